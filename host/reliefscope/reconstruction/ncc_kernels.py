"""Fused kernels of the mean normalised cross-correlation over all pairs of views (paper, eq. 3).

For one tile of the image and one height, the shifted views ``t_k`` are sampled once; then every row updates
running column sums of the products ``t_i t_j`` (one row enters the window, one leaves), sums them along the
window's width, and forms

    score = 2 / (n_v (n_v - 1)) * sum_{i<j} g_i g_j (S_ij / n - m_i m_j),        g_k = 1 / sqrt(v_k + noise)

with each window's own mean ``m_k`` and variance ``v_k`` in each view: eq. 3 exactly, whatever the gain and
offset of a view.  The means leave the pair loop through
``sum_{i<j} p_i p_j = ((sum p)^2 - sum p^2) / 2`` with ``p_k = g_k m_k``.

Rounding: a tile mean is taken off each view; samples and gains are float32, and products (exact), sums
and differences float64, so that weak texture on a strong mean keeps its score and a clipped area is flat.

The kernels release the interpreter lock and are single-threaded; tiles run side by side on a thread pool.
"""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from reliefscope.reconstruction.shifts import sample_block

F32 = NDArray[np.float32]
F64 = NDArray[np.float64]
I64 = NDArray[np.int64]

FLAT_VARIANCE = 1e-12
"""Window variance (full scale 1) below which a window is flat: a standard deviation of 1e-6."""
LANE = 16
"""Columns whose curves are gathered together: one cache line of float32."""


@njit(cache=True, nogil=True, error_model="numpy", fastmath={"contract"})
def exchange_products(total: F64, a: F32, b: F32, old_a: F32, old_b: F32) -> None:
    """Column sums of the products of two rows: one row enters the window, one leaves."""
    for x in range(total.size):
        total[x] += np.float64(a[x]) * b[x] - np.float64(old_a[x]) * old_b[x]


@njit(cache=True, nogil=True, error_model="numpy")
def exchange_one(total: F64, a: F32, old_a: F32) -> None:
    """Column sums of one view: one row enters the window, one leaves."""
    for x in range(total.size):
        total[x] += np.float64(a[x]) - np.float64(old_a[x])


@njit(cache=True, nogil=True, error_model="numpy")
def window_sums(columns: F64, window: int, triples: F64, out: F64) -> None:
    """Sums of ``window`` neighbours, by sums of three: ``out[x] = columns[x] + ... + columns[x + window - 1]``."""
    width = out.size
    for x in range(columns.size - 2):
        triples[x] = columns[x] + columns[x + 1] + columns[x + 2]
    if window == 15:
        for x in range(width):
            out[x] = (
                (triples[x] + triples[x + 3]) + (triples[x + 6] + triples[x + 9]) + triples[x + 12]
            )
        return
    if window == 9:
        for x in range(width):
            out[x] = triples[x] + triples[x + 3] + triples[x + 6]
        return
    for x in range(width):
        out[x] = triples[x]
    for first in range(3, window - 2, 3):
        for x in range(width):
            out[x] += triples[x + first]
    for first in range(window - window % 3, window):
        for x in range(width):
            out[x] += columns[x + first]


@njit(cache=True, nogil=True, error_model="numpy", fastmath={"contract"})
def _add_scaled(total: F64, scale: F32, values: F64) -> None:
    for x in range(total.size):
        total[x] += scale[x] * values[x]


@njit(cache=True, nogil=True, error_model="numpy")
def _view_gain(
    first: F64,
    second: F64,
    count: float,
    noise_variance: float,
    gain: F32,
    means: F64,
    squares: F64,
    valid: F64,
) -> None:
    """Gain ``g`` of one view's windows, its part of ``sum p`` and ``sum p^2``, and the count of views."""
    share = 1.0 / count
    for x in range(gain.size):
        mean = first[x] * share
        variance = np.float32(max(second[x] * share - mean * mean, 0.0) + noise_variance)
        g = np.float32(0.0)
        if variance > FLAT_VARIANCE:
            g = np.float32(1.0) / np.sqrt(variance)
        gain[x] = g
        p = g * mean
        means[x] += p
        squares[x] += p * p
        valid[x] += 1.0


@njit(cache=True, nogil=True, error_model="numpy")
def _cross_row(
    products: F64,
    samples: F32,
    y: int,
    leaving: int,
    window: int,
    gains: F32,
    scored: bool,
    triples: F64,
    sums: F64,
    partial: F64,
    total: F64,
) -> None:
    """Move every pair's column sums by one row and add up ``sum_{i<j} g_i g_j S_ij``."""
    views = samples.shape[0]
    for i in range(views - 1):
        a, old_a = samples[i, y], samples[i, leaving]
        partial[:] = 0.0
        for j in range(i + 1, views):
            column = products[i, j]
            exchange_products(column, a, samples[j, y], old_a, samples[j, leaving])
            if scored:
                window_sums(column, window, triples, sums)
                _add_scaled(partial, gains[j], sums)
        if scored:
            _add_scaled(total, gains[i], partial)


@njit(cache=True, nogil=True, error_model="numpy")
def tile_offsets(padded: F32, margin: int, tile: I64) -> F32:
    """Mean (K,) of each view over a tile: taken off first, so that sums stay small."""
    offsets = np.empty(padded.shape[0], dtype=np.float32)
    for k in range(offsets.size):
        total = 0.0
        for r in range(margin + tile[0], margin + tile[1]):
            for c in range(margin + tile[2], margin + tile[3]):
                total += padded[k, r, c]
        offsets[k] = np.float32(total / ((tile[1] - tile[0]) * (tile[3] - tile[2])))
    return offsets


@njit(cache=True, nogil=True, error_model="numpy")
def score_tile(
    padded: F32,
    margin: int,
    plan_rows: I64,
    plan_cols: I64,
    row_weights: F32,
    col_weights: F32,
    spans: I64,
    tile: I64,
    window: int,
    noise_variance: float,
    least_pairs: float,
    curves: F32,
) -> None:
    """Mean NCC of one tile for every height.

    Parameters
    ----------
    padded:
        (K, H + 2 margin, W + 2 margin) views, borders repeated.
    plan_rows, plan_cols, row_weights, col_weights:
        (N, K) whole shifts and (N, K, 4) weights (:class:`~reliefscope.reconstruction.shifts.ShiftPlan`).
    spans:
        (N, K, 4) first and one-past-last row, first and one-past-last column of the centres whose windows
        are valid in the view.
    tile:
        first row, one-past-last row, first column, one-past-last column.
    margin, window, noise_variance:
        Border of ``padded``; side of the window; added to each window's variance.
    least_pairs:
        A centre with fewer valid pairs has no score.
    curves:
        (N, >= rows, >= columns) output: scores, NaN where there is none.
    """
    heights, views = plan_rows.shape
    radius = window // 2
    top, left = tile[0], tile[2]
    rows, cols = tile[1] - tile[0], tile[3] - tile[2]
    width = cols + window - 1
    stride = (width + LANE - 1) // LANE * LANE
    depth = rows + window - 1
    count = float(window * window)

    samples = np.zeros((views, depth + 1, stride), dtype=np.float32)  # the last row stays dark
    line = np.empty(width + 4, dtype=np.float32)
    offsets = tile_offsets(padded, margin, tile)
    firsts = np.empty((views, stride), dtype=np.float64)
    products = np.empty((views, views, stride), dtype=np.float64)
    triples = np.empty(stride, dtype=np.float64)
    sums = np.empty(cols, dtype=np.float64)
    sums_squares = np.empty(cols, dtype=np.float64)
    gains = np.empty((views, cols), dtype=np.float32)
    means = np.empty(cols, dtype=np.float64)
    squares = np.empty(cols, dtype=np.float64)
    partial = np.empty(cols, dtype=np.float64)
    total = np.empty(cols, dtype=np.float64)
    valid = np.empty(cols, dtype=np.float64)

    for n in range(heights):
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
        firsts[:] = 0.0
        products[:] = 0.0
        for y in range(depth):
            leaving = y - window if y >= window else depth
            r = y - window + 1
            row = top + r
            means[:] = 0.0
            squares[:] = 0.0
            valid[:] = 0.0
            total[:] = 0.0
            for k in range(views):
                a, old_a = samples[k, y], samples[k, leaving]
                exchange_one(firsts[k], a, old_a)
                exchange_products(products[k, k], a, a, old_a, old_a)
                if r < 0:
                    continue
                gain = gains[k]
                gain[:] = np.float32(0.0)
                first_col = max(spans[n, k, 2] - left, 0)
                stop_col = min(spans[n, k, 3] - left, cols)
                if row < spans[n, k, 0] or row >= spans[n, k, 1] or stop_col <= first_col:
                    continue
                window_sums(firsts[k], window, triples, sums)
                window_sums(products[k, k], window, triples, sums_squares)
                _view_gain(
                    sums[first_col:stop_col],
                    sums_squares[first_col:stop_col],
                    count,
                    noise_variance,
                    gain[first_col:stop_col],
                    means[first_col:stop_col],
                    squares[first_col:stop_col],
                    valid[first_col:stop_col],
                )
            _cross_row(
                products, samples, y, leaving, window, gains, r >= 0, triples, sums, partial, total
            )
            if r < 0:
                continue
            for x in range(cols):
                pairs = 0.5 * valid[x] * (valid[x] - 1.0)
                if pairs < least_pairs:
                    curves[n, r, x] = np.nan
                else:
                    crossed = 0.5 * (means[x] * means[x] - squares[x])
                    score = (total[x] / count - crossed) / pairs
                    curves[n, r, x] = min(max(score, -1.0), 1.0)


@njit(cache=True, nogil=True, error_model="numpy")
def _order_statistic(values: F32, size: int, rank: int) -> np.float32:
    """Value of ``rank`` (0 is the least) of the first ``size`` values, which are reordered."""
    low, high = 0, size - 1
    while low < high:
        pivot = values[(low + high) // 2]
        i, j = low, high
        while i <= j:
            while values[i] < pivot:
                i += 1
            while values[j] > pivot:
                j -= 1
            if i <= j:
                values[i], values[j] = values[j], values[i]
                i += 1
                j -= 1
        if rank <= j:
            high = j
        elif rank >= i:
            low = i
        else:
            break
    found: np.float32 = values[rank]
    return found


@njit(cache=True, nogil=True, error_model="numpy")
def _median(values: F32, size: int) -> np.float32:
    upper = _order_statistic(values, size, size // 2)
    if size % 2 == 1:
        return upper
    lower: np.float32 = values[0]
    for n in range(1, size // 2):
        lower = max(lower, values[n])
    return np.float32(0.5) * (lower + upper)


@njit(cache=True, nogil=True, error_model="numpy")
def vertex_height(heights: F64, n: int, before: float, peak: float, after: float) -> float:
    """Height of the vertex of the parabola through three scores; heights may be unevenly spaced."""
    middle: float = heights[n]
    lower: float = heights[n - 1] - middle
    upper: float = heights[n + 1] - middle
    slope_lower = (before - peak) / lower
    slope_upper = (after - peak) / upper
    curvature = (slope_upper - slope_lower) / (upper - lower)
    if curvature >= 0.0:
        return middle
    vertex = -0.5 * (slope_lower - curvature * lower) / curvature
    return middle + min(max(vertex, 0.5 * lower), 0.5 * upper)


@njit(cache=True, nogil=True, error_model="numpy")
def pick_heights(
    curves: F32,
    heights_um: F64,
    least_scores: int,
    parabola: bool,
    height_um: F32,
    quality: F32,
    peak: F32,
    curvature: F32,
) -> None:
    """Height of the greatest score and what the scores tell about it, from ``curves`` (N, >= R, >= C).

    ``quality`` is the lead of the greatest score over the median, ``peak`` the score itself, ``curvature`` minus its
    second derivative with height (per um squared; 0 at the ends of the range).  Where fewer than
    ``least_scores`` heights have a score, the height and the peak are NaN.
    """
    count = heights_um.size
    rows, cols = height_um.shape
    block = np.empty((LANE, count), dtype=np.float32)
    scores = np.empty(count, dtype=np.float32)
    for r in range(rows):
        for left in range(0, cols, LANE):
            lanes = min(LANE, cols - left)
            for n in range(count):
                for lane in range(lanes):
                    block[lane, n] = curves[n, r, left + lane]
            for lane in range(lanes):
                curve = block[lane]
                c = left + lane
                size = 0
                best = -1
                for n in range(count):
                    score = curve[n]
                    if not np.isnan(score):
                        scores[size] = score
                        size += 1
                        if best < 0 or score > curve[best]:
                            best = n
                if size < least_scores:
                    height_um[r, c] = np.nan
                    quality[r, c] = 0.0
                    peak[r, c] = np.nan
                    curvature[r, c] = 0.0
                    continue
                chosen = heights_um[best]
                bend = 0.0
                if 0 < best < count - 1:
                    before, after = curve[best - 1], curve[best + 1]
                    if not (np.isnan(before) or np.isnan(after)):
                        if parabola:
                            chosen = vertex_height(heights_um, best, before, curve[best], after)
                        lower = (curve[best] - before) / (heights_um[best] - heights_um[best - 1])
                        upper = (curve[best] - after) / (heights_um[best + 1] - heights_um[best])
                        bend = 2.0 * (lower + upper) / (heights_um[best + 1] - heights_um[best - 1])
                curvature[r, c] = bend
                height_um[r, c] = chosen
                peak[r, c] = curve[best]
                quality[r, c] = curve[best] - _median(scores, size)
