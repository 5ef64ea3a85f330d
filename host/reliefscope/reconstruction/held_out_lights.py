"""Every light predicted from all the others: one LED that is weak or too bright disagrees with the rest.

The images of a light are rendered from normals and albedo that least squares finds without it, at the light's
true strength and direction at every pixel, and compared with the frames.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from reliefscope import axes
from reliefscope.models.light_field import LightField
from reliefscope.units import BoolImage, FloatImage

SAMPLES = 30_000
"""Pixels, at most, on which lights are held out."""
LEAST_PIXELS = 100
LEAST_COSINE = 0.15
"""Cosine between normal and light below which a pixel may be in shadow."""
LAMBERTIAN_SHARE = 0.5
"""Share of the pixels, those that Lambert's law explains best, that are used."""
LEAST_LIGHTS = 6
"""Lights, the one held out included, below which the others do not settle what it should be."""
LEAST_RING = 4
"""Lights of equal elevation from which on they are compared with each other."""
RING_DEG = 3.0
"""Difference in elevation within a ring."""


@dataclass(frozen=True, slots=True, eq=False)
class HeldOutLights:
    """Every light against what all others predict for it.

    Attributes
    ----------
    levels:
        (L,) measured over predicted intensity, median over the pixels, over the median of the lights of the
        same elevation: gloss brightens a whole ring.
    error:
        Median absolute difference between measured and predicted intensity, over the median intensity.
    pixels:
        Pixels compared.
    """

    levels: NDArray[np.float64]
    error: float
    pixels: int


def hold_out_lights(
    images: FloatImage,
    lights: LightField,
    height_um: FloatImage,
    good: BoolImage,
    pixel_um: float,
    excluded: frozenset[int] = frozenset(),
) -> HeldOutLights | None:
    """Predict every light from all the others that are not ``excluded``.

    Parameters
    ----------
    images:
        (L, H, W) linear intensities in the view s = 0, not divided by the lights' powers.
    lights:
        Where light comes from, and how strong it is.
    height_um, good:
        (H, W) heights, and the pixels that may be used.
    pixel_um:
        Size of a pixel on the sample.
    excluded:
        Lights known to be faulty.

    Returns
    -------
    None where there are too few lights or too few pixels that Lambert's law explains.
    """
    used = np.array([light not in excluded for light in range(len(lights))])
    if used.sum() < LEAST_LIGHTS:
        return None
    step = max(1, math.isqrt(height_um.size // SAMPLES))
    at = (slice(step // 2, None, step), slice(step // 2, None, step))
    values = images[:, *at].reshape(len(lights), -1).astype(np.float64)
    usable = good[at].ravel() & np.isfinite(values).all(axis=0)
    places = np.flatnonzero(usable & np.isfinite(height_um[at]).ravel())
    x_um, y_um = axes.pixel_grid_um((height_um.shape[0], height_um.shape[1]), pixel_um)
    grid = np.stack([*np.meshgrid(x_um[at[1]], y_um[at[0]]), height_um[at]], axis=-1)
    irradiance = lights.irradiance(grid.reshape(-1, 3)[places])
    sample = _Sample(values[:, places], irradiance, used).lambertian()
    if sample.intensities.shape[1] < LEAST_PIXELS:
        return None
    return _compare(sample, lights)


@dataclass(frozen=True)
class _Sample:
    """Intensities (L, P) and irradiance vectors (L, P, 3) of some pixels; which lights are ``used`` (L,)."""

    intensities: NDArray[np.float64]
    light: NDArray[np.float64]
    used: NDArray[np.bool_]

    @cached_property
    def _normal_equations(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Matrices (P, 3, 3) and right sides (P, 3) of least squares over the used lights."""
        light = self.light[self.used]
        matrix = np.einsum("lpi,lpj->pij", light, light)
        right = np.einsum("lpi,lp->pi", light, self.intensities[self.used])
        return matrix, right

    def solved(self, without: int | None = None) -> NDArray[np.float64]:
        """Albedo times normal (P, 3) by least squares over the used lights but one."""
        matrix, right = self._normal_equations
        if without is not None and self.used[without]:
            light = self.light[without]
            matrix = matrix - light[:, :, None] * light[:, None, :]
            right = right - light * self.intensities[without, :, None]
        ridge = 1e-9 * np.trace(matrix, axis1=1, axis2=2)
        found: NDArray[np.float64] = np.linalg.solve(
            matrix + ridge[:, None, None] * np.eye(3), right[..., None]
        )[..., 0]
        return found

    def lambertian(self) -> _Sample:
        """The pixels that no light grazes, and of them those that Lambert's law explains best."""
        product = self.solved()
        length = np.maximum(np.linalg.norm(product, axis=1), 1e-12)
        predicted = np.einsum("lpi,pi->lp", self.light, product)
        cosine = predicted / (length * np.linalg.norm(self.light, axis=2))
        lit = cosine.min(axis=0) > LEAST_COSINE
        residual = np.abs(self.intensities - predicted)[self.used].mean(axis=0)
        relative = np.where(lit, residual / length, np.inf)
        kept = np.sort(np.argsort(relative, kind="stable")[: int(LAMBERTIAN_SHARE * lit.sum())])
        return _Sample(self.intensities[:, kept], self.light[:, kept], self.used)


def _compare(sample: _Sample, lights: LightField) -> HeldOutLights:
    count, pixels = sample.intensities.shape
    levels, misses = np.empty(count), np.empty((count, pixels))
    for index in range(count):
        product = sample.solved(without=index)
        measured = sample.intensities[index]
        predicted = np.einsum("pi,pi->p", sample.light[index], product)
        misses[index] = np.abs(measured - predicted)
        levels[index] = np.median(measured / np.maximum(predicted, 1e-12))
    error = np.median(misses[sample.used]) / np.median(sample.intensities[sample.used])
    return HeldOutLights(
        levels=levels / _ring_medians(levels, lights, sample.used),
        error=float(error),
        pixels=pixels,
    )


def _ring_medians(
    levels: NDArray[np.float64], lights: LightField, used: NDArray[np.bool_]
) -> NDArray[np.float64]:
    """Median level (L,) of the lights of each light's elevation; of all lights where these are few."""
    elevation = np.degrees(np.arcsin(lights.directions[:, 2]))
    medians = np.full(len(levels), float(np.median(levels[used])))
    for index, angle in enumerate(elevation):
        ring = used & (np.abs(elevation - angle) <= RING_DEG)
        if ring.sum() >= LEAST_RING:
            medians[index] = np.median(levels[ring])
    return medians
