"""Robust fusion beside Jacobi-preconditioned conjugate gradients (SciPy) and algebraic multigrid (pyamg).

The 3D fiducial with errors like those of matching and shading: heights wrong alike over windows and, within six
pixels outside walls, of the upper level; normals wrong by 1 to 15 degrees.  The whole fusion is timed at three sizes;
at 1388 x 1038 the linear system of its last round is then solved by each solver from the same start (the
heights) to the RMS distance from the converged solution at which the fusion stops.  The peers are stopped after
``PEER_S`` seconds: their ratio is then a lower bound, and ``fusion_ratio_reached`` (``fusion_pyamg_reached``) is 0.

    python -m bench.bench_fusion
"""

from __future__ import annotations

import contextlib
import importlib
import time
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage, sparse
from scipy.sparse.linalg import LinearOperator, cg

from reliefscope import axes
from reliefscope.jobs import Job
from reliefscope.reconstruction import conjugate_gradients, joint_fusion
from reliefscope.reconstruction.joint_fusion import fuse_robust
from reliefscope.reconstruction.systems import SpringSystem
from reliefscope.targets import Fiducial3D

PIXEL_UM = 1.116
SIZES = ((519, 694), (1038, 1388), (2076, 2776))
PEER_S = 25.0
CHECKED = 20
"""Iterations between two looks at a peer's distance, which are not timed."""

Field = NDArray[np.float64]


class _ReachedError(Exception):
    """A peer has come near enough, or run out of time."""


def measurements(shape: tuple[int, int], seed: int = 1) -> dict[str, Any]:
    """Heights and normals of the fiducial, scaled to fill ``shape``, with errors and their standard errors."""
    rng = np.random.default_rng(seed)
    pixel_um = PIXEL_UM * SIZES[1][1] / shape[1]
    truth = Fiducial3D().height_um(shape, pixel_um).astype(np.float64)
    fat = ndimage.maximum_filter(truth, 11)
    band = fat - ndimage.minimum_filter(truth, 11) > 15.0
    spread = ndimage.gaussian_filter(rng.standard_normal(shape).astype(np.float32), 20)
    sigma = np.where(band, 15.0, 0.5 * np.exp(spread / spread.std()))
    noise = ndimage.gaussian_filter(rng.standard_normal(shape).astype(np.float32), 3)
    height = np.where(band, fat, truth) + np.minimum(sigma, 3.0) * noise / noise.std()
    sigma_rad = np.where(band, 0.25, 0.03)
    exact = axes.normals_from_height(truth, pixel_um).astype(np.float64)
    normals = exact + sigma_rad[..., None] * rng.standard_normal(exact.shape)
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    images = np.maximum(normals @ axes.direction(0.6, 0.5), 0.0) * np.where(band, 0.6, 1.0)
    return {
        "height_um": height.astype(np.float32),
        "height_sigma_um": sigma.astype(np.float32),
        "normals": normals.astype(np.float32),
        "normal_sigma_rad": sigma_rad.astype(np.float32),
        "images": images[None].astype(np.float32),
    }


def run() -> dict[str, float]:
    """Seconds, ratios and distances."""
    figures: dict[str, float] = {}
    small = measurements((96, 128))
    fuse_robust(**small, pixel_um=PIXEL_UM)  # compile
    seconds = []
    for shape in SIZES:
        maps = measurements(shape)
        started = time.perf_counter()
        result = fuse_robust(**maps, pixel_um=PIXEL_UM * SIZES[1][1] / shape[1])
        seconds.append(time.perf_counter() - started)
        figures[f"fusion_{shape[0] * shape[1] / 1e6:.2f}mp_s"] = seconds[-1]
        figures[f"fusion_{shape[0] * shape[1] / 1e6:.2f}mp_iterations"] = float(result.iterations)
    figures["fusion_s"] = seconds[1]
    per_pixel = [
        spent / (rows * columns) for spent, (rows, columns) in zip(seconds, SIZES, strict=True)
    ]
    figures["fusion_flatness"] = per_pixel[-1] / per_pixel[0]
    figures |= compare(SIZES[1])
    return figures


def compare(shape: tuple[int, int]) -> dict[str, float]:
    """The last round's system by our solver and its peers."""
    maps = measurements(shape)
    system, start = joint_fusion.last_system(**maps, pixel_um=PIXEL_UM)
    job = Job()
    surface = fuse_robust(**maps, pixel_um=PIXEL_UM).height_um.astype(np.float64)
    converged = conjugate_gradients.solve(system, surface, 2e-4, 400, job).z
    distance = _rms(surface - converged)
    iterations = CHECKED // 5
    while True:  # what it takes from the same start as the peers
        started = time.perf_counter()
        ours = conjugate_gradients.solve(system.renewed(), start, 0.0, iterations, job)
        ours_s = time.perf_counter() - started
        if _rms(ours.z - converged) <= distance or ours.iterations < iterations:
            break
        iterations += CHECKED // 5
    figures = {
        "fusion_solve_s": ours_s,
        "fusion_solve_iterations": float(ours.iterations),
        "fusion_error_um": distance,
    }
    matrix = written_out(system)
    inverse = 1.0 / matrix.diagonal()
    jacobi = LinearOperator(matrix.shape, matvec=lambda v: inverse * v, dtype=np.float64)
    spent, reached = _peer(matrix, jacobi, system.right, start, converged, distance)
    figures |= {"fusion_ratio": spent / ours_s, "fusion_ratio_reached": float(reached)}
    try:
        pyamg = importlib.import_module("pyamg")
    except ImportError:
        return figures
    started = time.perf_counter()
    hierarchy = pyamg.smoothed_aggregation_solver(matrix.tocsr(), max_coarse=500)
    setup = time.perf_counter() - started
    spent, reached = _peer(
        matrix, hierarchy.aspreconditioner(), system.right, start, converged, distance
    )
    figures |= {
        "fusion_pyamg_ratio": (setup + spent) / ours_s,
        "fusion_pyamg_reached": float(reached),
    }
    return figures


def _peer(
    matrix: sparse.csr_array,
    preconditioner: LinearOperator,
    right: Field,
    start: Field,
    converged: Field,
    distance: float,
) -> tuple[float, bool]:
    """Seconds until SciPy's conjugate gradients came as near as ``distance``, and whether they did."""
    looked_s = 0.0
    count = 0
    reached = False
    started = time.perf_counter()

    def look(z: Field) -> None:
        nonlocal looked_s, count, reached
        count += 1
        if count % CHECKED == 0:
            began = time.perf_counter()
            reached = _rms(z.reshape(converged.shape) - converged) <= distance
            looked_s += time.perf_counter() - began
            if reached or time.perf_counter() - started - looked_s > PEER_S:
                raise _ReachedError

    with contextlib.suppress(_ReachedError):
        cg(
            matrix,
            right.ravel(),
            x0=start.ravel(),
            rtol=0.0,
            maxiter=10**6,
            M=preconditioner,
            callback=look,
        )
    return time.perf_counter() - started - looked_s, reached


def written_out(system: SpringSystem) -> sparse.csr_array:
    """Matrix of a system of springs."""
    height, width = system.right.shape
    hold, across, down = system.weights()
    index = np.arange(height * width).reshape(height, width)
    first = np.concatenate([index[:, :-1].ravel(), index[:-1].ravel()])
    second = np.concatenate([index[:, 1:].ravel(), index[1:].ravel()])
    weight = np.concatenate([across.ravel(), down.ravel()])
    ends = sparse.coo_array((weight, (first, second)), shape=(index.size, index.size))
    links = (ends + ends.T).tocsr()
    diagonal = hold.ravel() + np.asarray(links.sum(axis=1)).ravel()
    matrix: sparse.csr_array = (sparse.diags_array(diagonal) - links).tocsr()
    return matrix


def _rms(difference: Field) -> float:
    return float(np.sqrt(np.mean(difference**2)))


def main() -> None:
    for name, value in run().items():
        print(f"{name:32s} {value:10.4g}")


if __name__ == "__main__":
    main()
