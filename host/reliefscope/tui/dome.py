"""The dome of LEDs seen from above: click one to turn it on or off."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from rich.segment import Segment
from rich.style import Style
from textual.binding import Binding
from textual.events import Click
from textual.message import Message
from textual.reactive import reactive
from textual.strip import Strip
from textual.widget import Widget

from reliefscope.axes import elevation_azimuth

LABEL_CELLS = 4
CURSOR = Style(bold=True, reverse=True)


class DomeMap(Widget, can_focus=True):
    """LEDs by azimuth (counter-clockwise from the right) and zenith distance (rim: the sample plane)."""

    DEFAULT_CSS = "DomeMap { width: 1fr; height: 1fr; min-width: 36; min-height: 13; }"
    COMPONENT_CLASSES = {"dome--on", "dome--off", "dome--ring", "dome--sample"}
    BINDINGS = [
        Binding("left", "move(0,-1)", "LED", show=False),
        Binding("right", "move(0,1)", "LED", show=False),
        Binding("up", "move(1,0)", "Ring", show=False),
        Binding("down", "move(-1,0)", "Ring", show=False),
        Binding("enter,space", "switch", "LED on/off", show=False),
    ]
    cursor = reactive(0)

    class Toggled(Message):
        """An LED was clicked."""

        def __init__(self, led: int) -> None:
            super().__init__()
            self.led = led

    def __init__(self, *, id: str | None = None) -> None:  # noqa: A002 - textual's own name
        super().__init__(id=id)
        self._angles: list[tuple[float, float]] = []
        self._levels: dict[int, int] = {}
        self._full = 4095

    def set_up(self, positions_mm: Sequence[Sequence[float]], full_level: int) -> None:
        """Tell where the LEDs sit: positions (N, 3) in the world frame."""
        self._angles = [elevation_azimuth(position) for position in positions_mm]
        self._full = full_level
        self.cursor = 0
        self.refresh()

    def show(self, levels: Mapping[int, int]) -> None:
        """Show which LEDs are on: LED index -> level."""
        self._levels = dict(levels)
        on = len(self._levels)
        if not self._levels:
            self.border_subtitle = "all off"
        else:
            strongest = max(self._levels.values()) / self._full
            self.border_subtitle = f"{on} on · {100 * strongest:.0f} %"
        self.set_class(bool(on), "lit")
        self.refresh()

    @property
    def lit(self) -> frozenset[int]:
        """LEDs shown as on."""
        return frozenset(self._levels)

    def cell_of(self, led: int) -> tuple[int, int]:
        """Cell (column, row) at the middle of an LED's label, within the content."""
        elevation, azimuth = self._angles[led]
        centre_x, centre_y, radius_x, radius_y = self._frame()
        reach = (math.pi / 2 - elevation) / (math.pi / 2)
        x = centre_x + reach * radius_x * math.cos(azimuth)
        y = centre_y - reach * radius_y * math.sin(azimuth)
        return round(x), round(y)

    def _frame(self) -> tuple[float, float, float, float]:
        width, height = max(self.size.width, 8), max(self.size.height, 5)
        radius_y = min((height - 1) / 2, (width - LABEL_CELLS) / 4) / 0.8
        return (width - 1) / 2, (height - 1) / 2, 2 * radius_y, radius_y

    def on_click(self, event: Click) -> None:
        """Toggle the LED whose label is under the pointer, or nearest to it within two cells."""
        offset = event.get_content_offset(self)
        if offset is None or not self._angles:
            return
        distances = []
        for led in range(len(self._angles)):
            x, y = self.cell_of(led)
            distances.append(math.hypot((offset.x - x) / 2, offset.y - y))
        nearest = min(range(len(distances)), key=distances.__getitem__)
        if distances[nearest] <= 1.5:
            self.cursor = nearest
            self.post_message(self.Toggled(nearest))

    def action_switch(self) -> None:
        """Toggle the LED under the cursor."""
        if self._angles:
            self.post_message(self.Toggled(self.cursor))

    def action_move(self, up: int, around: int) -> None:
        """Move the cursor around its ring, or to the nearest LED of the next ring."""
        if not self._angles:
            return
        elevation, azimuth = self._angles[self.cursor]
        if around:
            ring = [led for led, angles in enumerate(self._angles) if _same(angles[0], elevation)]
            ring.sort(key=lambda led: self._angles[led][1] % math.tau)
            self.cursor = ring[(ring.index(self.cursor) + around) % len(ring)]
            return
        others = [
            led for led, angles in enumerate(self._angles) if up * (angles[0] - elevation) > 1e-6
        ]
        if others:
            self.cursor = min(
                others,
                key=lambda led: (
                    round(abs(self._angles[led][0] - elevation), 6),
                    abs(math.remainder(self._angles[led][1] - azimuth, math.tau)),
                ),
            )

    def render_line(self, y: int) -> Strip:
        """One row: rings of dots, the sample in the middle, a label per LED."""
        width = self.size.width
        if not self._angles:
            return Strip.blank(width, self.rich_style)
        ring, sample = self._style("dome--ring"), self._style("dome--sample")
        cells: list[tuple[str, Style]] = [(" ", self.rich_style)] * width
        for x in self._ring_cells(y):
            if 0 <= x < width:
                cells[x] = ("·", ring)
        centre_x, centre_y, _, _ = self._frame()
        if y == round(centre_y):
            cells[round(centre_x)] = ("◇", sample)
        for led in range(len(self._angles)):
            x, row = self.cell_of(led)
            if row == y:
                self._write_label(cells, led, x)
        return Strip([Segment(text, style) for text, style in cells], width)

    def _write_label(self, cells: list[tuple[str, Style]], led: int, x: int) -> None:
        style = self._style("dome--on" if led in self._levels else "dome--off")
        text = f" {led:>2d} "
        if led == self.cursor and self.has_focus:
            style = style if led in self._levels else Style.combine((style, CURSOR))
            text = f"[{led:>2d}]"
        left = min(max(x - LABEL_CELLS // 2 + 1, 0), len(cells) - LABEL_CELLS)
        for index, letter in enumerate(text):
            cells[left + index] = (letter, style)

    def _style(self, name: str) -> Style:
        return self.get_component_rich_style(name)

    def _ring_cells(self, y: int) -> list[int]:
        """Columns where a circle of LEDs crosses this row."""
        centre_x, centre_y, radius_x, radius_y = self._frame()
        columns = []
        for reach in {
            round((math.pi / 2 - angles[0]) / (math.pi / 2), 6) for angles in self._angles
        }:
            for step in range(96):
                azimuth = math.tau * step / 96
                if round(centre_y - reach * radius_y * math.sin(azimuth)) == y:
                    columns.append(round(centre_x + reach * radius_x * math.cos(azimuth)))
        return columns


def _same(one: float, other: float) -> bool:
    return abs(one - other) < 1e-6
