"""Pixels whose count was at full scale: what they really received is not known."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from reliefscope.reconstruction import registration
from reliefscope.reconstruction.inputs import Inputs
from reliefscope.reconstruction.stage_clock import StageClock
from reliefscope.units import BoolImage, FloatImage


class SaturatingFrames(Protocol):
    """What is asked; :class:`reliefscope.dataset.Run` has it."""

    def saturation_level(self, view: int, light: int) -> FloatImage | float:
        """Linear luminance (H, W), or one for all pixels, from which a pixel counts as saturated."""


def blank_saturated(images: FloatImage, run: SaturatingFrames, view: int) -> int:
    """Set saturated pixels of a view's frames (L, H, W) to NaN in place; returns how many there were."""
    found = 0
    for light, image in enumerate(images):
        level = np.asarray(run.saturation_level(view, light), dtype=np.float32)
        if image.max() < level.min():
            continue
        saturated = image >= level
        found += int(np.count_nonzero(saturated))
        image[saturated] = np.nan
    return found


def saturated_points(inputs: Inputs, height_um: FloatImage | None, clock: StageClock) -> BoolImage:
    """Points (H, W) of the surface that were saturated in a frame, for methods that use such frames all the same.

    Frames are read again (stage ``saturation``).  Those of all views are brought to the view s = 0 by ``height_um``;
    without heights only the view nearest to it is looked at, as it is.
    """
    run = inputs.frames
    views = [inputs.nearest] if height_um is None else list(range(inputs.view_count))
    marked = {view: np.zeros(run.shape, np.bool_) for view in views}
    points = np.zeros(run.shape, np.bool_)
    with clock.timed("saturation"), clock.job.stage("saturation", len(views)) as stage:
        for view, light, image in run.stack(views):
            marked[view] |= image >= run.saturation_level(view, light)
        for view, saturated in marked.items():
            if height_um is None:
                points = saturated
            elif saturated.any():
                share = registration.to_reference(
                    saturated[None].astype(np.float32),
                    inputs.slopes[[view]],
                    height_um,
                    run.pixel_um,
                    telecentricity_per_um=run.telecentricity_per_um,
                    interpolation="linear",
                )[0]
                points |= share > 0.0  # false where the view does not see the point: NaN
            stage.advance()
    return points
