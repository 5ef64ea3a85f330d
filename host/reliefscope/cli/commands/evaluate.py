"""``reliefscope evaluate``: a result against the fiducial's true shape."""

from __future__ import annotations

from typing import Annotated

import typer

from reliefscope.cli.options import JsonFlag, ProgressMode, ProgressOption, RunArgument
from reliefscope.cli.session import session


def evaluate(
    run: RunArgument,
    name: Annotated[
        str | None,
        typer.Option("--name", help="Result to evaluate; every result of the run if left out."),
    ] = None,
    seed: Annotated[
        int, typer.Option("--fiducial-seed", help="Seed that drew the fiducial's slanted planes.")
    ] = 1,
    as_json: JsonFlag = False,
    progress: ProgressOption = ProgressMode.AUTO,
) -> None:
    """Compare the results of a run of the 3D fiducial with its true shape, beside Table I of the paper.

    Mean absolute errors in micrometres: as they are, after one median offset, and after a plane fit. Every
    pixel counts; a missing height counts as 100 um.
    """
    with session(progress, as_json=as_json) as this:
        from reliefscope import microscope
        from reliefscope.cli.tables import show_table
        from reliefscope.targets import Fiducial3D

        evaluation = microscope.evaluate_run(
            run, name=name, target=Fiducial3D(seed=seed), job=this.job
        )
    this.result(evaluation.as_dict(), lambda console: show_table(console, evaluation))
