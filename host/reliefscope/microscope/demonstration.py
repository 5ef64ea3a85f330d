"""The demonstration: from a simulated instrument to a measured surface, with the paper's table."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import urlencode

from reliefscope.errors import InvalidInputError
from reliefscope.evaluation import PAPER_TABLE_I, TableRow
from reliefscope.jobs import Job, ensure_job
from reliefscope.microscope.evaluating import Evaluation
from reliefscope.microscope.instruments import DEFAULT_PROFILE, DEFAULT_SCENE, DEMO_SCHEME
from reliefscope.microscope.live import Microscope
from reliefscope.microscope.places import fresh_path
from reliefscope.microscope.reconstructing import DEFAULT_METHOD, Outcome
from reliefscope.models.instrument import builtin_profiles, load_profile


@dataclass(frozen=True, slots=True)
class DemoResult:
    """What a demonstration measured, how long each part took, and where everything lies."""

    run: Path
    outcome: Outcome
    evaluation: Evaluation | None
    """None for a scene without a known true shape."""
    stages_s: Mapping[str, float]
    total_s: float
    device: str
    method: str
    seed: int

    @property
    def table(self) -> Sequence[TableRow]:
        """Rows of the evaluation; empty where there is none."""
        return () if self.evaluation is None else self.evaluation.table

    def as_dict(self) -> dict[str, Any]:
        """For ``--json``."""
        return {
            "device": self.device,
            "method": self.method,
            "seed": self.seed,
            "run": str(self.run),
            "results": str(self.outcome.folder),
            "pictures": [str(picture) for picture in self.outcome.pictures],
            "table": list(self.table),
            "paper_table_um": dict(PAPER_TABLE_I),
            "whole_fiducial": self.evaluation is not None and self.evaluation.whole,
            "stages_s": {stage: round(spent, 3) for stage, spent in self.stages_s.items()},
            "total_s": round(self.total_s, 3),
        }


def demo_url(
    profile: str, scene: str, finish: str | None, seed: int, size: tuple[int, int] | None
) -> str:
    """Address of the instrument that a demonstration uses; ``size`` is (columns, rows)."""
    options: dict[str, object] = {"scene": scene, "seed": seed}
    name = profile
    if profile not in builtin_profiles():
        load_profile(profile)  # refuses what is neither a name nor a file
        name, options["profile"] = "demo", profile
    if finish is not None:
        options["finish"] = finish
    if size is not None:
        options["size"] = f"{size[0]}x{size[1]}"
    return f"{DEMO_SCHEME}://{name}?{urlencode(options)}"


def demo(
    out: Path | str | None = None,
    *,
    size: tuple[int, int] | None = None,
    scene: str = DEFAULT_SCENE,
    finish: str | None = None,
    seed: int = 1,
    profile: str = DEFAULT_PROFILE,
    method: str = DEFAULT_METHOD,
    beside: str | None = None,
    job: Job | None = None,
) -> DemoResult:
    """Acquire, reconstruct, evaluate and draw, on a simulated instrument.

    Parameters
    ----------
    out:
        Folder of the new run; ``runs/demo-001`` and so on if left out.
    size:
        (columns, rows) of the camera's central region; all of it if left out.
    scene, finish, seed:
        What lies under the objective, and the seed of it and of the noise.
    profile, method:
        Instrument to simulate, method of reconstruction.
    beside:
        Another method than ``method``, whose result and errors are told beside.
    job:
        Receives progress; may cancel.

    Raises
    ------
    InvalidInputError
        If there is no such scene, finish, profile or method, or ``beside`` is ``method``; nothing was made.
    """
    from reliefscope.reconstruction.settings import settings_for

    job = ensure_job(job)
    if beside == method:
        raise InvalidInputError(
            f"`{method}` beside itself shows nothing.",
            hint="Name another method to compare it with, or leave `--beside` out.",
        )
    methods = [method] if beside is None else [method, beside]
    for name in methods:
        settings_for(name)  # refuse a wrong name before anything is taken
    url = demo_url(profile, scene, finish, seed, size)
    place = fresh_path("demo") if out is None else Path(out)
    started = time.perf_counter()
    stages: dict[str, float] = {}
    with Microscope.open(url) as microscope:
        stages["open"] = time.perf_counter() - started
        begun = time.perf_counter()
        sample = f"{scene} ({finish})" if finish else scene
        run = microscope.acquire(out=place, job=job, sample=sample, notes=f"demonstration, {url}")
        stages["acquire"] = time.perf_counter() - begun
    outcome, *others = [
        run.reconstruct(method=name, pictures=name == method, job=job) for name in methods
    ]
    stages.update(outcome.stages_s)
    stages.update({f"method {other.name}": other.total_s for other in others})
    evaluation: Evaluation | None = None
    if scene == DEFAULT_SCENE:
        begun = time.perf_counter()
        evaluation = run.evaluate(job=job)
        stages["evaluate"] = time.perf_counter() - begun
    return DemoResult(
        run=run.path,
        outcome=outcome,
        evaluation=evaluation,
        stages_s=stages,
        total_s=time.perf_counter() - started,
        device=url,
        method=method,
        seed=seed,
    )
