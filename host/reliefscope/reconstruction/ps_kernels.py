"""Compiled kernels of photometric stereo: one pass over the intensities, one over the normals.

Plain least squares needs the intensities twice (solution, then residual).  Both passes run over
blocks of a row that stay in the first-level cache, so the stack is read from memory once.  Threads
share rows, and every pixel is computed by one thread in a fixed order: the result does not depend
on the number of threads.
"""

from __future__ import annotations

import math

import numpy as np
from numba import njit, prange

from reliefscope.units import FloatImage

_BLOCK = 256
_LN2 = math.log(2.0)
_TINY = 1e-12


@njit(cache=True, parallel=True)
def solve_least_squares(
    images: FloatImage,
    pseudo_inverse: FloatImage,
    directions: FloatImage,
    normals: FloatImage,
    albedo: FloatImage,
    residual: FloatImage,
) -> None:
    """Eq. 6 and 7 for every pixel.

    ``images`` (L, H, W), ``pseudo_inverse`` (3, L), ``directions`` (L, 3); outputs ``normals`` (H,
    W, 3), ``albedo`` (H, W), ``residual`` (H, W).  A pixel without light or with a NaN gets NaN in
    all of them.
    """
    lights, height, width = images.shape
    for row in prange(height):
        gx = np.empty(_BLOCK, np.float32)
        gy = np.empty(_BLOCK, np.float32)
        gz = np.empty(_BLOCK, np.float32)
        squares = np.empty(_BLOCK, np.float32)
        for start in range(0, width, _BLOCK):
            count = min(_BLOCK, width - start)
            gx[:count] = 0.0
            gy[:count] = 0.0
            gz[:count] = 0.0
            squares[:count] = 0.0
            for light in range(lights):
                px = pseudo_inverse[0, light]
                py = pseudo_inverse[1, light]
                pz = pseudo_inverse[2, light]
                for i in range(count):
                    value = images[light, row, start + i]
                    gx[i] += px * value
                    gy[i] += py * value
                    gz[i] += pz * value
            for light in range(lights):
                lx = directions[light, 0]
                ly = directions[light, 1]
                lz = directions[light, 2]
                for i in range(count):
                    model = lx * gx[i] + ly * gy[i] + lz * gz[i]
                    difference = images[light, row, start + i] - model
                    squares[i] += difference * difference
            for i in range(count):
                norm = math.sqrt(gx[i] * gx[i] + gy[i] * gy[i] + gz[i] * gz[i])
                column = start + i
                if norm > _TINY:
                    normals[row, column, 0] = gx[i] / norm
                    normals[row, column, 1] = gy[i] / norm
                    normals[row, column, 2] = gz[i] / norm
                    albedo[row, column] = norm
                    residual[row, column] = math.sqrt(squares[i] / np.float32(lights))
                else:
                    normals[row, column, 0] = np.nan
                    normals[row, column, 1] = np.nan
                    normals[row, column, 2] = np.nan
                    albedo[row, column] = np.nan
                    residual[row, column] = np.nan


@njit(cache=True, parallel=True)
def solve_trimmed(
    images: FloatImage,
    pseudo_inverse: FloatImage,
    directions: FloatImage,
    first: int,
    last: int,
    minimum_determinant: float,
    normals: FloatImage,
    albedo: FloatImage,
    residual: FloatImage,
) -> None:
    """Eq. 6 and 7 from the lights of ranks ``first`` to ``last`` - 1 (darkest = 0) of each pixel.

    A pixel whose kept lights are badly spread (determinant of their normal matrix, over the cube of
    their number, below ``minimum_determinant``) is solved from all lights instead.  Shapes and the
    treatment of missing pixels as in :func:`solve_least_squares`.
    """
    lights, height, width = images.shape
    kept = last - first
    for row in prange(height):
        order = np.empty(lights, np.int64)
        values = np.empty(lights, np.float64)
        for column in range(width):
            for light in range(lights):
                value = images[light, row, column]
                position = light
                while position > 0 and values[position - 1] > value:
                    values[position] = values[position - 1]
                    order[position] = order[position - 1]
                    position -= 1
                values[position] = value
                order[position] = light
            xx = xy = xz = yy = yz = zz = 0.0
            bx = by = bz = 0.0
            for rank in range(first, last):
                lx = directions[order[rank], 0]
                ly = directions[order[rank], 1]
                lz = directions[order[rank], 2]
                value = values[rank]
                xx += lx * lx
                xy += lx * ly
                xz += lx * lz
                yy += ly * ly
                yz += ly * lz
                zz += lz * lz
                bx += lx * value
                by += ly * value
                bz += lz * value
            cxx = yy * zz - yz * yz
            cxy = xz * yz - xy * zz
            cxz = xy * yz - xz * yy
            determinant = xx * cxx + xy * cxy + xz * cxz
            begin = first
            end = last
            if determinant > minimum_determinant * kept * kept * kept:
                cyy = xx * zz - xz * xz
                cyz = xy * xz - xx * yz
                czz = xx * yy - xy * xy
                gx = (cxx * bx + cxy * by + cxz * bz) / determinant
                gy = (cxy * bx + cyy * by + cyz * bz) / determinant
                gz = (cxz * bx + cyz * by + czz * bz) / determinant
            else:
                begin = 0
                end = lights
                gx = gy = gz = 0.0
                for rank in range(lights):
                    gx += pseudo_inverse[0, order[rank]] * values[rank]
                    gy += pseudo_inverse[1, order[rank]] * values[rank]
                    gz += pseudo_inverse[2, order[rank]] * values[rank]
            squares = 0.0
            total = 0.0
            for rank in range(begin, end):
                light = order[rank]
                model = directions[light, 0] * gx + directions[light, 1] * gy
                difference = values[rank] - model - directions[light, 2] * gz
                squares += difference * difference
            for rank in range(lights):
                total += values[rank]
            norm = math.sqrt(gx * gx + gy * gy + gz * gz)
            if norm > _TINY and not math.isnan(total):
                normals[row, column, 0] = gx / norm
                normals[row, column, 1] = gy / norm
                normals[row, column, 2] = gz / norm
                albedo[row, column] = norm
                residual[row, column] = math.sqrt(squares / (end - begin))
            else:
                normals[row, column, 0] = np.nan
                normals[row, column, 1] = np.nan
                normals[row, column, 2] = np.nan
                albedo[row, column] = np.nan
                residual[row, column] = np.nan


@njit(cache=True, parallel=True)
def score_quality(
    normals: FloatImage,
    residual: FloatImage,
    residual_scale: float,
    slant_scale: float,
    change_scale: float,
    slant: FloatImage,
    change: FloatImage,
    quality: FloatImage,
) -> None:
    """Slant, eq. 8 with the Sobel operators of eq. 9, and eq. 10 for every pixel.

    ``normals`` (H, W, 3), everything else (H, W).  The kernels are applied as written (correlation)
    per pixel; beyond the border the nearest pixel is repeated.  The second kernel is d/dy with y
    up: the row above (smaller index) counts positive.  Where a neighbour is missing the quality is
    0.
    """
    height, width = residual.shape
    for row in prange(height):
        above = max(row - 1, 0)
        below = min(row + 1, height - 1)
        for column in range(width):
            left = max(column - 1, 0)
            right = min(column + 1, width - 1)
            dx = (
                normals[above, right, 0]
                - normals[above, left, 0]
                + 2 * (normals[row, right, 0] - normals[row, left, 0])
                + normals[below, right, 0]
                - normals[below, left, 0]
            ) / np.float32(8)
            dy = (
                normals[above, left, 1]
                - normals[below, left, 1]
                + 2 * (normals[above, column, 1] - normals[below, column, 1])
                + normals[above, right, 1]
                - normals[below, right, 1]
            ) / np.float32(8)
            angle = math.acos(min(max(normals[row, column, 2], np.float32(-1)), np.float32(1)))
            delta = math.sqrt(dx * dx + dy * dy)
            exponent = (
                (residual[row, column] / residual_scale) ** 2
                + (angle / slant_scale) ** 2
                + (delta / change_scale) ** 2
            )
            slant[row, column] = angle
            change[row, column] = delta
            score = math.exp(-_LN2 * exponent)
            quality[row, column] = score if score == score else 0.0  # noqa: PLR0124 - NaN test
