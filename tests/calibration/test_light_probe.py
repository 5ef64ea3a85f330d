import numpy as np
import pytest
from tests.calibration.spheres import SPHERE, photograph

from reliefscope import axes
from reliefscope.calibration.light_probe import (
    Sphere,
    angular_difference_deg,
    calibrate_lights,
    direction_of_highlight,
    find_highlight,
    fit_circle,
)
from reliefscope.errors import InvalidInputError


@pytest.mark.parametrize("elevation_deg", [22.5, 45.0, 80.0])
@pytest.mark.parametrize("azimuth_deg", [0.0, 100.0, 250.0])
def test_directions_come_back(elevation_deg: float, azimuth_deg: float) -> None:
    light = axes.direction(np.radians(elevation_deg), np.radians(azimuth_deg))
    found = calibrate_lights([photograph(light)], SPHERE)
    assert found.shape == (1, 3)
    assert np.linalg.norm(found[0]) == pytest.approx(1.0)
    assert angular_difference_deg(found, light)[0] < 0.6


def test_signs() -> None:
    """A highlight right of and above the centre comes from a light at +x and +y."""
    x, y, z = direction_of_highlight((SPHERE.column + 10, SPHERE.row - 20), SPHERE)
    assert x > 0
    assert y > 2 * x - 1e-9
    assert z == pytest.approx(2 * (1 - 0.2**2 - 0.4**2) - 1)


def test_circle_through_points() -> None:
    angle = np.linspace(0.3, 4.0, 9)
    circle = fit_circle(12.5 + 30 * np.cos(angle), -4.0 + 30 * np.sin(angle))
    assert (circle.column, circle.row, circle.radius) == pytest.approx((12.5, -4.0, 30.0))
    with pytest.raises(InvalidInputError, match="line"):
        fit_circle([0, 1, 2, 3], [0, 2, 4, 6])
    with pytest.raises(InvalidInputError, match="three points"):
        fit_circle([0, 1], [0, 2])


def test_what_shows_no_light_is_refused() -> None:
    dark = np.full((120, 140), 0.02)
    light = photograph(axes.direction(0.9, 0.1))
    with pytest.raises(InvalidInputError, match="Photograph 1: The sphere shows no highlight"):
        calibrate_lights([light, dark], SPHERE)
    with pytest.raises(InvalidInputError, match="does not lie in"):
        find_highlight(light, Sphere(-300.0, 20.0, 50.0))
    with pytest.raises(InvalidInputError, match="outside the sphere"):
        direction_of_highlight((200.0, 58.0), SPHERE)
