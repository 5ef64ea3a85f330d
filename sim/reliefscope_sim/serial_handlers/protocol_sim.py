"""Serial port of the simulated device: ``serial.serial_for_url("sim://benchtop?scene=fiducial")``.

Timeouts count the instrument's time: under virtual time a read that finds nothing returns at once, after the
clock has run for its timeout.  Baud rate and line settings are accepted and mean nothing, as on USB.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from serial.serialutil import (
    PortNotOpenError,
    SerialBase,
    SerialException,
    SerialTimeoutException,
)

from reliefscope.units import US_PER_S

if TYPE_CHECKING:
    from reliefscope_sim.bench import Bench


class Serial(SerialBase):
    """A port of pyserial; the port is the bench's, one object can hold it at a time."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        self._bench: Bench | None = None
        self._cancel_read = False
        self._seen_us = 0
        super().__init__(*args, **kwargs)

    def open(self) -> None:
        """Attach to the bench that the port's address names.

        Raises
        ------
        SerialException
            If there is no address, or the port is open already, here or elsewhere.
        ReliefscopeError
            If the address is wrong or the instrument cannot be made; says why.
        """
        # The bench brings numba along; pyserial takes an ImportError here for an unknown scheme.
        from reliefscope_sim.bench import Bench

        if self.port is None:
            raise SerialException("Port must be configured before it can be used.")
        if self.is_open:
            raise SerialException("Port is already open.")
        bench = Bench.attach(self.port)
        if not bench.open_port():
            bench.release()
            raise SerialException(
                f"could not exclusively lock port {self.port}: it is already open"
            )
        self._bench = bench
        self.is_open = True

    def close(self) -> None:
        """Let go of the bench; closing twice does no harm."""
        bench, self._bench = self._bench, None
        self.is_open = False
        if bench is not None:
            bench.close_port()
            bench.release()

    def clock_s(self) -> float:
        """The instrument's own time; asking lets no time go by.  Once closed, when that was."""
        if self._bench is not None:
            self._seen_us = self._bench.time_us
        return self._seen_us / US_PER_S

    @property
    def in_waiting(self) -> int:
        """Bytes that can be read without waiting."""
        bench = self._check()
        bench.poll()
        return len(bench.cable.received)

    @property
    def out_waiting(self) -> int:
        """Bytes that the device has not taken yet."""
        return self._check().cable.unsent

    def read(self, size: int = 1) -> bytes:
        """Read ``size`` bytes, fewer if the timeout ends first."""
        bench = self._check()
        self._cancel_read = False
        data = bench.receive(
            size, _microseconds(self.timeout), lambda: self._cancel_read or not self.is_open
        )
        if not data:
            self._check()
        return data

    def write(self, data: Any, /) -> int:
        """Send bytes; returns their number.

        Raises
        ------
        SerialTimeoutException
            If the device did not take them within ``write_timeout``.
        """
        if isinstance(data, str):
            raise TypeError(f"unicode strings are not supported, please encode to bytes: {data!r}")
        content = bytes(data)
        if not self._check().send(content, _microseconds(self.write_timeout)):
            raise SerialTimeoutException("Write timeout")
        return len(content)

    def flush(self) -> None:
        """Wait until the device has taken everything."""
        bench = self._check()
        bench.wait(
            lambda: not bench.cable.unsent or bench.cable.broken,
            _microseconds(self.write_timeout),
        )

    def cancel_read(self) -> None:
        """End a read that waits in another thread."""
        self._cancel_read = True
        if self._bench is not None:
            self._bench.wake()

    def reset_input_buffer(self) -> None:
        """Forget what was received."""
        self._check().discard_input()

    def reset_output_buffer(self) -> None:
        """Forget what was not sent."""
        self._check().discard_output()

    @property
    def cts(self) -> bool:
        """Clear to send: always."""
        self._check()
        return True

    @property
    def dsr(self) -> bool:
        """Data set ready: always."""
        self._check()
        return True

    @property
    def ri(self) -> bool:
        """Ring indicator: never."""
        self._check()
        return False

    @property
    def cd(self) -> bool:
        """Carrier detect: always."""
        self._check()
        return True

    def _check(self) -> Bench:
        if self._bench is None:
            raise PortNotOpenError
        if self._bench.cable.broken and not self._bench.cable.received:
            raise SerialException(
                f"device {self.port} disconnected: unplugged, or left for its bootloader"
            )
        return self._bench

    def _reconfigure_port(self) -> None:
        """Line settings have no effect on a USB port."""

    _update_rts_state = _update_dtr_state = _update_break_state = _reconfigure_port


def _microseconds(timeout_s: float | None) -> int | None:
    return None if timeout_s is None else round(timeout_s * US_PER_S)
