"""The one base exception, and the exit codes that the command line documents.

Every error that a user can meet says what happened (``message``), and what to do about it (``hint``: likely
cause and the next command to type).  ``exit_code`` is the process status that the command line returns; the
table in the guide is made from :class:`ExitCode`.
"""

from __future__ import annotations

import shlex
from enum import IntEnum
from pathlib import Path

DEFAULT_DEVICE = "sim://benchtop?scene=fiducial"
"""Instrument that commands open where none is named."""


class ExitCode(IntEnum):
    """Status of the ``reliefscope`` process."""

    OK = 0
    FAILURE = 1
    USAGE = 2
    INVALID_INPUT = 3
    DATASET = 4
    DEVICE = 5
    CAMERA = 6
    OUTCOME_UNKNOWN = 7
    VERIFICATION = 8
    LOCKED = 9
    CHECKS_FAILED = 10
    CANCELLED = 130

    @property
    def meaning(self) -> str:
        """One sentence for the table in the guide."""
        return _MEANINGS[self]


_MEANINGS = {
    ExitCode.OK: "The command did what it was asked.",
    ExitCode.FAILURE: "An unforeseen error; the log says more.",
    ExitCode.USAGE: "The command line itself was wrong.",
    ExitCode.INVALID_INPUT: "A file, plan, profile or option was refused before anything happened.",
    ExitCode.DATASET: "A dataset is missing, damaged, incomplete, or its place is already taken.",
    ExitCode.DEVICE: "The device was not found, refused, failed, or rebooted.",
    ExitCode.CAMERA: "The camera was not found, stalled, or lost frames.",
    ExitCode.OUTCOME_UNKNOWN: "The link was lost in the middle of a request; the device may have acted.",
    ExitCode.VERIFICATION: "Verification found frames that differ from what was recorded.",
    ExitCode.LOCKED: "Another process uses this run or port.",
    ExitCode.CHECKS_FAILED: "`doctor` found something that keeps the instrument from working.",
    ExitCode.CANCELLED: "Cancelled by the user; what was acquired is kept.",
}


class ReliefscopeError(Exception):
    """Base of every error that a user can meet.

    Parameters
    ----------
    message:
        What happened, in one sentence.
    hint:
        Likely cause and the next command to type; empty only where the message says it all.
    """

    exit_code: ExitCode = ExitCode.FAILURE

    def __init__(self, message: str, *, hint: str = "") -> None:
        super().__init__(message)
        self.message = message
        self.hint = hint

    def __str__(self) -> str:
        return f"{self.message}\n{self.hint}" if self.hint else self.message


class InvalidInputError(ReliefscopeError):
    """A file, plan, profile or argument was refused; nothing was touched."""

    exit_code = ExitCode.INVALID_INPUT


class DatasetError(ReliefscopeError):
    """A dataset is missing, damaged or incomplete."""

    exit_code = ExitCode.DATASET


class OutputExistsError(DatasetError):
    """The place for an output is taken; nothing was overwritten."""


class VerificationError(DatasetError):
    """Stored frames differ from what the journal recorded."""

    exit_code = ExitCode.VERIFICATION


class DeviceError(ReliefscopeError):
    """The link to the device or the device itself failed."""

    exit_code = ExitCode.DEVICE


class CameraError(ReliefscopeError):
    """The camera failed, stalled or lost a frame."""

    exit_code = ExitCode.CAMERA


class LockedError(ReliefscopeError):
    """Another process holds a run or a port."""

    exit_code = ExitCode.LOCKED


class Cancelled(ReliefscopeError):  # noqa: N818 - it is a request that was honoured, not a fault
    """The user asked to stop; everything acquired so far is kept."""

    exit_code = ExitCode.CANCELLED


def resume_command(run: Path, device: str = "") -> str:
    """What to type to go on with the unfinished ``run``, for hints.

    ``device`` is the address of the instrument that took it, empty where it is not known; the default one
    needs no naming.
    """
    command = f"reliefscope acquire --resume {shlex.quote(str(run))}"
    if device and device != DEFAULT_DEVICE:
        command += f" --device '{device}'"
    return f"`{command}`"
