"""Properties of frames on a bad link."""

from hypothesis import given
from hypothesis import strategies as st

from reliefscope.protocol.framing import MAX_ENCODED, Frame, FrameError, FrameReader
from reliefscope.protocol.messages import MAX_PAYLOAD

u8, u32 = st.integers(0, 255), st.integers(0, 2**32 - 1)
# Zeros and full bytes often: that is where COBS has its edges.
payloads = st.lists(st.sampled_from([0, 1, 255]) | u8, max_size=MAX_PAYLOAD).map(bytes)
frames = st.builds(Frame, u8, u32, u32, payloads)


@given(st.lists(frames, max_size=5), st.lists(st.integers(1, 50), max_size=20))
def test_round_trip_however_the_stream_is_cut(sent, cuts):
    stream = b"".join(b"\0" + frame.encode() for frame in sent)
    reader, received = FrameReader(), []
    for cut in cuts:
        received += reader.feed(stream[:cut])
        stream = stream[cut:]
    received += reader.feed(stream)
    assert received == sent
    assert not reader.dropped


@given(frames)
def test_encoded_frame_is_bounded_and_has_one_zero(frame):
    data = frame.encode()
    assert data.index(0) == len(data) - 1
    assert len(data) <= MAX_ENCODED


@given(frames, st.data())
def test_a_corrupted_frame_is_never_taken_for_another(frame, data):
    encoded = bytearray(frame.encode()[:-1])
    for _ in range(data.draw(st.integers(1, 4))):
        place = data.draw(st.integers(0, len(encoded) - 1))
        what = data.draw(st.sampled_from(["flip", "lose", "insert"]))
        if what == "flip":
            encoded[place] ^= 1 << data.draw(st.integers(0, 7))
        elif what == "lose" and len(encoded) > 1:
            del encoded[place]
        else:
            encoded.insert(place, data.draw(u8))
    for part in bytes(encoded).split(b"\0"):
        try:
            got = Frame.decode(part)
        except FrameError:
            continue
        assert got == frame


@given(st.binary(max_size=600), frames)
def test_the_frame_after_garbage_is_found(garbage, frame):
    reader = FrameReader()
    list(reader.feed(garbage))
    assert list(reader.feed(b"\0" + frame.encode()))[-1] == frame


def test_endless_garbage_takes_no_memory():
    reader = FrameReader()
    for _ in range(100):
        assert list(reader.feed(b"\x55" * 10_000)) == []
    assert len(reader._buffer) <= MAX_ENCODED
    assert list(reader.feed(b"\0")) == []
    assert dict(reader.dropped) == {"overrun": 1}
