"""Golden vectors: frames with the verdict that every implementation must come to.

Nothing here uses the code under test: values are laid out byte by byte from the schema, the CRC is the bit-serial
definition and COBS is the definition of its paper, written out plainly.  Host and firmware use other
implementations, so an error would have to be made twice in two ways to stay hidden.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from protocol.generator.schema import INTEGER_BYTES, Layout, Schema, WireField, integer_range

Vector = dict[str, Any]
NONCE = 0x1BADB002


def crc32(data: bytes) -> int:
    """CRC-32 of IEEE 802.3, bit by bit."""
    register = 0xFFFFFFFF
    for byte in data:
        register ^= byte
        for _ in range(8):
            register = (register >> 1) ^ (0xEDB88320 if register & 1 else 0)
    return register ^ 0xFFFFFFFF


def stuff(data: bytes) -> bytes:
    """COBS without delimiter: each zero, and each run of 254 others, is replaced by the distance to the next."""
    out, block = bytearray(), bytearray()
    full = False
    for byte in data:
        full = False
        if byte:
            block.append(byte)
        if not byte or len(block) == 254:
            out += bytes([len(block) + 1]) + block
            full = bool(byte)
            block.clear()
    return bytes(out if full else out + bytes([len(block) + 1]) + block)


def cobs_vectors() -> list[Vector]:
    """Pairs of plain and stuffed bytes around the limits of COBS."""
    run = bytes(range(1, 256))
    plain = [b"", b"\0", b"\0\0", b"\1", b"\1\0", b"\0\1", b"\x11\x22\0\x33", b"\xff" * 3]
    plain += [run[:n] for n in (253, 254, 255)]
    plain += [run[:n] + b"\0" for n in (253, 254, 255)]
    plain += [b"\0" + run[:n] for n in (253, 254, 255)]
    plain += [run[:254] * 2, run[:254] + b"\1", run[:254] + b"\0\1", b"\0" * 300, run + b"\0" + run]
    return [{"plain": p.hex(), "stuffed": stuff(p).hex()} for p in plain]


def frame_vectors(schema: Schema) -> list[Vector]:
    """Every message with typical, least and greatest values; limits of COBS; every kind of bad frame."""
    return [*_good(schema), *_runs(schema), *_bad_payloads(schema), *_bad_frames(schema)]


def _frame(
    schema: Schema, message: int, request_id: int, payload: bytes, *, length: int | None = None
) -> bytes:
    values = [message, request_id, NONCE, len(payload) if length is None else length]
    head = b"".join(
        v.to_bytes(INTEGER_BYTES[f.base], "little")
        for v, f in zip(values, schema.header.fields, strict=True)
    )
    return head + payload + crc32(head + payload).to_bytes(4, "little")


def _vector(
    schema: Schema, name: str, layout: Layout, payload: bytes, verdict: str = "ok", **more: Any
) -> Vector:
    request_id = 0x01020304 + layout.id
    return {
        "name": name,
        "verdict": verdict,
        "message": layout.name,
        "id": layout.id,
        "request_id": request_id,
        "boot_nonce": NONCE,
        "payload": payload.hex(),
        "frame": (stuff(_frame(schema, layout.id, request_id, payload)) + b"\0").hex(),
        **more,
    }


def _good(schema: Schema) -> Iterator[Vector]:
    for layout in schema.messages:
        for style in ("typical", "least", "greatest") if layout.fields else ("typical",):
            values = _values(schema, layout, style)
            payload = _pack(schema, layout, values)
            yield _vector(
                schema, f"{layout.name}_{style}", layout, payload, fields=_as_json(values)
            )


def _runs(schema: Schema) -> Iterator[Vector]:
    layout = next(m for m in schema.messages if m.name == "aperture_chunk_request")
    size = next(f.count for f in layout.fields if f.name == "data") or 0
    fills = {"zeros": b"", "ones": b"\xff" * size}
    fills |= {f"run_{n}": b"\0" + b"\x5a" * n for n in (253, 254, 255)}
    for name, fill in fills.items():
        values = {"slot": 3, "chunk": 2, "data": fill.ljust(size, b"\0")}
        payload = _pack(schema, layout, values)
        yield _vector(schema, f"cobs_{name}", layout, payload, fields=_as_json(values))


def _bad_payloads(schema: Schema) -> Iterator[Vector]:
    for layout in schema.messages:
        values = _values(schema, layout, "typical")
        payload = _pack(schema, layout, values)
        if len(payload) < schema.max_payload:  # else the frame itself would be too long
            longer = payload + b"\x01"
            yield _vector(schema, f"{layout.name}_too_long", layout, longer, "bad_length")
        if payload:
            yield _vector(schema, f"{layout.name}_too_short", layout, payload[:-1], "bad_length")
        for index, field in enumerate(layout.fields):
            for n, wrong in enumerate(_outside(schema, field)):
                payload = _pack(schema, layout, values | {field.name: wrong})
                name = f"{layout.name}_bad_{field.name}{n or ''}"
                yield _vector(schema, name, layout, payload, "out_of_range", bad_field=index)


def _bad_frames(schema: Schema) -> Iterator[Vector]:
    def raw(name: str, verdict: str, encoded: bytes) -> Vector:
        return {"name": name, "verdict": verdict, "frame": (encoded + b"\0").hex()}

    good = _frame(schema, 0x03, 7, b"")
    yield raw("empty", "empty", b"")
    yield raw("crc_flipped", "crc", stuff(good[:-1] + bytes([good[-1] ^ 0x10])))
    yield raw("payload_flipped", "crc", stuff(bytes([good[0] ^ 1]) + good[1:]))
    yield raw("truncated", "crc", stuff(_frame(schema, 0x3F, 7, b"\1\2\3")[:-1]))
    yield raw("truncated_to_less_than_a_frame", "framing", stuff(good[:-1]))
    yield raw("too_short", "framing", stuff(good[:5] + crc32(good[:5]).to_bytes(4, "little")))
    yield raw("one_byte", "framing", stuff(b"\x01"))
    yield raw("length_above", "framing", stuff(_frame(schema, 0x03, 7, b"\1\2", length=3)))
    yield raw("length_below", "framing", stuff(_frame(schema, 0x03, 7, b"\1\2", length=1)))
    yield raw("cobs_beyond_end", "framing", b"\xff" + good.replace(b"\0", b"\x07"))
    yield raw(
        "overrun", "overrun", stuff(_frame(schema, 0x03, 7, b"\x33" * (schema.max_payload + 1)))
    )
    unknown = Layout("unknown", "", (), 0, 0, id=0x3F)
    yield _vector(schema, "unknown_message", unknown, b"\1\2\3", "unknown_message")


def _number(field: WireField, index: int, style: str) -> int:
    least, most = integer_range(field.base)
    low = least if field.minimum is None else field.minimum
    high = most if field.maximum is None else field.maximum
    if style == "least":
        return low
    if style == "greatest":
        return max(high, *field.also, 0)
    size = INTEGER_BYTES[field.base]  # every byte another, so that swapped bytes or fields show
    pattern = sum((0x11 * (k + 1) + 7 * index) % 256 << (8 * k) for k in range(size))
    return max(low, pattern) if pattern <= high else low + pattern % (high - low + 1)


def _one(schema: Schema, field: WireField, index: int, style: str) -> Any:
    if field.kind == "bool":
        return style != "least"
    if field.kind == "struct":
        return _values(schema, schema.structs[field.base], style)
    if field.kind == "enum":
        enum = schema.enums[field.enum]
        values = sorted(v.value for v in enum.values.values())
        if enum.flags:
            return {"typical": values[-1], "least": 0, "greatest": sum(values)}[style]
        return {"typical": values[len(values) // 2], "least": values[0], "greatest": values[-1]}[
            style
        ]
    return _number(field, index, style)


def _value(schema: Schema, field: WireField, index: int, style: str) -> Any:
    if field.count is None:
        return _one(schema, field, index, style)
    if field.kind == "ascii":
        text = {"typical": f"{field.name}-{index}", "least": "", "greatest": "~" * field.count}
        return text[style][: field.count]
    some = {"typical": max(1, field.count // 3), "least": 0, "greatest": field.count}[style]
    count = some if field.bounded else field.count
    items = [_one(schema, field, index + k, style) for k in range(count)]
    return bytes(items) if field.base == "u8" and field.kind == "int" else items


def _values(schema: Schema, layout: Layout, style: str) -> dict[str, Any]:
    return {f.name: _value(schema, f, index, style) for index, f in enumerate(layout.fields)}


def _pack(schema: Schema, layout: Layout, values: dict[str, Any]) -> bytes:
    out = bytearray()
    for field in layout.fields:
        value = values[field.name]
        if field.kind == "ascii":
            value = (
                value
                if isinstance(value, bytes)
                else value.encode("ascii").ljust(field.count or 0, b"\0")
            )
        items = [value] if field.count is None else value
        if field.bounded:
            out.append(len(items))
        for item in items:
            if field.kind == "struct":
                out += _pack(schema, schema.structs[field.base], item)
            else:
                out += int(item).to_bytes(
                    INTEGER_BYTES[field.base], "little", signed=field.base[0] == "i"
                )
    return bytes(out)


def _outside(schema: Schema, field: WireField) -> Iterator[Any]:
    """Values that fit the bytes but not the field's range."""
    size = field.count or 0
    if field.kind == "ascii":
        yield b"a\nb".ljust(size, b"\0")
        yield b"a\0b".ljust(size, b"\0")
    elif field.kind == "bool":
        yield 2
    elif field.kind == "enum" and not schema.enums[field.enum].flags:
        yield max(v.value for v in schema.enums[field.enum].values.values()) + 1
    elif field.kind == "struct":
        inner = schema.structs[field.base]
        good = _values(schema, inner, "typical")
        for part in inner.fields:
            for wrong in _outside(schema, part):
                bad = good | {part.name: wrong}
                yield bad if field.count is None else [good, bad]
    else:
        wrong_values = [] if field.maximum is None else [field.maximum + 1]
        wrong_values += [] if field.minimum is None else [field.minimum - 1]
        for wrong in wrong_values:
            yield wrong if field.count is None else [wrong] * (1 if field.bounded else size)


def _as_json(values: Any) -> Any:
    if isinstance(values, dict):
        return {key: _as_json(value) for key, value in values.items()}
    if isinstance(values, list):
        return [_as_json(value) for value in values]
    return {"hex": values.hex()} if isinstance(values, bytes) else values
