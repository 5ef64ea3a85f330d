"""Sub-pixel shifts of whole views: the one interpolation that matching, calibration and tests share.

A view is sampled by cubic convolution with Keys' kernel (a = -1/2, Keys 1981: exact for quadratics, third
order), separable, along rows and columns.  At whole-pixel shifts the four weights are exactly
(0, 1, 0, 0).  A sample position is *valid* where it lies within the grid of pixel centres,
``0 <= row <= H - 1`` and ``0 <= col <= W - 1``; the outer tap of a valid sample next to the border repeats
the border pixel.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numba import njit
from numpy.typing import ArrayLike, NDArray

from reliefscope.axes import apparent_shift_px

SNAP_PX = 1e-6
"""Shifts closer than this to a whole pixel are whole: rounding of ``z * s / pixel`` must not blur."""
TAPS = 4
"""Samples per axis that cubic convolution reads: one before the position's pixel, two after."""


@dataclass(frozen=True, slots=True)
class ShiftPlan:
    """Shifts of K views for N candidate heights, split into whole pixels and interpolation weights.

    Sampling view ``k`` at ``(row + row_px[n, k], col + col_px[n, k])`` brings a surface at height ``n`` to
    the virtual view s = 0.
    """

    row_px: NDArray[np.float64]
    """(N, K) shift along rows in pixels."""
    col_px: NDArray[np.float64]
    """(N, K) shift along columns in pixels."""
    row_whole: NDArray[np.int64]
    col_whole: NDArray[np.int64]
    row_weights: NDArray[np.float32]
    """(N, K, 4) weights of the taps at ``row_whole - 1 .. row_whole + 2``."""
    col_weights: NDArray[np.float32]


def keys_weights(fraction: NDArray[np.float64]) -> NDArray[np.float32]:
    """Cubic convolution weights (..., 4) of the taps at -1, 0, 1, 2 for positions ``0 <= fraction < 1``."""
    t = fraction
    return np.stack(
        [
            ((-0.5 * t + 1.0) * t - 0.5) * t,
            (1.5 * t - 2.5) * t * t + 1.0,
            ((-1.5 * t + 2.0) * t + 0.5) * t,
            (0.5 * t - 0.5) * t * t,
        ],
        axis=-1,
    ).astype(np.float32)


def split_shift(shift_px: NDArray[np.float64]) -> tuple[NDArray[np.int64], NDArray[np.float32]]:
    """Whole pixels (...) and tap weights (..., 4) of shifts in pixels."""
    nearest = np.rint(shift_px)
    snapped = np.where(np.abs(shift_px - nearest) < SNAP_PX, nearest, shift_px)
    whole = np.floor(snapped)
    return whole.astype(np.int64), keys_weights(snapped - whole)


def plan_shifts(
    slopes: ArrayLike,
    heights_um: ArrayLike,
    pixel_um: float,
    telecentricity_per_um: float = 0.0,
    place_px: tuple[float, float] = (0.0, 0.0),
) -> ShiftPlan:
    """Shifts of every view for every height, from the world frame's rule (:mod:`reliefscope.axes`).

    Parameters
    ----------
    slopes:
        (K, 2) slopes ``(sx, sy)``, y up.
    heights_um:
        (N,) candidate heights.
    pixel_um:
        Sampling distance in the focal plane.
    telecentricity_per_um, place_px:
        Growth kappa of the slopes with the position from the middle of the field, and the place (rows, columns
        from the middle) that the shifts are for: a point at ``(x, y, z)`` appears where a ray of the slope
        that holds *there* meets the focal plane, at ``((x - z sx) / (1 + z kappa), (y - z sy) / (1 + z kappa))``.
    """
    s = np.asarray(slopes, dtype=np.float64)
    z = np.asarray(heights_um, dtype=np.float64)
    unit = np.array([apparent_shift_px(1.0, (float(sx), float(sy)), pixel_um) for sx, sy in s])
    reach = z / (1.0 + z * telecentricity_per_um)
    col_px = reach[:, None] * (unit[None, :, 0] - telecentricity_per_um * place_px[1])
    row_px = reach[:, None] * (unit[None, :, 1] - telecentricity_per_um * place_px[0])
    col_whole, col_weights = split_shift(col_px)
    row_whole, row_weights = split_shift(row_px)
    return ShiftPlan(row_px, col_px, row_whole, col_whole, row_weights, col_weights)


def valid_span(
    shift_px: NDArray[np.float64], size: int, radius: int
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """First and one-past-last centre whose window of ``radius`` has only valid samples along one axis."""
    whole, weights = split_shift(shift_px)
    partial = weights[..., 1] != 1.0
    first = np.maximum(radius - whole, 0)
    stop = np.minimum(size - radius - whole - partial, size)
    return first.astype(np.int64), np.maximum(stop, first).astype(np.int64)


@njit(cache=True, nogil=True, error_model="numpy", fastmath={"contract", "nsz"})
def sample_block(source, top, left, row_weights, col_weights, offset, line, out):  # type: ignore[no-untyped-def]
    """Cubic samples of a block: ``out[r, c]`` is ``source`` at ``(top + r, left + c)`` plus the fraction.

    ``source`` must hold the taps: rows ``top - 1 .. top + R + 1`` and the columns alike.  ``offset`` is
    subtracted; ``line`` is scratch of at least C + 3 values.
    """
    rows, cols = out.shape
    a0, a1, a2, a3 = row_weights[0], row_weights[1], row_weights[2], row_weights[3]
    b0, b1, b2, b3 = col_weights[0], col_weights[1], col_weights[2], col_weights[3]
    for r in range(rows):
        y = top + r
        above = source[y - 1, left - 1 : left + cols + 2]
        here = source[y, left - 1 : left + cols + 2]
        below = source[y + 1, left - 1 : left + cols + 2]
        further = source[y + 2, left - 1 : left + cols + 2]
        target = out[r]
        if a1 == 1.0:
            for c in range(cols + 3):
                line[c] = here[c] - offset
        else:
            for c in range(cols + 3):
                line[c] = a0 * above[c] + a1 * here[c] + a2 * below[c] + a3 * further[c] - offset
        if b1 == 1.0:
            for c in range(cols):
                target[c] = line[c + 1]
        else:
            for c in range(cols):
                target[c] = b0 * line[c] + b1 * line[c + 1] + b2 * line[c + 2] + b3 * line[c + 3]
