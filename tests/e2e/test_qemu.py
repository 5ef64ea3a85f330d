"""The product's core as ARM code: its unit tests, and a whole sequence by the host's own client."""

import itertools
import re
import zlib

import numpy as np
import pytest

from reliefscope.device import Device
from reliefscope.device.sequence import SequenceTiming
from reliefscope.models.apertures import pack_bitmap
from reliefscope.protocol import messages as m
from reliefscope_sim.display import DisplayController
from reliefscope_sim.trace import OutputPin, TraceKind, TraceRecord
from tests.e2e import qemu
from tests.firmware import compiled
from tests.firmware.test_core import CASES

APERTURES, LIGHTS = 12, 16
EXPOSURE_US = 1000
TIMING = SequenceTiming(light_lead_us=300, trigger_us=50, gap_us=500, ready_timeout_ms=0)
STEPS = [
    m.Step(aperture, light, 1, 2000, EXPOSURE_US)
    for aperture in range(APERTURES)
    for light in range(LIGHTS)
]
BITMAPS = [
    np.random.default_rng(aperture).random((64, 128)) < 0.1 + 0.05 * aperture
    for aperture in range(APERTURES)
]


def levels(light):
    return (0,) * light + (1000 + light,)


@pytest.fixture(scope="module")
def images():
    return qemu.images()


@pytest.fixture(scope="module")
def arm_results(images):
    done = qemu.run_tests(images / "reliefscope_qemu_tests.elf")
    found = re.findall(r"^.+:\d+:(\w+):(PASS|FAIL.*)$", done.stdout, re.MULTILINE)
    assert done.returncode in {0, 100}, done.stdout + done.stderr
    return dict(found)


@pytest.mark.parametrize("case", CASES)
def test_case_as_arm_code(arm_results, case):
    assert arm_results.get(case, "was not run") == "PASS"


def at_triggers(records):
    """What glass and LEDs show at each rising edge of the camera trigger."""
    glass = DisplayController()
    lit: dict[int, int] = {}
    shown = []
    for record in records:
        assert record.kind is not TraceKind.OVERFLOW
        if record.kind is TraceKind.SPI:
            glass.feed(record.argument, record.payload)
        elif record.kind is TraceKind.LED:
            lit[record.argument] = record.level
        elif record.kind is TraceKind.PIN:
            if record.argument == OutputPin.LCD_RESET:
                glass.set_reset(record.level)
            elif record.argument == OutputPin.LCD_SELECT:
                glass.set_select(record.level)
            elif record.level:
                shown.append((glass.driven(), {led for led, level in lit.items() if level}))
    assert not glass.faults
    return shown


def bus(records):
    """Everything that went over SPI, chunk by chunk."""
    return [(r.argument, r.payload) for r in records if r.kind is TraceKind.SPI]


def host_trace(library):
    """The same sequence on the host build of the core."""
    with compiled.Device(library) as device:
        device.run_for(20_000)
        ids = iter(range(1, 1000))
        for slot, bitmap in enumerate(BITMAPS):
            data = pack_bitmap(bitmap)
            for chunk in range(4):
                part = data[256 * chunk : 256 * (chunk + 1)]
                device.ask(m.ApertureChunkRequest(slot, chunk, part), next(ids))
            device.ask(m.CommitApertureRequest(slot, zlib.crc32(data)), next(ids))
        for light in range(LIGHTS):
            device.ask(m.LoadLightRequest(light, levels(light)), next(ids))
        for first in range(0, len(STEPS), 16):
            device.ask(m.StepChunkRequest(first, tuple(STEPS[first : first + 16])), next(ids))
        table = zlib.crc32(b"".join(step.pack() for step in STEPS))
        device.ask(m.CommitStepsRequest(len(STEPS), table), next(ids))
        device.ask(
            m.StartRequest(
                run_id=9,
                table_hash=table,
                deadline_ms=60_000,
                light_lead_us=TIMING.light_lead_us,
                trigger_us=TIMING.trigger_us,
                gap_us=TIMING.gap_us,
                ready_timeout_ms=0,
                require_strobe=False,
            ),
            next(ids),
        )
        found = []
        for _ in range(100):
            device.run_for(50_000)
            found += [
                TraceRecord(TraceKind(r.kind), r.argument, r.time_us, r.payload)
                for r in device.trace()
            ]
            reply = device.ask(m.StatusRequest(), next(ids))
            if reply.sequence is m.SequenceState.IDLE:
                return found
            device.ask(m.AcknowledgeEventsRequest(reply.next_event, False), next(ids))
    raise AssertionError("the host build did not finish")


def test_a_whole_sequence_over_a_socket_equals_the_host_build(images, library):
    with qemu.QemuBoard(images / "reliefscope_qemu_m4.elf") as board:
        with Device.open(board.url) as device:
            assert device.identity.board == "qemu_m4"
            assert device.identity.boot_nonce == qemu.NONCE
            for slot, bitmap in enumerate(BITMAPS):
                assert device.load_aperture(slot, bitmap) == bitmap.sum()
            for light in range(LIGHTS):
                device.load_light(light, levels(light))
            table = device.load_steps(STEPS)
            device.start(9, timing=TIMING)
            events = []
            while not (events and isinstance(events[-1], m.SequenceEvent) and len(events) > 1):
                events.append(device.events(timeout_s=30))
            counters = device.counters()
        records = board.settled_trace()
    assert events[0].news is m.SequenceNews.STARTED
    assert events[-1].news is m.SequenceNews.FINISHED
    exposures = events[1:-1]
    assert [(e.step, e.aperture, e.light) for e in exposures] == [
        (index, step.aperture, step.light) for index, step in enumerate(STEPS)
    ]
    assert all(e.table_hash == table and e.settle_waited_us >= 2000 for e in exposures)
    starts = [e.start_us for e in exposures]
    assert all(b - a >= EXPOSURE_US + TIMING.gap_us for a, b in itertools.pairwise(starts))
    assert (counters.crc_errors, counters.framing_errors, counters.faults) == (0, 0, 0)

    edges = [
        r.time_us
        for r in records
        if r.kind is TraceKind.PIN and r.argument == OutputPin.CAMERA_TRIGGER and r.level
    ]
    assert len(edges) == len(starts)
    assert max(abs(a - b) for a, b in zip(edges, starts, strict=True)) <= 1000
    shown = at_triggers(records)
    for (glass, lit), step in zip(shown, STEPS, strict=True):
        np.testing.assert_array_equal(glass, BITMAPS[step.aperture])
        assert lit == {step.light}
    expected = host_trace(library)
    for (glass, lit), (host_glass, host_lit) in zip(shown, at_triggers(expected), strict=True):
        np.testing.assert_array_equal(glass, host_glass)
        assert lit == host_lit
    assert bus(records) == bus(expected)
