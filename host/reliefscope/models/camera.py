"""What a camera must do, and what a frame carries.

The shape follows the device conventions of the field (configure, arm, next frame, disarm), with times in
microseconds.  Frames are matched with exposure events by count, never by time, so a camera must deliver them
in order and must tell when one was lost.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol, runtime_checkable

from reliefscope.errors import CameraError
from reliefscope.models.instrument import Sensor
from reliefscope.units import RawImage


class CameraTimeout(CameraError):  # noqa: N818 - as TimeoutError's kin it names an event
    """No frame came in time; the camera may deliver it later."""


class CameraLostError(CameraError):
    """The camera does not answer any more: unplugged, or without power."""


class CameraBusyError(CameraError):
    """Refused in the camera's present state, or held by someone else."""


@dataclass(frozen=True, slots=True)
class Frame:
    """One exposure as the sensor saw it.

    ``raw`` is (H, W) uint8 or uint16, a mosaic where the sensor is a colour one.  ``frame_id`` counts the
    trigger pulses since the camera was armed, so that a gap in it is a lost frame.  ``time_us`` is the
    camera's own clock at the start of exposure.
    """

    raw: RawImage
    frame_id: int
    time_us: int
    exposure_us: int


@dataclass(frozen=True, slots=True)
class CameraInfo:
    """Identity of a camera and the form of its frames."""

    vendor: str
    model: str
    serial: str
    shape: tuple[int, int]
    """(rows, columns)."""
    sensor: Sensor
    bit_depth: int
    trigger_inputs: bool


@dataclass(frozen=True, slots=True)
class CameraSettings:
    """Settings of an exposure; what a camera returns is what it really uses."""

    exposure_us: int
    gain_db: float = 0.0
    trigger: bool = True
    """True: one frame per pulse on the trigger line; False: free-running preview."""


@runtime_checkable
class Camera(Protocol):
    """A camera.  Every call raises :class:`~reliefscope.errors.CameraError` where it fails."""

    @property
    def info(self) -> CameraInfo:
        """Identity and form of the frames."""

    @property
    def dropped(self) -> int:
        """Frames that the camera or its link lost since it was armed."""

    def configure(self, settings: CameraSettings) -> CameraSettings:
        """Set exposure, gain and trigger; return what was really set.  Refused while armed."""

    def arm(self) -> None:
        """Get ready for pulses (or start free-running); frame ids start anew at 0."""

    def next_frame(self, timeout_s: float) -> Frame:
        """The next frame in order; raises ``CameraTimeout`` after ``timeout_s`` without one."""

    def disarm(self) -> None:
        """Stop; frames not fetched are dropped."""

    def close(self) -> None:
        """Let go of the camera."""
