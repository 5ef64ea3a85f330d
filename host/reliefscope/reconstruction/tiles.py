"""Tiles of an image worked on side by side.

The compiled kernels of matching and registration release the interpreter lock and are single-threaded
inside; a thread pool runs one tile per thread.  Progress and cancellation are therefore per tile, the
result does not depend on the number of threads, and several callers may compute at once.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor, as_completed
from itertools import pairwise
from typing import TypeVar

import numba

from reliefscope.jobs import Stage

Item = TypeVar("Item")


def spans(size: int, longest: int) -> list[tuple[int, int]]:
    """``[first, stop)`` spans of nearly equal length, at most ``longest``, that cover ``size``."""
    count = math.ceil(size / longest)
    edges = [size * n // count for n in range(count + 1)]
    return list(pairwise(edges))


def run_each(work: Callable[[Item], None], items: Iterable[Item], stage: Stage) -> None:
    """Call ``work`` for every item on the threads that numba is set to use; ``stage`` counts the items.

    A request to stop, or an error in one item, drops the items that have not begun and is raised.
    """
    with ThreadPoolExecutor(numba.get_num_threads(), thread_name_prefix="reliefscope") as pool:
        futures = [pool.submit(work, item) for item in items]
        try:
            for future in as_completed(futures):
                future.result()
                stage.advance()
        except BaseException:
            for future in futures:
                future.cancel()
            raise
