"""Frames: header + payload + CRC-32, stuffed with COBS and ended by a zero byte.

COBS comes from the package `cobs` (S. Cheshire and M. Baker, "Consistent Overhead Byte Stuffing", IEEE/ACM
Transactions on Networking 7(2), 1999), whose compiled form keeps long transfers cheap.
"""

from __future__ import annotations

import zlib
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass

from cobs import cobs

from reliefscope.protocol.codec import FieldRangeError, PayloadError
from reliefscope.protocol.messages import MAX_PAYLOAD, MESSAGES, Header

CRC_SIZE = 4
MAX_FRAME = Header.SIZE + MAX_PAYLOAD + CRC_SIZE
MAX_ENCODED = MAX_FRAME + MAX_FRAME // 254 + 2
"""Bytes of the longest frame on the wire, with its delimiter."""


class FrameError(PayloadError):
    """Bytes up to a delimiter are not a frame; ``verdict`` is "framing", "crc" or "overrun"."""

    def __init__(self, verdict: str, message: str) -> None:
        super().__init__(
            message, hint="The link lost or changed bytes; the request will be repeated."
        )
        self.verdict = verdict


@dataclass(frozen=True, slots=True)
class Frame:
    """One frame.

    ``request_id`` is the number of the request that is asked or answered, or the number of the event.
    """

    message: int
    request_id: int
    boot_nonce: int
    payload: bytes

    def encode(self) -> bytes:
        """The frame on the wire, with its delimiter."""
        header = Header(self.message, self.request_id, self.boot_nonce, len(self.payload))
        body = header.pack() + self.payload
        return bytes(cobs.encode(body + zlib.crc32(body).to_bytes(CRC_SIZE, "little"))) + b"\0"

    @classmethod
    def decode(cls, stuffed: bytes) -> Frame:
        """Read what came before a delimiter.

        Raises
        ------
        FrameError
            If it is not a whole frame with a right CRC.
        """
        if len(stuffed) >= MAX_ENCODED:
            raise FrameError(
                "overrun", f"Received {len(stuffed)} bytes without an end; no frame is that long."
            )
        try:
            data = bytes(cobs.decode(stuffed))
        except cobs.DecodeError as error:
            raise FrameError("framing", f"Received bytes that are not stuffed: {error}.") from error
        if len(data) > MAX_FRAME:
            raise FrameError(
                "overrun", f"Received a frame of {len(data)} bytes; {MAX_FRAME} are the most."
            )
        if len(data) < Header.SIZE + CRC_SIZE:
            raise FrameError("framing", f"Received a frame of only {len(data)} bytes.")
        body = data[:-CRC_SIZE]
        if zlib.crc32(body) != int.from_bytes(data[-CRC_SIZE:], "little"):
            raise FrameError("crc", "Received a frame whose checksum is wrong.")
        header, payload = Header.unpack(body[: Header.SIZE]), body[Header.SIZE :]
        if header.length != len(payload):
            raise FrameError(
                "framing", f"Received {len(payload)} bytes where the header says {header.length}."
            )
        return cls(header.message, header.request_id, header.boot_nonce, payload)

    def __str__(self) -> str:
        return f"{describe(self.message, self.payload)} id={self.request_id} nonce={self.boot_nonce:08x}"


class FrameReader:
    """Finds frames in a stream of bytes; ``dropped`` counts what was not a frame, by verdict."""

    def __init__(self) -> None:
        self.dropped: Counter[str] = Counter()
        self._buffer = bytearray()

    def reset(self) -> None:
        """Forget an unfinished frame."""
        self._buffer.clear()

    def feed(self, data: bytes) -> Iterator[Frame]:
        """Take bytes as they come, yield the frames that they complete.

        Every byte is taken at once; frames that are not fetched from the iterator are decoded, not lost.
        """
        *ended, rest = (bytes(self._buffer) + data).split(b"\0")
        # Past the longest frame nothing can become one any more: keep just enough to tell so at the delimiter.
        self._buffer = bytearray(rest[:MAX_ENCODED])
        frames = []
        for stuffed in filter(None, ended):
            try:
                frames.append(Frame.decode(stuffed))
            except FrameError as error:
                self.dropped[error.verdict] += 1
        return iter(frames)


def describe(message: int, payload: bytes) -> str:
    """A message by name and values, for wire logs."""
    kind = MESSAGES.get(message)
    if kind is None:
        return f"unknown message 0x{message:02X} ({len(payload)} bytes)"
    try:
        return str(kind.unpack(payload))
    except (PayloadError, FieldRangeError) as error:
        return f"invalid {kind.__name__}: {error.message}"
