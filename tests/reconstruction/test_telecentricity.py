"""Telecentricity of the simulated instrument: what its calibration tells takes the distortion out."""

from pathlib import Path

import numpy as np
import yaml

from reliefscope.acquisition import acquire
from reliefscope.camera import open_camera
from reliefscope.device import Device
from reliefscope.models.instrument import load_profile
from reliefscope.models.plan import default_plan
from reliefscope.reconstruction.joint import match_jointly
from reliefscope.reconstruction.registration import to_reference
from reliefscope_sim.offer import describe
from reliefscope_sim.scenes import load_scene
from reliefscope_sim.url import SimUrl

KAPPA_PER_MM = 0.5
SCENE = "scene=hemisphere&scene.texture=0.4&scene.radius_um=140&scene.base_um=-60"


def test_a_lens_that_is_not_telecentric_is_taken_out(tmp_path: Path) -> None:
    profile = load_profile("benchtop")
    optics = profile.optics.model_copy(update={"telecentricity_per_mm": KAPPA_PER_MM})
    file = tmp_path / "profile.yml"
    file.write_text(yaml.safe_dump(profile.model_copy(update={"optics": optics}).model_dump()))
    url = f"sim://leaning?size=160x128&profile={file}&{SCENE}"
    offer = describe(url)
    plan = default_plan(offer.profile)
    plan = plan.model_copy(update={"lights": plan.lights[8::4]})
    with Device.open(url) as device:
        camera = open_camera(url)
        try:
            run = acquire(device, camera, plan, offer.profile, offer.calibration, tmp_path / "run")
        finally:
            camera.close()
    assert run.telecentricity_per_um == KAPPA_PER_MM / 1000
    address = SimUrl.parse(url)
    options = dict(address.scene_options)
    scene = load_scene(address.scene, address.seed, options, shape=run.shape, pixel_um=run.pixel_um)
    margins = [(a - b) // 2 for a, b in zip(scene.height_um.shape, run.shape, strict=True)]
    truth = scene.height_um[tuple(slice(m, m + n) for m, n in zip(margins, run.shape, strict=True))]

    frames = np.zeros((len(plan.lights), len(plan.views), *run.shape), np.float32)
    for view, light, image in run.stack():
        frames[light, view] = image
    spread, errors = [], []
    inside = np.s_[24:-24, 24:-24]
    for kappa in (run.telecentricity_per_um, 0.0):
        found = match_jointly(
            frames, run.views, (-60.0, 90.0), run.pixel_um, telecentricity_per_um=kappa
        )
        errors.append(float(np.nanmedian(np.abs(found.height_um - truth)[inside])))
        registered = to_reference(
            frames[0], run.views, truth, run.pixel_um, telecentricity_per_um=kappa
        )
        spread.append(float(np.nanmean(registered[(slice(None), *inside)].std(axis=0))))
    assert errors[0] < 0.4 * errors[1], errors
    assert spread[0] < 0.9 * spread[1], spread
