"""A microscope that only remembers what it was told, for tests of the screen."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np

from reliefscope.errors import DeviceError
from reliefscope.jobs import Job
from reliefscope.models.calibration import Calibration
from reliefscope.models.camera import CameraInfo, Frame
from reliefscope.models.instrument import load_profile
from reliefscope.models.plan import Aperture, Plan, default_plan


class FakeMicroscope:
    """Has the face of :class:`reliefscope.microscope.Microscope`; every command is noted in ``calls``."""

    def __init__(self, url: str, shape: tuple[int, int] = (72, 96)) -> None:
        self.profile = load_profile("benchtop").resized(shape[1], shape[0])
        self.calibration = Calibration.nominal(self.profile)
        self.device = SimpleNamespace(url=url)
        self.identity = SimpleNamespace(board="host", firmware_version="0.1.0")
        self.instrument = SimpleNamespace(calibration_from="nominal")
        self.live_exposure_us = 20_000
        self.has_camera = True
        self.camera_info = CameraInfo("fake", "Fake camera", "1", shape, "bayer_rggb", 12, True)
        self.aperture = np.zeros((64, 128), bool)
        self.aperture_name = "shut"
        self.light: dict[int, int] = {}
        self.calls: list[tuple[Any, ...]] = []
        self.refuse: DeviceError | None = None
        self.hold = threading.Event()
        """While clear, an acquisition waits before each frame."""
        self.hold.set()
        y, x = np.mgrid[0 : shape[0], 0 : shape[1]]
        self._scene = 2000 + 1200 * np.sin(x / 7) + 700 * np.cos(y / 5 + x / 19)

    def _call(self, *call: Any) -> None:
        self.calls.append(call)
        if self.refuse is not None:
            raise self.refuse

    def show_aperture(self, aperture: Aperture) -> None:
        self._call("show_aperture", aperture.name)
        self.aperture, self.aperture_name = aperture.bitmap, aperture.name

    def shut(self) -> None:
        self._call("shut")
        self.aperture, self.aperture_name = np.zeros((64, 128), bool), "shut"

    def set_light(self, levels: Mapping[int, int]) -> None:
        self._call("set_light", dict(levels))
        self.light = dict(levels)

    def all_off(self) -> None:
        self.calls.append(("all_off",))
        self.light = {}

    def keep_alive(self) -> None:
        pass

    def close(self) -> None:
        self.calls.append(("close",))

    def _frame(self, number: int) -> Frame:
        brightness = 0.1 + 0.9 * min(len(self.light), 1)
        return Frame((self._scene * brightness).astype(np.uint16), number, number * 66_000, 20_000)

    def live(self, stop: threading.Event) -> Iterator[Frame]:
        number = 0
        while not stop.is_set():
            yield self._frame(number)
            number += 1

    def default_plan(self) -> Plan:
        return default_plan(self.profile)

    def plan_summary(self, plan: Plan) -> dict[str, Any]:
        return {"views": len(plan.views), "lights": len(plan.lights), "duration": "about 1.0 s"}

    def acquire(
        self,
        plan: Plan,
        out: Path | None,
        *,
        job: Job,
        sample: str,
        notes: str,
        on_frame: Callable[[Frame], None],
    ) -> Any:
        self._call("acquire", out, sample, notes)
        with job.stage("acquire", 12) as stage:
            for number in range(12):
                self.hold.wait(5)
                job.check()
                on_frame(self._frame(number))
                stage.advance(note=f"view {number}")
        return SimpleNamespace(path=out)
