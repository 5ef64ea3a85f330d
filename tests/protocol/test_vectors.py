"""Golden vectors: what the host makes and understands, byte for byte."""

import json

import pytest
from cobs import cobs
from tests.support import REPOSITORY

from reliefscope.protocol.codec import PayloadError, Struct, wire_fields
from reliefscope.protocol.framing import Frame, FrameError, FrameReader
from reliefscope.protocol.messages import MESSAGES, SCHEMA_HASH

FOLDER = REPOSITORY / "protocol" / "vectors"
FRAMES = json.loads((FOLDER / "frames.json").read_text())
VECTORS = FRAMES["vectors"]
STUFFING = json.loads((FOLDER / "cobs.json").read_text())["vectors"]


def of(*verdicts):
    chosen = [v for v in VECTORS if v["verdict"] in verdicts]
    assert chosen
    return pytest.mark.parametrize("vector", chosen, ids=[v["name"] for v in chosen])


def plain(value):
    """A field as the vectors write it."""
    if isinstance(value, Struct):
        return {name: plain(getattr(value, name)) for name in wire_fields(type(value))}
    if isinstance(value, bytes):
        return {"hex": value.hex()}
    return [plain(v) for v in value] if isinstance(value, tuple) else value


def test_vectors_belong_to_this_schema():
    assert FRAMES["schema_hash"] == SCHEMA_HASH.hex()


def test_every_message_has_a_vector():
    assert {v["id"] for v in VECTORS if v["verdict"] == "ok"} == set(MESSAGES)


@of("ok")
def test_good_frames(vector):
    data = bytes.fromhex(vector["frame"])
    (frame,) = FrameReader().feed(data)
    expected = vector["id"], vector["request_id"], vector["boot_nonce"], vector["payload"]
    assert (frame.message, frame.request_id, frame.boot_nonce, frame.payload.hex()) == expected
    message = MESSAGES[frame.message].unpack(frame.payload)
    assert vector["message"] == message.NAME
    assert plain(message) == vector["fields"]
    assert message.pack() == frame.payload
    assert frame.encode() == data


@of("crc", "framing", "overrun", "empty")
def test_bad_frames_are_dropped_and_counted(vector):
    reader = FrameReader()
    assert list(reader.feed(bytes.fromhex(vector["frame"]))) == []
    assert dict(reader.dropped) == ({} if vector["verdict"] == "empty" else {vector["verdict"]: 1})


@of("crc", "framing", "overrun")
def test_bad_frames_carry_their_verdict(vector):
    with pytest.raises(FrameError) as caught:
        Frame.decode(bytes.fromhex(vector["frame"])[:-1])
    assert caught.value.verdict == vector["verdict"]


@of("bad_length", "out_of_range")
def test_bad_payloads(vector):
    (frame,) = FrameReader().feed(bytes.fromhex(vector["frame"]))
    kind = MESSAGES[frame.message]
    fields = list(wire_fields(kind).values())
    field = fields[vector["bad_field"]] if "bad_field" in vector else None
    if field and field.of and "UNKNOWN" in getattr(field.of, "__members__", {}):
        # HELLO stays readable when a later firmware knows more reset causes.
        assert "UNKNOWN" in str(kind.unpack(frame.payload))
        return
    with pytest.raises(PayloadError):
        kind.unpack(frame.payload)


@of("unknown_message")
def test_unknown_message_is_a_sound_frame(vector):
    (frame,) = FrameReader().feed(bytes.fromhex(vector["frame"]))
    assert frame.message not in MESSAGES
    assert "unknown message 0x3F" in str(frame)


@pytest.mark.parametrize("vector", STUFFING)
def test_stuffing(vector):
    plain_bytes, stuffed = bytes.fromhex(vector["plain"]), bytes.fromhex(vector["stuffed"])
    assert cobs.encode(plain_bytes) == stuffed
    assert cobs.decode(stuffed) == plain_bytes
