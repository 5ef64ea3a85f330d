"""What flashing touches outside itself, in one place, so that a simulated board can stand in for all of it."""

from __future__ import annotations

import functools
import time
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any

import serial

from reliefscope.device import Device, PortInfo, list_ports
from reliefscope.flash.boards import Board, default_backend, list_boards

REBOOT_BAUD = 134
"""Line setting on which the USB core of a Teensy leaves for its bootloader, whatever program runs."""
_HELLO_S = 1.0


def open_device(port: str) -> Device:
    """Connect to firmware of any version."""
    return Device.open(port, _HELLO_S, allow_mismatch=True)


def touch_port(port: str) -> None:
    """Ask for the bootloader through the serial driver, by opening the port at 134 baud.

    Raises
    ------
    OSError
        If the port cannot be opened; an error after that is normal, since the port goes away.
    """
    opened = serial.Serial(port, baudrate=REBOOT_BAUD, timeout=0)
    with suppress(OSError):
        opened.close()


@dataclass(frozen=True)
class Surroundings:
    """USB, serial ports, clients and time; the real ones by default."""

    find_backend: Callable[[], Any] = default_backend
    list_ports: Callable[[], Sequence[PortInfo]] = list_ports
    open_device: Callable[[str], Device] = open_device
    touch_port: Callable[[str], None] = touch_port
    sleep: Callable[[float], None] = time.sleep
    monotonic: Callable[[], float] = field(default=time.monotonic)

    @functools.cached_property
    def backend(self) -> Any:
        """The backend of pyusb, found at first use."""
        return self.find_backend()

    def boards(self) -> list[Board]:
        """Every Teensy that can be seen now."""
        return list_boards(self.backend, self.list_ports)
