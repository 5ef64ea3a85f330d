"""``reliefscope flash``: firmware onto the board."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from reliefscope.cli.options import JsonFlag, ProgressMode, ProgressOption
from reliefscope.cli.session import Session, session

if TYPE_CHECKING:
    from reliefscope.flash import Board, FirmwareImage, FlashReport

_NOTICE = "Writing is not left half done; Ctrl-C again stops at once, and the board then has to be flashed again."


def flash(
    firmware: Annotated[
        Path | None,
        typer.Argument(
            metavar="[FIRMWARE.HEX]",
            help="Image; the newest that `make firmware` built if left out.",
        ),
    ] = None,
    port: Annotated[
        str | None,
        typer.Option(
            "--port",
            "-p",
            metavar="PORT",
            help="Which board: serial port, USB location or serial number; not needed for a single one.",
        ),
    ] = None,
    dry_run: Annotated[
        bool,
        typer.Option("--dry-run", help="Check image and boards, say what would be done, stop."),
    ] = False,
    force: Annotated[
        bool,
        typer.Option(
            "--force",
            help="Write an image that is not this program's firmware for this board; end a running sequence.",
        ),
    ] = False,
    list_boards: Annotated[bool, typer.Option("--list", help="List the boards and stop.")] = False,
    wait_s: Annotated[
        float,
        typer.Option("--wait", metavar="SECONDS", min=0, help="Time to press the board's button."),
    ] = 30.0,
    as_json: JsonFlag = False,
    progress: ProgressOption = ProgressMode.AUTO,
) -> None:
    """Write firmware to the Teensy and see that it runs.

    The image is checked before the board is touched; the board's settings are kept. A board whose flashing
    broke off is mended by pressing its button and repeating the command.
    """
    with session(progress, as_json=as_json, notice=_NOTICE) as this:
        from reliefscope.flash import FirmwareImage, Flasher, newest_image

        flasher = Flasher(job=this.job)
        if list_boards:
            _show_boards(this, flasher.boards())
            return
        image = FirmwareImage.load(firmware or newest_image())
        doubts = image.check(force=force)
        for doubt in doubts:
            this.say(f"[yellow]forced:[/] {doubt}")
        board = flasher.select(port, _ask if sys.stdin.isatty() and not as_json else None)
        if dry_run:
            _show_plan(this, image, board, doubts)
            return
        if board is None:
            this.say(f"No Teensy is seen: plug it in and press its button within {wait_s:g} s.")
        report = flasher.flash(image, board, button_s=wait_s, force=force)
    _show_report(this, image, report)


def _ask(boards: Sequence[Board]) -> Board:
    for number, board in enumerate(boards, 1):
        typer.echo(f"{number}  {board.title}", err=True)
    chosen: int = typer.prompt("Which board", type=int, err=True)
    if not 1 <= chosen <= len(boards):
        raise typer.BadParameter(f"There is no board {chosen}.")
    return boards[chosen - 1]


def _show_boards(this: Session, boards: Sequence[Board]) -> None:
    def show(console: Any) -> None:
        for board in boards:
            console.print(f"{board.title}   reliefscope flash --port {board.name}", markup=False)
        if not boards:
            console.print(
                "No Teensy is seen. A board that runs no program appears once its button is pressed."
            )

    this.result({"boards": [board.as_dict() for board in boards]}, show)


def _show_plan(
    this: Session, image: FirmwareImage, board: Board | None, doubts: Sequence[str]
) -> None:
    from reliefscope.cli.tables import show_facts

    facts = {
        "image": str(image.path),
        "firmware": image.title,
        "doubts": list(doubts),
        "blocks": len(image.blocks),
        "board": board.title if board else None,
    }
    content = {**facts, "board": board.as_dict() if board else None}
    this.result(content, lambda console: show_facts(console, "What would be written", facts))


def _show_report(this: Session, image: FirmwareImage, report: FlashReport) -> None:
    from reliefscope.cli.tables import show_facts

    facts = {
        "firmware": image.title,
        "port": report.port,
        "before": report.before or None,
        "now": report.after or None,
        "blocks": report.blocks,
        "retries": report.retries,
        "confirmed by the board": report.confirmed,
    }
    this.result(
        {"image": str(image.path), **report.as_dict()},
        lambda console: show_facts(console, "Flashed", facts),
    )
