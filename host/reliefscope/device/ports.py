"""Which serial ports there are, and how a port URL is opened."""

from __future__ import annotations

import errno
import logging
import sys
from dataclasses import dataclass
from importlib.metadata import entry_points
from typing import Any, Protocol, cast

import serial
from serial.tools import list_ports as serial_ports

from reliefscope.device.errors import DeviceNotFoundError, PortAccessError
from reliefscope.errors import LockedError

logger = logging.getLogger(__name__)

HANDLER_GROUP = "reliefscope.serial_handlers"
TEENSY_VID = 0x16C0
TEENSY_SERIAL_PID = 0x0483
BAUD_RATE = 115200
"""USB ignores it; 134 would send a Teensy into its bootloader."""
ADDRESSES = (
    "Give a port (/dev/ttyACM0, COM3) or a URL (sim://benchtop, socket://host:port); "
    "`reliefscope doctor` lists the ports."
)
UDEV_COMMAND = (
    """echo 'ATTRS{idVendor}=="16c0", ATTRS{idProduct}=="04*", MODE:="0666"' """
    """| sudo tee /etc/udev/rules.d/70-reliefscope.rules && sudo udevadm control --reload"""
)


class Port(Protocol):
    """What is used of a pyserial port."""

    timeout: float | None

    @property
    def in_waiting(self) -> int:
        """Bytes that can be read at once."""

    def read(self, size: int = 1, /) -> bytes:
        """Up to ``size`` bytes, fewer if ``timeout`` ends first."""

    def write(self, data: bytes, /) -> int | None:
        """Send bytes."""

    def reset_input_buffer(self) -> None:
        """Forget what was received."""

    def close(self) -> None:
        """Close."""


@dataclass(frozen=True, slots=True)
class PortInfo:
    """A serial port of this computer; ``is_teensy`` by its USB vendor and product id.

    ``location`` is USB bus and ports ("1-2.4"), empty where the system does not tell.
    """

    port: str
    description: str
    serial_number: str
    is_teensy: bool
    location: str = ""


def list_ports() -> list[PortInfo]:
    """Serial ports, those of a Teensy first."""
    found = [
        PortInfo(
            port=p.device,
            description=p.description or "",
            serial_number=p.serial_number or "",
            is_teensy=(p.vid, p.pid) == (TEENSY_VID, TEENSY_SERIAL_PID),
            location=(p.location or "").partition(":")[0],
        )
        for p in serial_ports.comports()
    ]
    return sorted(found, key=lambda p: (not p.is_teensy, p.port))


def register_handlers() -> None:
    """Make pyserial know the URL schemes that installed packages offer in the entry-point group."""
    for entry in entry_points(group=HANDLER_GROUP):
        if entry.value not in serial.protocol_handler_packages:
            serial.protocol_handler_packages.append(entry.value)


def open_port(url: str) -> Port:
    """Open a port by name or URL (``/dev/ttyACM0``, ``COM3``, ``socket://host:port``, ``sim://...``).

    A port of the operating system is taken for this process alone.

    Raises
    ------
    DeviceNotFoundError
        If it does not exist or may not be opened.
    LockedError
        If another process has it.
    """
    register_handlers()
    options: dict[str, Any] = {} if "://" in url or sys.platform == "win32" else {"exclusive": True}
    try:
        port = serial.serial_for_url(
            url, baudrate=BAUD_RATE, timeout=0.05, write_timeout=2.0, **options
        )
        return cast(Port, port)
    except ValueError as error:
        raise DeviceNotFoundError(
            f"{url!r} is not a port that can be opened: {error}.",
            hint=ADDRESSES,
        ) from error
    except OSError as error:  # pyserial's SerialException is one
        raise _open_error(url, error) from error


def _open_error(url: str, error: OSError) -> DeviceNotFoundError | LockedError:
    text = str(error)
    if "exclusively lock" in text or error.errno in {errno.EBUSY, errno.EAGAIN}:
        return LockedError(
            f"{url} is in use by another program.",
            hint="Close the other reliefscope or serial terminal, then try again.",
        )
    if error.errno in {errno.EACCES, errno.EPERM} or "PermissionError" in text:
        return PortAccessError(
            f"{url} may not be opened by this user.",
            hint=f"Allow it once with: {UDEV_COMMAND}; then plug the device in again.",
        )
    if "://" in url:
        return DeviceNotFoundError(f"{url} could not be opened: {text}.", hint=_url_hint(url))
    found = list_ports()
    teensies = [p.port for p in found if p.is_teensy]
    known = f"A Teensy is at {', '.join(teensies)}." if teensies else "No Teensy is plugged in."
    others = [p.port for p in found if not p.is_teensy]
    if others:
        known += f" Other serial ports: {', '.join(others)}."
    named = url.startswith("/dev/") or url.upper().startswith("COM")
    advice = "`reliefscope doctor` lists the ports." if named else ADDRESSES
    return DeviceNotFoundError(f"{url} could not be opened: {text}.", hint=f"{known} {advice}")


def _url_hint(url: str) -> str:
    """What to do where an address other than a port of this computer did not open."""
    if url.startswith("socket://"):
        return (
            f"Nothing answers at {url.removeprefix('socket://')}: start `reliefscope sim serve` there and use "
            "the address that it prints, or check host and port."
        )
    return ADDRESSES
