"""Samples by name, their options, and the state of an instrument as built."""

import numpy as np
import pytest

from reliefscope.errors import InvalidInputError
from reliefscope.models.calibration import Calibration
from reliefscope.models.instrument import load_profile
from reliefscope.targets import Fiducial3D
from reliefscope_sim.as_built import AsBuilt
from reliefscope_sim.scenes import SCENES, Scene, load_scene
from reliefscope_sim.scenes.regolith import drop_grains
from reliefscope_sim.scenes.scene import MARGIN_PX

PITCH = 1.116
SHAPE = (96, 128)


def load(name, seed=1, **options):
    return load_scene(name, seed, options, shape=SHAPE, pixel_um=PITCH)


def middle(values):
    return values[MARGIN_PX:-MARGIN_PX, MARGIN_PX:-MARGIN_PX]


@pytest.mark.parametrize("name", sorted(SCENES))
def test_scenes_have_a_margin_sane_values_and_depend_on_their_seed_alone(name):
    scene = load(name)
    assert middle(scene.height_um).shape == SHAPE
    assert scene.height_um.dtype == scene.albedo.dtype == np.float32
    assert scene.albedo.min() >= 0
    assert scene.albedo.max() <= 1
    again = load(name)
    assert np.array_equal(scene.height_um, again.height_um)
    assert np.array_equal(scene.albedo, again.albedo)
    if name in {"fiducial", "regolith"}:
        assert not np.array_equal(scene.albedo, load(name, seed=2).albedo)


def test_printed_fiducial_follows_the_design_within_half_a_layer():
    scene = load_scene("fiducial", 1, {}, shape=(1038, 1388), pixel_um=PITCH)
    truth = Fiducial3D().height_um((1038, 1388), PITCH)
    error = middle(scene.height_um) - truth
    assert np.abs(error).mean() < 0.2
    assert abs(np.median(error)) < 0.02
    assert not scene.coloured


def test_finishes_run_from_diffuse_to_mirror():
    finishes = [load("fiducial", finish=finish) for finish in ("dull", "half", "metallic")]
    albedo = [scene.albedo.mean() for scene in finishes]
    gloss = [0.0 if s.specular is None else s.specular.mean() for s in finishes]
    assert albedo[0] > albedo[1] > albedo[2]
    assert gloss[0] < gloss[1] < gloss[2]


def test_walls_carry_less_film_than_level_faces():
    shape = (400, 400)
    scene = load_scene("fiducial", 1, {}, shape=shape, pixel_um=PITCH)
    height = middle(scene.height_um)
    wall = np.hypot(*np.gradient(height)) > 20
    ratio = middle(scene.albedo)[wall].mean() / middle(scene.albedo)[~wall].mean()
    assert wall.sum() > 500
    assert ratio == pytest.approx(0.43, abs=0.06)


def test_options_come_as_text_too():
    assert np.unique(load("flat", height_um="12.5").height_um).tolist() == [12.5]
    tilted = load("plane", tilt_deg="30", azimuth_deg="90").height_um
    across, down = np.diff(tilted, axis=1), -np.diff(tilted, axis=0)
    assert np.abs(across).max() < 1e-3
    assert down.mean() == pytest.approx(np.tan(np.radians(30)) * PITCH, rel=1e-4)


@pytest.mark.parametrize(
    ("name", "options", "said"),
    [
        ("moon", {}, "no scene `moon`"),
        ("fiducial", {"finish": "shiny"}, "no finish `shiny`"),
        ("fiducial", {"finsh": "dull"}, "no option `finsh`"),
        ("flat", {"albedo": "white"}, "albedo=white"),
        ("flat", {"albedo": 1.5}, "from 0 to 1"),
        ("flat", {"height_um": "nan"}, "height_um=nan"),
    ],
)
def test_what_a_scene_does_not_know_is_refused_with_what_it_does(name, options, said):
    with pytest.raises(InvalidInputError, match=said) as caught:
        load(name, 1, **options)
    assert caught.value.hint
    if name == "moon":
        assert "fiducial" in caught.value.hint
    if "finsh" in options:
        assert "Did you mean `finish`?" in caught.value.hint


def test_maps_of_a_scene_must_fit_together():
    height = np.zeros(SHAPE, dtype=np.float32)
    with pytest.raises(InvalidInputError, match="albedo"):
        Scene("bad", 1.0, height, np.zeros((3, 3), dtype=np.float32))
    with pytest.raises(InvalidInputError, match="finite"):
        Scene("bad", 1.0, height * np.nan, height)
    with pytest.raises(InvalidInputError, match="together"):
        Scene("bad", 1.0, height, height, specular=height)


def test_grains_rest_on_what_lies_below_them():
    generator = np.random.default_rng(8)
    surface, kind, shade, grains = drop_grains(generator, 60, (200, 200), 2.0)
    assert surface.min() >= 0
    assert kind.shape == shade.shape == surface.shape
    assert 40 < len(grains) <= 60
    for grain in grains:
        # No grain sinks below the table: its centre stays above by its extent along z.
        A = grain.rotation @ np.diag(np.square(grain.semi_axes_um)) @ grain.rotation.T
        assert grain.centre_um[2] >= np.sqrt(A[2, 2]) - 2.0
        assert np.allclose(grain.rotation @ grain.rotation.T, np.eye(3), atol=1e-12)
        assert np.linalg.det(grain.rotation) == pytest.approx(1.0)


def test_an_instrument_as_built_departs_within_its_tolerances_and_tells_the_factory():
    profile = load_profile("benchtop")
    drawn = [AsBuilt.draw(profile, seed) for seed in range(40)]
    for built in drawn:
        assert np.hypot(*built.glass_offset_mm) <= 0.3
        assert abs(built.glass_rotation_rad) <= np.radians(2.0)
        assert 1.0 <= built.pupil_scale <= 1.15
        moved = np.abs(built.led_positions_mm - profile.dome.positions_mm)
        assert 0 < moved.max() <= 1.0
        assert 0.8 <= built.led_intensities.min() < built.led_intensities.max() <= 1.2
        calibration = built.factory_calibration(profile)
        assert calibration.source == "factory"
        assert calibration.glass_offset_mm == built.glass_offset_mm
        assert np.array_equal(calibration.led_positions_mm, built.led_positions_mm)
    assert len({built.pupil_scale for built in drawn}) == 40
    assert AsBuilt.draw(profile, 3).glass_offset_mm == drawn[3].glass_offset_mm


def test_the_nominal_instrument_is_its_profile():
    profile = load_profile("miniature")
    calibration = AsBuilt.nominal(profile).factory_calibration(profile)
    nominal = Calibration.nominal(profile)
    assert calibration == nominal.model_copy(update={"source": "factory"})
