"""Photometric stereo beside a copy of its input and numpy's least squares, in one run.

Input are 16 frames of float32 in memory; results go into arrays that exist already, and everything has been run
once before.  The copy is the faster of ``numpy.copyto`` and of one spread over the same threads.  Plain is
:func:`~reliefscope.reconstruction.photometric.solve_lambert` with the quality of eq. 10, robust is
:func:`~reliefscope.reconstruction.photometric.solve` with near lights, a shadow mask and expected errors.  Processor
time stands beside wall time, because other work on the machine lengthens the latter.

    python -m bench.bench_ps [--repeats 7]
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable

import numpy as np
from bench.figures import SIZES
from numba import njit, prange
from numpy.typing import NDArray

from reliefscope import axes
from reliefscope.models.light_field import LightField, beam_exponent
from reliefscope.reconstruction import shadows
from reliefscope.reconstruction.photometric import PsResult, solve, solve_lambert

MAIN = "1.44mp"
PIXEL_UM = 1.12


@njit(parallel=True)
def threaded_copy(source: NDArray[np.float32], target: NDArray[np.float32]) -> None:
    """Copy frames (L, H, W), rows spread over the threads."""
    for row in prange(source.shape[1]):
        for light in range(source.shape[0]):
            target[light, row] = source[light, row]


def lights() -> LightField:
    """Sixteen LEDs of the benchtop, 30 mm away."""
    rings = [(22.5, 0.0), (45.0, 22.5)]
    directions = [
        axes.direction(np.radians(elevation), np.radians(first + 45.0 * k))
        for elevation, first in rings
        for k in range(8)
    ]
    return LightField.of_leds(30.0 * np.array(directions), np.eye(16), beam_exponent(22.5))


def best(action: Callable[[], object], repeats: int) -> tuple[float, float]:
    """Least wall and processor seconds of several calls."""
    wall_s, cpu_s = np.inf, np.inf
    for _ in range(repeats):
        started, cpu = time.perf_counter(), time.process_time()
        action()
        wall_s = min(wall_s, time.perf_counter() - started)
        cpu_s = min(cpu_s, time.process_time() - cpu)
    return wall_s, cpu_s


def numpy_lstsq(frames: NDArray[np.float32], directions: NDArray[np.float64]) -> None:
    """Normals, albedo and residual by ``numpy.linalg.lstsq`` over all pixels at once."""
    flat = frames.reshape(len(frames), -1)
    vectors = np.linalg.lstsq(directions.astype(np.float32), flat, rcond=None)[0]
    residual = np.sqrt(np.mean((flat - directions.astype(np.float32) @ vectors) ** 2, axis=0))
    albedo = np.linalg.norm(vectors, axis=0)
    assert (vectors / albedo).shape[1] == residual.size


def measure(shape: tuple[int, int], repeats: int, *, peer: bool) -> dict[str, float]:
    """Seconds of each form on one size, and the two ratios to the copy; with those of numpy for ``peer``."""
    rng = np.random.default_rng(1)
    frames = rng.random((16, *shape), dtype=np.float32)
    lit = rng.random(frames.shape, dtype=np.float32) > 0.2
    height = rng.random(shape, dtype=np.float32) * 5.0
    field, target = lights(), np.empty_like(frames)
    plain, robust = PsResult.empty(shape), PsResult.empty(shape, robust=True)

    def run_robust() -> None:
        solve(frames, field, PIXEL_UM, lit=lit, out=robust)

    def run_plain() -> None:
        solve_lambert(frames, field.directions, out=plain)

    actions: dict[str, Callable[[], object]] = {
        "copy": lambda: np.copyto(target, frames),
        "threaded_copy": lambda: threaded_copy(frames, target),
        "plain": run_plain,
        "robust": run_robust,
        "shadows": lambda: shadows.lit(height, field, PIXEL_UM),
    }
    figures: dict[str, float] = {}
    for name, action in actions.items():
        action()
        figures[f"{name}_s"], figures[f"{name}_cpu_s"] = best(action, repeats)
    if peer:
        figures["lstsq_s"], _ = best(lambda: numpy_lstsq(frames, field.directions), 1)
    copy_s = min(figures["copy_s"], figures["threaded_copy_s"])
    figures["copy_ratio"] = figures["plain_s"] / copy_s
    figures["robust_copy_ratio"] = figures["robust_s"] / copy_s
    figures["megapixels_per_s"] = shape[0] * shape[1] / figures["robust_s"] / 1e6
    return figures


def run(repeats: int = 7) -> dict[str, float]:
    """Figures of photometric stereo; those without a size in their name are of 1388 x 1038."""
    found: dict[str, float] = {}
    for size, shape in SIZES.items():
        figures = measure(shape, repeats, peer=size == MAIN)
        if size == MAIN:
            found |= {f"ps_{name}": value for name, value in figures.items()}
        else:
            found |= {
                f"ps_{name}_{size}": figures[name] for name in ("copy_ratio", "robust_copy_ratio")
            }
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--repeats", type=int, default=7)
    for name, value in run(parser.parse_args().repeats).items():
        print(f"{name:32s} {value:10.4g}")


if __name__ == "__main__":
    main()
