"""Joint matching: its kernel against plain numpy, its surfaces against truth and the exact search."""

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy import ndimage
from tests.reconstruction import scenes

from reliefscope.errors import Cancelled, InvalidInputError
from reliefscope.jobs import Job, Progress
from reliefscope.reconstruction import joint
from reliefscope.reconstruction.joint import (
    candidate_heights,
    light_groups,
    match_jointly,
    resolved_binning,
)
from reliefscope.reconstruction.joint_kernels import expand, score_tile_jointly
from reliefscope.reconstruction.mvs import match_views
from reliefscope.reconstruction.shifts import TAPS, ShiftPlan, plan_shifts
from reliefscope.units import BoolImage, FloatImage

Array = NDArray[np.float64]
RANGE_UM = (-6.0, 50.0)
SHAPE = (160, 208)
SOFTNESS = 0.07
CONTRAST = 0.15
INSIDE = np.s_[24:-24, 24:-24]


def shaded(scene: scenes.ParallaxScene, groups: int, seed: int) -> NDArray[np.float32]:
    """The scene's views under several lights: gains that vary slowly from place to place, fixed to the sample."""
    rng = np.random.default_rng(seed)
    out = []
    for _ in range(groups):
        smooth = ndimage.gaussian_filter(rng.standard_normal(scene.reference.shape), 25)
        out.append(scene.views * (1 + 0.3 * smooth / np.abs(smooth).max()))
    return np.asarray(out, dtype=np.float32)


def box(image: Array, window: int) -> Array:
    """Mean over windows that lie inside the image."""
    wide = np.lib.stride_tricks.sliding_window_view(image, (window, window))
    return np.asarray(wide.mean(axis=(2, 3)))


def expected_score(
    views: NDArray[np.float32], small: int, large: int, noise: float
) -> tuple[Array, Array]:
    """Harmonic mean of 1 - score + softness over channels and alike windows, for unshifted views; brightness."""
    total = np.zeros((1, 1))
    for channel in views.astype(np.float64):
        own = sum(box(v * v, small) - box(v, small) ** 2 for v in channel)
        summed = channel.sum(axis=0)
        of_sum = box(summed**2, small) - box(summed, small) ** 2
        score = (of_sum - own) / ((len(channel) - 1) * (own + len(channel) * noise))
        total = total + 1 / (1 - score + SOFTNESS)
    votes = np.lib.stride_tricks.sliding_window_view(total / len(views), (large, large))
    brightness = box(views.astype(np.float64).mean(axis=(0, 1)), small)
    around = np.lib.stride_tricks.sliding_window_view(brightness, (large, large))
    here = brightness[large // 2 : -(large // 2), large // 2 : -(large // 2)]
    weights = 1 / (1 + ((around - here[..., None, None]) / CONTRAST) ** 2)
    mean_vote = (weights * votes).sum(axis=(2, 3)) / weights.sum(axis=(2, 3))
    return 1 + SOFTNESS - 1 / mean_vote, here


@pytest.mark.parametrize(("small", "large"), [(3, 5), (5, 3), (7, 9)])
def test_kernel_is_its_formula_at_whole_shifts(small: int, large: int) -> None:
    rng = np.random.default_rng(2)
    base = scenes.texture((40, 48), 5) - 0.5
    views = np.asarray(
        [[g * (base + rng.normal(0, 0.04, base.shape)) for g in (1.0, 0.7, 1.3)] for _ in range(2)],
        dtype=np.float32,
    )
    moves = np.array([[0, 1], [2, -1], [-1, 0]])  # columns, rows
    height_um, pixel_um, noise = 56.0, 1.12, 2e-4
    plan = plan_shifts(moves * [-1, 1] * pixel_um / height_um, [height_um], pixel_um)
    reach = small // 2 + large // 2
    margin = reach + 2 + TAPS
    padded = np.pad(views, ((0, 0), (0, 0), (margin, margin), (margin, margin)), mode="edge")
    tile = np.array([12, 26, 13, 31])
    curves = np.empty((1, 14, 18), dtype=np.float32)
    brightness = np.empty((14, 18), dtype=np.float32)
    score_tile_jointly(
        padded,
        margin,
        plan.row_whole,
        plan.col_whole,
        plan.row_weights,
        plan.col_weights,
        np.ones((1, 3), np.bool_),
        tile,
        small,
        large,
        noise,
        SOFTNESS,
        CONTRAST,
        curves,
        brightness,
    )
    moved = np.stack([np.roll(views[:, k], (-m[1], -m[0]), (1, 2)) for k, m in enumerate(moves)], 1)
    part = moved[:, :, 12 - reach : 26 + reach, 13 - reach : 31 + reach]
    score, here = expected_score(part, small, large, noise)
    assert np.abs(curves[0] - score).max() < 2e-4
    assert np.abs(brightness - here).max() < 1e-5


def scored(padded: FloatImage, plan: ShiftPlan, used: BoolImage) -> tuple[FloatImage, FloatImage]:
    """Curves (N, 8, 8) and brightness (8, 8) of a tile in the middle of views (1, V, 40, 40) with a margin of 8."""
    curves = np.empty((len(used), 8, 8), dtype=np.float32)
    brightness = np.empty((8, 8), dtype=np.float32)
    score_tile_jointly(
        padded,
        8,
        plan.row_whole,
        plan.col_whole,
        plan.row_weights,
        plan.col_weights,
        used,
        np.array([4, 12, 4, 12]),
        3,
        5,
        0.0,
        SOFTNESS,
        CONTRAST,
        curves,
        brightness,
    )
    return curves, brightness


def test_kernel_leaves_out_unused_views_and_scores_nothing_from_too_few() -> None:
    rng = np.random.default_rng(4)
    padded = rng.random((1, 4, 40, 40), dtype=np.float32)
    padded[0, 1] = padded[0, 0]
    padded[0, 2] = padded[0, 0]
    used = np.array([[1, 1, 1, 1], [1, 1, 1, 0], [1, 0, 0, 0]], np.bool_)
    curves, _ = scored(padded, plan_shifts(np.zeros((4, 2)), [0.0, 1.0, 2.0], 1.0), used)
    assert curves[0].max() < 0.7
    assert np.allclose(curves[1], 1.0, atol=1e-4)  # three equal views
    assert np.isnan(curves[2]).all()  # no pair


def test_brightness_is_that_of_the_height_that_wins() -> None:
    rng = np.random.default_rng(5)
    padded = np.zeros((1, 3, 40, 40), dtype=np.float32)
    padded[:, :, :, :] = rng.random((1, 1, 40, 40), dtype=np.float32)
    plan = plan_shifts(np.array([[1.0, 0.0], [0.0, 0.0], [0.0, 1.0]]), [0.0, 2.0], 1.0)
    means = box(padded[0, 0].astype(np.float64), 3)[11:19, 11:19]
    _, there = scored(padded, plan, np.ones((2, 3), np.bool_))
    assert np.abs(there - means).max() < 1e-5
    elsewhere = np.array(
        [[0, 0, 0], [1, 1, 1]], np.bool_
    )  # nothing is known at the height that would win
    _, shifted = scored(padded, plan, elsewhere)
    assert np.abs(shifted - means).max() > 0.05


def test_plane_and_dome_are_found_at_least_as_well_as_by_the_exact_search() -> None:
    for height in (scenes.plane(0.05, 0.12, 6.0), scenes.dome(SHAPE, 40, 40.0)):
        scene = scenes.render(height, SHAPE, scenes.hexagon_slopes(12, 0.127), noise=0.005)
        exact = match_views(scene.views, scene.slopes, np.arange(-6.0, 51.0), scene.pixel_um)
        ours = match_jointly(shaded(scene, 4, 1), scene.slopes, RANGE_UM, scene.pixel_um, binning=2)
        errors = [np.abs(found.height_um - scene.height_um)[INSIDE] for found in (exact, ours)]
        assert np.isfinite(errors[1]).all()
        assert errors[1].mean() <= errors[0].mean()
        assert ours.accepted(joint.QUALITY_THRESHOLD)[INSIDE].mean() > 0.99


@pytest.mark.parametrize(("blur_px", "binning"), [(0.7, 1), (2.4, 2), (5.0, 4)])
def test_pixels_are_binned_as_far_as_the_images_are_blurred(blur_px: float, binning: int) -> None:
    image = scenes.texture((400, 420), 6, blur_px) + 0.2 * (np.arange(420) // 60 % 2)
    image = ndimage.gaussian_filter(image, blur_px)
    noisy = image + np.random.default_rng(1).normal(0, 0.002, image.shape)
    assert resolved_binning(noisy[None].astype(np.float32)) == binning


def test_a_step_stays_where_it_is() -> None:
    edge = 104

    def step(row: Array, col: Array) -> Array:
        return np.where(col < edge, 0.0, 30.0) + 0.0 * row

    scene = scenes.render(step, SHAPE, scenes.hexagon_slopes(12, 0.127))
    found = match_jointly(scene.views, scene.slopes, (-10.0, 40.0), scene.pixel_um)
    lower, upper = found.height_um[INSIDE[0], 40:94], found.height_um[INSIDE[0], 114:-24]
    assert np.abs(lower).mean() < 1.0
    assert np.abs(upper - 30.0).mean() < 1.0


def test_a_highlight_under_one_light_does_not_move_the_surface() -> None:
    scene = scenes.render(
        scenes.plane(0.0, 0.0, 20.0), SHAPE, scenes.hexagon_slopes(8), noise=0.002
    )
    channels = shaded(scene, 4, 3)
    rows, cols = np.mgrid[: SHAPE[0], : SHAPE[1]]
    for k, (sx, sy) in enumerate(scene.slopes):  # a mirrored lamp, 60 um below the surface
        shift = -40.0 / scene.pixel_um
        spot = np.hypot(rows - 80 - shift * sy, cols - 104 + shift * sx)
        channels[1, k] += 3.0 * np.exp(-((spot / 5) ** 2))
    mean = channels.mean(axis=0)
    heights = np.arange(-50.0, 50.0, 2.0)
    near = np.hypot(rows - 80, cols - 104) < 12
    exact = match_views(mean, scene.slopes, heights, scene.pixel_um).height_um[near]
    ours = match_jointly(channels, scene.slopes, (-50.0, 48.0), scene.pixel_um).height_um[near]
    assert np.abs(exact - 20.0).mean() > 10.0
    assert np.abs(ours - 20.0).mean() < 2.0


def test_gain_of_a_view_or_a_channel_does_not_matter() -> None:
    scene = scenes.render(scenes.plane(0.05, 0.1, 8.0), SHAPE)
    channels = shaded(scene, 2, 2)
    gains = np.array([[0.8, 1.1, 1.0, 0.9, 1.2, 1.0]], np.float32).T[None, :, :, None]
    plain = match_jointly(channels, scene.slopes, RANGE_UM, scene.pixel_um)
    scaled = match_jointly(channels * gains, scene.slopes, RANGE_UM, scene.pixel_um)
    assert np.nanpercentile(np.abs(plain.height_um - scaled.height_um), 95) < 0.3
    assert np.nanmedian(np.abs(plain.quality - scaled.quality)) < 0.01


def test_result_does_not_depend_on_threads_or_tiles(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = scenes.render(scenes.plane(0.05, 0.1, 8.0), (97, 129), scenes.hexagon_slopes(5))
    whole = match_jointly(scene.views, scene.slopes, RANGE_UM, scene.pixel_um)
    assert whole.height_um.shape == (97, 129)
    monkeypatch.setattr(joint, "TILE_ROWS", 11)
    monkeypatch.setattr(joint, "TILE_COLUMNS", 17)
    cut = match_jointly(scene.views, scene.slopes, RANGE_UM, scene.pixel_um)
    known = np.isfinite(whole.height_um) & np.isfinite(cut.height_um)
    assert known.mean() > 0.35
    assert np.abs(whole.height_um - cut.height_um)[24:-24, 24:-24].max() < 1e-3


def test_missing_pixels_are_a_narrow_frame() -> None:
    scene = scenes.render(scenes.plane(0.05, 0.1, 8.0), SHAPE)
    found = match_jointly(scene.views, scene.slopes, RANGE_UM, scene.pixel_um)
    missing = ~np.isfinite(found.height_um)
    assert not missing[20:-20, 20:-20].any()
    assert missing[0].all()
    assert np.all(found.quality[missing] == 0.0)
    assert np.all((found.height_um >= RANGE_UM[0]) | missing)
    assert np.all((found.height_um <= RANGE_UM[1]) | missing)


def test_candidates_are_spaced_by_parallax_and_reach_beyond_the_range() -> None:
    slopes = scenes.hexagon_slopes(12, 0.12)
    heights = candidate_heights(slopes, (-75.0, 75.0), 1.1, 2)
    step = np.diff(heights)
    assert np.allclose(step, step[0])
    assert step[0] * 0.12 / 2.2 <= joint.STEP_PX
    assert heights[0] == pytest.approx(-75.0 - step[0])
    assert heights[-1] == pytest.approx(75.0 + step[0])


def test_lights_are_grouped_by_azimuth() -> None:
    azimuth = np.radians([0, 90, 180, 270, 10, 100, 190, 280])
    directions = np.stack([np.cos(azimuth), np.sin(azimuth), np.ones(8)], axis=1)
    assert light_groups(directions, 8) == [[0, 4], [1, 5], [2, 6], [3, 7]]
    assert light_groups(directions[:3], 3) == [[0], [1], [2]]
    assert light_groups(None, 6) == [[0, 1], [2, 3], [4], [5]]


def test_expansion_is_linear_on_slopes_and_keeps_steps() -> None:
    coarse = np.tile(np.array([0, 1, 2, 3, 20, 21], np.float32), (4, 1))
    out = np.empty((9, 12), np.float32)
    expand(coarse, 2, 5.0, 0, 9, out)
    assert np.allclose(out[3], [0, 0.25, 0.75, 1.25, 1.75, 2.25, 2.75, 3, 20, 20.25, 20.75, 21])
    coarse[1, 1] = np.nan
    expand(coarse, 2, 5.0, 0, 9, out)
    assert np.isnan(out[2:4, 2:4]).all()
    assert np.isnan(out).sum() == 4


def test_progress_is_reported_and_a_request_to_stop_is_honoured() -> None:
    scene = scenes.render(scenes.plane(0.05, 0.1, 8.0), SHAPE)
    events: list[Progress] = []
    match_jointly(scene.views, scene.slopes, RANGE_UM, scene.pixel_um, Job(events.append))
    assert events[-1].finished
    assert events[-1].stage == "match"
    stopping = Job()
    stopping.subscribe(lambda event: stopping.cancel() if event.done == 1 else None)
    with pytest.raises(Cancelled):
        match_jointly(scene.views, scene.slopes, RANGE_UM, scene.pixel_um, stopping)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"range_um": (5.0, 5.0)}, "empty"),
        ({"range_um": (0.0, np.nan)}, "empty"),
        ({"range_um": (0.0, 1e5)}, "too far"),
        ({"slopes": np.zeros((3, 2))}, "no baseline"),
        ({"slopes": np.zeros((2, 2))}, "as many finite slopes"),
        ({"channels": np.zeros((30, 30), np.float32)}, "groups of lights"),
        ({"channels": np.full((2, 3, 30, 30), np.nan, np.float32)}, "not finite"),
        ({"pixel_um": 0.0}, "positive"),
    ],
)
def test_bad_input_is_refused(change: dict[str, object], words: str) -> None:
    good: dict[str, object] = {
        "channels": np.zeros((2, 3, 30, 30), np.float32),
        "slopes": scenes.hexagon_slopes(3),
        "range_um": (0.0, 20.0),
        "pixel_um": 1.0,
    }
    with pytest.raises(InvalidInputError, match=words) as caught:
        match_jointly(**(good | change))  # type: ignore[arg-type]
    assert caught.value.hint


def test_telecentricity_is_taken_out_of_the_map() -> None:
    kappa, pixel_um, height = 1e-3, 1.12, scenes.plane(0.0, 0.25, 4.0)
    slopes = scenes.hexagon_slopes(12, 0.127)
    rows, cols = np.mgrid[: SHAPE[0], : SHAPE[1]].astype(np.float64)
    middle = (np.array(SHAPE) - 1) / 2
    canvas = scenes.texture((SHAPE[0] + 48, SHAPE[1] + 48), 1)
    views = []
    for sx, sy in slopes:
        r, c = rows.copy(), cols.copy()
        for _ in range(60):  # what lies at (r, c) appears at (rows, cols)
            z = height(r, c)
            r = rows - z * (sy / pixel_um - kappa * (rows - middle[0]))
            c = cols + z * (sx / pixel_um + kappa * (cols - middle[1]))
        views.append(ndimage.map_coordinates(canvas, [r + 24, c + 24], order=3))
    frames = np.asarray(views, dtype=np.float32)
    told, untold = (
        np.abs(
            match_jointly(frames, slopes, (0.0, 60.0), pixel_um, telecentricity_per_um=k).height_um
            - height(rows, cols)
        )[INSIDE].mean()
        for k in (kappa, 0.0)
    )
    assert told < 0.25
    assert untold > 1.7 * told
