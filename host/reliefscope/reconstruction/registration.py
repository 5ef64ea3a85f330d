"""Bringing frames to the virtual view s = 0 by the height of the surface.

A surface point at ``(x, y)`` with height z appears in the view ``s`` at ``(x - z sx, y - z sy)``
(:mod:`reliefscope.axes`), so the frame is sampled there.  Where the optics are not quite telecentric the slope
grows by ``telecentricity_per_um`` times the position from the middle of the field
(:func:`~reliefscope.reconstruction.shifts.plan_shifts`).  A point is hidden in that
view where a higher part of the surface lies on its ray ``(x + t sx, y + t sy, z + t)``.
"""

from __future__ import annotations

import math
from typing import Literal

import cv2
import numpy as np
from numba import njit
from numpy.typing import ArrayLike, NDArray

from reliefscope.axes import apparent_shift_px
from reliefscope.errors import InvalidInputError
from reliefscope.jobs import Job, ensure_job
from reliefscope.reconstruction import tiles
from reliefscope.reconstruction.shifts import SNAP_PX
from reliefscope.units import BoolImage, FloatImage

Interpolation = Literal["linear", "cubic"]
STRIP_ROWS = 64
VISIBILITY_TOLERANCE_UM = 2.0
"""Height by which a surface must rise above a ray to hide a point: the noise of heights, not an edge."""


def to_reference(
    images: FloatImage,
    slopes: ArrayLike,
    height_um: FloatImage,
    pixel_um: float,
    *,
    telecentricity_per_um: float = 0.0,
    interpolation: Interpolation = "cubic",
    visible: BoolImage | None = None,
    job: Job | None = None,
) -> FloatImage:
    """Frames of K views as the view s = 0 would see them.

    Parameters
    ----------
    images:
        (K, H, W) frames, one per view.
    slopes:
        (K, 2) slopes ``(sx, sy)``, y up.
    height_um:
        (H, W) height in the view s = 0; NaN is missing.
    pixel_um:
        Sampling distance in the focal plane.
    telecentricity_per_um:
        Growth of the slopes with the position from the middle of the field.
    interpolation:
        ``cubic`` convolution (Keys, a = -1/2; at the border the outer taps repeat it) or ``linear``.
    visible:
        (K, H, W) mask such as :func:`visibility` gives; what is hidden becomes NaN.
    job:
        Progress (stage ``register``, per view and strip of rows) and cancellation.

    Returns
    -------
    (K, H, W) float32; NaN where the height is missing, the point falls outside the frame, or is hidden.
    """
    frames = np.ascontiguousarray(images, dtype=np.float32)
    height, moves = _checked(frames.shape, slopes, height_um, pixel_um)
    if visible is not None and visible.shape != frames.shape:
        raise InvalidInputError(
            f"A visibility mask {visible.shape} does not belong to frames {frames.shape}.",
            hint="Make it from the same slopes and heights.",
        )
    out = np.empty(frames.shape, dtype=np.float32)

    def work(item: tuple[int, tuple[int, int]]) -> None:
        k, (first, stop) = item
        resample(
            frames[k],
            height,
            *moves[k],
            telecentricity_per_um,
            interpolation == "cubic",
            first,
            stop,
            out[k],
        )
        if visible is not None:
            out[k, first:stop][~visible[k, first:stop]] = np.nan

    items = [(k, rows) for k in range(len(frames)) for rows in _strips(height)]
    with ensure_job(job).stage("register", len(items)) as stage:
        tiles.run_each(work, items, stage)
    return out


def visibility(
    height_um: FloatImage,
    slopes: ArrayLike,
    pixel_um: float,
    *,
    telecentricity_per_um: float = 0.0,
    tolerance_um: float = VISIBILITY_TOLERANCE_UM,
    job: Job | None = None,
) -> BoolImage:
    """Whether each point of the surface is seen in each view (K, H, W).

    The ray from the point toward the aperture is followed in steps of at most one pixel until it is above
    the highest part of the surface that it can come to; the point is hidden where the surface (linear between
    pixels) rises more than ``tolerance_um`` above the ray.  Missing heights hide nothing and are not visible.
    """
    s = np.asarray(slopes, dtype=np.float64)
    height, moves = _checked((len(s), *height_um.shape), slopes, height_um, pixel_um)
    mask = np.empty((len(s), *height.shape), dtype=np.bool_)
    ceiling = _ceiling(height, moves, telecentricity_per_um)

    def work(item: tuple[int, tuple[int, int]]) -> None:
        k, (first, stop) = item
        trace_visibility(
            height, *moves[k], telecentricity_per_um, ceiling, tolerance_um, first, stop, mask[k]
        )

    items = [(k, rows) for k in range(len(s)) for rows in _strips(height)]
    with ensure_job(job).stage("visibility", len(items)) as stage:
        tiles.run_each(work, items, stage)
    return mask


@njit(cache=True, nogil=True, error_model="numpy", fastmath={"contract", "nsz"})
def resample(
    frame: FloatImage,
    height: FloatImage,
    cols_per_um: float,
    rows_per_um: float,
    telecentricity_per_um: float,
    cubic: bool,
    first: int,
    stop: int,
    out: FloatImage,
) -> None:
    """Rows ``first`` to ``stop`` of ``out``: ``frame`` at ``(row + z rows_per_um, col + z cols_per_um)``.

    The shifts per um are those in the middle of the field.
    """
    rows, cols = frame.shape
    middle_row, middle_col = 0.5 * (rows - 1), 0.5 * (cols - 1)
    low, right = rows - 1 + SNAP_PX, cols - 1 + SNAP_PX
    one, half = np.float32(1.0), np.float32(0.5)
    two, three, five = np.float32(2.0), np.float32(1.5), np.float32(2.5)
    for r in range(first, stop):
        for c in range(cols):
            z = height[r, c]
            z /= 1.0 + z * telecentricity_per_um
            y = r + z * (rows_per_um - telecentricity_per_um * (r - middle_row))
            x = c + z * (cols_per_um - telecentricity_per_um * (c - middle_col))
            if not (y >= -SNAP_PX and y <= low and x >= -SNAP_PX and x <= right):
                out[r, c] = np.nan
                continue
            y1 = min(int(y), max(rows - 2, 0))
            x1 = min(int(x), max(cols - 2, 0))
            y2 = min(y1 + 1, rows - 1)
            x2 = min(x1 + 1, cols - 1)
            t = np.float32(x - x1)
            u = np.float32(y - y1)
            if not cubic:
                above = frame[y1, x1] + t * (frame[y1, x2] - frame[y1, x1])
                below = frame[y2, x1] + t * (frame[y2, x2] - frame[y2, x1])
                out[r, c] = above + u * (below - above)
                continue
            y0 = max(y1 - 1, 0)
            x0 = max(x1 - 1, 0)
            y3 = min(y1 + 2, rows - 1)
            x3 = min(x1 + 2, cols - 1)
            t0 = ((one - half * t) * t - half) * t
            t1 = (three * t - five) * t * t + one
            t2 = ((two - three * t) * t + half) * t
            t3 = (half * t - half) * t * t
            a = t0 * frame[y0, x0] + t1 * frame[y0, x1] + t2 * frame[y0, x2] + t3 * frame[y0, x3]
            b = t0 * frame[y1, x0] + t1 * frame[y1, x1] + t2 * frame[y1, x2] + t3 * frame[y1, x3]
            d = t0 * frame[y2, x0] + t1 * frame[y2, x1] + t2 * frame[y2, x2] + t3 * frame[y2, x3]
            e = t0 * frame[y3, x0] + t1 * frame[y3, x1] + t2 * frame[y3, x2] + t3 * frame[y3, x3]
            out[r, c] = (
                (((one - half * u) * u - half) * u) * a
                + ((three * u - five) * u * u + one) * b
                + (((two - three * u) * u + half) * u) * d
                + ((half * u - half) * u * u) * e
            )


@njit(cache=True, nogil=True, error_model="numpy")
def trace_visibility(
    height: FloatImage,
    cols_per_um: float,
    rows_per_um: float,
    telecentricity_per_um: float,
    ceiling: FloatImage,
    tolerance_um: float,
    first: int,
    stop: int,
    out: BoolImage,
) -> None:
    """Rows ``first`` to ``stop`` of ``out``: no surface above the ray that rises toward the aperture.

    The ray moves against the parallax: by ``-cols_per_um, -rows_per_um`` pixels per um of rise.  ``ceiling`` (H, W)
    is a height that no surface within its reach exceeds.
    """
    rows, cols = height.shape
    middle_row, middle_col = 0.5 * (rows - 1), 0.5 * (cols - 1)
    for r in range(first, stop):
        for c in range(cols):
            z, top = height[r, c], ceiling[r, c]
            bend = 1.0 + z * telecentricity_per_um
            along_um = (cols_per_um - telecentricity_per_um * (c - middle_col)) / bend
            down_um = (rows_per_um - telecentricity_per_um * (r - middle_row)) / bend
            travel = max(abs(along_um), abs(down_um))
            seen = not np.isnan(z)
            if seen and travel > 0.0:
                step_um = 1.0 / travel
                rise = step_um
                while z + rise + tolerance_um < top:
                    y = r - rise * down_um
                    x = c - rise * along_um
                    if not (y >= 0.0 and y <= rows - 1 and x >= 0.0 and x <= cols - 1):
                        break
                    above = min(int(y), max(rows - 2, 0))
                    left = min(int(x), max(cols - 2, 0))
                    down = min(above + 1, rows - 1)
                    right = min(left + 1, cols - 1)
                    fy, fx = y - above, x - left
                    surface = (1.0 - fy) * (
                        (1.0 - fx) * height[above, left] + fx * height[above, right]
                    ) + fy * ((1.0 - fx) * height[down, left] + fx * height[down, right])
                    if surface > z + rise + tolerance_um:
                        seen = False
                        break
                    rise += step_um
            out[r, c] = seen


def _ceiling(
    height: FloatImage, moves: list[tuple[float, float]], telecentricity_per_um: float
) -> FloatImage:
    """Greatest height (H, W) that the ray of any view can come to before it is above the whole surface."""
    known = np.isfinite(height)
    if not known.any():
        return height
    low, high = float(height[known].min()), float(height[known].max())
    bend = 1.0 - abs(telecentricity_per_um) * max(abs(low), abs(high))
    steepest = max(abs(move) for pair in moves for move in pair)
    steepest += abs(telecentricity_per_um) * max(height.shape) / 2
    reach = math.ceil((high - low) * steepest / bend) + 1  # the surface is linear between pixels
    window = np.ones((2 * min(reach, max(height.shape)) + 1,) * 2, np.uint8)
    filled = np.where(known, height, np.float32(low))
    return np.asarray(cv2.dilate(filled, window), np.float32)


def _strips(height: NDArray[np.float32]) -> list[tuple[int, int]]:
    return tiles.spans(height.shape[0], STRIP_ROWS)


def _checked(
    shape: tuple[int, ...], slopes: ArrayLike, height_um: FloatImage, pixel_um: float
) -> tuple[FloatImage, list[tuple[float, float]]]:
    s = np.asarray(slopes, dtype=np.float64)
    if len(shape) != 3 or s.shape != (shape[0], 2) or not np.isfinite(s).all():
        raise InvalidInputError(
            f"Frames {shape} and slopes {s.shape} do not belong together.",
            hint="Registration needs frames (views, H, W) and one finite slope (sx, sy) per view.",
        )
    if height_um.shape != shape[1:]:
        raise InvalidInputError(
            f"A height map {height_um.shape} does not belong to frames {shape}.",
            hint="Heights and frames must share one pixel grid.",
        )
    if not math.isfinite(pixel_um) or pixel_um <= 0:
        raise InvalidInputError(
            f"pixel_um must be positive, not {pixel_um}.", hint="Give the sampling in um per pixel."
        )
    moves = [apparent_shift_px(1.0, (float(sx), float(sy)), pixel_um) for sx, sy in s]
    return np.ascontiguousarray(height_um, dtype=np.float32), moves
