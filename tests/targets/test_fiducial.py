"""The fiducial's geometry against the figures of the paper and against closed forms."""

import math

import numpy as np
import pytest

from reliefscope.errors import InvalidInputError
from reliefscope.targets import SECTIONS, Fiducial3D, grid_coverage, scale_coverage

SHAPE = (1000, 1100)
TARGET = Fiducial3D()
HEIGHT = TARGET.height_um(SHAPE, 1.0)


def test_relief_spans_the_stated_depth_about_the_focal_plane():
    assert HEIGHT.min() == pytest.approx(-47.0)
    assert HEIGHT.max() == pytest.approx(53.0, abs=0.01)
    assert HEIGHT.dtype == np.float32


def test_checkerboard_has_fifty_fields_each_way_up_and_fifty_micrometres_between_them():
    tops = TARGET.mask("checker_tops", SHAPE, 1.0)
    floors = TARGET.mask("checker_floors", SHAPE, 1.0)
    assert tops.sum() == floors.sum() == 50 * 50 * 50
    assert not (tops & floors).any()
    assert np.unique(HEIGHT[tops]).tolist() == [3.0]
    assert np.unique(HEIGHT[floors]).tolist() == [-47.0]
    # One field: 50 um wide, the next one low.  The checkerboard is the upper left quarter.
    row, left = 25, 50
    assert tops[row, left : left + 500].reshape(10, 50).all(axis=1).tolist() == [False, True] * 5


def test_eighteen_planes_have_their_slopes_and_touch_the_base():
    assert len(TARGET.planes) == 18
    angles = [math.degrees(plane.angle_rad) for plane in TARGET.planes]
    assert min(angles) > 4.9
    assert max(angles) < 40.1
    assert max(angles) - min(angles) > 20
    row, column = np.mgrid[: SHAPE[0], : SHAPE[1]]
    x, y = column - (SHAPE[1] - 1) / 2, (SHAPE[0] - 1) / 2 - row
    for plane in TARGET.planes:
        inside = (abs(x - plane.centre_um[0]) <= 49) & (abs(y - plane.centre_um[1]) <= 49)
        A = np.stack([x[inside], y[inside], np.ones(inside.sum())], axis=-1)
        fit, residual, *_ = np.linalg.lstsq(A, HEIGHT[inside].astype(float), rcond=None)
        assert fit[:2] == pytest.approx([plane.slope_x, plane.slope_y], abs=1e-6)
        assert residual[0] < 1e-4
        assert -47.0 <= HEIGHT[inside].min() < -44.0
        assert HEIGHT[inside].max() <= 48.0


def test_hemispheres_are_two_of_each_radius_and_spherical():
    assert sorted(ball.radius_um for ball in TARGET.hemispheres) == [75, 75, 100, 100]
    row, column = np.mgrid[: SHAPE[0], : SHAPE[1]]
    x, y = column - (SHAPE[1] - 1) / 2, (SHAPE[0] - 1) / 2 - row
    for ball in TARGET.hemispheres:
        distance = np.hypot(x - ball.centre_um[0], y - ball.centre_um[1])
        inside = distance < ball.radius_um
        radius = np.sqrt(distance[inside] ** 2 + (HEIGHT[inside] + 47.0) ** 2)
        assert np.abs(radius - ball.radius_um).max() < 1e-2


def test_sections_lie_in_the_square_and_apart():
    full = TARGET.mask("full", SHAPE, 1.0)
    assert full.sum() == 1000 * 1000
    sections = [TARGET.mask(name, SHAPE, 1.0) for name in SECTIONS if name != "full"]
    assert (np.sum(sections, axis=0)[~full] == 0).all()
    assert np.sum(sections, axis=0).max() == 1
    assert TARGET.mask("hemispheres", SHAPE, 1.0).sum() == pytest.approx(
        2 * math.pi * (75**2 + 100**2), rel=2e-3
    )


def test_everything_outside_features_is_base():
    features = np.any(
        [TARGET.mask(name, SHAPE, 1.0) for name in ("checker_tops", "planes", "hemispheres")],
        axis=0,
    )
    assert np.unique(HEIGHT[~features]).tolist() == [-47.0]


def test_the_same_point_has_the_same_height_at_any_pitch():
    fine = TARGET.height_um((301, 301), 1.0)
    coarse = TARGET.height_um((101, 101), 3.0)
    assert np.array_equal(fine[::3, ::3], coarse)


def test_scale_and_seed():
    half = Fiducial3D(scale=0.5)
    assert np.allclose(half.height_um(SHAPE, 0.5) + 47.0, (HEIGHT + 47.0) / 2, atol=1e-3)
    other = Fiducial3D(seed=2)
    assert other.planes != TARGET.planes
    assert Fiducial3D(seed=2).planes == other.planes
    with pytest.raises(InvalidInputError):
        Fiducial3D(scale=0.0)


def test_grid_covers_its_share_and_keeps_its_pitch():
    covered = grid_coverage((400, 600), 1.0, pitch_um=200.0, line_um=20.0)
    assert covered.mean() == pytest.approx(1 - 0.9**2, rel=1e-3)
    profile = covered[100]
    assert (np.flatnonzero(profile == 1)[[0, -1]] - 299.5).tolist() == [-209.5, 209.5]


def test_scale_has_a_mark_every_ten_micrometres():
    covered = scale_coverage((101, 601), 1.0)
    centres = np.flatnonzero(covered[50] == 1)
    assert np.array_equal(centres, np.arange(0, 601, 10))
    assert covered[50].mean() == pytest.approx(0.2, abs=0.005)
    assert covered[:, 300].sum() == pytest.approx(81)
