"""Figures of several panels."""

import cv2
import numpy as np
import pytest

from reliefscope.errors import DatasetError
from reliefscope.report.panels import Panel, toned, write_panels


def test_a_figure_holds_its_panels_and_leaves_unknown_pixels_blank(tmp_path):
    ramp = np.tile(np.linspace(0, 1, 1200, dtype=np.float32), (300, 1))
    ramp[:, :400] = np.nan
    panels = [
        Panel("map", ramp, "height (µm)", width_um=500.0),
        Panel("grey", np.full((300, 1200), 0.5, np.float32)),
        Panel("colour", np.full((300, 1200, 3), (1.0, 0.0, 0.0), np.float32)),
    ]
    path = write_panels(panels, tmp_path / "new" / "figure.png", columns=3, title="three")
    image = cv2.imread(str(path))[..., ::-1].astype(int)
    red = (image[..., 0] > 250) & (image[..., 1] < 5) & (image[..., 2] < 5)
    grey = (np.abs(image - 127).max(axis=-1) < 3).mean()
    assert red.mean() > 0.05
    assert grey > 0.05
    dark_violet = (np.abs(image - (68, 1, 84)).max(axis=-1) < 12).sum()  # viridis at its lowest
    assert dark_violet > 20


def test_tone_is_a_square_root_below_the_bright_end():
    image = np.linspace(0, 1, 1001, dtype=np.float32).reshape(7, 143)
    tone = toned(image, 100)
    np.testing.assert_allclose(tone, np.sqrt(image), atol=1e-6)
    assert toned(np.array([[np.nan, 1.0]], np.float32)).tolist() == [[0.0, 1.0]]


def test_a_place_that_cannot_be_written_is_named(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(DatasetError, match="could not be written"):
        write_panels(
            [Panel("grey", np.zeros((4, 4), np.float32))], tmp_path / "file" / "figure.png"
        )
