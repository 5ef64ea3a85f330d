"""Bitmaps of the glass: patterns of discs, and the order in which bytes reach the display.

A bitmap is boolean (64, 128), row 0 on top, True = open (passes light).
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from reliefscope.errors import InvalidInputError
from reliefscope.models.instrument import GlassModel
from reliefscope.units import BoolImage

GLASS_SHAPE = (64, 128)
BITMAP_BYTES = 1024


def pixel_centres_mm(glass: GlassModel) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Coordinates x (128,) and y (64,) in mm of the pixel centres on the glass, y up, origin in its middle."""
    x_mm = (np.arange(glass.columns, dtype=np.float64) - (glass.columns - 1) / 2) * glass.pitch_x_mm
    y_mm = ((glass.rows - 1) / 2 - np.arange(glass.rows, dtype=np.float64)) * glass.pitch_y_mm
    return x_mm, y_mm


def disc(glass: GlassModel, centre_mm: tuple[float, float], diameter_mm: float) -> BoolImage:
    """Bitmap of the pixels whose centre lies within a disc on the glass.

    Raises
    ------
    InvalidInputError
        If the disc opens no pixel, or reaches over the edge of the glass.
    """
    x_mm, y_mm = pixel_centres_mm(glass)
    distance = np.hypot(x_mm[None, :] - centre_mm[0], y_mm[:, None] - centre_mm[1])
    bitmap: BoolImage = distance <= diameter_mm / 2
    half_width = glass.columns * glass.pitch_x_mm / 2
    half_height = glass.rows * glass.pitch_y_mm / 2
    radius = diameter_mm / 2
    if abs(centre_mm[0]) + radius > half_width or abs(centre_mm[1]) + radius > half_height:
        raise InvalidInputError(
            f"A disc of {diameter_mm:g} mm at ({centre_mm[0]:g}, {centre_mm[1]:g}) mm reaches over "
            f"the glass of {2 * half_width:.1f} x {2 * half_height:.1f} mm.",
            hint="Choose a centre nearer to the middle, or a smaller disc.",
        )
    if not bitmap.any():
        raise InvalidInputError(
            f"A disc of {diameter_mm:g} mm at ({centre_mm[0]:g}, {centre_mm[1]:g}) mm opens no pixel.",
            hint=f"Pixels are {glass.pitch_x_mm:g} x {glass.pitch_y_mm:g} mm; choose a larger disc.",
        )
    return bitmap


def hexagonal_centres_mm(count: int, spacing_mm: float) -> list[tuple[float, float]]:
    """Centres of the ``count`` discs of a hexagonal packing that lie nearest to a hole of its lattice.

    The hole is the centre of a triangle of three touching discs, so that no disc sits on the axis; twelve
    give radii of d/sqrt(3) (3), 2d/sqrt(3) (3) and d sqrt(7/3) (6).  Sorted by radius, then azimuth.
    """
    hole_y = spacing_mm / (2 * math.sqrt(3))
    points = []
    for row in range(-5, 6):
        for column in range(-5, 6):
            x = (column + row / 2 - 0.5) * spacing_mm
            y = row * spacing_mm * math.sqrt(3) / 2 - hole_y
            azimuth = math.atan2(y, x) % (2 * math.pi)
            points.append((round(math.hypot(x, y), 9), round(azimuth, 9), x, y))
    points.sort()
    return [(x, y) for _, _, x, y in points[:count]]


def centroid_mm(bitmap: BoolImage, glass: GlassModel) -> tuple[float, float]:
    """Centroid (x, y) in mm on the glass of the open pixels of a bitmap (64, 128)."""
    if not bitmap.any():
        raise InvalidInputError(
            "A shut aperture has no centroid, so it is no view.",
            hint="Give every view at least one open pixel.",
        )
    x_mm, y_mm = pixel_centres_mm(glass)
    rows, columns = np.nonzero(bitmap)
    return float(x_mm[columns].mean()), float(y_mm[rows].mean())


def pack_bitmap(bitmap: BoolImage) -> bytes:
    """1,024 bytes in page order: page p, column c at byte 128 p + c, bit b is row 8 p + b."""
    if bitmap.shape != GLASS_SHAPE:
        raise InvalidInputError(
            f"An aperture bitmap has shape {bitmap.shape}, not {GLASS_SHAPE}.",
            hint="Give 64 rows of 128 columns, row 0 on top, True where the glass is open.",
        )
    pages = bitmap.reshape(8, 8, 128)
    return np.packbits(pages, axis=1, bitorder="little").tobytes()


def unpack_bitmap(data: bytes) -> BoolImage:
    """Bitmap (64, 128) of 1,024 bytes in page order."""
    if len(data) != BITMAP_BYTES:
        raise InvalidInputError(
            f"An aperture of {len(data)} bytes is no bitmap of {BITMAP_BYTES}.",
            hint="The file or message is damaged; write it again.",
        )
    pages = np.frombuffer(data, dtype=np.uint8).reshape(8, 1, 128)
    return np.unpackbits(pages, axis=1, bitorder="little").reshape(GLASS_SHAPE).astype(bool)
