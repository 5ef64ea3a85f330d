"""Kernel of matching jointly over lights: small windows of every channel and height vote on a larger one.

For shifted views ``t_k`` of one channel (one group of lights), in a window of a few pixels, the mean
correlation in its variance-of-sum form (:mod:`~reliefscope.reconstruction.ncc_sum_kernels`) is

    score = (var(sum_k t_k) - sum_k v_k) / ((K - 1) (sum_k v_k + noise))

with the window variances ``v_k`` of the shifted views themselves: variances taken once and shifted would not
know that interpolation blurs, and heights of whole shifts would win too often.

The score of a pixel is a mean of such scores over the channels and over a larger window: a small window that
straddles a bright edge has one vote, whereas in one large window the edge would outweigh all texture.  The
mean is harmonic in what the views do not share, ``1 - score + softness``.  Near a height that fits, a window
that fits to 2 % then counts for much more than one that fits to 10 %, as it does in a likelihood: a highlight
moves against the surface and fits poorly at every height, so the channels that it misses decide.

Windows vote the less, the more their brightness differs from that of the pixel's own (adaptive support, Yoon
and Kweon, "Adaptive support-weight approach for correspondence search", PAMI 2006): beyond an edge lies another
surface.  Brightness is the mean over views and channels, shifted to the height in question, so that it needs no
view from above.

All sums are float32 and direct, never running, on images whose mean was taken off.  A tile stays in the
second-level cache.  The kernels release the interpreter lock and are single-threaded.
"""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from reliefscope.reconstruction.ncc_kernels import F32, I64

Mask = NDArray[np.bool_]


@njit(cache=True, nogil=True, error_model="numpy", fastmath=True)
def blend_rows(above: F32, here: F32, below: F32, further: F32, weights: F32, line: F32) -> None:
    """Cubic sample along the columns: one row between four."""
    a0, a1, a2, a3 = weights[0], weights[1], weights[2], weights[3]
    for x in range(line.size):
        line[x] = a0 * above[x] + a1 * here[x] + a2 * below[x] + a3 * further[x]


@njit(cache=True, nogil=True, error_model="numpy", fastmath=True)
def blend_along(line: F32, weights: F32, sample: F32, total: F32, squares: F32) -> None:
    """Cubic sample along the row; it is kept, and added with its square to the sums over the views."""
    b0, b1, b2, b3 = weights[0], weights[1], weights[2], weights[3]
    for x in range(total.size):
        value = b0 * line[x] + b1 * line[x + 1] + b2 * line[x + 2] + b3 * line[x + 3]
        sample[x] = value
        total[x] += value
        squares[x] += value * value


@njit(cache=True, nogil=True, error_model="numpy", fastmath=True)
def add_squared_sums(columns: F32, window: int, total: F32) -> None:
    """Add the squares of the sums of ``window`` neighbours of a row of column sums."""
    if window == 3:
        for x in range(total.size):
            value = columns[x] + columns[x + 1] + columns[x + 2]
            total[x] += value * value
        return
    for x in range(total.size):
        value = columns[x]
        for shift in range(1, window):
            value += columns[x + shift]
        total[x] += value * value


@njit(cache=True, nogil=True, error_model="numpy", fastmath=True)
def add_three(above: F32, here: F32, below: F32, out: F32) -> None:
    """Sum of three rows."""
    for x in range(out.size):
        out[x] = above[x] + here[x] + below[x]


@njit(cache=True, nogil=True, error_model="numpy", fastmath=True)
def add_rows(row: F32, sums: F32, squares: F32) -> None:
    """Add one row, and its squares, to the column sums of a small window."""
    for x in range(row.size):
        value = row[x]
        sums[x] += value
        squares[x] += value * value


@njit(cache=True, nogil=True, error_model="numpy", fastmath=True)
def across(columns: F32, window: int, out: F32) -> None:
    """Sums of ``window`` neighbours of a row of column sums."""
    if window == 3:
        for x in range(out.size):
            out[x] = columns[x] + columns[x + 1] + columns[x + 2]
        return
    for x in range(out.size):
        out[x] = columns[x]
    for shift in range(1, window):
        for x in range(out.size):
            out[x] += columns[x + shift]


@njit(cache=True, nogil=True, error_model="numpy", fastmath=True)
def add_votes(
    sums: F32,
    squares: F32,
    own_squares: F32,
    squared_sums: F32,
    share: np.float32,
    noise: np.float32,
    softness: np.float32,
    views: int,
    votes: F32,
) -> None:
    """Add ``softness / (1 - score + softness)`` of the small windows of one row and channel."""
    pairs = np.float32(1.0 / (views - 1))
    for x in range(votes.size):
        mean = sums[x] * share
        of_sum = squares[x] * share - mean * mean
        own = max(own_squares[x] * share - squared_sums[x] * share * share, np.float32(0.0))
        floor = own + noise
        apart = max(floor - pairs * (of_sum - own), np.float32(0.0))
        votes[x] += softness * floor / (apart + softness * floor)


@njit(cache=True, nogil=True, error_model="numpy", fastmath=True)
def add_row(row: F32, sums: F32) -> None:
    """Add one row to column sums."""
    for x in range(row.size):
        sums[x] += row[x]


@njit(cache=True, nogil=True, error_model="numpy", fastmath=True)
def add_alike(
    votes: F32, brightness: F32, here: F32, unlikeness: np.float32, total: F32, weights: F32
) -> None:
    """Add votes of a row of windows, and their weights, which fall as their brightness departs from ``here``."""
    one = np.float32(1.0)
    for x in range(total.size):
        apart = brightness[x] - here[x]
        weight = one / (one + unlikeness * apart * apart)
        total[x] += weight * votes[x]
        weights[x] += weight


@njit(cache=True, nogil=True, error_model="numpy", fastmath=True)
def mean_score(votes: F32, weights: F32, channels: int, softness: np.float32, out: F32) -> None:
    """Score whose vote is the weighted mean vote, within [-1, 1]."""
    one = np.float32(1.0)
    scale = softness * np.float32(channels)
    for x in range(out.size):
        out[x] = min(max(one + softness - scale * weights[x] / votes[x], -one), one)


@njit(cache=True, nogil=True, error_model="numpy")
def keep_best(score: F32, brightness: F32, share: np.float32, best: F32, kept: F32) -> None:
    """Keep the brightness that belongs to the greatest score so far."""
    for x in range(score.size):
        if score[x] > best[x]:
            best[x] = score[x]
            kept[x] = brightness[x] * share


@njit(cache=True, nogil=True, error_model="numpy")
def window_variance(image: F32, window: int, out: F32) -> None:
    """Variance (H - window + 1, W - window + 1) in the windows that lie inside ``image``."""
    cols = image.shape[1]
    share = np.float32(1.0 / (window * window))
    sums = np.empty(cols, dtype=np.float32)
    squares = np.empty(cols, dtype=np.float32)
    wide = np.empty((2, out.shape[1]), dtype=np.float32)
    for r in range(out.shape[0]):
        sums[:] = np.float32(0.0)
        squares[:] = np.float32(0.0)
        for y in range(r, r + window):
            add_rows(image[y], sums, squares)
        across(sums, window, wide[0])
        across(squares, window, wide[1])
        for x in range(out.shape[1]):
            mean = wide[0, x] * share
            out[r, x] = max(wide[1, x] * share - mean * mean, np.float32(0.0))


@njit(cache=True, nogil=True, error_model="numpy")
def score_tile_jointly(
    images: F32,
    margin: int,
    row_whole: I64,
    col_whole: I64,
    row_weights: F32,
    col_weights: F32,
    used: Mask,
    tile: I64,
    small: int,
    large: int,
    noise_variance: float,
    softness: float,
    contrast: float,
    curves: F32,
    brightness: F32,
) -> None:
    """Joint score of one tile for every height.

    Parameters
    ----------
    images:
        (C, K, H + 2 margin, W + 2 margin) channels without their mean.
    margin:
        Border of ``images`` on every side.
    row_whole, col_whole, row_weights, col_weights:
        (N, K) whole shifts and (N, K, 4) cubic weights.
    used:
        (N, K) views whose windows are inside the frame for the whole tile.
    tile:
        first row, one-past-last row, first column, one-past-last column.
    small, large:
        Sides of the window that is correlated and of the window over which scores are averaged.
    noise_variance:
        Added per view to the window variance in the denominator.
    softness:
        Added to what the views do not share, above 0: the mean turns from harmonic to arithmetic as it grows.
    contrast:
        Difference of brightness at which a window's vote counts half.
    curves:
        (N, rows, cols) output; NaN at heights where fewer than two views are used.
    brightness:
        (rows, cols) output: mean of the pixel's own small window at the greatest score; NaN without a score.
    """
    channels, views = images.shape[0], images.shape[1]
    inner, outer = small // 2, large // 2
    reach = inner + outer
    rows, cols = tile[1] - tile[0], tile[3] - tile[2]
    depth, width = rows + 2 * reach, cols + 2 * reach
    scored_rows, scored_cols = rows + 2 * outer, cols + 2 * outer
    top, left = margin + tile[0] - reach, margin + tile[2] - reach
    share = np.float32(1.0 / (small * small))
    totals = np.empty((depth, width), dtype=np.float32)
    squares = np.empty((depth, width), dtype=np.float32)
    sample = np.empty((depth, width), dtype=np.float32)
    squared_sums = np.empty((scored_rows, scored_cols), dtype=np.float32)
    votes = np.empty((scored_rows, scored_cols), dtype=np.float32)
    means = np.empty((scored_rows, scored_cols), dtype=np.float32)
    soft = np.float32(softness)
    line = np.empty(width + 3, dtype=np.float32)
    sums = np.empty(width, dtype=np.float32)
    sums_squares = np.empty(width, dtype=np.float32)
    wide = np.empty((3, scored_cols), dtype=np.float32)
    total = np.empty(cols, dtype=np.float32)
    weights = np.empty(cols, dtype=np.float32)
    best = np.full((rows, cols), -np.inf, dtype=np.float32)
    brightness[:] = np.nan
    for n in range(row_whole.shape[0]):
        count = 0
        for k in range(views):
            count += used[n, k]
        if count < 2:
            curves[n] = np.nan
            continue
        noise = np.float32(noise_variance * count)
        votes[:] = np.float32(0.0)
        means[:] = np.float32(0.0)
        for c in range(channels):
            totals[:] = np.float32(0.0)
            squares[:] = np.float32(0.0)
            squared_sums[:] = np.float32(0.0)
            for k in range(views):
                if not used[n, k]:
                    continue
                image = images[c, k]
                y0, x0 = top + row_whole[n, k], left + col_whole[n, k]
                for r in range(depth):
                    y = y0 + r
                    blend_rows(
                        image[y - 1, x0 - 1 : x0 + width + 2],
                        image[y, x0 - 1 : x0 + width + 2],
                        image[y + 1, x0 - 1 : x0 + width + 2],
                        image[y + 2, x0 - 1 : x0 + width + 2],
                        row_weights[n, k],
                        line,
                    )
                    blend_along(line, col_weights[n, k], sample[r], totals[r], squares[r])
                    first = r - small + 1
                    if first < 0:
                        continue
                    if small == 3:
                        add_three(sample[first], sample[first + 1], sample[r], sums)
                    else:
                        sums[:] = np.float32(0.0)
                        for y in range(first, r + 1):
                            add_row(sample[y], sums)
                    add_squared_sums(sums, small, squared_sums[first])
            for r in range(scored_rows):
                sums[:] = np.float32(0.0)
                sums_squares[:] = np.float32(0.0)
                for y in range(r, r + small):
                    add_rows(totals[y], sums, sums_squares)
                across(sums, small, wide[0])
                add_row(wide[0], means[r])
                across(sums_squares, small, wide[1])
                sums[:] = np.float32(0.0)
                for y in range(r, r + small):
                    add_row(squares[y], sums)
                across(sums, small, wide[2])
                add_votes(
                    wide[0],
                    wide[1],
                    wide[2],
                    squared_sums[r],
                    share,
                    noise,
                    soft,
                    count,
                    votes[r],
                )
        each = np.float32(1.0 / (small * small * channels * count))
        unlikeness = np.float32((each / contrast) ** 2)
        for r in range(rows):
            here = means[r + outer, outer : outer + cols]
            total[:] = np.float32(0.0)
            weights[:] = np.float32(0.0)
            for y in range(r, r + large):
                for x in range(large):
                    place = slice(x, x + cols)
                    add_alike(votes[y, place], means[y, place], here, unlikeness, total, weights)
            mean_score(total, weights, channels, soft, curves[n, r])
            keep_best(curves[n, r], here, each, best[r], brightness[r])


@njit(cache=True, nogil=True, error_model="numpy")
def expand(coarse: F32, factor: int, jump: float, first: int, stop: int, out: F32) -> None:
    """Rows ``first`` to ``stop`` of ``out``: ``coarse``, one value per ``factor`` x ``factor`` pixels.

    Linear between the four values around a pixel; the nearest one where one of them is missing or they
    differ by more than ``jump``, so that no slope appears at a step.
    """
    rows, cols = coarse.shape
    for r in range(first, stop):
        y = min(max((r + 0.5) / factor - 0.5, 0.0), rows - 1.0)
        above = min(int(y), max(rows - 2, 0))
        below = min(above + 1, rows - 1)
        down = np.float32(y - above)
        for c in range(out.shape[1]):
            x = min(max((c + 0.5) / factor - 0.5, 0.0), cols - 1.0)
            left = min(int(x), max(cols - 2, 0))
            right = min(left + 1, cols - 1)
            along = np.float32(x - left)
            v00, v01 = coarse[above, left], coarse[above, right]
            v10, v11 = coarse[below, left], coarse[below, right]
            spread = max(v00, v01, v10, v11) - min(v00, v01, v10, v11)
            known = not (np.isnan(v00) or np.isnan(v01) or np.isnan(v10) or np.isnan(v11))
            if known and spread <= jump:
                upper = v00 + along * (v01 - v00)
                lower = v10 + along * (v11 - v10)
                out[r, c] = upper + down * (lower - upper)
            else:
                out[r, c] = coarse[int(y + 0.5), int(x + 0.5)]
