"""How well the link does: round trips, throughput, errors and retries, counted on both sides."""

from __future__ import annotations

import dataclasses
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from reliefscope.device.client import Device
from reliefscope.device.errors import OutcomeUnknownError, RefusedError
from reliefscope.errors import DeviceError
from reliefscope.jobs import Job, Stage, ensure_job
from reliefscope.protocol.messages import APERTURE_SLOTS, SequenceState
from reliefscope.units import US_PER_S

REQUESTS = 500
UPLOADS = 25
"""Bitmaps of 1,024 bytes, as four chunks and a commit each."""
_VIRTUAL = 0.02
"""Departure of the clocks' ratio from 1 beyond which they are not the same time."""


@dataclass(frozen=True, slots=True)
class LinkHealth:
    """Figures of one test of a link.

    ``round_trip_ms`` has min, p50, p99 and max of the time from a status request to its answer, retries included,
    by the host's clock.  ``upload_bytes_per_s`` counts bitmap bytes only.  ``host`` and ``device`` are what each
    side counted during the test; ``lost_to_device`` and ``lost_to_host`` are frames that one side sent and the
    other never saw, whole or damaged.  ``clock_ratio`` is device time over host time: far from 1 under the simulated
    instrument's virtual time, where the times say how fast the simulation is.
    """

    board: str
    firmware: str
    requests: int
    seconds: float
    clock_ratio: float
    round_trip_ms: dict[str, float]
    requests_per_s: float
    upload_bytes_per_s: float
    unanswered: int
    refused: int
    retries: int
    lost_to_device: int
    lost_to_host: int
    damaged_to_device: int
    damaged_to_host: int
    host: dict[str, int]
    device: dict[str, int]

    @property
    def verdict(self) -> str:
        """One sentence."""
        if self.unanswered:
            return f"{self.unanswered} of {self.requests} requests were never answered: the link is not usable."
        if self.retries:
            share = 100 * self.retries / self.requests
            return f"Every request was answered, but {self.retries} retries were needed ({share:.2g} %)."
        return "Every request was answered at the first attempt."

    @property
    def is_virtual_time(self) -> bool:
        """Whether device and host live in different times."""
        return abs(self.clock_ratio - 1) > _VIRTUAL

    def as_dict(self) -> dict[str, Any]:
        """For ``--json``."""
        return {**asdict(self), "verdict": self.verdict}


class _Tally:
    """Times of the requests that were answered, and how the others ended."""

    def __init__(self) -> None:
        self.times_s: list[float] = []
        self.unanswered = 0
        self.refused = 0

    def run(self, request: Callable[[], object]) -> bool:
        started = time.perf_counter()
        try:
            request()
        except OutcomeUnknownError:
            self.unanswered += 1
            return False
        except RefusedError:
            self.refused += 1
            return False
        self.times_s.append(time.perf_counter() - started)
        return True


def measure_link(
    device: Device, requests: int = REQUESTS, uploads: int = UPLOADS, job: Job | None = None
) -> LinkHealth:
    """Test the link of a connected device.

    Nothing lights up and nothing moves; the last aperture slot is overwritten and left loaded with a test pattern.

    Parameters
    ----------
    device:
        Connected, and idle.
    requests:
        Status requests, at least 1.
    uploads:
        Bitmaps that are uploaded, at least 1.
    job:
        Told every request.

    Raises
    ------
    DeviceError
        If a sequence is under way, which the test would disturb.
    OutcomeUnknownError
        If not even the counters come through.
    """
    job = ensure_job(job)
    before_status = device.status()
    if before_status.sequence is not SequenceState.IDLE:
        raise DeviceError(
            f"A sequence is under way ({before_status.sequence.name}); a test would disturb it.",
            hint="Let it end or abort it, then repeat.",
        )
    pattern = np.indices((64, 128)).sum(axis=0) % 3 == 0
    device_before, host_before = dataclasses.asdict(device.counters()), device.link_counters
    started, started_us = time.perf_counter(), device.status().uptime_us
    polls, loads = _Tally(), _Tally()
    with job.stage("round_trips", requests) as stage:
        _repeat(stage, requests, lambda: polls.run(device.status))
    with job.stage("uploads", uploads) as stage:
        _repeat(
            stage,
            uploads,
            lambda: loads.run(lambda: device.load_aperture(APERTURE_SLOTS - 1, pattern)),
        )
    device_us = device.status().uptime_us - started_us
    seconds = time.perf_counter() - started
    device_after, host_after = dataclasses.asdict(device.counters()), device.link_counters
    on_device = {name: device_after[name] - device_before[name] for name in device_after}
    on_host = {name: n - host_before.get(name, 0) for name, n in host_after.items()}
    damaged_to_device = sum(on_device[n] for n in ("crc_errors", "framing_errors", "overruns"))
    damaged_to_host = sum(n for name, n in on_host.items() if name.startswith("dropped_"))
    identity = device.identity
    return LinkHealth(
        board=identity.board,
        firmware=f"{identity.firmware_version} ({identity.git_hash})",
        requests=requests + uploads,
        seconds=seconds,
        clock_ratio=device_us / US_PER_S / seconds,
        round_trip_ms=_percentiles_ms(polls.times_s),
        requests_per_s=_rate(len(polls.times_s), polls.times_s),
        upload_bytes_per_s=_rate(len(loads.times_s) * pattern.size // 8, loads.times_s),
        unanswered=polls.unanswered + loads.unanswered,
        refused=polls.refused + loads.refused,
        retries=on_host.get("retries", 0),
        # A frame that arrives twice makes up for one that is lost; without bad luck of that kind these are exact.
        lost_to_device=max(
            0, on_host["frames_sent"] - on_device["frames_received"] - damaged_to_device
        ),
        lost_to_host=max(
            0, on_device["frames_sent"] - on_host["frames_received"] - damaged_to_host
        ),
        damaged_to_device=damaged_to_device,
        damaged_to_host=damaged_to_host,
        host=on_host,
        device=on_device,
    )


def _repeat(stage: Stage, count: int, action: Callable[[], object]) -> None:
    for _ in range(count):
        action()
        stage.advance()


def _percentiles_ms(times_s: list[float]) -> dict[str, float]:
    if not times_s:
        return {}
    values = np.percentile(np.asarray(times_s) * 1000, [0, 50, 99, 100])
    return dict(zip(("min", "p50", "p99", "max"), (float(v) for v in values), strict=True))


def _rate(amount: int, times_s: list[float]) -> float:
    return amount / sum(times_s) if times_s else 0.0
