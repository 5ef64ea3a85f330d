"""The instrument on the bench: device and camera behind one object."""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from types import MappingProxyType, TracebackType
from typing import Any, Self

import numpy as np

from reliefscope.acquisition import acquire as acquire_run
from reliefscope.acquisition import resumable
from reliefscope.acquisition import resume as resume_run
from reliefscope.camera import offers_camera, open_camera
from reliefscope.device import Device, Step
from reliefscope.errors import (
    CameraError,
    InvalidInputError,
    ReliefscopeError,
)
from reliefscope.jobs import Job
from reliefscope.microscope.instruments import Instrument, resolve_instrument
from reliefscope.microscope.places import fresh_path
from reliefscope.microscope.sequences import (
    expose_once,
    summarise_plan,
    watched,
)
from reliefscope.microscope.stored import StoredRun
from reliefscope.models.apertures import GLASS_SHAPE, disc
from reliefscope.models.calibration import Calibration
from reliefscope.models.camera import Camera, CameraInfo, CameraSettings, Frame
from reliefscope.models.instrument import InstrumentProfile
from reliefscope.models.plan import Aperture, Plan, default_plan
from reliefscope.protocol.messages import SLOT_NONE, FaultReason, HelloReply
from reliefscope.units import US_PER_S, BoolImage

logger = logging.getLogger(__name__)

MANUAL_SLOT = 0
"""Aperture and light slot of what is shown by hand; an acquisition loads its own."""
KEEP_ALIVE_S = 0.5
ON_TIME_SHARE = 0.7
"""Part of an LED's longest on-time after which the live picture gives it a short break."""
SHUT = "shut"


class Microscope:
    """A connected instrument.  All methods may be called from any thread.

    ``profile``, ``calibration`` and where they come from are in :attr:`instrument`.  :attr:`aperture`,
    :attr:`aperture_name` and :attr:`light` are what the device last confirmed.
    """

    def __init__(self, device: Device, camera: Camera | None, instrument: Instrument) -> None:
        self.device = device
        self.camera = camera
        self.instrument = instrument
        self.live_exposure_us = round(instrument.profile.exposure_ms * 1000)
        self.aperture: BoolImage = np.zeros(GLASS_SHAPE, bool)
        self.aperture_name = SHUT
        self._levels: dict[int, int] = {}
        self._lock = threading.RLock()
        self._camera_lock = threading.RLock()
        self._on_time_s = device.limits().led_on_time_us / US_PER_S
        self._lit_at_s = self._kept_at_s = time.monotonic()
        self._lit_at_us = self._kept_at_us = 0
        self._camera_us = 0

    @classmethod
    def open(
        cls,
        device_url: str,
        camera_url: str | None = None,
        *,
        profile: InstrumentProfile | str | None = None,
        calibration: Calibration | Path | str | None = None,
        hello_timeout_s: float = 2.0,
    ) -> Self:
        """Connect to the device and, where there is one, its camera.

        Parameters
        ----------
        device_url:
            Serial port, ``socket://HOST:PORT`` or ``sim://NAME?...``.
        camera_url:
            Camera; by default the same URL where its scheme offers a camera, else none.
        profile, calibration:
            What to use instead of what belongs to the URL; see :func:`resolve_instrument`.
        hello_timeout_s:
            Time that the device has to answer.

        Raises
        ------
        InvalidInputError, DeviceError, CameraError, LockedError
        """
        resolve_instrument(device_url, profile=profile, calibration=calibration)  # refuse early
        device = Device.open(device_url, hello_timeout_s)
        camera: Camera | None = None
        try:
            instrument = resolve_instrument(
                device_url,
                profile=profile,
                calibration=calibration,
                serial_number=device.identity.serial_number,
            )
            if camera_url is not None or offers_camera(device_url):
                camera = open_camera(camera_url or device_url)
            microscope = cls(device, camera, instrument)
            microscope.shut()
            microscope.all_off()
        except BaseException:
            if camera is not None:
                camera.close()
            device.close()
            raise
        return microscope

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def close(self) -> None:
        """All LEDs off, glass shut, camera and port let go."""
        with suppress(ReliefscopeError):
            self.all_off()
        with suppress(ReliefscopeError):
            self.device.select_aperture(None)
        try:
            if self.camera is not None:
                self.camera.close()
        finally:
            self.device.close()

    # What it is -------------------------------------------------------------------------------

    @property
    def profile(self) -> InstrumentProfile:
        """The instrument as designed."""
        return self.instrument.profile

    @property
    def calibration(self) -> Calibration:
        """How this one departs from its design."""
        return self.instrument.calibration

    @property
    def identity(self) -> HelloReply:
        """Board, firmware version, serial number."""
        return self.device.identity

    @property
    def has_camera(self) -> bool:
        """Whether a camera is connected."""
        return self.camera is not None

    @property
    def camera_info(self) -> CameraInfo | None:
        """Identity of the camera."""
        return None if self.camera is None else self.camera.info

    @property
    def light(self) -> Mapping[int, int]:
        """LED index -> level of every LED that is on."""
        return MappingProxyType(self._levels)

    # By hand ----------------------------------------------------------------------------------

    def show_aperture(self, aperture: Aperture | BoolImage, name: str = "bitmap") -> None:
        """Put an aperture on the glass: a named one, or a bitmap (64, 128), True = open, row 0 on top.

        The glass takes ``profile.glass.settle_ms`` to follow; :meth:`snap` waits for it.
        """
        bitmap = aperture.bitmap if isinstance(aperture, Aperture) else np.asarray(aperture, bool)
        with self._lock:
            self.device.load_aperture(MANUAL_SLOT, bitmap)
            self.device.select_aperture(MANUAL_SLOT)
            self.aperture = bitmap.copy()
            self.aperture_name = aperture.name if isinstance(aperture, Aperture) else name

    def show_disc(self, x_mm: float, y_mm: float, diameter_mm: float | None = None) -> None:
        """Open a disc centred at (``x_mm``, ``y_mm``) on the glass, y up, origin in its middle."""
        diameter = diameter_mm or self.profile.apertures.disc_diameter_mm
        bitmap = disc(self.profile.glass, (x_mm, y_mm), diameter)
        self.show_aperture(bitmap, name=f"disc {diameter:g} mm at ({x_mm:g}, {y_mm:g}) mm")

    def shut(self) -> None:
        """Shut the glass."""
        with self._lock:
            self.device.select_aperture(None)
            self.aperture = np.zeros(GLASS_SHAPE, bool)
            self.aperture_name = SHUT

    def set_light(self, levels: Mapping[int, int]) -> None:
        """Light these LEDs (index -> level, up to 4095) and no other; none turns the light off.

        Outside of :meth:`live` the device turns it off by itself when it hears nothing for two seconds.

        Raises
        ------
        InvalidInputError
            If there is no such LED or level.
        FailedError
            If all together exceed the current budget, or a fault is latched.
        """
        count, full = self.profile.dome.count, self.profile.dome.full_level
        for led, level in levels.items():
            if not (0 <= led < count and 0 <= level <= full):
                raise InvalidInputError(
                    f"There is no level {level} of LED {led}.",
                    hint=f"LEDs are 0 to {count - 1}, levels 0 to {full}.",
                )
        wanted = {led: level for led, level in sorted(levels.items()) if level > 0}
        with self._lock:
            if not wanted:
                self.all_off()
                return
            self.device.load_light(MANUAL_SLOT, [wanted.get(led, 0) for led in range(count)])
            self.device.select_light(MANUAL_SLOT)
            self._levels = wanted
            self._note_lit()

    def all_off(self) -> None:
        """All LEDs off at once; ends a sequence that is under way."""
        self.device.all_off()
        self._levels = {}

    def clear_fault(self) -> FaultReason:
        """Clear the fault that the device has latched; returns it (``NONE`` if there was none)."""
        fault = self.device.status().fault
        if fault is not FaultReason.NONE:
            self.device.clear_fault(fault)
        return fault

    def keep_alive(self) -> None:
        """Keep the light on: tell the device that somebody is there, and give LEDs a break in time."""
        now_s, camera_us = time.monotonic(), self._camera_us
        quiet_s = max(now_s - self._kept_at_s, (camera_us - self._kept_at_us) / US_PER_S)
        if quiet_s < min(KEEP_ALIVE_S, self._on_time_s / 4):
            return
        with self._lock:
            self._kept_at_s, self._kept_at_us = now_s, camera_us
            lit_s = max(now_s - self._lit_at_s, (camera_us - self._lit_at_us) / US_PER_S)
            if self._levels and lit_s > ON_TIME_SHARE * self._on_time_s:
                self.device.select_light(None)
                self.device.select_light(MANUAL_SLOT)
                self._note_lit()
            else:
                self.device.status()

    def _note_lit(self) -> None:
        self._lit_at_s = self._kept_at_s = time.monotonic()
        self._lit_at_us = self._kept_at_us = self._camera_us

    # Pictures ---------------------------------------------------------------------------------

    def _need_camera(self) -> Camera:
        if self.camera is None:
            raise CameraError(
                f"No camera is connected to {self.device.url}.",
                hint="Give its URL with --camera (Microscope.open(device_url, camera_url)); "
                "`reliefscope doctor` lists what is found.",
            )
        return self.camera

    def live(self, stop: threading.Event) -> Iterator[Frame]:
        """Frames of what glass and lights are at the moment, until ``stop`` is set.

        Exposure is :attr:`live_exposure_us`, read once at the beginning.  Keeps the light on.
        """
        camera = self._need_camera()
        with self._camera_lock:
            camera.configure(CameraSettings(exposure_us=self.live_exposure_us, trigger=False))
            camera.arm()
            self._camera_us = self._kept_at_us = self._lit_at_us = 0
            period_s = 1 / self.profile.camera.frames_per_s
            timeout_s = 2.0 + 2 * (self.live_exposure_us / US_PER_S + period_s)
            try:
                while not stop.is_set():
                    frame = camera.next_frame(timeout_s)
                    self._follow(frame)
                    self.keep_alive()
                    yield frame
            finally:
                camera.disarm()

    def _follow(self, frame: Frame) -> None:
        if self._camera_us == 0:
            self._kept_at_us = self._lit_at_us = frame.time_us
        self._camera_us = frame.time_us

    def snap(self, exposure_us: int | None = None, *, settle_ms: float | None = None) -> Frame:
        """One frame of the present aperture and light, after the glass has settled.

        The device steps it: settle, light on, trigger, light off.  The light is on again afterwards if it
        was before.
        """
        camera = self._need_camera()
        exposure = exposure_us or self.live_exposure_us
        settle = self.profile.glass.settle_ms if settle_ms is None else settle_ms
        step = Step(
            aperture=MANUAL_SLOT if self.aperture.any() else SLOT_NONE,
            light=MANUAL_SLOT if self._levels else SLOT_NONE,
            repeat=1,
            settle_us=round(settle * 1000),
            exposure_us=exposure,
        )
        with self._camera_lock, self._lock:
            camera.configure(CameraSettings(exposure_us=exposure, trigger=True))
            camera.arm()
            try:
                frame = expose_once(self.device, camera, step)
            finally:
                camera.disarm()
            if self._levels:
                self.device.select_light(MANUAL_SLOT)
                self._note_lit()
        return frame

    # Runs -------------------------------------------------------------------------------------

    def default_plan(self) -> Plan:
        """The profile's pattern of apertures under every LED, with dark, leakage and centre frames."""
        return default_plan(self.profile)

    def plan_summary(self, plan: Plan) -> dict[str, Any]:
        """What a plan takes, for people and for ``--dry-run --json``."""
        return summarise_plan(plan, self.instrument)

    def acquire(
        self,
        plan: Plan | None = None,
        out: Path | str | None = None,
        *,
        job: Job | None = None,
        sample: str = "",
        notes: str = "",
        on_frame: Callable[[Frame], None] | None = None,
    ) -> StoredRun:
        """Take a run.

        Parameters
        ----------
        plan:
            What to take; :meth:`default_plan` if left out.
        out:
            Folder of the new run; ``runs/run-001`` and so on if left out.
        job:
            Receives progress; cancelling it pauses after the current frame.
        sample, notes:
            Kept with the run.
        on_frame:
            Called with every frame as it comes, from the thread that acquires.

        Raises
        ------
        OutputExistsError, InvalidInputError
            Before anything moves.
        DeviceError, CameraError, DatasetError
            Naming the part that failed; the run can be resumed.
        Cancelled
            After the current frame; the run can be resumed.
        """
        place = fresh_path("run") if out is None else Path(out)
        camera = self._watched(on_frame)
        with self._sequence(place):
            run = acquire_run(
                self.device,
                camera,
                plan or self.default_plan(),
                self.profile,
                self.calibration,
                place,
                job=job,
                sample=sample,
                notes=notes,
            )
        return StoredRun(run)

    def resume(
        self,
        run: Path | str,
        *,
        job: Job | None = None,
        on_frame: Callable[[Frame], None] | None = None,
    ) -> StoredRun:
        """Take what is missing of a run."""
        camera = self._watched(on_frame)
        with self._sequence(Path(run)):
            return StoredRun(resume_run(Path(run), self.device, camera, job))

    def _watched(self, on_frame: Callable[[Frame], None] | None) -> Camera:
        camera = self._need_camera()
        return camera if on_frame is None else watched(camera, on_frame)

    @contextmanager
    def _sequence(self, run: Path) -> Iterator[None]:
        """Around an acquisition: light off and glass shut before and after, however it ends."""
        with self._camera_lock, resumable(run):
            self.all_off()
            self.shut()
            try:
                yield
            finally:
                with suppress(ReliefscopeError):
                    self.all_off()
                    self.shut()
