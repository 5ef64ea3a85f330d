"""Views made ready for matching, cut into tiles, scored at every candidate height."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from reliefscope.errors import InvalidInputError
from reliefscope.reconstruction import tiles
from reliefscope.reconstruction.ncc_kernels import score_tile
from reliefscope.reconstruction.ncc_sum_kernels import score_tile_of_sum
from reliefscope.reconstruction.shifts import TAPS, ShiftPlan, sample_block, valid_span
from reliefscope.units import FloatImage

Form = Literal["pairs", "variance_of_sum"]

LEAST_SHARE = 0.5
"""Share of pairs that a score needs, and of heights with a score that a pixel needs."""
TILE_COLUMNS = 498
TILE_ROWS = 128
TILE_BYTES = 24_000_000
"""Scores of one tile over all heights: what one thread keeps."""

LEAST_CONTRAST = 1e-4
"""Contrast, squared, against the strongest view below which a view is not raised further: it is dark."""

Tile = NDArray[np.int64]
"""First row, one-past-last row, first column, one-past-last column."""


class Matcher:
    """Views prepared for sampling at any of the planned shifts.

    ``pairs`` scores by eq. 3 pair by pair.  ``variance_of_sum`` brings the views to equal gain and scores
    by :mod:`~reliefscope.reconstruction.ncc_sum_kernels` wherever all views are valid at all heights, and
    pair by pair in the frame around that area.
    """

    def __init__(
        self,
        views: FloatImage,
        plan: ShiftPlan,
        window: int,
        noise_variance: float = 0.0,
        form: Form = "pairs",
    ) -> None:
        count, height, width = views.shape
        reach = int(max(np.abs(plan.row_whole).max(), np.abs(plan.col_whole).max()))
        if reach >= min(height, width):
            raise InvalidInputError(
                f"A candidate height moves a view by {reach} pixels, more than the image's "
                f"{min(height, width)}.",
                hint="Check the range of heights, pixel_um and the slopes of the views.",
            )
        self.plan = plan
        self.window = window
        self.noise_variance = noise_variance
        self.shape = (height, width)
        self.pairs = count * (count - 1) / 2
        self.margin = m = reach + window // 2 + TAPS
        self.gains = equal_gains(views) if form == "variance_of_sum" else np.ones(count, np.float32)
        self.padded = np.empty((count, height + 2 * m, width + 2 * m), dtype=np.float32)
        for k, view in enumerate(views):
            self.padded[k] = np.pad(view, m, mode="edge")
            self.padded[k] *= self.gains[k]
        rows = valid_span(plan.row_px, height, window // 2)
        cols = valid_span(plan.col_px, width, window // 2)
        self.spans = np.stack([*rows, *cols], axis=-1)
        self.inner = self._inner() if form == "variance_of_sum" else (0, 0, 0, 0)

    def _inner(self) -> tuple[int, int, int, int]:
        """Centres whose windows are valid in every view at every height; empty if there are none."""
        first_row, stop_row = int(self.spans[..., 0].max()), int(self.spans[..., 1].min())
        first_col, stop_col = int(self.spans[..., 2].max()), int(self.spans[..., 3].min())
        if stop_row <= first_row or stop_col <= first_col:
            return (0, 0, 0, 0)
        return first_row, stop_row, first_col, stop_col

    def tiles(self) -> list[Tile]:
        """Tiles that cover the image, largest share of work first."""
        height, width = self.shape
        top, bottom, left, right = self.inner
        if bottom == 0:
            return self._cut(0, height, 0, width)
        frame = [
            (0, top, 0, width),
            (bottom, height, 0, width),
            (top, bottom, 0, left),
            (top, bottom, right, width),
        ]
        return [tile for box in (self.inner, *frame) for tile in self._cut(*box)]

    def _cut(self, top: int, bottom: int, left: int, right: int) -> list[Tile]:
        """Tiles of a box whose scores over all heights stay within :data:`TILE_BYTES`."""
        if bottom <= top or right <= left:
            return []
        columns = tiles.spans(right - left, TILE_COLUMNS)
        widest = max(stop - first for first, stop in columns)
        tallest = TILE_BYTES // (4 * widest * self.plan.row_px.shape[0])
        rows = tiles.spans(bottom - top, min(max(tallest, 16), TILE_ROWS))
        return [
            np.array([top + r0, top + r1, left + c0, left + c1], dtype=np.int64)
            for r0, r1 in rows
            for c0, c1 in columns
        ]

    def curves(self, tile: Tile) -> FloatImage:
        """Scores (N, rows, columns) of a tile; NaN where fewer than half of the pairs are valid."""
        scores = np.empty(
            (self.plan.row_px.shape[0], int(tile[1] - tile[0]), int(tile[3] - tile[2])),
            dtype=np.float32,
        )
        plan = self.plan
        sampling = (plan.row_whole, plan.col_whole, plan.row_weights, plan.col_weights)
        top, bottom, left, right = self.inner
        if top <= tile[0] and tile[1] <= bottom and left <= tile[2] and tile[3] <= right:
            noise = self.noise_variance * float(np.square(self.gains, dtype=np.float64).sum())
            score_tile_of_sum(self.padded, self.margin, *sampling, tile, self.window, noise, scores)
        else:
            score_tile(
                self.padded,
                self.margin,
                *sampling,
                self.spans,
                tile,
                self.window,
                self.noise_variance,
                LEAST_SHARE * self.pairs,
                scores,
            )
        return scores

    def image_score(self, n: int, box: tuple[int, int, int, int]) -> float:
        """Mean of eq. 3 over all pairs for height ``n``, the window being ``box``."""
        top, bottom, left, right = box
        views = self.padded.shape[0]
        line = np.empty(right - left + TAPS, dtype=np.float32)
        first = np.zeros(views)
        gram = np.zeros((views, views))
        for start, stop in tiles.spans(bottom - top, 64):
            block = np.empty((views, stop - start, right - left), dtype=np.float32)
            for k in range(views):
                sample_block(
                    self.padded[k],
                    self.margin + top + start + self.plan.row_whole[n, k],
                    self.margin + left + self.plan.col_whole[n, k],
                    self.plan.row_weights[n, k],
                    self.plan.col_weights[n, k],
                    np.float32(0.0),
                    line,
                    block[k],
                )
            flat = block.reshape(views, -1).astype(np.float64)
            first += flat.sum(axis=1)
            gram += flat @ flat.T
        count = (bottom - top) * (right - left)
        covariance = gram / count - np.outer(first, first) / count**2
        deviation = np.sqrt(np.maximum(np.diag(covariance), 0.0))
        scale = np.outer(deviation, deviation)
        ncc = np.divide(covariance, scale, out=np.zeros_like(scale), where=scale > 0.0)
        return float(np.clip(ncc[np.triu_indices(views, 1)].mean(), -1.0, 1.0))


def equal_gains(views: FloatImage) -> FloatImage:
    """Factors (K,) that give views (K, H, W) the same contrast from pixel to pixel; their mean is 1."""
    contrast = np.array(
        [
            np.square(np.diff(view, axis=0), dtype=np.float64).mean()
            + np.square(np.diff(view, axis=1), dtype=np.float64).mean()
            for view in views
        ]
    )
    if not contrast.any():
        return np.ones(len(views), dtype=np.float32)
    gains = 1.0 / np.sqrt(np.maximum(contrast, LEAST_CONTRAST * contrast.max()))
    return np.asarray(gains / gains.mean(), dtype=np.float32)
