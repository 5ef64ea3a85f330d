"""The paper's figures of planetary simulants (Figs. 10 to 12) on simulated samples."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from reliefscope.dataset import Run
from reliefscope.errors import InvalidInputError
from reliefscope.jobs import Job, ensure_job
from reliefscope.microscope.demonstration import demo_url
from reliefscope.microscope.experiments.runs import result_of, run_of
from reliefscope.microscope.instruments import DEFAULT_PROFILE
from reliefscope.microscope.places import fresh_path
from reliefscope.microscope.reconstructing import DEFAULT_METHOD
from reliefscope.report.simulant import simulant_figure
from reliefscope.units import FloatImage

SIMULANTS = {
    "ds1": "Asteroid simulant DS-1-CR-1",
    "mars1": "Martian simulant JSC Mars-1",
    "jsc1a": "Lunar simulant JSC-1A",
}
"""Option ``simulant`` of the scene ``regolith`` and what it stands for."""


@dataclass(frozen=True, slots=True)
class SimulantFigure:
    """One simulant: its run, what was found, and its figure."""

    name: str
    run: Path
    figure: Path
    facts: dict[str, Any]

    def as_dict(self) -> dict[str, Any]:
        """For ``--json``."""
        return {
            "name": self.name,
            "run": str(self.run),
            "figure": str(self.figure),
            "summary": self.facts,
        }


def simulant_figures(
    out: Path | str | None = None,
    *,
    simulants: Iterable[str] = tuple(SIMULANTS),
    method: str = DEFAULT_METHOD,
    size: tuple[int, int] | None = None,
    seed: int = 1,
    job: Job | None = None,
) -> list[SimulantFigure]:
    """Measure simulated simulants and draw each as the paper does: micrograph, oblique view, height, slant.

    Parameters
    ----------
    out:
        Folder for everything; ``runs/simulants-001`` and so on if left out.  Runs and results that it holds already,
        under ``SIMULANT`` and its ``results/METHOD``, are used as they are.
    simulants, seed:
        Which samples, and the seed that draws them.
    method:
        Method of reconstruction.
    size:
        (columns, rows) of the camera's central region; all of it if left out.
    job:
        Receives progress; may cancel.

    Raises
    ------
    InvalidInputError
        There is no such simulant or method.
    DatasetError
        Something could not be written.
    """
    simulants = tuple(simulants)
    unknown = [name for name in simulants if name not in SIMULANTS]
    if unknown or not simulants:
        raise InvalidInputError(
            f"There is no simulant `{unknown[0]}`." if unknown else "No simulant was named.",
            hint=f"Use some of: {', '.join(SIMULANTS)}.",
        )
    job = ensure_job(job)
    folder = fresh_path("simulants") if out is None else Path(out)
    figures = []
    for name in simulants:
        url = f"{demo_url(DEFAULT_PROFILE, 'regolith', None, seed, size)}&scene.simulant={name}"
        run = run_of(url, folder / name, SIMULANTS[name], job)
        result = result_of(run, method, job)
        figure = simulant_figure(
            result, _colours(run.data), SIMULANTS[name], folder / f"{name}.jpg"
        )
        figures.append(SimulantFigure(name, run.path, figure, result.summary()))
    return figures


def _colours(run: Run) -> FloatImage | None:
    """The centre frame (H, W, 3) in the camera's colours; white where a pixel or one beside it is saturated.

    There the leakage is subtracted from counts that no longer rise with the light, which leaves false colours.
    """
    if not run.has("centre"):
        return None
    colours = run.rgb("centre", None, None)
    full = run.spec.frame.full_scale * run.record("centre", None, None).accumulated
    saturated = (run.raw("centre", None, None) >= full).astype(np.uint8)
    colours[cv2.dilate(saturated, np.ones((5, 5), np.uint8)) > 0] = colours.max()
    return colours
