"""Frames of the simulated instrument beside those of the path tracer: same scene, apertures and LEDs.

Sensor noise, leakage and colour are off on both sides, and the LEDs of the simulated instrument get the beam of a
luminous disc (half angle 60 degrees).  Both give radiance relative to a white surface under an LED that faces it:
nothing is fitted.
"""

from __future__ import annotations

import logging
from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np
from bench.pathtrace import samples
from bench.pathtrace.camera import Aperture, Frame, diffracted, first_hits, photograph
from bench.pathtrace.tracer import FirstHits, Tracer
from numpy.typing import NDArray

from reliefscope.models.instrument import InstrumentProfile, load_profile
from reliefscope.models.plan import pattern_apertures
from reliefscope.units import BoolImage, FloatImage
from reliefscope_sim.as_built import AsBuilt
from reliefscope_sim.optics import Renderer
from reliefscope_sim.optics.renderer import signal_per_mm2_s
from reliefscope_sim.scenes import Scene

BOUNCES = 5
EDGE_PX = 4
"""So near to a jump of depth, or to the edge of a shadow, a pixel counts as being at it."""
_JUMP_PX = 3.0
_WALL_LEVEL = 0.3
_NO_WAVELENGTH_UM = 1e-4
LOGGER = logging.getLogger(__name__)


@dataclass(frozen=True)
class Pair:
    """One aperture and one LED seen by both, radiance (H, W).

    ``tracer`` and ``twin`` have no diffraction, ``tracer_seen`` and ``twin_seen`` have it.  ``noise`` is the
    standard deviation of the tracer's own Monte Carlo noise.
    """

    view: int
    led: int
    tracer: FloatImage
    twin: FloatImage
    tracer_seen: FloatImage
    twin_seen: FloatImage
    noise: float
    regions: dict[str, BoolImage]

    @property
    def displacement_px(self) -> tuple[float, float]:
        """(columns, rows) by which the twin's frame lies beside the tracer's.

        Least squares in ``twin = gain * tracer - displacement . gradient(tracer)``, without diffraction, and in
        the light only, where texture and not the brightness of shadows decides.
        """
        tracer, twin = (cv2.GaussianBlur(each, (0, 0), 1.5) for each in (self.tracer, self.twin))
        down, across = np.gradient(tracer)
        lit = self.regions["in the light"]
        parts = np.stack([tracer[lit], across[lit], down[lit]], axis=-1).astype(np.float64)
        fit = np.linalg.lstsq(parts, twin[lit], rcond=None)[0]
        return float(-fit[1]), float(-fit[2])


@dataclass(frozen=True)
class Figures:
    """How one region of a pair compares."""

    region: str
    share: float
    """Part of the pixels."""
    radiance: float
    """Mean of the tracer."""
    ratio: float
    """Mean of the twin over that of the tracer."""
    rms: float
    """Root mean square of the difference over the tracer's mean in the region."""
    median: float
    """Median of the absolute difference over the tracer's mean in the region."""


def plain_profile(wavelength_um: float | None = None) -> InstrumentProfile:
    """The benchtop without colour filters and leakage, its LEDs with the beam of a luminous disc."""
    profile = load_profile("benchtop")
    optics = profile.optics.model_copy(
        update={"wavelength_um": wavelength_um or profile.optics.wavelength_um}
    )
    return profile.model_copy(
        update={
            "optics": optics,
            "camera": profile.camera.model_copy(update={"sensor": "mono"}),
            "glass": profile.glass.model_copy(update={"contrast_ratio": 1e9}),
            "dome": profile.dome.model_copy(update={"half_angle_deg": 60.0}),
        }
    )


def compare(
    scene: Scene,
    pairs: Sequence[tuple[int, int]],
    window: tuple[slice, slice],
    *,
    shape: tuple[int, int] | None = None,
    rays_per_pixel: int = 32,
    bounces: int = BOUNCES,
) -> list[Pair]:
    """Frames of both for pairs (aperture of the pattern, LED), cut to ``window``.

    Materials that only one of them knows (Oren-Nayar, Hapke) are taken out of the scene.
    """
    scene = replace(scene, diffuse_sigma_rad=None, hapke=None)
    sharp_profile, profile = plain_profile(_NO_WAVELENGTH_UM), plain_profile()
    shape = shape or profile.shape
    built = AsBuilt.nominal(profile)
    sharp, seen = (Renderer(each, scene, built, shape) for each in (sharp_profile, profile))
    tracer = Tracer(samples.of_scene(scene), profile.dome.positions_mm, bounces)
    frame = Frame(shape, profile.pixel_um, window)
    done = []
    for view, led in pairs:
        bitmap = pattern_apertures(profile)[view].bitmap
        aperture = Aperture.of_bitmap(bitmap, profile)
        energy = np.eye(profile.dome.count)[led]
        unit = signal_per_mm2_s(profile) * aperture.area_mm2
        twin, twin_seen = (
            each.signal(bitmap.astype(float), energy)[window] / np.float32(unit)
            for each in (sharp, seen)
        )
        tracer.shine(led)
        halves = [
            photograph(tracer, aperture, frame, rays_per_pixel // 2, 2 * led + half)
            / np.float32(aperture.area_mm2)
            for half in range(2)
        ]
        mean: FloatImage = (halves[0] + halves[1]) * np.float32(0.5)
        noise = float(np.sqrt(np.mean((halves[0] - halves[1]) ** 2)) / 2)
        spread = diffracted(mean, aperture, profile.optics.wavelength_um, profile.pixel_um)
        hits = first_hits(tracer, aperture, frame, led)
        places = regions(hits, profile.pixel_um)
        done.append(Pair(view, led, mean, twin, spread, twin_seen, noise, places))
        LOGGER.info("aperture %d under LED %d", view, led)
    return done


def regions(hits: FirstHits, pixel_um: float) -> dict[str, BoolImage]:
    """Parts of a frame: at walls, at edges of shadows, in the light, in the shade."""
    near = np.ones((2 * EDGE_PX + 1,) * 2, dtype=np.uint8)
    little = np.ones((3, 3), dtype=np.uint8)
    jump = cv2.dilate(hits.height_um, little) - cv2.erode(hits.height_um, little)
    steep = (jump > 2 * _JUMP_PX * pixel_um) | (hits.level < _WALL_LEVEL)
    walls = _grown(steep, near)
    edges = _grown(hits.sees_led, near) & _grown(~hits.sees_led, near) & ~walls
    return {
        "in the light": hits.sees_led & ~walls & ~edges,
        "in the shade": ~hits.sees_led & ~walls & ~edges,
        "at edges of shadows": edges,
        "at walls": walls,
    }


def _grown(mask: NDArray[np.bool_], element: NDArray[np.uint8]) -> NDArray[np.bool_]:
    return np.asarray(cv2.dilate(mask.astype(np.uint8), element)) > 0


def figures(pair: Pair, *, seen: bool) -> list[Figures]:
    """Figures of every region and of the whole, with diffraction (``seen``) or without."""
    tracer = pair.tracer_seen if seen else pair.tracer
    twin = pair.twin_seen if seen else pair.twin
    places = {**pair.regions, "everywhere": np.ones(tracer.shape, dtype=bool)}
    rows = []
    for region, mask in places.items():
        if not mask.any():
            continue
        mean = float(tracer[mask].mean(dtype=np.float64))
        difference = (twin[mask] - tracer[mask]).astype(np.float64)
        rows.append(
            Figures(
                region,
                float(mask.mean()),
                mean,
                float(twin[mask].mean(dtype=np.float64)) / mean,
                float(np.sqrt(np.mean(difference**2))) / mean,
                float(np.median(np.abs(difference))) / mean,
            )
        )
    return rows
