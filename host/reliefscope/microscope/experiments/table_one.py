"""Table I of the paper on simulated fiducials: three finishes, two methods, and the reference z-stack."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from reliefscope.dataset.image_stack import ImageStack, open_stack
from reliefscope.errors import DatasetError, InvalidInputError
from reliefscope.evaluation import TableRow, evaluate_fiducial
from reliefscope.evaluation.table_one import FINISHES, Z_STACK, table_markdown
from reliefscope.jobs import Job, ensure_job
from reliefscope.microscope.demonstration import demo_url
from reliefscope.microscope.evaluating import evaluate_run, visible_sections
from reliefscope.microscope.experiments.focus import record_stack
from reliefscope.microscope.experiments.runs import result_of, run_of
from reliefscope.microscope.instruments import DEFAULT_PROFILE, DEFAULT_SCENE
from reliefscope.microscope.places import fresh_path
from reliefscope.models.z_stack import STACK_FILE
from reliefscope.reconstruction.focus_stacking import focus_stack
from reliefscope.reconstruction.result import Reconstruction
from reliefscope.report.panels import Panel, toned, write_panels
from reliefscope.targets import Fiducial3D
from reliefscope.units import FloatImage

METHODS = ("joint", "paper")
SCHEMA_VERSION = 1
_ROOM_UM = 30.0
"""Field of the z-stack beyond the fiducial, so that its edges are seen with their surroundings."""
_ERROR_UM = 20.0
"""Errors of height that the figure tells apart."""


@dataclass(frozen=True, slots=True)
class TableOne:
    """What was measured of each finish, and where it lies."""

    folder: Path
    rows: Mapping[str, Sequence[TableRow]]
    whole: bool
    """Whether the frames show the whole fiducial; only then do the figures compare with the paper's."""
    figure: Path

    @property
    def markdown(self) -> str:
        """The table beside the paper's, after one median offset."""
        return table_markdown(self.rows)

    def as_dict(self) -> dict[str, Any]:
        """For ``--json`` and ``table_one.json``."""
        return {
            "schema_version": SCHEMA_VERSION,
            "rows": {finish: list(rows) for finish, rows in self.rows.items()},
            "whole_fiducial": self.whole,
            "results": str(self.folder),
            "figure": str(self.figure),
        }


def table_one(
    out: Path | str | None = None,
    *,
    finishes: Sequence[str] = FINISHES,
    methods: Sequence[str] = METHODS,
    size: tuple[int, int] | None = None,
    seed: int = 1,
    z_stack: bool = True,
    job: Job | None = None,
) -> TableOne:
    """Measure fiducials of several finishes in several ways, and write table and figure.

    Parameters
    ----------
    out:
        Folder for everything; ``runs/table-one-001`` and so on if left out.  Runs, results and stacks that it holds
        already, under the names given here, are used as they are: ``FINISH``, its ``results/METHOD``, and
        ``FINISH-z-stack``.
    finishes, methods:
        Finishes of the simulated fiducial, methods of reconstruction.
    size:
        (columns, rows) of the camera's central region; all of it if left out.
    seed:
        Seed of scene and noise.
    z_stack:
        Whether to take the reference z-stack as well.
    job:
        Receives progress; may cancel.

    Raises
    ------
    InvalidInputError
        An unknown finish or method, or frames that show no part of the fiducial.
    DatasetError
        Something could not be written.
    """
    from reliefscope.reconstruction.settings import settings_for

    for method in methods:
        settings_for(method)
    if not (finishes and methods):
        raise InvalidInputError(
            "There is nothing to measure.", hint="Name at least one finish and one method."
        )
    job = ensure_job(job)
    folder = fresh_path("table-one") if out is None else Path(out)
    target = Fiducial3D()
    rows: dict[str, list[TableRow]] = {}
    panels: list[Panel] = []
    whole = True
    for finish in finishes:
        url = demo_url(DEFAULT_PROFILE, DEFAULT_SCENE, finish, seed, size)
        run = run_of(url, folder / finish, f"{DEFAULT_SCENE} ({finish})", job)
        results = {method: result_of(run, method, job) for method in methods}
        rows[finish] = []
        for method in methods:
            evaluation = evaluate_run(run, name=method, target=target, job=job)
            rows[finish] += evaluation.table
            whole = whole and evaluation.whole
        first = results[methods[0]]
        panels += _panels(finish, first, target)
        if z_stack:
            stack = _stack(url, folder / f"{finish}-z-stack", target, job)
            height_um, pixel_um = _focused(stack, job)
            shown = visible_sections(target, _shape(height_um), pixel_um)
            rows[finish] += evaluate_fiducial(
                height_um, pixel_um, Z_STACK, target, sections=shown, job=job
            )
            panels += _height_panels(finish, Z_STACK, height_um, pixel_um, target)
    figure = write_panels(panels, folder / "table_one.jpg", columns=len(panels) // len(finishes))
    table = TableOne(folder, rows, whole, figure)
    _write(table)
    return table


def _stack(url: str, place: Path, target: Fiducial3D, job: Job) -> ImageStack:
    if (place / STACK_FILE).is_file():
        return open_stack([place])
    return record_stack(url, place, field_um=target.size_um + _ROOM_UM, job=job)


def _focused(stack: ImageStack, job: Job) -> tuple[FloatImage, float]:
    """Heights by the paper's reference method, on the stack's own pixels."""
    pixel_um = stack.description.pixel_um
    if pixel_um is None:
        raise InvalidInputError(
            f"{stack.folder / STACK_FILE} does not tell the size of a pixel.",
            hint="Write it there as pixel_um.",
        )
    return focus_stack(stack.images(), stack.heights_um, job=job).height_um, pixel_um


def _panels(finish: str, result: Reconstruction, target: Fiducial3D) -> list[Panel]:
    panels = _height_panels(finish, result.method, result.height_um, result.pixel_um, target)
    if result.micrograph is not None:
        picture, width_um = _square(toned(result.micrograph), result.pixel_um, target)
        panels.insert(0, Panel(f"{finish}: micrograph", picture, width_um=width_um))
    return panels


def _height_panels(
    finish: str, method: str, height_um: FloatImage, pixel_um: float, target: Fiducial3D
) -> list[Panel]:
    """Heights, and their errors after one median offset, over the square of the fiducial."""
    error = height_um - target.height_um(_shape(height_um), pixel_um)
    error -= np.float32(np.nanmedian(error))
    shown, width_um = _square(height_um, pixel_um, target)
    wrong, _ = _square(error, pixel_um, target)
    low, high = target.base_um, target.base_um + target.depth_um
    return [
        Panel(f"{finish}: {method}", shown, "height (µm)", span=(low, high), width_um=width_um),
        Panel(
            f"{finish}: error of {method}",
            wrong,
            "error (µm)",
            "RdBu_r",
            (-_ERROR_UM, _ERROR_UM),
            width_um=width_um,
        ),
    ]


def _square(image: FloatImage, pixel_um: float, target: Fiducial3D) -> tuple[FloatImage, float]:
    """The part of an image that shows the fiducial, and its width on the sample."""
    rows, columns = (min(n, round(target.size_um / pixel_um)) for n in image.shape[:2])
    top, left = (image.shape[0] - rows) // 2, (image.shape[1] - columns) // 2
    return image[top : top + rows, left : left + columns], columns * pixel_um


def _shape(image: FloatImage) -> tuple[int, int]:
    return image.shape[0], image.shape[1]


def _write(table: TableOne) -> None:
    try:
        (table.folder / "table_one.md").write_text(table.markdown, encoding="utf-8")
        (table.folder / "table_one.json").write_text(
            json.dumps(table.as_dict(), indent=2), encoding="utf-8"
        )
    except OSError as error:
        raise DatasetError(
            f"The table could not be written to {table.folder}: {error.strerror or error}.",
            hint="Check the disk and the permissions of the folder.",
        ) from error
