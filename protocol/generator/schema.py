"""The checked form of protocol.yml: what the templates and the vectors are made from.

``load`` reads the file, lets pydantic check each entry, resolves names (constants, enums, structs) and checks
what only the whole can tell: ids and names are unique, types exist, bounds fit their type.  Every complaint
is a :class:`SchemaError` that says where and what is allowed.
"""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import yaml
from pydantic import BaseModel, ConfigDict, Field, ValidationError

INTEGER_BYTES = {"u8": 1, "u16": 2, "u32": 4, "u64": 8, "i8": 1, "i16": 2, "i32": 4}
HASH_BYTES = 16
REPLY_BIT = 0x80

_TYPE = re.compile(
    r"^(?P<base>[A-Za-z][A-Za-z0-9]*)(?:\[(?P<bounded><=)?(?P<count>[A-Z0-9_]+)\])?$"
)
_TERM = re.compile(r"^(?P<name>[A-Z][A-Z0-9_]*)(?P<less>-1)?$")


class SchemaError(Exception):
    """protocol.yml says something that cannot be generated; the text names the place."""


class _Entry(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)
    description: str = Field(min_length=3)


class Constant(_Entry):
    """A number that both sides know."""

    value: int


class EnumValue(_Entry):
    """One value; ``cause`` and ``next_step`` only in enums of errors."""

    value: int = Field(ge=0)
    cause: str = ""
    next_step: str = ""


class EnumDef(_Entry):
    """An enum: a choice, or with ``flags`` a set of bits."""

    type: Literal["u8", "u16", "u32"]
    values: dict[str, EnumValue] = Field(min_length=1)
    flags: bool = False
    errors: bool = False


class FieldDef(_Entry):
    """One field as written; ``type`` and bounds are still text."""

    name: str = Field(pattern=r"^[a-z][a-z0-9_]*$")
    type: str
    unit: str = ""
    min: int | str | None = None
    max: int | str | None = None
    also: tuple[int, ...] = ()


class StructDef(_Entry):
    """A group of fields that messages carry."""

    fields: list[FieldDef]
    frozen: bool = False


class ExchangeDef(_Entry):
    """A request and its own reply."""

    name: str = Field(pattern=r"^[a-z][a-z0-9_]*$")
    id: int = Field(ge=0x01, le=0x3F)
    frozen: bool = False
    ring: bool = True
    request: list[FieldDef]
    reply: list[FieldDef]


class EventDef(_Entry):
    """A message that the device sends unasked."""

    name: str = Field(pattern=r"^[a-z][a-z0-9_]*$")
    id: int = Field(ge=0x40, le=0x7F)
    fields: list[FieldDef]


class RefusalDef(_Entry):
    """The id of a refusal."""

    id: int = Field(ge=0xC0, le=0xFF)


class RefusalsDef(BaseModel):
    """The two refusals, which share their fields."""

    model_config = ConfigDict(extra="forbid", frozen=True)
    rejected: RefusalDef
    failed: RefusalDef
    fields: list[FieldDef]


class _Info(_Entry):
    name: str
    version: int = Field(ge=1)


class _File(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)
    protocol: _Info
    constants: dict[str, Constant]
    enums: dict[str, EnumDef]
    structs: dict[str, StructDef]
    exchanges: list[ExchangeDef]
    refusals: RefusalsDef
    events: list[EventDef]


@dataclass(frozen=True)
class WireField:
    """A field with its type resolved.

    ``kind`` is "int", "bool", "enum", "struct" or "ascii"; ``base`` the scalar on the wire, or the struct's
    name; ``count`` the number of elements (None: a single one), fixed or, if ``bounded``, at most.
    """

    name: str
    description: str
    unit: str
    kind: str
    base: str
    enum: str
    count: int | None
    bounded: bool
    minimum: int | None
    maximum: int | None
    also: tuple[int, ...]

    @property
    def type_text(self) -> str:
        """The type as protocol.yml writes it, constants replaced by their numbers."""
        name = "ascii" if self.kind == "ascii" else self.enum or self.base
        if self.count is None:
            return name
        return f"{name}[{'<=' if self.bounded else ''}{self.count}]"

    @property
    def range_text(self) -> str:
        """The allowed values for the documentation."""
        if self.minimum is None and self.maximum is None:
            return ""
        least, most = integer_range(self.base)
        low = least if self.minimum is None else self.minimum
        high = most if self.maximum is None else self.maximum
        return " or ".join([f"{low}..{high}", *map(str, self.also)])


@dataclass(frozen=True)
class Layout:
    """A message or struct: its fields and how many bytes they take."""

    name: str
    description: str
    fields: tuple[WireField, ...]
    min_size: int
    max_size: int
    id: int = -1
    kind: str = "struct"
    exchange: str = ""
    ring: bool = False
    frozen: bool = False

    @property
    def class_name(self) -> str:
        """``load_light_request`` to ``LoadLightRequest``."""
        return (
            "".join(part.capitalize() for part in self.name.split("_"))
            if self.id >= 0
            else self.name
        )


@dataclass(frozen=True)
class Schema:
    """Everything, resolved, in the order of the file."""

    info: _Info
    constants: dict[str, Constant]
    enums: dict[str, EnumDef]
    structs: dict[str, Layout]
    exchanges: list[ExchangeDef]
    messages: tuple[Layout, ...]
    hash: bytes

    @property
    def header(self) -> Layout:
        """Head of every frame."""
        return self.structs["Header"]

    @property
    def max_payload(self) -> int:
        """Size of the largest payload in bytes."""
        return max(message.max_size for message in self.messages)

    @property
    def max_ring_reply(self) -> int:
        """Size of the largest answer that the completion ring keeps."""
        kept = (m for m in self.messages if m.ring or m.kind == "refusal")
        return max(m.max_size for m in kept if m.kind != "request")

    @property
    def max_event(self) -> int:
        """Size of the largest event."""
        return max(m.max_size for m in self.messages if m.kind == "event")


def load(path: Path) -> Schema:
    """Read and check a definition.

    Raises
    ------
    SchemaError
        With one line per complaint: where in the file, and what is wrong.
    """
    try:
        file = _File.model_validate(yaml.safe_load(path.read_text(encoding="utf-8")))
    except yaml.YAMLError as error:
        raise SchemaError(f"{path.name} is not YAML: {error}") from error
    except ValidationError as error:
        lines = [f"{'.'.join(map(str, e['loc']))}: {e['msg']}" for e in error.errors()]
        raise SchemaError("\n".join(lines)) from error
    return _Resolver(file).schema()


class _Resolver:
    def __init__(self, file: _File) -> None:
        self.file = file
        self.structs: dict[str, Layout] = {}

    def schema(self) -> Schema:
        for name, enum in self.file.enums.items():
            self._check_enum(name, enum)
        for name, struct in self.file.structs.items():
            self.structs[name] = self._layout(name, struct.description, struct.fields)
        if "Header" not in self.structs:
            raise SchemaError("structs: Header is missing; every frame begins with it")
        messages = tuple(self._messages())
        _unique("message id", [(m.id, m.name) for m in messages])
        _unique("message name", [(m.name, m.name) for m in messages])
        file = self.file
        digest = hashlib.sha256(_on_the_wire(file, self.structs, messages).encode()).digest()
        return Schema(
            file.protocol,
            file.constants,
            file.enums,
            self.structs,
            file.exchanges,
            messages,
            digest[:HASH_BYTES],
        )

    def _messages(self) -> Iterator[Layout]:
        for e in self.file.exchanges:
            request, reply = f"{e.name}_request", f"{e.name}_reply"
            extra = {"exchange": e.name, "ring": e.ring, "frozen": e.frozen}
            yield self._layout(request, e.description, e.request, id=e.id, kind="request", **extra)
            text = f"Answer to {e.name}: what was set or found."
            yield self._layout(reply, text, e.reply, id=e.id | REPLY_BIT, kind="reply", **extra)
        refusals = self.file.refusals
        for name, refusal in (("rejected", refusals.rejected), ("failed", refusals.failed)):
            yield self._layout(
                name, refusal.description, refusals.fields, id=refusal.id, kind="refusal"
            )
        for event in self.file.events:
            yield self._layout(
                f"{event.name}_event", event.description, event.fields, id=event.id, kind="event"
            )

    def _check_enum(self, name: str, enum: EnumDef) -> None:
        _unique(f"value of {name}", [(v.value, key) for key, v in enum.values.items()])
        limit = 256 ** INTEGER_BYTES[enum.type]
        for key, value in enum.values.items():
            where = f"enums.{name}.{key}"
            if value.value >= limit:
                raise SchemaError(f"{where}: {value.value} does not fit {enum.type}")
            if enum.flags and value.value.bit_count() != 1:
                raise SchemaError(f"{where}: {value.value} is not a single bit")
            if enum.errors and not (value.cause and value.next_step):
                raise SchemaError(f"{where}: an error needs a cause and a next_step")

    def _layout(self, name: str, description: str, fields: list[FieldDef], **extra: Any) -> Layout:
        wire = tuple(self._field(f"{name}.{field.name}", field) for field in fields)
        _unique(f"field of {name}", [(f.name, f.name) for f in wire])
        least = sum(self._sizes(f)[0] for f in wire)
        most = sum(self._sizes(f)[1] for f in wire)
        return Layout(name, description, wire, least, most, **extra)

    def _sizes(self, field: WireField) -> tuple[int, int]:
        one = (
            self.structs[field.base].max_size
            if field.kind == "struct"
            else INTEGER_BYTES[field.base]
        )
        if field.bounded:
            return 1, 1 + one * (field.count or 0)
        return (one * (field.count or 1),) * 2

    def _field(self, where: str, field: FieldDef) -> WireField:
        match = _TYPE.match(field.type)
        if not match:
            raise SchemaError(
                f"{where}: cannot read type {field.type!r}; examples: u16, u8[4], Step[<=16]"
            )
        count = self._number(where, match["count"]) if match["count"] else None
        if count is not None and not 1 <= count <= (255 if match["bounded"] else 65535):
            raise SchemaError(f"{where}: {count} elements are not possible")
        kind, base, enum = self._base(where, match["base"])
        if kind == "ascii" and (count is None or match["bounded"]):
            raise SchemaError(f"{where}: ascii needs a fixed size, as in ascii[16]")
        if kind == "struct" and any(f.bounded for f in self.structs[base].fields):
            raise SchemaError(f"{where}: a struct in a message must have a fixed size")
        if kind == "bool" and count is not None:
            raise SchemaError(f"{where}: no arrays of bool; use an enum with flags")
        low, high = self._number(where, field.min), self._number(where, field.max)
        self._check_bounds(where, kind, base, low, high)
        if base in INTEGER_BYTES:  # a bound that the type itself sets is no bound
            least, most = integer_range(base)
            low, high = None if low == least else low, None if high == most else high
        return WireField(
            field.name,
            field.description,
            field.unit,
            kind,
            base,
            enum,
            count,
            bool(match["bounded"]),
            low,
            high,
            field.also,
        )

    def _base(self, where: str, name: str) -> tuple[str, str, str]:
        if name in INTEGER_BYTES:
            return "int", name, ""
        if name == "bool":
            return "bool", "u8", ""
        if name == "ascii":
            return "ascii", "u8", ""
        if name in self.file.enums:
            return "enum", self.file.enums[name].type, name
        if name in self.structs:
            return "struct", name, ""
        known = [*INTEGER_BYTES, "bool", "ascii", *self.file.enums, *self.structs]
        raise SchemaError(f"{where}: unknown type {name!r}; known are {', '.join(known)}")

    def _number(self, where: str, text: int | str | None) -> int | None:
        if text is None or isinstance(text, int):
            return text
        if text.isdigit():
            return int(text)
        match = _TERM.match(text)
        if not match or match["name"] not in self.file.constants:
            raise SchemaError(
                f"{where}: {text!r} is neither a number nor a constant (or a constant and -1)"
            )
        return self.file.constants[match["name"]].value - (1 if match["less"] else 0)

    def _check_bounds(
        self, where: str, kind: str, base: str, low: int | None, high: int | None
    ) -> None:
        if low is None and high is None:
            return
        if kind != "int":
            raise SchemaError(f"{where}: only integers have min and max")
        least, most = integer_range(base)
        if not least <= (least if low is None else low) <= (most if high is None else high) <= most:
            raise SchemaError(f"{where}: min and max must be ordered and fit {base}")


def integer_range(base: str) -> tuple[int, int]:
    """Least and greatest value of an integer type."""
    bits = 8 * INTEGER_BYTES[base]
    return (-(1 << (bits - 1)), (1 << (bits - 1)) - 1) if base[0] == "i" else (0, (1 << bits) - 1)


def _unique(what: str, pairs: list[tuple[Any, str]]) -> None:
    seen: dict[Any, str] = {}
    for key, name in pairs:
        if key in seen:
            raise SchemaError(f"{what} {key!r} is given twice: by {seen[key]} and by {name}")
        seen[key] = name


def _on_the_wire(file: _File, structs: dict[str, Layout], messages: tuple[Layout, ...]) -> str:
    """Canonical text of what changes bytes or their meaning: no descriptions, causes or order of definition."""

    def fields(layout: Layout) -> list[Any]:
        return [[f.name, f.type_text, f.unit, f.minimum, f.maximum, f.also] for f in layout.fields]

    return json.dumps(
        {
            "version": file.protocol.version,
            "constants": {name: c.value for name, c in file.constants.items()},
            "enums": {
                name: [e.type, e.flags, {key: v.value for key, v in e.values.items()}]
                for name, e in file.enums.items()
            },
            "structs": {name: fields(s) for name, s in structs.items()},
            "messages": {m.name: [m.id, m.ring, fields(m)] for m in messages},
        },
        sort_keys=True,
        separators=(",", ":"),
    )
