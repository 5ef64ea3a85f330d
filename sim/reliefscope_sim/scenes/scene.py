"""What lies under the simulated microscope: a height map and what it is made of."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from reliefscope.errors import InvalidInputError
from reliefscope.units import FloatImage

MARGIN_PX = 32
"""Sample around the frame that a built-in scene provides, in frame pixels on each side."""


@dataclass(frozen=True)
class Scene:
    """Height map and materials on one grid (H', W'); its middle lies on the optical axis, y up.

    ``height_um`` is counted from the focal plane.  ``albedo`` is diffuse reflectance, (H', W') for a sample
    without colour or (H', W', 3) in linear RGB.  ``specular`` is the reflectance at normal incidence of a
    GGX lobe of width ``roughness``, both (H', W'); None stands for a sample without gloss.  Around the grid
    the sample goes on as its edge does.
    """

    name: str
    pixel_um: float
    height_um: FloatImage
    albedo: FloatImage
    specular: FloatImage | None = None
    roughness: FloatImage | None = None

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
        for label, values in (("specular", self.specular), ("roughness", self.roughness)):
            if values is not None and values.shape != shape:
                raise InvalidInputError(
                    f"Scene `{self.name}`: {label} has shape {values.shape}, the height map {shape}.",
                    hint="Give every map on the same grid.",
                )
        if self.albedo.shape not in {shape, (*shape, 3)}:
            raise InvalidInputError(
                f"Scene `{self.name}`: albedo has shape {self.albedo.shape}, the height map {shape}.",
                hint="Give albedo as (rows, columns) or (rows, columns, 3) on the grid of the heights.",
            )

    @property
    def coloured(self) -> bool:
        """Whether the albedo differs between red, green and blue."""
        return self.albedo.ndim == 3
