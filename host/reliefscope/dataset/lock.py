"""One writer per run: a file lock inside the run's folder that tells who holds it."""

from __future__ import annotations

import contextlib
import os
from pathlib import Path

import filelock

from reliefscope.errors import LockedError

LOCK_FILE = ".lock"
HOLDER_FILE = ".lock-holder"


class RunLock:
    """Exclusive use of a run; released on exit, and by the system when the process dies.

    Raises
    ------
    LockedError
        If another process (or another writer of this one) holds the run; the message names its process id.
    """

    def __init__(self, folder: Path) -> None:
        self._holder = folder / HOLDER_FILE
        self._lock = filelock.FileLock(folder / LOCK_FILE, timeout=0)
        try:
            self._lock.acquire()
        except filelock.Timeout:
            raise LockedError(
                f"{folder} is in use by process {_holder(folder)}.",
                hint="Wait until it ends, or end it; then repeat the command.",
            ) from None
        # A file of its own: some versions of the lock empty the locked file when another process asks for it.
        with contextlib.suppress(OSError):
            self._holder.write_text(f"{os.getpid()}\n", encoding="ascii")

    def release(self) -> None:
        """Let others use the run; releasing twice does no harm."""
        if self._lock.is_locked:
            with contextlib.suppress(OSError):
                self._holder.unlink()
            self._lock.release()

    def __enter__(self) -> RunLock:
        return self

    def __exit__(self, *_: object) -> None:
        self.release()


def _holder(folder: Path) -> str:
    try:
        return (folder / HOLDER_FILE).read_text(encoding="ascii").strip() or "(unknown)"
    except OSError:
        return "(unknown)"
