"""Materials through the renderer against the closed forms of brdf, and the energy that they keep."""

import math

import numpy as np
import pytest
from numba import njit
from tests.sim import optics_bench as ob

from reliefscope import brdf
from reliefscope.errors import InvalidInputError
from reliefscope_sim.as_built import AsBuilt
from reliefscope_sim.optics import Renderer
from reliefscope_sim.optics.lighting import Lighting
from reliefscope_sim.optics.surface import Surface

INSTRUMENT = ob.without_diffraction()
APERTURE_MM = (2.0, -1.0)
OPEN = ob.disc(INSTRUMENT, 1.5, APERTURE_MM)
LED = 10
SOURCE = (1 / 30) ** 2 / 8
"""What the extent of the LED adds to alpha^2."""


def even(value):
    """A map of one value."""
    return np.full((*ob.SHAPE, *np.shape(value)), value, dtype=np.float32)


def plane(tilt_deg, azimuth_deg=200.0):
    """Height of a tilted plane, and its normal."""
    x_um, y_um = ob.coordinates(INSTRUMENT)
    tilt, azimuth = math.radians(tilt_deg), math.radians(azimuth_deg)
    along = x_um * math.cos(azimuth) + y_um * math.sin(azimuth)
    lean = math.sin(tilt)
    normal = np.array([lean * math.cos(azimuth), lean * math.sin(azimuth), math.cos(tilt)])
    return -math.tan(tilt) * along, normal


def distant():
    """Every LED a thousand times as far away: one direction for the whole sample."""
    positions = 1e3 * INSTRUMENT.dome.positions_mm
    intensities = np.full(INSTRUMENT.dome.count, 1e6)
    return ob.as_built(INSTRUMENT, led_positions_mm=positions, led_intensities=intensities)


def cosines(normal):
    """n.l, n.v, n.h, v.h and l.v for the LED and the centre of what is open."""
    light = INSTRUMENT.dome.positions_mm[LED] / 30.0
    glass = INSTRUMENT.glass
    rows, columns = np.nonzero(OPEN)
    at_mm = ((columns - 63.5) * glass.pitch_x_mm, (31.5 - rows) * glass.pitch_y_mm)
    slope = [offset.mean() / INSTRUMENT.optics.objective_focal_mm for offset in at_mm]
    view = np.array([*slope, 1.0]) / math.hypot(*slope, 1.0)
    half = (light + view) / np.linalg.norm(light + view)
    return normal @ light, normal @ view, normal @ half, view @ half, light @ view


def against_white(height, **maps):
    """Image of a material over that of a perfect diffuser of the same shape, in the middle, by channel."""
    sensor = {"sensor": "mono"} if np.ndim(maps["albedo"]) == 2 else {"sensor": "bayer_rggb"}
    camera = INSTRUMENT.camera.model_copy(update=sensor)
    instrument = INSTRUMENT.model_copy(update={"camera": camera})
    albedo = maps.pop("albedo")
    scene = ob.sample(instrument, height, albedo, **maps)
    white = ob.sample(instrument, height, np.ones_like(albedo))
    images = [ob.render(instrument, sample, distant(), OPEN, LED) for sample in (scene, white)]
    middle = np.s_[40:56, 56:72]
    ratio = images[0][middle] / images[1][middle]
    return np.array([ratio[0::2, 0::2].mean(), ratio[0::2, 1::2].mean(), ratio[1::2, 1::2].mean()])


TILTS = pytest.mark.parametrize("tilt_deg", [0.0, 20.0, 35.0])


@TILTS
def test_rough_diffusers_are_those_of_oren_and_nayar(tilt_deg):
    height, normal = plane(tilt_deg)
    nl, nv, _, _, lv = cosines(normal)
    found = against_white(height, albedo=even(0.6), diffuse_sigma_rad=even(0.4))
    assert found == pytest.approx(brdf.oren_nayar(nl, nv, lv, 0.6, 0.4), rel=0.01)


@TILTS
def test_metals_have_a_coloured_lobe_and_nothing_else(tilt_deg):
    height, normal = plane(tilt_deg)
    nl, nv, nh, vh, _ = cosines(normal)
    gold = np.array([0.95, 0.68, 0.32])
    found = against_white(
        height, albedo=even((0.0, 0.0, 0.0)), specular=even(gold), roughness=even(0.35)
    )
    alpha = math.sqrt(0.35**2 + SOURCE)
    expected = [brdf.ggx(nl, nv, nh, vh, alpha, f0) for f0 in gold]
    # Around the plane the sample is level: what that throws onto it is in the picture too.
    assert found == pytest.approx(expected, rel=0.02)


@TILTS
def test_dielectrics_lose_below_what_they_reflect_above(tilt_deg):
    height, normal = plane(tilt_deg)
    nl, nv, nh, vh, _ = cosines(normal)
    found = against_white(height, albedo=even(0.7), specular=even(0.04), roughness=even(0.3))
    alpha = math.sqrt(0.3**2 + SOURCE)
    expected = brdf.ggx(nl, nv, nh, vh, alpha, 0.04) + brdf.coated(nl, nv, 0.04, 0.7)
    assert found == pytest.approx(expected, rel=0.01)
    # The physical model says the same, if its albedo below the boundary is the one that gives 0.7 from above.
    n = 1.5
    leaving = (1 - brdf.diffuse_fresnel(n)) / n**2
    share = 0.7 / (1 - 0.04)
    below = share / (leaving + share * (1 - leaving))
    exact = brdf.ggx_dielectric(nl, nv, nh, vh, alpha, n, below)
    assert found == pytest.approx(exact, rel=0.02)


@TILTS
def test_layers_of_grains_follow_hapke_and_mix_with_what_is_between(tilt_deg):
    height, normal = plane(tilt_deg)
    nl, nv, _, _, lv = cosines(normal)
    colour = (0.9, 0.5, 0.2)
    layer = [brdf.hapke(nl, nv, lv, w, *brdf.REGOLITH) for w in colour]
    found = against_white(height, albedo=even(colour), hapke=even(1.0))
    assert found == pytest.approx(layer, rel=0.01)
    mixed = against_white(height, albedo=even(colour), hapke=even(0.25))
    assert mixed == pytest.approx(0.25 * np.array(layer) + 0.75 * np.array(colour), rel=0.01)


def test_materials_change_from_pixel_to_pixel():
    left = ob.coordinates(INSTRUMENT)[0] + 0 * ob.coordinates(INSTRUMENT)[1] < 0
    maps = {
        "specular": np.where(left, 0.9, 0.0).astype(np.float32),
        "roughness": even(0.4),
        "diffuse_sigma_rad": np.where(left, 0.0, 0.5).astype(np.float32),
    }
    scene = ob.sample(INSTRUMENT, 0.0, np.where(left, 0.0, 0.5), **maps)
    image = ob.render(INSTRUMENT, scene, distant(), OPEN, LED)
    nl, nv, nh, vh, lv = cosines(np.array([0.0, 0.0, 1.0]))
    metal = brdf.ggx(nl, nv, nh, vh, math.sqrt(0.4**2 + SOURCE), 0.9)
    soil = brdf.oren_nayar(nl, nv, lv, 0.5, 0.5)
    ratio = image[:, 20:40].mean() / image[:, 90:110].mean()
    assert ratio == pytest.approx(metal / soil, rel=0.01)


@njit
def returned(light, views, f0, alpha, albedo):
    """Share of light from one direction that gloss over a diffuser returns."""
    total = 0.0
    for index in range(len(views)):
        view = views[index]
        half = light + view
        half /= math.sqrt((half * half).sum())
        nl, nv, vh = light[2], view[2], (half * view).sum()
        value = brdf.ggx(nl, nv, half[2], vh, alpha, f0) + brdf.coated(nl, nv, f0, albedo)
        total += value * nv
    return 2 * total / len(views)


@pytest.mark.parametrize("f0", [0.0, 0.01, 0.04, 0.3, 0.8])
@pytest.mark.parametrize("elevation_deg", [8.0, 30.0, 90.0])
def test_gloss_over_a_white_diffuser_returns_at_most_what_arrives(f0, elevation_deg):
    count = 200
    cosine, azimuth = np.meshgrid(
        (np.arange(count) + 0.5) / count, (np.arange(count) + 0.5) * 2 * np.pi / count
    )
    sine = np.sqrt(1 - cosine**2)
    views = np.stack([sine * np.cos(azimuth), sine * np.sin(azimuth), cosine], -1).reshape(-1, 3)
    tilt = math.radians(elevation_deg)
    light = np.array([math.cos(tilt), 0.0, math.sin(tilt)])
    total = returned(light, views, f0, 0.35, 1 - f0)
    assert 0.5 < total <= 1.001
    # Below smooth facets it is all of it: what is missing above is light between facets that the lobe loses.
    below = brdf.fresnel(f0, light[2]) + (1 - f0) * _entering(f0, light[2])
    assert below == pytest.approx(1.0, abs=1e-9)
    diffuse = returned(light, views, 0.0, 0.35, 1.0) if f0 == 0.0 else None
    assert diffuse is None or diffuse == pytest.approx(1.0, abs=1e-3)


def _entering(f0, cosine):
    """R(x) of brdf.coated, from its definition."""
    return (1 - brdf.fresnel(f0, cosine)) / (1 - f0)


def test_light_between_coloured_walls_takes_their_colour():
    # A pit with red walls and a grey floor: once around, light has the walls' colour.
    x_um, y_um = ob.coordinates(INSTRUMENT)
    inside = np.maximum(np.abs(x_um), np.abs(y_um)) < 20
    height = np.where(inside, -30.0, 0.0)
    red, grey = np.array([0.8, 0.2, 0.1]), np.array([0.3, 0.3, 0.3])
    floor = (np.maximum(np.abs(x_um), np.abs(y_um)) < 18)[..., None]
    scene = ob.sample(INSTRUMENT, height, np.where(floor, grey, red))
    surface = Surface.on_frame(scene, ob.SHAPE, INSTRUMENT.pixel_um, 0.3, colour=True)
    lit = Lighting(surface, INSTRUMENT.dome, AsBuilt.nominal(INSTRUMENT)).lit_by(LED)
    cell = 4
    row, column = ((surface.margin + size // 2) // cell for size in ob.SHAPE)
    light = lit.between[:, row - 2 : row + 2, column - 2 : column + 2].mean(axis=(1, 2))
    assert light[0] / light[1] == pytest.approx(4.0, rel=0.25)
    assert light[0] / light[2] == pytest.approx(8.0, rel=0.35)


@pytest.mark.parametrize(
    ("maps", "said"),
    [
        ({"specular": even(0.5), "roughness": even(0.3)}, "more light than arrives"),
        ({"specular": even(0.1), "roughness": even(0.0)}, "roughness runs from 0"),
        ({"hapke": even(2.0)}, "hapke runs from 2"),
        ({"diffuse_sigma_rad": even(np.nan)}, "diffuse_sigma_rad"),
        ({"grain_index": np.ones(ob.SHAPE, dtype=np.int32)}, "grain_index"),
    ],
)
def test_maps_without_physical_sense_are_refused(maps, said):
    with pytest.raises(InvalidInputError, match=said):
        ob.sample(INSTRUMENT, 0.0, 0.8, **maps)


def test_grains_may_be_named_by_pixel():
    index = np.zeros(ob.SHAPE, dtype=np.int32)
    index[0] = -1
    scene = ob.sample(INSTRUMENT, 0.0, 0.5, grain_index=index, grains=("a grain",))
    assert Renderer(INSTRUMENT, scene, AsBuilt.nominal(INSTRUMENT), ob.SHAPE).shape == ob.SHAPE
