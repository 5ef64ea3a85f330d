"""The glass as it is driven: 128 x 64 pixels in braille, exactly, or the pupil enlarged."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from rich.segment import Segment
from rich.style import Style
from textual.binding import Binding
from textual.events import Click
from textual.message import Message
from textual.reactive import reactive
from textual.strip import Strip
from textual.widget import Widget

from reliefscope.models.apertures import GLASS_SHAPE, centroid_mm, pixel_centres_mm
from reliefscope.models.instrument import GlassModel
from reliefscope.models.plan import Aperture
from reliefscope.units import BoolImage

BRAILLE_BITS = np.array([[0, 3], [1, 4], [2, 5], [6, 7]])
"""Bit of each dot of a braille cell of 4 rows x 2 columns."""
CELLS = (16, 64)
ZOOM_ROWS = 16
ZOOM_COLUMNS = 32
"""Pixels around the middle that the enlarged form shows: 32 x 16 of them, two cells wide and one high."""


def braille(bitmap: BoolImage) -> NDArray[np.uint8]:
    """Dots (16, 64) of a bitmap (64, 128): one byte per braille cell."""
    cells = bitmap.reshape(16, 4, 64, 2).transpose(0, 2, 1, 3)
    dots: NDArray[np.uint8] = (cells << BRAILLE_BITS).sum(axis=(2, 3)).astype(np.uint8)
    return dots


def pupil_outline(glass: GlassModel, diameter_mm: float) -> BoolImage:
    """Pixels (64, 128) on the rim of the pupil."""
    x_mm, y_mm = pixel_centres_mm(glass)
    inside = np.hypot(x_mm[None, :], y_mm[:, None]) <= diameter_mm / 2
    core = inside.copy()
    core[1:-1, 1:-1] = inside[:-2, 1:-1] & inside[2:, 1:-1] & inside[1:-1, :-2] & inside[1:-1, 2:]
    rim: BoolImage = inside & ~core
    return rim


class GlassView(Widget, can_focus=True):
    """Shows what the glass is told to show; a click or the keys choose among the plan's apertures."""

    DEFAULT_CSS = """
    GlassView { width: 66; height: 18; }
    """
    BINDINGS = [
        Binding("left,up", "step(-1)", "Previous", show=False),
        Binding("right,down", "step(1)", "Next", show=False),
        Binding("z", "zoom", "Zoom", show=False),
    ]
    zoomed = reactive(False)
    COMPONENT_CLASSES = {"glass--open", "glass--rim", "glass--shut"}

    class Chosen(Message):
        """An aperture was chosen."""

        def __init__(self, aperture: Aperture) -> None:
            super().__init__()
            self.aperture = aperture

    def __init__(self, *, id: str | None = None) -> None:  # noqa: A002 - textual's own name
        super().__init__(id=id)
        self._bitmap: BoolImage = np.zeros(GLASS_SHAPE, bool)
        self._rim: BoolImage = np.zeros(GLASS_SHAPE, bool)
        self._glass: GlassModel | None = None
        self._apertures: tuple[Aperture, ...] = ()
        self._centroids: list[tuple[float, float]] = []

    def set_up(
        self, glass: GlassModel, pupil_diameter_mm: float, apertures: Sequence[Aperture]
    ) -> None:
        """Tell which glass this is and which apertures can be chosen."""
        self._glass = glass
        self._rim = pupil_outline(glass, pupil_diameter_mm)
        self._apertures = tuple(apertures)
        self._centroids = [centroid_mm(aperture.bitmap, glass) for aperture in self._apertures]
        self.refresh()

    def show(self, bitmap: BoolImage, name: str) -> None:
        """Show ``bitmap`` (64, 128) under its name."""
        self._bitmap = bitmap
        self.border_subtitle = f"{name} · {int(bitmap.sum())} px open"
        self.refresh()

    @property
    def bitmap(self) -> BoolImage:
        """What is shown."""
        return self._bitmap

    def action_zoom(self) -> None:
        """Change between the whole glass and the pupil enlarged."""
        self.zoomed = not self.zoomed

    def action_step(self, by: int) -> None:
        """Choose the next or previous aperture."""
        if not self._apertures:
            return
        shown = [
            index
            for index, aperture in enumerate(self._apertures)
            if np.array_equal(aperture.bitmap, self._bitmap)
        ]
        index = (shown[0] + by) % len(self._apertures) if shown else 0
        self.post_message(self.Chosen(self._apertures[index]))

    def on_click(self, event: Click) -> None:
        """Choose the aperture nearest to the clicked place of the glass."""
        offset = event.get_content_offset(self)
        if offset is None or self._glass is None or not self._apertures:
            return
        row, column = self._pixel_at(offset.x, offset.y)
        x_mm, y_mm = pixel_centres_mm(self._glass)
        x = float(np.interp(column, np.arange(x_mm.size), x_mm))
        y = float(np.interp(row, np.arange(y_mm.size), y_mm))
        distances = [math.hypot(x - cx, y - cy) for cx, cy in self._centroids]
        self.post_message(self.Chosen(self._apertures[int(np.argmin(distances))]))

    def _pixel_at(self, x: int, y: int) -> tuple[float, float]:
        """Pixel (row, column) in the middle of a cell."""
        if self.zoomed:
            top, left = self._zoom_corner()
            return top + y, left + x // 2
        return 4 * y + 1.5, 2 * x + 0.5

    @staticmethod
    def _zoom_corner() -> tuple[int, int]:
        return (GLASS_SHAPE[0] - ZOOM_ROWS) // 2, (GLASS_SHAPE[1] - ZOOM_COLUMNS) // 2

    def render_line(self, y: int) -> Strip:
        """One row of cells."""
        width = self.size.width
        strip = self._zoomed_line(y) if self.zoomed else self._exact_line(y)
        return strip.adjust_cell_length(width, self.rich_style)

    def _styles(self) -> tuple[Style, Style, Style]:
        return (
            self.get_component_rich_style("glass--open"),
            self.get_component_rich_style("glass--rim"),
            self.get_component_rich_style("glass--shut"),
        )

    def _exact_line(self, y: int) -> Strip:
        if y >= CELLS[0]:
            return Strip([])
        open_style, rim_style, _ = self._styles()
        open_dots = braille(self._bitmap)[y].tolist()
        rim_dots = braille(self._rim)[y].tolist()
        segments = []
        for open_cell, rim_cell in zip(open_dots, rim_dots, strict=True):
            dots, style = (open_cell, open_style) if open_cell else (rim_cell, rim_style)
            segments.append(Segment(chr(0x2800 + dots), style))
        return Strip(segments)

    def _zoomed_line(self, y: int) -> Strip:
        if y >= ZOOM_ROWS:
            return Strip([])
        open_style, rim_style, shut_style = self._styles()
        top, left = self._zoom_corner()
        segments = []
        for column in range(left, left + ZOOM_COLUMNS):
            if self._bitmap[top + y, column]:
                segments.append(Segment("██", open_style))
            elif self._rim[top + y, column]:
                segments.append(Segment("░░", rim_style))
            else:
                segments.append(Segment("··", shut_style))
        return Strip(segments)
