"""Options of a scene as they arrive from a URL or a script: text or numbers, checked by name and range."""

from __future__ import annotations

import difflib
import math
from collections.abc import Mapping

from reliefscope.errors import InvalidInputError

OptionValue = str | float | int


class Options:
    """Options of one scene; each is fetched once, and :meth:`finish` refuses what nobody asked for."""

    def __init__(self, scene: str, values: Mapping[str, OptionValue] | None) -> None:
        self._scene = scene
        self._values = dict(values or {})
        self._known: list[str] = []

    def number(self, key: str, default: float, low: float, high: float) -> float:
        """Number within [low, high]; a default of NaN stands for "not given"."""
        self._known.append(key)
        given = self._values.pop(key, default)
        if given is default:
            return default
        try:
            value = float(given)
        except ValueError:
            value = math.nan
        if not low <= value <= high:
            raise InvalidInputError(
                f"Scene `{self._scene}`: {key}={given} is not a number from {low:g} to {high:g}.",
                hint=f"Leave {key} out for its default{'' if math.isnan(default) else f', {default:g}'}.",
            )
        return value

    def choice(self, key: str, default: str, allowed: tuple[str, ...]) -> str:
        """One of a few words."""
        self._known.append(key)
        value = str(self._values.pop(key, default))
        if value not in allowed:
            raise InvalidInputError(
                f"Scene `{self._scene}` knows no {key} `{value}`.",
                hint=f"Use one of: {', '.join(allowed)}.",
            )
        return value

    def text(self, key: str) -> str:
        """Any text; empty where it was not given."""
        self._known.append(key)
        return str(self._values.pop(key, ""))

    def finish(self) -> None:
        """Refuse options that the scene does not have."""
        for key in self._values:
            nearest = difflib.get_close_matches(key, self._known, n=1, cutoff=0.4)
            advice = f"Did you mean `{nearest[0]}`? " if nearest else ""
            known = ", ".join(self._known) if self._known else "none"
            raise InvalidInputError(
                f"Scene `{self._scene}` has no option `{key}`.",
                hint=f"{advice}Its options: {known}.",
            )
