"""Properties of framer, dispatch and sequencer, through the compiled core."""

import random

from hypothesis import given, settings
from hypothesis import strategies as st
from tests.firmware.compiled import NONCE, Device, frame, light, load_sequence

from reliefscope.protocol.messages import (
    AcknowledgeEventsRequest,
    CountersRequest,
    ErrorCode,
    ExposureEvent,
    FaultReason,
    HelloReply,
    HelloRequest,
    LoadLightReply,
    Rejected,
    SelectLightReply,
    SelectLightRequest,
    SequenceEvent,
    StatusReply,
    StatusRequest,
    Step,
)

TRACE_LED = 3
RING = 16
HELLO_ID = 0xFFFF_FFFF


def selected_level(device, request_id):
    answer = device.ask(SelectLightRequest(slot=0), request_id)
    return answer.level_sum if isinstance(answer, SelectLightReply) else None


def lit(device):
    return any(r.kind == TRACE_LED and any(r.payload) for r in device.trace())


garbage = st.lists(
    st.one_of(st.binary(max_size=40), st.binary(min_size=250, max_size=300), st.just(b"\0")),
    max_size=12,
).map(b"".join)


@settings(max_examples=150, deadline=None)
@given(garbage)
def test_garbage_never_executes_and_the_next_frame_after_a_zero_is_answered(library, data):
    with Device(library) as device:
        device.feed(data + b"\0", step_us=7)
        device.frames()
        assert isinstance(device.ask(HelloRequest(), HELLO_ID), HelloReply)
        status = device.ask(StatusRequest(), 1)
        assert (status.table_hash, status.run_id, status.light) == (0, 0, 255)
        assert status.fault == FaultReason.NONE
        assert not lit(device)
        # Every frame that looked like one was counted once, under one cause.
        counters = device.ask(CountersRequest(), 2)
        parts = [part for part in data.split(b"\0") if part]
        dropped = counters.crc_errors + counters.framing_errors + counters.overruns
        assert counters.frames_received == 3
        assert dropped == len(parts)


@settings(max_examples=150, deadline=None)
@given(st.data())
def test_a_damaged_request_is_never_run(library, data):
    with Device(library) as device:
        device.ask(light(700), 1)
        good = bytearray(frame(SelectLightRequest(slot=0), 2))
        for _ in range(data.draw(st.integers(1, 3))):
            at = data.draw(st.integers(0, len(good) - 2))
            good[at] ^= data.draw(st.integers(1, 255))
        if bytes(good) == frame(SelectLightRequest(slot=0), 2):
            return
        device.feed(bytes(good) + b"\0")
        assert device.answers(2) == []
        assert not lit(device)
        assert selected_level(device, 2) == 700


@settings(max_examples=100, deadline=None)
@given(st.lists(st.tuples(st.integers(1, 40), st.booleans()), min_size=1, max_size=60))
def test_a_request_is_run_at_most_once_whatever_arrives_again(library, arrivals):
    """Against a model of the ring; a request is (id, one of two contents), in any order and number."""
    with Device(library) as device:
        ring = []
        highest = 0
        level = None
        for request_id, other in arrivals:
            request = light(2 * request_id + other)
            answer = device.ask(request, request_id)
            kept = dict(ring[-RING:])
            if request_id in kept:
                if kept[request_id] == request:
                    assert answer.level_sum == 2 * request_id + other
                else:
                    assert isinstance(answer, Rejected)
                    assert answer.code == ErrorCode.REQUEST_ID_REUSED
            elif request_id <= highest:
                assert isinstance(answer, Rejected)
                assert answer.code == ErrorCode.REQUEST_TOO_OLD
            else:
                assert isinstance(answer, LoadLightReply)
                highest = request_id
                level = 2 * request_id + other
                ring.append((request_id, request))
        assert selected_level(device, 1000) == level


@settings(max_examples=60, deadline=None)
@given(st.binary(max_size=200), st.lists(st.integers(1, 60), min_size=1, max_size=40))
def test_how_bytes_are_cut_into_pieces_changes_nothing(library, noise, cuts):
    stream = frame(light(5), 1) + noise + b"\0" + frame(StatusRequest(), 2)
    stream += frame(light(6), 3) + frame(SelectLightRequest(slot=0), 4) + frame(StatusRequest(), 5)
    outputs = []
    for pieces in (cuts, [len(stream)]):
        with Device(library) as device:
            at = 0
            for size in pieces * (len(stream) // sum(pieces) + 1):
                device.feed(stream[at : at + size])
                at += size
            outputs.append([f for f in device.output().split(b"\0") if f])
    assert sorted(outputs[0]) == sorted(outputs[1])


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 2**32 - 1), st.sampled_from([0.001, 0.01, 0.03]))
def test_a_bad_line_makes_no_answer_wrong(library, seed, rate):
    """Bytes lost, changed, doubled; the host repeats each request until it is answered."""
    rng = random.Random(seed)

    def line(data):
        out = bytearray()
        for byte in data:
            damage = rng.choice(["lost", "changed", "doubled"]) if rng.random() < rate else ""
            if damage != "lost":
                out.append(byte ^ 1 << rng.randrange(8) if damage == "changed" else byte)
            if damage == "doubled":
                out.append(byte)
        return bytes(out)

    with Device(library) as device:
        device.ask(AcknowledgeEventsRequest(next_event=1, resend=False), 1)
        for request_id in range(2, 60):
            request = light(rng.randrange(4096))
            for _ in range(60):
                device.feed(b"\0" + line(frame(request, request_id)))
                answers = device.answers(request_id)
                if answers:
                    break
            # A lost delimiter is made good by the next frame's: then the retry is answered, too.
            assert {type(answer) for answer in answers} == {LoadLightReply}
            assert {answer.level_sum for answer in answers} == {request.levels[0]}
        assert selected_level(device, 1000) == request.levels[0]


steps_of = st.lists(
    st.builds(
        Step,
        aperture=st.sampled_from([0, 1, 255]),
        light=st.sampled_from([0, 1, 255]),
        repeat=st.integers(1, 4),
        settle_us=st.integers(0, 50_000),
        exposure_us=st.integers(10, 20_000),
    ),
    min_size=1,
    max_size=20,
)


@settings(max_examples=40, deadline=None)
@given(steps_of, st.integers(0, 2**32 - 1))
def test_a_sequence_tells_each_exposure_once_while_garbage_floods_the_port(library, steps, seed):
    rng = random.Random(seed)
    wanted = [(i, r) for i, step in enumerate(steps) for r in range(step.repeat)]
    with Device(library) as device:
        table_hash = load_sequence(device, steps, 5, 600_000)
        device.trace()
        told = []
        next_id = 200
        for _ in range(4000):
            flood = rng.randbytes(rng.randrange(60))
            device.feed(b"\0" + flood + b"\0")
            device.run_for(rng.randrange(1, 20_000))
            frames = device.frames()
            events = [f for f in frames if 0x40 <= f.message < 0x80]
            told += [ExposureEvent.unpack(f.payload) for f in events if f.message == 0x41]
            if events:
                acknowledge = AcknowledgeEventsRequest(
                    next_event=events[-1].request_id + 1, resend=False
                )
                device.feed(frame(acknowledge, next_id))
                next_id += 1
            news = [SequenceEvent.unpack(f.payload) for f in events if f.message == 0x42]
            if any(n.exposures == len(wanted) for n in news):
                break
        assert [(e.step, e.repeat) for e in told] == wanted
        assert [e.index for e in told] == list(range(len(wanted)))
        assert {e.table_hash for e in told} == {table_hash}
        assert all(e.settle_waited_us >= steps[e.step].settle_us for e in told)
        rises = [
            r.time_us for r in device.trace() if (r.kind, r.argument, r.payload) == (2, 2, b"\1")
        ]
        assert rises == [e.start_us for e in told]
        device.frames()
        status = device.ask(StatusRequest(), next_id)
        assert isinstance(status, StatusReply)
        assert status.fault == FaultReason.NONE


@settings(max_examples=25, deadline=None)
@given(steps_of, st.integers(0, 400_000), st.sampled_from([1, 3, 5]))
def test_a_reset_at_any_moment_leaves_the_light_off_and_shuts_first(library, steps, when_us, cause):
    with Device(library) as device:
        load_sequence(device, steps, 5, 600_000)
        device.run_for(when_us)
        before = device.trace()
        levels = {}
        for record in before:
            if record.kind == TRACE_LED:
                levels[record.argument] = int.from_bytes(record.payload, "little")
        device.library.rs_reset(device.handle, cause, NONCE + 1)
        reset_us = device.now_us
        device.run_for(5_000)
        after = device.trace()
        for record in after:
            if record.kind == TRACE_LED:
                levels[record.argument] = int.from_bytes(record.payload, "little")
                assert record.time_us - reset_us <= 1000
        assert not any(levels.values())
        spi = [r for r in after if r.kind == 1]
        assert spi[0].argument == 0
        assert spi[0].payload == b"\xae"
        hello = device.ask(HelloRequest(), HELLO_ID)
        assert hello.reset_cause == cause
        assert hello.boot_nonce == NONCE + 1
