"""Height from images focused at different heights: the reference measurement of the paper's section IV.C."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from importlib.metadata import entry_points
from pathlib import Path
from typing import Any, cast

import cv2
import numpy as np

from reliefscope.dataset.image_stack import ImageStack, open_stack
from reliefscope.errors import DatasetError, InvalidInputError, OutputExistsError
from reliefscope.jobs import Job
from reliefscope.microscope.instruments import scheme_of
from reliefscope.microscope.places import fresh_path
from reliefscope.models.z_stack import StackRecorder
from reliefscope.reconstruction.focus_stacking import (
    QUALITY_THRESHOLD,
    SMOOTHING_PX,
    WINDOW,
    FocusedStack,
    Peak,
    focus_stack,
)
from reliefscope.report.panels import Panel, toned, write_panels

STACK_GROUP = "reliefscope.z_stacks"
SCHEMA_VERSION = 1


@dataclass(frozen=True, slots=True)
class FocusOutcome:
    """A stack, what was found in it, and where that lies."""

    stack: ImageStack
    result: FocusedStack
    folder: Path
    pictures: tuple[Path, ...]
    settings: dict[str, Any]

    def facts(self) -> dict[str, Any]:
        """Figures for people and programs."""
        description, heights = self.stack.description, self.stack.heights_um
        rows, columns = self.result.height_um.shape
        low, high = np.percentile(self.result.height_um, (1, 99))
        return {
            "images": heights.size,
            "size_px": [columns, rows],
            "pixel_um": description.pixel_um,
            "heights_um": [float(heights[0]), float(heights[-1])],
            **self.settings,
            "height_1_to_99_percent_um": [round(float(low), 3), round(float(high), 3)],
            "quality_median": round(float(np.median(self.result.quality)), 4),
            "accepted": round(float(self.result.accepted().mean()), 4),
        }

    def as_dict(self) -> dict[str, Any]:
        """For ``--json``."""
        return {
            "results": str(self.folder),
            "pictures": [str(picture) for picture in self.pictures],
            "summary": self.facts(),
        }


def record_stack(
    url: str, out: Path | str, *, field_um: float | None = None, job: Job | None = None
) -> ImageStack:
    """Take a stack of what lies under the instrument of ``url`` with the microscope that stands beside it.

    Parameters
    ----------
    url:
        Instrument whose sample is meant; a simulated one has such a microscope.
    out:
        New folder for the images and their ``stack.yml``.
    field_um:
        Side of the central square to take; all that the instrument sees if left out.
    job:
        Receives progress; may cancel.

    Raises
    ------
    InvalidInputError
        No microscope goes with this URL, or the field is too small.
    OutputExistsError
        ``out`` exists.
    """
    found = [entry for entry in entry_points(group=STACK_GROUP) if entry.name == scheme_of(url)]
    if not found:
        raise InvalidInputError(
            f"No microscope that takes stacks goes with `{url}`.",
            hint="Take the images with any microscope; `reliefscope focus-stack FOLDER --step-um 5` reads them.",
        )
    record = cast(StackRecorder, found[0].load())
    description = record(url, Path(out), field_um=field_um, job=job)
    return ImageStack(Path(out), description)


def focus_pictures(
    places: Sequence[Path | str] | ImageStack,
    *,
    step_um: float | None = None,
    pixel_um: float | None = None,
    window: int = WINDOW,
    smoothing_px: float = SMOOTHING_PX,
    peak: Peak = "plane",
    out: Path | str | None = None,
    job: Job | None = None,
) -> FocusOutcome:
    """An image sharp everywhere and a height map from a stack of images, with pictures, in a new folder.

    Parameters
    ----------
    places, step_um, pixel_um:
        The images; see :func:`reliefscope.dataset.image_stack.open_stack`.
    window, smoothing_px, peak:
        See :func:`reliefscope.reconstruction.focus_stacking.focus_stack`; the defaults are the paper's.
    out:
        New folder; ``runs/focus-stack-001`` and so on if left out.
    job:
        Receives progress; may cancel.

    Raises
    ------
    InvalidInputError
        No stack there, or pictures that do not belong together.
    OutputExistsError
        ``out`` exists.
    """
    folder = fresh_path("focus-stack") if out is None else Path(out)
    if folder.exists():
        raise OutputExistsError(
            f"{folder} exists already; nothing was changed.", hint="Give `--out` another name."
        )
    stack = (
        places
        if isinstance(places, ImageStack)
        else open_stack([Path(place) for place in places], step_um=step_um, pixel_um=pixel_um)
    )
    result = focus_stack(
        stack.images(),
        stack.heights_um,
        window=window,
        smoothing_px=smoothing_px,
        peak=peak,
        job=job,
    )
    settings = {"window": window, "smoothing_px": smoothing_px, "peak": peak}
    outcome = FocusOutcome(stack, result, folder, (), settings)
    return replace(outcome, pictures=_write(outcome))


def _write(outcome: FocusOutcome) -> tuple[Path, ...]:
    folder, result = outcome.folder, outcome.result
    try:
        folder.mkdir(parents=True)
        np.savez(
            folder / "arrays.npz",
            height_um=result.height_um,
            picked_um=result.picked_um,
            quality=result.quality,
            focused=result.focused,
        )
        document = {
            "schema_version": SCHEMA_VERSION,
            "stack": outcome.stack.description.model_dump(mode="json"),
            "summary": outcome.facts(),
        }
        (folder / "result.json").write_text(json.dumps(document, indent=2), encoding="utf-8")
        focused = (255 * toned(result.focused) + 0.5).astype(np.uint8)
        cv2.imwrite(
            str(folder / "focused.png"), focused[..., ::-1] if focused.ndim == 3 else focused
        )
    except OSError as error:
        raise DatasetError(
            f"The result could not be written to {folder}: {error.strerror or error}.",
            hint=f"Check space and permissions: `df -h {folder.parent}`.",
        ) from error
    return (write_panels(focus_panels(outcome), folder / "overview.png"), folder / "focused.png")


def focus_panels(outcome: FocusOutcome) -> list[Panel]:
    """The image in focus, the heights (blank where there was nothing to focus on), and the quality."""
    result, pixel_um = outcome.result, outcome.stack.description.pixel_um
    width_um = None if pixel_um is None else pixel_um * result.height_um.shape[1]
    kept = np.where(result.accepted(), result.height_um, np.float32(np.nan))
    spread = (float(outcome.stack.heights_um[0]), float(outcome.stack.heights_um[-1]))
    return [
        Panel("In focus everywhere", toned(result.focused), width_um=width_um),
        Panel(
            f"Height (quality < {QUALITY_THRESHOLD:g} blank)",
            kept.astype(np.float32),
            "height (µm)",
            span=spread,
            width_um=width_um,
        ),
        Panel(
            "Quality of focus", result.quality, "quality", "cividis", (0.0, 1.0), width_um=width_um
        ),
    ]
