"""Description of a stack of images focused at different heights: the file ``stack.yml`` beside them."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Annotated, Literal, Protocol

from pydantic import Field, model_validator

from reliefscope.jobs import Job
from reliefscope.models.base import StrictModel

STACK_FILE = "stack.yml"


class StackPlane(StrictModel):
    """One image of a stack."""

    file: str
    """Relative to the description."""
    height_um: float
    """Height in the sample that is in focus."""


class ZStack(StrictModel):
    """Images of one sample, lowest plane of focus first, all of one size."""

    schema_version: Literal[1] = 1
    pixel_um: Annotated[float, Field(gt=0)] | None = None
    """Size of a pixel on the sample, where it is known."""
    instrument: str = ""
    sample: str = ""
    transfer: Literal["linear", "srgb"] = "linear"
    """Whether counts are proportional to light or follow the sRGB curve."""
    planes: Annotated[tuple[StackPlane, ...], Field(min_length=3)]

    @model_validator(mode="after")
    def _upward(self) -> ZStack:
        heights = [plane.height_um for plane in self.planes]
        if any(after <= before for before, after in pairwise(heights)):
            raise ValueError("planes must be in the order of height_um, each above the one before")
        return self


class StackRecorder(Protocol):
    """Takes a stack of what lies under the instrument of a URL with a conventional microscope.

    A package that can, registers one in the entry point group ``reliefscope.z_stacks`` under the scheme of its
    URLs.  The folder ``out`` is new and receives the images and :data:`STACK_FILE`.
    """

    def __call__(self, url: str, out: Path, *, field_um: float | None, job: Job | None) -> ZStack:
        """``field_um`` is the side of the central square to take; None: all that the instrument sees."""
        ...
