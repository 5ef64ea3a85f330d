"""``reliefscope fiducial``: the 3D fiducial as an STL for a printer, and its true heights."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from reliefscope.cli.options import JsonFlag, ProgressMode, parse_size
from reliefscope.cli.session import session
from reliefscope.errors import InvalidInputError

if TYPE_CHECKING:
    from rich.console import Console


class LengthUnit(StrEnum):
    """What one unit of an STL means."""

    MM = "mm"
    UM = "um"


def fiducial(
    stl: Annotated[
        Path | None,
        typer.Option("--stl", metavar="OUT.stl", help="Write the solid on its base plate."),
    ] = None,
    truth: Annotated[
        Path | None,
        typer.Option(
            "--truth",
            metavar="OUT.npz|.tif",
            help="Write the heights in um; the .npz also holds a mask of each section.",
        ),
    ] = None,
    unit: Annotated[
        LengthUnit, typer.Option("--unit", help="Unit of the STL, which names none itself.")
    ] = LengthUnit.MM,
    scale: Annotated[
        float, typer.Option("--scale", min=0.05, max=1000.0, help="Multiply every length.")
    ] = 1.0,
    seed: Annotated[
        int, typer.Option("--seed", min=0, help="Angles and directions of the slanted planes.")
    ] = 1,
    plate_um: Annotated[
        float, typer.Option("--plate-um", help="Thickness of the base plate at scale 1.")
    ] = 200.0,
    margin_um: Annotated[
        float, typer.Option("--margin-um", help="Plate beyond the 1 mm square at scale 1.")
    ] = 100.0,
    deviation_um: Annotated[
        float,
        typer.Option("--deviation-um", help="Largest error of the hemispheres' facets at scale 1."),
    ] = 0.05,
    pixel_um: Annotated[float, typer.Option("--pixel-um", help="Pixel of the truth.")] = 1.0,
    size: Annotated[
        str | None,
        typer.Option(
            "--size",
            metavar="WxH",
            help="Pixels of the truth, the fiducial in the middle; just its square if left out.",
        ),
    ] = None,
    as_json: JsonFlag = False,
) -> None:
    """Make the 3D fiducial: a watertight solid to print, and the truth to measure it by.

    Both files share one frame: origin in the middle, z = 0 in the focal plane, base 47 um below it. No file is
    overwritten.
    """
    with session(ProgressMode.NONE, as_json=as_json) as this:
        if stl is None and truth is None:
            raise InvalidInputError(
                "There is nothing to make.",
                hint="Give `--stl fiducial.stl`, `--truth fiducial.npz`, or both.",
            )
        from reliefscope.export.fiducial import (
            check_outputs,
            write_fiducial_stl,
            write_fiducial_truth,
        )
        from reliefscope.export.solid import Plate
        from reliefscope.targets import Fiducial3D

        frame = parse_size(size)
        check_outputs(stl=stl, truth=truth)
        target = Fiducial3D(seed=seed, scale=scale)
        facts: dict[str, Any] = {"seed": seed, "scale": scale, "stl": None, "truth": None}
        if stl is not None:
            plate = Plate(plate_um, margin_um)
            facts["stl"] = write_fiducial_stl(
                stl, target, unit=unit.value, plate=plate, deviation_um=deviation_um
            ).facts()
        if truth is not None:
            shape = None if frame is None else (frame[1], frame[0])
            facts["truth"] = write_fiducial_truth(
                truth, target, pixel_um=pixel_um, shape=shape
            ).facts()
    this.result(facts, lambda console: _show(console, facts))


def _show(console: Console, facts: dict[str, Any]) -> None:
    from reliefscope.cli.tables import show_facts

    for name, title in (("stl", "Solid"), ("truth", "Truth")):
        if facts[name] is not None:
            show_facts(console, title, facts[name])
