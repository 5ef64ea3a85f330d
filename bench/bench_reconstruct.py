"""The default method from process start to a result on the disk, its stages at three sizes, and the demonstration.

``reliefscope reconstruct`` of a stored run of 12 apertures and 16 lights, without pictures, in a process of its own:
start of the interpreter, imports, reading, every stage and writing are in the figure.  The run is taken by
``reliefscope demo`` in a process of its own, which is the other figure; it leaves the kernels compiled.  The stages are
then timed on a part of the same frames, on all of them, and on two by two copies of them side by side, each in
a process of its own (no larger camera is simulated; cutting and copying is in the time of reading and registering).
Processor time stands beside wall time, because other work on the machine lengthens the latter.

    python -m bench.bench_reconstruct [--run RUN]
"""

from __future__ import annotations

import argparse
import json
import multiprocessing
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
from bench.figures import SIZES

from reliefscope.dataset import Run
from reliefscope.reconstruction.pipeline import reconstruct
from reliefscope.units import FloatImage


class ResizedRun:
    """A run whose frames are cut, or repeated side by side, to ``shape``; everything else is the run's."""

    def __init__(self, run: Run, shape: tuple[int, int]) -> None:
        self._run = run
        self.shape = shape
        self.mask = None

    def __getattr__(self, name: str) -> Any:
        return getattr(self._run, name)

    def saturation_level(self, view: int, light: int) -> FloatImage | float:
        level = self._run.saturation_level(view, light)
        return level if isinstance(level, float) else self._resized(level)

    def stack(
        self, views: Iterable[int] | None = None, lights: Iterable[int] | None = None
    ) -> Iterator[tuple[int, int, FloatImage]]:
        for view, light, image in self._run.stack(views, lights):
            yield view, light, self._resized(image)

    def _resized(self, image: FloatImage) -> FloatImage:
        rows, columns = self.shape
        times = (-(-rows // image.shape[0]), -(-columns // image.shape[1]))
        whole = image if times == (1, 1) else np.tile(image, times)
        return whole[:rows, :columns]


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


def stages(place: Path, shape: tuple[int, int]) -> dict[str, float]:
    """Seconds of every stage at one size, their sum, and the greatest memory of the process that calls."""
    result = reconstruct(ResizedRun(Run.open(place), shape))
    figures = {f"{name.replace(' ', '_')}_s": spent for name, spent in result.timings_s.items()}
    figures["stages_s"] = sum(result.timings_s.values())
    figures["stages_mpix_per_s"] = shape[0] * shape[1] * 1e-6 / figures["stages_s"]
    figures["stages_peak_mb"] = result.peak_memory_mb
    return figures


def run(stored: Path | None = None) -> dict[str, float]:
    """Seconds and megabytes of ``reconstruct``, its stages by size, and ``demo``; accuracy of what the demo measured.

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
        context = multiprocessing.get_context("spawn")
        for size, shape in SIZES.items():
            with context.Pool(1) as pool:
                measured = pool.apply(stages, (place, shape))
            figures |= {f"reconstruct_{size}_{name}": value for name, value in measured.items()}
    return figures


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--run", type=Path, help="stored run instead of one that `demo` takes")
    for name, value in run(parser.parse_args().run).items():
        print(f"{name:40s} {value:10.4g}")


if __name__ == "__main__":
    main()
