"""The LED lines over time: levels in, energy per exposure out.

Drivers are constant-current and follow at once, so that the energy of an exposure is the integral of the
level over it.  What an LED may take is the firmware's business; the lines do what they are told.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from reliefscope.units import US_PER_S

FULL_LEVEL = 4095


class LedLines:
    """Levels of ``count`` LEDs over time.  Times are device time in us and never decrease."""

    def __init__(self, count: int, time_us: int = 0) -> None:
        self._spans: list[tuple[int, NDArray[np.int64]]] = [(time_us, np.zeros(count, np.int64))]

    @property
    def levels(self) -> NDArray[np.int64]:
        """Levels (n_leds,) that hold now, 0 to 4095."""
        return self._spans[-1][1].copy()

    def set_level(self, time_us: int, led: int, level: int) -> None:
        """Level of one LED from ``time_us`` on; a line with no LED on it changes nothing."""
        start_us, levels = self._spans[-1]
        if time_us < start_us:
            raise ValueError(f"change at {time_us} us, before the last one at {start_us} us")
        if led >= len(levels) or levels[led] == level:
            return
        if time_us > start_us:
            levels = levels.copy()
            self._spans.append((time_us, levels))
        levels[led] = level

    def energy(self, start_us: int, end_us: int) -> NDArray[np.float64]:
        """Level fraction times seconds (n_leds,) within [start_us, end_us]."""
        if start_us < self._spans[0][0]:
            raise ValueError(f"the history before {self._spans[0][0]} us is forgotten")
        total = np.zeros(len(self._spans[0][1]))
        ends = [span[0] for span in self._spans[1:]] + [max(end_us, self._spans[-1][0])]
        for (since, levels), until in zip(self._spans, ends, strict=True):
            duration = min(until, end_us) - max(since, start_us)
            if duration > 0:
                total += levels * float(duration)
        return total / (FULL_LEVEL * US_PER_S)

    def forget_before(self, time_us: int) -> None:
        """Drop changes that no exposure from ``time_us`` on can need."""
        while len(self._spans) > 1 and self._spans[1][0] <= time_us:
            self._spans.pop(0)
