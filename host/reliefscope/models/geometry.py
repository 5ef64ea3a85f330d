"""Where a bitmap looks from and where an LED shines from: the host's view of the instrument.

These are the functions bitmap -> slope and LED -> direction.  The simulated instrument must not use them: it
traces from raw positions in millimetres, otherwise a sign error would cancel itself.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from reliefscope.models.apertures import centroid_mm
from reliefscope.models.calibration import Calibration
from reliefscope.models.instrument import InstrumentProfile
from reliefscope.units import BoolImage


def pupil_position_mm(
    glass_mm: tuple[float, float], calibration: Calibration
) -> tuple[float, float]:
    """Position in the pupil of a point on the glass: turned by ``glass_rotation_rad``, then shifted."""
    cos, sin = math.cos(calibration.glass_rotation_rad), math.sin(calibration.glass_rotation_rad)
    x, y = glass_mm
    offset_x, offset_y = calibration.glass_offset_mm
    return (cos * x - sin * y + offset_x, sin * x + cos * y + offset_y)


def slope_of_position(
    pupil_mm: tuple[float, float], profile: InstrumentProfile, calibration: Calibration
) -> tuple[float, float]:
    """Slope s = a / (pupil_scale f_o), small-angle form of eq. 1."""
    focal = calibration.pupil_scale * profile.optics.objective_focal_mm
    return (pupil_mm[0] / focal, pupil_mm[1] / focal)


def slope_of_bitmap(
    bitmap: BoolImage, profile: InstrumentProfile, calibration: Calibration
) -> tuple[float, float]:
    """Slope of the view through the open pixels of a bitmap (64, 128), from their centroid."""
    on_glass = centroid_mm(bitmap, profile.glass)
    return slope_of_position(pupil_position_mm(on_glass, calibration), profile, calibration)


def light_direction(levels: dict[int, int], calibration: Calibration) -> NDArray[np.float64]:
    """Unit vector (3,) from the sample toward a light; several LEDs give their intensity-weighted mean.

    ``levels`` maps LED index -> level; the mean of a whole ring points along the axis.
    """
    total = np.zeros(3)
    for led, level in levels.items():
        position = np.asarray(calibration.led_positions_mm[led])
        total += level * calibration.led_intensities[led] * position / np.linalg.norm(position)
    unit: NDArray[np.float64] = total / np.linalg.norm(total)
    return unit


def light_power(levels: dict[int, int], calibration: Calibration, full_level: int) -> float:
    """Brightness of a light relative to one nominal LED at its full level."""
    return sum(
        level / full_level * calibration.led_intensities[led] for led, level in levels.items()
    )
