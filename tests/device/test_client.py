"""The client against a device that follows the protocol reference."""

import json
import threading

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.device.fake import FakeDevice, FakePort, Faults

from reliefscope.device import (
    Device,
    DeviceNotFoundError,
    DeviceRebootedError,
    DeviceTimeout,
    FailedError,
    Link,
    OutcomeUnknownError,
    RejectedError,
    SchemaMismatchError,
)
from reliefscope.device.wirelog import WireLog
from reliefscope.errors import ExitCode, ReliefscopeError
from reliefscope.protocol import messages as m
from reliefscope.protocol.codec import FieldRangeError


def connect(device, faults=None, **options):
    port = FakePort(device, faults)
    return Device(Link(port, "fake"), "fake://", **options), port


def exposure(index):
    return m.ExposureEvent(
        table_hash=7,
        run_id=1,
        index=index,
        step=0,
        repeat=index,
        aperture=0,
        light=0,
        start_us=1000 * index,
        settle_waited_us=5,
        exposure_us=100,
        flags=m.ExposureFlag(0),
    )


class Scripted(FakePort):
    """Drops the frames whose number (from 0, in its direction) is named."""

    def __init__(self, device, lose_out=(), lose_in=()):
        super().__init__(device)
        self.lose = {True: set(lose_out), False: set(lose_in)}
        self.seen = {True: 0, False: 0}
        self.armed = False

    def _fate(self, data, *, to_device):
        if not self.armed:
            yield data
            return
        number = self.seen[to_device]
        self.seen[to_device] += 1
        if number not in self.lose[to_device]:
            yield data


def test_identity_and_first_id():
    fake = FakeDevice(highest=1000)
    device, _ = connect(fake)
    assert device.identity.board == "fake"
    device.select_light(3)
    assert min(fake.executed) == 1024  # the next multiple of 256 above what an earlier host used
    assert fake.light == 3


def test_lost_reply_is_answered_from_the_ring_and_run_once():
    fake = FakeDevice()
    port = Scripted(fake, lose_in={0, 1})
    device = Device(Link(port, "fake"))
    port.armed = True
    assert device.select_light(4).slot == 4
    assert [r for r in fake.requests if isinstance(r, m.SelectLightRequest)] == [
        m.SelectLightRequest(4)
    ]
    assert set(fake.executed.values()) == {1}
    assert device.link_counters["retries"] == 2


def test_lost_request_is_repeated():
    fake = FakeDevice()
    port = Scripted(fake, lose_out={0, 1, 2})
    device = Device(Link(port, "fake"))
    port.armed = True
    assert device.select_light(4).slot == 4
    assert set(fake.executed.values()) == {1}


def test_rejected_names_the_field():
    fake = FakeDevice()
    device, _ = connect(fake)
    fake.run = lambda frame, request: fake.answer(
        frame, m.Rejected(m.ErrorCode.OUT_OF_RANGE, frame.message, 0)
    )
    with pytest.raises(RejectedError, match="Field slot is outside its range") as caught:
        device.select_light(4)
    assert caught.value.code is m.ErrorCode.OUT_OF_RANGE


def test_failed_says_cause_and_next_step():
    fake = FakeDevice()
    device, _ = connect(fake)
    fake.fail_with = m.ErrorCode.SLOT_EMPTY
    with pytest.raises(FailedError, match=r"select_light.*SLOT_EMPTY") as caught:
        device.select_light(4)
    assert m.ErrorCode.SLOT_EMPTY.next_step in caught.value.hint
    assert caught.value.exit_code is ExitCode.DEVICE


def test_failed_for_a_fault_names_the_fault():
    fake = FakeDevice()
    device, _ = connect(fake)
    fake.fail_with = m.ErrorCode.FAULT_LATCHED
    with pytest.raises(FailedError, match="LED was on for longer"):
        device.select_light(4)


def test_silence_is_an_unknown_outcome():
    fake = FakeDevice()
    device, port = connect(fake)
    fake.silent = True
    before = port.now_s
    with pytest.raises(OutcomeUnknownError) as caught:
        device.select_light(4)
    assert caught.value.exit_code is ExitCode.OUTCOME_UNKNOWN
    assert 2.9 < port.now_s - before < 3.3  # the deadline ended in virtual time, at once in ours


def test_unplugged_is_an_unknown_outcome():
    device, port = connect(FakeDevice())
    port.unplugged = True
    with pytest.raises(OutcomeUnknownError, match="lost"):
        device.select_light(4)


def test_nobody_there():
    with pytest.raises(DeviceNotFoundError, match=r"within 0\.2 s") as caught:
        connect(FakeDevice(silent=True), hello_timeout_s=0.2)
    assert "reliefscope doctor" in caught.value.hint


def test_reboot_is_found_by_the_next_request():
    fake = FakeDevice()
    device, _ = connect(fake)
    fake.reboot(m.ResetCause.BROWN_OUT)
    fake.outbox.clear()
    with pytest.raises(DeviceRebootedError) as caught:
        device.select_light(4)
    assert caught.value.cause is m.ResetCause.BROWN_OUT
    assert m.SelectLightRequest(4) not in fake.requests
    with pytest.raises(DeviceRebootedError):  # and stays so until somebody connects again
        device.status()
    device.reconnect()
    assert device.select_light(4).slot == 4


def test_reboot_is_found_by_its_event():
    fake = FakeDevice()
    device, _ = connect(fake)
    fake.reboot(m.ResetCause.WATCHDOG)
    with pytest.raises(DeviceRebootedError) as caught:
        device.events(1.0)
    assert caught.value.cause is m.ResetCause.WATCHDOG


def test_reboot_is_found_although_its_event_was_lost():
    fake = FakeDevice()
    device, _ = connect(fake)
    fake.reboot(m.ResetCause.WATCHDOG)
    fake.outbox.clear()
    with pytest.raises(DeviceRebootedError):
        device.events(2.0)


def test_mismatch_refuses_everything_but_the_bootloader():
    fake = FakeDevice(schema_hash=bytes(16))
    with pytest.raises(SchemaMismatchError, match="does not fit") as caught:
        connect(fake)
    assert "reliefscope flash --port fake://" in caught.value.hint
    device, _ = connect(fake, allow_mismatch=True)
    with pytest.raises(SchemaMismatchError):
        device.select_light(1)
    with pytest.raises(SchemaMismatchError):
        device.events(0.1)
    assert device.enter_bootloader().delay_ms == 100
    assert fake.requests == [m.EnterBootloaderRequest(m.BOOTLOADER_MAGIC)]


def test_bad_values_are_refused_before_anything_is_sent():
    fake = FakeDevice()
    device, _ = connect(fake)
    before = len(fake.requests)
    with pytest.raises(FieldRangeError, match="slot is 32; allowed are 0 to 31"):
        device.load_light(32, [1])
    with pytest.raises(FieldRangeError, match="4096"):
        device.load_light(0, [4096])
    with pytest.raises(FieldRangeError, match="49 elements"):
        device.load_light(0, [1] * 49)
    assert len(fake.requests) == before


def test_light_levels_are_confirmed():
    fake = FakeDevice()
    device, _ = connect(fake)
    levels = np.array([0, 4095, 12], np.uint16)
    assert device.load_light(3, levels).level_sum == 4107
    assert m.LoadLightRequest(3, (0, 4095, 12)) in fake.requests


def test_events_come_in_order_once_and_are_acknowledged():
    fake = FakeDevice()
    device, _ = connect(fake)
    for index in range(50):
        fake.emit(exposure(index))
    assert [device.events(0.1).index for _ in range(50)] == list(range(50))
    assert len(fake.events) < 16 + 50 - 48
    with pytest.raises(DeviceTimeout):
        device.events(0.2)


@pytest.mark.parametrize("lost", [{0}, {3, 4}, {9}, set(range(10))])
def test_lost_events_are_fetched_again(lost):
    fake = FakeDevice()
    port = Scripted(fake, lose_in=lost)
    device = Device(Link(port, "fake"))
    port.armed = True
    for index in range(10):
        fake.emit(exposure(index))
    assert [device.events(2.0).index for _ in range(10)] == list(range(10))


def test_events_of_an_earlier_host_are_skipped():
    fake = FakeDevice()
    fake.emit(exposure(0))
    device, _ = connect(fake)
    fake.emit(exposure(1))
    assert device.events(0.1).index == 1


def test_request_of_another_thread_passes_a_wait_for_events():
    fake = FakeDevice()
    device, _ = connect(fake)
    stop = threading.Event()
    failures = []

    def wait():
        while not stop.is_set():
            try:
                device.events(0.3)
            except DeviceTimeout:
                pass
            except ReliefscopeError as error:
                failures.append(error)
                return

    thread = threading.Thread(target=wait)
    thread.start()
    try:
        for n in range(200):
            assert device.select_light(n % 32).slot == n % 32
    finally:
        stop.set()
        thread.join(10)
    assert not thread.is_alive()
    assert failures == []


def test_an_error_in_the_block_turns_the_light_off():
    fake = FakeDevice()
    device, port = connect(fake)
    device.select_light(2)
    with pytest.raises(FieldRangeError), device:
        device.select_light(99)
    assert fake.light == m.SLOT_NONE
    assert port.closed


def test_wire_log_says_what_passed(tmp_path):
    log = WireLog(tmp_path / "wire.jsonl")
    device = Device(Link(FakePort(FakeDevice()), "fake", log))
    device.select_light(2)
    device.close()
    lines = [json.loads(line) for line in (tmp_path / "wire.jsonl").read_text().splitlines()]
    assert [line["dir"] for line in lines if "SelectLight" in line["says"]] == ["out", "in"]
    assert any("HelloReply(protocol_version=1" in line["says"] for line in lines)


RATES = [0.001, 0.01, 0.05, 0.2]


def run_commands(faults, count):
    """Send numbered commands over a bad link; returns how many finished, and checks that none went wrong."""
    fake = FakeDevice()
    device, port = connect(fake, Faults(seed=faults.seed))
    port.faults = faults
    finished = 0
    for n in range(count):
        try:
            assert device.select_light(n % 32).slot == n % 32
        except OutcomeUnknownError:
            continue
        finished += 1
        assert fake.light == n % 32
    assert set(fake.executed.values()) <= {1}
    return finished


rates = st.floats(0, 0.3)


@settings(max_examples=60, deadline=None)
@given(rates, rates, rates, rates, st.floats(0, 0.01), st.integers(0, 2**32))
def test_whatever_the_link_does_nothing_is_run_twice_or_silently_wrong(
    lose, corrupt, duplicate, delay, byte_loss, seed
):
    run_commands(Faults(lose, corrupt, duplicate, delay, byte_loss, seed), 20)


@pytest.mark.parametrize("rate", RATES)
def test_bad_link(rate):
    faults = Faults(lose=rate, corrupt=rate, duplicate=rate, delay=rate, seed=5)
    assert run_commands(faults, 300) >= (285 if rate == 0.2 else 300)


@pytest.mark.parametrize("rate", [0.001, 0.01])
def test_bad_bytes(rate):
    assert run_commands(Faults(byte_loss=rate, seed=6), 300) >= 299


@pytest.mark.soak
@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("rate", RATES)
def test_bad_link_for_long(rate, seed):
    faults = Faults(lose=rate, corrupt=rate, duplicate=rate, delay=rate, seed=seed)
    assert run_commands(faults, 2000) >= 2000 * (0.95 if rate == 0.2 else 0.999)
