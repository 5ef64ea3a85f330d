"""Laws of the liquid crystal: voltage to alignment, temperature to speed.

**Voltage.**  The controller (ST7565 family) makes V0 = r (1 - (63 - volume) / 162) V_ref from its coarse ratio r
and its fine volume, with V_ref = 2.1 V at 25 degrees Celsius, falling by 0.05 % per kelvin.  Multiplexing N = 64
rows at a bias of 1/b puts on every pixel, driven or not, a voltage whose effective value is (Alt and Pleshko)

    V_on  = V0 sqrt((1 + (N - 1) / b^2) / N),
    V_off = V0 sqrt(((b - 2)^2 / b^2 + (N - 1) / b^2) / N).

Below a threshold the crystal does not move, above saturation it is aligned; in between the aligned fraction
follows the smooth step 3u^2 - 2u^3.  Threshold and saturation (assumed) lie between V_on and V_off of the
contrast that the firmware starts with, and fall with temperature as those of STN mixtures do.  So a contrast
set too low leaves open pixels dim, one set too high makes closed pixels leak (variant S; the reverse for E),
and what was right in a warm room is too low in a cold one.

**Temperature.**  Switching times grow with the crystal's viscosity, which follows Arrhenius' law:

    tau(T) = tau(25 C) exp(E / k (1/T - 1/298.15 K)),   E = 0.45 eV (assumed; usual for nematic mixtures).

That is 5 times slower at freezing point, and seconds at -10 degrees.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

ROOM_C = 25.0
TEMPERATURE_RANGE_C = (-30.0, 70.0)
_ZERO_CELSIUS_K = 273.15
_ACTIVATION_K = 0.45 / 8.617333e-5
"""E / k in kelvin."""
_ROWS = 64
_REFERENCE_V = 2.1
_REFERENCE_PER_K = -0.0005
_RATIOS = (3.0, 3.5, 4.0, 4.5, 5.0, 5.5, 6.0, 6.4)
_VOLUME_STEPS = 162
_VOLUME_MAX = 63
_THRESHOLD_V = 1.50
_SATURATION_V = 1.65
_THRESHOLD_PER_K = -0.002


@dataclass(frozen=True, slots=True)
class Drive:
    """Effective voltages of pixels that are not driven and of those that are."""

    off_v: float
    on_v: float


NO_DRIVE = Drive(0.0, 0.0)


def multiplexed(
    resistor_ratio: int, volume: int, bias: int, temperature_c: float = ROOM_C
) -> Drive:
    """Effective voltages for the controller's registers; ``bias`` is b of the bias 1/b."""
    reference_v = _REFERENCE_V * (1 + _REFERENCE_PER_K * (temperature_c - ROOM_C))
    v0 = _RATIOS[resistor_ratio] * (1 - (_VOLUME_MAX - volume) / _VOLUME_STEPS) * reference_v
    others = (_ROWS - 1) / bias**2
    off = math.sqrt((((bias - 2) / bias) ** 2 + others) / _ROWS)
    on = math.sqrt((1 + others) / _ROWS)
    return Drive(v0 * off, v0 * on)


def aligned_fraction(voltage_v: float, temperature_c: float = ROOM_C) -> float:
    """Part of the crystal, 0 to 1, that an effective voltage aligns in the end."""
    shift = 1 + _THRESHOLD_PER_K * (temperature_c - ROOM_C)
    threshold, saturation = _THRESHOLD_V * shift, _SATURATION_V * shift
    u = min(max((voltage_v - threshold) / (saturation - threshold), 0.0), 1.0)
    return u * u * (3 - 2 * u)


def slowdown(temperature_c: float) -> float:
    """Switching times at a temperature over those at 25 degrees Celsius."""
    kelvin = temperature_c + _ZERO_CELSIUS_K
    return math.exp(_ACTIVATION_K * (1 / kelvin - 1 / (ROOM_C + _ZERO_CELSIUS_K)))
