"""What lies under the simulated microscope: a height map and what it is made of."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from reliefscope.errors import InvalidInputError
from reliefscope.units import FloatImage

MARGIN_PX = 32
"""Sample around the frame that a built-in scene provides, in frame pixels on each side."""
_ENERGY_TOLERANCE = 1e-3


@dataclass(frozen=True)
class Scene:
    """Height map and materials on one grid (H', W'); its middle lies on the optical axis, y up.

    Every map is float32 on the grid of ``height_um`` (um, counted from the focal plane), so that each grain,
    and each pixel of it, may be another material.  Colours are linear RGB; a map without colour holds for all
    channels.  Around the grid the sample goes on as its edge does.

    ==================  ==================  ===========================================================
    Map                 Shape               Meaning
    ==================  ==================  ===========================================================
    albedo              (H', W'[, 3])       diffuse part, 0 to 1: the share of light from straight above
                                            that comes back diffusely; where ``hapke``, the
                                            single-scattering albedo w of a grain of the layer
    specular            (H', W'[, 3])       reflectance F0 of the facets at normal incidence, 0 to 1:
                                            0.04 glass, 0.5 to 0.95 and coloured for metals (whose albedo
                                            is 0); with ``roughness``
    roughness           (H', W')            width alpha of the GGX lobe, above 0 to 1
    diffuse_sigma_rad   (H', W')            Oren-Nayar slope of the facets of the diffuse part, rad
    hapke               (H', W')            share, 0 to 1, of the diffuse part that follows Hapke's law
                                            with the phase function of :data:`reliefscope.brdf.REGOLITH`
    ==================  ==================  ===========================================================

    None stands for no gloss, for Lambert's law and for no Hapke.  Light that gloss throws back is missing from
    the diffuse part, more so at grazing angles: :func:`reliefscope.brdf.coated`, so ``albedo + specular``
    must not exceed 1 where the surface is no Hapke layer.

    For evaluation only: ``grain_index`` (H', W') is the place in ``grains`` of the grain on top of a pixel,
    -1 for none; what describes a grain is up to the scene.
    """

    name: str
    pixel_um: float
    height_um: FloatImage
    albedo: FloatImage
    specular: FloatImage | None = None
    roughness: FloatImage | None = None
    diffuse_sigma_rad: FloatImage | None = None
    hapke: FloatImage | None = None
    grain_index: NDArray[np.int32] | None = None
    grains: tuple[object, ...] = ()

    def __post_init__(self) -> None:
        shape = self.height_um.shape
        if len(shape) != 2:
            raise InvalidInputError(
                f"Scene `{self.name}`: a height map has two axes, not {len(shape)}.",
                hint="Give an array (rows, columns) of heights in um.",
            )
        if self.pixel_um <= 0 or not np.isfinite(self.height_um).all():
            raise InvalidInputError(
                f"Scene `{self.name}` has heights that are not finite, or no pixel size.",
                hint="Fill missing heights first, and give pixel_um above 0.",
            )
        if (self.specular is None) != (self.roughness is None):
            raise InvalidInputError(
                f"Scene `{self.name}`: specular and roughness go together.",
                hint="Give both or neither.",
            )
        self._check_map("albedo", self.albedo, 0.0, 1.0, colour=True)
        self._check_map("specular", self.specular, 0.0, 1.0, colour=True)
        self._check_map("roughness", self.roughness, 1e-3, 1.0)
        self._check_map("diffuse_sigma_rad", self.diffuse_sigma_rad, 0.0, np.pi / 2)
        self._check_map("hapke", self.hapke, 0.0, 1.0)
        self._check_grains()
        self._check_energy()

    def _check_map(
        self,
        label: str,
        values: FloatImage | None,
        low: float,
        high: float,
        *,
        colour: bool = False,
    ) -> None:
        """Refuse a map on another grid, or with values outside ``low`` to ``high`` or not finite."""
        if values is None:
            return
        shape = self.height_um.shape
        if values.shape != shape and not (colour and values.shape == (*shape, 3)):
            raise InvalidInputError(
                f"Scene `{self.name}`: {label} has shape {values.shape}, the height map {shape}.",
                hint="Give every map on the grid of the heights, (rows, columns)"
                + (" or (rows, columns, 3)." if colour else "."),
            )
        if not (values.min() >= low and values.max() <= high):
            raise InvalidInputError(
                f"Scene `{self.name}`: {label} runs from {values.min():g} to {values.max():g}.",
                hint=f"Keep {label} within {low:g} to {high:g}, and fill missing values first.",
            )

    def _check_grains(self) -> None:
        index = self.grain_index
        if index is None:
            return
        if (
            index.shape != self.height_um.shape
            or index.min() < -1
            or index.max() >= len(self.grains)
        ):
            raise InvalidInputError(
                f"Scene `{self.name}`: grain_index {index.shape} does not name one of its "
                f"{len(self.grains)} grains, or -1, for every pixel of {self.height_um.shape}.",
                hint="Give an index into grains on the grid of the heights.",
            )

    def _check_energy(self) -> None:
        """Refuse a surface that returns more light than arrives."""
        if self.specular is None:
            return
        bright = _with_channels(self.albedo) + _with_channels(self.specular)
        if self.hapke is not None:
            bright = bright - self.hapke[..., None] * _with_channels(self.albedo)
        if bright.max() > 1 + _ENERGY_TOLERANCE:
            raise InvalidInputError(
                f"Scene `{self.name}` returns more light than arrives: albedo + specular reaches "
                f"{bright.max():.3g}.",
                hint="Lower one of them so that their sum stays within 1 at every pixel.",
            )

    @property
    def coloured(self) -> bool:
        """Whether anything differs between red, green and blue."""
        return self.albedo.ndim == 3 or (self.specular is not None and self.specular.ndim == 3)


def _with_channels(values: FloatImage) -> FloatImage:
    """(H', W', C) with one channel or three."""
    return values if values.ndim == 3 else values[..., None]
