"""The simulated instrument beside Mitsuba 3: same scene, apertures and LEDs, nothing fitted."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from bench.pathtrace.compare import compare, figures, plain_profile
from bench.pathtrace.tracer import mitsuba, start

from reliefscope.errors import InvalidInputError
from reliefscope_sim.scenes import load_scene

pytestmark = pytest.mark.soak

SHAPE = (300, 400)
WINDOW = (slice(40, -40), slice(40, -40))


@pytest.fixture(scope="module", autouse=True)
def _path_tracer():
    pytest.importorskip("mitsuba", reason="left out: Mitsuba 3 is absent (extra `pathtrace`)")
    try:
        mitsuba()
    except InvalidInputError as error:
        pytest.skip(f"left out: {error}")
    start(1)


def beside(name, pair, *, matt=False, **options):
    """Figures without diffraction of each region, by name, and the pair itself."""
    profile = plain_profile()
    scene = load_scene(name, 1, options, shape=SHAPE, pixel_um=profile.pixel_um)
    if matt:
        scene = replace(scene, specular=None, roughness=None)
    (done,) = compare(scene, [pair], WINDOW, shape=SHAPE, rays_per_pixel=64)
    return {each.region: each for each in figures(done, seen=False)}, done


def test_a_white_level_surface_is_as_bright():
    found, _ = beside("flat", (0, 9), albedo=0.9)
    assert found["everywhere"].ratio == pytest.approx(1.0, abs=0.004)
    assert found["everywhere"].rms < 0.01


@pytest.mark.parametrize("pair", [(0, 0), (11, 9)])
def test_the_dull_fiducial_looks_the_same(pair):
    found, done = beside("fiducial", pair, finish="dull")
    assert found["everywhere"].ratio == pytest.approx(1.0, abs=0.02)
    assert found["in the light"].ratio == pytest.approx(1.0, abs=0.01)
    assert found["in the light"].median < 0.03
    assert found["in the shade"].ratio == pytest.approx(1.0, abs=0.2)
    assert np.hypot(*done.displacement_px) < 0.03


def test_gloss_and_what_it_throws_into_pits_are_as_bright():
    found, _ = beside("fiducial", (11, 9), finish="metallic")
    assert found["in the light"].ratio == pytest.approx(1.0, abs=0.05)
    assert found["in the shade"].ratio == pytest.approx(1.0, abs=0.3)


def test_matt_grains_look_the_same():
    found, done = beside("regolith", (11, 9), matt=True)
    assert found["everywhere"].ratio == pytest.approx(1.0, abs=0.02)
    assert found["in the light"].ratio == pytest.approx(1.0, abs=0.015)
    assert np.hypot(*done.displacement_px) < 0.03


def test_a_mirrored_scene_does_not_pass():
    profile = plain_profile()
    scene = load_scene("fiducial", 1, {}, shape=SHAPE, pixel_um=profile.pixel_um)
    upside_down = replace(
        scene, height_um=scene.height_um[::-1].copy(), albedo=scene.albedo[::-1].copy()
    )
    right, wrong = (
        compare(each, [(0, 2)], WINDOW, shape=SHAPE, rays_per_pixel=16)[0]
        for each in (scene, upside_down)
    )
    alike = np.corrcoef(right.twin.ravel(), right.tracer.ravel())[0, 1]
    mirrored = np.corrcoef(right.twin.ravel(), wrong.tracer[::-1].ravel())[0, 1]
    assert alike > 0.97
    assert mirrored < 0.8
