"""The paper's experiments end to end, in small."""

import json
from types import SimpleNamespace
from typing import ClassVar

import cv2
import pytest

from reliefscope.errors import InvalidInputError
from reliefscope.evaluation.table_one import Z_STACK
from reliefscope.microscope import record_stack, simulant_figures, table_one, take_z_stage
from reliefscope.microscope.experiments.z_stage import stage_plan
from reliefscope.models.instrument import load_profile


def test_wrong_names_are_refused_before_anything_is_taken(tmp_path):
    with pytest.raises(InvalidInputError, match="method `papper`"):
        table_one(tmp_path / "t", methods=["papper"])
    with pytest.raises(InvalidInputError, match="nothing to measure"):
        table_one(tmp_path / "t", finishes=[])
    with pytest.raises(InvalidInputError, match="simulant `ds2`") as caught:
        simulant_figures(tmp_path / "s", simulants=["mars1", "ds2"])
    assert "jsc1a" in caught.value.hint
    with pytest.raises(InvalidInputError, match="No microscope that takes stacks"):
        record_stack("/dev/ttyACM0", tmp_path / "stack")
    assert not any(tmp_path.iterdir())


class FakeMicroscope:
    """Notes when it is opened and what is taken."""

    profile = load_profile("benchtop")
    log: ClassVar[list[str]] = []

    @classmethod
    def open(cls, device, camera, **_):
        cls.log.append(f"open {device} {camera}")
        return cls()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.log.append("close")

    def acquire(self, plan, out, **_):
        self.log.append(out.name)
        return SimpleNamespace(path=out)


def test_stage_is_moved_by_hand_or_by_the_address(tmp_path, monkeypatch):
    monkeypatch.setattr("reliefscope.microscope.experiments.z_stage.Microscope", FakeMicroscope)
    log = FakeMicroscope.log
    log.clear()

    def move(height_um):
        log.append(f"to {height_um:g}")

    runs = take_z_stage("/dev/ttyACM0", [-10.0, 0.0, 10.0], tmp_path / "a", camera="cam", move=move)
    assert log == [
        "open /dev/ttyACM0 cam",
        *("to -10", "stage-0010.0um", "to 0", "stage+0000.0um", "to 10", "stage+0010.0um"),
        "close",
    ]
    assert {path.name: height for path, height in runs.items()} == {
        "stage-0010.0um": -10.0,
        "stage+0000.0um": 0.0,
        "stage+0010.0um": 10.0,
    }
    log.clear()
    take_z_stage("x://y?z={stage_um}", [1.0, 2.5, 4.0], tmp_path / "b", move=move)
    assert log[:3] == ["open x://y?z=1 None", "stage+0001.0um", "close"]
    assert log[3] == "open x://y?z=2.5 None"
    with pytest.raises(InvalidInputError, match="Nobody moves the stage"):
        take_z_stage("/dev/ttyACM0", [1.0, 2.0, 3.0], tmp_path / "c")
    with pytest.raises(InvalidInputError, match="2 heights"):
        take_z_stage("/dev/ttyACM0", [1.0, 2.0, 2.0], tmp_path / "c", move=move)


@pytest.mark.parametrize("name", ["benchtop", "miniature"])
def test_a_flat_target_is_lit_as_brightly_as_by_two_leds(name):
    profile = load_profile(name)
    (light,) = stage_plan(profile).lights
    share = sum(light.levels.values()) / profile.dome.full_level
    assert share == pytest.approx(2.0, abs=0.01)


@pytest.mark.soak
def test_table_one_and_its_second_look(tmp_path):
    table = table_one(tmp_path, finishes=["dull"], methods=["paper"], size=(320, 240))
    assert {row["method"] for row in table.rows["dull"]} == {"paper", Z_STACK}
    assert not table.whole
    errors = {(row["method"], row["section"]): row["mae_offset_um"] for row in table.rows["dull"]}
    assert errors["paper", "planes"] < 6.0
    assert errors[Z_STACK, "full"] < 8.0
    assert cv2.imread(str(table.figure)) is not None
    assert "| dull | z-stack |" in (tmp_path / "table_one.md").read_text()
    stamp = (tmp_path / "dull" / "run.json").stat().st_mtime_ns
    again = table_one(tmp_path, finishes=["dull"], methods=["paper"], size=(320, 240))
    assert again.rows == table.rows
    assert (tmp_path / "dull" / "run.json").stat().st_mtime_ns == stamp
    assert json.loads((tmp_path / "table_one.json").read_text())["rows"]["dull"]
    with pytest.raises(InvalidInputError, match="was taken with"):
        table_one(tmp_path, finishes=["dull"], methods=["paper"], size=(160, 120))


@pytest.mark.soak
def test_figure_of_a_simulant(tmp_path):
    (figure,) = simulant_figures(tmp_path, simulants=["jsc1a"], method="paper", size=(200, 150))
    image = cv2.imread(str(figure.figure))
    assert image.shape[0] > 300
    assert figure.facts["size_px"] == [200, 150]
