"""What the journal says of each image: one JSON line, written after its pixels are on the disk."""

from __future__ import annotations

import hashlib
import logging
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated

import numpy as np
from pydantic import Field, ValidationError

from reliefscope.models.base import StrictModel
from reliefscope.models.plan import FrameKind, FrameRequest
from reliefscope.units import RawImage

log = logging.getLogger(__name__)

JOURNAL_FILE = "journal.jsonl"
FrameKey = tuple[FrameKind, int | None, int | None]
"""Kind, view, light: what names an image within its run."""


class Confirmed(StrictModel):
    """State of the instrument during an exposure, as the device confirmed it."""

    aperture_slot: int
    aperture_sha256: str
    """Over the 1,024 bytes of the bitmap in page order."""
    open_pixels: int
    light_slot: int
    levels: dict[int, int]
    """LED index -> level."""


class SourceFile(StrictModel):
    """Photograph that an imported image was made from."""

    file: str
    sha256: str
    """Over the bytes of the file."""


class FrameRecord(StrictModel):
    """One image: what was asked for, what was confirmed, when it was taken."""

    kind: FrameKind
    view: int | None
    light: int | None
    accumulated: Annotated[int, Field(ge=1)] = 1
    """Exposures in the stored exact sum."""
    exposure_us: int | None = None
    confirmed: Confirmed | None = None
    device_time_us: int | None = None
    """Device time of the first trigger."""
    settle_waited_us: int | None = None
    """Shortest wait before a trigger of this image since glass or light changed."""
    frame_ids: tuple[int, ...] = ()
    """The camera's numbers of the frames summed, counted since it was armed."""
    sources: tuple[SourceFile, ...] = ()
    time: str
    """Host time, ISO 8601 in UTC."""

    @property
    def key(self) -> FrameKey:
        """Name of the image within its run."""
        return (self.kind, self.view, self.light)


class JournalEntry(FrameRecord):
    """A record with the checksum of the pixels that are on the disk."""

    sha256: str


def key_of(request: FrameRequest) -> FrameKey:
    """Name of a planned image within its run."""
    return (request.kind, request.view, request.light)


def key_text(key: FrameKey) -> str:
    """Name of an image for people, e.g. ``view-03-light-11``."""
    return FrameRequest(kind=key[0], view=key[1], light=key[2]).key


def pixel_hash(raw: RawImage) -> str:
    """SHA-256 over the pixels in little-endian C order."""
    ordered = np.ascontiguousarray(raw, dtype=raw.dtype.newbyteorder("<"))
    return hashlib.sha256(ordered.data).hexdigest()


@dataclass
class Journal:
    """Content of a journal file.

    ``entries`` holds the last line of each image: a retake supersedes.  ``whole_bytes`` is the length up to
    the end of the last whole line; what follows is the torn line of a crash and was never acknowledged.
    """

    entries: dict[FrameKey, JournalEntry] = field(default_factory=dict)
    problems: list[str] = field(default_factory=list)
    whole_bytes: int = 0

    @classmethod
    def read(cls, path: Path) -> Journal:
        """Read ``path``; an absent file is an empty journal."""
        try:
            data = path.read_bytes()
        except FileNotFoundError:
            return cls()
        journal = cls(whole_bytes=data.rfind(b"\n") + 1)
        if journal.whole_bytes < len(data):
            log.info("%s ends in a torn line, which is ignored", path)
        for number, line in enumerate(data[: journal.whole_bytes].splitlines(), start=1):
            try:
                entry = JournalEntry.model_validate_json(line)
            except (ValidationError, ValueError):
                journal.problems.append(
                    f"line {number} of {path.name} is damaged; the image that it recorded counts as not taken"
                )
                continue
            journal.entries[entry.key] = entry
        return journal
