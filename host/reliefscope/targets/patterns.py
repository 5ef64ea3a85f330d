"""Flat targets: the square grid for the z calibration and the stage micrometre for the pixel size."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from reliefscope.axes import pixel_grid_um
from reliefscope.units import FloatImage


def grid_coverage(
    shape: tuple[int, int], pixel_um: float, pitch_um: float = 200.0, line_um: float = 20.0
) -> FloatImage:
    """Fraction (H, W) of each pixel covered by the lines of a square grid; a crossing lies in the middle."""
    x_um, y_um = pixel_grid_um(shape, pixel_um)
    across = _line_coverage(x_um, pixel_um, pitch_um, line_um)
    down = _line_coverage(y_um, pixel_um, pitch_um, line_um)
    covered: FloatImage = 1 - (1 - across)[None, :] * (1 - down)[:, None]
    return covered


def scale_coverage(
    shape: tuple[int, int], pixel_um: float, division_um: float = 10.0, line_um: float = 2.0
) -> FloatImage:
    """Fraction (H, W) of each pixel covered by the marks of a stage micrometre along x.

    Every mark is 40 um long, every fifth 60 um, every tenth 80 um; the middle of the image is a tenth mark.
    """
    x_um, y_um = pixel_grid_um(shape, pixel_um)
    covered: FloatImage = np.zeros(shape, dtype=np.float32)
    for every, length_um in ((1, 40.0), (5, 60.0), (10, 80.0)):
        marks = _line_coverage(x_um, pixel_um, division_um * every, line_um)
        within = (np.abs(y_um) <= length_um / 2).astype(np.float32)
        covered = np.maximum(covered, within[:, None] * marks[None, :])
    return covered


def _line_coverage(
    position_um: NDArray[np.float64], pixel_um: float, pitch_um: float, line_um: float
) -> FloatImage:
    """Covered fraction of pixels at ``position_um`` by lines at the multiples of ``pitch_um``."""
    distance = np.abs(position_um - np.round(position_um / pitch_um) * pitch_um)
    coverage: FloatImage = np.clip(
        (line_um / 2 - distance) / pixel_um + 0.5, 0.0, min(1.0, line_um / pixel_um)
    ).astype(np.float32)
    return coverage
