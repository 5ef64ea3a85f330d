"""Photometric stereo: normals and albedo from the intensities under known lights (eq. 4-10).

:func:`solve_lambert` is the paper's: least squares over all lights, which are distant.  :func:`solve` is the
default method's: near lights, masks for cast shadows and saturation, robust weights, and the error to expect of
each normal.  The intensities are linear and belong to one virtual view, so that a pixel is the same point of the
sample under every light.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np
from numpy.typing import ArrayLike, NDArray

from reliefscope.errors import InvalidInputError
from reliefscope.models.light_field import LightField
from reliefscope.reconstruction import ps_kernels, ps_robust_kernels
from reliefscope.units import BoolImage, FloatImage

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
DROPPED_SHARE = 0.4
"""Share of the usable lights, the brightest, that the robust form sets aside at first.

A smooth surface throws its highlight toward some lights only, and those are the bright ones.  On the simulated metal
(GGX width 0.35) the median error of normals on planes falls from 15 degrees without to 6.2 with a share of 0.3
and 3.7 with 0.4; on the matt finish it stays at 1.4.
"""
DROPPED_DARK_SHARE = 0.2
"""Share of the lights, the darkest, that is set aside at first where no mask tells cast shadows."""
KEPT_AT_LEAST = 6
"""Lights that are never set aside: twice the number of unknowns."""
REWEIGHTINGS = 2
"""Rounds of Cauchy's weights.  A third changes median errors of normals by less than 0.4 degrees for the better, and by
up to 0.8 (level glossy ground) for the worse."""
SIGMA_PER_MISFIT = 0.6
"""Expected error of a normal, in rad, over the relative deviation of its intensities from Lambert's law."""
SIGMA_PER_CHANGE = 3.95
"""Expected error over the change of the normal per pixel around it: apertures blur, heights that registered the
frames are a little off, and across an edge normals mix."""
SIGMA_PER_SLANT = 0.022
"""Expected error over the sine of twice the slant: light from neighbouring surfaces flattens, gloss steepens."""
SIGMA_PER_ASIDE = 0.25
"""Expected error over the same times the share of the lights that are set aside: those left have gloss, too."""
SIGMA_LEAST_RAD = 0.005
_CHANGE_BLUR_PX = 2.0
_FULL_SCALE_PIXELS = 5000
TOLERATED_RESIDUAL = 0.01
"""Residual, as a fraction of the albedo, that is never held against a light."""


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
    sigma_rad:
        Angle within which about 68 % of the normals lie from the true ones; of the robust form only.
    lights_used:
        Sum of the weights of the lights; of the robust form only.
    """

    normals: FloatImage
    albedo: FloatImage
    residual: FloatImage
    change: FloatImage
    quality: FloatImage
    slant_rad: FloatImage
    sigma_rad: FloatImage | None = None
    lights_used: FloatImage | None = None

    @classmethod
    def empty(cls, shape: tuple[int, int], *, robust: bool = False) -> PsResult:
        """Space for a result of ``shape`` (H, W), to be given as ``out``."""
        normals = np.empty((*shape, 3), np.float32)
        planes = [np.empty(shape, np.float32) for _ in range(5)]
        extra = [np.empty(shape, np.float32) for _ in range(2)] if robust else [None, None]
        return cls(normals, *planes, *extra)


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


def solve(
    images: FloatImage,
    lights: LightField,
    pixel_um: float,
    *,
    lit: BoolImage | None = None,
    plane_um: float = 0.0,
    full_scale: float | None = None,
    maximum_condition: float = MAXIMUM_CONDITION,
    out: PsResult | None = None,
) -> PsResult:
    """Normals, albedo and quality by the robust form; see :mod:`~reliefscope.reconstruction.ps_robust_kernels`.

    Parameters
    ----------
    images:
        (L, H, W) float32, linear, in the view s = 0, as the lights gave them: their powers are in ``lights``.
        NaN is missing.
    lights:
        Where the light of each image came from; near or distant.
    pixel_um:
        Size of a pixel on the sample; the focal point lies in the middle of the image.
    lit:
        (L, H, W) mask, False in cast shadow (:func:`reliefscope.reconstruction.shadows.lit`).  What such pixels
        still receive comes from other surfaces, and tells how much of it lit ones do.  Where fewer than four lights
        arrive, all are used.  None: shadows are not known.
    plane_um:
        Height at which the lights' field is taken.
    full_scale:
        Intensity that counts as 1 in the quality of eq. 10; by default that of :func:`full_scale_of`.
    maximum_condition:
        See :data:`MAXIMUM_CONDITION`.
    out:
        Where the result goes, from :meth:`PsResult.empty` with ``robust=True``; made if left out.

    Raises
    ------
    InvalidInputError
        Too few or badly spread lights, shapes that do not belong together.
    """
    check_directions(lights.directions, maximum_condition)
    stack = _checked_stack(images, len(lights))
    mask = np.ones(stack.shape, np.bool_) if lit is None else lit
    if mask.shape != stack.shape:
        raise InvalidInputError(
            f"A mask of shape {mask.shape} does not belong to images of shape {stack.shape}.",
            hint="Give one mask per image, of its size.",
        )
    shape = (stack.shape[1], stack.shape[2])
    result = PsResult.empty(shape, robust=True) if out is None else out
    assert result.sigma_rad is not None  # space of the robust form
    assert result.lights_used is not None
    if lights.level is None:
        gains = lights.powers.mean() / lights.powers
        knots = _knots(lights.scaled(1.0 / lights.powers), shape, pixel_um, plane_um)
    else:
        stack = lights.over_level(stack)
        gains = np.ones(len(lights))
        knots = _knots(lights, shape, pixel_um, plane_um)
        knots /= knots[..., 2:].copy()
    if full_scale is None:
        step = max(1, math.isqrt(stack[0].size // _FULL_SCALE_PIXELS))
        full_scale = full_scale_of(stack, step=step) * float(np.median(gains))
    ps_robust_kernels.solve_robust(
        stack,
        gains.astype(np.float32),
        knots,
        np.ascontiguousarray(mask),
        DROPPED_SHARE,
        DROPPED_DARK_SHARE if lit is None else 0.0,
        KEPT_AT_LEAST,
        REWEIGHTINGS,
        TOLERATED_RESIDUAL,
        SIGMA_PER_ASIDE / SIGMA_PER_MISFIT,
        result.normals,
        result.albedo,
        result.residual,
        result.sigma_rad,
        result.lights_used,
    )
    _score(result, full_scale)
    change = np.nan_to_num(result.change, nan=CHANGE_SCALE)
    ps_robust_kernels.expected_error(
        np.asarray(cv2.GaussianBlur(change, (0, 0), _CHANGE_BLUR_PX), dtype=np.float32),
        result.slant_rad,
        SIGMA_PER_MISFIT,
        SIGMA_PER_CHANGE,
        SIGMA_PER_SLANT,
        SIGMA_LEAST_RAD,
        result.sigma_rad,
    )
    return result


def solve_lambert(
    images: FloatImage,
    directions: ArrayLike,
    *,
    full_scale: float = 1.0,
    maximum_condition: float = MAXIMUM_CONDITION,
    out: PsResult | None = None,
) -> PsResult:
    """Normals, albedo and quality by least squares over all lights, as the paper has them.

    Parameters
    ----------
    images:
        (L, H, W) float32, linear, of lights of equal power; NaN marks missing pixels.
    directions:
        (L, 3) vectors from the sample to the lights; only their directions count.
    full_scale:
        Intensity that counts as 1 in the quality of eq. 10, see :func:`full_scale_of`.
    maximum_condition:
        See :data:`MAXIMUM_CONDITION`.
    out:
        Where the result goes, from :meth:`PsResult.empty`; made if left out.

    Raises
    ------
    InvalidInputError
        Too few or badly spread lights, shapes that do not belong together.
    """
    unit = check_directions(directions, maximum_condition)
    stack = _checked_stack(images, len(unit))
    shape = (stack.shape[1], stack.shape[2])
    result = PsResult.empty(shape) if out is None else out
    ps_kernels.solve_least_squares(
        stack,
        np.ones(len(unit), np.float32),
        _even_knots(np.linalg.pinv(unit).T, shape),
        _even_knots(unit, shape),
        result.normals,
        result.albedo,
        result.residual,
    )
    _score(result, full_scale)
    return result


def _checked_stack(images: FloatImage, lights: int) -> FloatImage:
    if images.ndim != 3 or len(images) != lights:
        raise InvalidInputError(
            f"{lights} lights do not belong to images of shape {images.shape}.",
            hint="Images have the shape (lights, rows, columns).",
        )
    return np.ascontiguousarray(images, dtype=np.float32)


def _even_knots(vectors: NDArray[np.floating[Any]], shape: tuple[int, int]) -> FloatImage:
    """Vectors (L, 3) that hold everywhere, as the kernels take them."""
    return _knots(LightField(np.asarray(vectors, dtype=np.float64)), shape, 1.0)


def _knots(
    lights: LightField, shape: tuple[int, int], pixel_um: float, plane_um: float = 0.0
) -> FloatImage:
    """Irradiance vectors (L, KR, KC, 3) at the corners of the kernels' blocks, from which they interpolate.

    Between corners 0.15 mm apart and LEDs 20 mm away this is exact to 1e-5.  Heights of 75 um change direction by
    up to 0.2 degrees and strength by up to 1 %, alike for all lights of a ring; they are not followed.
    """
    block = ps_kernels.BLOCK
    rows = np.arange(math.ceil(shape[0] / block) + 1) * block
    columns = np.arange(math.ceil(shape[1] / block) + 1) * block
    x_um = (columns - (shape[1] - 1) / 2) * pixel_um
    y_um = ((shape[0] - 1) / 2 - rows) * pixel_um
    points = np.stack(
        np.broadcast_arrays(x_um[None, :], y_um[:, None], np.float64(plane_um)), axis=-1
    )
    return np.ascontiguousarray(lights.irradiance(points), dtype=np.float32)


def _score(result: PsResult, full_scale: float) -> None:
    ps_kernels.score_quality(
        result.normals,
        result.residual,
        RESIDUAL_SCALE * full_scale,
        SLANT_SCALE_RAD,
        CHANGE_SCALE,
        result.slant_rad,
        result.change,
        result.quality,
    )


def full_scale_of(
    images: FloatImage, percentile: float = FULL_SCALE_PERCENTILE, step: int = 4
) -> float:
    """Intensity of ``images`` (L, H, W) that counts as full scale.

    Eq. 10 weighs the residual against full scale, so it takes the sample for well exposed.  Behind a leaking
    glass it never is: the shut pixels fill a large part of the camera's range, and the frames that are left
    after the subtraction of their light reach a fraction of it.  Full scale is therefore where a well
    exposed frame would have it: at the level that the brightest twentieth of the sample exceeds, so that highlights
    may clip and the matte part fills the range.  Every ``step``-th row and column is looked at.
    """
    level = float(np.nanpercentile(images[:, ::step, ::step], percentile))
    return level if level > 0.0 else 1.0
