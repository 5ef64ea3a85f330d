"""Robust smoothing with an automatic parameter and missing data (Garcia 2010; paper, section III.A).

The smoothed values minimise ``sum W (y - z)^2 + s sum (L z)^2``, where L is the discrete Laplacian with
reflecting borders.  L is diagonal in the discrete cosine transform (DCT), so for uniform weights one
transform there and back solves it: ``z = IDCT(G DCT(y))`` with ``G = 1 / (1 + s lambda^2)``,
``lambda = sum_axes (2 cos(pi i / n) - 2)``.

- Weights, and missing values as weight zero: Garcia iterates ``z <- IDCT(G DCT(W (y - z) + z))``
  (eq. 12).  Its fixed point solves ``(W + s L^2) z = W y``; we reach the same point by conjugate
  gradients preconditioned with the same two transforms, in far fewer steps.
- The parameter s minimises the generalised cross-validation score evaluated, as Garcia does,
  for one such step from the current z, with ``tr H = sum G``.
- Outliers: bisquare weights of residuals studentised with the median absolute deviation and the leverage
  of s, in repeated rounds.

Sources: D. Garcia, "Robust smoothing of gridded data in one and higher dimensions with missing values",
Computational Statistics and Data Analysis 54 (2010) 1167-1178.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numba
import numpy as np
from numpy.typing import NDArray
from scipy import fft, ndimage, optimize

from reliefscope.errors import InvalidInputError
from reliefscope.jobs import Job, ensure_job

Real = NDArray[np.floating[Any]]

ROUNDS = 4
"""Fits in the robust form: one plain, three with bisquare weights."""
TUNING = 4.685
"""Bisquare tuning constant: 95 % efficiency for normal errors."""
LEVERAGES = (1e-6, 0.99)
"""Least and greatest leverage searched: bounds of the parameter s."""
LEAST_SPREAD = 1e-3
"""Least spread of residuals, against that of the values: noiseless data have no outliers."""
SEARCH_TOLERANCE = 0.05
"""Of log10(s)."""
SETTLED = 0.1
"""Change of log10(s) below which parameter and values agree."""
PARAMETER_UPDATES = 5
STEP_TOLERANCE = 1e-4
"""Conjugate gradients stop at a preconditioned residual this small against the spread of the values."""
MOST_STEPS = 60
WARM_UP = ((1e4, 8), (1e2, 8), (1.0, 8))
"""Parameters and steps that fill gaps from coarse to fine before the first search."""
PAD_FROM = 256
"""Sides from this size on are padded, with missing values, to one that transforms fast."""


@dataclass(frozen=True, slots=True)
class Smoothed:
    """Result of :func:`smooth_robust`."""

    values: Real
    """Smoothed values, no gaps; shape and type of the input."""
    parameter: float
    """Smoothing parameter s."""
    outlier_weights: Real
    """Bisquare weight in [0, 1] of each value; 0 where missing, 1 in the plain form."""
    steps: int
    """Conjugate-gradient steps taken."""


def smooth_robust(
    values: Real,
    weights: Real | None = None,
    *,
    robust: bool = True,
    parameter: float | None = None,
    resolution: float = 0.0,
    job: Job | None = None,
) -> Smoothed:
    """Smooth gridded ``values``, fill what is missing, and ignore outliers.

    Parameters
    ----------
    values:
        Array of one or more dimensions; NaN is missing.  float32 is computed in float32, anything else in
        float64.
    weights:
        Non-negative weights of the same shape, such as the matching quality; 0 or NaN is missing.
    robust:
        Repeat with bisquare weights, so that outliers do not count.
    parameter:
        Smoothing parameter s; by default found by generalised cross-validation.
    resolution:
        Least standard deviation that a good value may have, in the unit of the values: the step of a
        search over candidates, for example.  Where most of a map is flat and quantised, the median
        deviation is far below it, and every edge would count as an outlier.
    job:
        Progress (stage ``smooth``, per round) and cancellation.

    Raises
    ------
    InvalidInputError
        Shapes that differ, negative weights, or fewer than three values to go by.
    """
    data, weight = _prepared(values, weights)
    shape = data.shape
    pads = [(0, _fast_length(size) - size) for size in shape]
    centre = float(np.median(data[weight > 0]))
    solver = _Solver(
        np.pad(np.where(weight > 0, data - data.dtype.type(centre), 0), pads),
        np.pad(weight, pads),
        resolution,
        ensure_job(job),
    )
    rounds = ROUNDS if robust else 1
    with solver.job.stage("smooth", rounds) as stage:
        solver.start()
        for turn in range(rounds):
            if turn:
                solver.reweight()
            solver.fit(parameter)
            stage.advance()
    inside = tuple(slice(size) for size in shape)
    return Smoothed(
        solver.z[inside] + data.dtype.type(centre),
        solver.s,
        np.where(weight > 0, solver.outlier[inside], 0).astype(data.dtype),
        solver.steps,
    )


class _Solver:
    """State of one smoothing: data, weights, current values and parameter."""

    def __init__(self, data: Real, weight: Real, resolution: float, job: Job) -> None:
        self.y = data
        self.given = weight
        self.known = weight > 0
        self.count = int(self.known.sum())
        self.job = job
        self.least_spread = max(resolution, LEAST_SPREAD * float(data[self.known].std()))
        self.outlier = self.known.astype(data.dtype)
        self.total = weight
        self.penalty = _penalty(data.shape, data.dtype)
        self.z = data.copy()
        self.s = 1.0
        self.steps = 0
        self.threads = numba.get_num_threads()
        tensor = sum(size > 1 for size in data.shape)
        self.tensor = max(tensor, 1)
        self.bounds = tuple(sorted(math.log10(_parameter_of(h, self.tensor)) for h in LEVERAGES))
        self.searched = False

    def dct(self, field: Real) -> Real:
        return np.asarray(fft.dctn(field, norm="ortho", workers=self.threads))

    def idct(self, field: Real) -> Real:
        return np.asarray(fft.idctn(field, norm="ortho", workers=self.threads, overwrite_x=True))

    def start(self) -> None:
        """First values: nearest known value, low-passed; gaps are then filled from coarse to fine."""
        if self.count == self.y.size:
            return
        nearest = ndimage.distance_transform_edt(
            ~self.known, return_distances=False, return_indices=True
        )
        coefficients = self.dct(self.y[tuple(nearest)])
        for axis, size in enumerate(coefficients.shape):
            kept = math.ceil(size / 10)
            coefficients[(slice(None),) * axis + (slice(kept, None),)] = 0
        self.z = self.idct(coefficients)
        for s, steps in WARM_UP:
            self.solve(s, steps)

    def fit(self, parameter: float | None) -> None:
        """Bring parameter and values into agreement for the present weights."""
        if parameter is not None:
            self.s = parameter
            self.solve(parameter, MOST_STEPS)
            return
        for _ in range(PARAMETER_UPDATES):
            before = self.s if self.searched else math.inf
            self.s = self.search()
            self.solve(self.s, MOST_STEPS)
            if abs(math.log10(self.s) - math.log10(before)) < SETTLED:
                break

    def search(self) -> float:
        """Parameter with the least generalised cross-validation score, one step from the current z."""
        coefficients = self.dct(self.total * (self.y - self.z) + self.z)
        low, high = self.bounds
        if self.searched:
            middle = math.log10(self.s)
            near = (max(low, middle - 1), min(high, middle + 1))
            found = self._minimise(coefficients, near)
            if min(found - near[0], near[1] - found) > 2 * SEARCH_TOLERANCE or near == (low, high):
                return float(10**found)
        self.searched = True
        return float(10 ** self._minimise(coefficients, (low, high)))

    def _minimise(self, coefficients: Real, bounds: tuple[float, float]) -> float:
        result = optimize.minimize_scalar(
            lambda exponent: self.score(coefficients, 10.0**exponent),
            bounds=bounds,
            method="bounded",
            options={"xatol": SEARCH_TOLERANCE},
        )
        return float(result.x)

    def score(self, coefficients: Real, s: float) -> float:
        """Generalised cross-validation score of s."""
        self.job.check()
        gain = 1 / (1 + self.penalty.dtype.type(s) * self.penalty)
        trace = float(gain.sum(dtype=np.float64))
        gain *= coefficients
        residual = self.idct(gain)
        np.subtract(self.y, residual, out=residual)
        residual *= residual
        squares = float(np.vdot(residual, self.total))
        return squares / self.count / (1 - trace / self.y.size) ** 2

    def solve(self, s: float, most: int) -> None:
        """Conjugate gradients on ``(W + s L^2) z = W y``, preconditioned with ``w + s L^2``, w the mean W.

        With M the preconditioner, ``A q = M q - (w - W) q``, so a step needs no transforms but those of
        the preconditioner.
        """
        kind = self.z.dtype.type
        mean = kind(self.total.sum(dtype=np.float64) / self.count)
        scale = 1 / (mean + kind(s) * self.penalty)
        lack = mean - self.total
        bending = self.dct(self.z)
        bending *= kind(s) * self.penalty
        residual = self.total * (self.y - self.z) - self.idct(bending)
        spread = float(np.linalg.norm(self.z)) + float(np.finfo(kind).tiny)
        direction = image = np.zeros_like(self.z)
        previous = 0.0
        for _ in range(most):
            self.job.check()
            self.steps += 1
            coefficients = self.dct(residual)
            coefficients *= scale
            q = self.idct(coefficients)
            if float(np.linalg.norm(q)) <= STEP_TOLERANCE * spread:
                self.z += q
                break
            energy = float(np.vdot(q, residual))
            applied = lack * q
            np.subtract(residual, applied, out=applied)
            if previous:
                ratio = kind(energy / previous)
                direction *= ratio
                direction += q
                image *= ratio
                image += applied
            else:
                direction, image = q, applied
            previous = energy
            length = kind(energy / float(np.vdot(direction, image)))
            self.z += length * direction
            residual -= length * image

    def reweight(self) -> None:
        """Bisquare weights of the studentised residuals."""
        residual = (self.y - self.z)[self.known]
        deviation = float(np.median(np.abs(residual - np.median(residual))))
        spread = 1.4826 * deviation * math.sqrt(1 - _leverage_of(self.s, self.tensor))
        spread = max(spread, self.least_spread)
        if spread > 0:
            u = np.abs(residual) / (TUNING * spread)
            self.outlier[self.known] = np.where(u < 1, (1 - u * u) ** 2, 0)
            self.total = self.given * self.outlier


def _prepared(values: Real, weights: Real | None) -> tuple[Real, Real]:
    kind = np.float32 if values.dtype == np.float32 else np.float64
    data: Real = np.asarray(values, dtype=kind)
    weight: Real = np.isfinite(data).astype(kind)
    if weights is not None:
        given: Real = np.asarray(weights, dtype=kind)
        if given.shape != data.shape:
            raise InvalidInputError(
                f"Weights of shape {given.shape} do not belong to values of shape {data.shape}.",
                hint="Give one weight per value.",
            )
        if np.any(given < 0):
            raise InvalidInputError(
                "Smoothing weights must not be negative.", hint="Use 0 for values to be ignored."
            )
        weight *= np.nan_to_num(given, nan=0.0, posinf=0.0)
    known = int((weight > 0).sum())
    if known < 3:
        raise InvalidInputError(
            f"Only {known} of {data.size} values are known: nothing to smooth.",
            hint="Lower the quality threshold, or check the range of heights and the slopes of views.",
        )
    return data, weight / weight.max()


def _penalty(shape: tuple[int, ...], kind: np.dtype[Any]) -> Real:
    """Squared eigenvalues of the Laplacian with reflecting borders."""
    eigenvalue = np.zeros(shape)
    for axis, size in enumerate(shape):
        along = 2 * np.cos(np.pi * np.arange(size) / size) - 2
        eigenvalue += along.reshape([-1 if a == axis else 1 for a in range(len(shape))])
    return (eigenvalue**2).astype(kind)


def _leverage_of(s: float, tensor: int) -> float:
    """Mean leverage of the parameter s over ``tensor`` dimensions."""
    root = math.sqrt(1 + 16 * s)
    return float((math.sqrt(1 + root) / math.sqrt(2) / root) ** tensor)


def _parameter_of(leverage: float, tensor: int) -> float:
    """Parameter s of a mean leverage: the inverse of :func:`_leverage_of`."""
    h2 = leverage ** (2 / tensor)
    root = (1 + math.sqrt(1 + 8 * h2)) / (4 * h2)
    return float((root * root - 1) / 16)


def _fast_length(size: int) -> int:
    return int(fft.next_fast_len(size)) if size >= PAD_FROM else size
