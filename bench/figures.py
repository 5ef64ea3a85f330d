"""One benchmark by its name, in a module that a process of its own can import."""

from __future__ import annotations

import importlib


def figures_of(name: str) -> dict[str, float]:
    """What ``bench_NAME`` measures."""
    found: dict[str, float] = importlib.import_module(f"bench.bench_{name}").run()
    return found
