"""Frames over a port, with deadlines that also end under virtual time.

Reads are synchronous and there is no background thread: under the twin's virtual time it is the waiting host
that lets the clock run, so a reader that waits for nothing in particular would race through time.
"""

from __future__ import annotations

import logging
import time
from collections import Counter, deque

from reliefscope.device.errors import LinkLostError
from reliefscope.device.ports import Port
from reliefscope.device.wirelog import WireLog
from reliefscope.protocol.framing import Frame, FrameReader

logger = logging.getLogger(__name__)

READ_SLICE_S = 0.05
"""Longest single read: other threads get their turn in between."""
SHORT_SLICE_S = 0.005
"""A single read where less than the longest is left; only two values, since pyserial sets up a port anew for each."""


class Deadline:
    """Time allowed for something, in seconds.

    Counts the greater of wall time and the timeouts of reads that brought nothing: under virtual time such a
    read returns at once, having let the device's clock run for its timeout.
    """

    def __init__(self, seconds: float) -> None:
        self.seconds = seconds
        self._start = time.monotonic()
        self._idle_s = 0.0

    def idle(self, seconds: float) -> None:
        """A read of this timeout brought nothing."""
        self._idle_s += seconds

    @property
    def spent_s(self) -> float:
        """Seconds that count as spent."""
        return max(time.monotonic() - self._start, self._idle_s)

    @property
    def remaining_s(self) -> float:
        """Seconds left, 0 when over."""
        return max(0.0, self.seconds - self.spent_s)


class Link:
    """Sends and receives frames; not thread-safe (the client locks).

    ``counters``: frames_sent, frames_received, bytes_sent, bytes_received, and dropped_* by verdict.
    ``silent_s`` is the time for which nothing came although somebody waited.  ``log`` notes everything, by
    default in memory alone.
    """

    def __init__(self, port: Port, name: str = "", wire_log: WireLog | None = None) -> None:
        self.name = name
        self.silent_s = 0.0
        self._port = port
        self.log = wire_log or WireLog()
        self._reader = FrameReader()
        self._frames: deque[Frame] = deque()
        self._counters: Counter[str] = Counter()

    @property
    def counters(self) -> dict[str, int]:
        """What was counted since opening."""
        dropped = {f"dropped_{verdict}": n for verdict, n in self._reader.dropped.items()}
        return {**self._counters, **dropped}

    def count(self, what: str) -> None:
        """Add one to a counter."""
        self._counters[what] += 1

    def send(self, frame: Frame) -> None:
        """Send a frame, with a delimiter ahead that ends whatever a lost byte left open.

        Raises
        ------
        LinkLostError
            If the port is gone.
        """
        data = b"\0" + frame.encode()
        self.log.note("out", frame)
        try:
            self._port.write(data)
        except OSError as error:
            raise self._lost(error) from error
        self._counters["frames_sent"] += 1
        self._counters["bytes_sent"] += len(data)

    def receive(self, deadline: Deadline) -> Frame | None:
        """Next frame, or None after one read (of at most READ_SLICE_S) that completed none.

        Raises
        ------
        LinkLostError
            If the port is gone.
        """
        if not self._frames:
            data = self._read(deadline)
            before = self._reader.dropped.copy()
            for frame in self._reader.feed(data):
                self._counters["frames_received"] += 1
                self._frames.append(frame)
                self.log.note("in", frame)
            for verdict, count in (self._reader.dropped - before).items():
                self.log.note_dropped(verdict, count)
        if not self._frames:
            return None
        self.silent_s = 0.0
        return self._frames.popleft()

    def _read(self, deadline: Deadline) -> bytes:
        remaining = deadline.remaining_s
        timeout = READ_SLICE_S if remaining >= READ_SLICE_S else SHORT_SLICE_S
        try:
            waiting = self._port.in_waiting
            if not waiting and remaining <= 0:
                return b""
            if self._port.timeout != timeout:
                self._port.timeout = timeout
            data = self._port.read(max(1, waiting))
            if not waiting and data:
                data += self._port.read(self._port.in_waiting)
        except OSError as error:
            raise self._lost(error) from error
        if not data:
            deadline.idle(timeout)
            self.silent_s += timeout
        self._counters["bytes_received"] += len(data)
        return data

    def flush_input(self) -> None:
        """Forget everything received so far."""
        try:
            self._port.reset_input_buffer()
        except OSError as error:
            raise self._lost(error) from error
        self._reader.reset()
        self._frames.clear()

    def close(self) -> None:
        """Close port and log."""
        self._port.close()
        self.log.close()

    def _lost(self, error: OSError) -> LinkLostError:
        logger.debug("link %s lost: %s", self.name, error)
        return LinkLostError(
            f"The link to {self.name or 'the device'} was lost: {error}.",
            hint="Check the cable and the supply, then connect again; `reliefscope doctor` lists the ports.",
        )
