"""Any measured surface as a sample: a file of heights, with an even or speckled reflectance."""

from __future__ import annotations

import math

import numpy as np

from reliefscope.errors import InvalidInputError
from reliefscope.surface import read_height_map
from reliefscope.surface.readers import FORMATS
from reliefscope_sim.scenes.options import Options
from reliefscope_sim.scenes.scene import Scene
from reliefscope_sim.scenes.textures import albedo_map

_HIGHEST_UM = 2000.0


def heightmap(seed: int, options: Options, shape: tuple[int, int], pixel_um: float) -> Scene:
    """The height map ``file``, its middle on the optical axis, its median height in the focal plane.

    ``width_um`` stretches it sideways (both ways alike), ``z_scale`` in height; ``offset_um`` lifts it, ``level``
    (``yes``) takes its tilt away.  Missing heights are filled smoothly; beyond its edges the map goes on
    mirrored.  ``specular`` and ``roughness`` give it gloss.
    """
    path = options.text("file")
    if not path:
        raise InvalidInputError(
            "Scene `heightmap` needs a file.",
            hint=f"Name one: scene=heightmap&file=PATH ({', '.join(FORMATS)}).",
        )
    width_um = options.number("width_um", math.nan, 1.0, 1e6)
    z_scale = options.number("z_scale", 1.0, -1e6, 1e6)
    offset_um = options.number("offset_um", 0.0, -1000.0, 1000.0)
    level = options.choice("level", "yes", ("yes", "no"))
    specular = options.number("specular", 0.0, 0.0, 0.95)
    roughness = options.number("roughness", 0.3, 0.02, 1.0)
    height_map = read_height_map(path, width_um=None if math.isnan(width_um) else width_um)
    height_map = height_map.filled()
    if level == "yes":
        height_map = height_map.levelled()
    height_um = z_scale * height_map.resampled(shape, pixel_um)
    height_um += np.float32(offset_um - np.median(height_um))
    if np.abs(height_um).max() > _HIGHEST_UM:
        raise InvalidInputError(
            f"`{height_map.name}` reaches {np.abs(height_um).max():.0f} um from the focal plane.",
            hint=f"At most {_HIGHEST_UM:.0f} um can be rendered: make it lower with z_scale.",
        )
    albedo = albedo_map(seed, options, shape, pixel_um, mean=0.6, texture=0.2)
    return Scene(
        "heightmap",
        pixel_um,
        height_um.astype(np.float32),
        np.minimum(albedo, np.float32(1 - specular)),
        np.full(shape, specular, dtype=np.float32) if specular > 0 else None,
        np.full(shape, roughness, dtype=np.float32) if specular > 0 else None,
    )
