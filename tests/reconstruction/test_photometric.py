import numpy as np
import pytest

from reliefscope import axes
from reliefscope.errors import InvalidInputError
from reliefscope.reconstruction.photometric import check_directions, kept_ranks, solve_lambert


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
    for trim in (None, (0.2, 0.9)):
        result = solve_lambert(images, lights, trim=trim)
        for row, column in ((2, 2), (6, 6)):
            assert np.isnan(result.normals[row, column]).all()
            assert result.quality[row, column] == 0.0
        assert np.isfinite(result.quality).all()
        assert result.quality[4, 0] > 0.5


def test_trimming_ignores_shadows_and_highlights() -> None:
    rng = np.random.default_rng(4)
    normals = random_normals(rng, (12, 13), 0.25)
    lights = ring_lights()
    clean = np.einsum("lc,hwc->lhw", lights, normals)
    images = clean.copy()
    order = np.argsort(clean, axis=0)
    np.put_along_axis(images, order[:2], 0.0, axis=0)
    np.put_along_axis(images, order[-1:], 3.0, axis=0)
    plain = solve_lambert(images.astype(np.float32), lights)
    trimmed = solve_lambert(images.astype(np.float32), lights, trim=(0.2, 0.9))
    np.testing.assert_allclose(trimmed.normals, normals, atol=2e-5)
    assert trimmed.residual.max() < 1e-5
    assert np.abs(plain.normals - normals).max() > 0.1


def test_trimming_agrees_with_lstsq_on_the_kept_lights() -> None:
    rng = np.random.default_rng(5)
    lights = ring_lights()
    images = rng.uniform(0.1, 1.0, (16, 4, 5)).astype(np.float32)
    result = solve_lambert(images, lights, trim=(0.2, 0.9))
    assert kept_ranks(16, (0.2, 0.9)) == (3, 15)
    kept = np.argsort(images[:, 1, 2])[3:15]
    solution, *_ = np.linalg.lstsq(lights[kept], images[kept, 1, 2].astype(float), rcond=None)
    np.testing.assert_allclose(
        result.normals[1, 2] * result.albedo[1, 2], solution, rtol=1e-4, atol=1e-5
    )


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
    with pytest.raises(InvalidInputError, match="3 are needed"):
        kept_ranks(5, (0.4, 0.6))
