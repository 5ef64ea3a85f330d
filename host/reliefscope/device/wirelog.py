"""A log of every frame on the link, one JSON object a line."""

from __future__ import annotations

import json
import time
from pathlib import Path
from typing import Literal

from reliefscope.protocol.framing import Frame

Direction = Literal["out", "in"]


class WireLog:
    """Writes frames as they pass: seconds since opening, direction, raw bytes, and what they say.

    Lines are flushed one by one, so that the log of a program that died is whole.
    """

    def __init__(self, path: Path) -> None:
        self._file = path.open("a", encoding="utf-8")
        self._start = time.monotonic()

    def note(self, direction: Direction, frame: Frame) -> None:
        """Write one frame."""
        line = {
            "t": round(time.monotonic() - self._start, 6),
            "dir": direction,
            "says": str(frame),
            "frame": frame.encode().hex(),
        }
        self._file.write(json.dumps(line) + "\n")
        self._file.flush()

    def close(self) -> None:
        """Close the file."""
        self._file.close()
