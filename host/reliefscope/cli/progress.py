"""Progress on standard error: a bar on a terminal, sparse lines elsewhere, JSON lines for programs."""

from __future__ import annotations

import json
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TextIO

from reliefscope.cli.options import ProgressMode
from reliefscope.jobs import Job, Progress

SPARSE_S = 10.0
"""A stage that takes long says so this often."""


def label(stage: str) -> str:
    """Name of a stage for people."""
    return stage.replace("_", " ").replace("-", " ")


def duration(seconds: float) -> str:
    """Short duration: ``8.2 s``, ``3:05``, ``2:10:00``."""
    if seconds < 60:
        return f"{seconds:.1f} s"
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02d}:{rest:02d}" if hours else f"{minutes}:{rest:02d}"


@contextmanager
def progress_display(mode: ProgressMode, job: Job) -> Iterator[None]:
    """Show the events of ``job`` until the block ends."""
    if mode is ProgressMode.AUTO:
        mode = ProgressMode.BAR if sys.stderr.isatty() else ProgressMode.LINES
    if mode is ProgressMode.NONE:
        yield
    elif mode is ProgressMode.JSON:
        job.subscribe(JsonLines(sys.stderr))
        yield
    elif mode is ProgressMode.LINES:
        job.subscribe(SparseLines(sys.stderr.write))
        yield
    else:
        with _bar(job):
            yield


class JsonLines:
    """One JSON object per event, rate-limited per stage so that a million tiles do not flood a pipe."""

    def __init__(self, stream: TextIO, every_s: float = 0.1) -> None:
        self._stream = stream
        self._every_s = every_s
        self._lock = threading.Lock()
        self._last: dict[str, float] = {}

    def __call__(self, event: Progress) -> None:
        """Write ``event``; the first and the last of a stage always get through."""
        now = time.monotonic()
        with self._lock:
            due = now - self._last.get(event.stage, -1e9) >= self._every_s
            if not (due or event.finished or event.done == 0):
                return
            self._last[event.stage] = now
            self._stream.write(json.dumps(event.as_dict()) + "\n")
            self._stream.flush()


class SparseLines:
    """A line when a long stage has gone on for another ten seconds, and one when a stage ends."""

    def __init__(self, write: Callable[[str], object], every_s: float = SPARSE_S) -> None:
        self._write = write
        self._every_s = every_s
        self._lock = threading.Lock()
        self._last: dict[str, float] = {}

    def __call__(self, event: Progress) -> None:
        """Write what is worth a line."""
        with self._lock:
            if event.finished:
                self._last.pop(event.stage, None)
                self._write(f"{label(event.stage)}: done in {duration(event.elapsed_s)}\n")
                return
            now = time.monotonic()
            if now - self._last.setdefault(event.stage, now) < self._every_s:
                return
            self._last[event.stage] = now
            share = 100 * event.done / event.total if event.total else 100.0
            left = "" if event.seconds_left is None else f", {duration(event.seconds_left)} left"
            note = f" ({event.note})" if event.note else ""
            self._write(
                f"{label(event.stage)}: {event.done}/{event.total} ({share:.0f} %){left}{note}\n"
            )


@contextmanager
def _bar(job: Job) -> Iterator[None]:
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, TaskID, TextColumn
    from rich.progress import Progress as Bar

    bar = Bar(
        TextColumn("[bold]{task.description:<14}"),
        BarColumn(bar_width=32),
        MofNCompleteColumn(),
        TextColumn("{task.fields[left]:<12}", style="cyan"),
        TextColumn("{task.fields[note]}", style="dim"),
        console=Console(stderr=True),
        refresh_per_second=8,
    )
    tasks: dict[str, TaskID] = {}
    lock = threading.Lock()

    def show(event: Progress) -> None:
        with lock:
            if event.stage not in tasks:
                tasks[event.stage] = bar.add_task(
                    label(event.stage), total=event.total, left="", note=""
                )
            if event.finished:
                left = f"in {duration(event.elapsed_s)}"
            elif event.seconds_left is None:
                left = ""
            else:
                left = f"{duration(event.seconds_left)} left"
            bar.update(
                tasks[event.stage],
                completed=event.done,
                total=event.total,
                left=left,
                note="" if event.finished else event.note,
            )

    job.subscribe(show)
    with bar:
        yield
