"""The z scale of an instrument, from a flat target on a stage at known heights (paper, section IV.A)."""

from __future__ import annotations

import datetime
import json
from collections.abc import Callable, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from reliefscope.calibration.store import CalibrationStore
from reliefscope.calibration.z_scale import (
    ZScale,
    common_calibration,
    fit_z_scale,
    measure_height,
)
from reliefscope.errors import DatasetError, InvalidInputError, OutputExistsError
from reliefscope.jobs import Job, ensure_job
from reliefscope.microscope.experiments.z_figure import plot_z_scale
from reliefscope.microscope.live import Microscope
from reliefscope.microscope.places import fresh_path
from reliefscope.microscope.stored import StoredRun, open_run
from reliefscope.models.calibration import Calibration
from reliefscope.models.instrument import InstrumentProfile
from reliefscope.models.plan import Light, Plan, pattern_apertures

STAGE_FIELD = "{stage_um}"
"""What an address holds where the stage moves by itself; it stands for the height in um."""
SCHEMA_VERSION = 1
_LEDS = 4
"""A flat target needs light from several sides, not every LED; together they shine as bright as two."""
_SETTLE_FACTOR = 2.0
"""Each view has one frame only, taken right after the glass has switched: what is left of the view before would pull
its direction toward that one, by a few parts in a thousand after the usual wait."""

MoveStage = Callable[[float], None]
"""Has the stage moved to a height in um, and returns when it stands there."""


@dataclass(frozen=True, slots=True)
class ZCalibration:
    """What was measured, the calibration that follows, and where it lies."""

    fit: ZScale
    peaks: tuple[float, ...]
    """Mean NCC over the whole image at each height."""
    calibration: Calibration
    folder: Path
    stored: Path | None
    """Where later runs of this instrument find it; None where it was not stored."""

    def as_dict(self) -> dict[str, Any]:
        """For ``--json``."""
        fit = self.fit
        steps = zip(fit.stage_um, fit.measured_um, fit.residual_um, self.peaks, strict=True)
        return {
            "schema_version": SCHEMA_VERSION,
            **fit.facts(),
            "steps": [
                {
                    "stage_um": round(float(stage), 3),
                    "measured_um": round(float(measured), 3),
                    "residual_um": round(float(residual), 3),
                    "peak": round(peak, 4),
                }
                for stage, measured, residual, peak in steps
            ],
            "results": str(self.folder),
            "stored": None if self.stored is None else str(self.stored),
        }


def stage_plan(profile: InstrumentProfile) -> Plan:
    """What a flat target needs: every view of the pattern under a few LEDs together."""
    count = profile.dome.count
    level = round(profile.dome.full_level * min(1.0, 2 / min(count, _LEDS)))
    lit = range(0, count, max(1, count // _LEDS))
    return Plan(
        views=pattern_apertures(profile),
        lights=(Light(name="several", levels=dict.fromkeys(lit, level)),),
        exposure_us=round(profile.exposure_ms * 1000),
        settle_ms=_SETTLE_FACTOR * profile.glass.settle_ms,
    )


def take_z_stage(
    device: str,
    heights_um: Sequence[float],
    out: Path | str | None = None,
    *,
    camera: str | None = None,
    profile: InstrumentProfile | str | None = None,
    calibration: Calibration | Path | str | None = None,
    move: MoveStage | None = None,
    job: Job | None = None,
) -> dict[Path, float]:
    """Take a run of the target at each height; run -> height in um.

    Parameters
    ----------
    device:
        Address of the instrument.  Where it holds ``{stage_um}`` the instrument moves the stage: it is opened
        at each height under the address with the height in that place.
    heights_um:
        Readings of the stage, growing toward the objective.
    out:
        New folder for the runs; ``runs/z-calibration-001`` and so on if left out.
    camera, profile, calibration:
        See :meth:`Microscope.open`.
    move:
        Where the address holds no ``{stage_um}``: called before each run.
    job:
        Receives progress; may cancel.

    Raises
    ------
    InvalidInputError
        Nobody moves the stage, or there are fewer than three heights.
    OutputExistsError
        ``out`` exists.
    """
    moves_itself = STAGE_FIELD in device
    if not moves_itself and move is None:
        raise InvalidInputError(
            f"Nobody moves the stage under {device}.",
            hint="Run this on a terminal, where it asks for each height; or give runs that were taken, as RUN=UM; "
            f"or, where the instrument has a stage, write {STAGE_FIELD} in its address.",
        )
    if len(set(heights_um)) < 3:
        raise InvalidInputError(
            f"{len(set(heights_um))} heights do not make a line.",
            hint="Take at least three, for example `--from-um -50 --to-um 50 --step-um 10`.",
        )
    folder = fresh_path("z-calibration") if out is None else Path(out)
    if folder.exists():
        raise OutputExistsError(
            f"{folder} exists already; nothing was changed.", hint="Give `--out` another name."
        )

    def opened_at(height_um: float) -> Microscope:
        at = f"{height_um:g}"
        seen = None if camera is None else camera.replace(STAGE_FIELD, at)
        return Microscope.open(
            device.replace(STAGE_FIELD, at), seen, profile=profile, calibration=calibration
        )

    runs: dict[Path, float] = {}
    with (
        ExitStack() as held,
        ensure_job(job).stage("heights of the stage", len(heights_um)) as stage,
    ):
        instrument = None if moves_itself else held.enter_context(opened_at(heights_um[0]))
        for height_um in heights_um:
            if instrument is None:
                with opened_at(height_um) as lifted:
                    run = _take(lifted, folder, height_um, job)
            else:
                assert move is not None  # refused above
                move(height_um)
                run = _take(instrument, folder, height_um, job)
            runs[run.path] = height_um
            stage.advance(note=f"{height_um:g} um")
    return runs


def _take(instrument: Microscope, folder: Path, height_um: float, job: Job | None) -> StoredRun:
    return instrument.acquire(
        stage_plan(instrument.profile),
        folder / f"stage{height_um:+07.1f}um",
        job=job,
        sample="target for the z calibration",
        notes=f"stage at {height_um:g} um",
    )


def calibrate_z(
    runs: Mapping[Path, float],
    out: Path | str | None = None,
    *,
    store: CalibrationStore | None = None,
    keep: bool = True,
    job: Job | None = None,
) -> ZCalibration:
    """Find the z scale from runs of a flat target, and write the calibration, its figures and a plot.

    Parameters
    ----------
    runs:
        Run -> reading of the stage in um.
    out:
        Folder for ``calibration.json``, ``z_scale.json`` and ``z_scale.png``; that of the runs if left out.
    store:
        Where the calibration is stored; the user's own if left out.
    keep:
        Whether to store it, so that later runs of this instrument use it.
    job:
        Receives progress; may cancel.

    Raises
    ------
    InvalidInputError
        The runs do not show a flat target that follows the stage, or come from different instruments.
    """
    ordered = sorted(runs.items(), key=lambda item: item[1])
    opened = [open_run(path).data for path, _ in ordered]
    if not opened:
        raise InvalidInputError(
            "There is no run to calibrate with.", hint="Give runs as RUN=UM, or an instrument."
        )
    calibration = common_calibration(opened)
    serials = {
        session.device.get("serial_number", "")
        for run in opened
        if run.spec.acquired is not None
        for session in run.spec.acquired.sessions
    }
    if len(serials) > 1:
        raise InvalidInputError(
            f"The runs come from several instruments ({', '.join(sorted(serials))}).",
            hint="Calibrate each with its own runs.",
        )
    job = ensure_job(job)
    with job.stage("measure heights", len(opened)) as stage:
        matches = []
        for run in opened:
            matches.append(measure_height(run))
            stage.advance(note=run.name)
    fit = fit_z_scale(
        [height for _, height in ordered],
        [match.height_um for match in matches],
        calibration.pupil_scale,
    )
    created = datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds")
    better = fit.calibrated(calibration, created)
    folder = opened[0].path.parent if out is None else Path(out)
    stored = (
        (store or CalibrationStore()).save(better, serials.pop() if serials else "")
        if keep
        else None
    )
    found = ZCalibration(fit, tuple(match.peak for match in matches), better, folder, stored)
    _write(found)
    return found


def _write(found: ZCalibration) -> None:
    folder = found.folder
    try:
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "calibration.json").write_text(
            found.calibration.model_dump_json(indent=2), encoding="utf-8"
        )
        (folder / "z_scale.json").write_text(
            json.dumps(found.as_dict(), indent=2), encoding="utf-8"
        )
    except OSError as error:
        raise DatasetError(
            f"The calibration could not be written to {folder}: {error.strerror or error}.",
            hint="Give another folder with `--out`.",
        ) from error
    plot_z_scale(found.fit, folder / "z_scale.png")
