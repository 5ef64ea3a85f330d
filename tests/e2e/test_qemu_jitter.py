"""Lateness of the trigger as ARM code under a flood, on a clock that counts every instruction."""

import itertools
import random
import select
import socket
import time
import zlib

import pytest

from reliefscope.protocol import messages as m
from reliefscope.protocol.framing import FrameReader
from reliefscope_sim.trace import OutputPin, TraceKind, parse_trace
from tests.e2e import qemu
from tests.firmware.compiled import frame

LEAD_US, REPEATS, APERTURES = 400, 12, 4
STEPS = [m.Step(slot, 0, REPEATS, 3000, 900) for slot in range(APERTURES)]
LIMIT_US = 50


class Wire:
    """A host without manners: asks when it should, and floods."""

    def __init__(self, url):
        self.socket = socket.create_connection(("127.0.0.1", int(url.rsplit(":", 1)[1])))
        self.reader = FrameReader()
        self.ids = itertools.count(1)

    def ask(self, request):
        number = next(self.ids)
        self.socket.sendall(frame(request, number, qemu.NONCE))
        while True:
            for answer in self.reader.feed(self.socket.recv(4096)):
                if answer.request_id == number and answer.message >= 0x80:
                    assert answer.message == request.REPLY.ID, answer
                    return

    def flood(self, garbage, done):
        """As many bytes as the device takes; answers are read and forgotten.  Returns the bytes sent."""
        self.socket.setblocking(False)
        sent, waiting = 0, b""
        look_s = 0.0
        while True:
            if time.monotonic() >= look_s:
                if done():
                    return sent
                look_s = time.monotonic() + 0.1
            if not waiting:
                waiting = garbage(next(self.ids))
            readable, writable, _ = select.select([self.socket], [self.socket], [], 0.5)
            if readable:
                self.socket.recv(1 << 16)
            if writable:
                count = self.socket.send(waiting[:256])
                sent, waiting = sent + count, waiting[count:]


def start(wire):
    for slot in range(APERTURES):
        data = bytes([0x11 << slot & 0xFF]) * 1024
        for chunk in range(4):
            wire.ask(m.ApertureChunkRequest(slot, chunk, data[:256]))
        wire.ask(m.CommitApertureRequest(slot, zlib.crc32(data)))
    wire.ask(m.LoadLightRequest(0, (1000,)))
    wire.ask(m.StepChunkRequest(0, tuple(STEPS)))
    table = zlib.crc32(b"".join(step.pack() for step in STEPS))
    wire.ask(m.CommitStepsRequest(len(STEPS), table))
    wire.ask(
        m.StartRequest(
            run_id=1,
            table_hash=table,
            deadline_ms=60_000,
            light_lead_us=LEAD_US,
            trigger_us=50,
            gap_us=700,
            ready_timeout_ms=0,
            require_strobe=False,
        )
    )


def lateness_us(records):
    """How much later than the lead after the light each trigger came."""
    late, lit_us = [], 0
    for record in records:
        if record.kind is TraceKind.LED and record.level:
            lit_us = record.time_us
        elif (
            record.kind is TraceKind.PIN
            and record.argument == OutputPin.CAMERA_TRIGGER
            and record.level
        ):
            late.append(record.time_us - lit_us - LEAD_US)
    return late


def whole_records(data):
    """Records up to one that is still being sent."""
    at = 0
    while at + 12 <= len(data) and at + 12 + int.from_bytes(data[at + 2 : at + 4], "little") <= len(
        data
    ):
        at += 12 + int.from_bytes(data[at + 2 : at + 4], "little")
    return list(parse_trace(data[:at]))


@pytest.mark.parametrize("kind", ["valid", "garbage", "zeros", "both"])
def test_the_trigger_is_not_late_under_a_flood(kind, record_property):
    chance = random.Random(kind)

    def garbage(number):
        noise = chance.randbytes(chance.randrange(1, 300))
        valid = frame(m.StatusRequest(), number, qemu.NONCE) * chance.randrange(1, 4)
        zeros = bytes(64)
        parts = {"valid": valid, "garbage": noise, "zeros": zeros, "both": valid + noise + b"\0"}
        return parts[kind]

    with qemu.QemuBoard(qemu.images() / "reliefscope_qemu_m4.elf") as board:
        wire = Wire(board.url)
        start(wire)
        sent = wire.flood(
            garbage,
            lambda: len(lateness_us(whole_records(board.received()))) == REPEATS * APERTURES,
        )
        wire.socket.close()
        late = lateness_us(board.settled_trace())
    record_property(
        "lateness_us", f"{min(late)} to {max(late)} over {len(late)} triggers, {sent} bytes"
    )
    print(f"{kind}: {min(late)} to {max(late)} us over {len(late)} triggers, {sent} bytes")
    assert len(late) == REPEATS * APERTURES
    assert sent > 2000
    assert min(late) >= 0
    assert max(late) - min(late) <= LIMIT_US
    assert max(late) <= LIMIT_US
