"""Trace records: round trip and damage."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from reliefscope_sim.trace import TraceKind, TraceRecord, pack_record, parse_trace

records = st.builds(
    TraceRecord,
    kind=st.sampled_from(TraceKind),
    argument=st.integers(0, 255),
    time_us=st.integers(0, 2**64 - 1),
    payload=st.binary(max_size=80),
)


@given(st.lists(records, max_size=8))
def test_records_survive_packing(written):
    data = b"".join(map(pack_record, written))
    assert list(parse_trace(data)) == written


def test_layout_is_the_documented_one():
    data = bytes([3, 5, 2, 0]) + (1_000_000).to_bytes(8, "little") + (4095).to_bytes(2, "little")
    (record,) = parse_trace(data)
    assert record == TraceRecord(TraceKind.LED, 5, 1_000_000, b"\xff\x0f")
    assert record.level == 4095


@given(records, st.data())
def test_cut_off_records_are_refused(record, data):
    whole = pack_record(record)
    cut = data.draw(st.integers(1, len(whole) - 1))
    with pytest.raises(ValueError, match="cut off"):
        list(parse_trace(whole[:cut]))


def test_unknown_kinds_are_refused():
    with pytest.raises(ValueError, match="99"):
        list(parse_trace(bytes([99]) + bytes(11)))
