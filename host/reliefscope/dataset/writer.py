"""Taking a run to the disk so that a crash at any moment loses nothing that was acknowledged."""

from __future__ import annotations

import datetime
import itertools
import logging
import os
import platform
import shutil
import socket
from pathlib import Path
from types import TracebackType

from reliefscope import __version__
from reliefscope.dataset.durable import (
    AppendFile,
    disk_error,
    make_folders,
    sync_folder,
)
from reliefscope.dataset.frames import FrameStore
from reliefscope.dataset.layout import Layout
from reliefscope.dataset.lock import RunLock
from reliefscope.dataset.records import (
    JOURNAL_FILE,
    FrameKey,
    FrameRecord,
    Journal,
    JournalEntry,
    key_text,
    pixel_hash,
)
from reliefscope.dataset.spec import RunSpec, read_spec, resume_command_of, write_spec
from reliefscope.dataset.verify import VerifyReport, verify_frames
from reliefscope.errors import DatasetError, InvalidInputError, OutputExistsError
from reliefscope.jobs import Job
from reliefscope.models.plan import FrameRequest
from reliefscope.units import RawImage, format_bytes

log = logging.getLogger(__name__)

PARTIAL_SUFFIX = ".partial"
_SPARE_BYTES = 64_000_000


def partial_path(path: Path) -> Path:
    """Folder in which the run ``path`` grows until it is complete."""
    return path.with_name(path.name + PARTIAL_SUFFIX)


def final_path(path: Path) -> Path:
    """Folder that the run ``path`` has once it is complete."""
    return path.with_name(path.name.removesuffix(PARTIAL_SUFFIX))


def now() -> str:
    """Time for records, ISO 8601 in UTC."""
    return datetime.datetime.now(datetime.UTC).isoformat(timespec="milliseconds")


def software_name() -> str:
    """Name and version of this program for records."""
    return f"reliefscope {__version__}"


def host_identity() -> dict[str, str]:
    """The computer that runs an acquisition."""
    return {
        "name": socket.gethostname(),
        "system": platform.platform(),
        "python": platform.python_version(),
        "software": software_name(),
    }


def _free_name(path: Path) -> Path:
    """A name like ``path`` that no run has, finished or not."""
    candidates = (path.with_name(f"{path.name}-{number}") for number in itertools.count(2))
    return next(
        name for name in candidates if not name.exists() and not partial_path(name).exists()
    )


def check_output(path: Path, needed_bytes: int = 0) -> None:
    """Refuse a place that is taken or too small, before anything moves.

    Raises
    ------
    OutputExistsError
        If the run, or an unfinished run of this name, exists.
    DatasetError
        If the disk has too little space.
    """
    if path.name.endswith(PARTIAL_SUFFIX):
        raise InvalidInputError(
            f"A run must not be called {path.name}: {PARTIAL_SUFFIX} marks an unfinished one.",
            hint="Choose another name.",
        )
    partial = partial_path(path)
    if partial.exists():
        raise OutputExistsError(
            f"{partial} exists: an unfinished run of this name.",
            hint=f"Finish it with {resume_command_of(partial)} (an unfinished import: "
            "remove it), or choose another name.",
        )
    if path.exists():
        raise OutputExistsError(
            f"{path} exists; nothing was overwritten.",
            hint=f"Choose another name: `--out {_free_name(path)}`.",
        )
    place = path.absolute().parent
    while not place.exists():
        place = place.parent
    free = shutil.disk_usage(place).free
    if free < needed_bytes + _SPARE_BYTES:
        raise DatasetError(
            f"The run needs {format_bytes(needed_bytes)}, but {place} has {format_bytes(free)} free.",
            hint="Free some space or choose another disk with `--out`.",
        )


class RunWriter:
    """Writes one run; holds its lock.  Use as a context manager.

    A frame is taken when its journal line is on the disk, which is after its pixels are.  ``put`` of a frame
    that was taken before supersedes it; its former pixels are kept under ``superseded/``.
    """

    def __init__(self, folder: Path, spec: RunSpec, lock: RunLock) -> None:
        self.folder = folder
        self.spec = spec
        self._lock = lock
        self._layout = Layout(spec)
        self._store = FrameStore(folder, self._layout, read_only=False)
        path = folder / JOURNAL_FILE
        self._journal = Journal.read(path)
        if path.exists() and path.stat().st_size > self._journal.whole_bytes:
            os.truncate(path, self._journal.whole_bytes)  # the torn line was never acknowledged
        self._file: AppendFile | None = AppendFile(path)
        self._damaged: set[FrameKey] = set()

    @classmethod
    def create(cls, path: Path, spec: RunSpec) -> RunWriter:
        """Begin the run ``path`` in ``path.partial``: plan and metadata first, then frames.

        Raises
        ------
        OutputExistsError
            If the run exists, finished or not.
        DatasetError
            If the disk is full or not writable.
        """
        check_output(path, spec.storage_bytes())
        folder = partial_path(path)
        # Whatever ends this early leaves no folder that looks like a run.
        staging = path.with_name(f".{path.name}.new-{os.getpid()}")
        try:
            parents = make_folders(staging)
            Layout(spec).create(staging)
            write_spec(staging, spec)
            if folder.exists():
                raise OutputExistsError(
                    f"{folder} exists; nothing was overwritten.", hint="Choose another name."
                )
            staging.rename(folder)
            for parent in [folder.absolute().parent, *parents]:
                sync_folder(parent)
        except OSError as error:
            shutil.rmtree(staging, ignore_errors=True)
            raise disk_error(error, folder) from error
        except BaseException:
            shutil.rmtree(staging, ignore_errors=True)
            raise
        return cls._locked(folder, spec)

    @classmethod
    def resume(cls, path: Path, job: Job | None = None) -> RunWriter:
        """Go on with a run; frames whose pixels are damaged count as missing.

        ``path`` may be given with or without ``.partial``.

        Raises
        ------
        DatasetError
            If there is no such run or its description is damaged.
        LockedError
            If another process uses it.
        """
        folder = path if path.exists() else partial_path(path)
        if not folder.is_dir():
            raise DatasetError(
                f"There is no run {path}.", hint=f"Look for it: `ls {path.absolute().parent}`."
            )
        writer = cls._locked(folder, read_spec(folder))
        try:
            writer.verify(job)
        except BaseException:
            writer.close()
            raise
        return writer

    @classmethod
    def _locked(cls, folder: Path, spec: RunSpec) -> RunWriter:
        lock = RunLock(folder)
        try:
            return cls(folder, spec, lock)
        except BaseException:
            lock.release()
            raise

    def __enter__(self) -> RunWriter:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def missing(self) -> list[FrameRequest]:
        """Planned images that are not taken, or whose pixels were found damaged, in the order of the plan."""
        return [
            request
            for key, request in self._layout.requests.items()
            if key not in self._journal.entries or key in self._damaged
        ]

    def set_spec(self, spec: RunSpec) -> None:
        """Replace ``run.json``; what decides the form and number of frames must not change."""
        if list(spec.requests()) != list(self.spec.requests()) or spec.frame != self.spec.frame:
            raise ValueError("the frames of a run cannot change once it exists")
        write_spec(self.folder, spec)
        self.spec = spec

    def put(self, record: FrameRecord, raw: RawImage) -> JournalEntry:
        """Store one image and acknowledge it; on return both pixels and journal line are on the disk.

        Raises
        ------
        DatasetError
            If the disk is full or fails; frames acknowledged before stay valid.
        """
        if self._file is None:
            raise ValueError("the writer is closed")
        key = record.key
        if key not in self._layout.places:
            raise ValueError(f"{key_text(key)} is not part of the plan")
        image = self._layout.images[self._layout.places[key][0]]
        if raw.shape != self.spec.frame.shape or raw.dtype != self._layout.dtype(image):
            raise ValueError(
                f"{key_text(key)}: {raw.dtype} {raw.shape} instead of "
                f"{self._layout.dtype(image)} {self.spec.frame.shape}"
            )
        entry = JournalEntry(**record.model_dump(), sha256=pixel_hash(raw))
        chunk = self.folder / self._layout.chunk_path(key)
        try:
            self._keep_superseded(key, chunk)
            self._store.write(key, raw)
            self._file.append(entry.model_dump_json().encode("utf-8"))
        except OSError as error:
            raise disk_error(error, chunk, self.spec.resume_command(self.folder)) from error
        self._journal.entries[key] = entry
        self._damaged.discard(key)
        return entry

    def verify(self, job: Job | None = None) -> VerifyReport:
        """Hash every frame taken so far; damaged ones count as missing from now on."""
        report = verify_frames(self._store, self._journal, job)
        self._damaged = set(report.damaged)
        return report

    def finish(self, job: Job | None = None) -> Path:
        """Verify every frame and give the run its final name.

        Raises
        ------
        VerificationError
            If a frame is missing or damaged; the run stays resumable.
        """
        self.verify(job).require_ok()
        final = final_path(self.folder)
        if final == self.folder:
            return final
        if final.exists():
            raise OutputExistsError(
                f"{final} exists; the finished run stays in {self.folder}.",
                hint=f"Move one of them away: `mv {self.folder} NEW-NAME`.",
            )
        self.close()
        try:
            self.folder.rename(final)
            sync_folder(final.parent)
        except OSError as error:
            raise disk_error(error, final, self.spec.resume_command(self.folder)) from error
        self.folder = final
        return final

    def close(self) -> None:
        """Let go of the run; what was put stays."""
        if self._file is not None:
            self._file.close()
            self._file = None
            self._lock.release()

    def _keep_superseded(self, key: FrameKey, chunk: Path) -> None:
        """Keep the pixels of an image that is taken again: nothing acquired is ever deleted."""
        if key not in self._journal.entries or not chunk.exists():
            return
        folder = self.folder / "superseded"
        folder.mkdir(exist_ok=True)
        for number in itertools.count(1):
            kept = folder / f"{key_text(key)}.{number}"
            if not kept.exists():
                break
        # A copy, so that the chunk of the earlier take stays in place until the new one replaces it.
        shutil.copyfile(chunk, kept)
        sync_folder(folder)
