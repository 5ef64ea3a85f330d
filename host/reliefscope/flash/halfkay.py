"""HalfKay, the bootloader of the Teensy: a chip of its own beside the processor, so it always survives.

One HID output report (control transfer 0x21, 9, 0x0200, interface 0) of 1,088 bytes does everything: address
(3 bytes, little-endian), 61 zeros, 1,024 bytes for that address.  Block 0 erases the chip first.  Address
0xFFFFFF restarts into the program.  While it erases or writes, the bootloader does not take the next report: it is
repeated until it does.
"""

from __future__ import annotations

import errno
import logging
from collections.abc import Callable
from contextlib import suppress
from typing import Any

import usb.core
import usb.util

from reliefscope.flash.boards import WANTED_MODEL, access_error
from reliefscope.flash.errors import FlashError
from reliefscope.flash.image import BLOCK_BYTES

logger = logging.getLogger(__name__)

ERASE_PATIENCE_S = 45.0
"""For the first writes: erasing takes long, and the operating system may still look at the new device."""
WRITE_PATIENCE_S = 0.5
PATIENT_WRITES = 5
RETRY_S = 0.01
_TRANSFER_S = 5.0
_HEAD_BYTES = 64
_RESTART = 0xFFFFFF
# Usage (page 0xFF9C) in the HID report descriptor of the bootloader, by model; 3.1 and 3.2 are alike.
_MODEL_BY_USAGE = {
    0x1D: "Teensy 3.0",
    0x1E: WANTED_MODEL,
    0x1F: "Teensy 3.5",
    0x20: "Teensy LC",
    0x21: WANTED_MODEL,
    0x22: "Teensy 3.6",
    0x24: "Teensy 4.0",
    0x25: "Teensy 4.1",
}
_USAGE_PAGE = bytes([0x06, 0x9C, 0xFF])
_USAGE = 0x09
GONE = {errno.ENODEV, errno.ENXIO, errno.ENOENT}


class BoardGoneError(FlashError):
    """The board left USB."""


class StuckError(FlashError):
    """The bootloader did not take a block for longer than it ever needs."""


class HalfKay:
    """A bootloader on USB.

    ``retries`` counts the reports that had to be repeated, ``written`` the blocks since the chip was erased last.

    ``sleep`` and ``monotonic`` are those of :mod:`time`, or of a simulated board.
    """

    def __init__(
        self, device: Any, sleep: Callable[[float], None], monotonic: Callable[[], float]
    ) -> None:
        self.retries = 0
        self.written = 0
        self._device = device
        self._sleep = sleep
        self._monotonic = monotonic

    def open(self) -> None:
        """Take the device from the system's HID driver.

        Raises
        ------
        UsbAccessError, BoardGoneError
        """
        try:
            with suppress(NotImplementedError):  # only Linux can, and needs to
                if self._device.is_kernel_driver_active(0):
                    self._device.detach_kernel_driver(0)
            usb.util.claim_interface(self._device, 0)
        except usb.core.USBError as error:
            raise access_error(error) or _gone(error) from error

    def close(self) -> None:
        """Give the device back."""
        with suppress(usb.core.USBError):
            usb.util.dispose_resources(self._device)

    def model(self) -> str:
        """Model of the board, by its report descriptor; empty where it does not tell."""
        try:
            descriptor = bytes(self._device.ctrl_transfer(0x81, 6, 0x2200, 0, 256, timeout=1000))
        except usb.core.USBError as error:
            logger.debug("no report descriptor: %s", error)
            return ""
        if not descriptor.startswith(_USAGE_PAGE) or descriptor[3:4] != bytes([_USAGE]):
            return ""
        usage = descriptor[4]
        return _MODEL_BY_USAGE.get(usage, f"unknown Teensy (usage 0x{usage:02X})")

    def write(self, address: int, block: bytes) -> None:
        """Write 1,024 bytes, repeating the report until the bootloader takes it.

        Raises
        ------
        StuckError
            If it does not in time.
        BoardGoneError, UsbAccessError
        """
        report = address.to_bytes(3, "little").ljust(_HEAD_BYTES, b"\0") + block
        if address == 0:  # erases, also when writing starts over
            self.written = 0
        patience_s = ERASE_PATIENCE_S if self.written < PATIENT_WRITES else WRITE_PATIENCE_S
        deadline = self._monotonic() + patience_s
        while True:
            try:
                self._send(report, min(patience_s, _TRANSFER_S))
                break
            except usb.core.USBError as error:
                if problem := access_error(error):
                    raise problem from error
                if error.errno in GONE:
                    raise _gone(error) from error
                if self._monotonic() >= deadline:
                    raise StuckError(
                        f"The bootloader did not take the block at 0x{address:05X} within {patience_s:g} s: {error}."
                    ) from error
                logger.debug("block at 0x%05X again: %s", address, error)
            self.retries += 1
            self._sleep(RETRY_S)
        self.written += 1

    def restart(self) -> None:
        """Leave for the program.  An error is normal: the chip may be gone before it answers."""
        report = _RESTART.to_bytes(3, "little").ljust(_HEAD_BYTES + BLOCK_BYTES, b"\0")
        try:
            self._send(report, WRITE_PATIENCE_S)
        except usb.core.USBError as error:
            logger.debug("restart: %s", error)

    def _send(self, report: bytes, timeout_s: float) -> None:
        self._device.ctrl_transfer(0x21, 9, 0x0200, 0, report, timeout=round(timeout_s * 1000))


def _gone(error: usb.core.USBError) -> BoardGoneError:
    return BoardGoneError(f"The board left USB: {error}.")
