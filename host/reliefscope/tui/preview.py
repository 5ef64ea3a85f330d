"""The camera's picture in half-block cells: one cell shows two pixels, one above the other."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray
from rich.color import Color
from rich.segment import Segment
from rich.style import Style
from textual.geometry import Region, Size
from textual.message import Message
from textual.strip import Strip
from textual.widget import Widget

from reliefscope.units import RawImage

GREYS = 48
"""Shades on the screen; fewer repaint fewer cells, more show more of a smooth surface."""
SATURATED = GREYS
"""Extra level, drawn in colour: at least 98 % of full scale."""
EMPTY = GREYS + 1
"""Extra level of the margin around the picture."""
GAMMA = 1 / 2.2


def fit(frame: tuple[int, int], room: tuple[int, int]) -> tuple[int, int]:
    """Largest (rows, columns) of square pixels with the aspect of ``frame`` within ``room``."""
    scale = min(room[0] / frame[0], room[1] / frame[1])
    return max(1, round(frame[0] * scale)), max(1, round(frame[1] * scale))


def shade(
    raw: RawImage, full_scale: int, room: tuple[int, int], *, mosaic: bool, stretch: bool
) -> NDArray[np.uint8]:
    """Levels for the screen, shape ``room`` (rows, columns), of a frame (H, W).

    Block means are shown with a gamma of 2.2; ``stretch`` spreads the 1st to 99.5th percentile over all
    shades.  A mosaic is binned 2 x 2 first, so that its pattern does not beat with the screen.
    """
    height, width = raw.shape
    image: NDArray[Any] = raw
    if mosaic and min(height, width) >= 4:
        image = cv2.resize(
            raw[: height // 2 * 2, : width // 2 * 2],
            (width // 2, height // 2),
            interpolation=cv2.INTER_AREA,
        )
    rows, columns = fit((height, width), room)
    shrinks = rows < image.shape[0]
    small = cv2.resize(
        image, (columns, rows), interpolation=cv2.INTER_AREA if shrinks else cv2.INTER_NEAREST
    ).astype(np.float32)
    small /= full_scale
    saturated = small >= 0.98
    if stretch:
        low, high = np.percentile(small, (1.0, 99.5))
        small = (small - low) / max(high - low, 1e-3)
    levels = (np.clip(small, 0, 1) ** GAMMA * (GREYS - 1) + 0.5).astype(np.uint8)
    levels[saturated] = SATURATED
    canvas = np.full(room, EMPTY, np.uint8)
    top, left = (room[0] - rows) // 2, (room[1] - columns) // 2
    canvas[top : top + rows, left : left + columns] = levels
    return canvas


class Preview(Widget):
    """Live picture; only changed rows are painted again."""

    DEFAULT_CSS = "Preview { width: 1fr; height: 1fr; }"

    class Clicked(Message):
        """A cell of the picture was clicked; position as fractions (0..1) of the widget."""

        def __init__(self, x: float, y: float) -> None:
            super().__init__()
            self.x = x
            self.y = y

    def __init__(self, *, id: str | None = None) -> None:  # noqa: A002 - textual's own name
        super().__init__(id=id)
        self._levels: NDArray[np.uint8] = np.full((2, 1), EMPTY, np.uint8)
        self._segments: dict[tuple[int, int, int], Segment] = {}
        self._colours: list[Color] = []
        self.room = (2, 1)
        """(rows, columns) of pixels that fit; read by the thread that prepares frames."""
        self.shown = 0
        """Frames shown so far."""

    def on_mount(self) -> None:
        """Make the palette."""
        margin = self.background_colors[1].rich_color
        greys = [
            Color.from_rgb(*([round(255 * level / (GREYS - 1))] * 3)) for level in range(GREYS)
        ]
        self._colours = [*greys, Color.parse("#ff5f5f"), margin]

    def on_resize(self) -> None:
        """Tell the room anew; the next frame fits it."""
        size: Size = self.size
        self.room = (max(2, 2 * size.height), max(1, size.width))

    def put(self, levels: NDArray[np.uint8]) -> None:
        """Show levels (rows, columns) made by :func:`shade`."""
        self.shown += 1
        same_shape = levels.shape == self._levels.shape
        previous, self._levels = self._levels, levels
        if not same_shape:
            self.refresh()
            return
        cells = levels.shape[0] // 2
        changed = np.flatnonzero((levels != previous).reshape(cells, -1).any(axis=1))
        if changed.size > cells // 2:
            self.refresh()
        elif changed.size:
            self.refresh(*(Region(0, int(row), self.size.width, 1) for row in changed))

    def clear(self) -> None:
        """Show nothing."""
        self._levels = np.full(self.room, EMPTY, np.uint8)
        self.refresh()

    def render_line(self, y: int) -> Strip:
        """One row of cells: runs of equal cells share a segment, segments are cached."""
        width = self.size.width
        if 2 * y + 1 >= self._levels.shape[0] or not self._colours:
            return Strip.blank(width, self.rich_style)
        upper = self._levels[2 * y].astype(np.int32)
        lower = self._levels[2 * y + 1].astype(np.int32)
        key = upper * 256 + lower
        starts = np.concatenate(([0], np.flatnonzero(np.diff(key)) + 1))
        lengths = np.diff(np.concatenate((starts, [key.size])))
        segments = [
            self._segment(top, bottom, length)
            for top, bottom, length in zip(
                upper[starts].tolist(), lower[starts].tolist(), lengths.tolist(), strict=True
            )
        ]
        return Strip(segments, key.size).adjust_cell_length(width, self.rich_style)

    def _segment(self, top: int, bottom: int, length: int) -> Segment:
        key = (top, bottom, length)
        segment = self._segments.get(key)
        if segment is None:
            style = Style(color=self._colours[top], bgcolor=self._colours[bottom])
            segment = self._segments[key] = Segment("▀" * length, style)
        return segment
