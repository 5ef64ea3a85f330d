"""The instrument as designed: optics, glass, LEDs, camera.

A profile states what was built or bought; a :class:`~reliefscope.models.calibration.Calibration` states how
the one on the bench departs from it.  What the paper does not give is listed under ``assumed`` with the
reason, so that nobody takes a guess for a datum.
"""

from __future__ import annotations

import math
from functools import cached_property
from importlib import resources
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, model_validator

from reliefscope.errors import InvalidInputError
from reliefscope.models.base import StrictModel, load_model

Positive = Annotated[float, Field(gt=0)]
Sensor = Literal["mono", "bayer_rggb"]


class Optics(StrictModel):
    """Two lenses with the glass at the back focal plane of the first (Fig. 3)."""

    objective_focal_mm: Positive
    tube_focal_mm: Positive
    pupil_diameter_mm: Positive
    wavelength_um: Positive = 0.5
    pupil_scale: Positive = 1.0
    """s = a / (pupil_scale f_o)."""
    telecentricity_per_mm: float = 0.0
    """kappa: s grows by kappa times the field position (1/mm)."""

    @property
    def magnification(self) -> float:
        """M = f_t / f_o."""
        return self.tube_focal_mm / self.objective_focal_mm


class GlassModel(StrictModel):
    """The transparent LCD: a grid of pixels, each open or shut."""

    model: str
    columns: Literal[128] = 128
    rows: Literal[64] = 64
    pitch_x_mm: Positive
    pitch_y_mm: Positive
    gap_mm: Annotated[float, Field(ge=0)] = 0.0
    """Width of the always-shut line between neighbouring pixels."""
    contrast_ratio: Annotated[float, Field(gt=1)] = 15.0
    """Transmission of an open pixel over that of a shut one."""
    variant: Literal["E", "S"] = "S"
    """E: STN positive, clear at rest.  S: FSTN negative, dark at rest."""
    rise_ms: Positive = 120.0
    decay_ms: Positive = 120.0
    """10-90 % switching times."""
    settle_ms: Positive = 400.0
    """Time after which a view counts as settled."""


class LedRing(StrictModel):
    """LEDs at one elevation, evenly spread in azimuth."""

    elevation_deg: Annotated[float, Field(gt=0, lt=90)]
    count: Annotated[int, Field(ge=1, le=48)]
    first_azimuth_deg: float = 0.0


class Dome(StrictModel):
    """Constellation of LEDs on a hemisphere around the focal point (Fig. 4)."""

    model: str
    radius_mm: Positive
    rings: Annotated[tuple[LedRing, ...], Field(min_length=1)]
    half_angle_deg: Annotated[float, Field(gt=0, le=90)] = 22.5
    full_level: Literal[4095] = 4095

    @property
    def count(self) -> int:
        """Number of LEDs."""
        return sum(ring.count for ring in self.rings)

    @cached_property
    def positions_mm(self) -> NDArray[np.float64]:
        """Positions (N, 3) in the world frame, origin at the focal point; ring by ring in file order."""
        rows = []
        for ring in self.rings:
            elevation = math.radians(ring.elevation_deg)
            for index in range(ring.count):
                azimuth = math.radians(ring.first_azimuth_deg + 360.0 * index / ring.count)
                rows.append(
                    (
                        self.radius_mm * math.cos(elevation) * math.cos(azimuth),
                        self.radius_mm * math.cos(elevation) * math.sin(azimuth),
                        self.radius_mm * math.sin(elevation),
                    )
                )
        return np.array(rows)

    @model_validator(mode="after")
    def _fits_the_driver(self) -> Dome:
        if self.count > 48:
            raise ValueError(f"{self.count} LEDs; the driver chain has 48 channels")
        return self


class CameraModel(StrictModel):
    """The camera; ``columns`` and ``rows`` may be a region of the sensor."""

    model: str
    columns: Annotated[int, Field(ge=16)]
    rows: Annotated[int, Field(ge=16)]
    pixel_um: Positive
    sensor: Sensor
    bit_depth: Literal[8, 10, 12] = 12
    full_well_electrons: Positive = 15000.0
    read_noise_electrons: Annotated[float, Field(ge=0)] = 8.0
    black_level: Annotated[float, Field(ge=0, lt=0.5)] = 0.01
    """Offset of a dark pixel, fraction of full scale."""
    frames_per_s: Positive = 15.0

    @property
    def full_scale(self) -> int:
        """Largest count."""
        return (1 << self.bit_depth) - 1


class AperturePattern(StrictModel):
    """Discs that the glass shows one after the other, and the pattern's measure."""

    kind: Literal["hexagonal"] = "hexagonal"
    count: Annotated[int, Field(ge=2, le=12)] = 12
    disc_diameter_mm: Positive = 1.5
    spacing_mm: Positive | None = None
    """Distance between neighbours; the disc's diameter where absent."""


class InstrumentProfile(StrictModel):
    """One instrument as designed."""

    schema_version: Literal[1] = 1
    name: str
    description: str
    optics: Optics
    glass: GlassModel
    dome: Dome
    camera: CameraModel
    apertures: AperturePattern = AperturePattern()
    exposure_ms: Positive = 20.0
    height_range_um: tuple[float, float] = (-75.0, 75.0)
    """Heights that the focal depth and the samples make sense of; the default search range."""
    assumed: dict[str, str] = {}
    """Dotted key -> why its value is an assumption."""

    @property
    def pixel_um(self) -> float:
        """Size of a camera pixel in the sample plane."""
        return self.camera.pixel_um / self.optics.magnification

    @property
    def shape(self) -> tuple[int, int]:
        """Frame shape (rows, columns)."""
        return self.camera.rows, self.camera.columns

    def resized(self, columns: int, rows: int) -> InstrumentProfile:
        """The same instrument reading out a central region of its sensor."""
        camera = self.camera.model_copy(update={"columns": columns, "rows": rows})
        return self.model_copy(update={"camera": CameraModel.model_validate(camera.model_dump())})

    @model_validator(mode="after")
    def _assumptions_exist(self) -> InstrumentProfile:
        for key in self.assumed:
            place: object = self
            for part in key.split("."):
                if not hasattr(place, part):
                    raise ValueError(f"assumed names `{key}`, which the profile does not have")
                place = getattr(place, part)
        low, high = self.height_range_um
        if low >= high:
            raise ValueError("height_range_um must be [low, high] with low < high")
        return self


def builtin_profiles() -> list[str]:
    """Names of the profiles that come with the program."""
    folder = resources.files("reliefscope.models").joinpath("profiles")
    return sorted(entry.name.removesuffix(".yml") for entry in folder.iterdir())


def load_profile(name_or_path: str) -> InstrumentProfile:
    """Profile by name (``benchtop``, ``miniature``) or from a YAML file."""
    if name_or_path in builtin_profiles():
        entry = resources.files("reliefscope.models").joinpath("profiles", f"{name_or_path}.yml")
        with resources.as_file(entry) as path:
            return load_model(InstrumentProfile, path)
    path = Path(name_or_path)
    if path.suffix in {".yml", ".yaml", ".json"}:
        return load_model(InstrumentProfile, path)
    raise InvalidInputError(
        f"There is no instrument profile `{name_or_path}`.",
        hint=f"Use one of: {', '.join(builtin_profiles())}; or the path of a .yml file.",
    )
