"""The camera's timing, pulse by pulse."""

import numpy as np
import pytest

from reliefscope.models.instrument import load_profile
from reliefscope_sim.faults import Faults
from reliefscope_sim.firmware import NEVER_US
from reliefscope_sim.glass import Glass
from reliefscope_sim.lights import LedLines
from reliefscope_sim.shutter import BUFFERS, Shutter

READOUT_US = 100_000


def shutter(fault="", *, triggered=True, exposure_us=20_000):
    leds = LedLines(2)
    leds.set_level(0, 0, 4095)
    made = Shutter(Glass(load_profile("benchtop").glass), leds, 10.0, Faults.parse(fault))
    made.configure(exposure_us, triggered=triggered)
    return made


def run(made, until_us, pulses=()):
    """Step as the bench does: from event to event, pulses in between."""
    due = sorted(pulses)
    time_us = 0
    while time_us < until_us:
        pulse_us = due[0] if due else NEVER_US
        time_us = max(time_us + 1, min(until_us, made.next_event_us, pulse_us))
        made.run_until(time_us)
        if due and time_us >= due[0]:
            made.pulse(due.pop(0))
    return time_us


def fetched(made):
    return list(iter(made.fetch, None))


def test_one_frame_per_pulse_after_exposure_and_readout():
    made = shutter()
    made.arm(0)
    run(made, 1000 + 20_000 + READOUT_US - 1, pulses=[1000])
    assert made.fetch() is None
    made.run_until(1000 + 20_000 + READOUT_US)
    frame = made.fetch()
    assert (frame.frame_id, frame.start_us, frame.exposure_us) == (0, 1000, 20_000)
    np.testing.assert_allclose(frame.led_energy, [0.02, 0.0])
    assert made.fetch() is None


def test_strobe_is_high_while_exposing_and_ready_while_a_pulse_would_be_taken():
    made = shutter()
    assert not made.ready(0)
    made.arm(0)
    assert made.ready(0)
    made.pulse(500)
    for time_us, strobe, ready in [
        (501, True, False),
        (20_499, True, False),
        (20_500, False, False),
        (120_499, False, False),
        (120_500, False, True),
    ]:
        made.run_until(time_us)
        assert (made.strobe, made.ready(time_us)) == (strobe, ready), time_us
    assert made.next_event_us == NEVER_US


def test_pulses_during_exposure_and_readout_are_missed_and_leave_gaps():
    made = shutter()
    made.arm(0)
    run(made, 500_000, pulses=[0, 10_000, 60_000, 130_000])
    assert [frame.frame_id for frame in fetched(made)] == [0, 3]
    assert made.dropped == 2


def test_pulses_while_not_armed_do_nothing_but_count():
    made = shutter()
    made.pulse(0)
    made.run_until(500_000)
    made.arm(500_000)
    made.pulse(500_000)
    made.run_until(700_000)
    assert [frame.frame_id for frame in fetched(made)] == [0]
    assert made.pulses == 2


def test_lost_frame_leaves_a_gap():
    made = shutter("camera_drop:1")
    made.arm(0)
    run(made, 800_000, pulses=[0, 200_000, 400_000])
    assert [frame.frame_id for frame in fetched(made)] == [0, 2]
    assert made.dropped == 1


def test_unplugged_camera_gives_nothing_more():
    made = shutter("camera_unplug:1")
    made.arm(0)
    run(made, 800_000, pulses=[0, 200_000, 400_000])
    assert made.unplugged
    assert fetched(made) == []
    assert not made.ready(800_000)


def test_buffers_are_bounded_and_keep_the_oldest_under_trigger():
    made = shutter(exposure_us=20)
    made.arm(0)
    count = BUFFERS + 5
    run(made, (count + 1) * 110_000, pulses=[n * 110_000 for n in range(count)])
    frames = fetched(made)
    assert [frame.frame_id for frame in frames] == list(range(BUFFERS))
    assert made.dropped == 5


def test_free_running_keeps_its_rate_and_the_newest_frames():
    made = shutter(triggered=False)
    made.arm(0)
    run(made, 1_050_000)
    starts = [frame.start_us for frame in fetched(made)]
    assert starts == [n * READOUT_US for n in range(len(starts))]
    assert len(starts) == pytest.approx(10, abs=1)
    run(made, 1_050_000 + (BUFFERS + 20) * READOUT_US)
    newest = fetched(made)
    assert len(newest) == BUFFERS
    assert made.dropped > 0
    assert newest[-1].frame_id > BUFFERS


def test_long_exposures_slow_the_free_running_camera_down():
    made = shutter(triggered=False, exposure_us=250_000)
    made.arm(0)
    run(made, 2_000_000)
    starts = np.diff([frame.start_us for frame in fetched(made)])
    assert set(starts) == {250_000}


def test_disarming_ends_everything():
    made = shutter(triggered=False)
    made.arm(0)
    run(made, 250_000)
    made.disarm()
    assert made.next_event_us == NEVER_US
    assert fetched(made) == []
    assert made.needs_from_us is None


def test_repeats_count_while_glass_and_light_stay_the_same():
    glass, leds = Glass(load_profile("benchtop").glass), LedLines(2)
    made = Shutter(glass, leds, 10.0, Faults())
    made.configure(20_000, triggered=True)
    made.arm(0)
    keys = []
    for number, (pixel, led) in enumerate([(0, 0), (0, 0), (0, 1), (1, 1), (1, 1), (0, 0)]):
        time_us = number * 200_000
        shown = np.zeros((64, 128), dtype=bool)
        shown[0, pixel] = True
        made.run_until(time_us)
        glass.drive(time_us, shown)
        for index in range(2):
            leds.set_level(time_us, index, 4095 if index == led else 0)
        made.pulse(time_us)
        made.run_until(time_us + 199_000)
        (frame,) = fetched(made)
        keys.append((frame.glass_key, frame.light_key, frame.repeat))
    assert [repeat for *_, repeat in keys] == [0, 1, 0, 0, 1, 0]
    assert keys[0] == keys[5]
    assert len(set(keys)) == 5
