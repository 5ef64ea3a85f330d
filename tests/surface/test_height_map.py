"""Height maps: filling, levelling, resampling against closed forms."""

import numpy as np
import pytest

from reliefscope.axes import pixel_grid_um
from reliefscope.errors import InvalidInputError
from reliefscope.surface import HeightMap


def make(heights, pixel_um=(2.0, 2.0)):
    return HeightMap(np.asarray(heights, dtype=np.float32), pixel_um, "test")


def plane(shape, pixel_um, rise_x, rise_y):
    rows, columns = shape
    x_um = np.arange(columns) * pixel_um[0]
    y_um = (rows - 1 - np.arange(rows)) * pixel_um[1]
    return rise_x * x_um + rise_y * y_um[:, None]


def test_levelling_takes_away_exactly_a_plane_and_heeds_missing_points():
    pixel_um = (1.5, 4.0)
    relief = np.random.default_rng(1).normal(size=(40, 50))
    relief = make(relief, pixel_um).levelled().height_um
    tilted = relief + plane((40, 50), pixel_um, 0.3, -0.2) + 7.0
    assert np.allclose(make(tilted, pixel_um).levelled().height_um, relief, atol=1e-4)
    tilted[5:20, 10:30] = np.nan
    levelled = make(plane((40, 50), pixel_um, 0.3, -0.2), pixel_um)
    holed = make(np.where(np.isnan(tilted), np.nan, levelled.height_um), pixel_um).levelled()
    assert np.nanmax(np.abs(holed.height_um)) < 1e-4
    assert holed.missing == pytest.approx(300 / 2000)


def test_filling_keeps_what_is_known_and_stays_within_what_surrounds_the_hole():
    heights = plane((61, 83), (1.0, 1.0), 0.5, 0.25)
    holed = heights.copy()
    holed[20:40, 30:60] = np.nan
    holed[0, 0] = np.nan
    filled = make(holed).filled().height_um
    known = np.isfinite(holed)
    assert np.array_equal(filled[known], holed[known].astype(np.float32))
    rim = holed[19:41, 29:61]
    hole = filled[20:40, 30:60]
    assert hole.min() >= np.nanmin(rim)
    assert hole.max() <= np.nanmax(rim)
    # Half way across a hole in a plane the patch is near the plane; 15 um is its rise over the hole.
    assert abs(hole[10, 15] - heights[30, 45]) < 3.0
    assert make(heights).filled().height_um is not None
    lonely = np.full((30, 30), np.nan)
    lonely[3, 4] = 5.0
    assert np.allclose(make(lonely).filled().height_um, 5.0)


def test_resampling_keeps_a_plane_and_the_middle():
    pixel_um = (1.5, 4.0)
    heights = plane((60, 121), pixel_um, 0.3, -0.2)
    resampled = make(heights, pixel_um).resampled((31, 41), 2.0)
    x_um, y_um = pixel_grid_um((31, 41), 2.0)
    expected = 0.3 * x_um + -0.2 * y_um[:, None] + heights.mean()
    assert np.allclose(resampled, expected, atol=1e-3)


def test_beyond_its_edges_a_map_goes_on_mirrored():
    heights = np.arange(12.0).reshape(3, 4)
    wide = make(heights, (1.0, 1.0)).resampled((5, 8), 1.0)
    assert wide[1].tolist() == [2, 1, 0, 1, 2, 3, 2, 1]
    assert np.allclose(wide[1:4, 2:6], heights)
    assert np.allclose(wide[0], wide[2])
    assert np.allclose(wide[:, 1], wide[:, 3])


def test_larger_pixels_average():
    fine = np.tile([[0.0, 1.0], [1.0, 0.0]], (100, 100))
    coarse = make(fine, (1.0, 1.0)).resampled((20, 20), 8.0)
    assert np.abs(coarse - 0.5).max() < 0.02


def test_widening_keeps_heights_and_proportions():
    wide = make(np.arange(12.0).reshape(3, 4), (1.0, 2.0)).widened(40.0)
    assert wide.pixel_um == (10.0, 20.0)
    assert wide.width_um == 40.0


@pytest.mark.parametrize(
    ("heights", "pixel_um", "said"),
    [
        (np.zeros(5), (1.0, 1.0), "no height map"),
        (np.zeros((1, 5)), (1.0, 1.0), "no height map"),
        (np.full((4, 4), np.nan), (1.0, 1.0), "none at all"),
        (np.full((4, 4), np.inf), (1.0, 1.0), "infinite"),
        (np.zeros((4, 4)), (1.0, 0.0), "um apart"),
        (np.zeros((4, 4)), (np.nan, 1.0), "um apart"),
    ],
)
def test_what_is_no_height_map_is_refused(heights, pixel_um, said):
    with pytest.raises(InvalidInputError, match=said) as caught:
        make(heights, pixel_um)
    assert caught.value.hint
