"""Reading: linear light against closed forms, geometry against the calibration in use, streaming."""

import math
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from tests.dataset.helpers import make_run, record, small_plan, small_profile, small_spec

from reliefscope.dataset import FrameRecord, IncompleteRunWarning, Run, RunSpec, RunWriter
from reliefscope.dataset.sensor_image import colour, luminance
from reliefscope.errors import DatasetError, InvalidInputError
from reliefscope.models.plan import Aperture, Light
from reliefscope.units import RawImage


def mosaic_of(rgb: NDArray[np.floating]) -> NDArray[np.floating]:
    """What an RGGB sensor sees of (H, W, 3)."""
    mosaic = rgb[:, :, 1].copy()
    mosaic[0::2, 0::2] = rgb[0::2, 0::2, 0]
    mosaic[1::2, 1::2] = rgb[1::2, 1::2, 2]
    return mosaic


def test_luminance_of_a_uniform_colour_has_no_trace_of_the_mosaic() -> None:
    rgb = np.broadcast_to(np.array([0.2, 0.5, 0.9], dtype=np.float32), (16, 20, 3))
    image = luminance(mosaic_of(rgb).astype(np.float32), "bayer_rggb")
    np.testing.assert_allclose(image, (0.2 + 2 * 0.5 + 0.9) / 4, rtol=1e-6)


def test_luminance_of_a_linear_ramp_is_exact_inside() -> None:
    rows, columns = np.mgrid[:20, :24].astype(np.float32)
    plane = 0.3 + 0.01 * columns + 0.02 * rows
    rgb = plane[:, :, None] * np.array([0.5, 1.0, 0.7], dtype=np.float32)
    image = luminance(mosaic_of(rgb).astype(np.float32), "bayer_rggb")
    expected = plane * (0.5 + 2 * 1.0 + 0.7) / 4
    np.testing.assert_allclose(image[1:-1, 1:-1], expected[1:-1, 1:-1], rtol=1e-5)


def test_luminance_moves_with_the_scene_whatever_the_mosaic_phase() -> None:
    rng = np.random.default_rng(1)
    grey = rng.random((40, 40)).astype(np.float32)
    scene = np.repeat(grey[:, :, None], 3, axis=2)
    for rows, columns in ((0, 1), (1, 0), (1, 1)):
        moved = np.roll(scene, (rows, columns), axis=(0, 1))
        there = luminance(mosaic_of(moved).astype(np.float32), "bayer_rggb")
        here = np.roll(
            luminance(mosaic_of(scene).astype(np.float32), "bayer_rggb"),
            (rows, columns),
            axis=(0, 1),
        )
        np.testing.assert_allclose(there[3:-3, 3:-3], here[3:-3, 3:-3], rtol=1e-5)


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16, np.float32])
def test_luminance_takes_every_stored_type(dtype: type[np.generic]) -> None:
    counts = np.arange(64, dtype=dtype).reshape(8, 8)
    for sensor in ("mono", "bayer_rggb"):
        image = luminance(counts, sensor, 0.5)
        assert image.dtype == np.float32
        assert image[4, 4] == pytest.approx(float(counts[4, 4]) / 2)


def test_colour_of_a_ramp_is_exact_inside() -> None:
    rows, columns = np.mgrid[:16, :18].astype(np.float32)
    plane = 1 + 0.1 * columns - 0.05 * rows
    rgb = plane[:, :, None] * np.array([0.5, 1.0, 0.25], dtype=np.float32)
    got = colour(mosaic_of(rgb).astype(np.float32), "bayer_rggb")
    np.testing.assert_allclose(got[1:-1, 1:-1], rgb[1:-1, 1:-1], rtol=1e-5)


def physical_run(path: Path, sensor: str, *, dark: bool, leakage: bool) -> tuple[Run, float]:
    """A run whose counts follow from a uniform sample, an offset, and leaking glass."""
    profile = small_profile(sensor=sensor, black_level=0.02)
    plan = small_plan(
        profile, dark_accumulate=16 if dark else 0, leakage_accumulate=4 if leakage else 0
    )
    bitmaps = [np.zeros((64, 128), dtype=bool) for _ in range(2)]
    bitmaps[0][30:32, 60:64] = True  # 8 pixels
    bitmaps[1][30:34, 60:64] = True  # 16 pixels
    plan = plan.model_copy(
        update={
            "views": tuple(
                Aperture(name=f"v{index}", bitmap=bitmap) for index, bitmap in enumerate(bitmaps)
            ),
            "centre": plan.centre,
            "lights": (Light(name="a", levels={0: 4095}), Light(name="b", levels={1: 2000})),
            "centre_light": Light(name="both", levels={0: 819, 1: 500}),
        }
    )
    spec = small_spec(profile, plan)
    black, per_pixel, leak = 80, 100, 60
    light_factor = (1.0, 2.0)

    def counts(kind: str, view: int | None, light: int | None) -> int:
        if kind == "dark":
            return black
        if kind == "leakage":
            return black + round(leak * light_factor[light or 0])
        if kind == "centre":
            assert plan.centre is not None
            share = light_factor[0] * 819 / 4095 + light_factor[1] * 500 / 2000
            return black + round((per_pixel * plan.centre.open_pixels + leak) * share)
        return black + round(
            (per_pixel * plan.views[view or 0].open_pixels + leak) * light_factor[light or 0]
        )

    with RunWriter.create(path, spec) as writer:
        for request in writer.missing():
            value = counts(request.kind, request.view, request.light) * request.accumulate
            raw: RawImage = np.full(spec.frame.shape, value, dtype=np.uint16)
            writer.put(record(request, exposure_us=plan.exposure_us), raw)
        run = Run.open(writer.finish())
    return run, per_pixel * 12 / 4095


@pytest.mark.parametrize("sensor", ["mono", "bayer_rggb"])
def test_views_of_different_apertures_come_to_equal_gain(tmp_path: Path, sensor: str) -> None:
    run, expected = physical_run(tmp_path / "run", sensor, dark=True, leakage=True)
    for view in range(2):
        for light, factor in enumerate((1.0, 2.0)):
            np.testing.assert_allclose(run.linear(view, light), expected * factor, rtol=2e-5)
            np.testing.assert_allclose(run.rgb("view", view, light), expected * factor, rtol=2e-5)
    # The leakage of the centre light is the sum of its LEDs' leakages.
    centre = expected * (819 / 4095 + 2 * 500 / 2000)
    np.testing.assert_allclose(run.luminance("centre", None, None), centre, rtol=2e-3)
    np.testing.assert_allclose(run.rgb("centre", None, None), centre, rtol=2e-3)


def test_without_dark_frames_the_black_level_is_taken_off(tmp_path: Path) -> None:
    run, _ = physical_run(tmp_path / "run", "mono", dark=False, leakage=False)
    expected = (80 + (800 + 60) - 0.02 * 4095) * 12 / 8 / 4095
    np.testing.assert_allclose(run.linear(0, 0), expected, rtol=1e-5)


def test_without_dark_frames_leakage_is_still_taken_off(tmp_path: Path) -> None:
    run, expected = physical_run(tmp_path / "run", "mono", dark=False, leakage=True)
    np.testing.assert_allclose(run.linear(0, 0), expected, rtol=2e-5)


def test_exposure_is_brought_to_the_plan(tmp_path: Path) -> None:
    profile = small_profile(sensor="mono", black_level=0.0)
    plan = small_plan(
        profile, dark_accumulate=0, leakage_accumulate=0, centre=None, centre_light=None
    )
    spec = small_spec(profile, plan)
    with RunWriter.create(tmp_path / "run", spec) as writer:
        for request in writer.missing():
            raw: RawImage = np.full(spec.frame.shape, 1000, dtype=np.uint16)
            writer.put(record(request, exposure_us=2 * plan.exposure_us), raw)
        run = Run.open(writer.finish())
    gain = np.mean([view.open_pixels for view in plan.views]) / plan.views[0].open_pixels
    np.testing.assert_allclose(run.linear(0, 0), 500 / 4095 * gain, rtol=1e-5)


def test_streams_agree_with_single_frames(tmp_path: Path) -> None:
    run = make_run(tmp_path / "run")
    whole = run.linear_stack()
    assert whole.shape == (3, 2, *run.shape)
    seen = []
    for view, light, image in run.stack():
        np.testing.assert_array_equal(image, run.linear(view, light))
        np.testing.assert_array_equal(image, whole[view, light])
        seen.append((view, light))
    assert seen == [(view, light) for view in range(3) for light in range(2)]
    out = np.empty((2, *run.shape), dtype=np.float32)
    assert run.linear_stack(view=1, out=out) is out
    np.testing.assert_array_equal(out, whole[1])
    np.testing.assert_array_equal(run.linear_stack(light=1), whole[:, 1])
    with pytest.raises(ValueError, match="float32"):
        run.linear_stack(view=1, out=np.empty((3, *run.shape), dtype=np.float32))


def test_a_stream_may_be_left_early(tmp_path: Path) -> None:
    run = make_run(tmp_path / "run")
    for _ in run.stack():
        break
    assert len(list(run.stack(views=[2], lights=[1]))) == 1


def test_geometry_follows_the_calibration_in_use(tmp_path: Path) -> None:
    run = make_run(tmp_path / "run")
    assert run.views is not None
    assert run.lights is not None
    assert run.calibration is not None
    assert run.views.shape == (3, 2)
    np.testing.assert_allclose(np.linalg.norm(run.lights, axis=1), 1)
    assert run.lights[0] == pytest.approx(
        [math.cos(math.radians(22.5)), 0, math.sin(math.radians(22.5))]
    )
    np.testing.assert_allclose(run.powers, 1)
    better = run.calibration.model_copy(
        update={"pupil_scale": 1.125, "telecentricity_per_mm": 0.008, "source": "measured"}
    )
    other = run.with_calibration(better)
    assert run.telecentricity_per_um == 0.0
    assert other.telecentricity_per_um == pytest.approx(8e-6)
    np.testing.assert_allclose(other.views, run.views / 1.125)
    assert run.spec.calibration is not None
    assert run.spec.calibration.pupil_scale == 1.0
    np.testing.assert_array_equal(other.linear(0, 0), run.linear(0, 0))
    few = run.calibration.model_copy(
        update={
            "led_positions_mm": run.calibration.led_positions_mm[:4],
            "led_intensities": run.calibration.led_intensities[:4],
        }
    )
    with pytest.raises(InvalidInputError, match="4 LEDs"):
        run.with_calibration(few)


def test_the_specification_survives_the_file(tmp_path: Path) -> None:
    spec = small_spec()
    run = make_run(tmp_path / "run", spec)
    assert run.spec == spec
    assert run.spec.storage_bytes() == 10 * 24 * 32 * 2
    assert RunSpec.model_validate_json((run.path / "run.json").read_text()) == spec


def test_a_sum_that_does_not_fit_is_refused() -> None:
    spec = small_spec()
    with pytest.raises(ValueError, match="does not fit into 16 bit"):
        RunSpec.model_validate(
            spec.model_dump() | {"frame": spec.frame.model_dump() | {"bit_depth": 14}}
        )


def test_records_need_a_known_kind() -> None:
    with pytest.raises(ValueError, match="kind"):
        FrameRecord.model_validate({"kind": "bright", "view": 0, "light": 0, "time": "now"})


@pytest.mark.parametrize("lost", ["dark", "leakage"])
def test_a_planned_offset_that_was_not_taken_is_refused(tmp_path: Path, lost: str) -> None:
    physical_run(tmp_path / "run", "mono", dark=True, leakage=True)
    journal = tmp_path / "run" / "journal.jsonl"
    lines = journal.read_text().splitlines(keepends=True)
    journal.write_text("".join(line for line in lines if f'"kind":"{lost}"' not in line))
    with pytest.warns(IncompleteRunWarning):
        run = Run.open(tmp_path / "run")
    for read in (run.luminance, run.rgb):
        with pytest.raises(DatasetError, match=lost) as caught:
            read("view", 0, 0)
        assert f"--resume {tmp_path / 'run'}" in caught.value.hint
    assert run.raw("view", 0, 0).shape == run.shape
