from pathlib import Path

import cv2
import numpy as np
import pytest
from tests.support import shared_data

from reliefscope import axes
from reliefscope.calibration.light_probe import (
    Sphere,
    angular_difference_deg,
    calibrate_lights,
    direction_of_highlight,
    find_highlight,
    fit_circle,
    mean_directions,
)
from reliefscope.errors import InvalidInputError

SPHERE = Sphere(column=70.0, row=58.0, radius=50.0)


def photograph(light: np.ndarray, shape: tuple[int, int] = (120, 140)) -> np.ndarray:
    """A mirroring sphere: the reflected ray of each pixel, with a lamp of a few degrees."""
    rows, columns = np.indices(shape)
    nx = (columns - SPHERE.column) / SPHERE.radius
    ny = (SPHERE.row - rows) / SPHERE.radius
    nz = np.sqrt(np.maximum(1 - nx**2 - ny**2, 0))
    mirrored = np.stack([2 * nz * nx, 2 * nz * ny, 2 * nz**2 - 1], axis=-1)
    image = 0.02 + np.exp((mirrored @ light - 1) / 0.004)
    image[nz == 0] = 0.9  # a bright background must not win
    return image


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


def probe_directions(folder: Path) -> np.ndarray:
    """The circle is given with x to the right and y up, both counted from 1."""
    x, y, radius = np.loadtxt(folder / "circle_data.txt")
    images = [cv2.imread(str(folder / f"Image_{k:02d}.JPG")) for k in range(1, 13)]
    return calibrate_lights(images, Sphere(x - 1, images[0].shape[0] - y, radius))


def test_real_light_probes_agree_with_the_given_directions(
    capsys: pytest.CaptureFixture[str],
) -> None:
    data = shared_data("psbox_cat")
    given = np.loadtxt(data / "light_directions.txt").T
    found = mean_directions([probe_directions(data / f"LightProbe-{k}") for k in (1, 2)])
    difference = angular_difference_deg(found, given)
    with capsys.disabled():
        shown = ", ".join(f"{angle:.2f}" for angle in difference)
        print(f"\nlight probes against the given directions, degrees: {shown}")
    assert difference.max() < 1.5
    assert difference.mean() < 0.8
