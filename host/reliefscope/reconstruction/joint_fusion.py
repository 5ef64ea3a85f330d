"""Robust fusion of heights and normals: the method `joint`.

The surface z maximises the likelihood of what stereo and photometric stereo measured,

    sum over pixels of (z - h)^2 / (c sigma_h)^2 + sum over neighbours of rho((dz - s) / sigma_s) e,

with the standard errors of both instead of a lambda.  What differs from the paper's fusion
(:mod:`~reliefscope.reconstruction.fusion`):

- **Steps.** A wall has no slope in the view from above.  Two neighbours are joined by a spring for which the slope
  at either end votes, and a vote loses weight as the surface departs from it (Student's distribution): a spring
  across a wall is cut.  The first surface is that of least squares; the scale of the distribution then falls from
  round to round (graduated non-convexity), so that cuts end up where they cost least.
- **Edges of the images.** Matching finds walls only to within its window.  Springs are weaker where the images
  change (e, :func:`~reliefscope.reconstruction.joint_fusion_kernels.edge_factors`): a step that must be somewhere in
  a band of uncertain heights is cut at an edge.
- **Bias of the slopes.** Photometric stereo is precise over short distances, but highlights, interreflection and
  shadows bias it over long ones.  The bias is estimated where stereo is certain, as the smooth part of the
  difference of the slopes (Nehab et al. 2005), taken off, and added to the slopes' standard error.
- **Correlated errors.** Errors of stereo are alike over a matching window: its heights count as c^2 times fewer.

The rounds with large scales are done on a grid of half the size.  Each round is a linear system for the multigrid
solver of :mod:`~reliefscope.reconstruction.conjugate_gradients`.

Sources: D. Nehab, S. Rusinkiewicz, J. Davis, R. Ramamoorthi, "Efficiently combining positions and normals for
precise 3D geometry", SIGGRAPH 2005; X. Cao, H. Santo, B. Shi, F. Okura, Y. Matsushita, "Bilateral normal
integration", ECCV 2022; A. Blake, A. Zisserman, "Visual reconstruction", 1987.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from reliefscope.errors import InvalidInputError
from reliefscope.jobs import Job, ensure_job
from reliefscope.reconstruction import conjugate_gradients, uncertainty
from reliefscope.reconstruction import joint_fusion_kernels as kernels
from reliefscope.reconstruction.halving import averaged, doubled
from reliefscope.reconstruction.systems import SpringSystem
from reliefscope.units import FloatImage

Real = NDArray[np.floating[Any]]

CORRELATION = 1.5
"""c: heights count as c^2 times fewer than there are pixels of the half-size grid."""
FREEDOM = 2.0
"""Degrees of freedom of the distribution of slope errors."""
COARSE_SCALES = (math.inf, 4.0, 2.0, 1.0)
"""Scale of that distribution in sigma per round on the half-size grid; infinite: least squares."""
FINE_SCALES = (2.0, 1.0)
"""The same on the full grid."""
EDGE_STRENGTH = 500.0
"""Factor of the squared contrast that weakens a spring: half at a change of 4.5 %."""
DARK_SHARE = 0.1
"""Intensity added before contrasts are taken, as a share of the median intensity."""
BIAS_LENGTH_PX = 16.0
"""Standard deviation, in full-size pixels, of the window over which the bias of slopes is averaged."""
BIAS_SCALE = 1.0
"""Difference of slopes at which a pixel's vote on the bias has a quarter of its weight."""
BIAS_PRIOR = 0.02
"""Share of certain heights in that window at which half of the bias is believed."""
LEAST_NZ = 0.1
"""Bound of n_z: steeper slopes (84 degrees) are not measured."""
LEAST_SIGMA_UM = 0.05
LEAST_SIGMA_RAD, GREATEST_SIGMA_RAD = 0.02, 0.6
"""Bounds of the standard errors: what calibration of lights and pixels leaves; what any shading still tells."""
WEAKEST_HOLD = 1e-8
"""Weight per um^2 that ties a pixel without a height to the median height."""
TOLERANCE_UM = 0.006
"""Estimated RMS distance to the exact minimum at which the last linear system is solved; the true one is up to five
times larger (bench_fusion)."""
ROUND_ITERATIONS = 3
"""Iterations of the solver in a round that another follows: its weights are provisional anyway."""
MAXIMUM_ITERATIONS = 40
"""Iterations of the last round at most; five to ten are usual."""
LEAST_SIDE = 32
"""Images with a shorter side are not halved."""


@dataclass(frozen=True, slots=True)
class JointSurface:
    """The surface, its standard error and how it was found.

    Attributes
    ----------
    height_um:
        (H, W) float32, no gaps.
    sigma_um:
        (H, W) float32: about 68 % of the errors are smaller
        (:mod:`~reliefscope.reconstruction.uncertainty`).
    iterations:
        Iterations of the solver on the full grid, all rounds together.
    error_um:
        Estimated RMS distance to the exact minimum of the last round, um.
    """

    height_um: FloatImage
    sigma_um: FloatImage
    iterations: int
    error_um: float


@dataclass(slots=True)
class _Grid:
    """Measurements on one grid, as the springs need them."""

    height_um: FloatImage
    sigma_um: FloatImage
    normals: FloatImage
    sigma_rad: FloatImage
    images: FloatImage | None
    pixel_um: float


@dataclass(slots=True)
class _Bias:
    """Bias of the slopes (H, W) across and down, dimensionless."""

    across: FloatImage
    down: FloatImage


def fuse_robust(
    height_um: Real,
    height_sigma_um: Real,
    normals: Real,
    normal_sigma_rad: Real,
    pixel_um: float,
    *,
    images: FloatImage | None = None,
    job: Job | None = None,
) -> JointSurface:
    """Surface of greatest likelihood from heights and normals with their standard errors.

    Parameters
    ----------
    height_um:
        (H, W) heights of stereo, um; NaN where missing.
    height_sigma_um:
        (H, W) their standard errors; infinite where missing or discarded.
    normals:
        (H, W, 3) unit normals, y up; NaN where missing.
    normal_sigma_rad:
        (H, W) their standard errors; infinite where missing or discarded.
    pixel_um:
        Size of a pixel on the sample.
    images:
        (L, H, W) linear images in the view s = 0, one per light; their edges attract steps.  None: no edges known.
    job:
        Progress (stage ``fuse``, per round) and cancellation.

    Raises
    ------
    InvalidInputError
        Shapes that do not belong together, standard errors that are not positive, or no height at all.
    """
    grid = _checked(height_um, height_sigma_um, normals, normal_sigma_rad, images, pixel_um)
    springs, deviation, iterations = _rounds(grid, ensure_job(job))
    stated = uncertainty.stated_error(deviation.sigma_um, deviation.pixel_um)
    sigma = np.asarray(cv2.resize(stated, springs.z.shape[::-1]), np.float32)
    return JointSurface(springs.z.astype(np.float32), sigma, iterations, springs.error_um)


def last_system(
    height_um: Real,
    height_sigma_um: Real,
    normals: Real,
    normal_sigma_rad: Real,
    pixel_um: float,
    *,
    images: FloatImage | None = None,
) -> tuple[SpringSystem, NDArray[np.float64]]:
    """Linear system of the last round of :func:`fuse_robust`, and its heights (H, W): to compare solvers with."""
    grid = _checked(height_um, height_sigma_um, normals, normal_sigma_rad, images, pixel_um)
    springs, _, _ = _rounds(grid, Job())
    return springs.system, springs.target.astype(np.float64)


@dataclass(frozen=True, slots=True)
class _Deviation:
    """Sampled deviation (H', W') of the half-size grid, and the size of its pixels."""

    sigma_um: FloatImage
    pixel_um: float


def _rounds(fine: _Grid, job: Job) -> tuple[_Springs, _Deviation, int]:
    """All rounds; iterations are those on the full grid."""
    halve = min(fine.height_um.shape) >= 2 * LEAST_SIDE
    coarse = _halved(fine) if halve else fine
    iterations = 0
    with job.stage("fuse", len(COARSE_SCALES) + halve * len(FINE_SCALES)) as stage:
        springs = _Springs(coarse)
        for scale in COARSE_SCALES:
            springs.solve(scale, job, last=not halve and scale == COARSE_SCALES[-1])
            iterations += 0 if halve else springs.iterations
            stage.advance()
        deviation = uncertainty.sampled_deviation(springs.system, job)
        if halve:
            springs = _Springs(fine, springs.bias, springs.z)
            for scale in FINE_SCALES:
                springs.solve(scale, job, last=scale == FINE_SCALES[-1])
                iterations += springs.iterations
                stage.advance()
    return springs, _Deviation(deviation, coarse.pixel_um), iterations


class _Springs:
    """The robust problem on one grid: measurements, surface ``z`` (H, W) and how well it was solved."""

    def __init__(
        self, grid: _Grid, bias: _Bias | None = None, start_um: Real | None = None
    ) -> None:
        shape = grid.height_um.shape
        known = np.isfinite(grid.height_um) & np.isfinite(grid.sigma_um)
        middle = np.float32(np.median(grid.height_um[known]))
        self.target = np.where(known, grid.height_um, middle)
        self._rises = np.empty((2, *shape), np.float32)
        self._weights = np.empty((2, *shape), np.float32)
        kernels.slope_equations(
            grid.normals, grid.sigma_rad, grid.pixel_um, LEAST_NZ, self._rises, self._weights
        )
        if bias is None:
            bias = _bias(grid, known, self._rises)
        self.bias = bias = _resized(bias, shape)
        excess = np.hypot(bias.across, bias.down)
        kernels.slope_equations(
            grid.normals,
            np.hypot(grid.sigma_rad, excess),
            grid.pixel_um,
            LEAST_NZ,
            self._rises,
            self._weights,
        )
        pixel = np.float32(grid.pixel_um)
        self._bias_um = (
            0.5 * pixel * (bias.across[:, 1:] + bias.across[:, :-1]),
            0.5 * pixel * (bias.down[1:] + bias.down[:-1]),
        )
        self._factors = _edges(grid.images, shape)
        sigma = CORRELATION * np.maximum(grid.sigma_um, np.float32(LEAST_SIGMA_UM))
        self._hold = np.where(known, np.maximum(sigma**-2, WEAKEST_HOLD), WEAKEST_HOLD)
        self.z = (self.target if start_um is None else doubled(start_um, shape)).astype(np.float64)
        self._solved: SpringSystem | None = None
        self.iterations = 0
        self.error_um = math.inf

    @property
    def system(self) -> SpringSystem:
        """Linear system of the last round."""
        assert self._solved is not None  # there was a round
        return self._solved

    def solve(self, scale: float, job: Job, *, last: bool) -> None:
        """Reweight the springs at the present surface and solve for the next one."""
        springs, wanted = [], []
        z = self.z.astype(np.float32)
        for axis in (0, 1):
            spring = np.empty(self._factors[axis].shape, np.float32)
            rise = np.empty_like(spring)
            kernels.reweight(
                z,
                self._rises[axis],
                self._weights[axis],
                self._bias_um[axis],
                self._factors[axis],
                axis,
                scale,
                FREEDOM,
                spring,
                rise,
            )
            springs.append(spring)
            wanted.append(rise)
        self._solved = SpringSystem(self._hold, self.target, *springs, *wanted)
        solution = conjugate_gradients.solve(
            self._solved,
            self.z,
            TOLERANCE_UM,
            MAXIMUM_ITERATIONS if last else ROUND_ITERATIONS,
            job,
        )
        self.z, self.iterations = solution.z, solution.iterations
        self.error_um = solution.error_um


def _bias(grid: _Grid, known: NDArray[np.bool_], rises: FloatImage) -> _Bias:
    """Smooth part of the difference between the slopes of stereo and those of photometric stereo."""
    height = np.where(known, grid.height_um, np.float32(np.nan))
    trust = np.where(known, 1.0 / (1.0 + grid.sigma_um**2), 0.0).astype(np.float32)
    parts = []
    length = BIAS_LENGTH_PX / 2
    for axis in (0, 1):
        along = 1 - axis
        first = [slice(None)] * 2
        second = [slice(None)] * 2
        first[along], second[along] = slice(None, -1), slice(1, None)
        a, b = tuple(first), tuple(second)
        excess = height[b] - height[a] - 0.5 * (rises[axis][a] + rises[axis][b])
        excess /= np.float32(grid.pixel_um)
        weight = np.minimum(trust[a], trust[b]) / (1 + (excess / BIAS_SCALE) ** 2) ** 2
        missing = ~np.isfinite(excess)
        weight[missing] = 0.0
        excess[missing] = 0.0
        full = np.zeros((2, *height.shape), np.float32)
        full[0][b], full[1][b] = excess * weight, weight
        moment, total = (cv2.GaussianBlur(part, (0, 0), length) for part in full)
        parts.append(np.asarray(moment / (total + np.float32(BIAS_PRIOR)), np.float32))
    return _Bias(*parts)


def _edges(images: FloatImage | None, shape: tuple[int, ...]) -> tuple[FloatImage, FloatImage]:
    """Factors of the springs across and down."""
    rows, columns = shape
    across = np.ones((rows, columns - 1), np.float32)
    down = np.ones((rows - 1, columns), np.float32)
    if images is not None:
        floor = DARK_SHARE * float(np.median(images[:, ::8, ::8]))
        kernels.edge_factors(images, max(floor, 1e-6), EDGE_STRENGTH, across, down)
    return across, down


def _halved(fine: _Grid) -> _Grid:
    """Every second height, so that none lies between the two sides of a step; mean normals and images."""
    normals = averaged(fine.normals)
    normals /= np.maximum(np.linalg.norm(normals, axis=-1, keepdims=True), np.float32(1e-6))
    images = None
    if fine.images is not None:
        images = np.stack([averaged(image) for image in fine.images])
    return _Grid(
        fine.height_um[::2, ::2],
        fine.sigma_um[::2, ::2],
        normals,
        averaged(fine.sigma_rad),
        images,
        2 * fine.pixel_um,
    )


def _resized(bias: _Bias, shape: tuple[int, ...]) -> _Bias:
    if bias.across.shape == shape:
        return bias
    across, down = (
        np.asarray(cv2.resize(part, shape[::-1]), np.float32) for part in (bias.across, bias.down)
    )
    return _Bias(across, down)


def _checked(
    height_um: Real,
    height_sigma_um: Real,
    normals: Real,
    normal_sigma_rad: Real,
    images: FloatImage | None,
    pixel_um: float,
) -> _Grid:
    shape = height_um.shape
    if (
        height_sigma_um.shape != shape
        or normals.shape != (*shape, 3)
        or normal_sigma_rad.shape != shape
        or (images is not None and images.shape[1:] != shape)
    ):
        raise InvalidInputError(
            f"Heights {shape}, their errors {height_sigma_um.shape}, normals {normals.shape} and their "
            f"errors {normal_sigma_rad.shape} do not belong together.",
            hint="All maps of one reconstruction have the same rows and columns.",
        )
    if min(shape) < 3:
        raise InvalidInputError(
            f"An image of {shape[0]} x {shape[1]} pixels is too small to take slopes from.",
            hint="At least 3 x 3 pixels are needed.",
        )
    for sigma in (height_sigma_um, normal_sigma_rad):
        if np.any(sigma <= 0.0):
            raise InvalidInputError(
                "A standard error is zero or negative.",
                hint="Standard errors are positive, and infinite where a measurement is missing.",
            )
    known = np.isfinite(height_um) & np.isfinite(height_sigma_um)
    if not known.any():
        raise InvalidInputError(
            "No height has a finite standard error; there is nothing to hang a surface on.",
            hint="Look at the quality of stereo: exposure, focus and the height range are likely causes.",
        )
    bounded = np.where(
        np.isfinite(normal_sigma_rad),
        np.clip(normal_sigma_rad, LEAST_SIGMA_RAD, GREATEST_SIGMA_RAD),
        np.float32(np.inf),
    )
    return _Grid(
        np.asarray(height_um, np.float32),
        np.where(known, height_sigma_um, np.float32(np.inf)).astype(np.float32),
        np.nan_to_num(np.ascontiguousarray(normals, np.float32)),
        bounded.astype(np.float32),
        None if images is None else np.ascontiguousarray(images, np.float32),
        pixel_um,
    )
