"""Voltage and temperature: the laws by themselves, and what they do to the picture."""

import math

import numpy as np
import pytest
from tests.sim.flow import LEFT, OFF, SHUT, instrument, step, take

from reliefscope.models.instrument import load_profile
from reliefscope.protocol.messages import SetSettingsRequest
from reliefscope_sim.glass import Glass
from reliefscope_sim.liquid_crystal import Drive, aligned_fraction, multiplexed, slowdown

RATIO, VOLUME = 7, 22  # what the firmware starts with


def effective(waveform):
    return math.sqrt(np.mean(np.square(waveform)))


def test_effective_voltages_are_those_of_the_multiplexed_waveform():
    v0 = 6.4 * (1 - (63 - VOLUME) / 162) * 2.1
    others = [v0 / 9] * 63
    drive = multiplexed(RATIO, VOLUME, 9)
    assert drive.on_v == pytest.approx(effective([v0, *others]))
    assert drive.off_v == pytest.approx(effective([v0 * 7 / 9, *others]))


def test_a_bias_of_a_ninth_separates_64_rows_best():
    def ratio(bias):
        drive = multiplexed(RATIO, VOLUME, bias)
        return drive.on_v / drive.off_v

    assert ratio(9) == pytest.approx(math.sqrt((8 + 1) / (8 - 1)))  # Alt and Pleshko, N = 64
    assert ratio(9) > max(ratio(7), ratio(11))


def test_the_contrast_that_the_firmware_starts_with_is_right_at_room_temperature():
    drive = multiplexed(RATIO, VOLUME, 9)
    assert (aligned_fraction(drive.off_v), aligned_fraction(drive.on_v)) == (0.0, 1.0)


def test_alignment_grows_with_voltage_and_with_temperature():
    volts = np.linspace(1.3, 1.8, 60)
    room = [aligned_fraction(v) for v in volts]
    cold = [aligned_fraction(v, 0.0) for v in volts]
    assert np.all(np.diff(room) >= 0)
    assert (room[0], room[-1]) == (0.0, 1.0)
    assert all(c <= r for c, r in zip(cold, room, strict=True))
    assert min(cold) < max(room)


def test_switching_follows_arrhenius():
    assert slowdown(25.0) == 1.0
    energy_ev = math.log(slowdown(0.0)) * 8.617333e-5 / (1 / 273.15 - 1 / 298.15)
    assert energy_ev == pytest.approx(0.45)
    room, cold = (Glass(load_profile("benchtop").glass, temperature_c=t) for t in (25.0, 0.0))
    for glass in (room, cold):
        glass.drive(0, LEFT)
    open_at = [
        glass.transmission(t)[LEFT][0]
        for glass, t in ((room, 100_000), (cold, round(100_000 * slowdown(0.0))))
    ]
    assert open_at[0] == pytest.approx(open_at[1], abs=1e-5)


@pytest.mark.parametrize("variant", ["S", "E"])
def test_partly_aligned_pixels_relax_to_where_their_voltage_takes_them(variant):
    model = load_profile("benchtop").glass.model_copy(update={"variant": variant})
    glass = Glass(model)
    glass.drive(0, LEFT, (0.25, 0.75))
    settled = glass.transmission(10_000_000)
    for pixel, aligned in ((settled[LEFT][0], 0.75), (settled[0, 0], 0.25)):
        opened = aligned if variant == "S" else 1 - aligned
        assert pixel == pytest.approx(1 / 15 + (1 - 1 / 15) * opened, rel=1e-5)
    start, end = 5_000, 255_000
    moments = range(start + 50, end, 100)
    sampled = np.mean([glass.transmission(t)[30, 50:60] for t in moments], axis=0)
    np.testing.assert_allclose(glass.mean_transmission(start, end)[30, 50:60], sampled, atol=1e-5)


def set_contrast(device, contrast):
    now = device.settings()
    device.store_settings(
        SetSettingsRequest(
            now.serial_number, now.glass_variant, now.mounting, contrast, now.resistor_ratio
        )
    )


def brightness(device, camera, run_id):
    """Light through the open square and through the shut glass, above dark."""
    taken = take(device, camera, [step(SHUT, OFF), step(0, 0), step(SHUT, 0)], run_id)
    dark, opened, shut = (float(frame.raw.mean()) for _, frame in taken)
    return opened - dark, shut - dark


def test_the_contrast_setting_of_the_firmware_acts_on_the_light():
    with instrument("scene=flat") as (device, camera, _):
        opened, shut = brightness(device, camera, 1)
        set_contrast(device, 17)
        faint, still_shut = brightness(device, camera, 2)
        set_contrast(device, 28)
        _, leaking = brightness(device, camera, 3)
    assert still_shut == pytest.approx(shut, rel=0.02)
    assert faint - still_shut < 0.9 * (opened - shut)
    assert leaking > 2 * shut


def test_in_the_cold_the_same_wait_leaves_more_of_the_view_before():
    def opened(temperature):
        with instrument(f"scene=flat&temperature={temperature}") as (device, camera, bench):
            take(device, camera, [step(1, OFF), step(0, 0, settle_us=200_000)])
            return bench.glass.transmission(bench.time_us)[LEFT].mean()

    assert 1 - opened(5) > 10 * (1 - opened(25))


def test_no_voltage_where_nothing_is_shown():
    with instrument("scene=flat") as (_, _, bench):
        bench.display.set_reset(0)
        assert bench.display.drive() == Drive(0.0, 0.0)
