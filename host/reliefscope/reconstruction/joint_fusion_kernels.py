"""Compiled parts of the robust fusion: slopes and their weights, edges of the images, reweighted springs.

Between two neighbours lies a spring.  ``across`` (H, W-1) joins columns, ``down`` (H-1, W) rows; the rise of a
spring is the height that its right or lower end lies above its left or upper end, in um.
"""

from __future__ import annotations

import numpy as np
from numba import njit, prange

from reliefscope.units import FloatImage


@njit(cache=True, parallel=True)
def slope_equations(
    normals: FloatImage,
    sigma_rad: FloatImage,
    pixel_um: float,
    least_nz: float,
    rises: FloatImage,
    weights: FloatImage,
) -> None:
    """Rise per pixel to the right and downward (2, H, W), um, and its inverse variance (2, H, W), 1 / um^2.

    An error of the normal by ``sigma_rad`` in any direction gives the slope p = -n_x / n_z the variance
    ``sigma^2 (1 + p^2) / n_z^2``.  The weight is 0 where the normal is missing or looks away.
    """
    height, width = sigma_rad.shape
    for row in prange(height):
        for column in range(width):
            nz = normals[row, column, 2]
            sigma = sigma_rad[row, column]
            if nz > 0 and sigma < np.inf:
                nz = max(nz, np.float32(least_nz))
                p = -normals[row, column, 0] / nz
                q = -normals[row, column, 1] / nz
                common = (nz / (sigma * pixel_um)) ** 2
                rises[0, row, column] = p * pixel_um
                rises[1, row, column] = -q * pixel_um
                weights[0, row, column] = common / (1 + p * p)
                weights[1, row, column] = common / (1 + q * q)
            else:
                rises[0, row, column] = 0.0
                rises[1, row, column] = 0.0
                weights[0, row, column] = 0.0
                weights[1, row, column] = 0.0


@njit(cache=True, parallel=True)
def edge_factors(
    images: FloatImage, floor: float, strength: float, across: FloatImage, down: FloatImage
) -> None:
    """Factor in (0, 1] of each spring: ``1 / (1 + strength * contrast^2)``.

    The squared contrast of two neighbours is the mean over the images (L, H, W) of the square of the
    difference of their logarithms (to second order), with ``floor`` added to the intensities.
    """
    count, height, width = images.shape
    for row in prange(height):
        right = np.zeros(width, np.float32)
        lower = np.zeros(width, np.float32)
        base = np.float32(2.0 * floor)
        zero = np.float32(0.0)
        for k in range(count):
            for column in range(width):
                here = max(images[k, row, column], zero)
                if column < width - 1:
                    other = max(images[k, row, column + 1], zero)
                    change = (other - here) / (other + here + base)
                    right[column] += change * change
                if row < height - 1:
                    other = max(images[k, row + 1, column], zero)
                    change = (other - here) / (other + here + base)
                    lower[column] += change * change
        scale = np.float32(4.0 * strength / count)
        one = np.float32(1.0)
        for column in range(width - 1):
            across[row, column] = one / (one + scale * right[column])
        if row < height - 1:
            for column in range(width):
                down[row, column] = one / (one + scale * lower[column])


@njit(cache=True)
def _half(weight: float, deviation: float, scale: float, freedom: float) -> float:
    """Half of a slope's weight, by Student's distribution of its deviation over ``scale`` sigma."""
    return 0.5 * weight * (freedom + 1.0) / (freedom + weight * (deviation / scale) ** 2)


@njit(cache=True, parallel=True)
def reweight(
    z: FloatImage,
    rise: FloatImage,
    weight: FloatImage,
    bias: FloatImage,
    factor: FloatImage,
    axis: int,
    scale: float,
    freedom: float,
    spring: FloatImage,
    wanted: FloatImage,
) -> None:
    """Springs along one axis (0: across, 1: down) and their rises, from the slopes at both ends.

    Each end votes with its own slope, and its vote loses weight as the surface ``z`` (H, W) departs from it.
    With ``scale`` infinite the weights are those of least squares.  ``rise``, ``weight`` (H, W) are those of
    the pixels; ``bias`` and ``factor`` those of the springs.
    """
    rows, columns = spring.shape
    for row in prange(rows):
        for column in range(columns):
            r = row + axis
            c = column + 1 - axis
            step = z[r, c] - z[row, column] - bias[row, column]
            first = _half(weight[row, column], rise[row, column] - step, scale, freedom)
            second = _half(weight[r, c], rise[r, c] - step, scale, freedom)
            total = first + second
            spring[row, column] = factor[row, column] * total
            if total > 0.0:
                mean = (first * rise[row, column] + second * rise[r, c]) / total
                wanted[row, column] = mean + bias[row, column]
            else:
                wanted[row, column] = 0.0
