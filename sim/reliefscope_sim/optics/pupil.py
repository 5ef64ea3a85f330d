"""From pixels of the glass to points of the pupil, in millimetres.

This is the simulated instrument's own geometry: it starts from pixel indices, pitch and the as-built place
of the glass, and shares no function with the host, so that an error of sign on either side shows.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from reliefscope.models.instrument import InstrumentProfile
from reliefscope.units import BoolImage
from reliefscope_sim.as_built import AsBuilt

_SUBDIVISIONS = 8
_EXACT_POINTS = 16
"""Up to so many points an aperture keeps each pixel as its own point."""
_MOST_POINTS = 32
"""More are merged even where their images part visibly, far outside the depth of field."""

_CORNERS = np.array([(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)])


@dataclass(frozen=True)
class PupilPoints:
    """Points (K, 2) in mm in the pupil and the open area (K,) in mm^2 that each stands for.

    ``cell_mm`` are the sides of the rectangle that a point stands for; a square of its area where absent.
    """

    position_mm: NDArray[np.float64]
    area_mm2: NDArray[np.float64]
    cell_mm: tuple[float, float] | None = None

    def __len__(self) -> int:
        return len(self.area_mm2)

    @property
    def centroid_mm(self) -> NDArray[np.float64]:
        """Mean position (2,), weighted by area."""
        centroid: NDArray[np.float64] = (self.area_mm2 @ self.position_mm) / self.area_mm2.sum()
        return centroid

    @property
    def covariance_mm2(self) -> NDArray[np.float64]:
        """Covariance (2, 2) of the open area, the extent of each cell included."""
        offset = self.position_mm - self.centroid_mm
        side = math.sqrt(float(self.area_mm2.mean()))
        cell = np.diag(np.square(self.cell_mm or (side, side)) / 12)
        covariance: NDArray[np.float64] = (
            self.area_mm2 * offset.T
        ) @ offset / self.area_mm2.sum() + cell
        return covariance

    def condensed(self) -> PupilPoints:
        """Four points with the area, centroid and covariance of all: Gauss's rule of two points per axis."""
        variance, axes = np.linalg.eigh(self.covariance_mm2)
        corners = _CORNERS * np.sqrt(np.maximum(variance, 0))
        return PupilPoints(
            self.centroid_mm + corners @ axes.T, np.full(4, self.area_mm2.sum() / 4), (0.0, 0.0)
        )

    def clusters(self, cell_mm: float) -> list[PupilPoints]:
        """The same points in groups that fit into cells of at most ``cell_mm``, evenly over their extent."""
        low, extent = self.position_mm.min(axis=0), np.ptp(self.position_mm, axis=0)
        count = np.maximum(np.ceil(extent / cell_mm), 1)
        cells = np.minimum((self.position_mm - low) / np.maximum(extent, 1e-9) * count, count - 1)
        cells = cells.astype(int)
        _, group = np.unique(cells, axis=0, return_inverse=True)
        group = group.ravel()
        return [
            PupilPoints(
                self.position_mm[group == index], self.area_mm2[group == index], self.cell_mm
            )
            for index in range(group.max() + 1)
        ]

    def merged(self, cell_mm: float) -> PupilPoints:
        """One point per cell, at its centroid, with the area of all its points."""
        parts = self.clusters(cell_mm)
        return PupilPoints(
            np.array([part.centroid_mm for part in parts]),
            np.array([part.area_mm2.sum() for part in parts]),
        )


class Pupil:
    """The glass as it sits in the round pupil of the objective.

    ``area_mm2`` (64, 128) is the part of every glass pixel that lies inside the pupil: what the rim cuts off
    is vignetted.
    """

    def __init__(self, profile: InstrumentProfile, as_built: AsBuilt) -> None:
        glass = profile.glass
        part = (np.arange(_SUBDIVISIONS) + 0.5) / _SUBDIVISIONS - 0.5
        column = np.arange(glass.columns)[:, None] + part[None, :]
        row = np.arange(glass.rows)[:, None] + part[None, :]
        x = (column - (glass.columns - 1) / 2) * glass.pitch_x_mm
        y = ((glass.rows - 1) / 2 - row) * glass.pitch_y_mm
        grid_x, grid_y = x[None, :, None, :], y[:, None, :, None]
        cos, sin = math.cos(as_built.glass_rotation_rad), math.sin(as_built.glass_rotation_rad)
        self._x_mm = cos * grid_x - sin * grid_y + as_built.glass_offset_mm[0]
        self._y_mm = sin * grid_x + cos * grid_y + as_built.glass_offset_mm[1]
        radius = profile.optics.pupil_diameter_mm / 2
        self._inside = self._x_mm**2 + self._y_mm**2 <= radius**2
        self._cell_mm2 = glass.pitch_x_mm * glass.pitch_y_mm / _SUBDIVISIONS**2
        self._pitches_mm = (glass.pitch_x_mm, glass.pitch_y_mm)
        self.area_mm2: NDArray[np.float64] = self._inside.sum(axis=(2, 3)) * self._cell_mm2
        covered = (glass.pitch_x_mm - glass.gap_mm) * (glass.pitch_y_mm - glass.gap_mm)
        self.fill_factor = max(0.0, covered / (glass.pitch_x_mm * glass.pitch_y_mm))
        """Part of a glass pixel that switches; the gap around it always leaks."""

    def pixels(self, mask: BoolImage) -> PupilPoints:
        """One point for every pixel of ``mask`` (64, 128), in the middle of what the rim leaves of it."""
        return self._divided(mask, 1)

    def points(self, mask: BoolImage, spacing_mm: float) -> PupilPoints:
        """Points that stand for the pixels of ``mask`` (64, 128), no further apart than ``spacing_mm``.

        An aperture as small as that is condensed to four points.  Otherwise pixels larger than it are divided,
        and many pixels smaller than it are merged.  There are never many more than 32 points, which bounds time
        and memory whatever the height of the sample.
        """
        pixels = self.pixels(mask)
        if len(pixels) > len(_CORNERS):
            condensed = pixels.condensed()
            if np.ptp(condensed.position_mm, axis=0).max() <= spacing_mm:
                return condensed
        spacing_mm = max(spacing_mm, math.sqrt(float(self.area_mm2[mask].sum()) / _MOST_POINTS))
        split = 1
        while max(self._pitches_mm) / split > spacing_mm and split < _SUBDIVISIONS:
            split *= 2
        points = self._divided(mask, split)
        if len(points) > _EXACT_POINTS:
            points = points.merged(spacing_mm)
        return points

    def _divided(self, mask: BoolImage, split: int) -> PupilPoints:
        """One point for each of ``split`` x ``split`` parts of every pixel that lie within the pupil."""
        rows, columns = np.nonzero(mask & (self.area_mm2 > 0))
        run = _SUBDIVISIONS // split
        blocks = (len(rows), split, run, split, run)
        inside = self._inside[rows, columns].reshape(blocks)
        count = inside.sum(axis=(2, 4))
        x = (self._x_mm[rows, columns].reshape(blocks) * inside).sum(axis=(2, 4))
        y = (self._y_mm[rows, columns].reshape(blocks) * inside).sum(axis=(2, 4))
        kept = count > 0
        position = np.stack([x[kept], y[kept]], axis=-1) / count[kept][:, None]
        side_x, side_y = self._pitches_mm
        return PupilPoints(position, count[kept] * self._cell_mm2, (side_x / split, side_y / split))
