"""What the benchmarks share: sizes, and one of them by its name, in a module that a process of its own can import."""

from __future__ import annotations

import importlib

SIZES: dict[str, tuple[int, int]] = {
    "0.36mp": (519, 694),
    "1.44mp": (1038, 1388),
    "5.8mp": (2076, 2776),
}
"""Rows and columns by megapixels."""


def figures_of(name: str) -> dict[str, float]:
    """What ``bench_NAME`` measures."""
    found: dict[str, float] = importlib.import_module(f"bench.bench_{name}").run()
    return found
