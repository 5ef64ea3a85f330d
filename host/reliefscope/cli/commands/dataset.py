"""``reliefscope import``, ``info`` and ``verify``: runs on disk."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from reliefscope.cli.options import JsonFlag, ProgressMode, ProgressOption, RunArgument
from reliefscope.cli.session import session
from reliefscope.errors import ExitCode

if TYPE_CHECKING:
    from rich.console import Console


def import_photographs(
    description: Annotated[
        Path, typer.Argument(metavar="FILE.yml", help="YAML file that describes the photographs.")
    ],
    out: Annotated[
        Path | None,
        typer.Option(
            "--out", "-o", help="Folder of the new run; runs/NAME-001 and so on if left out."
        ),
    ] = None,
    as_json: JsonFlag = False,
    progress: ProgressOption = ProgressMode.AUTO,
) -> None:
    """Turn photographs from any instrument into a run, by a small YAML file.

    Keys: pixel_um, views (slope), lights (direction), frames or a pattern, sensor, bit_depth, y_axis,
    height_range_um.
    """
    with session(progress, as_json=as_json) as this:
        from reliefscope import microscope
        from reliefscope.cli.tables import show_facts

        run = microscope.import_photographs(description, out, job=this.job)
        facts = run.describe()

    def show(console: Console) -> None:
        show_facts(console, "Run", facts)
        console.print(f"Next: [bold]reliefscope reconstruct {run.path}[/]")

    this.result(facts, show)


def info(run: RunArgument, as_json: JsonFlag = False) -> None:
    """Show what a run holds: instrument, plan, calibration, frames, results."""
    with session(ProgressMode.NONE, as_json=as_json) as this:
        from reliefscope import microscope
        from reliefscope.cli.tables import show_facts

        facts = microscope.open_run(run).describe()
    this.result(facts, lambda console: show_facts(console, "Run", facts))


def verify(
    run: RunArgument,
    as_json: JsonFlag = False,
    progress: ProgressOption = ProgressMode.AUTO,
) -> None:
    """Read every frame of a run again and compare it with its checksum. Changes nothing."""
    with session(progress, as_json=as_json) as this:
        from reliefscope import microscope

        report = microscope.open_run(run).verify(job=this.job)

    def show(console: Console) -> None:
        console.print(f"{report.verified} of {report.planned} frames are as they were recorded.")

    this.result(report.as_dict(), show)
    if not report.ok and as_json:
        raise typer.Exit(ExitCode.VERIFICATION)
    report.require_ok()
