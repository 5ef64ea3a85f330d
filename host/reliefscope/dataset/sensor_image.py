"""From sensor counts to linear light: luminance, and red, green and blue.

A raw mosaic must never be matched: its pattern agrees with itself at zero shift.  The luminance of a Bayer
mosaic is its convolution with [1 2 1] x [1 2 1] / 16.  At every pixel, whatever its own colour, that filter
weighs red, green and blue with 1/4, 1/2 and 1/4, and it is exactly zero at the three frequencies (0, 1/2),
(1/2, 0) and (1/2, 1/2) cycles per pixel that carry the mosaic.  It is the same filter for every pixel, so a
texture looks the same wherever parallax takes it; a demosaic that treats pixels of different colours
differently, or follows edges, would not hold that.  Its blur is far below that of the apertures used here.
"""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from reliefscope.models.instrument import Sensor
from reliefscope.units import FloatImage, RawImage

SATURATED_SHARE: dict[Sensor, float] = {"mono": 0.995, "bayer_rggb": 0.75}
"""Share of full scale from which luminance counts as saturated.  On simulated metal, 97 to 99 % of the counts at full
scale of a mosaic lie in pixels above it, and practically all of these pixels are next to such a count."""
BINOMIAL = np.array([0.25, 0.5, 0.25], dtype=np.float32)
_RED_BLUE_TENT = np.array([[1, 2, 1], [2, 4, 2], [1, 2, 1]], dtype=np.float32) / 4
_GREEN_TENT = np.array([[0, 1, 0], [1, 4, 1], [0, 1, 0]], dtype=np.float32) / 4


def luminance(
    counts: RawImage | FloatImage, sensor: Sensor, scale: float = 1.0, out: FloatImage | None = None
) -> FloatImage:
    """Linear luminance (H, W) float32 of raw counts (H, W), multiplied by ``scale``; in ``out`` where given.

    Works on uint8, uint16 and float32.  The border is mirrored about the outermost pixel, which keeps the
    order of the mosaic's colours.
    """
    # OpenCV's filter is vectorised for float32 and not for uint16: converting first is three times as fast
    values = counts.astype(np.float32)
    if sensor == "mono":
        return np.multiply(values, np.float32(scale), out=out)
    kernel = BINOMIAL * np.float32(scale)
    filtered = cv2.sepFilter2D(
        values, cv2.CV_32F, kernel, BINOMIAL, dst=out, borderType=cv2.BORDER_REFLECT_101
    )
    return filtered.astype(np.float32, copy=False)


def colour(counts: RawImage | FloatImage, sensor: Sensor, scale: float = 1.0) -> FloatImage:
    """Linear red, green and blue (H, W, 3) float32 of raw counts (H, W), bilinear, multiplied by ``scale``.

    A monochrome sensor gives three equal planes.  Channels are as the sensor weighs them: no white balance.
    """
    if sensor == "mono":
        return np.repeat(luminance(counts, sensor, scale)[:, :, None], 3, axis=2)
    values = counts.astype(np.float32) * np.float32(scale)
    image = np.empty((*values.shape, 3), dtype=np.float32)
    # Bilinear interpolation of a colour that is sampled on a lattice is the convolution of its samples with a
    # tent: over the square lattice of red and blue, and over the quincunx of green, which needs no corners.
    for channel, sites in enumerate(_rggb_sites(values.shape)):
        sampled = np.where(sites, values, np.float32(0))
        tent = _GREEN_TENT if channel == 1 else _RED_BLUE_TENT
        image[:, :, channel] = cv2.filter2D(
            sampled, cv2.CV_32F, tent, borderType=cv2.BORDER_REFLECT_101
        )
    return image


def _rggb_sites(shape: tuple[int, ...]) -> tuple[NDArray[np.bool_], ...]:
    odd_row = (np.arange(shape[0]) % 2).astype(bool)[:, None]
    odd_column = (np.arange(shape[1]) % 2).astype(bool)[None, :]
    return (~odd_row & ~odd_column, odd_row ^ odd_column, odd_row & odd_column)
