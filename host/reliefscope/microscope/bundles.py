"""Bundles: one small file with everything of a run but its pixels, for a bug report."""

from __future__ import annotations

import json
import zipfile
from pathlib import Path
from typing import Any

from reliefscope.acquisition.acquire import WIRE_LOGS
from reliefscope.dataset.durable import disk_error
from reliefscope.dataset.records import JOURNAL_FILE
from reliefscope.dataset.spec import SPEC_FILE, read_spec
from reliefscope.dataset.writer import final_path, now, partial_path, software_name
from reliefscope.errors import DatasetError, OutputExistsError

SCHEMA_VERSION = 1
BUNDLE_FILE = "bundle.json"
SUFFIX = ".bundle.zip"


def bundle_run(run: Path | str, out: Path | str | None = None) -> Path:
    """Pack plan, journal and wire logs of a run, finished or not, into one file.

    A wire log holds every frame between host and device, what was asked of the camera, and the address of the
    instrument: for a simulated one that is its seed and its faults, so that the session can be played again.

    Parameters
    ----------
    run:
        Folder of the run, with or without ``.partial``.
    out:
        File to write; ``RUN.bundle.zip`` beside the run if left out.

    Raises
    ------
    DatasetError
        If there is no such run, or it has no wire log.
    OutputExistsError
        If the file exists.
    """
    folder = Path(run) if Path(run).is_dir() else partial_path(Path(run))
    if not folder.is_dir():
        raise DatasetError(
            f"There is no run {run}.", hint=f"Look for it: `ls {Path(run).absolute().parent}`."
        )
    spec = read_spec(folder)
    logs = sorted(folder.glob(WIRE_LOGS))
    if not logs:
        raise DatasetError(
            f"{folder} has no record of what passed between host and instrument.",
            hint="Runs that were imported have none; acquire a run, then bundle it.",
        )
    name = final_path(folder)
    target = name.with_name(name.name + SUFFIX) if out is None else Path(out)
    content: dict[str, Any] = {
        "schema_version": SCHEMA_VERSION,
        "created": now(),
        "software": software_name(),
        "run": name.name,
        "run_software": spec.software,
        "sessions": [{"wire_log": log.name, **_head(log)} for log in logs],
    }
    try:
        with zipfile.ZipFile(target, "x", zipfile.ZIP_DEFLATED) as bundle:
            bundle.writestr(BUNDLE_FILE, json.dumps(content, indent=1) + "\n")
            for path in (folder / SPEC_FILE, folder / JOURNAL_FILE, *logs):
                bundle.write(path, path.name)
    except FileExistsError:
        raise OutputExistsError(
            f"{target} exists; nothing was overwritten.", hint="Choose another place with `--out`."
        ) from None
    except OSError as error:
        raise disk_error(error, target) from error
    return target


def _head(log: Path) -> dict[str, Any]:
    """Address of the device and kind of clock, from the first line of a wire log."""
    try:
        with log.open(encoding="utf-8") as file:
            head = json.loads(file.readline())
        return {"device": head["device"], "clock": head["clock"]}
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise DatasetError(
            f"{log} cannot be read: {error}.", hint="Restore it from a copy of the run."
        ) from error
