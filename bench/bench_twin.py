"""Rendering of the simulated instrument, beside the same sum written with OpenCV and numpy.

Frames are counted over aperture/light pairs in plan order, none rendered before, noise included; the set-up (scene,
shadows and light between surfaces for every LED, whole-pupil images) is reported apart.  The peer warps the lit
surface once per open pixel with ``cv2.remap``, blurs with ``cv2.GaussianBlur`` and draws noise with numpy's generator;
it knows no occlusion and no leakage.

    python -m bench.bench_twin [--scene fiducial] [--finish dull] [--views 12]
"""

from __future__ import annotations

import argparse
import time

import cv2
import numpy as np
from numpy.typing import NDArray

from reliefscope.models.instrument import InstrumentProfile, load_profile
from reliefscope.models.plan import pattern_apertures
from reliefscope.units import FloatImage
from reliefscope_sim.as_built import AsBuilt
from reliefscope_sim.optics import Renderer
from reliefscope_sim.optics.pupil import Pupil
from reliefscope_sim.scenes import Scene, load_scene

PEER_FRAMES = 8


def run(scene: str = "fiducial", finish: str = "dull", views: int = 12) -> dict[str, float]:
    """Set-up (s), frames a second of the renderer and of its peer, and their ratio.

    Processor time per frame, over all cores, tells more than frames a second where others use the machine too.
    """
    profile = load_profile("benchtop")
    as_built = AsBuilt.draw(profile, 1)
    options = {"finish": finish} if scene == "fiducial" else {}
    bitmaps = [aperture.bitmap for aperture in pattern_apertures(profile)[:views]]
    leds = profile.dome.count
    shut = 1 / profile.glass.contrast_ratio

    started = time.perf_counter()
    sample = load_scene(scene, 1, options, shape=profile.shape, pixel_um=profile.pixel_um)
    renderer = Renderer(profile, sample, as_built)
    renderer.prepare()
    energies = np.eye(leds) * profile.exposure_ms / 1000
    for led in range(leds):
        renderer.expose(np.full(bitmaps[0].shape, shut), energies[led], 0.02, (1, led))
    setup_s = time.perf_counter() - started

    started, spent = time.perf_counter(), time.process_time()
    for view, bitmap in enumerate(bitmaps):
        transmission = np.where(bitmap, 1.0, shut)
        for led in range(leds):
            renderer.expose(transmission, energies[led], 0.02, (1, view, led))
    frames = len(bitmaps) * leds
    frames_per_s = frames / (time.perf_counter() - started)
    cpu_ms = 1000 * (time.process_time() - spent) / frames

    peer_per_s = PEER_FRAMES / _peer_s(profile, sample, as_built, bitmaps[0])
    return {
        "render_setup_s": setup_s,
        "render_frames_per_s": frames_per_s,
        "render_cpu_ms_per_frame": cpu_ms,
        "render_peer_frames_per_s": peer_per_s,
        "render_over_peer": frames_per_s / peer_per_s,
    }


def _peer_s(
    profile: InstrumentProfile, sample: Scene, as_built: AsBuilt, bitmap: NDArray[np.bool_]
) -> float:
    """Seconds for ``PEER_FRAMES`` frames of one aperture, maps included."""
    radiance: FloatImage = np.ascontiguousarray(
        sample.albedo.reshape(*sample.height_um.shape, -1)[..., 0]
    )
    points = Pupil(profile, as_built).pixels(bitmap)
    slopes = points.position_mm / (as_built.pupil_scale * profile.optics.objective_focal_mm)
    height_px = sample.height_um / np.float32(sample.pixel_um)
    rows, columns = np.indices(height_px.shape, dtype=np.float32)
    generator = np.random.default_rng(1)
    full = profile.camera.full_scale
    started = time.perf_counter()
    maps = [
        (columns + height_px * np.float32(sx), rows - height_px * np.float32(sy))
        for sx, sy in slopes
    ]
    for _ in range(PEER_FRAMES):
        total: FloatImage = np.zeros_like(radiance)
        for across, down in maps:
            total += cv2.remap(radiance, across, down, cv2.INTER_LINEAR)
        image = cv2.GaussianBlur(total, (0, 0), 2.2) * np.float32(2000.0)
        noisy = image + np.sqrt(image + 64) * generator.standard_normal(image.shape, np.float32)
        np.clip(noisy, 0, full).astype(np.uint16)
    return time.perf_counter() - started


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scene", default="fiducial", help="name of the scene")
    parser.add_argument("--finish", default="dull", help="finish of the fiducial")
    parser.add_argument("--views", type=int, default=12, help="apertures to render, 1 to 12")
    arguments = parser.parse_args()
    for name, value in run(arguments.scene, arguments.finish, arguments.views).items():
        print(f"{name:28s} {value:10.4g}")


if __name__ == "__main__":
    main()
