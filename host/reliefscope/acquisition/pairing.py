"""Frames meet events by count, never by time; any disagreement ends the acquisition.

Exposure number n of a sequence is event n of the device and frame n of the camera.  The event says which step,
aperture and light it was; all of it must be what the table says.
"""

from __future__ import annotations

import logging
from dataclasses import dataclass

from reliefscope.acquisition.batches import Batch
from reliefscope.device import (
    Device,
    DeviceTimeout,
    ExposureEvent,
    FailedError,
    FaultEvent,
    SequenceEvent,
    SequenceNews,
    SequenceState,
    SequenceTiming,
)
from reliefscope.errors import CameraError, DeviceError, ReliefscopeError
from reliefscope.models.camera import Camera, CameraTimeout, Frame
from reliefscope.protocol.messages import ErrorCode, FaultReason
from reliefscope.units import US_PER_S

log = logging.getLogger(__name__)

MARGIN_S = 3.0
"""Added to what an exposure must take, before a wait for it ends."""
_KEPT = "What was stored is kept."


@dataclass(frozen=True, slots=True)
class Exposure:
    """One frame with the event that belongs to it."""

    step: int
    repeat: int
    event: ExposureEvent
    frame: Frame


class Pairing:
    """The exposures of one batch that runs, in order.

    ``readout_s`` is the camera's longest time from the end of an exposure to its frame.
    """

    def __init__(
        self,
        device: Device,
        camera: Camera,
        batch: Batch,
        table_hash: int,
        run_id: int,
        timing: SequenceTiming,
        readout_s: float,
    ) -> None:
        self._device = device
        self._camera = camera
        self._batch = batch
        self._table_hash = table_hash
        self._run_id = run_id
        self._timing = timing
        self._readout_s = readout_s
        self._count = 0
        self._step = 0
        self._repeat = 0
        self._started = False
        self._stopped_at: int | None = None

    def next(self) -> Exposure | None:
        """The next exposure with its frame; None once the sequence stands and everything before is paired.

        Raises
        ------
        DeviceError
            If the device stalled, stopped with a fault, or confirmed something else than the table says.
        CameraError
            If a frame is missing.
        """
        while self._stopped_at != self._count:
            event = self._next_event()
            if isinstance(event, SequenceEvent) and event.run_id == self._run_id:
                self._heed(event)
            elif not self._started:
                log.info("left over from an earlier sequence: %s", event)
            elif isinstance(event, ExposureEvent):
                return self._pair(event)
            elif isinstance(event, FaultEvent):
                raise _fault(event)
            else:
                raise DeviceError(
                    f"An event of sequence {event.run_id} came during sequence {self._run_id}.",
                    hint=f"Make sure that only one program uses the device. {_KEPT}",
                )
        return None

    def stop(self) -> None:
        """Ask the device to pause; :meth:`next` then gives what was exposed before it stood."""
        try:
            self._device.pause()
        except FailedError as error:
            if error.code is not ErrorCode.NOT_RUNNING:
                raise
            log.info("the sequence had ended before it could be paused")

    def _next_event(self) -> ExposureEvent | FaultEvent | SequenceEvent:
        last = len(self._batch.steps) - 1  # after the last exposure: the end of the sequence
        step = self._batch.steps[min(self._step, last)]
        lead_us = (
            self._timing.light_lead_us + self._timing.gap_us + self._timing.ready_timeout_ms * 1000
        )
        due_s = (step.settle_us + step.exposure_us + lead_us) / US_PER_S + self._readout_s
        try:
            return self._device.events(due_s + MARGIN_S)
        except DeviceTimeout as error:
            status = self._device.status()
            name = self._batch.requests[min(self._step, last)].key
            if status.sequence is SequenceState.IDLE:
                raise DeviceError(
                    f"The device ended the sequence before {name} without saying why.",
                    hint=_KEPT,
                ) from error
            if not status.camera_ready:
                raise CameraError(
                    f"The camera stalled: it does not get ready for {name}.",
                    hint=f"Check its cable, supply and trigger mode. {_KEPT}",
                ) from error
            raise DeviceError(
                f"The device stalled: no exposure of {name} within {due_s + MARGIN_S:.1f} s "
                f"(it says {status.sequence.name}).",
                hint=_KEPT,
            ) from error

    def _heed(self, event: SequenceEvent) -> None:
        if event.news is SequenceNews.STARTED:
            self._started = True
        elif event.news in (SequenceNews.PAUSED, SequenceNews.FINISHED):
            self._stopped_at = event.exposures
            if event.exposures < self._count or (
                event.news is SequenceNews.FINISHED and event.exposures != self._batch.exposures
            ):
                raise DeviceError(
                    f"The device counts {event.exposures} exposures, the host has {self._count}.",
                    hint=_KEPT,
                )
        elif event.news is SequenceNews.ABORTED:
            raise DeviceError(
                f"The sequence was aborted after {event.exposures} exposures.",
                hint=f"Another program or a person stopped it. {_KEPT}",
            )

    def _pair(self, event: ExposureEvent) -> Exposure:
        if self._step == len(self._batch.steps):
            raise DeviceError(
                f"The device made more exposures than the {self._count} of the table.", hint=_KEPT
            )
        step, name = self._batch.steps[self._step], self._batch.requests[self._step].key
        for what, found, expected in (
            ("table", event.table_hash, self._table_hash),
            ("sequence", event.run_id, self._run_id),
            ("exposure number", event.index, self._count),
            ("step", event.step, self._step),
            ("repeat", event.repeat, self._repeat),
            ("aperture slot", event.aperture, step.aperture),
            ("light slot", event.light, step.light),
            ("exposure time (us)", event.exposure_us, step.exposure_us),
        ):
            if found != expected:
                raise DeviceError(
                    f"The device confirmed {what} {found} instead of {expected} for {name}.",
                    hint=f"The image was not stored. {_KEPT}",
                )
        if event.settle_waited_us < step.settle_us:
            raise DeviceError(
                f"The device waited {event.settle_waited_us} us instead of {step.settle_us} us before {name}.",
                hint=f"The image was not stored. {_KEPT}",
            )
        exposure = Exposure(self._step, self._repeat, event, self._next_frame(name))
        self._count += 1
        self._repeat += 1
        if self._repeat == step.repeat:
            self._step, self._repeat = self._step + 1, 0
        return exposure

    def _next_frame(self, name: str) -> Frame:
        step = self._batch.steps[self._step]
        timeout_s = step.exposure_us / US_PER_S + self._readout_s + MARGIN_S
        try:
            frame = self._camera.next_frame(timeout_s)
        except CameraTimeout as error:
            raise CameraError(
                f"The camera stalled: the frame of exposure {self._count} ({name}) did not come within "
                f"{timeout_s:.1f} s; {self._camera.dropped} frames were lost.",
                hint=f"Check its cable, its trigger mode and the load of this computer. {_KEPT}",
            ) from error
        if frame.frame_id != self._count:
            happened = "lost a frame" if frame.frame_id > self._count else "gave a frame twice"
            raise CameraError(
                f"The camera {happened}: number {frame.frame_id} came instead of {self._count} ({name}); "
                f"{self._camera.dropped} frames were lost.",
                hint=f"Check its cable and the load of this computer. {_KEPT}",
            )
        return frame


def _fault(event: FaultEvent) -> ReliefscopeError:
    """The error of a fault, with the part that is to blame."""
    hint = f"{event.reason.cause} {event.reason.next_step} {_KEPT}"
    if event.reason in (FaultReason.CAMERA_NOT_READY, FaultReason.CAMERA_NO_STROBE):
        message = f"The camera stalled at step {event.step}: {event.reason.description}"
        return CameraError(message, hint=hint)
    message = f"The device stopped itself at step {event.step}: {event.reason.description}"
    return DeviceError(message, hint=hint)
