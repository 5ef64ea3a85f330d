"""The sensor: noise statistics, colour, counts; and frames that are the same whatever computes them."""

import cv2
import numba
import numpy as np
import pytest
from tests.sim import optics_bench as ob

from reliefscope.errors import Cancelled, InvalidInputError
from reliefscope.jobs import Job
from reliefscope.models.instrument import load_profile
from reliefscope_sim.as_built import AsBuilt
from reliefscope_sim.flaws import PIXEL_SPREAD, FlawLevels, SensorFlaws
from reliefscope_sim.optics import Renderer
from reliefscope_sim.optics.cache import ByteCache
from reliefscope_sim.scenes import load_scene
from reliefscope_sim.sensor import RGB_RESPONSE, Sensor, fold_key
from reliefscope_sim.url import SimUrl

CAMERA = ob.profile().camera
LARGE = (400, 500)


def frame(level, key=(1, 2, 3), camera=CAMERA):
    signal = np.full(LARGE, level, dtype=np.float32)
    return Sensor(camera, SensorFlaws.none(LARGE)).expose(signal, 0.02, key).astype(float)


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
    raw = Sensor(eight, SensorFlaws.none(LARGE)).expose(
        np.full(LARGE, 0.5, dtype=np.float32), 0.02, (1,)
    )
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
    ("name", "options", "shape"),
    [
        ("fiducial", {"finish": "metallic"}, ob.SHAPE),
        ("regolith", {"grains": 60}, ob.SHAPE),
        # Large enough for OpenCV to share the work out.
        pytest.param("regolith", {"grains": 500}, (1038, 1388), marks=pytest.mark.soak),
    ],
)
def test_frames_are_the_same_bit_for_bit_whatever_the_number_of_threads(name, options, shape):
    instrument = ob.load_profile("benchtop").resized(shape[1], shape[0])
    scene = load_scene(name, 4, options, shape=shape, pixel_um=instrument.pixel_um)
    built = AsBuilt.draw(instrument, 2)
    transmission = np.where(ob.disc(instrument, 1.5, (1.2, 0.4)) > 0, 0.98, 1 / 15)
    most, opencv = numba.config.NUMBA_NUM_THREADS, cv2.getNumThreads()
    frames = []
    for threads in (1, most):
        numba.set_num_threads(threads)
        cv2.setNumThreads(threads)
        renderer = Renderer(instrument, scene, built)
        frames.append(renderer.expose(transmission, ob.one_led(instrument, 5), 0.02, (9, 5)))
    numba.set_num_threads(most)
    cv2.setNumThreads(opencv)
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


LEVELS = FlawLevels(shading=0.2, dust=5, dust_px=40.0, hot_pixels=300.0)
SENSOR = (1038, 1388)


def test_shading_takes_its_part_from_the_furthest_corner_and_follows_a_square():
    gain = SensorFlaws.draw(SENSOR, FlawLevels(shading=0.2, dust=0), 4).gain
    smooth = gain.reshape(519, 2, 694, 2).mean(axis=(1, 3))
    rows, columns = np.indices(smooth.shape)
    terms = [np.ones(smooth.size)]
    terms += [term.ravel() for term in (rows, columns, rows**2 + columns**2)]
    fit = np.stack(terms, axis=1)
    coefficients, *_ = np.linalg.lstsq(fit, smooth.ravel(), rcond=None)
    residual = smooth.ravel() - fit @ coefficients
    # What the square leaves is the spread of the pixels, averaged over four.
    assert residual.std() == pytest.approx(smooth.mean() * PIXEL_SPREAD / 2, rel=0.03)
    model = (fit @ coefficients).reshape(smooth.shape)
    assert model.min() == pytest.approx(0.8, abs=0.002)
    assert model.max() == pytest.approx(1.0, abs=0.002)


def test_dust_is_as_many_specks_of_the_size_that_was_asked_for():
    levels = FlawLevels(shading=0.0, dust=1, dust_px=40.0)
    for seed in range(4):
        gain = SensorFlaws.draw(SENSOR, levels, seed).gain
        speck = cv2.blur(1 - gain, (9, 9)) > 0.005
        rows, columns = np.nonzero(speck)
        assert 8 < np.ptp(rows) < 56
        assert 8 < np.ptp(columns) < 56
        assert 0.01 < 1 - cv2.blur(gain, (9, 9)).min() < 0.085
    clean = SensorFlaws.draw(SENSOR, FlawLevels(shading=0.0, dust=0), 1).gain
    assert not (cv2.blur(1 - clean, (9, 9)) > 0.005).any()


def test_hot_pixels_grow_with_exposure_and_go_with_the_dark_frame():
    flaws = SensorFlaws.draw(SENSOR, LEVELS, 2)
    hot = flaws.dark_electrons_per_s > 100
    assert hot.sum() == pytest.approx(300e-6 * hot.size, rel=0.25)
    sensor = Sensor(CAMERA.model_copy(update={"read_noise_electrons": 0.0}), flaws)
    per_electron = CAMERA.full_scale / CAMERA.full_well_electrons
    dark = np.zeros(SENSOR, dtype=np.float32)
    black = CAMERA.black_level * CAMERA.full_scale
    for exposure_s in (0.02, 0.2):
        electrons = (sensor.expose(dark, exposure_s, (1,))[hot] - black) / per_electron
        expected = flaws.dark_electrons_per_s[hot] * exposure_s
        kept = expected < 0.8 * CAMERA.full_well_electrons
        noise = (electrons - expected)[kept] / np.sqrt(expected[kept] + 5.0)
        assert abs(noise.mean()) < 0.3
        assert noise.std() == pytest.approx(1.0, abs=0.15)
    light = np.full(SENSOR, 0.3, dtype=np.float32)
    difference = sensor.expose(light, 0.02, (1,)).astype(float) - sensor.expose(dark, 0.02, (2,))
    bright = flaws.gain[hot] * 0.3 * CAMERA.full_scale
    assert np.median(difference[hot] / bright) == pytest.approx(1.0, abs=0.02)


def test_a_camera_keeps_its_flaws_and_a_region_shows_those_of_the_middle():
    one, again, other = (SensorFlaws.draw(SENSOR, LEVELS, seed) for seed in (3, 3, 4))
    assert np.array_equal(one.gain, again.gain)
    assert np.array_equal(one.dark_electrons_per_s, again.dark_electrons_per_s)
    assert not np.array_equal(one.gain, other.gain)
    middle = one.region((96, 128))
    assert np.array_equal(middle.gain, one.gain[471:567, 630:758])
    even = SensorFlaws.none((3, 4))
    assert (even.gain == 1).all()


def test_flaws_of_an_address_are_those_of_its_camera():
    url = SimUrl.parse("sim://benchtop?size=128x96&shading=0.3&dust=0&hot_pixels=0")
    profile = url.load_profile()
    flaws = url.load_flaws(profile)
    assert flaws.gain.shape == profile.shape
    assert (flaws.dark_electrons_per_s == 5.0).all()
    whole = url.load_flaws(load_profile("benchtop"))
    assert whole.gain.min() == pytest.approx(0.7, abs=0.02)
    usual = SimUrl.parse("sim://benchtop?size=128x96")
    assert usual.camera_serial != url.camera_serial
    assert usual.device_serial == url.device_serial
    with pytest.raises(InvalidInputError, match="shading=2"):
        SimUrl.parse("sim://benchtop?shading=2")
