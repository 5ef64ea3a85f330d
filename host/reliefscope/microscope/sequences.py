"""Parts of an acquisition that the microscope adds: what a plan takes, one exposure, frames seen twice."""

from __future__ import annotations

import random
from collections.abc import Callable
from typing import Any

from reliefscope.camera.forwarding import ForwardingCamera
from reliefscope.device import Device, ExposureEvent, FaultEvent, SequenceEvent, SequenceNews, Step
from reliefscope.device.sequence import SequenceTiming, sequence_duration_s
from reliefscope.errors import DeviceError
from reliefscope.microscope.instruments import Instrument
from reliefscope.models.camera import Camera, Frame
from reliefscope.models.plan import Plan
from reliefscope.units import format_bytes, format_duration


def summarise_plan(plan: Plan, instrument: Instrument) -> dict[str, Any]:
    """What a plan takes with an instrument, for people and programs."""
    profile = instrument.profile
    requests = list(plan.requests())
    rows, columns = profile.shape
    duration_s = plan.duration_s(1 / profile.camera.frames_per_s)
    size = len(requests) * rows * columns * 2
    return {
        "instrument": profile.name,
        "calibration": instrument.calibration_from,
        "views": len(plan.views),
        "lights": len(plan.lights),
        "images": len(requests),
        "exposures": sum(request.accumulate for request in requests),
        "frame": f"{columns} x {rows} px",
        "exposure_ms": plan.exposure_us / 1000,
        "settle_ms": plan.settle_ms,
        "duration": f"about {format_duration(duration_s)}",
        "disk": f"up to {format_bytes(size)}",
    }


def expose_once(device: Device, camera: Camera, step: Step) -> Frame:
    """Let the device step through one exposure and fetch its frame from the armed camera.

    Raises
    ------
    DeviceError, CameraError
        If the device latches a fault or ends the sequence, or the camera delivers nothing.
    """
    device.load_steps([step])
    timing = SequenceTiming()
    device.start(random.randrange(1, 1 << 32), timing=timing)
    wait_s = sequence_duration_s([step], timing) + 5.0
    while True:
        event = device.events(wait_s)
        if isinstance(event, FaultEvent):
            raise DeviceError(
                f"The device stopped: {event.reason.description}",
                hint=f"Likely cause: {event.reason.cause} Next: {event.reason.next_step}",
            )
        if isinstance(event, ExposureEvent):
            frame = camera.next_frame(wait_s)
        elif isinstance(event, SequenceEvent) and event.news is SequenceNews.FINISHED:
            return frame
        elif isinstance(event, SequenceEvent) and event.news is SequenceNews.ABORTED:
            raise DeviceError("The exposure was ended before it was made.", hint="Take it again.")


def watched(camera: Camera, on_frame: Callable[[Frame], None]) -> Camera:
    """The camera, whose frames ``on_frame`` sees as well, from the thread that fetches them."""
    return _WatchedCamera(camera, on_frame)


class _WatchedCamera(ForwardingCamera):
    """A camera whose frames somebody else sees as well."""

    def __init__(self, camera: Camera, on_frame: Callable[[Frame], None]) -> None:
        super().__init__(camera)
        self._on_frame = on_frame

    def next_frame(self, timeout_s: float) -> Frame:
        frame = super().next_frame(timeout_s)
        self._on_frame(frame)
        return frame
