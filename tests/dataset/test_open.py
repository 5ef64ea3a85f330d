"""Damaged input: one clear error each, with a next step."""

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.dataset.helpers import make_run

from reliefscope.dataset import Run
from reliefscope.errors import DatasetError, ExitCode


def _edit(change: Callable[[dict[str, object]], object]) -> Callable[[Path], object]:
    def apply(folder: Path) -> None:
        path = folder / "run.json"
        content = json.loads(path.read_text())
        change(content)
        path.write_text(json.dumps(content))

    return apply


@pytest.mark.parametrize(
    ("damage", "message"),
    [
        (lambda folder: (folder / "run.json").unlink(), "not a run"),
        (lambda folder: (folder / "run.json").write_text('{"schema_'), "cannot be read"),
        (lambda folder: (folder / "run.json").write_bytes(b"\xff\xfe"), "cannot be read"),
        (lambda folder: (folder / "run.json").write_text("[]"), "schema_version None"),
        (_edit(lambda content: content.update(schema_version=99)), "schema_version 99"),
        (_edit(lambda content: content.pop("acquired")), "either acquired or imported"),
        (_edit(lambda content: content.update(sampel="x")), "did you mean `sample`"),
        (lambda folder: (folder / "1" / "0" / "zarr.json").unlink(), "not a readable Zarr"),
        (lambda folder: (folder / "1" / "0" / "zarr.json").write_text("{"), "not a readable Zarr"),
        (
            _edit(lambda content: content["frame"].update(rows=20)),
            "run.json tells of",
        ),
    ],
)
def test_a_damaged_description_is_named(
    tmp_path: Path, damage: Callable[[Path], object], message: str
) -> None:
    run = make_run(tmp_path / "run")
    damage(run.path)
    with pytest.raises(DatasetError, match=message) as caught:
        Run.open(run.path)
    assert caught.value.exit_code == ExitCode.DATASET
    assert caught.value.hint


def test_an_unknown_folder_is_named(tmp_path: Path) -> None:
    with pytest.raises(DatasetError, match="no run"):
        Run.open(tmp_path / "absent")
    with pytest.raises(DatasetError, match="not a run"):
        Run.open(tmp_path)


@pytest.mark.parametrize(
    ("damage", "message"),
    [
        (lambda chunk: chunk.unlink(), "missing"),
        (lambda chunk: chunk.write_bytes(chunk.read_bytes()[:100]), "damaged"),
        (lambda chunk: chunk.write_bytes(b""), "damaged"),
        (lambda chunk: chunk.write_bytes(bytes(len(chunk.read_bytes()))), "damaged"),
    ],
)
def test_a_damaged_chunk_is_named(
    tmp_path: Path, damage: Callable[[Path], object], message: str
) -> None:
    run = make_run(tmp_path / "run")
    damage(run.path / run.layout.chunk_path(("view", 2, 1)))
    run = Run.open(run.path)
    run.raw("view", 2, 0)
    with pytest.raises(DatasetError, match=f"view-02-light-01 is {message}") as caught:
        run.linear(2, 1)
    assert "--resume" in caught.value.hint
    assert list(run.verify().damaged) == [("view", 2, 1)]


def test_a_frame_that_was_never_planned_is_named(tmp_path: Path) -> None:
    run = make_run(tmp_path / "run")
    with pytest.raises(DatasetError, match="view-07-light-00") as caught:
        run.raw("view", 7, 0)
    assert "not part of the plan" in caught.value.hint
