"""The board and what hangs on it: firmware, display controller, glass, LED lines, and what breaks there."""

from __future__ import annotations

import zlib
from collections.abc import Callable, Iterable, Mapping

from reliefscope.models.instrument import InstrumentProfile
from reliefscope.protocol.messages import ResetCause
from reliefscope_sim.display import DisplayController
from reliefscope_sim.factory import factory_settings
from reliefscope_sim.faults import Faults
from reliefscope_sim.firmware import NEVER_US, Firmware
from reliefscope_sim.glass import Glass
from reliefscope_sim.lights import FULL_LEVEL, LedLines
from reliefscope_sim.liquid_crystal import aligned_fraction
from reliefscope_sim.trace import InputLine, OutputPin, TraceKind, TraceRecord
from reliefscope_sim.url import SimUrl

DIP_US = 5_000
"""Length of a brown-out."""
WATCHDOG_US = 100_000
"""Time after which the hardware watchdog restarts a firmware that hangs (assumed)."""


class Electronics:
    """One board, switched on at device time 0.

    ``on_pulse`` is called with the time of every rising edge of the camera trigger; ``on_leave`` when the
    firmware leaves for its bootloader.  ``nonces`` are those of its boots, where they are to be the
    ones of a recording; after them it makes its own.
    """

    def __init__(
        self,
        url: SimUrl,
        profile: InstrumentProfile,
        faults: Faults,
        on_pulse: Callable[[int], None],
        on_leave: Callable[[], None],
        nonces: Iterable[int] = (),
        first_boot: int = 0,
    ) -> None:
        self.display = DisplayController(url.mounting, url.seed)
        self.glass = Glass(profile.glass, temperature_c=url.temperature_c)
        self.leds = LedLines(profile.dome.count, droop=url.led_droop)
        self.serial_number = url.device_serial
        self.in_bootloader = False
        self._name = f"{url.identity} {url.seed}"
        self._temperature_c = url.temperature_c
        self._faults = faults
        self._on_pulse = on_pulse
        self._on_leave = on_leave
        self._nonces = iter(nonces)
        self._boots = first_boot
        self._stalled = False
        self._fails_us = NEVER_US
        self._starts_us = NEVER_US
        self._cause = ResetCause.UNKNOWN
        self._trigger_level = 0
        self._inputs: dict[InputLine, bool] = {}
        if not faults.parts_from:
            self._break_parts(0)
        settings = factory_settings(profile.glass.variant, url.mounting, self.serial_number)
        self.firmware = Firmware(settings, self._next_nonce())

    def close(self) -> None:
        """Switch it off for good."""
        self.firmware.close()

    @property
    def halted(self) -> bool:
        """Whether the firmware does not run: stalled, hanging, without supply, or in the bootloader."""
        return self._stalled or self.in_bootloader or self._starts_us != NEVER_US

    @property
    def next_event_us(self) -> int:
        """When something happens by itself."""
        own = min(self._fails_us, self._starts_us)
        return own if self.halted else min(own, self.firmware.next_wakeup_us())

    def run_until(self, time_us: int) -> None:
        """Let firmware and failures go on, at most to :attr:`next_event_us`."""
        if not self.halted:
            self.firmware.run_until(time_us)
        self._observe_lines()
        if time_us >= self._fails_us:
            self._fails_us = NEVER_US
            self._fail(time_us)
        if time_us >= self._starts_us:
            self._starts_us = NEVER_US
            self.restart(self._cause)

    def restart(self, cause: ResetCause) -> None:
        """Start the firmware again."""
        self.in_bootloader = False
        self.firmware.reset(cause, self._next_nonce())
        self._observe_lines()

    def drive_inputs(self, levels: Mapping[InputLine, bool]) -> None:
        """Levels of the lines from the camera."""
        for line, level in levels.items():
            if self._inputs.get(line) is not level:
                self._inputs[line] = level
                self.firmware.set_input(line, level)

    def fail_at(self, pulse: int, time_us: int, middle_us: int) -> None:
        """Failures that happen at exposure ``pulse``, which begins at ``time_us``."""
        if pulse and pulse == self._faults.parts_from:
            self._break_parts(time_us)
        for name, cause in _RESTARTS.items():
            if self._faults.strikes(name, pulse):
                self._fails_us, self._cause = middle_us, cause
        if self._faults.strikes("stall_at", pulse):
            self._stalled = True

    def _fail(self, time_us: int) -> None:
        if self._cause is ResetCause.PIN:
            self.restart(self._cause)
            return
        hangs = self._cause is ResetCause.WATCHDOG
        self._starts_us = time_us + (WATCHDOG_US if hangs else DIP_US)
        if not hangs:
            self.leds.all_off(time_us)
            self.display.lose_power()
            self._drive_glass(time_us)

    def _break_parts(self, time_us: int) -> None:
        for led in range(len(self.leds.levels)):
            if self._faults.strikes("led_dead", led):
                self.leds.pin(time_us, led, 0)
            elif self._faults.strikes("led_stuck", led):
                self.leds.pin(time_us, led, FULL_LEVEL)
        columns = range(self.glass.driven.shape[1])
        broken = [column for column in columns if self._faults.strikes("lcd_column", column)]
        self.display.dead_columns = frozenset(broken)
        self._drive_glass(time_us)

    def _drive_glass(self, time_us: int) -> None:
        drive = self.display.drive(self._temperature_c)
        off, on = (aligned_fraction(v, self._temperature_c) for v in (drive.off_v, drive.on_v))
        self.glass.drive(time_us, self.display.driven(), (off, on))

    def _observe_lines(self) -> None:
        for record in self.firmware.trace():
            match record.kind:
                case TraceKind.SPI:
                    self.display.feed(record.argument, record.payload)
                    self._drive_glass(record.time_us)
                case TraceKind.LED:
                    self.leds.set_level(record.time_us, record.argument, record.level)
                case TraceKind.PIN:
                    self._pin(record)
                case TraceKind.BOOTLOADER:
                    self.in_bootloader = True
                    self._on_leave()
                case TraceKind.OVERFLOW:
                    raise RuntimeError("the firmware's trace was not read in time")
                case TraceKind.NONVOLATILE:
                    pass

    def _pin(self, record: TraceRecord) -> None:
        match record.argument:
            case OutputPin.LCD_RESET:
                self.display.set_reset(record.level)
                self._drive_glass(record.time_us)
            case OutputPin.LCD_SELECT:
                self.display.set_select(record.level)
            case OutputPin.CAMERA_TRIGGER:
                if record.level and not self._trigger_level:
                    self._on_pulse(record.time_us)
                self._trigger_level = record.level

    def _next_nonce(self) -> int:
        """Differs from boot to boot; never 0."""
        self._boots += 1
        made = zlib.crc32(f"{self._name} {self._boots}".encode()) or 1
        return next(self._nonces, made)


_RESTARTS = {
    "reset_at": ResetCause.PIN,
    "brown_out_at": ResetCause.BROWN_OUT,
    "watchdog_at": ResetCause.WATCHDOG,
}
