"""The world frame, against the numeric example of the conventions and against closed forms."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from reliefscope import axes


def test_a_raised_point_appears_shifted_against_the_slope() -> None:
    # a = (1.5, -0.75) mm, f_o = 18 mm, z = 60 um, 1.12 um per pixel.
    slope = (1.5 / 18, -0.75 / 18)
    assert axes.apparent_shift_um(60, slope) == pytest.approx((-5.0, 2.5))
    columns, rows = axes.apparent_shift_px(60, slope, 1.12)
    assert columns == pytest.approx(-4.464, abs=5e-4)  # to the left
    assert rows == pytest.approx(-2.232, abs=5e-4)  # up


def test_y_falls_with_the_row_index() -> None:
    x_um, y_um = axes.pixel_grid_um((3, 5), 2.0)
    np.testing.assert_allclose(x_um, [-4, -2, 0, 2, 4])
    np.testing.assert_allclose(y_um, [2, 0, -2])


def test_azimuth_runs_counter_clockwise_from_x() -> None:
    np.testing.assert_allclose(axes.direction(0.0, math.pi / 2), [0, 1, 0], atol=1e-15)
    np.testing.assert_allclose(axes.direction(math.pi / 2, 0.0), [0, 0, 1], atol=1e-15)


@given(st.floats(-1.5, 1.5), st.floats(-3.1, 3.1))
def test_direction_and_angles_are_inverse(elevation: float, azimuth: float) -> None:
    vector = axes.direction(elevation, azimuth)
    assert np.linalg.norm(vector) == pytest.approx(1)
    assert axes.elevation_azimuth(vector) == pytest.approx((elevation, azimuth), abs=1e-9)


def test_normals_of_a_plane_lean_downhill() -> None:
    x_um, y_um = axes.pixel_grid_um((20, 30), 1.5)
    plane = 0.3 * x_um[None, :] - 0.2 * y_um[:, None]
    normals = axes.normals_from_height(plane, 1.5)
    expected = np.array([-0.3, 0.2, 1]) / math.sqrt(1 + 0.09 + 0.04)
    np.testing.assert_allclose(normals, np.broadcast_to(expected, normals.shape), atol=1e-6)
    d_x, d_y = axes.gradient_from_normals(normals)
    np.testing.assert_allclose(d_x, 0.3, atol=1e-5)
    np.testing.assert_allclose(d_y, -0.2, atol=1e-5)
    np.testing.assert_allclose(axes.slant_rad(normals), math.acos(expected[2]), atol=1e-5)


def test_slopes_stay_finite_where_the_normal_lies_in_the_plane() -> None:
    d_x, d_y = axes.gradient_from_normals(np.array([[1.0, 0.0, 0.0]]), minimum_nz=0.02)
    assert d_x[0] == pytest.approx(-50)
    assert d_y[0] == pytest.approx(0)
