"""Heights without gaps, fast: for registration and shadows, which need a height everywhere before there are normals.

A membrane is held by the heights, each by its standard error:

    sum (z - h)^2 / sigma^2 + sum over neighbours of (dz / STEP_UM)^2

so that certain heights stay, uncertain ones give way to their neighbours, and gaps are spanned.  It is solved on the
half-size grid, on which stereo matches, and by the multigrid of the fusion.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from reliefscope.errors import InvalidInputError
from reliefscope.jobs import Job, ensure_job
from reliefscope.reconstruction import conjugate_gradients
from reliefscope.reconstruction.halving import doubled
from reliefscope.reconstruction.systems import SpringSystem
from reliefscope.units import FloatImage

STEP_UM = 10.0
"""Standard deviation of the difference between neighbours on the half-size grid."""
LEAST_SIGMA_UM = 0.05
ITERATIONS = 10
LEAST_SIDE = 32
"""Images with a shorter side are filled as they are."""


def fill_heights(
    height_um: NDArray[np.floating[Any]],
    sigma_um: NDArray[np.floating[Any]],
    *,
    job: Job | None = None,
) -> FloatImage:
    """Heights (H, W) without gaps from heights and their standard errors, um.

    Parameters
    ----------
    height_um:
        (H, W); NaN where missing.
    sigma_um:
        (H, W) standard errors; infinite where missing or discarded.
    job:
        Cancellation.

    Raises
    ------
    InvalidInputError
        No height with a finite standard error.
    """
    known = np.isfinite(height_um) & np.isfinite(sigma_um)
    if not known.any():
        raise InvalidInputError(
            "No height has a finite standard error; there is nothing to fill gaps from.",
            hint="Check focus, exposure and the range of heights; look at a frame.",
        )
    middle = np.float32(np.median(height_um[known]))
    part = np.s_[::2, ::2] if min(height_um.shape) >= 2 * LEAST_SIDE else np.s_[:, :]
    target = np.where(known, height_um, middle)[part]
    sigma = np.where(known, np.maximum(sigma_um, LEAST_SIGMA_UM), np.inf)[part]
    springs = np.full(target.shape, STEP_UM**-2)
    system = SpringSystem(
        sigma**-2.0,
        target,
        springs[:, 1:],
        springs[1:],
        np.zeros_like(springs[:, 1:]),
        np.zeros_like(springs[1:]),
    )
    start = target.astype(np.float64)
    filled = conjugate_gradients.solve(system, start, LEAST_SIGMA_UM, ITERATIONS, ensure_job(job)).z
    if filled.shape == height_um.shape:
        return filled.astype(np.float32)
    return doubled(filled, height_um.shape)
