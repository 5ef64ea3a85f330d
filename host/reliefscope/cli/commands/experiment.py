"""``reliefscope experiment``: the paper's experiments on the simulated instrument."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from reliefscope.cli.options import (
    METHOD_NAMES,
    JsonFlag,
    ProgressMode,
    ProgressOption,
    SizeOption,
    parse_size,
)
from reliefscope.cli.session import session

if TYPE_CHECKING:
    from rich.console import Console

    from reliefscope.microscope import SimulantFigure, TableOne

app = typer.Typer(
    name="experiment",
    help="Repeat the paper's experiments on the simulated instrument.",
    no_args_is_help=True,
)

FolderOption = Annotated[
    Path | None,
    typer.Option(
        "--out",
        "-o",
        metavar="FOLDER",
        help="Folder for everything, new if left out; what it holds already is used.",
    ),
]
SeedOption = Annotated[int, typer.Option("--seed", help="Seed of the samples and of the noise.")]


@app.command("table1")
def table_one(
    out: FolderOption = None,
    finish: Annotated[
        list[str] | None,
        typer.Option("--finish", help="Finish of the fiducial; all three if left out."),
    ] = None,
    method: Annotated[
        list[str] | None,
        typer.Option(
            "--method",
            metavar="NAME",
            help=f"Method of reconstruction; {' and '.join(METHOD_NAMES)} if left out.",
        ),
    ] = None,
    size: SizeOption = None,
    seed: SeedOption = 1,
    z_stack: Annotated[
        bool,
        typer.Option("--z-stack/--no-z-stack", help="Take the reference z-stack as well."),
    ] = True,
    as_json: JsonFlag = False,
    progress: ProgressOption = ProgressMode.AUTO,
) -> None:
    """Repeat Table I: fiducials of three finishes, by the instrument and by a conventional microscope's z-stack.

    Writes the table beside the paper's as Markdown and JSON, and a figure of heights and errors.
    """
    shape = parse_size(size)
    with session(progress, as_json=as_json) as this:
        from reliefscope import microscope
        from reliefscope.evaluation.table_one import FINISHES

        table = microscope.table_one(
            out,
            finishes=finish or FINISHES,
            methods=method or METHOD_NAMES,
            size=shape,
            seed=seed,
            z_stack=z_stack,
            job=this.job,
        )
    this.result(table.as_dict(), lambda console: _show_table(console, table))


@app.command("simulants")
def simulants(
    out: FolderOption = None,
    simulant: Annotated[
        list[str] | None,
        typer.Option("--simulant", help="ds1, mars1 or jsc1a; all three if left out."),
    ] = None,
    method: Annotated[
        str, typer.Option("--method", metavar="NAME", help="Method of reconstruction.")
    ] = METHOD_NAMES[0],
    size: SizeOption = None,
    seed: SeedOption = 1,
    as_json: JsonFlag = False,
    progress: ProgressOption = ProgressMode.AUTO,
) -> None:
    """Repeat the figures of planetary simulants: micrograph, oblique view, height and slant of each."""
    shape = parse_size(size)
    with session(progress, as_json=as_json) as this:
        from reliefscope import microscope

        figures = microscope.simulant_figures(
            out,
            simulants=simulant or microscope.SIMULANTS,
            method=method,
            size=shape,
            seed=seed,
            job=this.job,
        )
    content = {"figures": [figure.as_dict() for figure in figures]}
    this.result(content, lambda console: _show_figures(console, figures))


def _show_table(console: Console, table: TableOne) -> None:
    from rich.markdown import Markdown
    from rich.markup import escape

    console.print("[bold]Mean absolute error in µm after one median offset[/]")
    console.print(Markdown(table.markdown))
    if not table.whole:
        console.print(
            "[yellow]The frames show only a part of the fiducial: the paper's figures are for the whole.[/]"
        )
    console.print(f"[cyan]results[/]  {escape(str(table.folder))}", soft_wrap=True)
    console.print(f"[cyan]look at[/]  [bold]{escape(str(table.figure))}[/]", soft_wrap=True)


def _show_figures(console: Console, figures: list[SimulantFigure]) -> None:
    from rich.markup import escape

    from reliefscope.cli.tables import show_facts

    for figure in figures:
        show_facts(console, figure.name, figure.facts)
        console.print(f"[cyan]look at[/]  [bold]{escape(str(figure.figure))}[/]", soft_wrap=True)
