"""Compiled parts of the multigrid on the pixel grid.

Images have a margin of one pixel of zeros, so that no loop has to ask where the border is: ``east`` and ``south``
(H + 2, W + 2) are the springs of a pixel to its right and lower neighbour, ``inverse`` that of its own equation (0
where nothing holds it).  Pixels are taken in two colours, like those of a chequerboard: neighbours differ.
"""

from __future__ import annotations

import numpy as np
from numba import njit, prange

from reliefscope.reconstruction.cluster_kernels import Index, Vector
from reliefscope.units import FloatArray, FloatImage


@njit(cache=True, parallel=True)
def from_springs(
    hold: FloatArray,
    across: FloatArray,
    down: FloatArray,
    east: FloatImage,
    south: FloatImage,
    inverse: FloatImage,
) -> None:
    """Equations of ``hold`` (H, W) and springs ``across`` (H, W-1), ``down`` (H-1, W)."""
    height, width = hold.shape
    for row in prange(height):
        for column in range(width):
            total = hold[row, column]
            if column < width - 1:
                east[row + 1, column + 1] = across[row, column]
                total += across[row, column]
            if row < height - 1:
                south[row + 1, column + 1] = down[row, column]
                total += down[row, column]
            if column > 0:
                total += across[row, column - 1]
            if row > 0:
                total += down[row - 1, column]
            inverse[row + 1, column + 1] = 1.0 / total if total > 0.0 else 0.0


@njit(cache=True, inline="always")
def _pull(east: FloatImage, south: FloatImage, z: FloatImage, y: int, x: int) -> np.float32:
    """Pull of the four neighbours of the pixel at (y, x) of the arrays."""
    total: np.float32 = east[y, x - 1] * z[y, x - 1] + east[y, x] * z[y, x + 1]
    total += south[y - 1, x] * z[y - 1, x] + south[y, x] * z[y + 1, x]
    return total


@njit(cache=True, parallel=True)
def start(residual: FloatArray, inverse: FloatImage, right: FloatImage, z: FloatImage) -> None:
    """Take ``residual`` (H, W) as the right-hand side and solve the pixels of the first colour from z = 0."""
    height, width = residual.shape
    for row in prange(height):
        for column in range(width):
            right[row + 1, column + 1] = residual[row, column]
        for column in range(row % 2, width, 2):
            z[row + 1, column + 1] = right[row + 1, column + 1] * inverse[row + 1, column + 1]


@njit(cache=True, parallel=True)
def smooth(
    east: FloatImage,
    south: FloatImage,
    inverse: FloatImage,
    right: FloatImage,
    z: FloatImage,
    colour: int,
) -> None:
    """Solve every pixel of one colour for its own equation."""
    height, width = z.shape[0] - 2, z.shape[1] - 2
    for row in prange(height):
        y = row + 1
        for x in range(1 + (row + colour) % 2, width + 1, 2):
            z[y, x] = (right[y, x] + _pull(east, south, z, y, x)) * inverse[y, x]


@njit(cache=True, parallel=True)
def remainder(east: FloatImage, south: FloatImage, z: FloatImage, out: FloatImage) -> None:
    """Residual after both colours were solved once from z = 0: what the second pulls at the first with."""
    height, width = z.shape[0] - 2, z.shape[1] - 2
    for row in prange(height):
        y = row + 1
        for x in range(1 + row % 2, width + 1, 2):
            out[y, x] = _pull(east, south, z, y, x)


@njit(cache=True, parallel=True)
def spread(label: Index, coarse: Vector, fine: FloatImage) -> None:
    """Move every pixel by as much as its cluster."""
    height, width = fine.shape[0] - 2, fine.shape[1] - 2
    for row in prange(height):
        for column in range(width):
            k = label[row * width + column]
            if k >= 0:
                fine[row + 1, column + 1] += coarse[k]


@njit(cache=True, parallel=True)
def leave(z: FloatImage, out: FloatArray) -> None:
    """Copy without the margin."""
    height, width = out.shape
    for row in prange(height):
        for column in range(width):
            out[row, column] = z[row + 1, column + 1]
