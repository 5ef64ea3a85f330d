"""A reconstruction and its folder ``results/NAME`` inside the run.

``arrays.npz`` holds the maps (numpy, not compressed: height maps do not compress), ``result.json``
the settings, figures and times.  A folder appears whole or not at all, and is never replaced
unasked.
"""

from __future__ import annotations

import json
import os
import re
import shutil
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any
from zipfile import BadZipFile

import numpy as np
from numpy.typing import NDArray

from reliefscope import __version__, axes
from reliefscope.errors import DatasetError, InvalidInputError, OutputExistsError
from reliefscope.reconstruction.self_check import SelfCheck
from reliefscope.reconstruction.settings import Settings
from reliefscope.units import BoolImage, FloatImage

SCHEMA_VERSION = 2
ARRAYS_FILE = "arrays.npz"
RESULT_FILE = "result.json"
RESULTS_FOLDER = "results"
_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]*")


@dataclass(frozen=True)
class Reconstruction:
    """Maps (H, W) float32 in the virtual view s = 0; None where the run did not allow for them.

    Attributes
    ----------
    height_um:
        The surface: fused, else smoothed stereo, else integrated normals (mean zero).  NaN is
        missing.
    pixel_um:
        Size of a pixel on the sample.
    settings:
        What it was made with.
    kind:
        ``fused``, ``stereo`` or ``integrated``.
    sigma_um:
        Standard error of the height: about 68 % of the errors are smaller.
    stereo_height_um, stereo_quality:
        As matched, before anything is discarded; NaN and 0 where missing.
    stereo_accepted:
        Bool, where the matched height was used.
    smoothed_height_um:
        Stereo heights after discarding and smoothing.
    normals, albedo, photometric_quality, residual:
        As solved, before anything is discarded; normals are (H, W, 3).
    albedo_rgb:
        (H, W, 3) albedo in red, green and blue as the sensor weighs them; its luminance is ``albedo``.
    normal_sigma_rad:
        Angular error to expect of the normal.
    lights_used:
        Number of lights that the normal rests on: neither in shadow nor a highlight.
    micrograph:
        Linear luminance to look at: the centre view under all light where it was taken.
    saturated:
        Bool, where the sensor was at full scale under a light and in a view that sees the point.
    valid:
        (H, W) bool, pixels that the run's mask leaves; None: all.  Shares are of these.
    self_check:
        Whether the result agrees with itself; None without both stereo and normals.
    figures:
        Numbers about the solution, such as the solver's iterations.
    timings_s, peak_memory_mb:
        Time of each stage, and the greatest memory of the process so far.
    """

    height_um: FloatImage
    pixel_um: float
    settings: Settings
    kind: str
    sigma_um: FloatImage | None = None
    stereo_height_um: FloatImage | None = None
    stereo_quality: FloatImage | None = None
    stereo_accepted: BoolImage | None = None
    smoothed_height_um: FloatImage | None = None
    normals: FloatImage | None = None
    normal_sigma_rad: FloatImage | None = None
    lights_used: FloatImage | None = None
    albedo: FloatImage | None = None
    albedo_rgb: FloatImage | None = None
    photometric_quality: FloatImage | None = None
    residual: FloatImage | None = None
    micrograph: FloatImage | None = None
    saturated: BoolImage | None = None
    valid: BoolImage | None = None
    self_check: SelfCheck | None = None
    figures: Mapping[str, float] = field(default_factory=dict)
    timings_s: Mapping[str, float] = field(default_factory=dict)
    peak_memory_mb: float = 0.0

    @property
    def method(self) -> str:
        """Name of the method that made it."""
        return self.settings.method

    @property
    def slant_rad(self) -> FloatImage | None:
        """Angle (H, W) between the normals and the optical axis."""
        return None if self.normals is None else axes.slant_rad(self.normals)

    def summary(self) -> dict[str, Any]:
        """Figures for people and programs."""
        rows, columns = self.height_um.shape
        known = self.height_um[np.isfinite(self.height_um)]
        low, high = np.percentile(known, (1, 99)) if known.size else (np.nan, np.nan)
        facts: dict[str, Any] = {
            "method": self.method,
            "kind": self.kind,
            "size_px": [columns, rows],
            "pixel_um": self.pixel_um,
            "height_known": self._share(np.isfinite(self.height_um)),
            "height_1_to_99_percent_um": [round(float(low), 3), round(float(high), 3)],
        }
        if self.sigma_um is not None:
            facts["standard_error_median_um"] = self._median(self.sigma_um)
        if self.stereo_quality is not None:
            accepted = self.stereo_quality >= self.settings.chosen.stereo_quality
            facts["stereo_accepted"] = self._share(accepted)
            facts["stereo_quality_median"] = self._median(self.stereo_quality)
        if self.photometric_quality is not None:
            accepted = self.photometric_quality >= self.settings.chosen.photometric_quality
            facts["photometric_accepted"] = self._share(accepted)
            facts["photometric_quality_median"] = self._median(self.photometric_quality)
        if self.saturated is not None:
            facts["saturated"] = self._share(self.saturated)
        facts.update({name: float(f"{value:.6g}") for name, value in self.figures.items()})
        if self.self_check is not None:
            facts["self_check"] = self.self_check.verdict
        facts["peak_memory_mb"] = round(self.peak_memory_mb)
        return facts

    def _share(self, chosen: NDArray[np.bool_]) -> float:
        return round(float(self._among(chosen).mean()), 4)

    def _median(self, quality: FloatImage) -> float:
        return round(float(np.median(self._among(quality))), 4)

    def _among(self, values: NDArray[Any]) -> NDArray[Any]:
        """Values of the valid pixels."""
        return values if self.valid is None else values[self.valid]


_ARRAYS = tuple(
    item.name
    for item in fields(Reconstruction)
    if item.name == "height_um" or item.type in ("FloatImage | None", "BoolImage | None")
)


def result_folder(run_path: Path, name: str, *, overwrite: bool = False) -> Path:
    """Folder of a result, checked before any work is done for it.

    Raises
    ------
    InvalidInputError
        A name that cannot be a folder's.
    OutputExistsError
        The folder exists and ``overwrite`` is false.
    """
    if not _NAME.fullmatch(name):
        raise InvalidInputError(
            f"`{name}` cannot be the name of a result.",
            hint="Use letters, digits, dots, dashes and underscores, starting with a letter or digit.",
        )
    folder = run_path / RESULTS_FOLDER / name
    if folder.exists() and not overwrite:
        raise OutputExistsError(
            f"{folder} exists already; nothing was changed.",
            hint=f"Choose another name: `reliefscope reconstruct {run_path} --name {name}-2`, "
            "or replace it with `--overwrite`.",
        )
    return folder


def list_results(run_path: Path) -> list[str]:
    """Names of the results of a run, in order."""
    folder = run_path / RESULTS_FOLDER
    return sorted(path.parent.name for path in folder.glob(f"[!.]*/{RESULT_FILE}"))


def save_result(
    reconstruction: Reconstruction,
    run_path: Path,
    name: str,
    *,
    overwrite: bool = False,
    draw: Callable[[Path], object] | None = None,
) -> Path:
    """Write a result to ``results/NAME`` of a run and return the folder: all of it or, where that fails, nothing.

    ``draw`` puts pictures into the folder that it is given, before the result takes its place.

    Raises
    ------
    InvalidInputError, OutputExistsError
        See :func:`result_folder`.
    DatasetError
        The disk did not take it; what was there before is unchanged.
    """
    folder = result_folder(run_path, name, overwrite=overwrite)
    making = folder.with_name(f".{name}.making-{os.getpid()}")
    try:
        making.mkdir(parents=True)
        arrays = {
            key: value for key in _ARRAYS if (value := getattr(reconstruction, key)) is not None
        }
        with (making / ARRAYS_FILE).open("wb") as stream:
            np.savez(stream, **arrays)
            _sync(stream)
        with (making / RESULT_FILE).open("w", encoding="utf-8") as stream:
            json.dump(_document(reconstruction), stream, indent=2)
            _sync(stream)
        if draw is not None:
            draw(making)
        if folder.exists():
            replaced = folder.with_name(f".{name}.replaced-{os.getpid()}")
            folder.rename(replaced)
            making.rename(folder)
            shutil.rmtree(replaced)
        else:
            making.rename(folder)
    except OSError as error:
        raise DatasetError(
            f"The result could not be written to {folder}: {error.strerror or error}.",
            hint=f"Check space and permissions: `df -h {run_path}`, then reconstruct again.",
        ) from error
    finally:
        shutil.rmtree(making, ignore_errors=True)  # gone already where all went well
    return folder


def read_verdict(run_path: Path, name: str) -> str:
    """What a result showed when it was compared with itself, in one line, without reading its maps."""
    path = run_path / RESULTS_FOLDER / name / RESULT_FILE
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
        check = document.get("self_check")
        return "not compared with itself" if check is None else SelfCheck.from_dict(check).verdict
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return "damaged"


def load_result(run_path: Path, name: str) -> Reconstruction:
    """Read a result of a run.

    Raises
    ------
    DatasetError
        It is absent, damaged, or of another version.
    """
    folder = run_path / RESULTS_FOLDER / name
    if not (folder / RESULT_FILE).is_file():
        known = ", ".join(list_results(run_path)) or "none"
        raise DatasetError(
            f"{run_path} has no result `{name}` (there are: {known}).",
            hint=f"Make one: `reliefscope reconstruct {run_path} --name {name}`.",
        )
    try:
        document = json.loads((folder / RESULT_FILE).read_text(encoding="utf-8"))
        version = document["schema_version"]
        if version != SCHEMA_VERSION:
            raise DatasetError(
                f"{folder} has version {version}; this program reads {SCHEMA_VERSION}.",
                hint=f"Reconstruct again: `reliefscope reconstruct {run_path} --name {name} "
                "--overwrite`.",
            )
        with (folder / ARRAYS_FILE).open("rb") as stream, np.load(stream) as archive:
            arrays: dict[str, Any] = {key: archive[key] for key in archive.files}
        check = document["self_check"]
        return Reconstruction(
            pixel_um=document["pixel_um"],
            settings=Settings.model_validate(document["settings"]),
            kind=document["kind"],
            self_check=None if check is None else SelfCheck.from_dict(check),
            figures=document["figures"],
            timings_s=document["timings_s"],
            peak_memory_mb=document["peak_memory_mb"],
            **arrays,
        )
    except (OSError, ValueError, KeyError, TypeError, EOFError, BadZipFile) as error:
        raise DatasetError(
            f"{folder} is damaged: {error}.",
            hint=f"Reconstruct again: `reliefscope reconstruct {run_path} --name {name} "
            "--overwrite`.",
        ) from error


def _document(reconstruction: Reconstruction) -> dict[str, Any]:
    check = reconstruction.self_check
    return {
        "schema_version": SCHEMA_VERSION,
        "program_version": __version__,
        "method": reconstruction.method,
        "kind": reconstruction.kind,
        "pixel_um": reconstruction.pixel_um,
        "settings": reconstruction.settings.as_dict(),
        "summary": reconstruction.summary(),
        "self_check": None if check is None else check.as_dict(),
        "figures": dict(reconstruction.figures),
        "timings_s": dict(reconstruction.timings_s),
        "peak_memory_mb": reconstruction.peak_memory_mb,
    }


def _sync(stream: Any) -> None:
    stream.flush()
    os.fsync(stream.fileno())
