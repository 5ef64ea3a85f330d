"""Directions of lights from files: a small YAML tells which photographs show which sphere."""

from __future__ import annotations

import math
import string
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, model_validator

from reliefscope import axes
from reliefscope.calibration.light_probe import (
    Sphere,
    angular_difference_deg,
    direction_of_highlight,
    find_highlight,
    fit_circle,
    mean_directions,
)
from reliefscope.dataset.import_spec import Circle, Index
from reliefscope.dataset.pictures import read_picture
from reliefscope.dataset.spec import Vector2
from reliefscope.errors import InvalidInputError
from reliefscope.jobs import Job, ensure_job
from reliefscope.models.base import StrictModel


class ProbeEntry(StrictModel):
    """One sphere, photographed under every light.

    Polished metal and black glass are the same to it: both show the lights by reflection.
    """

    circle: Circle | None = None
    """Outline of the sphere."""
    outline: Annotated[tuple[Vector2, ...], Field(min_length=3)] | None = None
    """Points [column, row] on the outline instead, row 0 on top."""
    folder: str = "."
    """Where the files are, relative to the description."""
    pattern: str | None = None
    """File name with ``{light}``, e.g. ``Image_{light:02d}.png``."""
    files: Annotated[tuple[str, ...], Field(min_length=1)] | None = None
    """File names in the order of the lights, instead of a pattern."""

    @model_validator(mode="after")
    def _one_of_each(self) -> ProbeEntry:
        if (self.circle is None) == (self.outline is None):
            raise ValueError("give either `circle` or `outline` (points on it)")
        if (self.pattern is None) == (self.files is None):
            raise ValueError("give either `files` (a list) or `pattern` (a file name)")
        if self.pattern is not None:
            try:
                used = {name for _, name, _, _ in string.Formatter().parse(self.pattern)} - {None}
                self.pattern.format(light=0)
            except (ValueError, IndexError, KeyError) as error:
                raise ValueError(
                    f"pattern `{self.pattern}` is no valid pattern: {error}"
                ) from error
            if used != {"light"}:
                raise ValueError(f"pattern `{self.pattern}` must hold {{light}}")
        return self

    def sphere(self) -> Sphere:
        """Outline in pixels."""
        if self.circle is not None:
            return Sphere(self.circle.column, self.circle.row, self.circle.radius_px)
        assert self.outline is not None  # the validator holds it
        columns, rows = zip(*self.outline, strict=True)
        return fit_circle(columns, rows)


class LightProbeSet(StrictModel):
    """Content of the description file of ``reliefscope light-probe``."""

    schema_version: Literal[1] = 1
    lights: Annotated[int, Field(ge=1)]
    """Number of lights."""
    first: Index = 0
    """Number that the first light has in a ``pattern``."""
    probes: Annotated[tuple[ProbeEntry, ...], Field(min_length=1)]

    @model_validator(mode="after")
    def _every_light(self) -> LightProbeSet:
        for number, probe in enumerate(self.probes):
            if probe.files is not None and len(probe.files) != self.lights:
                raise ValueError(
                    f"probes.{number}.files are {len(probe.files)}, but there are {self.lights} lights"
                )
        return self

    def files(self, probe: ProbeEntry) -> tuple[str, ...]:
        """Photographs of a probe in the order of the lights."""
        if probe.files is not None:
            return probe.files
        assert probe.pattern is not None  # the validator holds it
        return tuple(probe.pattern.format(light=self.first + k) for k in range(self.lights))


@dataclass(frozen=True, slots=True)
class ProbedLights:
    """Directions of L lights from P probes.

    Attributes
    ----------
    directions:
        (L, 3) unit vectors toward the lights, y up: the mean of the probes.
    estimates:
        (P, L, 3) what each probe gave.
    photographs:
        (L,) files of the first probe, to tell the lights by.
    given:
        (L, 3) directions to compare with, None where there are none.
    """

    directions: NDArray[np.float64]
    estimates: NDArray[np.float64]
    photographs: tuple[str, ...]
    given: NDArray[np.float64] | None = None

    @property
    def disagreement_deg(self) -> NDArray[np.float64] | None:
        """Greatest angle (L,) between what two probes gave; None of a single probe."""
        pairs = [angular_difference_deg(a, b) for a, b in combinations(self.estimates, 2)]
        return np.max(pairs, axis=0) if pairs else None

    @property
    def difference_deg(self) -> NDArray[np.float64] | None:
        """Angle (L,) to the given directions."""
        return None if self.given is None else angular_difference_deg(self.directions, self.given)

    def rows(self) -> list[dict[str, Any]]:
        """One row per light, for people and programs; angles in degrees."""
        apart, difference = self.disagreement_deg, self.difference_deg
        rows = []
        for light, vector in enumerate(self.directions):
            elevation, azimuth = axes.elevation_azimuth(vector)
            rows.append(
                {
                    "light": light,
                    "photograph": self.photographs[light],
                    "direction": [round(float(value), 5) for value in vector],
                    "elevation_deg": round(math.degrees(elevation), 3),
                    "azimuth_deg": round(math.degrees(azimuth) % 360.0, 3),
                    "disagreement_deg": None if apart is None else round(float(apart[light]), 3),
                    "difference_deg": (
                        None if difference is None else round(float(difference[light]), 3)
                    ),
                }
            )
        return rows


def probe_lights(
    description: LightProbeSet,
    folder: Path,
    given: NDArray[np.float64] | None = None,
    job: Job | None = None,
) -> ProbedLights:
    """Find the highlights in the photographs and average the directions over the probes.

    Parameters
    ----------
    description:
        Spheres and files.
    folder:
        What the folders of the probes are relative to.
    given:
        (L, 3) directions to compare with.
    job:
        Progress and cancellation, per photograph.

    Raises
    ------
    InvalidInputError
        A photograph that cannot be read or shows no highlight, a light below the sample plane, or
        another number of given directions; the message names it.
    """
    if given is not None and len(given) != description.lights:
        raise InvalidInputError(
            f"There are {len(given)} directions to compare {description.lights} lights with.",
            hint="Give one direction for every light, in the same order.",
        )
    estimates = np.empty((len(description.probes), description.lights, 3))
    with ensure_job(job).stage("find highlights", estimates.shape[0] * description.lights) as stage:
        for number, probe in enumerate(description.probes):
            sphere = probe.sphere()
            for light, name in enumerate(description.files(probe)):
                estimates[number, light] = _direction(folder / probe.folder / name, sphere)
                stage.advance(note=name)
    return ProbedLights(
        mean_directions(list(estimates)),
        estimates,
        tuple(Path(name).name for name in description.files(description.probes[0])),
        given,
    )


def _direction(path: Path, sphere: Sphere) -> NDArray[np.float64]:
    pixels, _ = read_picture(
        path, hint="Check `folder`, `files` or `pattern`, `lights` and `first` in the description."
    )
    try:
        direction = direction_of_highlight(find_highlight(pixels, sphere), sphere)
    except InvalidInputError as error:
        raise InvalidInputError(f"{path}: {error.message}", hint=error.hint) from None
    if direction[2] <= 0.0:
        raise InvalidInputError(
            f"{path}: the highlight is so near the rim that its light would lie below the sample plane.",
            hint="Check centre and radius of the sphere, and that nothing else is mirrored there.",
        )
    return direction
