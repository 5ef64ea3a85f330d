"""The device as a Python object: one method for each thing it can do."""

from __future__ import annotations

import logging
import zlib
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from types import TracebackType
from typing import Self

import numpy as np
from numpy.typing import NDArray

from reliefscope.device.errors import DeviceRebootedError
from reliefscope.device.exchange import Exchange
from reliefscope.device.link import Link
from reliefscope.device.ports import open_port
from reliefscope.device.sequence import SequenceTiming, default_deadline_s
from reliefscope.device.wirelog import WireLog
from reliefscope.errors import DeviceError, InvalidInputError, ReliefscopeError
from reliefscope.models.apertures import pack_bitmap
from reliefscope.protocol.messages import (
    APERTURE_CHUNK,
    BOOTLOADER_MAGIC,
    LEDS,
    SLOT_NONE,
    STEP_CHUNK,
    STEPS,
    AbortRequest,
    AllOffRequest,
    ApertureChunkRequest,
    ClearFaultRequest,
    CommitApertureRequest,
    CommitStepsRequest,
    CountersReply,
    CountersRequest,
    EnterBootloaderReply,
    EnterBootloaderRequest,
    ExposureEvent,
    FaultEvent,
    FaultReason,
    GetLedCorrectionReply,
    GetLedCorrectionRequest,
    GetSettingsReply,
    GetSettingsRequest,
    HelloReply,
    LimitsReply,
    LimitsRequest,
    LoadLightReply,
    LoadLightRequest,
    PauseRequest,
    ResumeRequest,
    SelectApertureReply,
    SelectApertureRequest,
    SelectLightReply,
    SelectLightRequest,
    SequenceEvent,
    SequenceState,
    SetLedCorrectionReply,
    SetLedCorrectionRequest,
    SetSettingsReply,
    SetSettingsRequest,
    StartReply,
    StartRequest,
    StatusReply,
    StatusRequest,
    Step,
    StepChunkRequest,
)
from reliefscope.units import BoolImage

logger = logging.getLogger(__name__)

MS_PER_S = 1000


class Device:
    """A connected device.

    Every method sends one request (uploads: several) and returns what the device says it did.  A request can
    end in five ways, told apart by type:

    - it returns: done;
    - :class:`RejectedError`: nothing happened, the request did not fit the protocol;
    - :class:`FailedError`: nothing happened, the device says why;
    - :class:`OutcomeUnknownError`: the link was lost, the device may have acted;
    - :class:`DeviceRebootedError`: the device restarted; everything loaded is gone, the light is off.

    Values outside the protocol's ranges raise :class:`FieldRangeError` before anything is sent.  All methods may be
    called from any thread; a request of one thread passes another's wait in :meth:`events`.

    The device turns the light off when it hears nothing for 2 s outside a sequence: whoever keeps a light on for
    longer (a live view) reads :meth:`status` now and then.
    """

    def __init__(
        self,
        link: Link,
        url: str = "",
        *,
        hello_timeout_s: float = 2.0,
        allow_mismatch: bool = False,
    ) -> None:
        """Say HELLO over an open link; see :meth:`open`."""
        self._exchange = Exchange(link, url)
        self._steps: tuple[Step, ...] = ()
        self._table_hash = 0
        self._run_id = 0
        self._hello_timeout_s = hello_timeout_s
        self._allow_mismatch = allow_mismatch
        self.url = url
        self.reconnect()

    @classmethod
    def open(
        cls,
        url: str,
        hello_timeout_s: float = 2.0,
        *,
        allow_mismatch: bool = False,
        wire_log: Path | None = None,
    ) -> Self:
        """Open a port or any pyserial URL and say HELLO.

        Parameters
        ----------
        url:
            ``/dev/ttyACM0``, ``COM3``, ``socket://host:port``, ``sim://benchtop?...``.
        hello_timeout_s:
            Time that the device has to answer.
        allow_mismatch:
            Connect to firmware of another version as well; then only :attr:`identity` and
            :meth:`enter_bootloader` work.
        wire_log:
            New file to which every frame is written, one JSON object a line.

        Raises
        ------
        DeviceNotFoundError, LockedError, SchemaMismatchError
        """
        port = open_port(url)
        log = WireLog(wire_log, clock_s=getattr(port, "clock_s", None), device=url)
        link = Link(port, url, log)
        try:
            return cls(link, url, hello_timeout_s=hello_timeout_s, allow_mismatch=allow_mismatch)
        except BaseException:
            link.close()
            raise

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if (
            kind is not None
            and self._exchange.mismatch is None
            and not isinstance(error, DeviceRebootedError)
        ):
            with suppress(ReliefscopeError):
                self._exchange.request(AllOffRequest(), 0.5)
        self.close()

    def close(self) -> None:
        """Close the port.  The light goes off by the device's own watchdog; a sequence goes on."""
        self._exchange.link.close()

    def reconnect(self) -> HelloReply:
        """Say HELLO again, after a restart or a lost link; forgets events that were not fetched."""
        exchange = self._exchange
        identity = exchange.hello(self._hello_timeout_s)
        self._steps, self._table_hash, self._run_id = (), 0, 0
        mismatch = exchange.mismatch
        if mismatch is None:
            exchange.skip_old_events()
        elif not self._allow_mismatch:
            raise mismatch
        logger.info(
            "connected to %s on %s, firmware %s",
            identity.board,
            self.url,
            identity.firmware_version,
        )
        return identity

    @property
    def log(self) -> WireLog:
        """What passed over the link since it was opened."""
        return self._exchange.link.log

    # -- what it is -------------------------------------------------------------------------------

    @property
    def identity(self) -> HelloReply:
        """Answer to HELLO: board, versions, capabilities, capacities, serial number, reset cause."""
        if self._exchange.identity is None:
            raise DeviceError("No device is connected.", hint="Call reconnect().")
        return self._exchange.identity

    @property
    def run_id(self) -> int:
        """Run that this client started last, 0 if none."""
        return self._run_id

    @property
    def link_counters(self) -> dict[str, int]:
        """Frames, bytes, retries and drops counted on this side."""
        return self._exchange.link.counters

    def status(self) -> StatusReply:
        """What it does now."""
        return self._exchange.request(StatusRequest())

    def limits(self) -> LimitsReply:
        """Safety limits of the board."""
        return self._exchange.request(LimitsRequest())

    def counters(self) -> CountersReply:
        """What the device counted since its start."""
        return self._exchange.request(CountersRequest())

    def settings(self) -> GetSettingsReply:
        """Settings in the non-volatile memory."""
        return self._exchange.request(GetSettingsRequest())

    def led_correction(self) -> GetLedCorrectionReply:
        """Factors by which the board lowers the current of each LED."""
        return self._exchange.request(GetLedCorrectionRequest())

    def store_led_correction(self, factors: Sequence[int]) -> SetLedCorrectionReply:
        """Replace the factors of all LEDs, 0 to 255: currents are level * (factor + 1) / 256."""
        return self._exchange.request(SetLedCorrectionRequest(bytes(factors)))

    def store_settings(self, settings: SetSettingsRequest) -> SetSettingsReply:
        """Replace all settings."""
        return self._exchange.request(settings)

    # -- apertures and lights ---------------------------------------------------------------------

    def load_aperture(self, slot: int, bitmap: BoolImage) -> int:
        """Load a bitmap (64, 128), True = open, row 0 on top, into a slot; returns the number of open pixels."""
        data = pack_bitmap(bitmap)
        for chunk in range(len(data) // APERTURE_CHUNK):
            part = data[chunk * APERTURE_CHUNK : (chunk + 1) * APERTURE_CHUNK]
            self._exchange.request(ApertureChunkRequest(slot, chunk, part))
        reply = self._exchange.request(CommitApertureRequest(slot, zlib.crc32(data)))
        return reply.open_pixels

    def load_light(self, slot: int, levels: Sequence[int] | NDArray[np.integer]) -> LoadLightReply:
        """Load the levels (0 to 4095) of LED 0, 1, ... into a slot; LEDs beyond are off.

        Raises
        ------
        FailedError
            CURRENT_BUDGET, if all together are too much.
        """
        numbers = tuple(int(level) for level in levels)
        reply = self._exchange.request(LoadLightRequest(slot, numbers))
        wanted = zlib.crc32(
            np.asarray(numbers + (0,) * (LEDS - len(numbers)), dtype="<u2").tobytes()
        )
        _check_echo("light levels", wanted, reply.crc32)
        return reply

    def select_aperture(self, slot: int | None) -> SelectApertureReply:
        """Send a slot to the glass (None: shut); the glass takes its time to follow."""
        return self._exchange.request(SelectApertureRequest(SLOT_NONE if slot is None else slot))

    def select_light(self, slot: int | None) -> SelectLightReply:
        """Turn a light on (None: off), and any other off."""
        return self._exchange.request(SelectLightRequest(SLOT_NONE if slot is None else slot))

    def all_off(self) -> SequenceState:
        """All LEDs off at once; aborts a sequence."""
        return self._exchange.request(AllOffRequest()).sequence

    # -- sequences --------------------------------------------------------------------------------

    def load_steps(self, steps: Sequence[Step]) -> int:
        """Load the step table; returns its hash, which every exposure event repeats."""
        if not 1 <= len(steps) <= STEPS:
            raise InvalidInputError(
                f"A table of {len(steps)} steps was given; 1 to {STEPS} are possible.",
                hint="Split the sequence into several tables.",
            )
        for first in range(0, len(steps), STEP_CHUNK):
            part = tuple(steps[first : first + STEP_CHUNK])
            self._exchange.request(StepChunkRequest(first, part))
        wanted = zlib.crc32(b"".join(step.pack() for step in steps))
        reply = self._exchange.request(CommitStepsRequest(len(steps), wanted))
        _check_echo("step table", wanted, reply.table_hash)
        self._steps, self._table_hash = tuple(steps), wanted
        return wanted

    def start(
        self, run_id: int, *, timing: SequenceTiming | None = None, deadline_s: float | None = None
    ) -> StartReply:
        """Start the table that was loaded last.

        Parameters
        ----------
        run_id:
            Number from 1 on that every event of this sequence carries.
        timing:
            What holds for every step; by default :class:`SequenceTiming`.
        deadline_s:
            Time after which the device gives up; by default 1.5 times the sequence's duration and 10 s.
        """
        timing = timing or SequenceTiming()
        if deadline_s is None:
            deadline_s = default_deadline_s(self._steps, timing)
        reply = self._exchange.request(
            StartRequest(
                run_id=run_id,
                table_hash=self._table_hash,
                deadline_ms=max(1, round(deadline_s * MS_PER_S)),
                light_lead_us=timing.light_lead_us,
                trigger_us=timing.trigger_us,
                gap_us=timing.gap_us,
                ready_timeout_ms=timing.ready_timeout_ms,
                require_strobe=timing.require_strobe,
            )
        )
        self._run_id = run_id
        return reply

    def pause(self) -> SequenceState:
        """Stop between two exposures; a sequence event tells when it stands."""
        return self._exchange.request(PauseRequest(self._run_id)).sequence

    def resume(self) -> SequenceState:
        """Go on after a pause."""
        return self._exchange.request(ResumeRequest(self._run_id)).sequence

    def abort(self) -> SequenceState:
        """Light off, glass shut, whatever sequence is under way ended."""
        return self._exchange.request(AbortRequest(0)).sequence

    def clear_fault(self, reason: FaultReason) -> FaultReason:
        """Clear the latched fault if it is this one; returns what is latched then."""
        return self._exchange.request(ClearFaultRequest(reason)).fault

    def events(self, timeout_s: float) -> ExposureEvent | FaultEvent | SequenceEvent:
        """Wait for the next event, in their order, each once, none left out.

        Raises
        ------
        DeviceTimeout
            If none comes within ``timeout_s`` although the device is alive.
        DeviceRebootedError, OutcomeUnknownError
            If it restarted or is gone.
        """
        event = self._exchange.next_event(timeout_s)
        if not isinstance(event, ExposureEvent | FaultEvent | SequenceEvent):
            raise DeviceError(f"The device sent an event that is not expected: {event}.")
        return event

    # -- bootloader -------------------------------------------------------------------------------

    def enter_bootloader(self) -> EnterBootloaderReply:
        """Leave for the bootloader; works across any mismatch of versions.  The port goes away."""
        return self._exchange.request(EnterBootloaderRequest(BOOTLOADER_MAGIC))


def _check_echo(what: str, wanted: int, got: int) -> None:
    if wanted != got:
        raise DeviceError(
            f"The device confirmed other {what} than were sent (CRC {got:08x} instead of {wanted:08x}).",
            hint="Load them again; if it persists, report it with the wire log.",
        )
