"""Half-size grids: work on every second pixel, and back."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from reliefscope.units import FloatImage

JUMP_UM = 6.0
"""Difference within 3 x 3 pixels of the half-size grid over which no height is interpolated."""


def averaged(image: FloatImage) -> FloatImage:
    """Means (H', W') or (H', W', C) over 2 x 2 pixels; odd sides are rounded up."""
    rows, columns = image.shape[:2]
    size = ((columns + 1) // 2, (rows + 1) // 2)
    return np.asarray(cv2.resize(image, size, interpolation=cv2.INTER_AREA), np.float32)


def doubled(z: NDArray[np.floating[Any]], shape: tuple[int, ...]) -> FloatImage:
    """Surface of the half-size grid on the full one (H, W): linear, but the nearest value at steps."""
    coarse = z.astype(np.float32)
    window = np.ones((3, 3), np.uint8)
    steep = cv2.dilate(coarse, window) - cv2.erode(coarse, window) > JUMP_UM
    smooth = cv2.resize(coarse, shape[::-1], interpolation=cv2.INTER_LINEAR)
    nearest = cv2.resize(coarse, shape[::-1], interpolation=cv2.INTER_NEAREST)
    at_step = cv2.resize(steep.astype(np.uint8), shape[::-1], interpolation=cv2.INTER_NEAREST)
    return np.where(at_step > 0, nearest, smooth)
