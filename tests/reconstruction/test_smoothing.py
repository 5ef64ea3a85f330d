"""Garcia's smoothing against closed forms and explicit matrices."""

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy import ndimage, optimize

from reliefscope.errors import Cancelled, InvalidInputError
from reliefscope.jobs import Job
from reliefscope.reconstruction import smoothing
from reliefscope.reconstruction.smoothing import smooth_robust

Array = NDArray[np.float64]


def laplacian(shape: tuple[int, int]) -> Array:
    """Matrix of the five-point Laplacian; a neighbour outside repeats the border."""
    size = shape[0] * shape[1]
    index = np.arange(size).reshape(shape)
    matrix = np.zeros((size, size))
    for row, col in np.ndindex(shape):
        for d_row, d_col in ((1, 0), (-1, 0), (0, 1), (0, -1)):
            r, c = row + d_row, col + d_col
            if 0 <= r < shape[0] and 0 <= c < shape[1]:
                matrix[index[row, col], index[row, col]] -= 1
                matrix[index[row, col], index[r, c]] += 1
    return matrix


def hill(shape: tuple[int, int]) -> Array:
    rows, cols = np.mgrid[: shape[0], : shape[1]]
    return np.asarray(
        30 * np.exp(-((rows - shape[0] / 2) ** 2 + (cols - shape[1] / 3) ** 2) / 200) + 0.1 * cols
    )


def test_constant_is_kept_and_cosines_are_damped_by_the_closed_form() -> None:
    rows, cols = np.mgrid[:20, :30]
    for i, j, s in ((0, 0, 5.0), (1, 2, 10.0), (3, 0, 0.5), (7, 9, 2.0)):
        mode = np.cos(np.pi * i * (rows + 0.5) / 20) * np.cos(np.pi * j * (cols + 0.5) / 30)
        eigenvalue = 2 * np.cos(np.pi * i / 20) - 2 + 2 * np.cos(np.pi * j / 30) - 2
        result = smooth_robust(100 + mode, robust=False, parameter=s)
        expected = 100 + mode / (1 + s * eigenvalue**2)
        assert np.allclose(result.values, expected, atol=1e-9)


def test_weights_and_gaps_solve_the_dense_system() -> None:
    shape = (14, 17)
    rng = np.random.default_rng(1)
    y = hill(shape) + rng.normal(0, 0.5, shape)
    w = rng.uniform(0.2, 1.0, shape)
    y[4:8, 5:9] = np.nan
    w[10:12, 2] = 0.0
    known = np.isfinite(y) & (w > 0)
    matrix = laplacian(shape)
    weight = np.where(known, w, 0).ravel() / w[known].max()
    for s in (0.3, 4.0, 200.0):
        dense = np.linalg.solve(
            np.diag(weight) + s * matrix.T @ matrix, weight * np.nan_to_num(y).ravel()
        ).reshape(shape)
        result = smooth_robust(y, w, robust=False, parameter=s)
        assert np.abs(result.values - dense).max() < 0.02
        assert np.array_equal(result.outlier_weights > 0, known)


def test_parameter_is_that_of_generalised_cross_validation_with_explicit_matrices() -> None:
    shape = (16, 18)
    y = hill(shape) + np.random.default_rng(2).normal(0, 0.7, shape)
    matrix = laplacian(shape)
    eigenvalues, vectors = np.linalg.eigh(matrix.T @ matrix)

    def score(exponent: float) -> float:
        gain = 1 / (1 + 10.0**exponent * eigenvalues)
        fitted = vectors @ (gain * (vectors.T @ y.ravel()))
        n = y.size
        return float(((y.ravel() - fitted) ** 2).sum() / n / (1 - gain.sum() / n) ** 2)

    best = optimize.minimize_scalar(score, bounds=(-4, 6), method="bounded")
    result = smooth_robust(y, robust=False)
    assert np.log10(result.parameter) == pytest.approx(float(best.x), abs=0.06)
    assert score(float(np.log10(result.parameter))) <= score(float(best.x)) * (1 + 1e-3)


def test_noise_is_removed_gaps_are_filled_and_outliers_ignored() -> None:
    shape = (96, 128)
    rng = np.random.default_rng(3)
    truth = 20 * np.sin(np.mgrid[:96, :128][1] / 20.0) + 0.2 * np.mgrid[:96, :128][0]
    y = (truth + rng.normal(0, 1.0, shape)).astype(np.float32)
    outliers = rng.random(shape) < 0.05
    y[outliers] += rng.uniform(30, 60, int(outliers.sum())).astype(np.float32)
    gaps = ndimage.binary_dilation(rng.random(shape) < 0.004, iterations=4)
    y[gaps] = np.nan
    quality = np.full(shape, 0.6, dtype=np.float32)
    robust = smooth_robust(y, quality)
    plain = smooth_robust(y, quality, robust=False)
    assert robust.values.dtype == np.float32
    error = np.abs(robust.values - truth)
    assert 0.1 < gaps.mean() < 0.4
    assert error[~gaps].mean() < 0.25
    assert error[gaps].mean() < 0.5
    assert np.abs(plain.values - truth).mean() > 3 * error.mean()
    assert robust.outlier_weights[outliers & ~gaps].max() < 0.01
    assert np.median(robust.outlier_weights[~outliers & ~gaps]) > 0.9


def test_resolution_keeps_the_structure_of_a_map_that_is_mostly_flat() -> None:
    # Heights taken from candidates 1 um apart: flat ground without any deviation, one steep mound.
    rows, cols = np.mgrid[:96, :128]
    mound = 25 * np.exp(-((rows - 48) ** 2 + (cols - 64) ** 2) / 60)
    y = np.round(mound + np.random.default_rng(6).normal(0, 0.2, mound.shape))
    y[5, 7] = 60.0
    blind = smooth_robust(y)
    told = smooth_robust(y, resolution=1.0)
    top = mound > 5
    assert np.abs(told.values - mound)[top].mean() < 0.5 < np.abs(blind.values - mound)[top].mean()
    assert (told.outlier_weights[top] > 0.5).mean() > 0.95
    assert told.outlier_weights[5, 7] == 0.0
    assert abs(told.values[5, 7]) < 0.5


def test_result_moves_and_scales_with_the_data() -> None:
    shape = (40, 50)
    y = hill(shape) + np.random.default_rng(4).normal(0, 0.5, shape)
    y[10:14, 20:30] = np.nan
    one = smooth_robust(y)
    other = smooth_robust(3 * y + 1000)
    assert other.parameter == pytest.approx(one.parameter, rel=1e-6)
    assert np.allclose(other.values, 3 * one.values + 1000, atol=1e-6)


def test_a_gap_in_a_quadratic_is_bridged_by_the_smoothest_surface() -> None:
    # A harmonic quadratic has no Laplacian at all: away from the border it costs nothing.
    rows, cols = np.mgrid[:48, :48].astype(float)
    y = 0.02 * ((rows - 20) ** 2 - (cols - 25) ** 2)
    holed = y.copy()
    holed[18:30, 16:28] = np.nan
    result = smooth_robust(holed, robust=False, parameter=1e-3)
    assert np.abs(result.values - y)[18:30, 16:28].max() < 0.05


def test_padding_to_a_fast_size_does_not_show(monkeypatch: pytest.MonkeyPatch) -> None:
    shape = (83, 94)  # 83 is prime, 94 is 2 * 47
    y = hill(shape) + np.random.default_rng(5).normal(0, 0.5, shape)
    plain = smooth_robust(y, robust=False)
    monkeypatch.setattr(smoothing, "PAD_FROM", 50)
    padded = smooth_robust(y, robust=False)
    assert padded.values.shape == shape
    assert np.abs(padded.values - plain.values)[:-8, :-8].max() < 0.1
    assert np.abs(padded.values - plain.values).max() < 1.0


def test_parameter_bounds_are_the_leverages() -> None:
    for leverage in (1e-5, 0.1, 0.5, 0.99):
        s = smoothing._parameter_of(leverage, 2)
        assert smoothing._leverage_of(s, 2) == pytest.approx(leverage, rel=1e-6)


def test_data_without_noise_is_left_alone() -> None:
    y = np.full((20, 20), 7.5)
    assert np.allclose(smooth_robust(y).values, 7.5)
    smooth = hill((40, 40))
    assert np.abs(smooth_robust(smooth).values - smooth).max() < 0.05


def test_bad_input_and_cancellation() -> None:
    y = hill((20, 20))
    with pytest.raises(InvalidInputError, match="do not belong"):
        smooth_robust(y, np.ones((3, 3)))
    with pytest.raises(InvalidInputError, match="negative"):
        smooth_robust(y, -np.ones((20, 20)))
    with pytest.raises(InvalidInputError, match="nothing to smooth"):
        smooth_robust(np.full((20, 20), np.nan))
    job = Job()
    job.cancel()
    with pytest.raises(Cancelled):
        smooth_robust(y, job=job)
