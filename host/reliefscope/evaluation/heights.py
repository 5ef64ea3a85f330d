"""Mean absolute error of heights after three alignments.

Every pixel of a section counts; where a height is missing its error is :data:`MISSING_UM`.  Nothing is eroded,
so that walls and edges, which are the hard part, are in the figure.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from reliefscope import axes
from reliefscope.errors import InvalidInputError
from reliefscope.units import BoolImage

MISSING_UM = 100.0
"""Error of a pixel without height."""


@dataclass(frozen=True, slots=True)
class HeightErrors:
    """Mean absolute errors of one section, um.

    Attributes
    ----------
    raw_um:
        As it is.
    offset_um:
        After the median of the section's errors is taken off.
    plane_um:
        After a plane in x and y is fitted to the section's errors by least squares and taken off.
    coverage:
        Share of the section's pixels that have a height.
    pixels:
        Pixels of the section.
    """

    raw_um: float
    offset_um: float
    plane_um: float
    coverage: float
    pixels: int


def height_errors(
    height_um: NDArray[np.floating[Any]],
    truth_um: NDArray[np.floating[Any]],
    section: BoolImage,
) -> HeightErrors:
    """Errors of ``height_um`` (H, W) against ``truth_um`` (H, W) over the pixels of ``section`` (H, W).

    Raises
    ------
    InvalidInputError
        Shapes that differ, or a section without a pixel.
    """
    if height_um.shape != truth_um.shape or section.shape != truth_um.shape:
        raise InvalidInputError(
            f"A height map of shape {height_um.shape} does not belong to a truth of shape {truth_um.shape}.",
            hint="Make the truth for the shape and the pixel size of the result.",
        )
    pixels = int(section.sum())
    if pixels == 0:
        raise InvalidInputError(
            "The section does not lie in the field of view.",
            hint="Evaluate a run that shows the whole fiducial, or a section that it shows.",
        )
    known = section & np.isfinite(height_um)
    error = (height_um[known].astype(np.float64)) - truth_um[known]
    x_um, y_um = axes.pixel_grid_um(section.shape, 1.0)
    rows, columns = np.nonzero(known)

    def mean(residual: NDArray[np.float64]) -> float:
        total = float(np.abs(residual).sum()) + MISSING_UM * (pixels - residual.size)
        return total / pixels

    if error.size == 0:
        return HeightErrors(MISSING_UM, MISSING_UM, MISSING_UM, 0.0, pixels)
    plane = np.stack([np.ones(error.size), x_um[columns], y_um[rows]], axis=1)
    coefficients = np.linalg.lstsq(plane, error, rcond=None)[0]
    return HeightErrors(
        raw_um=mean(error),
        offset_um=mean(error - np.median(error)),
        plane_um=mean(error - plane @ coefficients),
        coverage=error.size / pixels,
        pixels=pixels,
    )
