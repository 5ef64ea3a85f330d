"""``reliefscope acquire``: take a run, or go on with one that was interrupted."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from reliefscope.cli.options import (
    CalibrationOption,
    CameraOption,
    DeviceOption,
    JsonFlag,
    ProfileOption,
    ProgressMode,
    ProgressOption,
)
from reliefscope.cli.session import Session, session
from reliefscope.errors import DEFAULT_DEVICE, InvalidInputError

if TYPE_CHECKING:
    from reliefscope.microscope import Microscope, StoredRun
    from reliefscope.models.plan import Plan


def acquire(
    out: Annotated[
        Path | None,
        typer.Option(
            "--out", "-o", help="Folder of the new run; runs/run-001 and so on if left out."
        ),
    ] = None,
    device: DeviceOption = DEFAULT_DEVICE,
    camera: CameraOption = None,
    profile: ProfileOption = None,
    calibration: CalibrationOption = None,
    plan: Annotated[
        Path | None,
        typer.Option("--plan", metavar="FILE", help="Plan to take instead of the profile's own."),
    ] = None,
    exposure_ms: Annotated[
        float | None, typer.Option("--exposure-ms", help="Exposure instead of the plan's.")
    ] = None,
    settle_ms: Annotated[
        float | None,
        typer.Option("--settle-ms", help="Wait after a change of the glass instead of the plan's."),
    ] = None,
    sample: Annotated[str, typer.Option("--sample", help="Name of the sample.")] = "",
    notes: Annotated[
        str, typer.Option("--notes", help="Anything worth keeping with the run.")
    ] = "",
    resume: Annotated[
        Path | None,
        typer.Option(
            "--resume", metavar="RUN", help="Go on with this run: take only what is missing."
        ),
    ] = None,
    dry_run: Annotated[
        bool,
        typer.Option("--dry-run", help="Show what would be taken, and how long; move nothing."),
    ] = False,
    as_json: JsonFlag = False,
    progress: ProgressOption = ProgressMode.AUTO,
) -> None:
    """Take every view under every light, with dark, leakage and centre frames.

    The firmware steps through the plan; every frame is on disk with its checksum before it counts. Ctrl-C
    pauses after the current frame; `--resume RUN` takes what is missing.
    """
    if resume is not None:
        _refuse_with_resume(
            {
                "--out": out,
                "--plan": plan,
                "--exposure-ms": exposure_ms,
                "--settle-ms": settle_ms,
                "--profile": profile,
                "--calibration": calibration,
                "--sample": sample or None,
                "--notes": notes or None,
                "--dry-run": dry_run or None,
            }
        )
    _refuse_durations(exposure_ms, settle_ms)
    with session(progress, as_json=as_json) as this:
        from reliefscope import microscope

        with microscope.Microscope.open(
            device, camera, profile=profile, calibration=calibration
        ) as instrument:
            if resume is not None:
                run = instrument.resume(resume, job=this.job)
            else:
                chosen = _plan(instrument, plan, exposure_ms, settle_ms)
                if dry_run:
                    _show_plan(this, instrument, chosen)
                    return
                run = instrument.acquire(chosen, out, job=this.job, sample=sample, notes=notes)
    _show_run(this, run)


def _refuse_with_resume(others: dict[str, object]) -> None:
    given = [name for name, value in others.items() if value is not None]
    if given:
        raise InvalidInputError(
            f"--resume goes on with a run exactly as it was begun; it does not take {', '.join(given)}.",
            hint="Give --resume RUN alone (with --device and --camera), or begin a new run without it.",
        )


def _refuse_durations(exposure_ms: float | None, settle_ms: float | None) -> None:
    if exposure_ms is not None and not (math.isfinite(exposure_ms) and exposure_ms >= 0.001):
        raise InvalidInputError(
            f"--exposure-ms {exposure_ms:g} is no exposure: it is a time in milliseconds, at least 0.001.",
            hint="Give the milliseconds of one exposure, for example `--exposure-ms 20`.",
        )
    if settle_ms is not None and not (math.isfinite(settle_ms) and settle_ms >= 0):
        raise InvalidInputError(
            f"--settle-ms {settle_ms:g} is no wait: it is a time in milliseconds, at least 0.",
            hint="Give the milliseconds that the glass needs, for example `--settle-ms 400`.",
        )


def _plan(
    instrument: Microscope, path: Path | None, exposure_ms: float | None, settle_ms: float | None
) -> Plan:
    from reliefscope.models.base import load_model, parse_model
    from reliefscope.models.plan import Plan

    plan = instrument.default_plan() if path is None else load_model(Plan, path)
    changes: dict[str, float] = {}
    if exposure_ms is not None:
        changes["exposure_us"] = round(exposure_ms * 1000)
    if settle_ms is not None:
        changes["settle_ms"] = settle_ms
    if not changes:
        return plan
    return parse_model(
        Plan, {**plan.model_dump(mode="json"), **changes}, "The plan of these options"
    )


def _show_plan(this: Session, instrument: Microscope, plan: Plan) -> None:
    from reliefscope.cli.tables import show_facts

    facts = instrument.plan_summary(plan)
    this.result(
        {**facts, "plan": plan.model_dump(mode="json")},
        lambda console: show_facts(console, "What would be taken", facts),
    )


def _show_run(this: Session, run: StoredRun) -> None:
    from reliefscope.cli.tables import show_facts

    facts = run.describe()

    def show(console: object) -> None:
        from rich.console import Console

        assert isinstance(console, Console)
        show_facts(console, "Run", facts)
        console.print(f"Next: [bold]reliefscope reconstruct {run.path}[/]")

    this.result(facts, show)
