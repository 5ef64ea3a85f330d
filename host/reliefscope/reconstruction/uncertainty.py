"""Standard error of a fused surface.

The weights of the fusion are inverse variances, so the inverse of its matrix A is the covariance of the surface,
were all errors independent and of the stated size.  Its diagonal is estimated by sampling: measurements drawn from
their distributions around zero, fused by the same springs, give surfaces of covariance A^-1 (perturb and optimise:
Papandreou and Yuille 2010).  A pixel far from every certain height thus gets the error that slopes add up to on
the way to it, one that is cut off gets the error of its own height, and nothing has to be assumed about which is
which.

Errors are not independent: stereo and slopes are wrong in the same way over whole neighbourhoods.  The stated
error is therefore ``GAIN * s^EXPONENT`` of the sampled deviation s, both in pixels.  The two constants were set on
simulated runs of the fiducial and of regolith (docs/explanation/fusion.md has the figures, and those of other scenes).
"""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from reliefscope.jobs import Job
from reliefscope.reconstruction import conjugate_gradients
from reliefscope.reconstruction.systems import SpringSystem
from reliefscope.units import FloatImage

SAMPLES = 4
"""Surfaces drawn; with the averaging over neighbours some thirty samples stand behind a pixel."""
AVERAGED_PX = 1.0
"""Standard deviation of the window over which the variance is averaged."""
ITERATIONS = 3
"""Of the solver, per sample: enough for a few per cent of the deviation."""
GAIN, EXPONENT = 1.5, 0.9
"""Stated error from the sampled deviation, both in pixels."""
LEAST_PX = 0.04
"""Least stated error, in pixels: no more is claimed whatever the weights."""
SEED = 1


def sampled_deviation(system: SpringSystem, job: Job) -> FloatImage:
    """Standard deviation (H, W) um of the surface of ``system`` if its weights are inverse variances."""
    generator = np.random.default_rng(SEED)
    variance: NDArray[np.float64] = np.zeros(system.right.shape)
    start = np.zeros_like(variance)
    for _ in range(SAMPLES):
        drawn = system.drawn(generator)
        sample = conjugate_gradients.solve(drawn, start, 0.0, ITERATIONS, job)
        variance += sample.z**2
    averaged = cv2.GaussianBlur((variance / SAMPLES).astype(np.float32), (0, 0), AVERAGED_PX)
    return np.asarray(np.sqrt(averaged), np.float32)


def stated_error(deviation_um: FloatImage, pixel_um: float) -> FloatImage:
    """Standard error (H, W) um to state for a sampled deviation (H, W) um."""
    pixel = np.float32(pixel_um)
    relative = GAIN * (deviation_um / pixel) ** np.float32(EXPONENT)
    return np.asarray(pixel * np.maximum(relative, LEAST_PX), np.float32)
