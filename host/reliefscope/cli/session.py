"""What every subcommand has: a job that Ctrl-C cancels, a picture of its progress, and one way to print."""

from __future__ import annotations

import json
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType
from typing import TYPE_CHECKING, Any

from reliefscope.cli.errors import JSON_SCHEMA_VERSION
from reliefscope.cli.options import ProgressMode
from reliefscope.cli.progress import progress_display
from reliefscope.jobs import Job

if TYPE_CHECKING:
    from rich.console import Console

PLAIN_WIDTH = 120
"""Columns of tables that go to a file or pipe."""


PAUSE_NOTICE = "Pausing after the current frame; Ctrl-C again turns the light off and stops."
STOP_NOTICE = "Stopping after the current step; a result is written whole or not at all."
"""For what only computes."""


class Session:
    """One run of a subcommand; made by :func:`session`."""

    def __init__(self, job: Job, *, as_json: bool) -> None:
        self.job = job
        self.as_json = as_json

    def result(self, content: dict[str, Any], show: Callable[[Console], None]) -> None:
        """Print the result: ``content`` as one JSON object, or ``show`` on a console for people."""
        if self.as_json:
            text = json.dumps({"schema_version": JSON_SCHEMA_VERSION, **content}, indent=2)
            sys.stdout.write(text + "\n")
            sys.stdout.flush()
            return
        from rich.console import Console

        width = None if sys.stdout.isatty() else PLAIN_WIDTH
        show(Console(highlight=False, width=width))

    def say(self, text: str) -> None:
        """A remark for people, on standard error; left out with ``--json``."""
        if not self.as_json:
            from rich.console import Console

            Console(stderr=True, highlight=False, soft_wrap=True).print(text)


@contextmanager
def session(
    progress: ProgressMode, *, as_json: bool, notice: str = PAUSE_NOTICE
) -> Iterator[Session]:
    """Progress display and Ctrl-C handling around the body of a subcommand.

    The first Ctrl-C (or a polite end, SIGTERM) asks the job to pause after the current frame; the second
    raises KeyboardInterrupt, on which whoever holds the instrument turns the light off.  ``notice`` is what the
    first Ctrl-C tells the user.
    """
    job = Job()
    with progress_display(progress, job), _interrupts(job, notice):
        yield Session(job, as_json=as_json)


@contextmanager
def _interrupts(job: Job, notice: str) -> Iterator[None]:
    if threading.current_thread() is not threading.main_thread():
        yield
        return

    def on_signal(number: int, frame: FrameType | None) -> None:  # noqa: ARG001 - fixed by signal
        if job.cancelled:
            raise KeyboardInterrupt
        job.cancel()
        if number == signal.SIGINT:
            # write(2) only: rich's locks may be held by the very code that was interrupted
            sys.stderr.write(f"\n{notice}\n")

    wanted = [signal.SIGINT, signal.SIGTERM]
    previous = {number: signal.signal(number, on_signal) for number in wanted}
    try:
        yield
    finally:
        for number, handler in previous.items():
            signal.signal(number, handler)
