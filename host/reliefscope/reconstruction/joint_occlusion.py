"""Second look behind steps: there, only the views that lean away from the higher ground count.

Ground beside a step is hidden from the views that lean over it; what they show there is the wall and its edge,
which agree on a wrong height.  Where the first search found higher ground on one side of a pixel and lower
ground on the other, the search is repeated with the half of the views that leans away from the higher side;
the pixel takes that height where it leaves clearly less that the views do not share.  Only heights that the first
search found around the pixel are tried, and the quality is the lead over their median.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from reliefscope.jobs import Job, ensure_job
from reliefscope.reconstruction import tiles
from reliefscope.reconstruction.joint_search import SOFTNESS, JointSearch, Peaks
from reliefscope.reconstruction.matcher import Tile
from reliefscope.units import BoolImage, FloatImage

STEP = 2.6
"""Difference of height over the windows, in candidate heights, from which one side may hide the other."""
GAIN = 0.85
"""Share of what all views do not share (``1 - score + softness``) that the half of them must come down to: fewer views
share more by chance alone."""
MARGIN = 2
"""Candidate heights that are tried beyond those around a pixel."""
BLOCK_ROWS, BLOCK_COLUMNS = 48, 96
"""Binned pixels that are searched together, where one of them needs it."""
DIRECTIONS = ((1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0))
"""Sides (x, y) on which the lower ground may lie."""


def search_behind_steps(search: JointSearch, peaks: Peaks, job: Job | None = None) -> None:
    """Improve ``peaks`` of all views at steps by the views that look there.

    ``job`` may stop it between two directions.
    """
    first = peaks.height_um.copy()
    for direction in DIRECTIONS:  # one after the other: their blocks overlap
        ensure_job(job).check()
        below = lower_ground(first, direction, search.reach + 1, STEP * search.step_um)
        _look(search, peaks, first, below, leaning(search.slopes, direction))


def _look(
    search: JointSearch,
    peaks: Peaks,
    first: FloatImage,
    below: BoolImage,
    among: NDArray[np.bool_],
) -> None:
    def work(block: Tile) -> None:
        known = peaks.part(block)
        found = Peaks.empty((int(block[1] - block[0]), int(block[3] - block[2])))
        around = _around(first, block, search.reach)
        search.find(block, among, found, _span(around, search.heights_um))
        needed = below[block[0] : block[1], block[2] : block[3]]
        better = (1.0 + SOFTNESS - found.score) < GAIN * (1.0 + SOFTNESS - known.score)
        known.take(found, needed & better)

    blocks = _blocks(below)
    with Job().stage("look behind steps", len(blocks)) as stage:
        tiles.run_each(work, blocks, stage)


def lower_ground(
    height_um: FloatImage, direction: tuple[float, float], reach: int, jump_um: float
) -> BoolImage:
    """Pixels (H, W) where the ground falls by more than ``jump_um`` within ``reach`` to either side.

    ``direction`` (x, y) points to the lower side, along an axis, y up.
    """
    rows, cols = height_um.shape
    padded = np.pad(height_um, reach, mode="edge")
    down, right = -int(direction[1]) * reach, int(direction[0]) * reach
    low = padded[reach + down : reach + down + rows, reach + right : reach + right + cols]
    high = padded[reach - down : reach - down + rows, reach - right : reach - right + cols]
    with np.errstate(invalid="ignore"):
        falls: BoolImage = high - low > jump_um
    return falls


def leaning(slopes: NDArray[np.float64], direction: tuple[float, float]) -> NDArray[np.bool_]:
    """The half of the views (K,), rounded up, that leans furthest to one side."""
    order = np.argsort(-(slopes @ np.asarray(direction)), kind="stable")
    chosen = np.zeros(len(slopes), dtype=np.bool_)
    chosen[order[: len(slopes) // 2 + 1]] = True
    return chosen


def _around(height_um: FloatImage, block: Tile, reach: int) -> FloatImage:
    """Known heights (M,) in a block and around it."""
    part = height_um[
        max(block[0] - reach, 0) : block[1] + reach, max(block[2] - reach, 0) : block[3] + reach
    ]
    known: FloatImage = part[np.isfinite(part)]
    return known


def _span(around: FloatImage, heights_um: NDArray[np.float64]) -> slice:
    """Candidate heights over the range of those around, and :data:`MARGIN` beyond either end."""
    first, last = np.searchsorted(heights_um, (around.min(), around.max()))
    return slice(max(int(first) - MARGIN, 0), int(last) + MARGIN)


def _blocks(needed: BoolImage) -> list[Tile]:
    """The smallest rectangles that hold what is needed of each block."""
    found = []
    for top, bottom in tiles.spans(needed.shape[0], BLOCK_ROWS):
        for left, right in tiles.spans(needed.shape[1], BLOCK_COLUMNS):
            rows, cols = np.nonzero(needed[top:bottom, left:right])
            if rows.size:
                found.append(
                    np.array(
                        [
                            top + rows.min(),
                            top + rows.max() + 1,
                            left + cols.min(),
                            left + cols.max() + 1,
                        ],
                        dtype=np.int64,
                    )
                )
    return found
