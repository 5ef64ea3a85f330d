"""The command line: a thin face over :mod:`reliefscope.microscope`."""

from __future__ import annotations

import signal
from collections.abc import Sequence

__all__ = ["main"]


def main(arguments: Sequence[str] | None = None) -> int:
    """Run ``reliefscope`` with ``arguments`` (default: those of the process); returns the exit code.

    With those of the process, Ctrl-C is deaf afterwards: pressed too often, it would end a clean stop in a traceback
    of the interpreter's own shutdown.
    """
    from reliefscope.cli.app import run

    status = run(arguments)
    if arguments is None:
        signal.signal(signal.SIGINT, signal.SIG_IGN)
    return status
