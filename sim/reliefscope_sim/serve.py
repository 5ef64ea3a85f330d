"""A simulated instrument for other processes: its serial port over TCP or a pseudo-terminal, its camera over TCP.

The device's port carries plain bytes, as ``socket://HOST:PORT`` of pyserial wants them.  The camera's port speaks
lines: each request is one JSON object on a line, each reply one JSON object on a line, after which ``bytes`` raw
bytes follow where the reply says so (docs/reference/simulated-instrument.md lists the requests).  Time is real.
"""

from __future__ import annotations

import contextlib
import io
import json
import logging
import os
import socket
import sys
import threading
from collections.abc import Callable
from dataclasses import asdict
from typing import Any, Self

from reliefscope.errors import DeviceError, InvalidInputError, ReliefscopeError
from reliefscope.models.camera import CameraSettings
from reliefscope_sim.bench import Bench
from reliefscope_sim.camera import SimCamera
from reliefscope_sim.url import SimUrl

logger = logging.getLogger(__name__)

REMOTE_SCHEME = "sim+tcp"
LOOPBACK = "127.0.0.1"
_PIECE = 4096
_LOOK_US = 50_000
"""How long a pump waits for bytes of the device before it looks whether it has to end."""
_REPLUG_S = 1.0
"""Time after which a pseudo-terminal is plugged in again when the link broke; nobody can do it by hand."""


class InstrumentServer:
    """Serves the instrument at ``url`` until it is closed; a context manager.

    Parameters
    ----------
    url:
        ``sim://NAME?...``; its time is real whatever it says not.
    host:
        Interface to listen on; nothing is encrypted or asked for a password.
    port, camera_port:
        TCP ports, 0 for any free one.
    terminal:
        Offer the device on a pseudo-terminal instead of a TCP port.

    Raises
    ------
    InvalidInputError
        If the address is wrong, asks for virtual time, or the system has no pseudo-terminals.
    DeviceError
        If a port is taken.
    """

    def __init__(
        self,
        url: str,
        *,
        host: str = LOOPBACK,
        port: int = 0,
        camera_port: int = 0,
        terminal: bool = False,
    ) -> None:
        self.url = in_real_time(url)
        self._stop = threading.Event()
        self._threads: list[threading.Thread] = []
        self._open = contextlib.ExitStack()
        with contextlib.ExitStack() as undo:
            self._bench = Bench.attach(self.url)
            undo.callback(self._bench.release)
            self.profile = self._bench.profile
            self._camera_socket = undo.enter_context(_listen(host, camera_port))
            if terminal:
                self._master, self.device_url = _open_terminal(undo)
                self._run("device", self._serve_terminal)
            else:
                self._device_socket = undo.enter_context(_listen(host, port))
                self.device_url = f"socket://{_address(self._device_socket)}"
                self._run("device", lambda: self._accept(self._device_socket, self._serve_socket))
            self.camera_url = f"{REMOTE_SCHEME}://{_address(self._camera_socket)}/camera"
            self._run("camera", lambda: self._accept(self._camera_socket, self._serve_camera))
            self._open = undo.pop_all()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """End all connections and switch the instrument off; closing twice does no harm."""
        self._stop.set()
        for thread in self._threads:
            thread.join()
        self._open.close()

    def _run(self, name: str, work: Callable[[], None]) -> None:
        thread = threading.Thread(target=work, name=f"serve-{name}", daemon=True)
        self._threads.append(thread)
        thread.start()

    def _accept(self, listener: socket.socket, serve: Callable[[socket.socket], None]) -> None:
        """Serve one client after the other; a second one at the same time finds its connection closed."""
        busy: threading.Thread | None = None
        while not self._stop.is_set():
            # Time goes on while nobody is connected.
            self._bench.poll()
            with contextlib.suppress(TimeoutError):
                client, address = listener.accept()
                if busy is not None and busy.is_alive():
                    logger.warning("refused %s: somebody else is connected", address)
                    client.close()
                    continue
                logger.info("connected: %s", address)
                client.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
                busy = threading.Thread(
                    target=self._guard, args=(serve, client), name="serve-client", daemon=True
                )
                busy.start()
        if busy is not None:
            busy.join()

    def _guard(self, serve: Callable[[socket.socket], None], client: socket.socket) -> None:
        try:
            with client:
                serve(client)
        except OSError as error:  # the client went away
            logger.info("connection ended: %s", error)

    # --- the device ---

    def _serve_socket(self, client: socket.socket) -> None:
        client.settimeout(_LOOK_US / 1e6)
        if not self._bench.open_port():
            return
        gone = threading.Event()
        sender = threading.Thread(target=self._forward, args=(client.sendall, gone), daemon=True)
        sender.start()
        try:
            while not (gone.is_set() or self._stop.is_set()):
                with contextlib.suppress(TimeoutError):
                    data = client.recv(_PIECE)
                    if not data:
                        return
                    self._bench.send(data, _LOOK_US)
        finally:
            gone.set()
            sender.join()
            self._bench.close_port()

    def _forward(self, write: Callable[[bytes], object], gone: threading.Event) -> None:
        """Bytes of the device to the client, until one of them is gone."""
        while not (gone.is_set() or self._stop.is_set()):
            data = self._bench.receive(1, _LOOK_US, gone.is_set)
            data += self._bench.receive(_PIECE, 0, gone.is_set) if data else b""
            try:
                if data:
                    write(data)
            except OSError:
                gone.set()
            if self._bench.cable.broken and not data:
                gone.set()

    def _serve_terminal(self) -> None:
        while not self._stop.is_set():
            if not self._bench.open_port():
                raise DeviceError("The port of the simulated instrument is taken.")
            gone = threading.Event()
            sender = threading.Thread(
                target=self._forward, args=(lambda data: os.write(self._master, data), gone)
            )
            sender.start()
            try:
                while not (gone.is_set() or self._stop.is_set()):
                    if _readable(self._master):
                        self._bench.send(os.read(self._master, _PIECE), _LOOK_US)
            finally:
                gone.set()
                sender.join()
                self._bench.close_port()
            self._stop.wait(_REPLUG_S)

    # --- the camera ---

    def _serve_camera(self, client: socket.socket) -> None:
        with client.makefile("rwb") as stream:
            try:
                camera = SimCamera(self.url)
            except ReliefscopeError as error:
                _reply(stream, _refusal(error))
                return
            closer = threading.Thread(target=self._close_when_stopped, args=(client, camera))
            closer.start()
            try:
                for line in stream:
                    _reply(stream, *_answer(camera, line))
            finally:
                camera.close()
                closer.join()

    def _close_when_stopped(self, client: socket.socket, camera: SimCamera) -> None:
        while camera.is_open:
            if self._stop.wait(_LOOK_US / 1e6):
                with contextlib.suppress(OSError):
                    client.shutdown(socket.SHUT_RDWR)
                return


def in_real_time(url: str) -> str:
    """The address with ``time=real``, which serving needs."""
    parsed = SimUrl.parse(url)
    given = dict(parsed.given)
    if given.get("time") == "virtual":
        raise InvalidInputError(
            "An instrument for other processes cannot run in virtual time.",
            hint="Leave `time=virtual` out: time is real when an instrument is served.",
        )
    if "time" in given:
        return url
    return f"{url}{'&' if '?' in url else '?'}time=real"


def _listen(host: str, port: int) -> socket.socket:
    try:
        listener = socket.create_server((host, port), backlog=1)
    except OSError as error:
        raise DeviceError(
            f"Port {port} of {host} cannot be listened on: {error.strerror or error}.",
            hint="Choose another port, or 0 for any that is free.",
        ) from error
    listener.settimeout(_LOOK_US / 1e6)
    return listener


def _address(listener: socket.socket) -> str:
    host, port = listener.getsockname()[:2]
    return f"{host}:{port}"


def _open_terminal(undo: contextlib.ExitStack) -> tuple[int, str]:
    """Descriptor of the instrument's end, and the name of the client's."""
    if sys.platform == "win32":
        raise InvalidInputError(
            "This system has no pseudo-terminals.", hint="Serve the device on a TCP port."
        )
    import tty

    master, slave = os.openpty()
    for descriptor in (
        master,
        slave,
    ):  # the client's end stays open: it comes and goes without a hang-up
        undo.callback(os.close, descriptor)
    tty.setraw(slave)
    return master, os.ttyname(slave)


def _readable(descriptor: int) -> bool:
    import select

    return bool(select.select([descriptor], [], [], _LOOK_US / 1e6)[0])


def _reply(stream: io.BufferedRWPair, content: dict[str, Any], data: bytes = b"") -> None:
    stream.write(json.dumps(content).encode() + b"\n" + data)
    stream.flush()


def _answer(camera: SimCamera, line: bytes) -> tuple[dict[str, Any], bytes]:
    try:
        request = json.loads(line)
        name, arguments = request.pop("do"), request
        if name not in _REQUESTS:
            raise InvalidInputError(
                f"There is no request `{name}`.", hint=f"Known: {', '.join(_REQUESTS)}."
            )
        return _REQUESTS[name](camera, **arguments)
    except ReliefscopeError as error:
        return _refusal(error), b""
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        wrong = InvalidInputError(
            f"`{line[:80].decode(errors='replace').strip()}` is no request: {error}.",
            hint='Send one JSON object a line, as in {"do": "info"}.',
        )
        return _refusal(wrong), b""


def _refusal(error: ReliefscopeError) -> dict[str, Any]:
    return {"error": type(error).__name__, "message": error.message, "hint": error.hint}


def _info(camera: SimCamera) -> tuple[dict[str, Any], bytes]:
    return {"info": asdict(camera.info), "dropped": camera.dropped}, b""


def _configure(camera: SimCamera, **settings: Any) -> tuple[dict[str, Any], bytes]:
    return {"settings": asdict(camera.configure(CameraSettings(**settings)))}, b""


def _arm(camera: SimCamera) -> tuple[dict[str, Any], bytes]:
    camera.arm()
    return {}, b""


def _disarm(camera: SimCamera) -> tuple[dict[str, Any], bytes]:
    camera.disarm()
    return {}, b""


def _next_frame(camera: SimCamera, timeout_s: float) -> tuple[dict[str, Any], bytes]:
    frame = camera.next_frame(timeout_s)
    pixels = frame.raw.astype(frame.raw.dtype.newbyteorder("<"), order="C").tobytes()
    head = {
        "frame_id": frame.frame_id,
        "time_us": frame.time_us,
        "exposure_us": frame.exposure_us,
        "shape": list(frame.raw.shape),
        "dtype": frame.raw.dtype.name,
    }
    return {"frame": head, "dropped": camera.dropped, "bytes": len(pixels)}, pixels


_REQUESTS: dict[str, Callable[..., tuple[dict[str, Any], bytes]]] = {
    "info": _info,
    "configure": _configure,
    "arm": _arm,
    "next_frame": _next_frame,
    "disarm": _disarm,
}
