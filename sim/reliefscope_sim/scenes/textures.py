"""Random fields from which surfaces get their grain; the same seed gives the same field."""

from __future__ import annotations

import cv2
import numpy as np

from reliefscope.units import FloatImage
from reliefscope_sim.scenes.options import Options


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


def albedo_map(
    seed: int,
    options: Options,
    shape: tuple[int, int],
    pixel_um: float,
    mean: float = 0.9,
    texture: float = 0.0,
) -> FloatImage:
    """Even ``albedo`` (H, W), or one with speckle of relative standard deviation ``texture``, as the options say."""
    mean = options.number("albedo", mean, 0.0, 1.0)
    texture = options.number("texture", texture, 0.0, 1.0)
    if texture == 0.0:
        return np.full(shape, mean, dtype=np.float32)
    generator = np.random.default_rng([seed, 0xA1B])
    field = speckle(generator, shape, (2.0 / pixel_um, 5.0 / pixel_um), (1.0, 0.7))
    albedo: FloatImage = np.clip(mean * (1 + texture * field), 0.0, 1.0).astype(np.float32)
    return albedo
