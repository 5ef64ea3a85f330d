"""``reliefscope bundle``: a run without its pixels, for a bug report."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from reliefscope.cli.options import JsonFlag, ProgressMode, RunArgument
from reliefscope.cli.session import session


def bundle(
    run: RunArgument,
    out: Annotated[
        Path | None,
        typer.Option("--out", "-o", metavar="FILE", help="Bundle; RUN.bundle.zip if left out."),
    ] = None,
    as_json: JsonFlag = False,
) -> None:
    """Pack what happened in a run, without its pixels, into a file for a bug report.

    Plan, calibration, journal and every byte between host and instrument; with a simulated instrument also its
    seed and faults, so that `reliefscope sim replay FILE` repeats the session.
    """
    with session(ProgressMode.NONE, as_json=as_json) as this:
        from reliefscope import microscope
        from reliefscope.units import format_bytes

        path = microscope.bundle_run(run, out)
    size = path.stat().st_size
    this.result(
        {"bundle": str(path), "bytes": size},
        lambda console: console.print(f"{path} ({format_bytes(size)})"),
    )
