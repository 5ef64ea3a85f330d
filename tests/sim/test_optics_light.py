"""Illumination against closed forms: shading, shadows, distance, beam, gloss, light between surfaces."""

import math

import cv2
import numpy as np
import pytest
from tests.sim import optics_bench as ob

from reliefscope import brdf
from reliefscope_sim.as_built import AsBuilt
from reliefscope_sim.optics import WHITE_SIGNAL, Renderer
from reliefscope_sim.optics.lighting import Lighting
from reliefscope_sim.optics.surface import Surface

INSTRUMENT = ob.without_diffraction()
ON_AXIS = ob.disc(INSTRUMENT, 1.5)


def lit(scene, built, led=8, instrument=INSTRUMENT):
    """Direct irradiance, and that from other surfaces, on the frame."""
    surface = Surface.on_frame(scene, ob.SHAPE, instrument.pixel_um, 0.3, colour=False)
    light = Lighting(surface, instrument.dome, built).lit_by(led)
    m = surface.margin
    window = (slice(m, m + ob.SHAPE[0]), slice(m, m + ob.SHAPE[1]))
    between = cv2.resize(light.between[0], light.direct.shape[::-1])
    return light.direct[window].astype(float), between[window].astype(float)


def glossy(scene_height, albedo=0.5, specular=0.0, roughness=0.3):
    """A sample with gloss, so that direct light is kept apart."""
    return ob.sample(
        INSTRUMENT,
        scene_height,
        albedo,
        specular=np.full(ob.SHAPE, specular, dtype=np.float32),
        roughness=np.full(ob.SHAPE, roughness, dtype=np.float32),
    )


def test_sphere_is_shaded_by_lamberts_cosine():
    radius = 45.0
    x_um, y_um = ob.coordinates(INSTRUMENT)
    squared = radius**2 - x_um**2 - y_um**2
    scene = ob.sample(INSTRUMENT, np.sqrt(np.maximum(squared, 0.0)), 0.02)
    built = AsBuilt.nominal(INSTRUMENT)
    image = ob.render(INSTRUMENT, scene, built, ON_AXIS)
    flat = ob.render(INSTRUMENT, ob.sample(INSTRUMENT, 0.0, 0.02), built, ON_AXIS)
    direction = built.led_positions_mm[8] / np.linalg.norm(built.led_positions_mm[8])
    z_um = np.sqrt(np.maximum(squared, 0.0))
    cosine = (x_um * direction[0] + y_um * direction[1] + z_um * direction[2]) / radius
    fair = (x_um**2 + y_um**2 < (0.8 * radius) ** 2) & (cosine > 0.1)
    ratio = image / flat * direction[2] / cosine
    assert fair.sum() > 2000
    assert np.abs(ratio[fair] - 1).max() < 0.05
    assert np.abs(ratio[fair] - 1).mean() < 0.012


@pytest.mark.parametrize(("led", "elevation_deg"), [(8, 45.0), (0, 22.5)])
def test_shadow_is_as_long_as_height_over_tangent_of_elevation(led, elevation_deg):
    x_um, y_um = ob.coordinates(INSTRUMENT)
    azimuth = math.radians(22.5 if led == 8 else 0.0)
    along = x_um * math.cos(azimuth) + y_um * math.sin(azimuth)
    # A ridge across the light, 15 um high, that ends at 0 on the side away from it.
    scene = glossy(np.where((along > 0) & (along < 8), 15.0, 0.0))
    direct, _ = lit(scene, AsBuilt.nominal(INSTRUMENT), led)
    level = direct / np.median(direct[(along > 20) & (along < 40)])
    length = 15.0 / math.tan(math.radians(elevation_deg))
    edge = np.array([level[np.abs(along + d) < 0.6].mean() for d in np.arange(2.0, 60.0, 0.5)])
    found = 2.0 + 0.5 * np.argmax(edge > 0.5)
    assert found == pytest.approx(length, abs=1.5)
    assert edge[2 : int(length) - 6].max() < 0.02
    # The source is 1/30 rad to either side: the soft edge spans h (cot(e - r) - cot(e + r)).
    r, e = 1 / 30, math.radians(elevation_deg)
    soft = 15.0 * (1 / math.tan(e - r) - 1 / math.tan(e + r))
    width = 0.5 * np.count_nonzero((edge > 0.02) & (edge < 0.98))
    assert width == pytest.approx(soft, abs=2.0)


def test_no_light_comes_through_where_two_towers_touch_in_a_corner():
    x_um, y_um = ob.coordinates(INSTRUMENT)
    scene = glossy(np.where((x_um > 0) == (y_um > 0), 30.0, 0.0))
    place = 30 * np.array([-1.0, 1.0, 0.6]) / math.sqrt(2.36)
    built = ob.as_built(INSTRUMENT, led_positions_mm=np.tile(place, (16, 1)))
    direct, _ = lit(scene, built)
    # Straight behind the corner, and short of the end of the towers' shadow, 30 sqrt(2) / 0.6 = 71 um.
    behind = [direct[48 + step, 64 + step] for step in range(4, 28)]
    assert max(behind) < 0.01
    assert direct[10, 20] > 0.1


def test_light_falls_with_the_square_of_distance():
    near = AsBuilt.nominal(INSTRUMENT)
    far = ob.as_built(INSTRUMENT, led_positions_mm=2 * near.led_positions_mm)
    scene = ob.sample(INSTRUMENT, 0.0, 0.5)
    images = [ob.render(INSTRUMENT, scene, built, ON_AXIS) for built in (near, far)]
    middle = (slice(47, 49), slice(63, 65))
    assert images[1][middle].mean() / images[0][middle].mean() == pytest.approx(0.25, rel=1e-4)


def test_near_field_of_one_led_across_the_sample():
    # 45 degrees, azimuth 22.5: toward the LED the sample is nearer to it, and off its axis.
    built = AsBuilt.nominal(INSTRUMENT)
    direct, _ = lit(glossy(0.0), built)
    led_um = built.led_positions_mm[8] * 1000
    x_um, y_um = ob.coordinates(INSTRUMENT)
    to_led = np.stack(np.broadcast_arrays(led_um[0] - x_um, led_um[1] - y_um, led_um[2]))
    distance = np.linalg.norm(to_led, axis=0)
    on_axis = np.tensordot(led_um, to_led, axes=1) / distance / np.linalg.norm(led_um)
    exponent = math.log(0.5) / math.log(math.cos(math.radians(22.5)))
    expected = (30000.0 / distance) ** 2 * on_axis**exponent * to_led[2] / distance
    assert np.abs(direct / expected - 1).max() < 2e-5


def test_beam_is_half_as_bright_at_its_half_angle():
    # The axis points at the focal point; a sample point 22.5 degrees off it sees half the intensity.
    instrument = INSTRUMENT
    distance_mm = 0.1
    built = ob.as_built(
        instrument,
        led_positions_mm=np.tile([0.0, 0.0, distance_mm], (16, 1)),
    )
    direct, _ = lit(glossy(0.0), built)
    x_um, y_um = ob.coordinates(instrument)
    radius = np.hypot(x_um, y_um)
    ring = np.abs(radius - distance_mm * 1000 * math.tan(math.radians(22.5))) < 0.6
    peak = (30.0 / distance_mm) ** 2
    cosine = math.cos(math.radians(22.5))
    assert direct[ring].mean() == pytest.approx(peak * 0.5 * cosine**3, rel=0.01)


def test_white_sample_gives_the_documented_signal():
    instrument = ob.profile()
    scene = ob.sample(instrument, 0.0, 0.9)
    renderer = Renderer(instrument, scene, AsBuilt.nominal(instrument), ob.SHAPE)
    glass = instrument.glass
    open_disc = ob.disc(instrument, 1.5)
    signal = renderer.signal(np.where(open_disc > 0, 1.0, 1 / 15), ob.one_led(instrument))
    open_mm2 = open_disc.sum() * glass.pitch_x_mm * glass.pitch_y_mm
    ideal = math.pi * 0.75**2
    pupil = math.pi * 4.5**2
    share = (open_mm2 + (pupil - open_mm2) / 15) / (ideal + (pupil - ideal) / 15)
    assert signal[48, 64] == pytest.approx(WHITE_SIGNAL * share, rel=0.01)


def test_lights_add_up_and_scale_with_energy():
    instrument = ob.profile()
    x_um, _ = ob.coordinates(instrument)
    scene = ob.sample(instrument, np.where(x_um < 0, 10.0, -10.0), 0.5)
    renderer = Renderer(instrument, scene, AsBuilt.nominal(instrument), ob.SHAPE)
    first, second = ob.one_led(instrument, 3), ob.one_led(instrument, 12)
    transmission = ob.disc(instrument, 1.5)
    both = renderer.signal(transmission, first + 0.25 * second)
    apart = renderer.signal(transmission, first) + 0.25 * renderer.signal(transmission, second)
    assert np.abs(both - apart).max() < 1e-6
    assert np.allclose(
        renderer.signal(transmission, first / 8), renderer.signal(transmission, first) / 8
    )
    assert not renderer.signal(transmission, 0 * first).any()


def test_gloss_of_a_tilted_mirror_is_the_lobe_of_the_model():
    built = ob.as_built(INSTRUMENT, led_positions_mm=1e3 * ob.profile().dome.positions_mm)
    built = ob.as_built(
        INSTRUMENT,
        led_positions_mm=built.led_positions_mm,
        led_intensities=np.full(16, 1e6),
    )
    x_um, y_um = ob.coordinates(INSTRUMENT)
    direction = INSTRUMENT.dome.positions_mm[8] / 30.0
    for tilt_deg in (10.0, 22.5, 30.0):
        tilt = math.radians(tilt_deg)
        towards = direction[:2] / np.linalg.norm(direction[:2])
        height = -math.tan(tilt) * (x_um * towards[0] + y_um * towards[1])
        scene = glossy(height, albedo=0.0, specular=0.8, roughness=0.3)
        image = ob.render(INSTRUMENT, scene, built, ON_AXIS)
        normal = np.array([*(math.sin(tilt) * towards), math.cos(tilt)])
        half = direction + np.array([0.0, 0.0, 1.0])
        half /= np.linalg.norm(half)
        nl = normal @ direction
        lobe = brdf.ggx(nl, normal[2], normal @ half, half[2], 0.3, 0.8)
        diffuse = ob.render(INSTRUMENT, ob.sample(INSTRUMENT, height, 0.5), built, ON_AXIS)
        assert image[48, 64] / diffuse[48, 64] == pytest.approx(lobe / 0.5, rel=0.03)


def test_gloss_follows_the_viewing_direction():
    scene = glossy(0.0, albedo=0.0, specular=0.8, roughness=0.3)
    built = AsBuilt.nominal(INSTRUMENT)
    direction = built.led_positions_mm[10] / 30.0  # azimuth 112.5 degrees
    away = -direction[:2] / np.linalg.norm(direction[:2]) * 3.0
    with_it = ob.render(INSTRUMENT, scene, built, ob.disc(INSTRUMENT, 1.5, -away), 10)
    against = ob.render(INSTRUMENT, scene, built, ob.disc(INSTRUMENT, 1.5, away), 10)
    # A mirror throws light to the far side of its normal.
    assert against.mean() > 1.5 * with_it.mean()


def test_light_within_a_spherical_cavity_is_even_and_has_its_closed_form():
    # On the inside of a sphere every point gets the same share of what any other one reflects:
    # dF = dA / (4 pi R^2), so one bounce gives rho/(4 pi R^2) times the flux that falls into the cap.
    radius, opening, albedo = 60.0, 50.0, 0.5
    x_um, y_um = ob.coordinates(INSTRUMENT)
    distance = np.hypot(x_um, y_um)
    sphere = -np.sqrt(np.maximum(radius**2 - distance**2, 0.0))
    rim = -math.sqrt(radius**2 - opening**2)
    scene = glossy(np.where(distance < opening, sphere, rim), albedo=albedo)
    direct, between = lit(scene, ob.overhead(INSTRUMENT))
    inside = distance < 0.75 * opening
    flux = math.pi * opening**2  # even light from above: irradiance 1 on the level
    cap = 2 * math.pi * radius * (radius + rim)
    once = albedo * flux / (4 * math.pi * radius**2)
    expected = once + albedo * cap / (4 * math.pi * radius**2) * once
    assert direct[48, 64] == pytest.approx(1.0, rel=0.01)
    assert between[inside].mean() == pytest.approx(expected, rel=0.08)
    assert between[inside].std() < 0.12 * expected
    assert between[distance > 57].max() < 0.1 * expected


def test_a_wall_lights_the_floor_beside_it_as_brightly_as_the_light_falls_on_it():
    # A wall of height h beside the left half of a floor, under light of 60 degrees from either side.  An endless
    # wall of height h fills (1 - cos(atan(h / d))) / 2 of what a floor at distance d receives.
    x_um, y_um = ob.coordinates(INSTRUMENT)
    edge, wall, albedo = -20.0, 30.0, 0.3
    scene = glossy(np.where(x_um + 0 * y_um < edge, wall, 0.0), albedo=albedo)
    place = np.tile([1500.0, 0.0, 1500.0 * math.sqrt(3)], (INSTRUMENT.dome.count, 1))
    even = np.full(INSTRUMENT.dome.count, (3000.0 / INSTRUMENT.dome.radius_mm) ** 2)
    built = ob.as_built(INSTRUMENT, led_positions_mm=place, led_intensities=even)
    turned = ob.as_built(INSTRUMENT, led_positions_mm=place * [-1, 1, 1], led_intensities=even)
    floor = np.s_[30:66, 52:72]
    toward, away = (lit(scene, either)[1][floor].mean(axis=0) for either in (built, turned))
    once = albedo * 0.5 * (1 - np.cos(np.arctan2(wall, x_um[0, 52:72] - edge))) / 2
    assert (toward / once).mean() == pytest.approx(1.25, abs=0.25)  # and a little the second time
    assert away.mean() < 0.1 * toward.mean()


def test_light_between_surfaces_cannot_exceed_what_arrives():
    generator = np.random.default_rng(5)
    height = 15 * generator.standard_normal((12, 16))
    scene = glossy(np.kron(height, np.ones((8, 8))), albedo=0.9)
    direct, between = lit(scene, ob.overhead(INSTRUMENT))
    assert 0 < between.mean() < direct.max() * 0.9
