"""The sample on the camera's own grid, with a margin, in units of camera pixels."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import cv2
import numpy as np

from reliefscope.units import FloatImage
from reliefscope_sim.scenes.scene import Scene

ALIGNMENT = 4
"""Margins and sizes are multiples of this, so that coarser levels share the grid's corner."""


@dataclass(frozen=True)
class Surface:
    """Height and materials (H', W') on the grid of a frame (H, W) with ``margin`` pixels around it.

    Heights are in pixels of this level (``pixel_um``), slopes ``rise_x``, ``rise_y`` are dz/dx and dz/dy
    with y up.  ``albedo`` and ``specular`` are (C, H', W') with one channel or three; what the maps mean is said
    with :class:`~reliefscope_sim.scenes.scene.Scene`.  Column ``margin + centre_column`` and row
    ``margin + centre_row`` lie on the optical axis.
    """

    pixel_um: float
    frame_shape: tuple[int, int]
    margin: int
    centre_column: float
    centre_row: float
    height_px: FloatImage
    rise_x: FloatImage
    rise_y: FloatImage
    albedo: FloatImage
    specular: FloatImage | None = None
    roughness: FloatImage | None = None
    diffuse_sigma_rad: FloatImage | None = None
    hapke: FloatImage | None = None

    @property
    def lowest_px(self) -> float:
        """Lowest height."""
        return float(self.height_px.min())

    @property
    def highest_px(self) -> float:
        """Highest height."""
        return float(self.height_px.max())

    @property
    def reach_px(self) -> float:
        """Largest distance from the focal plane."""
        return max(abs(self.lowest_px), abs(self.highest_px))

    @cached_property
    def reflectance(self) -> FloatImage:
        """Fraction (C, H', W') of even light from all sides that leaves again, in whatever direction.

        For a Hapke layer Hapke's estimate ``r0 (1 - g / (3 + 3 g))`` with ``g = sqrt(1 - w)``,
        ``r0 = (1 - g) / (1 + g)``.
        """
        if self.specular is None and self.hapke is None:
            return self.albedo
        total = self.albedo
        if self.hapke is not None:
            g = np.sqrt(1 - total)
            spherical = (1 - g) / (1 + g) * (1 - g / (3 + 3 * g))
            total = total + self.hapke * (spherical - total)
        if self.specular is not None:
            total = total + self.specular
        return np.minimum(total, np.float32(1.0))

    @classmethod
    def on_frame(
        cls, scene: Scene, shape: tuple[int, int], pixel_um: float, steepest: float, *, colour: bool
    ) -> Surface:
        """Resample ``scene`` onto a frame; ``steepest`` is the largest lean of a ray that must stay inside.

        Without ``colour``, colours are reduced to the mean of their channels.
        """
        reach_px = float(np.abs(scene.height_um).max()) / pixel_um
        margin = _aligned(int(np.ceil(steepest * reach_px)) + 8)
        grid = (_aligned(shape[0] + 2 * margin), _aligned(shape[1] + 2 * margin))
        scale = pixel_um / scene.pixel_um
        rows, columns = scene.height_um.shape
        centre_row, centre_column = (shape[0] - 1) / 2, (shape[1] - 1) / 2
        warp = np.array(
            [
                [scale, 0.0, (columns - 1) / 2 - scale * (margin + centre_column)],
                [0.0, scale, (rows - 1) / 2 - scale * (margin + centre_row)],
            ]
        )

        def resample(values: FloatImage) -> FloatImage:
            if scale > 1:
                values = as_float_image(cv2.GaussianBlur(values, (0, 0), 0.4 * scale))
            return as_float_image(
                cv2.warpAffine(
                    values,
                    warp,
                    (grid[1], grid[0]),
                    flags=cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP,
                    borderMode=cv2.BORDER_REPLICATE,
                )
            )

        def optional(values: FloatImage | None) -> FloatImage | None:
            return None if values is None else resample(values)

        def planes(values: FloatImage) -> FloatImage:
            channels = values if values.ndim == 3 else values[..., None]
            if not colour:
                channels = channels.mean(axis=2, keepdims=True)
            elif scene.coloured:
                channels = np.broadcast_to(channels, (*channels.shape[:2], 3))
            return np.stack(
                [resample(np.ascontiguousarray(c)) for c in np.moveaxis(channels, 2, 0)]
            )

        height_px: FloatImage = resample(scene.height_um) / np.float32(pixel_um)
        rise_x, rise_y = _slopes(height_px)
        return cls(
            pixel_um=pixel_um,
            frame_shape=shape,
            margin=margin,
            centre_column=centre_column,
            centre_row=centre_row,
            height_px=height_px,
            rise_x=rise_x,
            rise_y=rise_y,
            albedo=planes(scene.albedo),
            specular=None if scene.specular is None else planes(scene.specular),
            roughness=optional(scene.roughness),
            diffuse_sigma_rad=optional(scene.diffuse_sigma_rad),
            hapke=optional(scene.hapke),
        )

    def coarser(self, factor: int) -> Surface:
        """The same surface with pixels ``factor`` (2 or 4) times as large, block means of this one."""

        def shrink(values: FloatImage) -> FloatImage:
            return block_mean(values, factor)

        def optional(values: FloatImage | None) -> FloatImage | None:
            return None if values is None else shrink(values)

        def planes(values: FloatImage) -> FloatImage:
            return np.stack([shrink(channel) for channel in values])

        height_px: FloatImage = shrink(self.height_px) / np.float32(factor)
        rise_x, rise_y = _slopes(height_px)
        rows, columns = self.frame_shape
        return Surface(
            pixel_um=self.pixel_um * factor,
            frame_shape=(-(-rows // factor), -(-columns // factor)),
            margin=self.margin // factor,
            centre_column=(self.centre_column + 0.5) / factor - 0.5,
            centre_row=(self.centre_row + 0.5) / factor - 0.5,
            height_px=height_px,
            rise_x=rise_x,
            rise_y=rise_y,
            albedo=planes(self.albedo),
            specular=None if self.specular is None else planes(self.specular),
            roughness=optional(self.roughness),
            diffuse_sigma_rad=optional(self.diffuse_sigma_rad),
            hapke=optional(self.hapke),
        )


def block_mean(values: FloatImage, factor: int) -> FloatImage:
    """Means of ``factor`` x ``factor`` blocks of an array whose sides are multiples of it."""
    rows, columns = values.shape
    return as_float_image(
        cv2.resize(values, (columns // factor, rows // factor), interpolation=cv2.INTER_AREA)
    )


def as_float_image(values: object) -> FloatImage:
    """What an OpenCV function returned, with its type stated."""
    return np.asarray(values, dtype=np.float32)


def _aligned(size: int) -> int:
    return -(-size // ALIGNMENT) * ALIGNMENT


def _slopes(height_px: FloatImage) -> tuple[FloatImage, FloatImage]:
    """(dz/dx, dz/dy) by central differences, y up."""
    down, across = np.gradient(height_px)
    return as_float_image(across), as_float_image(-down)
