"""Camera of a simulated instrument in another process: ``sim+tcp://HOST:PORT/camera``."""

from __future__ import annotations

import json
import socket
from typing import Any
from urllib.parse import urlsplit

import numpy as np

from reliefscope.errors import CameraError, InvalidInputError
from reliefscope.models.camera import (
    CameraBusyError,
    CameraInfo,
    CameraLostError,
    CameraSettings,
    CameraTimeout,
    Frame,
)

SPARE_S = 10.0
"""Time beyond what an answer must take, before the server counts as gone."""
_ERRORS: dict[str, type[CameraError]] = {
    kind.__name__: kind for kind in (CameraTimeout, CameraLostError, CameraBusyError)
}


class RemoteCamera:
    """Client of :class:`reliefscope_sim.serve.InstrumentServer`; see :class:`reliefscope.models.camera.Camera`."""

    def __init__(self, url: str) -> None:
        parts = urlsplit(url)
        if parts.hostname is None or parts.port is None or parts.path not in {"", "/camera"}:
            raise InvalidInputError(
                f"`{url}` is no camera address.",
                hint="Write sim+tcp://HOST:PORT/camera, as `reliefscope sim serve` prints it.",
            )
        self._url = url
        try:
            self._socket = socket.create_connection((parts.hostname, parts.port), SPARE_S)
        except OSError as error:
            raise CameraError(
                f"No camera answers at {url}: {error.strerror or error}.",
                hint="Start it with `reliefscope sim serve`, and use the address that it prints.",
            ) from error
        self._stream = self._socket.makefile("rwb")
        self._dropped = 0
        try:
            reply, _ = self._ask("info")
        except BaseException:
            self.close()
            raise
        info = reply["info"]
        self._info = CameraInfo(**{**info, "shape": tuple(info["shape"])})

    @property
    def info(self) -> CameraInfo:
        """Identity and form of the frames."""
        return self._info

    @property
    def dropped(self) -> int:
        """Frames lost since it was armed, as of now."""
        self._ask("info")
        return self._dropped

    def configure(self, settings: CameraSettings) -> CameraSettings:
        """Set exposure, gain and trigger; return what was really set."""
        reply, _ = self._ask(
            "configure",
            exposure_us=settings.exposure_us,
            gain_db=settings.gain_db,
            trigger=settings.trigger,
        )
        return CameraSettings(**reply["settings"])

    def arm(self) -> None:
        """Get ready for pulses, or start free-running."""
        self._ask("arm")

    def next_frame(self, timeout_s: float) -> Frame:
        """The next frame in order.

        Raises
        ------
        CameraTimeout
            After ``timeout_s`` without one.
        CameraLostError
            If the camera was unplugged or its server is gone.
        """
        reply, pixels = self._ask("next_frame", wait_s=timeout_s, timeout_s=timeout_s)
        head = reply["frame"]
        dtype = np.dtype(head["dtype"])
        raw = np.frombuffer(pixels, dtype.newbyteorder("<")).reshape(head["shape"])
        return Frame(raw.astype(dtype), head["frame_id"], head["time_us"], head["exposure_us"])

    def disarm(self) -> None:
        """Stop; frames not fetched are dropped."""
        self._ask("disarm")

    def close(self) -> None:
        """Let go of the camera; closing twice does no harm."""
        self._stream.close()
        self._socket.close()

    def _ask(
        self, name: str, wait_s: float = 0.0, **arguments: Any
    ) -> tuple[dict[str, Any], bytes]:
        if self._stream.closed:
            raise ValueError("the camera is closed")
        try:
            self._socket.settimeout(wait_s + SPARE_S)
            self._stream.write(json.dumps({"do": name, **arguments}).encode() + b"\n")
            self._stream.flush()
            reply = json.loads(self._stream.readline())
            size = reply.get("bytes", 0)
            data = self._stream.read(size)
            if len(data) < size:
                raise EOFError("the connection ended within a frame")
        except (OSError, EOFError, ValueError) as error:
            raise CameraLostError(
                f"The camera at {self._url} is gone.",
                hint="Is `reliefscope sim serve` still running?",
            ) from error
        if "error" in reply:
            kind = _ERRORS.get(reply["error"], CameraError)
            raise kind(reply["message"], hint=reply["hint"])
        self._dropped = reply.get("dropped", self._dropped)
        return reply, data


def open_camera(url: str) -> RemoteCamera:
    """Camera at ``sim+tcp://HOST:PORT/camera``."""
    return RemoteCamera(url)
