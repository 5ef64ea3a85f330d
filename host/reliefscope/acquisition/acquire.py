"""From plan to run: preflight, tables, pairing, storing; and going on where a run stopped."""

from __future__ import annotations

import contextlib
import itertools
import logging
import math
import secrets
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from reliefscope.acquisition.batches import Batch, Capacity, make_batches
from reliefscope.acquisition.pairing import Exposure, Pairing
from reliefscope.acquisition.preflight import (
    check_camera,
    check_device,
    check_plan,
    configure_camera,
    frame_format,
)
from reliefscope.acquisition.resuming import resumable
from reliefscope.acquisition.storing import DiskThread
from reliefscope.camera import RecordedCamera
from reliefscope.dataset import (
    AcquiredSpec,
    FrameFormat,
    FrameRecord,
    Run,
    RunSpec,
    RunWriter,
    Session,
)
from reliefscope.dataset.durable import disk_error
from reliefscope.dataset.writer import check_output, host_identity, now, software_name
from reliefscope.device import Device, SequenceState, SequenceTiming
from reliefscope.errors import (
    CameraError,
    Cancelled,
    InvalidInputError,
    ReliefscopeError,
)
from reliefscope.jobs import Job, Stage, ensure_job
from reliefscope.models.calibration import Calibration
from reliefscope.models.camera import Camera, CameraInfo
from reliefscope.models.instrument import InstrumentProfile
from reliefscope.models.plan import Light, Plan
from reliefscope.protocol.messages import Capability, FaultReason
from reliefscope.units import US_PER_S, RawImage, format_duration

log = logging.getLogger(__name__)

WIRE_LOGS = "wire-*.jsonl"
"""Files in a run's folder with what passed between host and instrument, one for each session."""
DEADLINE_FACTOR, DEADLINE_SPARE_S = 2.0, 60.0
"""The device gives a sequence this much longer than planned: it also waits while the host is behind."""


def acquire(
    device: Device,
    camera: Camera,
    plan: Plan,
    profile: InstrumentProfile,
    calibration: Calibration,
    out: Path,
    job: Job | None = None,
    *,
    sample: str = "",
    notes: str = "",
) -> Run:
    """Take every image of ``plan`` into the run ``out``.

    Everything that can be checked is checked before the instrument moves and before a file is written.  A
    request to stop pauses after the exposure under way, turns the light off, keeps what is complete, and
    raises :class:`Cancelled`; :func:`resume` goes on from there, as it does after any error.  The LEDs are off
    when this returns, however it ends.

    Raises
    ------
    InvalidInputError
        If plan, profile, calibration, device and camera do not fit together.
    OutputExistsError, DatasetError
        If the place is taken, too small, or the disk fails.
    DeviceError, CameraError
        If one of them stalls, fails, or confirms something else than the plan says.
    Cancelled
        On request.
    """
    check_plan(plan, profile, calibration)
    check_camera(camera.info, profile)
    check_device(device, plan)
    camera = RecordedCamera(camera, device.log.note_camera)
    spec = RunSpec(
        created=now(),
        software=software_name(),
        sample=sample,
        notes=notes,
        frame=frame_format(profile),
        acquired=AcquiredSpec(
            plan=plan,
            profile=profile,
            calibration=calibration,
            camera_exposure_us=plan.exposure_us,
            camera_gain_db=plan.gain_db,
        ),
    )
    check_output(out, spec.storage_bytes())
    acquired = spec.acquired
    assert acquired is not None  # set just above
    settings = configure_camera(camera, plan)
    acquired = acquired.model_copy(
        update={
            "camera_exposure_us": settings.exposure_us,
            "camera_gain_db": settings.gain_db,
            "sessions": (_session(device, camera.info),),
        }
    )
    spec = spec.model_copy(update={"acquired": acquired})
    with resumable(out), RunWriter.create(out, spec) as writer:
        return _take(writer, device, camera, ensure_job(job))


def resume(run: Path, device: Device, camera: Camera, job: Job | None = None) -> Run:
    """Take what is missing of a run: images never taken, and those whose pixels are damaged.

    Raises
    ------
    InvalidInputError
        If this is another instrument than the one that began the run, or the run was imported.
    DatasetError, DeviceError, CameraError, Cancelled
        As for :func:`acquire`.
    """
    job = ensure_job(job)
    with resumable(run), RunWriter.resume(run, job) as writer:
        acquired = writer.spec.acquired
        if acquired is None:
            raise InvalidInputError(
                f"{writer.folder} was imported; there is nothing to acquire.",
                hint="Import the photographs again under another name.",
            )
        if not writer.missing():
            return Run.open(writer.finish(job))
        check_camera(camera.info, acquired.profile, resuming=True)
        check_device(device, acquired.plan)
        camera = RecordedCamera(camera, device.log.note_camera)
        session = _session(device, camera.info)
        _check_same_instrument(acquired.sessions[0], session)
        settings = configure_camera(camera, acquired.plan)
        if settings.exposure_us != acquired.camera_exposure_us:
            raise CameraError(
                f"The camera exposes for {settings.exposure_us} us now, {acquired.camera_exposure_us} us "
                "when the run began.",
                hint="Begin a new run.",
            )
        sessions = (*acquired.sessions, session)
        writer.set_spec(
            writer.spec.model_copy(
                update={"acquired": acquired.model_copy(update={"sessions": sessions})}
            )
        )
        return _take(writer, device, camera, job)


def _take(writer: RunWriter, device: Device, camera: Camera, job: Job) -> Run:
    acquired = writer.spec.acquired
    assert acquired is not None  # both callers made sure
    identity = device.identity
    capacity = Capacity(identity.aperture_slots, identity.light_slots, identity.steps)
    plan, camera_model = acquired.plan, acquired.profile.camera
    requests = writer.missing()
    batches = make_batches(requests, plan, capacity, acquired.camera_exposure_us)
    readout_s = 1 / camera_model.frames_per_s
    timing = _timing(identity.capabilities, readout_s)
    total = sum(batch.exposures for batch in batches)
    times_s = [_step_times_s(batch, timing, readout_s) for batch in batches]
    left_s = _time_left(times_s)
    # The light goes off before what is still in memory is stored, and the log has all of it.
    with (
        _wire_log(device, writer.folder),
        job.stage("acquire", total) as stage,
        DiskThread(writer) as disk,
        _lights_off_afterwards(device, camera),
    ):
        _make_idle(device)
        for batch, step_times_s in zip(batches, times_s, strict=True):
            run_id = secrets.randbelow(0xFFFF_FFFF) + 1
            table_hash = _load(device, batch, identity.leds)
            camera.arm()
            deadline_s = DEADLINE_FACTOR * sum(step_times_s) + DEADLINE_SPARE_S
            device.start(run_id, timing=timing, deadline_s=deadline_s)
            pairing = Pairing(device, camera, batch, table_hash, run_id, timing, readout_s)
            _collect(pairing, batch, disk, stage, writer.spec.frame, left_s)
            camera.disarm()
    return Run.open(writer.finish(job))


def _collect(
    pairing: Pairing,
    batch: Batch,
    disk: DiskThread,
    stage: Stage,
    frame: FrameFormat,
    left_s: Iterator[float],
) -> None:
    """Take a batch that was started, image by image; stops between two exposures when asked to."""
    stopping: Cancelled | None = None
    members: list[Exposure] = []
    total: RawImage | None = None
    while (exposure := pairing.next()) is not None:
        request = batch.requests[exposure.step]
        raw = exposure.frame.raw
        _check_counts(raw, frame, request.key)
        if exposure.repeat == 0:
            members, total = [], raw.astype(frame.dtype(request.accumulate))
        else:
            assert total is not None  # the pairing counts repeats from 0
            np.add(total, raw, out=total, casting="unsafe")
        members.append(exposure)
        if len(members) < request.accumulate:
            continue
        assert total is not None  # set with the first member
        disk.put(_record(batch, members), total)
        note = f"{request.key}, {format_duration(next(left_s))} of the device's time left"
        try:
            stage.advance(request.accumulate, note)
        except Cancelled as cancelled:
            if stopping is None:
                stopping = cancelled
                pairing.stop()
    if stopping is not None:
        raise stopping


def _record(batch: Batch, members: list[Exposure]) -> FrameRecord:
    first = members[0]
    request = batch.requests[first.step]
    return FrameRecord(
        kind=request.kind,
        view=request.view,
        light=request.light,
        accumulated=len(members),
        exposure_us=first.frame.exposure_us,
        confirmed=batch.confirmed(first.step),
        device_time_us=first.event.start_us,
        settle_waited_us=min(member.event.settle_waited_us for member in members),
        frame_ids=tuple(member.frame.frame_id for member in members),
        time=now(),
    )


def _check_counts(raw: RawImage, frame: FrameFormat, name: str) -> None:
    if raw.shape != frame.shape or raw.dtype.kind != "u":
        raise CameraError(
            f"The camera gave a frame of {raw.dtype} {raw.shape} for {name} instead of {frame.shape}.",
            hint="Its region or pixel format was changed; set it back and resume the run.",
        )
    if int(raw.max()) > frame.full_scale:
        raise CameraError(
            f"The frame of {name} holds counts up to {int(raw.max())}; {frame.bit_depth} bits reach "
            f"{frame.full_scale}.",
            hint="Correct `bit_depth` in the profile, or the camera's pixel format.",
        )


def _load(device: Device, batch: Batch, leds: int) -> int:
    for slot, aperture in enumerate(batch.apertures):
        device.load_aperture(slot, aperture.bitmap)
    for slot, light in enumerate(batch.lights):
        device.load_light(slot, _levels(light, leds))
    return device.load_steps(batch.steps)


def _levels(light: Light, leds: int) -> list[int]:
    return [light.levels.get(led, 0) for led in range(leds)]


def _timing(capabilities: Capability, readout_s: float) -> SequenceTiming:
    """With the camera's ready line the device waits for it; without, the gap covers the readout."""
    default = SequenceTiming()
    strobe = Capability.STROBE in capabilities
    if Capability.READY in capabilities:
        return SequenceTiming(require_strobe=strobe)
    gap_us = default.gap_us + math.ceil(readout_s * US_PER_S)
    return SequenceTiming(gap_us=gap_us, ready_timeout_ms=0, require_strobe=strobe)


def _step_times_s(batch: Batch, timing: SequenceTiming, readout_s: float) -> list[float]:
    """Seconds of device time that each step of a batch takes."""
    per_exposure_us = timing.light_lead_us + max(timing.gap_us, round(readout_s * US_PER_S))
    return [
        (step.settle_us + step.repeat * (step.exposure_us + per_exposure_us)) / US_PER_S
        for step in batch.steps
    ]


def _time_left(times_s: list[list[float]]) -> Iterator[float]:
    """Seconds of device time that are left after each image."""
    left_s = sum(sum(batch) for batch in times_s)
    for spent_s in itertools.chain.from_iterable(times_s):
        left_s -= spent_s
        yield max(left_s, 0.0)


def _make_idle(device: Device) -> None:
    """End what an earlier host left behind: a sequence under way, a latched fault."""
    status = device.status()
    if status.sequence is not SequenceState.IDLE:
        log.warning("a sequence of another session was under way; it was ended")
        device.abort()
    if status.fault is not FaultReason.NONE:
        log.warning("the device had stopped itself before: %s", status.fault.description)
        device.clear_fault(status.fault)


@contextlib.contextmanager
def _wire_log(device: Device, folder: Path) -> Iterator[None]:
    """Keep what passes between host and instrument beside the frames, a file for each session."""
    number = 1 + len(list(folder.glob(WIRE_LOGS)))
    path = folder / WIRE_LOGS.replace("*", f"{number:02d}")
    with contextlib.ExitStack() as files:
        try:
            files.enter_context(device.log.written_to(path))
        except OSError as error:
            raise disk_error(error, path) from error
        yield


@contextlib.contextmanager
def _lights_off_afterwards(device: Device, camera: Camera) -> Iterator[None]:
    """Sequence ended, LEDs off and camera disarmed on every way out; errors on the way do not hide the first."""
    try:
        yield
    except BaseException:
        for step in (device.abort, device.all_off, camera.disarm):
            try:
                step()
            except ReliefscopeError as error:
                log.warning("while stopping: %s", error.message)
        raise
    device.all_off()


def _session(device: Device, info: CameraInfo) -> Session:
    identity = device.identity
    return Session(
        started=now(),
        host=host_identity(),
        device={
            "url": device.url,
            "board": identity.board,
            "serial_number": identity.serial_number,
            "firmware_version": identity.firmware_version,
            "git_hash": identity.git_hash,
            "schema_hash": identity.schema_hash.hex(),
        },
        camera={"vendor": info.vendor, "model": info.model, "serial": info.serial},
    )


def _check_same_instrument(first: Session, now_there: Session) -> None:
    """A run belongs to one device and one camera; their firmware may be newer."""
    for part, before, after in (
        ("device", first.device, now_there.device),
        ("camera", first.camera, now_there.camera),
    ):
        for key in ("board", "serial_number", "vendor", "model", "serial"):
            if before.get(key) != after.get(key):
                raise InvalidInputError(
                    f"The run was begun with the {part} {key} `{before.get(key)}`; "
                    f"`{after.get(key)}` is connected.",
                    hint="Connect the instrument that began the run, or begin a new one.",
                )
