"""Albedo in red, green and blue, where the sensor sees colour.

Geometry comes from luminance, which every pixel has; colour needs one view only.  Its frames are brought to the
view s = 0 and, channel by channel, fitted to the shading that normals and albedo predict, from the lights whose
luminance agrees with it: gloss has the colour of the lamp, and shadows that of their surroundings.
"""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from reliefscope.jobs import Job, ensure_job
from reliefscope.models.light_field import LightField
from reliefscope.models.plan import FrameKind
from reliefscope.reconstruction import registration
from reliefscope.reconstruction.photometric import PsResult
from reliefscope.units import FloatImage

LUMINANCE = (0.25, 0.5, 0.25)
"""Shares of red, green and blue in the luminance of a mosaic."""
AGREEMENT = 0.15
"""Difference of luminance from its prediction, over the albedo, up to which a light counts."""


class ColourFrames(Protocol):
    """What is read; :class:`reliefscope.dataset.Run` has it."""

    @property
    def pixel_um(self) -> float:
        """Size of a pixel on the sample."""

    def rgb(self, kind: FrameKind, view: int | None, light: int | None) -> FloatImage:
        """Linear red, green and blue (H, W, 3)."""


def colour_albedo(
    frames: ColourFrames,
    view: int,
    slope: tuple[float, float],
    gain: float,
    height_um: FloatImage | None,
    lights: LightField,
    solved: PsResult,
    job: Job | None = None,
) -> FloatImage:
    """Albedo (H, W, 3), in units of intensity as ``solved.albedo``, which is its luminance.

    Parameters
    ----------
    frames:
        Where the colour comes from.
    view, slope, gain:
        View to read, its slope (y up), and the factor that brought its frames to the level of all views.
    height_um:
        (H, W) height by which the view is brought to s = 0; None: it is there.
    lights:
        Lights of the run, as they were given to :func:`~reliefscope.reconstruction.photometric.solve` but with the
        powers that the frames still have; their directions in the middle of the field serve, because only the
        ratio of the channels is taken from here.
    solved:
        Normals and albedo; missing ones stay missing.
    job:
        Progress (stage ``colour``, per light) and cancellation.
    """
    shape = solved.albedo.shape
    sums: NDArray[np.float32] = np.zeros((*shape, 3), np.float32)
    all_light: NDArray[np.float32] = np.full((*shape, 3), 1e-9, np.float32)
    luminance = np.array(LUMINANCE, np.float32)
    vectors = lights.vectors / lights.powers.mean()
    with ensure_job(job).stage("colour", len(lights)) as stage:
        for light, vector in enumerate(vectors.astype(np.float32)):
            image = frames.rgb("view", view, light) * np.float32(gain)
            if height_um is not None:
                planes = np.ascontiguousarray(np.moveaxis(image, 2, 0))
                image = np.moveaxis(
                    registration.to_reference(
                        planes, [slope] * 3, height_um, frames.pixel_um, interpolation="linear"
                    ),
                    0,
                    2,
                )
            image = np.nan_to_num(image)
            shading = np.maximum(solved.normals @ vector, np.float32(0.0))
            level = solved.albedo * np.float32(lights.powers[light] / lights.powers.mean())
            apart = np.abs(image @ luminance - solved.albedo * shading)
            agrees = (apart <= np.float32(AGREEMENT) * level).astype(np.float32)
            sums += (agrees * shading)[..., None] * image
            all_light += np.maximum(image, 0.0)
            stage.advance()
    # where no light agrees, the mean colour of all light
    unknown = ~(sums @ luminance > 0.0)
    sums[unknown] = all_light[unknown]
    np.maximum(sums, 0.0, out=sums)
    sums *= (solved.albedo / (sums @ luminance))[..., None]
    return sums
