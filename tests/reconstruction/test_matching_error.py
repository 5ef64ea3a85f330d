"""Standard error of matched heights: roughness against least squares, and what widens it."""

import numpy as np
import pytest
from tests.reconstruction import scenes

from reliefscope.reconstruction.joint import match_jointly
from reliefscope.reconstruction.matching_error import (
    BRIGHTNESS_EXPONENT,
    GREATEST_CONTRAST,
    GREATEST_UM,
    error_share,
    knows_nothing_um,
    roughness,
    standard_error,
)

SHAPE = (128, 160)
INSIDE = np.s_[24:-24, 24:-24]


def test_roughness_is_the_residual_to_the_best_plane() -> None:
    rng = np.random.default_rng(1)
    rows, cols = np.mgrid[:20, :24]
    height = (40 + 3.0 * rows - 2.0 * cols + rng.normal(0, 0.5, rows.shape)).astype(np.float32)
    found = roughness(height, 5)
    for r, c in ((8, 9), (10, 15)):
        part = height[r - 2 : r + 3, c - 2 : c + 3].astype(np.float64).ravel()
        y, x = np.mgrid[-2:3, -2:3]
        basis = np.stack([np.ones(25), y.ravel(), x.ravel()], axis=1)
        fit = basis @ np.linalg.lstsq(basis, part, rcond=None)[0]
        assert abs(found[r, c] - np.sqrt(np.mean((part - fit) ** 2))) < 1e-3


def test_missing_and_flat_peaks_know_nothing_and_spare_their_surroundings() -> None:
    height = np.full((40, 40), 3.0, np.float32)
    height[5, 5] = np.nan
    peak = np.full((40, 40), 0.95, np.float32)
    curvature = np.full((40, 40), 0.01, np.float32)
    curvature[20, 20] = 0.0
    brightness = np.zeros((40, 40), np.float32)
    brightness[5, 5] = np.nan
    sigma = standard_error(height, peak, curvature, brightness, 0.05)
    assert sigma[5, 5] == sigma[20, 20] == GREATEST_UM
    assert sigma[30, 30] == sigma[5, 7] < 1.0


def test_dark_ground_beside_a_bright_surface_is_less_certain_than_the_surface() -> None:
    height = np.full((40, 40), 3.0, np.float32)
    peak = np.full((40, 40), 0.95, np.float32)
    curvature = np.full((40, 40), 0.01, np.float32)
    brightness = np.full((40, 40), np.log(0.1), np.float32)
    brightness[:, :20] = np.log(0.3)
    sigma = standard_error(height, peak, curvature, brightness, 0.05)
    assert np.allclose(sigma[:, :20], sigma[0, 0])
    assert np.allclose(sigma[:, 22] / sigma[0, 0], 3.0**BRIGHTNESS_EXPONENT, rtol=1e-4)
    assert np.allclose(sigma[:, 30:], sigma[0, 0])  # as dark as all around
    brightness[:, 20:] = np.log(1e-6)
    black = standard_error(height, peak, curvature, brightness, 0.05)
    assert np.allclose(
        black[:, 22] / black[0, 0], np.exp(BRIGHTNESS_EXPONENT * GREATEST_CONTRAST), rtol=1e-4
    )


def test_sigma_grows_with_noise_as_the_errors_do() -> None:
    errors, sigmas = [], []
    for noise in (0.003, 0.06):
        scene = scenes.render(
            scenes.plane(0.05, 0.1, 8.0), SHAPE, scenes.hexagon_slopes(12, 0.127), noise=noise
        )
        found = match_jointly(scene.views, scene.slopes, (-10.0, 50.0), scene.pixel_um)
        assert found.sigma_um is not None
        errors.append(np.abs(found.height_um - scene.height_um)[INSIDE].mean())
        sigmas.append(np.median(found.sigma_um[INSIDE]))
    assert errors[1] > 1.5 * errors[0]
    assert sigmas[1] > 1.5 * sigmas[0]


def test_a_height_that_is_no_better_than_a_guess_is_not_accepted() -> None:
    draws = np.random.default_rng(1).uniform(-20.0, 40.0, 100_000)
    assert abs(knows_nothing_um((-20.0, 40.0)) - draws.std()) < 0.1
    views = np.random.default_rng(2).random((6, *SHAPE)).astype(np.float32)  # nothing in common
    found = match_jointly(views, scenes.hexagon_slopes(6, 0.127), (-20.0, 40.0), 1.12, binning=1)
    known = np.isfinite(found.height_um)
    assert found.sigma_um is not None
    guessed = found.sigma_um >= np.float32(knows_nothing_um((-20.0, 40.0)))
    assert (guessed & known).sum() > 0.2 * known.sum()
    assert not found.quality[guessed].any()
    assert not found.accepted(0.01)[guessed].any()


def test_sigma_is_great_at_a_step_and_where_nothing_is_seen() -> None:
    edge = 80
    scene = scenes.render(
        lambda row, col: np.where(col < edge, 0.0, 30.0) + 0.0 * row,
        SHAPE,
        scenes.hexagon_slopes(12, 0.127),
    )
    found = match_jointly(scene.views, scene.slopes, (-10.0, 40.0), scene.pixel_um)
    assert found.sigma_um is not None
    sigma = np.median(found.sigma_um[INSIDE[0]], axis=0)
    assert sigma[edge - 2 : edge + 2].min() > 5 * sigma[[edge - 30, edge + 30]].max()
    missing = np.isnan(found.height_um)
    assert np.isinf(found.sigma_um[missing]).all()
    assert np.isfinite(found.sigma_um[~missing]).all()


def test_share_of_errors_is_neither_that_of_the_best_nor_of_the_worst_heights() -> None:
    """Regolith: most heights are certain, many are not, and discarded ones count for nothing."""
    rng = np.random.default_rng(8)
    height = 40.0 * rng.standard_normal((60, 80)).astype(np.float32)
    sigma = np.exp(rng.normal(np.log(8.0), 1.0, height.shape)).astype(np.float32)
    quality = np.ones_like(height)
    sigma[:10], quality[:10] = 43.0, 0.0
    share = error_share(height, sigma, quality)
    kept = sigma[10:]
    assert np.median(kept) ** 2 / 40.0**2 < share < np.mean(kept**2) / 40.0**2
    assert share == pytest.approx((8.0 * np.exp(0.5)) ** 2 / 40.0**2, rel=0.15)
