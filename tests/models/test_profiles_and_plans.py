"""Profiles, plans and the errors of files that people write."""

import itertools
from pathlib import Path

import numpy as np
import pytest
import yaml

from reliefscope.errors import InvalidInputError
from reliefscope.models.base import load_model
from reliefscope.models.calibration import Calibration
from reliefscope.models.instrument import InstrumentProfile, builtin_profiles, load_profile
from reliefscope.models.plan import Plan, default_plan


def test_the_benchtop_is_the_one_of_the_paper() -> None:
    profile = load_profile("benchtop")
    assert profile.optics.magnification == pytest.approx(4.1667, abs=1e-4)
    assert profile.pixel_um == pytest.approx(1.12, abs=0.005)
    assert profile.shape == (1038, 1388)
    elevations = {ring.elevation_deg for ring in profile.dome.rings}
    assert elevations == {22.5, 45.0}


@pytest.mark.parametrize("name", builtin_profiles())
def test_every_profile_makes_a_plan_and_names_its_assumptions(name: str) -> None:
    profile = load_profile(name)
    assert {"dome.rings", "dome.radius_mm", "optics.pupil_diameter_mm"} <= set(profile.assumed)
    plan = default_plan(profile)
    assert len(plan.views) == 12
    assert len(plan.lights) == 16
    farthest = max(np.hypot(x, y) for x, y in _disc_edges(profile, plan))
    assert farthest <= profile.optics.pupil_diameter_mm / 2 + 0.3


def _disc_edges(profile: InstrumentProfile, plan: Plan) -> list[tuple[float, float]]:
    from reliefscope.models.apertures import pixel_centres_mm

    x_mm, y_mm = pixel_centres_mm(profile.glass)
    return [
        (float(x_mm[column]), float(y_mm[row]))
        for view in plan.views
        for row, column in np.argwhere(view.bitmap)
    ]


def test_led_positions_lie_on_the_dome_at_their_elevation() -> None:
    dome = load_profile("benchtop").dome
    np.testing.assert_allclose(np.linalg.norm(dome.positions_mm, axis=1), dome.radius_mm)
    np.testing.assert_allclose(
        np.degrees(np.arcsin(dome.positions_mm[:, 2] / dome.radius_mm)), [22.5] * 8 + [45.0] * 8
    )


def test_a_plan_takes_every_pair_and_what_corrects_it() -> None:
    plan = default_plan(load_profile("benchtop"))
    requests = list(plan.requests())
    assert len({request.key for request in requests}) == len(requests) == 1 + 16 + 192 + 1
    pairs = {(r.view, r.light) for r in requests if r.kind == "view"}
    assert pairs == {(view, light) for view in range(12) for light in range(16)}
    changes = sum(a.view != b.view for a, b in itertools.pairwise(requests))
    assert changes == 13  # the glass changes once per view, not once per frame


def test_a_plan_survives_a_file() -> None:
    plan = default_plan(load_profile("benchtop"))
    assert Plan.model_validate_json(plan.model_dump_json()) == plan
    assert Plan.model_validate(yaml.safe_load(yaml.safe_dump(plan.model_dump(mode="json")))) == plan


def test_an_unknown_key_is_named_with_its_nearest_neighbour(tmp_path: Path) -> None:
    content = load_profile("benchtop").model_dump(mode="json")
    content["optics"]["tube_focl_mm"] = content["optics"].pop("tube_focal_mm")
    path = tmp_path / "mine.yml"
    path.write_text(yaml.safe_dump(content))
    with pytest.raises(InvalidInputError, match="did you mean `tube_focal_mm`") as caught:
        load_model(InstrumentProfile, path)
    assert "optics.tube_focal_mm: Field required" in caught.value.message


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("a: [1, 2", "not valid YAML"),
        ("- 1\n- 2\n", "holds no mapping"),
        ("\xff", "not a valid|no mapping|cannot be read"),
    ],
)
def test_damaged_files_are_refused_with_their_place(tmp_path: Path, text: str, words: str) -> None:
    path = tmp_path / "bad.yml"
    path.write_bytes(text.encode("latin-1"))
    with pytest.raises(InvalidInputError, match=words):
        load_model(InstrumentProfile, path)


def test_a_missing_file_and_an_unknown_name_are_told_apart(tmp_path: Path) -> None:
    with pytest.raises(InvalidInputError, match="does not exist"):
        load_profile(str(tmp_path / "none.yml"))
    with pytest.raises(InvalidInputError, match="no instrument profile") as caught:
        load_profile("bench")
    assert "benchtop" in caught.value.hint


def test_an_assumption_about_nothing_is_refused() -> None:
    content = load_profile("benchtop").model_dump()
    content["assumed"] = {"optics.colour": "nobody knows"}
    with pytest.raises(ValueError, match=r"optics\.colour"):
        InstrumentProfile.model_validate(content)


def test_a_resized_profile_keeps_the_scale() -> None:
    profile = load_profile("benchtop").resized(320, 240)
    assert profile.shape == (240, 320)
    assert profile.pixel_um == load_profile("benchtop").pixel_um


def test_as_many_intensities_as_leds() -> None:
    nominal = Calibration.nominal(load_profile("benchtop")).model_dump()
    nominal["led_intensities"] = nominal["led_intensities"][:-1]
    with pytest.raises(ValueError, match="16 led_positions_mm but 15"):
        Calibration.model_validate(nominal)
