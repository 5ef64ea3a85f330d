"""Cast shadows against closed forms and against rays that are followed step by step."""

import numpy as np
import pytest

from reliefscope import axes
from reliefscope.errors import InvalidInputError
from reliefscope.models.light_field import LightField
from reliefscope.reconstruction import registration, shadows


def hills(shape: tuple[int, int]) -> np.ndarray:
    rng = np.random.default_rng(3)
    rows, columns = np.indices(shape)
    height = np.zeros(shape)
    for _ in range(25):
        row, column = rng.uniform(0, shape[0]), rng.uniform(0, shape[1])
        squared = (rows - row) ** 2 + (columns - column) ** 2
        height = np.maximum(height, 30.0 - 0.4 * squared / rng.uniform(3, 9))
    return height.astype(np.float32)


@pytest.mark.parametrize("azimuth_deg", [0, 90, 180, 270, 45, 135, 200, 340])
def test_length_and_side_of_the_shadow_of_a_pillar(azimuth_deg: float) -> None:
    """height / tan(elevation), away from the light."""
    height = np.zeros((141, 141), np.float32)
    height[66:75, 66:75] = 20.0
    elevation = np.radians(35.0)
    light = LightField.distant([axes.direction(elevation, np.radians(azimuth_deg))])
    seen = shadows.lit(height, light, 1.0, tolerance_um=0.25)[0]
    away = -np.array([np.cos(np.radians(azimuth_deg)), np.sin(np.radians(azimuth_deg))])
    steps = np.arange(0.0, 60.0, 0.25)
    column = np.rint(70 + steps * away[0]).astype(int)
    row = np.rint(70 - steps * away[1]).astype(int)
    dark = steps[~seen[row, column]]
    far_edge = 4.5 / np.abs(away).max()
    assert dark.min() == pytest.approx(far_edge, abs=1.5)
    # from a corner the shadow ends in a point, which pixels cut short
    assert dark.max() == pytest.approx(far_edge + 20.0 / np.tan(elevation), abs=2.0)
    outside = steps[steps > far_edge + 2]
    column = np.rint(70 - outside * away[0]).astype(int)
    row = np.rint(70 + outside * away[1]).astype(int)
    assert seen[row, column].all()


def test_agrees_with_rays_followed_step_by_step() -> None:
    height = hills((90, 120))
    directions = np.array(
        [axes.direction(np.radians(e), np.radians(a)) for e in (15, 50) for a in range(5, 365, 30)]
    )
    swept = shadows.lit(height, LightField.distant(directions), 1.2)
    marched = registration.visibility(height, directions[:, :2] / directions[:, 2:], 1.2)
    assert 0.1 < np.mean(~marched) < 0.5
    assert np.mean(swept != marched) < 0.01


def test_shadows_of_a_near_led_spread_from_its_foot() -> None:
    """A thin wall across the field, and the line of sight from the LED over its upper edge."""
    pixel_um = 10.0
    height = np.zeros((101, 201), np.float32)
    height[50, :] = 100.0
    led_mm = (2.0, 4.0, 1.5)
    field = LightField.of_leds([led_mm], [[1.0]])
    seen = shadows.lit(height, field, pixel_um, tolerance_um=0.5)[0]
    # in the plane x = const the edge's shadow ends where the line of sight meets z = 0, whatever x
    reach_um = 4000.0 * 100.0 / (1500.0 - 100.0)
    rows = reach_um / pixel_um
    for column in (20, 100, 180):
        dark = np.flatnonzero(~seen[:, column])
        assert dark.min() == 51
        assert dark.max() == pytest.approx(50 + rows, abs=1)
    # the end of a wall casts its shadow along the line from the LED's foot
    height[50, :100] = 0.0
    seen = shadows.lit(height, field, pixel_um, tolerance_um=0.5)[0]
    for row in (55, 65, 75):
        edge = np.flatnonzero(~seen[row]).min()
        foot_column, foot_row = 100 + 200, 50 - 400
        expected = foot_column + (100 - foot_column) * (row - foot_row) / (50 - foot_row)
        assert edge == pytest.approx(expected, abs=1.5)


def test_a_ring_counts_as_shadowed_by_its_share() -> None:
    height = np.zeros((41, 41), np.float32)
    height[:, 20] = 10.0
    leds = 30.0 * np.array(
        [axes.direction(np.radians(30), a) for a in (0, np.pi / 2, np.pi, 3 * np.pi / 2)]
    )
    strengths = np.array([[1.0, 0, 0, 0], [0.05, 1, 0, 1], [1, 1, 1, 1]])
    seen = shadows.lit(height, LightField.of_leds(leds, strengths), 1.0)
    assert not seen[0, 20, 10]  # the wall stands between the point and the LED to the right
    assert seen[0, 20, 30]
    assert seen[1].all()  # a twentieth of the light is missing
    assert not seen[2, 20, 10]  # a quarter is missing
    assert not seen[2, 20, 30]


def test_light_from_above_casts_none_and_missing_heights_neither() -> None:
    height = hills((40, 50))
    overhead = LightField.distant([[0.001, 0.0, 1.0], [0.0, 0.0, 1.0]])
    assert shadows.lit(height, overhead, 1.0).all()
    side = LightField.distant([axes.direction(np.radians(20), 0.3)])
    known = shadows.lit(height, side, 1.0)[0]
    height[10:14, 10:40] = np.nan
    with_hole = shadows.lit(height, side, 1.0)[0]
    assert with_hole[10:14, 10:40].all()
    assert not np.any(known & ~with_hole)
    assert shadows.lit(np.full((5, 6), np.nan, np.float32), side, 1.0).all()
    with pytest.raises(InvalidInputError, match="positive pixel size"):
        shadows.lit(height, side, 0.0)
