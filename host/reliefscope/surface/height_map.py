"""A height map on a regular grid, with what has to be done before anything can be made of it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np

from reliefscope.axes import pixel_grid_um
from reliefscope.errors import InvalidInputError
from reliefscope.units import FloatImage


@dataclass(frozen=True)
class HeightMap:
    """Heights (H, W) in um, row 0 on top, NaN where nothing was measured.

    ``pixel_um`` is the distance of neighbouring points along x and along y.

    Raises
    ------
    InvalidInputError
        No two-dimensional array of at least 2 x 2 points, no height at all, infinite heights, or a pixel size
        that is none.
    """

    height_um: FloatImage
    pixel_um: tuple[float, float]
    name: str

    def __post_init__(self) -> None:
        heights = self.height_um
        if heights.ndim != 2 or min(heights.shape) < 2:
            raise InvalidInputError(
                f"`{self.name}` is no height map: its shape is {heights.shape}.",
                hint="A height map has rows and columns, at least two of each.",
            )
        if not np.isfinite(heights).any() or np.isinf(heights).any():
            raise InvalidInputError(
                f"`{self.name}` has infinite heights, or none at all.",
                hint="Mark points without a height as NaN, and check that the file is the right one.",
            )
        if not (np.isfinite(self.pixel_um).all() and min(self.pixel_um) > 0):
            raise InvalidInputError(
                f"`{self.name}` has points {self.pixel_um} um apart.",
                hint="Give the pixel size, or the true width, in um and above 0.",
            )

    @property
    def width_um(self) -> float:
        """Extent along x."""
        return float(self.height_um.shape[1] * self.pixel_um[0])

    @property
    def missing(self) -> float:
        """Share of points without a height."""
        return float(np.isnan(self.height_um).mean())

    def widened(self, width_um: float) -> HeightMap:
        """The same with another extent along x; along y it grows in proportion, heights stay."""
        factor = width_um / self.width_um
        return replace(self, pixel_um=(factor * self.pixel_um[0], factor * self.pixel_um[1]))

    def filled(self) -> HeightMap:
        """The same with smooth patches where heights were missing; known heights stay.

        Push-pull (Gortler et al. 1996): means of what is known over ever larger blocks, of which the smallest
        that knows anything is taken, interpolated linearly.
        """
        known = np.isfinite(self.height_um)
        if known.all():
            return self
        patches = _push_pull(
            np.where(known, self.height_um, 0.0).astype(np.float32), known.astype(np.float32)
        )
        return replace(self, height_um=np.where(known, self.height_um, patches))

    def levelled(self) -> HeightMap:
        """The same without the plane that fits the known heights best (least squares)."""
        rows, columns = self.height_um.shape
        x_um, y_um = np.arange(columns) * self.pixel_um[0], -np.arange(rows) * self.pixel_um[1]
        known = np.isfinite(self.height_um)
        design = np.stack(
            [
                np.broadcast_to(x_um - x_um.mean(), known.shape)[known],
                np.broadcast_to((y_um - y_um.mean())[:, None], known.shape)[known],
                np.ones(known.sum()),
            ],
            axis=1,
        )
        (rise_x, rise_y, mean), *_ = np.linalg.lstsq(design, self.height_um[known], rcond=None)
        plane = rise_x * (x_um - x_um.mean()) + rise_y * (y_um - y_um.mean())[:, None] + mean
        return replace(self, height_um=(self.height_um - plane).astype(np.float32))

    def resampled(self, shape: tuple[int, int], pixel_um: float) -> FloatImage:
        """Heights (H, W) on square pixels about the middle of the map, interpolated linearly.

        Where the grid is wider than the map, the map goes on mirrored at its edges, without a step.  Larger
        pixels than the map's average over what they cover.  NaN spreads to its neighbours: fill first.
        """
        rows, columns = self.height_um.shape
        heights: FloatImage = self.height_um
        sigma = [0.4 * max(pixel_um / own, 0.0) for own in self.pixel_um]
        if max(sigma) > 0.4:
            smooth = cv2.GaussianBlur(
                heights, (0, 0), sigmaX=max(sigma[0], 1e-3), sigmaY=max(sigma[1], 1e-3)
            )
            heights = np.asarray(smooth, dtype=np.float32)
        x_um, y_um = pixel_grid_um(shape, pixel_um)
        across = _mirrored(x_um / self.pixel_um[0] + (columns - 1) / 2, columns)
        down = _mirrored((rows - 1) / 2 - y_um / self.pixel_um[1], rows)
        return _interpolated(heights, down, across)


def _mirrored(place: np.ndarray[tuple[int], np.dtype[np.float64]], count: int) -> FloatImage:
    """Places in pixels folded back into 0 to ``count - 1``."""
    period = 2 * (count - 1)
    folded = np.abs((place + period / 2) % period - period / 2)
    return folded.astype(np.float32)


def _interpolated(values: FloatImage, rows: FloatImage, columns: FloatImage) -> FloatImage:
    """Bilinear values on the grid of ``rows`` (H,) and ``columns`` (W,)."""
    first = np.minimum(columns.astype(np.intp), values.shape[1] - 2)
    part = (columns - first).astype(np.float32)
    across = values[:, first] * (1 - part) + values[:, first + 1] * part
    first = np.minimum(rows.astype(np.intp), values.shape[0] - 2)
    part = (rows - first).astype(np.float32)[:, None]
    between: FloatImage = across[first] * (1 - part) + across[first + 1] * part
    return between


def _push_pull(values: FloatImage, weight: FloatImage) -> FloatImage:
    """``values`` where ``weight`` is 1; elsewhere what blocks of twice, four times ... the size know."""
    rows, columns = values.shape
    if (weight > 0).all():
        return values
    padded = ((0, rows % 2), (0, columns % 2))
    own = np.pad(weight, padded)
    total = _blocks(np.pad(values * weight, padded))
    known = _blocks(own)
    means = np.where(known > 0, total / np.maximum(known, 1e-6), 0.0).astype(np.float32)
    coarse = _push_pull(means, np.minimum(known, 1.0).astype(np.float32))
    patches = cv2.resize(coarse, (own.shape[1], own.shape[0]), interpolation=cv2.INTER_LINEAR)[
        :rows, :columns
    ]
    filled: FloatImage = (weight * values + (1 - weight) * patches).astype(np.float32)
    return filled


def _blocks(values: FloatImage) -> FloatImage:
    """Sums over blocks of 2 x 2."""
    rows, columns = values.shape
    total: FloatImage = values.reshape(rows // 2, 2, columns // 2, 2).sum(axis=(1, 3))
    return total
