"""Mirror-like targets for calibrating lights: chromium-plated balls on a matt plate, or a chromium-plated flat."""

from __future__ import annotations

import math

import numpy as np

from reliefscope.axes import pixel_grid_um
from reliefscope.units import FloatImage
from reliefscope_sim.scenes.options import Options
from reliefscope_sim.scenes.scene import Scene

CHROMIUM = (0.549, 0.556, 0.554)
"""Reflectance at normal incidence in linear RGB."""
_PLATE_ALBEDO = 0.18
_IN_FOCUS = 0.85
"""Height of the focal plane on a ball by its radius: highlights of lights at 22.5 to 45 degrees lie there."""
_PITCH = 3.2
"""Distance of neighbouring balls by their radius: they cast no shadow on each other's highlights."""


def chrome(seed: int, options: Options, shape: tuple[int, int], pixel_um: float) -> Scene:
    """``target``: one ``ball`` in the middle, ``balls`` all over, or a ``flat``.

    What the lobe can render is a mirror with a haze: ``roughness`` is its GGX width.  The default spreads a light
    about as wide on the ball as its lens and the open disc of the glass do; smaller ones make highlights that
    are narrower than on a real instrument, because the renderer takes an open disc for one direction.  Mirrors
    show no pictures of each other or of the plate: between surfaces all light is diffuse.
    """
    del seed  # nothing is random about it
    target = options.choice("target", "ball", ("ball", "balls", "flat"))
    roughness = options.number("roughness", 0.06, 0.02, 0.5)
    if target == "flat":
        height_um, metal = _flat(options, shape, pixel_um)
    else:
        height_um, metal = _balls(options, shape, pixel_um, only_one=target == "ball")
    return Scene(
        "chrome",
        pixel_um,
        height_um,
        np.where(metal, 0.0, _PLATE_ALBEDO).astype(np.float32),
        np.where(metal[..., None], CHROMIUM, 0.0).astype(np.float32),
        np.full(shape, roughness, dtype=np.float32),
    )


def _flat(
    options: Options, shape: tuple[int, int], pixel_um: float
) -> tuple[FloatImage, np.ndarray[tuple[int, int], np.dtype[np.bool_]]]:
    """Level, a flat throws the light of the dome past the pupil; tilted by half a light's zenith angle it shines."""
    slope = math.tan(math.radians(options.number("tilt_deg", 0.0, 0.0, 45.0)))
    azimuth = math.radians(options.number("azimuth_deg", 0.0, -360.0, 360.0))
    x_um, y_um = pixel_grid_um(shape, pixel_um)
    rise_x, rise_y = slope * math.cos(azimuth), slope * math.sin(azimuth)
    height_um = (rise_x * x_um[None, :] + rise_y * y_um[:, None]).astype(np.float32)
    return height_um, np.ones(shape, dtype=np.bool_)


def _balls(
    options: Options, shape: tuple[int, int], pixel_um: float, *, only_one: bool
) -> tuple[FloatImage, np.ndarray[tuple[int, int], np.dtype[np.bool_]]]:
    """Balls half sunk into the plate: nothing below the equator can be seen from above."""
    radius = options.number("radius_um", 60.0, 5.0, 1000.0)
    x_um, y_um = pixel_grid_um(shape, pixel_um)
    if not only_one:
        pitch = _PITCH * radius
        x_um, y_um = (axis - pitch * np.round(axis / pitch) for axis in (x_um, y_um))
    squared = radius**2 - x_um[None, :] ** 2 - y_um[:, None] ** 2
    height_um = np.sqrt(np.maximum(squared, 0.0)) - _IN_FOCUS * radius
    return height_um.astype(np.float32), squared > 0
