"""Views: parallax, occlusion, defocus, diffraction and leakage against closed forms."""

import math

import numpy as np
import pytest
from tests.sim import optics_bench as ob

from reliefscope.models.apertures import disc as host_disc
from reliefscope.models.geometry import slope_of_bitmap
from reliefscope_sim.as_built import AsBuilt
from reliefscope_sim.optics import Renderer
from reliefscope_sim.optics.pupil import Pupil

INSTRUMENT = ob.without_diffraction()
MIDDLE = (31, 63)
"""Row and column of the glass pixel whose centre lies half a pitch to the upper left of the middle."""
GLASS = INSTRUMENT.glass
F_MM = INSTRUMENT.optics.objective_focal_mm


def glass_offset(a_mm):
    """Offset of the glass that puts the pixel MIDDLE at ``a_mm`` in the pupil."""
    return (a_mm[0] + GLASS.pitch_x_mm / 2, a_mm[1] - GLASS.pitch_y_mm / 2)


def shift_px(height_um, built, at_um=(0.0, 0.0)):
    """Shift (columns, rows) of a spot at ``height_um`` against the same spot in the focal plane."""
    spots = []
    for z in (0.0, height_um):
        scene = ob.sample(INSTRUMENT, z, ob.bump(INSTRUMENT, 6.0, at_um))
        spots.append(ob.moments(ob.render(INSTRUMENT, scene, built, ob.pixels(MIDDLE)))[0])
    return spots[1][0] - spots[0][0], spots[1][1] - spots[0][1]


def test_raised_point_moves_as_the_design_example_says():
    built = ob.overhead(INSTRUMENT, glass_offset_mm=glass_offset((1.5, -0.75)))
    # s = (0.08333, -0.04167); 60 um: 5.0 um to the left and 2.5 um up of 1.116 um each.
    assert shift_px(60.0, built) == pytest.approx((-5.0 / 1.116, -2.5 / 1.116), abs=0.01)


def test_parallax_is_odd_in_height_and_shrinks_with_pupil_scale():
    built = ob.overhead(INSTRUMENT, glass_offset_mm=glass_offset((1.5, -0.75)), pupil_scale=1.125)
    up, down = shift_px(40.0, built), shift_px(-40.0, built)
    expected = 40.0 * 1.5 / (F_MM * 1.125) / INSTRUMENT.pixel_um
    assert up[0] == pytest.approx(-expected, abs=0.01)
    assert down[0] == pytest.approx(expected, abs=0.01)


def test_turned_glass_turns_the_parallax_counter_clockwise():
    # Pixel 5 columns right of the middle, the glass turned by 30 degrees.
    built = ob.overhead(
        INSTRUMENT,
        glass_offset_mm=(0.0, 0.0),
        glass_rotation_rad=math.radians(30.0),
    )
    scene = [ob.sample(INSTRUMENT, z, ob.bump(INSTRUMENT, 6.0)) for z in (0.0, 50.0)]
    pixels = ob.pixels((31, 69), (32, 69))  # centred on the row axis, 5.5 columns right
    (c0, r0), _ = ob.moments(ob.render(INSTRUMENT, scene[0], built, pixels))
    (c1, r1), _ = ob.moments(ob.render(INSTRUMENT, scene[1], built, pixels))
    length = 50.0 * 5.5 * GLASS.pitch_x_mm / F_MM / INSTRUMENT.pixel_um
    expected = (-length * math.cos(math.radians(30)), length * math.sin(math.radians(30)))
    assert (c1 - c0, r1 - r0) == pytest.approx(expected, abs=0.02)


def test_without_telecentricity_height_changes_magnification():
    built = ob.overhead(
        INSTRUMENT, glass_offset_mm=glass_offset((0.0, 0.0)), telecentricity_per_mm=1.0
    )
    # s grows by 1 per mm of field: at x = 40 um, s = 0.04, z = 50 um gives 2 um inward.
    across, down = shift_px(50.0, built, (40.0, -20.0))
    field = 40.0 / (1 + 0.05)  # where the raised spot is seen
    assert across == pytest.approx(-50.0 * field / 1000 / INSTRUMENT.pixel_um, abs=0.03)
    assert down == pytest.approx(across / 2, abs=0.03)  # half as far, and inward is up


def test_pupil_agrees_with_the_hosts_own_geometry():
    built = AsBuilt.draw(INSTRUMENT, 7)
    bitmap = host_disc(GLASS, (1.7, -0.9), 1.5)
    centroid = Pupil(INSTRUMENT, built).points(bitmap, 1.0).centroid_mm
    slope = slope_of_bitmap(bitmap, INSTRUMENT, built.factory_calibration(INSTRUMENT))
    assert centroid / (built.pupil_scale * F_MM) == pytest.approx(slope, abs=1e-9)


def test_a_step_hides_the_floor_behind_it():
    x_um, _ = ob.coordinates(INSTRUMENT)
    raised = x_um < 0
    scene = ob.sample(INSTRUMENT, np.where(raised, 40.0, 0.0), np.where(raised, 0.0, 0.5))
    edges = {}
    for sign in (1, -1):
        built = ob.overhead(INSTRUMENT, glass_offset_mm=glass_offset((sign * 4.0, 0.0)))
        image = ob.render(INSTRUMENT, scene, built, ob.pixels(MIDDLE))
        row = image[48] / image[48, 100:].mean()
        column = int(np.argmax(row > 0.5))
        part = (0.5 - row[column - 1]) / (row[column] - row[column - 1])
        edges[sign] = (column - 1 + part - 63.5) * INSTRUMENT.pixel_um
    # Leaning to the left the black top (40 um up) covers 40 * 4 / 18 um of the floor; leaning to the
    # right the floor is seen up to the foot of the wall.  The wall is one pixel thick, from its last high
    # pixel to its first low one, and an edge is found to half a pixel.
    half = INSTRUMENT.pixel_um / 2
    assert edges[-1] == pytest.approx(40 * 4.0 / F_MM - half, abs=1.1 * half)
    assert edges[1] == pytest.approx(half, abs=1.1 * half)


def test_blur_grows_with_height_as_the_open_pixels_are_spread():
    built = ob.overhead(INSTRUMENT)
    open_disc = ob.disc(INSTRUMENT, 3.0)
    rows, columns = np.nonzero(open_disc)
    spread_x = np.std(columns) * GLASS.pitch_x_mm
    spread_y = np.std(rows) * GLASS.pitch_y_mm
    assert spread_x == pytest.approx(3.0 / 4, rel=0.1)
    width = {}
    for z in (0.0, -60.0):
        scene = ob.sample(INSTRUMENT, z, ob.bump(INSTRUMENT, 3.0))
        _, width[z] = ob.moments(ob.render(INSTRUMENT, scene, built, open_disc))
    for axis, spread in ((0, spread_x), (1, spread_y)):
        grown = math.sqrt(width[-60.0][axis] - width[0.0][axis]) * INSTRUMENT.pixel_um
        # Each pixel is a square of its own extent beside the spread of the centres.
        assert grown == pytest.approx(60.0 * spread / F_MM, rel=0.05)


def full_width_added_um(transmission):
    """Width (x, y) at half height of the Gaussian that diffraction adds to a spot."""
    variance = []
    for instrument in (ob.profile(), INSTRUMENT):
        scene = ob.sample(instrument, 0.0, ob.bump(instrument, 3.0))
        image = ob.render(instrument, scene, ob.overhead(instrument), transmission)
        variance.append(np.array(ob.moments(image)[1]))
    return 2.355 * np.sqrt(variance[0] - variance[1]) * INSTRUMENT.pixel_um


def test_diffraction_spot_of_a_disc_follows_equation_two():
    spot_um = 0.5 * F_MM / 3.0
    # The Airy disc of r = lambda f_o / d is 1.03 r wide at half its height.
    widths = full_width_added_um(ob.disc(INSTRUMENT, 3.0))
    assert math.sqrt(widths[0] * widths[1]) == pytest.approx(1.03 * spot_um, rel=0.08)


def test_half_the_depth_of_field_away_a_point_is_blurred_by_its_spot_again():
    # DOF = 2 lambda (f / d)^2 (eq. 2): at +-DOF/2 the cone of the disc is as wide as lambda f / d, the spot.
    instrument, diameter_mm = ob.profile(), 3.0
    open_disc = ob.disc(instrument, diameter_mm)
    spot_um = 0.5 * F_MM / diameter_mm
    half_depth_um = 0.5 * (F_MM / diameter_mm) ** 2
    added = {}
    for z in (0.0, half_depth_um, -half_depth_um, 3 * half_depth_um):
        scene = ob.sample(instrument, z, ob.bump(instrument, 3.0))
        image = ob.render(instrument, scene, ob.overhead(instrument), open_disc)
        added[z] = np.mean(ob.moments(image)[1]) * instrument.pixel_um**2 - 3.0**2
    cone = spot_um**2 / 16  # variance of an even disc of that diameter
    # Rays that end between pixels are interpolated, which adds up to a quarter of a squared pixel.
    between = 0.25 * instrument.pixel_um**2
    for z, cones in ((half_depth_um, 1), (-half_depth_um, 1), (3 * half_depth_um, 9)):
        assert 0.95 * cones * cone < added[z] - added[0.0] < 1.05 * cones * cone + between


def test_diffraction_of_few_pixels_has_their_form():
    # The "1.5 mm disc" about the middle of the glass is really 4 x 2 pixels: a sinc^2, 0.886 r wide.
    widths = full_width_added_um(ob.disc(INSTRUMENT, 1.5))
    lengths_mm = np.array([4 * GLASS.pitch_x_mm, 2 * GLASS.pitch_y_mm])
    assert widths == pytest.approx(0.886 * 0.5 * F_MM / lengths_mm, rel=0.08)


def test_shut_glass_leaks_over_the_whole_pupil():
    instrument = ob.profile()
    scene = ob.sample(instrument, 0.0, 0.9)
    renderer = Renderer(instrument, scene, ob.overhead(instrument), ob.SHAPE)
    energy = ob.one_led(instrument)
    open_disc = ob.disc(instrument, 1.5)
    shut = renderer.signal(np.full((64, 128), 1 / 15), energy).mean()
    disc_alone = renderer.signal(open_disc, energy).mean()
    open_mm2 = open_disc.sum() * GLASS.pitch_x_mm * GLASS.pitch_y_mm
    assert shut / disc_alone == pytest.approx(math.pi * 4.5**2 / 15 / open_mm2, rel=0.01)
    # The figure that the design states: about 2.4 times the ideal disc.
    assert shut / disc_alone * open_mm2 / (math.pi * 0.75**2) == pytest.approx(2.4, abs=0.03)
    settled = renderer.signal(np.where(open_disc > 0, 1.0, 1 / 15), energy).mean()
    assert settled == pytest.approx(shut + disc_alone * 14 / 15, rel=1e-3)


@pytest.mark.parametrize(
    ("spacing_mm", "fewest", "most"), [(10.0, 4, 4), (0.6, 8, 8), (0.3, 12, 40), (1e-3, 30, 80)]
)
def test_points_of_an_aperture_stay_few_and_keep_area_and_centroid(spacing_mm, fewest, most):
    built = AsBuilt.draw(INSTRUMENT, 4)
    mask = ob.disc(INSTRUMENT, 1.5) > 0
    points = Pupil(INSTRUMENT, built).points(mask, spacing_mm)
    pixels = Pupil(INSTRUMENT, built).pixels(mask)
    assert fewest <= len(points) <= most
    assert points.area_mm2.sum() == pytest.approx(pixels.area_mm2.sum())
    assert points.centroid_mm == pytest.approx(pixels.centroid_mm)
    # Whatever the points, they and their cells are spread as the open area is; merging loses a little.
    loss = 0.0 if len(points) in {4, len(pixels)} else 0.05
    difference = points.covariance_mm2 - pixels.covariance_mm2
    assert np.abs(difference).max() <= loss * np.trace(pixels.covariance_mm2) + 1e-9


def test_what_lies_outside_the_round_pupil_is_cut_off():
    instrument = ob.profile()
    scene = ob.sample(instrument, 0.0, 0.9)
    built = ob.overhead(instrument)
    centre_column = 63 + round(4.5 / GLASS.pitch_x_mm)
    beyond = ob.render(instrument, scene, built, ob.pixels((31, centre_column + 4)))
    rim = Pupil(instrument, built).area_mm2
    assert beyond.max() == 0.0
    assert rim.sum() == pytest.approx(math.pi * 4.5**2, rel=0.005)


def test_glass_pixels_add_up():
    instrument = ob.profile()
    generator = np.random.default_rng(3)
    height = np.where(ob.coordinates(instrument)[0] < 0, 30.0, -20.0)
    scene = ob.sample(instrument, height, generator.uniform(0.2, 0.8, ob.SHAPE))
    renderer = Renderer(instrument, scene, AsBuilt.nominal(instrument), ob.SHAPE)
    energy = ob.one_led(instrument)
    old = ob.disc(instrument, 1.5, (-1.0, 0.5))
    new = ob.disc(instrument, 1.5, (1.0, -0.5))
    ghost = renderer.signal(0.3 * old + 0.7 * new, energy)
    apart = 0.3 * renderer.signal(old, energy) + 0.7 * renderer.signal(new, energy)
    assert np.abs(ghost - apart).max() < 1e-5
    assert np.abs(ghost - renderer.signal(new, energy)).max() > 0.005


def test_gaps_between_pixels_leak_but_never_switch():
    tight = ob.profile()
    gappy = tight.model_copy(update={"glass": tight.glass.model_copy(update={"gap_mm": 0.04})})
    built = ob.overhead(tight)
    scene = ob.sample(tight, 0.0, 0.9)
    fill = (0.398 - 0.04) * (0.484 - 0.04) / (0.398 * 0.484)
    everything = np.ones((64, 128))
    whole = ob.render(tight, scene, built, everything).mean()
    assert ob.render(gappy, scene, built, everything).mean() == pytest.approx(
        whole * (fill + (1 - fill) / 15), rel=1e-4
    )
