"""The simulated serial port: what pyserial promises, and who may hold it."""

import threading
import time

import pytest
import serial

from reliefscope.errors import InvalidInputError, LockedError
from reliefscope.protocol import messages
from reliefscope.protocol.framing import Frame, FrameReader
from reliefscope_sim.bench import Bench
from reliefscope_sim.camera import SimCamera

PACKAGE = "reliefscope_sim.serial_handlers"
URL = "sim://benchtop?size=96x72&scene=flat"
HELLO = Frame(messages.HelloRequest.ID, 1, 0, b"").encode()


@pytest.fixture(autouse=True)
def _handler():
    if PACKAGE not in serial.protocol_handler_packages:
        serial.protocol_handler_packages.append(PACKAGE)


@pytest.fixture
def port():
    with serial.serial_for_url(URL, timeout=0.1) as opened:
        yield opened


def read_until_it_fails(port):
    for _ in range(20):
        port.read(100)


def answers(data):
    return list(FrameReader().feed(data))


def test_hello_through_plain_pyserial(port):
    assert port.write(HELLO) == len(HELLO)
    frames = answers(port.read(500))
    reply = next(frame for frame in frames if frame.message == messages.HelloReply.ID)
    hello = messages.HelloReply.unpack(reply.payload)
    assert hello.schema_hash == messages.SCHEMA_HASH
    assert hello.serial_number == "SIM-benchtop"
    assert hello.board == "host"


def test_read_returns_as_soon_as_it_has_what_it_asked_for(port):
    port.timeout = 60
    port.write(HELLO)
    bench = Bench.attach(URL)
    before_us = bench.time_us
    assert len(port.read(4)) == 4
    assert bench.time_us - before_us < 100_000
    bench.release()


def test_timeouts_let_the_clock_run_and_never_further(port):
    bench = Bench.attach(URL)
    port.read(10_000)
    before_us, started = bench.time_us, time.perf_counter()
    port.timeout = 30
    assert port.read(1) == b""
    assert bench.time_us - before_us == 30_000_000
    assert time.perf_counter() - started < 2
    port.timeout = 0
    assert port.read(5) == b""
    assert bench.time_us - before_us < 30_001_000
    bench.release()


def test_polling_without_waiting_gets_the_answer_too(port):
    port.timeout = 0
    port.write(HELLO)
    received = b""
    for _ in range(100):
        received += port.read(port.in_waiting)
    assert any(frame.message == messages.HelloReply.ID for frame in answers(received))


def test_input_can_be_thrown_away(port):
    port.write(HELLO)
    while not port.in_waiting:
        pass
    port.reset_input_buffer()
    assert port.in_waiting == 0
    port.reset_output_buffer()
    assert port.out_waiting == 0


def test_endless_read_can_be_cancelled(port):
    port.read(10_000)
    port.timeout = None
    result = []
    reader = threading.Thread(target=lambda: result.append(port.read(100_000)))
    reader.start()
    time.sleep(0.05)
    assert reader.is_alive()
    port.cancel_read()
    reader.join(timeout=5)
    assert not reader.is_alive()
    assert len(result) == 1


def test_endless_read_is_fed_by_another_thread(port):
    port.read(10_000)
    port.timeout = None
    result = []
    reader = threading.Thread(target=lambda: result.append(port.read(10)))
    reader.start()
    time.sleep(0.05)
    port.write(HELLO)
    reader.join(timeout=5)
    assert len(result[0]) == 10


@pytest.mark.parametrize("shared", [False, True])
def test_closing_ends_a_read_of_another_thread(port, shared):
    camera = SimCamera(URL) if shared else None
    port.read(10_000)
    port.timeout = None
    outcome = []

    def read():
        try:
            port.read(10)
        except serial.PortNotOpenError as error:
            outcome.append(error)

    reader = threading.Thread(target=read)
    reader.start()
    time.sleep(0.05)
    port.close()
    reader.join(timeout=5)
    assert len(outcome) == 1
    if camera:
        camera.close()


def test_only_bytes_are_sent(port):
    with pytest.raises(TypeError):
        port.write("hello")
    assert port.write(bytearray(b"\0")) == 1
    port.flush()


def test_line_settings_mean_nothing(port):
    port.baudrate = 9600
    port.dtr = port.rts = False
    assert (port.cts, port.dsr, port.ri, port.cd) == (True, True, False, True)


def test_closed_port_refuses_everything(port):
    port.close()
    port.close()
    for use in (lambda: port.read(1), lambda: port.write(b"x"), lambda: port.in_waiting):
        with pytest.raises(serial.PortNotOpenError):
            use()
    port.open()
    assert port.is_open
    with pytest.raises(serial.SerialException, match="already open"):
        port.open()


def test_port_is_exclusive(port):
    with pytest.raises((serial.SerialException, LockedError), match="already open"):
        serial.serial_for_url(URL)
    other = serial.serial_for_url("sim://other?size=96x72")
    other.close()


def test_unopened_port_can_be_configured_first():
    port = serial.serial_for_url(URL, do_not_open=True, timeout=1)
    assert not port.is_open
    with port:
        assert port.is_open
    with pytest.raises(serial.SerialException, match="configured"):
        type(port)().open()


def test_device_and_camera_share_the_bench_until_both_are_closed(port):
    camera = SimCamera("sim://benchtop")
    assert Bench.in_use() == ["benchtop"]
    with pytest.raises(InvalidInputError, match="already in use"):
        SimCamera("sim://benchtop?scene=plane")
    port.close()
    assert Bench.in_use() == ["benchtop"]
    camera.close()
    assert Bench.in_use() == []


def test_wrong_address_switches_nothing_on():
    for url in ("sim://benchtop?sead=1", "sim://benchtop?profile=nowhere", "sim://b?size=1x1"):
        with pytest.raises(InvalidInputError):
            serial.serial_for_url(url)
    with pytest.raises(InvalidInputError, match="scene"):
        SimCamera("sim://benchtop?scene=atlantis")
    assert Bench.in_use() == []


def test_bootloader_takes_the_port_away_until_it_is_opened_again(port):
    request = messages.EnterBootloaderRequest(messages.BOOTLOADER_MAGIC)
    port.write(Frame(request.ID, 2, 0, request.pack()).encode())
    with pytest.raises(serial.SerialException, match="bootloader"):
        read_until_it_fails(port)
    bench = Bench.attach(URL)
    port.close()
    port.open()
    bench.release()
    port.write(HELLO)
    frames = answers(port.read(500))
    reply = next(frame for frame in frames if frame.message == messages.HelloReply.ID)
    hello = messages.HelloReply.unpack(reply.payload)
    assert hello.reset_cause is messages.ResetCause.BOOTLOADER
