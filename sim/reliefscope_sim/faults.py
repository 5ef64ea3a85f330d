"""Faults on request: what goes wrong, where, and how often, drawn from a seed.

Grammar: ``fault=NAME:VALUE[,NAME:VALUE...]``, names as in :data:`KNOWN`.  Exposures are counted as trigger
pulses since the bench was switched on, from 0.  A fault that happens at an exposure takes its number, once or
several times, or ``P%``: then it happens at each exposure with that probability.  Faults of parts take the
number of the part, or ``P%`` of them.  Example: ``fault=link_loss:0.05,camera_drop:3,camera_late:2%``.
"""

from __future__ import annotations

import difflib
import random
from collections.abc import Iterator
from dataclasses import dataclass, field

from reliefscope.errors import InvalidInputError

RATES = {
    "link_loss": "rate at which whole frames on the link vanish, each way",
    "link_drop": "rate at which single bytes on the link vanish, each way",
    "link_flip": "rate at which bytes on the link get one bit flipped, each way",
    "link_duplicate": "rate at which frames on the link arrive twice, each way",
}
AMOUNTS = {
    "link_delay": "longest delay in ms of a frame from the device; each gets its own",
    "camera_late_ms": "how late the frames of camera_late are, in ms (default: 500)",
}
AT_EXPOSURES = {
    "link_loss_at": "exposure after which the next frame from the device is lost",
    "link_flip_at": "exposure after which the next frame from the device has one bit flipped",
    "link_duplicate_at": "exposure after which the next frame from the device arrives twice",
    "link_cut": "exposure at which the link breaks; opening the port again mends it",
    "reset_at": "exposure in the middle of which the device's reset line is pulled",
    "brown_out_at": "exposure in the middle of which the supply fails for 5 ms, the glass's too",
    "watchdog_at": "exposure in the middle of which the firmware hangs until its watchdog restarts it",
    "stall_at": "exposure at which the device stops dead, its outputs as they are",
    "camera_drop": "exposure whose frame is lost",
    "camera_late": "exposure whose frame comes late, and all behind it; see camera_late_ms",
    "camera_duplicate": "exposure whose frame is delivered twice",
    "camera_torn": "exposure whose frame lacks its lower rows",
    "camera_unplug": "exposure from which on the camera is gone",
}
PARTS = {
    "led_dead": "LED that never lights",
    "led_stuck": "LED that is always on, at full level",
    "lcd_column": "column of the glass, from the left, whose line is broken",
}
PARTS_FROM = "parts_from"
KNOWN = {
    **RATES,
    **AMOUNTS,
    **AT_EXPOSURES,
    **PARTS,
    PARTS_FROM: "exposure from which on the faults of parts hold (default: from the start)",
}
DEFAULT_LATE_MS = 500.0
_NUMBERS: frozenset[int] = frozenset()


@dataclass(frozen=True, slots=True)
class Place:
    """Where something happens: at these numbers, and elsewhere with this probability."""

    numbers: frozenset[int] = _NUMBERS
    rate: float = 0.0


@dataclass(frozen=True, slots=True)
class Faults:
    """What was asked for; no fault by default.  Whether it happens is drawn from ``seed`` and the place alone."""

    rates: dict[str, float] = field(default_factory=dict)
    amounts: dict[str, float] = field(default_factory=dict)
    places: dict[str, Place] = field(default_factory=dict)
    seed: int = field(default=1, compare=False)

    @classmethod
    def parse(cls, text: str, seed: int = 1) -> Faults:
        """Faults named by the text of a URL's ``fault=``.

        Raises
        ------
        InvalidInputError
            If a name is unknown or a value is not of its kind; names the known ones.
        """
        made = cls(seed=seed)
        for item in filter(None, text.split(",")):
            name, _, value = item.partition(":")
            if name not in KNOWN:
                raise _unknown(name)
            if name in RATES:
                made.rates[name] = _rate(name, value)
            elif name in AMOUNTS:
                made.amounts[name] = _number(name, value)
            else:
                before = made.places.get(name, Place())
                if value.endswith("%"):
                    made.places[name] = Place(before.numbers, _rate(name, value))
                else:
                    numbers = before.numbers | {_whole(name, value)}
                    made.places[name] = Place(numbers, before.rate)
        return made

    def strikes(self, name: str, number: int) -> bool:
        """Whether the fault ``name`` happens at exposure, or to part, ``number``."""
        place = self.places.get(name)
        if place is None:
            return False
        if number in place.numbers:
            return True
        return bool(place.rate) and self.draw(name, number) < place.rate

    def draw(self, name: str, number: int) -> float:
        """Number from 0 to 1, always the same one for a seed, a fault and a place."""
        return random.Random(f"{self.seed}-{name}-{number}").random()

    def rate(self, name: str) -> float:
        """Probability of a fault of the link."""
        return self.rates.get(name, 0.0)

    @property
    def link_delay_us(self) -> int:
        """Longest delay of a frame from the device."""
        return round(self.amounts.get("link_delay", 0.0) * 1000)

    @property
    def camera_late_us(self) -> int:
        """Delay of a late frame of the camera."""
        return round(self.amounts.get("camera_late_ms", DEFAULT_LATE_MS) * 1000)

    @property
    def parts_from(self) -> int:
        """Exposure from which on the faults of parts hold."""
        return min(self.places.get(PARTS_FROM, Place()).numbers, default=0)

    @property
    def on_the_link(self) -> bool:
        """Whether bytes can be lost, changed or late."""
        placed = any(name in self.places for name in _LINK_PLACES)
        return placed or any(self.rates.values()) or self.link_delay_us > 0


def _number(name: str, value: str) -> float:
    try:
        number = float(value)
    except ValueError:
        number = -1.0
    if not 0 <= number < float("inf"):
        raise InvalidInputError(
            f"Fault `{name}` has no valid value: {value!r}.",
            hint=f"Write `fault={name}:NUMBER`; {name}: {KNOWN[name]}.",
        )
    return number


def _rate(name: str, value: str) -> float:
    percent = value.endswith("%")
    number = _number(name, value.removesuffix("%")) / (100 if percent else 1)
    if number > 1:
        raise InvalidInputError(
            f"The rate of fault `{name}` is {value}, more than 1.",
            hint=f"Give a probability, as in `fault={name}:{'5%' if percent else '0.05'}`.",
        )
    return number


def _whole(name: str, value: str) -> int:
    number = _number(name, value)
    if number != int(number):
        raise InvalidInputError(
            f"Fault `{name}` wants a whole number, not {value}.",
            hint=f"Give a number from 0 on, as in `fault={name}:3`, or a rate, as in `fault={name}:5%`.",
        )
    return int(number)


def _unknown(name: str) -> InvalidInputError:
    nearest = difflib.get_close_matches(name, KNOWN, n=1)
    advice = f"Did you mean `{nearest[0]}`? " if nearest else ""
    if name.startswith("disk"):
        advice = (
            "A full or slow disk is made by the system: see the page on the simulated instrument. "
        )
    return InvalidInputError(
        f"There is no fault `{name}`.", hint=f"{advice}Known faults: {', '.join(KNOWN)}."
    )


_LINK_PLACES = ("link_loss_at", "link_flip_at", "link_duplicate_at")


class FaultyWire:
    """One direction of the link: bytes in, and what arrives when.

    A frame is everything up to and including a zero byte, as the link's framing has it.  Frames keep their
    order: one that is late holds up those behind it.
    """

    def __init__(self, faults: Faults, seed: str, *, delays: bool) -> None:
        self._faults = faults
        self._random = random.Random(seed)
        self._delay_us = faults.link_delay_us if delays else 0
        self._inside_frame = False
        self._lost = False
        self._twice = False
        self._flip_first = False
        self._frame_delay_us = 0
        self._frame = bytearray()
        self._arrives_us = 0
        self._struck: set[str] = set()

    def strike(self, exposure: int) -> None:
        """An exposure began: faults that are placed there wait for the next frame."""
        self._struck |= {name for name in _LINK_PLACES if self._faults.strikes(name, exposure)}

    def feed(self, time_us: int, data: bytes) -> list[tuple[int, bytes]]:
        """(arrival time in us, bytes) of what comes out for ``data``, in order."""
        if not self._faults.on_the_link:
            return [(time_us, data)]
        return list(self._arrivals(time_us, data))

    def _arrivals(self, time_us: int, data: bytes) -> Iterator[tuple[int, bytes]]:
        for piece in _frames(data):
            if not self._inside_frame:
                self._draw(alone=piece == b"\0")
            self._inside_frame = piece[-1] != 0
            if self._lost:
                continue
            passed = self._damage(piece)
            self._frame += passed
            self._arrives_us = max(self._arrives_us, time_us + self._frame_delay_us)
            if passed:
                yield self._arrives_us, passed
            if not self._inside_frame and self._twice:
                yield self._arrives_us, bytes(self._frame)

    def _draw(self, *, alone: bool) -> None:
        """What happens to the frame that begins; a delimiter alone is none that a placed fault waits for."""
        draw = self._random.random
        self._lost = draw() < self._faults.rate("link_loss")
        self._twice = draw() < self._faults.rate("link_duplicate")
        self._frame_delay_us = round(draw() * self._delay_us)
        self._frame.clear()
        if self._struck and not alone:
            self._lost |= "link_loss_at" in self._struck
            self._twice |= "link_duplicate_at" in self._struck
            self._flip_first = "link_flip_at" in self._struck
            self._struck.clear()

    def _damage(self, data: bytes) -> bytes:
        if self._flip_first:
            self._flip_first = False
            # A bit that leaves the byte unlike the delimiter, so that the frame stays one frame.
            data = bytes([data[0] ^ (2 if data[0] != 2 else 4)]) + data[1:]
        draw = self._random.random
        drop, flip = self._faults.rate("link_drop"), self._faults.rate("link_flip")
        if not (drop or flip):
            return data
        out = bytearray()
        for byte in data:
            if draw() < drop:
                continue
            flipped = draw() < flip
            out.append(byte ^ (1 << self._random.randrange(8)) if flipped else byte)
        return bytes(out)


def _frames(data: bytes) -> list[bytes]:
    """Pieces of ``data`` that end with a zero byte, and the rest."""
    pieces = [piece + b"\0" for piece in data.split(b"\0")]
    pieces[-1] = pieces[-1][:-1]
    return [piece for piece in pieces if piece]
