"""Options that several subcommands share."""

from __future__ import annotations

import re
from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from reliefscope.errors import InvalidInputError

METHOD_NAMES = ("joint", "paper")
"""Methods of reconstruction, kept here as well because their settings load numpy; a test compares the two."""
DEVICE_VARIABLE = "RELIEFSCOPE_DEVICE"


class ProgressMode(StrEnum):
    """How progress is shown on standard error."""

    AUTO = "auto"
    BAR = "bar"
    LINES = "lines"
    JSON = "json"
    NONE = "none"


JsonFlag = Annotated[
    bool, typer.Option("--json", help="Print the result as one JSON object on standard output.")
]
ProgressOption = Annotated[
    ProgressMode,
    typer.Option(
        "--progress",
        help="On standard error: a bar (auto on a terminal), sparse lines (auto elsewhere), JSON lines, or none.",
    ),
]
DeviceOption = Annotated[
    str,
    typer.Option(
        "--device",
        "-d",
        envvar=DEVICE_VARIABLE,
        metavar="URL",
        help="Serial port (/dev/ttyACM0, COM3), socket://HOST:PORT, or a simulated instrument sim://NAME?...",
    ),
]
CameraOption = Annotated[
    str | None,
    typer.Option(
        "--camera", metavar="URL", help="Camera; that of the device's URL where it has one."
    ),
]
ProfileOption = Annotated[
    str | None,
    typer.Option(
        "--profile",
        metavar="NAME|FILE",
        help="Instrument profile; that of the device's URL, else benchtop.",
    ),
]
CalibrationOption = Annotated[
    Path | None,
    typer.Option(
        "--calibration", metavar="FILE", help="Calibration to use instead of the one in force."
    ),
]
METHOD_HELP = f"Reconstruction method: {' or '.join(METHOD_NAMES)}"
RunArgument = Annotated[Path, typer.Argument(metavar="RUN", help="Folder of the run.")]
SizeOption = Annotated[
    str | None,
    typer.Option(
        "--size", metavar="WxH", help="Simulate only the central W x H pixels of the camera."
    ),
]


def parse_size(text: str | None) -> tuple[int, int] | None:
    """(columns, rows) of ``1388x1038``."""
    if text is None:
        return None
    match = re.fullmatch(r"\s*(\d+)\s*[xX×]\s*(\d+)\s*", text)
    if match is None:
        raise InvalidInputError(
            f"`{text}` is no frame size.",
            hint="Write columns x rows, for example `--size 320x240`.",
        )
    columns, rows = int(match[1]), int(match[2])
    if columns < 16 or rows < 16:
        raise InvalidInputError(
            f"A frame of {columns} x {rows} pixels is too small.",
            hint="Give at least 16 columns and 16 rows; `--size 320x240` is quick.",
        )
    return columns, rows
