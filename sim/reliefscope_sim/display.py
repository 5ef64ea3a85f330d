"""Model of the ST7565R, the controller bonded to the glass: bytes in, driven pixels out.

The controller has a RAM of 65 x 132 bits, drives 64 common lines (rows) and 132 segment lines (columns), and
is written over SPI with A0 telling commands (low) from data (high).  A pixel is *driven* when its RAM bit,
after inversion, asks for the on voltage; what a driven pixel looks like is the glass's business.

The glass is bonded to segments 4 to 131.  Seen with the connector at the bottom, segment 131 is its left
column and common line 0 its top row; turned by 180 degrees, segment 4 is left and common line 63 on top.

Commands after the ST7565R data sheet; reset state: display off, power off, nothing inverted or reversed,
start line, page and column 0, volume 32, ratio 0.  The RAM holds noise after power-on and survives a reset.
A resistor holds the reset pin low until the firmware raises it.
"""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from reliefscope.units import BoolImage
from reliefscope_sim.liquid_crystal import NO_DRIVE, ROOM_C, Drive, multiplexed

RAM_COLUMNS = 132
RAM_PAGES = 9
GLASS_ROWS = 64
GLASS_COLUMNS = 128
FIRST_SEGMENT = 4
POWER_ALL_ON = 0b111


class Mounting(Enum):
    """How the glass sits in the light path."""

    BOTTOM_VIEW = "bottom_view"
    TOP_VIEW = "top_view"


class DisplayController:
    """State of the controller.

    ``faults`` holds one line for each thing that a correct driver never does (unknown command, bytes while
    not selected or in reset, data past the end of the RAM); at most 100 are kept.
    """

    def __init__(self, mounting: Mounting = Mounting.BOTTOM_VIEW, seed: int = 0) -> None:
        self.mounting = mounting
        self.faults: list[str] = []
        self.dead_columns: frozenset[int] = frozenset()
        """Columns of the glass, from the left, whose lines are broken: never driven."""
        self._noise = np.random.default_rng(seed)
        self.ram: NDArray[np.uint8]
        self.lose_power()

    def lose_power(self) -> None:
        """The supply was gone: noise in the RAM, registers cleared, in reset until the pin is raised."""
        self.ram = self._noise.integers(0, 256, (RAM_PAGES, RAM_COLUMNS), dtype=np.uint8)
        self.selected = False
        self.in_reset = True
        self._reset_registers()

    def _reset_registers(self) -> None:
        self.on = False
        self.inverse = False
        self.all_points = False
        self.segments_reversed = False
        self.commons_reversed = False
        self.power = 0
        self.start_line = 0
        self.page = 0
        self.column = 0
        self.volume = 32
        self.resistor_ratio = 0
        self.bias_1_7 = False
        self.booster_ratio = 0
        self.indicator = False
        self._marked_column: int | None = None
        self._argument_for: Callable[[int], None] | None = None

    def set_reset(self, level: int) -> None:
        """Level of the reset pin: registers are cleared while it is low."""
        self.in_reset = not level
        if self.in_reset:
            self._reset_registers()

    def set_select(self, level: int) -> None:
        """Level of chip select: bytes count only while it is low."""
        self.selected = not level

    def feed(self, a0: int, data: bytes) -> None:
        """Bytes off the bus; ``a0`` low for commands, high for data."""
        if self.in_reset or not self.selected:
            why = "in reset" if self.in_reset else "not selected"
            self._fault(f"{len(data)} bytes ignored: {why}")
            return
        for byte in data:
            if a0:
                self._write_data(byte)
            else:
                self._command(byte)

    def driven(self) -> BoolImage:
        """Pixels (64, 128) of the mounted glass that get the on voltage, row 0 on top."""
        if not self.showing:
            return np.zeros((GLASS_ROWS, GLASS_COLUMNS), dtype=bool)
        shown = self._shown()
        shown[:, list(self.dead_columns)] = False
        return shown

    @property
    def showing(self) -> bool:
        """Whether voltages are on the glass."""
        return not self.in_reset and self.on and self.power == POWER_ALL_ON

    def drive(self, temperature_c: float = ROOM_C) -> Drive:
        """Effective voltages on the glass, of pixels that are not driven and of those that are."""
        if not self.showing:
            return NO_DRIVE
        bias = 7 if self.bias_1_7 else 9
        return multiplexed(self.resistor_ratio, self.volume, bias, temperature_c)

    def _shown(self) -> BoolImage:
        if self.all_points:
            return np.ones((GLASS_ROWS, GLASS_COLUMNS), dtype=bool)
        pages = self.ram[:8].reshape(8, 1, RAM_COLUMNS)
        lines = np.unpackbits(pages, axis=1, bitorder="little").reshape(GLASS_ROWS, RAM_COLUMNS)
        # Line shown by each common line, column shown by each segment.
        order = (np.arange(GLASS_ROWS) + self.start_line) % GLASS_ROWS
        commons = lines[order[::-1] if self.commons_reversed else order]
        segments = commons[:, ::-1] if self.segments_reversed else commons
        glass = segments[:, FIRST_SEGMENT:]
        glass = glass[:, ::-1] if self.mounting is Mounting.BOTTOM_VIEW else glass[::-1]
        shown: BoolImage = glass != self.inverse
        return shown

    def _write_data(self, byte: int) -> None:
        self._argument_for = None
        if self.page >= RAM_PAGES:
            self._fault(f"data for page {self.page}, which the RAM does not have")
            return
        if self.column >= RAM_COLUMNS:
            self._fault("data past the last column ignored")
            return
        self.ram[self.page, self.column] = byte
        self.column += 1

    def _command(self, byte: int) -> None:
        if self._argument_for is not None:
            take, self._argument_for = self._argument_for, None
            take(byte)
        elif byte in _REGISTER_COMMANDS:
            _REGISTER_COMMANDS[byte](self)
        else:
            self._command_with_field(byte)

    def _command_with_field(self, byte: int) -> None:
        """Commands whose low bits carry a value."""
        high, low = byte & 0xF0, byte & 0x0F
        if high == 0x00:
            self.column = (self.column & 0xF0) | low
        elif high == 0x10:
            self.column = (self.column & 0x0F) | (low << 4)
        elif 0x20 <= byte <= 0x27:
            self.resistor_ratio = byte & 7
        elif 0x28 <= byte <= 0x2F:
            self.power = byte & 7
        elif 0x40 <= byte <= 0x7F:
            self.start_line = byte & 0x3F
        elif high == 0xB0:
            self.page = low
        elif 0xC0 <= byte <= 0xCF:
            self.commons_reversed = bool(byte & 8)
        else:
            self._fault(f"unknown command 0x{byte:02X}")

    def _set_volume(self, value: int) -> None:
        self.volume = value & 0x3F

    def _set_booster(self, value: int) -> None:
        self.booster_ratio = value & 3

    def _start_read_modify_write(self) -> None:
        self._marked_column = self.column

    def _end_read_modify_write(self) -> None:
        if self._marked_column is not None:
            self.column, self._marked_column = self._marked_column, None

    def _fault(self, text: str) -> None:
        if len(self.faults) < 100:
            self.faults.append(text)


def _flag(name: str, value: bool) -> Callable[[DisplayController], None]:
    return lambda controller: setattr(controller, name, value)


def _expect(
    method: Callable[[DisplayController, int], None],
) -> Callable[[DisplayController], None]:
    """Command of two bytes: the next one is its argument."""

    def expect(controller: DisplayController) -> None:
        controller._argument_for = lambda value: method(controller, value)

    return expect


def _software_reset(controller: DisplayController) -> None:
    """0xE2 resets all but power, bias and drive settings that the sheet leaves to the pin."""
    controller.start_line = controller.page = controller.column = 0
    controller.commons_reversed = controller.segments_reversed = False
    controller.volume, controller.resistor_ratio = 32, 0
    controller.indicator = False


_REGISTER_COMMANDS: dict[int, Callable[[DisplayController], None]] = {
    0x81: _expect(DisplayController._set_volume),
    0xA0: _flag("segments_reversed", False),
    0xA1: _flag("segments_reversed", True),
    0xA2: _flag("bias_1_7", False),
    0xA3: _flag("bias_1_7", True),
    0xA4: _flag("all_points", False),
    0xA5: _flag("all_points", True),
    0xA6: _flag("inverse", False),
    0xA7: _flag("inverse", True),
    0xAC: _flag("indicator", False),
    0xAD: _expect(lambda controller, _value: setattr(controller, "indicator", True)),
    0xAE: _flag("on", False),
    0xAF: _flag("on", True),
    0xE0: DisplayController._start_read_modify_write,
    0xE2: _software_reset,
    0xE3: lambda _controller: None,
    0xEE: DisplayController._end_read_modify_write,
    0xF8: _expect(DisplayController._set_booster),
}
