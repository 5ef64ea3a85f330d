"""Matching against eq. 3 computed pair by pair in float64, closed forms, and signs."""

from itertools import combinations

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy import ndimage
from tests.reconstruction import scenes

from reliefscope.errors import Cancelled, InvalidInputError
from reliefscope.jobs import Job, Progress
from reliefscope.reconstruction import matcher
from reliefscope.reconstruction.matcher import Form
from reliefscope.reconstruction.mvs import match_image, match_views, mean_ncc

Array = NDArray[np.float64]
FORMS: tuple[Form, Form] = ("pairs", "variance_of_sum")


def keys_kernel(x: Array) -> Array:
    """Cubic convolution of Keys (1981), eq. 15 with a = -1/2."""
    d = np.abs(x)
    near = 1.5 * d**3 - 2.5 * d**2 + 1
    far = -0.5 * d**3 + 2.5 * d**2 - 4 * d + 2
    return np.where(d < 1, near, np.where(d < 2, far, 0.0))


def sample_axis(image: Array, shift: float, axis: int) -> Array:
    """Image at index + shift along an axis, NaN outside the grid, border repeated for the outer tap."""
    size = image.shape[axis]
    position = np.arange(size) + shift
    taps = np.floor(position)[:, None] + np.arange(-1, 3)
    weights = keys_kernel(position[:, None] - taps)
    valid = (position >= 0) & (position <= size - 1)
    values = np.take(image, np.clip(taps, 0, size - 1).astype(int), axis=axis)
    out = np.einsum("nt,nt...->n...", weights, np.moveaxis(values, (axis, axis + 1), (0, 1)))
    out[~valid] = np.nan
    return np.moveaxis(out, 0, axis)


def shifted(image: NDArray[np.float32], rows: float, cols: float) -> Array:
    """The reference's own sampling at (row + rows, col + cols)."""
    return sample_axis(sample_axis(image.astype(np.float64), rows, 0), cols, 1)


def pairwise_ncc(samples: list[Array], window: int) -> Array:
    """Mean of eq. 3 over the pairs whose windows have no invalid sample; NaN below half of the pairs."""
    shape = samples[0].shape
    half = window // 2
    total, count = np.zeros(shape), np.zeros(shape)
    everything = list(combinations(range(len(samples)), 2))
    for row in range(half, shape[0] - half):
        for col in range(half, shape[1] - half):
            box = np.s_[row - half : row + half + 1, col - half : col + half + 1]
            windows = [sample[box] - sample[box].mean() for sample in samples]
            for i, j in everything:
                a, b = windows[i], windows[j]
                if np.isfinite(a).all() and np.isfinite(b).all():
                    norm = np.sqrt((a * a).sum() * (b * b).sum())
                    total[row, col] += (a * b).sum() / norm if norm > 1e-9 else 0.0
                    count[row, col] += 1
    return np.where(count >= len(everything) / 2, total / np.maximum(count, 1), np.nan)


def unequal_views(shape: tuple[int, int], count: int, seed: int) -> NDArray[np.float32]:
    """Views that share a texture, each with its own gain, offset and 12-bit noise."""
    rng = np.random.default_rng(seed)
    base = scenes.texture(shape, seed)
    gains = rng.uniform(0.2, 1.2, count)
    views = [gain * (base + rng.normal(0, 0.03, shape)) + rng.uniform(0, 0.4) for gain in gains]
    return (np.round(np.asarray(views) * 4095) / 4095).astype(np.float32)


@pytest.mark.parametrize("window", [5, 7, 9, 11, 15])
def test_mean_ncc_is_equation_3_at_whole_pixel_shifts(window: int) -> None:
    views = unequal_views((30, 34), 4, seed=3)
    moves = np.array([[0, 1], [2, -1], [-1, 0], [1, 2]])  # columns, rows
    pixel_um, height_um = 1.12, 56.0
    slopes = moves * [-1, 1] * pixel_um / height_um
    reference = [shifted(v, float(m[1]), float(m[0])) for v, m in zip(views, moves, strict=True)]
    for v, m, sampled in zip(views, moves, reference, strict=True):  # whole pixels: a mere roll
        inner = np.s_[3:-3, 3:-3]
        assert np.array_equal(np.roll(v, (-m[1], -m[0]), (0, 1))[inner], sampled[inner])
    score = mean_ncc(views, slopes, height_um, pixel_um, window)
    expected = pairwise_ncc(reference, window)
    half = window // 2
    inside = np.s_[half:-half, half:-half]
    assert np.array_equal(np.isnan(score[inside]), np.isnan(expected[inside]))
    assert np.isfinite(score).sum() > 100
    assert np.nanmax(np.abs(score - expected)) < 1e-4


def test_mean_ncc_is_equation_3_at_fractional_shifts_of_twelve_views() -> None:
    views = unequal_views((28, 30), 12, seed=5)
    slopes = scenes.hexagon_slopes(12, 0.11)
    height_um, pixel_um = 23.7, 1.12
    samples = [
        shifted(v, height_um * sy / pixel_um, -height_um * sx / pixel_um)
        for v, (sx, sy) in zip(views, slopes, strict=True)
    ]
    score = mean_ncc(views, slopes, height_um, pixel_um)
    expected = pairwise_ncc(samples, 15)
    inside = np.s_[7:-7, 7:-7]
    assert np.array_equal(np.isnan(score[inside]), np.isnan(expected[inside]))
    assert np.isfinite(expected).sum() > 100
    assert np.nanmax(np.abs(score - expected)) < 1e-4


def test_windows_of_weak_texture_on_a_strong_mean_keep_their_accuracy() -> None:
    rng = np.random.default_rng(8)
    ramp = np.linspace(0.1, 0.9, 64)[None, :] * np.ones((40, 1))
    shared = rng.normal(0, 4e-4, ramp.shape)
    views = np.asarray(
        [g * (ramp.round(1) + shared + rng.normal(0, 4e-4, ramp.shape)) for g in (0.3, 1.0, 0.8)],
        dtype=np.float32,
    )
    score = mean_ncc(views, scenes.hexagon_slopes(3), 0.0, 1.0)
    expected = pairwise_ncc([v.astype(np.float64) for v in views], 15)
    assert np.nanmax(np.abs(score - expected)) < 1e-4


def test_saturated_windows_score_nothing() -> None:
    views = np.ones((4, 40, 60), dtype=np.float32)
    views[:, :, 40:] = scenes.texture((40, 20), 1)
    score = mean_ncc(views, scenes.hexagon_slopes(4), 0.0, 1.12)
    assert np.all(score[8:-8, 8:32] == 0.0)


def test_gain_and_offset_of_a_view_do_not_matter() -> None:
    scene = scenes.render(scenes.plane(0.05, 0.1, 10.0))
    altered = scene.views * np.linspace(0.2, 0.9, 6, dtype=np.float32)[:, None, None]
    altered += np.linspace(0.1, 0.0, 6, dtype=np.float32)[:, None, None]
    before = mean_ncc(scene.views, scene.slopes, 17.0, scene.pixel_um)
    after = mean_ncc(altered, scene.slopes, 17.0, scene.pixel_um)
    assert np.nanmax(np.abs(before - after)) < 1e-4


def test_tiles_do_not_show(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = scenes.render(scenes.plane(0.05, 0.1, 10.0))
    whole = mean_ncc(scene.views, scene.slopes, 17.3, scene.pixel_um)
    monkeypatch.setattr(matcher, "TILE_COLUMNS", 37)
    monkeypatch.setattr(matcher, "TILE_BYTES", 37 * 4 * 21)
    cut = mean_ncc(scene.views, scene.slopes, 17.3, scene.pixel_um)
    assert np.array_equal(np.isnan(whole), np.isnan(cut))
    assert np.nanmax(np.abs(whole - cut)) < 1e-6


def test_flat_windows_score_nothing_and_identical_views_score_one() -> None:
    view = scenes.texture((40, 60), 2).astype(np.float32)
    view[:, :30] = 0.25
    views = np.stack([view, view, view])
    score = mean_ncc(views, scenes.hexagon_slopes(3), 0.0, 1.12)
    assert np.all(score[8:-8, 8:22] == 0.0)
    assert np.allclose(score[8:-8, 38:-8], 1.0, atol=1e-5)
    assert np.isnan(score[:7]).all()
    assert np.isnan(score[:, :7]).all()


def test_noise_floor_lowers_scores_by_the_share_of_noise() -> None:
    view = scenes.texture((40, 60), 2).astype(np.float32)
    views = np.stack([view, view])
    floor = 0.004
    score = mean_ncc(views, scenes.hexagon_slopes(2), 0.0, 1.12, noise_variance=floor)
    variance = ndimage.uniform_filter(view.astype(float) ** 2, 15) - (
        ndimage.uniform_filter(view.astype(float), 15) ** 2
    )
    inside = np.s_[7:-7, 7:-7]
    assert np.allclose(score[inside], (variance / (variance + floor))[inside], atol=1e-4)


def test_variance_of_sum_is_the_mean_ncc_of_views_that_differ_by_a_gain() -> None:
    scene = scenes.render(scenes.plane(0.0, 0.0, 20.0), noise=0.004)
    gains = np.array([0.3, 1.0, 0.6, 0.8, 0.45, 0.9], dtype=np.float32)
    views = scene.views * gains[:, None, None]
    for height_um in (0.0, 11.3, 19.0, 20.0, 27.7):
        pairs = mean_ncc(views, scene.slopes, height_um, scene.pixel_um)
        by_sum = mean_ncc(views, scene.slopes, height_um, scene.pixel_um, form="variance_of_sum")
        assert np.array_equal(np.isnan(pairs), np.isnan(by_sum))
        assert np.nanmax(np.abs(pairs - by_sum)) < 0.03
    assert np.nanmin(by_sum) >= -1.0


def test_variance_of_sum_is_its_own_formula() -> None:
    views = unequal_views((40, 44), 3, seed=6)
    slopes = scenes.hexagon_slopes(3)
    score = mean_ncc(views, slopes, 0.0, 1.0, form="variance_of_sum", noise_variance=1e-3)
    gains = matcher.equal_gains(views)
    assert gains.mean() == pytest.approx(1.0)
    scaled = views.astype(np.float64) * gains[:, None, None]
    for row, col in ((7, 7), (20, 20), (32, 36), (15, 30)):
        box = scaled[:, row - 7 : row + 8, col - 7 : col + 8].reshape(3, -1)
        own = box.var(axis=1).sum()
        expected = (box.sum(axis=0).var() - own) / (2 * (own + 1e-3 * (gains**2).sum()))
        assert score[row, col] == pytest.approx(expected, abs=1e-5)


def test_variance_of_sum_finds_the_same_surface() -> None:
    scene = scenes.render(scenes.dome((96, 128), 30, 40.0), noise=0.005)
    heights = np.arange(-6.0, 50.0, 2.0)
    both = [
        match_views(scene.views, scene.slopes, heights, scene.pixel_um, parabola=True, form=form)
        for form in FORMS
    ]
    errors = [np.abs(result.height_um - scene.height_um) for result in both]
    assert np.nanmedian(errors[1]) < 1.1 * np.nanmedian(errors[0])
    assert np.array_equal(np.isnan(errors[0]), np.isnan(errors[1]))


def test_a_dark_view_does_not_silence_the_others() -> None:
    views = unequal_views((40, 44), 3, seed=6)
    views[1] = 0.0
    gains = matcher.equal_gains(views)
    assert gains[1] <= 101 * gains[[0, 2]].max()
    score = mean_ncc(views, scenes.hexagon_slopes(3), 0.0, 1.0)
    assert 0.2 < np.nanmedian(score) < 0.34  # one pair of three
    assert np.array_equal(matcher.equal_gains(np.zeros((2, 5, 5), np.float32)), [1.0, 1.0])


def test_sign_of_the_numeric_example() -> None:
    # a = (1.5, -0.75) mm, f_o = 18 mm, z = 60 um, 1.12 um/px: 4.464 columns left, 2.232 rows up.
    slope = np.array([1.5, -0.75]) / 18
    canvas = scenes.texture((120, 140), 4)
    rows, cols = np.mgrid[:120, :140].astype(float)
    reference = canvas.astype(np.float32)
    moved = ndimage.map_coordinates(canvas, [rows + 2.232, cols + 4.464], order=5, mode="nearest")
    views = np.stack([reference, moved.astype(np.float32)])
    slopes = np.stack([np.zeros(2), slope])
    result = match_views(views, slopes, np.arange(0.0, 100.0, 4.0), 1.12, parabola=True)
    inner = result.height_um[20:-20, 20:-20]
    assert abs(np.median(inner) - 60.0) < 0.3
    mirrored = match_views(views, slopes * [1, -1], np.arange(0.0, 100.0, 4.0), 1.12)
    assert np.median(mirrored.quality) < 0.5 < np.median(result.quality[20:-20, 20:-20])


def test_plane_and_dome_are_found() -> None:
    heights = np.arange(-6.0, 50.0, 1.0)
    tilted = scenes.render(scenes.plane(0.1, 0.15, 5.0))
    result = match_views(tilted.views, tilted.slopes, heights, tilted.pixel_um, parabola=True)
    error = np.abs(result.height_um - tilted.height_um)[result.accepted()]
    assert result.accepted()[20:-20, 20:-20].all()
    assert np.median(error) < 0.25
    dome = scenes.render(scenes.dome((96, 128), 30, 40.0), noise=0.005)
    result = match_views(dome.views, dome.slopes, heights, dome.pixel_um)
    error = np.abs(result.height_um - dome.height_um)[result.accepted()]
    assert np.median(error) < 0.75
    assert np.percentile(error, 99) < 4.0


def test_paper_takes_the_candidate_and_the_median_of_the_curve() -> None:
    scene = scenes.render(scenes.plane(0.0, 0.1, 8.0), shape=(48, 64))
    heights = np.array([-3.0, 0.0, 4.0, 9.0, 11.0, 13.0, 20.0, 31.0])
    result = match_views(scene.views, scene.slopes, heights, scene.pixel_um)
    curves = np.stack([mean_ncc(scene.views, scene.slopes, z, scene.pixel_um) for z in heights])
    known = np.isfinite(curves).sum(axis=0) >= 4
    assert np.array_equal(np.isfinite(result.height_um), known)
    assert np.all(result.quality[~known] == 0.0)
    curves = curves[:, known]
    assert np.allclose(result.height_um[known], heights[np.nanargmax(curves, axis=0)])
    assert np.allclose(result.peak[known], np.nanmax(curves, axis=0), atol=1e-6)
    lead = np.nanmax(curves, axis=0) - np.nanmedian(curves, axis=0)
    assert np.allclose(result.quality[known], lead, atol=1e-5)


def test_parabola_beats_the_candidate_at_the_double_step() -> None:
    scene = scenes.render(scenes.plane(0.05, 0.12, 6.0))
    heights = np.arange(-4.0, 36.0, 4.0)
    errors = []
    for parabola in (False, True):
        result = match_views(scene.views, scene.slopes, heights, scene.pixel_um, parabola=parabola)
        errors.append(np.nanmedian(np.abs(result.height_um - scene.height_um)))
    assert errors[1] < 0.4 * errors[0]


def test_whole_image_window_measures_a_flat_object() -> None:
    truth = 23.4
    scene = scenes.render(scenes.plane(0.0, 0.0, truth), shape=(64, 96), noise=0.01)
    match = match_image(scene.views, scene.slopes, np.arange(0.0, 60.0, 2.0), scene.pixel_um)
    assert abs(match.height_um - truth) < 0.2
    assert match.scores.shape == (30,)
    at = mean_whole(scene, 24.0)
    assert match.scores[12] == pytest.approx(at, abs=1e-5)


def mean_whole(scene: scenes.ParallaxScene, height_um: float) -> float:
    """Mean correlation coefficient of the shifted images where every height of the search is valid."""
    reach = 58.0 * np.abs(scene.slopes) / scene.pixel_um
    left, up = (int(np.ceil(v)) for v in reach.max(axis=0))
    box = np.s_[up:-up, left:-left]
    flat = [
        shifted(v, height_um * sy / scene.pixel_um, -height_um * sx / scene.pixel_um)[box].ravel()
        for v, (sx, sy) in zip(scene.views, scene.slopes, strict=True)
    ]
    matrix = np.asarray(np.corrcoef(flat))
    return float(matrix[np.triu_indices(len(flat), 1)].mean())


def test_progress_is_reported_and_a_request_to_stop_is_honoured(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    scene = scenes.render(scenes.plane(0.0, 0.1, 8.0), shape=(48, 64))
    monkeypatch.setattr(matcher, "TILE_COLUMNS", 16)
    events: list[Progress] = []
    job = Job(events.append)
    match_views(scene.views, scene.slopes, np.arange(9.0), scene.pixel_um, job=job)
    assert [event.done for event in events][:5] == [0, 1, 2, 3, 4]
    assert events[-1].finished
    stopping = Job()
    stopping.subscribe(lambda event: stopping.cancel() if event.done == 1 else None)
    with pytest.raises(Cancelled):
        match_views(scene.views, scene.slopes, np.arange(9.0), scene.pixel_um, job=stopping)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"slopes": np.zeros((3, 2))}, "no baseline"),
        ({"slopes": np.zeros((2, 2))}, "as many finite slopes"),
        ({"slopes": np.full((3, 2), np.nan)}, "as many finite slopes"),
        ({"views": np.full((3, 20, 20), np.nan, np.float32)}, "not finite"),
        ({"views": np.zeros((1, 20, 20), np.float32)}, "at least two views"),
        ({"heights_um": [0.0, 1.0]}, "increasing"),
        ({"heights_um": [0.0, 2.0, 1.0]}, "increasing"),
        ({"heights_um": [0.0, 100.0, 1e5]}, "more than the image"),
        ({"window": 4}, "odd"),
        ({"window": 21}, "fit the image"),
        ({"pixel_um": 0.0}, "positive"),
    ],
)
def test_bad_input_is_refused(change: dict[str, object], words: str) -> None:
    good: dict[str, object] = {
        "views": np.zeros((3, 20, 20), np.float32),
        "slopes": scenes.hexagon_slopes(3),
        "heights_um": np.arange(10.0),
        "pixel_um": 1.0,
    }
    with pytest.raises(InvalidInputError, match=words) as caught:
        match_views(**(good | change))  # type: ignore[arg-type]
    assert caught.value.hint
