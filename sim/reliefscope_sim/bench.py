"""The bench: everything of one simulated instrument, and its time.

Device and camera of the same NAME share a bench (:meth:`Bench.attach`).  Its time moves only in
:meth:`Bench.wait`: from event to event (a firmware timer, the end of an exposure, a frame that arrives), never
past what is waited for.  One lock guards all of it; pictures are rendered outside of that lock.
"""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import ClassVar

from reliefscope.errors import CameraError
from reliefscope.models.camera import CameraBusyError, CameraLostError
from reliefscope.protocol.messages import ResetCause
from reliefscope.units import US_PER_S
from reliefscope_sim.clock import Clock
from reliefscope_sim.darkroom import Darkroom
from reliefscope_sim.electronics import Electronics
from reliefscope_sim.firmware import NEVER_US
from reliefscope_sim.link import BYTE_US, WRITE_AHEAD, Cable
from reliefscope_sim.recording import Recording
from reliefscope_sim.replay import Player
from reliefscope_sim.shutter import Exposure, Shutter
from reliefscope_sim.trace import InputLine
from reliefscope_sim.url import SimUrl

logger = logging.getLogger(__name__)

POLL_US = 100
"""Time that looking for bytes or frames without waiting takes; a host that polls lets the clock run too."""
_STEPS_IN_A_ROW = 64
_NAP_S = 0.02
"""Longest sleep before a wait looks again whether it was cancelled."""


class Bench:
    """One simulated instrument on a bench, switched on when it is made.

    Raises
    ------
    InvalidInputError
        If profile, size or scene do not exist.
    DeviceError
        If the compiled firmware core is missing.
    """

    _registry: ClassVar[dict[str, Bench]] = {}
    _registry_lock: ClassVar[threading.RLock] = threading.RLock()
    _switched_on: ClassVar[int] = 0

    def __init__(self, url: SimUrl, nonces: Iterable[int] = ()) -> None:
        self.url = url
        self.profile = url.load_profile()
        self.darkroom = Darkroom(url, self.profile)
        self.faults = url.faults
        self.cable = Cable(self.faults, url.seed)
        Bench._switched_on += 1
        self._board = Electronics(
            url,
            self.profile,
            self.faults,
            on_pulse=self._pulse,
            on_leave=self.cable.cut,
            nonces=nonces,
            first_boot=Bench._switched_on << 16,
        )
        self.display = self._board.display
        self.glass = self._board.glass
        self.leds = self._board.leds
        self.serial_number = self._board.serial_number
        self.camera_serial = url.camera_serial
        self.shutter = Shutter(self.glass, self.leds, self.profile.camera.frames_per_s, self.faults)
        self.time_us = 0
        self._users = 0
        self._off = False
        self._changed = threading.Condition(threading.RLock())
        self._camera_open = False
        self._clock = Clock(url.time)

    # --- who uses it ---

    @classmethod
    def attach(cls, url: str) -> Bench:
        """The bench of the NAME in ``url``, switched on if need be; give it back with :meth:`release`.

        Raises
        ------
        InvalidInputError
            If the bench is in use with other options than those that ``url`` names.
        """
        wanted = SimUrl.parse(url)
        with cls._registry_lock:
            bench = cls._registry.get(wanted.name)
            if bench is None:
                bench = cls._registry[wanted.name] = cls._switch_on(wanted)
            else:
                bench.url.check_agrees(wanted)
            bench._users += 1
            return bench

    @classmethod
    def _switch_on(cls, url: SimUrl) -> Bench:
        """A new bench; one that replays a recording stands where the recording ends."""
        if url.replay is None:
            return cls(url)
        recording = Recording.load(Path(url.replay))
        bench = cls(url, recording.nonces)
        report = Player(bench, recording, pictures=False).play()
        logger.info("replayed %s: %s", url.replay, report)
        return bench

    @classmethod
    def in_use(cls) -> list[str]:
        """Names of the benches that are switched on."""
        with cls._registry_lock:
            return list(cls._registry)

    def release(self) -> None:
        """Give the bench back; the last one switches it off."""
        with self._registry_lock, self._changed:
            self._users -= 1
            if self._users == 0:
                del self._registry[self.url.name]
                self.switch_off()

    def switch_off(self) -> None:
        """End of it: every wait ends, nothing else may be called."""
        with self._changed:
            self._off = True
            self._board.close()
            self._changed.notify_all()

    # --- time ---

    def wait(self, ready: Callable[[], bool], timeout_us: int | None) -> bool:
        """Let the clock run until ``ready()`` or for ``timeout_us`` (None: for ever).

        ``ready`` is called with the bench's lock held.  Returns what it said last; False at once where the
        bench was switched off meanwhile.
        """
        with self._changed:
            self._catch_up()
            deadline_us = NEVER_US if timeout_us is None else self.time_us + timeout_us
        turns = 0
        while True:
            turns += 1
            if turns % _STEPS_IN_A_ROW == 0:
                time.sleep(0)  # other threads get their turn at the lock
            with self._changed:
                self._catch_up()
                if ready():
                    return True
                if self._off or self.time_us >= deadline_us:
                    return False
                if self._clock.real:
                    ahead_us = min(deadline_us, self._next_event_us()) - self._clock.due_us()
                    self._changed.wait(min(max(ahead_us, 0) / US_PER_S, _NAP_S))
                elif deadline_us == NEVER_US and self._next_event_us() == NEVER_US:
                    self._changed.wait(_NAP_S)
                else:
                    self._step(deadline_us)

    def run_to(self, time_us: int) -> None:
        """Let the clock run to a moment; one that is past is ignored."""
        if time_us > self.time_us:
            self.wait(lambda: False, time_us - self.time_us)

    def poll(self) -> None:
        """The host looked without waiting."""
        with self._changed:
            self._spend(POLL_US)

    def _spend(self, duration_us: int) -> None:
        """Let time go by for what the host does."""
        until_us = self.time_us if self._clock.real else self.time_us + duration_us
        self._catch_up()
        while self.time_us < until_us and not self._off:
            self._step(until_us)

    def _catch_up(self) -> None:
        """Under real time: run up to what the wall says."""
        due_us = self._clock.due_us()
        while self.time_us < due_us and not self._off:
            self._step(due_us)

    def _next_event_us(self) -> int:
        return min(self.shutter.next_event_us, self.cable.next_event_us, self._board.next_event_us)

    def _step(self, limit_us: int) -> None:
        """Run to the next event, at most to ``limit_us``, at least by 1 us."""
        time_us = min(limit_us, max(self._next_event_us(), self.time_us + 1))
        self._board.run_until(time_us)
        self.time_us = time_us
        self._clock.advance_to(time_us)
        self.shutter.run_until(time_us)
        self._drive_inputs()
        self._exchange()
        needed_us = self.shutter.needs_from_us
        history_us = time_us if needed_us is None else needed_us
        self.glass.forget_before(history_us)
        self.leds.forget_before(history_us)
        self._changed.notify_all()

    # --- wires ---

    def _pulse(self, time_us: int) -> None:
        number = self.shutter.pulses
        # What happened before the pulse belongs before it: a frame that was read out frees the sensor.
        self.shutter.run_until(time_us)
        self.shutter.pulse(time_us)
        self._board.fail_at(number, time_us, time_us + self.shutter.exposure_us // 2)
        self.cable.strike(number)

    def _drive_inputs(self) -> None:
        self._board.drive_inputs(
            {
                InputLine.CAMERA_STROBE: self.shutter.strobe,
                InputLine.CAMERA_READY: self.shutter.ready(self.time_us),
            }
        )

    def _exchange(self) -> None:
        if not self._board.halted:
            self.cable.exchange(self.time_us, self._board.firmware)

    # --- the device's face ---

    def open_port(self) -> bool:
        """Take the serial port; False if somebody has it."""
        with self._changed:
            if self.cable.host_open:
                return False
            self._catch_up()
            if self._board.in_bootloader:
                self._board.restart(ResetCause.BOOTLOADER)
            self.cable.plug_in()
            return True

    def close_port(self) -> None:
        """Let go of the serial port."""
        with self._changed:
            self.cable.unplug()
            self._changed.notify_all()

    def send(self, data: bytes, timeout_us: int | None) -> bool:
        """Bytes from the host; False if the device did not take them in time."""
        with self._changed:
            self._catch_up()
            self.cable.send(self.time_us, data)
            self._spend(len(data) * BYTE_US)
            if self._clock.real and not self._off:
                self._exchange()
            self._changed.notify_all()
        return self.wait(lambda: self.cable.unsent <= WRITE_AHEAD or self.cable.broken, timeout_us)

    def receive(self, size: int, timeout_us: int | None, cancelled: Callable[[], bool]) -> bytes:
        """Up to ``size`` bytes from the device, fewer when time is up."""
        if timeout_us == 0:
            self.poll()
        self.wait(
            lambda: len(self.cable.received) >= size or self.cable.broken or cancelled(),
            timeout_us,
        )
        with self._changed:
            data = bytes(self.cable.received[:size])
            del self.cable.received[: len(data)]
            self._spend(len(data) * BYTE_US)
            return data

    def take_received(self) -> bytes:
        """Everything that has come from the device; taking it lets no time go by."""
        with self._changed:
            data = bytes(self.cable.received)
            self.cable.received.clear()
            return data

    def discard_input(self) -> None:
        """Forget what the host has not read."""
        with self._changed:
            self.cable.clear_input()

    def discard_output(self) -> None:
        """Forget what the device has not taken."""
        with self._changed:
            self.cable.clear_output()

    def wake(self) -> None:
        """Let waits look again whether they were cancelled."""
        with self._changed:
            self._changed.notify_all()

    # --- the camera's face ---

    def open_camera(self, *, set_up: bool = True) -> None:
        """Take the camera; the first time, the scene is set up, unless nobody will look."""
        with self._changed:
            if self._camera_open:
                raise CameraBusyError(
                    f"The camera of the simulated instrument `{self.url.name}` is already open.",
                    hint="Close the other program or object that holds it.",
                )
            self._camera_open = True
        try:
            if set_up:
                self.darkroom.set_up()
        except BaseException:
            self.close_camera()
            raise

    def close_camera(self) -> None:
        """Let go of the camera."""
        with self._changed:
            self.shutter.disarm()
            self._camera_open = False

    def configure_camera(self, exposure_us: int, *, triggered: bool, gain_db: float) -> None:
        """Exposure time, gain and mode."""
        with self._changed:
            self._check_camera()
            if self.shutter.armed:
                raise CameraBusyError(
                    "Settings cannot change while the camera is armed.", hint="Disarm it first."
                )
            self.shutter.configure(exposure_us, triggered=triggered, gain_db=gain_db)

    def arm_camera(self) -> None:
        """Take pulses, or start free-running, from now on."""
        with self._changed:
            self._catch_up()
            self._check_camera()
            self.shutter.arm(self.time_us)
            self._drive_inputs()

    def disarm_camera(self) -> None:
        """Stop."""
        with self._changed:
            self._catch_up()
            self.shutter.disarm()
            self._drive_inputs()

    def take_exposure(self) -> Exposure | None:
        """The next frame if it has arrived, not rendered yet; asking lets no time go by."""
        with self._changed:
            return self.shutter.fetch()

    def next_exposure(self, timeout_us: int) -> Exposure | None:
        """The next frame to have arrived, not rendered yet; None if none came in time."""
        if timeout_us == 0:
            self.poll()
        found: list[Exposure] = []

        def fetched() -> bool:
            exposure = self.shutter.fetch()
            if exposure is not None:
                found.append(exposure)
                return True
            return self.shutter.unplugged or not self.shutter.armed

        self.wait(fetched, timeout_us)
        if found:
            return found[0]
        with self._changed:
            self._check_camera()
            if not self.shutter.armed:
                raise CameraError(
                    "The camera is not armed, so no frame can come.", hint="Arm it first."
                )
        return None

    def _check_camera(self) -> None:
        if self.shutter.unplugged:
            raise CameraLostError(
                f"The camera of the simulated instrument `{self.url.name}` is gone.",
                hint="Plug it in (open the instrument without fault=camera_unplug), then resume.",
            )
