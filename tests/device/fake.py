"""A device that follows the protocol reference, behind a port whose time is virtual and whose link is bad.

Written from the reference, not from the firmware, so that the client is tested against what is promised.
"""

import random
import zlib
from collections import Counter
from dataclasses import dataclass, field

from reliefscope.protocol import messages as m
from reliefscope.protocol.framing import Frame, FrameReader

RING = m.COMPLETION_RING


@dataclass
class Faults:
    """Fate of frames, in both directions, drawn from ``seed``; rates are per frame, ``byte_loss`` per byte."""

    lose: float = 0.0
    corrupt: float = 0.0
    duplicate: float = 0.0
    delay: float = 0.0
    byte_loss: float = 0.0
    seed: int = 1


def hello_reply(**changes):
    values = {
        "protocol_version": m.PROTOCOL_VERSION,
        "schema_hash": m.SCHEMA_HASH,
        "firmware_version": "0.1.0",
        "git_hash": "0123abcd",
        "board": "fake",
        "serial_number": "",
        "capabilities": m.Capability(0),
        "reset_cause": m.ResetCause.POWER_ON,
        "boot_nonce": 0xBEEF,
        "last_request_id": 0,
        "aperture_slots": m.APERTURE_SLOTS,
        "light_slots": m.LIGHT_SLOTS,
        "leds": m.LEDS,
        "steps": m.STEPS,
        "reserved": bytes(8),
    }
    return m.HelloReply(**values | changes)


@dataclass
class FakeDevice:
    """State of a device; ``executed`` counts how often each request id was run."""

    nonce: int = 0xBEEF
    cause: m.ResetCause = m.ResetCause.POWER_ON
    schema_hash: bytes = m.SCHEMA_HASH
    silent: bool = False
    highest: int = 0
    ring: dict[int, tuple[int, Frame]] = field(default_factory=dict)
    executed: Counter = field(default_factory=Counter)
    requests: list = field(default_factory=list)
    events: list = field(default_factory=list)
    first_event: int = 0
    light: int = m.SLOT_NONE
    fail_with: m.ErrorCode | None = None
    outbox: list = field(default_factory=list)

    def __post_init__(self):
        self.emit(m.BootedEvent(self.cause))

    def emit(self, event):
        number = self.first_event + len(self.events)
        self.events.append(event)
        self.outbox.append(Frame(event.ID, number, self.nonce, event.pack()))

    def reboot(self, cause):
        kept = self.requests
        self.__init__(nonce=self.nonce + 1, cause=cause, schema_hash=self.schema_hash)
        self.requests = kept

    def take(self, frame):
        if self.silent:
            return
        kind = m.MESSAGES.get(frame.message)
        if kind is m.HelloRequest:
            reply = hello_reply(
                boot_nonce=self.nonce,
                reset_cause=self.cause,
                schema_hash=self.schema_hash,
                last_request_id=self.highest,
            )
            self.answer(frame, reply)
        elif kind is m.EnterBootloaderRequest:
            self.requests.append(kind.unpack(frame.payload))
            self.answer(frame, m.EnterBootloaderReply(100))
        elif frame.boot_nonce != self.nonce:
            self.reject(frame, m.ErrorCode.WRONG_NONCE)
        elif frame.request_id in self.ring:
            check, answer = self.ring[frame.request_id]
            if check == zlib.crc32(frame.encode()):
                self.outbox.append(answer)
            else:
                self.reject(frame, m.ErrorCode.REQUEST_ID_REUSED)
        elif frame.request_id <= self.highest:
            self.reject(frame, m.ErrorCode.REQUEST_TOO_OLD)
        else:
            self.run(frame, kind.unpack(frame.payload))

    def run(self, frame, request):
        self.executed[frame.request_id] += 1
        self.highest = frame.request_id
        self.requests.append(request)
        failed = self.fail_with and m.Failed(self.fail_with, frame.message, 1)
        reply = failed or self.reply(request)
        answer = self.answer(frame, reply)
        self.ring[frame.request_id] = (zlib.crc32(frame.encode()), answer)
        while len(self.ring) > RING:
            del self.ring[next(iter(self.ring))]

    def reply(self, request):
        match request:
            case m.SelectLightRequest(slot):
                self.light = slot
                return m.SelectLightReply(slot, 0)
            case m.SelectApertureRequest(slot):
                return m.SelectApertureReply(slot, 0)
            case m.LoadLightRequest(slot, levels):
                data = b"".join(v.to_bytes(2, "little") for v in levels).ljust(2 * m.LEDS, b"\0")
                return m.LoadLightReply(slot, zlib.crc32(data), sum(levels))
            case m.AcknowledgeEventsRequest(number, resend):
                self.events = self.events[number - self.first_event :]
                self.first_event = number
                for n, event in enumerate(self.events if resend else []):
                    self.outbox.append(Frame(event.ID, number + n, self.nonce, event.pack()))
                return m.AcknowledgeEventsReply(number, number + len(self.events))
            case m.StatusRequest():
                return status(self)
            case m.AllOffRequest():
                self.light = m.SLOT_NONE
                return m.AllOffReply(m.SequenceState.IDLE)
        raise AssertionError(f"the fake does not know {request}")

    def answer(self, frame, message):
        answer = Frame(message.ID, frame.request_id, self.nonce, message.pack())
        self.outbox.append(answer)
        return answer

    def reject(self, frame, code):
        self.answer(frame, m.Rejected(code, frame.message, 0))


def status(device):
    return m.StatusReply(
        sequence=m.SequenceState.IDLE,
        fault=m.FaultReason.NONE,
        aperture=m.SLOT_NONE,
        light=device.light,
        camera_ready=True,
        uptime_us=1,
        table_hash=0,
        run_id=0,
        step=0,
        exposures=0,
        oldest_event=device.first_event,
        next_event=device.first_event + len(device.events),
        temperature_centi=m.TEMPERATURE_UNKNOWN,
    )


class FakePort:
    """Port to a fake device; a read that finds nothing returns at once and lets virtual time run."""

    def __init__(self, device, faults=None):
        self.device = device
        self.faults = faults or Faults()
        self.timeout = 0.0
        self.now_s = 0.0
        self.closed = False
        self.unplugged = False
        self._random = random.Random(self.faults.seed)
        self._reader = FrameReader()
        self._buffer = bytearray()
        self._later = []

    def write(self, data):
        self._alive()
        for frame in self._reader.feed(self._mangle_bytes(data)):
            for sent in self._fate(frame.encode(), to_device=True):
                for again in FrameReader().feed(sent):
                    self.device.take(again)
        self._collect()
        return len(data)

    @property
    def in_waiting(self):
        self._alive()
        self._collect()
        return len(self._buffer)

    def read(self, size=1):
        self._alive()
        self._collect()
        if not self._buffer:
            self.now_s += self.timeout
            self._release()
        data = bytes(self._buffer[:size])
        del self._buffer[:size]
        return data

    def reset_input_buffer(self):
        self._buffer.clear()
        self.device.outbox.clear()

    def close(self):
        self.closed = True

    def _alive(self):
        if self.unplugged:
            raise OSError(5, "Input/output error")

    def _collect(self):
        self._release()
        outbox, self.device.outbox = self.device.outbox, []
        for frame in outbox:
            for data in self._fate(frame.encode(), to_device=False):
                self._buffer += self._mangle_bytes(data)

    def _release(self):
        due = [entry for entry in self._later if entry[0] <= self.now_s]
        self._later = [entry for entry in self._later if entry[0] > self.now_s]
        for _, data, to_device in due:
            if to_device:
                for frame in FrameReader().feed(data):
                    self.device.take(frame)
            else:
                self._buffer += data

    def _fate(self, data, *, to_device):
        draw, f = self._random.random, self.faults
        if draw() < f.lose:
            return
        if draw() < f.corrupt:
            place = self._random.randrange(len(data) - 1)
            data = (
                data[:place]
                + bytes([data[place] ^ 1 << self._random.randrange(8)])
                + data[place + 1 :]
            )
        if draw() < f.delay:
            self._later.append((self.now_s + draw(), data, to_device))
            return
        yield data
        if draw() < f.duplicate:
            self._later.append((self.now_s + draw(), data, to_device))

    def _mangle_bytes(self, data):
        rate = self.faults.byte_loss
        return bytes(b for b in data if self._random.random() >= rate) if rate else data
