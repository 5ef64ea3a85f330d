"""A reset at any moment of a sequence: dark at once, shut before anything else on the bus, told to the host."""

import numpy as np
import pytest

from reliefscope.device import Device, DeviceRebootedError, SequenceTiming
from reliefscope.protocol import messages as m
from reliefscope_sim.trace import OutputPin, TraceKind
from tests.firmware import compiled

DISPLAY_OFF = 0xAE  # shuts the glass that the defaults are for
STEPS = [m.Step(slot % 2, slot % 2, 1 + slot % 3, 2500, 1500) for slot in range(24)]
SPACING_US = 2300
CAUSES = [m.ResetCause.POWER_ON, m.ResetCause.WATCHDOG, m.ResetCause.LOCKUP]


def led_levels(records, levels):
    for record in records:
        if record.kind == TraceKind.LED:
            levels[record.argument] = int.from_bytes(record.payload, "little")
    return levels


@pytest.fixture(scope="module")
def duration_us(library):
    with compiled.Device(library) as device:
        compiled.load_sequence(device, STEPS, 5, 60_000)
        begun = device.now_us
        next_id = 200
        while True:
            device.run_for(5000)
            status = device.ask(m.StatusRequest(), next_id)
            if status.sequence is m.SequenceState.IDLE:
                assert status.exposures == sum(step.repeat for step in STEPS)
                return device.now_us - begun
            next_id += 1


def test_a_reset_anywhere_in_a_sequence_is_dark_shut_and_told(library, duration_us):
    lit, steps = 0, set()
    for number, after_us in enumerate(range(0, duration_us, SPACING_US)):
        cause = CAUSES[number % len(CAUSES)]
        with compiled.Device(library) as device:
            compiled.load_sequence(device, STEPS, 5, 60_000)
            device.run_for(after_us)
            before = led_levels(device.trace(), {})
            lit += any(before.values())
            steps.add(device.ask(m.StatusRequest(), 150).step)
            led_levels(device.trace(), before)
            device.output()
            library.rs_reset(device.handle, int(cause), compiled.NONCE + 1)
            reset_us = device.now_us
            at_reset = device.trace()
            assert not any(led_levels(at_reset, before).values())
            device.run_for(1000)
            records = at_reset + device.trace()
            assert all(
                r.time_us <= reset_us + 1000 and not int.from_bytes(r.payload, "little")
                for r in records
                if r.kind == TraceKind.LED
            )
            device.run_for(20_000)
            records += device.trace()
            bus = [r for r in records if r.kind == TraceKind.SPI]
            assert (bus[0].argument, bus[0].payload[0]) == (0, DISPLAY_OFF)
            assert not any(led_levels(records, {}).values())
            assert not any(
                r.kind == TraceKind.PIN and r.argument == OutputPin.CAMERA_TRIGGER and r.payload[0]
                for r in records
            )
            frames = device.frames()
            booted = m.MESSAGES[frames[0].message].unpack(frames[0].payload)
            assert isinstance(booted, m.BootedEvent)
            assert booted.reset_cause is cause
            assert frames[0].boot_nonce == compiled.NONCE + 1
    assert lit > 10
    assert steps == set(range(len(STEPS)))


def all_events(device):
    while True:
        device.events(5.0)


@pytest.mark.parametrize("exposure", range(12))
def test_the_host_tells_of_a_power_cut_in_any_step(exposure):
    url = f"sim://cut-{exposure}?size=64x48&seed=3&fault=brown_out_at:{exposure}"
    with Device.open(url, 10.0) as device:
        device.load_aperture(0, np.ones((64, 128), dtype=bool))
        device.load_light(0, [2000])
        device.load_steps([m.Step(0, 0, 1, 1000, 2000)] * 12)
        device.start(1, timing=SequenceTiming(ready_timeout_ms=0))
        with pytest.raises(DeviceRebootedError) as caught:
            all_events(device)
        assert caught.value.cause is m.ResetCause.BROWN_OUT
        device.reconnect()
        status = device.status()
        assert (status.light, status.aperture) == (m.SLOT_NONE, m.SLOT_NONE)
        assert status.sequence is m.SequenceState.IDLE
