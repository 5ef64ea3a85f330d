"""Frames of all views brought to the view s = 0 by the height and averaged, light by light, in one pass.

The same sums as :func:`~reliefscope.reconstruction.registration.to_reference` and a mean, without an array per
view: where a pixel lies in a view, and how its neighbours weigh, is worked out once for all lights.  The lights of a
pixel lie side by side in memory meanwhile, so that one vector instruction interpolates many of them.
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
        self._sums = np.zeros((*height_um.shape, lights), np.float32)
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
        rows, columns = self._height.shape
        if rows < 2 or columns < 2:
            return  # nothing to interpolate between
        cols_per_um, rows_per_um = apparent_shift_px(1.0, slope, self._pixel_um)
        seen = np.ones(self._height.shape, np.bool_) if visible is None else visible

        def work(strip: tuple[int, int]) -> None:
            add_rows(
                frames,
                self._height,
                seen,
                cols_per_um,
                rows_per_um,
                self._telecentricity_per_um,
                np.float32(gain),
                *strip,
                self._sums,
                self._counts,
                self._missing,
            )

        strips = tiles.spans(rows, STRIP_ROWS)
        with ensure_job(job).stage("register", len(strips)) as stage:
            tiles.run_each(work, strips, stage)

    def mean(self, factors: NDArray[np.float64]) -> FloatImage:
        """Mean over the views (L, H, W), times a factor (L,) per light; NaN where none sees the point."""
        rows, columns, lights = self._sums.shape
        out = np.empty((lights, rows, columns), np.float32)
        scale = factors.astype(np.float32)

        def work(strip: tuple[int, int]) -> None:
            divide_rows(self._sums, self._counts, self._missing, scale, *strip, out)

        strips = tiles.spans(rows, STRIP_ROWS)
        with ensure_job(None).stage("register", len(strips)) as stage:
            tiles.run_each(work, strips, stage)
        return out

    @property
    def incomplete(self) -> BoolImage:
        """Points (H, W) of which some view knew nothing under some light, although it sees them."""
        points: BoolImage = self._missing.max(axis=-1) > 0
        return points


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

    The shifts per um are those in the middle of the field.  ``sums`` (H, W, L) gather the values, ``counts`` (H, W)
    the views that see a point, ``missing`` (H, W, L) those of them that know nothing of it under a light.
    """
    lights, rows, cols = frames.shape
    middle_row, middle_col = 0.5 * (rows - 1), 0.5 * (cols - 1)
    low, right = rows - 1 + SNAP_PX, cols - 1 + SNAP_PX
    one, none = np.float32(1.0), np.float32(0.0)
    shape = (stop - first, cols)
    upper = np.empty(shape, np.int32)
    left = np.empty(shape, np.int32)
    down = np.empty(shape, np.float32)
    across = np.empty(shape, np.float32)
    top, bottom = rows, 0
    for i in range(stop - first):
        r = first + i
        for c in range(cols):
            z = height[r, c]
            z /= 1.0 + z * telecentricity_per_um
            y = r + z * (rows_per_um - telecentricity_per_um * (r - middle_row))
            x = c + z * (cols_per_um - telecentricity_per_um * (c - middle_col))
            left[i, c] = -1
            if y >= -SNAP_PX and y <= low and x >= -SNAP_PX and x <= right and visible[r, c]:
                y0 = min(max(int(y), 0), rows - 2)
                x0 = min(max(int(x), 0), cols - 2)
                upper[i, c] = y0
                left[i, c] = x0
                down[i, c] = np.float32(y - y0)
                across[i, c] = np.float32(x - x0)
                counts[r, c] += one
                top, bottom = min(top, y0), max(bottom, y0 + 1)
    # the rows that are read, light by light for each pixel
    part = np.empty((max(bottom + 1 - top, 0), cols, lights), np.float32)
    for i in range(len(part)):
        line = part[i]
        for n in range(lights):
            source = frames[n, top + i]
            for c in range(cols):
                line[c, n] = source[c]
    for i in range(stop - first):
        r = first + i
        for c in range(cols):
            x0 = left[i, c]
            if x0 < 0:
                continue
            y0 = upper[i, c] - top
            t, u = across[i, c], down[i, c]
            above_left, above_right = part[y0, x0], part[y0, x0 + 1]
            below_left, below_right = part[y0 + 1, x0], part[y0 + 1, x0 + 1]
            total, unknown = sums[r, c], missing[r, c]
            for n in range(lights):
                above = above_left[n] + t * (above_right[n] - above_left[n])
                below = below_left[n] + t * (below_right[n] - below_left[n])
                value = above + u * (below - above)
                lost = np.isnan(value)
                total[n] += none if lost else gain * value
                unknown[n] += np.uint8(lost)


@njit(cache=True, nogil=True, error_model="numpy")
def divide_rows(
    sums: FloatImage,
    counts: FloatImage,
    missing: NDArray[np.uint8],
    factors: NDArray[np.float32],
    first: int,
    stop: int,
    out: FloatImage,
) -> None:
    """Rows ``first`` to ``stop`` of ``out`` (L, H, W): the sums (H, W, L) over their number, times ``factors`` (L,)."""
    _, cols, lights = sums.shape
    for r in range(first, stop):
        for n in range(lights):
            for c in range(cols):
                known = counts[r, c] - np.float32(missing[r, c, n])
                out[n, r, c] = factors[n] / known * sums[r, c, n] if known > 0 else np.nan
