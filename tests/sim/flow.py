"""A small run on the simulated instrument, as a host would make it."""

from __future__ import annotations

from contextlib import contextmanager

import numpy as np

from reliefscope.camera import CameraSettings, open_camera
from reliefscope.device import Device, ExposureEvent, SequenceEvent, SequenceNews, Step
from reliefscope_sim.bench import Bench

SIZE = "size=96x72"
LEDS = 16
SHUT = 255
OFF = 255
SETTLED_US = 1_500_000
EXPOSURE_US = 20_000


def square(row: int, column: int, side: int = 4) -> np.ndarray:
    """Bitmap with one open square."""
    bitmap = np.zeros((64, 128), dtype=bool)
    bitmap[row : row + side, column : column + side] = True
    return bitmap


LEFT = square(30, 58)
RIGHT = square(30, 66)


def one_led(led: int, level: int = 4095) -> np.ndarray:
    """Levels with one LED on."""
    levels = np.zeros(LEDS, dtype=np.uint16)
    levels[led] = level
    return levels


def step(aperture: int, light: int, repeat: int = 1, settle_us: int = SETTLED_US) -> Step:
    return Step(
        aperture=aperture,
        light=light,
        repeat=repeat,
        settle_us=settle_us,
        exposure_us=EXPOSURE_US,
    )


@contextmanager
def instrument(options: str = "", name: str = "benchtop"):
    """Device, armed camera and bench, two apertures and two lights loaded."""
    url = f"sim://{name}?{SIZE}&{options}".rstrip("&")
    with Device.open(url) as device:
        camera = open_camera(url)
        bench = Bench.attach(url)
        try:
            for slot, bitmap in enumerate((LEFT, RIGHT)):
                device.load_aperture(slot, bitmap)
            for slot, led in enumerate((8, 12)):
                device.load_light(slot, one_led(led))
            camera.configure(CameraSettings(EXPOSURE_US))
            camera.arm()
            yield device, camera, bench
        finally:
            bench.release()
            camera.close()


def take(device, camera, steps, run_id: int = 1):
    """Run a table; (event, frame) of each exposure, paired by count."""
    device.load_steps(steps)
    device.start(run_id)
    taken = []
    while True:
        event = device.events(timeout_s=10.0)
        if isinstance(event, ExposureEvent):
            taken.append((event, camera.next_frame(timeout_s=1.0)))
        elif isinstance(event, SequenceEvent) and event.news is SequenceNews.FINISHED:
            return taken
