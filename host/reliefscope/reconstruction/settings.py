"""Every choice of a reconstruction in one model, saved with its result."""

from __future__ import annotations

import difflib
from pathlib import Path
from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from reliefscope.errors import InvalidInputError
from reliefscope.models.base import StrictModel, load_model
from reliefscope.reconstruction import fusion, joint, mvs

Fraction = Annotated[float, Field(ge=0.0, le=1.0)]
Positive = Annotated[float, Field(gt=0.0, allow_inf_nan=False)]


class Settings(StrictModel):
    """Settings of :func:`reliefscope.reconstruction.pipeline.reconstruct`.

    The defaults are the method ``paper``: section III of the paper, read as docs/explanation says.
    """

    method: str = "paper"
    """Name under which results and tables show these settings."""
    use: Literal["auto", "stereo", "photometric"] = "auto"
    """``auto``: stereo where there are two views or more, photometric where there are two lights or more."""

    height_range_um: tuple[float, float] | None = None
    """Lowest and highest height searched; None: as the run says."""
    matching: Literal["pairs", "joint"] = "pairs"
    """``pairs``: eq. 3 on the mean over the lights.  ``joint``: groups of lights together, coarser and faster
    (:mod:`~reliefscope.reconstruction.joint`); ``height_step_um``, ``window`` and ``parabola`` are its own."""
    height_step_um: Positive = 1.0
    window: Annotated[int, Field(ge=3, le=101)] = mvs.WINDOW
    """Side of the correlation window in pixels, odd."""
    parabola: bool = False
    """Heights between the steps, from a parabola through the peak; the paper takes the step itself."""
    stereo_quality: Fraction = mvs.QUALITY_THRESHOLD
    """Heights of a lower quality are discarded and filled by smoothing."""
    smoothing_parameter: Positive | None = None
    """Garcia's s; None: by generalised cross-validation."""

    photometric_views: Literal["all", "nearest"] = "all"
    """Frames whose mean photometric stereo uses: of all views, or of the one nearest to s = 0."""
    occlusion: bool = False
    """Leave a view out where the surface hides the point from it."""
    trim: tuple[Fraction, Fraction] | None = None
    """Share of the lights, darkest first, between which intensities count; None: all lights."""
    full_scale: Positive | None = None
    """Intensity that counts as 1 in eq. 10; None: what a twentieth of the images exceeds."""
    photometric_quality: Fraction = 0.25
    """Normals of a lower quality are discarded."""

    lam: Positive = fusion.LAMBDA_RAD_PER_UM
    """lambda of eq. 12, rad / um."""
    derivative: fusion.Derivative = "sobel_stabilised"
    """Form of the slope equations; ``sobel`` is eq. 13 to the letter."""
    minimum_quality: Fraction = fusion.MINIMUM_QUALITY
    tolerance_um: Positive | None = None
    """Estimated RMS distance to the exact minimum at which the solver stops; None: a hundredth of a pixel."""

    frames_in_memory_mb: Annotated[int, Field(ge=0)] = 1500
    """Runs whose frames take more, as float32, are read twice instead of kept."""

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        if self.window % 2 == 0:
            raise ValueError(f"window must be odd, not {self.window}")
        if self.height_range_um is not None and not (
            self.height_range_um[0] < self.height_range_um[1]
        ):
            raise ValueError("height_range_um must be [lowest, highest]")
        if self.trim is not None and not self.trim[0] < self.trim[1]:
            raise ValueError("trim must be [low, high], fractions of the lights")
        return self


METHODS: dict[str, Settings] = {
    "paper": Settings(),
    "robust": Settings(method="robust", parabola=True, trim=(0.2, 0.9)),
    "joint": Settings(
        method="joint",
        matching="joint",
        stereo_quality=joint.QUALITY_THRESHOLD,
        trim=(0.2, 0.9),
    ),
}


def settings_for(method: str) -> Settings:
    """Settings of a method by its name.

    Raises
    ------
    InvalidInputError
        No such method; the hint names the nearest one.
    """
    if method not in METHODS:
        nearest = difflib.get_close_matches(method, METHODS, n=1)
        raise InvalidInputError(
            f"There is no reconstruction method `{method}`.",
            hint=f"Did you mean `{nearest[0]}`?" if nearest else f"Methods: {', '.join(METHODS)}.",
        )
    return METHODS[method]


def load_settings(path: Path) -> Settings:
    """Settings from a YAML file; keys left out keep the values of the method ``paper``."""
    return load_model(Settings, path)
