"""Description of a set of photographs: the YAML that ``reliefscope import`` reads."""

from __future__ import annotations

import math
import string
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from reliefscope.dataset.spec import (
    ImportedLight,
    ImportedView,
    LevelIntensity,
    Vector2,
    Vector3,
)
from reliefscope.errors import InvalidInputError
from reliefscope.models.base import StrictModel, parse_model, read_yaml
from reliefscope.models.instrument import Sensor
from reliefscope.models.light_field import mirrored_level

Positive = Annotated[float, Field(gt=0)]
Index = Annotated[int, Field(ge=0)]


class ViewEntry(StrictModel):
    """One viewing direction."""

    slope: Vector2 | None = None
    """(sx, sy): a point at height z appears at (x - z sx, y - z sy)."""
    name: str | None = None


class LightEntry(StrictModel):
    """One light."""

    direction: Vector3 | None = None
    """Toward the light, of any length."""
    position_mm: Vector3 | None = None
    """Place of a near light, from the point of the object in the middle of the picture; instead of ``direction``."""
    power: Positive = 1.0
    level: LevelIntensity | None = None
    """What a level surface shows, as ``reliefscope estimate-lights`` finds it."""
    name: str | None = None

    @model_validator(mode="after")
    def _one_place(self) -> LightEntry:
        if self.direction is not None and self.position_mm is not None:
            raise ValueError("give either `direction` or `position_mm`")
        return self


class LightList(StrictModel):
    """Directions of lights in a file of their own, as ``reliefscope light-probe --out`` writes them."""

    schema_version: Literal[1] = 1
    lights: Annotated[tuple[LightEntry, ...], Field(min_length=1)]
    y_axis: Literal["up", "down"] = "up"


class FrameEntry(StrictModel):
    """One photograph; indices count from 0."""

    view: Index = 0
    light: Index = 0
    file: str


class Circle(StrictModel):
    """Valid region; row and column count from 0 at the top left pixel."""

    row: float
    column: float
    radius_px: Positive


class MaskEntry(StrictModel):
    """Valid region of every photograph: a picture (white is valid) or a circle."""

    file: str | None = None
    circle: Circle | None = None

    @model_validator(mode="after")
    def _one(self) -> MaskEntry:
        if (self.file is None) == (self.circle is None):
            raise ValueError("give either file or circle")
        return self


class PhotographSet(StrictModel):
    """Content of the description file."""

    schema_version: Literal[1] = 1
    folder: str = "."
    """Where the files are, relative to the description."""
    pixel_um: Positive
    """Size of a pixel on the object; take 1 where it is not known, heights are then in pixels."""
    height_range_um: Vector2 | None = None
    """Heights to search; needed for more than one view."""
    views: Annotated[tuple[ViewEntry, ...], Field(min_length=1)] = (ViewEntry(slope=(0.0, 0.0)),)
    lights: Annotated[tuple[LightEntry, ...], Field(min_length=1)] = (LightEntry(),)
    frames: tuple[FrameEntry, ...] | None = None
    pattern: str | None = None
    """File name with ``{view}`` and ``{light}``, e.g. ``Image_{light:02d}.png``; instead of ``frames``."""
    first: Index = 0
    """Number that the first view and the first light have in ``pattern``."""
    sensor: Sensor = "mono"
    bit_depth: Annotated[int, Field(ge=1, le=16)]
    transfer: Literal["linear", "srgb"] = "linear"
    """Whether counts are proportional to light or follow the sRGB curve."""
    y_axis: Literal["up", "down"] = "up"
    """Direction of y in the slopes and directions given, as seen in the pictures."""
    black_level: Annotated[float, Field(ge=0, lt=1)] = 0.0
    """Signal without light, fraction of full scale."""
    dark: str | Annotated[tuple[str, ...], Field(min_length=1, max_length=16)] | None = None
    """Photograph, or several, with the lens covered or the lights off; they are averaged."""
    mask: MaskEntry | None = None
    sample: str = ""
    notes: str = ""

    @model_validator(mode="after")
    def _consistent(self) -> PhotographSet:
        if (self.frames is None) == (self.pattern is None):
            raise ValueError("give either `frames` (a list) or `pattern` (a file name)")
        if self.pattern is not None:
            self._check_pattern(self.pattern)
        if self.frames is not None:
            self._check_frames(self.frames)
        if self.height_range_um is not None and self.height_range_um[0] >= self.height_range_um[1]:
            raise ValueError("height_range_um must be [low, high] with low < high")
        if self.sensor == "bayer_rggb" and self.transfer != "linear":
            raise ValueError("a mosaic must be linear: `transfer: linear`")
        for index, light in enumerate(self.lights):
            place = light.direction or light.position_mm
            if place is not None and place[2] <= 0:
                key = "direction" if light.direction is not None else "position_mm"
                raise ValueError(
                    f"lights.{index}.{key} {place} points to or below the sample plane"
                )
        if any((light.level is None) != (self.lights[0].level is None) for light in self.lights):
            raise ValueError("give `level` for all lights or for none")
        for kind, names in (("views", self.view_names), ("lights", self.light_names)):
            if len(set(names)) < len(names):
                raise ValueError(f"{kind} must have different names")
        return self

    def _check_pattern(self, pattern: str) -> None:
        try:
            used = {name for _, name, _, _ in string.Formatter().parse(pattern) if name is not None}
            pattern.format(view=0, light=0) if used <= {"view", "light"} else None
        except (ValueError, IndexError) as error:
            raise ValueError(f"pattern `{pattern}` is no valid pattern: {error}") from error
        if not used <= {"view", "light"}:
            raise ValueError(f"pattern `{pattern}` may hold {{view}} and {{light}} only")
        for kind, count in (("view", len(self.views)), ("light", len(self.lights))):
            if count > 1 and kind not in used:
                raise ValueError(f"there are {count} {kind}s, but the pattern holds no {{{kind}}}")

    def _check_frames(self, frames: tuple[FrameEntry, ...]) -> None:
        seen: set[tuple[int, int]] = set()
        for number, frame in enumerate(frames):
            for kind, index, count in (
                ("view", frame.view, len(self.views)),
                ("light", frame.light, len(self.lights)),
            ):
                if index >= count:
                    raise ValueError(
                        f"frames.{number}.{kind} is {index}, but {kind}s are 0 to {count - 1}"
                    )
            if (frame.view, frame.light) in seen:
                raise ValueError(
                    f"view {frame.view} under light {frame.light} is listed more than once"
                )
            seen.add((frame.view, frame.light))
        absent = [pair for pair in self.pairs if pair not in seen]
        if absent:
            listed = ", ".join(f"view {view} light {light}" for view, light in absent[:6])
            raise ValueError(f"{len(absent)} frames are not listed: {listed}")

    @property
    def pairs(self) -> list[tuple[int, int]]:
        """Every (view, light)."""
        return [
            (view, light) for view in range(len(self.views)) for light in range(len(self.lights))
        ]

    @property
    def view_names(self) -> list[str]:
        """Names of the views, made up where none is given."""
        return [view.name or f"view-{index:02d}" for index, view in enumerate(self.views)]

    @property
    def light_names(self) -> list[str]:
        """Names of the lights, made up where none is given."""
        return [light.name or f"light-{index:02d}" for index, light in enumerate(self.lights)]

    @property
    def dark_files(self) -> tuple[str, ...]:
        """Files of the dark photographs."""
        if self.dark is None:
            return ()
        return (self.dark,) if isinstance(self.dark, str) else self.dark

    def files(self) -> dict[tuple[int, int], str]:
        """(view, light) -> file."""
        if self.frames is not None:
            return {(frame.view, frame.light): frame.file for frame in self.frames}
        assert self.pattern is not None  # the validator holds it
        return {
            (view, light): self.pattern.format(view=view + self.first, light=light + self.first)
            for view, light in self.pairs
        }

    def imported_views(self) -> tuple[ImportedView, ...]:
        """Views with y up."""
        sign = -1.0 if self.y_axis == "down" else 1.0
        return tuple(
            ImportedView(
                name=name,
                slope=None if view.slope is None else (view.slope[0], sign * view.slope[1]),
            )
            for name, view in zip(self.view_names, self.views, strict=True)
        )

    def imported_lights(self) -> tuple[ImportedLight, ...]:
        """Lights with y up and unit directions."""
        lights = []
        for name, light in zip(self.light_names, self.lights, strict=True):
            upright = _upside_down(light) if self.y_axis == "down" else light
            direction = upright.direction or upright.position_mm
            if direction is not None:
                x, y, z = direction
                length = math.hypot(x, y, z)
                direction = (x / length, y / length, z / length)
            lights.append(
                ImportedLight(
                    name=name,
                    direction=direction,
                    position_mm=upright.position_mm,
                    power=light.power,
                    level=upright.level,
                )
            )
        return tuple(lights)


def load_photograph_set(path: Path) -> PhotographSet:
    """Description of a set; ``lights`` may be the name of a :class:`LightList` file beside it.

    Raises
    ------
    InvalidInputError
        If a file is absent or wrong; the message names file and key.
    """
    return parse_model(PhotographSet, _with_lights(path), str(path))


def load_lights(path: Path) -> LightList:
    """Lights of a :class:`LightList` file, or of the description of a set of photographs, with y up.

    Raises
    ------
    InvalidInputError
        If the file is absent or wrong, or gives no lights.
    """
    content = _with_lights(path)
    if isinstance(content, dict):
        content = {key: content[key] for key in LightList.model_fields if key in content}
    listed = parse_model(LightList, content, str(path))
    if listed.y_axis == "up":
        return listed
    return LightList(lights=tuple(_upside_down(light) for light in listed.lights))


def _with_lights(path: Path) -> Any:
    """Content of a YAML file, with the lights of the file that ``lights`` may name."""
    content = read_yaml(path)
    if not isinstance(content, dict) or not isinstance(content.get("lights"), str):
        return content
    source = path.parent / content["lights"]
    if source.resolve() == path.resolve():
        raise InvalidInputError(
            f"{path} names itself as the file of its lights.", hint="Correct `lights`."
        )
    lights = parse_model(LightList, read_yaml(source), str(source))
    same = lights.y_axis == content.get("y_axis", "up")
    entries = lights.lights if same else tuple(_upside_down(light) for light in lights.lights)
    return content | {"lights": [entry.model_dump() for entry in entries]}


def _upside_down(light: LightEntry) -> LightEntry:
    flipped: dict[str, Any] = {}
    for key in ("direction", "position_mm"):
        place = getattr(light, key)
        if place is not None:
            flipped[key] = (place[0], -place[1], place[2])
    if light.level is not None:
        flipped["level"] = mirrored_level(light.level)
    return light.model_copy(update=flipped)
