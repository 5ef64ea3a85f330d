"""How the instrument on the bench departs from its profile."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from reliefscope.models.base import StrictModel
from reliefscope.models.instrument import InstrumentProfile

Vector3 = tuple[float, float, float]


class Calibration(StrictModel):
    """What holds for the measurements of one instrument.

    ``source`` tells where it comes from: ``nominal`` repeats the profile, ``factory`` came with the
    instrument, ``measured`` was made on the bench.
    """

    schema_version: Literal[1] = 1
    profile: str
    source: Literal["nominal", "factory", "measured"]
    created: str | None = None
    """ISO 8601 time of measurement."""
    pixel_um: Annotated[float, Field(gt=0)]
    glass_offset_mm: tuple[float, float] = (0.0, 0.0)
    """Position in the pupil of the middle of the glass."""
    glass_rotation_rad: float = 0.0
    """Turn of the glass, counter-clockwise seen in the image."""
    pupil_scale: Annotated[float, Field(gt=0)] = 1.0
    telecentricity_per_mm: float = 0.0
    led_positions_mm: tuple[Vector3, ...]
    led_intensities: tuple[Annotated[float, Field(gt=0)], ...]
    """Relative to the nominal LED."""

    @model_validator(mode="after")
    def _as_many_intensities_as_leds(self) -> Calibration:
        if len(self.led_positions_mm) != len(self.led_intensities):
            raise ValueError(
                f"{len(self.led_positions_mm)} led_positions_mm but "
                f"{len(self.led_intensities)} led_intensities"
            )
        return self

    @classmethod
    def nominal(cls, profile: InstrumentProfile) -> Calibration:
        """The calibration of an instrument that is exactly as designed."""
        positions = tuple((float(x), float(y), float(z)) for x, y, z in profile.dome.positions_mm)
        return cls(
            profile=profile.name,
            source="nominal",
            pixel_um=profile.pixel_um,
            pupil_scale=profile.optics.pupil_scale,
            telecentricity_per_mm=profile.optics.telecentricity_per_mm,
            led_positions_mm=positions,
            led_intensities=(1.0,) * len(positions),
        )


class InstrumentOffer(StrictModel):
    """What is known of the instrument behind a URL: its profile and the calibration that came with it."""

    profile: InstrumentProfile
    calibration: Calibration
