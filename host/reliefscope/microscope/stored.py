"""Runs on disk: look at them, verify, reconstruct, evaluate."""

from __future__ import annotations

import time
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any
from urllib.parse import parse_qsl, urlsplit

from reliefscope.dataset import Run, VerifyReport
from reliefscope.dataset import import_photographs as import_run
from reliefscope.dataset.run import IncompleteRunWarning
from reliefscope.dataset.spec import RunSpec
from reliefscope.errors import DatasetError, InvalidInputError
from reliefscope.evaluation import PAPER_TABLE_I, TableRow, evaluate_fiducial
from reliefscope.jobs import Job
from reliefscope.microscope.instruments import DEFAULT_SCENE, DEMO_SCHEME, load_calibration
from reliefscope.microscope.places import fresh_path
from reliefscope.models.calibration import Calibration
from reliefscope.targets import SECTIONS, Fiducial3D, Section
from reliefscope.units import format_bytes

if TYPE_CHECKING:
    from reliefscope.reconstruction.result import Reconstruction
    from reliefscope.reconstruction.settings import Settings

DEFAULT_METHOD = "paper"
PICTURES_STAGE = "pictures"


@dataclass(frozen=True, slots=True)
class Outcome:
    """A reconstruction, what it took, and where it lies."""

    run: Path
    name: str
    folder: Path
    reconstruction: Reconstruction
    pictures: tuple[Path, ...]
    stages_s: Mapping[str, float]
    total_s: float

    def facts(self) -> dict[str, Any]:
        """Figures of the result, for people and programs."""
        return self.reconstruction.summary()

    def as_dict(self) -> dict[str, Any]:
        """For ``--json``."""
        return {
            "run": str(self.run),
            "name": self.name,
            "results": str(self.folder),
            "pictures": [str(picture) for picture in self.pictures],
            "summary": self.facts(),
            "stages_s": {stage: round(spent, 3) for stage, spent in self.stages_s.items()},
            "total_s": round(self.total_s, 3),
        }


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


class StoredRun:
    """A run on disk; ``data`` reads its frames and geometry."""

    def __init__(self, data: Run) -> None:
        self.data = data

    @property
    def path(self) -> Path:
        """Folder of the run."""
        return self.data.path

    @property
    def results(self) -> list[str]:
        """Names of the results that were made from it."""
        folder = self.data.results_dir
        if not folder.is_dir():
            return []
        return sorted(place.name for place in folder.iterdir() if (place / "result.json").is_file())

    def describe(self) -> dict[str, Any]:
        """What the run holds, for people and programs."""
        data, spec = self.data, self.data.spec
        rows, columns = data.shape
        facts: dict[str, Any] = {
            "run": str(data.path),
            "origin": spec.origin,
            "created": spec.created,
            "complete": data.complete,
            "images": f"{data.planned - len(data.missing)} of {data.planned}",
            "views": len(data.view_names),
            "lights": len(data.light_names),
            "frame": f"{columns} x {rows} px, {spec.frame.bit_depth} bit, {spec.frame.sensor}",
            "pixel_um": data.pixel_um,
            "size": format_bytes(_size(data.path)),
            "sample": spec.sample or None,
            "notes": spec.notes or None,
        }
        if spec.acquired is not None:
            plan, calibration = spec.acquired.plan, spec.acquired.calibration
            facts["instrument"] = spec.acquired.profile.name
            facts["calibration"] = f"{calibration.source} ({calibration.created or 'no date'})"
            facts["exposure_ms"] = spec.acquired.camera_exposure_us / 1000
            facts["settle_ms"] = plan.settle_ms
            facts["sessions"] = len(spec.acquired.sessions)
        if spec.imported is not None:
            facts["source"] = spec.imported.source
            facts["conversion"] = spec.imported.conversion or None
        facts["results"] = self.results
        return facts

    def reconstruct(
        self,
        *,
        name: str | None = None,
        method: str | None = None,
        settings: Settings | Path | str | None = None,
        calibration: Calibration | Path | str | None = None,
        pictures: bool = True,
        overwrite: bool = False,
        job: Job | None = None,
    ) -> Outcome:
        """Height, normals and albedo; see :func:`reconstruct_run`."""
        return reconstruct_run(
            self,
            name=name,
            method=method,
            settings=settings,
            calibration=calibration,
            pictures=pictures,
            overwrite=overwrite,
            job=job,
        )

    def evaluate(
        self, *, name: str | None = None, target: Fiducial3D | None = None, job: Job | None = None
    ) -> Evaluation:
        """Results against the true shape of the fiducial; see :func:`evaluate_run`."""
        return evaluate_run(self, name=name, target=target, job=job)

    def verify(self, *, job: Job | None = None) -> VerifyReport:
        """Hash every frame and compare with the journal; changes nothing."""
        return self.data.verify(job)


def open_run(path: Path | str) -> StoredRun:
    """A run on disk, finished or not.

    Raises
    ------
    DatasetError
        If it is absent or damaged; the message says which.
    """
    with warnings.catch_warnings():  # describe() tells what is missing
        warnings.simplefilter("ignore", IncompleteRunWarning)
        return StoredRun(Run.open(path))


def import_photographs(
    description: Path | str, out: Path | str | None = None, *, job: Job | None = None
) -> StoredRun:
    """Turn photographs into a run, by the YAML file ``description``.

    ``out`` is ``runs/NAME-001`` and so on, after the name of the file, where it is left out.
    """
    source = Path(description)
    place = fresh_path(source.stem) if out is None else Path(out)
    return StoredRun(import_run(source, place, job))


def _size(folder: Path) -> int:
    return sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())


def reconstruct_run(
    run: StoredRun | Path | str,
    *,
    name: str | None = None,
    method: str | None = None,
    settings: Settings | Path | str | None = None,
    calibration: Calibration | Path | str | None = None,
    pictures: bool = True,
    overwrite: bool = False,
    job: Job | None = None,
) -> Outcome:
    """Reconstruct a run into ``results/NAME`` of its folder, and draw the pictures.

    Parameters
    ----------
    run:
        The run, or its folder.
    name:
        Name of the result; that of the method if left out.
    method:
        Name of a method; ``paper`` if neither it nor ``settings`` is given.
    settings:
        Settings, or a YAML file of them, instead of a method's.
    calibration:
        Instead of the one that held during acquisition.
    pictures:
        Whether to draw them.
    overwrite:
        Replace a result of the same name.
    job:
        Receives progress; may cancel.

    Raises
    ------
    InvalidInputError
        If method, settings, calibration or the run's geometry do not allow it; nothing was written.
    OutputExistsError
        If there is a result of this name.
    DatasetError, LockedError, Cancelled
    """
    from reliefscope.reconstruction.pipeline import reconstruct
    from reliefscope.reconstruction.result import result_folder, save_result
    from reliefscope.report.pictures import write_pictures

    stored = _stored(run)
    started = time.perf_counter()
    chosen = _settings(method, settings)
    data = stored.data
    if calibration is not None:
        data = data.with_calibration(load_calibration(calibration))
    label = name or chosen.method
    result_folder(data.path, label, overwrite=overwrite)  # refuse before the work
    centre = data.luminance("centre", None, None) if data.has("centre") else None
    with data.lock():
        reconstruction = reconstruct(data, chosen, job, micrograph=centre)
        folder = save_result(reconstruction, data.path, label, overwrite=overwrite)
        stages = dict(reconstruction.timings_s)
        drawn: tuple[Path, ...] = ()
        if pictures:
            begun = time.perf_counter()
            drawn = write_pictures(reconstruction, folder, job)
            stages[PICTURES_STAGE] = time.perf_counter() - begun
    return Outcome(
        run=data.path,
        name=label,
        folder=folder,
        reconstruction=reconstruction,
        pictures=drawn,
        stages_s=stages,
        total_s=time.perf_counter() - started,
    )


def _settings(method: str | None, settings: Settings | Path | str | None) -> Settings:
    from reliefscope.reconstruction.settings import Settings, load_settings, settings_for

    if settings is None:
        return settings_for(method or DEFAULT_METHOD)
    if method is not None:
        raise InvalidInputError(
            "A method and a file of settings were given together.",
            hint="Give one of them; `method: NAME` in the file names its result.",
        )
    return settings if isinstance(settings, Settings) else load_settings(Path(settings))


def _stored(run: StoredRun | Path | str) -> StoredRun:
    return run if isinstance(run, StoredRun) else open_run(run)


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

    stored = _stored(run)
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
