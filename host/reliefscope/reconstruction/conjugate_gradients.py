"""Preconditioned conjugate gradients with a stopping rule in micrometres.

The preconditioner may differ a little from one iteration to the next (flexible form: Notay 2000).

A small residual says little about an ill-conditioned system.  The energy that iterations gain says
more: the energy still missing is the sum of all later gains (Hestenes and Stiefel), here
extrapolated geometrically from the last ones, and divided by the softest mode's energy per um^2 it
bounds the height that is missing.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

import numba
import numpy as np
from numpy.typing import NDArray

from reliefscope.jobs import Job, ensure_job
from reliefscope.reconstruction import fusion_kernels as kernels
from reliefscope.reconstruction.systems import System

_WINDOW = 4
"""Iterations over which the rate of convergence is judged."""
_SHARED = 200_000
"""Pixels from which the work is worth several threads: each iteration is some dozens of short loops, and on a busy
machine the threads wait for each other after every one."""


@dataclass(frozen=True, slots=True)
class Solution:
    """Surface ``z`` (H, W) um, iterations used, estimated RMS error in um and whether that is in tolerance."""

    z: NDArray[np.float64]
    iterations: int
    error_um: float
    converged: bool


def solve(
    system: System,
    start_um: NDArray[np.float64],
    tolerance_um: float,
    maximum_iterations: int,
    job: Job | None = None,
) -> Solution:
    """Surface at which the energy of ``system`` is least, starting from ``start_um`` (H, W).

    Stops when the estimated RMS error is at most ``tolerance_um`` or after ``maximum_iterations``.
    """
    with _threads(start_um.size):
        return _solve(system, start_um, tolerance_um, maximum_iterations, ensure_job(job))


@contextmanager
def _threads(pixels: int) -> Iterator[None]:
    """One thread for small images, those allowed for large ones."""
    allowed = numba.get_num_threads()
    if pixels < _SHARED:
        numba.set_num_threads(1)
    try:
        yield
    finally:
        numba.set_num_threads(allowed)


def _solve(
    system: System,
    start_um: NDArray[np.float64],
    tolerance_um: float,
    maximum_iterations: int,
    job: Job,
) -> Solution:
    multigrid = system.preconditioner()
    z = np.array(start_um, dtype=np.float64)
    applied = np.empty_like(z)
    system.apply(z, applied)
    residual = system.right - applied
    correction = np.empty_like(z)
    multigrid.cycle(residual, correction)
    search = correction.copy()
    product = kernels.dot(residual, correction)
    gains: list[float] = []
    error_um = math.inf
    for iteration in range(1, maximum_iterations + 1):
        job.check()
        system.apply(search, applied)
        curvature = kernels.dot(search, applied)
        if product <= 0.0 or curvature <= 0.0:
            return Solution(z, iteration - 1, 0.0 if product == 0.0 else error_um, True)
        alpha = product / curvature
        kernels.step(z, residual, search, applied, alpha)
        gains.append(alpha * product)
        error_um = math.sqrt(_missing(gains) / (z.size * system.softness))
        if error_um <= tolerance_um:
            return Solution(z, iteration, error_um, True)
        multigrid.cycle(residual, correction)
        # the share of the old direction that is conjugate to a correction, linear or not (flexible form)
        kernels.turn(search, correction, -alpha * kernels.dot(applied, correction) / product)
        product = kernels.dot(residual, correction)
    return Solution(z, maximum_iterations, error_um, False)


def _missing(gains: list[float]) -> float:
    """Energy still to be gained if gains go on to fall as over the last iterations."""
    if len(gains) <= _WINDOW:
        return gains[0] if gains[-1] > 0.0 and gains[0] > 1e-30 else 0.0
    rate = (gains[-1] / gains[-1 - _WINDOW]) ** (1.0 / _WINDOW)
    return gains[-1] * rate / (1.0 - rate) if rate < 1.0 else math.inf
