"""Images of a lit surface through sets of glass pixels: parallax, occlusion, defocus, diffraction.

An image is a sum over points of the pupil.  The geometry of a point, the height at which the ray of every
pixel first meets the surface, depends on the point alone; it is found once per aperture and used for every
light.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from reliefscope.models.instrument import Optics
from reliefscope.units import UM_PER_MM, FloatImage
from reliefscope_sim.as_built import AsBuilt
from reliefscope_sim.optics.cache import ByteCache
from reliefscope_sim.optics.pupil import PupilPoints
from reliefscope_sim.optics.ray_kernels import (
    DEPTH_LEVELS,
    DepthStack,
    blur,
    blur_to_mosaic,
    gather,
    gaussian_taps,
    intersect,
)
from reliefscope_sim.optics.surface import Surface, as_float_image

AIRY_SIGMA = 0.42
"""Standard deviation of the Gaussian nearest to an Airy disc, in units of lambda f_o / d (eq. 2)."""
_APART_OF_SPOT = 1.5
"""Points of the pupil may lie so far apart that their images part by this many standard deviations of the spot:
their sum is then even to 2 exp(-2 pi^2 / 1.5^2), 0.3 per mille..."""
_LEAST_APART_PX = 2.0
"""...or by this much, where the spot is smaller than a pixel."""
_BATCH = 8

Shader = Callable[[NDArray[np.float64]], FloatImage]
"""Radiance (C, H', W') of the surface for rays of one slope (2,)."""


@dataclass(frozen=True)
class _Batch:
    """Some points of an aperture that share one direction for gloss, with their geometry."""

    lean: NDArray[np.float64]
    slopes: FloatImage
    weights: FloatImage
    depth: DepthStack


class Viewer:
    """Sees one surface through the optics as they really are."""

    def __init__(
        self,
        surface: Surface,
        optics: Optics,
        as_built: AsBuilt,
        gloss_cell_mm: float,
        cache_bytes: int,
    ) -> None:
        self.surface = surface
        self._optics = optics
        self._focal_mm = as_built.pupil_scale * optics.objective_focal_mm
        self._kappa_per_px = as_built.telecentricity_per_mm * surface.pixel_um / UM_PER_MM
        self._gloss_cell_mm = gloss_cell_mm
        self._centre: FloatImage = np.array(
            [surface.centre_column, surface.centre_row], dtype=np.float32
        )
        span = surface.highest_px - surface.lowest_px
        self._depth_step = max(span, 1e-3) / DEPTH_LEVELS
        self._batches: ByteCache[list[_Batch]] = ByteCache(
            cache_bytes, lambda batches: sum(batch.depth.nbytes for batch in batches)
        )
        self._bounds: dict[int, tuple[FloatImage, FloatImage, FloatImage]] = {}

    def spacing_mm(self, points: PupilPoints) -> float:
        """Distance of pupil points at which diffraction still hides that their images part."""
        apart_px = max(_LEAST_APART_PX, _APART_OF_SPOT * float(self._spot_px(points).min()))
        return apart_px * self._focal_mm / max(self.surface.reach_px, 1e-3)

    def image(self, key: bytes, points: PupilPoints, shader: Shader) -> FloatImage:
        """Image (C, H, W) through ``points``, which ``key`` names: radiance times open area in mm^2."""
        return self._blurred(self._sharp(key, points, shader), points)

    def mosaic(self, key: bytes, points: PupilPoints, shader: Shader) -> FloatImage:
        """The same, (H, W): of a coloured image each pixel has the channel that its RGGB filter passes."""
        sharp = self._sharp(key, points, shader)
        if len(sharp) == 1:
            return as_float_image(self._blurred(sharp, points)[0])
        mosaic: FloatImage = np.empty(sharp.shape[1:], dtype=np.float32)
        blur_to_mosaic(sharp, *self._taps(points), mosaic)
        return mosaic

    def _blurred(self, sharp: FloatImage, points: PupilPoints) -> FloatImage:
        blurred: FloatImage = np.empty_like(sharp)
        blur(sharp, *self._taps(points), blurred)
        return blurred

    def _sharp(self, key: bytes, points: PupilPoints, shader: Shader) -> FloatImage:
        """Image (C, H, W) before diffraction."""
        rows, columns = self.surface.frame_shape
        total: FloatImage = np.zeros((len(self.surface.albedo), rows, columns), dtype=np.float32)
        lean: NDArray[np.float64] | None = None
        for batch in self._batches.get(key, lambda: self._trace(points)):
            if lean is None or not np.array_equal(lean, batch.lean):
                lean = batch.lean
                radiance = shader(lean)
            gather(
                radiance,
                batch.depth,
                batch.slopes,
                batch.weights,
                self._kappa_per_px,
                self._centre,
                self.surface.margin,
                self.surface.lowest_px,
                self._depth_step,
                total,
            )
        return total

    def _trace(self, points: PupilPoints) -> list[_Batch]:
        """Geometry of every point, in batches of one direction for gloss."""
        groups = [points] if self._gloss_cell_mm == 0 else points.clusters(self._gloss_cell_mm)
        batches = []
        for group in groups:
            if not len(group):
                continue
            lean = group.centroid_mm / self._focal_mm
            for start in range(0, len(group), _BATCH):
                slopes = group.position_mm[start : start + _BATCH] / self._focal_mm
                batches.append(
                    _Batch(
                        lean,
                        slopes.astype(np.float32),
                        group.area_mm2[start : start + _BATCH].astype(np.float32),
                        self._intersections(slopes),
                    )
                )
        return batches

    def _intersections(self, slopes: NDArray[np.float64]) -> DepthStack:
        surface = self.surface
        rows, columns = surface.frame_shape
        depth = np.empty((len(slopes), rows, columns), dtype=np.uint16)
        steepest = float(np.hypot(slopes[:, 0], slopes[:, 1]).max()) + abs(
            self._kappa_per_px
        ) * math.hypot(rows, columns)
        high, low, rise = self._bounds_within(math.ceil(steepest * surface.reach_px) + 1)
        intersect(
            surface.height_px,
            high,
            low,
            rise,
            slopes.astype(np.float32),
            self._kappa_per_px,
            self._centre,
            surface.margin,
            surface.lowest_px,
            self._depth_step,
            depth,
        )
        return depth

    def _bounds_within(self, reach: int) -> tuple[FloatImage, FloatImage, FloatImage]:
        """Highest and lowest height and largest change per pixel within ``reach`` pixels of each pixel.

        The last answer is kept: apertures at one distance from the axis ask for the same.
        """
        if reach not in self._bounds:
            kernel = np.ones((2 * reach + 1, 2 * reach + 1), dtype=np.uint8)
            height = self.surface.height_px
            across = np.abs(np.diff(height, axis=1, append=height[:, -1:]))
            down = np.abs(np.diff(height, axis=0, append=height[-1:]))
            self._bounds = {
                reach: (
                    as_float_image(cv2.dilate(height, kernel)),
                    as_float_image(cv2.erode(height, kernel)),
                    as_float_image(cv2.dilate(np.hypot(across, down), kernel)),
                )
            }
        return self._bounds[reach]

    def _spot_px(self, points: PupilPoints) -> NDArray[np.float64]:
        """Standard deviation (2,) along x and y of the spot of eq. 2, that of a disc as spread as the points.

        A disc of diameter d has a standard deviation of d / 4 along any axis.
        """
        diameter_mm = 4 * np.sqrt(np.diag(points.covariance_mm2))
        spot_um = self._optics.wavelength_um * self._focal_mm / diameter_mm
        spot: NDArray[np.float64] = AIRY_SIGMA * spot_um / self.surface.pixel_um
        return spot

    def _taps(self, points: PupilPoints) -> tuple[FloatImage, FloatImage]:
        """Blur by diffraction along x and y, for :func:`blur`."""
        spot_px = self._spot_px(points)
        return gaussian_taps(float(spot_px[0])), gaussian_taps(float(spot_px[1]))
