"""Every material against reciprocity, energy conservation by quadrature, and published closed forms."""

import math

import numpy as np
import pytest
from numba import njit

from reliefscope import brdf

GRID = 160
"""Cosines of the quadrature; twice as many azimuths."""


def lights(count=GRID):
    """Directions to lights (N, 3) of equal solid angle over the upper hemisphere."""
    cosine, azimuth = np.meshgrid(
        (np.arange(count) + 0.5) / count, (np.arange(2 * count) + 0.5) * np.pi / count
    )
    sine = np.sqrt(1 - cosine**2)
    return np.stack([sine * np.cos(azimuth), sine * np.sin(azimuth), cosine], -1).reshape(-1, 3)


MODELS = {
    "lambert": (1.0,),
    "oren_nayar": (1.0, 0.4),
    "metal": (0.3, 0.2, 3.4),
    "dielectric": (0.3, 1.5, 1.0),
    "hapke": (0.85, 0.3, 0.4, 1.0, 0.06),
}


@njit
def value(model, light, view, p):
    half = light + view
    half /= math.sqrt((half * half).sum())
    nl, nv, nh, vh, lv = light[2], view[2], half[2], (half * view).sum(), (light * view).sum()
    if model == "lambert":
        return brdf.lambert(p[0])
    if model == "oren_nayar":
        return brdf.oren_nayar(nl, nv, lv, p[0], p[1])
    if model == "metal":
        return brdf.ggx_metal(nl, nv, nh, vh, p[0], p[1], p[2])
    if model == "dielectric":
        return brdf.ggx_dielectric(nl, nv, nh, vh, p[0], p[1], p[2])
    return brdf.hapke(nl, nv, lv, p[0], p[1], p[2], p[3], p[4])


@njit
def returned(model, directions, view, p):
    """Share of the light from ``view`` that a surface returns: reciprocity lets lights and views change places."""
    total = 0.0
    for index in range(len(directions)):
        total += value(model, directions[index], view, p) * directions[index, 2]
    return 2 * total / len(directions)


def at(elevation_deg):
    tilt = np.radians(elevation_deg)
    return np.array([np.cos(tilt), 0.0, np.sin(tilt)])


def share(model, elevation_deg, *parameters, count=GRID):
    return returned(model, lights(count), at(elevation_deg), np.array(parameters))


@pytest.mark.parametrize("model", MODELS)
def test_light_and_viewer_can_change_places(model):
    rng = np.random.default_rng(3)
    directions = rng.normal(size=(200, 2, 3))
    directions[..., 2] = np.abs(directions[..., 2]) + 0.05
    directions /= np.linalg.norm(directions, axis=-1, keepdims=True)
    p = np.array(MODELS[model])
    for light, view in directions:
        there, back = value(model, light, view, p), value(model, view, light, p)
        assert there == pytest.approx(back, rel=1e-9)
        assert there >= 0


@pytest.mark.parametrize("elevation_deg", [10.0, 35.0, 60.0, 90.0])
@pytest.mark.parametrize("model", MODELS)
def test_no_material_returns_more_than_arrives(model, elevation_deg):
    total = share(model, elevation_deg, *MODELS[model])
    assert 0.1 < total <= 1.0005


@pytest.mark.parametrize("sigma", [0.0, 0.1, 0.3, 0.6, 1.0])
@pytest.mark.parametrize("elevation_deg", [15.0, 45.0, 90.0])
def test_white_rough_diffusers_keep_energy_whatever_their_slope(sigma, elevation_deg):
    total = share("oren_nayar", elevation_deg, 1.0, sigma)
    assert total <= 1.0005
    if sigma == 0.0:
        assert total == pytest.approx(share("lambert", elevation_deg, 1.0), rel=1e-12)


def test_oren_nayar_has_its_closed_form_in_the_plane_of_the_light():
    # Light and viewer at the same angle: lv - nl nv = sin^2, so pi f_r = A + B sin tan (eq. 30).
    sigma, angle = 0.35, 0.9
    a = 1 - 0.5 * sigma**2 / (sigma**2 + 0.33)
    b = 0.45 * sigma**2 / (sigma**2 + 0.09)
    cosine = math.cos(angle)
    found = brdf.oren_nayar(cosine, cosine, 1.0, 0.6, sigma)
    assert found == pytest.approx(0.6 * (a + b * math.sin(angle) * math.tan(angle)), rel=1e-9)


def test_metals_at_normal_incidence_and_without_absorption():
    n, k = 0.15, 3.5
    normal = ((n - 1) ** 2 + k**2) / ((n + 1) ** 2 + k**2)
    assert brdf.fresnel_conductor(n, k, 1.0) == pytest.approx(normal, rel=1e-12)
    assert brdf.fresnel_conductor(n, k, 1e-9) == pytest.approx(1.0, abs=1e-6)
    for cosine in (0.05, 0.3, 0.7, 1.0):
        assert brdf.fresnel_conductor(1.5, 0.0, cosine) == pytest.approx(
            brdf.fresnel_dielectric(1.5, cosine), rel=1e-9
        )


def test_fresnel_equations_of_a_complex_index():
    n, k, angle = 1.2, 2.1, 1.1
    index = complex(n, k)
    cosine, inside = math.cos(angle), (1 - (math.sin(angle) / index) ** 2) ** 0.5
    s = (cosine - index * inside) / (cosine + index * inside)
    p = (index * cosine - inside) / (index * cosine + inside)
    expected = (abs(s) ** 2 + abs(p) ** 2) / 2
    assert brdf.fresnel_conductor(n, k, cosine) == pytest.approx(expected, rel=1e-9)


def test_a_dielectric_at_brewsters_angle_reflects_one_polarisation_only():
    n = 1.5
    cosine = math.cos(math.atan(n))
    perpendicular = ((n**2 - 1) / (n**2 + 1)) ** 2
    assert brdf.fresnel_dielectric(n, cosine) == pytest.approx(perpendicular / 2, rel=1e-9)
    assert brdf.fresnel_dielectric(n, 1.0) == pytest.approx(0.04, rel=1e-9)


@pytest.mark.parametrize("index", [1.2, 1.5, 2.4])
def test_diffuse_reflectance_of_a_boundary_is_fresnels_averaged(index):
    cosine = (np.arange(20000) + 0.5) / 20000
    values = [brdf.fresnel_dielectric(index, c) for c in cosine]
    assert brdf.diffuse_fresnel(index) == pytest.approx(2 * np.mean(values * cosine), rel=1e-4)


def test_a_white_dielectric_with_a_smooth_boundary_returns_all_light():
    # A narrow lobe is too fine for the quadrature: its share is Fresnel's, the rest is the diffuser's.
    for elevation_deg in (20.0, 50.0, 90.0):
        view = at(elevation_deg)
        gloss = brdf.fresnel_dielectric(1.5, view[2])
        # alpha of 1e-6: off the mirror direction only the diffuser is left.
        below = returned("dielectric", lights(400), view, np.array([1e-6, 1.5, 1.0]))
        assert gloss + below == pytest.approx(1.0, abs=2e-3)


def test_a_black_dielectric_is_gloss_alone():
    view = np.array([0.0, 0.0, 1.0])
    found = value("dielectric", view, view, np.array([0.4, 1.5, 0.0]))
    assert found == pytest.approx(0.04 * brdf.ggx_lobe(1.0, 1.0, 1.0, 0.4), rel=1e-9)


@pytest.mark.parametrize(("x", "exact"), [(0.5, 2.0128), (1.0, 2.9078)])
def test_h_function_without_absorption_is_that_of_chandrasekhars_table(x, exact):
    assert brdf.hapke_h(x, 1.0) == pytest.approx(exact, rel=0.01)


def test_h_function_without_scattering_is_one():
    assert brdf.hapke_h(0.4, 0.0) == 1.0


@pytest.mark.parametrize(("b", "c"), [(0.0, 0.0), (0.3, 0.5), (0.5, -0.4)])
def test_phase_function_averages_to_one(b, c):
    cosine = -1 + (np.arange(20000) + 0.5) / 10000
    mean = np.mean([brdf.double_henyey_greenstein(value, b, c) for value in cosine])
    assert mean == pytest.approx(1.0, abs=1e-6)


def test_phase_function_scatters_backward_for_positive_balance():
    back, forth = (brdf.double_henyey_greenstein(g, 0.4, 0.8) for g in (1.0, -1.0))
    assert back > 5 * forth


@pytest.mark.parametrize("w", [0.1, 0.5, 0.9, 1.0])
@pytest.mark.parametrize("elevation_deg", [12.0, 40.0, 90.0])
def test_isotropic_hapke_returns_its_closed_form(w, elevation_deg):
    # Directional-hemispherical reflectance of isotropic grains: 1 - sqrt(1 - w) H.
    nv = at(elevation_deg)[2]
    expected = 1 - math.sqrt(1 - w) * brdf.hapke_h(nv, w)
    found = share("hapke", elevation_deg, w, 0.0, 0.0, 0.0, 0.05)
    assert expected - 0.016 < found <= expected


def test_dark_hapke_is_lommel_and_seeligers_law():
    w = 1e-6
    found = brdf.hapke(0.3, 0.8, 0.5, w, 0.0, 0.0, 0.0, 0.05)
    assert found == pytest.approx(w / 4 / (0.3 + 0.8), rel=1e-5)


@pytest.mark.parametrize("w", [0.1, 0.5, 0.9])
def test_geometric_albedo_of_a_hapke_sphere_is_hapkes_closed_form(w):
    # Hapke 1984: A = r0 / 2 (1 + r0 / 3) + w / 8 ((1 + B0) p(0) - 1), within a few per cent.
    b, c, b0 = 0.2, 0.3, 0.7
    r0 = (1 - math.sqrt(1 - w)) / (1 + math.sqrt(1 - w))
    cosine = (np.arange(2000) + 0.5) / 2000
    disc = [brdf.hapke(m, m, 1.0, w, b, c, b0, 0.05) * m * m for m in cosine]
    p0 = brdf.double_henyey_greenstein(1.0, b, c)
    expected = r0 / 2 * (1 + r0 / 3) + w / 8 * ((1 + b0) * p0 - 1)
    assert 2 * np.mean(disc) == pytest.approx(expected, rel=0.01)


def test_opposition_surge_has_its_height_and_half_width():
    w, b0, width = 1e-6, 0.8, 0.1
    base, peak = (brdf.hapke(0.9, 0.9, 1.0, w, 0.0, 0.0, value, width) for value in (0.0, b0))
    assert peak / base == pytest.approx(1 + b0, rel=1e-5)
    # B falls to a half where tan(g / 2) is the width.
    g = 2 * math.atan(width)
    side = brdf.hapke(0.9, 0.9, math.cos(g), w, 0.0, 0.0, b0, width)
    assert side / base == pytest.approx(1 + b0 / 2, rel=1e-5)


def test_hapke_is_finite_straight_against_the_light():
    assert math.isfinite(brdf.hapke(1e-3, 1e-3, -1.0, 0.5, 0.3, 0.5, 1.0, 0.05))


def test_bright_lobed_hapke_returns_what_its_description_admits():
    for w, surge, expected in (
        (1.0, 0.0, 1.03),
        (1.0, 1.0, 1.06),
        (0.9, 0.0, 0.45),
        (0.9, 1.0, 0.48),
    ):
        found = share("hapke", 90.0, w, 0.3, 0.4, surge, 0.05)
        assert found == pytest.approx(expected, abs=0.005)
