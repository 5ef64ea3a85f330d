"""Compiled kernels that turn a surface into an image seen through one point of the pupil, and blur it.

All lengths are pixels of the surface's grid; slopes are x right, y up, rows grow downward.  The ray that
reaches pixel (r, c) through pupil point k runs through the focal plane at that pixel and leans by
``slope + kappa * field position``, so at height z it is above column ``c + z sx`` and row ``r - z sy``.
Every pixel is computed by one thread in a fixed order: the result does not depend on their number.
"""

from __future__ import annotations

import math

import numpy as np
from numba import njit, prange
from numpy.typing import NDArray

from reliefscope.units import FloatImage

DepthStack = NDArray[np.uint16]

DEPTH_LEVELS = 65535
_REFINEMENTS = 2
_ITERATIONS = 3
_GENTLE_SQUARED = np.float32(0.25**2)
"""Square of the rise of a surface over that of a ray up to which three iterations leave less than 2 % of
the first guess's error."""


@njit(cache=True, inline="always", fastmath=True)
def bilinear(flat: FloatImage, stride: int, x: np.float32, y: np.float32) -> np.float32:
    """Value of a flattened image at column ``x`` and row ``y``, both at least 0 and inside by one pixel.

    Signed conversions vectorise; unsigned indices spare the check for negative ones.
    """
    column = np.int32(x)
    row = np.int32(y)
    a = x - np.float32(column)
    b = y - np.float32(row)
    at = np.uint32(row * np.int32(stride) + column)
    below = np.uint32(at + np.uint32(stride))
    left = flat[at]
    top = left + a * (flat[np.uint32(at + np.uint32(1))] - left)
    left = flat[below]
    bottom = left + a * (flat[np.uint32(below + np.uint32(1))] - left)
    value: np.float32 = top + b * (bottom - top)
    return value


@njit(cache=True, inline="always", fastmath=True)
def _march(
    flat: FloatImage,
    stride: int,
    x0: np.float32,
    y0: np.float32,
    sx: np.float32,
    sy: np.float32,
    high: np.float32,
    low: np.float32,
) -> np.float32:
    """Height at which a ray first meets the surface between ``high`` and ``low``, in steps of a pixel."""
    steps = int((high - low) * math.sqrt(sx * sx + sy * sy)) + 1
    dz = (high - low) / np.float32(steps)
    above_z = high
    above_gap = high - bilinear(flat, stride, x0 + high * sx, y0 - high * sy)
    z = above_z
    gap = above_gap
    for i in range(1, steps + 1):
        if gap <= np.float32(0.0):
            break
        above_z = z
        above_gap = gap
        z = high - np.float32(i) * dz
        gap = z - bilinear(flat, stride, x0 + z * sx, y0 - z * sy)
    for _ in range(_REFINEMENTS):
        if above_gap - gap < np.float32(1e-6):
            break
        middle = z + (above_z - z) * (gap / (gap - above_gap))
        middle_gap = middle - bilinear(flat, stride, x0 + middle * sx, y0 - middle * sy)
        if middle_gap > np.float32(0.0):
            above_z = middle
            above_gap = middle_gap
        else:
            z = middle
            gap = middle_gap
    if above_gap - gap > np.float32(1e-6):
        z += (above_z - z) * (gap / (gap - above_gap))
    return z


@njit(cache=True, parallel=True, fastmath=True)
def intersect(
    height: FloatImage,
    local_high: FloatImage,
    local_low: FloatImage,
    local_rise: FloatImage,
    slopes: FloatImage,
    kappa: float,
    centre: FloatImage,
    margin: int,
    lowest: float,
    step: float,
    depth: DepthStack,
) -> None:
    """Height of the first surface point on the ray of every pixel, coming from the objective.

    ``local_high``, ``local_low`` and ``local_rise`` bound the heights and their change per pixel that any
    ray of a pixel can meet.  Where the surface rises at most a quarter as steeply as the ray, nothing can
    hide and ``z = h(x + z s)`` converges by itself; elsewhere the ray is followed.  ``depth`` (K, H, W)
    receives ``round((z - lowest) / step)``.
    """
    count, rows, columns = depth.shape
    stride = height.shape[1]
    flat = height.reshape(-1)
    kappa32 = np.float32(kappa)
    lowest32 = np.float32(lowest)
    levels_per_px = np.float32(1.0 / step)
    for row in prange(rows):
        found = np.empty(columns, np.float32)
        start = height[row + margin, margin : margin + columns]
        high = local_high[row + margin, margin : margin + columns]
        low = local_low[row + margin, margin : margin + columns]
        rise = local_rise[row + margin, margin : margin + columns]
        y0 = np.float32(row + margin)
        for k in range(count):
            sx0 = slopes[k, 0] - kappa32 * centre[0]
            sy = slopes[k, 1] + kappa32 * (centre[1] - np.float32(row))
            for column in range(columns):
                sx = sx0 + kappa32 * np.float32(column)
                x0 = np.float32(column + margin)
                z = start[column]
                for _ in range(_ITERATIONS):
                    z = bilinear(flat, stride, x0 + z * sx, y0 - z * sy)
                found[column] = z
            for column in range(columns):
                sx = sx0 + kappa32 * np.float32(column)
                if rise[column] * rise[column] * (sx * sx + sy * sy) > _GENTLE_SQUARED:
                    found[column] = _march(
                        flat,
                        stride,
                        np.float32(column + margin),
                        y0,
                        sx,
                        sy,
                        high[column],
                        low[column],
                    )
            levels = depth[k, row]
            for column in range(columns):
                level = (found[column] - lowest32) * levels_per_px + np.float32(0.5)
                levels[column] = np.uint16(
                    min(max(level, np.float32(0.0)), np.float32(DEPTH_LEVELS))
                )


@njit(cache=True, parallel=True, fastmath=True)
def gather(
    radiance: FloatImage,
    depth: DepthStack,
    slopes: FloatImage,
    weights: FloatImage,
    kappa: float,
    centre: FloatImage,
    margin: int,
    lowest: float,
    step: float,
    image: FloatImage,
) -> None:
    """Add to ``image`` (C, H, W) the weighted radiance (C, H', W') that each pupil point sees at its depth."""
    channels, rows, columns = image.shape
    count = len(depth)
    stride = np.uint32(radiance.shape[2])
    next_column = np.uint32(1)
    kappa32 = np.float32(kappa)
    lowest32 = np.float32(lowest)
    step32 = np.float32(step)
    for row in prange(rows):
        # Where a ray ends is the same for every channel.
        part_x = np.empty(columns, np.float32)
        part_y = np.empty(columns, np.float32)
        place = np.empty(columns, np.uint32)
        for k in range(count):
            weight = weights[k]
            sx0 = slopes[k, 0] - kappa32 * centre[0]
            sy = slopes[k, 1] + kappa32 * (centre[1] - np.float32(row))
            y0 = np.float32(row + margin)
            levels = depth[k, row]
            for column in range(columns):
                z = lowest32 + step32 * np.float32(levels[column])
                sx = sx0 + kappa32 * np.float32(column)
                x = np.float32(column + margin) + z * sx
                y = y0 - z * sy
                left = np.int32(x)
                top = np.int32(y)
                part_x[column] = x - np.float32(left)
                part_y[column] = y - np.float32(top)
                place[column] = np.uint32(top * np.int32(stride) + left)
            for channel in range(channels):
                flat = radiance[channel].reshape(-1)
                line = image[channel, row]
                for column in range(columns):
                    at = place[column]
                    below = np.uint32(at + stride)
                    a = part_x[column]
                    upper = flat[at]
                    upper += a * (flat[np.uint32(at + next_column)] - upper)
                    lower = flat[below]
                    lower += a * (flat[np.uint32(below + next_column)] - lower)
                    line[column] += weight * (upper + part_y[column] * (lower - upper))


@njit(cache=True, inline="always", fastmath=True)
def _blur_row(
    image: FloatImage, row: int, taps_x: FloatImage, taps_y: FloatImage, target: FloatImage
) -> None:
    """One row of a separable symmetric blur of ``image`` (H, W)."""
    rows, columns = image.shape
    reach_x = len(taps_x) - 1
    line = np.empty(columns + 2 * reach_x, np.float32)
    middle = line[reach_x : reach_x + columns]
    source = image[row]
    for column in range(columns):
        middle[column] = taps_y[0] * source[column]
    for i in range(1, len(taps_y)):
        upper = image[max(row - i, 0)]
        lower = image[min(row + i, rows - 1)]
        tap = taps_y[i]
        for column in range(columns):
            middle[column] += tap * (upper[column] + lower[column])
    for i in range(reach_x):
        line[i] = middle[0]
        line[reach_x + columns + i] = middle[columns - 1]
    for column in range(columns):
        target[column] = taps_x[0] * middle[column]
    for i in range(1, reach_x + 1):
        left = line[reach_x - i : reach_x - i + columns]
        right = line[reach_x + i : reach_x + i + columns]
        tap = taps_x[i]
        for column in range(columns):
            target[column] += tap * (left[column] + right[column])


@njit(cache=True, parallel=True, fastmath=True)
def blur(image: FloatImage, taps_x: FloatImage, taps_y: FloatImage, out: FloatImage) -> None:
    """Separable symmetric blur of (C, H, W); ``taps[i]`` is the weight at distance i, edges are repeated."""
    channels, rows, _ = image.shape
    for row in prange(rows):
        for channel in range(channels):
            _blur_row(image[channel], row, taps_x, taps_y, out[channel, row])


@njit(cache=True, parallel=True, fastmath=True)
def blur_to_mosaic(
    image: FloatImage, taps_x: FloatImage, taps_y: FloatImage, out: FloatImage
) -> None:
    """What pixels below an RGGB filter (H, W) get of a blurred image (3, H, W); see :func:`blur`."""
    _, rows, columns = image.shape
    for row in prange(rows):
        # Red is found in even rows, blue in odd ones, at every other pixel beside green.
        coloured = row & 1
        beside = np.empty(columns, np.float32)
        _blur_row(image[1], row, taps_x, taps_y, out[row])
        _blur_row(image[2 * coloured], row, taps_x, taps_y, beside)
        for column in range(coloured, columns, 2):
            out[row, column] = beside[column]


def gaussian_taps(sigma_px: float) -> FloatImage:
    """Half of a normalised Gaussian kernel, from its middle outward; one tap where it does nothing."""
    if sigma_px < 0.2:
        return np.ones(1, dtype=np.float32)
    distance = np.arange(math.ceil(3.2 * sigma_px) + 1)
    taps = np.exp(-0.5 * (distance / sigma_px) ** 2)
    taps /= taps[0] + 2 * taps[1:].sum()
    half: FloatImage = taps.astype(np.float32)
    return half
