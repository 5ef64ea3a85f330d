"""``reliefscope tui``: the terminal screen."""

from __future__ import annotations

import sys
from typing import Annotated

import typer

from reliefscope.cli.options import (
    DEVICE_VARIABLE,
    CalibrationOption,
    CameraOption,
    ProfileOption,
)
from reliefscope.errors import InvalidInputError


def tui(
    device: Annotated[
        str | None,
        typer.Option(
            "--device",
            "-d",
            envvar=DEVICE_VARIABLE,
            metavar="URL",
            help="Connect to this device at once instead of asking.",
        ),
    ] = None,
    camera: CameraOption = None,
    profile: ProfileOption = None,
    calibration: CalibrationOption = None,
) -> None:
    """Open the terminal screen: live picture, glass, lights, acquisition.

    `o` turns all LEDs off everywhere, `?` shows every key.
    """
    if not (sys.stdin.isatty() and sys.stdout.isatty()):
        raise InvalidInputError(
            "`reliefscope tui` needs a terminal.",
            hint="In a script use `reliefscope acquire`, or `from reliefscope.microscope import Microscope`.",
        )
    from reliefscope.tui import run

    run(device, camera_url=camera, profile=profile, calibration=calibration)
