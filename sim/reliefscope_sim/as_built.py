"""How the simulated instrument really is, which its profile does not tell.

``AsBuilt.nominal`` is the instrument exactly as designed; ``AsBuilt.draw`` departs from it in ways that a
calibration has to find.  :meth:`AsBuilt.factory_calibration` writes the true numbers down, as a supplier who
measured the instrument would.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from reliefscope.models.calibration import Calibration
from reliefscope.models.instrument import InstrumentProfile


@dataclass(frozen=True)
class AsBuilt:
    """True state of one instrument.

    The glass is turned by ``glass_rotation_rad`` (counter-clockwise seen in the image) about its middle,
    which sits at ``glass_offset_mm`` in the pupil.  A ray through pupil point a leans by
    ``a / (pupil_scale f_o) + telecentricity_per_mm * field position``.  LED positions are (N, 3) in mm from
    the focal point; intensities (N,) are relative to the nominal LED.
    """

    glass_offset_mm: tuple[float, float]
    glass_rotation_rad: float
    pupil_scale: float
    telecentricity_per_mm: float
    led_positions_mm: NDArray[np.float64]
    led_intensities: NDArray[np.float64]

    @classmethod
    def nominal(cls, profile: InstrumentProfile) -> AsBuilt:
        """The instrument exactly as its profile says."""
        return cls(
            glass_offset_mm=(0.0, 0.0),
            glass_rotation_rad=0.0,
            pupil_scale=profile.optics.pupil_scale,
            telecentricity_per_mm=profile.optics.telecentricity_per_mm,
            led_positions_mm=profile.dome.positions_mm.copy(),
            led_intensities=np.ones(profile.dome.count),
        )

    @classmethod
    def draw(cls, profile: InstrumentProfile, seed: int) -> AsBuilt:
        """An instrument built with tolerances, always the same one for a seed.

        Glass within 0.3 mm and 2 degrees, pupil scale 1.0 to 1.15 of the profile's, telecentricity within
        0.01 per mm, LEDs off by 0.5 mm (standard deviation per axis, at most 1 mm) and 20 % in intensity.
        """
        generator = np.random.default_rng(seed)
        radius = 0.3 * np.sqrt(generator.random())
        azimuth = generator.uniform(0.0, 2 * np.pi)
        rotation = np.radians(generator.uniform(-2.0, 2.0))
        pupil_scale = profile.optics.pupil_scale * generator.uniform(1.0, 1.15)
        telecentricity = profile.optics.telecentricity_per_mm + generator.uniform(-0.01, 0.01)
        count = profile.dome.count
        moves = np.clip(generator.normal(0.0, 0.5, (count, 3)), -1.0, 1.0)
        return cls(
            glass_offset_mm=(float(radius * np.cos(azimuth)), float(radius * np.sin(azimuth))),
            glass_rotation_rad=float(rotation),
            pupil_scale=float(pupil_scale),
            telecentricity_per_mm=float(telecentricity),
            led_positions_mm=profile.dome.positions_mm + moves,
            led_intensities=generator.uniform(0.8, 1.2, count),
        )

    def factory_calibration(self, profile: InstrumentProfile) -> Calibration:
        """The calibration that came with this instrument: its true numbers."""
        return Calibration(
            profile=profile.name,
            source="factory",
            pixel_um=profile.pixel_um,
            glass_offset_mm=self.glass_offset_mm,
            glass_rotation_rad=self.glass_rotation_rad,
            pupil_scale=self.pupil_scale,
            telecentricity_per_mm=self.telecentricity_per_mm,
            led_positions_mm=tuple(
                (float(x), float(y), float(z)) for x, y, z in self.led_positions_mm
            ),
            led_intensities=tuple(float(value) for value in self.led_intensities),
        )
