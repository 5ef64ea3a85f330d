"""The simulated camera, as the host sees it."""

from __future__ import annotations

from reliefscope.models.camera import CameraInfo, CameraSettings, CameraTimeout, Frame
from reliefscope.units import US_PER_S
from reliefscope_sim.bench import Bench

EXPOSURE_RANGE_US = (20, 10_000_000)
GAIN_RANGE_DB = (0.0, 32.0)
GAIN_STEP_DB = 0.1


class SimCamera:
    """Camera of the bench of ``url``; see :class:`reliefscope.models.camera.Camera`.

    Frames are rendered when they are fetched.
    """

    def __init__(self, url: str) -> None:
        self._bench: Bench | None = None
        bench = Bench.attach(url)
        try:
            bench.open_camera()
        except BaseException:
            bench.release()
            raise
        self._bench = bench
        profile = bench.profile
        self._info = CameraInfo(
            vendor="reliefscope",
            model=f"{profile.camera.model}, simulated",
            serial=bench.camera_serial,
            shape=profile.shape,
            sensor=profile.camera.sensor,
            bit_depth=profile.camera.bit_depth,
            trigger_inputs=True,
        )

    @property
    def info(self) -> CameraInfo:
        """Identity and form of the frames."""
        return self._info

    @property
    def is_open(self) -> bool:
        """Whether it was not closed."""
        return self._bench is not None

    @property
    def dropped(self) -> int:
        """Frames lost since it was armed: missed pulses, full buffers, faults."""
        return self._open_bench().shutter.dropped

    def configure(self, settings: CameraSettings) -> CameraSettings:
        """Set exposure, gain and trigger, within :data:`EXPOSURE_RANGE_US` and :data:`GAIN_RANGE_DB`."""
        low, high = EXPOSURE_RANGE_US
        exposure_us = min(max(settings.exposure_us, low), high)
        lowest_db, highest_db = GAIN_RANGE_DB
        steps = round(min(max(settings.gain_db, lowest_db), highest_db) / GAIN_STEP_DB)
        gain_db = round(steps * GAIN_STEP_DB, 1)
        bench = self._open_bench()
        bench.configure_camera(exposure_us, triggered=settings.trigger, gain_db=gain_db)
        return CameraSettings(exposure_us, gain_db=gain_db, trigger=settings.trigger)

    def arm(self) -> None:
        """Get ready for pulses, or start free-running."""
        self._open_bench().arm_camera()

    def next_frame(self, timeout_s: float) -> Frame:
        """The next frame in order.

        Raises
        ------
        CameraTimeout
            After ``timeout_s`` of the instrument's time without one.
        CameraLostError
            If the camera was unplugged.
        """
        bench = self._open_bench()
        exposure = bench.next_exposure(round(timeout_s * US_PER_S))
        if exposure is None:
            raise CameraTimeout(
                f"No frame came within {timeout_s:g} s.",
                hint="Check that triggers are sent, and that none came during exposure or readout.",
            )
        raw = bench.darkroom.develop(exposure)
        return Frame(raw, exposure.frame_id, exposure.start_us, exposure.exposure_us)

    def disarm(self) -> None:
        """Stop; frames not fetched are dropped."""
        self._open_bench().disarm_camera()

    def close(self) -> None:
        """Let go of the camera; closing twice does no harm."""
        bench, self._bench = self._bench, None
        if bench is not None:
            bench.close_camera()
            bench.release()

    def _open_bench(self) -> Bench:
        if self._bench is None:
            raise ValueError("the camera is closed")
        return self._bench


def open_camera(url: str) -> SimCamera:
    """Camera of the simulated instrument at ``sim://NAME?...``."""
    return SimCamera(url)
