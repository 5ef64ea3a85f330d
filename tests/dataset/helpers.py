"""Small runs for the tests of the dataset."""

from pathlib import Path

import numpy as np

from reliefscope.dataset import (
    AcquiredSpec,
    Confirmed,
    FrameFormat,
    FrameRecord,
    Run,
    RunSpec,
    RunWriter,
)
from reliefscope.models.calibration import Calibration
from reliefscope.models.instrument import InstrumentProfile, load_profile
from reliefscope.models.plan import FrameRequest, Plan, default_plan
from reliefscope.units import RawImage

ROWS, COLUMNS = 24, 32


def small_profile(**camera: object) -> InstrumentProfile:
    profile = load_profile("benchtop").resized(COLUMNS, ROWS)
    return profile.model_copy(update={"camera": profile.camera.model_copy(update=camera)})


def small_plan(profile: InstrumentProfile, **changes: object) -> Plan:
    plan = default_plan(profile)
    return plan.model_copy(update={"views": plan.views[:3], "lights": plan.lights[:2], **changes})


def small_spec(profile: InstrumentProfile | None = None, plan: Plan | None = None) -> RunSpec:
    profile = profile or small_profile()
    plan = plan or small_plan(profile)
    camera = profile.camera
    return RunSpec(
        created="2026-01-01T00:00:00+00:00",
        software="reliefscope test",
        sample="probe",
        frame=FrameFormat(
            rows=camera.rows,
            columns=camera.columns,
            sensor=camera.sensor,
            bit_depth=camera.bit_depth,
            black_level=camera.black_level,
        ),
        acquired=AcquiredSpec(
            plan=plan,
            profile=profile,
            calibration=Calibration.nominal(profile),
            camera_exposure_us=plan.exposure_us,
            camera_gain_db=0.0,
        ),
    )


def pixels(request: FrameRequest, spec: RunSpec, seed: int = 0) -> RawImage:
    """Counts that differ from frame to frame, the same for the same frame."""
    key = [
        {"view": 0, "centre": 1, "dark": 2, "leakage": 3}[request.kind],
        -1 if request.view is None else request.view,
        -1 if request.light is None else request.light,
    ]
    rng = np.random.default_rng([seed, *(value + 1 for value in key)])
    top = spec.frame.full_scale * request.accumulate
    counts = rng.integers(0, top, spec.frame.shape, endpoint=True)
    return counts.astype(spec.frame.dtype(request.accumulate))


def record(request: FrameRequest, **changes: object) -> FrameRecord:
    fields: dict[str, object] = {
        "kind": request.kind,
        "view": request.view,
        "light": request.light,
        "accumulated": request.accumulate,
        "exposure_us": 20000,
        "confirmed": Confirmed(
            aperture_slot=1, aperture_sha256="0" * 64, open_pixels=9, light_slot=2, levels={3: 4095}
        ),
        "device_time_us": 1234567,
        "settle_waited_us": 400_000,
        "frame_ids": tuple(range(request.accumulate)),
        "time": "2026-01-01T00:00:00+00:00",
    }
    return FrameRecord.model_validate(fields | changes)


def fill(writer: RunWriter, limit: int | None = None, seed: int = 0) -> None:
    for request in writer.missing()[:limit]:
        writer.put(record(request), pixels(request, writer.spec, seed))


def make_run(path: Path, spec: RunSpec | None = None) -> Run:
    spec = spec or small_spec()
    with RunWriter.create(path, spec) as writer:
        fill(writer)
        return Run.open(writer.finish())
