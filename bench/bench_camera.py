"""The simulated instrument through the faces that a host uses: serial port and camera.

Frames are counted through the camera API on aperture/light pairs that were never rendered before, stepped by the
firmware in plan order (12 apertures x 16 lights), noise included.  Set-up is everything until the first aperture has
been seen under every light: starting the device, making the scene, shadows and light between surfaces and leakage of
every LED.  Each scene gets a process of its own, so that peak memory is its own, and importing counts.  Processor
time, over all cores, stands beside wall time, because other work on the machine lengthens the latter.

    python -m bench.bench_camera [--options "scene=fiducial&finish=dull"] [--views 12]
"""

from __future__ import annotations

import argparse
import multiprocessing
import resource
import sys
import time

import numpy as np

from reliefscope.camera import CameraSettings, open_camera
from reliefscope.device import Device, ExposureEvent, Step
from reliefscope.models.instrument import load_profile
from reliefscope.models.plan import pattern_apertures

EXPOSURE_US = 20_000
SETTLE_US = 400_000
REQUESTS = 1000
SCENES = {
    "fiducial": "scene=fiducial&finish=metallic",
    "regolith": "scene=regolith&scene.grains=500",
}
"""Options of each scene whose figures :func:`run` gives: the dearest finish, and 500 grains."""


def measure(options: str, views: int = 12) -> dict[str, float]:
    """Figures of one scene, of the process that calls."""
    started = time.perf_counter()
    profile = load_profile("benchtop")
    lights = profile.dome.count
    url = f"sim://benchtop?{options}"
    with Device.open(url) as device:
        camera = open_camera(url)
        try:
            opened_s = time.perf_counter() - started
            for slot, aperture in enumerate(pattern_apertures(profile)[:views]):
                device.load_aperture(slot, aperture.bitmap)
            for light in range(lights):
                levels = np.zeros(lights, dtype=np.uint16)
                levels[light] = profile.dome.full_level
                device.load_light(light, levels)
            device.load_steps(
                [
                    Step(view, light, 1, SETTLE_US if light == 0 else 1000, EXPOSURE_US)
                    for view in range(views)
                    for light in range(lights)
                ]
            )
            camera.configure(CameraSettings(EXPOSURE_US))
            camera.arm()
            device.start(1)
            moments: list[float] = []
            cpu: list[float] = []
            device_times: list[float] = []
            while len(moments) < views * lights:
                event = device.events(timeout_s=10.0)
                if isinstance(event, ExposureEvent):
                    frame = camera.next_frame(timeout_s=1.0)
                    moments.append(time.perf_counter())
                    cpu.append(time.process_time())
                    device_times.append(frame.time_us / 1e6)
            before = time.perf_counter()
            for _ in range(REQUESTS):
                device.status()
            requests_s = REQUESTS / (time.perf_counter() - before)
        finally:
            camera.close()
    first, frames = lights - 1, (views - 1) * lights
    measured_s = moments[-1] - moments[first]
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return {
        "fps": frames / measured_s,
        "cpu_ms_per_frame": 1000 * (cpu[-1] - cpu[first]) / frames,
        "opened_s": opened_s,
        "setup_s": moments[first] - started,
        "setup_cpu_s": cpu[first],
        "peak_mb": peak / (1e6 if sys.platform == "darwin" else 1e3),
        "time_over_wall_time": (device_times[-1] - device_times[first]) / measured_s,
        "requests_per_s": requests_s,
    }


def run(views: int = 6) -> dict[str, float]:
    """``twin_fps_fiducial``, ``twin_fps_regolith`` and the other figures of :func:`measure` for each scene."""
    context = multiprocessing.get_context("spawn")
    figures: dict[str, float] = {}
    for name, options in SCENES.items():
        with context.Pool(1) as pool:
            measured = pool.apply(measure, (options, views))
        figures |= {f"twin_{key}_{name}": value for key, value in measured.items()}
    return figures


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--options", help="options of the sim:// address; both scenes where absent")
    parser.add_argument("--views", type=int, default=12, help="apertures to take, 2 to 12")
    arguments = parser.parse_args()
    options, views = arguments.options, arguments.views
    figures = run(views) if options is None else measure(options, views)
    for name, value in figures.items():
        print(f"{name:36s} {value:10.4g}")


if __name__ == "__main__":
    main()
