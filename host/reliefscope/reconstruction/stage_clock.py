"""Time of each stage of a reconstruction, and the memory that it took."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager

import psutil

from reliefscope.jobs import Job


class StageClock:
    """Seconds spent per stage; ``timings_s`` fills as the stages end."""

    def __init__(self, job: Job) -> None:
        self.job = job
        self.timings_s: dict[str, float] = {}

    @contextmanager
    def timed(self, stage: str) -> Iterator[None]:
        """Add the time of the block to ``stage``, after honouring a request to stop."""
        self.job.check()
        begun = time.perf_counter()
        yield
        self.timings_s[stage] = self.timings_s.get(stage, 0.0) + time.perf_counter() - begun


def peak_memory_mb() -> float:
    """Greatest resident memory of this process so far, in MB."""
    if sys.platform == "win32":
        return float(psutil.Process().memory_info().peak_wset) / 1e6
    import resource

    unit = 1 if sys.platform == "darwin" else 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * unit / 1e6
