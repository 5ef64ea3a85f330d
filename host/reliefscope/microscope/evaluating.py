"""Results against the true shape of what lay under the objective."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import parse_qsl, urlsplit

from reliefscope.dataset.spec import RunSpec
from reliefscope.errors import DatasetError, InvalidInputError
from reliefscope.evaluation import PAPER_TABLE_I, TableRow, evaluate_fiducial
from reliefscope.jobs import Job
from reliefscope.microscope.instruments import DEFAULT_SCENE, DEMO_SCHEME
from reliefscope.microscope.stored import StoredRun, as_stored
from reliefscope.targets import SECTIONS, Fiducial3D, Section


@dataclass(frozen=True, slots=True)
class Evaluation:
    """Errors of one or more results of a run of the fiducial."""

    run: Path
    table: Sequence[TableRow]
    paper_um: Mapping[str, float]
    """What the paper reports for a section (Table I, average)."""
    whole: bool
    """Whether the frames show the whole fiducial; only then do the figures compare with the paper's."""

    def as_dict(self) -> dict[str, Any]:
        """For ``--json``."""
        return {
            "run": str(self.run),
            "table": list(self.table),
            "paper_table_um": dict(self.paper_um),
            "whole_fiducial": self.whole,
        }


def evaluate_run(
    run: StoredRun | Path | str,
    *,
    name: str | None = None,
    target: Fiducial3D | None = None,
    job: Job | None = None,
) -> Evaluation:
    """Compare results of a run of the fiducial with its true shape.

    Parameters
    ----------
    run:
        The run, or its folder.
    name:
        Result to evaluate; every result of the run if left out.
    target:
        The fiducial that lay under the objective; the standard one if left out, which a run must be
        known to show (:func:`refuse_other_sample`).
    job:
        Receives progress; may cancel.

    Raises
    ------
    InvalidInputError
        If nothing says that the run shows the fiducial.
    DatasetError
        If there is no such result.
    """
    from reliefscope.reconstruction.result import load_result

    stored = as_stored(run)
    if target is None:
        refuse_other_sample(stored.data.spec, stored.path)
    names = stored.results if name is None else [name]
    if not names:
        raise DatasetError(
            f"{stored.path} has no result to evaluate.",
            hint=f"Make one: `reliefscope reconstruct {stored.path}`.",
        )
    fiducial = target or Fiducial3D()
    shown = visible_sections(fiducial, stored.data.shape, stored.data.pixel_um)
    table: list[TableRow] = []
    for each in names:
        result = load_result(stored.path, each)
        table += evaluate_fiducial(
            result.height_um, result.pixel_um, each, fiducial, sections=shown, job=job
        )
    whole = min(stored.data.shape) * stored.data.pixel_um >= fiducial.size_um
    return Evaluation(stored.path, table, PAPER_TABLE_I, whole)


def refuse_other_sample(spec: RunSpec, path: Path) -> None:
    """Refuse a run at ``path`` of which nothing tells that it shows the 3D fiducial.

    A simulated instrument's address names its scene; of any other run only the sample and the notes tell.

    Raises
    ------
    InvalidInputError
        It shows another scene, or nothing is known of it.
    """
    scene = _simulated_scene(spec)
    if scene == DEFAULT_SCENE:
        return
    if scene is not None:
        raise InvalidInputError(
            f"{path} shows the scene `{scene}`, not the fiducial: its true shape is not known here.",
            hint=f"`reliefscope reconstruct {path}` gives its heights; `reliefscope info {path}` tells what it is.",
        )
    if DEFAULT_SCENE not in f"{spec.sample} {spec.notes}".lower():
        raise InvalidInputError(
            f"Nothing recorded says that {path} shows the fiducial, the only sample whose true shape is known.",
            hint=f"`reliefscope reconstruct {path}` gives heights of any sample, `reliefscope info {path}` "
            "tells what is recorded. If it does show the fiducial, say so with `--fiducial`.",
        )


def _simulated_scene(spec: RunSpec) -> str | None:
    """Scene by the address of the simulated instrument; None where there is no such address."""
    addresses = (
        [session.device.get("url", "") for session in spec.acquired.sessions]
        if spec.acquired
        else []
    )
    for address in (*addresses, *spec.notes.split()):
        parts = urlsplit(address)
        if parts.scheme == DEMO_SCHEME:
            return dict(parse_qsl(parts.query)).get("scene", DEFAULT_SCENE)
    return None


def visible_sections(
    fiducial: Fiducial3D, shape: tuple[int, int], pixel_um: float
) -> tuple[Section, ...]:
    """Sections of the fiducial of which a frame of ``shape`` (rows, columns) shows anything.

    Raises
    ------
    InvalidInputError
        If it shows none.
    """
    shown = tuple(section for section in SECTIONS if fiducial.mask(section, shape, pixel_um).any())
    if not shown:
        raise InvalidInputError(
            "The frames show no part of the fiducial.", hint="Evaluate a run of the fiducial."
        )
    return shown
