"""``reliefscope estimate-lights``: where the lights are, or how bright, from the photographs of the sample itself."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from reliefscope.cli.options import JsonFlag, ProgressMode, ProgressOption
from reliefscope.cli.session import STOP_NOTICE, session

if TYPE_CHECKING:
    from rich.console import Console

    from reliefscope.reconstruction.light_estimation import LightEstimate


def estimate_lights(
    run: Annotated[Path, typer.Argument(metavar="RUN", help="Run of imported photographs.")],
    out: Annotated[
        Path | None,
        typer.Option(
            "--out",
            "-o",
            metavar="FILE.yml",
            help="Write the lights; `import` takes them as `lights: FILE.yml`.",
        ),
    ] = None,
    reflectance: Annotated[
        float | None,
        typer.Option(
            "--reflectance",
            min=0.0,
            max=0.95,
            help="Reflectance of the sample; 0.6, a light grey coating, if left out.",
        ),
    ] = None,
    powers: Annotated[
        bool,
        typer.Option(
            "--powers",
            help="Only how bright the lights are relative to each other; their directions are known, and the "
            "sample is matt with slopes to all sides.",
        ),
    ] = False,
    as_json: JsonFlag = False,
    progress: ProgressOption = ProgressMode.AUTO,
) -> None:
    """Estimate near lights of which nothing is known from a sample that is level, matt and of one colour.

    Most of the sample must be level, and some of it sloped to two sides; lights must stand around it at about one
    height and fall off across the field.  Where they can be photographed in a sphere, use light-probe.  With
    --powers, directions are known, and only brightness is sought.
    """
    with session(progress, as_json=as_json, notice=STOP_NOTICE) as this:
        from reliefscope import microscope
        from reliefscope.errors import InvalidInputError

        if powers and reflectance is not None:
            raise InvalidInputError(
                "`--reflectance` has no part in `--powers`.", hint="Give one of the two."
            )
        if powers:
            brightness = microscope.estimate_powers(run, out=out, job=this.job)
            facts: dict[str, Any] = {
                "lights": [{"power": round(float(power), 4)} for power in brightness]
            }
            show = _show_powers
        else:
            found = microscope.estimate_lights(run, reflectance=reflectance, out=out, job=this.job)
            facts, show = _facts(found), _show_lights
        facts["out"] = None if out is None else str(out)
    this.result(facts, lambda console: show(console, facts))


def _facts(found: LightEstimate) -> dict[str, Any]:
    from reliefscope import axes
    from reliefscope.units import degrees

    rows = []
    for position, power in zip(found.positions_mm, found.powers, strict=True):
        _, azimuth = axes.elevation_azimuth(position)
        rows.append(
            {
                "position_mm": [round(float(value), 3) for value in position],
                "azimuth_deg": round(degrees(azimuth), 2),
                "power": round(float(power), 4),
            }
        )
    return {
        "lights": rows,
        "elevation_deg": round(degrees(found.elevation_rad), 2),
        "level_share": round(found.level_share, 3),
    }


def _show_powers(console: Console, facts: dict[str, Any]) -> None:
    from rich.table import Table

    table = Table(title="Estimated powers", title_justify="left", title_style="bold")
    table.add_column("light", justify="right")
    table.add_column("power", justify="right")
    for index, row in enumerate(facts["lights"]):
        table.add_row(str(index), f"{row['power']:.3f}")
    console.print(table)
    _show_place(console, facts["out"])


def _show_lights(console: Console, facts: dict[str, Any]) -> None:
    from rich.table import Table

    table = Table(title="Estimated lights", title_justify="left", title_style="bold")
    table.add_column("light", justify="right")
    table.add_column("position x, y, z, mm", no_wrap=True)
    table.add_column("azimuth, degrees", justify="right")
    table.add_column("power", justify="right")
    for index, row in enumerate(facts["lights"]):
        place = ", ".join(f"{value:+.2f}" for value in row["position_mm"])
        table.add_row(str(index), place, f"{row['azimuth_deg']:.1f}", f"{row['power']:.3f}")
    console.print(table)
    console.print(
        f"Elevation {facts['elevation_deg']:.1f}° for all; {facts['level_share']:.0%} of the sample is level."
    )
    _show_place(console, facts["out"])


def _show_place(console: Console, out: str | None) -> None:
    from rich.markup import escape

    if out is not None:
        console.print(
            f"Written: [bold]{escape(out)}[/]; `lights: FILE` in an import description takes it."
        )
