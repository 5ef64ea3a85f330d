"""Light on a surface, and off it: shadows of each LED, what surfaces give each other, radiance to the viewer."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TypeVar

import cv2
import numpy as np
from numpy.typing import NDArray

from reliefscope.models.instrument import Dome
from reliefscope.units import UM_PER_MM, FloatImage
from reliefscope_sim.as_built import AsBuilt
from reliefscope_sim.optics.light_kernels import (
    STRIDES_PX,
    collect,
    find_neighbours,
    irradiance,
)
from reliefscope_sim.optics.shading_kernels import shade
from reliefscope_sim.optics.surface import ALIGNMENT, Surface, as_float_image, block_mean

_Value = TypeVar("_Value", np.float32, np.int32)

LED_DIAMETER_MM = 2.0
"""Bright part of the lens of a 3 mm LED (assumed); it sets the soft edge of shadows."""
_DIRECTIONS = 48
_CELL_BITS = 4
"""A cell of the light between surfaces has 2^4 pixels."""


@dataclass(frozen=True)
class LitSurface:
    """A surface under one LED of energy 1: irradiance relative to normal incidence on the LED's axis.

    ``direct`` (H', W') comes from the LED, ``between`` (C, H'/r, W'/r) from other surfaces; that varies
    slowly and is kept on a coarser grid.
    """

    direct: FloatImage
    between: FloatImage

    @property
    def nbytes(self) -> int:
        """Memory that it takes."""
        return self.direct.nbytes + self.between.nbytes

    def coarser(self, factor: int) -> LitSurface:
        """The same light on a grid with larger pixels."""
        return LitSurface(block_mean(self.direct, factor), self.between)


class Lighting:
    """Illumination of one surface by the LEDs as they really are."""

    def __init__(self, surface: Surface, dome: Dome, as_built: AsBuilt) -> None:
        self._surface = surface
        self._as_built = as_built
        self._reference_px = dome.radius_mm * UM_PER_MM / surface.pixel_um
        self._beam_exponent = math.log(0.5) / math.log(math.cos(math.radians(dome.half_angle_deg)))
        self._source_radius = LED_DIAMETER_MM / 2 / dome.radius_mm
        self._reflectance: FloatImage = np.stack(
            [_by_cells(plane) for plane in surface.reflectance], axis=-1
        )
        per_cell = self._reflectance.reshape(-1, 1 << _CELL_BITS, self._reflectance.shape[1])
        self._cell_reflectance: FloatImage = per_cell.mean(axis=1)
        boxes = (np.ones((2 * stride + 3,) * 2, dtype=np.uint8) for stride in STRIDES_PX)
        self._ceilings = np.stack(
            [as_float_image(cv2.dilate(surface.height_px, box)) for box in boxes]
        )
        self._hits = _neighbours(surface, self._ceilings)

    def led_px(self, led: int, pixel_um: float) -> FloatImage:
        """Position (3,) of an LED in pixels from the focal point."""
        position: NDArray[np.float64] = self._as_built.led_positions_mm[led] * UM_PER_MM / pixel_um
        return position.astype(np.float32)

    def lit_by(self, led: int) -> LitSurface:
        """The surface under one LED; its as-built intensity is included."""
        surface = self._surface
        direct: FloatImage = np.empty_like(surface.height_px)
        irradiance(
            surface.height_px,
            self._ceilings,
            surface.rise_x,
            surface.rise_y,
            optical_axis(surface),
            self.led_px(led, surface.pixel_um),
            self._reference_px,
            self._beam_exponent,
            self._source_radius,
            surface.highest_px,
            direct,
        )
        direct *= np.float32(self._as_built.led_intensities[led])
        return LitSurface(direct, self._from_other_surfaces(direct))

    def _from_other_surfaces(self, direct: FloatImage) -> FloatImage:
        """Light (C, H'/4, W'/4) that came from the LED by way of one other surface or two.

        Each reflects evenly to all sides, a mirror too.  What a pixel of a wall sends on is its own light; the
        second time it is the mean of its cell's.
        """
        between: FloatImage = np.zeros(
            self._hits.shape[:2] + self._reflectance.shape[1:], np.float32
        )
        collect(self._reflectance * _by_cells(direct)[:, None], self._hits, 0, between)
        once = between.reshape(self._cell_reflectance.shape)
        collect(self._cell_reflectance * once, self._hits, _CELL_BITS, between)
        return np.stack(
            [cv2.GaussianBlur(plane, (0, 0), 0.8) for plane in np.moveaxis(between, 2, 0)]
        )

    def add_radiance(
        self,
        surface: Surface,
        lit: LitSurface,
        led: int,
        lean: NDArray[np.float64],
        share: float,
        radiance: FloatImage,
    ) -> None:
        """Add ``share`` of what ``surface`` sends along a ray of slope ``lean`` (2,) to ``radiance`` (C, H', W').

        ``surface`` is the one of these lights, or a coarser form of it, under the LED as in ``lit``.
        """
        view = np.array([lean[0], lean[1], 1.0])
        shade(
            lit.direct,
            lit.between,
            surface.rise_x,
            surface.rise_y,
            surface.albedo,
            surface.reflectance,
            (_or_none(surface.specular, 3), _or_none(surface.roughness, 2)),
            _or_none(surface.diffuse_sigma_rad, 2),
            _or_none(surface.hapke, 2),
            self._source_radius**2 / 8,
            optical_axis(surface),
            self.led_px(led, surface.pixel_um),
            (view / np.linalg.norm(view)).astype(np.float32),
            share,
            radiance,
        )


def _or_none(values: FloatImage | None, axes: int) -> FloatImage:
    """A map, or an empty array where there is none."""
    return np.empty((0,) * axes, dtype=np.float32) if values is None else values


def optical_axis(surface: Surface) -> FloatImage:
    """(column, row) of the optical axis in the arrays of a surface."""
    return np.array(
        [surface.margin + surface.centre_column, surface.margin + surface.centre_row],
        dtype=np.float32,
    )


def _by_cells(values: NDArray[_Value]) -> NDArray[_Value]:
    """Pixels (H', W') in a row (H' W'), cell after cell of 4 x 4."""
    rows, columns = values.shape
    blocks = values.reshape(rows // ALIGNMENT, ALIGNMENT, columns // ALIGNMENT, ALIGNMENT)
    return np.ascontiguousarray(blocks.transpose(0, 2, 1, 3)).reshape(-1)


def _neighbours(surface: Surface, ceilings: FloatImage) -> NDArray[np.int32]:
    """For each cell, the pixels that it sees in directions that are spread as the cosine about its normal.

    Pixels are counted as :func:`_by_cells` puts them; -1 is the open sky.
    """
    index = np.arange(_DIRECTIONS)
    radius = np.sqrt((index + 0.5) / _DIRECTIONS)
    azimuth = index * math.pi * (3 - math.sqrt(5))
    directions = np.stack(
        [radius * np.cos(azimuth), radius * np.sin(azimuth), np.sqrt(1 - radius**2)], axis=-1
    ).astype(np.float32)
    rows, columns = surface.height_px.shape
    hits = np.empty((rows // ALIGNMENT, columns // ALIGNMENT, _DIRECTIONS), dtype=np.int32)
    find_neighbours(
        surface.height_px,
        ceilings,
        surface.rise_x,
        surface.rise_y,
        directions,
        surface.highest_px,
        hits,
    )
    places = np.arange(rows * columns, dtype=np.int32).reshape(rows, columns)
    order = np.empty(rows * columns, dtype=np.int32)
    order[_by_cells(places)] = places.reshape(-1)
    np.copyto(hits, order[hits], where=hits >= 0)
    return hits
