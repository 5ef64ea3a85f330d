"""Faults of the instrument's description, injected into runs of the twin, are named; sound runs have none."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from reliefscope.dataset import Run
from reliefscope.microscope import Microscope
from reliefscope.reconstruction.pipeline import reconstruct
from reliefscope.reconstruction.self_check import SelfCheck
from reliefscope.reconstruction.settings import settings_for

SIZE = "size=144x108"


def take(folder: Path, options: str) -> Run:
    """Twelve views under eight lights, four of either ring."""
    with Microscope.open(f"sim://check?{SIZE}&{options}") as microscope:
        plan = microscope.default_plan()
        changes = {"lights": plan.lights[::2], "dark_accumulate": 4, "leakage_accumulate": 8}
        return microscope.acquire(plan.model_copy(update=changes), folder / "run").data


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Run:
    return take(tmp_path_factory.mktemp("check"), "scene=fiducial&finish=dull&seed=2")


def recalibrated(run: Run, **changes: Any) -> Run:
    assert run.calibration is not None
    return run.with_calibration(run.calibration.model_copy(update=changes))


def moved_leds(run: Run, matrix: list[list[float]]) -> Run:
    """The same run, LEDs told to be where ``matrix`` takes them."""
    assert run.calibration is not None
    places = np.array(run.calibration.led_positions_mm)
    places[:, :2] = places[:, :2] @ np.array(matrix).T
    return recalibrated(run, led_positions_mm=tuple(map(tuple, places.tolist())))


def turned(degrees: float) -> list[list[float]]:
    cos, sin = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return [[cos, -sin], [sin, cos]]


class Altered:
    """A run of which some things are told wrongly."""

    def __init__(self, run: Run, **wrong: Any) -> None:
        self._run = run
        self.__dict__.update(wrong)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._run, name)


def check(run: Any) -> SelfCheck:
    result = reconstruct(run)
    assert result.self_check is not None
    return result.self_check


def test_a_sound_run_shows_no_fault(run: Run) -> None:
    found = check(run)
    assert found.findings == ()
    assert found.verdict == "no fault seen"
    assert found.figures["shadow_correlation"] > 0.7
    assert found.figures["shadow_z_scale"] == pytest.approx(1.0, abs=0.08)
    assert np.abs(np.array(found.figures["held_out_levels"]) - 1).max() < 0.05
    assert found.figures["held_out_error"] < 0.05
    assert SelfCheck.from_dict(found.as_dict()) == found


@pytest.mark.parametrize(
    ("matrix", "code"),
    [
        ([[-1, 0], [0, 1]], "led_map_mirrored_x"),
        ([[1, 0], [0, -1]], "led_map_mirrored_y"),
        ([[0, 1], [1, 0]], "led_map_axes_swapped"),
        (turned(45), "led_map_turned"),
        (turned(-20), "led_map_turned"),
    ],
    ids=["mirrored-x", "mirrored-y", "swapped", "one-step", "between-steps"],
)
def test_a_wrong_map_of_the_leds_is_named(run: Run, matrix: list[list[float]], code: str) -> None:
    (finding,) = check(moved_leds(run, matrix)).findings
    assert finding.code == code
    assert "LED map looks" in finding.sentence
    assert "led_positions_mm" in finding.next_step


def test_the_turn_of_the_led_map_is_measured(run: Run) -> None:
    (finding,) = check(moved_leds(run, turned(30))).findings
    *_, degrees, unit = finding.sentence.split()
    assert unit == "degrees"
    assert float(degrees) == pytest.approx(30, abs=5)
    assert "counter-clockwise" in finding.sentence


def test_an_even_slope_is_no_fault(tmp_path: Path) -> None:
    """It turns away from some of the lights, which is not a shadow that heights should have cast."""
    slope = take(tmp_path, "scene=plane&scene.tilt_deg=35&scene.texture=0&seed=2")
    assert check(slope).findings == ()


@pytest.mark.parametrize(("factor", "word"), [(1.25, "high"), (0.8, "low")])
def test_a_wrong_scale_of_z_is_measured(run: Run, factor: float, word: str) -> None:
    """Slopes taken for smaller than they are make heights too great, by as much."""
    assert run.calibration is not None
    found = check(recalibrated(run, pupil_scale=run.calibration.pupil_scale * factor))
    assert [finding.code for finding in found.findings] == ["z_scale"]
    assert f"% too {word}" in found.findings[0].sentence
    assert found.figures["shadow_z_scale"] == pytest.approx(factor, abs=0.1)


def test_a_weak_light_is_named(run: Run) -> None:
    assert run.calibration is not None
    levels = list(run.calibration.led_intensities)
    levels[6] *= 2  # told to be twice as bright as it is
    (finding,) = check(recalibrated(run, led_intensities=tuple(levels))).findings
    assert finding.code == "light_level"
    assert finding.sentence.startswith("Light `led-06` looks 5")


def test_exchanged_leds_are_named(run: Run) -> None:
    assert run.calibration is not None
    places = list(run.calibration.led_positions_mm)
    places[4], places[10] = places[10], places[4]
    (finding,) = check(recalibrated(run, led_positions_mm=tuple(places))).findings
    assert finding.sentence == "Lights `led-04` and `led-10` look exchanged"


def test_a_wrong_sign_and_wrong_views_are_told_apart(run: Run) -> None:
    assert run.views is not None
    assert check(Altered(run, views=-run.views)).findings[0].code == "sign_wrong"
    for wrong in (run.views[:, ::-1].copy(), run.views * [-1, 1]):
        (finding,) = check(Altered(run, views=wrong)).findings
        assert finding.code == "views_disagree"
        assert "aperture map" in finding.sentence


@pytest.mark.soak
@pytest.mark.parametrize(
    "options",
    [
        "scene=fiducial&finish=half",
        "scene=fiducial&finish=metallic",
        "scene=flat",
        "scene=plane&scene.tilt_deg=35&scene.texture=0.2",
        "scene=hemisphere&scene.texture=0.4&scene.radius_um=90&scene.base_um=-40",
        "scene=regolith",
        "scene=regolith&simulant=jsc1a",
    ],
    ids=["half", "metallic", "flat", "slope", "hemisphere", "mars1", "jsc1a"],
)
def test_other_sound_samples_show_no_fault(tmp_path: Path, options: str) -> None:
    assert check(take(tmp_path, options)).findings == ()


def test_a_range_that_misses_the_surface_is_named(run: Run) -> None:
    settings = settings_for("joint").model_copy(update={"height_range_um": (-10.0, 10.0)})
    check = reconstruct(run, settings).self_check
    assert check is not None
    assert "few_heights" in [finding.code for finding in check.findings]
