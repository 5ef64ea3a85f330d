"""The simulated instrument through the faces that a host uses: serial port and camera.

Frames are counted through the camera API on aperture/light pairs that were never rendered before, stepped by the
firmware in plan order (12 apertures x 16 lights), noise included.  The first aperture warms up compiled kernels and the
lighting of every LED; its time is reported as set-up.

    python -m bench.bench_camera [--options "scene=fiducial&finish=dull"] [--views 12]
"""

from __future__ import annotations

import argparse
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


def run(options: str = "scene=fiducial", views: int = 12) -> dict[str, float]:
    """Set-up (s), frames a second, requests a second, device time over wall time, peak memory (MB)."""
    profile = load_profile("benchtop")
    lights = profile.dome.count
    url = f"sim://benchtop?{options}"
    started = time.perf_counter()
    with Device.open(url) as device:
        camera = open_camera(url)
        try:
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
            moments, device_times = [started], []
            while len(moments) <= views * lights:
                event = device.events(timeout_s=10.0)
                if isinstance(event, ExposureEvent):
                    frame = camera.next_frame(timeout_s=1.0)
                    moments.append(time.perf_counter())
                    device_times.append(frame.time_us / 1e6)
            before = time.perf_counter()
            for _ in range(REQUESTS):
                device.status()
            requests_s = REQUESTS / (time.perf_counter() - before)
        finally:
            camera.close()
    measured_s = moments[-1] - moments[lights]
    return {
        "twin_setup_s": moments[lights] - moments[0],
        "twin_frames_per_s": (views - 1) * lights / measured_s,
        "twin_time_over_wall_time": (device_times[-1] - device_times[lights - 1]) / measured_s,
        "twin_requests_per_s": requests_s,
        "twin_peak_memory_mb": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        / (1e6 if sys.platform == "darwin" else 1e3),
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--options", default="scene=fiducial", help="options of the sim:// address")
    parser.add_argument("--views", type=int, default=12, help="apertures to take, 2 to 12")
    arguments = parser.parse_args()
    for name, value in run(arguments.options, arguments.views).items():
        print(f"{name:28s} {value:10.4g}")


if __name__ == "__main__":
    main()
