"""A camera whose use is written down."""

from __future__ import annotations

import zlib
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from reliefscope.camera.forwarding import ForwardingCamera
from reliefscope.models.camera import Camera, CameraSettings, Frame


class RecordedCamera(ForwardingCamera):
    """Passes everything on to ``camera`` and notes it: the request first, a frame when it came, with its CRC-32.

    ``note(request, content)`` is called in the thread that uses the camera.
    """

    def __init__(self, camera: Camera, note: Callable[[str, Mapping[str, Any]], None]) -> None:
        super().__init__(camera)
        self._note = note

    def configure(self, settings: CameraSettings) -> CameraSettings:
        """Set exposure, gain and trigger."""
        content = {
            "exposure_us": settings.exposure_us,
            "gain_db": settings.gain_db,
            "trigger": settings.trigger,
        }
        self._note("configure", content)
        return super().configure(settings)

    def arm(self) -> None:
        """Get ready."""
        self._note("arm", {})
        super().arm()

    def next_frame(self, timeout_s: float) -> Frame:
        """The next frame in order."""
        frame = super().next_frame(timeout_s)
        content = {
            "frame_id": frame.frame_id,
            "time_us": frame.time_us,
            "crc32": zlib.crc32(np.ascontiguousarray(frame.raw).data),
        }
        self._note("frame", content)
        return frame

    def disarm(self) -> None:
        """Stop."""
        self._note("disarm", {})
        super().disarm()
