"""Stereo matching jointly over groups of lights: the fast and more accurate method.

What differs from the paper's search (:func:`~reliefscope.reconstruction.mvs.match_views`):

- Lights are not averaged but kept in a few groups by azimuth, each a *channel*: shading is texture where
  the surface has none, and a highlight of one light spoils only its own channel.
- Channels are logarithms of intensity, so that a dark floor counts as much as a bright edge and a gain is
  an offset, which correlation does not see.
- Small windows are correlated, and their scores averaged over a larger one and over the channels; what
  fits best weighs most (:mod:`~reliefscope.reconstruction.joint_kernels`).
- Beside steps the views that look behind them are asked again
  (:mod:`~reliefscope.reconstruction.joint_occlusion`).
- Pixels are binned as far as the apertures' blur leaves nothing finer to match, and the candidate heights
  spaced by parallax on the binned grid.  The peak is refined by a parabola.

Quality keeps its meaning: greatest score minus the median over all candidate heights; it is 0 where the
standard error is no less than that of a guess.  Validity at the
borders is that of :mod:`~reliefscope.reconstruction.mvs`, except that a view counts for a small tile as a
whole.
"""

from __future__ import annotations

import math

import cv2
import numpy as np
from numpy.typing import ArrayLike, NDArray

from reliefscope.errors import InvalidInputError
from reliefscope.jobs import Job, ensure_job
from reliefscope.reconstruction import tiles
from reliefscope.reconstruction.joint_kernels import expand, window_variance
from reliefscope.reconstruction.joint_occlusion import search_behind_steps
from reliefscope.reconstruction.joint_search import SOFTNESS, Channels, JointSearch, Peaks
from reliefscope.reconstruction.matcher import Tile
from reliefscope.reconstruction.matching_error import knows_nothing_um, standard_error
from reliefscope.reconstruction.mvs import MvsResult, check_baseline, check_views
from reliefscope.reconstruction.shifts import (
    TAPS,
    plan_shifts,
    valid_span,
)
from reliefscope.units import FloatImage

GROUPS = 4
"""Groups of lights matched jointly."""
SHARPNESS_RATIO = 3.1
"""Pixels are binned by two as long as the mean squared difference of intensities grows by more than this from
two pixels to four: an image so blurred (4 would be all blur, 2 a sharp edge, 1 noise) has nothing finer."""
SMALL_WINDOW = 3
LARGE_WINDOW = 5
"""Windows in binned pixels: correlated, and averaged over."""
LARGE_WINDOW_ALONE = 9
"""Window that is averaged over where there is one channel: fewer samples vote."""
STEP_PX = 0.5
"""Parallax, in binned pixels and against the mean view, between neighbouring candidate heights."""
NOISE_SHARE = 0.002
"""Variance added to each window's in the denominator, as a share of the median window variance."""
DARK_SHARE = 0.05
"""Intensity added before the logarithm, as a share of the median intensity."""
QUALITY_THRESHOLD = 0.03
"""Quality below which heights are better discarded (docs/explanation/default-method.md)."""
LEAST_SIDE = 48
"""Binned images are at least so wide and high; smaller ones are matched as they are."""

TILE_ROWS = 48
TILE_COLUMNS = 350
BORDER_ROWS = 2
LEAST_TILE = 16
DRIFT_PX = 0.05
"""Change within a tile of the shift by telecentricity, in binned pixels, that smaller tiles avoid."""
JUMP_STEPS = 2.0
"""Difference between neighbours, in steps of height, over which no height is interpolated."""


def light_groups(directions: NDArray[np.float64] | None, count: int) -> list[list[int]]:
    """Lights that share a channel: at most :data:`GROUPS` groups of neighbouring azimuth.

    ``directions`` (L, 3) point toward the ``count`` lights; lights of unknown direction are grouped in order.
    """
    if directions is None:
        order = np.arange(count)
    else:
        azimuth = np.arctan2(directions[:, 1], directions[:, 0]) % (2 * math.pi)
        order = np.argsort(np.round(azimuth, 9), kind="stable")
    parts = np.array_split(order, min(GROUPS, count))
    return [[int(light) for light in part] for part in parts]


def resolved_binning(images: FloatImage) -> int:
    """Pixels per side, a power of two, that can be averaged in images (C, H, W) without losing detail."""
    binning = 1
    while min(images.shape[1:]) >= 2 * LEAST_SIDE * binning:
        near, far = (
            sum(float(np.mean((image[::4, lag:] - image[::4, :-lag]) ** 2)) for image in images)
            for lag in (2 * binning, 4 * binning)
        )
        if far <= SHARPNESS_RATIO * near:
            break
        binning *= 2
    return binning


def candidate_heights(
    slopes: NDArray[np.float64], range_um: tuple[float, float], pixel_um: float, binning: int
) -> NDArray[np.float64]:
    """Heights (N,) to try, one beyond either end of the range, so that the ends can be refined too."""
    lean = float(np.linalg.norm(slopes - slopes.mean(axis=0), axis=1).max())
    low, high = range_um
    count = max(math.ceil((high - low) * lean / (STEP_PX * binning * pixel_um)), 2)
    step = (high - low) / count
    return np.asarray(low + step * np.arange(-1, count + 2), dtype=np.float64)


def match_jointly(
    channels: FloatImage,
    slopes: ArrayLike,
    range_um: tuple[float, float],
    pixel_um: float,
    job: Job | None = None,
    *,
    telecentricity_per_um: float = 0.0,
    binning: int | None = None,
    small_window: int = SMALL_WINDOW,
    large_window: int | None = None,
) -> MvsResult:
    """Height and quality of every pixel from all views of several groups of lights.

    Parameters
    ----------
    channels:
        (C, K, H, W) linear images of K views under C groups of lights, or (K, H, W) of one group.
    slopes:
        (K, 2) slopes ``(sx, sy)``, y up.
    range_um:
        Lowest and highest height.
    pixel_um:
        Sampling distance in the focal plane.
    job:
        Progress (stage ``match``, per tile) and cancellation.
    telecentricity_per_um:
        Growth of the slopes with the position from the middle of the field; constant within a tile.
    binning:
        Pixels per side that are averaged before matching; None: as :func:`resolved_binning` finds.
    small_window, large_window:
        See :data:`SMALL_WINDOW`, :data:`LARGE_WINDOW`; both odd.  None: :data:`LARGE_WINDOW` of several
        channels, :data:`LARGE_WINDOW_ALONE` of one.

    Raises
    ------
    InvalidInputError
        Pixels that are not finite, shapes that do not belong together, views without a baseline, a range
        that is empty or moves the views out of the image.
    """
    stack = np.asarray(channels, dtype=np.float32)
    stack = stack[None] if stack.ndim == 3 else stack
    if large_window is None:
        large_window = LARGE_WINDOW if len(stack) > 1 else LARGE_WINDOW_ALONE
    low, high = range_um
    if not (math.isfinite(low) and math.isfinite(high) and low < high):
        raise InvalidInputError(
            f"The range of heights {low:g} to {high:g} um is empty.",
            hint="Give the lowest height first, then the highest.",
        )
    if stack.ndim != 4 or not len(stack):
        raise InvalidInputError(
            f"Joint matching needs channels (groups of lights, views, H, W), not {stack.shape}.",
            hint="Average the frames of each group of lights.",
        )
    for images in stack:
        _, s = check_views(images, slopes, pixel_um, small_window)
    shape = (stack.shape[2], stack.shape[3])
    if binning is None:
        binning = resolved_binning(stack[:, 0])
    heights = candidate_heights(s, range_um, pixel_um, binning)
    check_baseline(s, heights, pixel_um)
    coarse = (shape[0] // binning, shape[1] // binning)
    plan = plan_shifts(s, heights, pixel_um * binning, telecentricity_per_um)
    reach = small_window // 2 + large_window // 2
    travel = int(max(np.abs(plan.row_whole).max(), np.abs(plan.col_whole).max()))
    drift = abs(telecentricity_per_um) * float(np.abs(heights).max())
    travel += math.ceil(drift * 0.5 * max(coarse))
    if travel + reach >= min(coarse) // 2:
        raise InvalidInputError(
            f"The range of heights moves a view by {travel * binning} pixels, too far for an image of "
            f"{shape[0]} x {shape[1]}.",
            hint="Check the range of heights, pixel_um and the slopes of the views.",
        )
    search = JointSearch(
        _prepared(stack, coarse, binning, travel + reach + TAPS, small_window),
        s,
        heights,
        pixel_um * binning,
        coarse,
        small_window,
        large_window,
        telecentricity_per_um,
    )
    peaks = Peaks.empty(coarse)
    everyone = np.ones(len(s), dtype=np.bool_)
    places = _tiles(search, drift)
    with ensure_job(job).stage("match", len(places)) as stage:
        tiles.run_each(lambda tile: search.find(tile, everyone, peaks.part(tile)), places, stage)
    search_behind_steps(search, peaks, job)
    height_um = np.clip(peaks.height_um, low, high)
    sigma_um = standard_error(height_um, peaks.score, peaks.curvature, peaks.brightness, SOFTNESS)
    jump = JUMP_STEPS * float(heights[1] - heights[0])
    height_um = _expanded(height_um, shape, binning, jump)
    quality = _expanded(peaks.quality, shape, binning, math.inf)
    sigma_um = _expanded(sigma_um, shape, binning, math.inf)
    missing = np.isnan(height_um)
    greatest_um = np.float32(knows_nothing_um(range_um))
    quality[missing | (sigma_um >= greatest_um)] = 0.0
    np.minimum(sigma_um, greatest_um, out=sigma_um)
    sigma_um[missing] = np.inf
    peak = _expanded(peaks.score, shape, binning, math.inf)
    return MvsResult(height_um, quality, peak, sigma_um)


def _prepared(
    stack: FloatImage, coarse: tuple[int, int], binning: int, margin: int, window: int
) -> Channels:
    """Binned logarithms without their means, and the noise floor of their window variances."""
    count, views = stack.shape[:2]
    padded = (count, views, coarse[0] + 2 * margin, coarse[1] + 2 * margin)
    images = np.empty(padded, dtype=np.float32)
    medians = np.empty((count, views))
    crop = np.s_[: coarse[0] * binning, : coarse[1] * binning]
    level = float(np.median(stack[:, 0, ::8, ::8]))
    floor = np.float32(DARK_SHARE * level if level > 0.0 else max(float(np.abs(stack).max()), 1e-6))

    def work(place: tuple[int, int]) -> None:
        image = stack[place][crop]
        if binning > 1:
            image = cv2.resize(image, coarse[::-1], interpolation=cv2.INTER_AREA)
        logarithm = np.log(np.maximum(image, np.float32(0.0)) + floor)
        logarithm -= logarithm.mean(dtype=np.float64).astype(np.float32)
        images[place] = cv2.copyMakeBorder(
            logarithm, margin, margin, margin, margin, cv2.BORDER_REPLICATE
        )
        variance = np.empty([side - window + 1 for side in coarse], dtype=np.float32)
        window_variance(logarithm, window, variance)
        medians[place] = np.median(variance[::4, ::4])

    places = [(c, k) for c in range(count) for k in range(views)]
    with Job().stage("prepare", len(places)) as stage:
        tiles.run_each(work, places, stage)
    return Channels(images, margin, NOISE_SHARE * float(np.median(medians)) + 1e-12)


def _tiles(search: JointSearch, drift: float) -> list[Tile]:
    """Tiles of the area that all views see, then small ones in the frame around it.

    ``drift`` is the change of shift from one pixel to the next by telecentricity.
    """
    shape, plan = search.shape, search.plan
    row_first, row_stop = valid_span(plan.row_px, shape[0], search.reach)
    col_first, col_stop = valid_span(plan.col_px, shape[1], search.reach)
    top, bottom = int(row_first.max()), int(row_stop.min())
    left, right = int(col_first.max()), int(col_stop.min())
    widest = max(LEAST_TILE, int(2 * DRIFT_PX / drift)) if drift > 0.0 else max(shape)
    rows, columns = min(TILE_ROWS, widest), min(TILE_COLUMNS, widest)

    def cut(r0: int, r1: int, c0: int, c1: int, tall: int, wide: int) -> list[Tile]:
        if r1 <= r0 or c1 <= c0:
            return []
        return [
            np.array([r0 + a, r0 + b, c0 + c, c0 + d], dtype=np.int64)
            for a, b in tiles.spans(r1 - r0, tall)
            for c, d in tiles.spans(c1 - c0, wide)
        ]

    return [
        *cut(top, bottom, left, right, rows, columns),
        *cut(0, top, left, right, BORDER_ROWS, columns),
        *cut(bottom, shape[0], left, right, BORDER_ROWS, columns),
        *cut(0, shape[0], 0, left, rows, BORDER_ROWS),
        *cut(0, shape[0], right, shape[1], rows, BORDER_ROWS),
    ]


def _expanded(coarse: FloatImage, shape: tuple[int, int], binning: int, jump: float) -> FloatImage:
    if binning == 1:
        return coarse
    out: FloatImage = np.empty(shape, dtype=np.float32)
    strips = tiles.spans(shape[0], 64)
    with Job().stage("expand", len(strips)) as stage:
        tiles.run_each(lambda rows: expand(coarse, binning, jump, *rows, out), strips, stage)
    return out
