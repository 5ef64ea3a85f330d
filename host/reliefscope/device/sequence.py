"""Timing of a sequence as the device steps it, for deadlines and time left."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from reliefscope.protocol.messages import Step
from reliefscope.units import US_PER_S

MARGIN = 1.5
MARGIN_S = 10.0


@dataclass(frozen=True, slots=True)
class SequenceTiming:
    """What holds for every step of a sequence.

    The light is on for ``light_lead_us`` before each trigger; ``gap_us`` separates the end of an exposure from
    what comes next (it must cover the camera's readout where no ready line is wired).  ``ready_timeout_ms`` of 0
    ignores the camera's ready line.
    """

    light_lead_us: int = 1_000
    trigger_us: int = 100
    gap_us: int = 1_000
    ready_timeout_ms: int = 5_000
    require_strobe: bool = False


def sequence_duration_s(steps: Iterable[Step], timing: SequenceTiming) -> float:
    """Duration in seconds if the camera is always ready."""
    overhead = timing.light_lead_us + timing.gap_us
    total = sum(s.settle_us + s.repeat * (s.exposure_us + overhead) for s in steps)
    return total / US_PER_S


def default_deadline_s(steps: Iterable[Step], timing: SequenceTiming) -> float:
    """Deadline in seconds that a healthy sequence never reaches."""
    return sequence_duration_s(steps, timing) * MARGIN + MARGIN_S
