"""The block by which a firmware image says what it is.

Layout in ``firmware/core/identity.hpp``: magic, layout version, size, product, board, version, commit, protocol
version, schema hash, CRC-32; little-endian; later layouts only append (the CRC always stands last).
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Iterator
from dataclasses import dataclass

MAGIC = b"\x89RSID\r\n\x1a"
PRODUCT = "reliefscope"
_HEAD = struct.Struct("<8sHH")
_BODY = struct.Struct("<16s16s16s16sHH16s")
_CRC_BYTES = 4
_MAX_BYTES = 1024


@dataclass(frozen=True, slots=True)
class FirmwareIdentity:
    """What an image is; ``board``, ``version``, ``git_hash`` and ``schema_hash`` as in HELLO."""

    product: str
    board: str
    version: str
    git_hash: str
    protocol_version: int
    schema_hash: bytes


def find_identities(data: bytes) -> Iterator[FirmwareIdentity]:
    """Every intact block in ``data``; a magic without a right size and CRC is chance, not a block."""
    at = data.find(MAGIC)
    while at >= 0:
        identity = _read(data, at)
        if identity is not None:
            yield identity
        at = data.find(MAGIC, at + 1)


def _read(data: bytes, at: int) -> FirmwareIdentity | None:
    if len(data) < at + _HEAD.size + _BODY.size + _CRC_BYTES:
        return None
    _, layout, size = _HEAD.unpack_from(data, at)
    if layout < 1 or not _HEAD.size + _BODY.size + _CRC_BYTES <= size <= _MAX_BYTES:
        return None
    block = data[at : at + size]
    stored = int.from_bytes(block[-_CRC_BYTES:], "little")
    if len(block) < size or zlib.crc32(block[:-_CRC_BYTES]) != stored:
        return None
    product, board, version, git_hash, protocol, _, schema = _BODY.unpack_from(block, _HEAD.size)
    return FirmwareIdentity(
        product=_text(product),
        board=_text(board),
        version=_text(version),
        git_hash=_text(git_hash),
        protocol_version=protocol,
        schema_hash=schema,
    )


def _text(field: bytes) -> str:
    return field.partition(b"\0")[0].decode("ascii", errors="replace")
