"""Records of what the firmware did to its lines, as its hardware layer writes them.

The same records come from the host library and from the emulated board: one byte stream of whole records,
little-endian: u8 kind, u8 argument, u16 payload length, u64 time in us, payload.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator
from dataclasses import dataclass
from enum import IntEnum

_HEAD = struct.Struct("<BBHQ")


class TraceKind(IntEnum):
    """What a record tells."""

    SPI = 1
    """Bytes to the glass; the argument is the level of A0."""
    PIN = 2
    """Output pin; the argument is the :class:`OutputPin`, payload u8 level."""
    LED = 3
    """LED line; the argument is its index, payload u16 level."""
    NONVOLATILE = 4
    """Byte of the non-volatile memory written."""
    BOOTLOADER = 5
    """The bootloader was entered: the firmware runs no more."""
    OVERFLOW = 6
    """Records were lost because nobody read them in time."""


class OutputPin(IntEnum):
    """Pins that the firmware drives."""

    LCD_RESET = 0
    LCD_SELECT = 1
    CAMERA_TRIGGER = 2


class InputLine(IntEnum):
    """Lines that the firmware reads."""

    CAMERA_STROBE = 0
    CAMERA_READY = 1


@dataclass(frozen=True, slots=True)
class TraceRecord:
    """One record; ``time_us`` is device time."""

    kind: TraceKind
    argument: int
    time_us: int
    payload: bytes

    @property
    def level(self) -> int:
        """Payload of pin and LED records as a number."""
        return int.from_bytes(self.payload, "little")


def parse_trace(data: bytes) -> Iterator[TraceRecord]:
    """Records of ``data``, oldest first.

    Raises
    ------
    ValueError
        If ``data`` does not consist of whole records of known kinds: the library is of another version.
    """
    offset = 0
    while offset < len(data):
        try:
            kind, argument, length, time_us = _HEAD.unpack_from(data, offset)
        except struct.error as error:
            raise ValueError(f"trace record at byte {offset} is cut off") from error
        offset += _HEAD.size
        payload = data[offset : offset + length]
        if len(payload) < length:
            raise ValueError(f"trace record at byte {offset - _HEAD.size} is cut off")
        offset += length
        yield TraceRecord(TraceKind(kind), argument, time_us, payload)


def pack_record(record: TraceRecord) -> bytes:
    """Bytes of one record: the inverse of :func:`parse_trace`."""
    head = _HEAD.pack(record.kind, record.argument, len(record.payload), record.time_us)
    return head + record.payload
