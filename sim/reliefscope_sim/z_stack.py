"""A conventional microscope with a motorised stage, looking at the sample of a simulated instrument.

It stands for the commercial microscope of the paper's section IV.C: a wide aperture, so that little is in focus at
a time, light through the objective, and a stage that moves the sample through the focal plane.  Its images come
from the same renderer as the instrument's own: the same occlusion, shading, diffraction and noise, but through the
whole pupil of a 5x/0.13 objective.
"""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import yaml
from numpy.typing import NDArray

from reliefscope.errors import DatasetError, InvalidInputError, OutputExistsError
from reliefscope.jobs import Job, ensure_job
from reliefscope.models.instrument import (
    CameraModel,
    Dome,
    GlassModel,
    InstrumentProfile,
    LedRing,
    Optics,
)
from reliefscope.models.z_stack import STACK_FILE, StackPlane, ZStack
from reliefscope.units import FloatImage, RawImage
from reliefscope_sim.as_built import AsBuilt
from reliefscope_sim.optics.pupil import PupilPoints
from reliefscope_sim.optics.renderer import Renderer
from reliefscope_sim.optics.views import Viewer
from reliefscope_sim.scenes import Scene, load_scene
from reliefscope_sim.stage import lifted
from reliefscope_sim.url import SimUrl

PLANES = 31
STEP_UM = 5.0
NUMERICAL_APERTURE = 0.13
_TUBE_MM = 164.5
_MAGNIFICATION = 5.0
_CAMERA_PIXEL_UM = 3.45
_SENSOR = (2452, 2056)
_PUPIL_POINTS = 36
"""Points that stand for the pupil; 75 um out of focus their images lie 4.7 pixels apart."""
_GLOSS_CELL_MM = 3.0
"""Points of the pupil this near to each other share one direction for gloss."""
_EXPOSED_TO = 0.8
"""Share of full scale that the brightest hundredth of the middle image is exposed to."""


def reference_microscope(size: tuple[int, int] = _SENSOR) -> InstrumentProfile:
    """The microscope as a profile, reading out ``size`` (columns, rows).

    Objective 5x/0.13 before a tube lens of 164.5 mm: 0.69 um per pixel of 3.45 um, DOF 14.8 um after eq. 2.
    The light through the objective is that of seven distant lamps within its aperture.  The sensor is taken as a
    monochrome one, and the glass is never used.
    """
    focal_mm = _TUBE_MM / _MAGNIFICATION
    return InstrumentProfile(
        name="reference",
        description="Conventional microscope with a 5x/0.13 objective and light through it",
        optics=Optics(
            objective_focal_mm=focal_mm,
            tube_focal_mm=_TUBE_MM,
            pupil_diameter_mm=2 * focal_mm * NUMERICAL_APERTURE,
        ),
        glass=GlassModel(model="none", pitch_x_mm=0.5, pitch_y_mm=0.5),
        dome=Dome(
            model="light through the objective",
            radius_mm=300.0,
            rings=(
                LedRing(elevation_deg=89.9, count=1),
                LedRing(elevation_deg=85.0, count=6),
            ),
            half_angle_deg=60.0,
        ),
        camera=CameraModel(
            model="monochrome, 3.45 um",
            columns=size[0],
            rows=size[1],
            pixel_um=_CAMERA_PIXEL_UM,
            sensor="mono",
            bit_depth=12,
            full_well_electrons=11000.0,
            black_level=0.0,
        ),
        exposure_ms=20.0,
    )


class FocusingRenderer(Renderer):
    """Images of a scene through the whole pupil, focused at any height between two limits."""

    def __init__(
        self, profile: InstrumentProfile, scene: Scene, lowest_um: float, highest_um: float
    ) -> None:
        # The renderer keeps room at the edges for the defocus of heights as it is given them: those of the
        # end of travel that brings the sample furthest from the focal plane.
        low, high = float(scene.height_um.min()), float(scene.height_um.max())
        self._focused_at_um = lowest_um if high - lowest_um > highest_um - low else highest_um
        as_built = AsBuilt.nominal(profile)
        super().__init__(profile, lifted(scene, -self._focused_at_um), as_built)
        self._light = tuple((led, 1.0) for led in range(profile.dome.count))
        self._radiance: dict[tuple[float, ...], FloatImage] = {}
        self._pupil_points = _disc(profile.optics.pupil_diameter_mm)

    def focused(self, focus_um: float) -> FloatImage:
        """Image (H, W) with ``focus_um`` in focus: radiance times mm^2 of the pupil, without noise."""
        raised_px = np.float32((self._focused_at_um - focus_um) / self.profile.pixel_um)
        viewer = Viewer(
            replace(self._surface, height_px=self._surface.height_px + raised_px),
            self.profile.optics,
            self._as_built,
            0.0 if self._surface.specular is None else _GLOSS_CELL_MM,
            0,
        )
        image: FloatImage = viewer.image(b"pupil", self._pupil_points, self._shade)[0]
        return image

    def record(self, focus_um: float, gain: float, noise_key: tuple[int, ...]) -> RawImage:
        """Counts (H, W) of the image that is focused at ``focus_um``, brightened by ``gain``."""
        signal = np.float32(gain) * self.focused(focus_um)
        return self._sensor.expose(signal, self.profile.exposure_ms / 1000, noise_key)

    def _shade(self, lean: NDArray[np.float64]) -> FloatImage:
        """Radiance toward a direction; the same at every focus, for the lamps are far away."""
        key = tuple(lean)
        if key not in self._radiance:
            self._radiance[key] = self._shader(self._light)(lean)
        return self._radiance[key]


def record_z_stack(
    url: str, out: Path, *, field_um: float | None = None, job: Job | None = None
) -> ZStack:
    """Take the stack of the sample under the simulated instrument at ``url``.

    It is a :class:`reliefscope.models.z_stack.StackRecorder`.

    The sample is made as that instrument sees it, and both look at the middle of it.  31 images, 5 um apart from
    -75 to +75 um, 12 bits in 16-bit PNG files.  Until the last is written the folder is called ``OUT.partial``.
    """
    address = SimUrl.parse(url)
    if out.exists():
        raise OutputExistsError(
            f"{out} exists already; nothing was changed.", hint="Give `--out` another name."
        )
    instrument = address.load_profile()
    profile = reference_microscope(_frame(instrument, field_um))
    scene = load_scene(
        address.scene,
        address.seed,
        dict(address.scene_options),
        shape=instrument.shape,
        pixel_um=instrument.pixel_um,
    )
    focus_um = (np.arange(PLANES) - (PLANES - 1) / 2) * STEP_UM
    renderer = FocusingRenderer(
        profile, lifted(scene, address.stage_um), float(focus_um[0]), float(focus_um[-1])
    )
    planes = []
    try:
        making = out.with_name(f"{out.name}.partial")
        making.mkdir(parents=True, exist_ok=True)
        with ensure_job(job).stage("z-stack", PLANES) as stage:
            middle = renderer.focused(float(focus_um[PLANES // 2]))
            gain = _EXPOSED_TO / max(float(np.percentile(middle, 99)), 1e-9)
            for index, height in enumerate(focus_um):
                raw = renderer.record(float(height), gain, (address.seed, index))
                planes.append(StackPlane(file=f"plane-{index:02d}.png", height_um=float(height)))
                _write(making / planes[-1].file, raw)
                stage.advance()
        stack = ZStack(
            pixel_um=profile.pixel_um,
            instrument=profile.description,
            sample=url,
            planes=tuple(planes),
        )
        content = yaml.safe_dump(stack.model_dump(mode="json"), sort_keys=False)
        (making / STACK_FILE).write_text(content, "utf-8")
        making.rename(out)
    except OSError as error:
        raise DatasetError(
            f"{out} cannot be written: {error.strerror or error}.",
            hint="Check the disk and the permissions of the folder.",
        ) from error
    return stack


def _frame(instrument: InstrumentProfile, field_um: float | None) -> tuple[int, int]:
    """(columns, rows) that show a square of ``field_um``, at most what instrument and sensor see."""
    pixel_um = _CAMERA_PIXEL_UM / _MAGNIFICATION
    seen = [size * instrument.pixel_um / pixel_um for size in instrument.shape[::-1]]
    wanted = seen if field_um is None else [field_um / pixel_um] * 2
    columns, rows = (int(min(sides)) for sides in zip(wanted, seen, _SENSOR, strict=True))
    if columns < 16 or rows < 16:
        raise InvalidInputError(
            f"A field of {columns} x {rows} pixels is too small for the z-stack microscope.",
            hint=f"Give a field of at least {16 * pixel_um:.0f} um.",
        )
    return columns, rows


def _disc(diameter_mm: float) -> PupilPoints:
    """Points of equal area spread over a disc along a spiral by the golden angle."""
    index = np.arange(_PUPIL_POINTS)
    radius = diameter_mm / 2 * np.sqrt((index + 0.5) / _PUPIL_POINTS)
    azimuth = index * math.pi * (3 - math.sqrt(5))
    position = np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth)], axis=-1)
    area = np.full(_PUPIL_POINTS, math.pi * diameter_mm**2 / 4 / _PUPIL_POINTS)
    return PupilPoints(position, area)


def _write(path: Path, raw: RawImage) -> None:
    """Counts of 12 bits, spread over the 16 of the file."""
    good, encoded = cv2.imencode(".png", (raw << 4).astype(np.uint16))
    if not good:
        raise OSError(f"{path.name} could not be encoded")
    path.write_bytes(encoded.tobytes())
