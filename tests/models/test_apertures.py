"""Bitmaps of the glass: patterns, packing, and the slopes that follow from them."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from reliefscope.errors import InvalidInputError
from reliefscope.models.apertures import (
    centroid_mm,
    disc,
    hexagonal_centres_mm,
    pack_bitmap,
    unpack_bitmap,
)
from reliefscope.models.calibration import Calibration
from reliefscope.models.geometry import (
    light_direction,
    light_power,
    pupil_position_mm,
    slope_of_bitmap,
    slope_of_position,
)
from reliefscope.models.instrument import load_profile

BENCHTOP = load_profile("benchtop")
NOMINAL = Calibration.nominal(BENCHTOP)


def test_twelve_discs_about_a_hole_of_the_lattice() -> None:
    centres = hexagonal_centres_mm(12, 1.5)
    radii = [math.hypot(*centre) for centre in centres]
    assert radii[:3] == pytest.approx([1.5 / math.sqrt(3)] * 3)
    assert radii[3:6] == pytest.approx([3.0 / math.sqrt(3)] * 3)
    assert radii[6:] == pytest.approx([1.5 * math.sqrt(7 / 3)] * 6)
    gaps = [math.dist(a, b) for i, a in enumerate(centres) for b in centres[:i]]
    assert min(gaps) == pytest.approx(1.5)  # they touch and do not overlap
    np.testing.assert_allclose(np.mean(centres, axis=0), 0, atol=1e-12)


def test_discs_of_the_pattern_share_no_pixel() -> None:
    discs = [disc(BENCHTOP.glass, centre, 1.5) for centre in hexagonal_centres_mm(12, 1.5)]
    assert np.sum(discs, axis=0).max() == 1
    assert {int(bitmap.sum()) for bitmap in discs} <= {7, 8, 9, 10}


def test_the_slope_comes_from_the_open_pixels_and_not_from_the_ideal_disc() -> None:
    bitmap = np.zeros((64, 128), dtype=bool)
    bitmap[31, 64] = bitmap[31, 65] = True  # 0.5 and 1.5 pixels right of the middle, 0.5 above
    x_mm, y_mm = centroid_mm(bitmap, BENCHTOP.glass)
    assert (x_mm, y_mm) == pytest.approx((0.398, 0.242))
    slope = slope_of_bitmap(bitmap, BENCHTOP, NOMINAL)
    assert slope == pytest.approx((0.398 / 18, 0.242 / 18))


def test_the_example_of_the_conventions() -> None:
    assert slope_of_position((1.5, -0.75), BENCHTOP, NOMINAL) == pytest.approx(
        (0.08333, -0.04167), abs=5e-6
    )


def test_the_calibrated_map_turns_then_shifts_then_scales() -> None:
    calibration = NOMINAL.model_copy(
        update={
            "glass_rotation_rad": math.pi / 2,
            "glass_offset_mm": (0.1, 0.2),
            "pupil_scale": 1.125,
        }
    )
    position = pupil_position_mm((1.0, 0.0), calibration)
    assert position == pytest.approx((0.1, 1.2))
    assert slope_of_position(position, BENCHTOP, calibration)[1] == pytest.approx(1.2 / 20.25)


def test_page_order_puts_row_eight_p_plus_b_in_bit_b() -> None:
    bitmap = np.zeros((64, 128), dtype=bool)
    bitmap[8 * 3 + 5, 17] = True
    packed = pack_bitmap(bitmap)
    assert packed[128 * 3 + 17] == 1 << 5
    assert sum(packed) == 1 << 5


@given(arrays(np.bool_, (64, 128)))
def test_packing_is_inverse_of_unpacking(bitmap: np.ndarray) -> None:
    np.testing.assert_array_equal(unpack_bitmap(pack_bitmap(bitmap)), bitmap)


@given(st.integers(0, 15), st.integers(1, 4095))
def test_one_led_points_from_its_position(led: int, level: int) -> None:
    position = np.asarray(NOMINAL.led_positions_mm[led])
    np.testing.assert_allclose(
        light_direction({led: level}, NOMINAL), position / np.linalg.norm(position)
    )
    assert light_power({led: level}, NOMINAL, 4095) == pytest.approx(level / 4095)


def test_a_full_ring_shines_along_the_axis() -> None:
    ring = dict.fromkeys(range(8), 4095)
    np.testing.assert_allclose(light_direction(ring, NOMINAL), [0, 0, 1], atol=1e-12)


@pytest.mark.parametrize(
    ("centre", "diameter", "words"),
    [((30.0, 0.0), 1.5, "reaches over"), ((0.0, 0.0), 0.1, "opens no pixel")],
)
def test_a_disc_that_cannot_be_shown_is_refused(
    centre: tuple[float, float], diameter: float, words: str
) -> None:
    with pytest.raises(InvalidInputError, match=words):
        disc(BENCHTOP.glass, centre, diameter)


def test_a_shut_aperture_is_no_view() -> None:
    with pytest.raises(InvalidInputError, match="no centroid"):
        centroid_mm(np.zeros((64, 128), dtype=bool), BENCHTOP.glass)


def test_a_bitmap_of_another_shape_is_refused() -> None:
    with pytest.raises(InvalidInputError, match="64 rows of 128"):
        pack_bitmap(np.zeros((128, 64), dtype=bool))
    with pytest.raises(InvalidInputError, match="1024"):
        unpack_bitmap(b"short")
