"""Robust fusion and its standard error, on surfaces of known shape with errors of known size."""

import numba
import numpy as np
import pytest
from numpy.typing import NDArray
from scipy import ndimage, sparse
from scipy.sparse.linalg import spsolve

from reliefscope import axes
from reliefscope.errors import Cancelled, InvalidInputError
from reliefscope.jobs import Job
from reliefscope.reconstruction import conjugate_gradients, joint_fusion, uncertainty
from reliefscope.reconstruction.filling import fill_heights
from reliefscope.reconstruction.joint_fusion import fuse_robust
from reliefscope.reconstruction.systems import SpringSystem

PIXEL_UM = 1.12
SHAPE = (96, 128)
WALL_UM = 40.0


def bumps(shape: tuple[int, int], seed: int) -> NDArray[np.float64]:
    """Smooth relief of some 10 um with slopes up to about 0.5."""
    rng = np.random.default_rng(seed)
    field = ndimage.gaussian_filter(rng.standard_normal(shape), 12)
    return np.asarray(6.0 * field / field.std())


def measured(
    truth: NDArray[np.float64], seed: int, *, top: NDArray[np.bool_] | None = None
) -> dict[str, NDArray[np.float32]]:
    """Heights with errors alike over windows, normals with independent errors, and their standard errors.

    Where ``top`` is given, it stands ``WALL_UM`` above the rest, and heights are wrong as matching is: the upper
    level reaches 5 pixels too far, with a large standard error in that band.
    """
    rng = np.random.default_rng(seed)
    shape = truth.shape
    sigma = ndimage.gaussian_filter(rng.uniform(-1.5, 1.5, shape), 15)
    sigma = 0.8 * np.exp(sigma / sigma.std())
    noise = ndimage.gaussian_filter(rng.standard_normal(shape), 2.5)
    height = truth + sigma * noise / noise.std()
    if top is not None:
        fat = ndimage.binary_dilation(top, iterations=5)
        height += np.where(fat, WALL_UM, 0.0)
        band = fat & ~ndimage.binary_erosion(top, iterations=2)
        sigma = np.where(band, 25.0, sigma)
    normals = axes.normals_from_height(truth, PIXEL_UM)
    normals = normals + rng.normal(0, 0.04, normals.shape).astype(np.float32)
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    return {
        "height_um": height.astype(np.float32),
        "height_sigma_um": sigma.astype(np.float32),
        "normals": normals,
        "normal_sigma_rad": np.full(shape, 0.04, np.float32),
    }


def mae(height: NDArray[np.floating], truth: NDArray[np.floating]) -> float:
    error = height - truth
    return float(np.abs(error - np.median(error)).mean())


def test_surface_is_better_than_heights_alone_and_ignores_their_gaps() -> None:
    truth = bumps(SHAPE, 1)
    maps = measured(truth, 2)
    maps["height_um"][30:50, 40:60] = np.nan
    maps["height_sigma_um"][30:50, 40:60] = np.inf
    maps["normals"][5:9, 5:9] = np.nan
    result = fuse_robust(**maps, pixel_um=PIXEL_UM)
    assert np.isfinite(result.height_um).all()
    known = np.isfinite(maps["height_um"])
    assert mae(result.height_um, truth) < 0.5 * mae(maps["height_um"][known], truth[known])
    assert np.abs(result.height_um - truth)[30:50, 40:60].mean() < 2.0


@pytest.mark.parametrize("guided", [True, False])
def test_wall_stays_sharp_and_is_found_at_the_edge_of_the_images(guided: bool) -> None:
    """Heights place the wall 5 pixels too far out; the images show where it is."""
    truth = bumps(SHAPE, 3)
    top = np.zeros(SHAPE, bool)
    top[30:70, 40:90] = True
    maps = measured(truth, 4, top=top)
    images = np.where(top, 0.6, 0.3) * np.ones((4, 1, 1))
    images = images + np.random.default_rng(5).normal(0, 0.005, images.shape)
    truth = truth + np.where(top, WALL_UM, 0.0)
    result = fuse_robust(
        **maps, pixel_um=PIXEL_UM, images=images.astype(np.float32) if guided else None
    )
    error = np.abs(result.height_um - truth)
    assert np.median(error) < 0.6
    assert mae(maps["height_um"], truth) > 3.0
    if guided:
        assert (error > 5.0).mean() < 0.01
        assert mae(result.height_um, truth) < 0.8
    else:
        assert mae(result.height_um, truth) < mae(maps["height_um"], truth)


def test_bias_of_slopes_is_taken_from_heights(monkeypatch: pytest.MonkeyPatch) -> None:
    """Slopes that are 0.15 wrong over the left half do not tilt it."""
    truth = bumps(SHAPE, 6)
    maps = measured(truth, 7)
    sx, sy = axes.gradient_from_normals(maps["normals"])
    sx[:, :64] += 0.15
    normals = np.stack([-sx, -sy, np.ones_like(sx)], axis=-1)
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    maps["normals"] = normals
    corrected = mae(fuse_robust(**maps, pixel_um=PIXEL_UM).height_um, truth)
    assert corrected < 0.5 * mae(maps["height_um"], truth)
    monkeypatch.setattr(joint_fusion, "BIAS_PRIOR", 1e9)
    assert corrected < 0.7 * mae(fuse_robust(**maps, pixel_um=PIXEL_UM).height_um, truth)


@pytest.mark.parametrize("seed", [11, 12, 13])
def test_two_thirds_of_the_errors_are_within_the_standard_error(seed: int) -> None:
    """Uncertain regions included; scenes that no constant was set on."""
    truth = bumps((160, 200), seed)
    maps = measured(truth, seed + 100)
    maps["height_sigma_um"][60:100, 80:140] = 30.0
    maps["height_um"][60:100, 80:140] += 20.0
    maps["normal_sigma_rad"][60:100, 80:140] = np.inf
    result = fuse_robust(**maps, pixel_um=PIXEL_UM)
    error = np.abs(result.height_um - truth - np.median(result.height_um - truth))
    covered = error <= result.sigma_um
    assert 0.55 < covered.mean() < 0.95
    sure = result.sigma_um < np.median(result.sigma_um)
    assert error[sure].mean() < error[~sure].mean()
    assert np.median(result.sigma_um[70:90, 95:125]) > 10.0


def test_sampled_deviation_is_that_of_the_inverse() -> None:
    """Against the diagonal of the inverse of the written-out matrix."""
    rng = np.random.default_rng(8)
    shape = (24, 28)
    hold = 10.0 ** rng.uniform(-3, 0, shape)
    across = 10.0 ** rng.uniform(-1, 1, (24, 27))
    down = 10.0 ** rng.uniform(-1, 1, (23, 28))
    flat = np.zeros(shape)
    system = SpringSystem(hold, flat, across, down, np.zeros_like(across), np.zeros_like(down))
    columns = []
    for index in range(hold.size):
        unit = np.zeros(shape)
        unit.flat[index] = 1.0
        image = np.empty(shape)
        system.apply(unit, image)
        columns.append(image.ravel())
    exact = np.sqrt(np.diag(np.linalg.inv(np.stack(columns)))).reshape(shape)
    sampled = uncertainty.sampled_deviation(system, Job())
    ratio = sampled / exact
    assert np.exp(np.log(ratio).mean()) == pytest.approx(1.0, abs=0.1)
    assert np.log(ratio).std() < 0.35


def test_solver_reaches_the_minimum_that_it_claims() -> None:
    """Against a direct solver, with parts that are held 10^4 times less than others and springs cut."""
    rng = np.random.default_rng(9)
    shape = (60, 70)
    hold = np.where(bumps(shape, 10) > 3, 1e-4, 1.0)
    across = np.where(rng.random((60, 69)) < 0.1, 1e-3, 30.0)
    down = np.where(rng.random((59, 70)) < 0.1, 1e-3, 30.0)
    rises = rng.normal(0, 1, across.shape), rng.normal(0, 1, down.shape)
    target = rng.normal(0, 5, shape)
    system = SpringSystem(hold, target, across, down, *rises)
    index = np.arange(hold.size).reshape(shape)
    first = np.concatenate([index[:, :-1].ravel(), index[:-1].ravel()])
    second = np.concatenate([index[:, 1:].ravel(), index[1:].ravel()])
    weight = np.concatenate([across.ravel(), down.ravel()])
    ends = sparse.coo_array((weight, (first, second)), shape=(hold.size, hold.size))
    links = (ends + ends.T).tocsr()
    matrix = sparse.diags_array(hold.ravel() + links.sum(axis=1)) - links
    exact = spsolve(matrix.tocsc(), system.right.ravel()).reshape(shape)
    solution = conjugate_gradients.solve(system, target, 0.04, 100)
    assert solution.converged
    assert np.sqrt(np.mean((solution.z - exact) ** 2)) < 0.05


def test_result_does_not_depend_on_threads() -> None:
    truth = bumps(SHAPE, 14)
    maps = measured(truth, 15)
    whole = fuse_robust(**maps, pixel_um=PIXEL_UM)
    before = numba.get_num_threads()
    try:
        numba.set_num_threads(1)
        single = fuse_robust(**maps, pixel_um=PIXEL_UM)
    finally:
        numba.set_num_threads(before)
    np.testing.assert_allclose(single.height_um, whole.height_um, atol=1e-4)
    np.testing.assert_allclose(single.sigma_um, whole.sigma_um, rtol=1e-4)


def test_filling_keeps_certain_heights_and_spans_gaps() -> None:
    truth = bumps(SHAPE, 16)
    sigma = np.full(SHAPE, 0.3)
    height = truth.copy()
    height[40:52, 60:72] = np.nan
    height[10:14, 10:14] += 300.0
    sigma[10:14, 10:14] = np.inf
    filled = fill_heights(height, sigma)
    assert filled.shape == SHAPE
    assert np.isfinite(filled).all()
    assert np.abs(filled - truth).mean() < 0.5
    assert np.abs(filled - truth)[38:54, 58:74].max() < 6.0
    with pytest.raises(InvalidInputError, match="nothing to fill"):
        fill_heights(height, np.full(SHAPE, np.inf))


def test_bad_input_is_refused_and_a_job_cancels() -> None:
    maps = measured(bumps((20, 24), 17), 18)
    with pytest.raises(InvalidInputError, match="do not belong together"):
        fuse_robust(**(maps | {"normal_sigma_rad": np.ones((20, 23))}), pixel_um=1.0)
    with pytest.raises(InvalidInputError, match="zero or negative"):
        fuse_robust(**(maps | {"height_sigma_um": np.zeros((20, 24))}), pixel_um=1.0)
    with pytest.raises(InvalidInputError, match="nothing to hang"):
        fuse_robust(**(maps | {"height_sigma_um": np.full((20, 24), np.inf)}), pixel_um=1.0)
    job = Job()
    job.cancel()
    with pytest.raises(Cancelled):
        fuse_robust(**maps, pixel_um=PIXEL_UM, job=job)


def test_small_images_are_fused_without_halving() -> None:
    truth = bumps((40, 44), 19)
    result = fuse_robust(**measured(truth, 20), pixel_um=PIXEL_UM)
    assert min(truth.shape) < 2 * joint_fusion.LEAST_SIDE
    assert mae(result.height_um, truth) < 1.0
