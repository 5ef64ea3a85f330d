"""Fusion of heights and normals into one surface (eq. 11-13).

The surface minimises, over all pixels,

    lambda^2 q_mvs^2 (z - z_mvs)^2 + q_ps^2 (Tx z - sx)^2 + q_ps^2 (Ty z - sy)^2

with the slopes s = -n_x / n_z, -n_y / n_z of photometric stereo.  T takes slopes in um per um: the
Sobel operators of eq. 9 give the height per pixel, so they are divided by ``pixel_um``.  The forms
of T are described in :mod:`reliefscope.reconstruction.systems`.
"""

from __future__ import annotations

import logging
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from reliefscope import axes
from reliefscope.errors import InvalidInputError
from reliefscope.jobs import Job, ensure_job
from reliefscope.reconstruction import conjugate_gradients
from reliefscope.reconstruction.systems import SobelSystem, System, forward_system
from reliefscope.units import FloatImage

LAMBDA_RAD_PER_UM = 0.05
"""Height deviation that counts like a slope deviation, paper section III.C."""
STABILISER = 0.1
"""Weight of the single differences beside their Sobel mean in the default form; see ``systems``."""
MINIMUM_QUALITY = 0.01
"""Weight that an inpainted height keeps, so that a surface is defined where both methods are blind."""
TOLERANCE_PX = 0.01
"""Estimated RMS distance to the exact minimum at which the solver stops, in sizes of a pixel.

Slopes have no unit, so the heights that they add up to grow with the pixel, and so must the distance: the work
is the same for a micrograph and for a photograph of a statue.  The estimate holds for the softest mode and is
cautious.
"""
MAXIMUM_ITERATIONS = 400

Derivative = Literal["sobel_stabilised", "sobel", "forward"]

_LOG = logging.getLogger(__name__)


@dataclass(frozen=True, slots=True)
class FusionResult:
    """The surface and how it was found.

    Attributes
    ----------
    height_um:
        (H, W) float32; NaN where neither a height nor a slope holds a pixel.
    iterations:
        Iterations of the solver.
    error_um:
        Estimated RMS distance to the exact minimum, um.
    converged:
        Whether ``error_um`` came within the tolerance.
    """

    height_um: FloatImage
    iterations: int
    error_um: float
    converged: bool


def fuse(
    height_um: NDArray[np.floating[Any]],
    q_mvs: NDArray[np.floating[Any]],
    normals: NDArray[np.floating[Any]],
    q_ps: NDArray[np.floating[Any]],
    pixel_um: float,
    *,
    lam: float = LAMBDA_RAD_PER_UM,
    derivative: Derivative = "sobel_stabilised",
    minimum_quality: float = MINIMUM_QUALITY,
    tolerance_um: float | None = None,
    maximum_iterations: int = MAXIMUM_ITERATIONS,
    job: Job | None = None,
) -> FusionResult:
    """Surface that agrees best with heights and normals, each by its quality.

    Parameters
    ----------
    height_um:
        (H, W) heights of multi-view stereo, um; NaN where missing.
    q_mvs:
        (H, W) quality of the heights; 0 where discarded.
    normals:
        (H, W, 3) unit normals, y up; NaN where missing.
    q_ps:
        (H, W) quality of the normals; 0 where discarded.
    pixel_um:
        Size of a pixel on the sample.
    lam:
        Equivalence of height and slope deviations, rad / um.
    derivative:
        ``sobel_stabilised``: the Sobel operators of eq. 9 without their null space (default).
        ``sobel``: eq. 13 to the letter.  ``forward``: differences of two neighbours.
    minimum_quality:
        Weight that every finite height keeps; 0 for the equations to the letter.
    tolerance_um:
        Estimated RMS distance to the exact minimum at which the solver stops, um; ``TOLERANCE_PX`` of a
        pixel if left out.
    maximum_iterations:
        When the solver stops in any case.
    job:
        Progress and cancellation, checked per iteration.

    Raises
    ------
    InvalidInputError
        Shapes that do not belong together, negative or infinite qualities, or no equation at all.
    """
    if height_um.shape != q_mvs.shape:
        raise _mismatch("height", height_um.shape, "its quality", q_mvs.shape)
    known = np.isfinite(height_um)
    weight = np.where(known, np.maximum(_checked(q_mvs), minimum_quality), 0.0)
    hold = (lam * weight) ** 2
    target = np.where(known, height_um, _middle(height_um, known)).astype(np.float64)
    return _solve(
        hold, target, normals, q_ps, pixel_um, derivative, tolerance_um, maximum_iterations, job
    )


def _solve(
    hold: NDArray[np.float64],
    target_um: NDArray[np.float64],
    normals: NDArray[np.floating[Any]],
    quality: NDArray[np.floating[Any]],
    pixel_um: float,
    derivative: Derivative,
    tolerance_um: float | None,
    maximum_iterations: int,
    job: Job | None,
) -> FusionResult:
    system = build_system(hold, target_um, normals, quality, pixel_um, derivative)
    touched = system.touched()
    if not touched.any():
        raise InvalidInputError(
            "Neither a height nor a normal has any quality; there is nothing to make a surface from.",
            hint="Look at the quality maps: exposure, focus and the height range are likely causes.",
        )
    tolerance = TOLERANCE_PX * pixel_um if tolerance_um is None else tolerance_um
    with ensure_job(job).stage("fuse", 1):
        solution = conjugate_gradients.solve(system, target_um, tolerance, maximum_iterations, job)
    if not solution.converged:
        _LOG.warning(
            "The fusion solver stopped after %d iterations, about %.3g um from the minimum.",
            solution.iterations,
            solution.error_um,
        )
    height = np.where(touched, solution.z, np.nan).astype(np.float32)
    return FusionResult(height, solution.iterations, solution.error_um, solution.converged)


def build_system(
    hold: NDArray[np.float64],
    target_um: NDArray[np.float64],
    normals: NDArray[np.floating[Any]],
    quality: NDArray[np.floating[Any]],
    pixel_um: float,
    derivative: Derivative,
) -> System:
    """Normal equations of eq. 12 in one of the forms of :func:`fuse`."""
    if normals.shape != (*hold.shape, 3) or quality.shape != hold.shape:
        raise _mismatch("height", hold.shape, "normals", normals.shape)
    if min(hold.shape) < 3:
        raise InvalidInputError(
            f"An image of {hold.shape[0]} x {hold.shape[1]} pixels is too small to take slopes from.",
            hint="At least 3 x 3 pixels are needed.",
        )
    usable = np.isfinite(normals).all(axis=-1) & (normals[..., 2] > 0.0)
    weight = np.where(usable, _checked(quality), 0.0)
    upright = np.where(usable[..., None], normals, np.array([0.0, 0.0, 1.0]))
    slope_x, slope_y = axes.gradient_from_normals(upright)
    if derivative == "forward":
        return forward_system(hold, target_um, slope_x, slope_y, weight, pixel_um)
    stabiliser = STABILISER if derivative == "sobel_stabilised" else 0.0
    return SobelSystem(hold, target_um, slope_x, slope_y, weight, pixel_um, stabiliser)


def integrate(
    normals: NDArray[np.floating[Any]],
    weights: NDArray[np.floating[Any]],
    pixel_um: float,
    *,
    derivative: Derivative = "sobel_stabilised",
    tolerance_um: float | None = None,
    maximum_iterations: int = MAXIMUM_ITERATIONS,
    job: Job | None = None,
) -> FusionResult:
    """Surface (H, W) um that follows the normals alone; its mean over the held pixels is zero.

    ``normals`` (H, W, 3), ``weights`` (H, W), the tolerance and the greatest number of iterations as
    ``normals``, ``q_ps`` and those of :func:`fuse`.  Parts that no normal joins have each an offset of
    their own, which nothing can tell.
    """
    flat = np.zeros(weights.shape)
    result = _solve(
        flat,
        flat,
        normals,
        weights,
        pixel_um,
        derivative,
        tolerance_um,
        maximum_iterations,
        job,
    )
    height = result.height_um - np.nanmean(result.height_um)
    return FusionResult(height, result.iterations, result.error_um, result.converged)


def _checked(quality: NDArray[np.floating[Any]]) -> NDArray[np.float64]:
    values = np.asarray(quality, dtype=np.float64)
    if not np.isfinite(values).all() or values.min(initial=0.0) < 0.0:
        raise InvalidInputError(
            "A quality map holds negative or undefined values.",
            hint="Quality is 0 where a measurement is missing, and positive elsewhere.",
        )
    return values


def _middle(height_um: NDArray[np.floating[Any]], known: NDArray[np.bool_]) -> float:
    return float(np.median(height_um[known])) if known.any() else 0.0


def _mismatch(
    first: str, first_shape: tuple[int, ...], second: str, second_shape: tuple[int, ...]
) -> InvalidInputError:
    return InvalidInputError(
        f"A {first} map of shape {first_shape} does not belong to {second} of shape {second_shape}.",
        hint="All maps of one reconstruction have the same rows and columns.",
    )
