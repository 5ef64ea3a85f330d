"""The whole instrument, from bytes to photons."""

import math
import time

import numpy as np
import pytest
from tests.sim.flow import (
    EXPOSURE_US,
    LEFT,
    OFF,
    RIGHT,
    SHUT,
    instrument,
    one_led,
    step,
    take,
)

from reliefscope.camera import CameraLostError, CameraTimeout
from reliefscope.device import (
    DeviceRebootedError,
    LinkLostError,
    OutcomeUnknownError,
)
from reliefscope.protocol.messages import ExposureFlag, ResetCause


def test_frames_pair_with_events_by_count_and_by_time():
    steps = [step(0, 0, 2, 300_000), step(0, 1, 1, 1000), step(1, 0, 3, 300_000)]
    with instrument() as (device, camera, bench):
        taken = take(device, camera, steps)
        assert bench.display.faults == []
    assert [event.step for event, _ in taken] == [0, 0, 1, 2, 2, 2]
    assert [frame.frame_id for _, frame in taken] == list(range(6))
    for event, frame in taken:
        assert frame.time_us == event.start_us
        assert frame.exposure_us == event.exposure_us == EXPOSURE_US
        assert frame.raw.shape == (72, 96)
        assert ExposureFlag.STROBE_SEEN in event.flags
    starts = [event.start_us for event, _ in taken]
    assert np.diff(starts).min() >= EXPOSURE_US + 1_000_000 // 15, "the ready line holds it back"


def test_light_and_glass_show_in_the_picture():
    with instrument() as (device, camera, _):
        device.load_light(2, one_led(8, 2048))
        table = [(0, 0), (0, 2), (0, OFF), (SHUT, 0), (SHUT, OFF)]
        taken = take(device, camera, [step(*pair) for pair in table])
    full, half, dark, leak, both_off = (frame.raw.mean() for _, frame in taken)
    assert dark == pytest.approx(both_off, abs=1.0)
    assert (half - dark) / (full - dark) == pytest.approx(2048 / 4095, rel=0.01)
    assert dark < leak < full


def read_all_events(device):
    """Read until the device says no more, one way or the other."""
    while True:
        device.events(timeout_s=5.0)


def signal(frame, dark):
    return frame.raw.astype(float) - dark.raw.astype(float)


def test_too_short_a_settle_time_leaves_the_ghost_that_the_glass_law_gives():
    wait_us = 60_000
    order = [(SHUT, OFF), (SHUT, 0), (0, 0), (1, 0)]
    steps = [step(*pair) for pair in order] + [step(0, OFF), step(1, 0, settle_us=wait_us)]
    with instrument() as (device, camera, bench):
        glass = bench.profile.glass
        taken = take(device, camera, steps)
    dark, *frames = (frame for _, frame in taken)
    shut, left, right, _, hasty = (signal(frame, dark) for frame in frames)
    design = np.stack([(left - shut).ravel(), (right - shut).ravel()], axis=1)
    (ghost, wanted), *_ = np.linalg.lstsq(design, (hasty - shut).ravel(), rcond=None)

    def remaining(time_ms):
        """Average over the exposure of exp(-t / tau)."""
        tau, exposure = time_ms / math.log(9), EXPOSURE_US / 1000
        wait = taken[-1][0].settle_waited_us / 1000
        return tau / exposure * (math.exp(-wait / tau) - math.exp(-(wait + exposure) / tau))

    assert remaining(glass.decay_ms) > 0.3
    assert ghost == pytest.approx(remaining(glass.decay_ms), abs=0.02)
    assert wanted == pytest.approx(1 - remaining(glass.rise_ms), abs=0.02)


def test_reset_in_the_middle_of_an_exposure_turns_the_light_off_in_the_picture():
    steps = [step(0, OFF), step(0, 0), step(0, 0)]
    with instrument("fault=brown_out_at:2") as (device, camera, bench):
        device.load_steps(steps)
        device.start(1)
        frames = [camera.next_frame(timeout_s=10.0) for _ in steps]
        assert bench.leds.levels.max() == 0
        with pytest.raises(DeviceRebootedError):
            read_all_events(device)
        assert device.reconnect().reset_cause is ResetCause.BROWN_OUT
    dark, whole, cut = (frame.raw.mean() for frame in frames)
    assert (cut - dark) / (whole - dark) == pytest.approx(0.5, abs=0.03)


def test_retaking_gives_the_same_frames_bit_for_bit():
    steps = [step(0, 0, 2), step(1, 0), step(1, 1)]

    def fresh():
        with instrument("seed=4") as (device, camera, _):
            first = take(device, camera, steps)
            again = take(device, camera, steps, run_id=2)
        return [[frame.raw for _, frame in taken] for taken in (first, again)]

    first, again = fresh()
    other, _ = fresh()
    for a, b, c in zip(first, again, other, strict=True):
        np.testing.assert_array_equal(a, b)
        np.testing.assert_array_equal(a, c)
    assert not np.array_equal(first[0], first[1]), "repeats have noise of their own"


def test_another_seed_gives_other_noise():
    def picture(seed):
        with instrument(f"scene=flat&seed={seed}") as (device, camera, _):
            ((_, frame),) = take(device, camera, [step(SHUT, OFF)])
        return frame.raw

    assert not np.array_equal(picture(1), picture(2))


def test_virtual_time_is_fast():
    with instrument("scene=flat") as (device, camera, bench):
        take(device, camera, [step(0, 0)])  # compiles
        before_us, started = bench.time_us, time.perf_counter()
        take(device, camera, [step(n % 2, 0, settle_us=10_000_000) for n in range(6)], run_id=2)
        assert bench.time_us - before_us > 60_000_000
        assert time.perf_counter() - started < 6


def test_real_time_follows_the_wall():
    with instrument("scene=flat&time=real") as (device, camera, bench):
        steps = [step(0, 0, settle_us=150_000), step(1, 0, settle_us=150_000)]
        bench.poll()
        before_us, started = bench.time_us, time.monotonic()
        taken = take(device, camera, steps)
        bench.poll()
        spent_s = time.monotonic() - started
        assert spent_s > 0.3
        assert (bench.time_us - before_us) / 1e6 == pytest.approx(spent_s, abs=0.1)
        assert [frame.frame_id for _, frame in taken] == [0, 1]
        with pytest.raises(CameraTimeout):
            camera.next_frame(timeout_s=0.1)


@pytest.mark.parametrize("options", ["glass=E", "mounting=top_view", "glass=E&mounting=top_view"])
def test_every_glass_and_mounting_shows_the_bitmap(options):
    with instrument(f"scene=flat&{options}") as (device, camera, bench):
        resting = 1.0 if "glass=E" in options else 1 / 15
        assert bench.glass.transmission(bench.time_us).mean() == pytest.approx(resting, abs=0.1)
        taken = take(device, camera, [step(0, OFF), step(1, 0)])
        np.testing.assert_array_equal(bench.glass.commanded_open, RIGHT)
        assert bench.display.faults == []
        assert len(taken) == 2


def test_wrong_mounting_setting_turns_the_aperture():
    from reliefscope.protocol.messages import Mounting, SetSettingsRequest

    with instrument("scene=flat&mounting=top_view") as (device, _, bench):
        now = device.settings()
        device.store_settings(
            SetSettingsRequest(
                serial_number=now.serial_number,
                glass_variant=now.glass_variant,
                mounting=Mounting.BOTTOM_VIEW,
                contrast=now.contrast,
                resistor_ratio=now.resistor_ratio,
            )
        )
        device.select_aperture(0)
        bench.wait(lambda: False, 50_000)
        np.testing.assert_array_equal(bench.glass.commanded_open, LEFT[::-1, ::-1])


def test_light_goes_off_when_the_host_falls_silent():
    with instrument("scene=flat") as (device, _, bench):
        device.select_light(0)
        assert bench.leds.levels.max() == 4095
        bench.wait(lambda: False, 2_100_000)
        assert bench.leds.levels.max() == 0


def test_lost_frame_shows_as_a_gap():
    with instrument("scene=flat&fault=camera_drop:1") as (device, camera, _):
        device.load_steps([step(0, 0, 3)])
        device.start(1)
        ids = [camera.next_frame(timeout_s=5.0).frame_id for _ in range(2)]
        assert ids == [0, 2]
        assert camera.dropped == 1
        with pytest.raises(CameraTimeout):
            camera.next_frame(timeout_s=1.0)


def test_unplugged_camera_says_so():
    with instrument("scene=flat&fault=camera_unplug:1") as (device, camera, _):
        device.load_steps([step(0, 0, 3)])
        device.start(1)
        assert camera.next_frame(timeout_s=5.0).frame_id == 0
        with pytest.raises(CameraLostError):
            camera.next_frame(timeout_s=5.0)


def test_lossy_link_loses_no_event():
    faults = "fault=link_loss:0.1,link_flip:0.0005,link_duplicate:0.1,link_delay:2"
    with instrument(f"scene=flat&{faults}") as (device, camera, bench):
        taken = take(device, camera, [step(n % 2, n % 2, 2, 50_000) for n in range(8)])
        assert [event.index for event, _ in taken] == list(range(16))
        assert [frame.frame_id for _, frame in taken] == list(range(16))
        assert bench.leds.levels.max() == 0
        assert device.link_counters["retries"] > 0


def test_stalled_device_is_told_from_a_slow_one():
    with instrument("scene=flat&fault=stall_at:1") as (device, camera, _):
        device.load_steps([step(0, 0, 3)])
        device.start(1)
        with pytest.raises(OutcomeUnknownError):
            read_all_events(device)
        assert camera.next_frame(timeout_s=1.0).frame_id == 0


def test_cut_link_ends_in_an_error_and_opening_again_mends_it():
    with instrument("scene=flat&fault=link_cut:0") as (device, _, bench):
        device.load_steps([step(0, 0)])
        device.start(1)
        with pytest.raises((LinkLostError, OutcomeUnknownError)):
            read_all_events(device)
        bench.close_port()
        assert bench.open_port()
        assert device.reconnect().boot_nonce == device.identity.boot_nonce
