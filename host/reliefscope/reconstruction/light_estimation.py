"""What the photographs themselves tell about their lights.

:func:`refine_powers` finds how bright lights are relative to each other where their directions are known.
:func:`estimate_lights` finds near lights of which nothing is known, from a sample that is level and even for the
most part:

1. *Level intensity.*  A cubic in x and y, fitted robustly to the logarithm of each photograph, is what a level
   surface shows under that light; slopes are outliers to it.
2. *Place above the sample, up to elevation.*  Brightness falls off from the light; an LED that shines evenly, with
   the inverse square of its distance and the cosine of incidence, is fitted to the level intensity.  Its azimuth
   is taken over.  Its elevation is not, and its distance is a start only: the beam of an LED changes the fall-off
   as they do.
3. *Elevation and distance*, the same for all lights.  A slope under evenly spread lights receives the cosine of
   its slant in the mean; how much brighter it is on the side of a light tells the same slant times the cotangent of
   the elevation.  Both agree at one elevation only, and for slopes to either side at one distance only.  What
   slopes receive from the sample around them adds ``reflectance (1 - cos slant) / 2``, the share of their
   hemisphere that level surroundings fill.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq, least_squares

from reliefscope.axes import pixel_grid_um
from reliefscope.errors import InvalidInputError
from reliefscope.models.light_field import LightField, level_powers
from reliefscope.reconstruction import photometric
from reliefscope.units import UM_PER_MM, FloatImage

REFLECTANCE = 0.6
"""Reflectance of a light grey coating, of which slopes receive their share (assumed)."""
_FIT_PIXELS = 4000
_FIT_ROUNDS = 15
_TUKEY = 4.0
_LEAST_DEVIATION = 0.003
"""Scatter of the logarithm of intensity below which level pixels are not told from slopes."""
_LEVEL_SHARE = 0.4
_LEVEL = 0.05
"""Relative deviation from the level intensity up to which a pixel counts as level."""
_SLOPED = 0.1
"""Relative deviation from which a pixel counts as sloped."""
_ELEVATIONS_RAD = (math.radians(10.0), math.radians(75.0))
_DISTANCE_FACTORS = (0.7, 3.0)
"""Range of distances tried, over that of the fall-off: a beam makes an LED look nearer than it is."""
_POWER_PIXELS = 12000
_POWER_ROUNDS = 4
_SEPARATION = 0.15
"""Smallest over second eigenvalue up to which powers are told: 0.08 on the dull finish of the simulated fiducial, where
powers come out to 1.6 % or better; 0.2 on the half glossy one, where they are up to 7 % off."""
_GRAZING = 0.05
"""Prediction, over the albedo, below which a light may be shadowed."""
_SEED = 1


@dataclass(frozen=True, slots=True, eq=False)
class LightEstimate:
    """Lights found in photographs.

    Attributes
    ----------
    positions_mm:
        (L, 3) from the point of the sample in the middle of the image.
    powers:
        (L,) relative to their mean.
    level:
        (L, 10) coefficients of the logarithm of the level intensity, see
        :func:`reliefscope.models.light_field.level_powers`.
    elevation_rad:
        Elevation of all lights.
    level_share:
        Part of the sample that is level.
    """

    positions_mm: NDArray[np.float64]
    powers: NDArray[np.float64]
    level: NDArray[np.float64]
    elevation_rad: float
    level_share: float

    @property
    def light_field(self) -> LightField:
        """The lights as photometric stereo takes them."""
        field = LightField.of_leds(self.positions_mm, np.diag(self.powers))
        return field.with_level(self.level)


def refine_powers(images: FloatImage, lights: LightField, pixel_um: float) -> NDArray[np.float64]:
    """Factors (L,), of geometric mean 1, by which lights are stronger than ``lights`` says.

    Let t be the inverse factors.  Where Lambert's law holds, the intensities times t lie in the space that the
    irradiance vectors span, so their part outside of it vanishes: t is the eigenvector, of the smallest eigenvalue,
    of the sum over the pixels of that part's squares.  Pixels count by the residual that the normals solved so far
    leave there, which keeps highlights and shadows out.

    Raises
    ------
    InvalidInputError
        Fewer than five lights, which explain any powers; too few pixels that all of them light; or a sample that
        does not follow Lambert's law well enough for the smallest eigenvalue to stand apart.
    """
    if len(lights) < 5:
        raise InvalidInputError(
            f"Powers of lights follow from at least 5 lights; there are {len(lights)}.",
            hint="Give `power` for every light.",
        )
    step = max(1, math.isqrt(images.shape[1] * images.shape[2] // _POWER_PIXELS))
    sparse = np.ascontiguousarray(images[:, ::step, ::step], dtype=np.float32)
    x_um, y_um = pixel_grid_um((images.shape[1], images.shape[2]), pixel_um)
    points = np.stack(np.broadcast_arrays(x_um[None, ::step], y_um[::step, None], 0.0), axis=-1)
    field = np.moveaxis(lights.irradiance(points), 0, 2)
    factors = np.ones(len(lights))
    for _ in range(_POWER_ROUNDS):
        vectors = _vectors(sparse, lights.scaled(factors), points)
        albedo = np.linalg.norm(vectors, axis=-1)
        predicted = np.einsum("hwlc,hwc->hwl", field * factors[:, None], vectors)
        misfit = np.abs(np.moveaxis(sparse, 0, 2) - predicted).max(axis=-1) / albedo
        counts = np.isfinite(misfit) & (predicted.min(axis=-1) > _GRAZING * albedo)
        if np.count_nonzero(counts) < _POWER_PIXELS // 100:
            raise InvalidInputError(
                "Too few pixels are lit by every light for its power to be found.",
                hint="Give `power` for every light.",
            )
        chosen = field[counts]
        intensities = np.moveaxis(sparse, 0, 2)[counts] / albedo[counts][:, None]
        spanned = chosen @ np.linalg.pinv(chosen)
        outside = np.eye(len(lights)) - spanned
        scale = max(float(np.median(misfit[counts])), photometric.TOLERATED_RESIDUAL)
        weights = 1.0 / (1.0 + (misfit[counts] / scale) ** 2) ** 2
        total = np.einsum(
            "n,ni,nij,nj->ij", weights, intensities, outside, intensities, optimize=True
        )
        misfits, solutions = np.linalg.eigh(total)
        inverse = np.abs(solutions[:, 0])
        factors = np.exp(np.log(inverse).mean()) / inverse
    if misfits[0] > _SEPARATION * misfits[1]:
        raise InvalidInputError(
            "The sample does not tell how strong its lights are: other powers explain it almost as well.",
            hint="Use a matt sample with slopes to all sides, or give `power` for every light.",
        )
    return factors


def _vectors(
    images: FloatImage, lights: LightField, points: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Albedo times normal (H, W, 3) by least squares, reweighted against what single lights add or miss."""
    field = np.moveaxis(lights.irradiance(points), 0, 2)
    intensities = np.moveaxis(images, 0, 2).astype(np.float64)
    weights = np.ones(intensities.shape)
    for _ in range(4):
        matrix = np.einsum("hwl,hwli,hwlj->hwij", weights, field, field, optimize=True)
        right = np.einsum("hwl,hwli,hwl->hwi", weights, field, intensities, optimize=True)
        matrix += 1e-6 * np.trace(matrix, axis1=-2, axis2=-1)[..., None, None] * np.eye(3) + 1e-30
        found = np.linalg.solve(matrix, right[..., None])[..., 0]
        misfit = np.abs(intensities - np.einsum("hwli,hwi->hwl", field, found))
        scale = np.median(misfit, axis=-1, keepdims=True) * 2.0 + 1e-6
        weights = 1.0 / (1.0 + (misfit / scale) ** 2)
    return np.asarray(found, dtype=np.float64)


def estimate_lights(
    images: FloatImage, pixel_um: float, *, reflectance: float = REFLECTANCE
) -> LightEstimate:
    """Near lights from photographs (L, H, W) of one sample, linear, that is level and even for the most part.

    ``reflectance`` of the sample (0 to 1) corrects for light between its parts; 0 leaves it out.

    Raises
    ------
    InvalidInputError
        Fewer than three photographs, ones without light, a sample that is not level enough or has no slopes,
        light that does not fall off, or slopes that no elevation explains.
    """
    if images.ndim != 3 or len(images) < 3:
        raise InvalidInputError(
            f"Lights are estimated from at least 3 photographs (lights, rows, columns), not {images.shape}.",
            hint="Take the sample under more lights.",
        )
    shape = (images.shape[1], images.shape[2])
    terms = level_powers(shape).reshape(-1, 10)
    level = np.array([_level_intensity(image, terms) for image in images])
    shown = np.exp(terms @ level.T).T.reshape(images.shape)
    relative = images / shown
    deviation = np.abs(np.log(np.maximum(relative, 1e-3))).max(axis=0)
    level_share = float(np.mean(deviation < _LEVEL))
    if level_share < _LEVEL_SHARE:
        raise InvalidInputError(
            f"Only {level_share:.0%} of the sample is level and even; at least {_LEVEL_SHARE:.0%} must be.",
            hint="Give the directions of the lights, or find them with `reliefscope light-probe`.",
        )
    x_um, y_um = pixel_grid_um(shape, pixel_um)
    x_mm, y_mm = np.meshgrid(x_um / UM_PER_MM, y_um / UM_PER_MM)
    places = np.array([_falloff(light, x_mm, y_mm) for light in shown])
    azimuths = np.arctan2(places[:, 1], places[:, 0])
    distance = float(np.median(np.linalg.norm(places, axis=1)))
    generator = np.random.default_rng(_SEED)
    sloped = _some(np.flatnonzero(deviation.ravel() > _SLOPED), generator)
    if sloped.size < _FIT_PIXELS // 10:
        raise InvalidInputError(
            "The sample has no slopes from which the elevation of the lights could follow.",
            hint="Give the directions of the lights, or find them with `reliefscope light-probe`.",
        )
    slopes = _Slopes(
        relative.reshape(len(images), -1)[:, sloped].astype(np.float64),
        np.stack([x_mm.ravel()[sloped], y_mm.ravel()[sloped]], axis=-1),
        azimuths,
        reflectance / 2,
    )
    distance = slopes.distance(distance)
    elevation = slopes.elevation(distance)
    towards = np.stack(
        [
            math.cos(elevation) * np.cos(azimuths),
            math.cos(elevation) * np.sin(azimuths),
            np.full(len(images), math.sin(elevation)),
        ],
        axis=-1,
    )
    powers = np.exp(level[:, 0])
    return LightEstimate(distance * towards, powers / powers.mean(), level, elevation, level_share)


def _some(indices: NDArray[np.intp], generator: np.random.Generator) -> NDArray[np.intp]:
    if indices.size <= _FIT_PIXELS:
        return indices
    return generator.choice(indices, _FIT_PIXELS, replace=False)


def _level_intensity(image: FloatImage, terms: NDArray[np.float64]) -> NDArray[np.float64]:
    """Coefficients (10,) of the logarithm of intensity of the level part, by Tukey's biweight."""
    values = image.ravel().astype(np.float64)
    chosen = np.flatnonzero(values > 0)
    if chosen.size < values.size // 2:
        raise InvalidInputError(
            "A photograph is dark for the most part.",
            hint="Check exposure, black level and lights.",
        )
    chosen = chosen[:: max(1, chosen.size // (2 * _FIT_PIXELS))]
    logs, matrix = np.log(values[chosen]), terms[chosen]
    weights = np.ones(len(chosen))
    for _ in range(_FIT_ROUNDS):
        root = np.sqrt(weights)
        found = np.linalg.lstsq(matrix * root[:, None], logs * root, rcond=None)[0]
        misfit = logs - matrix @ found
        scale = max(1.4826 * float(np.median(np.abs(misfit))), _LEAST_DEVIATION)
        weights = np.maximum(1 - (misfit / (_TUKEY * scale)) ** 2, 0.0) ** 2 + 1e-9
    return np.asarray(found, dtype=np.float64)


def _falloff(
    level: NDArray[np.float64], x_mm: NDArray[np.float64], y_mm: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Place (3,) in mm of an LED that shines evenly and gives a level surface ``level`` (H, W) up to a factor."""
    coarse = max(1, max(level.shape) // 64)
    size = (level.shape[1] // coarse, level.shape[0] // coarse)
    x, y, light = (
        cv2.resize(a, size, interpolation=cv2.INTER_AREA).astype(np.float64)
        for a in (x_mm, y_mm, np.log(level))
    )
    d_row, d_column = np.gradient(light)
    azimuth = math.atan2(-float(d_row.mean()), float(d_column.mean()))
    extent = float(np.ptp(x_mm) + np.ptp(y_mm)) / 2

    def misfit(place: NDArray[np.float64]) -> NDArray[np.float64]:
        height = math.exp(min(max(float(place[2]), -20.0), 20.0))
        squared = (place[0] - x) ** 2 + (place[1] - y) ** 2 + height**2
        difference = light + 1.5 * np.log(squared)
        centred: NDArray[np.float64] = (difference - difference.mean()).ravel()
        return centred

    start = [extent * math.cos(azimuth), extent * math.sin(azimuth), math.log(extent)]
    found = least_squares(misfit, start, loss="soft_l1", f_scale=0.03)
    place = np.array([found.x[0], found.x[1], math.exp(min(max(float(found.x[2]), -20.0), 20.0))])
    if not np.isfinite(place).all() or np.linalg.norm(place) > 100 * extent:
        raise InvalidInputError(
            "A light does not fall off across the field, so that its distance cannot be found.",
            hint="Give the directions of the lights, or find them with `reliefscope light-probe`.",
        )
    return place


@dataclass(frozen=True, slots=True, eq=False)
class _Slopes:
    """Sloped pixels: intensities (L, N) over the level one, and where they are (N, 2).

    ``azimuths`` (L,) of the lights in rad; ``bounce``: what level surroundings add, over the share that they fill.
    """

    relative: NDArray[np.float64]
    points_mm: NDArray[np.float64]
    azimuths: NDArray[np.float64]
    bounce: float

    def albedos(self, distance_mm: float, elevation: float) -> tuple[float, float]:
        """Mean albedo, over the level one, of slopes to either side, were all lights at this place."""
        reach, height = distance_mm * math.cos(elevation), distance_mm * math.sin(elevation)
        field = np.ones((*self.relative.shape, 3))
        field[..., 0] = (reach * np.cos(self.azimuths)[:, None] - self.points_mm[:, 0]) / height
        field[..., 1] = (reach * np.sin(self.azimuths)[:, None] - self.points_mm[:, 1]) / height
        matrix = np.einsum("lni,lnj->nij", field, field)
        right = np.einsum("lni,ln->ni", field, self.relative)
        found = np.linalg.solve(matrix, right[..., None])[..., 0]
        found[:, 2] = (found[:, 2] - self.bounce) / (1 - self.bounce)
        lengths = np.linalg.norm(found, axis=1)
        across = np.argmax(np.abs(found[:, :2]).mean(axis=0))
        sides = found[:, across] > 0
        both = [float(lengths[side].mean()) for side in (sides, ~sides) if side.any()]
        return both[0], both[-1]

    def elevation(self, distance_mm: float) -> float:
        """Elevation in rad at which slopes keep the albedo of the level part, both sides counting alike."""

        def excess(elevation: float) -> float:
            return sum(self.albedos(distance_mm, elevation)) - 2.0

        low, high = _ELEVATIONS_RAD
        if excess(low) * excess(high) > 0:
            raise InvalidInputError(
                "No elevation of the lights explains the brightness of the slopes.",
                hint="The sample must be matt and of one colour; give the directions of the lights instead.",
            )
        return float(brentq(excess, low, high, xtol=1e-4))

    def distance(self, falloff_mm: float) -> float:
        """Distance in mm at which slopes to either side agree; that of the fall-off where none does."""

        def imbalance(logarithm: float) -> float:
            distance = falloff_mm * math.exp(logarithm)
            first, second = self.albedos(distance, self.elevation(distance))
            return first - second

        low, high = (math.log(factor) for factor in _DISTANCE_FACTORS)
        if imbalance(low) * imbalance(high) > 0:
            return falloff_mm
        return falloff_mm * math.exp(float(brentq(imbalance, low, high, xtol=1e-3)))
