"""``reliefscope calibrate``: measure how this instrument departs from its design."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from reliefscope.cli.options import (
    CalibrationOption,
    CameraOption,
    JsonFlag,
    ProfileOption,
    ProgressMode,
    ProgressOption,
)
from reliefscope.cli.session import session
from reliefscope.errors import InvalidInputError

if TYPE_CHECKING:
    from rich.console import Console

    from reliefscope.microscope import ZCalibration

app = typer.Typer(
    name="calibrate",
    help="Measure how this instrument departs from its design; later runs use what is found.",
    no_args_is_help=True,
)
_PAPER_RMS_UM = 1.9
_PAPER_PUPIL_SCALE = 1.125


@app.callback()
def _group() -> None:
    """Keeps the name of the measurement in the command while there is only one."""


@app.command("z")
def calibrate_z(
    runs: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[RUN=UM...]",
            help="Runs of the target that were taken, each with the reading of the stage in um.",
        ),
    ] = None,
    device: Annotated[
        str | None,
        typer.Option(
            "--device",
            "-d",
            metavar="URL",
            help="Take the runs now with this instrument; {stage_um} in the URL moves its own stage.",
        ),
    ] = None,
    camera: CameraOption = None,
    profile: ProfileOption = None,
    calibration: CalibrationOption = None,
    from_um: Annotated[float, typer.Option("--from-um", help="Lowest height.")] = -50.0,
    to_um: Annotated[float, typer.Option("--to-um", help="Highest height.")] = 50.0,
    step_um: Annotated[float, typer.Option("--step-um", help="Step of the stage.")] = 10.0,
    out: Annotated[
        Path | None,
        typer.Option(
            "--out",
            "-o",
            metavar="FOLDER",
            help="Folder for runs and results; runs/z-calibration-001 and so on, or that of the runs.",
        ),
    ] = None,
    store: Annotated[
        bool,
        typer.Option(
            "--store/--no-store", help="Let later runs of this instrument use what is found."
        ),
    ] = True,
    as_json: JsonFlag = False,
    progress: ProgressOption = ProgressMode.AUTO,
) -> None:
    """Find the scale of heights: a flat target on a stage, measured at known heights.

    Give the runs (`grid-00=0 grid-10=10 ...`), or an instrument: then a terminal asks for each height of the stage,
    and the runs are taken. Heights grow toward the objective. The target is flat and has texture, for example a grid
    of 200 um.
    """
    if bool(runs) == (device is not None):
        raise InvalidInputError(
            "Give either runs that were taken, as RUN=UM, or an instrument with --device.",
            hint="For example `reliefscope calibrate z low=-20 middle=0 high=20`.",
        )
    ask = device is not None and sys.stdin.isatty() and sys.stderr.isatty()
    if ask and progress is ProgressMode.AUTO:
        progress = ProgressMode.LINES  # a bar would be drawn over the question
    with session(progress, as_json=as_json) as this:
        from reliefscope import microscope

        if device is None:
            heights = dict(_run_and_height(text) for text in runs or ())
        else:
            heights = microscope.take_z_stage(
                device,
                _heights(from_um, to_um, step_um),
                out,
                camera=camera,
                profile=profile,
                calibration=calibration,
                move=_ask if ask else None,
                job=this.job,
            )
        found = microscope.calibrate_z(heights, out, keep=store, job=this.job)
    this.result(found.as_dict(), lambda console: _show(console, found))


def _run_and_height(text: str) -> tuple[Path, float]:
    match = re.fullmatch(r"(.+)=([-+]?\d+(?:\.\d*)?)", text)
    if match is None:
        raise InvalidInputError(
            f"`{text}` does not tell a run and its height.",
            hint="Write RUN=UM, for example `runs/grid-003=20`.",
        )
    return Path(match[1]), float(match[2])


def _heights(from_um: float, to_um: float, step_um: float) -> list[float]:
    if not (step_um > 0 and from_um < to_um):
        raise InvalidInputError(
            f"There are no steps of {step_um:g} um from {from_um:g} to {to_um:g} um.",
            hint="Give for example `--from-um -50 --to-um 50 --step-um 10`.",
        )
    count = int((to_um - from_um) / step_um + 1e-9) + 1
    return [from_um + index * step_um for index in range(count)]


def _ask(height_um: float) -> None:
    typer.prompt(
        f"Move the stage to {height_um:g} um, then press Enter",
        default="",
        show_default=False,
        err=True,
    )


def _show(console: Console, found: ZCalibration) -> None:
    from rich.markup import escape
    from rich.table import Table

    fit = found.fit
    table = Table(title="Heights in µm", title_justify="left", title_style="bold")
    for name in ("stage", "measured", "residual", "mean NCC"):
        table.add_column(name, justify="right")
    steps = zip(fit.stage_um, fit.measured_um, fit.residual_um, found.peaks, strict=True)
    for stage, measured, residual, peak in steps:
        table.add_row(f"{stage:g}", f"{measured:.2f}", f"{residual:+.2f}", f"{peak:.3f}")
    console.print(table)
    error = fit.pupil_scale * fit.slope_error / fit.slope
    console.print(
        f"Pupil scale [bold]{fit.pupil_scale:.4f} ± {error:.4f}[/] (was {fit.former_pupil_scale:.4f}; "
        f"the paper's instrument: {_PAPER_PUPIL_SCALE:g})"
    )
    console.print(f"Residual [bold]{fit.rms_um:.2f} µm[/] RMS (the paper: {_PAPER_RMS_UM:g} µm)\n")
    console.print(f"[cyan]results[/]  {escape(str(found.folder))}", soft_wrap=True)
    if found.stored is not None:
        console.print(
            f"[cyan]stored[/]   {escape(str(found.stored))}: later runs use it; for earlier ones "
            f"`reliefscope reconstruct RUN --calibration {escape(str(found.folder / 'calibration.json'))}`",
            soft_wrap=True,
        )
