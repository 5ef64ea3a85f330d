"""The compiled firmware core, bound through ctypes.

The library is the product's own core with a hardware layer that keeps virtual time and writes a trace
(``firmware/boards/host/reliefscope_host.h``).  It is found where the installation put it, beside this package;
``RELIEFSCOPE_FIRMWARE_LIBRARY`` names another one, for those who work on the firmware.
"""

from __future__ import annotations

import ctypes
import functools
import os
import sys
from ctypes import c_size_t, c_uint8, c_uint32, c_uint64, c_void_p
from pathlib import Path

import reliefscope_sim
from reliefscope.errors import DeviceError
from reliefscope_sim.trace import InputLine, TraceRecord, parse_trace

LIBRARY_VARIABLE = "RELIEFSCOPE_FIRMWARE_LIBRARY"
NEVER_US = (1 << 64) - 1
_FOLDER = "_firmware"
_BUFFER_BYTES = 65536


def library_name() -> str:
    """File name of the library on this platform."""
    if sys.platform == "win32":
        return "reliefscope_firmware.dll"
    return f"libreliefscope_firmware.{'dylib' if sys.platform == 'darwin' else 'so'}"


def locate_library() -> Path:
    """Path of the compiled core.

    An editable installation keeps the sources in the checkout and the library in the environment; both are
    on the package's search path.

    Raises
    ------
    DeviceError
        If it is nowhere; names the command that builds it.
    """
    override = os.environ.get(LIBRARY_VARIABLE)
    if override:
        path = Path(override)
        if not path.is_file():
            raise DeviceError(
                f"{LIBRARY_VARIABLE} names {path}, which does not exist.",
                hint=f"Build the firmware there, or `unset {LIBRARY_VARIABLE}`.",
            )
        return path
    folders = [Path(entry) / _FOLDER for entry in reliefscope_sim.__path__]
    folders += [Path(entry) / "reliefscope_sim" / _FOLDER for entry in sys.path if entry]
    for folder in folders:
        if (folder / library_name()).is_file():
            return folder / library_name()
    raise DeviceError(
        "The compiled firmware core of the simulated instrument is missing.",
        hint="Build and install it: `pip install -e .` in the checkout (needs a C++17 compiler).",
    )


@functools.cache
def _load(path: Path) -> ctypes.CDLL:
    try:
        library = ctypes.CDLL(str(path))
        signatures = {
            "rs_create": (c_void_p, [c_void_p, c_size_t, c_uint32]),
            "rs_destroy": (None, [c_void_p]),
            "rs_reset": (None, [c_void_p, c_uint32, c_uint32]),
            "rs_serial_in": (c_size_t, [c_void_p, c_void_p, c_size_t]),
            "rs_serial_out": (c_size_t, [c_void_p, c_void_p, c_size_t]),
            "rs_run_until": (None, [c_void_p, c_uint64]),
            "rs_next_wakeup_us": (c_uint64, [c_void_p]),
            "rs_set_input": (None, [c_void_p, c_uint32, c_uint32]),
            "rs_trace_read": (c_size_t, [c_void_p, c_void_p, c_size_t]),
            "rs_nonvolatile_read": (c_size_t, [c_void_p, c_void_p, c_size_t]),
        }
        for name, (result, arguments) in signatures.items():
            function = getattr(library, name)
            function.restype = result
            function.argtypes = arguments
    except (OSError, AttributeError) as error:
        raise DeviceError(
            f"The compiled firmware core {path} cannot be used: {error}.",
            hint="It was built for another platform or version: `pip install -e .` builds it anew.",
        ) from error
    return library


class Firmware:
    """One device in virtual time, from power-on.  Not thread-safe; times in us since power-on."""

    def __init__(self, nonvolatile: bytes, boot_nonce: int) -> None:
        self._library = _load(locate_library())
        self._buffer = (c_uint8 * _BUFFER_BYTES)()
        self._device: int | None = self._library.rs_create(
            nonvolatile, len(nonvolatile), boot_nonce
        )
        if self._device is None:
            raise DeviceError("There is no memory for another simulated device.")

    def close(self) -> None:
        """Free the device; nothing else may be called afterwards."""
        if self._device is not None:
            self._library.rs_destroy(self._device)
            self._device = None

    def reset(self, cause: int, boot_nonce: int) -> None:
        """Start again for ``cause`` (a ResetCause of the protocol); time goes on."""
        self._library.rs_reset(self._device, cause, boot_nonce)

    def serial_in(self, data: bytes) -> int:
        """Bytes to the device; returns how many it took."""
        return int(self._library.rs_serial_in(self._device, data, len(data)))

    def serial_out(self) -> bytes:
        """Bytes from the device that are there now."""
        return self._read("rs_serial_out")

    def run_until(self, time_us: int) -> None:
        """Run main loop and timers up to and including ``time_us``."""
        self._library.rs_run_until(self._device, time_us)

    def next_wakeup_us(self) -> int:
        """When something happens without input; :data:`NEVER_US` if nothing does."""
        return int(self._library.rs_next_wakeup_us(self._device))

    def set_input(self, line: InputLine, level: bool) -> None:
        """Level of an input line from now on."""
        self._library.rs_set_input(self._device, line, level)

    def trace(self) -> list[TraceRecord]:
        """Records since the last call, oldest first."""
        records: list[TraceRecord] = []
        while data := self._read("rs_trace_read"):
            records += parse_trace(data)
        return records

    def nonvolatile(self) -> bytes:
        """Copy of the non-volatile memory."""
        return self._read("rs_nonvolatile_read")

    def _read(self, function: str) -> bytes:
        count = getattr(self._library, function)(self._device, self._buffer, _BUFFER_BYTES)
        return bytes(self._buffer[:count]) if count else b""
