"""Multi-view stereo by mean normalised cross-correlation (paper, section III.A).

For each candidate height the views are shifted after eq. 1 so that a surface at that height coincides in
all of them; the score of a pixel is the mean of eq. 3 over all pairs of views in a window centred on the
pixel.  The height with the greatest score is the pixel's height, and its lead over the median score is
the quality.

Heights live in the virtual view s = 0.  A view counts for a pixel and a height only where the whole
window falls inside that view (:mod:`reliefscope.reconstruction.shifts`); a height has a score where at
least half of all pairs count; a pixel is missing (height NaN, quality 0) where fewer than half of the
heights have one.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from reliefscope.errors import InvalidInputError
from reliefscope.jobs import Job, ensure_job
from reliefscope.reconstruction import tiles
from reliefscope.reconstruction.matcher import LEAST_SHARE, Form, Matcher, Tile
from reliefscope.reconstruction.ncc_kernels import pick_heights, vertex_height
from reliefscope.reconstruction.shifts import plan_shifts, valid_span
from reliefscope.units import BoolImage, FloatImage

WINDOW = 15
"""Side of the correlation window in pixels (paper)."""
QUALITY_THRESHOLD = 0.25
"""Quality below which the paper discards a height."""
LEAST_BASELINE_PX = 0.1
"""Parallax over the whole range of heights below which views tell nothing about height."""


@dataclass(frozen=True, slots=True)
class MvsResult:
    """Height by matching, in the virtual view s = 0; arrays (H, W) float32."""

    height_um: FloatImage
    """NaN where missing."""
    quality: FloatImage
    """Greatest score minus the median over the candidate heights; 0 where missing or no better than a guess."""
    peak: FloatImage
    """Greatest mean NCC; NaN where missing."""
    sigma_um: FloatImage | None = None
    """Standard error of the height, infinite where missing (:mod:`~reliefscope.reconstruction.matching_error`);
    None: not told, as by the paper's search."""

    def accepted(self, threshold: float = QUALITY_THRESHOLD) -> BoolImage:
        """Pixels (H, W) with a height of at least this quality."""
        return np.isfinite(self.height_um) & (self.quality >= threshold)


@dataclass(frozen=True, slots=True)
class ImageMatch:
    """Height of a flat object by matching whole images (paper, section IV.A)."""

    height_um: float
    peak: float
    scores: NDArray[np.float64]
    """(N,) mean NCC of every candidate height."""


def mean_ncc(
    views: FloatImage,
    slopes: ArrayLike,
    height_um: float,
    pixel_um: float,
    window: int = WINDOW,
    *,
    noise_variance: float = 0.0,
    form: Form = "pairs",
) -> FloatImage:
    """Mean of eq. 3 over all pairs of views for one height.

    Parameters
    ----------
    views:
        (K, H, W) linear images, full scale 1.
    slopes:
        (K, 2) slopes ``(sx, sy)``, y up.
    height_um:
        Height that the views are shifted to.
    pixel_um:
        Sampling distance in the focal plane.
    window:
        Odd side of the window in pixels.
    noise_variance:
        Added to each window's variance in the denominator, full scale squared: the variance that sensor
        noise alone gives keeps dark and flat areas from winning.  The paper has none (0).  A window with
        a standard deviation below 1e-6 counts as flat and scores 0.
    form:
        ``pairs`` is eq. 3 exactly (the paper).  ``variance_of_sum`` takes work per view instead of per pair
        and equals it where views differ by one gain each; contrasts that differ within the image weigh
        the pairs (:mod:`reliefscope.reconstruction.ncc_sum_kernels`).

    Returns
    -------
    (H, W) score in [-1, 1]; NaN where fewer than half of all pairs have their windows inside the views.
    """
    images, s = check_views(views, slopes, pixel_um, window)
    heights = np.array([height_um], dtype=np.float64)
    matcher = Matcher(images, plan_shifts(s, heights, pixel_um), window, noise_variance, form)
    score = np.empty(images.shape[1:], dtype=np.float32)

    def work(tile: Tile) -> None:
        part = score[tile[0] : tile[1], tile[2] : tile[3]]
        part[...] = matcher.curves(tile)[0]

    places = matcher.tiles()
    with Job().stage("score", len(places)) as stage:
        tiles.run_each(work, places, stage)
    return score


def match_views(
    views: FloatImage,
    slopes: ArrayLike,
    heights_um: ArrayLike,
    pixel_um: float,
    window: int = WINDOW,
    job: Job | None = None,
    *,
    parabola: bool = False,
    noise_variance: float = 0.0,
    form: Form = "pairs",
) -> MvsResult:
    """Height and quality of every pixel by exhaustive search over ``heights_um``.

    Parameters
    ----------
    views, slopes, pixel_um, window, noise_variance, form:
        As in :func:`mean_ncc`.
    heights_um:
        (N,) candidate heights, increasing, at least three.
    job:
        Progress (stage ``match``, per tile) and cancellation.
    parabola:
        Move the height to the vertex of the parabola through the peak and its neighbours.  The paper
        takes the candidate itself.

    Raises
    ------
    InvalidInputError
        NaN in the views, shapes that do not belong together, views without a baseline, heights that are
        not increasing or move the views out of the image.
    """
    images, s = check_views(views, slopes, pixel_um, window)
    heights = _checked_heights(heights_um)
    check_baseline(s, heights, pixel_um)
    matcher = Matcher(images, plan_shifts(s, heights, pixel_um), window, noise_variance, form)
    shape = images.shape[1:]
    height_um = np.empty(shape, dtype=np.float32)
    quality = np.empty(shape, dtype=np.float32)
    peak = np.empty(shape, dtype=np.float32)
    curvature = np.empty(shape, dtype=np.float32)
    least_scores = max(1, math.ceil(LEAST_SHARE * heights.size))

    def work(tile: Tile) -> None:
        part = (slice(tile[0], tile[1]), slice(tile[2], tile[3]))
        pick_heights(
            matcher.curves(tile),
            heights,
            least_scores,
            parabola,
            height_um[part],
            quality[part],
            peak[part],
            curvature[part],
        )

    places = matcher.tiles()
    with ensure_job(job).stage("match", len(places)) as stage:
        tiles.run_each(work, places, stage)
    return MvsResult(height_um, quality, peak)


def match_image(
    views: FloatImage,
    slopes: ArrayLike,
    heights_um: ArrayLike,
    pixel_um: float,
    job: Job | None = None,
) -> ImageMatch:
    """One height for a flat object: the window is the image (paper, section IV.A, z calibration).

    The window is the largest rectangle that lies inside every view at every candidate height, so that all
    heights are compared on the same ground.  The height is the vertex of the parabola through the peak.

    Parameters and errors are those of :func:`match_views`; stage ``match image``, per height.
    """
    images, s = check_views(views, slopes, pixel_um, 1)
    heights = _checked_heights(heights_um)
    check_baseline(s, heights, pixel_um)
    plan = plan_shifts(s, heights, pixel_um)
    row_first, row_stop = valid_span(plan.row_px, images.shape[1], 0)
    col_first, col_stop = valid_span(plan.col_px, images.shape[2], 0)
    box = (
        int(row_first.max()),
        int(row_stop.min()),
        int(col_first.max()),
        int(col_stop.min()),
    )
    if box[1] - box[0] < WINDOW or box[3] - box[2] < WINDOW:
        raise InvalidInputError(
            "The views have no area in common over the whole range of heights.",
            hint="Narrow the range of heights, or use a larger image.",
        )
    matcher = Matcher(images, plan, 1)
    scores = np.empty(heights.size, dtype=np.float64)

    def work(n: int) -> None:
        scores[n] = matcher.image_score(n, box)

    with ensure_job(job).stage("match image", heights.size) as stage:
        tiles.run_each(work, range(heights.size), stage)
    best = int(np.argmax(scores))
    height = float(heights[best])
    if 0 < best < heights.size - 1:
        height = float(
            vertex_height(heights, best, scores[best - 1], scores[best], scores[best + 1])
        )
    return ImageMatch(height, float(scores[best]), scores)


def check_views(
    views: FloatImage, slopes: ArrayLike, pixel_um: float, window: int
) -> tuple[FloatImage, NDArray[np.float64]]:
    """Views (K, H, W) float32 and slopes (K, 2), or :class:`InvalidInputError` if they cannot be matched."""
    images = np.asarray(views, dtype=np.float32)
    s = np.asarray(slopes, dtype=np.float64)
    if images.ndim != 3 or images.shape[0] < 2:
        raise InvalidInputError(
            f"Matching needs at least two views as an array (views, H, W), not {images.shape}.",
            hint="A run with a single view gets photometric stereo only.",
        )
    if s.shape != (images.shape[0], 2) or not np.isfinite(s).all():
        raise InvalidInputError(
            f"{images.shape[0]} views need as many finite slopes (sx, sy), not an array {s.shape}.",
            hint="Check the slopes of the views in the run or the import file.",
        )
    if not math.isfinite(pixel_um) or pixel_um <= 0:
        raise InvalidInputError(
            f"pixel_um must be positive, not {pixel_um}.", hint="Give the sampling in um per pixel."
        )
    if window < 1 or window % 2 == 0 or window > min(images.shape[1:]):
        raise InvalidInputError(
            f"The window must be odd and fit the image {images.shape[1:]}, not {window}.",
            hint="The paper uses 15.",
        )
    for k, image in enumerate(images):
        if not np.isfinite(image).all():
            raise InvalidInputError(
                f"View {k} has pixels that are not finite.",
                hint="Verify the run; take the damaged frame again or fill the pixels.",
            )
    return images, s


def _checked_heights(heights_um: ArrayLike) -> NDArray[np.float64]:
    heights = np.ascontiguousarray(heights_um, dtype=np.float64)
    if heights.ndim != 1 or heights.size < 3 or not (np.diff(heights) > 0).all():
        raise InvalidInputError(
            "The candidate heights must be at least three increasing values.",
            hint="Give a range such as 0 to 150 um in steps of 1 um.",
        )
    return heights


def check_baseline(s: NDArray[np.float64], heights: NDArray[np.float64], pixel_um: float) -> None:
    """Refuse views whose parallax over the range of heights is nothing."""
    baseline = max(float(np.linalg.norm(s - one, axis=1).max()) for one in s)
    parallax_px = baseline * float(heights[-1] - heights[0]) / pixel_um
    if not parallax_px >= LEAST_BASELINE_PX:
        raise InvalidInputError(
            f"The views have no baseline: {parallax_px:.3g} px of parallax over the whole range of "
            "heights.",
            hint="Take views through apertures that lie apart; check their slopes and the range of "
            "heights.",
        )
