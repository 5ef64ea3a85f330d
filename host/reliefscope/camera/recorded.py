"""A camera whose use is written down."""

from __future__ import annotations

import zlib
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from reliefscope.models.camera import Camera, CameraInfo, CameraSettings, Frame


class RecordedCamera:
    """Passes everything on to ``camera`` and notes it: the request first, a frame when it came, with its CRC-32.

    ``note(request, content)`` is called in the thread that uses the camera.
    """

    def __init__(self, camera: Camera, note: Callable[[str, Mapping[str, Any]], None]) -> None:
        self._camera = camera
        self._note = note

    @property
    def info(self) -> CameraInfo:
        """Identity and form of the frames."""
        return self._camera.info

    @property
    def dropped(self) -> int:
        """Frames lost since it was armed."""
        return self._camera.dropped

    def configure(self, settings: CameraSettings) -> CameraSettings:
        """Set exposure, gain and trigger."""
        content = {
            "exposure_us": settings.exposure_us,
            "gain_db": settings.gain_db,
            "trigger": settings.trigger,
        }
        self._note("configure", content)
        return self._camera.configure(settings)

    def arm(self) -> None:
        """Get ready."""
        self._note("arm", {})
        self._camera.arm()

    def next_frame(self, timeout_s: float) -> Frame:
        """The next frame in order."""
        frame = self._camera.next_frame(timeout_s)
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
        self._camera.disarm()

    def close(self) -> None:
        """Let go of the camera."""
        self._camera.close()
