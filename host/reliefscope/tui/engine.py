"""The threads behind the screen: whatever talks to the instrument runs here, never in the screen's loop.

Commands run one after the other in one thread, the live picture in a second, an acquisition in the first
with the live picture at rest.  "All off" has a thread of its own, so that it never waits behind anything.
"""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

import numpy as np
from numpy.typing import NDArray
from textual.message import Message

from reliefscope.errors import Cancelled, ReliefscopeError
from reliefscope.jobs import Job, Progress
from reliefscope.microscope import Microscope, StoredRun
from reliefscope.models.camera import Frame
from reliefscope.models.plan import Aperture, Plan
from reliefscope.tui.preview import shade

logger = logging.getLogger(__name__)


class Opener(Protocol):
    """Opens the instrument behind a URL."""

    def __call__(self, url: str) -> Microscope:
        """Connect; raises a :class:`ReliefscopeError`."""


class Connected(Message):
    """The instrument is there."""

    def __init__(self, microscope: Microscope) -> None:
        super().__init__()
        self.microscope = microscope


class Disconnected(Message):
    """The instrument was let go."""


class Failed(Message):
    """Something went wrong."""

    def __init__(self, error: ReliefscopeError, doing: str) -> None:
        super().__init__()
        self.error = error
        self.doing = doing


class StateChanged(Message):
    """The device confirmed another aperture or light."""


class Advanced(Message):
    """A long job reports."""

    def __init__(self, progress: Progress) -> None:
        super().__init__()
        self.progress = progress


class Ended(Message):
    """An acquisition ended: with a run, or cancelled without a complete one."""

    def __init__(self, run: StoredRun | None, note: str, hint: str = "") -> None:
        super().__init__()
        self.run = run
        self.note = note
        self.hint = hint


@dataclass(frozen=True, slots=True)
class Picture:
    """A frame prepared for the screen."""

    levels: NDArray[np.uint8]
    mean: float
    """Fraction of full scale."""
    saturated: float
    """Fraction of the pixels at full scale."""
    frame_id: int
    exposure_us: int


class Engine:
    """Owner of the instrument while the screen is open.

    ``post`` hands a message to the screen from any thread; ``room`` tells (rows, columns) of pixels that the
    picture may take.
    """

    def __init__(
        self,
        post: Callable[[Message], object],
        room: Callable[[], tuple[int, int]],
        opener: Opener,
    ) -> None:
        self._post = post
        self._room = room
        self._opener = opener
        self._commands = ThreadPoolExecutor(max_workers=1, thread_name_prefix="instrument")
        self._urgent = ThreadPoolExecutor(max_workers=1, thread_name_prefix="all-off")
        self._live: threading.Thread | None = None
        self._live_stop = threading.Event()
        self._slot: Picture | None = None
        self._slot_free = threading.Event()
        self._slot_free.set()
        self._job: Job | None = None
        self._closing = False
        self.microscope: Microscope | None = None
        self.stretch = False

    @property
    def busy(self) -> bool:
        """Whether an acquisition is under way."""
        return self._job is not None

    # The live picture -------------------------------------------------------------------------

    def take_picture(self) -> Picture | None:
        """The newest picture not shown yet; the next one is made once this was taken."""
        picture, self._slot = self._slot, None
        if picture is not None:
            self._slot_free.set()
        return picture

    def _prepare(self, frame: Frame, microscope: Microscope) -> Picture:
        camera = microscope.profile.camera
        counts = frame.raw[::2, ::2] if min(frame.raw.shape) > 256 else frame.raw
        return Picture(
            levels=shade(
                frame.raw,
                camera.full_scale,
                self._room(),
                mosaic=camera.sensor != "mono",
                stretch=self.stretch,
            ),
            mean=float(counts.mean()) / camera.full_scale,
            saturated=float((counts >= camera.full_scale).mean()),
            frame_id=frame.frame_id,
            exposure_us=frame.exposure_us,
        )

    def _offer(self, frame: Frame, microscope: Microscope) -> None:
        if self._slot_free.is_set():
            self._slot_free.clear()
            self._slot = self._prepare(frame, microscope)

    def _start_live(self) -> None:
        microscope = self.microscope
        if microscope is None or not microscope.has_camera or self._live is not None:
            return
        self._live_stop.clear()
        self._live = threading.Thread(
            target=self._run_live, args=(microscope,), name="live", daemon=True
        )
        self._live.start()

    def _run_live(self, microscope: Microscope) -> None:
        try:
            for frame in microscope.live(self._live_stop):
                self._offer(frame, microscope)
                while not self._live_stop.is_set() and not self._slot_free.wait(0.05):
                    microscope.keep_alive()
        except ReliefscopeError as error:
            self._post(Failed(error, "live picture"))
        except Exception as error:
            logger.exception("live picture")
            self._post(Failed(_unforeseen(error), "live picture"))

    def _stop_live(self) -> None:
        self._live_stop.set()
        if self._live is not None:
            self._live.join()
            self._live = None

    # Commands ---------------------------------------------------------------------------------

    def connect(self, url: str) -> None:
        """Let go of the present instrument and open another."""

        def work() -> None:
            self._let_go()
            microscope = self._opener(url)
            self.microscope = microscope
            self._post(Connected(microscope))
            self._start_live()

        self._submit(work, f"connect to {url}")

    def disconnect(self) -> None:
        """Let go of the instrument."""
        self._submit(self._let_go, "disconnect")

    def show_aperture(self, aperture: Aperture) -> None:
        """Put an aperture on the glass."""
        self._command(lambda microscope: microscope.show_aperture(aperture), "change the glass")

    def shut(self) -> None:
        """Shut the glass."""
        self._command(lambda microscope: microscope.shut(), "shut the glass")

    def toggle_led(self, led: int, level: int) -> None:
        """Turn one LED on at ``level``, or off."""

        def work(microscope: Microscope) -> None:
            levels = dict(microscope.light)
            if led in levels:
                del levels[led]
            else:
                levels[led] = level
            microscope.set_light(levels)

        self._command(work, f"switch LED {led}")

    def set_level(self, level: int) -> None:
        """Give every LED that is on another level."""
        self._command(
            lambda microscope: microscope.set_light(dict.fromkeys(microscope.light, level)),
            "dim the light",
        )

    def set_exposure(self, exposure_us: int) -> None:
        """Exposure of the live picture."""

        def work(microscope: Microscope) -> None:
            self._stop_live()
            microscope.live_exposure_us = exposure_us
            self._start_live()

        self._command(work, "change the exposure")

    def all_off(self) -> None:
        """All LEDs off now, whatever else goes on; an acquisition pauses."""
        microscope, job = self.microscope, self._job
        if job is not None:
            job.cancel()
        if microscope is not None:
            self._urgent.submit(self._guard, lambda: self._do(microscope.all_off), "all LEDs off")

    def acquire(self, plan: Plan, out: Path | None, sample: str, notes: str) -> None:
        """Take a run; progress and end come as messages."""
        self._long(
            lambda microscope, job: microscope.acquire(
                plan, out, job=job, sample=sample, notes=notes, on_frame=self._watch(microscope)
            )
        )

    def resume(self, run: Path) -> None:
        """Go on with a run."""
        self._long(
            lambda microscope, job: microscope.resume(
                run, job=job, on_frame=self._watch(microscope)
            )
        )

    def cancel(self) -> None:
        """Pause the acquisition after the current frame."""
        if self._job is not None:
            self._job.cancel()

    def close(self) -> None:
        """End all threads; the light is off afterwards."""
        self._closing = True
        self.cancel()
        self._live_stop.set()
        self._submit(self._let_go, "disconnect")
        self._commands.shutdown(wait=True)
        self._urgent.shutdown(wait=True)

    # Inside -----------------------------------------------------------------------------------

    def _watch(self, microscope: Microscope) -> Callable[[Frame], None]:
        return lambda frame: self._offer(frame, microscope)

    def _long(self, work: Callable[[Microscope, Job], StoredRun]) -> None:
        if self.busy:
            return

        def report(progress: Progress) -> None:
            self._post(Advanced(progress))

        job = self._job = Job(report)

        def run(microscope: Microscope) -> None:
            self._stop_live()
            try:
                stored = work(microscope, job)
                self._post(Ended(stored, "complete"))
            except Cancelled as error:
                self._post(Ended(None, error.message, error.hint))
            except Exception:
                self._post(Ended(None, "stopped by an error"))
                raise
            finally:
                self._job = None
                if not self._closing:
                    self._start_live()

        def release() -> None:
            self._job = None

        self._command(run, "acquire", otherwise=release)

    def _command(
        self,
        work: Callable[[Microscope], None],
        doing: str,
        otherwise: Callable[[], None] | None = None,
    ) -> None:
        def run() -> None:
            microscope = self.microscope
            if microscope is None:
                if otherwise is not None:
                    otherwise()
                raise ReliefscopeError(
                    "No instrument is connected.", hint="Press `c` to choose one."
                )
            self._do(lambda: work(microscope))

        self._submit(run, doing)

    def _do(self, work: Callable[[], None]) -> None:
        try:
            work()
        finally:
            self._post(StateChanged())

    def _let_go(self) -> None:
        self._stop_live()
        microscope, self.microscope = self.microscope, None
        if microscope is not None:
            try:
                microscope.close()
            finally:
                self._post(Disconnected())

    def _submit(self, work: Callable[[], None], doing: str) -> None:
        self._commands.submit(self._guard, work, doing)

    def _guard(self, work: Callable[[], None], doing: str) -> None:
        try:
            work()
        except ReliefscopeError as error:
            self._post(Failed(error, doing))
        except Exception as error:
            logger.exception(doing)
            self._post(Failed(_unforeseen(error), doing))


def _unforeseen(error: Exception) -> ReliefscopeError:
    return ReliefscopeError(
        f"Unforeseen {type(error).__name__}: {error}",
        hint="This is a defect of the program; `reliefscope --debug tui` logs where it happened.",
    )
