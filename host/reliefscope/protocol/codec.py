"""Behaviour of the generated wire messages: packing, unpacking and range checks.

A message class is a frozen dataclass whose fields are annotated with :class:`Wire`.  Payloads are little-endian
without padding.  A message that exists is valid: ranges are checked when it is made, whether by the host or from
received bytes.
"""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from enum import Enum, IntEnum
from typing import Annotated, Any, ClassVar, Generic, Self, TypeVar, cast, get_args, get_origin

from reliefscope.errors import DeviceError, InvalidInputError

_INTEGERS = {name: (size, name[0] == "i") for name, size in (
    ("u8", 1), ("u16", 2), ("u32", 4), ("u64", 8), ("i8", 1), ("i16", 2), ("i32", 4)
)}  # fmt: skip


class FieldRangeError(InvalidInputError, ValueError):
    """A field of a message is outside what the protocol allows; nothing was sent."""


class PayloadError(DeviceError, ValueError):
    """Received bytes are not a valid payload of the message that they claim to be."""


class WireEnum(IntEnum):
    """An enum on the wire whose members explain themselves.

    ``description`` says what a value means; errors also have a likely ``cause`` and a ``next_step``.
    """

    description: str
    cause: str
    next_step: str

    def __new__(
        cls, value: int, description: str = "", cause: str = "", next_step: str = ""
    ) -> Self:
        """Make a member from its value and its explanations."""
        member = int.__new__(cls, value)
        member._value_ = value
        member.description, member.cause, member.next_step = description, cause, next_step
        return member

    @classmethod
    def _missing_(cls, value: object) -> Enum | None:
        # A later firmware may know more reasons; HELLO must stay readable across any version.
        return cls.__members__.get("UNKNOWN") if isinstance(value, int) else None


@dataclass(frozen=True, slots=True)
class Wire:
    """How one field travels, and what it means.

    ``kind`` is "int", "bool", "enum", "struct" or "ascii"; ``base`` the integer on the wire ("u16"), or the
    struct's name; ``of`` the enum or struct class.  ``count`` elements are fixed, or, if ``bounded``, at most
    that many after a count byte.  ``minimum`` and ``maximum`` are inclusive; ``also`` are allowed besides.
    """

    kind: str
    base: str
    description: str
    unit: str = ""
    of: type[Any] | None = None
    count: int | None = None
    bounded: bool = False
    minimum: int | None = None
    maximum: int | None = None
    also: tuple[int, ...] = ()

    @property
    def limits(self) -> tuple[int, int]:
        """Least and greatest value (without ``also``) of an integer field."""
        size, signed = _INTEGERS[self.base]
        least, most = (
            (-(1 << (8 * size - 1)), (1 << (8 * size - 1)) - 1)
            if signed
            else (0, (1 << 8 * size) - 1)
        )
        return (
            least if self.minimum is None else self.minimum,
            most if self.maximum is None else self.maximum,
        )


class Struct:
    """Base of everything that has a wire form."""

    __slots__ = ()

    def __post_init__(self) -> None:
        for name, wire in wire_fields(type(self)).items():
            problem = _problem(wire, getattr(self, name))
            if problem:
                raise FieldRangeError(
                    f"{type(self).__name__}.{name} {problem}.",
                    hint=f"{name}: {wire.description}",
                )

    def pack(self) -> bytes:
        """The payload."""
        out = bytearray()
        for name, wire in wire_fields(type(self)).items():
            _put(out, wire, getattr(self, name))
        return bytes(out)

    @classmethod
    def unpack(cls, payload: bytes) -> Self:
        """Read a whole payload.

        Raises
        ------
        PayloadError
            If its length does not fit or a value is outside its range.
        """
        reader = _Reader(payload)
        try:
            message = cls._read(reader)
        except (FieldRangeError, ValueError) as error:
            if isinstance(error, PayloadError):
                raise
            raise PayloadError(f"Received an invalid {cls.__name__}: {error}") from error
        if reader.position != len(payload):
            raise PayloadError(
                f"Received a {cls.__name__} of {len(payload)} bytes, expected {reader.position}."
            )
        return message

    @classmethod
    def _read(cls, reader: _Reader) -> Self:
        return cls(**{name: _get(reader, wire) for name, wire in wire_fields(cls).items()})


class Message(Struct):
    """A message: a struct with an id."""

    __slots__ = ()
    ID: ClassVar[int]
    NAME: ClassVar[str]


R = TypeVar("R", bound=Message)


class Request(Message, Generic[R]):
    """A message to the device; ``REPLY`` is the class of its answer, ``R`` the same for the type checker."""

    __slots__ = ()
    REPLY: ClassVar[type[Message]]
    RING: ClassVar[bool]

    def read_reply(self, payload: bytes) -> R:
        """Read the payload of this request's reply."""
        return cast(R, self.REPLY.unpack(payload))


class Reply(Message):
    """Answer of the device: what was set or found."""

    __slots__ = ()


class Refusal(Message):
    """The device did not do what was asked."""

    __slots__ = ()


class Event(Message):
    """A message that the device sends unasked."""

    __slots__ = ()


_FIELDS: dict[type[Any], dict[str, Wire]] = {}


def wire_fields(cls: type[Any]) -> dict[str, Wire]:
    """Fields of a message class in the order of the wire."""
    found = _FIELDS.get(cls)
    if found is None:
        found = _FIELDS[cls] = {
            field.name: next(a for a in get_args(field.type) if isinstance(a, Wire))
            for field in dataclasses.fields(cls)
            if get_origin(field.type) is Annotated
        }
    return found


class _Reader:
    def __init__(self, data: bytes) -> None:
        self.data = data
        self.position = 0

    def take(self, size: int) -> bytes:
        chunk = self.data[self.position : self.position + size]
        if len(chunk) < size:
            raise PayloadError(f"Received a payload of {len(self.data)} bytes that ends too early.")
        self.position += size
        return chunk


def _problem(wire: Wire, value: Any) -> str:
    """What is wrong with a value, or nothing."""
    if wire.kind == "ascii":
        text = str(value)
        if not all(" " <= c <= "~" for c in text):
            return f"is {text!r}; only printable ASCII is possible"
        return f"is longer than {wire.count} characters" if len(text) > (wire.count or 0) else ""
    if wire.count is None:
        return _problem_of_one(wire, value)
    if len(value) > wire.count or (len(value) < wire.count and not wire.bounded):
        return f"has {len(value)} elements, not {'at most ' if wire.bounded else ''}{wire.count}"
    return next((p for p in (_problem_of_one(wire, item) for item in value) if p), "")


def _problem_of_one(wire: Wire, value: Any) -> str:
    if wire.kind in {"struct", "bool"}:
        expected = wire.of or bool
        return "" if isinstance(value, expected) else f"is {value!r}, not a {expected.__name__}"
    if wire.kind == "enum" and wire.of is not None and issubclass(wire.of, WireEnum):
        return "" if isinstance(value, wire.of) else f"is {value!r}, not a {wire.of.__name__}"
    low, high = wire.limits
    if value in wire.also or low <= value <= high:
        return ""
    allowed = " or ".join([f"{low} to {high}", *map(str, wire.also)])
    return f"is {value}{' ' + wire.unit if wire.unit else ''}; allowed are {allowed}"


def _put(out: bytearray, wire: Wire, value: Any) -> None:
    if wire.kind == "ascii":
        out += value.encode("ascii").ljust(wire.count or 0, b"\0")
        return
    items = [value] if wire.count is None else value
    if wire.bounded:
        out.append(len(items))
    if wire.kind == "struct":
        for item in items:
            out += item.pack()
        return
    size, signed = _INTEGERS[wire.base]
    for item in items:
        out += int(item).to_bytes(size, "little", signed=signed)


def _get(reader: _Reader, wire: Wire) -> Any:
    if wire.kind == "ascii":
        text, _, padding = reader.take(wire.count or 0).partition(b"\0")
        if padding.strip(b"\0"):
            raise PayloadError("Received a text with something behind its end.")
        return text.decode("ascii")
    if wire.count is None:
        return _get_one(reader, wire)
    count = reader.take(1)[0] if wire.bounded else wire.count
    if count > wire.count:
        raise PayloadError(f"Received {count} elements where {wire.count} are the most.")
    if wire.kind == "int" and wire.base == "u8":
        return reader.take(count)
    return tuple(_get_one(reader, wire) for _ in range(count))


def _get_one(reader: _Reader, wire: Wire) -> Any:
    if wire.kind == "struct" and wire.of is not None:
        return wire.of._read(reader)
    size, signed = _INTEGERS[wire.base]
    number = int.from_bytes(reader.take(size), "little", signed=signed)
    if wire.kind == "bool":
        if number > 1:
            raise PayloadError(f"Received {number} where only 0 and 1 are possible.")
        return bool(number)
    return wire.of(number) if wire.of is not None else number
