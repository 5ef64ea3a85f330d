"""Re-hashing of every frame against the journal.  Changes and deletes nothing."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from typing import Any

from reliefscope.dataset.frames import FrameStore
from reliefscope.dataset.records import FrameKey, Journal, key_text, pixel_hash
from reliefscope.errors import DatasetError, VerificationError
from reliefscope.jobs import Job, ensure_job


@dataclass
class VerifyReport:
    """What verification found."""

    run: str
    planned: int
    verified: int = 0
    missing: list[FrameKey] = field(default_factory=list)
    """Planned, but not in the journal."""
    damaged: dict[FrameKey, str] = field(default_factory=dict)
    """In the journal, but the pixels are absent or differ: why."""
    hint: str = ""
    """What to do about it."""
    problems: list[str] = field(default_factory=list)
    """Damage outside the frames."""

    @property
    def ok(self) -> bool:
        """Whether every planned frame is there and is what was recorded."""
        return not (self.missing or self.damaged or self.problems)

    def lines(self) -> list[str]:
        """The findings for people, one per line."""
        found = [f"{key_text(key)}: {reason}" for key, reason in self.damaged.items()]
        found += [f"{key_text(key)}: not taken yet" for key in self.missing]
        return found + self.problems

    def _summary(self) -> str:
        frames = len(self.damaged) + len(self.missing)
        if not frames:
            return "the journal is not as it should be"
        return f"{frames} of {self.planned} frames are not as planned"

    def as_dict(self) -> dict[str, Any]:
        """The report for ``--json``."""
        return {
            "schema_version": 1,
            "run": self.run,
            "ok": self.ok,
            "planned": self.planned,
            "verified": self.verified,
            "missing": [key_text(key) for key in self.missing],
            "damaged": {key_text(key): reason for key, reason in self.damaged.items()},
            "problems": self.problems,
        }

    def require_ok(self) -> None:
        """Raise :class:`VerificationError` that names what is wrong."""
        if self.ok:
            return
        found = self.lines()
        shown = "\n".join(f"  {line}" for line in found[:10])
        more = f"\n  ... and {len(found) - 10} more" if len(found) > 10 else ""
        raise VerificationError(
            f"{self.run}: {self._summary()}:\n{shown}{more}",
            hint=self.hint,
        )


def verify_frames(store: FrameStore, journal: Journal, job: Job | None = None) -> VerifyReport:
    """Hash every journalled frame and compare."""
    layout = store.layout
    hint = layout.spec.repair_hint(store.folder)
    report = VerifyReport(str(store.folder), planned=len(layout.places), hint=hint)
    report.missing = [key for key in layout.places if key not in journal.entries]
    if report.missing:  # otherwise what a damaged line recorded was taken again
        report.problems += journal.problems
    unplanned = [key for key in journal.entries if key not in layout.places]
    report.problems += [f"{key_text(key)} is journalled but not planned" for key in unplanned]
    taken = [key for key in layout.places if key in journal.entries]

    def check(key: FrameKey) -> str | None:
        try:
            same = pixel_hash(store.read(key)) == journal.entries[key].sha256
        except DatasetError as error:
            return error.message
        return None if same else "its pixels differ from the SHA-256 in the journal"

    with ensure_job(job).stage("verify", len(taken)) as stage, ThreadPoolExecutor(2) as pool:
        for key, reason in zip(taken, pool.map(check, taken), strict=True):
            if reason is None:
                report.verified += 1
            else:
                report.damaged[key] = reason
            stage.advance(note=key_text(key))
    return report
