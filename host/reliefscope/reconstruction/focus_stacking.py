"""Height from a stack of images focused at different heights (paper, section IV.C: the reference microscope).

The method is that of the Stack Focuser plugin of ImageJ, which the paper used: each image is freed from single noisy
pixels by a 3 x 3 median, its edges are found by the Sobel operators, an edge speaks for the pixels of a window
around it (the greatest gradient in the window), and each pixel takes the plane where that measure is greatest.
The height map is then smoothed with a Gaussian.

Two things are added.  A quality tells where there was something to focus on: a surface without texture takes any
plane.  And a peak between the planes can be found from the measure at the best plane and its two neighbours,
which as a function of defocus is nearly Gaussian.  One weakness of the method stays: around a strong edge the wide
flank of its blur, in a plane far out of focus, beats the faint texture that belongs there (a halo); a larger window
narrows it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal

import cv2
import numpy as np
from numpy.typing import ArrayLike, NDArray

from reliefscope.errors import InvalidInputError
from reliefscope.jobs import Job, ensure_job
from reliefscope.units import BoolImage, FloatImage

Peak = Literal["plane", "gaussian"]

WINDOW = 5
"""Side of the window in pixels (paper)."""
SMOOTHING_PX = 3.0
"""Standard deviation of the final Gaussian in pixels (paper)."""
QUALITY_THRESHOLD = 0.45
"""Quality from which a pixel had something to focus on: of 31 planes of noise alone, 90 % of the pixels stay below."""
_LEAST_MEASURE = 1e-12


@dataclass(frozen=True, slots=True)
class FocusedStack:
    """What a stack of images tells; maps (H, W) float32."""

    height_um: FloatImage
    """Height in focus, smoothed; every pixel has one, good or not."""
    picked_um: FloatImage
    """The same before smoothing."""
    quality: FloatImage
    """1 - mean / greatest focus measure over the planes: 0 where no plane is sharper than another, and where the
    sharpest is the first or the last, for then the peak may lie outside the stack."""
    focused: FloatImage
    """(H, W) or (H, W, 3): every pixel from the plane that is sharpest there."""

    def accepted(self, threshold: float = QUALITY_THRESHOLD) -> BoolImage:
        """Pixels (H, W) with something to focus on."""
        accepted: BoolImage = self.quality >= threshold
        return accepted


def focus_measure(image: FloatImage, window: int = WINDOW) -> FloatImage:
    """Greatest gradient (H, W) within a window around each pixel of an image (H, W) or (H, W, 3).

    The gradient is the length of the two Sobel derivatives, in intensity per pixel, after a 3 x 3 median.
    """
    grey = image if image.ndim == 2 else image.mean(axis=2, dtype=np.float32)
    calm = cv2.medianBlur(np.ascontiguousarray(grey, np.float32), 3)
    across = cv2.Sobel(calm, cv2.CV_32F, 1, 0, scale=1 / 8)
    down = cv2.Sobel(calm, cv2.CV_32F, 0, 1, scale=1 / 8)
    edges = cv2.magnitude(across, down)
    measure: FloatImage = cv2.dilate(edges, np.ones((window, window), np.uint8)).astype(np.float32)
    return measure


def focus_stack(
    planes: Iterable[FloatImage],
    heights_um: ArrayLike,
    *,
    window: int = WINDOW,
    smoothing_px: float = SMOOTHING_PX,
    peak: Peak = "plane",
    job: Job | None = None,
) -> FocusedStack:
    """Height and an image sharp everywhere, from images focused at different heights.

    Images are taken one after the other; about ten times the memory of one is needed, however many there are.

    Parameters
    ----------
    planes:
        Images (H, W) or (H, W, 3), linear, of equal brightness, in the order of ``heights_um``.
    heights_um:
        (N,) height that is in focus in each, increasing; at least three.
    window:
        Odd side in pixels of the window in which an edge speaks for its neighbours.
    smoothing_px:
        Standard deviation of the Gaussian that smooths the height map; 0 leaves it.
    peak:
        ``plane`` takes the height of the sharpest plane (the paper), ``gaussian`` the vertex of a Gaussian
        through its measure and those of its neighbours.
    job:
        Progress (stage ``focus``, per image) and cancellation.

    Raises
    ------
    InvalidInputError
        Fewer than three planes, images of different shapes, heights that do not increase, an even window.
    """
    heights = _checked_heights(heights_um)
    if window < 1 or window % 2 == 0:
        raise InvalidInputError(f"The window must be odd, not {window}.", hint="The paper uses 5.")
    search: _Search | None = None
    with ensure_job(job).stage("focus", heights.size) as stage:
        for image in planes:
            if search is None:
                search = _Search(image, window)
            search.look_at(image)
            stage.advance()
    if search is None or search.planes != heights.size:
        raise InvalidInputError(
            f"There are {search.planes if search else 0} images for {heights.size} heights.",
            hint="Give one height per image.",
        )
    picked = (heights[search.index] + search.offset_um(heights, peak)).astype(np.float32)
    height = cv2.GaussianBlur(picked, (0, 0), smoothing_px) if smoothing_px > 0 else picked.copy()
    return FocusedStack(np.asarray(height, np.float32), picked, search.quality(), search.focused)


class _Search:
    """The sharpest plane of every pixel so far, and its neighbours' measures."""

    def __init__(self, first: FloatImage, window: int) -> None:
        shape = first.shape[:2]
        self._window = window
        self._image_shape = first.shape
        self.planes = 0
        self._total = np.zeros(shape, np.float32)
        self._best = np.full(shape, -1.0, np.float32)
        self._previous = np.zeros(shape, np.float32)
        self._before = np.zeros(shape, np.float32)
        self._after = np.zeros(shape, np.float32)
        self.index: NDArray[np.intp] = np.zeros(shape, np.intp)
        self.focused: FloatImage = np.zeros_like(first, dtype=np.float32)

    def look_at(self, image: FloatImage) -> None:
        """Take in the next plane."""
        if image.shape != self._image_shape:
            raise InvalidInputError(
                f"Image {self.planes} of the stack has shape {image.shape}, the first {self._image_shape}.",
                hint="Give images of one size, all of them grey or all in colour.",
            )
        measure = focus_measure(image, self._window)
        np.copyto(self._after, measure, where=self.index == self.planes - 1)
        better = measure > self._best
        np.copyto(self._best, measure, where=better)
        np.copyto(self._before, self._previous, where=better)
        np.copyto(self.index, self.planes, where=better)
        np.copyto(self.focused, image, where=better if image.ndim == 2 else better[..., None])
        self._total += measure
        self._previous = measure
        self.planes += 1

    def quality(self) -> FloatImage:
        """See :attr:`FocusedStack.quality`; 0 where nothing was measured."""
        mean = self._total / np.float32(self.planes)
        quality: FloatImage = np.clip(1 - mean / np.maximum(self._best, _LEAST_MEASURE), 0.0, 1.0)
        quality[(self.index == 0) | (self.index == self.planes - 1)] = 0.0
        return quality

    def offset_um(self, heights: NDArray[np.float64], peak: Peak) -> NDArray[np.float64]:
        """Height of the peak over the best plane: the vertex of the parabola through three logarithms.

        It stays within half a step; planes at either end of the stack have none.
        """
        offset = np.zeros(self.index.shape)
        if peak == "plane":
            return offset
        inside = (self.index > 0) & (self.index < heights.size - 1)
        best = self.index[inside]
        lower = heights[best - 1] - heights[best]
        upper = heights[best + 1] - heights[best]
        middle = _logarithm(self._best[inside])
        slope_lower = (_logarithm(self._before[inside]) - middle) / lower
        slope_upper = (_logarithm(self._after[inside]) - middle) / upper
        curvature = (slope_upper - slope_lower) / (upper - lower)
        curved = curvature < 0
        with np.errstate(divide="ignore", invalid="ignore"):
            vertex = -0.5 * (slope_lower - curvature * lower) / curvature
        offset[inside] = np.where(curved, np.clip(vertex, 0.5 * lower, 0.5 * upper), 0.0)
        return offset


def _logarithm(measure: FloatImage) -> NDArray[np.float64]:
    return np.log(np.maximum(measure, _LEAST_MEASURE).astype(np.float64))


def _checked_heights(heights_um: ArrayLike) -> NDArray[np.float64]:
    heights = np.asarray(heights_um, dtype=np.float64)
    if heights.ndim != 1 or heights.size < 3 or not (np.diff(heights) > 0).all():
        raise InvalidInputError(
            "The planes of a stack need at least three increasing heights.",
            hint="Sort the images by the height that is in focus, lowest first.",
        )
    if not math.isfinite(float(heights[-1] - heights[0])):
        raise InvalidInputError("A height of the stack is not finite.", hint="Correct its heights.")
    return heights
