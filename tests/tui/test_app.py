"""The screen, driven by a pilot, over a microscope that remembers what it was told."""

from collections.abc import Awaitable, Callable
from pathlib import Path

import numpy as np
import pytest
from tests.tui.fakes import FakeMicroscope
from textual.pilot import Pilot
from textual.widgets import Input

from reliefscope.errors import DeviceError
from reliefscope.microscope import Microscope, open_run
from reliefscope.tui.app import ReliefscopeApp
from reliefscope.tui.bar import InstrumentLine
from reliefscope.tui.dome import DomeMap
from reliefscope.tui.engine import Picture
from reliefscope.tui.glass import GlassView
from reliefscope.tui.screens import AcquireScreen, ConnectScreen, HelpScreen

URL = "fake://bench"
DEVICES = [("/dev/ttyFAKE", "a port"), (URL, "the bench")]


class Desk:
    """The application and every microscope that it opened."""

    def __init__(self, url: str | None = URL) -> None:
        self.opened: list[FakeMicroscope] = []
        self.refuse: DeviceError | None = None
        self.app = ReliefscopeApp(self._open, url, lambda: DEVICES)  # type: ignore[arg-type]

    def _open(self, url: str) -> FakeMicroscope:
        if self.refuse is not None:
            raise self.refuse
        self.opened.append(FakeMicroscope(url))
        return self.opened[-1]

    @property
    def microscope(self) -> FakeMicroscope:
        return self.opened[-1]

    @property
    def messages(self) -> str:
        """All of them in one line, however the panel wraps."""
        return " ".join(" ".join(strip.text for strip in self.app._messages.lines).split())


async def until(pilot: Pilot[None], ready: Callable[[], object], seconds: float = 20.0) -> None:
    for _ in range(round(seconds / 0.02)):
        if ready():
            return
        await pilot.pause(0.02)
    pytest.fail("the screen did not get there in time")


Driven = Callable[[Pilot[None], Desk], Awaitable[None]]


async def drive(steps: Driven, size: tuple[int, int] = (132, 42), url: str | None = URL) -> Desk:
    desk = Desk(url)
    async with desk.app.run_test(size=size) as pilot:
        if url is not None:
            await until(pilot, lambda: "Connected" in desk.messages)
        await steps(pilot, desk)
    return desk


async def test_live_picture_is_shown() -> None:
    async def steps(pilot: Pilot[None], desk: Desk) -> None:
        await until(pilot, lambda: desk.app.preview.shown >= 3)
        line = desk.app.preview.render_line(desk.app.preview.size.height // 2)
        assert len(list(line)) > 5

    desk = await drive(steps)
    assert desk.microscope.calls[-1] == ("close",)


async def test_clicked_led_goes_on_and_off() -> None:
    async def steps(pilot: Pilot[None], desk: Desk) -> None:
        dome = desk.app.query_one(DomeMap)
        column, row = dome.cell_of(5)
        spot = (column + dome.gutter.left, row + dome.gutter.top)
        await pilot.click(DomeMap, offset=spot)
        await until(pilot, lambda: dome.lit == {5})
        assert desk.microscope.light == {5: 4095}
        await pilot.press("right", "enter")
        await until(pilot, lambda: dome.lit == {5, 6})
        await pilot.click(DomeMap, offset=spot)
        await until(pilot, lambda: dome.lit == {6})

    await drive(steps)


async def test_one_key_turns_all_leds_off_everywhere() -> None:
    async def steps(pilot: Pilot[None], desk: Desk) -> None:
        for keys in ((), ("question_mark",), ("a",), ("c",)):
            desk.app.dome.focus()
            await pilot.press("enter")
            await until(pilot, lambda: desk.app.dome.lit == {0})
            off = "ctrl+o" if keys == ("a",) else "o"  # its folder field has the focus
            await pilot.press(*keys, off)
            await until(pilot, lambda: not desk.app.dome.lit)
            if keys:
                await pilot.press("escape")
        assert desk.microscope.calls.count(("all_off",)) == 4
        await pilot.press("enter", "c")
        await until(pilot, lambda: desk.app.dome.lit == {0})
        await pilot.click("#url")
        await pilot.press("o")
        assert desk.app.screen.query_one("#url", Input).value == "o", "a letter while typing"
        await pilot.press("ctrl+o")
        await until(pilot, lambda: not desk.app.dome.lit)

    await drive(steps)


async def test_apertures_by_key_and_by_click() -> None:
    async def steps(pilot: Pilot[None], desk: Desk) -> None:
        await pilot.press("right_square_bracket")
        await until(pilot, lambda: desk.microscope.aperture_name == "disc-00")
        await until(pilot, lambda: bool(desk.app.glass.bitmap.any()))
        await pilot.press("right_square_bracket")
        await until(pilot, lambda: desk.microscope.aperture_name == "disc-01")
        await until(pilot, lambda: np.array_equal(desk.app.glass.bitmap, desk.microscope.aperture))
        await pilot.press("0")
        await until(pilot, lambda: desk.microscope.aperture_name == "centre")
        await pilot.press("s")
        await until(pilot, lambda: not desk.app.glass.bitmap.any())
        plan = desk.microscope.default_plan()
        rows, columns = np.nonzero(plan.views[7].bitmap)
        glass = desk.app.query_one(GlassView)
        x = round(columns.mean() / 2) + glass.gutter.left
        y = round(rows.mean() // 4) + glass.gutter.top
        await pilot.click(GlassView, offset=(x, y))
        await until(pilot, lambda: desk.microscope.aperture_name == "disc-07")

    await drive(steps)


async def test_exposure_and_level() -> None:
    async def steps(pilot: Pilot[None], desk: Desk) -> None:
        await pilot.press("plus")
        await until(pilot, lambda: desk.microscope.live_exposure_us == 28_280)
        await pilot.press("enter", "less_than_sign")
        await until(pilot, lambda: desk.microscope.light == {0: 2048})
        await pilot.press("x")
        await until(pilot, lambda: "stretched" in str(desk.app._camera_line.render()))

    await drive(steps)


async def test_acquisition_with_progress_and_end(tmp_path: Path) -> None:
    async def steps(pilot: Pilot[None], desk: Desk) -> None:
        desk.microscope.hold.clear()
        await pilot.press("a")
        assert isinstance(desk.app.screen, AcquireScreen)
        assert desk.app.focused is desk.app.screen.query_one("#out")
        desk.app.screen.query_one("#out", Input).value = str(tmp_path / "r1")
        desk.app.screen.query_one("#sample", Input).value = "basalt"
        await pilot.click("#start")
        await until(pilot, lambda: desk.app.engine.busy)
        desk.microscope.hold.set()
        await until(pilot, lambda: "Run complete" in desk.messages)
        assert ("acquire", tmp_path / "r1", "basalt", "") in desk.microscope.calls
        assert desk.app._progress.percentage == 1.0
        await until(pilot, lambda: not desk.app.engine.busy)
        assert "complete" in str(desk.app._stage_line.render())
        shown = desk.app.preview.shown
        await until(pilot, lambda: desk.app.preview.shown > shown)

    await drive(steps)


async def test_acquisition_pauses_on_escape() -> None:
    async def steps(pilot: Pilot[None], desk: Desk) -> None:
        desk.microscope.hold.clear()
        await pilot.press("a")
        await pilot.click("#start")
        await until(pilot, lambda: desk.app.engine.busy)
        await pilot.press("escape")
        desk.microscope.hold.set()
        await until(pilot, lambda: "Acquisition:" in desk.messages)
        assert "Run complete" not in desk.messages

    await drive(steps)


async def test_errors_are_shown_with_their_hint() -> None:
    async def steps(pilot: Pilot[None], desk: Desk) -> None:
        desk.microscope.refuse = DeviceError("The link [was] lost.", hint="Plug it in again.")
        await pilot.press("enter")
        await until(pilot, lambda: "Plug it in again." in desk.messages)
        assert "The link [was] lost." in desk.messages
        assert "switch LED 0" in desk.messages

    await drive(steps)


async def test_connect_dialog_lists_devices_and_takes_any_url() -> None:
    async def steps(pilot: Pilot[None], desk: Desk) -> None:
        await until(pilot, lambda: isinstance(desk.app.screen, ConnectScreen))
        await pilot.press("down", "enter")
        await until(pilot, lambda: "Connected" in desk.messages)
        assert desk.microscope.device.url == URL
        await pilot.press("c")
        await pilot.click("#url")
        await pilot.press(*"fake", "enter")
        await until(pilot, lambda: len(desk.opened) == 2)
        assert desk.opened[0].calls[-1] == ("close",)
        assert desk.microscope.device.url == "fake"

    await drive(steps, url=None)


async def test_refused_connection_leaves_the_screen_usable() -> None:
    async def steps(pilot: Pilot[None], desk: Desk) -> None:
        desk.refuse = DeviceError("Nobody answers.", hint="Is it plugged in?")
        await until(pilot, lambda: isinstance(desk.app.screen, ConnectScreen))
        await pilot.press("enter")
        await until(pilot, lambda: "Nobody answers." in desk.messages)
        await pilot.press("s")
        await until(pilot, lambda: "No instrument is connected." in desk.messages)

    await drive(steps, url=None)


async def test_failed_connection_clears_the_acquisition(tmp_path: Path) -> None:
    async def steps(pilot: Pilot[None], desk: Desk) -> None:
        await pilot.press("a")
        desk.app.screen.query_one("#out", Input).value = str(tmp_path / "r1")
        await pilot.press("enter")
        await until(pilot, lambda: "Run complete" in desk.messages)
        await until(pilot, lambda: not desk.app.engine.busy)
        desk.refuse = DeviceError("Nobody answers.", hint="Is it plugged in?")
        await pilot.press("c", "enter")
        await until(pilot, lambda: "Nobody answers." in desk.messages)
        assert "complete" not in str(desk.app._stage_line.render())
        assert desk.app._progress.progress == 0

    await drive(steps)


async def test_interrupt_tells_the_keys_that_quit() -> None:
    async def steps(pilot: Pilot[None], desk: Desk) -> None:
        await pilot.press("ctrl+c")
        await until(pilot, lambda: desk.app._notifications)
        (told,) = desk.app._notifications
        assert "Press q to quit" in told.message
        await pilot.press("q")
        await until(pilot, lambda: not desk.app.is_running)

    await drive(steps)


async def test_header_keeps_firmware_and_calibration_on_a_narrow_screen() -> None:
    async def steps(pilot: Pilot[None], desk: Desk) -> None:
        bar = desk.app._instrument_bar
        bar.show_instrument(
            InstrumentLine(
                "benchtop", "sim://benchtop?scene=fiducial&seed=1", "host", "0.1.0", "factory"
            )
        )
        text = str(bar.render())
        assert text == "benchtop  sim://benchtop?…  host, firmware 0.1.0, calibration factory"
        assert len(text) <= bar.content_size.width
        await pilot.resize_terminal(140, 30)
        await until(pilot, lambda: "seed=1" in str(bar.render()))
        await pilot.resize_terminal(75, 30)
        await until(pilot, lambda: "sim://" not in str(bar.render()))
        assert str(bar.render()).endswith("firmware 0.1.0, calibration factory")

    await drive(steps, (100, 30))


@pytest.mark.parametrize("size", [(180, 50), (100, 30)])
async def test_help_shows_every_key_and_both_sizes_fit(size: tuple[int, int]) -> None:
    async def steps(pilot: Pilot[None], desk: Desk) -> None:
        wide = size[0] >= 130
        assert desk.app.glass.display is wide
        assert desk.app.dome.size.height >= 11
        await pilot.press("question_mark")
        assert isinstance(desk.app.screen, HelpScreen)
        await pilot.press("escape")
        if not wide:
            await pilot.press("g")
            assert desk.app.glass.display
            assert not desk.app.dome.display

    await drive(steps, size)


async def test_whole_screen_over_the_simulated_instrument(tmp_path: Path) -> None:
    """Connect, light an LED, open the centre disc, see the picture brighten, acquire a run."""
    pictures = []

    def opener(url: str) -> Microscope:
        microscope = Microscope.open(url)
        plan = microscope.default_plan()
        small = plan.model_copy(
            update={
                "views": plan.views[:2],
                "lights": plan.lights[:2],
                "dark_accumulate": 1,
                "leakage_accumulate": 1,
            }
        )
        microscope.default_plan = lambda: small  # type: ignore[method-assign]
        return microscope

    app = ReliefscopeApp(opener, "sim://screen?scene=flat&size=96x72", list)
    async with app.run_test(size=(132, 42)) as pilot:
        take = app.engine.take_picture

        def watched() -> Picture | None:
            picture = take()
            if picture is not None:
                pictures.append(picture)
            return picture

        app.engine.take_picture = watched  # type: ignore[method-assign]
        await until(pilot, lambda: app.preview.shown >= 2)
        dark = pictures[-1].mean
        await pilot.press("0")
        await until(pilot, lambda: app.glass.bitmap.sum() > 0)
        await pilot.press("up", "enter")
        await until(pilot, lambda: len(app.dome.lit) == 1)
        await until(pilot, lambda: pictures[-1].mean > 3 * dark)
        await pilot.press("a")
        app.screen.query_one("#out", Input).value = str(tmp_path / "run")
        await pilot.click("#start")
        await until(pilot, lambda: not app.dome.lit)
        await until(pilot, (tmp_path / "run").is_dir)
        await until(pilot, lambda: not app.engine.busy)
    assert open_run(tmp_path / "run").verify().ok
