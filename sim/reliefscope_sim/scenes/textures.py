"""Random fields from which surfaces get their grain; the same seed gives the same field."""

from __future__ import annotations

import cv2
import numpy as np

from reliefscope.units import FloatImage


def noise(
    generator: np.random.Generator, shape: tuple[int, int], correlation_px: float
) -> FloatImage:
    """Gaussian field (H, W) of zero mean and unit variance, smoothed to ``correlation_px`` (sigma)."""
    white = generator.standard_normal(shape, dtype=np.float32)
    if correlation_px < 0.3:
        return white
    smooth = cv2.GaussianBlur(white, (0, 0), correlation_px)
    scaled: FloatImage = smooth / np.float32(max(smooth.std(), 1e-6))
    return scaled


def speckle(
    generator: np.random.Generator,
    shape: tuple[int, int],
    correlations_px: tuple[float, ...],
    weights: tuple[float, ...],
) -> FloatImage:
    """Weighted sum of fields of several grain sizes, scaled back to unit variance."""
    total: FloatImage = np.zeros(shape, dtype=np.float32)
    for correlation_px, weight in zip(correlations_px, weights, strict=True):
        total += np.float32(weight) * noise(generator, shape, correlation_px)
    scaled: FloatImage = total / np.float32(np.sqrt(np.square(weights).sum()))
    return scaled
