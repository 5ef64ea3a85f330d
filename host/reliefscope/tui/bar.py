"""The line that names the instrument, as much of it as there is room for."""

from __future__ import annotations

from dataclasses import dataclass

from rich.cells import cell_len
from rich.markup import escape
from textual.events import Resize
from textual.widgets import Static


@dataclass(frozen=True, slots=True)
class InstrumentLine:
    """What is connected."""

    profile: str
    url: str
    board: str
    firmware: str
    calibration: str

    def fit(self, width: int) -> str:
        """Markup of at most ``width`` cells where possible.

        The options of the address go first, then the board, then the address: the messages show it as well.
        """
        address = self.url.partition("?")[0]
        short = f"{address}?…" if address != self.url else address
        for url, board in ((self.url, self.board), (short, self.board), (short, ""), ("", "")):
            facts = [board] if board else []
            facts += [f"firmware {self.firmware}", f"calibration {self.calibration}"]
            parts = [self.profile, *([url] if url else []), ", ".join(facts)]
            if cell_len("  ".join(parts)) <= width:
                break
        name, *middle, last = (escape(part) for part in parts)
        return "  ".join([f"[b]{name}[/]", *middle, f"[dim]{last}[/]"])


class InstrumentBar(Static):
    """The line of the connected instrument, or any other text."""

    _line: InstrumentLine | None = None

    def show_instrument(self, line: InstrumentLine) -> None:
        """Name what is connected, now and after every change of the room."""
        self._line = line
        self._refit()

    def show_text(self, markup: str) -> None:
        """Say something else."""
        self._line = None
        self.update(markup)

    def on_resize(self, _: Resize) -> None:
        """Use the new room."""
        self._refit()

    def _refit(self) -> None:
        if self._line is not None:
            self.update(self._line.fit(self.content_size.width))
