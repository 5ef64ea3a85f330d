"""The cable between host and device, and the buffers at its ends."""

from __future__ import annotations

from collections import deque

from reliefscope_sim.faults import Faults, FaultyWire
from reliefscope_sim.firmware import NEVER_US, Firmware

BYTE_US = 1
"""Time that a byte takes: USB full speed carries about 1 MB/s."""
HOST_BUFFER = 65536
"""Bytes that the host keeps unread; after that the device's own buffer fills up."""
WRITE_AHEAD = 4096
"""Bytes that the host's driver takes before a write has to wait for the device."""


class Cable:
    """Bytes under way in both directions.  Times in us."""

    def __init__(self, faults: Faults, seed: int) -> None:
        self._faults = faults
        self._up = FaultyWire(faults, f"{seed}-to-host", delays=True)
        self._down = FaultyWire(faults, f"{seed}-to-device", delays=False)
        self._arriving: deque[tuple[int, bytes]] = deque()
        self._backlog = bytearray()
        self.received = bytearray()
        """Bytes that the host can read."""
        self.host_open = False
        self.broken = False
        """Cut, or the device is no longer there; mended when the port is opened again."""

    def plug_in(self) -> None:
        """The host opened the port: both ends start with empty buffers."""
        self.host_open = True
        self.broken = False
        self.clear_input()
        self.clear_output()

    def unplug(self) -> None:
        """The host closed the port."""
        self.host_open = False

    def cut(self) -> None:
        """Break the link."""
        self.broken = True

    def strike(self, exposure: int) -> None:
        """An exposure began: what is placed there happens to the link."""
        self._up.strike(exposure)
        if self._faults.strikes("link_cut", exposure):
            self.cut()

    @property
    def unsent(self) -> int:
        """Bytes that the device has not taken yet."""
        return len(self._backlog)

    @property
    def next_event_us(self) -> int:
        """When a delayed frame arrives."""
        return self._arriving[0][0] if self._arriving else NEVER_US

    def send(self, time_us: int, data: bytes) -> None:
        """Bytes from the host."""
        for _, piece in self._down.feed(time_us, data):
            self._backlog += piece

    def exchange(self, time_us: int, firmware: Firmware) -> None:
        """Move what can move: to the device what it takes, from it what it sent."""
        if self.broken:
            return
        if self._backlog:
            del self._backlog[: firmware.serial_in(bytes(self._backlog))]
        while self._held < HOST_BUFFER and (data := firmware.serial_out()):
            if self.host_open:
                self._arriving += self._up.feed(time_us, data)
        while self._arriving and self._arriving[0][0] <= time_us:
            self.received += self._arriving.popleft()[1]

    def clear_input(self) -> None:
        """Forget what the host has not read."""
        self.received.clear()
        self._arriving.clear()

    def clear_output(self) -> None:
        """Forget what the device has not taken."""
        self._backlog.clear()

    @property
    def _held(self) -> int:
        return len(self.received) + sum(len(data) for _, data in self._arriving)
