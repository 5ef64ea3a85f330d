"""Samples for the path tracer: those of the simulated instrument, plain forms, and height maps from files.

Only the description of a sample is shared with the simulated instrument: heights, reflectances and roughness on
a grid.
"""

from __future__ import annotations

import math
from pathlib import Path

import cv2
import numpy as np
from bench.pathtrace.tracer import Sample

from reliefscope.axes import pixel_grid_um
from reliefscope.errors import InvalidInputError
from reliefscope.targets import Fiducial3D
from reliefscope.units import FloatImage
from reliefscope_sim.scenes import Scene, load_scene

MARGIN_PX = 32
"""Sample beyond the frame on each side, so that leaning rays and shadows at the rim meet something."""


def of_scene(scene: Scene) -> Sample:
    """The sample of a scene without colour and without laws of reflection that :class:`Sample` lacks.

    Colours are averaged; every diffuse part becomes Lambert's.
    """
    specular = None if scene.specular is None else _grey(scene.specular)
    return Sample(scene.pixel_um, scene.height_um, _grey(scene.albedo), specular, scene.roughness)


def _grey(values: FloatImage) -> FloatImage:
    grey: FloatImage = values.mean(axis=2) if values.ndim == 3 else values
    return grey


def make(name: str, shape: tuple[int, int], pixel_um: float) -> Sample:
    """Sample by name, on the grid of frames of ``shape`` and a margin.

    ``fiducial-dull``, ``fiducial-half``, ``fiducial-metallic``, ``regolith``, ``forms``, or a file ``*.npz`` with
    ``levelled_um`` and ``pixel_um``.
    """
    if name.startswith("fiducial-"):
        options = {"finish": name.removeprefix("fiducial-")}
        scene = load_scene("fiducial", 1, options, shape=shape, pixel_um=pixel_um)
        return of_scene(scene)
    if name == "regolith":
        return of_scene(load_scene("regolith", 1, shape=shape, pixel_um=pixel_um))
    grid = (shape[0] + 2 * MARGIN_PX, shape[1] + 2 * MARGIN_PX)
    if name == "forms":
        return forms(grid, pixel_um)
    if name.endswith(".npz"):
        return relief(Path(name), grid, pixel_um)
    raise InvalidInputError(
        f"There is no sample `{name}`.",
        hint="Use fiducial-dull, fiducial-half, fiducial-metallic, regolith, forms or a file .npz.",
    )


def true_heights(name: str, sample: Sample, shape: tuple[int, int], pixel_um: float) -> FloatImage:
    """Heights (H, W) in um at the pixel centres of a frame.

    Those of the fiducial are its design, without layers and grain of the print; the others are read from the
    sample's grid.
    """
    if name.startswith("fiducial-"):
        return Fiducial3D().height_um(shape, pixel_um)
    rows, columns = sample.height_um.shape
    x_um, y_um = pixel_grid_um(shape, pixel_um)
    x = (x_um / sample.pixel_um + (columns - 1) / 2).astype(np.float32)
    y = ((rows - 1) / 2 - y_um / sample.pixel_um).astype(np.float32)
    across, down = np.meshgrid(x, y)
    return np.asarray(cv2.remap(sample.height_um, across, down, cv2.INTER_LINEAR), dtype=np.float32)


def forms(shape: tuple[int, int], pixel_um: float) -> Sample:
    """Cones, pyramids, balls, a pit, a staircase and waves on a slanting base, printed with a random grain."""
    x_axis, y_axis = pixel_grid_um(shape, pixel_um)
    x, y = np.meshgrid(x_axis, y_axis)
    half_x, half_y = x_axis[-1], y_axis[0]
    unit = 0.25 * min(half_x, half_y)
    height = -30.0 + 0.02 * x - 0.015 * y
    left, middle, right = -0.6 * half_x, 0.0, 0.6 * half_x
    upper, lower = 0.5 * half_y, -0.5 * half_y

    cone = 70.0 * (1 - np.hypot(x - left, y - upper) / (1.4 * unit))
    height += np.maximum(cone, 0.0)
    pyramid = 60.0 * (1 - np.maximum(abs(x - middle), abs(y - upper)) / (1.3 * unit))
    height += np.clip(pyramid, 0.0, 45.0)
    for dx, dy, radius in ((-0.7, 0.5, 50.0), (0.6, 0.6, 65.0), (0.1, -0.8, 35.0)):
        squared = radius**2 - (x - right - dx * unit) ** 2 - (y - upper - dy * unit) ** 2
        height += np.sqrt(np.maximum(squared, 0.0))
    inside = np.hypot(x - left, y - lower) < 1.1 * unit
    height += np.where(inside, -25.0 + 12.0 * np.cos((x - left) / (0.25 * unit)), 0.0)
    stair = np.clip(np.floor((x - middle) / (0.35 * unit)) + 4, 0, 7) * 8.0
    height += np.where((abs(x - middle) < 1.4 * unit) & (abs(y - lower) < unit), stair, 0.0)
    window = np.exp(-(((x - right) / (1.3 * unit)) ** 4) - ((y - lower) / (1.2 * unit)) ** 4)
    wave = np.sin((x - right) / 22.0) * np.sin((y - lower) / 31.0 + 0.5)
    height += 22.0 * wave * window
    return Sample(pixel_um, height.astype(np.float32), _grain(shape, pixel_um, 0.45, 7))


def relief(path: Path, shape: tuple[int, int], pixel_um: float) -> Sample:
    """A measured height map, stretched over the frame and to a relief of 100 um (1st to 99th percentile)."""
    with np.load(path) as content:
        height = content["levelled_um"].astype(np.float64)
    missing = ~np.isfinite(height)
    if missing.any():
        filled = np.where(missing, np.nanmedian(height), height).astype(np.float32)
        height = cv2.inpaint(filled, missing.astype(np.uint8), 3, cv2.INPAINT_TELEA)
    rows, columns = height.shape
    factor = max(shape[0] / rows, shape[1] / columns)
    size = (math.ceil(columns * factor), math.ceil(rows * factor))
    stretched = cv2.resize(height.astype(np.float32), size, interpolation=cv2.INTER_CUBIC)
    stretched = stretched[: shape[0], : shape[1]]
    low, middle, high = np.percentile(stretched, [1, 50, 99])
    levelled = np.clip((stretched - middle) * (100.0 / (high - low)), -70.0, 70.0)
    return Sample(pixel_um, levelled.astype(np.float32), _grain(shape, pixel_um, 0.4, 11))


def _grain(shape: tuple[int, int], pixel_um: float, mean: float, seed: int) -> FloatImage:
    """Albedo with blotches of 2 to 10 um, lognormal with a standard deviation of a quarter."""
    generator = np.random.default_rng(seed)
    total = np.zeros(shape)
    for size_um, weight in ((2.0, 1.0), (4.0, 0.8), (10.0, 0.5)):
        field = cv2.GaussianBlur(generator.standard_normal(shape), (0, 0), size_um / 2 / pixel_um)
        total += weight * field / field.std()
    grain = mean * np.exp(0.25 * total / total.std())
    albedo: FloatImage = np.clip(grain, 0.02, 0.95).astype(np.float32)
    return albedo
