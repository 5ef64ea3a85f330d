"""Planes of least squares in a window around every sample of a height map."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from reliefscope.units import FloatImage


@dataclass(frozen=True, slots=True)
class LocalPlanes:
    """The plane that fits the heights best in a window around each sample; arrays (H, W) float32."""

    middle: FloatImage
    """Height of the plane at the sample."""
    along: FloatImage
    down: FloatImage
    """Rise per column and per row."""
    residual: FloatImage
    """RMS deviation of the heights from it."""


def fit_planes(height_um: FloatImage, window: int) -> LocalPlanes:
    """Planes of least squares in odd windows of ``height_um`` (H, W), which has no gaps."""
    offsets = np.arange(window, dtype=np.float32) - np.float32(window // 2)
    spread = float(np.mean(offsets**2))
    ramp = np.tile(offsets, (window, 1)) / np.float32(spread * window**2)
    level = np.float32(height_um.mean(dtype=np.float64))
    z = height_um - level  # small numbers keep the digits of the squares
    mean = cv2.blur(z, (window, window))
    along = np.asarray(cv2.filter2D(z, -1, ramp), dtype=np.float32)
    down = np.asarray(cv2.filter2D(z, -1, np.ascontiguousarray(ramp.T)), dtype=np.float32)
    variance = cv2.blur(z * z, (window, window)) - mean**2 - spread * (along**2 + down**2)
    residual = np.asarray(np.sqrt(np.maximum(variance, 0.0)), dtype=np.float32)
    return LocalPlanes(np.asarray(mean + level, dtype=np.float32), along, down, residual)
