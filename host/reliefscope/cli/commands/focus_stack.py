"""``reliefscope focus-stack``: height from images focused at different heights."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from reliefscope.cli.options import JsonFlag, ProgressMode, ProgressOption
from reliefscope.cli.session import STOP_NOTICE, session

if TYPE_CHECKING:
    from rich.console import Console

    from reliefscope.microscope import FocusOutcome


class PeakOption(StrEnum):
    """Where the peak of sharpness is taken to be."""

    PLANE = "plane"
    GAUSSIAN = "gaussian"


def focus_stack(
    places: Annotated[
        list[Path],
        typer.Argument(
            metavar="FOLDER|FILES...",
            help="Folder of a stack, or its pictures in the order in which they were taken.",
        ),
    ],
    step_um: Annotated[
        float | None,
        typer.Option(
            "--step-um",
            help="Height from one picture to the next, negative from the top down; not where stack.yml tells it.",
        ),
    ] = None,
    pixel_um: Annotated[
        float | None, typer.Option("--pixel-um", min=0.0, help="Size of a pixel on the sample.")
    ] = None,
    window: Annotated[
        int, typer.Option("--window", min=1, help="Side of the window in pixels, odd.")
    ] = 5,
    smoothing_px: Annotated[
        float, typer.Option("--smooth-px", min=0.0, help="Sigma of the final Gaussian in pixels.")
    ] = 3.0,
    peak: Annotated[
        PeakOption,
        typer.Option(
            "--peak", help="Height of the sharpest plane, or of a Gaussian through its neighbours."
        ),
    ] = PeakOption.PLANE,
    out: Annotated[
        Path | None,
        typer.Option("--out", "-o", help="New folder; runs/focus-stack-001 and so on if left out."),
    ] = None,
    as_json: JsonFlag = False,
    progress: ProgressOption = ProgressMode.AUTO,
) -> None:
    """Make one sharp picture and a height map of pictures focused at different heights.

    The defaults are those of the paper's reference measurement: window of 5 pixels, Gaussian of 3 pixels, no
    height between the planes.
    """
    with session(progress, as_json=as_json, notice=STOP_NOTICE) as this:
        from reliefscope import microscope

        outcome = microscope.focus_pictures(
            list(places),
            step_um=step_um,
            pixel_um=pixel_um,
            window=window,
            smoothing_px=smoothing_px,
            peak=peak.value,
            out=out,
            job=this.job,
        )
    this.result(outcome.as_dict(), lambda console: _show(console, outcome))


def _show(console: Console, outcome: FocusOutcome) -> None:
    from rich.markup import escape

    from reliefscope.cli.tables import show_facts

    show_facts(console, "Focus stack", outcome.facts())
    console.print(f"[cyan]results[/]  {escape(str(outcome.folder))}", soft_wrap=True)
    console.print(f"[cyan]look at[/]  [bold]{escape(str(outcome.pictures[0]))}[/]", soft_wrap=True)
