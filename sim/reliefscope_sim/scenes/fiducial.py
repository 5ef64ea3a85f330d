"""The 3D fiducial as printed and silvered: layers, micro-texture, and three finishes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from reliefscope.axes import normals_from_height
from reliefscope.targets import Fiducial3D
from reliefscope.units import FloatImage
from reliefscope_sim.scenes.options import Options
from reliefscope_sim.scenes.scene import Scene
from reliefscope_sim.scenes.textures import noise, speckle

LAYER_UM = 0.5
"""Layer height of the printer (section IV.B)."""
WALL_COVERAGE = 0.4
"""Reflectance of the film on a vertical wall relative to a level face (assumed): sputtering comes from above
and coats walls thinner, and a thin film corrodes further."""


@dataclass(frozen=True, slots=True)
class Finish:
    """Optical state of the silver after corrosion; spreads are standard deviations."""

    albedo: float
    albedo_spread: float
    specular: float
    roughness: float
    texture_um: float


FINISHES: dict[str, Finish] = {
    "dull": Finish(albedo=0.55, albedo_spread=0.30, specular=0.0, roughness=0.5, texture_um=0.12),
    "half": Finish(albedo=0.35, albedo_spread=0.30, specular=0.12, roughness=0.45, texture_um=0.10),
    "metallic": Finish(
        albedo=0.12, albedo_spread=0.35, specular=0.6, roughness=0.35, texture_um=0.08
    ),
}


def fiducial(seed: int, options: Options, shape: tuple[int, int], pixel_um: float) -> Scene:
    """The fiducial in a finish; ``scale`` shrinks or grows it as a whole."""
    finish = FINISHES[options.choice("finish", "dull", tuple(FINISHES))]
    scale = options.number("scale", 1.0, 0.05, 10.0)
    generator = np.random.default_rng([seed, 0xF1D])
    target = Fiducial3D(scale=scale)
    design_um = target.height_um(shape, pixel_um)
    level = normals_from_height(design_um, pixel_um)[..., 2]
    film = np.float32(WALL_COVERAGE) + np.float32(1 - WALL_COVERAGE) * level
    height_um = _printed(design_um, target.base_um)
    height_um += np.float32(finish.texture_um) * noise(generator, shape, 1.5 / pixel_um)
    # Corrosion leaves patches of a few micrometres with finer grain inside.
    field = speckle(
        generator,
        shape,
        (1.2 / pixel_um, 2.5 / pixel_um, 6.0 / pixel_um, 20.0 / pixel_um),
        (0.6, 1.0, 0.7, 0.3),
    )
    albedo = finish.albedo * np.exp(
        np.float32(finish.albedo_spread) * field - np.float32(finish.albedo_spread**2 / 2)
    )
    albedo = np.clip(film * albedo, 0.02, 0.95).astype(np.float32)
    specular: FloatImage | None = None
    roughness: FloatImage | None = None
    if finish.specular > 0:
        # Where corrosion took the silver, the diffuse part grows and the mirror fades.
        specular = np.clip(
            film * finish.specular * np.exp(-np.float32(finish.albedo_spread) * field), 0.0, 0.95
        ).astype(np.float32)
        roughness = np.full(shape, finish.roughness, dtype=np.float32)
        albedo = np.minimum(albedo, 1 - specular)
    return Scene("fiducial", pixel_um, height_um, albedo, specular, roughness)


def _printed(height_um: FloatImage, base_um: float) -> FloatImage:
    """Half way from the smooth design to bare layers: the printer's voxel rounds its steps."""
    above = height_um - np.float32(base_um)
    layered = np.round(above / LAYER_UM) * LAYER_UM
    printed: FloatImage = (0.5 * (above + layered) + base_um).astype(np.float32)
    return printed
