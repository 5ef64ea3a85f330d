"""What a run is, apart from its pixels: the content of ``run.json``."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Literal

from pydantic import Field, model_validator

from reliefscope.dataset.durable import disk_error, write_file
from reliefscope.errors import DatasetError, InvalidInputError, resume_command
from reliefscope.models.base import StrictModel, parse_model
from reliefscope.models.calibration import Calibration
from reliefscope.models.instrument import InstrumentProfile, Sensor
from reliefscope.models.plan import FrameRequest, Plan

SCHEMA_VERSION = 1
SPEC_FILE = "run.json"
Positive = Annotated[float, Field(gt=0)]
Vector2 = tuple[float, float]
Vector3 = tuple[float, float, float]
LevelIntensity = Annotated[tuple[float, ...], Field(min_length=10, max_length=10)]


class FrameFormat(StrictModel):
    """Form of every frame of a run."""

    rows: Annotated[int, Field(ge=1)]
    columns: Annotated[int, Field(ge=1)]
    sensor: Sensor
    bit_depth: Annotated[int, Field(ge=1, le=16)]
    black_level: Annotated[float, Field(ge=0, lt=1)] = 0.0
    """Signal without light as a fraction of full scale; used where no dark frame was taken."""

    @property
    def shape(self) -> tuple[int, int]:
        """(rows, columns)."""
        return self.rows, self.columns

    @property
    def full_scale(self) -> int:
        """Largest count of one exposure."""
        return (1 << self.bit_depth) - 1

    def dtype(self, accumulate: int) -> Literal["uint8", "uint16"]:
        """Stored type of the sum of ``accumulate`` exposures."""
        return "uint8" if self.full_scale * accumulate <= 0xFF else "uint16"


class Session(StrictModel):
    """One stretch of acquisition; a resumed run has several."""

    started: str
    host: dict[str, str]
    device: dict[str, str]
    camera: dict[str, str]


class AcquiredSpec(StrictModel):
    """Part of a run that an instrument took.

    Slopes and directions are not stored: they follow from ``plan``, ``profile`` and a calibration, and a
    better calibration may come later.  ``calibration`` is the one that held during acquisition.
    """

    plan: Plan
    profile: InstrumentProfile
    calibration: Calibration
    camera_exposure_us: int
    """What the camera really used."""
    camera_gain_db: float
    sessions: tuple[Session, ...] = ()


class ImportedView(StrictModel):
    """Viewing direction of a set of photographs."""

    name: str
    slope: Vector2 | None = None
    """y up; None where it is not known."""


class ImportedLight(StrictModel):
    """Light of a set of photographs."""

    name: str
    direction: Vector3 | None = None
    """Unit vector toward the light, y up; None where it is not known."""
    position_mm: Vector3 | None = None
    """Place of a near light, y up, from the middle of the picture; None where it is distant."""
    power: Positive = 1.0
    level: LevelIntensity | None = None
    """Logarithm of the intensity of a level surface, see ``reliefscope.models.light_field.level_powers``."""


class ImportedSpec(StrictModel):
    """Part of a run that came from photographs."""

    source: str
    """Name of the description that was imported."""
    pixel_um: Positive
    height_range_um: Vector2 | None = None
    views: Annotated[tuple[ImportedView, ...], Field(min_length=1)]
    lights: Annotated[tuple[ImportedLight, ...], Field(min_length=1)]
    dark_accumulate: Annotated[int, Field(ge=0, le=16)] = 0
    mask_sha256: str | None = None
    """Over the pixels (uint8, 255 = valid) of ``mask.png``; None where every pixel is valid."""
    conversion: str = ""
    """What was done to the counts of the files, for people; empty where they are stored as they were."""


class RunSpec(StrictModel):
    """Content of ``run.json``."""

    schema_version: Literal[1] = 1
    created: str
    software: str
    sample: str = ""
    notes: str = ""
    frame: FrameFormat
    acquired: AcquiredSpec | None = None
    imported: ImportedSpec | None = None

    @model_validator(mode="after")
    def _one_origin(self) -> RunSpec:
        if (self.acquired is None) == (self.imported is None):
            raise ValueError("a run is either acquired or imported")
        for request in self.requests():
            if self.frame.full_scale * request.accumulate > 0xFFFF:
                raise ValueError(
                    f"{request.key}: the sum of {request.accumulate} exposures of "
                    f"{self.frame.bit_depth} bit does not fit into 16 bit"
                )
        return self

    @property
    def origin(self) -> Literal["acquired", "imported"]:
        """Where the frames came from."""
        return "acquired" if self.acquired is not None else "imported"

    @property
    def plan(self) -> Plan | None:
        """Plan of an acquired run."""
        return self.acquired.plan if self.acquired else None

    @property
    def profile(self) -> InstrumentProfile | None:
        """Profile of the instrument that took the run."""
        return self.acquired.profile if self.acquired else None

    @property
    def calibration(self) -> Calibration | None:
        """Calibration that held during acquisition."""
        return self.acquired.calibration if self.acquired else None

    @property
    def view_names(self) -> tuple[str, ...]:
        """Names of the views in the order of their index."""
        views = self.acquired.plan.views if self.acquired else self._imported.views
        return tuple(view.name for view in views)

    @property
    def light_names(self) -> tuple[str, ...]:
        """Names of the lights in the order of their index."""
        lights = self.acquired.plan.lights if self.acquired else self._imported.lights
        return tuple(light.name for light in lights)

    @property
    def pixel_um(self) -> float:
        """Size of a pixel in the sample plane, as known when the run was made."""
        return self.acquired.calibration.pixel_um if self.acquired else self._imported.pixel_um

    @property
    def height_range_um(self) -> Vector2 | None:
        """Heights worth searching, where known."""
        if self.acquired:
            return self.acquired.profile.height_range_um
        return self._imported.height_range_um

    def requests(self) -> Iterator[FrameRequest]:
        """Every image of the run in the order in which it is taken."""
        if self.acquired:
            yield from self.acquired.plan.requests()
            return
        imported = self._imported
        if imported.dark_accumulate:
            yield FrameRequest(
                kind="dark", view=None, light=None, accumulate=imported.dark_accumulate
            )
        for view in range(len(imported.views)):
            for light in range(len(imported.lights)):
                yield FrameRequest(kind="view", view=view, light=light)

    def resume_command(self, folder: Path) -> str:
        """What to type to go on with this run, with the address of the instrument that took it last."""
        sessions = self.acquired.sessions if self.acquired else ()
        return resume_command(folder, sessions[-1].device.get("url", "") if sessions else "")

    def repair_hint(self, folder: Path) -> str:
        """What to type to get frames back that are missing or damaged."""
        if self.acquired:
            return f"{self.resume_command(folder)} takes again what was lost; nothing was deleted."
        return "Import the photographs again under another name; nothing was deleted."

    def storage_bytes(self) -> int:
        """Bytes that the pixels of the whole run take."""
        pixels = self.frame.rows * self.frame.columns
        return sum(
            pixels * (1 if self.frame.dtype(request.accumulate) == "uint8" else 2)
            for request in self.requests()
        )

    @property
    def _imported(self) -> ImportedSpec:
        assert self.imported is not None  # the validator holds it
        return self.imported


def write_spec(folder: Path, spec: RunSpec) -> None:
    """Write ``run.json`` in one atomic step."""
    path = folder / SPEC_FILE
    text = json.dumps(spec.model_dump(mode="json"), indent=1, ensure_ascii=False)
    try:
        write_file(path, text.encode("utf-8") + b"\n")
    except OSError as error:
        raise disk_error(error, path) from error


def read_spec(folder: Path) -> RunSpec:
    """Content of ``run.json``, or one clear error."""
    path = folder / SPEC_FILE
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise DatasetError(
            f"{folder} is not a run: it holds no {SPEC_FILE}.",
            hint="Give the folder that `reliefscope acquire` or `reliefscope import` made.",
        ) from None
    except (OSError, ValueError) as error:
        raise DatasetError(
            f"{path} cannot be read: {error}.",
            hint=f"The frames are still readable as OME-Zarr. Restore {SPEC_FILE} from a copy of the run.",
        ) from error
    version = content.get("schema_version") if isinstance(content, dict) else None
    if version != SCHEMA_VERSION:
        raise DatasetError(
            f"{path} has schema_version {version!r}; this program reads {SCHEMA_VERSION}.",
            hint="Open the run with the version of reliefscope that wrote it, or a newer one.",
        )
    try:
        return parse_model(RunSpec, content, str(path))
    except InvalidInputError as error:
        raise DatasetError(
            error.message, hint=f"Restore {SPEC_FILE} from a copy of the run."
        ) from None


def resume_command_of(folder: Path) -> str:
    """What to type to go on with the run in ``folder``, as far as its description can be read."""
    try:
        return read_spec(folder).resume_command(folder)
    except DatasetError:
        return resume_command(folder)
