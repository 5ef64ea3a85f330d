"""Compiled parts of the multigrid: nine-point stencils, their coarsening, smoothing and transfer.

A stencil is stored as ``couplings`` (5, H + 2, W + 2) float32: the diagonal, then what joins a pixel to its
neighbours east, south, south-east and south-west (positive: a spring that pulls the two together); the other four
follow from symmetry.  Stencils and images have a margin of one pixel of zeros, so that no loop has to ask where the
border is; row and column below count from the first pixel within it.  Interpolation is stored per coarse pixel
as the weights (3, 3) with which it enters the fine pixels around it.
"""

from __future__ import annotations

import numpy as np
from numba import njit, prange

from reliefscope.units import FloatArray, FloatImage

DIAGONAL, EAST, SOUTH, SOUTH_EAST, SOUTH_WEST = range(5)


@njit(cache=True, parallel=True)
def from_springs(
    hold: FloatArray, across: FloatArray, down: FloatArray, couplings: FloatImage
) -> None:
    """Stencil of ``hold`` (H, W) and springs ``across`` (H, W-1), ``down`` (H-1, W)."""
    height, width = hold.shape
    for row in prange(height):
        for column in range(width):
            total = hold[row, column]
            east = across[row, column] if column < width - 1 else 0.0
            south = down[row, column] if row < height - 1 else 0.0
            total += east + south
            if column > 0:
                total += across[row, column - 1]
            if row > 0:
                total += down[row - 1, column]
            couplings[DIAGONAL, row + 1, column + 1] = total
            couplings[EAST, row + 1, column + 1] = east
            couplings[SOUTH, row + 1, column + 1] = south


@njit(cache=True)
def _sides(a: FloatImage, y: int, x: int, rows: bool) -> tuple[np.float32, np.float32]:
    """Shares of the two coarse pixels beside the pixel at (y, x) of the arrays: left and right, or up and down."""
    north, south = a[SOUTH, y - 1, x], a[SOUTH, y, x]
    west, east = a[EAST, y, x - 1], a[EAST, y, x]
    north_west, north_east = a[SOUTH_EAST, y - 1, x - 1], a[SOUTH_WEST, y - 1, x + 1]
    south_west, south_east = a[SOUTH_WEST, y, x], a[SOUTH_EAST, y, x]
    if rows:
        first = north_west + north + north_east
        second = south_west + south + south_east
        along = west + east
    else:
        first = north_west + west + south_west
        second = north_east + east + south_east
        along = north + south
    total = max(a[DIAGONAL, y, x] - along, first + second)
    if total > 0:
        return first / total, second / total
    return np.float32(0), np.float32(0)


@njit(cache=True, parallel=True)
def interpolation(a: FloatImage, weights: FloatImage) -> None:
    """Weights (h, w, 3, 3) of each coarse pixel (2 i, 2 j) in the fine pixels around it.

    A pixel between two coarse ones divides itself by the springs that pull it either way, a pixel
    between four by its own equation (Alcouffe, Brandt, Dendy and Painter): heights are not
    interpolated across a place where the springs are cut.
    """
    height, width = a.shape[1] - 2, a.shape[2] - 2
    rows, columns = weights.shape[:2]
    weights[...] = 0.0
    for parity in range(2):
        # pixels right of and below a coarse one write to two coarse pixels: even ones, then odd ones
        for half in prange((rows - parity + 1) // 2):
            i = 2 * half + parity
            y = 2 * i + 1
            for j in range(columns):
                x = 2 * j + 1
                weights[i, j, 1, 1] = 1.0
                right = 2 * j + 1 < width
                below = 2 * i + 1 < height
                if right:
                    left_share, right_share = _sides(a, y, x + 1, False)
                    weights[i, j, 1, 2] = left_share
                    if j + 1 < columns:
                        weights[i, j + 1, 1, 0] = right_share
                if below:
                    upper_share, lower_share = _sides(a, y + 1, x, True)
                    weights[i, j, 2, 1] = upper_share
                    if i + 1 < rows:
                        weights[i + 1, j, 0, 1] = lower_share
    for parity in range(2):
        for half in prange((rows - parity + 1) // 2):
            i = 2 * half + parity
            for j in range(columns):
                y, x = 2 * i + 2, 2 * j + 2
                if y <= height and x <= width and a[DIAGONAL, y, x] > 0:
                    _centre(a, weights, i, j, y, x)


@njit(cache=True)
def _centre(a: FloatImage, weights: FloatImage, i: int, j: int, y: int, x: int) -> None:
    """Weights of up to four coarse pixels in the one between them, at (y, x) of the arrays."""
    rows, columns = weights.shape[:2]
    inverse = 1 / a[DIAGONAL, y, x]
    north, south = a[SOUTH, y - 1, x], a[SOUTH, y, x]
    west, east = a[EAST, y, x - 1], a[EAST, y, x]
    lower, more = i + 1 < rows, j + 1 < columns
    value = a[SOUTH_EAST, y - 1, x - 1] + north * weights[i, j, 1, 2] + west * weights[i, j, 2, 1]
    weights[i, j, 2, 2] = value * inverse
    if more:
        value = a[SOUTH_WEST, y - 1, x + 1] + north * weights[i, j + 1, 1, 0]
        value += east * weights[i, j + 1, 2, 1]
        weights[i, j + 1, 2, 0] = value * inverse
    if lower:
        value = a[SOUTH_WEST, y, x] + south * weights[i + 1, j, 1, 2]
        value += west * weights[i + 1, j, 0, 1]
        weights[i + 1, j, 0, 2] = value * inverse
    if lower and more:
        value = a[SOUTH_EAST, y, x] + south * weights[i + 1, j + 1, 1, 0]
        value += east * weights[i + 1, j + 1, 0, 1]
        weights[i + 1, j + 1, 0, 0] = value * inverse


@njit(cache=True, parallel=True)
def coarsen(a: FloatImage, weights: FloatImage, coarse: FloatImage) -> None:
    """Galerkin stencil of the coarse grid: P' A P, so that no coarse move is judged softer than it is."""
    height, width = a.shape[1] - 2, a.shape[2] - 2
    rows, columns = weights.shape[:2]
    for i in prange(rows):
        image = np.empty((5, 5), np.float32)
        for j in range(columns):
            image[:] = 0.0
            # A applied to the column of P that belongs to (i, j): a 5 x 5 patch around (2 i, 2 j)
            for dy in range(3):
                y = 2 * i + dy
                for dx in range(3):
                    x = 2 * j + dx
                    p = weights[i, j, dy, dx]
                    if p == 0 or y < 1 or y > height or x < 1 or x > width:
                        continue
                    image[dy + 1, dx + 1] += p * a[DIAGONAL, y, x]
                    image[dy + 1, dx] -= p * a[EAST, y, x - 1]
                    image[dy + 1, dx + 2] -= p * a[EAST, y, x]
                    image[dy, dx + 1] -= p * a[SOUTH, y - 1, x]
                    image[dy + 2, dx + 1] -= p * a[SOUTH, y, x]
                    image[dy, dx] -= p * a[SOUTH_EAST, y - 1, x - 1]
                    image[dy + 2, dx + 2] -= p * a[SOUTH_EAST, y, x]
                    image[dy, dx + 2] -= p * a[SOUTH_WEST, y - 1, x + 1]
                    image[dy + 2, dx] -= p * a[SOUTH_WEST, y, x]
            coarse[DIAGONAL, i + 1, j + 1] = _product(weights, i, j, image, 0, 0)
            if j + 1 < columns:
                coarse[EAST, i + 1, j + 1] = -_product(weights, i, j, image, 0, 1)
            if i + 1 < rows:
                coarse[SOUTH, i + 1, j + 1] = -_product(weights, i, j, image, 1, 0)
                if j + 1 < columns:
                    coarse[SOUTH_EAST, i + 1, j + 1] = -_product(weights, i, j, image, 1, 1)
                if j > 0:
                    coarse[SOUTH_WEST, i + 1, j + 1] = -_product(weights, i, j, image, 1, -1)


@njit(cache=True)
def _product(weights: FloatImage, i: int, j: int, image: FloatImage, di: int, dj: int) -> float:
    """Inner product of the patch around (2 i, 2 j) with the column of P of (i + di, j + dj)."""
    total = 0.0
    for dy in range(max(0, -2 * di), 3 if di == 0 else 2):
        for dx in range(1 if dj < 0 else 0, 2 if dj > 0 else 3):
            total += weights[i + di, j + dj, dy, dx] * image[1 + 2 * di + dy, 1 + 2 * dj + dx]
    return total


@njit(cache=True, parallel=True)
def smooth(
    a: FloatImage, inverse: FloatImage, right: FloatImage, z: FloatImage, colour: int
) -> None:
    """Solve every pixel of one of the four colours (row parity, column parity) for its own equation."""
    height, width = z.shape[0] - 2, z.shape[1] - 2
    first = colour // 2
    for half in prange((height - first + 1) // 2):
        y = 2 * half + first + 1
        for x in range(1 + colour % 2, width + 1, 2):
            z[y, x] = (right[y, x] + _pull(a, z, y, x)) * inverse[y, x]


@njit(cache=True, parallel=True)
def smooth_five(
    a: FloatImage, inverse: FloatImage, right: FloatImage, z: FloatImage, colour: int
) -> None:
    """:func:`smooth` for stencils without diagonal neighbours, which need two colours only."""
    height, width = z.shape[0] - 2, z.shape[1] - 2
    for row in prange(height):
        y = row + 1
        for x in range(1 + (row + colour) % 2, width + 1, 2):
            total = right[y, x] + a[EAST, y, x - 1] * z[y, x - 1] + a[EAST, y, x] * z[y, x + 1]
            total += a[SOUTH, y - 1, x] * z[y - 1, x] + a[SOUTH, y, x] * z[y + 1, x]
            z[y, x] = total * inverse[y, x]


@njit(cache=True)
def _pull(a: FloatImage, z: FloatImage, y: int, x: int) -> np.float32:
    """Sum of coupling times height over the eight neighbours."""
    total: np.float32 = (
        a[EAST, y, x - 1] * z[y, x - 1]
        + a[EAST, y, x] * z[y, x + 1]
        + a[SOUTH, y - 1, x] * z[y - 1, x]
        + a[SOUTH, y, x] * z[y + 1, x]
        + a[SOUTH_EAST, y - 1, x - 1] * z[y - 1, x - 1]
        + a[SOUTH_EAST, y, x] * z[y + 1, x + 1]
        + a[SOUTH_WEST, y - 1, x + 1] * z[y - 1, x + 1]
        + a[SOUTH_WEST, y, x] * z[y + 1, x - 1]
    )
    return total


@njit(cache=True, parallel=True)
def residual(a: FloatImage, right: FloatImage, z: FloatImage, out: FloatImage) -> None:
    """``out = right - A z``."""
    height, width = z.shape[0] - 2, z.shape[1] - 2
    for row in prange(height):
        y = row + 1
        for x in range(1, width + 1):
            out[y, x] = right[y, x] - a[DIAGONAL, y, x] * z[y, x] + _pull(a, z, y, x)


@njit(cache=True, parallel=True)
def residual_five(a: FloatImage, right: FloatImage, z: FloatImage, out: FloatImage) -> None:
    """:func:`residual` for stencils without diagonal neighbours."""
    height, width = z.shape[0] - 2, z.shape[1] - 2
    for row in prange(height):
        y = row + 1
        for x in range(1, width + 1):
            value = right[y, x] - a[DIAGONAL, y, x] * z[y, x]
            value += a[EAST, y, x - 1] * z[y, x - 1] + a[EAST, y, x] * z[y, x + 1]
            out[y, x] = value + a[SOUTH, y - 1, x] * z[y - 1, x] + a[SOUTH, y, x] * z[y + 1, x]


@njit(cache=True, parallel=True)
def restrict(weights: FloatImage, fine: FloatImage, coarse: FloatImage) -> None:
    """Transpose of :func:`prolong`."""
    rows, columns = weights.shape[:2]
    for i in prange(rows):
        for j in range(columns):
            total = np.float32(0)
            for dy in range(3):
                for dx in range(3):
                    total += weights[i, j, dy, dx] * fine[2 * i + dy, 2 * j + dx]
            coarse[i + 1, j + 1] = total


@njit(cache=True, parallel=True)
def prolong(weights: FloatImage, coarse: FloatImage, fine: FloatImage) -> None:
    """Add the interpolated coarse correction to ``fine``."""
    height, width = fine.shape[0] - 2, fine.shape[1] - 2
    rows, columns = weights.shape[:2]
    for row in prange(height):
        i0 = row // 2
        i1 = min(i0 + (row & 1), rows - 1)
        for column in range(width):
            j0 = column // 2
            j1 = min(j0 + (column & 1), columns - 1)
            total = np.float32(0)
            for i in range(i0, i1 + 1):
                for j in range(j0, j1 + 1):
                    share = weights[i, j, row - 2 * i + 1, column - 2 * j + 1]
                    total += share * coarse[i + 1, j + 1]
            fine[row + 1, column + 1] += total


@njit(cache=True, parallel=True)
def enter(values: FloatArray, out: FloatImage) -> None:
    """Copy ``values`` (H, W) into the margin's inside."""
    height, width = values.shape
    for row in prange(height):
        for column in range(width):
            out[row + 1, column + 1] = values[row, column]


@njit(cache=True, parallel=True)
def leave(values: FloatImage, out: FloatArray) -> None:
    """Copy the inside of the margin to ``out`` (H, W)."""
    height, width = out.shape
    for row in prange(height):
        for column in range(width):
            out[row, column] = values[row + 1, column + 1]
