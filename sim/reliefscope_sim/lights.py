"""The LED lines over time: levels in, energy per exposure out.

Drivers are constant-current and follow at once.  An LED that is on warms up, and gives less light the warmer it
is: its warmth w, 0 cold and 1 at the end of warming at full level, follows the level f (0 to 1) with the time
constant of LED and board, and the light is

    f (1 - droop w),    dw/dt = (f - w) / tau,

integrated in closed form.  ``droop`` is the light lost when warm at full level; 0 (the default of the simulated
instrument) makes every retake of a frame the same to the last bit.  What an LED may take is the firmware's
business; the lines do what they are told.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from reliefscope.units import US_PER_S

FULL_LEVEL = 4095
WARMING_S = 8.0
"""Time constant of warming and cooling (assumed: LED in its holder, not the chip alone)."""
_TAU_US = WARMING_S * US_PER_S

_Levels = NDArray[np.int64]
_Warmth = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class _Span:
    """From ``start_us`` on the LEDs are at ``levels``; they begin with ``warmth``."""

    start_us: int
    levels: _Levels
    warmth: _Warmth

    def warmth_at(self, time_us: int) -> _Warmth:
        fraction = self.levels / FULL_LEVEL
        result: _Warmth = fraction + (self.warmth - fraction) * np.exp(
            -(time_us - self.start_us) / _TAU_US
        )
        return result

    def warmth_integral_us(self, since_us: int, until_us: int) -> _Warmth:
        fraction, duration = self.levels / FULL_LEVEL, until_us - since_us
        lag = (self.warmth_at(since_us) - fraction) * (-np.expm1(-duration / _TAU_US) * _TAU_US)
        result: _Warmth = fraction * duration + lag
        return result


class LedLines:
    """Levels of ``count`` LEDs over time.  Times are device time in us and never decrease."""

    def __init__(self, count: int, time_us: int = 0, droop: float = 0.0) -> None:
        self._droop = droop
        self._spans = [_Span(time_us, np.zeros(count, np.int64), np.zeros(count))]
        self._pinned: dict[int, int] = {}

    @property
    def levels(self) -> _Levels:
        """Levels (n_leds,) that hold now, 0 to 4095."""
        return self._spans[-1].levels.copy()

    def set_level(self, time_us: int, led: int, level: int) -> None:
        """Level of one LED from ``time_us`` on; a line with no LED on it changes nothing."""
        last = self._spans[-1]
        if time_us < last.start_us:
            raise ValueError(f"change at {time_us} us, before the last one at {last.start_us} us")
        level = self._pinned.get(led, level)
        if led >= len(last.levels) or last.levels[led] == level:
            return
        if time_us > last.start_us:
            last = _Span(time_us, last.levels.copy(), last.warmth_at(time_us))
            self._spans.append(last)
        last.levels[led] = level

    def pin(self, time_us: int, led: int, level: int) -> None:
        """A broken driver holds an LED at ``level`` from ``time_us`` on, whatever it is told."""
        self._pinned[led] = level
        self.set_level(time_us, led, level)

    def all_off(self, time_us: int) -> None:
        """The supply is gone."""
        for led in range(len(self._spans[-1].levels)):
            self.set_level(time_us, led, 0)

    def energy(self, start_us: int, end_us: int) -> NDArray[np.float64]:
        """Light (n_leds,) as a fraction of a cold LED at full level, times seconds, within [start_us, end_us]."""
        total = np.zeros(len(self._spans[0].levels))
        for span, since, until in self._within(start_us, end_us):
            fraction = span.levels / FULL_LEVEL
            lost: float | _Warmth = 0.0
            if self._droop:
                lost = self._droop * span.warmth_integral_us(since, until)
            total += fraction * (float(until - since) - lost)
        return total / US_PER_S

    def mean_levels(self, start_us: int, end_us: int) -> _Levels:
        """Levels (n_leds,) averaged over an exposure and rounded: what was commanded, warm or not."""
        total = np.zeros(len(self._spans[0].levels))
        for span, since, until in self._within(start_us, end_us):
            total += span.levels * float(until - since)
        return np.rint(total / (end_us - start_us)).astype(np.int64)

    def forget_before(self, time_us: int) -> None:
        """Drop changes that no exposure from ``time_us`` on can need."""
        while len(self._spans) > 1 and self._spans[1].start_us <= time_us:
            self._spans.pop(0)

    def _within(self, start_us: int, end_us: int) -> list[tuple[_Span, int, int]]:
        """Spans that meet an interval, each with the part of it that it covers."""
        if start_us < self._spans[0].start_us:
            raise ValueError(f"the history before {self._spans[0].start_us} us is forgotten")
        ends = [span.start_us for span in self._spans[1:]] + [end_us]
        parts = []
        for span, end in zip(self._spans, ends, strict=True):
            since, until = max(span.start_us, start_us), min(end, end_us)
            if until > since:
                parts.append((span, since, until))
        return parts
