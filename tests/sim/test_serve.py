"""The simulated instrument for other processes: TCP, pseudo-terminal, camera beside it."""

import contextlib
import json
import socket
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from tests.sim.flow import LEFT, OFF, RIGHT, SHUT, SIZE, one_led, step, take

from reliefscope.camera import CameraBusyError, CameraLostError, CameraTimeout, open_camera
from reliefscope.device import Device
from reliefscope.errors import CameraError, DeviceError, InvalidInputError
from reliefscope.models.base import load_model
from reliefscope.models.calibration import Calibration
from reliefscope.models.camera import Camera, CameraSettings
from reliefscope.models.instrument import InstrumentProfile
from reliefscope_sim.serve import InstrumentServer, in_real_time

URL = f"sim://served?{SIZE}&scene=flat"
EXPOSURE_US = 20_000


@pytest.fixture
def server():
    with InstrumentServer(URL) as running:
        yield running


@contextlib.contextmanager
def connected(server):
    with Device.open(server.device_url) as device:
        camera = open_camera(server.camera_url)
        try:
            yield device, camera
        finally:
            camera.close()


def test_a_sequence_over_tcp_gives_the_frames_of_the_same_bench(server):
    table = [step(SHUT, OFF, settle_us=1000), step(0, 0, 2, settle_us=300_000)]
    with connected(server) as (device, camera):
        assert isinstance(camera, Camera)
        assert camera.info.shape == (72, 96)
        device.load_aperture(0, LEFT)
        device.load_light(0, one_led(8))
        assert camera.configure(CameraSettings(EXPOSURE_US, gain_db=3.0)).gain_db == 3.0
        camera.arm()
        started = time.monotonic()
        taken = take(device, camera, table)
        assert time.monotonic() - started > 0.3, "time is real"
        assert camera.dropped == 0
        camera.disarm()
    assert [frame.frame_id for _, frame in taken] == [0, 1, 2]
    for event, frame in taken:
        assert frame.time_us == event.start_us
        assert frame.raw.dtype == np.uint16
        assert frame.raw.flags.writeable
    dark, lit, _ = (frame.raw.mean() for _, frame in taken)
    assert lit > dark + 100


def test_the_device_is_a_serial_port_of_the_system():
    if sys.platform == "win32":
        pytest.skip("no pseudo-terminals")
    with InstrumentServer(URL, terminal=True) as server:
        assert Path(server.device_url).exists()
        for _ in range(2):  # it can be opened again
            with Device.open(server.device_url) as device:
                assert device.load_aperture(1, RIGHT) == int(RIGHT.sum())


def test_one_client_at_a_time_and_the_next_one_afterwards(server):
    with connected(server) as (device, _):
        host, _, port = server.device_url.removeprefix("socket://").partition(":")
        with socket.create_connection((host, int(port)), 5) as second:
            assert second.recv(1) == b"", "closed at once"
        with pytest.raises(CameraError):
            open_camera(server.camera_url)
        assert device.status().exposures == 0
    deadline = time.monotonic() + 5
    while True:
        with contextlib.suppress(CameraError, DeviceError), connected(server) as (device, _):
            assert device.identity.board == "host"
            return
        assert time.monotonic() < deadline


def test_a_camera_held_by_somebody_in_this_process_is_busy(server):
    own = open_camera(URL)
    try:
        with pytest.raises(CameraBusyError, match="already open"):
            open_camera(server.camera_url)
    finally:
        own.close()


def test_any_client_can_speak_the_cameras_lines(server):
    host, port = server.camera_url.removeprefix("sim+tcp://").removesuffix("/camera").split(":")
    with socket.create_connection((host, int(port)), 5) as client, client.makefile("rwb") as lines:

        def ask(text):
            lines.write(text.encode() + b"\n")
            lines.flush()
            return json.loads(lines.readline())

        assert ask('{"do": "info"}')["info"]["sensor"] == "bayer_rggb"
        assert ask('{"do": "configure", "exposure_us": 5000, "trigger": false}')["settings"]
        assert ask('{"do": "arm"}') == {}
        reply = ask('{"do": "next_frame", "timeout_s": 2}')
        pixels = np.frombuffer(lines.read(reply["bytes"]), "<u2")
        assert pixels.reshape(reply["frame"]["shape"]).shape == (72, 96)
        assert ask('{"do": "configure", "exposure_us": 5000}')["error"] == "CameraBusyError"
        assert ask('{"do": "develop"}')["error"] == "InvalidInputError"
        assert "no request" in ask("hello")["message"]
        assert "no request" in ask('{"do": "next_frame"}')["message"]
        assert "no request" in ask("[]")["message"]


def test_errors_of_the_camera_keep_their_kind(server):
    with connected(server) as (_, camera):
        with pytest.raises(CameraError, match="not armed"):
            camera.next_frame(0.1)
        camera.arm()
        with pytest.raises(CameraTimeout, match=r"0\.2 s"):
            camera.next_frame(0.2)
        server.close()
        with pytest.raises(CameraLostError, match="gone"):
            camera.next_frame(0.1)


def test_wrong_addresses_are_refused():
    with pytest.raises(InvalidInputError, match="virtual"):
        InstrumentServer(URL + "&time=virtual")
    assert in_real_time("sim://x") == "sim://x?time=real"
    assert in_real_time("sim://x?time=real") == "sim://x?time=real"
    with pytest.raises(InvalidInputError, match="no camera address"):
        open_camera("sim+tcp://localhost")
    with InstrumentServer(URL) as server:
        taken = int(server.device_url.rpartition(":")[2])
        with pytest.raises(DeviceError, match="cannot be listened on"):
            InstrumentServer("sim://other?size=32x32", port=taken)
    with pytest.raises(CameraError, match="No camera answers"):
        open_camera(server.camera_url)


def test_the_command_serves_another_process_until_it_is_told_to_end(tmp_path):
    program = "import sys; from reliefscope.cli import main; sys.exit(main())"
    arguments = ["sim", "serve", f"{URL}&as_built=3", "--json", "--save", str(tmp_path / "here")]
    serving = subprocess.Popen(
        [sys.executable, "-c", program, *arguments], stdout=subprocess.PIPE, text=True
    )
    try:
        assert serving.stdout is not None
        said = json.loads(serving.stdout.readline())
        assert load_model(InstrumentProfile, tmp_path / "here/profile.yml").shape == (72, 96)
        calibration = load_model(Calibration, tmp_path / "here/calibration.yml")
        assert calibration.source == "factory"
        with Device.open(said["device"]) as device:
            camera = open_camera(said["camera"])
            device.load_aperture(0, LEFT)
            device.load_light(0, one_led(8))
            camera.configure(CameraSettings(EXPOSURE_US))
            camera.arm()
            ((event, frame),) = take(device, camera, [step(0, 0, settle_us=50_000)])
            assert frame.time_us == event.start_us
            camera.close()
    finally:
        serving.terminate()
        assert serving.wait(timeout=20) == 0
        assert serving.stdout is not None
        serving.stdout.close()
