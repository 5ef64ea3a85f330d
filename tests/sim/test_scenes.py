"""Samples by name, their options, and the state of an instrument as built."""

import cv2
import numba
import numpy as np
import pytest
from tests.sim import optics_bench as ob
from tests.support import shared_data

from reliefscope.errors import InvalidInputError
from reliefscope.models.calibration import Calibration
from reliefscope.models.instrument import load_profile
from reliefscope.targets import Fiducial3D
from reliefscope_sim.as_built import AsBuilt
from reliefscope_sim.optics import Renderer
from reliefscope_sim.scenes import SCENES, Scene, load_scene
from reliefscope_sim.scenes.grains.simulants import SIMULANTS
from reliefscope_sim.scenes.scene import MARGIN_PX

PITCH = 1.116
SHAPE = (96, 128)


def load(name, seed=1, **options):
    return load_scene(name, seed, options, shape=SHAPE, pixel_um=PITCH)


def middle(values):
    return values[MARGIN_PX:-MARGIN_PX, MARGIN_PX:-MARGIN_PX]


@pytest.mark.parametrize("name", sorted(set(SCENES) - {"heightmap"}))
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
        ("regolith", {"simulant": "gobi"}, "no simulant `gobi`"),
        ("chrome", {"target": "cone"}, "no target `cone`"),
        ("heightmap", {}, "needs a file"),
        ("heightmap", {"file": "absent.x3p"}, "no height map `absent.x3p`"),
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


def test_chrome_balls_are_mirrors_on_a_matt_plate():
    ball = load("chrome", radius_um=40)
    metal = ball.specular.max(axis=2) > 0
    assert metal.sum() * PITCH**2 == pytest.approx(np.pi * 40**2, rel=0.02)
    assert ball.albedo[metal].max() == 0
    assert ball.height_um.max() == pytest.approx(6.0, abs=0.1)
    assert ball.height_um[~metal].max() == pytest.approx(-34.0)
    assert (load("chrome", target="balls", radius_um=15).specular[..., 0] > 0).sum() > metal.sum()
    flat = load("chrome", target="flat", tilt_deg=22.5, azimuth_deg=90)
    rise = -np.diff(flat.height_um, axis=0) / PITCH
    assert np.allclose(rise, np.tan(np.radians(22.5)), atol=1e-4)


def test_a_light_shines_in_a_chrome_ball_half_way_toward_it():
    """The mirror law: the normal at the highlight is half way between the light and the viewer."""
    profile = ob.profile()
    scene = load_scene("chrome", 0, {"radius_um": 50}, shape=ob.SHAPE, pixel_um=profile.pixel_um)
    renderer = Renderer(profile, scene, AsBuilt.nominal(profile), ob.SHAPE)
    for led in (0, profile.dome.count - 1):
        energy = np.zeros(profile.dome.count)
        energy[led] = ob.ENERGY_S
        signal = renderer.signal(ob.disc(profile, 1.5), energy)
        bright = np.where(signal > 0.5 * signal.max(), signal, 0.0)
        x_um, y_um = ob.coordinates(profile)
        place = np.array([(bright * x_um).sum(), (bright * y_um).sum()]) / bright.sum()
        light = profile.dome.positions_mm[led] / np.linalg.norm(profile.dome.positions_mm[led])
        half = light + np.array([0.0, 0.0, 1.0])
        expected = 50 * half[:2] / np.linalg.norm(half)
        assert np.abs(place - expected).max() < 1.5


def test_any_height_map_is_a_scene(tmp_path):
    x_um = np.arange(300) * 1.0
    ridge = np.broadcast_to(20 * np.sin(x_um / 25), (200, 300)) + 0.3 * x_um
    np.savez(tmp_path / "ridge.npz", height_um=ridge, pixel_um=[1.0, 1.0])
    path = str(tmp_path / "ridge.npz")

    def heights(**options):
        return load("heightmap", file=path, **options).height_um

    level = heights()
    assert abs(np.median(level)) < 1e-3
    assert 38 < np.ptp(level) < 48
    assert np.ptp(heights(level="no")) > 60
    assert np.allclose(heights(z_scale=0.5), 0.5 * level, atol=1e-4)
    assert np.allclose(heights(offset_um=12.0), level + 12, atol=1e-4)
    # Twice as wide: half as steep, about the same middle.
    wide = heights(width_um=600)
    rise, wide_rise = (np.abs(np.diff(each, axis=1)).max() for each in (level, wide))
    assert wide_rise == pytest.approx(rise / 2, rel=0.05)
    glossy = load("heightmap", file=path, specular=0.6, albedo=0.5)
    assert glossy.specular.max() == pytest.approx(0.6)
    assert glossy.albedo.max() <= 0.4 + 1e-6
    with pytest.raises(InvalidInputError, match="um from the focal plane") as caught:
        heights(z_scale=1000)
    assert "z_scale" in caught.value.hint


def test_real_surfaces_are_scenes():
    folder = shared_data("surface_heightmaps")
    for name, options in (
        ("x3p-2.x3p", {"width_um": 400, "z_scale": 100}),
        ("frt-1_um.npz", {"width_um": 1200, "z_scale": 0.2}),
        ("al3d-1_um.npz", {"z_scale": 20}),
    ):
        scene = load("heightmap", file=str(folder / name), **options)
        assert 1 < np.ptp(scene.height_um) < 300


def test_maps_of_a_scene_must_fit_together():
    height = np.zeros(SHAPE, dtype=np.float32)
    with pytest.raises(InvalidInputError, match="albedo"):
        Scene("bad", 1.0, height, np.zeros((3, 3), dtype=np.float32))
    with pytest.raises(InvalidInputError, match="finite"):
        Scene("bad", 1.0, height * np.nan, height)
    with pytest.raises(InvalidInputError, match="together"):
        Scene("bad", 1.0, height, height, specular=height)


@pytest.mark.parametrize("simulant", sorted(SIMULANTS))
def test_regolith_knows_each_grain_and_where_it_shows(simulant):
    scene = load("regolith", simulant=simulant, grains=60)
    index = scene.grain_index
    assert index.shape == scene.height_um.shape
    assert len(np.unique(index)) > 15
    kinds = SIMULANTS[simulant].all_kinds
    for number in np.unique(index[index >= 0]):
        grain = scene.grains[number]
        low, high = kinds[grain.kind].radii_um
        assert low <= grain.radius_um <= high
        # Where it shows, the surface lies between its lowest and its highest point, but for its roughness.
        vertices, _ = grain.mesh_um()
        shown = scene.height_um[index == number]
        assert shown.max() < vertices[:, 2].max() + 6 * kinds[grain.kind].material.relief_um
        assert shown.min() > vertices[:, 2].min() - 6 * kinds[grain.kind].material.relief_um
    low, high = np.percentile(scene.height_um, [0.5, 99.5])
    assert low + high == pytest.approx(0, abs=0.1)


def test_sizes_of_grains_follow_their_power_law():
    red_brown = SIMULANTS["mars1"].kinds[0]
    grains = SIMULANTS["mars1"].draw(np.random.default_rng(1), 4000)
    radii = np.array([grain.radius_um for grain in grains if grain.kind == 0])
    assert len(radii) == pytest.approx(4000 * red_brown.share, rel=0.05)
    low, high = red_brown.radii_um
    for size in (10.0, 20.0, 30.0):
        above = np.array([size, high]) ** -red_brown.steepness
        expected = (above[0] - above[1]) / (low**-red_brown.steepness - high**-red_brown.steepness)
        assert (radii > size).mean() == pytest.approx(expected, abs=0.03)


def test_simulants_look_as_the_paper_says():
    """Section V.B: dark asteroid with a white grain, red-brown Mars, dark grey Moon."""
    scenes = {name: load("regolith", simulant=name) for name in SIMULANTS}
    mean = {name: scene.albedo.mean(axis=(0, 1)) for name, scene in scenes.items()}
    red, green, blue = mean["mars1"]
    assert red > 1.5 * green > 2.2 * blue
    assert np.ptp(mean["jsc1a"]) < 0.05 * mean["jsc1a"].max()
    assert mean["jsc1a"].max() < 0.6 * red
    # The asteroid's albedo is that of single scattering: a fifth and less of it comes back.
    assert scenes["ds1"].hapke.mean() > 0.7
    gloss = scenes["jsc1a"].specular.max(axis=2)
    assert 0.01 < (gloss > 0.1).mean() < 0.1


def test_the_asteroid_carries_its_white_grain_on_top_left_of_the_middle():
    scene = load_scene("regolith", 1, {"simulant": "ds1"}, shape=(420, 560), pixel_um=PITCH)
    white = scene.grains[-1]
    long, middle, short = white.size_um
    assert long == pytest.approx(300)
    assert middle == pytest.approx(100, abs=15)
    assert short == pytest.approx(100, abs=15)
    shown = scene.grain_index == len(scene.grains) - 1
    # All of it shows: its outline is that of an ellipse of its size.
    assert shown.sum() * PITCH**2 == pytest.approx(np.pi / 4 * long * middle, rel=0.15)
    assert white.centre_um[0] < -50
    assert scene.albedo[shown].mean() > 0.5
    # There is no room for it in a small frame.
    assert load("regolith", simulant="ds1").grains[-1].radius_um < 40


def test_regolith_does_not_depend_on_the_number_of_threads():
    threads = numba.get_num_threads(), cv2.getNumThreads()
    first = load("regolith", simulant="jsc1a")
    try:
        numba.set_num_threads(1)
        cv2.setNumThreads(1)
        alone = load("regolith", simulant="jsc1a")
    finally:
        numba.set_num_threads(threads[0])
        cv2.setNumThreads(threads[1])
    for label in ("height_um", "albedo", "specular", "roughness", "grain_index"):
        assert np.array_equal(getattr(first, label), getattr(alone, label)), label


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
