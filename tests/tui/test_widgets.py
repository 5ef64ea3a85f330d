"""What the widgets draw, against the bits and pixels they were given."""

import math

import numpy as np
import pytest
from textual.app import App, ComposeResult

from reliefscope.models.calibration import Calibration
from reliefscope.models.instrument import load_profile
from reliefscope.models.plan import pattern_apertures
from reliefscope.tui.dome import DomeMap
from reliefscope.tui.glass import GlassView, braille, pupil_outline
from reliefscope.tui.preview import EMPTY, GREYS, SATURATED, Preview, fit, shade

# Rows and columns of the dots 1 to 8 of a braille cell, as Unicode numbers them.
UNICODE_DOTS = [(0, 0), (1, 0), (2, 0), (0, 1), (1, 1), (2, 1), (3, 0), (3, 1)]


def test_braille_is_exact_for_every_pixel() -> None:
    bitmap = np.random.default_rng(3).random((64, 128)) < 0.3
    back = np.zeros_like(bitmap)
    for row, cells in enumerate(braille(bitmap)):
        for column, dots in enumerate(cells):
            for dot, (y, x) in enumerate(UNICODE_DOTS):
                back[4 * row + y, 2 * column + x] = bool(dots >> dot & 1)
    np.testing.assert_array_equal(back, bitmap)


def test_pupil_outline_is_a_closed_ring_of_the_right_size() -> None:
    profile = load_profile("benchtop")
    rim = pupil_outline(profile.glass, profile.optics.pupil_diameter_mm)
    rows, columns = np.nonzero(rim)
    assert np.ptp(columns) + 1 == pytest.approx(9.0 / profile.glass.pitch_x_mm, abs=1)
    assert np.ptp(rows) + 1 == pytest.approx(9.0 / profile.glass.pitch_y_mm, abs=1)
    assert not rim[32, 64]


@pytest.mark.parametrize(
    ("frame", "room", "expected"),
    [
        ((1038, 1388), (80, 110), (80, 107)),
        ((100, 100), (40, 20), (20, 20)),
        ((72, 96), (10, 4), (3, 4)),
    ],
)
def test_fit_keeps_the_aspect(
    frame: tuple[int, int], room: tuple[int, int], expected: tuple[int, int]
) -> None:
    assert fit(frame, room) == expected


def test_shade_shows_means_with_gamma_and_marks_saturation() -> None:
    raw = np.zeros((40, 40), np.uint16)
    raw[:20, 20:] = 4095
    raw[20:, :20] = round(4095 * 0.25**2.2)
    levels = shade(raw, 4095, (4, 8), mosaic=False, stretch=False)
    assert (levels[:, :2] == EMPTY).all()
    assert (levels[:, 6:] == EMPTY).all()
    assert (levels[:2, 2:4] == 0).all()
    assert (levels[:2, 4:6] == SATURATED).all()
    assert (levels[2:, 2:4] == round(0.25 * (GREYS - 1))).all()


def test_a_flat_mosaic_is_shown_flat() -> None:
    raw = np.empty((64, 64), np.uint16)
    raw[::2, ::2], raw[::2, 1::2], raw[1::2, ::2], raw[1::2, 1::2] = 400, 1200, 1200, 2500
    levels = shade(raw, 4095, (64, 64), mosaic=True, stretch=False)
    assert np.unique(levels).size == 1
    assert np.unique(shade(raw, 4095, (64, 64), mosaic=False, stretch=False)).size == 3


def test_stretch_uses_all_shades() -> None:
    raw = np.linspace(200, 400, 64 * 64).reshape(64, 64).astype(np.uint16)
    flat = shade(raw, 4095, (64, 64), mosaic=False, stretch=False)
    stretched = shade(raw, 4095, (64, 64), mosaic=False, stretch=True)
    assert np.ptp(flat) < 8
    assert stretched.min() == 0
    assert stretched.max() == GREYS - 1


class Stage(App[None]):
    """The three widgets by themselves."""

    def compose(self) -> ComposeResult:
        yield Preview(id="preview")
        yield GlassView(id="glass")
        yield DomeMap(id="dome")


def text_of(widget: GlassView | DomeMap | Preview) -> list[str]:
    return [widget.render_line(y).text for y in range(widget.size.height)]


async def test_glass_draws_aperture_and_pupil() -> None:
    profile = load_profile("benchtop")
    apertures = pattern_apertures(profile)
    async with Stage().run_test(size=(80, 60)) as pilot:
        glass = pilot.app.query_one(GlassView)
        glass.set_up(profile.glass, profile.optics.pupil_diameter_mm, apertures)
        glass.show(apertures[3].bitmap, apertures[3].name)
        await pilot.pause()
        cells = braille(apertures[3].bitmap)
        drawn = text_of(glass)
        for row, column in zip(*np.nonzero(cells), strict=True):
            assert ord(drawn[row][column]) - 0x2800 == cells[row, column]
        glass.action_zoom()
        await pilot.pause()
        assert "".join(text_of(glass)).count("██") == apertures[3].open_pixels


async def test_every_led_can_be_clicked_where_it_is_drawn() -> None:
    profile = load_profile("benchtop")
    positions = Calibration.nominal(profile).led_positions_mm
    async with Stage().run_test(size=(68, 60)) as pilot:
        dome = pilot.app.query_one(DomeMap)
        dome.set_up(positions, profile.dome.full_level)
        await pilot.pause()
        for led in range(profile.dome.count):
            column, row = dome.cell_of(led)
            await pilot.click(DomeMap, offset=(column, row))
            assert dome.cursor == led
            assert f"{led:>2d}" in dome.render_line(row).text


async def test_dome_is_drawn_in_the_frame_of_the_image() -> None:
    """LED 0 lies at +x, to the right; LED 2 a quarter turn counter-clockwise, on top."""
    profile = load_profile("benchtop")
    async with Stage().run_test(size=(68, 60)) as pilot:
        dome = pilot.app.query_one(DomeMap)
        dome.set_up(Calibration.nominal(profile).led_positions_mm, profile.dome.full_level)
        await pilot.pause()
        right, top, middle = dome.cell_of(0), dome.cell_of(2), dome.size
        assert right[0] > middle.width // 2
        assert right[1] == middle.height // 2
        assert top[1] < middle.height // 2
        assert abs(top[0] - middle.width / 2) <= 1
        low, high = dome.cell_of(0), dome.cell_of(8)  # 22.5 and 45 degrees above the sample plane
        centre = (middle.width / 2, middle.height / 2)
        assert math.dist(high, centre) < math.dist(low, centre)


async def test_dome_keys_walk_ring_and_change_ring() -> None:
    profile = load_profile("benchtop")
    async with Stage().run_test(size=(68, 60)) as pilot:
        dome = pilot.app.query_one(DomeMap)
        dome.set_up(Calibration.nominal(profile).led_positions_mm, profile.dome.full_level)
        dome.focus()
        await pilot.press("left")
        assert dome.cursor == 7
        await pilot.press("right", "right", "right")
        assert dome.cursor == 2
        await pilot.press("up")
        assert dome.cursor in {9, 10}
        await pilot.press("down")
        assert dome.cursor in {1, 2, 3}


async def test_preview_repaints_only_what_changed() -> None:
    async with Stage().run_test(size=(40, 60)) as pilot:
        preview = pilot.app.query_one(Preview)
        await pilot.pause()
        levels = np.zeros(preview.room, np.uint8)
        preview.put(levels)
        await pilot.pause()
        assert set("".join(text_of(preview))) == {"▀"}
        changed = levels.copy()
        changed[2, 3] = GREYS - 1
        preview.put(changed)
        strip = preview.render_line(1)
        assert [segment.cell_length for segment in strip] == [3, 1, preview.size.width - 4]
