"""Compiled parts of the fusion solver: gradient operators, vectors of conjugate gradients.

Sums are taken row by row and then over rows, so that a result does not depend on the number of
threads. Everything is float64: the outer iteration carries the accuracy, its preconditioner does
not have to.
"""

from __future__ import annotations

import numpy as np
from numba import njit, prange
from numpy.typing import NDArray

Field = NDArray[np.float64]


@njit(cache=True, parallel=True)
def sobel_fluxes(z: Field, weight: Field, flux_x: Field, flux_y: Field) -> None:
    """Weighted Sobel derivatives (eq. 9, per pixel, y up) of ``z`` (H, W).

    ``flux_x`` and ``flux_y`` (H + 2, W + 2) hold the image with a margin of zeros; the outermost
    pixels of the image have no whole neighbourhood and stay zero as well.
    """
    height, width = z.shape
    for row in prange(1, height - 1):
        for column in range(1, width - 1):
            w = weight[row, column] * 0.125
            if w > 0.0:
                rise = z[row - 1, column + 1] - z[row + 1, column - 1]
                fall = z[row - 1, column - 1] - z[row + 1, column + 1]
                flux_x[row + 1, column + 1] = w * (
                    rise - fall + 2.0 * (z[row, column + 1] - z[row, column - 1])
                )
                flux_y[row + 1, column + 1] = w * (
                    rise + fall + 2.0 * (z[row - 1, column] - z[row + 1, column])
                )
            else:
                flux_x[row + 1, column + 1] = 0.0
                flux_y[row + 1, column + 1] = 0.0


@njit(cache=True, parallel=True)
def sobel_gather(hold: Field, z: Field, flux_x: Field, flux_y: Field, out: Field) -> None:
    """``out = hold * z + Tx' flux_x + Ty' flux_y`` with the transposed Sobel operators."""
    height, width = z.shape
    for row in prange(height):
        r = row + 1
        for column in range(width):
            c = column + 1
            x = (
                flux_x[r - 1, c - 1]
                - flux_x[r - 1, c + 1]
                + 2.0 * (flux_x[r, c - 1] - flux_x[r, c + 1])
                + flux_x[r + 1, c - 1]
                - flux_x[r + 1, c + 1]
            )
            y = (
                flux_y[r + 1, c - 1]
                - flux_y[r - 1, c - 1]
                + 2.0 * (flux_y[r + 1, c] - flux_y[r - 1, c])
                + flux_y[r + 1, c + 1]
                - flux_y[r - 1, c + 1]
            )
            out[row, column] = hold[row, column] * z[row, column] + 0.125 * (x + y)


@njit(cache=True, parallel=True)
def spring_add(across: Field, down: Field, z: Field, out: Field) -> None:
    """Add the pull of springs ``across`` (H, W-1) and ``down`` (H-1, W) at ``z`` to ``out`` (H, W)."""
    height, width = z.shape
    for row in prange(height):
        for column in range(width):
            centre = z[row, column]
            total = 0.0
            if column > 0:
                total += across[row, column - 1] * (centre - z[row, column - 1])
            if column < width - 1:
                total += across[row, column] * (centre - z[row, column + 1])
            if row > 0:
                total += down[row - 1, column] * (centre - z[row - 1, column])
            if row < height - 1:
                total += down[row, column] * (centre - z[row + 1, column])
            out[row, column] += total


@njit(cache=True, parallel=True)
def spring_pull(hold: Field, across: Field, down: Field, z: Field, out: Field) -> None:
    """``out = hold * z`` plus the pull of springs ``across`` (H, W-1) and ``down`` (H-1, W) at ``z`` (H, W)."""
    height, width = z.shape
    for row in prange(height):
        for column in range(width):
            out[row, column] = hold[row, column] * z[row, column]
        for column in range(width - 1):
            force = across[row, column] * (z[row, column] - z[row, column + 1])
            out[row, column] += force
            out[row, column + 1] -= force
        if row > 0:
            for column in range(width):
                out[row, column] += down[row - 1, column] * (z[row, column] - z[row - 1, column])
        if row < height - 1:
            for column in range(width):
                out[row, column] += down[row, column] * (z[row, column] - z[row + 1, column])


@njit(cache=True, parallel=True)
def dot(a: Field, b: Field) -> float:
    """Inner product of two images."""
    height, width = a.shape
    rows = np.empty(height, np.float64)
    for row in prange(height):
        total = 0.0
        for column in range(width):
            total += a[row, column] * b[row, column]
        rows[row] = total
    return float(rows.sum())


@njit(cache=True, parallel=True)
def step(x: Field, r: Field, p: Field, ap: Field, alpha: float) -> None:
    """``x += alpha p`` and ``r -= alpha A p``."""
    height, width = x.shape
    for row in prange(height):
        for column in range(width):
            x[row, column] += alpha * p[row, column]
            r[row, column] -= alpha * ap[row, column]


@njit(cache=True, parallel=True)
def turn(p: Field, s: Field, beta: float) -> None:
    """``p = s + beta p``."""
    height, width = p.shape
    for row in prange(height):
        for column in range(width):
            p[row, column] = s[row, column] + beta * p[row, column]
