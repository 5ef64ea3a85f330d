"""Least-recently-used store with a limit in bytes."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Hashable
from typing import Generic, TypeVar

ValueT = TypeVar("ValueT")


class ByteCache(Generic[ValueT]):
    """Keeps computed values until together they exceed ``limit_bytes``; the newest always stays."""

    def __init__(self, limit_bytes: int, size_of: Callable[[ValueT], int]) -> None:
        self.limit_bytes = limit_bytes
        self.held_bytes = 0
        self._size_of = size_of
        self._values: OrderedDict[Hashable, ValueT] = OrderedDict()

    def get(self, key: Hashable, compute: Callable[[], ValueT]) -> ValueT:
        """Value of ``key``, computed where it is not held."""
        if key in self._values:
            self._values.move_to_end(key)
            return self._values[key]
        value = compute()
        self._values[key] = value
        self.held_bytes += self._size_of(value)
        while self.held_bytes > self.limit_bytes and len(self._values) > 1:
            _, oldest = self._values.popitem(last=False)
            self.held_bytes -= self._size_of(oldest)
        return value
