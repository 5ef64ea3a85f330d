"""Faults on request: what goes wrong, where, and how often, drawn from a seed.

Grammar: ``fault=NAME:VALUE[,NAME:VALUE...]``, names as in :data:`KNOWN`.  Rates are probabilities from 0 to 1;
numbers of exposures count the trigger pulses since the bench was switched on, from 0, and may be given more
than once.  Example: ``fault=link_loss:0.05,camera_drop:3,camera_drop:9``.
"""

from __future__ import annotations

import difflib
import random
from dataclasses import dataclass

from reliefscope.errors import InvalidInputError

KNOWN = {
    "link_loss": "rate at which whole frames on the link vanish, each way",
    "link_drop": "rate at which single bytes on the link vanish, each way",
    "link_flip": "rate at which bytes on the link get one bit flipped, each way",
    "link_duplicate": "rate at which frames on the link arrive twice, each way",
    "link_delay": "longest delay in ms of a frame from the device; each gets its own",
    "link_cut": "exposure at which the link breaks; opening the port again mends it",
    "reset_at": "exposure in the middle of which the device browns out and starts again",
    "stall_at": "exposure at which the device stops dead, its outputs as they are",
    "camera_drop": "exposure whose frame is lost",
    "camera_unplug": "exposure from which on the camera is gone",
}
_RATES = {"link_loss", "link_drop", "link_flip", "link_duplicate"}


@dataclass(frozen=True, slots=True)
class Faults:
    """What was asked for; no fault by default."""

    link_loss: float = 0.0
    link_drop: float = 0.0
    link_flip: float = 0.0
    link_duplicate: float = 0.0
    link_delay_us: int = 0
    link_cut: frozenset[int] = frozenset()
    reset_at: frozenset[int] = frozenset()
    stall_at: frozenset[int] = frozenset()
    camera_drop: frozenset[int] = frozenset()
    camera_unplug: frozenset[int] = frozenset()

    @classmethod
    def parse(cls, text: str) -> Faults:
        """Faults named by the text of a URL's ``fault=``.

        Raises
        ------
        InvalidInputError
            If a name is unknown or a value is not of its kind; names the known ones.
        """
        rates: dict[str, float] = {}
        delay_us = 0
        exposures: dict[str, set[int]] = {}
        for item in filter(None, text.split(",")):
            name, _, value = item.partition(":")
            if name not in KNOWN:
                raise _unknown(name)
            number = _number(name, value)
            if name in _RATES:
                if number > 1:
                    raise InvalidInputError(
                        f"The rate of fault `{name}` is {value}, more than 1.",
                        hint=f"Give a probability from 0 to 1, as in `fault={name}:0.05`.",
                    )
                rates[name] = number
            elif name == "link_delay":
                delay_us = round(number * 1000)
            elif number != int(number):
                raise InvalidInputError(
                    f"Fault `{name}` wants a whole number, not {value}.",
                    hint=f"Give the number of an exposure from 0 on, as in `fault={name}:3`.",
                )
            else:
                exposures.setdefault(name, set()).add(int(number))
        places = {name: frozenset(numbers) for name, numbers in exposures.items()}
        nowhere: frozenset[int] = frozenset()
        return cls(
            link_loss=rates.get("link_loss", 0.0),
            link_drop=rates.get("link_drop", 0.0),
            link_flip=rates.get("link_flip", 0.0),
            link_duplicate=rates.get("link_duplicate", 0.0),
            link_delay_us=delay_us,
            link_cut=places.get("link_cut", nowhere),
            reset_at=places.get("reset_at", nowhere),
            stall_at=places.get("stall_at", nowhere),
            camera_drop=places.get("camera_drop", nowhere),
            camera_unplug=places.get("camera_unplug", nowhere),
        )

    @property
    def on_the_link(self) -> bool:
        """Whether bytes can be lost, changed or late."""
        return bool(
            self.link_loss
            or self.link_drop
            or self.link_flip
            or self.link_duplicate
            or self.link_delay_us
        )


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


def _unknown(name: str) -> InvalidInputError:
    nearest = difflib.get_close_matches(name, KNOWN, n=1)
    advice = f"Did you mean `{nearest[0]}`? " if nearest else ""
    return InvalidInputError(
        f"There is no fault `{name}`.", hint=f"{advice}Known faults: {', '.join(KNOWN)}."
    )


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
        self._frame_delay_us = 0
        self._frame = bytearray()
        self._arrives_us = 0

    def feed(self, time_us: int, data: bytes) -> list[tuple[int, bytes]]:
        """(arrival time in us, bytes) of what comes out for ``data``, in order."""
        if not self._faults.on_the_link:
            return [(time_us, data)]
        arrivals = []
        for piece in _frames(data):
            if not self._inside_frame:
                self._draw()
            self._inside_frame = piece[-1] != 0
            if self._lost:
                continue
            passed = self._damage(piece)
            self._frame += passed
            self._arrives_us = max(self._arrives_us, time_us + self._frame_delay_us)
            if passed:
                arrivals.append((self._arrives_us, passed))
            if not self._inside_frame and self._twice:
                arrivals.append((self._arrives_us, bytes(self._frame)))
        return arrivals

    def _draw(self) -> None:
        draw = self._random.random
        self._lost = draw() < self._faults.link_loss
        self._twice = draw() < self._faults.link_duplicate
        self._frame_delay_us = round(draw() * self._delay_us)
        self._frame.clear()

    def _damage(self, data: bytes) -> bytes:
        draw = self._random.random
        if not (self._faults.link_drop or self._faults.link_flip):
            return data
        out = bytearray()
        for byte in data:
            if draw() < self._faults.link_drop:
                continue
            flipped = draw() < self._faults.link_flip
            out.append(byte ^ (1 << self._random.randrange(8)) if flipped else byte)
        return bytes(out)


def _frames(data: bytes) -> list[bytes]:
    """Pieces of ``data`` that end with a zero byte, and the rest."""
    pieces = [piece + b"\0" for piece in data.split(b"\0")]
    pieces[-1] = pieces[-1][:-1]
    return [piece for piece in pieces if piece]
