"""Matching of real photographs through seven sub-apertures of a microscope (no ground truth)."""

import json
from pathlib import Path

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray
from tests.support import shared_data

from reliefscope.reconstruction.joint import match_jointly
from reliefscope.reconstruction.mvs import QUALITY_THRESHOLD, MvsResult, match_views
from reliefscope.reconstruction.smoothing import smooth_robust

RODS = {"upper": ((140, 80), (160, 290), 12), "lower": ((318, 75), (225, 330), 20)}
"""Ends of the axis (row, col) and half width of the part of each rod that is away from its edges."""


ONE_LIGHT_QUALITY = 0.1
"""Threshold of joint matching here: one light alone, and nothing but smoothing after it."""

Chips = tuple[MvsResult, NDArray[np.bool_], float]
"""Result, valid pixels, and a threshold of quality."""


@pytest.fixture(scope="module", params=["pairs", "joint"])
def chips(request: pytest.FixtureRequest) -> Chips:
    folder = shared_data("lightfield_microscope_chips") / "Chips_4_views"
    index = json.loads((folder / "views.json").read_text(encoding="utf-8"))
    views = np.stack([grey(folder / view["file"]) for view in index["views"]])
    # view(row + d u, col + d v) shows what the centre shows at (row, col); a point at height z appears at
    # (x - z sx, y - z sy) with y up: d is the height when pixel_um is 1, sx = -v and sy = u.
    slopes = [[-view["v_col"], view["u_row"]] for view in index["views"]]
    rows, cols = np.mgrid[: views.shape[1], : views.shape[2]]
    middle = (views.shape[1] - 1) / 2, (views.shape[2] - 1) / 2
    valid = np.hypot(rows - middle[0], cols - middle[1]) <= index["valid_radius_px"]
    if request.param == "joint":
        return match_jointly(views, slopes, (0.0, 28.0), 1.0), valid, ONE_LIGHT_QUALITY
    exact = match_views(views, slopes, np.arange(0.0, 28.5, 0.5), 1.0)
    return exact, valid, QUALITY_THRESHOLD


def grey(path: Path) -> NDArray[np.float32]:
    image = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE)
    assert image is not None
    return (image / 255).astype(np.float32)


def test_coverage(chips: Chips) -> None:
    result, valid, threshold = chips
    accepted = result.accepted(threshold) & valid
    assert accepted.sum() >= 0.75 * valid.sum()
    assert np.median(result.peak[accepted]) > 0.6


def test_rods_are_smooth_tilted_planes(chips: Chips) -> None:
    result, valid, threshold = chips
    kept = np.where(result.accepted(threshold) & valid, result.height_um, np.nan).astype(np.float32)
    smooth = smooth_robust(kept, result.quality).values
    rows, cols = np.mgrid[: smooth.shape[0], : smooth.shape[1]]
    for name, (start, end, half) in RODS.items():
        axis = np.subtract(end, start)
        length = np.hypot(*axis)
        along = ((rows - start[0]) * axis[0] + (cols - start[1]) * axis[1]) / length
        across = ((cols - start[1]) * axis[0] - (rows - start[0]) * axis[1]) / length
        rod = (along >= 0) & (along <= length) & (np.abs(across) <= half)
        design = np.stack([along[rod], across[rod], np.ones(int(rod.sum()))], axis=1)
        fitted, *_ = np.linalg.lstsq(design, smooth[rod].astype(np.float64), rcond=None)
        residual = smooth[rod] - design @ fitted
        fall = -fitted[0] * length
        assert fall > 4.0, name
        assert residual.std() < 0.05 * fall, name
