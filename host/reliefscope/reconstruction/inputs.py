"""What a reconstruction reads, checked before a frame is read."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from reliefscope.errors import InvalidInputError
from reliefscope.models.light_field import LightField
from reliefscope.models.plan import FrameKind
from reliefscope.reconstruction import photometric
from reliefscope.reconstruction.settings import Settings
from reliefscope.units import BoolImage, FloatImage


class Frames(Protocol):
    """What a reconstruction reads; :class:`reliefscope.dataset.Run` has it all."""

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns of a frame."""

    @property
    def pixel_um(self) -> float:
        """Size of a pixel on the sample."""

    @property
    def height_range_um(self) -> tuple[float, float] | None:
        """Heights worth searching, where known."""

    @property
    def view_names(self) -> tuple[str, ...]:
        """Names of the views."""

    @property
    def light_names(self) -> tuple[str, ...]:
        """Names of the lights."""

    @property
    def views(self) -> NDArray[np.float64] | None:
        """Slopes (K, 2), y up; None where one is unknown."""

    @property
    def telecentricity_per_um(self) -> float:
        """Growth of the slopes with the position from the middle of the field."""

    @property
    def lights(self) -> NDArray[np.float64] | None:
        """Directions (L, 3) toward the lights; None where one is unknown."""

    @property
    def light_field(self) -> LightField | None:
        """Light at every point of the sample; None where a direction is unknown."""

    @property
    def powers(self) -> NDArray[np.float64]:
        """Brightness (L,) of the lights relative to each other."""

    @property
    def mask(self) -> BoolImage | None:
        """Valid pixels (H, W); None: all."""

    @property
    def in_colour(self) -> bool:
        """Whether the sensor sees red, green and blue."""

    def rgb(self, kind: FrameKind, view: int | None, light: int | None) -> FloatImage:
        """Linear red, green and blue (H, W, 3) of one frame."""

    def saturation_level(self, view: int, light: int) -> FloatImage | float:
        """Luminance (H, W), or one for all pixels, from which a pixel counts as saturated."""

    def stack(
        self, views: Iterable[int] | None = None, lights: Iterable[int] | None = None
    ) -> Iterator[tuple[int, int, FloatImage]]:
        """(view, light, linear luminance (H, W)) of every pair, lights fastest."""


@dataclass(frozen=True)
class Inputs:
    """Frames with the geometry that a reconstruction uses of them.

    Attributes
    ----------
    frames, settings:
        As given.
    stereo, photometric:
        Which of the two methods the run and the settings allow for; at least one.
    slopes:
        (K, 2) slopes of the views, y up; zero where unknown and not needed.
    directions:
        (L, 3) unit vectors toward the lights; empty where not needed.
    range_um:
        Lowest and highest height to search; (0, 0) without stereo.
    mask:
        (H, W) valid pixels; None: all.
    """

    frames: Frames
    settings: Settings
    stereo: bool
    photometric: bool
    slopes: NDArray[np.float64]
    directions: NDArray[np.float64]
    range_um: tuple[float, float]
    mask: BoolImage | None

    @property
    def view_count(self) -> int:
        """Number of views."""
        return len(self.frames.view_names)

    @property
    def light_count(self) -> int:
        """Number of lights."""
        return len(self.frames.light_names)

    @property
    def nearest(self) -> int:
        """View whose slope is nearest to zero."""
        return int(np.argmin(np.linalg.norm(self.slopes, axis=1)))

    @property
    def relative_powers(self) -> NDArray[np.float64]:
        """Brightness (L,) of the lights, of mean 1."""
        powers = self.frames.powers
        relative: NDArray[np.float64] = powers / powers.mean()
        return relative

    @property
    def light_field(self) -> LightField:
        """Light in frames that were divided by :attr:`relative_powers`."""
        field = self.frames.light_field
        if field is None:
            field = LightField.distant(self.directions, self.relative_powers)
        return field.scaled(1.0 / self.relative_powers)

    def with_mask(self, quality: FloatImage) -> FloatImage:
        """Quality (H, W), 0 outside the mask."""
        return quality if self.mask is None else np.where(self.mask, quality, np.float32(0.0))


def check_inputs(frames: Frames, settings: Settings) -> Inputs:
    """Refuse everything that can be refused before a frame is read.

    Raises
    ------
    InvalidInputError
        Too few or badly spread lights, unknown geometry, no range of heights, or neither two views nor two
        lights.
    """
    views, lights = len(frames.view_names), len(frames.light_names)
    stereo = settings.use == "stereo" or (settings.use == "auto" and views > 1)
    shaded = settings.use == "photometric" or (settings.use == "auto" and lights > 1)
    if not stereo and not shaded:
        raise InvalidInputError(
            "One view under one light tells nothing about height.",
            hint="Take at least two views, or at least three lights.",
        )
    slopes = _checked_slopes(frames) if stereo else frames.views
    return Inputs(
        frames=frames,
        settings=settings,
        stereo=stereo,
        photometric=shaded,
        slopes=np.zeros((views, 2)) if slopes is None else slopes,
        directions=_checked_directions(frames) if shaded else np.zeros((0, 3)),
        range_um=_checked_range(frames, settings) if stereo else (0.0, 0.0),
        mask=frames.mask,
    )


def _way_out(use: str, possible: bool) -> str:
    """End of a hint: the other of the two methods, where the run allows for it."""
    return f", or reconstruct with `use: {use}` in a settings file" if possible else ""


def _checked_slopes(frames: Frames) -> NDArray[np.float64]:
    possible = len(frames.light_names) > 2 and frames.lights is not None
    way_out = _way_out("photometric", possible)
    slopes = frames.views
    if slopes is None:
        raise InvalidInputError(
            "The slope of a view is not known, so parallax cannot be turned into height.",
            hint=f"Give `slope: [sx, sy]` for every view{way_out}.",
        )
    if len(slopes) < 2:
        raise InvalidInputError(
            "Stereo needs at least two views; there is one.", hint=f"Take more views{way_out}."
        )
    return slopes


def _checked_directions(frames: Frames) -> NDArray[np.float64]:
    possible = len(frames.view_names) > 1 and frames.views is not None
    way_out = _way_out("stereo", possible)
    directions = frames.lights
    if directions is None:
        raise InvalidInputError(
            "The direction of a light is not known, so shading cannot be turned into slope.",
            hint=f"Give `direction: [x, y, z]` for every light{way_out}.",
        )
    if len(directions) < 3:
        raise InvalidInputError(
            f"Photometric stereo needs at least 3 lights; there are {len(directions)}.",
            hint=f"Take the sample under more lights{way_out}.",
        )
    return photometric.check_directions(directions)


def _checked_range(frames: Frames, settings: Settings) -> tuple[float, float]:
    span = settings.height_range_um or frames.height_range_um
    if span is None:
        raise InvalidInputError(
            "There is no range of heights to search.",
            hint="Give `height_range_um: [lowest, highest]` in the import file or the settings.",
        )
    return span


def refuse_undefined(level: float, what: str) -> None:
    """Refuse a mean ``level`` of the frames of ``what`` that is undefined or not positive.

    Raises
    ------
    InvalidInputError
    """
    if not np.isfinite(level):
        raise InvalidInputError(
            f"Frames of {what} hold undefined values (NaN or infinite).",
            hint="Check the files that were imported; acquire or import them again.",
        )
    if level <= 0.0:
        raise InvalidInputError(
            f"Frames of {what} are black after the dark signal was subtracted.",
            hint="Check exposure, lights and the dark frames.",
        )
