"""Compiled kernels of photometric stereo: one pass over the intensities, one over the normals.

All loops run over blocks of a row that stay in the first-level cache while every light, and every pass of the
solution, goes over them; so the intensities are read from memory once, and the innermost loops are over
neighbouring pixels, which the compiler turns into vector instructions.  Irradiance vectors are linear between
knots at the corners of blocks.  Threads share rows, and every pixel is computed by one thread in a fixed order:
the result does not depend on the number of threads.
"""

from __future__ import annotations

import math

import numpy as np
from numba import njit, prange

from reliefscope.units import FloatImage

BLOCK = 128
"""Columns of a block, and distance of the knots in rows and columns."""
_STRIP = 16
"""Rows that share one set of buffers."""
_TINY = np.float32(1e-12)
FLAGS = {"contract", "nsz", "arcp", "reassoc"}


@njit(cache=True, error_model="numpy", fastmath=FLAGS)
def coefficients(
    knots: FloatImage, row: int, block: int, start: FloatImage, step: FloatImage
) -> None:
    """Values (L, 3) at the first pixel of a block of ``row``, and their change per pixel.

    ``knots`` are (L, KR, KC, 3).
    """
    lights = knots.shape[0]
    above = row // BLOCK
    t = np.float32(row - above * BLOCK) / np.float32(BLOCK)
    for light in range(lights):
        for axis in range(3):
            left = knots[light, above, block, axis]
            left += t * (knots[light, above + 1, block, axis] - left)
            right = knots[light, above, block + 1, axis]
            right += t * (knots[light, above + 1, block + 1, axis] - right)
            start[light, axis] = left
            step[light, axis] = (right - left) / np.float32(BLOCK)


@njit(cache=True, error_model="numpy", fastmath=FLAGS)
def store(
    g: FloatImage,
    residual: FloatImage,
    row: int,
    first: int,
    count: int,
    normals: FloatImage,
    albedo: FloatImage,
    residuals: FloatImage,
) -> None:
    """Split the solutions ``g`` (3, B) of a block into normal and albedo; NaN where there is none."""
    for i in range(count):
        norm = np.sqrt(g[0, i] * g[0, i] + g[1, i] * g[1, i] + g[2, i] * g[2, i])
        # not > also holds for NaN
        inverse = np.float32(1.0) / norm if norm > _TINY else np.float32(np.nan)
        normals[row, first + i, 0] = g[0, i] * inverse
        normals[row, first + i, 1] = g[1, i] * inverse
        normals[row, first + i, 2] = g[2, i] * inverse
        known = np.float32(0.0) * inverse
        albedo[row, first + i] = norm + known
        residuals[row, first + i] = residual[i] + known


@njit(cache=True, parallel=True, error_model="numpy", fastmath=FLAGS)
def solve_least_squares(
    images: FloatImage,
    gains: FloatImage,
    inverses: FloatImage,
    fields: FloatImage,
    normals: FloatImage,
    albedo: FloatImage,
    residuals: FloatImage,
) -> None:
    """Eq. 6 and 7 for every pixel.

    ``images`` (L, H, W) times ``gains`` (L,) are the intensities; ``inverses`` and ``fields`` (L, KR, KC, 3) the
    columns of the pseudo-inverse and the irradiance vectors at the knots; outputs ``normals`` (H, W, 3), ``albedo``
    (H, W), ``residuals`` (H, W).  A pixel without light or with a NaN gets NaN in all of them.
    """
    lights, height, width = images.shape
    for strip in prange((height + _STRIP - 1) // _STRIP):
        g = np.empty((3, BLOCK), np.float32)
        squares = np.empty(BLOCK, np.float32)
        p0 = np.empty((lights, 3), np.float32)
        dp = np.empty((lights, 3), np.float32)
        e0 = np.empty((lights, 3), np.float32)
        de = np.empty((lights, 3), np.float32)
        share = np.float32(1.0) / np.float32(lights)
        for row in range(strip * _STRIP, min((strip + 1) * _STRIP, height)):
            for block in range((width + BLOCK - 1) // BLOCK):
                first = block * BLOCK
                count = min(BLOCK, width - first)
                coefficients(inverses, row, block, p0, dp)
                coefficients(fields, row, block, e0, de)
                g[:] = np.float32(0.0)
                squares[:] = np.float32(0.0)
                for light in range(lights):
                    line = images[light, row, first : first + count]
                    gain = gains[light]
                    for i in range(count):
                        at = np.float32(i)
                        value = gain * line[i]
                        g[0, i] += (p0[light, 0] + at * dp[light, 0]) * value
                        g[1, i] += (p0[light, 1] + at * dp[light, 1]) * value
                        g[2, i] += (p0[light, 2] + at * dp[light, 2]) * value
                for light in range(lights):
                    line = images[light, row, first : first + count]
                    gain = gains[light]
                    for i in range(count):
                        at = np.float32(i)
                        model = (e0[light, 0] + at * de[light, 0]) * g[0, i]
                        model += (e0[light, 1] + at * de[light, 1]) * g[1, i]
                        model += (e0[light, 2] + at * de[light, 2]) * g[2, i]
                        difference = gain * line[i] - model
                        squares[i] += difference * difference
                for i in range(count):
                    squares[i] = np.sqrt(squares[i] * share)
                store(g, squares, row, first, count, normals, albedo, residuals)


@njit(cache=True, parallel=True, error_model="numpy", fastmath=FLAGS)
def score_quality(
    normals: FloatImage,
    residuals: FloatImage,
    residual_scale: float,
    slant_scale: float,
    change_scale: float,
    slant: FloatImage,
    change: FloatImage,
    quality: FloatImage,
) -> None:
    """Slant, eq. 8 with the Sobel operators of eq. 9, and eq. 10 for every pixel.

    ``normals`` (H, W, 3), everything else (H, W).  The kernels are applied as written (correlation) per pixel;
    beyond the border the nearest pixel is repeated.  The second kernel is d/dy with y up: the row above (smaller
    index) counts positive.  The quality is 0 where the normal or a neighbour is missing or looks away from the camera.
    """
    height, width = residuals.shape
    by_residual = np.float32(1.0 / (residual_scale * residual_scale))
    by_slant = np.float32(1.0 / (slant_scale * slant_scale))
    by_change = np.float32(1.0 / (change_scale * change_scale))
    eighth = np.float32(0.125)
    for strip in prange((height + _STRIP - 1) // _STRIP):
        # sums of the three rows (x smoothed down, y differenced), with one repeated pixel at either end
        x = np.empty(width + 2, np.float32)
        y = np.empty(width + 2, np.float32)
        two = np.float32(2.0)
        for row in range(strip * _STRIP, min((strip + 1) * _STRIP, height)):
            above = normals[max(row - 1, 0)]
            here = normals[row]
            below = normals[min(row + 1, height - 1)]
            for column in range(width):
                x[column + 1] = above[column, 0] + two * here[column, 0] + below[column, 0]
                y[column + 1] = above[column, 1] - below[column, 1]
            x[0] = x[1]
            x[width + 1] = x[width]
            y[0] = y[1]
            y[width + 1] = y[width]
            for column in range(width):
                dx = eighth * (x[column + 2] - x[column])
                dy = eighth * (y[column] + two * y[column + 1] + y[column + 2])
                squared = dx * dx + dy * dy
                angle = _arccos(here[column, 2])
                residual = residuals[row, column]
                slant[row, column] = angle
                change[row, column] = np.sqrt(squared)
                exponent = residual * residual * by_residual
                exponent += angle * angle * by_slant + squared * by_change
                seen = here[column, 2] > np.float32(0.0) and exponent < np.float32(120.0)
                quality[row, column] = _half_to_the(exponent) if seen else np.float32(0.0)


@njit(cache=True, error_model="numpy", fastmath=FLAGS)
def _arccos(value: np.float32) -> np.float32:
    """Inverse cosine, values beyond -1 and 1 clamped; absolute error below 3e-7.

    Polynomial 4.4.46 of Abramowitz and Stegun, which vector instructions can evaluate.
    """
    one = np.float32(1.0)
    a = np.float32(min(abs(value), one))
    p = np.float32(-0.0012624911)
    p = p * a + np.float32(0.0066700901)
    p = p * a + np.float32(-0.0170881256)
    p = p * a + np.float32(0.0308918810)
    p = p * a + np.float32(-0.0501743046)
    p = p * a + np.float32(0.0889789874)
    p = p * a + np.float32(-0.2145988016)
    p = p * a + np.float32(1.5707963050)
    near = np.sqrt(one - a) * p
    angle = near if value >= np.float32(0.0) else np.float32(math.pi) - near
    return np.float32(angle + np.float32(0.0) * value)


@njit(cache=True, error_model="numpy", fastmath=FLAGS)
def _half_to_the(exponent: np.float32) -> np.float32:
    """2 to the power of ``-exponent``, from 0 to 120; relative error below 3e-7."""
    whole = np.int32(exponent)
    t = (np.float32(whole) - exponent) * np.float32(math.log(2.0))
    p = np.float32(1.0 / 5040.0)
    p = p * t + np.float32(1.0 / 720.0)
    p = p * t + np.float32(1.0 / 120.0)
    p = p * t + np.float32(1.0 / 24.0)
    p = p * t + np.float32(1.0 / 6.0)
    p = p * t + np.float32(0.5)
    p = p * t + np.float32(1.0)
    p = p * t + np.float32(1.0)
    return p * np.int32((127 - whole) << 23).view(np.float32)
