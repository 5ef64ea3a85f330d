"""The core as a library: virtual time, trace, memory, resets, as reliefscope_host.h promises them."""

import pytest
from cobs import cobs
from tests.firmware.compiled import NONCE, Device, frame, light, load_sequence

from reliefscope.protocol.messages import (
    BOOTLOADER_MAGIC,
    BootedEvent,
    CountersRequest,
    EnterBootloaderRequest,
    ExposureEvent,
    ExposureFlag,
    GetSettingsRequest,
    GlassVariant,
    HelloReply,
    HelloRequest,
    Mounting,
    ResetCause,
    SelectApertureRequest,
    SelectLightRequest,
    SetSettingsRequest,
    StatusRequest,
    Step,
)

SPI, PIN, LED, NONVOLATILE, BOOTLOADER, OVERFLOW = range(1, 7)
LCD_RESET, TRIGGER = 0, 2
NEVER = 2**64 - 1
HELLO_ID = 0xFFFF_FFFF
SETTINGS = SetSettingsRequest(
    serial_number="RS-0042",
    glass_variant=GlassVariant.E_STN_POSITIVE,
    mounting=Mounting.TOP_VIEW,
    contrast=30,
    resistor_ratio=5,
)


def test_the_same_calls_give_the_same_trace(library):
    steps = [
        Step(aperture=i % 2, light=i % 2, repeat=2, settle_us=999, exposure_us=777)
        for i in range(9)
    ]
    runs = []
    for _ in range(2):
        with Device(library) as device:
            load_sequence(device, steps, 1, 60_000)
            device.run_for(1_000_000)
            runs.append((device.trace(), device.output()))
    assert runs[0] == runs[1]


def test_wakeups_lead_through_a_sequence_without_polling(library):
    """A caller that jumps from one announced time to the next sees what one sees that asks every microsecond."""
    steps = [Step(aperture=0, light=0, repeat=3, settle_us=500, exposure_us=300)]
    traces = []
    for jump in (True, False):
        with Device(library) as device:
            load_sequence(device, steps, 1, 60_000)
            end = device.now_us + 30_000
            while device.now_us < end:
                wakeup = device.library.rs_next_wakeup_us(device.handle)
                device.run_for(max(1, min(wakeup, end) - device.now_us) if jump else 1)
            traces.append(device.trace())
    assert traces[0] == traces[1]


def test_settings_carry_over_to_the_next_device(library):
    with Device(library) as device:
        device.ask(SETTINGS, 1)
        written = [r for r in device.trace() if r.kind == NONVOLATILE]
        count = device.library.rs_nonvolatile_read(device.handle, device.buffer, len(device.buffer))
        memory = device.buffer.raw[:count]
        assert count == 2048
        for record in written:
            assert memory[int.from_bytes(record.payload[:2], "little")] == record.payload[2]
        assert sum(byte != 0xFF for byte in memory) == len(written)
    with Device(library, memory) as device:
        assert device.ask(GetSettingsRequest(), 1).serial_number == "RS-0042"
        assert device.ask(HelloRequest(), HELLO_ID).serial_number == "RS-0042"
        device.run_for(10_000)
        spi = [r for r in device.trace() if r.kind == SPI]
        assert spi[0].payload == b"\xa5"
        assert spi[1].payload[:4] == bytes([0x40, 0xA0, 0xC8, 0xA7])


def test_a_reset_keeps_time_and_settings_and_loses_the_rest(library):
    with Device(library) as device:
        device.ask(SETTINGS, 1)
        device.ask(light(100), 2)
        device.run_for(1_000_000)
        library.rs_reset(device.handle, ResetCause.BROWN_OUT, 77)
        device.run_for(0)
        frames = device.frames()
        assert [f.request_id for f in frames] == [0]
        assert BootedEvent.unpack(frames[0].payload).reset_cause == ResetCause.BROWN_OUT
        hello = device.ask(HelloRequest(), HELLO_ID)
        assert (hello.boot_nonce, hello.last_request_id) == (77, 0)
        assert hello.serial_number == "RS-0042"
        failed = device.ask(SelectLightRequest(slot=0), 1, nonce=77)
        assert failed.code.name == "SLOT_EMPTY"
        assert device.ask(StatusRequest(), 2, nonce=77).uptime_us == 0
        device.trace()
        device.run_for(100)
        assert all(r.time_us >= 1_000_000 for r in device.trace())


def test_a_strange_reset_cause_and_nonce_are_made_valid(library):
    with Device(library) as device:
        library.rs_reset(device.handle, 999, 0)
        hello = device.ask(HelloRequest(), HELLO_ID)
        assert hello.reset_cause == ResetCause.UNKNOWN
        assert hello.boot_nonce == 1


def test_the_bootloader_ends_everything_until_a_reset(library):
    with Device(library) as device:
        device.ask(light(100), 1)
        device.ask(SelectLightRequest(slot=0), 2)
        device.ask(EnterBootloaderRequest(magic=BOOTLOADER_MAGIC), 3)
        device.run_for(100_000)
        trace = device.trace()
        assert [r.kind for r in trace].count(BOOTLOADER) == 1
        assert [r.payload for r in trace if r.kind == LED][-1] == b"\0\0"
        assert library.rs_next_wakeup_us(device.handle) == NEVER
        device.feed(frame(HelloRequest(), 4))
        assert device.frames() == []
        library.rs_reset(device.handle, ResetCause.BOOTLOADER, NONCE + 1)
        assert isinstance(device.ask(HelloRequest(), HELLO_ID), HelloReply)


def test_the_strobe_line_reaches_the_sequencer(library):
    with Device(library) as device:
        load_sequence(
            device, [Step(aperture=0, light=0, repeat=1, settle_us=0, exposure_us=5000)], 1, 1000
        )
        device.trace()
        while not any(r.kind == PIN and r.argument == TRIGGER for r in device.trace()):
            device.run_for(10)
        library.rs_set_input(device.handle, 0, 1)
        device.run_for(6000)
        library.rs_set_input(device.handle, 0, 0)
        library.rs_set_input(device.handle, 99, 1)  # no such line
        device.run_for(1000)
        events = [f for f in device.frames() if f.message == ExposureEvent.ID]
        assert ExposureEvent.unpack(events[0].payload).flags == ExposureFlag.STROBE_SEEN


def test_a_host_that_does_not_read_loses_nothing(library):
    """The device stops reading requests while its answers have no room; all are answered in the end."""
    with Device(library) as device:
        data = b"".join(frame(CountersRequest(), i) for i in range(1, 301))
        taken = 0
        while count := library.rs_serial_in(device.handle, data[taken:], len(data) - taken):
            taken += count
            device.run_for(0)
        assert taken < len(data)
        ids = []
        while len(ids) < 300:
            taken += library.rs_serial_in(device.handle, data[taken:], len(data) - taken)
            device.run_for(1)
            ids += [f.request_id for f in device.frames() if f.message == CountersRequest.REPLY.ID]
        assert ids == list(range(1, 301))


def test_a_trace_that_nobody_reads_says_where_it_has_a_hole(library):
    with Device(library) as device:
        device.ask(light(1), 1)
        for request_id in range(2, 3200):
            device.feed(frame(SelectApertureRequest(slot=255), request_id))
            device.run_for(3000)
            device.output()
        kinds = [r.kind for r in device.trace()]
        assert kinds.count(OVERFLOW) == 1
        assert kinds[-1] == OVERFLOW
        device.ask(SelectLightRequest(slot=0), 4000)
        assert [r.kind for r in device.trace()] == [LED]


def test_earlier_times_are_ignored(library):
    with Device(library) as device:
        device.run_for(5000)
        library.rs_run_until(device.handle, 10)
        assert device.ask(StatusRequest(), 1).uptime_us == 5000


@pytest.mark.parametrize("capacity", [0, 5, 12])
def test_trace_records_come_whole_or_not_at_all(library, capacity):
    with Device(library) as device:
        device.run_for(10_000)
        assert library.rs_trace_read(device.handle, device.buffer, capacity) == 0
        first = device.trace()[0]
        assert (first.kind, first.argument, first.payload) == (PIN, LCD_RESET, b"\1")


def test_stuffing_of_the_core_is_the_package_cobs(library):
    with Device(library) as device:
        device.feed(frame(HelloRequest(), 3))
        parts = [part for part in device.output().split(b"\0") if part]
        assert all(cobs.encode(cobs.decode(part)) == part for part in parts)
