"""The default method from process start to a result on the disk, and the demonstration as a whole.

``reliefscope reconstruct`` of a stored run of 12 apertures and 16 lights, without pictures, in a process of its own:
start of the interpreter, imports, reading, every stage and writing are in the figure.  It is run once to compile the
kernels, then measured.  The run is taken by ``reliefscope demo`` in a process of its own, which is the other figure.
Processor time stands beside wall time, because other work on the machine lengthens the latter.

    python -m bench.bench_reconstruct [--run RUN]
"""

from __future__ import annotations

import argparse
import json
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any


def reliefscope(*arguments: str) -> tuple[float, dict[str, Any]]:
    """Wall seconds of a ``reliefscope`` command, and what it printed."""
    started = time.perf_counter()
    done = subprocess.run(
        [sys.executable, "-m", "reliefscope", *arguments, "--json", "--progress", "none"],
        check=True,
        capture_output=True,
        text=True,
    )
    spent = time.perf_counter() - started
    found: dict[str, Any] = json.loads(done.stdout)
    return spent, found


def processor_s() -> float:
    """Processor time of all children so far, over all cores."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(stored: Path | None = None) -> dict[str, float]:
    """Seconds and megabytes of ``reconstruct`` at full size, seconds of ``demo``; accuracy of what the demo measured.

    ``stored`` is a run to reconstruct instead of the demonstration's.
    """
    figures: dict[str, float] = {}
    with tempfile.TemporaryDirectory(prefix="bench-reconstruct-") as folder:
        if stored is None:
            place = Path(folder) / "run"
            before = processor_s()
            figures["demo_s"], found = reliefscope("demo", "--out", str(place), "--finish", "dull")
            figures["demo_processor_s"] = processor_s() - before
            for row in found["table"]:
                figures[f"demo_{row['section']}_um"] = row["mae_offset_um"]
        else:
            place = Path(folder) / stored.name
            shutil.copytree(stored, place, ignore=shutil.ignore_patterns("results"))
            reliefscope("reconstruct", str(place), "--no-pictures")
        before = processor_s()
        arguments = ("reconstruct", str(place), "--no-pictures", "--overwrite")
        figures["reconstruct_s"], found = reliefscope(*arguments)
        figures["reconstruct_processor_s"] = processor_s() - before
        figures["reconstruct_peak_mb"] = found["summary"]["peak_memory_mb"]
        columns, rows = found["summary"]["size_px"]
        figures["reconstruct_mpix_per_s"] = columns * rows * 1e-6 / figures["reconstruct_s"]
        for stage, spent in found["stages_s"].items():
            figures[f"reconstruct_{stage.replace(' ', '_').replace('-', '_')}_s"] = spent
    return figures


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--run", type=Path, help="stored run instead of one that `demo` takes")
    for name, value in run(parser.parse_args().run).items():
        print(f"{name:36s} {value:10.4g}")


if __name__ == "__main__":
    main()
