"""From an image and a board to a board that says it runs the image.

The order keeps the board's old firmware until the last moment: image, board and rights are checked first, then the
board is sent to its bootloader, then block 0 erases it.  From there on only a board that says HELLO with the image's
identity counts as done; every other end says what state the board is in and what to do.
"""

from __future__ import annotations

import logging
import math
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass
from typing import Any

import usb.core
import usb.util

from reliefscope.device import Device, PortAccessError, SequenceState
from reliefscope.errors import DeviceError, LockedError
from reliefscope.flash.boards import WANTED_MODEL, Board, access_error
from reliefscope.flash.errors import (
    FlashError,
    HalfWrittenError,
    NotConfirmedError,
    UsbAccessError,
)
from reliefscope.flash.halfkay import BoardGoneError, HalfKay, StuckError
from reliefscope.flash.identity import FirmwareIdentity
from reliefscope.flash.image import FirmwareImage
from reliefscope.flash.surroundings import REBOOT_BAUD, Surroundings
from reliefscope.jobs import Job, ensure_job
from reliefscope.protocol.messages import HelloReply

logger = logging.getLogger(__name__)

POLL_S = 0.25
BUTTON_S = 30.0
"""Time to find and press the button on the board."""
_REBOOT_S = 5.0
_RIGHTS_S = 2.0
_CONFIRM_S = 10.0
_ATTEMPTS = 2
"""Writing starts over, from the erasing block 0, when the bootloader stops taking blocks."""

Choose = Callable[[Sequence[Board]], Board]


@dataclass(frozen=True, slots=True)
class FlashReport:
    """What was done.  Versions are as "0.1.0 (commit)", empty where nobody told."""

    board: dict[str, str]
    port: str
    before: str
    after: str
    blocks: int
    retries: int
    attempts: int
    confirmed: bool

    def as_dict(self) -> dict[str, Any]:
        """For ``--json``."""
        return asdict(self)


class Flasher:
    """Finds boards and writes images to them."""

    def __init__(self, surroundings: Surroundings | None = None, job: Job | None = None) -> None:
        self._around = surroundings or Surroundings()
        self._job = ensure_job(job)

    def boards(self) -> list[Board]:
        """Every Teensy that can be seen now."""
        return self._around.boards()

    def select(self, name: str | None = None, choose: Choose | None = None) -> Board | None:
        """The board that ``name`` (port, USB location, serial number) means, or the only one; None if there is none.

        Of several, ``choose`` takes one.

        Raises
        ------
        FlashError
            If ``name`` means none of them, there are several and no ``choose``, or it is another model.
        """
        boards = self.boards()
        board = _named(boards, name) if name else _only(boards, choose)
        if board is not None:
            _check_model(board.model)
        return board

    def flash(
        self,
        image: FirmwareImage,
        board: Board | None,
        *,
        button_s: float = BUTTON_S,
        force: bool = False,
    ) -> FlashReport:
        """Write ``image`` to ``board`` and see that it runs.

        Parameters
        ----------
        image:
            Checked first (:meth:`FirmwareImage.check`).
        board:
            From :meth:`select`; None waits for whichever board's button is pressed.
        button_s:
            Time to wait for the button where no command reaches the bootloader.
        force:
            Write an image with doubts, and end a sequence that is under way.

        Raises
        ------
        ImageError, FlashError, UsbAccessError
            The board still has its old firmware.
        HalfWrittenError
            It has none, and waits in its bootloader.
        NotConfirmedError
            The image was written; the board does not say so.
        """
        image.check(force=force)
        self._job.check()
        before = ""
        waiting = board
        if board is None:
            waiting = self._wait_for_button(None, button_s)
        elif board.mode == "serial":
            before, waiting = self._send_to_bootloader(board, button_s, force=force)
        assert waiting is not None
        retries, attempts = self._write(image, waiting)
        port, now = self._confirm(image, waiting)
        return FlashReport(
            board=waiting.as_dict(),
            port=port,
            before=before,
            after=_version(now) if now else "",
            blocks=len(image.blocks),
            retries=retries,
            attempts=attempts,
            confirmed=now is not None,
        )

    # -- into the bootloader ----------------------------------------------------------------------

    def _send_to_bootloader(
        self, board: Board, button_s: float, *, force: bool
    ) -> tuple[str, Board]:
        _check_rights(board)
        before = self._ask_firmware(board, force=force)
        waiting = self._appears(board, _REBOOT_S) if before else None
        if waiting is None:
            self._ask_usb_core(board)
            waiting = self._appears(board, _REBOOT_S)
        if waiting is None:
            waiting = self._wait_for_button(board, button_s)
        return before, waiting

    def _ask_firmware(self, board: Board, *, force: bool) -> str:
        """Our own command, across any difference of versions; returns the version that ran, empty if none did."""
        if not board.port:
            return ""
        before = ""
        try:
            device = self._around.open_device(board.port)
            # Not `with`, which turns the light off on an error and so would end the sequence that is to be spared.
            try:
                before = _version(device.identity)
                if not force:
                    _check_idle(device)
                device.enter_bootloader()
            finally:
                device.close()
        except FlashError:
            raise
        except PortAccessError as error:
            raise UsbAccessError(error.message, hint=error.hint) from error
        except DeviceError as error:
            logger.info("firmware on %s: %s", board.port, error.message)
        return before

    def _ask_usb_core(self, board: Board) -> None:
        """134 baud, which every Teensy program that still serves USB understands."""
        line_coding = REBOOT_BAUD.to_bytes(4, "little") + bytes([0, 0, 8])
        try:
            with suppress(NotImplementedError):  # only Linux can, and needs to
                if board.device.is_kernel_driver_active(0):
                    board.device.detach_kernel_driver(0)
            board.device.ctrl_transfer(0x21, 0x20, 0, 0, line_coding, timeout=1000)
            return
        except usb.core.USBError as error:
            logger.debug("134 baud over USB: %s", error)
            with suppress(usb.core.USBError, NotImplementedError):
                board.device.attach_kernel_driver(0)
        finally:
            usb.util.dispose_resources(board.device)
        if board.port:
            try:
                self._around.touch_port(board.port)
            except OSError as error:
                logger.debug("134 baud over the serial driver: %s", error)

    def _wait_for_button(self, board: Board | None, button_s: float) -> Board:
        where = board.title if board else "the Teensy"
        logger.warning("press the button on %s within %g s", where, button_s)
        with self._job.stage("press_the_button", math.ceil(button_s)) as stage:
            deadline = self._around.monotonic() + button_s
            while (left := deadline - self._around.monotonic()) > 0:
                found = self._waiting_board(board)
                if found is not None:
                    return found
                stage.done = stage.total - math.ceil(left)
                stage.emit(f"press the button on {where}: {math.ceil(left)} s")
                self._job.check()
                self._around.sleep(POLL_S)
        raise FlashError(
            f"No bootloader appeared within {button_s:g} s.",
            hint="Plug the board in with a cable that carries data, press its button once, then repeat: "
            "reliefscope flash",
        )

    def _appears(self, board: Board, seconds: float) -> Board | None:
        deadline = self._around.monotonic() + seconds
        while True:
            found = self._waiting_board(board)
            if found is not None or self._around.monotonic() >= deadline:
                return found
            self._around.sleep(POLL_S)

    def _waiting_board(self, board: Board | None) -> Board | None:
        waiting = [b for b in self.boards() if b.mode == "bootloader"]
        if board is not None:
            return next((b for b in waiting if b.is_same(board)), None)
        return waiting[0] if len(waiting) == 1 else None

    # -- writing ----------------------------------------------------------------------------------

    def _write(self, image: FirmwareImage, board: Board) -> tuple[int, int]:
        """Write all blocks and restart; returns (retries, attempts)."""
        halfkay = HalfKay(board.device, self._around.sleep, self._around.monotonic)
        try:
            self._open(halfkay)
            _check_model(halfkay.model())
            if self._job.cancelled:
                halfkay.restart()  # into the old firmware, which is still there
            self._job.check()
            for attempt in range(1, _ATTEMPTS + 1):
                try:
                    self._write_blocks(image, halfkay)
                    break
                except StuckError:
                    if attempt == _ATTEMPTS:
                        raise
                    logger.warning("the bootloader stopped taking blocks; starting over")
            halfkay.restart()
        except (BoardGoneError, StuckError) as error:
            raise _half_written(error.message, image, halfkay) from error
        except KeyboardInterrupt as error:
            raise _half_written("Writing was interrupted.", image, halfkay) from error
        finally:
            halfkay.close()
        return halfkay.retries, attempt

    def _open(self, halfkay: HalfKay) -> None:
        """Open with some patience: a device that has just appeared gets its rights a moment later."""
        deadline = self._around.monotonic() + _RIGHTS_S
        while True:
            try:
                return halfkay.open()
            except UsbAccessError:
                if self._around.monotonic() >= deadline:
                    raise
            except BoardGoneError as error:
                raise FlashError(
                    "The board left its bootloader before anything was written.",
                    hint="Press its button, then repeat the command.",
                ) from error
            self._around.sleep(POLL_S)

    def _write_blocks(self, image: FirmwareImage, halfkay: HalfKay) -> None:
        blocks = image.blocks
        with self._job.stage("write", len(blocks)) as stage:
            for address, block in blocks:
                halfkay.write(address, block)
                # No place to stop at: a request to stop is honoured once the board is whole again.
                stage.done += 1
                stage.emit(f"0x{address:05X}")

    # -- confirming -------------------------------------------------------------------------------

    def _confirm(self, image: FirmwareImage, board: Board) -> tuple[str, HelloReply | None]:
        """Port and HELLO of the board once it runs the image; no HELLO for an image that is not ours."""
        deadline = self._around.monotonic() + _CONFIRM_S
        problem = "it did not come back on USB"
        with self._job.stage("confirm", 1):
            while self._around.monotonic() < deadline:
                running = [b for b in self.boards() if b.mode == "serial" and b.is_same(board)]
                if running and image.identity is None:
                    return running[0].port, None
                if running and running[0].port:
                    try:
                        with self._around.open_device(running[0].port) as device:
                            _compare(image.identity, device.identity)
                            return running[0].port, device.identity
                    except (NotConfirmedError, UsbAccessError):
                        raise
                    except (DeviceError, LockedError) as error:
                        problem = f"it does not answer: {error.message}"
                self._around.sleep(POLL_S)
        raise NotConfirmedError(
            f"{image.title} was written, but the board cannot confirm it: {problem}.",
            hint="Unplug it, plug it in again, and ask it: reliefscope doctor. If it stays silent, flash again.",
        )


def _named(boards: Sequence[Board], name: str) -> Board:
    if "://" in name:
        raise FlashError(
            f"{name} is not a board on USB, so it has no bootloader that could be reached.",
            hint="A simulated or emulated device runs the firmware it was started with: build it anew "
            "(pip install -e . in the checkout) and start it again.",
        )
    found = [board for board in boards if board.answers_to(name)]
    if not found:
        # A board whose flashing broke off has no port any more; its user repeats the command with the old one.
        found = [board for board in boards if board.mode == "bootloader"]
        if len(found) != 1:
            listed = "".join(f"\n  {board.title}" for board in boards)
            raise FlashError(
                f"No Teensy is at {name}.",
                hint=f"Seen:{listed}" if boards else "None is seen at all; check the cable.",
            )
        logger.warning("%s is not there; taking the board that waits in its bootloader", name)
    return found[0]


def _only(boards: Sequence[Board], choose: Choose | None) -> Board | None:
    if len(boards) <= 1:
        return boards[0] if boards else None
    if choose is not None:
        return choose(boards)
    commands = "".join(f"\n  reliefscope flash --port {b.name}   {b.title}" for b in boards)
    raise FlashError(f"There are {len(boards)} boards.", hint=f"Say which one:{commands}")


def _check_model(model: str) -> None:
    if model and model != WANTED_MODEL:
        raise FlashError(
            f"This board is a {model}; the instrument has a {WANTED_MODEL} (or 3.1).",
            hint="Name the right board with --port; `reliefscope flash --list` shows them.",
        )


def _check_rights(board: Board) -> None:
    """Any request to the device itself needs the right to open it; better now than once it left its program."""
    try:
        board.device.ctrl_transfer(0x80, 6, 0x0100, 0, 18, timeout=1000)
    except usb.core.USBError as error:
        if problem := access_error(error):
            raise problem from error
        logger.debug("device descriptor: %s", error)
    except NotImplementedError as error:
        logger.debug("device descriptor: %s", error)
    finally:
        usb.util.dispose_resources(board.device)


def _check_idle(device: Device) -> None:
    """The bootloader ends sequences; only firmware of our own version can be asked whether one is under way."""
    try:
        state = device.status().sequence
    except DeviceError as error:
        logger.debug("status: %s", error.message)
        return
    if state is not SequenceState.IDLE:
        raise FlashError(
            f"A sequence is under way on this board ({state.name}).",
            hint="Let it end or abort it; or end it by flashing: add --force",
        )


def _compare(wanted: FirmwareIdentity | None, got: HelloReply) -> None:
    assert wanted is not None
    pairs = (
        ("board", wanted.board, got.board),
        ("version", wanted.version, got.firmware_version),
        ("commit", wanted.git_hash, got.git_hash),
        ("protocol", wanted.schema_hash.hex()[:12], got.schema_hash.hex()[:12]),
    )
    differing = [f"{what} {b} instead of {a}" for what, a, b in pairs if a != b]
    if differing:
        raise NotConfirmedError(
            f"The board runs other firmware than was written: {', '.join(differing)}.",
            hint="Flash again; if it persists, another board answered: name it with --port.",
        )


def _half_written(message: str, image: FirmwareImage, halfkay: HalfKay) -> HalfWrittenError:
    lost = "has no whole firmware now" if halfkay.written else "may have lost its firmware"
    return HalfWrittenError(
        f"{message} The board {lost}.",
        hint="Nothing is lost: its bootloader is a chip of its own. Plug the board in, press its button, then: "
        f"reliefscope flash {image.path}",
    )


def _version(identity: HelloReply) -> str:
    return f"{identity.firmware_version} ({identity.git_hash})"
