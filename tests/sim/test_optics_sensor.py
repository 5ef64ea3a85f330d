"""The sensor: noise statistics, colour, counts; and frames that are the same whatever computes them."""

import numba
import numpy as np
import pytest
from tests.sim import optics_bench as ob

from reliefscope.errors import Cancelled, InvalidInputError
from reliefscope.jobs import Job
from reliefscope_sim.as_built import AsBuilt
from reliefscope_sim.optics import Renderer
from reliefscope_sim.optics.cache import ByteCache
from reliefscope_sim.scenes import load_scene
from reliefscope_sim.sensor import RGB_RESPONSE, Sensor, fold_key

CAMERA = ob.profile().camera
LARGE = (400, 500)


def frame(level, key=(1, 2, 3), camera=CAMERA):
    signal = np.full(LARGE, level, dtype=np.float32)
    return Sensor(camera).expose(signal, 0.02, key).astype(float)


@pytest.mark.parametrize("level", [0.0, 0.05, 0.5])
def test_mean_and_variance_follow_shot_and_read_noise(level):
    counts = frame(level)
    per_electron = CAMERA.full_scale / CAMERA.full_well_electrons
    electrons = level * CAMERA.full_well_electrons + 5.0 * 0.02
    variance = (electrons + CAMERA.read_noise_electrons**2) * per_electron**2 + 1 / 12
    mean = electrons * per_electron + CAMERA.black_level * CAMERA.full_scale
    size = counts.size
    assert counts.mean() == pytest.approx(mean, abs=5 * (variance / size) ** 0.5)
    assert counts.var() == pytest.approx(variance, rel=5 * (2 / size) ** 0.5)


def test_noise_is_gaussian_and_independent_from_pixel_to_pixel():
    noise = frame(0.5)
    noise = (noise - noise.mean()) / noise.std()
    assert abs((noise**3).mean()) < 0.03
    # Two draws of a table cut at 3.7 standard deviations: hardly below the 3 of a Gaussian.
    assert (noise**4).mean() == pytest.approx(3.0, abs=0.06)
    assert (np.abs(noise) > 3).mean() == pytest.approx(0.0027, abs=0.0006)
    for shifted in (noise[1:] * noise[:-1], noise[:, 1:] * noise[:, :-1], noise[2:] * noise[:-2]):
        assert abs(shifted.mean()) < 5 / noise.size**0.5


def test_noise_is_named_by_its_key():
    same, other = frame(0.3), frame(0.3, (1, 2, 4))
    assert np.array_equal(same, frame(0.3))
    correlation = np.corrcoef(same.ravel(), other.ravel())[0, 1]
    assert abs(correlation) < 5 / same.size**0.5


def test_keys_take_any_whole_numbers_and_their_order_counts():
    keys = [(), (0,), (0, 0), (1, 2), (2, 1), (-1,), (1 << 200,), ((1 << 200) + 1,), (1 << 64, 1)]
    words = {fold_key(key) for key in keys}
    assert len(words) == len(keys)
    assert all(0 <= word < 1 << 64 for word in words)


def test_counts_saturate_and_fit_their_type():
    assert frame(3.0).min() == CAMERA.full_scale
    eight = CAMERA.model_copy(update={"bit_depth": 8})
    raw = Sensor(eight).expose(np.full(LARGE, 0.5, dtype=np.float32), 0.02, (1,))
    assert raw.dtype == np.uint8
    assert raw.mean() == pytest.approx(0.5 * 255 + 0.01 * 255, abs=0.5)


def test_colour_filters_pass_their_own_channel():
    instrument = ob.profile()
    camera = instrument.camera.model_copy(update={"sensor": "bayer_rggb"})
    instrument = instrument.model_copy(update={"camera": camera})
    colour = np.array([0.6, 0.3, 0.15], dtype=np.float32)
    scene = ob.sample(instrument, 0.0, colour[None, None, :])
    renderer = Renderer(instrument, scene, ob.overhead(instrument), ob.SHAPE)
    raw = renderer.expose(ob.disc(instrument, 3.0), ob.one_led(instrument) / 2, 0.02, (1,))
    light = raw.astype(float) - camera.black_level * camera.full_scale
    sites = [light[0::2, 0::2], light[0::2, 1::2], light[1::2, 0::2], light[1::2, 1::2]]
    means = np.array([site.mean() for site in sites])
    expected = np.array([0.6, 0.3, 0.3, 0.15]) * np.array(RGB_RESPONSE)[[0, 1, 1, 2]]
    assert means / means[1] == pytest.approx(expected / expected[1], rel=0.01)


def test_a_mono_sensor_sees_the_mean_of_colours():
    instrument = ob.profile()
    coloured = ob.sample(instrument, 0.0, np.array([0.6, 0.3, 0.15])[None, None, :])
    grey = ob.sample(instrument, 0.0, 0.35)
    built = ob.overhead(instrument)
    images = [ob.render(instrument, s, built, ob.disc(instrument, 1.5)) for s in (coloured, grey)]
    assert np.allclose(images[0], images[1], rtol=1e-5)


@pytest.mark.parametrize(
    ("name", "options"), [("fiducial", {"finish": "metallic"}), ("regolith", {"grains": 60})]
)
def test_frames_are_the_same_bit_for_bit_whatever_the_number_of_threads(name, options):
    instrument = ob.load_profile("benchtop").resized(ob.SHAPE[1], ob.SHAPE[0])
    scene = load_scene(name, 4, options, shape=ob.SHAPE, pixel_um=instrument.pixel_um)
    built = AsBuilt.draw(instrument, 2)
    transmission = np.where(ob.disc(instrument, 1.5, (1.2, 0.4)) > 0, 0.98, 1 / 15)
    most = numba.config.NUMBA_NUM_THREADS
    frames = []
    for threads in (1, most):
        numba.set_num_threads(threads)
        renderer = Renderer(instrument, scene, built, ob.SHAPE)
        frames.append(renderer.expose(transmission, ob.one_led(instrument, 5), 0.02, (9, 5)))
    numba.set_num_threads(most)
    assert np.array_equal(frames[0], frames[1])
    # And whatever was rendered before.
    renderer.signal(ob.disc(instrument, 1.5), ob.one_led(instrument, 2))
    again = renderer.expose(transmission, ob.one_led(instrument, 5), 0.02, (9, 5))
    assert np.array_equal(frames[0], again)


def test_preparing_reports_every_led_stops_on_request_and_changes_no_frame():
    instrument = ob.profile()
    scene = ob.sample(instrument, 0.0, 0.5)
    prepared = Renderer(instrument, scene, AsBuilt.nominal(instrument), ob.SHAPE)
    events = []
    prepared.prepare(Job(events.append))
    assert [event.done for event in events] == [*range(17), 16]
    fresh = Renderer(instrument, scene, AsBuilt.nominal(instrument), ob.SHAPE)
    arguments = (ob.disc(instrument, 1.5), ob.one_led(instrument), 0.02, (1,))
    assert np.array_equal(prepared.expose(*arguments), fresh.expose(*arguments))
    stopped = Job()
    stopped.cancel()
    with pytest.raises(Cancelled):
        fresh.prepare(stopped)


def test_both_profiles_expose_a_white_sample_well():
    for name in ("benchtop", "miniature"):
        instrument = ob.load_profile(name).resized(ob.SHAPE[1], ob.SHAPE[0])
        scene = load_scene("flat", 0, {"albedo": 0.9}, shape=ob.SHAPE, pixel_um=instrument.pixel_um)
        renderer = Renderer(instrument, scene, AsBuilt.nominal(instrument))
        transmission = np.where(ob.disc(instrument, 1.5) > 0, 1.0, 1 / 15)
        energy = ob.one_led(instrument) * instrument.exposure_ms / 20
        raw = renderer.expose(transmission, energy, instrument.exposure_ms / 1000, (1,))
        assert raw.shape == ob.SHAPE
        assert 0.4 < raw.mean() / instrument.camera.full_scale < 0.7


def test_caches_keep_within_their_bound_and_forget_the_oldest():
    cache: ByteCache[bytes] = ByteCache(100, len)
    made = []

    def make(name, size):
        def compute():
            made.append(name)
            return bytes(size)

        return cache.get(name, compute)

    make("a", 40)
    make("b", 40)
    make("a", 40)
    make("c", 40)
    assert cache.held_bytes == 80
    make("a", 40)
    make("b", 40)
    assert made == ["a", "b", "c", "b"]
    make("large", 500)
    assert cache.held_bytes == 500


def test_a_glass_of_another_size_is_refused():
    instrument = ob.profile()
    scene = ob.sample(instrument, 0.0, 0.5)
    renderer = Renderer(instrument, scene, AsBuilt.nominal(instrument), ob.SHAPE)
    with pytest.raises(InvalidInputError, match="glass"):
        renderer.expose(np.ones((10, 10)), ob.one_led(instrument), 0.02, (1,))
    with pytest.raises(InvalidInputError, match="LEDs"):
        renderer.expose(np.ones((64, 128)), np.ones(3), 0.02, (1,))
