"""A levelled sample of loose regolith after one of the paper's simulants."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from reliefscope.units import FloatImage
from reliefscope_sim.scenes.grains import Grain, Heap, pour
from reliefscope_sim.scenes.grains.simulants import SIMULANTS, Colour, Material, Simulant
from reliefscope_sim.scenes.options import Options
from reliefscope_sim.scenes.scene import Scene
from reliefscope_sim.scenes.textures import noise, speckle

_WIDE_ENOUGH_UM = 600.0
"""Width of a frame from which on the grain on top is laid on it: it is 300 um long."""
_BRIGHTEST = 0.98


def regolith(seed: int, options: Options, shape: tuple[int, int], pixel_um: float) -> Scene:
    """Grains of ``simulant`` (ds1, jsc1a, mars1), ``grains`` in all or as many as it has on such an area.

    The focal plane lies half way between the lowest and the highest half per cent of the surface.
    """
    simulant = SIMULANTS[options.choice("simulant", "mars1", tuple(sorted(SIMULANTS)))]
    area_mm2 = shape[0] * shape[1] * pixel_um**2 / 1e6
    wanted = simulant.grains_per_mm2 * area_mm2
    count = options.number("grains", wanted, 1, 50_000)
    generator = np.random.default_rng([seed, 0x6E6])
    heap = _heap(generator, simulant, count, shape, pixel_um)
    # Dust is the last material, and stands for grain -1.
    materials = (*(kind.material for kind in simulant.all_kinds), simulant.dust)
    material = np.array([*(grain.kind for grain in heap.grains), len(materials) - 1])[
        heap.grain_index
    ]
    relief_um = _table([each.relief_um for each in materials])[material]
    height_um = heap.height_um + relief_um * noise(generator, material.shape, 1.5 / pixel_um)
    middle = float(np.percentile(height_um, [0.5, 99.5]).mean())
    albedo = _albedo(generator, simulant, material, heap, pixel_um)
    specular, roughness = _gloss(generator, materials, material, heap, pixel_um)
    return Scene(
        "regolith",
        pixel_um,
        height_um - np.float32(middle),
        np.clip(albedo, 0.01, _BRIGHTEST - specular),
        specular,
        roughness,
        diffuse_sigma_rad=_table([each.sigma_rad or 0.0 for each in materials])[material],
        hapke=_table([float(each.sigma_rad is None) for each in materials])[material],
        grain_index=heap.grain_index,
        grains=tuple(_lowered(grain, middle) for grain in heap.grains),
    )


def _heap(
    generator: np.random.Generator,
    simulant: Simulant,
    count: float,
    shape: tuple[int, int],
    pixel_um: float,
) -> Heap:
    """The grains that fall on a frame and on the rim around it, and the one on top where there is room."""
    rim_um = 3 * max(kind.radii_um[1] for kind in simulant.kinds)
    height_um, width_um = shape[0] * pixel_um, shape[1] * pixel_um
    share = (height_um + rim_um) * (width_um + rim_um) / (height_um * width_um)
    loose = simulant.draw(generator, max(1, round(count * share)))
    if width_um >= _WIDE_ENOUGH_UM:
        loose += simulant.draw_on_top(generator, (-0.22 * width_um, 0.0))
    return pour(generator, loose, shape, pixel_um, rim_um)


def _lowered(grain: Grain, by_um: float) -> Grain:
    x, y, z = grain.centre_um
    return replace(grain, centre_um=(x, y, z - by_um))


def _table(values: list[float] | list[Colour]) -> FloatImage:
    """One value or colour per material."""
    return np.array(values, dtype=np.float32)


def _albedo(
    generator: np.random.Generator,
    simulant: Simulant,
    material: NDArray[np.intp],
    heap: Heap,
    pixel_um: float,
) -> FloatImage:
    """Diffuse reflectance (H, W, 3): that of the material, brighter or darker by grain and by spot."""
    materials = (*(kind.material for kind in simulant.all_kinds), simulant.dust)
    sizes = (1.2 / pixel_um, 3.0 / pixel_um, 9.0 / pixel_um)
    spots = speckle(generator, material.shape, sizes, (0.8, 1.0, 0.6))
    mottling = _table([each.mottling for each in materials])[material]
    variety = [simulant.all_kinds[grain.kind].variety for grain in heap.grains]
    # Dust, grain -1, is the same everywhere.
    shade = np.array([*variety, 0.0], dtype=np.float32)
    shade *= generator.standard_normal(len(shade), dtype=np.float32)
    logarithm = shade[heap.grain_index] + mottling * _own_part(generator, spots, heap)
    albedo: FloatImage = _table([each.albedo for each in materials])[material]
    albedo *= np.exp(logarithm)[..., None]
    return albedo


def _gloss(
    generator: np.random.Generator,
    materials: tuple[Material, ...],
    material: NDArray[np.intp],
    heap: Heap,
    pixel_um: float,
) -> tuple[FloatImage, FloatImage]:
    """Specular reflectance (H, W, 3) and its width (H, W), with glossy specks."""
    specular: FloatImage = _table([each.gloss.f0 for each in materials])[material]
    roughness: FloatImage = _table([each.gloss.alpha for each in materials])[material]
    for number, each in enumerate(materials):
        if each.specks is None:
            continue
        field = noise(generator, material.shape, each.specks.size_um / pixel_um)
        field = _own_part(generator, field, heap)
        spots = (material == number) & (field > np.quantile(field, 1 - each.specks.share))
        specular[spots] = each.specks.gloss.f0
        roughness[spots] = each.specks.gloss.alpha
    return specular, roughness


def _own_part(generator: np.random.Generator, field: FloatImage, heap: Heap) -> FloatImage:
    """The field shifted by a random amount for every grain, so that patterns end where a grain does."""
    shifts = generator.integers(0, field.size, len(heap.grains) + 1)[heap.grain_index]
    places = np.arange(field.size).reshape(field.shape) + shifts
    own: FloatImage = np.take(field, places, mode="wrap")
    return own
