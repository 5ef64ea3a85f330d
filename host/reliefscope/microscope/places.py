"""Where new runs go when nobody says where."""

from __future__ import annotations

import itertools
from pathlib import Path

RUNS = Path("runs")


def fresh_path(stem: str, folder: Path = RUNS) -> Path:
    """First of ``folder/stem-001``, ``-002``, ... that neither a run nor an unfinished one has taken."""
    for number in itertools.count(1):
        path = folder / f"{stem}-{number:03d}"
        if not path.exists() and not path.with_name(path.name + ".partial").exists():
            return path
    raise AssertionError("itertools.count never ends")
