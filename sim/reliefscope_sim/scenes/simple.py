"""Scenes of simple shape, for checks against closed forms and for calibration."""

from __future__ import annotations

import math

import numpy as np

from reliefscope.axes import pixel_grid_um
from reliefscope.targets import grid_coverage, scale_coverage
from reliefscope_sim.scenes.options import Options
from reliefscope_sim.scenes.scene import Scene
from reliefscope_sim.scenes.textures import albedo_map


def flat(seed: int, options: Options, shape: tuple[int, int], pixel_um: float) -> Scene:
    """Level diffuser at ``height_um``."""
    height = options.number("height_um", 0.0, -1000.0, 1000.0)
    albedo = albedo_map(seed, options, shape, pixel_um)
    return Scene("flat", pixel_um, np.full(shape, height, dtype=np.float32), albedo)


def plane(seed: int, options: Options, shape: tuple[int, int], pixel_um: float) -> Scene:
    """Diffuse plane through the focal point, rising by ``tilt_deg`` toward ``azimuth_deg``."""
    slope = math.tan(math.radians(options.number("tilt_deg", 20.0, 0.0, 75.0)))
    azimuth = math.radians(options.number("azimuth_deg", 0.0, -360.0, 360.0))
    x_um, y_um = pixel_grid_um(shape, pixel_um)
    rise_x, rise_y = slope * math.cos(azimuth), slope * math.sin(azimuth)
    height_um = (rise_x * x_um[None, :] + rise_y * y_um[:, None]).astype(np.float32)
    return Scene("plane", pixel_um, height_um, albedo_map(seed, options, shape, pixel_um))


def hemisphere(seed: int, options: Options, shape: tuple[int, int], pixel_um: float) -> Scene:
    """Diffuse hemisphere in the middle of a level base at ``base_um``."""
    radius = options.number("radius_um", 100.0, 1.0, 1000.0)
    base = options.number("base_um", -50.0, -1000.0, 1000.0)
    x_um, y_um = pixel_grid_um(shape, pixel_um)
    squared = radius**2 - x_um[None, :] ** 2 - y_um[:, None] ** 2
    height_um = (np.sqrt(np.maximum(squared, 0.0)) + base).astype(np.float32)
    return Scene("hemisphere", pixel_um, height_um, albedo_map(seed, options, shape, pixel_um))


def grid(seed: int, options: Options, shape: tuple[int, int], pixel_um: float) -> Scene:
    """Dark square grid on a white plate at ``height_um`` (Fig. 7)."""
    height = options.number("height_um", 0.0, -1000.0, 1000.0)
    pitch = options.number("pitch_um", 200.0, 5.0, 2000.0)
    line = options.number("line_um", 20.0, 1.0, 1000.0)
    white = albedo_map(seed, options, shape, pixel_um)
    albedo = white * (1 - 0.9 * grid_coverage(shape, pixel_um, pitch, line))
    level = np.full(shape, height, dtype=np.float32)
    return Scene("grid", pixel_um, level, albedo.astype(np.float32))


def scale(seed: int, options: Options, shape: tuple[int, int], pixel_um: float) -> Scene:
    """Dark marks of a stage micrometre on a white plate in the focal plane."""
    white = albedo_map(seed, options, shape, pixel_um)
    albedo = white * (1 - 0.9 * scale_coverage(shape, pixel_um))
    return Scene("scale", pixel_um, np.zeros(shape, dtype=np.float32), albedo.astype(np.float32))
