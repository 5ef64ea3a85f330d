"""Second look behind steps: which ground is low, which views look there, and what it gains."""

import numba
import numpy as np
import pytest
from scipy import ndimage
from tests.reconstruction import scenes

from reliefscope.reconstruction import joint
from reliefscope.reconstruction.joint_occlusion import leaning, lower_ground

PIXEL_UM = 1.12


def wall(
    edge: int, height_um: float, shape: tuple[int, int], contrast: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Views (K, H, W) with true occlusion of a terrace left of a column, slopes and height; the floor is dull."""
    slopes = scenes.hexagon_slopes(12, 0.127)
    wide = (shape[0] + 80, shape[1] + 80)
    top, floor = scenes.texture(wide, 1, 2.0), scenes.texture(wide, 10, 2.0)[40:-40, 40:-40]
    rows, cols = np.mgrid[: shape[0], : shape[1]].astype(np.float64)
    noise = np.random.default_rng(1)
    views = []
    for sx, sy in slopes:
        at = (rows - height_um * sy / PIXEL_UM, cols + height_um * sx / PIXEL_UM)
        seen = ndimage.map_coordinates(top, [at[0] + 40, at[1] + 40], order=3)
        view = np.where(at[1] < edge - 0.5, seen, 0.5 + contrast * (floor - 0.5))
        views.append(ndimage.gaussian_filter(view, 1.5) + noise.normal(0, 0.002, shape))
    return np.asarray(views, np.float32), slopes, np.where(cols < edge - 0.5, height_um, 0.0)


def test_lower_ground_lies_on_the_side_that_is_asked_for() -> None:
    height = np.zeros((20, 30), np.float32)
    height[:, :15] = 50.0
    right = lower_ground(height, (1.0, 0.0), 4, 20.0)
    assert right[:, 11:19].all()
    assert not right[:, :11].any()
    assert not right[:, 19:].any()
    assert not lower_ground(height, (-1.0, 0.0), 4, 20.0).any()
    up = lower_ground(np.ascontiguousarray(height.T), (0.0, -1.0), 4, 20.0)  # rows grow as y falls
    assert np.array_equal(up, right.T)


def test_half_of_the_views_leans_to_a_side() -> None:
    slopes = scenes.hexagon_slopes(12)
    chosen = leaning(slopes, (0.0, 1.0))
    assert chosen.sum() == 7
    assert slopes[chosen, 1].min() > slopes[~chosen, 1].max()


def test_the_floor_behind_a_wall_is_found_nearer_to_it(monkeypatch: pytest.MonkeyPatch) -> None:
    views, slopes, truth = wall(104, 60.0, (112, 208), 0.4)
    beside = np.s_[24:-24, 104:134]
    errors = []
    for _ in range(2):
        found = joint.match_jointly(views, slopes, (-10.0, 80.0), PIXEL_UM, binning=2)
        errors.append(float(np.abs(found.height_um - truth)[beside].mean()))
        monkeypatch.setattr(joint, "search_behind_steps", lambda *_: None)
    assert errors[0] < 0.85 * errors[1], errors


def test_the_number_of_threads_does_not_matter() -> None:
    views, slopes, _ = wall(60, 40.0, (112, 128), 0.6)
    threads = numba.get_num_threads()
    found = []
    try:
        for count in (1, min(2, numba.config.NUMBA_NUM_THREADS)):
            numba.set_num_threads(count)
            found.append(joint.match_jointly(views, slopes, (-10.0, 60.0), PIXEL_UM))
    finally:
        numba.set_num_threads(threads)
    for one, other in zip(*((f.height_um, f.quality, f.sigma_um) for f in found), strict=True):
        assert np.array_equal(one, other, equal_nan=True)
