"""Saturated pixels are missing, and nothing else is."""

import numpy as np

from reliefscope.reconstruction.saturation import blank_saturated


class Levels:
    def saturation_level(self, view: int, light: int) -> np.ndarray | float:
        assert view == 2
        return 0.5 if light == 0 else np.full((4, 5), 0.8, np.float32)


def test_pixels_at_full_scale_become_missing() -> None:
    images = np.full((3, 4, 5), 0.3, np.float32)
    images[0, 1, 1] = 0.5
    images[1, 2, 2] = 0.7
    images[2, 3, 3] = 0.8
    assert blank_saturated(images, Levels(), 2) == 2
    assert np.argwhere(np.isnan(images)).tolist() == [[0, 1, 1], [2, 3, 3]]
