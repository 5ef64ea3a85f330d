"""Teensy boards on USB: as a serial device (a program runs) or as a bootloader (HalfKay waits for one)."""

from __future__ import annotations

import errno
import logging
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

import usb.backend.libusb1
import usb.core
import usb.util

from reliefscope.device.ports import TEENSY_SERIAL_PID, TEENSY_VID, UDEV_COMMAND, PortInfo
from reliefscope.flash.errors import FlashError, UsbAccessError

logger = logging.getLogger(__name__)

HALFKAY_PID = 0x0478
WANTED_MODEL = "Teensy 3.2"
# Device release numbers that PJRC's USB core gives the program's serial device, by model; 3.1 and 3.2 are alike.
_MODEL_BY_RELEASE = {
    0x273: "Teensy LC",
    0x274: "Teensy 3.0",
    0x275: WANTED_MODEL,
    0x276: "Teensy 3.5",
    0x277: "Teensy 3.6",
    0x279: "Teensy 4.0",
    0x280: "Teensy 4.1",
}
_SHORT_SERIAL = 10_000_000
"""The program shows serial numbers below this with a zero appended; the bootloader does not."""

Mode = Literal["serial", "bootloader"]


@dataclass(frozen=True, slots=True)
class Board:
    """A Teensy on USB.

    ``location`` is bus and ports ("1-2.4"), which stay when it changes between program and bootloader.  ``port``
    is its serial port, empty in the bootloader; ``model`` and ``serial_number`` are empty where unknown.
    """

    mode: Mode
    location: str
    serial_number: str
    port: str
    model: str
    device: Any = field(repr=False, compare=False)

    @property
    def title(self) -> str:
        """The board in a few words."""
        what = "in its bootloader" if self.mode == "bootloader" else self.port or "no serial port"
        serial = f", serial number {self.serial_number}" if self.serial_number else ""
        return f"{self.model or 'Teensy'} at USB {self.location} ({what}{serial})"

    @property
    def name(self) -> str:
        """What --port takes to mean this board."""
        return self.port or self.location

    def is_same(self, other: Board) -> bool:
        """Whether this is the same board, before or after a restart."""
        return self.location == other.location or (
            self.serial_number != "" and self.serial_number == other.serial_number
        )

    def answers_to(self, name: str) -> bool:
        """Whether ``name`` is its port (links to it count), location or serial number."""
        if name in {self.port, self.location, self.serial_number} - {""}:
            return True
        return (
            self.port != "" and Path(name).is_symlink() and Path(name).resolve() == Path(self.port)
        )

    def as_dict(self) -> dict[str, str]:
        """For ``--json``."""
        return {
            "mode": self.mode,
            "location": self.location,
            "port": self.port,
            "serial_number": self.serial_number,
            "model": self.model,
        }


def default_backend() -> Any:
    """libusb: the system's, else the one that comes with the package libusb-package.

    Raises
    ------
    FlashError
        If there is none.
    """
    backend = usb.backend.libusb1.get_backend()
    if backend is None:
        import libusb_package

        backend = libusb_package.get_libusb1_backend()
    if backend is None:
        raise FlashError(
            "There is no libusb, without which the bootloader cannot be reached.",
            hint="Install it: apt install libusb-1.0-0, brew install libusb, or pip install libusb-package",
        )
    return backend


def list_boards(backend: Any, ports: Callable[[], Sequence[PortInfo]]) -> list[Board]:
    """Every Teensy that runs a serial program or its bootloader, by location.

    Raises
    ------
    UsbAccessError
        If USB cannot be looked at.
    """
    try:
        found = list(usb.core.find(find_all=True, backend=backend, idVendor=TEENSY_VID))
    except usb.core.USBError as error:
        raise access_error(error) or _usb_error(error) from error
    serial_ports = [port for port in ports() if port.is_teensy]
    boards = []
    for device in found:
        if device.idProduct == TEENSY_SERIAL_PID:
            boards.append(_running(device, serial_ports))
        elif device.idProduct == HALFKAY_PID:
            boards.append(_waiting(device))
    return sorted(boards, key=lambda board: board.location)


def _running(device: Any, ports: Sequence[PortInfo]) -> Board:
    location, serial = _location(device), _serial_number(device)
    at_place = [p for p in ports if p.location == location]
    by_number = [p for p in ports if serial and p.serial_number == serial]
    port = next(iter(at_place or by_number or (ports if len(ports) == 1 else [])), None)
    return Board(
        mode="serial",
        location=location,
        serial_number=serial or (port.serial_number if port else ""),
        port=port.port if port else "",
        model=_MODEL_BY_RELEASE.get(device.bcdDevice, ""),
        device=device,
    )


def _waiting(device: Any) -> Board:
    text = _serial_number(device)
    try:
        number = int(text, 16)
    except ValueError:
        number = 0
    serial = number * 10 if number < _SHORT_SERIAL else number
    return Board("bootloader", _location(device), str(serial or ""), "", "", device)


def _location(device: Any) -> str:
    ports = device.port_numbers or (device.address,)
    return f"{device.bus}-{'.'.join(map(str, ports))}"


def _serial_number(device: Any) -> str:
    """Empty where this user may not ask: the board can still be told by its place."""
    try:
        return str(usb.util.get_string(device, device.iSerialNumber) or "").strip()
    except (usb.core.USBError, ValueError, NotImplementedError) as error:
        logger.debug("no serial number of USB %s: %s", _location(device), error)
        return ""
    finally:
        usb.util.dispose_resources(device)


def access_error(error: usb.core.USBError) -> UsbAccessError | None:
    """The error as one of rights, if it is one."""
    if error.errno not in {errno.EACCES, errno.EPERM}:
        return None
    if sys.platform == "linux":
        hint = f"Allow it once with: {UDEV_COMMAND}; then plug the board in again."
    else:
        hint = (
            "On this system HID devices belong to its own driver. Write the .hex file with PJRC's Teensy Loader, "
            "then check it: reliefscope doctor"
        )
    return UsbAccessError("The board may not be opened by this user.", hint=hint)


def _usb_error(error: usb.core.USBError) -> FlashError:
    return FlashError(
        f"USB cannot be searched: {error}.",
        hint="Unplug the board, plug it in again, repeat the command.",
    )
