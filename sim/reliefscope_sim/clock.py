"""Where device time comes from: from waiting (virtual), or from the wall (real).

Under virtual time nothing happens until somebody waits; a wait lets the clock run to what was waited for, so a
run takes as long as its frames take to render.  Under real time the clock follows the wall, and a wait sleeps.
"""

from __future__ import annotations

import time
from typing import Literal

from reliefscope.units import US_PER_S

TimeMode = Literal["virtual", "real"]


class Clock:
    """Device time in us since the bench was switched on; moved by the bench alone."""

    def __init__(self, mode: TimeMode) -> None:
        self.real = mode == "real"
        self._origin_s = time.monotonic()
        self._virtual_us = 0

    def due_us(self) -> int:
        """Time up to which the bench has to have run: the wall's, or where virtual time stands."""
        if self.real:
            return int((time.monotonic() - self._origin_s) * US_PER_S)
        return self._virtual_us

    def advance_to(self, time_us: int) -> None:
        """Let virtual time stand at ``time_us``; the wall needs no telling."""
        self._virtual_us = max(self._virtual_us, time_us)
