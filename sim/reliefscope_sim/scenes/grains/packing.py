"""Grains poured one after the other, each coming to rest on those that lie there."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from reliefscope.units import FloatImage
from reliefscope_sim.scenes.grains.kernels import cover, rest_height, settle
from reliefscope_sim.scenes.grains.shapes import UNIT_VOLUME, Faces, GrainShape, Points

FRICTION = 0.5
"""Coefficient between grains (assumed; angles of repose of 30 degrees and a little more belong to it)."""
_DROP_SITES = 3
"""A grain takes the lowest of so many places: the sample is levelled, not a cone below a funnel."""
_ROLLING_STEPS, _RESTING_STEPS = 600, 200
_SMALL_UM, _LARGE_UM = 14.0, 60.0


@dataclass(frozen=True)
class Grain:
    """One grain of a heap: a rigid body of known shape, place and material.

    ``radius_um`` is that of a sphere of the same volume, ``centre_um`` (x, y, z) its centre of mass in the
    world frame, ``rotation`` (3, 3) turns its principal axes (columns: long, middle, short) into the world's.
    ``kind`` is the number of its material in the recipe of the heap, ``name`` what people call it.
    """

    shape: GrainShape = field(repr=False)
    radius_um: float
    centre_um: tuple[float, float, float]
    rotation: Points = field(repr=False)
    kind: int
    name: str

    @property
    def volume_um3(self) -> float:
        """Volume."""
        return UNIT_VOLUME * self.radius_um**3

    @property
    def size_um(self) -> tuple[float, float, float]:
        """Extent along the principal axes, longest first."""
        long, middle, short = self.shape.extents
        return long * self.radius_um, middle * self.radius_um, short * self.radius_um

    def mesh_um(self) -> tuple[Points, Faces]:
        """Its surface in the world frame: vertices (V, 3) in um and faces (F, 3)."""
        vertices = self.radius_um * self.shape.vertices @ self.rotation.T + self.centre_um
        return vertices, self.shape.faces


@dataclass(frozen=True)
class LooseGrain:
    """A grain that is to be dropped.  Where ``place_um`` and ``rotation`` are None, chance decides."""

    shape: GrainShape
    radius_um: float
    kind: int
    name: str = ""
    place_um: tuple[float, float] | None = None
    rotation: Points | None = None


@dataclass(frozen=True)
class Heap:
    """What lies on the plate: surface (H, W) in um above it, the grain on top of each pixel, the grains.

    ``grain_index`` is -1 where the plate shows.
    """

    height_um: FloatImage
    grain_index: NDArray[np.int32]
    grains: tuple[Grain, ...]


def pour(
    generator: np.random.Generator,
    loose: Iterable[LooseGrain],
    shape: tuple[int, int],
    pixel_um: float,
    rim_um: float,
) -> Heap:
    """Drop grains one after the other over a plate and let each roll until it rests.

    ``shape`` (rows, columns) at ``pixel_um`` is what is wanted of the heap.  It is made larger by ``rim_um``
    and repeats itself beyond that, so that it has no walls; with a rim of at least the length of a grain no
    grain shows twice.
    """
    rim = math.ceil(rim_um / pixel_um)
    rows, columns = shape[0] + rim, shape[1] + rim
    surface: FloatImage = np.zeros((rows, columns), dtype=np.float32)
    owner = np.full((rows, columns), -1, dtype=np.int32)
    # The middle of what is wanted, in the heap's frame: x from column 0, y = 0 in row 0 and up.
    middle = np.array(
        [(rim // 2 + (shape[1] - 1) / 2) * pixel_um, -(rim // 2 + (shape[0] - 1) / 2) * pixel_um]
    )
    span = np.array([columns, rows]) * pixel_um
    grains: list[Grain] = []
    for grain in loose:
        rotation = _random_rotation(generator) if grain.rotation is None else grain.rotation.copy()
        few, many = _contact_points(grain)
        if grain.place_um is None:
            sites = middle + (generator.random((_DROP_SITES, 2)) - 0.5) * span
        else:
            sites = middle + np.array([grain.place_um])
        heights = [rest_height(surface, pixel_um, few, rotation, x, y) for x, y in sites]
        lowest = int(np.argmin(heights))
        position = np.array([*sites[lowest], heights[lowest]])
        reach_um = grain.radius_um * grain.shape.reach
        for points, steps in ((few, _ROLLING_STEPS), (many, _RESTING_STEPS)):
            settle(surface, pixel_um, points, reach_um, FRICTION, steps, position, rotation)
        body = grain.radius_um * grain.shape.vertices @ rotation.T + position
        cover(surface, owner, pixel_um, body, grain.shape.faces, len(grains))
        level = (position[:2] - middle + span / 2) % span - span / 2
        centre = (float(level[0]), float(level[1]), float(position[2]))
        grains.append(Grain(grain.shape, grain.radius_um, centre, rotation, grain.kind, grain.name))
    inside = (slice(rim // 2, rim // 2 + shape[0]), slice(rim // 2, rim // 2 + shape[1]))
    return Heap(
        np.ascontiguousarray(surface[inside]), np.ascontiguousarray(owner[inside]), tuple(grains)
    )


def _contact_points(grain: LooseGrain) -> tuple[Points, Points]:
    """Points (N, 3) in um at which a grain touches while it rolls, and more of them for its rest."""
    levels = grain.shape.contacts
    first = 0 if grain.radius_um < _SMALL_UM else 1 if grain.radius_um < _LARGE_UM else 2
    return grain.radius_um * levels[first], grain.radius_um * levels[min(first + 1, 2)]


def _random_rotation(generator: np.random.Generator) -> Points:
    """Uniformly random rotation (3, 3) from a random unit quaternion."""
    w, x, y, z = generator.normal(size=4).tolist()
    norm = math.sqrt(w * w + x * x + y * y + z * z)
    w, x, y, z = w / norm, x / norm, y / norm, z / norm
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
