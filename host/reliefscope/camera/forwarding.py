"""A camera in front of another one: what wrappers have in common."""

from __future__ import annotations

from reliefscope.models.camera import Camera, CameraInfo, CameraSettings, Frame


class ForwardingCamera:
    """Passes everything on to ``camera``; a wrapper overrides what it watches."""

    def __init__(self, camera: Camera) -> None:
        self._camera = camera

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
        return self._camera.configure(settings)

    def arm(self) -> None:
        """Get ready."""
        self._camera.arm()

    def next_frame(self, timeout_s: float) -> Frame:
        """The next frame in order."""
        return self._camera.next_frame(timeout_s)

    def disarm(self) -> None:
        """Stop."""
        self._camera.disarm()

    def close(self) -> None:
        """Let go of the camera."""
        self._camera.close()
