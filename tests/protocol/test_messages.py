"""Typed messages: ranges are checked when a message is made, and every value survives the wire."""

import enum

import pytest
from hypothesis import given
from hypothesis import strategies as st

from reliefscope.protocol import messages as m
from reliefscope.protocol.codec import FieldRangeError, PayloadError, Request, wire_fields

TEXT = st.text(st.characters(min_codepoint=0x20, max_codepoint=0x7E))


def one_value(wire):
    if wire.kind == "struct":
        return a_message(wire.of)
    if wire.kind == "bool":
        return st.booleans()
    if wire.kind == "enum" and not issubclass(wire.of, enum.Flag):
        return st.sampled_from(list(wire.of))
    low, high = wire.limits
    numbers = st.sampled_from([low, high, *wire.also]) | st.integers(low, high)
    return numbers.map(wire.of) if wire.of else numbers


def value_of(wire):
    if wire.kind == "ascii":
        return TEXT.map(lambda text: text[: wire.count])
    if wire.count is None:
        return one_value(wire)
    least = 0 if wire.bounded else wire.count
    items = st.lists(one_value(wire), min_size=least, max_size=wire.count)
    return items.map(bytes if wire.base == "u8" else tuple)


def a_message(kind):
    return st.builds(kind, **{name: value_of(wire) for name, wire in wire_fields(kind).items()})


@given(st.sampled_from(list(m.MESSAGES.values())).flatmap(a_message))
def test_every_valid_message_survives_the_wire(message):
    assert type(message).unpack(message.pack()) == message


@given(st.sampled_from(list(m.MESSAGES.values())), st.binary(max_size=300))
def test_any_bytes_are_a_valid_message_or_an_error(kind, data):
    try:
        message = kind.unpack(data)
    except PayloadError:
        return
    assert len(message.pack()) == len(data)


def test_step_is_little_endian_without_padding():
    step = m.Step(aperture=3, light=255, repeat=0x0102, settle_us=400_000, exposure_us=0x01020304)
    assert step.pack().hex() == "03ff" + "0201" + "801a0600" + "04030201"


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (lambda: m.SelectLightRequest(32), "slot is 32; allowed are 0 to 31 or 255"),
        (lambda: m.Step(0, 0, 0, 0, 100), "repeat is 0"),
        (lambda: m.Step(0, 0, 1, 60_000_001, 100), "settle_us is 60000001 us"),
        (lambda: m.ApertureChunkRequest(0, 0, b"\0" * 255), "data has 255 elements, not 256"),
        (lambda: m.LoadLightRequest(0, (0,) * 49), "levels has 49 elements, not at most 48"),
        (lambda: m.ClearFaultRequest(3), "reason is 3, not a FaultReason"),
        (lambda: m.StepChunkRequest(0, ((1, 2),)), "is .1, 2., not a Step"),
        (lambda: settings(serial_number="Ω1"), "only printable ASCII"),
        (lambda: settings(serial_number="x" * 17), "longer than 16"),
    ],
)
def test_bad_values_are_named(make, text):
    with pytest.raises(FieldRangeError, match=text):
        make()


def settings(**changes):
    values = {
        "serial_number": "RS-1",
        "glass_variant": m.GlassVariant.S_FSTN_NEGATIVE,
        "mounting": m.Mounting.TOP_VIEW,
        "contrast": 22,
        "resistor_ratio": 7,
    }
    return m.SetSettingsRequest(**values | changes)


def test_requests_know_their_replies():
    for kind in m.MESSAGES.values():
        if issubclass(kind, Request):
            assert kind.REPLY.ID == kind.ID | 0x80
            assert kind.REPLY.NAME.removesuffix("_reply") == kind.NAME.removesuffix("_request")


def test_errors_explain_themselves():
    for error in [*m.ErrorCode, *m.FaultReason]:
        assert error.description
        assert error.cause
        assert error.next_step


def test_a_later_reset_cause_is_unknown_but_a_later_state_is_an_error():
    assert m.ResetCause(200) is m.ResetCause.UNKNOWN
    with pytest.raises(ValueError, match="200"):
        m.SequenceState(200)


def test_frozen_layouts_have_not_moved():
    """HELLO and enter_bootloader of version 1, byte for byte: these numbers may never change."""
    assert [m.HelloRequest.ID, m.HelloReply.ID] == [0x01, 0x81]
    assert [m.EnterBootloaderRequest.ID, m.EnterBootloaderReply.ID] == [0x02, 0x82]
    reply = m.HelloReply(
        protocol_version=0x0201,
        schema_hash=bytes(range(16)),
        firmware_version="1.2.3",
        git_hash="abc",
        board="teensy31",
        serial_number="RS-1",
        capabilities=m.Capability.BOOTLOADER,
        reset_cause=m.ResetCause.PIN,
        boot_nonce=0x44332211,
        last_request_id=0x88776655,
        aperture_slots=16,
        light_slots=32,
        leds=48,
        steps=1024,
        reserved=bytes(8),
    )
    assert reply.pack() == (
        b"\x01\x02" + bytes(range(16)) + b"1.2.3".ljust(16, b"\0") + b"abc".ljust(16, b"\0")
        + b"teensy31".ljust(16, b"\0") + b"RS-1".ljust(16, b"\0") + b"\x08\0\0\0" + b"\x02"
        + b"\x11\x22\x33\x44" + b"\x55\x66\x77\x88" + b"\x10\x20\x30" + b"\x00\x04" + bytes(8)
    )  # fmt: skip
    assert m.EnterBootloaderRequest(m.BOOTLOADER_MAGIC).pack() == b"BOOT"
    header = m.Header(message=1, request_id=0x44332211, boot_nonce=0x88776655, length=0x0201)
    assert header.pack().hex() == "01" + "11223344" + "55667788" + "0102"
