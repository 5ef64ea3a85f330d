"""How far a matched height may be off: a standard error from the peak of the score and its surroundings.

Three things tell.  The *width* of the peak: matching to a likelihood, ``log L ~ -log(1 - score + softness)``,
whose curvature at the peak falls with noise and with lack of texture.  The *roughness* of the heights around the
pixel, their deviation from a plane: where matching errs, neighbours disagree, and at a step the windows straddle
it.  And how much *brighter* the brightest place nearby is: the edge of a bright surface outweighs what a dark one
beside it shows, so that gaps and shadowed ground take the height of what stands over them.  The standard error is
a product of powers of them, fitted to the true errors of the simulated instrument
(docs/explanation/default-method.md tells scenes and coverage).
"""

from __future__ import annotations

import math

import cv2
import numpy as np

from reliefscope.units import FloatImage

SCALE = 0.1
WIDTH_EXPONENT = 1.0
ROUGHNESS_EXPONENTS = (0.4, 0.4)
BRIGHTNESS_EXPONENT = 1.5
"""Standard error in um per um of width, of roughness near and far, and by the ratio of intensities, to these powers."""
GREATEST_CONTRAST = 1.5
"""Logarithm of that ratio beyond which it tells no more: paint can be darker than any gap."""
BRIGHT_WINDOW = 11
"""Window, in samples, in which the brightest place is looked for: as far as the windows of matching reach."""
WINDOWS = (5, 9)
"""Windows of the roughness in samples: about that of matching, and one that sees a step from either side."""
LEAST_ROUGHNESS_UM = 0.05
GREATEST_UM = 1000.0
"""Standard error where nothing tells; finite, so that it can be interpolated."""


def roughness(height_um: FloatImage, window: int) -> FloatImage:
    """RMS deviation (H, W) of the heights in an odd window from the plane that fits them best."""
    reach = window // 2
    offsets = np.arange(-reach, reach + 1, dtype=np.float32)
    spread = float(np.mean(offsets**2))
    ramp = np.tile(offsets, (window, 1)) / np.float32(spread * window**2)
    z = height_um - np.float32(height_um.mean(dtype=np.float64))
    mean = cv2.blur(z, (window, window))
    along = cv2.filter2D(z, -1, ramp)
    down = cv2.filter2D(z, -1, np.ascontiguousarray(ramp.T))
    variance = cv2.blur(z * z, (window, window)) - mean**2 - spread * (along**2 + down**2)
    return np.asarray(np.sqrt(np.maximum(variance, 0.0)), dtype=np.float32)


def brightest(brightness: FloatImage) -> FloatImage:
    """Greatest mean of 3 x 3 samples (H, W) in :data:`BRIGHT_WINDOW`."""
    window = np.ones((BRIGHT_WINDOW, BRIGHT_WINDOW), np.uint8)
    return np.asarray(cv2.dilate(cv2.blur(brightness, (3, 3)), window), dtype=np.float32)


def knows_nothing_um(range_um: tuple[float, float]) -> float:
    """Standard error of a height that is guessed: that of an even distribution over the range."""
    return (range_um[1] - range_um[0]) / math.sqrt(12.0)


def standard_error(
    height_um: FloatImage,
    peak: FloatImage,
    curvature: FloatImage,
    brightness: FloatImage,
    softness: float,
) -> FloatImage:
    """Standard error (H, W) of matched heights in um, at most :data:`GREATEST_UM`.

    Parameters
    ----------
    height_um:
        (H, W) heights, NaN where missing (:data:`GREATEST_UM`).
    peak, curvature:
        Greatest score, and minus its second derivative with height there, per um squared.
    brightness:
        Logarithm of intensity there; undefined where the height is missing.
    softness:
        What ``1 - score`` leaves at a perfect match.
    """
    known = np.isfinite(height_um)
    filled = np.where(
        known, height_um, np.float32(np.median(height_um[known]) if known.any() else 0)
    )
    darkest = np.float32(brightness[known].min() if known.any() else 0)
    light = np.where(known, brightness, darkest)
    near, far = (np.maximum(roughness(filled, window), LEAST_ROUGHNESS_UM) for window in WINDOWS)
    with np.errstate(divide="ignore", invalid="ignore"):
        width = np.sqrt((1.0 + softness - peak) / np.maximum(curvature, 0.0))
        sigma = (
            SCALE
            * width**WIDTH_EXPONENT
            * near ** ROUGHNESS_EXPONENTS[0]
            * far ** ROUGHNESS_EXPONENTS[1]
            * np.exp(BRIGHTNESS_EXPONENT * np.minimum(brightest(light) - light, GREATEST_CONTRAST))
        )
    sigma[~known] = GREATEST_UM
    return np.asarray(np.fmin(sigma, GREATEST_UM), dtype=np.float32)


def error_share(height_um: FloatImage, sigma_um: FloatImage, quality: FloatImage) -> float:
    """Variance of the errors of heights (H, W) over that of the heights, where their quality is above 0.

    The square of their mean standard error: the mean of the squares would be that of the few worst.
    """
    known = np.isfinite(height_um) & np.isfinite(sigma_um) & (quality > 0.0)
    if not known.any():
        return 0.0
    variance = float(np.var(height_um[known], dtype=np.float64))
    error = float(np.mean(sigma_um[known], dtype=np.float64))
    return error**2 / variance if variance > 0.0 else 0.0
