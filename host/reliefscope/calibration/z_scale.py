"""Calibration of z: a flat target on a stage, measured at known heights (paper, section IV.A).

Multi-view stereo measures the height of the target with the whole image as its window.  Against the reading of
the stage the measured heights lie on a line; its slope tells by how much the slopes of the views are wrong as a
whole, that is the pupil scale (s = a / (pupil_scale f_o)), and the scatter about it is a lower bound on the error
of matching.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np
from numpy.typing import ArrayLike, NDArray

from reliefscope.dataset import Run
from reliefscope.errors import InvalidInputError
from reliefscope.jobs import Job
from reliefscope.models.calibration import Calibration
from reliefscope.reconstruction.mvs import ImageMatch, match_image
from reliefscope.units import FloatImage

DEFAULT_RANGE_UM = (-75.0, 75.0)
"""Heights that are searched where a run does not tell."""
_RANGE_FACTOR = 1.3
"""A pupil scale of 1.3, and a stage whose zero is not the focal plane, stay within the search."""
_SMOOTHING_PX = 1.5
"""Sigma of a Gaussian over the views, below their blur by the aperture.  What is finer is noise; interpolation weakens
it by the fraction of the shift, and unsmoothed it draws heights by up to 0.1 um."""
_COARSE_PX = 4
_COARSE_STEP_UM = 4.0
_FINE_STEP_UM = 1.0
_FINE_REACH_UM = 5.0
_LEAST_PEAK = 0.5
"""Mean NCC over the whole image below which it does not show one flat target."""


@dataclass(frozen=True, slots=True)
class ZScale:
    """A line through the heights (N,) that were measured at the readings (N,) of the stage."""

    stage_um: NDArray[np.float64]
    measured_um: NDArray[np.float64]
    slope: float
    """Measured over true height."""
    slope_error: float
    """Standard error of the slope."""
    offset_um: float
    """Measured height where the stage reads 0."""
    pupil_scale: float
    """Pupil scale with which the slope is 1."""
    former_pupil_scale: float
    """The one that the heights were measured with."""

    @property
    def residual_um(self) -> NDArray[np.float64]:
        """(N,) distance from the line, as true height."""
        residual: NDArray[np.float64] = (
            self.measured_um - self.offset_um
        ) / self.slope - self.stage_um
        return residual

    @property
    def rms_um(self) -> float:
        """Root mean square of the residuals; the paper's is 1.9 um."""
        return math.sqrt(float(np.square(self.residual_um).mean()))

    def calibrated(self, calibration: Calibration, created: str) -> Calibration:
        """``calibration``, with which the heights were measured, corrected to this z scale."""
        return calibration.model_copy(
            update={"pupil_scale": self.pupil_scale, "source": "measured", "created": created}
        )

    def facts(self) -> dict[str, Any]:
        """Figures for people and programs."""
        return {
            "heights": int(self.stage_um.size),
            "pupil_scale": round(self.pupil_scale, 5),
            "pupil_scale_error": round(self.pupil_scale * self.slope_error / self.slope, 5),
            "former_pupil_scale": round(self.former_pupil_scale, 5),
            "slope": round(self.slope, 5),
            "offset_um": round(self.offset_um, 3),
            "residual_rms_um": round(self.rms_um, 3),
            "residual_greatest_um": round(float(np.abs(self.residual_um).max()), 3),
        }


def fit_z_scale(stage_um: ArrayLike, measured_um: ArrayLike, pupil_scale: float = 1.0) -> ZScale:
    """Line by least squares through measured heights against readings of the stage.

    Parameters
    ----------
    stage_um, measured_um:
        (N,) readings of the stage and heights found there; at least three, at two different readings or more.
    pupil_scale:
        The one with which the heights were measured.

    Raises
    ------
    InvalidInputError
        Too few heights, or ones that do not rise with the stage.
    """
    stage = np.asarray(stage_um, dtype=np.float64)
    measured = np.asarray(measured_um, dtype=np.float64)
    if stage.size < 3 or stage.shape != measured.shape or np.ptp(stage) == 0:
        raise InvalidInputError(
            f"{stage.size} heights do not make a line.",
            hint="Take at least three heights of the stage; the paper's steps are 10 um.",
        )
    centred = stage - stage.mean()
    spread = float(centred @ centred)
    slope = float(centred @ measured) / spread
    offset = float(measured.mean() - slope * stage.mean())
    if slope <= 0:
        raise InvalidInputError(
            f"The measured height falls as the stage rises ({slope:.3f} um per um).",
            hint="Give heights that grow toward the objective; if they do, the glass is mounted or calibrated "
            "the wrong way round.",
        )
    residual = measured - offset - slope * stage
    variance = float(residual @ residual) / max(stage.size - 2, 1)
    return ZScale(
        stage,
        measured,
        slope,
        math.sqrt(variance / spread),
        offset,
        pupil_scale / slope,
        pupil_scale,
    )


def measure_height(run: Run, job: Job | None = None) -> ImageMatch:
    """Height of the flat target that a run shows, by matching whole images.

    The heights that the run is good for, and a third more, are searched in coarse steps on reduced images, then
    the neighbourhood of the best at full size.

    Raises
    ------
    InvalidInputError
        The run has no calibrated views, its target is out of range, or it is not flat.
    """
    slopes = run.views
    if slopes is None:
        raise InvalidInputError(
            f"{run.path} does not know the slopes of its views.",
            hint="Give them in its description and import it again.",
        )
    views = _views(run)
    low, high = run.height_range_um or DEFAULT_RANGE_UM
    middle, half = (low + high) / 2, _RANGE_FACTOR * (high - low) / 2
    coarse = np.arange(middle - half, middle + half + _COARSE_STEP_UM / 2, _COARSE_STEP_UM)
    factor = _COARSE_PX if min(run.shape) >= 100 * _COARSE_PX else 1
    reduced = views if factor == 1 else np.stack([_reduced(view, factor) for view in views])
    first = match_image(reduced, slopes, coarse, factor * run.pixel_um, job)
    if not coarse[0] < first.height_um < coarse[-1]:
        raise InvalidInputError(
            f"{run.path} shows no height between {coarse[0]:.0f} and {coarse[-1]:.0f} um.",
            hint="Bring the target nearer to the focal plane.",
        )
    if first.peak < _LEAST_PEAK:
        raise InvalidInputError(
            f"The views of {run.path} do not agree at any one height (best mean NCC {first.peak:.2f}).",
            hint="Use a flat target with texture, level, such as the 200 um grid.",
        )
    fine = first.height_um + np.arange(
        -_FINE_REACH_UM, _FINE_REACH_UM + _FINE_STEP_UM / 2, _FINE_STEP_UM
    )
    return match_image(views, slopes, fine, run.pixel_um, job)


def common_calibration(runs: Sequence[Run]) -> Calibration:
    """The calibration that all runs were taken with.

    Raises
    ------
    InvalidInputError
        A run was imported, or runs were taken with different calibrations.
    """
    first = runs[0].calibration
    for run in runs:
        if run.calibration is None:
            raise InvalidInputError(
                f"{run.path} was imported; there is no instrument to calibrate.",
                hint="Calibrate z with runs that the instrument took.",
            )
        if run.calibration != first:
            raise InvalidInputError(
                f"{run.path} was taken with another calibration than {runs[0].path}.",
                hint="Take all heights anew in one go: `reliefscope calibrate z --device URL`.",
            )
    assert first is not None  # the loop above looked at it
    return first


def _views(run: Run) -> FloatImage:
    """Smoothed mean over the lights (K, H, W) of every view."""
    count = len(run.light_names)
    views = np.zeros((len(run.view_names), *run.shape), dtype=np.float32)
    for index, _, image in run.stack():
        views[index] += image / np.float32(count)
    smooth = [cv2.GaussianBlur(image, (0, 0), _SMOOTHING_PX) for image in views]
    return np.asarray(smooth, dtype=np.float32)


def _reduced(image: FloatImage, factor: int) -> FloatImage:
    rows, columns = (size // factor for size in image.shape)
    kept = image[: rows * factor, : columns * factor]
    return np.asarray(cv2.resize(kept, (columns, rows), interpolation=cv2.INTER_AREA), np.float32)
