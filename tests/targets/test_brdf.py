"""Reflectance models against energy conservation, reciprocity and their limits."""

import numpy as np
import pytest

from reliefscope import brdf


def hemisphere(count: int = 200):
    """Directions and solid angles that tile the upper hemisphere."""
    cosine = (np.arange(count) + 0.5) / count
    azimuth = (np.arange(2 * count) + 0.5) * np.pi / count
    cos, phi = np.meshgrid(cosine, azimuth)
    sin = np.sqrt(1 - cos**2)
    return np.stack([sin * np.cos(phi), sin * np.sin(phi), cos], axis=-1), np.pi / count / count


def ggx_towards(view, light, alpha, f0):
    half = view + light
    half /= np.linalg.norm(half, axis=-1, keepdims=True)
    cosines = np.stack(
        [light[..., 2], view[..., 2] + 0 * light[..., 2], half[..., 2], (half * view).sum(-1)], -1
    )
    flat = [brdf.ggx(*row, alpha, f0) for row in cosines.reshape(-1, 4)]
    return np.reshape(flat, light.shape[:-1])


@pytest.mark.parametrize("alpha", [0.15, 0.4, 0.8])
@pytest.mark.parametrize("elevation_deg", [30.0, 60.0, 90.0])
def test_ggx_never_reflects_more_than_arrives(alpha, elevation_deg):
    light, solid_angle = hemisphere(80)
    tilt = np.radians(elevation_deg)
    view = np.array([np.cos(tilt), 0.0, np.sin(tilt)])
    reflected = (ggx_towards(view, light, alpha, 1.0) * light[..., 2]).sum() * solid_angle / np.pi
    assert 0.2 < reflected <= 1.01


def test_ggx_of_unit_width_seen_from_above_reflects_its_closed_form():
    # alpha = 1: facets spread evenly, pi f_r = 1 / (2 (1 + nl)), so E = integral of c / (1 + c) dc.
    light, solid_angle = hemisphere(150)
    values = ggx_towards(np.array([0.0, 0.0, 1.0]), light, 1.0, 1.0)
    assert (values * light[..., 2]).sum() * solid_angle / np.pi == pytest.approx(
        1 - np.log(2), rel=1e-3
    )


def test_a_narrow_ggx_lobe_is_a_mirror_that_loses_nothing():
    light, solid_angle = hemisphere(400)
    values = ggx_towards(np.array([0.0, 0.0, 1.0]), light, 0.1, 1.0)
    assert (values * light[..., 2]).sum() * solid_angle / np.pi == pytest.approx(1.0, abs=0.03)


def test_ggx_is_reciprocal():
    assert brdf.ggx(0.3, 0.8, 0.9, 0.6, 0.3, 0.5) == pytest.approx(
        brdf.ggx(0.8, 0.3, 0.9, 0.6, 0.3, 0.5), rel=1e-12
    )


def test_fresnel_runs_from_f0_to_one():
    assert brdf.fresnel(0.04, 1.0) == pytest.approx(0.04)
    assert brdf.fresnel(0.04, 0.0) == pytest.approx(1.0)


def test_oren_nayar_without_roughness_is_lambert():
    assert brdf.oren_nayar(0.4, 0.9, 0.5, 0.7, 0.0) == pytest.approx(0.7)


@pytest.mark.parametrize("sigma", [0.2, 0.5])
def test_oren_nayar_conserves_energy_and_brightens_toward_the_light(sigma):
    light, solid_angle = hemisphere(80)
    view = np.array([0.6, 0.0, 0.8])
    values = np.reshape(
        [
            brdf.oren_nayar(row[2], 0.8, float(row @ view), 1.0, sigma)
            for row in light.reshape(-1, 3)
        ],
        light.shape[:-1],
    )
    assert (values * light[..., 2]).sum() * solid_angle / np.pi <= 1.0
    backward = brdf.oren_nayar(0.8, 0.8, 1.0, 1.0, sigma)
    forward = brdf.oren_nayar(0.8, 0.8, 0.28, 1.0, sigma)
    assert backward > forward
