"""Images focused at different heights, on disk: a folder with ``stack.yml``, or pictures in their order."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from reliefscope.dataset.importer import srgb_to_linear
from reliefscope.dataset.pictures import read_picture
from reliefscope.errors import InvalidInputError
from reliefscope.models.base import load_model
from reliefscope.models.z_stack import STACK_FILE, StackPlane, ZStack
from reliefscope.units import FloatImage

_PICTURES = {".png", ".tif", ".tiff", ".jpg", ".jpeg"}
_PHOTOGRAPHS = {".jpg", ".jpeg"}
"""Formats whose values follow the sRGB curve where nothing says otherwise."""


@dataclass(frozen=True, slots=True)
class ImageStack:
    """A stack of images; ``description`` tells files, heights and pixel size."""

    folder: Path
    description: ZStack

    @property
    def heights_um(self) -> NDArray[np.float64]:
        """(N,) height in focus of every image, increasing."""
        return np.array([plane.height_um for plane in self.description.planes])

    def images(self) -> Iterator[FloatImage]:
        """Linear images (H, W) or (H, W, 3), full scale 1, read one after the other.

        Raises
        ------
        InvalidInputError
            A file is missing or no picture; the message names it.
        """
        for plane in self.description.planes:
            path = self.folder / plane.file
            counts, _ = read_picture(path, hint=f"Check the names in {self.folder / STACK_FILE}.")
            image = np.multiply(counts, np.float32(1 / np.iinfo(counts.dtype).max))
            yield srgb_to_linear(image) if self.description.transfer == "srgb" else image


def open_stack(
    places: Sequence[Path], *, step_um: float | None = None, pixel_um: float | None = None
) -> ImageStack:
    """The stack in a folder, or made of the pictures named.

    Parameters
    ----------
    places:
        One folder, or three pictures or more in the order in which they were taken.  A folder without
        ``stack.yml`` is read in the order of its names, numbers by value.
    step_um:
        Change of the height in focus from one picture to the next; negative where they come from the top
        down.  The first has height 0.  Needed where no ``stack.yml`` gives heights.
    pixel_um:
        Size of a pixel on the sample, over that of the description.

    Raises
    ------
    InvalidInputError
        No such place, too few pictures, or a step that is missing or not wanted.
    """
    if len(places) == 1 and (places[0] / STACK_FILE).is_file():
        folder = places[0]
        if step_um is not None:
            raise InvalidInputError(
                f"{folder / STACK_FILE} gives the heights already.",
                hint="Leave the step out, or correct the heights in that file.",
            )
        description = load_model(ZStack, folder / STACK_FILE)
        if pixel_um is not None:
            description = description.model_copy(update={"pixel_um": pixel_um})
        return ImageStack(folder, description)
    files = _pictures(places)
    if step_um is None or step_um == 0.0 or not np.isfinite(step_um):
        raise InvalidInputError(
            "The distance between the pictures is not known.",
            hint="Give it with `--step-um 5`; negative where they were taken from the top down.",
        )
    if len(files) < 3:
        raise InvalidInputError(
            f"{len(files)} pictures are no stack.",
            hint="Give a folder with three pictures or more, or their names in order.",
        )
    ordered = files if step_um > 0 else files[::-1]
    return ImageStack(
        Path(),
        ZStack(
            pixel_um=pixel_um,
            transfer="srgb" if files[0].suffix.lower() in _PHOTOGRAPHS else "linear",
            planes=tuple(
                StackPlane(file=str(path), height_um=index * abs(step_um))
                for index, path in enumerate(ordered)
            ),
        ),
    )


def _pictures(places: Sequence[Path]) -> list[Path]:
    if len(places) != 1:
        return list(places)
    folder = places[0]
    if not folder.is_dir():
        raise InvalidInputError(
            f"{folder} is no folder.", hint=f"Check the path: `ls {folder.parent}`."
        )
    found = [path for path in folder.iterdir() if path.suffix.lower() in _PICTURES]
    return sorted(found, key=lambda path: _by_number(path.name))


def _by_number(name: str) -> list[tuple[bool, int, str]]:
    """Sorting key in which ``image10`` comes after ``image9``."""
    return [
        (part.isdigit(), int(part) if part.isdigit() else 0, part)
        for part in re.split(r"(\d+)", name)
    ]
