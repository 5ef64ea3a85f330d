"""A small simulated instrument and a small plan for it."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from reliefscope.acquisition import acquire, resume
from reliefscope.camera import open_camera
from reliefscope.dataset import Run
from reliefscope.device import Device, ExposureEvent
from reliefscope.jobs import Job
from reliefscope.models.calibration import Calibration
from reliefscope.models.camera import Camera, Frame
from reliefscope.models.instrument import InstrumentProfile, load_profile
from reliefscope.models.plan import Plan, default_plan

COLUMNS, ROWS = 64, 48
_names = itertools.count()


def small_profile() -> InstrumentProfile:
    return load_profile("benchtop").resized(COLUMNS, ROWS)


def small_plan(views: int = 2, lights: int = 3, **changes: object) -> Plan:
    """Dark, one leakage frame a light, views x lights, centre; 8 lights sum into 4 exposures each."""
    plan = default_plan(small_profile())
    chosen: dict[str, object] = {
        "views": plan.views[:views],
        "lights": plan.lights[:lights],
        "dark_accumulate": 4,
        "leakage_accumulate": 3,
    }
    return plan.model_copy(update=chosen | changes)


def url(fault: str = "", name: str = "") -> str:
    name = name or f"acquisition-{next(_names)}"
    return f"sim://{name}?scene=plane&size={COLUMNS}x{ROWS}&fault={fault}"


@dataclass
class Instrument:
    device: Device
    camera: Camera
    profile: InstrumentProfile
    calibration: Calibration

    def acquire(self, out: Path, plan: Plan | None = None, job: Job | None = None) -> Run:
        return acquire(
            self.device,
            self.camera,
            plan or small_plan(),
            self.profile,
            self.calibration,
            out,
            job,
            sample="tilted plane",
        )

    def resume(self, run: Path, job: Job | None = None) -> Run:
        return resume(run, self.device, self.camera, job)


@contextmanager
def instrument(fault: str = "", name: str = "") -> Iterator[Instrument]:
    address = url(fault, name)
    profile = small_profile()
    with Device.open(address) as device:
        camera = open_camera(address)
        try:
            yield Instrument(device, camera, profile, Calibration.nominal(profile))
        finally:
            camera.close()


class OtherDevice:
    """The device with some of its answers changed."""

    def __init__(self, device: Device, event: Callable[[Any], Any] | None = None, **identity: int):
        self._device = device
        self._change = event
        self.identity = replace(device.identity, **identity)

    def events(self, timeout_s: float) -> Any:
        event = self._device.events(timeout_s)
        return self._change(event) if self._change and isinstance(event, ExposureEvent) else event

    def __getattr__(self, name: str) -> Any:
        return getattr(self._device, name)


class OtherCamera:
    """The camera with some of its frames changed."""

    def __init__(self, camera: Camera, frame: Callable[[Frame], Frame]) -> None:
        self._camera = camera
        self._change = frame

    def next_frame(self, timeout_s: float) -> Frame:
        return self._change(self._camera.next_frame(timeout_s))

    def __getattr__(self, name: str) -> Any:
        return getattr(self._camera, name)
