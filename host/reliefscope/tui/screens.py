"""The dialogs: connect, acquire, help."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

from rich.table import Table
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical, VerticalScroll
from textual.screen import ModalScreen
from textual.widgets import Button, Input, Label, OptionList, Static
from textual.widgets.option_list import Option


class ConnectScreen(ModalScreen[str | None]):
    """Choose an instrument: one of those that were found, or any URL.  Gives the URL, or None."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape", "cancel", "Close")]

    def __init__(self, choices: Sequence[tuple[str, str]]) -> None:
        """``choices`` are pairs of URL and description."""
        super().__init__()
        self._choices = list(choices)

    def compose(self) -> ComposeResult:
        """List, then a line for a URL."""
        with Vertical(classes="dialog") as dialog:
            dialog.border_title = "Connect"
            yield OptionList(
                *(
                    Option(
                        f"[b]{url.replace('[', chr(92) + '[')}[/]\n  [dim]{description}[/]",
                        id=str(index),
                    )
                    for index, (url, description) in enumerate(self._choices)
                ),
                id="choices",
            )
            yield Label("or any port or URL: COM3, socket://host:port, sim://name?scene=…")
            yield Input(placeholder="URL", id="url")

    def on_mount(self) -> None:
        """The list first."""
        self.query_one("#choices").focus()

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        """Take a listed one."""
        self.dismiss(self._choices[int(event.option.id or 0)][0])

    def on_input_submitted(self, event: Input.Submitted) -> None:
        """Take the typed one."""
        if event.value.strip():
            self.dismiss(event.value.strip())

    def action_cancel(self) -> None:
        """Leave things as they are."""
        self.dismiss(None)


@dataclass(frozen=True, slots=True)
class AcquireRequest:
    """What the dialog gives."""

    out: Path
    sample: str
    notes: str


class AcquireScreen(ModalScreen[AcquireRequest | None]):
    """Where to, what sample; shows what the plan takes and how long."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape", "cancel", "Close")]

    def __init__(self, out: Path, facts: Mapping[str, Any]) -> None:
        super().__init__()
        self._out = out
        self._facts = facts

    def compose(self) -> ComposeResult:
        """Facts of the plan, three fields, two buttons."""
        with VerticalScroll(classes="dialog") as dialog:
            dialog.border_title = "Acquire"
            table = Table.grid(padding=(0, 2))
            for name, value in self._facts.items():
                table.add_row(f"[cyan]{name.replace('_', ' ')}[/]", str(value))
            yield Static(table, id="plan-facts")
            yield Label("Folder of the new run")
            yield Input(str(self._out), id="out")
            yield Label("Sample")
            yield Input(placeholder="name of the sample", id="sample")
            yield Label("Notes")
            yield Input(placeholder="anything worth keeping", id="notes")
            with Horizontal(classes="buttons"):
                yield Button("Start", variant="primary", id="start")
                yield Button("Cancel", id="cancel")

    def on_mount(self) -> None:
        """The folder first; Enter starts from any field."""
        self.query_one("#out").focus()

    def on_button_pressed(self, event: Button.Pressed) -> None:
        """Start, or not."""
        if event.button.id == "start":
            self._start()
        else:
            self.dismiss(None)

    def on_input_submitted(self) -> None:
        """Enter in a field starts as well."""
        self._start()

    def _start(self) -> None:
        out = self.query_one("#out", Input).value.strip()
        self.dismiss(
            AcquireRequest(
                out=Path(out).expanduser() if out else self._out,
                sample=self.query_one("#sample", Input).value.strip(),
                notes=self.query_one("#notes", Input).value.strip(),
            )
        )

    def action_cancel(self) -> None:
        """Take nothing."""
        self.dismiss(None)


HELP: tuple[tuple[str, tuple[tuple[str, str], ...]], ...] = (
    (
        "Everywhere",
        (
            ("o", "all LEDs off, at once; an acquisition pauses (ctrl+o while typing)"),
            ("c", "connect to another instrument"),
            ("a", "acquire a run"),
            ("escape", "pause the acquisition after the current frame"),
            ("tab", "next panel"),
            ("q", "quit; the light goes off (ctrl+q while typing)"),
        ),
    ),
    (
        "Picture",
        (
            ("+ / -", "longer / shorter exposure"),
            ("x", "stretch the contrast; red cells are at full scale"),
        ),
    ),
    (
        "Glass",
        (
            ("[ / ]", "previous / next aperture; or click near its place"),
            ("0", "centre disc"),
            ("s", "shut"),
            ("z", "whole glass, every pixel as a dot / pupil enlarged"),
            ("g", "on a narrow screen: glass or dome"),
        ),
    ),
    (
        "Lights",
        (
            ("click", "LED on or off"),
            ("arrows", "move to an LED of the dome"),
            ("enter", "LED under the cursor on or off"),
            ("< / >", "dim / brighten what is on"),
        ),
    ),
)


class HelpScreen(ModalScreen[None]):
    """Every key."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape,question_mark,q", "close", "Close")]

    def compose(self) -> ComposeResult:
        """One table."""
        with VerticalScroll(classes="dialog") as dialog:
            dialog.border_title = "Keys"
            table = Table.grid(padding=(0, 2))
            table.add_column(justify="right", style="bold cyan", no_wrap=True)
            table.add_column()
            for title, keys in HELP:
                table.add_row("", f"[bold]{title}[/]")
                for key, meaning in keys:
                    table.add_row(key.replace("[", "\\["), meaning)
                table.add_row("", "")
            yield Static(table)

    def action_close(self) -> None:
        """Back."""
        self.dismiss(None)
