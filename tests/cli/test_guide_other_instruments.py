"""The guide to photographs from other instruments: its examples are complete and give what it says."""

import json
import re
from pathlib import Path

import cv2
import numpy as np
import pytest
import yaml
from tests.support import REPOSITORY, shared_data

from reliefscope.calibration.probe_photographs import LightProbeSet
from reliefscope.cli import main
from reliefscope.dataset.import_spec import PhotographSet, load_photograph_set
from reliefscope.models.base import load_model
from reliefscope.reconstruction.result import load_result
from reliefscope.reconstruction.settings import load_settings

PAGE = REPOSITORY / "docs" / "guide" / "other-instruments.md"


@pytest.fixture
def text() -> str:
    return PAGE.read_text(encoding="utf-8")


@pytest.fixture
def place(text: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Every YAML file of the page, under the name in its first line."""
    monkeypatch.chdir(tmp_path)
    for name, content in re.findall(r"^```yaml\n# (\S+\.yml)\n(.*?)^```", text, re.M | re.S):
        (tmp_path / name).write_text(content)
    return tmp_path


def commands(text: str, word: str) -> list[list[str]]:
    """Lines of the page that run the program on a file or run whose name holds ``word``."""
    lines = re.findall(r"^ {4}reliefscope (.+)$", text, re.M)
    return [line.split() for line in lines if word in line]


def run(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> dict:
    assert main([*arguments, "--json", "--progress", "none"]) == 0
    return json.loads(capsys.readouterr().out)


def test_examples_are_valid(place: Path) -> None:
    assert len(load_model(LightProbeSet, place / "spheres.yml").probes) == 2
    (place / "lights.yml").write_text(
        yaml.safe_dump({"lights": [{"direction": [0.1 * k, 0.2, 1.0]} for k in range(12)]})
    )
    figure = load_photograph_set(place / "figure.yml")
    assert len(figure.lights) == 12
    assert figure.files()[0, 11] == "photos/Image_12.png"
    rods = load_model(PhotographSet, place / "rods.yml")
    assert rods.files()[6, 0] == "views/view_6.png"
    assert load_settings(place / "fine.yml").paper.parabola


def test_figure(text: str, place: Path, capsys: pytest.CaptureFixture[str]) -> None:
    data = shared_data("psbox_cat")
    for name, source in (
        ("photos", "Objects"),
        ("sphere-1", "LightProbe-1"),
        ("sphere-2", "LightProbe-2"),
    ):
        (place / name).symlink_to(data / source)
    mean = np.mean([cv2.imread(str(path), 0) for path in data.glob("Objects/*.png")], axis=0)
    opened = cv2.morphologyEx((mean > 25).astype(np.uint8), cv2.MORPH_OPEN, np.ones((9, 9)))
    _, labels, sizes, _ = cv2.connectedComponentsWithStats(opened)
    cv2.imwrite("mask.png", 255 * (labels == 1 + sizes[1:, 4].argmax()).astype(np.uint8))
    given = np.loadtxt(data / "light_directions.txt").T
    Path("given.yml").write_text(
        yaml.safe_dump({"lights": [{"direction": vector.tolist()} for vector in given]})
    )
    probe, imported, reconstructed = (
        commands(text, "spheres.yml")[0],
        *commands(text, "runs/figure"),
    )
    told = run([*probe, "--compare", "given.yml"], capsys)
    assert f"{told['mean_difference_deg']:.2f} degrees" in text
    assert f"by {told['mean_disagreement_deg']:.1f} degrees on average" in text
    assert f"{max(row['disagreement_deg'] for row in told['lights']):.1f} at most" in text
    run(imported, capsys)
    summary = run([*reconstructed, "--no-pictures"], capsys)["summary"]
    assert summary["kind"] == "integrated"
    assert f"{summary['photometric_accepted']:.0%}".replace("%", " %") in text


def test_rods(text: str, place: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (place / "views").symlink_to(shared_data("lightfield_microscope_chips") / "Chips_4_views")
    imported, reconstructed = commands(text, "runs/rods")
    run(imported, capsys)
    summary = run([*reconstructed, "--no-pictures"], capsys)["summary"]
    assert summary["stereo_accepted"] >= 0.75
    assert f"{summary['stereo_accepted']:.1%}".replace("%", " %") in text
    height = load_result(Path("runs/rods"), "fine").height_um
    rows, columns = np.mgrid[: height.shape[0], : height.shape[1]]
    start, end, half_width = np.array([318, 75]), np.array([225, 330]), 20
    axis = (end - start) / np.linalg.norm(end - start)
    along = (rows - start[0]) * axis[0] + (columns - start[1]) * axis[1]
    across = (columns - start[1]) * axis[0] - (rows - start[0]) * axis[1]
    length = np.linalg.norm(end - start)
    rod = (along >= 0) & (along <= length) & (np.abs(across) <= half_width)
    design = np.stack([along[rod], across[rod], np.ones(rod.sum())], axis=1)
    fitted, *_ = np.linalg.lstsq(design, height[rod].astype(np.float64), rcond=None)
    assert -fitted[0] * length == pytest.approx(10.0, abs=0.5)
    assert np.std(height[rod] - design @ fitted) < 0.2
