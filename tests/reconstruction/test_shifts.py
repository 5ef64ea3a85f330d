"""Sampling, shift plans and tiles."""

import threading

import numba
import numpy as np
import pytest
from numpy.typing import NDArray
from tests.reconstruction import scenes
from tests.reconstruction.shifting import shift_image

from reliefscope.jobs import Job
from reliefscope.reconstruction import tiles
from reliefscope.reconstruction.mvs import match_views
from reliefscope.reconstruction.shifts import (
    keys_weights,
    plan_shifts,
    split_shift,
    valid_span,
)

Array = NDArray[np.float64]


def test_plan_has_the_signs_and_sizes_of_the_numeric_example() -> None:
    plan = plan_shifts([[1.5 / 18, -0.75 / 18]], [0.0, 60.0], 1.12)
    assert plan.col_px[:, 0] == pytest.approx([0.0, -4.464], abs=1e-3)
    assert plan.row_px[:, 0] == pytest.approx([0.0, -2.232], abs=1e-3)
    assert plan.col_whole[1, 0] == -5
    assert plan.row_whole[1, 0] == -3


def test_interpolation_keeps_quadratics_and_whole_pixels() -> None:
    rows, cols = np.mgrid[:20, :24].astype(np.float64)

    def surface(r: Array, c: Array) -> Array:
        return np.asarray(0.01 * r * r - 0.02 * r * c + 0.015 * c * c + 0.1 * r - 0.3 * c + 2)

    image = surface(rows, cols).astype(np.float32)
    shifted = shift_image(image, 1.37, -2.61)
    expected = surface(rows + 1.37, cols - 2.61)
    assert np.allclose(shifted[1:-3, 4:-1], expected[1:-3, 4:-1], atol=1e-5)
    assert np.array_equal(shift_image(image, 2, -3)[:-2, 3:], image[2:, :-3])
    assert np.array_equal(shift_image(image, 2 - 1e-9, -3)[:-2, 3:], image[2:, :-3])


def test_samples_outside_are_nan_and_all_others_are_not() -> None:
    image = scenes.texture((12, 15), 3).astype(np.float32)
    for row_px, col_px in ((0.0, 0.0), (0.5, -0.5), (-3.0, 4.0), (2.25, -7.75), (30.0, 0.0)):
        rows = np.arange(12) + row_px
        cols = np.arange(15) + col_px
        inside = ((rows >= 0) & (rows <= 11))[:, None] & ((cols >= 0) & (cols <= 14))[None, :]
        assert np.array_equal(np.isfinite(shift_image(image, row_px, col_px)), inside)


def test_spans_of_windows_are_those_of_their_samples() -> None:
    for shift in (-4.5, -1.0, 0.0, 0.25, 3.0, 7.9, 40.0):
        for radius in (0, 3):
            first, stop = (int(v[0]) for v in valid_span(np.array([shift]), 20, radius))
            position = np.arange(20) + shift
            valid = (position - radius >= 0) & (position + radius <= 19)
            assert np.array_equal(np.flatnonzero(valid), np.arange(first, stop))


def test_weights_sum_to_one_and_are_symmetric() -> None:
    fraction = np.linspace(0, 0.999, 50)
    weights = keys_weights(fraction)
    assert np.allclose(weights.sum(axis=-1), 1.0, atol=1e-6)
    assert np.allclose(keys_weights(1 - fraction)[..., ::-1], weights, atol=1e-6)
    whole, exact = split_shift(np.array([-2.0, 3.0000000001]))
    assert whole.tolist() == [-2, 3]
    assert np.array_equal(exact, [[0, 1, 0, 0]] * 2)


def test_tiles_cover_evenly() -> None:
    assert tiles.spans(10, 4) == [(0, 3), (3, 6), (6, 10)]
    assert tiles.spans(4, 4) == [(0, 4)]


def test_an_error_in_one_tile_is_raised_and_drops_the_rest() -> None:
    begun: list[int] = []
    gate = threading.Event()

    def work(item: int) -> None:
        begun.append(item)
        if item == 0:
            raise ValueError("tile 0")
        gate.wait(0.2)

    with Job().stage("test", 200) as stage, pytest.raises(ValueError, match="tile 0"):
        tiles.run_each(work, range(200), stage)
    assert len(begun) < 100


def test_heights_do_not_depend_on_the_number_of_threads() -> None:
    scene = scenes.render(scenes.plane(0.0, 0.1, 8.0), shape=(48, 64))
    before = numba.get_num_threads()
    results = []
    try:
        for threads in (1, before):
            numba.set_num_threads(threads)
            results.append(
                match_views(scene.views, scene.slopes, np.arange(0.0, 30.0, 2.0), scene.pixel_um)
            )
    finally:
        numba.set_num_threads(before)
    assert np.array_equal(results[0].height_um, results[1].height_um, equal_nan=True)
    assert np.array_equal(results[0].quality, results[1].quality)
