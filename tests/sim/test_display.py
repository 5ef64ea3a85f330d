"""The display controller against hand-made byte sequences."""

import numpy as np
import pytest

from reliefscope_sim.display import DisplayController, Mounting

# Initialisation of the part's data sheet for the two ways to mount it.
INIT_BOTTOM = bytes.fromhex("40 A1 C0 A6 A2 2F F8 00 27 81 16 AC 00 AF")
INIT_TOP = bytes.fromhex("40 A0 C8 A6 A2 2F F8 00 27 81 16 AC 00 AF")


def controller(mounting=Mounting.BOTTOM_VIEW, init=INIT_BOTTOM):
    display = DisplayController(mounting, seed=7)
    display.set_reset(0)
    display.set_reset(1)
    display.set_select(0)
    display.feed(0, init)
    return display


def write_pages(display, first_column, pages):
    for page, data in pages.items():
        display.feed(0, bytes([0xB0 | page, 0x10 | first_column >> 4, first_column & 15]))
        display.feed(1, data)


def blank(display, first_column):
    write_pages(display, first_column, {page: bytes(128) for page in range(8)})


@pytest.mark.parametrize(
    ("mounting", "init", "offset"),
    [(Mounting.BOTTOM_VIEW, INIT_BOTTOM, 0), (Mounting.TOP_VIEW, INIT_TOP, 4)],
)
def test_right_setting_shows_the_picture_upright(mounting, init, offset):
    display = controller(mounting, init)
    pages = {page: bytes(128) for page in range(8)}
    pages[0] = bytes([0b0000_0001]) + bytes(127)  # row 0, column 0
    pages[7] = bytes(126) + bytes([0b1000_0000, 0])  # row 63, column 126
    pages[3] = bytes([0, 0, 0b0010_0000]) + bytes(125)  # row 29, column 2
    write_pages(display, offset, pages)
    expected = np.zeros((64, 128), dtype=bool)
    expected[0, 0] = expected[63, 126] = expected[29, 2] = True
    np.testing.assert_array_equal(display.driven(), expected)
    assert display.faults == []


def test_wrong_setting_turns_the_picture_by_half_a_turn():
    display = controller(Mounting.TOP_VIEW, INIT_BOTTOM)
    blank(display, 0)
    write_pages(display, 0, {0: bytes([0, 1])})  # row 0, column 1
    expected = np.zeros((64, 128), dtype=bool)
    expected[63, 126] = True
    np.testing.assert_array_equal(display.driven(), expected)


def test_forgotten_column_offset_shifts_the_picture_and_shows_stale_columns():
    display = controller(Mounting.TOP_VIEW, INIT_TOP)
    blank(display, 4)
    write_pages(display, 0, {0: bytes([0, 0, 0, 0, 0, 0, 1])})
    expected = np.zeros((64, 128), dtype=bool)
    expected[0, 2] = True
    np.testing.assert_array_equal(display.driven(), expected)


def test_start_line_scrolls():
    display = controller()
    blank(display, 0)
    write_pages(display, 0, {1: bytes([0b100])})  # RAM line 10
    display.feed(0, bytes([0x40 | 7]))
    assert np.argwhere(display.driven()).tolist() == [[3, 0]]


def test_inverse_and_all_points():
    display = controller()
    blank(display, 0)
    write_pages(display, 0, {0: bytes([1])})
    display.feed(0, b"\xa7")
    assert np.argwhere(~display.driven()).tolist() == [[0, 0]]
    display.feed(0, b"\xa5")
    assert display.driven().all()
    display.feed(0, b"\xa4\xa6")
    assert np.argwhere(display.driven()).tolist() == [[0, 0]]


@pytest.mark.parametrize("off", [b"\xae", b"\x28", b"\xae\xa5"])
def test_nothing_is_driven_without_display_or_power(off):
    display = controller()
    display.feed(0, b"\xa7")
    assert display.driven().any()
    display.feed(0, off)
    assert not display.driven().any()


def test_reset_clears_registers_but_not_the_ram():
    display = controller()
    blank(display, 0)
    write_pages(display, 0, {2: bytes([255])})
    ram = display.ram.copy()
    display.set_reset(0)
    assert not display.driven().any()
    display.feed(0, b"\xaf")
    display.set_reset(1)
    assert display.faults == ["1 bytes ignored: in reset"]
    assert not display.on
    np.testing.assert_array_equal(display.ram, ram)


def test_ram_holds_noise_after_power_on():
    display = DisplayController(seed=3)
    display.set_reset(1)
    display.set_select(0)
    display.feed(0, INIT_BOTTOM)
    assert 0.4 < display.driven().mean() < 0.6


def test_column_stops_at_131_and_the_page_stays():
    display = controller()
    write_pages(display, 0, {page: bytes(132) for page in range(8)})
    display.feed(0, bytes([0xB2, 0x18, 0x02]))  # page 2, column 130
    display.feed(1, bytes([1, 2, 3]))
    assert display.ram[2, 130:].tolist() == [1, 2]
    assert display.ram[3].max() == 0
    assert display.faults == ["data past the last column ignored"]


def test_bytes_while_not_selected_are_ignored():
    display = controller()
    blank(display, 0)
    display.set_select(1)
    display.feed(1, b"\xff")
    assert not display.driven().any()
    assert display.faults == ["1 bytes ignored: not selected"]


def test_arguments_of_two_byte_commands_are_not_commands():
    display = controller()
    display.feed(0, bytes([0x81, 0xAE, 0xF8, 0x03, 0xAD, 0xAE]))
    assert display.on
    assert display.volume == 0x2E
    assert display.booster_ratio == 3
    assert display.faults == []


def test_read_modify_write_returns_to_its_column():
    display = controller()
    display.feed(0, bytes([0xB0, 0x10, 0x05, 0xE0]))
    display.feed(1, b"\x00\x00")
    display.feed(0, b"\xee")
    assert display.column == 5


def test_unknown_commands_are_recorded():
    display = controller()
    display.feed(0, bytes([0xF0, 0xE3]))
    assert display.faults == ["unknown command 0xF0"]
