"""The screen: picture, glass, dome, acquisition, messages.

Everything that talks to the instrument goes through :class:`~reliefscope.tui.engine.Engine`; this module only
draws what is known and passes on what the user wants.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import ClassVar

from rich.markup import escape
from textual import on
from textual.app import App, ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.widgets import Footer, Input, ProgressBar, RichLog, Static

from reliefscope.device import PortInfo, list_ports
from reliefscope.microscope import default_devices, fresh_path
from reliefscope.models.plan import Aperture
from reliefscope.tui.bar import InstrumentBar, InstrumentLine
from reliefscope.tui.dome import DomeMap
from reliefscope.tui.engine import (
    Advanced,
    Connected,
    Disconnected,
    Ended,
    Engine,
    Failed,
    Opener,
    StateChanged,
)
from reliefscope.tui.glass import GlassView
from reliefscope.tui.preview import Preview
from reliefscope.tui.screens import AcquireRequest, AcquireScreen, ConnectScreen, HelpScreen
from reliefscope.tui.theme import THEME
from reliefscope.units import format_duration

PERIOD_S = 0.1
"""Time between pictures when the terminal keeps up."""
SLOWEST_S = 0.5
NARROW = 130
EXPOSURE_STEP = 2**0.5
LEVEL_STEP = 2.0
READY = "[dim]press [b]a[/b] to take a run[/]"
SHORTEST_US, LONGEST_US = 20, 2_000_000


def found_devices() -> list[tuple[str, str]]:
    """(URL, description) of ports and of instruments that need no hardware."""
    ports = [(port.port, _describe(port)) for port in list_ports()]
    return ports + default_devices()


def _describe(port: PortInfo) -> str:
    name = "Teensy" if port.is_teensy else port.description.replace("n/a", "") or "serial port"
    return f"{name} {port.serial_number}".strip()


class ReliefscopeApp(App[None]):
    """The application; ``opener`` opens the instrument behind a URL."""

    TITLE = "reliefscope"
    CSS_PATH = "theme.tcss"
    ENABLE_COMMAND_PALETTE = False
    HORIZONTAL_BREAKPOINTS = [(0, "-narrow"), (NARROW, "-wide")]
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("o", "off_key", "All LEDs off", priority=True),
        Binding("ctrl+o", "all_off", show=False, priority=True),
        Binding("a", "acquire", "Acquire"),
        Binding("c", "connect", "Connect"),
        Binding("question_mark", "help", "Keys", key_display="?"),
        Binding("q", "quit", "Quit"),
        Binding("escape", "pause", "Pause", show=False),
        Binding("left_square_bracket", "aperture(-1)", "Aperture", key_display="[ ]"),
        Binding("right_square_bracket", "aperture(1)", show=False),
        Binding("0", "centre", "Centre", show=False),
        Binding("s", "shut", "Shut"),
        Binding("z", "zoom", "Zoom"),
        Binding("g", "swap", "Glass/dome", show=False),
        Binding("plus,equals_sign", "exposure(1)", "Exposure", key_display="+ -"),
        Binding("minus", "exposure(-1)", show=False),
        Binding("greater_than_sign", "level(1)", "Level", key_display="< >"),
        Binding("less_than_sign", "level(-1)", show=False),
        Binding("x", "stretch", "Contrast"),
    ]

    def __init__(
        self,
        opener: Opener,
        device_url: str | None = None,
        devices: Callable[[], Sequence[tuple[str, str]]] = found_devices,
    ) -> None:
        super().__init__()
        self._device_url = device_url
        self._devices = devices
        self._apertures: tuple[Aperture, ...] = ()
        self._period_s = PERIOD_S
        self._last_tick = 0.0
        self._last_put: list[float] = []
        self._level = 4095
        self.preview = Preview(id="preview")
        self.glass = GlassView(id="glass")
        self.dome = DomeMap(id="dome")
        self._instrument_bar = InstrumentBar("not connected", id="bar-instrument")
        self._light_bar = Static("light off", id="bar-light")
        self._camera_panel = Vertical(id="preview-panel", classes="panel")
        self._camera_line = Static("", id="preview-state")
        self._messages = RichLog(
            id="messages", classes="panel", markup=True, wrap=True, min_width=20, max_lines=500
        )
        self._stage_line = Static(READY, id="acquisition-line")
        self._progress = ProgressBar(total=100, id="progress", show_eta=False)
        self._left_line = Static("", id="acquisition-left")
        self.engine = Engine(self.post_message, lambda: self.preview.room, opener)

    # Layout -----------------------------------------------------------------------------------

    def compose(self) -> ComposeResult:
        """Bar, picture and messages on the left, glass, dome and acquisition on the right, keys below."""
        with Horizontal(id="bar"):
            yield Static("reliefscope", id="bar-name")
            yield self._instrument_bar
            yield self._light_bar
        with Horizontal(id="body"):
            with Vertical(id="left"):
                with self._camera_panel:
                    yield self.preview
                    yield self._camera_line
                yield self._messages
            with Vertical(id="right"):
                yield self.glass
                yield self.dome
                with Vertical(id="acquisition", classes="panel") as acquisition:
                    acquisition.border_title = "Acquisition"
                    yield self._stage_line
                    yield self._progress
                    yield self._left_line
        yield Footer(show_command_palette=False)

    def on_mount(self) -> None:
        """Name the panels, start the clock of the picture, connect."""
        self.register_theme(THEME)
        self.theme = THEME.name
        self._camera_panel.border_title = "Camera"
        self._messages.border_title = "Messages"
        self._messages.can_focus = False
        self.glass.border_title = "Glass"
        self.glass.add_class("panel")
        self.dome.border_title = "Lights"
        self.dome.add_class("panel")
        self.dome.focus()
        self._last_tick = time.monotonic()
        self.set_timer(self._period_s, self._tick)
        if self._device_url is None:
            self.action_connect()
        else:
            self._connect(self._device_url)

    def on_unmount(self) -> None:
        """Light off, instrument let go."""
        self.engine.close()

    def say(self, text: str) -> None:
        """A line in the messages; ``text`` is markup."""
        stamp = time.strftime("%H:%M:%S")
        self._messages.write(f"[dim]{stamp}[/] {text}", expand=True)

    # The picture ------------------------------------------------------------------------------

    def _tick(self) -> None:
        """Show the newest picture; slow down where the terminal does not keep up."""
        now = time.monotonic()
        late = now - self._last_tick - self._period_s
        self._last_tick = now
        if late > 0.5 * self._period_s:
            self._period_s = min(SLOWEST_S, self._period_s * 1.3)
        else:
            self._period_s = max(PERIOD_S, self._period_s * 0.95)
        picture = self.engine.take_picture()
        if picture is not None:
            self.preview.put(picture.levels)
            self._last_put = [*self._last_put[-19:], now]
            spread = self._last_put[-1] - self._last_put[0]
            rate = (len(self._last_put) - 1) / spread if spread > 0 else 0.0
            saturated = f"[red]{100 * picture.saturated:.1f} % saturated[/]"
            self._camera_line.update(
                f" [b]{picture.exposure_us / 1000:g} ms[/]   mean [b]{100 * picture.mean:.1f} %[/]   "
                f"{saturated if picture.saturated > 0.0005 else 'none saturated'}"
                f"   {rate:.1f}/s{'   stretched' if self.engine.stretch else ''}"
            )
        self.set_timer(self._period_s, self._tick)

    # What the engine tells --------------------------------------------------------------------

    def on_connected(self, event: Connected) -> None:
        """Fill the panels with what this instrument has."""
        microscope = event.microscope
        profile, identity = microscope.profile, microscope.identity
        plan = microscope.default_plan()
        self._apertures = (*plan.views, *([plan.centre] if plan.centre else []))
        self._level = profile.dome.full_level
        self.glass.set_up(profile.glass, profile.optics.pupil_diameter_mm, self._apertures)
        self.dome.set_up(microscope.calibration.led_positions_mm, profile.dome.full_level)
        self._instrument_bar.show_instrument(
            InstrumentLine(
                profile=profile.name,
                url=microscope.device.url,
                board=identity.board,
                firmware=identity.firmware_version,
                calibration=microscope.calibration.source,
            )
        )
        self.say(f"Connected to [b]{escape(microscope.device.url)}[/].")
        camera = microscope.camera_info
        if camera is None:
            self.say("[yellow]No camera: glass and lights only.[/] Give one with --camera URL.")
            self._camera_line.update(" no camera")
        else:
            rows, columns = camera.shape
            self._camera_panel.border_subtitle = (
                f"{camera.model} · {columns} x {rows} · {camera.bit_depth} bit"
            )
        self._show_state()

    def on_disconnected(self, _: Disconnected) -> None:
        """Empty the picture."""
        self._show_unconnected()
        self.preview.clear()

    def _show_unconnected(self) -> None:
        self._instrument_bar.show_text("not connected")
        self._clear_acquisition()
        self._light_bar.update("light off")
        self._light_bar.remove_class("lit")
        self._camera_panel.border_subtitle = ""
        self._camera_line.update(" press [b]c[/b] to connect")

    def _clear_acquisition(self) -> None:
        self._stage_line.update(READY)
        self._progress.update(total=100, progress=0)
        self._left_line.update("")

    def on_state_changed(self, _: StateChanged) -> None:
        """Draw what the device confirmed."""
        self._show_state()

    def on_failed(self, event: Failed) -> None:
        """Show the error with its hint, where it stays until the next one."""
        self._messages.add_class("error")
        if self.engine.microscope is None:
            self._show_unconnected()
        self.say(f"[bold red]Could not {escape(event.doing)}:[/] {escape(event.error.message)}")
        for line in event.error.hint.splitlines():
            self.say(f"  [cyan]{escape(line)}[/]")

    def on_advanced(self, event: Advanced) -> None:
        """Progress of the acquisition."""
        progress = event.progress
        if progress.done == 0:
            self._show_state()
            self._light_bar.update("sequence")
            self._light_bar.add_class("lit")
        self._progress.update(total=max(progress.total, 1), progress=progress.done)
        stage = progress.stage.replace("_", " ")
        self._stage_line.update(
            f"[b]{stage}[/]  {progress.done}/{progress.total}  {escape(progress.note)}"
        )
        left = progress.seconds_left
        self._left_line.update(
            "" if left is None else f"{format_duration(left)} left · [b]escape[/] pauses"
        )

    def on_ended(self, event: Ended) -> None:
        """Tell where the run is, or why there is none."""
        self._left_line.update("")
        if event.run is None:
            self._stage_line.update(f"[yellow]{escape(event.note)}[/]")
            self.say(f"[yellow]Acquisition:[/] {escape(event.note)}")
            if event.hint:
                self.say(f"  [cyan]{escape(event.hint)}[/]")
            return
        path = escape(str(event.run.path))
        self._stage_line.update(f"[green]complete[/]  {path}")
        self._messages.remove_class("error")
        self.say(f"[green]Run complete:[/] [b]{path}[/]")
        self.say(f"  Next: [cyan]reliefscope reconstruct {path}[/]")

    def _show_state(self) -> None:
        microscope = self.engine.microscope
        if microscope is None:
            return
        self.glass.show(microscope.aperture, microscope.aperture_name)
        self.dome.show(microscope.light)
        count = len(microscope.light)
        self._light_bar.update(
            f"{count} LED{'s' if count != 1 else ''} on" if count else "light off"
        )
        self._light_bar.set_class(bool(count), "lit")

    # What the user wants ----------------------------------------------------------------------

    @on(GlassView.Chosen)
    def _chosen(self, event: GlassView.Chosen) -> None:
        self.engine.show_aperture(event.aperture)

    @on(DomeMap.Toggled)
    def _toggled(self, event: DomeMap.Toggled) -> None:
        self.engine.toggle_led(event.led, self._level)

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Let `o` be a letter while somebody types; ctrl+o works there as well."""
        del parameters
        return not (action == "off_key" and isinstance(self.focused, Input))

    def action_off_key(self) -> None:
        """Every LED off."""
        self.action_all_off()

    def action_all_off(self) -> None:
        """Every LED off, whatever else goes on."""
        self.engine.all_off()
        self.say("All LEDs off.")

    def action_aperture(self, by: int) -> None:
        """Next or previous aperture."""
        self.glass.action_step(by)

    def action_centre(self) -> None:
        """The disc on the axis."""
        if self._apertures:
            self.engine.show_aperture(self._apertures[-1])

    def action_shut(self) -> None:
        """Shut the glass."""
        self.engine.shut()

    def action_zoom(self) -> None:
        """Whole glass or pupil."""
        self.glass.action_zoom()

    def action_swap(self) -> None:
        """Glass or dome, where there is room for one."""
        self.screen.toggle_class("-glass")

    def action_exposure(self, direction: int) -> None:
        """Longer or shorter exposure of the live picture."""
        microscope = self.engine.microscope
        if microscope is None:
            return
        wanted = microscope.live_exposure_us * EXPOSURE_STEP**direction
        self.engine.set_exposure(10 * round(min(max(wanted, SHORTEST_US), LONGEST_US) / 10))

    def action_level(self, direction: int) -> None:
        """Brighter or dimmer LEDs."""
        self._level = round(min(max(self._level * LEVEL_STEP**direction, 16), 4095))
        self.engine.set_level(self._level)

    def action_stretch(self) -> None:
        """Contrast as it is, or stretched."""
        self.engine.stretch = not self.engine.stretch

    def action_connect(self) -> None:
        """Choose an instrument."""
        if self.engine.busy:
            self.say("[yellow]An acquisition is under way;[/] escape pauses it.")
            return

        def chosen(url: str | None) -> None:
            if url:
                self._connect(url)

        self.push_screen(ConnectScreen(self._devices()), chosen)

    def _connect(self, url: str) -> None:
        self._instrument_bar.show_text(f"connecting to {escape(url)} …")
        self.engine.connect(url)

    def action_acquire(self) -> None:
        """Ask where to, then take a run."""
        microscope = self.engine.microscope
        if microscope is None or self.engine.busy:
            self.say(
                "[yellow]No instrument is connected;[/] press [b]c[/]."
                if microscope is None
                else "[yellow]An acquisition is under way;[/] escape pauses it."
            )
            return
        plan = microscope.default_plan()

        def start(request: AcquireRequest | None) -> None:
            if request is not None:
                self._messages.remove_class("error")
                self.say(f"Acquiring [b]{escape(str(request.out))}[/].")
                self.engine.acquire(plan, request.out, request.sample, request.notes)

        self.push_screen(AcquireScreen(self._next_run(), microscope.plan_summary(plan)), start)

    @staticmethod
    def _next_run() -> Path:
        return fresh_path("run")

    def action_pause(self) -> None:
        """Pause the acquisition."""
        if self.engine.busy:
            self.engine.cancel()
            self.say("Pausing after the current frame.")

    def action_help_quit(self) -> None:
        """Ctrl-C, which a terminal user may mean for a copy: tell the keys that do leave."""
        self.notify("Press q to quit, ctrl+q while typing.", title="Quit?")

    def action_help(self) -> None:
        """Every key."""
        self.push_screen(HelpScreen())
