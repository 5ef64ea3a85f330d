"""Every benchmark of this folder beside its peers, one after another; figures also go to ``build/bench.json``.

Each module's ``run()`` gives its figures by name, and runs in a process of its own, so that memory and compiled code of
one do not show in another.  The physical limit stands first: how fast this machine copies memory.

    python -m bench [NAME ...]      # for instance mvs fusion; all if left out
"""

from __future__ import annotations

import argparse
import json
import multiprocessing
import os
import pkgutil
import platform
import time
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np
from bench.figures import figures_of

COPY_MB = 256
TARGET = Path("build/bench.json")


def memory_copy_gb_per_s() -> float:
    """Bytes read and written a second by one thread copying an array that no cache holds; the best of five."""
    source = np.ones(COPY_MB * 1_000_000 // 8)
    target = np.zeros_like(source)
    best = np.inf
    for _ in range(5):
        started = time.perf_counter()
        np.copyto(target, source)
        best = min(best, time.perf_counter() - started)
    return 2 * source.nbytes / best / 1e9


def modules() -> list[str]:
    """Names of the benchmarks of this folder."""
    found = (module.name for module in pkgutil.iter_modules([str(Path(__file__).parent)]))
    return sorted(name.removeprefix("bench_") for name in found if name.startswith("bench_"))


def main() -> None:
    known = modules()
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "names", nargs="*", metavar="NAME", help=f"{', '.join(known)}; all if left out"
    )
    chosen = parser.parse_args().names or known
    if unknown := set(chosen) - set(known):
        parser.error(f"there is no benchmark {', '.join(sorted(unknown))}")
    print(f"{platform.machine()}, {os.cpu_count()} logical processors")
    figures: dict[str, float] = {"memory_copy_gb_per_s": memory_copy_gb_per_s()}
    print(f"  {'memory_copy_gb_per_s':40s} {figures['memory_copy_gb_per_s']:10.4g}")
    context = multiprocessing.get_context("spawn")
    for name in chosen:
        started = time.perf_counter()
        with ProcessPoolExecutor(1, mp_context=context) as pool:
            found = pool.submit(figures_of, name).result()
        print(f"{name} ({time.perf_counter() - started:.0f} s)")
        for key, value in found.items():
            print(f"  {key:40s} {value:10.4g}")
        figures |= {key: float(value) for key, value in found.items()}
    TARGET.parent.mkdir(exist_ok=True)
    TARGET.write_text(json.dumps(figures, indent=2) + "\n", encoding="utf-8")
    print(f"written to {TARGET}")


if __name__ == "__main__":
    main()
