"""Calibrations that the user made, one file per instrument.

They live in the user's data folder (``RELIEFSCOPE_CALIBRATIONS`` names another): ``PROFILE@SERIAL.json`` for
one instrument, ``PROFILE.json`` for whichever has no serial number.
"""

from __future__ import annotations

import datetime
import os
import re
from pathlib import Path

import platformdirs

from reliefscope.errors import InvalidInputError
from reliefscope.models.base import load_model
from reliefscope.models.calibration import Calibration

FOLDER_VARIABLE = "RELIEFSCOPE_CALIBRATIONS"


def default_folder() -> Path:
    """Folder of the user's calibrations; need not exist."""
    given = os.environ.get(FOLDER_VARIABLE)
    return Path(given) if given else platformdirs.user_data_path("reliefscope") / "calibrations"


class CalibrationStore:
    """The folder of stored calibrations."""

    def __init__(self, folder: Path | None = None) -> None:
        self.folder = default_folder() if folder is None else folder

    def path(self, profile: str, serial_number: str = "") -> Path:
        """File of an instrument's calibration."""
        name = f"{profile}@{serial_number}" if serial_number else profile
        return self.folder / f"{re.sub(r'[^A-Za-z0-9@._-]', '_', name)}.json"

    def find(self, profile: str, serial_number: str = "") -> tuple[Path, Calibration] | None:
        """Calibration of this instrument, else the one of the profile, else None.

        Raises
        ------
        InvalidInputError
            If the file is there but damaged: a calibration is never passed over in silence.
        """
        for serial in dict.fromkeys((serial_number, "")):
            path = self.path(profile, serial)
            if path.is_file():
                return path, load_model(Calibration, path)
        return None

    def save(self, calibration: Calibration, serial_number: str = "") -> Path:
        """Store a calibration; the former one of this instrument is kept beside it with its time.

        Returns
        -------
        Path
            Where it is now.
        """
        path = self.path(calibration.profile, serial_number)
        self.folder.mkdir(parents=True, exist_ok=True)
        if path.exists():
            stamp = datetime.datetime.fromtimestamp(path.stat().st_mtime, datetime.UTC)
            path.rename(path.with_name(f"{path.stem}.{stamp:%Y%m%dT%H%M%S}.json.old"))
        fresh = path.with_name(path.name + ".new")
        fresh.write_text(calibration.model_dump_json(indent=2), encoding="utf-8")
        fresh.replace(path)
        return path

    def list(self) -> list[tuple[Path, Calibration | None]]:
        """Every stored calibration; None for a file that cannot be read."""
        found: list[tuple[Path, Calibration | None]] = []
        for path in sorted(self.folder.glob("*.json")):
            try:
                found.append((path, load_model(Calibration, path)))
            except InvalidInputError:
                found.append((path, None))
        return found
