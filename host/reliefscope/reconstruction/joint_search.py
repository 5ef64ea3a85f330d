"""Search over all candidate heights in tiles of the binned channels, with all views or some of them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from reliefscope.reconstruction.joint_kernels import score_tile_jointly
from reliefscope.reconstruction.matcher import LEAST_SHARE, Tile
from reliefscope.reconstruction.ncc_kernels import pick_heights
from reliefscope.reconstruction.shifts import ShiftPlan, plan_shifts, valid_span
from reliefscope.units import BoolImage, FloatImage

SOFTNESS = 0.04
"""Added to what the views of a small window do not share before the harmonic mean
(:mod:`~reliefscope.reconstruction.joint_kernels`): below it, differences are noise."""
CONTRAST = 0.2
"""Difference of brightness, as a logarithm, at which a window votes half on a pixel's height."""


@dataclass(frozen=True, slots=True)
class Channels:
    """Binned logarithms (C, K, H', W') with repeated borders."""

    images: FloatImage
    margin: int
    noise_variance: float


@dataclass(frozen=True, slots=True)
class Peaks:
    """What the search found at each binned pixel; arrays (H, W) float32."""

    height_um: FloatImage
    quality: FloatImage
    score: FloatImage
    curvature: FloatImage
    """Minus the second derivative of the score with height at its peak, per um squared."""
    brightness: FloatImage
    """Mean logarithm of intensity in the pixel's small window at that height."""

    @classmethod
    def empty(cls, shape: tuple[int, int]) -> Peaks:
        """Arrays to be filled."""
        return cls(*(np.empty(shape, dtype=np.float32) for _ in range(5)))

    def part(self, tile: Tile) -> Peaks:
        """The same arrays within a tile."""
        rows, cols = slice(tile[0], tile[1]), slice(tile[2], tile[3])
        return Peaks(
            self.height_um[rows, cols],
            self.quality[rows, cols],
            self.score[rows, cols],
            self.curvature[rows, cols],
            self.brightness[rows, cols],
        )

    def take(self, other: Peaks, where: BoolImage) -> None:
        """Replace what lies at ``where`` by what ``other`` says."""
        for mine, theirs in (
            (self.height_um, other.height_um),
            (self.quality, other.quality),
            (self.score, other.score),
            (self.curvature, other.curvature),
            (self.brightness, other.brightness),
        ):
            mine[where] = theirs[where]


@dataclass(frozen=True)
class JointSearch:
    """Channels, candidate heights and windows of one search."""

    channels: Channels
    slopes: NDArray[np.float64]
    heights_um: NDArray[np.float64]
    pixel_um: float
    """Of the binned grid."""
    shape: tuple[int, int]
    small_window: int
    large_window: int
    telecentricity_per_um: float

    @property
    def reach(self) -> int:
        """Binned pixels from the middle of the windows to their border."""
        return self.small_window // 2 + self.large_window // 2

    @property
    def step_um(self) -> float:
        """Distance of the candidate heights."""
        return float(self.heights_um[1] - self.heights_um[0])

    @cached_property
    def plan(self) -> ShiftPlan:
        """Shifts in the middle of the field."""
        return plan_shifts(self.slopes, self.heights_um, self.pixel_um, self.telecentricity_per_um)

    def find(
        self, tile: Tile, among: NDArray[np.bool_], found: Peaks, span: slice = slice(None)
    ) -> None:
        """Fill ``found`` (of the tile's size) with the peaks of a tile, seen by the views ``among`` (K,).

        ``span`` are the candidate heights to try, all of them if left out; quality is the lead over their median.

        A view counts only where its windows lie inside the frame for the whole tile; a height counts where at
        least half of all pairs of the chosen views do.
        """
        plan = self._plan_at(tile)
        heights_um = self.heights_um[span]
        used = self._inside(plan, tile) & among
        chosen = int(among.sum())
        count = used.sum(axis=1)
        used[2 * count * (count - 1) < chosen * (chosen - 1)] = False
        curves = np.empty((heights_um.size, *found.score.shape), dtype=np.float32)
        score_tile_jointly(
            self.channels.images,
            self.channels.margin,
            plan.row_whole[span],
            plan.col_whole[span],
            plan.row_weights[span],
            plan.col_weights[span],
            used[span],
            tile,
            self.small_window,
            self.large_window,
            self.channels.noise_variance,
            SOFTNESS,
            CONTRAST,
            curves,
            found.brightness,
        )
        pick_heights(
            curves,
            heights_um,
            math.ceil(LEAST_SHARE * heights_um.size),
            True,
            found.height_um,
            found.quality,
            found.score,
            found.curvature,
        )

    def _plan_at(self, tile: Tile) -> ShiftPlan:
        if self.telecentricity_per_um == 0.0:
            return self.plan
        place = (
            0.5 * float(tile[0] + tile[1] - self.shape[0]),
            0.5 * float(tile[2] + tile[3] - self.shape[1]),
        )
        return plan_shifts(
            self.slopes, self.heights_um, self.pixel_um, self.telecentricity_per_um, place
        )

    def _inside(self, plan: ShiftPlan, tile: Tile) -> NDArray[np.bool_]:
        """Views (N, K) all of whose windows in the tile lie inside the frame."""
        row_first, row_stop = valid_span(plan.row_px, self.shape[0], self.reach)
        col_first, col_stop = valid_span(plan.col_px, self.shape[1], self.reach)
        inside: NDArray[np.bool_] = (row_first <= tile[0]) & (tile[1] <= row_stop)
        inside &= (col_first <= tile[2]) & (tile[3] <= col_stop)
        return inside
