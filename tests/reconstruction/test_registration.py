"""Registration by height: signs, agreement with the rendered texture, hidden points."""

import numpy as np
import pytest
from scipy import ndimage
from tests.reconstruction import scenes
from tests.reconstruction.shifting import shift_image

from reliefscope.errors import InvalidInputError
from reliefscope.reconstruction import registration
from reliefscope.reconstruction.registration import Interpolation, to_reference, visibility


def test_sign_of_the_numeric_example() -> None:
    # a = (1.5, -0.75) mm, f_o = 18 mm, z = 60 um, 1.12 um/px: 4.464 columns left, 2.232 rows up.
    frame = np.zeros((40, 50), dtype=np.float32)
    true_row, true_col = 25, 30
    rows, cols = np.mgrid[:40, :50]
    spot = (rows - (true_row - 2.232)) ** 2 + (cols - (true_col - 4.464)) ** 2
    frame[:] = np.exp(-spot / 8)
    slope = [[1.5 / 18, -0.75 / 18]]
    flat = np.full((40, 50), 60.0, dtype=np.float32)
    registered = np.nan_to_num(to_reference(frame[None], slope, flat, 1.12)[0])
    centre = ndimage.center_of_mass(registered)
    assert centre == pytest.approx((true_row, true_col), abs=0.02)


@pytest.mark.parametrize(("interpolation", "most"), [("cubic", 0.004), ("linear", 0.012)])
def test_frames_of_a_hill_become_its_texture(interpolation: Interpolation, most: float) -> None:
    scene = scenes.render(scenes.dome((96, 128), 25, 40.0))
    height = scene.height_um.astype(np.float32)
    registered = to_reference(
        scene.views, scene.slopes, height, scene.pixel_um, interpolation=interpolation
    )
    error = np.abs(registered - scene.reference)
    before = np.abs(scene.views - scene.reference)[:, 30:-30, 40:-40].mean()
    inside = error[:, 8:-8, 8:-8]
    assert np.isfinite(inside).all()
    assert np.median(inside) < most
    assert np.median(inside) < 0.2 * before


def test_cubic_is_the_interpolation_of_matching() -> None:
    frame = scenes.texture((30, 40), 7).astype(np.float32)
    flat = np.full((30, 40), 33.0, dtype=np.float32)
    registered = to_reference(frame[None], [[0.1, 0.05]], flat, 1.0)[0]
    shifted = shift_image(frame, 33.0 * 0.05, -33.0 * 0.1)
    assert np.array_equal(np.isnan(registered), np.isnan(shifted))
    assert np.nanmax(np.abs(registered - shifted)) < 1e-5


def test_missing_heights_and_outside_points_are_nan() -> None:
    frame = scenes.texture((30, 40), 7).astype(np.float32)
    height = np.zeros((30, 40), dtype=np.float32)
    height[10:12, 5] = np.nan
    registered = to_reference(frame[None], [[0.1, 0.0]], height, 1.0)[0]
    assert np.array_equal(np.isnan(registered), np.isnan(height))
    assert np.allclose(registered[~np.isnan(height)], frame[~np.isnan(height)], atol=1e-6)
    height[:] = 50.0  # five columns to the left
    registered = to_reference(frame[None], [[0.1, 0.0]], height, 1.0)[0]
    assert np.isnan(registered[:, :5]).all()
    assert np.allclose(registered[:, 5:], frame[:, :-5], atol=1e-5)


def test_a_wall_hides_what_lies_behind_it() -> None:
    # Wall of 100 um; a view that leans toward +x by 0.1 does not see 10 px on the wall's -x side.
    height = np.zeros((20, 60), dtype=np.float32)
    height[:, 30:40] = 100.0
    slopes = [[0.1, 0.0], [-0.1, 0.0], [0.0, 0.1]]
    seen = visibility(height, slopes, 1.0)
    hidden = ~seen[0, 10]
    assert hidden[21:30].all()
    assert not hidden[:19].any()
    assert not hidden[30:].any()
    mirrored = ~seen[1, 10]
    assert mirrored[40:49].all()
    assert not mirrored[:40].any()
    assert not mirrored[51:].any()
    assert seen[2, 10].all()
    assert visibility(np.zeros((5, 5), np.float32), slopes, 1.0).all()


def test_views_that_lean_up_hide_rows_below_a_wall() -> None:
    height = np.zeros((60, 20), dtype=np.float32)
    height[30:40] = 100.0
    seen = visibility(height, [[0.0, 0.1]], 1.0)[0, :, 10]  # +y is toward row 0
    assert not seen[40:49].any()
    assert seen[:40].all()
    assert seen[51:].all()


def test_hidden_points_agree_with_the_geometry_of_appearance() -> None:
    # The lower points between where the ridge appears and where it stands are covered by it.
    height = np.zeros((1, 80), dtype=np.float32)
    height[0, 50] = height[0, 51] = 80.0
    slope = 0.2
    apparent = round(50 - 80.0 * slope)
    seen = visibility(height, [[slope, 0.0]], 1.0)[0, 0]
    assert not seen[apparent + 1]
    assert seen[apparent - 1]
    assert seen[50:].all()


def test_mask_blanks_hidden_points_and_strips_do_not_show(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = scenes.render(scenes.dome((48, 64), 8, 60.0), shape=(48, 64))
    height = scene.height_um.astype(np.float32)
    whole = to_reference(scene.views, scene.slopes, height, scene.pixel_um)
    mask = visibility(height, scene.slopes, scene.pixel_um)
    monkeypatch.setattr(registration, "STRIP_ROWS", 7)
    masked = to_reference(scene.views, scene.slopes, height, scene.pixel_um, visible=mask)
    assert np.array_equal(mask, visibility(height, scene.slopes, scene.pixel_um))
    assert np.isnan(masked[~mask]).all()
    assert np.array_equal(masked[mask], whole[mask], equal_nan=True)


def test_bad_input_is_refused() -> None:
    frames = np.zeros((2, 8, 9), dtype=np.float32)
    height = np.zeros((8, 9), dtype=np.float32)
    with pytest.raises(InvalidInputError, match="do not belong together"):
        to_reference(frames, [[0.1, 0.0]], height, 1.0)
    with pytest.raises(InvalidInputError, match="does not belong to frames"):
        to_reference(frames, [[0.1, 0.0], [0.0, 0.1]], height[1:], 1.0)
    with pytest.raises(InvalidInputError, match="positive"):
        to_reference(frames, [[0.1, 0.0], [0.0, 0.1]], height, -1.0)
    with pytest.raises(InvalidInputError, match="visibility mask"):
        to_reference(
            frames, [[0.1, 0.0], [0.0, 0.1]], height, 1.0, visible=np.ones((1, 8, 9), bool)
        )


def test_telecentricity_moves_points_by_their_place_in_the_field() -> None:
    # kappa 0.0004 per um: 40 um above focus, 60 columns right of the middle, 0.96 columns to the left.
    kappa, height = 4e-4, np.full((81, 161), 40.0, dtype=np.float32)
    rows, cols = np.mgrid[:81, :161]
    true = (20, 140)
    near = 1 / (1 + 40 * kappa)
    seen = (40 + near * (true[0] - 40), 80 + near * (true[1] - 80 - 4.0))
    frame = np.exp(-((rows - seen[0]) ** 2 + (cols - seen[1]) ** 2) / 8).astype(np.float32)
    registered = to_reference(frame[None], [[0.1, 0.0]], height, 1.0, telecentricity_per_um=kappa)
    assert ndimage.center_of_mass(np.nan_to_num(registered[0])) == pytest.approx(true, abs=0.02)


def test_telecentricity_turns_the_rays_that_are_hidden() -> None:
    height = np.zeros((5, 201), dtype=np.float32)
    height[:, 20:30] = height[:, 170:180] = 50.0
    seen = visibility(height, [[0.0, 0.0]], 1.0, telecentricity_per_um=1e-3)[0, 2]
    # rays lean outward by 0.001 per column: by 0.07 at the walls, which hide 3 columns on their inner side
    assert not seen[[30, 31, 32]].any()
    assert not seen[[169, 168, 167]].any()
    assert seen[36:164].all()
    assert seen[:30].all()
    assert seen[170:].all()
