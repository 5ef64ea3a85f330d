"""Lights from photographs of spheres: the YAML, the API, the command, the way on to an import."""

import json
from collections.abc import Mapping
from pathlib import Path

import cv2
import numpy as np
import pytest
import yaml
from tests.calibration.spheres import SPHERE, photograph
from tests.support import shared_data

from reliefscope import axes
from reliefscope.calibration.light_probe import angular_difference_deg
from reliefscope.cli import main
from reliefscope.errors import ExitCode, InvalidInputError, OutputExistsError
from reliefscope.microscope import calibrate_lights, import_photographs

LIGHTS = np.array(
    [axes.direction(np.radians(60), np.radians(azimuth)) for azimuth in (20, 140, 260)]
)
CIRCLE = {"column": SPHERE.column, "row": SPHERE.row, "radius_px": SPHERE.radius}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Two spheres under three lights; the second one saw every light turned by about a degree."""
    tilt = np.array([0.0, 0.02, 0.0])
    for name, offset in (("a", 0 * tilt), ("b", tilt)):
        (tmp_path / name).mkdir()
        for k, light in enumerate(LIGHTS, start=1):
            seen = (light + offset) / np.linalg.norm(light + offset)
            grey = np.rint(255 * np.clip(photograph(seen), 0, 1)).astype(np.uint8)
            cv2.imwrite(str(tmp_path / name / f"P{k}.png"), cv2.merge([grey, grey, grey]))
    return tmp_path


def describe(folder: Path, **change: object) -> Path:
    content: Mapping[str, object] = {
        "lights": 3,
        "first": 1,
        "probes": [
            {"folder": "a", "pattern": "P{light}.png", "circle": CIRCLE},
            {"folder": "b", "files": ["P1.png", "P2.png", "P3.png"], "circle": CIRCLE},
        ],
    }
    path = folder / "probe.yml"
    path.write_text(yaml.safe_dump({**content, **change}))
    return path


def outline(step: float) -> list[list[float]]:
    angle = np.arange(0, 2 * np.pi, step)
    return [
        [float(SPHERE.column + SPHERE.radius * c), float(SPHERE.row + SPHERE.radius * s)]
        for c, s in zip(np.cos(angle), np.sin(angle), strict=True)
    ]


def test_several_spheres_are_averaged(folder: Path) -> None:
    found = calibrate_lights(describe(folder))
    assert found.directions.shape == (3, 3)
    assert found.estimates.shape == (2, 3, 3)
    np.testing.assert_allclose(np.linalg.norm(found.directions, axis=1), 1.0)
    assert angular_difference_deg(found.estimates[0], LIGHTS).max() < 0.6
    middle = found.estimates.sum(axis=0)
    assert angular_difference_deg(found.directions, middle).max() < 1e-5
    apart = found.disagreement_deg
    assert apart is not None
    np.testing.assert_allclose(apart, np.degrees(0.02), atol=0.5)
    assert found.difference_deg is None
    row = found.rows()[1]
    assert row["photograph"] == "P2.png"
    assert row["azimuth_deg"] == pytest.approx(140, abs=2)
    assert row["elevation_deg"] == pytest.approx(60, abs=1.5)


def test_one_sphere_by_points_on_its_outline(folder: Path) -> None:
    probe = {"folder": "a", "pattern": "P{light}.png", "outline": outline(0.5)}
    found = calibrate_lights(describe(folder, probes=[probe]))
    assert found.disagreement_deg is None
    assert angular_difference_deg(found.directions, LIGHTS).max() < 0.6


@pytest.mark.parametrize("y_axis", ["up", "down"])
def test_import_takes_what_was_written(folder: Path, y_axis: str) -> None:
    out = folder / "made" / "lights.yml"
    found = calibrate_lights(describe(folder), out=out)
    description = folder / "set.yml"
    description.write_text(
        f"pattern: a/P{{light}}.png\nfirst: 1\npixel_um: 1\nbit_depth: 8\ny_axis: {y_axis}\n"
        "lights: made/lights.yml\n"
    )
    run = import_photographs(description, folder / "run")
    np.testing.assert_allclose(run.data.lights, found.directions, atol=1e-5)
    again = calibrate_lights(folder / "probe.yml", compare=description)
    assert again.difference_deg is not None
    assert again.difference_deg.max() < 1e-3
    before = out.read_bytes()
    with pytest.raises(OutputExistsError, match="nothing was changed"):
        calibrate_lights(folder / "probe.yml", out=out)
    assert out.read_bytes() == before


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"lights": 4}, "probes.1.files are 3, but there are 4"),
        (
            {"first": 2, "probes": [{"pattern": "a/P{light}.png", "circle": CIRCLE}]},
            "P4.png cannot",
        ),
        ({"probes": []}, "probes"),
        ({"probes": [{"pattern": "P.png", "circle": CIRCLE}]}, r"must hold \{light\}"),
        ({"probes": [{"pattern": "P{light", "circle": CIRCLE}]}, "no valid pattern"),
        ({"probes": [{"circle": CIRCLE}]}, "either `files`"),
        ({"probes": [{"pattern": "a/P{light}.png"}]}, "either `circle`"),
        ({"probes": [{"pattern": "a/P{light}.png", "circel": CIRCLE}]}, "did you mean `circle`"),
        (
            {"probes": [{"pattern": "a/P{light}.png", "circle": CIRCLE | {"column": 900.0}}]},
            "P1.png: The sphere does not lie in the photograph",
        ),
        (
            {"probes": [{"pattern": "a/P{light}.png", "outline": [[0, 0], [1, 1], [2, 2]]}]},
            "on a line",
        ),
        (
            {"probes": [{"pattern": "a/P{light}.png", "circle": CIRCLE | {"radius_px": 16.0}}]},
            "below the sample plane",
        ),
    ],
)
def test_wrong_descriptions_are_named(
    folder: Path, change: dict[str, object], message: str
) -> None:
    with pytest.raises(InvalidInputError, match=message):
        calibrate_lights(describe(folder, **change), out=folder / "lights.yml")
    assert not (folder / "lights.yml").exists()


def test_wrong_directions_to_compare_with(folder: Path) -> None:
    description, given = describe(folder), folder / "given.yml"
    for text, message in (
        ("lights: [{direction: [0, 0, 1]}]", "1 directions to compare 3"),
        ("lights: [{direction: [0, 0, 1]}, {}, {}]", "no direction for 2"),
        ("lights: given.yml", "names itself"),
        ("lights: absent.yml", "absent.yml does not exist"),
        ("views: []", "lights: Field required"),
    ):
        given.write_text(text)
        with pytest.raises(InvalidInputError, match=message):
            calibrate_lights(description, compare=given)


def test_command(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    given = folder / "given.yml"
    given.write_text(yaml.safe_dump({"lights": [{"direction": v.tolist()} for v in LIGHTS]}))
    arguments = ["light-probe", str(describe(folder)), "--compare", str(given)]
    assert main([*arguments, "--json", "--out", str(folder / "lights.yml")]) == 0
    told = json.loads(capsys.readouterr().out)
    assert (told["schema_version"], told["probes"], len(told["lights"])) == (1, 2, 3)
    assert told["out"] == str(folder / "lights.yml")
    each = [row["difference_deg"] for row in told["lights"]]
    assert told["mean_difference_deg"] == pytest.approx(np.mean(each), abs=1e-3)
    assert 0.2 < told["mean_difference_deg"] < 1.0
    assert main(arguments) == 0
    shown = capsys.readouterr().out
    assert "Mean difference to the given directions" in shown
    assert "P3.png" in shown
    assert main([*arguments, "--out", str(folder / "lights.yml")]) == ExitCode.DATASET


def test_real_light_probes_agree_with_the_given_directions(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The circles are given with x to the right and y up, both counted from 1."""
    data = shared_data("psbox_cat")
    probes = []
    for folder, height in (("LightProbe-1", 1000), ("LightProbe-2", 950)):
        x, y, radius = (float(v) for v in np.loadtxt(data / folder / "circle_data.txt"))
        circle = {"column": x - 1, "row": height - y, "radius_px": radius}
        pattern = "Image_{light:02d}.JPG"
        probes.append({"folder": str(data / folder), "pattern": pattern, "circle": circle})
    given = np.loadtxt(data / "light_directions.txt").T
    (tmp_path / "given.yml").write_text(
        yaml.safe_dump({"lights": [{"direction": v.tolist()} for v in given]})
    )
    description = describe(tmp_path, lights=12, probes=probes)
    found = calibrate_lights(description, compare=tmp_path / "given.yml")
    difference = found.difference_deg
    assert difference is not None
    with capsys.disabled():
        shown = ", ".join(f"{angle:.2f}" for angle in difference)
        print(f"\nlight probes against the given directions, degrees: {shown}")
    assert difference.max() < 1.5
    assert difference.mean() < 0.8
