"""``reliefscope sim``: the simulated instrument for other programs.

The host's command line finds this group through the entry points ``reliefscope.commands``.  Nothing here imports
the bench before a command really runs.
"""

from __future__ import annotations

import json
import signal
import threading
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING, Annotated

import typer

from reliefscope.errors import ExitCode, InvalidInputError

if TYPE_CHECKING:
    from reliefscope.models.base import StrictModel

JSON_SCHEMA_VERSION = 1
DEFAULT_URL = "sim://benchtop?scene=fiducial"
SampleUrl = Annotated[
    str, typer.Argument(metavar="URL", help="Instrument whose sample is meant, sim://NAME?...")
]

app = typer.Typer(
    name="sim",
    help="Serve the simulated instrument to other programs; play recorded sessions again; photograph its sample, "
    "or tell the truth about it.",
    no_args_is_help=True,
)


@app.command("serve")
def serve(
    url: Annotated[
        str, typer.Argument(metavar="URL", help="Instrument to serve, sim://NAME?...")
    ] = DEFAULT_URL,
    host: Annotated[
        str, typer.Option("--host", help="Interface to listen on; nothing asks for a password.")
    ] = "127.0.0.1",
    port: Annotated[
        int, typer.Option("--port", min=0, max=65535, help="Port of the device; 0: any free one.")
    ] = 0,
    camera_port: Annotated[
        int,
        typer.Option(
            "--camera-port", min=0, max=65535, help="Port of the camera; 0: any free one."
        ),
    ] = 0,
    terminal: Annotated[
        bool,
        typer.Option("--pty", help="Offer the device as a serial port of this system instead."),
    ] = False,
    save: Annotated[
        Path | None,
        typer.Option(
            "--save",
            metavar="FOLDER",
            help="Write profile.yml and calibration.yml of this instrument there.",
        ),
    ] = None,
    as_json: Annotated[
        bool, typer.Option("--json", help="Print the addresses as one JSON object.")
    ] = False,
) -> None:
    """Offer device and camera of one simulated instrument to any client, in real time, until Ctrl-C.

    The device speaks its protocol over TCP (socket://HOST:PORT of pyserial) or a pseudo-terminal; the camera a
    protocol of JSON lines, also reached as sim+tcp://HOST:PORT/camera.
    """
    from reliefscope_sim.serve import InstrumentServer

    stop = threading.Event()

    def on_signal(number: int, frame: FrameType | None) -> None:  # noqa: ARG001 - fixed by signal
        stop.set()

    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, on_signal)
    with InstrumentServer(
        url, host=host, port=port, camera_port=camera_port, terminal=terminal
    ) as server:
        files: dict[str, str] = {} if save is None else _save(server.url, save)
        command = f"reliefscope acquire --device {server.device_url} --camera {server.camera_url}"
        command += "".join(f" --{name} {path}" for name, path in files.items())
        if as_json:
            addresses = {"device": server.device_url, "camera": server.camera_url, **files}
            typer.echo(
                json.dumps({"schema_version": JSON_SCHEMA_VERSION, "url": server.url, **addresses})
            )
        else:
            typer.echo(f"Device  {server.device_url}\nCamera  {server.camera_url}")
            typer.echo(f"Next:   {command}\nCtrl-C ends it.")
        while not stop.wait(1.0):
            pass


@app.command("replay")
def replay(
    file: Annotated[
        Path, typer.Argument(metavar="FILE", help="Bundle, or the wire-*.jsonl of a run.")
    ],
    instrument: Annotated[
        str | None,
        typer.Option(
            "--instrument",
            metavar="URL",
            help="sim://NAME?... with options over the recorded ones.",
        ),
    ] = None,
    pictures: Annotated[
        bool,
        typer.Option("--pictures/--no-pictures", help="Compare every picture, or timing alone."),
    ] = True,
    as_json: Annotated[
        bool, typer.Option("--json", help="Print the outcome as one JSON object.")
    ] = False,
) -> None:
    """Repeat a recorded session on the simulated instrument, and compare.

    The same bytes go to the device at the same times, with the same seed and faults; its answers and pictures
    have to be those that were recorded. Ends with a status of its own where they are not.
    """
    from reliefscope_sim.replay import play_file

    report = play_file(file, instrument=instrument, pictures=pictures)
    if as_json:
        content = {"schema_version": JSON_SCHEMA_VERSION, **report.as_dict()}
        typer.echo(json.dumps(content, indent=2))
    else:
        typer.echo(
            f"{report.sent} requests sent in {report.duration_s:.3f} s of the instrument's time.\n"
            f"{report.same_answers} of {report.answers} frames from the device came again, "
            f"{report.same_pictures} of {report.pictures} pictures"
            f"{'' if report.pictures_compared else ' (pixels not compared)'}."
        )
        typer.echo(report.difference or "Everything was the same.")
    if not report.same:
        raise typer.Exit(ExitCode.VERIFICATION)


@app.command("z-stack")
def z_stack(
    out: Annotated[
        Path, typer.Option("--out", "-o", metavar="FOLDER", help="New folder for the images.")
    ],
    url: SampleUrl = DEFAULT_URL,
    field_um: Annotated[
        float | None,
        typer.Option(
            "--field-um", help="Side of the central square; all that the instrument sees."
        ),
    ] = None,
    as_json: Annotated[
        bool, typer.Option("--json", help="Print the description as one JSON object.")
    ] = False,
) -> None:
    """Photograph the sample with a conventional microscope: 31 images, 5 um apart.

    Its objective is 5x/0.13 (depth of field 15 um), its light comes through the objective. `reliefscope focus-stack
    FOLDER` makes a height map of the images.
    """
    from reliefscope_sim.z_stack import record_z_stack

    stack = record_z_stack(url, out, field_um=field_um)
    if as_json:
        content = {"schema_version": JSON_SCHEMA_VERSION, **stack.model_dump(mode="json")}
        typer.echo(json.dumps(content, indent=2))
    else:
        typer.echo(f"{len(stack.planes)} images in {out}\nNext: reliefscope focus-stack {out}")


@app.command("truth")
def truth(
    out: Annotated[
        Path, typer.Option("--out", "-o", metavar="FILE.npz", help="New file for the maps.")
    ],
    url: SampleUrl = DEFAULT_URL,
    grains: Annotated[
        Path | None,
        typer.Option("--grains", metavar="FILE.csv", help="New file for a table of the grains."),
    ] = None,
) -> None:
    """Write what really lies under the instrument, on the grid of its frames: heights, reflectance, grains.

    `scene=heightmap&file=FILE.npz&scene.level=no` puts the shape, not the material, under an instrument again.
    """
    from reliefscope_sim.truth import Truth

    found = Truth.under(url)
    found.save(out, grains)
    height_um = found.scene.height_um
    typer.echo(
        f"{height_um.shape[1]} x {height_um.shape[0]} px of {found.scene.pixel_um:g} um, heights "
        f"{height_um.min():.1f} to {height_um.max():.1f} um: {out}"
    )
    if grains is not None:
        typer.echo(f"{len(found.grains)} grains: {grains}")


def _save(url: str, folder: Path) -> dict[str, str]:
    from reliefscope_sim.offer import describe

    offer = describe(url)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        return {
            "profile": _write(folder / "profile.yml", offer.profile),
            "calibration": _write(folder / "calibration.yml", offer.calibration),
        }
    except OSError as error:
        raise InvalidInputError(
            f"{folder} cannot be written: {error.strerror or error}.",
            hint="Choose another folder with --save.",
        ) from error


def _write(path: Path, model: StrictModel) -> str:
    import yaml

    path.write_text(yaml.safe_dump(model.model_dump(mode="json"), sort_keys=False), "utf-8")
    return str(path)
