"""Light on a surface, and off it: shadows of each LED, what surfaces give each other, radiance to the viewer."""

from __future__ import annotations

import math
from dataclasses import dataclass

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

LED_DIAMETER_MM = 2.0
"""Bright part of the lens of a 3 mm LED (assumed); it sets the soft edge of shadows."""
_DIRECTIONS = 48
_BOUNCES = 2


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
        self._reflectance: FloatImage = np.ascontiguousarray(np.moveaxis(surface.reflectance, 0, 2))
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
        """Light (C, H'/4, W'/4) that surfaces give each other, each reflecting evenly to all sides."""
        rows, columns, _ = self._hits.shape
        shape = (rows, columns, self._reflectance.shape[2])
        between: FloatImage = np.zeros(shape, dtype=np.float32)
        for _ in range(_BOUNCES):
            received: FloatImage = np.empty(shape, dtype=np.float32)
            collect(direct, between, self._reflectance, self._hits, received)
            between = received
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


def _neighbours(surface: Surface, ceilings: FloatImage) -> NDArray[np.int32]:
    """For each cell, the pixels that it sees in directions that are spread as the cosine about its normal."""
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
    return hits
