"""What spoils a measurement on the bench spoils it in the twin: each mistake shows in the heights or normals."""

from __future__ import annotations

import numpy as np
import pytest

from reliefscope.acquisition import acquire
from reliefscope.axes import normals_from_height
from reliefscope.camera import open_camera
from reliefscope.device import Device
from reliefscope.evaluation.heights import height_errors
from reliefscope.models.plan import default_plan
from reliefscope.reconstruction.pipeline import reconstruct
from reliefscope.reconstruction.settings import PaperSettings, Settings
from reliefscope_sim.offer import describe
from reliefscope_sim.scenes import load_scene
from reliefscope_sim.url import SimUrl

SCENE = "scene=hemisphere&scene.texture=0.4&scene.radius_um=90&scene.base_um=-40"
URL = f"sim://spoiled?size=160x128&{SCENE}"
EDGE = 16
FULL_SCALE = 4095
LEAKAGE_FRAMES = 8
PAPER = Settings(method="paper", paper=PaperSettings(height_step_um=2.0))


class Altered:
    """A run of which some things are told wrongly."""

    def __init__(self, run, **wrong):
        self._run = run
        self.__dict__.update(wrong)

    def __getattr__(self, name):
        return getattr(self._run, name)


class MosaicTakenForMono(Altered):
    """The mosaic itself where luminance should be."""

    def stack(self, views=None, lights=None):
        for view in range(len(self.view_names)) if views is None else views:
            for light in range(len(self.light_names)) if lights is None else lights:
                leakage = self.raw("leakage", None, light) / LEAKAGE_FRAMES
                mosaic = (self.raw("view", view, light) - leakage) / FULL_SCALE
                yield view, light, mosaic.astype(np.float32)


class Judge:
    """Takes runs of a textured hemisphere and compares reconstructions with its true shape."""

    def __init__(self, folder):
        self._folder = folder
        self._offer = describe(URL)
        profile = self._offer.profile
        self._plan = default_plan(profile).model_copy(
            update={"dark_accumulate": 4, "leakage_accumulate": LEAKAGE_FRAMES}
        )
        address = SimUrl.parse(URL)
        options = dict(address.scene_options)
        scene = load_scene(
            address.scene, address.seed, options, shape=profile.shape, pixel_um=profile.pixel_um
        )
        margins = [(a - b) // 2 for a, b in zip(scene.height_um.shape, profile.shape, strict=True)]
        window = tuple(slice(m, m + n) for m, n in zip(margins, profile.shape, strict=True))
        self._truth = scene.height_um[window]
        self._normals = normals_from_height(self._truth, profile.pixel_um)
        self._inside = np.zeros(profile.shape, dtype=bool)
        self._inside[EDGE:-EDGE, EDGE:-EDGE] = True

    def take(self, **changes):
        lights = self._plan.lights[::3]
        plan = self._plan.model_copy(update={"lights": lights} | changes)
        place = self._folder / "-".join(["run", *changes])
        with Device.open(URL) as device:
            camera = open_camera(URL)
            try:
                return acquire(
                    device, camera, plan, self._offer.profile, self._offer.calibration, place
                )
            finally:
                camera.close()

    def errors(self, run):
        """Mean errors of stereo and fused heights in um, median error of the normals in degrees."""
        result = reconstruct(run, PAPER)
        stereo, fused = (
            height_errors(height, self._truth, self._inside).raw_um
            for height in (result.smoothed_height_um, result.height_um)
        )
        cosine = np.sum(result.normals * self._normals, axis=-1)[self._inside]
        return stereo, fused, float(np.degrees(np.median(np.arccos(np.clip(cosine, -1, 1)))))


@pytest.fixture(scope="module")
def judge(tmp_path_factory):
    return Judge(tmp_path_factory.mktemp("spoiled"))


@pytest.fixture(scope="module")
def run(judge):
    return judge.take()


@pytest.fixture(scope="module")
def right(judge, run):
    return judge.errors(run)


def test_done_right_it_measures(right):
    stereo, fused, normals_deg = right
    assert stereo < 2.0
    assert fused < 2.5
    assert normals_deg < 5.0


def test_swapped_axes_spoil_the_heights(judge, run, right):
    stereo, fused, _ = judge.errors(Altered(run, views=run.views[:, ::-1].copy()))
    assert stereo > 10 * right[0]
    assert fused > 5 * right[1]


def test_a_wrong_map_of_the_leds_spoils_the_normals(judge, run, right):
    stereo, fused, normals_deg = judge.errors(Altered(run, lights=np.roll(run.lights, 1, axis=0)))
    assert normals_deg > 5 * right[2]
    assert fused > 2 * right[1]
    assert stereo == pytest.approx(right[0]), "stereo does not ask where the light came from"


def test_a_mosaic_that_is_matched_as_if_it_were_mono_spoils_the_heights(judge, run, right):
    stereo, fused, _ = judge.errors(MosaicTakenForMono(run))
    assert stereo > 2 * right[0]
    assert fused > 1.4 * right[1]


def test_too_short_a_settle_time_spoils_the_heights(judge, right):
    stereo, fused, _ = judge.errors(judge.take(settle_ms=0.0))
    assert stereo > 1.25 * right[0]
    assert fused > 1.15 * right[1]


def test_a_missing_leakage_frame_spoils_the_heights(judge, right):
    stereo, fused, _ = judge.errors(judge.take(leakage_accumulate=0))
    assert stereo > 5 * right[0]
    assert fused > 3 * right[1]
