"""Every choice of a reconstruction in one model, saved with its result."""

from __future__ import annotations

import difflib
from pathlib import Path
from typing import Annotated, Any, Literal, Self, get_args

from pydantic import Field, model_validator

from reliefscope.errors import InvalidInputError
from reliefscope.models.base import StrictModel, load_model
from reliefscope.reconstruction import fusion, joint, mvs

Method = Literal["joint", "paper"]
Fraction = Annotated[float, Field(ge=0.0, le=1.0)]
Positive = Annotated[float, Field(gt=0.0, allow_inf_nan=False)]


class JointSettings(StrictModel):
    """Choices of the method ``joint`` (:mod:`~reliefscope.reconstruction.joint_chain`)."""

    stereo_quality: Fraction = joint.QUALITY_THRESHOLD
    """Heights of a lower quality are discarded."""
    occlusion: bool = True
    """Leave a view out where the surface hides the point from it."""
    shadows: bool = True
    """Leave a light out where the height puts the point into its shadow."""
    photometric_quality: Fraction = 0.25
    """Normals of a lower quality count as doubtful; without heights to weigh them against they are left out."""
    colour: bool = False
    """Albedo in red, green and blue besides, where the sensor sees colour; reads one view again."""


class PaperSettings(StrictModel):
    """Choices of the method ``paper`` (:mod:`~reliefscope.reconstruction.paper_chain`).

    The defaults are section III of the paper, read as docs/explanation/method.md says.
    """

    height_step_um: Positive = 1.0
    """Distance between neighbouring candidate heights."""
    window: Annotated[int, Field(ge=3, le=101)] = mvs.WINDOW
    """Side of the correlation window in pixels, odd."""
    parabola: bool = False
    """Heights between the steps, from a parabola through the peak; the paper takes the step itself."""
    stereo_quality: Fraction = mvs.QUALITY_THRESHOLD
    """Heights of a lower quality are discarded and filled by smoothing."""
    smoothing_parameter: Positive | None = None
    """Garcia's s; None: by generalised cross-validation."""
    full_scale: Positive | None = None
    """Intensity that counts as 1 in eq. 10; None: what a twentieth of the images exceeds."""
    photometric_quality: Fraction = 0.25
    """Normals of a lower quality are discarded."""
    lam: Positive = fusion.LAMBDA_RAD_PER_UM
    """lambda of eq. 12, rad / um."""
    derivative: fusion.Derivative = "sobel_stabilised"
    """Form of the slope equations; ``sobel`` is eq. 13 to the letter."""
    minimum_quality: Fraction = fusion.MINIMUM_QUALITY
    """Weight that every finite height keeps in the fusion."""
    tolerance_um: Positive | None = None
    """Estimated RMS distance to the exact minimum at which the solver stops; None: a hundredth of a pixel."""

    @model_validator(mode="after")
    def _odd(self) -> Self:
        if self.window % 2 == 0:
            raise ValueError(f"window must be odd, not {self.window}")
        return self


class Settings(StrictModel):
    """Settings of :func:`reliefscope.reconstruction.pipeline.reconstruct`.

    What belongs to one method stands in the part of its name; the part of the other cannot be changed.
    """

    method: Method = "joint"
    use: Literal["auto", "stereo", "photometric"] = "auto"
    """``auto``: stereo where there are two views or more, photometric where there are two lights or more."""
    height_range_um: tuple[float, float] | None = None
    """Lowest and highest height searched; None: as the run says."""
    joint: JointSettings = JointSettings()
    paper: PaperSettings = PaperSettings()

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        if self.height_range_um is not None and not (
            self.height_range_um[0] < self.height_range_um[1]
        ):
            raise ValueError("height_range_um must be [lowest, highest]")
        for part, standard in (("joint", JointSettings()), ("paper", PaperSettings())):
            if part != self.method and getattr(self, part) != standard:
                raise ValueError(f"`{part}` must be left out with `method: {self.method}`")
        return self

    @property
    def chosen(self) -> JointSettings | PaperSettings:
        """The part of the method."""
        return self.joint if self.method == "joint" else self.paper

    def as_dict(self) -> dict[str, Any]:
        """What holds, for files: without the part of the other method."""
        unused = {"joint", "paper"} - {self.method}
        return self.model_dump(mode="json", exclude=unused)


METHODS: tuple[str, ...] = get_args(Method)


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
    return Settings.model_validate({"method": method})


def load_settings(path: Path) -> Settings:
    """Settings from a YAML file; keys left out keep their defaults."""
    return load_model(Settings, path)
