"""The world frame, in one place.

Right-handed: x to the right of the image, y up in the image (the row index grows as y falls), z toward the
objective, z = 0 in the focal plane.  Sample lengths are micrometres.

A view is its slope ``s = (sx, sy)``: the ray from the sample to the aperture leans by ``s``.  A point at
``(x, y, z)`` appears in the focal plane at ``(x - z sx, y - z sy)``.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray


def apparent_shift_um(height_um: float, slope: tuple[float, float]) -> tuple[float, float]:
    """Shift (dx, dy) in um, y up, of a point at ``height_um`` seen in the view ``slope`` (eq. 1 with sign)."""
    return (-height_um * slope[0], -height_um * slope[1])


def to_pixels(shift_um: tuple[float, float], pixel_um: float) -> tuple[float, float]:
    """Shift (columns, rows) of a displacement (dx, dy) in um; rows grow as y falls."""
    return (shift_um[0] / pixel_um, -shift_um[1] / pixel_um)


def apparent_shift_px(
    height_um: float, slope: tuple[float, float], pixel_um: float
) -> tuple[float, float]:
    """Shift (columns, rows) at which a point of ``height_um`` appears in the view ``slope``."""
    return to_pixels(apparent_shift_um(height_um, slope), pixel_um)


def pixel_grid_um(
    shape: tuple[int, int], pixel_um: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Coordinates x (W,) and y (H,) in um of pixel centres, origin in the middle of the image, y up."""
    height, width = shape
    x_um = (np.arange(width, dtype=np.float64) - (width - 1) / 2) * pixel_um
    y_um = ((height - 1) / 2 - np.arange(height, dtype=np.float64)) * pixel_um
    return x_um, y_um


def direction(elevation_rad: float, azimuth_rad: float) -> NDArray[np.float64]:
    """Unit vector (3,) from the sample toward a light.

    Elevation is measured from the sample plane, azimuth counter-clockwise from +x.
    """
    horizontal = math.cos(elevation_rad)
    return np.array(
        [
            horizontal * math.cos(azimuth_rad),
            horizontal * math.sin(azimuth_rad),
            math.sin(elevation_rad),
        ]
    )


def elevation_azimuth(vector: ArrayLike) -> tuple[float, float]:
    """Elevation above the sample plane and azimuth (radians, counter-clockwise from +x) of a vector (3,)."""
    x, y, z = (float(value) for value in np.asarray(vector, dtype=np.float64))
    return math.atan2(z, math.hypot(x, y)), math.atan2(y, x)


def slant_rad(normals: NDArray[np.floating]) -> NDArray[np.float32]:
    """Angle (...,) between unit normals (..., 3) and the z axis."""
    slant: NDArray[np.float32] = np.arccos(np.clip(normals[..., 2], -1.0, 1.0)).astype(np.float32)
    return slant


def gradient_from_normals(
    normals: NDArray[np.floating], minimum_nz: float = 0.02
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Slopes (dz/dx, dz/dy) with y up from unit normals (..., 3), eq. 11.

    ``minimum_nz`` bounds the slope (0.02: 88.9 degrees) where a normal lies in or below the sample plane.
    """
    nz = np.maximum(normals[..., 2], minimum_nz)
    return (
        (-normals[..., 0] / nz).astype(np.float32),
        (-normals[..., 1] / nz).astype(np.float32),
    )


def normals_from_height(height_um: NDArray[np.floating], pixel_um: float) -> NDArray[np.float32]:
    """Unit normals (H, W, 3) of a height map (H, W) by central differences."""
    d_row, d_col = np.gradient(height_um.astype(np.float64), pixel_um)
    normals = np.stack([-d_col, d_row, np.ones_like(d_col)], axis=-1)
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    return normals.astype(np.float32)
