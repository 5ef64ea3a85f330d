"""The compiled firmware behind a link that loses, damages, doubles and delays, in virtual time, from a seed.

Unlike the simulated instrument's cable, both directions suffer, and a delayed frame is overtaken by later ones:
some arrive seconds later, when the host gave up on them long ago.
"""

import heapq
import itertools
import random
import zlib
from dataclasses import dataclass

from reliefscope_sim.firmware import Firmware
from reliefscope_sim.trace import TraceKind

LATENCY_US = 500
USUAL_DELAY_US, LONGEST_DELAY_US = 200_000, 6_000_000
_BANK, _VALUES_AT, _VALUES = 256, 5, 20
_CRC_AT = _VALUES_AT + _VALUES
_CONTRAST = 0x81


@dataclass(frozen=True)
class Weather:
    """Rates per frame, and per byte, of each kind of mishap; each way."""

    lose: float = 0.0
    corrupt: float = 0.0
    duplicate: float = 0.0
    delay: float = 0.0
    byte_loss: float = 0.0
    byte_flip: float = 0.0

    @classmethod
    def all_at(cls, rate, byte_rate=0.0):
        """Every kind of frame mishap at one rate; bytes are lost and flipped at half of theirs each."""
        return cls(rate, rate, rate, rate, byte_rate / 2, byte_rate / 2)


class Wire:
    """One direction: frames in, and pieces of bytes that arrive."""

    def __init__(self, seed):
        self.weather = Weather()
        self.random = random.Random(seed)
        self.mishaps = 0
        self._arriving = []
        self._order = itertools.count()
        self._open = b""

    def send(self, now_us, data):
        *whole, self._open = (self._open + data).split(b"\0")
        for frame in whole:
            self._send_frame(now_us, frame + b"\0")

    def _send_frame(self, now_us, frame):
        draw, w = self.random.random, self.weather
        if len(frame) == 1:
            self._arrive(now_us + LATENCY_US, frame)
            return
        if draw() < w.lose:
            self.mishaps += 1
            return
        if draw() < w.corrupt:
            self.mishaps += 1
            at = self.random.randrange(len(frame))
            frame = (
                frame[:at] + bytes([frame[at] ^ 1 << self.random.randrange(8)]) + frame[at + 1 :]
            )
        if draw() < w.duplicate:
            self.mishaps += 1
            self._arrive(now_us + LATENCY_US + self._delay(), frame)
        late = draw() < w.delay
        self.mishaps += late
        self._arrive(now_us + LATENCY_US + (self._delay() if late else 0), frame)

    def _delay(self):
        longest = LONGEST_DELAY_US if self.random.random() < 0.1 else USUAL_DELAY_US
        return self.random.randrange(longest)

    def _arrive(self, time_us, frame):
        heapq.heappush(self._arriving, (time_us, next(self._order), self._damage(frame)))

    def _damage(self, frame):
        draw, w = self.random.random, self.weather
        if not (w.byte_loss or w.byte_flip):
            return frame
        out = bytearray()
        for byte in frame:
            if draw() < w.byte_loss:
                self.mishaps += 1
                continue
            flip = draw() < w.byte_flip
            self.mishaps += flip
            out.append(byte ^ 1 << self.random.randrange(8) if flip else byte)
        return bytes(out)

    @property
    def next_us(self):
        return self._arriving[0][0] if self._arriving else None

    def receive(self, now_us):
        data = b""
        while self._arriving and self._arriving[0][0] <= now_us:
            data += heapq.heappop(self._arriving)[2]
        return data


class LossyPort:
    """Port to the compiled firmware; a read that finds nothing lets the time of its timeout pass.  Calm at first."""

    def __init__(self, seed):
        self.firmware = Firmware(b"", 0xC0FFEE)
        self.timeout = 0.05
        self.now_us = 0
        self.down = Wire(f"{seed}-down")
        self.up = Wire(f"{seed}-up")
        self.log = ExecutionLog()
        self._received = bytearray()
        self._run_to(20_000)

    def write(self, data):
        self.down.send(self.now_us, data)
        self._run_to(self.now_us + len(data))
        return len(data)

    @property
    def in_waiting(self):
        return len(self._received)

    def read(self, size=1):
        end_us = self.now_us + round(self.timeout * 1e6)
        while len(self._received) < size and self.now_us < end_us:
            self._run_to(end_us, stop=True)
        data = bytes(self._received[:size])
        del self._received[:size]
        return data

    def reset_input_buffer(self):
        self._received.clear()

    def close(self):
        self.log.add(self.firmware.trace())
        self.firmware.close()

    def set_weather(self, weather):
        self.down.weather = self.up.weather = weather

    @property
    def mishaps(self):
        return self.down.mishaps + self.up.mishaps

    def let_pass(self, seconds):
        """Time in which the host does nothing; whatever is still under way arrives."""
        self._run_to(self.now_us + round(seconds * 1e6))

    def executed(self):
        """(generation, serial number) of everything that set_settings stored so far."""
        self.log.add(self.firmware.trace())
        return self.log.executed

    def _run_to(self, end_us, *, stop=False):
        while self.now_us < end_us and not (stop and self._received):
            steps = [end_us, self.down.next_us, self.up.next_us, self.firmware.next_wakeup_us()]
            self.now_us = min(end_us, max(self.now_us + 1, min(s for s in steps if s is not None)))
            self.firmware.run_until(self.now_us)
            data = self.down.receive(self.now_us)
            while data:
                data = data[self.firmware.serial_in(data) :]
                self.firmware.run_until(self.now_us)
            if out := self.firmware.serial_out():
                self.up.send(self.now_us, out)
            self._received += self.up.receive(self.now_us)


class ExecutionLog:
    """What the trace tells of executions of set_settings.

    Its writes to the non-volatile memory tell which settings were stored, in what order.  The same settings again are
    not written again, but every execution sets the glass up anew: ``set_ups`` counts the contrast commands on SPI, the
    one after power-on not among them.  It can only be too low, where two follow within one transfer.
    """

    def __init__(self):
        self.executed = []
        self.set_ups = -1
        self._memory = bytearray(b"\xff" * 2048)
        self._generation = 0

    def add(self, records):
        for record in records:
            assert record.kind is not TraceKind.OVERFLOW
            if record.kind is TraceKind.SPI and record.argument == 0:
                self.set_ups += _CONTRAST in record.payload
            if record.kind is TraceKind.NONVOLATILE:
                address = int.from_bytes(record.payload[:2], "little")
                self._memory[address] = record.payload[2]
                if address < 2 * _BANK:
                    self._look(address // _BANK * _BANK)

    def _look(self, at):
        bank = self._memory[at : at + _CRC_AT + 4]
        crc, generation = (int.from_bytes(bank[i : i + 4], "little") for i in (_CRC_AT, 1))
        if crc == zlib.crc32(bank[:_CRC_AT]) and generation > self._generation:
            self._generation = generation
            serial = bytes(bank[_VALUES_AT : _VALUES_AT + 16]).rstrip(b"\0").decode()
            self.executed.append((generation, serial))
