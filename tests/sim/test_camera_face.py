"""The simulated camera by the contract of every camera."""

import threading
import time

import numpy as np
import pytest

from reliefscope.errors import CameraError
from reliefscope.models.camera import Camera, CameraBusyError, CameraSettings, CameraTimeout
from reliefscope_sim.bench import Bench
from reliefscope_sim.camera import EXPOSURE_RANGE_US, SimCamera

URL = "sim://benchtop?size=96x72&scene=flat"


@pytest.fixture
def camera():
    opened = SimCamera(URL)
    yield opened
    opened.close()


def test_it_is_a_camera_and_says_which(camera):
    assert isinstance(camera, Camera)
    assert camera.info.shape == (72, 96)
    assert camera.info.sensor == "bayer_rggb"
    assert camera.info.bit_depth == 12
    assert "simulated" in camera.info.model


def test_free_running_frames_come_at_the_camera_rate(camera):
    camera.configure(CameraSettings(20_000, trigger=False))
    camera.arm()
    frames = [camera.next_frame(1.0) for _ in range(5)]
    assert [frame.frame_id for frame in frames] == list(range(5))
    assert np.diff([frame.time_us for frame in frames]).tolist() == [66_667] * 4
    assert frames[0].raw.dtype == np.uint16
    assert frames[0].raw.shape == (72, 96)
    camera.disarm()
    camera.arm()
    assert camera.next_frame(1.0).frame_id == 0


def test_preview_shows_what_is_on_at_the_moment(camera):
    camera.configure(CameraSettings(20_000, trigger=False))
    camera.arm()
    bench = Bench.attach(URL)
    dark = camera.next_frame(1.0).raw.mean()
    bench.leds.set_level(bench.time_us, 8, 4095)
    camera.next_frame(1.0)
    bright = camera.next_frame(1.0).raw.mean()
    bench.release()
    assert bright > dark + 20


def test_no_frame_ends_in_a_timeout_of_the_instruments_time(camera):
    camera.configure(CameraSettings(20_000))
    camera.arm()
    bench = Bench.attach(URL)
    before_us = bench.time_us
    with pytest.raises(CameraTimeout, match=r"2\.5 s"):
        camera.next_frame(2.5)
    assert bench.time_us - before_us == 2_500_000
    bench.release()


def test_settings_are_bounded_and_fixed_while_armed(camera):
    low, high = EXPOSURE_RANGE_US
    assert camera.configure(CameraSettings(1)).exposure_us == low
    assert camera.configure(CameraSettings(10**9)).exposure_us == high
    assert camera.configure(CameraSettings(5000, gain_db=6.04)).gain_db == 6.0
    camera.arm()
    with pytest.raises(CameraBusyError, match="armed"):
        camera.configure(CameraSettings(5000))


def test_without_arming_no_wait_is_needed_to_know_that_nothing_comes(camera):
    with pytest.raises(CameraError, match="not armed"):
        camera.next_frame(10.0)


def test_one_holder_at_a_time(camera):
    with pytest.raises(CameraBusyError, match="already open"):
        SimCamera("sim://benchtop")
    camera.close()
    camera.close()
    again = SimCamera(URL)
    again.close()
    with pytest.raises(ValueError, match="closed"):
        again.arm()


def test_closing_ends_a_wait_of_another_thread():
    camera = SimCamera(f"{URL}&time=real")
    camera.configure(CameraSettings(1000))
    camera.arm()
    outcome = []

    def wait():
        try:
            camera.next_frame(60.0)
        except CameraError as error:
            outcome.append(error)

    waiter = threading.Thread(target=wait)
    waiter.start()
    time.sleep(0.05)
    camera.close()
    waiter.join(timeout=5)
    assert len(outcome) == 1


def test_camera_in_one_thread_and_device_in_another(camera):
    serial = pytest.importorskip("serial")
    serial.protocol_handler_packages.append("reliefscope_sim.serial_handlers")
    camera.configure(CameraSettings(1000, trigger=False))
    camera.arm()
    ids = []
    preview = threading.Thread(
        target=lambda: ids.extend(camera.next_frame(5.0).frame_id for _ in range(30))
    )
    with serial.serial_for_url(URL, timeout=0.01) as port:
        preview.start()
        while preview.is_alive():
            port.write(b"\0")
            port.read(64)
        preview.join()
    serial.protocol_handler_packages.remove("reliefscope_sim.serial_handlers")
    assert len(ids) == 30
    assert ids == sorted(set(ids))
