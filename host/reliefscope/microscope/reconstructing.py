"""From a run on disk to a result beside it."""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from reliefscope.errors import InvalidInputError
from reliefscope.jobs import Job
from reliefscope.microscope.instruments import load_calibration
from reliefscope.microscope.stored import StoredRun, as_stored
from reliefscope.models.calibration import Calibration

if TYPE_CHECKING:
    from reliefscope.reconstruction.result import Reconstruction
    from reliefscope.reconstruction.settings import Settings

DEFAULT_METHOD = "joint"
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
        check = self.reconstruction.self_check
        return {
            "run": str(self.run),
            "name": self.name,
            "results": str(self.folder),
            "pictures": [str(picture) for picture in self.pictures],
            "summary": self.facts(),
            "self_check": None if check is None else check.as_dict(),
            "stages_s": {stage: round(spent, 3) for stage, spent in self.stages_s.items()},
            "total_s": round(self.total_s, 3),
        }


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
        Name of the result; if left out that of the settings' file, else of the method.
    method:
        Name of a method; ``joint`` if neither it nor ``settings`` is given.
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

    stored = as_stored(run)
    started = time.perf_counter()
    chosen = _settings(method, settings)
    data = stored.data
    if calibration is not None:
        data = data.with_calibration(load_calibration(calibration))
    file = Path(settings) if isinstance(settings, str | Path) else None
    label = name or (file.stem if file else chosen.method)
    result_folder(data.path, label, overwrite=overwrite)  # refuse before the work
    centre = data.luminance("centre", None, None) if data.has("centre") else None
    with data.lock():
        reconstruction = reconstruct(data, chosen, job, micrograph=centre)
        stages = dict(reconstruction.timings_s)
        drawn: list[Path] = []

        def draw(place: Path) -> None:
            from reliefscope.report.pictures import write_pictures

            begun = time.perf_counter()
            drawn.extend(write_pictures(reconstruction, place, job))
            stages[PICTURES_STAGE] = time.perf_counter() - begun

        folder = save_result(
            reconstruction, data.path, label, overwrite=overwrite, draw=draw if pictures else None
        )
    return Outcome(
        run=data.path,
        name=label,
        folder=folder,
        reconstruction=reconstruction,
        pictures=tuple(folder / picture.name for picture in drawn),
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
            hint="Give one of them; the file may say `method: paper`.",
        )
    return settings if isinstance(settings, Settings) else load_settings(Path(settings))
