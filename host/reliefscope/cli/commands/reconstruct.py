"""``reliefscope reconstruct``: from a run to height, normals and pictures."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from reliefscope.cli.options import (
    METHOD_HELP,
    CalibrationOption,
    JsonFlag,
    ProgressMode,
    ProgressOption,
    RunArgument,
)
from reliefscope.cli.session import STOP_NOTICE, session


def reconstruct(
    run: RunArgument,
    method: Annotated[
        str | None,
        typer.Option("--method", metavar="NAME", help=f"{METHOD_HELP}; joint if left out."),
    ] = None,
    settings: Annotated[
        Path | None, typer.Option("--settings", metavar="FILE", help="YAML file of settings.")
    ] = None,
    name: Annotated[
        str | None,
        typer.Option("--name", help="Name of the result within the run; the method's if left out."),
    ] = None,
    calibration: CalibrationOption = None,
    pictures: Annotated[
        bool, typer.Option("--pictures/--no-pictures", help="Draw the pictures as well.")
    ] = True,
    overwrite: Annotated[
        bool, typer.Option("--overwrite", help="Replace a result of the same name.")
    ] = False,
    as_json: JsonFlag = False,
    progress: ProgressOption = ProgressMode.AUTO,
) -> None:
    """Reconstruct height, normals and albedo of a run, and draw the pictures.

    A run with one view gets normals and an integrated surface only, one with one light gets stereo only.
    """
    with session(progress, as_json=as_json, notice=STOP_NOTICE) as this:
        from reliefscope import microscope
        from reliefscope.cli.tables import show_reconstruction

        outcome = microscope.reconstruct_run(
            run,
            name=name,
            method=method,
            settings=settings,
            calibration=calibration,
            pictures=pictures,
            overwrite=overwrite,
            job=this.job,
        )
    this.result(outcome.as_dict(), lambda console: show_reconstruction(console, outcome))
