"""Compiled parts of the multigrid: nine-point stencils, their coarsening, smoothing and transfer.

A stencil is stored as ``couplings`` (5, H, W) float32: the diagonal, then what joins a pixel to its
neighbours east, south, south-east and south-west (positive: a spring that pulls the two together);
the other four follow from symmetry.  Interpolation is stored per coarse pixel as the weights (3, 3)
with which it enters the fine pixels around it.
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
            couplings[DIAGONAL, row, column] = total
            couplings[EAST, row, column] = east
            couplings[SOUTH, row, column] = south
            couplings[SOUTH_EAST, row, column] = 0.0
            couplings[SOUTH_WEST, row, column] = 0.0


@njit(cache=True)
def _joint(a: FloatImage, row: int, column: int, dy: int, dx: int) -> np.float32:
    """Coupling between (row, column) and (row + dy, column + dx); zero beyond the border."""
    height, width = a.shape[1:]
    r = row + dy
    c = column + dx
    value = np.float32(0)
    if 0 <= r < height and 0 <= c < width:
        if dy == 0:
            value = a[EAST, row, min(column, c)]
        else:
            # as seen from the upper of the two pixels
            upper = row if dy > 0 else r
            start = column if dy > 0 else c
            sideways = dx if dy > 0 else -dx
            if sideways == 0:
                value = a[SOUTH, upper, start]
            elif sideways > 0:
                value = a[SOUTH_EAST, upper, start]
            else:
                value = a[SOUTH_WEST, upper, start]
    return value


@njit(cache=True)
def _between_columns(a: FloatImage, row: int, column: int, side: int) -> np.float32:
    """Share of the coarse pixel on ``side`` (-1 or 1) in the pixel between two of a row."""
    height, width = a.shape[1:]
    if column >= width or row >= height or column < 0:
        return np.float32(0)
    total = a[DIAGONAL, row, column]
    total -= _joint(a, row, column, -1, 0) + _joint(a, row, column, 1, 0)
    pull = _joint(a, row, column, -1, side) + _joint(a, row, column, 0, side)
    pull += _joint(a, row, column, 1, side)
    other = _joint(a, row, column, -1, -side) + _joint(a, row, column, 0, -side)
    other += _joint(a, row, column, 1, -side)
    total = max(total, pull + other)
    return pull / total if pull > 0 else np.float32(0)


@njit(cache=True)
def _between_rows(a: FloatImage, row: int, column: int, side: int) -> np.float32:
    """Share of the coarse pixel on ``side`` (-1 above, 1 below) in the pixel between two of a column."""
    height, width = a.shape[1:]
    if column >= width or row >= height or row < 0:
        return np.float32(0)
    total = a[DIAGONAL, row, column]
    total -= _joint(a, row, column, 0, -1) + _joint(a, row, column, 0, 1)
    pull = _joint(a, row, column, side, -1) + _joint(a, row, column, side, 0)
    pull += _joint(a, row, column, side, 1)
    other = _joint(a, row, column, -side, -1) + _joint(a, row, column, -side, 0)
    other += _joint(a, row, column, -side, 1)
    total = max(total, pull + other)
    return pull / total if pull > 0 else np.float32(0)


@njit(cache=True, parallel=True)
def interpolation(a: FloatImage, weights: FloatImage) -> None:
    """Weights (h, w, 3, 3) of each coarse pixel (2 i, 2 j) in the fine pixels around it.

    A pixel between two coarse ones divides itself by the springs that pull it either way, a pixel
    between four by its own equation (Alcouffe, Brandt, Dendy and Painter): heights are not
    interpolated across a place where the springs are cut.
    """
    height, width = a.shape[1:]
    rows, columns = weights.shape[:2]
    for i in prange(rows):
        r = 2 * i
        for j in range(columns):
            c = 2 * j
            weights[i, j, 1, 1] = 1.0
            for side in (-1, 1):
                weights[i, j, 1, 1 + side] = _between_columns(a, r, c + side, -side)
                weights[i, j, 1 + side, 1] = _between_rows(a, r + side, c, -side)
            for dy in (-1, 1):
                for dx in (-1, 1):
                    y = r + dy
                    x = c + dx
                    value = np.float32(0)
                    if 0 <= y < height and 0 <= x < width and a[DIAGONAL, y, x] > 0:
                        value = _joint(a, y, x, -dy, -dx)
                        value += _joint(a, y, x, -dy, 0) * _between_columns(a, r, x, -dx)
                        value += _joint(a, y, x, 0, -dx) * _between_rows(a, y, c, -dy)
                        value /= a[DIAGONAL, y, x]
                    weights[i, j, 1 + dy, 1 + dx] = value


@njit(cache=True, parallel=True)
def coarsen(a: FloatImage, weights: FloatImage, coarse: FloatImage) -> None:
    """Galerkin stencil of the coarse grid: P' A P, so that no coarse move is judged softer than it is."""
    height, width = a.shape[1:]
    rows, columns = weights.shape[:2]
    for i in prange(rows):
        image = np.empty((5, 5), np.float64)
        for j in range(columns):
            image[:] = 0.0
            # A applied to the column of P that belongs to (i, j): a 5 x 5 patch around (2 i, 2 j)
            for dy in range(-1, 2):
                for dx in range(-1, 2):
                    y = 2 * i + dy
                    x = 2 * j + dx
                    p = weights[i, j, 1 + dy, 1 + dx]
                    if p == 0 or y < 0 or y >= height or x < 0 or x >= width:
                        continue
                    image[2 + dy, 2 + dx] += p * a[DIAGONAL, y, x]
                    for ny in range(-1, 2):
                        for nx in range(-1, 2):
                            if ny != 0 or nx != 0:
                                image[2 + dy + ny, 2 + dx + nx] -= p * _joint(a, y, x, ny, nx)
            for part in range(5):
                di = 0 if part <= EAST else 1
                dj = 0
                if part in (EAST, SOUTH_EAST):
                    dj = 1
                elif part == SOUTH_WEST:
                    dj = -1
                total = 0.0
                if i + di < rows and 0 <= j + dj < columns:
                    for dy in range(-1, 2):
                        for dx in range(-1, 2):
                            y = 2 + 2 * di + dy
                            x = 2 + 2 * dj + dx
                            if y < 5 and 0 <= x < 5:
                                total += weights[i + di, j + dj, 1 + dy, 1 + dx] * image[y, x]
                coarse[part, i, j] = total if part == DIAGONAL else -total


@njit(cache=True, parallel=True)
def smooth(a: FloatImage, right: FloatImage, z: FloatImage, colour: int) -> None:
    """Solve every pixel of one of the four colours (row parity, column parity) for its own equation."""
    height, width = z.shape
    first = colour // 2
    for half in prange((height - first + 1) // 2):
        row = 2 * half + first
        for column in range(colour % 2, width, 2):
            diagonal = a[DIAGONAL, row, column]
            if diagonal > 0:
                z[row, column] = (right[row, column] + _pull(a, z, row, column)) / diagonal


@njit(cache=True)
def _pull(a: FloatImage, z: FloatImage, row: int, column: int) -> np.float32:
    """Sum of coupling times height over the eight neighbours."""
    height, width = z.shape
    west = column > 0
    east = column < width - 1
    total = np.float32(0)
    if west:
        total += a[EAST, row, column - 1] * z[row, column - 1]
    if east:
        total += a[EAST, row, column] * z[row, column + 1]
    if row > 0:
        total += a[SOUTH, row - 1, column] * z[row - 1, column]
        if west:
            total += a[SOUTH_EAST, row - 1, column - 1] * z[row - 1, column - 1]
        if east:
            total += a[SOUTH_WEST, row - 1, column + 1] * z[row - 1, column + 1]
    if row < height - 1:
        total += a[SOUTH, row, column] * z[row + 1, column]
        if west:
            total += a[SOUTH_WEST, row, column] * z[row + 1, column - 1]
        if east:
            total += a[SOUTH_EAST, row, column] * z[row + 1, column + 1]
    return total


@njit(cache=True, parallel=True)
def residual(a: FloatImage, right: FloatImage, z: FloatImage, out: FloatImage) -> None:
    """``out = right - A z``."""
    height, width = z.shape
    for row in prange(height):
        for column in range(width):
            value = right[row, column] - a[DIAGONAL, row, column] * z[row, column]
            out[row, column] = value + _pull(a, z, row, column)


@njit(cache=True, parallel=True)
def restrict(weights: FloatImage, fine: FloatImage, coarse: FloatImage) -> None:
    """Transpose of :func:`prolong`."""
    height, width = fine.shape
    rows, columns = coarse.shape
    for i in prange(rows):
        for j in range(columns):
            total = np.float32(0)
            for dy in range(-1, 2):
                y = 2 * i + dy
                if 0 <= y < height:
                    for dx in range(-1, 2):
                        x = 2 * j + dx
                        if 0 <= x < width:
                            total += weights[i, j, 1 + dy, 1 + dx] * fine[y, x]
            coarse[i, j] = total


@njit(cache=True, parallel=True)
def prolong(weights: FloatImage, coarse: FloatImage, fine: FloatImage) -> None:
    """Add the interpolated coarse correction to ``fine``."""
    height, width = fine.shape
    rows, columns = coarse.shape
    for row in prange(height):
        i0 = row // 2
        i1 = min(i0 + (row & 1), rows - 1)
        for column in range(width):
            j0 = column // 2
            j1 = min(j0 + (column & 1), columns - 1)
            total = np.float32(0)
            for i in range(i0, i1 + 1):
                for j in range(j0, j1 + 1):
                    total += weights[i, j, row - 2 * i + 1, column - 2 * j + 1] * coarse[i, j]
            fine[row, column] += total
