"""What passed between a host and an instrument, read back from a wire log or a bundle of ``reliefscope bundle``."""

from __future__ import annotations

import json
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from reliefscope.errors import InvalidInputError
from reliefscope.protocol.framing import Frame, FrameReader
from reliefscope.units import US_PER_S

SCHEMA_VERSION = 1
BUNDLE_FILE = "bundle.json"
_WIRE = "wire-"


@dataclass(frozen=True, slots=True)
class Happening:
    """One line of a log.

    ``direction`` is ``out``, ``in`` or ``camera``; ``frame`` is what passed over the link, ``says`` and
    ``content`` what was asked of the camera or came from it.
    """

    time_us: int
    direction: str
    says: str
    frame: Frame | None
    content: dict[str, Any]


@dataclass(frozen=True, slots=True)
class Recording:
    """One session: from the opening of the port to its end."""

    source: str
    device: str
    """Address of the device."""
    keeps_time: bool
    """Whether times are the instrument's own; else the host's, and good for the order of things."""
    happenings: tuple[Happening, ...]

    @property
    def nonces(self) -> list[int]:
        """Boot nonces of the device, in the order of its boots."""
        seen = [h.frame.boot_nonce for h in self.happenings if h.direction == "in" and h.frame]
        return list(dict.fromkeys(nonce for nonce in seen if nonce))

    @classmethod
    def load(cls, path: Path) -> Recording:
        """Read a bundle (its last session) or a wire log by itself.

        Raises
        ------
        InvalidInputError
            If it is neither, is of another version, or lacks its beginning.
        """
        lines = _lines(path)
        head = lines[0] if lines else {}
        if head.get("dir") != "log" or head.get("schema_version") != SCHEMA_VERSION:
            raise _unreadable(path, "its first line is not that of a wire log of this version")
        if head.get("forgotten_lines"):
            raise _unreadable(path, "the session was so long that its beginning is lost")
        try:
            happenings = tuple(_happenings(lines[1:]))
        except (KeyError, TypeError, ValueError) as error:
            raise _unreadable(path, f"a line is damaged ({error})") from error
        keeps_time = head.get("clock") == "instrument"
        return cls(str(path), str(head.get("device", "")), keeps_time, happenings)


def _lines(path: Path) -> list[dict[str, Any]]:
    try:
        if zipfile.is_zipfile(path):
            with zipfile.ZipFile(path) as bundle:
                sessions = sorted(n for n in bundle.namelist() if n.startswith(_WIRE))
                if not sessions:
                    raise _unreadable(path, "it holds no wire log")
                text = bundle.read(sessions[-1]).decode("utf-8")
        else:
            text = path.read_text("utf-8")
        whole = text[: text.rfind("\n") + 1]  # a program that died may have torn the last line
        lines = [json.loads(line) for line in whole.splitlines()]
    except FileNotFoundError:
        raise InvalidInputError(
            f"There is no recording {path}.", hint="Make one of a run: `reliefscope bundle RUN`."
        ) from None
    except (OSError, ValueError, zipfile.BadZipFile) as error:
        raise _unreadable(path, str(error)) from error
    if not all(isinstance(line, dict) for line in lines):
        raise _unreadable(path, "its lines are no objects")
    return lines


def _happenings(lines: list[dict[str, Any]]) -> Iterator[Happening]:
    for line in lines:
        frame = None
        if "frame" in line:
            (frame,) = FrameReader().feed(bytes.fromhex(line["frame"]))
        time_us = round(float(line["t"]) * US_PER_S)
        yield Happening(time_us, line["dir"], line["says"], frame, line)


def _unreadable(path: Path, why: str) -> InvalidInputError:
    return InvalidInputError(
        f"{path} is no recording that can be played: {why}.",
        hint="Give a bundle that `reliefscope bundle RUN` made, or the wire-*.jsonl of a run.",
    )
