"""Robust fusion beside Jacobi-preconditioned conjugate gradients (SciPy) and algebraic multigrid (pyamg).

The maps are those that the default method hands to the fusion: of the dull fiducial before the simulated instrument,
1388 x 1038, 12 apertures, 16 lights.  The whole fusion is timed on them, on their middle quarter and on four of them,
mirrored into each other; the linear system of its last round is then solved by each solver from the same start (the
heights) to the RMS distance from the converged solution at which the fusion stops.  The peers are stopped after
``PEER_S`` seconds: their ratio is then a lower bound, and ``fusion_ratio_reached`` (``fusion_pyamg_reached``) is 0.

    python -m bench.bench_fusion
"""

from __future__ import annotations

import contextlib
import importlib
import tempfile
import time
from pathlib import Path
from typing import Any
from unittest import mock

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.linalg import LinearOperator, cg

from reliefscope.jobs import Job
from reliefscope.microscope import Microscope
from reliefscope.reconstruction import conjugate_gradients, joint_fusion
from reliefscope.reconstruction.joint_fusion import fuse_robust
from reliefscope.reconstruction.systems import SpringSystem

INSTRUMENT = "sim://benchtop?scene=fiducial&finish=dull&seed=1"
PEER_S = 25.0
CHECKED = 20
"""Iterations between two looks at a peer's distance, which are not timed."""

Field = NDArray[np.float64]
Maps = dict[str, Any]


class _ReachedError(Exception):
    """A peer has come near enough, or run out of time."""


def measured_maps() -> tuple[Maps, float]:
    """Heights, normals, their standard errors and the images of a simulated run, and the size of a pixel in um."""
    with (
        tempfile.TemporaryDirectory(prefix="bench-fusion-") as folder,
        mock.patch.object(joint_fusion, "fuse_robust", wraps=fuse_robust) as fusing,
    ):
        with Microscope.open(INSTRUMENT) as microscope:
            run = microscope.acquire(microscope.default_plan(), Path(folder) / "run")
        run.reconstruct(pictures=False)
        names = ("height_um", "height_sigma_um", "normals", "normal_sigma_rad")
        *maps, pixel_um = fusing.call_args.args
        return dict(zip(names, maps, strict=True)) | {
            "images": fusing.call_args.kwargs["images"]
        }, pixel_um


def middle(maps: Maps) -> Maps:
    """Half of the rows and columns."""
    rows, columns = maps["height_um"].shape
    part = (
        slice(rows // 4, rows // 4 + rows // 2),
        slice(columns // 4, columns // 4 + columns // 2),
    )
    cut = {
        name: np.ascontiguousarray(values[part])
        for name, values in maps.items()
        if name != "images"
    }
    return cut | {"images": np.ascontiguousarray(maps["images"][:, *part])}


def four(maps: Maps) -> Maps:
    """Twice the rows and columns: the maps and their mirror images."""
    large = {
        name: np.pad(
            values,
            [(0, size) for size in values.shape[:2]] + [(0, 0)] * (values.ndim - 2),
            "symmetric",
        )
        for name, values in maps.items()
        if name != "images"
    }
    rows, columns = maps["height_um"].shape
    large["normals"][:, columns:, 0] *= -1
    large["normals"][rows:, :, 1] *= -1
    return large | {
        "images": np.pad(maps["images"], ((0, 0), (0, rows), (0, columns)), "symmetric")
    }


def run() -> dict[str, float]:
    """Seconds, ratios and distances."""
    figures: dict[str, float] = {}
    maps, pixel_um = measured_maps()
    seconds = []
    for sized in (middle(maps), maps, four(maps)):
        started = time.perf_counter()
        result = fuse_robust(**sized, pixel_um=pixel_um)
        seconds.append((time.perf_counter() - started, sized["height_um"].size))
        size = f"{sized['height_um'].size / 1e6:.2f}mp"
        figures[f"fusion_{size}_s"] = seconds[-1][0]
        figures[f"fusion_{size}_iterations"] = float(result.iterations)
    figures["fusion_s"] = seconds[1][0]
    (small_s, small), _, (large_s, large) = seconds
    figures["fusion_flatness"] = (large_s / large) / (small_s / small)
    return figures | compare(maps, pixel_um)


def compare(maps: Maps, pixel_um: float) -> dict[str, float]:
    """The last round's system by our solver and its peers."""
    system, start = joint_fusion.last_system(**maps, pixel_um=pixel_um)
    surface = fuse_robust(**maps, pixel_um=pixel_um).height_um.astype(np.float64)
    job = Job()
    converged = conjugate_gradients.solve(system, surface, 1e-5, 400, job).z
    distance = _rms(surface - converged)
    iterations = 1
    while True:  # what it takes from the same start as the peers
        started = time.perf_counter()
        ours = conjugate_gradients.solve(system.renewed(), start, 0.0, iterations, job)
        ours_s = time.perf_counter() - started
        if _rms(ours.z - converged) <= distance or ours.iterations < iterations:
            break
        iterations += 1
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
