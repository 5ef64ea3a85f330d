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
    fiducial: Annotated[
        bool,
        typer.Option(
            "--fiducial",
            help="The run shows the fiducial, though neither its sample nor its notes say so.",
        ),
    ] = False,
    seed: Annotated[
        int | None,
        typer.Option(
            "--fiducial-seed",
            help="Seed that drew the fiducial's slanted planes, 1 if left out; implies `--fiducial`.",
        ),
    ] = None,
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

        stated = Fiducial3D(seed=1 if seed is None else seed)
        target = stated if fiducial or seed is not None else None
        evaluation = microscope.evaluate_run(run, name=name, target=target, job=this.job)
    this.result(evaluation.as_dict(), lambda console: show_table(console, evaluation))
