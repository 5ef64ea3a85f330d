"""Frames of all views brought to the view s = 0 by the height and averaged, light by light, in one pass.

The same sums as :func:`~reliefscope.reconstruction.registration.to_reference` and a mean, without an array per
view: where a pixel lies in a view, and how its neighbours weigh, is worked out once for all lights.
"""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from reliefscope.axes import apparent_shift_px
from reliefscope.jobs import Job, ensure_job
from reliefscope.reconstruction import tiles
from reliefscope.reconstruction.shifts import SNAP_PX
from reliefscope.units import BoolImage, FloatImage

STRIP_ROWS = 16


class ViewAverage:
    """Running mean over views of the frames of all lights, in the view s = 0.

    Parameters
    ----------
    height_um:
        (H, W) height of the surface; NaN is missing.
    pixel_um:
        Sampling distance in the focal plane.
    lights:
        Number of lights L.
    telecentricity_per_um:
        Growth of the slopes with the position from the middle of the field.
    """

    def __init__(
        self,
        height_um: FloatImage,
        pixel_um: float,
        lights: int,
        telecentricity_per_um: float = 0.0,
    ) -> None:
        self._telecentricity_per_um = telecentricity_per_um
        self._height = np.ascontiguousarray(height_um, dtype=np.float32)
        self._pixel_um = pixel_um
        self._sums = np.zeros((lights, *height_um.shape), np.float32)
        self._counts = np.zeros(height_um.shape, np.float32)
        self._missing = np.zeros(self._sums.shape, np.uint8)

    def add(
        self,
        frames: FloatImage,
        slope: tuple[float, float],
        gain: float,
        visible: BoolImage | None = None,
        job: Job | None = None,
    ) -> None:
        """Add the frames (L, H, W) of one view, multiplied by ``gain``, where the view sees the point.

        ``visible`` (H, W) says where it does.  Bilinear between pixels; NaN is missing under that light only.
        Progress (stage ``register``, per strip of rows) and cancellation go to ``job``.
        """
        cols_per_um, rows_per_um = apparent_shift_px(1.0, slope, self._pixel_um)
        seen = np.ones(self._height.shape, np.bool_) if visible is None else visible

        def work(rows: tuple[int, int]) -> None:
            add_rows(
                frames,
                self._height,
                seen,
                cols_per_um,
                rows_per_um,
                self._telecentricity_per_um,
                np.float32(gain),
                *rows,
                self._sums,
                self._counts,
                self._missing,
            )

        strips = tiles.spans(self._height.shape[0], STRIP_ROWS)
        with ensure_job(job).stage("register", len(strips)) as stage:
            tiles.run_each(work, strips, stage)

    def mean(self, factors: NDArray[np.float64]) -> FloatImage:
        """Mean over the views (L, H, W), times a factor (L,) per light; NaN where none sees the point.

        The sums are used up: call it once, at the end.
        """
        for total, missing, factor in zip(self._sums, self._missing, factors, strict=True):
            known = self._counts - missing
            with np.errstate(divide="ignore", invalid="ignore"):
                total *= np.float32(factor) / known
            total[known <= 0] = np.nan
        return self._sums


@njit(cache=True, nogil=True, error_model="numpy", fastmath={"contract", "nsz"})
def add_rows(
    frames: FloatImage,
    height: FloatImage,
    visible: BoolImage,
    cols_per_um: float,
    rows_per_um: float,
    telecentricity_per_um: float,
    gain: np.float32,
    first: int,
    stop: int,
    sums: FloatImage,
    counts: FloatImage,
    missing: NDArray[np.uint8],
) -> None:
    """Add rows ``first`` to ``stop`` of the frames (L, H, W) at ``(row + z rows_per_um, col + z cols_per_um)``.

    The shifts per um are those in the middle of the field.  ``counts`` (H, W) are the views that see a point,
    ``missing`` (L, H, W) those of them that know nothing of it under a light.
    """
    lights, rows, cols = frames.shape
    middle_row, middle_col = 0.5 * (rows - 1), 0.5 * (cols - 1)
    low, right = rows - 1 + SNAP_PX, cols - 1 + SNAP_PX
    one = np.float32(1.0)
    used = np.empty(cols, np.int32)
    upper = np.empty(cols, np.int32)
    left = np.empty(cols, np.int32)
    down = np.empty(cols, np.float32)
    across = np.empty(cols, np.float32)
    for r in range(first, stop):
        count = 0
        for c in range(cols):
            z = height[r, c]
            z /= 1.0 + z * telecentricity_per_um
            y = r + z * (rows_per_um - telecentricity_per_um * (r - middle_row))
            x = c + z * (cols_per_um - telecentricity_per_um * (c - middle_col))
            if (
                y >= -SNAP_PX
                and y <= low
                and x >= -SNAP_PX
                and x <= right
                and visible[r, c]
                and rows > 1
                and cols > 1
            ):
                y0 = min(max(int(y), 0), rows - 2)
                x0 = min(max(int(x), 0), cols - 2)
                used[count] = c
                upper[count] = y0
                left[count] = x0
                down[count] = np.float32(y - y0)
                across[count] = np.float32(x - x0)
                counts[r, c] += one
                count += 1
        for n in range(lights):
            frame = frames[n]
            for i in range(count):
                y0, x0 = upper[i], left[i]
                t, u = across[i], down[i]
                above = frame[y0, x0] + t * (frame[y0, x0 + 1] - frame[y0, x0])
                below = frame[y0 + 1, x0] + t * (frame[y0 + 1, x0 + 1] - frame[y0 + 1, x0])
                value = above + u * (below - above)
                if np.isnan(value):
                    missing[n, r, used[i]] += 1
                else:
                    sums[n, r, used[i]] += gain * value
