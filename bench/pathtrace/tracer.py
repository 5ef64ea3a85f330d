"""A height map under one LED at a time in Mitsuba 3.

Mitsuba's world is the design's frame (x right, y up, z toward the objective, origin in the focal point) in
micrometres.  Radiance is relative to a white Lambert surface in the focal point that faces an LED of intensity 1.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from reliefscope.errors import InvalidInputError
from reliefscope.units import UM_PER_MM, FloatArray, FloatImage

VARIANT = "llvm_ad_mono"
LED_RADIUS_MM = 1.0
"""Bright part of the lens of a 3 mm LED: the same assumption as the simulated instrument makes."""
_NEARLY = 0.99
"""Part of the way to an LED along which something may stand in the light; the LED itself does not count."""


@dataclass(frozen=True)
class Sample:
    """Height map (H, W) in um and materials on the grid ``pixel_um``, whose middle is the focal point, y up.

    ``albedo`` is diffuse reflectance; ``specular`` and ``roughness`` (GGX alpha) are those of a rough mirror on
    top, None for a sample without gloss.
    """

    pixel_um: float
    height_um: FloatImage
    albedo: FloatImage
    specular: FloatImage | None = None
    roughness: FloatImage | None = None


@dataclass(frozen=True)
class FirstHits:
    """Where rays (N,) first meet the sample."""

    height_um: NDArray[np.float32]
    level: NDArray[np.float32]
    """z of the unit normal: 1 on a level face, 0 on a vertical wall."""
    sees_led: NDArray[np.bool_]
    """Whether the middle of the LED stands in sight."""


@cache
def mitsuba() -> Any:
    """Mitsuba with its LLVM variant.

    Raises
    ------
    InvalidInputError
        If Mitsuba or a libLLVM that it can use is missing.
    """
    if "DRJIT_LIBLLVM_PATH" not in os.environ:
        found = sorted(Path("/usr/lib").glob("*/libLLVM.so.*"))
        if found:
            os.environ["DRJIT_LIBLLVM_PATH"] = str(found[-1])
    try:
        import mitsuba as mi

        mi.set_variant(VARIANT)
        mi.Float(1.0) + 1.0
    except (ImportError, RuntimeError) as error:
        raise InvalidInputError(
            f"The path tracer does not start: {error}",
            hint="Install it with `pip install reliefscope[pathtrace]` and libLLVM 16 or newer (Debian: "
            "libllvm19); if it is in an unusual place, set DRJIT_LIBLLVM_PATH to it.",
        ) from error
    return mi


def start(threads: int) -> None:
    """Start Mitsuba with so many threads."""
    mitsuba()
    import drjit as dr

    dr.set_thread_count(threads)


class Tracer:
    """One sample under LEDs at ``led_positions_mm`` (N, 3), of which one shines at a time.

    ``bounces`` is the number of times that light may be reflected; 1 is direct light alone.
    """

    def __init__(self, sample: Sample, led_positions_mm: FloatArray, bounces: int) -> None:
        mi = mitsuba()
        self._mi = mi
        self.top_um = float(sample.height_um.max())
        scene: dict[str, Any] = {"type": "scene", "sample": _mesh(sample)}
        for index, position_mm in enumerate(led_positions_mm):
            scene[f"led{index}"] = _led(position_mm)
        self._scene = mi.load_dict(scene)
        self._integrator = mi.load_dict(
            {"type": "path", "max_depth": bounces + 1, "rr_depth": bounces + 2}
        )
        self._leds = len(led_positions_mm)
        self._positions_mm = led_positions_mm
        self._radiance = [
            float(np.sum(position**2)) / LED_RADIUS_MM**2 for position in led_positions_mm
        ]
        self._shining: int | None = None

    def shine(self, led: int) -> None:
        """Let one LED shine and no other."""
        if led == self._shining:
            return
        parameters = self._mi.traverse(self._scene)
        for index in range(self._leds):
            lit = index == led
            parameters[f"led{index}.emitter.radiance.value"] = self._radiance[index] if lit else 0.0
            parameters[f"led{index}.emitter.sampling_weight"] = 1.0 if lit else 0.0
        parameters.update()
        self._shining = led

    def first_hits(self, origin: Any, direction: Any, led: int) -> FirstHits:
        """Where rays first meet the sample, and how the middle of an LED stands there."""
        import drjit as dr

        mi = self._mi
        hit = self._scene.ray_intersect(mi.Ray3f(origin, direction))
        lamp = mi.Point3f(*(float(value) * UM_PER_MM for value in self._positions_mm[led]))
        near_lamp = hit.p + (lamp - hit.p) * _NEARLY
        hidden = self._scene.ray_test(hit.spawn_ray_to(near_lamp))
        incidence = dr.dot(hit.n, dr.normalize(lamp - hit.p))
        return FirstHits(
            np.asarray(hit.p.z), np.asarray(hit.n.z), ~np.asarray(hidden) & (incidence > 0)
        )

    def radiance(self, origin: Any, direction: Any, seed: int) -> Any:
        """Radiance along rays: arrays of Mitsuba in and out."""
        mi = self._mi
        count = len(origin.x)
        sampler = mi.load_dict({"type": "independent"})
        sampler.seed(seed, count)
        rays = mi.RayDifferential3f(origin, direction)
        value, _, _ = self._integrator.sample(self._scene, sampler, rays)
        return value[0]


def _mesh(sample: Sample) -> Any:
    """Two triangles per cell of the grid, materials interpolated between its points."""
    mi = mitsuba()
    rows, columns = sample.height_um.shape
    x = (np.arange(columns) - (columns - 1) / 2) * sample.pixel_um
    y = ((rows - 1) / 2 - np.arange(rows)) * sample.pixel_um
    points = np.empty((rows, columns, 3), dtype=np.float32)
    points[..., 0] = x[None, :]
    points[..., 1] = y[:, None]
    points[..., 2] = sample.height_um
    corner = np.arange(rows * columns, dtype=np.uint32).reshape(rows, columns)
    upper_left, upper_right = corner[:-1, :-1], corner[:-1, 1:]
    lower_left, lower_right = corner[1:, :-1], corner[1:, 1:]
    # Counter-clockwise seen from above: the normal points to the objective.
    faces = np.concatenate(
        [
            np.stack([upper_left, lower_left, lower_right], axis=-1).reshape(-1, 3),
            np.stack([upper_left, lower_right, upper_right], axis=-1).reshape(-1, 3),
        ]
    )
    properties = mi.Properties()
    properties["bsdf"] = mi.load_dict(_material(sample))
    mesh = mi.Mesh("sample", points.size // 3, len(faces), props=properties)
    for name, values in _attributes(sample).items():
        mesh.add_attribute(name, 1, values.astype(np.float32).ravel())
    parameters = mi.traverse(mesh)
    parameters["vertex_positions"] = points.ravel()
    parameters["faces"] = faces.ravel()
    parameters.update()
    return mesh


def _attributes(sample: Sample) -> dict[str, NDArray[np.float32]]:
    if sample.specular is None or sample.roughness is None:
        return {"vertex_albedo": sample.albedo}
    total = sample.albedo + sample.specular
    share = sample.specular / np.maximum(total, np.float32(1e-6))
    return {"vertex_albedo": total, "vertex_share": share, "vertex_alpha": sample.roughness}


def _material(sample: Sample) -> dict[str, Any]:
    """Diffuse, or a sum of diffuse and rough mirror.

    Mitsuba's blend of two materials is ``(1 - w) A + w B``; both are given the sum of the reflectances, and w
    is the mirror's share of it, so that the blend is the sum that is wanted.
    """

    def attribute(name: str) -> dict[str, Any]:
        return {"type": "mesh_attribute", "name": f"vertex_{name}"}

    diffuse = {"type": "diffuse", "reflectance": attribute("albedo")}
    if sample.specular is None:
        return diffuse
    mirror = {
        "type": "roughconductor",
        "material": "none",
        "distribution": "ggx",
        "alpha": attribute("alpha"),
        "specular_reflectance": attribute("albedo"),
    }
    return {"type": "blendbsdf", "weight": attribute("share"), "a": diffuse, "b": mirror}


def _led(position_mm: FloatArray) -> dict[str, Any]:
    """A luminous disc that faces the focal point."""
    mi = mitsuba()
    place = [float(value) * UM_PER_MM for value in position_mm]
    facing = mi.ScalarTransform4f().look_at(origin=place, target=[0, 0, 0], up=[0, 0, 1])
    size = LED_RADIUS_MM * UM_PER_MM
    return {
        "type": "disk",
        "to_world": facing @ mi.ScalarTransform4f().scale([size, size, 1]),
        "emitter": {"type": "area", "radiance": 1.0},
    }
