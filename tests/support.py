"""Helpers shared by the tests."""

from pathlib import Path

import pytest

REPOSITORY = Path(__file__).resolve().parents[1]


def shared_data(name: str) -> Path:
    """Folder of real photographs or height maps beside the checkout; skips where it is absent."""
    folder = REPOSITORY.parent / "shared" / "data" / name
    if not folder.is_dir():
        pytest.skip(f"left out: ../shared/data/{name} is absent")
    return folder
