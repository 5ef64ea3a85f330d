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
from reliefscope_sim.lights import FULL_LEVEL, LedLines

BUFFERS = 64
"""Frames that the camera's driver keeps; what comes after is lost until one is fetched."""


@dataclass(frozen=True, slots=True)
class Exposure:
    """Light that one frame is made of.

    ``transmission`` (64, 128) is the glass's average over the exposure, ``led_energy`` (n_leds,) level
    fraction times seconds.  ``glass_key`` and ``light_key`` identify what was commanded, ``repeat`` counts
    exposures since that changed: together they key the noise, so that retaking a frame gives the same one.
    """

    frame_id: int
    start_us: int
    exposure_us: int
    transmission: FloatImage
    led_energy: NDArray[np.float64]
    glass_key: int
    light_key: int
    repeat: int


@dataclass(frozen=True, slots=True)
class _Open:
    """An exposure under way."""

    frame_id: int
    start_us: int
    end_us: int
    glass_key: int
    switches: int
    lost: bool


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

    def configure(self, exposure_us: int, *, triggered: bool) -> None:
        """Exposure time and mode from the next :meth:`arm` on."""
        self.exposure_us = exposure_us
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
        if number in self._faults.camera_unplug:
            self.unplug()
        if not self.armed or not self._triggered:
            return
        if self.ready(time_us):
            self._start(time_us, lost=number in self._faults.camera_drop)
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
                self._start(due_us, lost=False)
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

    def _start(self, time_us: int, *, lost: bool) -> None:
        glass_key = zlib.crc32(np.packbits(self._glass.commanded_open).tobytes())
        end_us = time_us + self.exposure_us
        self._open = _Open(self._frame_id, time_us, end_us, glass_key, self._glass.switches, lost)
        self._frame_id += 1

    def _finish(self, window: _Open) -> None:
        self._open = None
        self._busy_until_us = window.end_us + self._readout_us
        energy = self._leds.energy(window.start_us, window.end_us)
        duration_s = (window.end_us - window.start_us) / US_PER_S
        levels = np.rint(energy / duration_s * FULL_LEVEL).astype("<i4")
        exposure = Exposure(
            frame_id=window.frame_id,
            start_us=window.start_us,
            exposure_us=window.end_us - window.start_us,
            transmission=self._glass.mean_transmission(window.start_us, window.end_us),
            led_energy=energy,
            glass_key=window.glass_key,
            light_key=zlib.crc32(levels.tobytes()),
            repeat=0,
        )
        pair = (exposure.glass_key, exposure.light_key, window.switches)
        self._repeat = self._repeat + 1 if pair == self._last_pair else 0
        self._last_pair = pair
        if window.lost:
            self.dropped += 1
        else:
            exposure = replace(exposure, repeat=self._repeat)
            self._reading.append((self._busy_until_us, exposure))

    def _deliver(self, exposure: Exposure) -> None:
        if len(self._finished) < BUFFERS:
            self._finished.append(exposure)
            return
        self.dropped += 1
        if not self._triggered:  # a preview wants the newest
            self._finished.popleft()
            self._finished.append(exposure)
