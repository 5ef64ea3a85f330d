"""Photometric stereo: Lambert's law by least squares with the paper's quality score (eq. 4-10).

The intensities are linear and belong to one virtual view, so that a pixel is the same point of the
sample under every light.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from reliefscope.errors import InvalidInputError
from reliefscope.reconstruction import ps_kernels
from reliefscope.units import FloatImage

RESIDUAL_SCALE = 0.2
"""Residual, as a fraction of full scale, that halves the quality, eq. 10."""
SLANT_SCALE_RAD = math.radians(80.0)
"""Slant that halves the quality, eq. 10."""
FULL_SCALE_PERCENTILE = 95.0
"""Percentile of the intensities that counts as full scale in eq. 10."""
CHANGE_SCALE = 0.1
"""Change of the normal per pixel that halves the quality, eq. 10."""
MAXIMUM_CONDITION = 20.0
"""Ratio of the largest to the smallest singular value of the light matrix above which lights are
refused.

It bounds by how much a relative error of the intensities can grow in the normals; 16 lights in two
rings of 22.5 and 45 degrees elevation have 1.0, twelve lights within 25 degrees of the axis about
5, lights in one row or column tens to thousands.
"""
_MINIMUM_SPREAD = 1e-4
"""Determinant of the normal matrix of the kept lights, over the cube of their number (1/27 at best)."""


@dataclass(frozen=True, slots=True)
class PsResult:
    """Normals and what speaks for them, all (H, W) float32 but ``normals`` (H, W, 3).

    Attributes
    ----------
    normals:
        Unit normals, x right, y up, z toward the objective; NaN where no light came or a frame is
        missing.
    albedo:
        Length of the least-squares vector (eq. 5), in units of intensity.
    residual:
        Root-mean-square residual of eq. 7, in units of intensity.
    change:
        Change of the normal per pixel, eq. 8.
    quality:
        Score of eq. 10, 0 where the normal or a neighbour is missing or looks away from the camera.
    slant_rad:
        Angle between the normal and the optical axis.
    """

    normals: FloatImage
    albedo: FloatImage
    residual: FloatImage
    change: FloatImage
    quality: FloatImage
    slant_rad: FloatImage


def check_directions(
    directions: ArrayLike, maximum_condition: float = MAXIMUM_CONDITION
) -> NDArray[np.float64]:
    """Directions (L, 3) as unit vectors, refused where they cannot give a normal.

    Raises
    ------
    InvalidInputError
        Fewer than three lights, a direction that is zero, not finite or below the sample, or a
        light matrix whose condition number exceeds ``maximum_condition``.
    """
    lights = np.asarray(directions, dtype=np.float64)
    if lights.ndim != 2 or lights.shape[1] != 3:
        raise InvalidInputError(
            f"Light directions must have the shape (lights, 3), not {lights.shape}.",
            hint="Give one vector [x, y, z] per light, from the sample to the light.",
        )
    if len(lights) < 3:
        raise InvalidInputError(
            f"Photometric stereo needs at least 3 lights; there are {len(lights)}.",
            hint="Take the sample under more lights.",
        )
    lengths = np.linalg.norm(lights, axis=1)
    if not np.all(np.isfinite(lengths)) or np.any(lengths == 0.0):
        bad = [int(i) for i in np.flatnonzero(~np.isfinite(lengths) | (lengths == 0.0))]
        raise InvalidInputError(
            f"Light directions {bad} are zero or not finite.",
            hint="Correct `direction` of these lights in the profile or the import file.",
        )
    unit: NDArray[np.float64] = lights / lengths[:, None]
    if np.any(unit[:, 2] <= 0.0):
        bad = [int(i) for i in np.flatnonzero(unit[:, 2] <= 0.0)]
        raise InvalidInputError(
            f"Light directions {bad} point below the sample plane (z is not positive).",
            hint="Directions lead from sample to light, z toward the objective; check the axes.",
        )
    condition = float(np.linalg.cond(unit))
    if condition > maximum_condition:
        raise InvalidInputError(
            f"The lights are badly spread: condition number {condition:.3g}, "
            f"at most {maximum_condition:g} is accepted.",
            hint="Lights in one row or one spot cannot tell slopes apart; spread them all around.",
        )
    return unit


def solve_lambert(
    images: FloatImage,
    directions: ArrayLike,
    *,
    trim: tuple[float, float] | None = None,
    full_scale: float = 1.0,
    maximum_condition: float = MAXIMUM_CONDITION,
) -> PsResult:
    """Normals, albedo and quality from intensities under known lights.

    Parameters
    ----------
    images:
        (L, H, W) float32, linear; NaN marks missing pixels.
    directions:
        (L, 3) vectors from the sample to the lights; only their directions count.
    trim:
        None: least squares over all lights, as the paper does.  (low, high): least squares over the
        lights whose intensity at the pixel ranks between these fractions, which leaves shadows
        (low) and highlights (high) out; eq. 7 then counts the kept lights only.  (0.2, 0.9) is a
        good choice from eight lights on.
    full_scale:
        Intensity that counts as 1 in the quality of eq. 10, see :func:`full_scale_of`.
    maximum_condition:
        See :data:`MAXIMUM_CONDITION`.

    Raises
    ------
    InvalidInputError
        Too few or badly spread lights, shapes that do not belong together, a trimming that leaves
        fewer than three lights.
    """
    unit = check_directions(directions, maximum_condition)
    if images.ndim != 3 or len(images) != len(unit):
        raise InvalidInputError(
            f"{len(unit)} light directions do not belong to images of shape {images.shape}.",
            hint="Images have the shape (lights, rows, columns).",
        )
    stack = np.ascontiguousarray(images, dtype=np.float32)
    lights, height, width = stack.shape
    pseudo_inverse = np.ascontiguousarray(np.linalg.pinv(unit), dtype=np.float32)
    matrix = np.ascontiguousarray(unit, dtype=np.float32)
    normals = np.empty((height, width, 3), np.float32)
    albedo = np.empty((height, width), np.float32)
    residual = np.empty((height, width), np.float32)
    if trim is None:
        ps_kernels.solve_least_squares(stack, pseudo_inverse, matrix, normals, albedo, residual)
    else:
        first, last = kept_ranks(lights, trim)
        ps_kernels.solve_trimmed(
            stack, pseudo_inverse, matrix, first, last, _MINIMUM_SPREAD, normals, albedo, residual
        )
    slant = np.empty_like(residual)
    change = np.empty_like(residual)
    quality = np.empty_like(residual)
    ps_kernels.score_quality(
        normals,
        residual,
        RESIDUAL_SCALE * full_scale,
        SLANT_SCALE_RAD,
        CHANGE_SCALE,
        slant,
        change,
        quality,
    )
    quality[~(normals[..., 2] > 0.0)] = 0.0
    return PsResult(normals, albedo, residual, change, quality, slant)


def full_scale_of(images: FloatImage, percentile: float = FULL_SCALE_PERCENTILE) -> float:
    """Intensity of ``images`` (L, H, W) that counts as full scale.

    Eq. 10 weighs the residual against full scale, so it takes the sample for well exposed.  Behind a leaking
    glass it never is: the shut pixels fill a large part of the camera's range, and the frames that are left
    after the subtraction of their light reach a fraction of it.  Full scale is therefore where a well
    exposed frame would have it: at the level that the brightest twentieth of the sample exceeds, so that highlights
    may clip and the matte part fills the range.
    """
    level = float(np.nanpercentile(images[:, ::4, ::4], percentile))
    return level if level > 0.0 else 1.0


def kept_ranks(lights: int, trim: tuple[float, float]) -> tuple[int, int]:
    """First and one past the last rank (darkest = 0) of the lights between two fractions.

    Raises
    ------
    InvalidInputError
        Fractions out of order or fewer than three lights left.
    """
    low, high = trim
    if not 0.0 <= low < high <= 1.0:
        raise InvalidInputError(
            f"Trimming fractions must satisfy 0 <= low < high <= 1, not {low:g} and {high:g}.",
            hint="Use for instance 0.2 and 0.9.",
        )
    first = math.floor(low * lights + 1e-9)
    last = math.ceil(high * lights - 1e-9)
    if last - first < 3:
        raise InvalidInputError(
            f"Trimming to {low:g}-{high:g} keeps {last - first} of {lights} lights; 3 are needed.",
            hint="Trim less, or use plain least squares (method `paper`).",
        )
    return first, last
