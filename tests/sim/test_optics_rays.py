"""The ray kernels against closed forms and against a slow march in fine steps."""

import cv2
import numpy as np
import pytest
from scipy.ndimage import gaussian_filter1d, map_coordinates

from reliefscope_sim.optics.ray_kernels import (
    blur,
    blur_to_mosaic,
    gather,
    gaussian_taps,
    intersect,
)

MARGIN = 24
SHAPE = (30, 40)
CENTRE = np.array([19.5, 14.5], dtype=np.float32)
STEP = 1e-3


def padded(height):
    """Grid coordinates (columns, rows) about the optical axis and a height over them, y up."""
    rows, columns = np.mgrid[: SHAPE[0] + 2 * MARGIN, : SHAPE[1] + 2 * MARGIN].astype(float)
    x, y = columns - MARGIN - CENTRE[0], CENTRE[1] - (rows - MARGIN)
    return np.asarray(height(x, y), dtype=np.float32)


def seen_heights(height, slope, kappa=0.0, reach=16):
    """Heights (H, W) that the kernel finds for one pupil point."""
    box = np.ones((2 * reach + 1, 2 * reach + 1), dtype=np.uint8)
    rise = np.hypot(
        np.abs(np.diff(height, axis=1, append=height[:, -1:])),
        np.abs(np.diff(height, axis=0, append=height[-1:])),
    )
    depth = np.empty((1, *SHAPE), dtype=np.uint16)
    lowest = float(height.min())
    slopes = np.array([slope], dtype=np.float32)
    high, low, steep = cv2.dilate(height, box), cv2.erode(height, box), cv2.dilate(rise, box)
    intersect(height, high, low, steep, slopes, kappa, CENTRE, MARGIN, lowest, STEP, depth)
    return lowest + STEP * depth[0]


def marched(height, slope, step=0.02):
    """The same by a march from far above in steps so small that nothing is missed."""
    row, column = np.mgrid[: SHAPE[0], : SHAPE[1]].astype(float) + MARGIN
    found = np.full(SHAPE, np.nan)
    for z in np.arange(height.max(), height.min() - step, -step):
        places = [row - z * slope[1], column + z * slope[0]]
        below = map_coordinates(height.astype(float), places, order=1) >= z
        found[np.isnan(found) & below] = z
    return found


@pytest.mark.parametrize("slope", [(0.1, 0.0), (-0.12, 0.05), (0.2, -0.2)])
def test_a_tilted_plane_is_met_where_the_ray_crosses_it(slope):
    tilt = (0.7, -0.3)
    height = padded(lambda x, y: tilt[0] * x + tilt[1] * y)
    x = np.arange(SHAPE[1]) - CENTRE[0]
    y = CENTRE[1] - np.arange(SHAPE[0])
    level = tilt[0] * x[None, :] + tilt[1] * y[:, None]
    expected = level / (1 - tilt[0] * slope[0] - tilt[1] * slope[1])
    # 0.05 pixels of height are 0.01 pixels in the image.
    assert np.abs(seen_heights(height, slope) - expected).max() < 0.05


def test_lean_that_grows_with_the_field_is_followed():
    height = padded(lambda x, y: 0.5 * x + 0 * y)
    x = np.arange(SHAPE[1]) - CENTRE[0]
    expected = 0.5 * x / (1 - 0.5 * (0.05 + 0.002 * x))
    assert np.abs(seen_heights(height, (0.05, 0.0), kappa=0.002) - expected[None, :]).max() < 0.02


@pytest.mark.parametrize("slope", [(0.12, 0.05), (-0.25, 0.1), (0.0, -0.2)])
@pytest.mark.parametrize("steepness", [1.5, 12.0])
def test_rough_ground_with_overhung_floors_is_seen_as_a_slow_march_sees_it(slope, steepness):
    generator = np.random.default_rng(11)
    field = cv2.GaussianBlur(generator.standard_normal((78, 88)).astype(np.float32), (0, 0), 2.5)
    height = np.clip(field / field.std() * steepness, -30, 30)
    error = np.abs(seen_heights(height, slope) - marched(height, slope))
    # At the rim of what hides something else, a hair's breadth decides between front and back.
    assert np.percentile(error, 98) < 0.08
    assert np.median(error) < 0.02


def test_a_wall_hides_what_lies_behind_it():
    height = padded(lambda x, y: np.where(np.abs(x + 5) < 2, 30.0, 0.0) + 0 * y)
    seen = seen_heights(height, (-0.2, 0.0))
    behind = (CENTRE[0] - 3 + np.array([1, 2, 3, 4])).astype(int)  # in the lee of the ridge
    assert (seen[:, behind] > 2.0).all()
    assert np.abs(seen_heights(height, (0.2, 0.0))[:, behind]).max() < 0.01


def test_gathering_shifts_by_height_times_slope():
    generator = np.random.default_rng(2)
    grid = (3, SHAPE[0] + 2 * MARGIN, SHAPE[1] + 2 * MARGIN)
    radiance = generator.random(grid, dtype=np.float32)
    depth = np.full((2, *SHAPE), 9000, dtype=np.uint16)  # z = 9 at lowest 0
    slopes = np.array([[0.15, -0.3], [-0.4, 0.05]], dtype=np.float32)
    weights = np.array([2.0, 0.5], dtype=np.float32)
    image = np.zeros((3, *SHAPE), dtype=np.float32)
    gather(radiance, depth, slopes, weights, 0.0, CENTRE, MARGIN, 0.0, STEP, image)
    row, column = np.mgrid[: SHAPE[0], : SHAPE[1]].astype(float) + MARGIN
    for channel, seen in zip(radiance.astype(float), image, strict=True):
        expected = sum(
            weight * map_coordinates(channel, [row - 9 * sy, column + 9 * sx], order=1)
            for (sx, sy), weight in zip(slopes.astype(float), weights, strict=True)
        )
        assert np.abs(seen - expected).max() < 1e-4


@pytest.mark.parametrize(("sigma_x", "sigma_y"), [(2.25, 2.25), (0.8, 3.1), (0.0, 1.0)])
def test_blur_is_a_gaussian_in_each_direction(sigma_x, sigma_y):
    generator = np.random.default_rng(4)
    image = generator.random((3, 50, 61), dtype=np.float32)
    out = np.empty_like(image)
    blur(image, gaussian_taps(sigma_x), gaussian_taps(sigma_y), out)
    expected = image.astype(float)
    for axis, sigma in ((1, sigma_y), (2, sigma_x)):
        if sigma > 0:
            reach = len(gaussian_taps(sigma)) - 1
            expected = gaussian_filter1d(expected, sigma, axis, mode="nearest", radius=reach)
    assert np.abs(out - expected).max() < 1e-5
    assert len(gaussian_taps(0.1)) == 1
    mosaic = np.empty((50, 61), dtype=np.float32)
    blur_to_mosaic(image, gaussian_taps(sigma_x), gaussian_taps(sigma_y), mosaic)
    filters = np.ones((50, 61), dtype=int)
    filters[0::2, 0::2], filters[1::2, 1::2] = 0, 2
    assert np.array_equal(mosaic, np.take_along_axis(out, filters[None], 0)[0])
