"""The demonstration as a whole, and runs on disk through the public API, at a small size."""

import json
import shutil
from pathlib import Path

import numpy as np
import pytest

from reliefscope import cli
from reliefscope.errors import InvalidInputError, OutputExistsError
from reliefscope.microscope import StoredRun, evaluate_run, open_run, reconstruct_run
from reliefscope.microscope.demonstration import demo, demo_url
from reliefscope.models.calibration import Calibration
from reliefscope.models.instrument import load_profile
from reliefscope.targets import Fiducial3D


@pytest.fixture(scope="module")
def answer(tmp_path_factory: pytest.TempPathFactory) -> dict[str, object]:
    """What `demo --json` prints."""
    import contextlib
    import io

    out = tmp_path_factory.mktemp("demo") / "run"
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        status = cli.main(
            ["demo", "--size", "160x120", "-o", str(out), "--json", "--progress", "none"]
        )
    assert status == 0
    found = json.loads(printed.getvalue())
    assert isinstance(found, dict)
    return found


@pytest.fixture
def run(answer: dict[str, object], tmp_path: Path) -> StoredRun:
    return open_run(shutil.copytree(str(answer["run"]), tmp_path / "run"))


def test_demo_prints_one_object_with_the_table(answer: dict[str, object]) -> None:
    assert answer["schema_version"] == 1
    table = answer["table"]
    assert isinstance(table, list)
    assert {row["section"] for row in table} >= {"planes", "hemispheres", "full"}
    for row in table:
        assert row["method"] == "joint"
        assert 0 < row["mae_plane_um"] < 100
        assert row["mae_offset_um"] <= row["mae_raw_um"] + 1e-9
    assert answer["whole_fiducial"] is False
    stages = answer["stages_s"]
    assert isinstance(stages, dict)
    assert {"acquire", "match", "pictures", "evaluate"} <= stages.keys()
    pictures = answer["pictures"]
    assert isinstance(pictures, list)
    assert all(Path(picture).stat().st_size > 1000 for picture in pictures)
    assert len(pictures) >= 7


def test_evaluate_agrees_with_the_demo(answer: dict[str, object], run: StoredRun) -> None:
    assert run.results == ["joint"]
    assert list(run.evaluate().table) == answer["table"]


def test_wrong_truth_is_worse(run: StoredRun) -> None:
    def full(target: Fiducial3D) -> float:
        rows = {row["section"]: row for row in evaluate_run(run, target=target).table}
        return rows["planes"]["mae_plane_um"]

    assert full(Fiducial3D(seed=1)) < full(Fiducial3D(seed=2))


def test_second_result_beside_the_first(run: StoredRun, tmp_path: Path) -> None:
    with pytest.raises(OutputExistsError):
        run.reconstruct(pictures=False)
    settings = tmp_path / "mine.yml"
    settings.write_text("method: paper\npaper: {parabola: true}\n", encoding="utf-8")
    outcome = run.reconstruct(settings=settings, pictures=False)
    assert outcome.name == "mine"
    assert run.results == ["joint", "mine"]
    assert {row["method"] for row in run.evaluate().table} == {"joint", "mine"}
    with pytest.raises(InvalidInputError, match="together"):
        run.reconstruct(method="paper", settings=settings)


def test_a_method_beside_itself_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InvalidInputError, match="beside itself"):
        demo(tmp_path / "run", method="joint", beside="joint")
    assert not list(tmp_path.iterdir())


def test_another_calibration_scales_the_heights(run: StoredRun, tmp_path: Path) -> None:
    """Slopes 0.8 times as large mean heights 1.25 times as large."""
    profile = load_profile("benchtop")
    calibration = Calibration.nominal(profile).model_copy(update={"pupil_scale": 1.25})
    path = tmp_path / "calibration.json"
    path.write_text(calibration.model_dump_json(), encoding="utf-8")
    settings = tmp_path / "wide.yml"
    settings.write_text("use: stereo\nheight_range_um: [-100, 100]\n", encoding="utf-8")
    plain = reconstruct_run(run, settings=settings, name="plain", pictures=False)
    scaled = reconstruct_run(
        run, settings=settings, name="scaled", calibration=path, pictures=False
    )

    def spread(heights: np.ndarray) -> float:
        return float(np.subtract(*np.nanpercentile(heights, (90, 10))))

    ratio = spread(scaled.reconstruction.height_um) / spread(plain.reconstruction.height_um)
    assert ratio == pytest.approx(1.25, rel=0.05)


def test_demo_url_of_a_profile_file(tmp_path: Path) -> None:
    path = tmp_path / "mine.yml"
    path.write_text(load_profile("miniature").model_dump_json(), encoding="utf-8")
    assert demo_url("benchtop", "flat", None, 3, (96, 72)) == (
        "sim://benchtop?scene=flat&seed=3&size=96x72"
    )
    assert "profile=" in demo_url(str(path), "flat", "dull", 3, None)
    with pytest.raises(InvalidInputError, match="desktop"):
        demo_url("desktop", "flat", None, 1, None)
