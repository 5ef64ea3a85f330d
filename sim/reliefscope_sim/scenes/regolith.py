"""Loose grains dropped one after the other, each coming to rest on what lies below it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from reliefscope.axes import pixel_grid_um
from reliefscope.units import FloatImage
from reliefscope_sim.scenes.options import Options
from reliefscope_sim.scenes.scene import Scene
from reliefscope_sim.scenes.textures import noise, speckle

_GRAINS_PER_MM2 = 900.0
_SEMI_AXES_UM = (12.0, 70.0)
_MATERIALS: tuple[tuple[float, tuple[float, float, float], float], ...] = (
    (0.55, (0.34, 0.22, 0.14), 0.0),
    (0.30, (0.20, 0.15, 0.12), 0.02),
    (0.10, (0.50, 0.42, 0.34), 0.04),
    (0.05, (0.10, 0.10, 0.11), 0.25),
)
"""Share, albedo (linear RGB) and reflectance at normal incidence of each kind of grain."""


@dataclass(frozen=True, slots=True)
class Grain:
    """Ellipsoid: centre, semi-axes and rotation matrix (columns are its axes) in um, kind of material."""

    centre_um: tuple[float, float, float]
    semi_axes_um: tuple[float, float, float]
    rotation: NDArray[np.float64]
    material: int


def regolith(seed: int, options: Options, shape: tuple[int, int], pixel_um: float) -> Scene:
    """Rounded grains of wide size distribution, as many as ``grains`` or 900 per square millimetre."""
    area_mm2 = shape[0] * shape[1] * pixel_um**2 / 1e6
    count = round(options.number("grains", _GRAINS_PER_MM2 * area_mm2, 1, 20000))
    relief_um = options.number("relief_um", 100.0, 5.0, 1000.0)
    generator = np.random.default_rng([seed, 0x6E6])
    height_um, kind, shade, _ = drop_grains(generator, count, shape, pixel_um)
    # The highest grains would stand far above the rest: press the heap to the wanted relief.
    low, middle, high = np.percentile(height_um, [1, 50, 99])
    height_um = (height_um - middle) * (relief_um / max(high - low, 1e-3))
    height_um += 0.3 * noise(generator, shape, 1.5 / pixel_um)
    texture = speckle(
        generator, shape, (1.2 / pixel_um, 3.0 / pixel_um, 9.0 / pixel_um), (0.8, 1.0, 0.6)
    )
    colours = np.array([colour for _, colour, _ in _MATERIALS], dtype=np.float32)
    gloss = np.array([specular for _, _, specular in _MATERIALS], dtype=np.float32)
    albedo = colours[kind] * (shade * np.exp(0.25 * texture))[..., None]
    return Scene(
        "regolith",
        pixel_um,
        height_um.astype(np.float32),
        np.clip(albedo, 0.01, 0.9).astype(np.float32),
        gloss[kind],
        np.full(shape, 0.3, dtype=np.float32),
    )


def drop_grains(
    generator: np.random.Generator, count: int, shape: tuple[int, int], pixel_um: float
) -> tuple[FloatImage, NDArray[np.int64], FloatImage, list[Grain]]:
    """Let ``count`` ellipsoids fall, large ones first on the whole.

    Returns the surface (H, W) in um, the kind of material and the brightness of the grain on top of each
    pixel, and the grains.
    """
    x_um, y_um = pixel_grid_um(shape, pixel_um)
    surface: FloatImage = np.zeros(shape, dtype=np.float32)
    kind = np.zeros(shape, dtype=np.int64)
    shade: FloatImage = np.ones(shape, dtype=np.float32)
    shares = np.array([share for share, _, _ in _MATERIALS])
    low, high = np.log(_SEMI_AXES_UM)
    sizes = np.exp(generator.uniform(low, high, count))
    sizes = sizes[np.argsort(-sizes * np.exp(generator.normal(0.0, 0.5, count)))]
    grains: list[Grain] = []
    for size in sizes:
        axes = size * np.array([1.0, generator.uniform(0.6, 1.0), generator.uniform(0.45, 0.9)])
        rotation = _rotation(generator)
        x0 = generator.uniform(x_um[0], x_um[-1])
        y0 = generator.uniform(y_um[-1], y_um[0])
        material = int(generator.choice(len(_MATERIALS), p=shares))
        brightness = np.float32(np.exp(generator.normal(0.0, 0.2)))
        columns = np.flatnonzero(np.abs(x_um - x0) <= size)
        rows = np.flatnonzero(np.abs(y_um - y0) <= size)
        if not (columns.size and rows.size):
            continue
        window = (slice(rows[0], rows[-1] + 1), slice(columns[0], columns[-1] + 1))
        top, bottom, inside = _caps(
            axes, rotation, x_um[window[1]][None, :] - x0, y_um[window[0]][:, None] - y0
        )
        if not inside.any():
            continue
        below = surface[window]
        rest = float((below - bottom)[inside].max())
        lifted = top + rest
        covers = inside & (lifted > below)
        surface[window] = np.where(covers, lifted, below)
        kind[window][covers] = material
        shade[window][covers] = brightness
        grains.append(
            Grain((float(x0), float(y0), rest), (axes[0], axes[1], axes[2]), rotation, material)
        )
    return surface, kind, shade, grains


def _rotation(generator: np.random.Generator) -> NDArray[np.float64]:
    """Uniformly random rotation (3, 3) from a random unit quaternion."""
    w, x, y, z = _unit(generator.normal(size=4))
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


def _unit(vector: NDArray[np.float64]) -> NDArray[np.float64]:
    unit: NDArray[np.float64] = vector / np.linalg.norm(vector)
    return unit


def _caps(
    axes: NDArray[np.float64],
    rotation: NDArray[np.float64],
    dx: NDArray[np.float64],
    dy: NDArray[np.float64],
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.bool_]]:
    """Upper and lower surface of an ellipsoid about its centre, and where it is.

    Points satisfy p^T A p = 1 with A = R diag(1/axes^2) R^T, a quadratic in z for given x and y.
    """
    A = rotation @ np.diag(1 / axes**2) @ rotation.T
    half_b = A[0, 2] * dx + A[1, 2] * dy
    c = A[0, 0] * dx**2 + 2 * A[0, 1] * dx * dy + A[1, 1] * dy**2 - 1
    discriminant = half_b**2 - A[2, 2] * c
    inside = discriminant > 0
    root = np.sqrt(np.maximum(discriminant, 0.0))
    return (-half_b + root) / A[2, 2], (-half_b - root) / A[2, 2], inside
