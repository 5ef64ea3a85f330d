"""The compiled core in virtual time, and a host that speaks to it through the other implementation of the wire."""

import ctypes
import zlib
from ctypes import c_size_t, c_uint32, c_uint64, c_void_p
from pathlib import Path
from typing import NamedTuple, Self

from reliefscope.protocol.framing import Frame, FrameReader
from reliefscope.protocol.messages import (
    MESSAGES,
    ApertureChunkRequest,
    CommitApertureRequest,
    CommitStepsRequest,
    LoadLightRequest,
    StartRequest,
    StepChunkRequest,
)

NONCE = 0x5EED5EED
FIRST_ANSWER = 0x80


def frame(request, request_id: int, nonce: int = NONCE) -> bytes:
    """A request on the wire."""
    return Frame(request.ID, request_id, nonce, request.pack()).encode()


class Record(NamedTuple):
    """One record of the trace."""

    kind: int
    argument: int
    time_us: int
    payload: bytes


def load(path: Path) -> ctypes.CDLL:
    """The library with the signatures of reliefscope_host.h."""
    loaded = ctypes.CDLL(str(path))
    loaded.rs_create.restype = c_void_p
    loaded.rs_create.argtypes = [c_void_p, c_size_t, c_uint32]
    loaded.rs_destroy.argtypes = [c_void_p]
    loaded.rs_destroy.restype = None
    loaded.rs_reset.argtypes = [c_void_p, c_uint32, c_uint32]
    loaded.rs_reset.restype = None
    loaded.rs_run_until.argtypes = [c_void_p, c_uint64]
    loaded.rs_run_until.restype = None
    loaded.rs_next_wakeup_us.argtypes = [c_void_p]
    loaded.rs_next_wakeup_us.restype = c_uint64
    loaded.rs_set_input.argtypes = [c_void_p, c_uint32, c_uint32]
    loaded.rs_set_input.restype = None
    for name in ("rs_serial_in", "rs_serial_out", "rs_trace_read", "rs_nonvolatile_read"):
        getattr(loaded, name).argtypes = [c_void_p, c_void_p, c_size_t]
        getattr(loaded, name).restype = c_size_t
    return loaded


class Device:
    """One device from power-on; a context manager."""

    def __init__(self, library: ctypes.CDLL, nonvolatile: bytes = b"") -> None:
        self.library = library
        self.handle = library.rs_create(nonvolatile, len(nonvolatile), NONCE)
        self.now_us = 0
        self.reader = FrameReader()
        self.buffer = ctypes.create_string_buffer(1 << 16)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.library.rs_destroy(self.handle)

    def feed(self, data: bytes, step_us: int = 0) -> None:
        """Bytes to the device, in as many parts as its buffer wants."""
        while data:
            data = data[self.library.rs_serial_in(self.handle, data, len(data)) :]
            self.now_us += step_us
            self.library.rs_run_until(self.handle, self.now_us)

    def run_for(self, duration_us: int) -> None:
        self.now_us += duration_us
        self.library.rs_run_until(self.handle, self.now_us)

    def _read(self, function: str) -> bytes:
        count = getattr(self.library, function)(self.handle, self.buffer, len(self.buffer))
        return self.buffer.raw[:count]

    def output(self) -> bytes:
        """Bytes from the device; what leaves its buffer makes room for more."""
        out = b""
        while data := self._read("rs_serial_out"):
            out += data
            self.run_for(0)
        return out

    def frames(self) -> list[Frame]:
        """Frames from the device; none of them may be broken."""
        frames = list(self.reader.feed(self.output()))
        assert not self.reader.dropped
        return frames

    def trace(self) -> list[Record]:
        """Records since the last call."""
        records = []
        while data := self._read("rs_trace_read"):
            at = 0
            while at < len(data):
                size = int.from_bytes(data[at + 2 : at + 4], "little")
                time_us = int.from_bytes(data[at + 4 : at + 12], "little")
                payload = data[at + 12 : at + 12 + size]
                records.append(Record(data[at], data[at + 1], time_us, payload))
                at += 12 + size
        return records

    def answers(self, request_id: int) -> list[object]:
        """Messages that answer this id, in order."""
        return [
            MESSAGES[f.message].unpack(f.payload)
            for f in self.frames()
            if f.request_id == request_id and f.message >= FIRST_ANSWER
        ]

    def ask(self, request, request_id: int, nonce: int = NONCE):
        """The one answer to a request."""
        self.feed(frame(request, request_id, nonce))
        (answer,) = self.answers(request_id)
        return answer


def light(level, slot=0):
    return LoadLightRequest(slot=slot, levels=(level,))


def load_sequence(device, steps, run_id, deadline_ms):
    """Apertures 0 and 1, lights 0 and 1, the table, and its start; ids from 1."""
    ids = iter(range(1, 100))
    for slot in (0, 1):
        bitmap = bytes([0x0F << slot]) * 1024
        for chunk in range(4):
            device.ask(ApertureChunkRequest(slot=slot, chunk=chunk, data=bitmap[:256]), next(ids))
        device.ask(CommitApertureRequest(slot=slot, crc32=zlib.crc32(bitmap)), next(ids))
        device.ask(light(100 + slot, slot), next(ids))
    table = b"".join(step.pack() for step in steps)
    for first in range(0, len(steps), 16):
        chunk = StepChunkRequest(first=first, steps=tuple(steps[first : first + 16]))
        device.ask(chunk, next(ids))
    device.ask(CommitStepsRequest(count=len(steps), crc32=zlib.crc32(table)), next(ids))
    start = StartRequest(
        run_id=run_id,
        table_hash=zlib.crc32(table),
        deadline_ms=deadline_ms,
        light_lead_us=300,
        trigger_us=20,
        gap_us=1000,
        ready_timeout_ms=0,
        require_strobe=False,
    )
    device.ask(start, next(ids))
    return zlib.crc32(table)
