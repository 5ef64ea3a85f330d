"""Pictures of a comparison."""

from __future__ import annotations

from pathlib import Path

import matplotlib as mpl
import numpy as np

mpl.use("Agg")
from bench.pathtrace.compare import Pair
from matplotlib.figure import Figure

DIFFERENCE = 0.5
"""A difference of this part of the brightest tones is full red or blue."""


def side_by_side(pair: Pair, window: tuple[slice, slice], path: Path) -> None:
    """Path tracer, simulated instrument and their difference, cut to ``window``, as JPEG."""
    tracer, twin = pair.tracer_seen[window], pair.twin_seen[window]
    bright = float(np.percentile(tracer, 99.5))
    height = 9.6 / 3 * tracer.shape[0] / tracer.shape[1] + 0.35
    figure = Figure(figsize=(9.6, height), layout="constrained")
    titles = ("path tracer", "simulated instrument", f"difference, ±{DIFFERENCE:.0%} of bright")
    for axes, title, values in zip(
        figure.subplots(1, 3), titles, (tracer, twin, twin - tracer), strict=True
    ):
        if values is tracer or values is twin:
            axes.imshow(values / bright, cmap="gray", vmin=0, vmax=1)
        else:
            axes.imshow(values / bright, cmap="RdBu_r", vmin=-DIFFERENCE, vmax=DIFFERENCE)
        axes.set_title(title, fontsize=9)
        axes.set_axis_off()
    figure.savefig(path, dpi=110, pil_kwargs={"quality": 82})


def profile(pair: Pair, row: slice, columns: slice, pixel_um: float, path: Path) -> None:
    """Radiance along a few averaged rows, with and without diffraction, as PNG."""
    figure = Figure(figsize=(7.2, 2.9), layout="constrained")
    curves = (
        (pair.tracer, "path tracer, rays alone", "C0", ":"),
        (pair.twin, "simulated instrument, rays alone", "C3", ":"),
        (pair.tracer_seen, "path tracer, with diffraction", "C0", "-"),
        (pair.twin_seen, "simulated instrument, with diffraction", "C3", "-"),
    )
    axes = figure.subplots()
    for frame, label, colour, style in curves:
        along = frame[row, columns].mean(axis=0)
        axes.semilogy(np.arange(len(along)) * pixel_um, along, style, color=colour, label=label)
    axes.set_xlabel("µm")
    axes.set_ylabel("radiance, white = 1")
    axes.set_ylim(5e-3, 1)
    axes.legend(fontsize=7, ncols=2)
    figure.savefig(path, dpi=100)
