import numba
import numpy as np
import pytest

from reliefscope import axes
from reliefscope.errors import InvalidInputError
from reliefscope.models.light_field import LightField
from reliefscope.reconstruction.photometric import (
    PsResult,
    check_directions,
    full_scale_of,
    solve,
    solve_lambert,
)


def ring_lights(count: int = 8, elevations_deg: tuple[float, ...] = (22.5, 45.0)) -> np.ndarray:
    return np.array(
        [
            axes.direction(np.radians(elevation), 2 * np.pi * k / count)
            for elevation in elevations_deg
            for k in range(count)
        ]
    )


def random_normals(rng: np.random.Generator, shape: tuple[int, int], tilt: float) -> np.ndarray:
    normals = np.concatenate([rng.uniform(-tilt, tilt, (*shape, 2)), np.ones((*shape, 1))], axis=-1)
    return normals / np.linalg.norm(normals, axis=-1, keepdims=True)


def test_noisy_intensities_agree_with_lstsq() -> None:
    rng = np.random.default_rng(1)
    lights = ring_lights()
    images = rng.uniform(0.0, 1.0, (16, 23, 301)).astype(np.float32)
    result = solve_lambert(images, lights)
    flat = images.reshape(16, -1).astype(np.float64)
    solution, *_ = np.linalg.lstsq(lights, flat, rcond=None)
    rho = np.linalg.norm(solution, axis=0)
    residual = np.sqrt(np.mean((flat - lights @ solution) ** 2, axis=0))
    np.testing.assert_allclose(result.albedo.ravel(), rho, rtol=2e-5)
    np.testing.assert_allclose(result.residual.ravel(), residual, rtol=2e-5)
    np.testing.assert_allclose(result.normals.reshape(-1, 3), (solution / rho).T, atol=2e-5, rtol=0)


def test_lambert_scene_is_recovered_exactly() -> None:
    rng = np.random.default_rng(2)
    normals = random_normals(rng, (9, 11), 0.3)
    albedo = rng.uniform(0.1, 0.9, (9, 11))
    lights = ring_lights()
    images = np.einsum("lc,hwc->lhw", lights, normals) * albedo
    assert images.min() > 0
    result = solve_lambert(images.astype(np.float32), lights * 7.0)
    np.testing.assert_allclose(result.normals, normals, atol=1e-5)
    np.testing.assert_allclose(result.albedo, albedo, rtol=1e-5)
    assert result.residual.max() < 1e-6


def test_signs_of_normals() -> None:
    """A surface that rises to the right leans to the left; one that rises upward leans down."""
    lights = ring_lights()
    x_um, y_um = axes.pixel_grid_um((5, 7), 1.0)
    height_um = 0.3 * x_um[None, :] + 0.2 * y_um[:, None]
    images = np.einsum("lc,hwc->lhw", lights, axes.normals_from_height(height_um, 1.0))
    result = solve_lambert(images.astype(np.float32), lights)
    slope_x, slope_y = axes.gradient_from_normals(result.normals)
    np.testing.assert_allclose(slope_x, 0.3, atol=1e-5)
    np.testing.assert_allclose(slope_y, 0.2, atol=1e-5)


def test_quality_follows_equation_10() -> None:
    """The Sobel operators as matrices written out by hand, on a random field of normals."""
    rng = np.random.default_rng(3)
    normals = random_normals(rng, (6, 7), 0.4)
    lights = ring_lights()
    images = np.einsum("lc,hwc->lhw", lights, normals) + rng.normal(0, 0.1, (16, 6, 7))
    result = solve_lambert(images.astype(np.float32), lights)
    kernel_x = np.array([[-1, 0, 1], [-2, 0, 2], [-1, 0, 1]]) / 8
    kernel_y = np.array([[1, 2, 1], [0, 0, 0], [-1, -2, -1]]) / 8
    row, column = 3, 4
    window = result.normals[row - 1 : row + 2, column - 1 : column + 2].astype(np.float64)
    change = np.hypot(np.sum(window[..., 0] * kernel_x), np.sum(window[..., 1] * kernel_y))
    slant_deg = np.degrees(np.arccos(window[1, 1, 2]))
    expected = (
        2.0 ** -((float(result.residual[row, column]) / 0.2) ** 2)
        * 2.0 ** -((slant_deg / 80) ** 2)
        * 2.0 ** -((change / 0.1) ** 2)
    )
    assert result.change[row, column] == pytest.approx(change, rel=1e-4)
    assert np.degrees(result.slant_rad[row, column]) == pytest.approx(slant_deg, rel=1e-4)
    assert result.quality[row, column] == pytest.approx(expected, rel=1e-3)


def test_change_is_per_pixel() -> None:
    """A cylinder turns its normal by 1/radius per pixel, whatever the pixel measures."""
    radius = 200.0
    x = np.arange(-40, 41) / radius
    normals = np.stack([x, np.zeros_like(x), np.sqrt(1 - x**2)], axis=-1)[None].repeat(5, axis=0)
    lights = ring_lights()
    images = np.einsum("lc,hwc->lhw", lights, normals).astype(np.float32)
    result = solve_lambert(images, lights)
    # Sobel/8 spans two pixels and divides by two: the derivative per pixel
    np.testing.assert_allclose(result.change[2, 1:-1], 1 / radius, rtol=1e-3)


def test_missing_and_dark_pixels_have_no_quality() -> None:
    lights = ring_lights()
    images = np.full((16, 8, 9), 0.4, np.float32)
    images[3, 2, 2] = np.nan
    images[:, 6, 6] = 0.0
    images[2:, 4, 7] = np.nan
    robust = solve(images, LightField.distant(lights), 1.0)
    assert np.isfinite(robust.normals[2, 2]).all()  # 15 lights are left there
    for result, missing in (
        (solve_lambert(images, lights), ((2, 2), (6, 6), (4, 7))),
        (robust, ((6, 6), (4, 7))),
    ):
        for row, column in missing:
            assert np.isnan(result.normals[row, column]).all()
            assert result.quality[row, column] == 0.0
        assert np.isfinite(result.quality).all()
        assert result.quality[4, 0] > 0.5


def angles_deg(normals: np.ndarray, truth: np.ndarray) -> np.ndarray:
    cross = np.linalg.norm(np.cross(normals.astype(np.float64), truth), axis=-1)
    return np.degrees(np.arctan2(cross, np.sum(normals * truth, axis=-1)))


def test_robust_form_ignores_shadows_and_highlights() -> None:
    """Two unmasked shadows and one highlight: kept out; least squares is far off."""
    rng = np.random.default_rng(4)
    normals = random_normals(rng, (12, 141), 0.25)
    lights = ring_lights()
    clean = np.einsum("lc,hwc->lhw", lights, normals)
    images = clean + rng.normal(0.0, 0.002, clean.shape)
    order = np.argsort(clean, axis=0)
    np.put_along_axis(images, order[:2], 0.0, axis=0)
    np.put_along_axis(images, order[-1:], 3.0, axis=0)
    plain = solve_lambert(images.astype(np.float32), lights)
    robust = solve(images.astype(np.float32), LightField.distant(lights), 1.0)
    assert np.median(angles_deg(plain.normals, normals)) > 10.0
    assert np.percentile(angles_deg(robust.normals, normals), 95) < 1.0


def test_robust_form_agrees_with_least_squares_where_nothing_disagrees() -> None:
    """Noise below the tolerated residual: every light counts, weights near one."""
    rng = np.random.default_rng(5)
    normals = random_normals(rng, (7, 300), 0.25)
    lights = ring_lights()
    images = np.einsum("lc,hwc->lhw", lights, normals) + rng.normal(0, 0.001, (16, 7, 300))
    robust = solve(images.astype(np.float32), LightField.distant(lights), 1.0)
    plain = solve_lambert(images.astype(np.float32), lights)
    assert robust.lights_used is not None
    assert robust.lights_used.min() > 15.0
    assert np.abs(robust.normals - plain.normals).max() < 3e-4
    np.testing.assert_allclose(robust.albedo, plain.albedo, rtol=3e-4)


def test_masked_lights_do_not_count() -> None:
    rng = np.random.default_rng(6)
    normals = random_normals(rng, (6, 9), 0.25)
    lights = ring_lights()
    clean = np.einsum("lc,hwc->lhw", lights, normals).astype(np.float32)
    lit = rng.random(clean.shape) > 0.5
    lit[:4] = True
    images = np.where(lit, clean, np.float32(0.0))
    masked = solve(images, LightField.distant(lights), 1.0, lit=lit)
    assert angles_deg(masked.normals, normals).max() < 0.01
    assert masked.lights_used is not None
    np.testing.assert_allclose(masked.lights_used, lit.sum(axis=0), atol=0.05)


def shaded_images(normals: np.ndarray, lights: np.ndarray, passed: float) -> np.ndarray:
    """Lambert's law where a surface faces the light, and what others pass on, ``passed * E_z``, everywhere."""
    direct = np.maximum(np.einsum("lc,hwc->lhw", lights, normals), 0.0)
    return (direct + passed * lights[:, 2, None, None]).astype(np.float32)


def test_light_from_other_surfaces_is_taken_off_where_shadows_tell_it() -> None:
    """Steep faces, of which half of the lights are hidden: exact with the shadows, too upright without."""
    lights = ring_lights()
    rng = np.random.default_rng(13)
    azimuth = rng.uniform(0, 2 * np.pi, (9, 200))
    slant = np.radians(rng.uniform(55.0, 70.0, azimuth.shape))
    flat = np.sin(slant)
    normals = np.stack([flat * np.cos(azimuth), flat * np.sin(azimuth), np.cos(slant)], axis=-1)
    images = shaded_images(normals, lights, 0.2)
    lit = np.einsum("lc,hwc->lhw", lights, normals) > 0.0
    assert 5 < lit.sum(axis=0).min() <= lit.sum(axis=0).max() < 14
    told = solve(images, LightField.distant(lights), 1.0, lit=lit)
    assert angles_deg(told.normals, normals).max() < 0.05
    np.testing.assert_allclose(told.albedo, 1.0, rtol=1e-3)
    uncorrected = solve(
        np.where(lit, images, np.float32(0)), LightField.distant(lights), 1.0, lit=lit
    )
    assert np.median(angles_deg(uncorrected.normals, normals)) > 7.0


def test_a_shadow_in_the_wrong_place_is_not_taken_for_light_from_other_surfaces() -> None:
    lights = ring_lights()
    normals = random_normals(np.random.default_rng(14), (5, 40), 0.2)
    images = shaded_images(normals, lights, 0.0)
    lit = np.ones(images.shape, bool)
    lit[::3] = False  # in the light all the same
    result = solve(images, LightField.distant(lights), 1.0, lit=lit)
    assert angles_deg(result.normals, normals).max() < 0.05


def test_powers_of_the_lights_are_divided_out() -> None:
    rng = np.random.default_rng(7)
    normals = random_normals(rng, (6, 9), 0.3)
    lights, powers = ring_lights(), rng.uniform(0.5, 2.0, 16)
    images = powers[:, None, None] * np.einsum("lc,hwc->lhw", lights, normals)
    result = solve(images.astype(np.float32), LightField.distant(lights, powers), 1.0)
    assert angles_deg(result.normals, normals).max() < 0.01
    np.testing.assert_allclose(result.albedo, powers.mean(), rtol=1e-4)


def test_near_lights_are_followed_across_the_field() -> None:
    """LEDs 20 mm away over a field of 1.6 mm, traced from their positions without the class under test."""
    rng = np.random.default_rng(8)
    shape, pixel_um = (140, 400), 4.0
    normals = random_normals(rng, shape, 0.25)
    positions_mm = 20.0 * ring_lights() * rng.uniform(0.9, 1.1, (16, 1))
    intensities = rng.uniform(0.8, 1.2, 16)
    x_um, y_um = axes.pixel_grid_um(shape, pixel_um)
    points_mm = np.stack(np.broadcast_arrays(x_um[None], y_um[:, None], 0.0), axis=-1) / 1000
    images = np.empty((16, *shape))
    for light, (place, intensity) in enumerate(zip(positions_mm, intensities, strict=True)):
        way = place - points_mm
        distance = np.linalg.norm(way, axis=-1)
        images[light] = intensity * (way * normals).sum(axis=-1) / distance**3
    strengths = np.diag(intensities / np.linalg.norm(positions_mm, axis=1) ** 2)
    near = LightField.of_leds(positions_mm, strengths)
    result = solve(images.astype(np.float32), near, pixel_um)
    assert angles_deg(result.normals, normals).max() < 0.02
    distant = solve(
        images.astype(np.float32), LightField.distant(positions_mm, near.powers), pixel_um
    )
    assert np.percentile(angles_deg(distant.normals, normals), 95) > 1.0


def test_a_ring_is_the_sum_of_its_leds() -> None:
    """Opposite pairs of a ring: their light comes from between them."""
    rng = np.random.default_rng(9)
    leds = 25.0 * ring_lights(8, (35.0,))
    strengths = np.zeros((8, 8))
    for light in range(8):
        strengths[light, [light, (light + 2) % 8]] = 0.5, 1.0
    field = LightField.of_leds(leds, strengths)
    expected = strengths @ (leds / 25.0)
    np.testing.assert_allclose(field.vectors, expected, atol=1e-12)
    np.testing.assert_allclose(field.irradiance(np.zeros(3)), expected, atol=1e-12)
    normals = random_normals(rng, (5, 6), 0.2)
    images = np.einsum("lc,hwc->lhw", expected, normals).astype(np.float32)
    assert angles_deg(solve(images, field, 0.01).normals, normals).max() < 0.01


def test_stated_error_is_that_of_noise_on_a_flat_sample() -> None:
    """68 % of the errors within it, from noise alone, for strong and for weak noise."""
    rng = np.random.default_rng(10)
    lights = ring_lights()
    normals = np.broadcast_to([0.0, 0.0, 1.0], (60, 250, 3))
    clean = np.einsum("lc,hwc->lhw", lights, normals)
    stated = {}
    for noise in (0.01, 0.04):
        noisy = (clean + rng.normal(0, noise, clean.shape)).astype(np.float32)
        result = solve(noisy, LightField.distant(lights), 1.0)
        assert result.sigma_rad is not None
        stated[noise] = float(np.median(result.sigma_rad))
        errors = np.radians(angles_deg(result.normals, normals))
        assert np.mean(errors < result.sigma_rad) > 0.6
    assert 2.0 < stated[0.04] / stated[0.01] < 4.5


def test_stated_error_ranks_shadows_slopes_and_edges() -> None:
    lights = ring_lights()
    slant = np.radians([0.0, 20.0, 40.0])
    normals = np.stack([np.sin(slant), 0 * slant, np.cos(slant)], axis=-1)
    normals = np.repeat(normals, 30, axis=0)[None].repeat(20, axis=0)
    images = np.einsum("lc,hwc->lhw", lights, normals).astype(np.float32)
    images[:8, 12:, :30] *= 0.5  # half of the lights do not fit
    result = solve(images, LightField.distant(lights), 1.0)
    assert result.sigma_rad is not None
    flat, steep = result.sigma_rad[4, [15, 75]]
    misfit = result.sigma_rad[17, 15]
    edge = result.sigma_rad[4, 30]
    assert flat < steep < edge
    assert misfit > 2 * flat
    blind = solve(images[:3], LightField.distant(lights[[0, 1, 2]]), 1.0, maximum_condition=1e3)
    assert blind.sigma_rad is not None
    assert blind.sigma_rad[4, 15] > 1.4 * flat


def test_space_for_the_result_is_used() -> None:
    lights = ring_lights()
    images = np.einsum(
        "lc,hwc->lhw", lights, random_normals(np.random.default_rng(11), (5, 6), 0.2)
    )
    stack = images.astype(np.float32)
    for robust in (False, True):
        space = PsResult.empty((5, 6), robust=robust)
        result = (
            solve(stack, LightField.distant(lights), 1.0, out=space)
            if robust
            else solve_lambert(stack, lights, full_scale=full_scale_of(stack), out=space)
        )
        assert result is space
        assert np.isfinite(space.normals).all()


def test_lights_that_cannot_work_are_refused_with_the_number() -> None:
    lights = ring_lights()
    with pytest.raises(InvalidInputError, match="there are 2"):
        check_directions(lights[:2])
    column = np.array([[0.05 * np.sin(7.0 * t), t, 1.0] for t in np.linspace(-0.5, 0.5, 12)]) * 1.0
    condition = np.linalg.cond(column / np.linalg.norm(column, axis=1, keepdims=True))
    assert condition > 20
    with pytest.raises(InvalidInputError, match=f"condition number {condition:.3g}"):
        check_directions(column)
    with pytest.raises(InvalidInputError, match=r"\[4\] point below"):
        check_directions(np.vstack([lights[:4], [[0.1, 0.0, -1.0]]]))
    with pytest.raises(InvalidInputError, match="not finite"):
        check_directions(np.vstack([lights[:4], [[np.nan, 0.0, 1.0]]]))
    with pytest.raises(InvalidInputError, match="do not belong"):
        solve_lambert(np.zeros((5, 4, 4), np.float32), lights)
    with pytest.raises(InvalidInputError, match="there are 2"):
        solve(np.zeros((2, 4, 4), np.float32), LightField.distant(lights[:2]), 1.0)
    lit = np.ones((16, 4, 5), bool)
    with pytest.raises(InvalidInputError, match="mask"):
        solve(np.zeros((16, 4, 4), np.float32), LightField.distant(lights), 1.0, lit=lit)


def test_the_number_of_threads_changes_nothing() -> None:
    rng = np.random.default_rng(12)
    images = rng.uniform(0.05, 1.0, (16, 70, 150)).astype(np.float32)
    field = LightField.of_leds(30.0 * ring_lights(), np.eye(16), 8.75)
    threads = numba.get_num_threads()
    results = []
    for count in {1, threads}:
        numba.set_num_threads(count)
        results.append(solve(images, field, 4.0))
    numba.set_num_threads(threads)
    for name in ("normals", "albedo", "residual", "quality", "sigma_rad", "lights_used"):
        np.testing.assert_array_equal(getattr(results[0], name), getattr(results[-1], name))
