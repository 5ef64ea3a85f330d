"""The figure of a z calibration: measured against true height, and what is left."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from reliefscope.calibration.z_scale import ZScale
from reliefscope.report.panels import DPI, FONT_SIZE, INK, save_figure


def plot_z_scale(fit: ZScale, path: Path) -> Path:
    """Draw the line and its residuals, and return ``path``.

    Raises
    ------
    DatasetError
        The file could not be written.
    """
    from matplotlib.figure import Figure

    figure = Figure(figsize=(5.6, 5.2), dpi=DPI, facecolor="white", layout="constrained")
    line, rest = figure.subplots(2, 1, sharex=True, height_ratios=(2.2, 1))
    ends = np.array([fit.stage_um.min(), fit.stage_um.max()])
    line.plot(ends, fit.offset_um + fit.slope * ends, color="#2a6f97", linewidth=1.2)
    line.plot(fit.stage_um, fit.measured_um, "o", color=INK, markersize=4)
    line.set_ylabel("measured height (µm)", fontsize=FONT_SIZE, color=INK)
    line.set_title(
        f"pupil scale {fit.pupil_scale:.4f} ± {fit.pupil_scale * fit.slope_error / fit.slope:.4f} "
        f"(was {fit.former_pupil_scale:.4f})",
        loc="left",
        fontsize=FONT_SIZE * 1.1,
        color=INK,
    )
    rest.axhline(0.0, color="#9aa0a6", linewidth=0.8)
    rest.plot(fit.stage_um, fit.residual_um, "o", color=INK, markersize=4)
    rest.set_title(
        f"residual, {fit.rms_um:.2f} µm RMS", loc="left", fontsize=FONT_SIZE * 1.1, color=INK
    )
    rest.set_xlabel("height of the stage (µm)", fontsize=FONT_SIZE, color=INK)
    rest.set_ylabel("residual (µm)", fontsize=FONT_SIZE, color=INK)
    for axes in (line, rest):
        axes.tick_params(colors=INK, length=3, width=0.6, labelsize=FONT_SIZE)
        axes.grid(color="#e8eaed", linewidth=0.6)
    return save_figure(figure, path)
