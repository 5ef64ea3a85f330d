"""Fused kernel of the mean correlation in the variance-of-sum form: work per view, not per pair of views.

For shifted views ``t_k`` with window variances ``v_k``,

    score = (var(sum_k t_k) - sum_k v_k) / ((K - 1) sum_k v_k)

is the sum of all covariances over the mean variance.  It equals the mean of eq. 3 over all pairs where the
views have equal contrast, so they are brought to equal gain first; where contrast differs it weighs each
pair by its contrast, which the mean NCC does not.  Never used by method ``paper``.
"""

from __future__ import annotations

import numpy as np
from numba import njit

from reliefscope.reconstruction.ncc_kernels import (
    F32,
    F64,
    FLAT_VARIANCE,
    I64,
    LANE,
    exchange_one,
    exchange_products,
    tile_offsets,
    window_sums,
)
from reliefscope.reconstruction.shifts import sample_block


@njit(cache=True, nogil=True, error_model="numpy", fastmath={"contract"})
def _add_view(sample: F32, total: F32, squares: F64) -> None:
    for x in range(sample.size):
        total[x] += sample[x]
        squares[x] += np.float64(sample[x]) * sample[x]


@njit(cache=True, nogil=True, error_model="numpy")
def _exchange_doubles(total: F64, new: F64, old: F64) -> None:
    for x in range(total.size):
        total[x] += new[x] - old[x]


@njit(cache=True, nogil=True, error_model="numpy", fastmath={"contract"})
def _add_mean(sums: F64, share: float, mean: F64, squares: F64) -> None:
    for x in range(sums.size):
        m = sums[x] * share
        mean[x] += m
        squares[x] += m * m


@njit(cache=True, nogil=True, error_model="numpy")
def _scores(
    squares_of_sum: F64,
    sum_of_squares: F64,
    mean: F64,
    mean_squares: F64,
    share: float,
    views: int,
    noise_variance: float,
    out: F32,
) -> None:
    least = views * FLAT_VARIANCE
    for x in range(mean.size):
        of_sum = squares_of_sum[x] * share - mean[x] * mean[x]
        own = max(sum_of_squares[x] * share - mean_squares[x], 0.0)
        floor = own + noise_variance
        score = (of_sum - own) / ((views - 1) * max(floor, least))
        out[x] = min(max(score, -1.0), 1.0) if floor > least else 0.0


@njit(cache=True, nogil=True, error_model="numpy")
def score_tile_of_sum(
    padded: F32,
    margin: int,
    plan_rows: I64,
    plan_cols: I64,
    row_weights: F32,
    col_weights: F32,
    tile: I64,
    window: int,
    noise_variance: float,
    curves: F32,
) -> None:
    """Variance-of-sum score of one tile for every height.

    Parameters are those of :func:`~reliefscope.reconstruction.ncc_kernels.score_tile`; the views have equal
    gain, ``noise_variance`` is the sum over the views, and every window of the tile must be valid in every
    view at every height.
    """
    heights, views = plan_rows.shape
    radius = window // 2
    top, left = tile[0], tile[2]
    rows, cols = tile[1] - tile[0], tile[3] - tile[2]
    width = cols + window - 1
    stride = (width + LANE - 1) // LANE * LANE
    depth = rows + window - 1
    share = 1.0 / (window * window)

    samples = np.zeros((views, depth + 1, stride), dtype=np.float32)  # the last row stays dark
    totals = np.zeros((depth + 1, stride), dtype=np.float32)
    squares = np.zeros((depth + 1, stride), dtype=np.float64)
    line = np.empty(width + 4, dtype=np.float32)
    firsts = np.empty((views, stride), dtype=np.float64)
    of_sum = np.empty(stride, dtype=np.float64)
    of_squares = np.empty(stride, dtype=np.float64)
    triples = np.empty(stride, dtype=np.float64)
    sums = np.empty(cols, dtype=np.float64)
    sums_squares = np.empty(cols, dtype=np.float64)
    mean = np.empty(cols, dtype=np.float64)
    mean_squares = np.empty(cols, dtype=np.float64)
    offsets = tile_offsets(padded, margin, tile)

    for n in range(heights):
        totals[:] = np.float32(0.0)
        squares[:] = 0.0
        for k in range(views):
            sample_block(
                padded[k],
                margin + top - radius + plan_rows[n, k],
                margin + left - radius + plan_cols[n, k],
                row_weights[n, k],
                col_weights[n, k],
                offsets[k],
                line,
                samples[k, :depth, :width],
            )
            for y in range(depth):
                _add_view(samples[k, y], totals[y], squares[y])
        firsts[:] = 0.0
        of_sum[:] = 0.0
        of_squares[:] = 0.0
        for y in range(depth):
            leaving = y - window if y >= window else depth
            r = y - window + 1
            mean[:] = 0.0
            mean_squares[:] = 0.0
            for k in range(views):
                exchange_one(firsts[k], samples[k, y], samples[k, leaving])
                if r >= 0:
                    window_sums(firsts[k], window, triples, sums)
                    _add_mean(sums, share, mean, mean_squares)
            exchange_products(of_sum, totals[y], totals[y], totals[leaving], totals[leaving])
            _exchange_doubles(of_squares, squares[y], squares[leaving])
            if r >= 0:
                window_sums(of_sum, window, triples, sums)
                window_sums(of_squares, window, triples, sums_squares)
                _scores(
                    sums,
                    sums_squares,
                    mean,
                    mean_squares,
                    share,
                    views,
                    noise_variance,
                    curves[n, r],
                )
