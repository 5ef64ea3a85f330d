"""Energy of LED lines over exposures."""

import numpy as np
import pytest

from reliefscope.units import US_PER_S
from reliefscope_sim.lights import WARMING_S, LedLines

TAU_US = round(WARMING_S * US_PER_S)


def test_energy_is_level_times_time_within_the_exposure():
    leds = LedLines(3)
    leds.set_level(1_000, 0, 4095)
    leds.set_level(1_000, 2, 819)
    leds.set_level(21_000, 0, 0)
    leds.set_level(11_000 + 10_000, 2, 0)
    energy = leds.energy(6_000, 26_000)
    np.testing.assert_allclose(energy, [0.015, 0.0, 0.003], rtol=1e-12)
    assert leds.levels.tolist() == [0, 0, 0]


def test_change_at_the_start_of_an_exposure_counts_from_there():
    leds = LedLines(1)
    leds.set_level(500, 0, 4095)
    np.testing.assert_allclose(leds.energy(500, 1500), [0.001])
    np.testing.assert_allclose(leds.energy(0, 500), [0.0])


def test_lines_without_led_change_nothing():
    leds = LedLines(2)
    leds.set_level(10, 47, 4095)
    assert leds.energy(0, 1000).tolist() == [0.0, 0.0]


def test_forgetting_keeps_what_is_on():
    leds = LedLines(1)
    leds.set_level(100, 0, 4095)
    leds.set_level(200, 0, 2000)
    leds.set_level(300, 0, 4095)
    leds.forget_before(250)
    np.testing.assert_allclose(leds.energy(250, 350), [(50 * 2000 / 4095 + 50) * 1e-6])
    with pytest.raises(ValueError, match="forgotten"):
        leds.energy(150, 350)


def test_time_never_runs_back():
    leds = LedLines(1)
    leds.set_level(100, 0, 5)
    with pytest.raises(ValueError, match="before the last"):
        leds.set_level(99, 0, 6)


def test_warming_takes_light_as_the_law_says():
    leds = LedLines(2, droop=0.05)
    leds.set_level(0, 0, 4095)
    leds.set_level(0, 1, 2048)
    span = (3_000_000, 4_000_000)
    time_s = np.linspace(3.0, 4.0, 20_001)
    for led, fraction in enumerate((1.0, 2048 / 4095)):
        warmth = fraction * (1 - np.exp(-time_s / WARMING_S))
        light = np.trapezoid(fraction * (1 - 0.05 * warmth), time_s)
        assert leds.energy(*span)[led] == pytest.approx(light, rel=1e-8)
    assert leds.mean_levels(*span).tolist() == [4095, 2048]


def test_a_warm_led_loses_the_droop_and_gets_it_back_in_the_dark():
    leds = LedLines(1, droop=0.05)
    leds.set_level(0, 0, 4095)
    warm = leds.energy(10 * TAU_US, 10 * TAU_US + 1000)[0]
    assert warm == pytest.approx(0.95e-3, rel=1e-5)
    leds.set_level(10 * TAU_US + 1000, 0, 0)
    leds.set_level(30 * TAU_US, 0, 4095)
    assert leds.energy(30 * TAU_US, 30 * TAU_US + 1000)[0] == pytest.approx(1e-3, rel=1e-5)


def test_a_pinned_line_does_not_do_what_it_is_told():
    leds = LedLines(2)
    leds.set_level(0, 1, 100)
    leds.pin(10, 0, 4095)
    leds.pin(10, 1, 0)
    leds.set_level(20, 0, 0)
    leds.set_level(20, 1, 4095)
    assert leds.levels.tolist() == [4095, 0]
