"""The average in one pass against registration view by view."""

import numpy as np
import pytest

from reliefscope.reconstruction import registration
from reliefscope.reconstruction.view_average import ViewAverage

PIXEL_UM = 1.5
SHAPE = (40, 52)


@pytest.fixture(scope="module")
def scene() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Frames (K, L, H, W), slopes (K, 2) and a height with a step."""
    rng = np.random.default_rng(2)
    frames = rng.random((3, 2, *SHAPE), dtype=np.float32)
    height = rng.normal(5, 3, SHAPE).astype(np.float32)
    height[:, 30:] += 30
    height[7, 9] = np.nan
    return frames, np.array([[0.1, 0.02], [-0.08, 0.12], [0.0, -0.1]]), height


@pytest.mark.parametrize("telecentricity", [0.0, 2e-5])
def test_it_is_the_mean_of_the_registered_views(
    scene: tuple[np.ndarray, np.ndarray, np.ndarray], telecentricity: float
) -> None:
    frames, slopes, height = scene
    gains, factors = [1.0, 0.5, 2.0], np.array([1.0, 3.0])
    visible = registration.visibility(height, slopes, PIXEL_UM)
    average = ViewAverage(height, PIXEL_UM, 2, telecentricity)
    for view, (sx, sy) in enumerate(slopes):
        average.add(frames[view], (sx, sy), gains[view], visible[view])
    mean = average.mean(factors)
    for light in range(2):
        apart = registration.to_reference(
            frames[:, light],
            slopes,
            height,
            PIXEL_UM,
            telecentricity_per_um=telecentricity,
            interpolation="linear",
            visible=visible,
        ) * np.array(gains, np.float32).reshape(3, 1, 1)
        seen = np.isfinite(apart).any(axis=0)
        expected = factors[light] * np.nanmean(apart[:, seen], axis=0)
        np.testing.assert_allclose(mean[light][seen], expected, rtol=1e-5, atol=1e-6)
        assert np.isnan(mean[light][~seen]).all()


def test_a_missing_pixel_is_missing_under_its_light_only(
    scene: tuple[np.ndarray, np.ndarray, np.ndarray],
) -> None:
    frames, _, _ = scene
    holed = frames[0].copy()
    holed[1, 5, 6] = np.nan
    average = ViewAverage(np.zeros(SHAPE, np.float32), PIXEL_UM, 2)
    average.add(holed, (0.0, 0.0), 1.0)
    average.add(frames[1], (0.0, 0.0), 1.0)
    mean = average.mean(np.ones(2))
    assert mean[0, 5, 6] == pytest.approx((frames[0, 0, 5, 6] + frames[1, 0, 5, 6]) / 2)
    assert mean[1, 5, 6] == frames[1, 1, 5, 6]
    # interpolation reaches one pixel down and to the right, whatever its weight
    assert np.argwhere(average.incomplete).tolist() == [[4, 5], [4, 6], [5, 5], [5, 6]]
