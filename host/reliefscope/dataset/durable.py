"""Writing that survives a power cut: temporary name, fsync of the file, rename, fsync of the folder.

A reader sees either the old file or the whole new one.  What these functions have returned from is on the disk.
"""

from __future__ import annotations

import asyncio
import errno
import os
from pathlib import Path

from zarr.core.buffer import Buffer
from zarr.storage import LocalStore

from reliefscope.errors import DatasetError

_NO_SPACE = {errno.ENOSPC, errno.EDQUOT, errno.EFBIG}


def disk_error(error: OSError, path: Path, resume: str = "") -> DatasetError:
    """The error that a user meets when writing ``path`` failed; ``resume`` is the command that goes on."""
    after = f", then go on with {resume}" if resume else ""
    if error.errno in _NO_SPACE:
        return DatasetError(
            f"The disk is full: {path} could not be written.",
            hint=f"Everything journalled so far is kept. Free some space (`df -h {path.parent}`)"
            f"{after}.",
        )
    return DatasetError(
        f"{path} could not be written: {error.strerror or error}.",
        hint="Check the disk and the permissions of the folder; everything journalled so far is kept.",
    )


def sync_folder(folder: Path) -> None:
    """Make the names in ``folder`` durable; systems that cannot open a folder need no such step."""
    try:
        handle = os.open(folder, os.O_RDONLY)
    except PermissionError:
        return
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def make_folders(folder: Path) -> list[Path]:
    """Create ``folder`` and its parents; return what must be synchronised to make their names durable."""
    if folder.is_dir():
        return []
    above = make_folders(folder.parent)
    folder.mkdir(exist_ok=True)
    return [folder.parent, *above]


def write_file(path: Path, data: bytes) -> None:
    """Write ``path`` in one atomic and durable step.

    Raises
    ------
    OSError
        As the system reports it; ``path`` is then what it was before.
    """
    parents = make_folders(path.parent)
    temporary = path.with_name(f".{path.name}.tmp-{os.getpid()}")
    try:
        with temporary.open("wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        temporary.replace(path)
    except OSError:
        temporary.unlink(missing_ok=True)
        raise
    # The innermost first: the file system commits all of them with it, and the others cost nothing.
    for folder in [path.parent, *parents]:
        sync_folder(folder)


class AppendFile:
    """File to which whole lines are appended; :meth:`append` returns when the line is on the disk."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._handle = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_APPEND, 0o644)
        sync_folder(path.parent)

    def append(self, line: bytes) -> None:
        """Append ``line`` (without its newline); a failed attempt leaves no part of it behind."""
        before = os.fstat(self._handle).st_size
        data = memoryview(line + b"\n")
        try:
            while data:
                data = data[os.write(self._handle, data) :]
            os.fsync(self._handle)
        except OSError:
            os.ftruncate(self._handle, before)
            raise

    def close(self) -> None:
        """Let go of the file."""
        os.close(self._handle)


class DurableStore(LocalStore):
    """The local store of zarr-python, with every write made durable before it returns."""

    async def set(self, key: str, value: Buffer) -> None:
        """Write one chunk or metadata document."""
        await asyncio.to_thread(self.set_sync, key, value)

    def set_sync(self, key: str, value: Buffer) -> None:
        """Write one chunk or metadata document; raises OSError."""
        self._check_writable()
        write_file(self.root / key, value.to_bytes())

    async def set_if_not_exists(self, key: str, value: Buffer) -> None:
        """Write a document unless it is there."""
        if not (self.root / key).exists():
            await self.set(key, value)
