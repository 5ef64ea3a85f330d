"""Faults of device, parts and camera, from the bytes of the host to the picture."""

import numpy as np
import pytest
from tests.sim.flow import LEFT, OFF, SHUT, SIZE, instrument, one_led, step, take

from reliefscope.camera import CameraTimeout, open_camera
from reliefscope.device import DeviceRebootedError, ExposureEvent
from reliefscope.models.camera import CameraSettings
from reliefscope.protocol.messages import ResetCause
from reliefscope_sim.bench import Bench
from reliefscope_sim.electronics import DIP_US, WATCHDOG_US

SHORT_US = 1_000


def read_all_events(device):
    while True:
        device.events(5.0)


def start(device, count, run_id=1):
    device.load_steps([step(0, 0, count, SHORT_US)])
    device.start(run_id)


@pytest.mark.parametrize(
    ("fault", "cause"),
    [
        ("reset_at", ResetCause.PIN),
        ("brown_out_at", ResetCause.BROWN_OUT),
        ("watchdog_at", ResetCause.WATCHDOG),
    ],
)
def test_every_restart_is_told_with_its_cause(fault, cause):
    with instrument(f"scene=flat&fault={fault}:1") as (device, _, bench):
        start(device, 3)
        with pytest.raises(DeviceRebootedError) as caught:
            read_all_events(device)
        assert caught.value.cause is cause
        device.reconnect()
        assert bench.leds.levels.max() == 0
        device.load_aperture(0, LEFT)
        device.select_aperture(0)
        bench.wait(lambda: False, 50_000)
        np.testing.assert_array_equal(bench.glass.commanded_open, LEFT)


def test_a_failing_supply_takes_light_and_glass_with_it_at_once():
    with instrument("scene=flat&fault=brown_out_at:0") as (device, _, bench):
        start(device, 1)
        bench.wait(lambda: bench.shutter.strobe, 100_000)
        assert bench.leds.levels.max() == 4095
        assert bench.glass.driven.any()
        bench.wait(lambda: not bench.leds.levels.any(), 100_000)
        assert not bench.glass.driven.any()
        assert not bench.display.showing
        dark_us = bench.time_us
        bench.wait(lambda: bench.display.showing, 100_000)
        assert bench.time_us - dark_us >= DIP_US


def test_a_firmware_that_hangs_leaves_the_light_on_until_the_watchdog_bites():
    with instrument("scene=flat&fault=watchdog_at:0") as (device, _, bench):
        start(device, 1)
        bench.wait(lambda: bench.leds.levels.max() > 0, 100_000)
        lit_us = bench.time_us
        bench.wait(lambda: not bench.leds.levels.any(), 1_000_000)
        assert WATCHDOG_US < bench.time_us - lit_us < WATCHDOG_US + 20_000


def test_dead_and_stuck_leds_show_in_the_picture():
    table = [step(0, OFF), step(0, 0), step(0, 1)]

    def means(fault):
        with instrument(f"scene=flat&fault={fault}") as (device, camera, _):
            device.load_light(0, one_led(8, 1000))
            return [float(frame.raw.mean()) for _, frame in take(device, camera, table)]

    dark, eight, twelve = means("")
    assert means("led_dead:8") == pytest.approx([dark, dark, twelve], abs=1.0)
    stuck = means("led_stuck:12")
    assert stuck == pytest.approx([twelve, eight + twelve - dark, twelve], abs=2.0)


def test_parts_may_fail_later():
    table = [step(0, OFF, 2, SHORT_US), step(0, OFF, 2, SHORT_US)]
    with instrument("scene=flat&fault=led_stuck:3,parts_from:2") as (device, camera, _):
        before, same, *after = (f.raw.mean() for _, f in take(device, camera, table))
    assert before == pytest.approx(same, abs=1.0)
    assert min(after) > before + 20


@pytest.mark.parametrize("variant", ["S", "E"])
def test_a_dead_column_is_never_driven(variant):
    with instrument(f"scene=flat&glass={variant}&fault=lcd_column:60") as (device, camera, bench):
        take(device, camera, [step(0, 0)])
        shown = bench.glass.commanded_open
        expected = LEFT.copy()
        expected[:, 60] = variant == "E"
        np.testing.assert_array_equal(shown, expected)


def test_a_late_frame_comes_late_and_in_order():
    fault = "fault=camera_late:1,camera_late_ms:800"
    with instrument(f"scene=flat&{fault}") as (device, camera, bench):
        start(device, 3)
        while not isinstance(device.events(5.0), ExposureEvent):
            pass
        assert camera.next_frame(1.0).frame_id == 0
        with pytest.raises(CameraTimeout):
            camera.next_frame(0.5)
        late = camera.next_frame(1.0)
        assert bench.time_us - late.time_us > 800_000
        assert (late.frame_id, camera.next_frame(0.5).frame_id) == (1, 2)


def test_a_doubled_frame_repeats_its_number_and_its_pixels():
    with instrument("scene=flat&fault=camera_duplicate:1") as (device, camera, _):
        start(device, 3)
        frames = [camera.next_frame(5.0) for _ in range(4)]
    assert [frame.frame_id for frame in frames] == [0, 1, 1, 2]
    np.testing.assert_array_equal(frames[1].raw, frames[2].raw)


def test_a_torn_frame_is_the_upper_part_of_the_whole_one():
    table = [step(0, 0, 2)]

    def second(fault):
        with instrument(f"seed=2&scene=flat{fault}") as (device, camera, _):
            return take(device, camera, table)[1][1].raw

    whole, torn = second(""), second("&fault=camera_torn:1")
    assert 0 < len(torn) < len(whole)
    assert len(torn) % 2 == 0
    np.testing.assert_array_equal(torn, whole[: len(torn)])


def test_faults_drawn_at_a_rate_come_as_often_and_the_same_for_a_seed():
    def ids(seed):
        with instrument(f"scene=flat&seed={seed}&fault=camera_drop:25%") as (device, camera, _):
            device.load_steps([step(SHUT, OFF, 40, SHORT_US)])
            device.start(1)
            found = []
            while not found or found[-1] < 37:
                found.append(camera.next_frame(5.0).frame_id)
        return found

    first = ids(1)
    assert ids(1) == first
    assert ids(2) != first
    assert 22 < len(first) < 37


def test_gain_multiplies_signal_and_noise_but_not_the_black_level():
    with instrument("scene=flat&seed=3") as (device, camera, bench):
        device.load_light(0, one_led(8, 400))
        camera.disarm()
        pictures = {}
        for run_id, gain_db in enumerate((0.0, 1e-9, 12.0), start=1):
            camera.configure(CameraSettings(20_000, gain_db=gain_db))
            if gain_db == 1e-9:
                bench.shutter.gain_db = gain_db  # finer than the camera's own steps
            camera.arm()
            taken = take(device, camera, [step(SHUT, OFF, 2), step(0, 0, 2)], run_id)
            pictures[gain_db] = [frame.raw.astype(float) for _, frame in taken]
            camera.disarm()
    for plain, near in zip(pictures[0.0], pictures[1e-9], strict=True):
        np.testing.assert_array_equal(plain, near)
    gain = 10 ** (12 / 20)
    (dark, dark2, lit, lit2), (dark_g, dark2_g, lit_g, lit2_g) = pictures[0.0], pictures[12.0]
    assert dark_g.mean() == pytest.approx(dark.mean(), abs=1.5)
    assert (lit_g - dark_g).mean() == pytest.approx(gain * (lit - dark).mean(), rel=0.01)
    assert (lit_g - lit2_g).std() == pytest.approx(gain * (lit - lit2).std(), rel=0.05)
    assert (dark_g - dark2_g).std() == pytest.approx(gain * (dark - dark2).std(), rel=0.1)


def test_eight_bit_frames_are_the_twelve_bit_ones_in_coarser_steps():
    def picture(bits):
        with instrument(f"scene=flat&bits={bits}", name=f"bits{bits}") as (device, camera, _):
            ((_, frame),) = take(device, camera, [step(0, 0)])
            assert camera.info.bit_depth == bits
        return frame.raw

    coarse, fine = picture(8), picture(12)
    assert coarse.dtype == np.uint8
    assert np.abs(coarse / 255 - fine / 4095).max() < 1.1 / 255


def test_a_camera_of_another_depth_is_another_bench():
    camera = open_camera(f"sim://benchtop?{SIZE}&scene=flat&bits=8")
    try:
        with pytest.raises(Exception, match="already in use"):
            Bench.attach("sim://benchtop?bits=12")
    finally:
        camera.close()
