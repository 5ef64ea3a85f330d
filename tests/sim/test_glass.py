"""The liquid crystal against numerical integration and its definition."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from reliefscope.models.instrument import GlassModel
from reliefscope_sim.glass import Glass


def model(variant="S", rise_ms=140.0, decay_ms=180.0):
    return GlassModel(
        model="test",
        pitch_x_mm=0.4,
        pitch_y_mm=0.48,
        contrast_ratio=15.0,
        variant=variant,
        rise_ms=rise_ms,
        decay_ms=decay_ms,
    )


def bitmap(*pixels):
    shown = np.zeros((64, 128), dtype=bool)
    for row, column in pixels:
        shown[row, column] = True
    return shown


def test_ten_to_ninety_percent_takes_the_rise_and_decay_times():
    glass = Glass(model())
    glass.drive(0, bitmap((3, 4)))
    times = np.arange(0, 3_000_000, 500)
    opened = np.array([glass.transmission(t)[3, 4] for t in times])
    fraction = (opened - 1 / 15) / (1 - 1 / 15)
    rise = times[np.searchsorted(fraction, 0.9)] - times[np.searchsorted(fraction, 0.1)]
    assert rise / 1000 == pytest.approx(140, abs=1)
    glass.drive(3_000_000, bitmap())
    closing = np.array([glass.transmission(3_000_000 + t)[3, 4] for t in times])
    fraction = 1 - (closing - 1 / 15) / (1 - 1 / 15)
    decay = times[np.searchsorted(fraction, 0.9)] - times[np.searchsorted(fraction, 0.1)]
    assert decay / 1000 == pytest.approx(180, abs=1)


def test_average_over_switches_equals_numerical_integration():
    glass = Glass(model())
    glass.drive(10_000, bitmap((0, 0), (1, 1)))
    glass.drive(95_000, bitmap((1, 1), (2, 2)))
    glass.drive(130_000, bitmap((2, 2)))
    start, end = 60_000, 171_000
    moments = np.arange(start, end, 20) + 10
    sampled = np.mean([glass.transmission(int(t))[:3, :3] for t in moments], axis=0)
    mean = glass.mean_transmission(start, end)
    np.testing.assert_allclose(mean[:3, :3], sampled, atol=2e-5)


def test_settled_glass_has_exactly_two_transmissions():
    glass = Glass(model())
    glass.drive(0, bitmap((5, 5)))
    glass.drive(400_000, bitmap((6, 6)))
    values = np.unique(glass.mean_transmission(3_000_000, 3_020_000))
    np.testing.assert_allclose(values, [1 / 15, 1.0], rtol=1e-6)
    assert len(values) == 2


def test_ghost_after_a_short_settle_follows_the_closed_form():
    glass = Glass(model())
    glass.drive(0, bitmap((5, 5)))
    glass.drive(2_000_000, bitmap((6, 6)))
    wait, exposure = 60_000, 20_000
    tau = 180_000 / math.log(9)
    ghost = tau / exposure * (math.exp(-wait / tau) - math.exp(-(wait + exposure) / tau))
    mean = glass.mean_transmission(2_000_000 + wait, 2_000_000 + wait + exposure)
    assert mean[5, 5] == pytest.approx(1 / 15 + (1 - 1 / 15) * ghost, rel=1e-5)


def test_variants_rest_dark_or_clear_and_open_by_opposite_voltages():
    negative, positive = Glass(model("S")), Glass(model("E"))
    assert negative.transmission(0).max() == pytest.approx(1 / 15)
    assert positive.transmission(0).min() == pytest.approx(1.0)
    wanted = bitmap((8, 9))
    negative.drive(0, wanted)
    positive.drive(0, ~wanted)
    for glass in (negative, positive):
        np.testing.assert_array_equal(glass.commanded_open, wanted)
        settled = glass.transmission(5_000_000)
        assert settled[8, 9] == pytest.approx(1.0)
        assert settled[0, 0] == pytest.approx(1 / 15)


def test_forgetting_keeps_what_an_exposure_needs():
    glass, forgetful = Glass(model()), Glass(model())
    for number in range(20):
        shown = bitmap((number, 0), (number, 1))
        glass.drive(number * 30_000, shown)
        forgetful.drive(number * 30_000, shown)
        forgetful.forget_before(number * 30_000 - 10_000)
    np.testing.assert_array_equal(
        glass.mean_transmission(560_000, 600_000), forgetful.mean_transmission(560_000, 600_000)
    )
    with pytest.raises(ValueError, match="forgotten"):
        forgetful.mean_transmission(100_000, 120_000)


def test_driving_the_same_again_is_no_switch():
    glass = Glass(model())
    assert glass.drive(100, bitmap((1, 1)))
    assert not glass.drive(200, bitmap((1, 1)))
    assert glass.switches == 1


def test_time_never_runs_back():
    glass = Glass(model())
    glass.drive(100, bitmap((1, 1)))
    with pytest.raises(ValueError, match="before the last"):
        glass.drive(99, bitmap())
    with pytest.raises(ValueError, match="ends after it starts"):
        glass.mean_transmission(200, 200)


@given(
    switches=st.lists(st.integers(1, 300_000), min_size=1, max_size=6),
    cuts=st.lists(st.integers(1, 999_999), min_size=1, max_size=3, unique=True),
)
def test_averages_of_parts_add_up_to_the_average_of_the_whole(switches, cuts):
    glass = Glass(model())
    time_us = 0
    for number, wait_us in enumerate(switches):
        time_us += wait_us
        glass.drive(time_us, bitmap((0, 0)) if number % 2 else bitmap((0, 1)))
    edges = [0, *sorted(cuts), 1_000_000]
    parts = [
        (b - a) * glass.mean_transmission(a, b)[0, :2].astype(float)
        for a, b in itertools.pairwise(edges)
    ]
    whole = glass.mean_transmission(0, 1_000_000)[0, :2]
    np.testing.assert_allclose(np.sum(parts, axis=0) / 1_000_000, whole, rtol=1e-5)
