"""Multigrid over clusters of pixels: against direct solution, and on bands that no grid of every second pixel sees."""

from __future__ import annotations

import numba
import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.linalg import spsolve

from reliefscope.reconstruction import conjugate_gradients
from reliefscope.reconstruction.multigrid import Multigrid
from reliefscope.reconstruction.systems import SpringSystem

Field = NDArray[np.float64]


def bands(shape: tuple[int, int], seed: int = 1) -> tuple[Field, Field, Field]:
    """Weights of a network with curved bands, one and two pixels wide, between cut springs; a quarter is held."""
    rng = np.random.default_rng(seed)
    rows, columns = np.indices(shape)
    island = np.floor(np.hypot(rows - 20.0, columns + 13.0) * 0.7).astype(int)
    across = np.where(island[:, 1:] == island[:, :-1], 900.0, 1e-3)
    down = np.where(island[1:] == island[:-1], 900.0, 1e-3)
    hold = np.where(rng.random(shape) < 0.25, rng.uniform(0.002, 2.0, shape), 1e-8)
    return hold, across, down


def system(hold: Field, across: Field, down: Field, seed: int = 2) -> SpringSystem:
    rng = np.random.default_rng(seed)
    rises = (rng.normal(size=springs.shape) for springs in (across, down))
    return SpringSystem(hold, 30.0 * rng.normal(size=hold.shape), across, down, *rises)


def solved_directly(problem: SpringSystem) -> Field:
    hold, across, down = problem.weights()
    index = np.arange(hold.size).reshape(hold.shape)
    first = np.concatenate([index[:, :-1].ravel(), index[:-1].ravel()])
    second = np.concatenate([index[:, 1:].ravel(), index[1:].ravel()])
    springs = np.concatenate([across.ravel(), down.ravel()])
    ends = sparse.coo_array((springs, (first, second)), shape=(hold.size, hold.size))
    links = (ends + ends.T).tocsr()
    matrix = sparse.diags_array(hold.ravel() + np.asarray(links.sum(axis=1)).ravel()) - links
    solution: Field = spsolve(matrix.tocsc(), problem.right.ravel()).reshape(hold.shape)
    return solution


def test_bands_between_cuts_converge_in_a_few_iterations() -> None:
    problem = system(*bands((97, 130)))
    exact = solved_directly(problem)
    start = np.zeros_like(exact)
    distance = [
        float(np.sqrt(np.mean((conjugate_gradients.solve(problem, start, 0.0, n).z - exact) ** 2)))
        for n in (4, 12)
    ]
    spread = float(np.sqrt(np.mean(exact**2)))
    assert distance[0] < 0.05 * spread
    assert distance[1] < 1e-4 * spread


def test_iterations_hardly_grow_with_the_image() -> None:
    """Bands become longer as well: the network, not only the image, becomes harder."""
    counts = []
    for size in (80, 320):
        solution = conjugate_gradients.solve(
            system(*bands((size, size))), np.zeros((size, size)), 1e-3, 60
        )
        assert solution.converged
        counts.append(solution.iterations)
    assert counts[1] <= counts[0] + 4


def test_cycle_is_positive_and_leaves_loose_pixels_alone() -> None:
    rng = np.random.default_rng(4)
    shape = (81, 66)
    hold = rng.uniform(0, 1e-3, shape)
    across = rng.uniform(0, 1, (81, 65)) * (rng.random((81, 65)) > 0.3)
    down = rng.uniform(0, 1, (80, 66)) * (rng.random((80, 66)) > 0.3)
    hold[40, 30] = across[40, 29] = across[40, 30] = down[39, 30] = down[40, 30] = 0.0
    multigrid = Multigrid(hold, across, down)
    assert multigrid.depth >= 2
    residual, out = rng.normal(size=shape), np.empty(shape)
    multigrid.cycle(residual, out)
    assert np.vdot(residual, out) > 0
    assert out[40, 30] == 0.0


def test_pixels_that_are_held_firmly_need_no_coarser_level() -> None:
    shape = (70, 60)
    problem = system(np.full(shape, 4.0), np.ones((70, 59)), np.ones((69, 60)))
    solution = conjugate_gradients.solve(problem, np.zeros(shape), 1e-5, 60)
    np.testing.assert_allclose(solution.z, solved_directly(problem), atol=1e-3)


def test_nothing_depends_on_the_number_of_threads() -> None:
    """The image has more pixels than a chunk of nodes."""
    problem = system(*bands((300, 310)))
    start = np.zeros((300, 310))
    several = conjugate_gradients.solve(problem, start, 0.0, 3).z
    allowed = numba.get_num_threads()
    try:
        numba.set_num_threads(1)
        one = conjugate_gradients.solve(problem.renewed(), start, 0.0, 3).z
    finally:
        numba.set_num_threads(allowed)
    np.testing.assert_array_equal(several, one)
