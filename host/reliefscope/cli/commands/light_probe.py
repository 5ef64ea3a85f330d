"""``reliefscope light-probe``: where the lights are, from photographs of a mirroring sphere."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from reliefscope.cli.options import JsonFlag, ProgressMode, ProgressOption
from reliefscope.cli.session import session

if TYPE_CHECKING:
    from rich.console import Console

_WARN_DEG = 5.0
"""Disagreement between probes that is remarked on."""


def light_probe(
    description: Annotated[
        Path, typer.Argument(metavar="PROBE.yml", help="YAML file: spheres and photographs.")
    ],
    compare: Annotated[
        Path | None,
        typer.Option(
            "--compare",
            metavar="FILE.yml",
            help="Directions to compare with: a YAML file with the key `lights`.",
        ),
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option(
            "--out",
            "-o",
            metavar="FILE.yml",
            help="Write the directions; `import` takes them as `lights: FILE.yml`.",
        ),
    ] = None,
    as_json: JsonFlag = False,
    progress: ProgressOption = ProgressMode.AUTO,
) -> None:
    """Find the directions of lights from photographs of a mirroring or glossy black sphere.

    Keys of the file: lights (their number), first, and probes, each with circle (column, row, radius_px; row 0 on
    top) or outline (points on it), and folder, pattern or files. Several spheres are averaged.
    """
    with session(progress, as_json=as_json) as this:
        from reliefscope import microscope

        lights = microscope.calibrate_lights(description, compare=compare, out=out, job=this.job)
        apart, difference = lights.disagreement_deg, lights.difference_deg
        facts: dict[str, Any] = {
            "probes": len(lights.estimates),
            "lights": lights.rows(),
            "mean_disagreement_deg": None if apart is None else round(float(apart.mean()), 3),
            "mean_difference_deg": None
            if difference is None
            else round(float(difference.mean()), 3),
            "out": None if out is None else str(out),
        }
    this.result(facts, lambda console: _show(console, facts))


def _show(console: Console, facts: dict[str, Any]) -> None:
    from rich.markup import escape
    from rich.table import Table

    rows = facts["lights"]
    compared = facts["mean_difference_deg"] is not None
    several = facts["mean_disagreement_deg"] is not None
    table = Table(title="Lights, angles in degrees", title_justify="left", title_style="bold")
    table.add_column("light", justify="right")
    table.add_column("photograph")
    table.add_column("direction x, y, z", no_wrap=True)
    table.add_column("elevation", justify="right")
    table.add_column("azimuth", justify="right")
    if several:
        table.add_column("between\nprobes", justify="right")
    if compared:
        table.add_column("to the given\ndirection", justify="right")
    for row in rows:
        cells = [
            str(row["light"]),
            escape(row["photograph"]),
            ", ".join(f"{value:+.4f}" for value in row["direction"]),
            f"{row['elevation_deg']:.2f}",
            f"{row['azimuth_deg']:.2f}",
        ]
        cells += [f"{row['disagreement_deg']:.2f}"] if several else []
        cells += [f"{row['difference_deg']:.2f}"] if compared else []
        table.add_row(*cells)
    console.print(table)
    if several:
        console.print(f"Mean disagreement between probes: {facts['mean_disagreement_deg']:.2f}°")
        if max(row["disagreement_deg"] for row in rows) > _WARN_DEG:
            console.print(
                f"[yellow]Probes disagree by more than {_WARN_DEG:g}°: check their circles, and whether the lights "
                "are too near to look the same from each.[/]"
            )
    if compared:
        console.print(
            f"Mean difference to the given directions: [bold]{facts['mean_difference_deg']:.2f}°[/]"
        )
    if facts["out"] is not None:
        console.print(
            f"Written: [bold]{escape(facts['out'])}[/]; `lights: FILE` in an import description takes it."
        )
