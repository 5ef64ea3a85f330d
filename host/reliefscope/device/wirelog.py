"""A log of everything that passed between host and instrument, one JSON object a line.

It is kept in memory from the moment a port is opened, and written to a file where somebody wants one: an
acquisition keeps it beside its frames, so that a bug report can be played again.
"""

from __future__ import annotations

import json
import logging
import time
from collections import deque
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from threading import RLock
from typing import Any, Literal, TextIO

from reliefscope.protocol.framing import Frame

logger = logging.getLogger(__name__)

Direction = Literal["out", "in"]
SCHEMA_VERSION = 1
KEPT_LINES = 50_000
"""Lines kept in memory; older ones are forgotten, which the first line of a file then says."""

_Entry = tuple[float, str, Frame | str, Mapping[str, Any]]


class WireLog:
    """What passed, with the time: frames out and in, frames dropped, and what was asked of the camera.

    Parameters
    ----------
    path:
        File to append to from the start; see also :meth:`written_to`.
    clock_s:
        Where times come from: a port that keeps time of its own offers it, otherwise seconds since now.
    device:
        Address of the device, for the first line.

    Lines are flushed one by one, so that the log of a program that died is whole.  Thread-safe.
    """

    def __init__(
        self,
        path: Path | None = None,
        *,
        clock_s: Callable[[], float] | None = None,
        device: str = "",
    ) -> None:
        start = time.monotonic()
        self._clock_s = clock_s or (lambda: time.monotonic() - start)
        self._head = {
            "schema_version": SCHEMA_VERSION,
            "device": device,
            "clock": "host" if clock_s is None else "instrument",
        }
        self._lock = RLock()
        self._entries: deque[_Entry] = deque(maxlen=KEPT_LINES)
        self._noted = 0
        self._files: list[TextIO] = []
        if path is not None:
            self._begin(path)

    def note(self, direction: Direction, frame: Frame) -> None:
        """Write one frame; ``out`` before it leaves, ``in`` after it came."""
        self._add(direction, frame, {})

    def note_dropped(self, verdict: str, count: int) -> None:
        """Write that bytes came which were no sound frame."""
        self._add("in", f"{count} dropped: {verdict}", {"dropped": {verdict: count}})

    def note_camera(self, request: str, content: Mapping[str, Any]) -> None:
        """Write what was asked of the camera, or which frame it gave."""
        self._add("camera", request, content)

    @contextmanager
    def written_to(self, path: Path) -> Iterator[None]:
        """Write to a new file, what was noted before and everything until the end of the context.

        Raises
        ------
        OSError
            If the file exists or cannot be written.
        """
        with self._lock:
            file = self._begin(path)
        try:
            yield
        finally:
            with self._lock:
                self._end(file)

    def close(self) -> None:
        """Close every file."""
        with self._lock:
            for file in list(self._files):
                self._end(file)

    def _add(self, direction: str, what: Frame | str, content: Mapping[str, Any]) -> None:
        with self._lock:
            entry = (self._clock_s(), direction, what, content)
            self._entries.append(entry)
            self._noted += 1
            for file in list(self._files):
                try:
                    file.write(_line(entry))
                    file.flush()
                except (
                    OSError
                ) as error:  # a log that cannot be written must not end what it is about
                    logger.warning("the wire log %s ends here: %s", file.name, error)
                    self._end(file)

    def _end(self, file: TextIO) -> None:
        if file in self._files:
            self._files.remove(file)
            with suppress(OSError):  # what could not be written cannot be flushed either
                file.close()

    def _begin(self, path: Path) -> TextIO:
        file = path.open("x", encoding="utf-8")
        try:
            forgotten = self._noted - len(self._entries)
            head = {**self._head, "forgotten_lines": forgotten}
            file.write(_line((0.0, "log", f"wire log of {self._head['device']}", head)))
            file.writelines(_line(entry) for entry in self._entries)
            file.flush()
        except OSError:
            file.close()
            raise
        self._files.append(file)
        return file


def _line(entry: _Entry) -> str:
    t, direction, what, content = entry
    line: dict[str, Any] = {"t": round(t, 6), "dir": direction, "says": str(what), **content}
    if isinstance(what, Frame):
        line["frame"] = what.encode().hex()
    return json.dumps(line) + "\n"
