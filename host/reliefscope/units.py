"""Array types and unit conversions shared by every room.

Lengths of the sample are micrometres, lengths of the instrument millimetres, angles radians inside the
program and degrees at its edges (files and screens).  Names carry their unit: ``height_um``, ``settle_ms``.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

FloatImage = NDArray[np.float32]
"""Linear light or a quantity per pixel, float32."""
RawImage = NDArray[np.uint8] | NDArray[np.uint16]
"""Sensor counts as the camera delivered them: a mosaic where the sensor is a colour one."""
BoolImage = NDArray[np.bool_]
FloatArray = NDArray[np.floating[Any]]

UM_PER_MM = 1000.0
US_PER_MS = 1000
US_PER_S = 1_000_000


def degrees(angle_rad: float) -> float:
    """Angle for files and screens."""
    return math.degrees(angle_rad)


def radians(angle_deg: float) -> float:
    """Angle from files and screens."""
    return math.radians(angle_deg)


def format_duration(seconds: float) -> str:
    """Duration for people: ``8.2 s``, ``3 min 05 s``, ``2 h 10 min``."""
    if seconds < 60:
        return f"{seconds:.1f} s"
    whole = round(seconds)
    if whole < 3600:
        return f"{whole // 60} min {whole % 60:02d} s"
    return f"{whole // 3600} h {whole % 3600 // 60:02d} min"


def format_bytes(count: float) -> str:
    """Size for people, in powers of 1,000."""
    for unit in ("B", "kB", "MB", "GB"):
        if count < 1000:
            return f"{count:.0f} {unit}" if unit == "B" else f"{count:.1f} {unit}"
        count /= 1000
    return f"{count:.1f} TB"
