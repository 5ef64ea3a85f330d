"""Opening ports: real ones, sockets, schemes of installed packages, and what goes wrong."""

import os
import socket
import sys
import threading
import types
from contextlib import suppress

import pytest
import serial
from tests.device.fake import FakeDevice, FakePort

from reliefscope.device import Device, DeviceNotFoundError, OutcomeUnknownError, ports
from reliefscope.errors import ExitCode, LockedError
from reliefscope.protocol.framing import FrameReader


class Server:
    """A fake device behind a loopback TCP port."""

    def __init__(self, device):
        self.device = device
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.url = f"socket://127.0.0.1:{self.listener.getsockname()[1]}"
        self.thread = threading.Thread(target=self._serve)
        self.connection = None

    def _serve(self):
        self.connection, _ = self.listener.accept()
        reader = FrameReader()
        with self.connection, suppress(OSError):  # the client or the test may end it at any time
            while data := self.connection.recv(4096):
                for frame in reader.feed(data):
                    self.device.take(frame)
                outbox, self.device.outbox = self.device.outbox, []
                for frame in outbox:
                    self.connection.sendall(frame.encode())

    def __enter__(self):
        self.thread.start()
        return self

    def __exit__(self, *_):
        self.listener.close()
        self.thread.join(5)
        assert not self.thread.is_alive()


def test_socket():
    with Server(FakeDevice()) as server, Device.open(server.url) as device:
        assert device.identity.board == "fake"
        for slot in range(20):
            assert device.select_light(slot).slot == slot
        assert set(server.device.executed.values()) == {1}


@pytest.mark.skipif(sys.platform == "win32", reason="pseudo-terminals are POSIX")
def test_serial_port_of_the_operating_system():
    """A pseudo-terminal behaves as a USB serial port does, without one."""
    fake, reader, stop = FakeDevice(), FrameReader(), threading.Event()
    leader, follower = os.openpty()
    os.set_blocking(leader, False)

    def serve():
        while not stop.wait(0.0005):
            with suppress(BlockingIOError):
                for frame in reader.feed(os.read(leader, 4096)):
                    fake.take(frame)
            outbox, fake.outbox = fake.outbox, []
            for frame in outbox:
                os.write(leader, frame.encode())

    thread = threading.Thread(target=serve)
    thread.start()
    try:
        with Device.open(os.ttyname(follower)) as device:
            for slot in range(20):
                assert device.select_light(slot).slot == slot
            assert device.load_light(0, [257] * 48).level_sum == 257 * 48
        assert set(fake.executed.values()) == {1}
    finally:
        stop.set()
        thread.join(5)
        os.close(leader)
        os.close(follower)


def test_socket_that_closes_is_an_unknown_outcome():
    with Server(FakeDevice()) as server, Device.open(server.url) as device:
        server.connection.shutdown(socket.SHUT_WR)
        with pytest.raises(OutcomeUnknownError):
            device.select_light(1)


def test_nobody_listens():
    with socket.create_server(("127.0.0.1", 0)) as listener:
        port = listener.getsockname()[1]
    with pytest.raises(DeviceNotFoundError, match="could not be opened") as caught:
        Device.open(f"socket://127.0.0.1:{port}")
    assert "reliefscope sim serve" in caught.value.hint
    assert f"127.0.0.1:{port}" in caught.value.hint
    assert "Teensy" not in caught.value.hint


@pytest.mark.skipif(sys.platform == "win32", reason="another message of the system")
def test_unknown_name_tells_the_ports_and_what_an_address_is(monkeypatch):
    listed = [ports.PortInfo("/dev/ttyS7", "serial port", "", is_teensy=False)]
    monkeypatch.setattr(ports, "list_ports", lambda: listed)
    with pytest.raises(DeviceNotFoundError, match="foo") as caught:
        Device.open("foo")
    for word in ("/dev/ttyS7", "sim://benchtop", "socket://host:port"):
        assert word in caught.value.hint


@pytest.mark.parametrize("url", ["/dev/no-such-port", "nonsense://here"])
def test_no_such_port(url):
    with pytest.raises(DeviceNotFoundError, match=url) as caught:
        Device.open(url)
    assert caught.value.exit_code is ExitCode.DEVICE


@pytest.mark.skipif(sys.platform == "win32", reason="pseudo-terminals are POSIX")
def test_port_is_taken_for_one_process_alone():
    leader, follower = os.openpty()
    try:
        name = os.ttyname(follower)
        port = ports.open_port(name)
        with pytest.raises(LockedError) as caught:
            ports.open_port(name)
        assert caught.value.exit_code is ExitCode.LOCKED
        port.close()
        ports.open_port(name).close()
    finally:
        os.close(leader)
        os.close(follower)


def test_missing_permission_names_the_udev_rule(monkeypatch):
    def refuse(*_args, **_options):
        raise serial.SerialException(
            13, "could not open port /dev/ttyACM0: [Errno 13] Permission denied"
        )

    monkeypatch.setattr(serial, "serial_for_url", refuse)
    with pytest.raises(DeviceNotFoundError, match="may not be opened") as caught:
        ports.open_port("/dev/ttyACM0")
    assert "udevadm" in caught.value.hint


def test_schemes_of_installed_packages_are_found(monkeypatch):
    """A package in the entry-point group offers its scheme without being imported by name."""
    fake = FakeDevice()
    package = types.ModuleType("fake_handlers")
    package.__path__ = []
    module = types.ModuleType("fake_handlers.protocol_fake")

    class Serial(FakePort):
        def __init__(self, *_args, **_options):
            super().__init__(fake)

        def open(self):
            pass

    module.Serial = Serial
    monkeypatch.setitem(sys.modules, "fake_handlers", package)
    monkeypatch.setitem(sys.modules, "fake_handlers.protocol_fake", module)
    entry = types.SimpleNamespace(name="fake", value="fake_handlers")
    monkeypatch.setattr(
        ports, "entry_points", lambda group: [entry] if group == ports.HANDLER_GROUP else []
    )
    monkeypatch.setattr(serial, "protocol_handler_packages", list(serial.protocol_handler_packages))
    with Device.open("fake://anything") as device:
        assert device.select_light(1).slot == 1
    ports.register_handlers()
    assert serial.protocol_handler_packages.count("fake_handlers") == 1


def test_teensies_are_listed_first(monkeypatch):
    def port(device, vid, pid):
        return types.SimpleNamespace(
            device=device,
            description="d",
            serial_number="7",
            vid=vid,
            pid=pid,
            location="1-2.4:1.0",
        )

    found = [
        port("/dev/ttyACM0", 0x2341, 0x0043),
        port("/dev/ttyACM1", 0x16C0, 0x0483),
        port("/dev/ttyS0", None, None),
    ]
    monkeypatch.setattr(ports.serial_ports, "comports", lambda: found)
    listed = ports.list_ports()
    assert [p.port for p in listed] == ["/dev/ttyACM1", "/dev/ttyACM0", "/dev/ttyS0"]
    assert [p.is_teensy for p in listed] == [True, False, False]
