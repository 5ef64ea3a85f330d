"""``reliefscope demo``: from a simulated instrument to a measured surface."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from reliefscope.cli.options import (
    METHOD_HELP,
    METHOD_NAMES,
    JsonFlag,
    ProgressMode,
    ProgressOption,
    SizeOption,
    parse_size,
)
from reliefscope.cli.session import session


def demo(
    out: Annotated[
        Path | None,
        typer.Option(
            "--out", "-o", help="Folder of the new run; runs/demo-001 and so on if left out."
        ),
    ] = None,
    size: SizeOption = None,
    scene: Annotated[
        str, typer.Option("--scene", help="What lies under the objective.")
    ] = "fiducial",
    finish: Annotated[
        str | None, typer.Option("--finish", help="Finish of the fiducial: dull, half or metallic.")
    ] = None,
    seed: Annotated[int, typer.Option("--seed", help="Seed of the scene and of the noise.")] = 1,
    profile: Annotated[
        str, typer.Option("--profile", help="Instrument to simulate: benchtop or miniature.")
    ] = "benchtop",
    method: Annotated[
        str, typer.Option("--method", metavar="NAME", help=f"{METHOD_HELP}.")
    ] = METHOD_NAMES[0],
    beside: Annotated[
        str | None,
        typer.Option(
            "--beside",
            metavar="NAME",
            help="Another method, whose errors are shown beside: `paper` takes minutes at full size.",
        ),
    ] = None,
    as_json: JsonFlag = False,
    progress: ProgressOption = ProgressMode.AUTO,
) -> None:
    """Measure the 3D fiducial on a simulated instrument and compare the result with its true shape.

    Acquires 12 apertures x 16 lights through the real firmware and protocol, reconstructs, evaluates beside
    Table I of the paper, and draws the pictures.
    """
    shape = parse_size(size)
    with session(progress, as_json=as_json) as this:
        from reliefscope import microscope
        from reliefscope.cli.tables import show_demo

        result = microscope.demo(
            out,
            size=shape,
            scene=scene,
            finish=finish,
            seed=seed,
            profile=profile,
            method=method,
            beside=beside,
            job=this.job,
        )
    this.result(result.as_dict(), lambda console: show_demo(console, result))
