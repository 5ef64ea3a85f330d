"""Directions of lights from photographs of a mirroring sphere.

Where a sphere shows the highlight of a light, its normal n halves the angle between the direction v to the
camera and the direction l to the light: ``l = 2 (n . v) n - v``.  The camera looks along -z (v = z, telecentric
or far away) and the light is far away, or all lights are at the same distance and the sphere is small.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np
from numpy.typing import ArrayLike, NDArray

from reliefscope.errors import InvalidInputError

Image = NDArray[np.floating[Any]] | NDArray[np.unsignedinteger[Any]]

_INSIDE = 0.97
"""Part of the radius within which highlights are looked for: the rim mirrors what lies behind the sphere."""
_CORE = 0.7
"""Share of the highlight's peak from which pixels count for its centre."""
_LEAST_CONTRAST = 3.0
"""Ratio of the highlight to the mean of the sphere below which there is no highlight."""


@dataclass(frozen=True, slots=True)
class Sphere:
    """Outline of the sphere in pixels: column and row of its centre (row 0 on top) and radius."""

    column: float
    row: float
    radius: float


def fit_circle(columns: ArrayLike, rows: ArrayLike) -> Sphere:
    """Circle through points on the outline, by algebraic least squares.

    Raises
    ------
    InvalidInputError
        Fewer than three points, or points on a line.
    """
    x = np.asarray(columns, dtype=np.float64)
    y = np.asarray(rows, dtype=np.float64)
    if x.shape != y.shape or x.ndim != 1 or x.size < 3:
        raise InvalidInputError(
            "A circle needs at least three points.", hint="Mark points all around the sphere."
        )
    middle_x, middle_y = float(x.mean()), float(y.mean())
    u, v = x - middle_x, y - middle_y
    matrix = np.stack([2 * u, 2 * v, np.ones_like(u)], axis=1)
    solution, _, rank, _ = np.linalg.lstsq(matrix, u * u + v * v, rcond=1e-9)
    if rank < 3:
        raise InvalidInputError(
            "The points lie on a line; no circle goes through them.",
            hint="Mark points all around the sphere.",
        )
    a, b, c = (float(value) for value in solution)
    return Sphere(a + middle_x, b + middle_y, math.sqrt(c + a * a + b * b))


def find_highlight(image: Image, sphere: Sphere) -> tuple[float, float]:
    """Column and row of the highlight's centre.

    The place is found in a blurred image, where a compact highlight beats streaks and grains of dust; its
    centre is the centroid of what is nearly as bright and connected to it.

    Raises
    ------
    InvalidInputError
        The sphere does not lie in the image or shows no highlight.
    """
    grey = np.asarray(image, dtype=np.float32)
    if grey.ndim == 3:
        grey = grey.mean(axis=-1)
    rows, columns = np.indices(grey.shape)
    inside = np.hypot(columns - sphere.column, rows - sphere.row) <= _INSIDE * sphere.radius
    if not inside.any():
        raise InvalidInputError(
            "The sphere does not lie in the photograph.",
            hint="Give centre and radius in pixels of this photograph, row 0 on top.",
        )
    masked = np.where(inside, grey, np.float32(0))
    blurred = cv2.GaussianBlur(masked, (0, 0), max(1.0, 0.02 * sphere.radius)).astype(np.float32)
    peak_row, peak_column = np.unravel_index(int(np.argmax(blurred)), blurred.shape)
    peak = float(blurred[peak_row, peak_column])
    if not peak > _LEAST_CONTRAST * float(grey[inside].mean()):
        raise InvalidInputError(
            "The sphere shows no highlight.",
            hint="Check that the light was on and that the sphere mirrors.",
        )
    _, found = cv2.connectedComponents((blurred >= _CORE * peak).astype(np.uint8))
    labels = np.asarray(found)
    core_rows, core_columns = np.nonzero(labels == labels[peak_row, peak_column])
    weight = blurred[core_rows, core_columns].astype(np.float64)
    return (
        float(np.average(core_columns, weights=weight)),
        float(np.average(core_rows, weights=weight)),
    )


def direction_of_highlight(highlight: tuple[float, float], sphere: Sphere) -> NDArray[np.float64]:
    """Unit vector (3,) from the sample to the light whose highlight is at (column, row); y up.

    Raises
    ------
    InvalidInputError
        The highlight lies outside the sphere.
    """
    nx = (highlight[0] - sphere.column) / sphere.radius
    ny = (sphere.row - highlight[1]) / sphere.radius
    if nx * nx + ny * ny >= 1.0:
        raise InvalidInputError(
            f"A highlight at ({highlight[0]:.1f}, {highlight[1]:.1f}) lies outside the sphere.",
            hint="Check centre and radius of the sphere.",
        )
    nz = math.sqrt(1.0 - nx * nx - ny * ny)
    return np.array([2 * nz * nx, 2 * nz * ny, 2 * nz * nz - 1.0])


def calibrate_lights(images: Sequence[Image], sphere: Sphere) -> NDArray[np.float64]:
    """Directions (L, 3) of the lights of L photographs of one sphere.

    Raises
    ------
    InvalidInputError
        A photograph without a highlight; the message counts photographs from 0.
    """
    directions = []
    for index, image in enumerate(images):
        try:
            directions.append(direction_of_highlight(find_highlight(image, sphere), sphere))
        except InvalidInputError as error:
            raise InvalidInputError(
                f"Photograph {index}: {error.message}", hint=error.hint
            ) from None
    return np.array(directions)


def mean_directions(estimates: Sequence[NDArray[np.float64]]) -> NDArray[np.float64]:
    """Unit mean (L, 3) of the directions that several spheres gave."""
    total = np.sum(np.asarray(estimates), axis=0)
    mean: NDArray[np.float64] = total / np.linalg.norm(total, axis=-1, keepdims=True)
    return mean


def angular_difference_deg(first: ArrayLike, second: ArrayLike) -> NDArray[np.float64]:
    """Angle (L,) in degrees between directions (L, 3), of any length."""
    a = np.asarray(first, dtype=np.float64)
    b = np.asarray(second, dtype=np.float64)
    sine = np.linalg.norm(np.cross(a, b), axis=-1)
    cosine = np.sum(a * b, axis=-1)
    return np.asarray(np.degrees(np.arctan2(sine, cosine)))
