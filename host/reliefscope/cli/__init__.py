"""The command line: a thin face over :mod:`reliefscope.microscope`."""

from __future__ import annotations

from collections.abc import Sequence

__all__ = ["main"]


def main(arguments: Sequence[str] | None = None) -> int:
    """Run ``reliefscope`` with ``arguments`` (default: those of the process); returns the exit code."""
    from reliefscope.cli.app import run

    return run(arguments)
