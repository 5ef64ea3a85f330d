"""The client against the compiled firmware, through the simulated instrument's port."""

import itertools
import zlib

import numpy as np
import pytest

from reliefscope.device import (
    Device,
    DeviceRebootedError,
    DeviceTimeout,
    ExposureEvent,
    FailedError,
    FaultEvent,
    LinkLostError,
    OutcomeUnknownError,
    SequenceEvent,
    SequenceNews,
    SequenceState,
    SequenceTiming,
    Step,
    sequence_duration_s,
)
from reliefscope.errors import LockedError
from reliefscope.protocol import messages as m

NO_CAMERA = SequenceTiming(ready_timeout_ms=0)
_names = itertools.count()


@pytest.fixture
def twin():
    """Open a bench of its own, with faults if need be."""
    opened = []

    def open_twin(fault="", **options):
        device = Device.open(
            f"sim://link-{next(_names)}?size=64x48&seed=3&fault={fault}", 10.0, **options
        )
        opened.append(device)
        return device

    yield open_twin
    for device in opened:
        device.close()


def bitmap(columns=10):
    """A wedge: every row another number of open pixels, so that a swapped order of bytes shows in the CRC."""
    rows, cols = np.indices((64, 128))
    return cols < rows // 8 + columns


def prepare(device, steps):
    device.load_aperture(0, bitmap())
    device.load_light(0, [2000])
    device.load_light(1, [0, 1500])
    return device.load_steps(steps)


def until_end(device, timeout_s=5.0):
    events = []
    while True:
        events.append(device.events(timeout_s))
        last = events[-1]
        if isinstance(last, SequenceEvent) and last.news in {
            SequenceNews.FINISHED,
            SequenceNews.ABORTED,
        }:
            return events


def test_hello(twin):
    identity = twin().identity
    assert (identity.board, identity.reset_cause) == ("host", m.ResetCause.POWER_ON)
    assert identity.schema_hash == m.SCHEMA_HASH
    assert (identity.aperture_slots, identity.light_slots, identity.steps) == (16, 32, 1024)


def test_port_is_taken_once():
    url = f"sim://link-{next(_names)}?size=64x48"
    with Device.open(url), pytest.raises(LockedError):
        Device.open(url)


def test_slots_and_selection(twin):
    device = twin()
    assert device.load_aperture(5, bitmap()) == bitmap().sum()
    assert device.load_light(7, np.array([0, 4095, 1])).level_sum == 4096
    shown = device.select_aperture(5)
    assert shown.crc32 == zlib.crc32(
        np.packbits(bitmap().reshape(8, 8, 128), axis=1, bitorder="little").tobytes()
    )
    assert device.select_light(7).level_sum == 4096
    status = device.status()
    assert (status.aperture, status.light) == (5, 7)
    assert device.select_aperture(None).crc32 == zlib.crc32(bytes(1024))
    device.all_off()
    assert device.status().light == m.SLOT_NONE


def test_what_is_not_there_fails(twin):
    device = twin()
    with pytest.raises(FailedError) as caught:
        device.select_light(3)
    assert caught.value.code is m.ErrorCode.SLOT_EMPTY
    with pytest.raises(FailedError) as caught:
        device.start(1)
    assert caught.value.code is m.ErrorCode.NO_TABLE
    with pytest.raises(FailedError) as caught:
        device.load_steps([Step(0, 0, 1, 0, 1000)])
    assert caught.value.code is m.ErrorCode.SLOT_EMPTY
    with pytest.raises(FailedError) as caught:
        device.load_light(0, [4095] * 48)
    assert caught.value.code is m.ErrorCode.CURRENT_BUDGET


def test_a_sequence(twin):
    device = twin()
    steps = [
        Step(0, 0, 2, 300_000, 10_000),
        Step(m.SLOT_NONE, 1, 3, 200_000, 5_000),
        Step(0, m.SLOT_NONE, 1, 0, 700),
    ]
    table = prepare(device, steps)
    assert device.start(11, timing=NO_CAMERA).exposures == 6
    started, *exposures, finished = until_end(device)
    assert (started.news, finished.news, finished.exposures) == (
        SequenceNews.STARTED,
        SequenceNews.FINISHED,
        6,
    )
    assert all(
        isinstance(e, ExposureEvent) and (e.table_hash, e.run_id) == (table, 11) for e in exposures
    )
    confirmed = [(e.index, e.step, e.repeat, e.aperture, e.light, e.exposure_us) for e in exposures]
    assert confirmed == [
        (0, 0, 0, 0, 0, 10_000),
        (1, 0, 1, 0, 0, 10_000),
        (2, 1, 0, 255, 1, 5_000),
        (3, 1, 1, 255, 1, 5_000),
        (4, 1, 2, 255, 1, 5_000),
        (5, 2, 0, 0, 255, 700),
    ]
    assert exposures[0].settle_waited_us >= 300_000
    assert exposures[2].settle_waited_us >= 200_000
    planned = sequence_duration_s(steps, NO_CAMERA)
    assert planned <= (finished.at_us - started.at_us) / 1e6 < planned + 0.1
    assert device.status().sequence is SequenceState.IDLE


def test_pause_resume_abort(twin):
    device = twin()
    prepare(device, [Step(0, 0, 50, 100_000, 10_000)])
    device.start(2, timing=NO_CAMERA)
    while not isinstance(device.events(5.0), ExposureEvent):
        pass
    device.pause()
    seen = device.events(5.0)
    while isinstance(seen, ExposureEvent):
        seen = device.events(5.0)
    assert seen.news is SequenceNews.PAUSED
    assert device.status().sequence is SequenceState.PAUSED
    with pytest.raises(FailedError) as caught:
        device.select_light(0)
    assert caught.value.code is m.ErrorCode.BUSY
    with pytest.raises(DeviceTimeout, match=f"PAUSED at step 0 after {seen.exposures} exposures"):
        device.events(1.0)
    device.resume()
    assert device.events(5.0).news is SequenceNews.RESUMED
    assert device.events(5.0).index == seen.exposures
    assert device.abort() is SequenceState.IDLE
    assert until_end(device)[-1].news is SequenceNews.ABORTED
    assert device.abort() is SequenceState.IDLE


def test_nothing_is_lost_when_the_host_reads_late(twin):
    device = twin()
    prepare(device, [Step(0, 0, 200, 0, 1_000)])
    device.start(3, timing=NO_CAMERA)
    for _ in range(5000):
        if device.status().sequence is SequenceState.HELD:
            break
    held = device.status()
    assert held.sequence is SequenceState.HELD
    assert held.light == m.SLOT_NONE
    assert held.next_event - held.oldest_event == m.EVENT_QUEUE - m.EVENT_RESERVE
    events = until_end(device)
    assert [e.index for e in events if isinstance(e, ExposureEvent)] == list(range(200))


def test_camera_that_is_not_ready_latches_a_fault(twin):
    device = twin()
    prepare(device, [Step(0, 0, 2, 0, 1_000)])
    device.start(4, timing=SequenceTiming(ready_timeout_ms=200))
    _, fault, end = until_end(device)
    assert isinstance(fault, FaultEvent)
    assert fault.reason is m.FaultReason.CAMERA_NOT_READY
    assert end.news is SequenceNews.ABORTED
    with pytest.raises(FailedError, match="Arm the camera"):
        device.start(5)
    assert device.clear_fault(fault.reason) is m.FaultReason.NONE
    device.start(6, timing=NO_CAMERA)
    assert until_end(device)[-1].news is SequenceNews.FINISHED


def test_settings_survive(twin):
    device = twin()
    old = device.settings()
    stored = device.store_settings(
        m.SetSettingsRequest("RS-0042", old.glass_variant, old.mounting, 30, old.resistor_ratio)
    )
    assert (stored.serial_number, stored.contrast) == ("RS-0042", 30)
    assert device.settings() == m.GetSettingsReply(
        "RS-0042", old.glass_variant, old.mounting, 30, old.resistor_ratio
    )
    assert device.reconnect().serial_number == "RS-0042"


@pytest.mark.parametrize(
    "fault", ["link_loss:0.2", "link_loss:0.05,link_duplicate:0.2,link_delay:40", "link_flip:0.003"]
)
def test_bad_link(twin, fault):
    device = twin(fault)
    device.load_aperture(0, bitmap())
    for slot in range(4):
        device.load_light(slot, [slot * 100 + 1])
    unknown = 0
    for n in range(150):
        try:
            assert device.select_light(n % 4).level_sum == n % 4 * 100 + 1
        except OutcomeUnknownError:
            unknown += 1
    assert unknown <= 7
    assert device.link_counters["retries"] > 0
    assert device.counters().retries_answered > 0


def test_events_over_a_bad_link(twin):
    device = twin("link_loss:0.1,link_duplicate:0.1")
    prepare(device, [Step(0, 0, 150, 0, 2_000)])
    device.start(9, timing=NO_CAMERA)
    events = until_end(device)
    assert [e.index for e in events if isinstance(e, ExposureEvent)] == list(range(150))
    assert device.counters().events_resent > 0


def test_led_correction_survives(twin):
    device = twin()
    assert device.led_correction().factors == b"\xff" * 48
    factors = bytes(range(200, 248))
    assert device.store_led_correction(factors).factors == factors
    assert device.led_correction().factors == factors


def test_reset_in_a_sequence_is_reported_with_its_cause(twin):
    device = twin("brown_out_at:3")
    prepare(device, [Step(0, 0, 10, 0, 10_000)])
    device.start(1, timing=NO_CAMERA)
    with pytest.raises(DeviceRebootedError) as caught:
        until_end(device)
    assert caught.value.cause is m.ResetCause.BROWN_OUT
    device.reconnect()
    assert device.status().light == m.SLOT_NONE
    with pytest.raises(FailedError, match="SLOT_EMPTY"):
        device.select_light(0)


@pytest.mark.parametrize("fault", ["stall_at:2", "link_cut:2"])
def test_silence_in_a_sequence_is_an_unknown_outcome(twin, fault):
    device = twin(fault)
    prepare(device, [Step(0, 0, 10, 0, 10_000)])
    device.start(1, timing=NO_CAMERA)
    with pytest.raises(OutcomeUnknownError):
        until_end(device)


def test_enter_bootloader(twin):
    device = twin()
    assert device.enter_bootloader().delay_ms > 0
    with pytest.raises(LinkLostError):  # it leaves, and its port goes away
        device.events(0.4)


@pytest.mark.soak
@pytest.mark.parametrize(
    "fault", ["link_loss:0.2,link_duplicate:0.2", "link_drop:0.01", "link_flip:0.01"]
)
def test_bad_link_for_long(twin, fault):
    device = twin(fault)
    device.load_light(0, [1])
    device.load_light(1, [2])
    unknown = 0
    for n in range(2000):
        try:
            assert device.select_light(n % 2).level_sum == n % 2 + 1
        except OutcomeUnknownError:
            unknown += 1
    assert unknown <= 100
