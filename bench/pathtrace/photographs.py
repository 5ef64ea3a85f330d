"""Sets of photographs by the path tracer alone, for ``reliefscope import``: another renderer's word."""

from __future__ import annotations

import logging
import time
from collections.abc import Sequence
from pathlib import Path

import cv2
import numpy as np
import yaml
from bench.pathtrace.camera import Aperture, Frame, diffracted, photograph
from bench.pathtrace.tracer import Sample, Tracer

from reliefscope.models.instrument import CameraModel, InstrumentProfile
from reliefscope.models.plan import pattern_apertures
from reliefscope.units import FloatImage, RawImage

WHITE = 0.6
"""Signal, as a fraction of full scale, of a white level surface under an LED of 45 degrees elevation."""
BOUNCES = 4
LOGGER = logging.getLogger(__name__)


def photograph_set(
    sample: Sample,
    profile: InstrumentProfile,
    frame: Frame,
    folder: Path,
    *,
    rays_per_pixel: int = 16,
    seed: int = 1,
    views: Sequence[int] | None = None,
    name: str = "",
) -> Path:
    """Every view under every LED as 16-bit PNG with shot and read noise, and ``set.yml`` that describes them.

    All views get the same exposure per open area; the glass leaks nothing.  Slopes are those of the middle of the
    open pixels, directions those of the LEDs as seen from the focal point.
    """
    folder.mkdir(parents=True, exist_ok=True)
    leds = profile.dome.positions_mm
    tracer = Tracer(sample, leds, BOUNCES)
    generator = np.random.default_rng(seed)
    apertures = [Aperture.of_bitmap(a.bitmap, profile) for a in pattern_apertures(profile)]
    chosen = list(range(len(apertures)) if views is None else views)
    started = time.monotonic()
    for led in range(len(leds)):
        tracer.shine(led)
        for number, view in enumerate(chosen):
            aperture = apertures[view]
            key = seed * 10_000 + view * len(leds) + led
            light = photograph(tracer, aperture, frame, rays_per_pixel, key)
            light = diffracted(light, aperture, profile.optics.wavelength_um, frame.pixel_um)
            signal = light * np.float32(WHITE / np.sin(np.pi / 4) / aperture.area_mm2)
            counts = develop(signal, profile.camera, generator)
            cv2.imwrite(str(folder / f"view{number:02d}_led{led:02d}.png"), counts)
        LOGGER.info("LED %d of %d after %.0f s", led + 1, len(leds), time.monotonic() - started)
    low, high = float(sample.height_um.min()), float(sample.height_um.max())
    description = {
        "schema_version": 1,
        "sample": name,
        "notes": f"path tracer: {rays_per_pixel} rays per pixel, {BOUNCES} reflections, seed {seed}",
        "pixel_um": frame.pixel_um,
        "bit_depth": profile.camera.bit_depth,
        "black_level": profile.camera.black_level,
        "height_range_um": [float(np.floor(low - 10)), float(np.ceil(high + 10))],
        "pattern": "view{view:02d}_led{light:02d}.png",
        "views": [{"slope": list(apertures[view].mean_slope)} for view in chosen],
        "lights": [{"direction": [float(value) for value in position]} for position in leds],
    }
    path = folder / "set.yml"
    path.write_text(yaml.safe_dump(description, sort_keys=False), encoding="utf-8")
    return path


def develop(signal: FloatImage, camera: CameraModel, generator: np.random.Generator) -> RawImage:
    """Counts of a signal (fraction of the full well): photon noise, read noise, black level, rounding."""
    well = camera.full_well_electrons
    electrons = generator.poisson(np.maximum(signal, 0.0) * well).astype(np.float64)
    electrons += generator.normal(0.0, camera.read_noise_electrons, signal.shape)
    counts = np.minimum(electrons, well) / well * camera.full_scale
    counts += camera.black_level * camera.full_scale
    return np.clip(np.rint(counts), 0, camera.full_scale).astype(np.uint16)
