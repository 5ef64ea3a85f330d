"""The liquid crystal in time: voltage on a pixel to light through it.

A pixel relaxes toward the state that its voltage asks for as a first-order system,

    x(t) = d + (x0 - d) exp(-(t - t0) / tau),    d = 1 driven, 0 not,

with tau from the 10-90 % time of the data sheets (t_10-90 = tau ln 9), one for switching on (``rise_ms``) and
one for falling back (``decay_ms``), both at 25 degrees Celsius and longer when cold.  Where the voltages are
not those of the right contrast, d lies in between (:mod:`reliefscope_sim.liquid_crystal` has both laws).  The
transmission runs from 1 / contrast (shut) to 1 (open); negative glass (variant S) is open where aligned and dark
at rest, positive glass (E) clear at rest.  Averages over an exposure are exact: the exponential is integrated in
closed form between the switch events.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from reliefscope.models.instrument import GlassModel
from reliefscope.units import BoolImage, FloatImage
from reliefscope_sim.liquid_crystal import ROOM_C, slowdown

LN_9 = math.log(9.0)
SETTLED = 1e-6
"""Distance from the final state that counts as none: light far below one electron of any pixel."""
RIGHT_CONTRAST = (0.0, 1.0)
"""Aligned fraction in the end of pixels that are not driven, and of those that are."""

_State = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class _Span:
    """From ``start_us`` on the pixels relax from ``aligned`` toward what their voltages ask for."""

    start_us: int
    aligned: _State
    driven: BoolImage
    ends: tuple[float, float] = RIGHT_CONTRAST

    @property
    def target(self) -> _State:
        """Aligned fraction in the end."""
        off, on = self.ends
        return np.where(self.driven, on, off)


class Glass:
    """State of all pixels over time.  Times are device time in us and never decrease."""

    def __init__(self, model: GlassModel, time_us: int = 0, temperature_c: float = ROOM_C) -> None:
        shape = (model.rows, model.columns)
        self._floor = 1.0 / model.contrast_ratio
        self._open_when_driven = model.variant == "S"
        per_ms = 1000 / LN_9 * slowdown(temperature_c)
        self._tau_us = (model.decay_ms * per_ms, model.rise_ms * per_ms)
        self._spans = [_Span(time_us, np.zeros(shape), np.zeros(shape, dtype=bool))]
        self.switches = 0
        """Times that any pixel changed its voltage."""

    @property
    def driven(self) -> BoolImage:
        """Pixels (64, 128) that are driven now."""
        return self._spans[-1].driven

    @property
    def commanded_open(self) -> BoolImage:
        """Pixels (64, 128) that will be open once the glass has settled."""
        return self.driven if self._open_when_driven else ~self.driven

    def drive(
        self, time_us: int, driven: BoolImage, ends: tuple[float, float] = RIGHT_CONTRAST
    ) -> bool:
        """Voltages from ``time_us`` on; returns whether any pixel changed.

        ``ends`` are the aligned fractions that pixels reach which are not driven, and which are.
        """
        last = self._spans[-1]
        if last.ends == ends and np.array_equal(last.driven, driven):
            return False
        if time_us < last.start_us:
            raise ValueError(f"switch at {time_us} us, before the last one at {last.start_us} us")
        self._spans.append(_Span(time_us, self._relaxed(last, time_us), driven.copy(), ends))
        self.switches += 1
        return True

    def transmission(self, time_us: int) -> FloatImage:
        """Transmission (64, 128), 1 = open, at one moment not before the history that is kept."""
        span = next(span for span in reversed(self._spans) if span.start_us <= time_us)
        return self._light(self._relaxed(span, time_us))

    def mean_transmission(self, start_us: int, end_us: int) -> FloatImage:
        """Transmission (64, 128) averaged over an exposure, exact across every switch within it."""
        if end_us <= start_us:
            raise ValueError("an exposure ends after it starts")
        if start_us < self._spans[0].start_us:
            raise ValueError(f"the history before {self._spans[0].start_us} us is forgotten")
        total: _State = np.zeros_like(self._spans[0].aligned)
        for index, span in enumerate(self._spans):
            is_last = index + 1 == len(self._spans)
            until = end_us if is_last else min(end_us, self._spans[index + 1].start_us)
            since = max(start_us, span.start_us)
            if until > since:
                total += self._integral(span, since, until)
        return self._light(total / (end_us - start_us))

    def forget_before(self, time_us: int) -> None:
        """Drop switch events that no exposure from ``time_us`` on can need."""
        while len(self._spans) > 1 and self._spans[1].start_us <= time_us:
            self._spans.pop(0)

    def _relaxed(self, span: _Span, time_us: int) -> _State:
        decay, rise = (math.exp(-(time_us - span.start_us) / tau) for tau in self._tau_us)
        target = span.target
        distance: _State = (span.aligned - target) * np.where(span.driven, rise, decay)
        distance[np.abs(distance) < SETTLED] = 0.0
        return target + distance

    def _integral(self, span: _Span, since_us: int, until_us: int) -> _State:
        """Integral over time (us) of the aligned fraction."""
        duration = until_us - since_us
        weights = [tau * -math.expm1(-duration / tau) for tau in self._tau_us]
        target = span.target
        distance = self._relaxed(span, since_us) - target
        lag = distance * np.where(span.driven, weights[1], weights[0])
        result: _State = target * float(duration) + lag
        return result

    def _light(self, aligned: _State) -> FloatImage:
        opened = aligned if self._open_when_driven else 1.0 - aligned
        return (self._floor + (1.0 - self._floor) * opened).astype(np.float32)
