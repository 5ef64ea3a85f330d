"""What a run takes: views x lights, a centre view, dark frames and leakage frames.

A plan is declarative and complete: it holds the bitmaps that the glass really shows and the levels of every
light, so that the run can be understood, and resumed, without the program that wrote it.
"""

from __future__ import annotations

import base64
from collections.abc import Iterator
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field, PlainSerializer, PlainValidator, WithJsonSchema, model_validator

from reliefscope.models.apertures import disc, hexagonal_centres_mm, pack_bitmap, unpack_bitmap
from reliefscope.models.base import StrictModel
from reliefscope.models.instrument import InstrumentProfile
from reliefscope.units import BoolImage

FrameKind = Literal["view", "centre", "dark", "leakage"]


def _read_bitmap(value: Any) -> BoolImage:
    if isinstance(value, np.ndarray):
        packed = pack_bitmap(value.astype(bool))
    elif isinstance(value, str):
        try:
            packed = base64.b64decode(value, validate=True)
        except ValueError as error:
            raise ValueError("bitmap is not base64") from error
    else:
        raise ValueError("bitmap must be base64 text of 1,024 bytes in page order")
    if len(packed) != 1024:
        raise ValueError(f"bitmap has {len(packed)} bytes, not 1,024")
    bitmap = unpack_bitmap(packed)
    bitmap.flags.writeable = False
    return bitmap


Bitmap = Annotated[
    BoolImage,
    PlainValidator(_read_bitmap),
    PlainSerializer(lambda bitmap: base64.b64encode(pack_bitmap(bitmap)).decode("ascii")),
    WithJsonSchema({"type": "string", "contentEncoding": "base64"}),
]
"""Boolean (64, 128) in memory, base64 of 1,024 bytes in page order in files."""


class Aperture(StrictModel):
    """A bitmap of the glass with a name."""

    name: str
    bitmap: Bitmap

    @property
    def open_pixels(self) -> int:
        """Number of open pixels: views are brought to equal gain by it."""
        return int(self.bitmap.sum())

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Aperture):
            return NotImplemented
        return self.name == other.name and bool(np.array_equal(self.bitmap, other.bitmap))

    def __hash__(self) -> int:
        return hash((self.name, self.bitmap.tobytes()))


class Light(StrictModel):
    """A named set of LED levels: one LED, a ring, or all."""

    name: str
    levels: Annotated[dict[int, Annotated[int, Field(ge=1, le=4095)]], Field(min_length=1)]
    """LED index -> level, 4095 = full."""


class FrameRequest(StrictModel):
    """One image of a plan: ``accumulate`` exposures of an aperture under a light, stored as their exact sum.

    ``view`` is None for centre, dark and leakage frames, ``light`` is None for dark frames; both are indices
    into the plan.
    """

    kind: FrameKind
    view: int | None
    light: int | None
    accumulate: Annotated[int, Field(ge=1, le=16)] = 1

    @property
    def key(self) -> str:
        """Stable name of the request within its plan, e.g. ``view-03-light-11``."""
        view = "" if self.view is None else f"-{self.view:02d}"
        light = "" if self.light is None else f"-light-{self.light:02d}"
        return f"{self.kind}{view}{light}"


class Plan(StrictModel):
    """A run: every view under every light, and the frames that correct them."""

    schema_version: Literal[1] = 1
    views: Annotated[tuple[Aperture, ...], Field(min_length=1)]
    lights: Annotated[tuple[Light, ...], Field(min_length=1)]
    centre: Aperture | None = None
    """Taken under ``all_lights``: the micrograph of the paper's Fig. 10A."""
    centre_light: Light | None = None
    dark_accumulate: Annotated[int, Field(ge=0, le=16)] = 16
    """Exposures with all LEDs off, summed; 0 takes none."""
    leakage_accumulate: Annotated[int, Field(ge=0, le=16)] = 16
    """Exposures with the glass shut, summed, per light; 0 takes none."""
    exposure_us: Annotated[int, Field(ge=20, le=10_000_000)]
    gain_db: Annotated[float, Field(ge=0, le=48)] = 0.0
    settle_ms: Annotated[float, Field(ge=0, le=10_000)]
    """Waited after every change of the glass."""
    light_settle_ms: Annotated[float, Field(ge=0, le=10_000)] = 1.0
    """Waited after a change of the light alone."""

    @model_validator(mode="after")
    def _consistent(self) -> Plan:
        if (self.centre is None) != (self.centre_light is None):
            raise ValueError("centre and centre_light come together or not at all")
        for kind, names in (
            ("views", [view.name for view in self.views]),
            ("lights", [light.name for light in self.lights]),
        ):
            if len(set(names)) < len(names):
                raise ValueError(f"{kind} must have different names")
        return self

    def requests(self) -> Iterator[FrameRequest]:
        """Every image in the order of acquisition: the glass changes as seldom as possible."""
        if self.dark_accumulate:
            yield FrameRequest(kind="dark", view=None, light=None, accumulate=self.dark_accumulate)
        if self.leakage_accumulate:
            for light in range(len(self.lights)):
                yield FrameRequest(
                    kind="leakage", view=None, light=light, accumulate=self.leakage_accumulate
                )
        for view in range(len(self.views)):
            for light in range(len(self.lights)):
                yield FrameRequest(kind="view", view=view, light=light)
        if self.centre is not None:
            yield FrameRequest(kind="centre", view=None, light=None)

    def duration_s(self, readout_s: float) -> float:
        """Time the device needs, from exposure, settle times and the camera's readout."""
        total_ms = 0.0
        previous: tuple[str, int | None] | None = None
        for request in self.requests():
            glass = (request.kind, request.view)
            total_ms += self.settle_ms if glass != previous else self.light_settle_ms
            previous = glass
            total_ms += request.accumulate * (self.exposure_us / 1000 + readout_s * 1000)
        return total_ms / 1000


def pattern_apertures(profile: InstrumentProfile) -> tuple[Aperture, ...]:
    """The profile's pattern of discs as bitmaps."""
    pattern = profile.apertures
    spacing = pattern.spacing_mm or pattern.disc_diameter_mm
    return tuple(
        Aperture(
            name=f"disc-{index:02d}", bitmap=disc(profile.glass, centre, pattern.disc_diameter_mm)
        )
        for index, centre in enumerate(hexagonal_centres_mm(pattern.count, spacing))
    )


def single_led_lights(profile: InstrumentProfile) -> tuple[Light, ...]:
    """One light per LED at full level, in the order of the profile."""
    full = profile.dome.full_level
    return tuple(
        Light(name=f"led-{led:02d}", levels={led: full}) for led in range(profile.dome.count)
    )


def all_leds(profile: InstrumentProfile, fraction: float = 1.0) -> Light:
    """Every LED at the same level."""
    level = max(1, round(profile.dome.full_level * fraction))
    return Light(name="all", levels=dict.fromkeys(range(profile.dome.count), level))


def default_plan(profile: InstrumentProfile) -> Plan:
    """Every disc of the pattern under every LED, the centre disc under all LEDs, dark and leakage frames.

    The centre view runs all LEDs at a level that keeps the sum as bright as two LEDs alone, within the current
    budget of the LED supply and the range of the camera.
    """
    return Plan(
        views=pattern_apertures(profile),
        lights=single_led_lights(profile),
        centre=Aperture(
            name="centre",
            bitmap=disc(profile.glass, (0.0, 0.0), profile.apertures.disc_diameter_mm),
        ),
        centre_light=all_leds(profile, fraction=2.0 / profile.dome.count),
        exposure_us=round(profile.exposure_ms * 1000),
        settle_ms=profile.glass.settle_ms,
    )
