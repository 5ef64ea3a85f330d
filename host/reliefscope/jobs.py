"""Progress and cancellation of long functions.

A long function takes a :class:`Job`, opens a stage with :meth:`Job.stage`, and calls :meth:`Stage.advance`
per frame or tile.  Faces subscribe with a callback: the command line draws a bar, ``--json`` streams the
events, the terminal UI posts them as messages.  Cancellation is checked at every advance and raises
:class:`~reliefscope.errors.Cancelled` there, so a function never stops in the middle of a frame.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from typing import Any

from reliefscope.errors import Cancelled


@dataclass(frozen=True, slots=True)
class Progress:
    """State of one stage.

    ``done`` and ``total`` count the stage's own units (frames, heights, iterations); ``seconds_left`` is
    None until there is something to extrapolate from.
    """

    stage: str
    done: int
    total: int
    elapsed_s: float
    seconds_left: float | None
    note: str = ""
    finished: bool = False

    def as_dict(self) -> dict[str, Any]:
        """Event for ``--json`` streams."""
        return {"event": "progress", **asdict(self)}


Listener = Callable[[Progress], None]


class Job:
    """Cancellation flag, progress listeners and the time that each stage took.  Thread-safe."""

    def __init__(self, listener: Listener | None = None) -> None:
        self._listeners: list[Listener] = [listener] if listener else []
        self._cancelled = threading.Event()
        self.timings_s: dict[str, float] = {}

    def subscribe(self, listener: Listener) -> None:
        """Call ``listener`` for every later progress event, from the thread that does the work."""
        self._listeners.append(listener)

    def cancel(self) -> None:
        """Ask for a stop after the current frame or tile."""
        self._cancelled.set()

    @property
    def cancelled(self) -> bool:
        """Whether a stop has been asked for."""
        return self._cancelled.is_set()

    def check(self) -> None:
        """Raise :class:`Cancelled` if a stop has been asked for."""
        if self.cancelled:
            raise Cancelled("Stopped on request; everything finished so far is kept.")

    @contextmanager
    def stage(self, name: str, total: int) -> Iterator[Stage]:
        """Run one stage of ``total`` units; its duration adds to ``timings_s[name]``."""
        stage = Stage(self, name, total)
        stage.emit()
        try:
            yield stage
            stage.finish()
        finally:
            spent = time.perf_counter() - stage.started
            self.timings_s[name] = self.timings_s.get(name, 0.0) + spent

    def post(self, progress: Progress) -> None:
        """Hand an event to every listener."""
        for listener in self._listeners:
            listener(progress)


class Stage:
    """One stage of a job; made by :meth:`Job.stage`."""

    def __init__(self, job: Job, name: str, total: int) -> None:
        self.job = job
        self.name = name
        self.total = total
        self.done = 0
        self.started = time.perf_counter()

    def advance(self, units: int = 1, note: str = "") -> None:
        """Count ``units`` as done, report, and honour a request to stop."""
        self.done += units
        self.emit(note)
        self.job.check()

    def emit(self, note: str = "", *, finished: bool = False) -> None:
        """Report without counting."""
        elapsed = time.perf_counter() - self.started
        left = elapsed / self.done * (self.total - self.done) if self.done else None
        self.job.post(Progress(self.name, self.done, self.total, elapsed, left, note, finished))

    def finish(self) -> None:
        """Report the end of the stage."""
        self.done = self.total
        self.emit(finished=True)


def ensure_job(job: Job | None) -> Job:
    """The job given, or a silent one."""
    return job if job is not None else Job()
