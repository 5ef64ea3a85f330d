"""Energy of LED lines over exposures."""

import numpy as np
import pytest

from reliefscope_sim.lights import LedLines


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
