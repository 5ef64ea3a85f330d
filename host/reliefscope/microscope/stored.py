"""Runs on disk: open them, look at them, verify them."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Any

from reliefscope.dataset import Run, VerifyReport
from reliefscope.dataset import import_photographs as import_run
from reliefscope.dataset.run import IncompleteRunWarning
from reliefscope.jobs import Job
from reliefscope.microscope.places import fresh_path
from reliefscope.models.calibration import Calibration
from reliefscope.targets import Fiducial3D
from reliefscope.units import format_bytes

if TYPE_CHECKING:
    from reliefscope.microscope.evaluating import Evaluation
    from reliefscope.microscope.reconstructing import Outcome
    from reliefscope.reconstruction.settings import Settings


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

    def verdicts(self) -> dict[str, str]:
        """What each result showed when it was compared with itself, in one line, by its name."""
        from reliefscope.reconstruction.result import read_verdict

        return {name: read_verdict(self.path, name) for name in self.results}

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
        facts["results"] = self.verdicts()
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
        """Height, normals and albedo; see :func:`~reliefscope.microscope.reconstructing.reconstruct_run`."""
        from reliefscope.microscope.reconstructing import reconstruct_run

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
        """Results against the true shape; see :func:`~reliefscope.microscope.evaluating.evaluate_run`."""
        from reliefscope.microscope.evaluating import evaluate_run

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


def as_stored(run: StoredRun | Path | str) -> StoredRun:
    """The run itself, or the one in a folder; see :func:`open_run`."""
    return run if isinstance(run, StoredRun) else open_run(run)


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
