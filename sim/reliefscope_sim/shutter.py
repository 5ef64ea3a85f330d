"""The camera in time: pulses become exposures, exposures become frames that can be fetched.

A pulse on the trigger line starts an exposure at once; after it the sensor is read out for 1 / frames_per_s,
and until that is done further pulses are missed, which shows as a gap in the frame ids.  Free-running, the
sensor exposes while the frame before is read out, and delivers frames_per_s.  Outputs: strobe (high while
exposing) and ready (high while a pulse would be taken).
"""

from __future__ import annotations

import zlib
from collections import deque
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from reliefscope.units import US_PER_S, FloatImage
from reliefscope_sim.faults import Faults
from reliefscope_sim.firmware import NEVER_US
from reliefscope_sim.glass import Glass
from reliefscope_sim.lights import LedLines

BUFFERS = 64
"""Frames that the camera's driver keeps; what comes after is lost until one is fetched."""


@dataclass(frozen=True, slots=True)
class Exposure:
    """Light that one frame is made of.

    ``transmission`` (64, 128) is the glass's average over the exposure, ``led_energy`` (n_leds,) level
    fraction times seconds.  ``glass_key`` and ``light_key`` identify what was commanded, ``repeat`` counts
    exposures since that changed: together they key the noise, so that retaking a frame gives the same one.
    ``kept`` is the part of the rows, from the top, that reached the host.
    """

    frame_id: int
    start_us: int
    exposure_us: int
    transmission: FloatImage
    led_energy: NDArray[np.float64]
    glass_key: int
    light_key: int
    repeat: int
    gain_db: float = 0.0
    kept: float = 1.0


@dataclass(frozen=True, slots=True)
class _Open:
    """An exposure under way; ``pulse`` is None where the camera runs freely."""

    frame_id: int
    pulse: int | None
    start_us: int
    end_us: int
    glass_key: int
    switches: int


class Shutter:
    """The camera's timing.  All times are device time in us and never decrease."""

    def __init__(self, glass: Glass, leds: LedLines, frames_per_s: float, faults: Faults) -> None:
        self._glass = glass
        self._leds = leds
        self._faults = faults
        self._readout_us = round(US_PER_S / frames_per_s)
        self._triggered = True
        self._now_us = 0
        self.exposure_us = 20_000
        self.gain_db = 0.0
        self.armed = False
        self.unplugged = False
        self.dropped = 0
        self.pulses = 0
        """Pulses since the bench was switched on, whether the camera took them or not."""
        self._clear()

    def _clear(self) -> None:
        self._frame_id = 0
        self._open: _Open | None = None
        self._busy_until_us = 0
        self._next_start_us = NEVER_US
        self._reading: deque[tuple[int, Exposure]] = deque()
        self._finished: deque[Exposure] = deque()
        self._last_pair: tuple[int, int, int] | None = None
        self._repeat = 0
        self.dropped = 0

    def configure(self, exposure_us: int, *, triggered: bool, gain_db: float = 0.0) -> None:
        """Exposure time, gain and mode from the next :meth:`arm` on."""
        self.exposure_us = exposure_us
        self.gain_db = gain_db
        self._triggered = triggered

    def arm(self, time_us: int) -> None:
        """Take pulses, or start free-running; frame ids start anew."""
        self._clear()
        self.armed = True
        self._busy_until_us = time_us
        if not self._triggered:
            self._next_start_us = time_us

    def disarm(self) -> None:
        """Stop at once; an exposure under way and frames not fetched are dropped."""
        self._clear()
        self.armed = False

    def unplug(self) -> None:
        """The cable is pulled."""
        self.disarm()
        self.unplugged = True

    @property
    def strobe(self) -> bool:
        """Level of the exposure-active output."""
        return self._open is not None

    def ready(self, time_us: int) -> bool:
        """Level of the trigger-ready output."""
        free = self._open is None and time_us >= self._busy_until_us
        return self.armed and self._triggered and free

    @property
    def needs_from_us(self) -> int | None:
        """Start of the exposure under way: the history of glass and LEDs has to reach back to it."""
        return self._open.start_us if self._open else None

    @property
    def next_event_us(self) -> int:
        """When something happens by itself."""
        times = [self._next_start_us]
        if self._open:
            times.append(self._open.end_us)
        elif self.armed and self._busy_until_us > self._now_us:
            times.append(self._busy_until_us)
        if self._reading:
            times.append(self._reading[0][0])
        return min(times)

    def pulse(self, time_us: int) -> None:
        """Rising edge of the trigger line."""
        number = self.pulses
        self.pulses += 1
        if self._faults.strikes("camera_unplug", number):
            self.unplug()
        if not self.armed or not self._triggered:
            return
        if self.ready(time_us):
            self._start(time_us, number)
        else:
            self._frame_id += 1
            self.dropped += 1

    def run_until(self, time_us: int) -> None:
        """Let everything happen that is due by ``time_us``."""
        self._now_us = time_us
        while (due_us := self._due_us(time_us)) is not None:
            if self._open and self._open.end_us == due_us:
                self._finish(self._open)
            elif self._reading and self._reading[0][0] == due_us:
                self._deliver(self._reading.popleft()[1])
            else:
                self._start(due_us, None)
                self._next_start_us = due_us + max(self._readout_us, self.exposure_us)

    def fetch(self) -> Exposure | None:
        """The oldest exposure whose frame has arrived."""
        return self._finished.popleft() if self._finished else None

    def _due_us(self, time_us: int) -> int | None:
        times = [self._next_start_us] if self._open is None else [self._open.end_us]
        if self._reading:
            times.append(self._reading[0][0])
        earliest = min(times)
        return earliest if earliest <= time_us else None

    def _start(self, time_us: int, pulse: int | None) -> None:
        glass_key = zlib.crc32(np.packbits(self._glass.commanded_open).tobytes())
        end_us = time_us + self.exposure_us
        self._open = _Open(self._frame_id, pulse, time_us, end_us, glass_key, self._glass.switches)
        self._frame_id += 1

    def _finish(self, window: _Open) -> None:
        self._open = None
        self._busy_until_us = window.end_us + self._readout_us
        span = (window.start_us, window.end_us)
        levels = self._leds.mean_levels(*span).astype("<i4")
        exposure = Exposure(
            frame_id=window.frame_id,
            start_us=window.start_us,
            exposure_us=window.end_us - window.start_us,
            transmission=self._glass.mean_transmission(*span),
            led_energy=self._leds.energy(*span),
            glass_key=window.glass_key,
            light_key=zlib.crc32(levels.tobytes()),
            repeat=0,
            gain_db=self.gain_db,
        )
        pair = (exposure.glass_key, exposure.light_key, window.switches)
        self._repeat = self._repeat + 1 if pair == self._last_pair else 0
        self._last_pair = pair
        self._read_out(replace(exposure, repeat=self._repeat), window.pulse)

    def _read_out(self, exposure: Exposure, pulse: int | None) -> None:
        """Send a frame on its way to the host, with what may happen to it there."""

        def happens(fault: str) -> bool:
            return pulse is not None and self._faults.strikes(fault, pulse)

        if happens("camera_drop"):
            self.dropped += 1
            return
        if pulse is not None and happens("camera_torn"):
            exposure = replace(exposure, kept=self._faults.draw("camera_torn rows", pulse))
        late_us = self._faults.camera_late_us if happens("camera_late") else 0
        for _ in range(2 if happens("camera_duplicate") else 1):
            self._reading.append((self._busy_until_us + late_us, exposure))

    def _deliver(self, exposure: Exposure) -> None:
        if len(self._finished) < BUFFERS:
            self._finished.append(exposure)
            return
        self.dropped += 1
        if not self._triggered:  # a preview wants the newest
            self._finished.popleft()
            self._finished.append(exposure)
