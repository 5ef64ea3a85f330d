"""Figures of several images side by side, each with its scale, as one PNG or JPEG file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import cv2
import numpy as np
from numpy.typing import NDArray

from reliefscope.errors import DatasetError
from reliefscope.units import FloatImage

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

INK = "#22262b"
FONT_SIZE = 9.0
DPI = 110
_PANEL_IN = 3.9
_WIDEST_PX = 900
_BLANK = "#e8eaed"


@dataclass(frozen=True, slots=True)
class Panel:
    """One image of a figure.

    ``image`` is a map (H, W), coloured over ``span`` with a bar named ``unit`` (NaN is left blank), or a picture
    (H, W) or (H, W, 3) from 0 to 1 that is shown as it is where ``unit`` is empty.
    """

    title: str
    image: FloatImage
    unit: str = ""
    colours: str = "viridis"
    span: tuple[float, float] | None = None
    width_um: float | None = None
    """Width of the image on the sample, for its axes; None: without axes."""


def toned(image: FloatImage, percentile: float = 99.5) -> FloatImage:
    """Linear light as a picture for a screen, 0 to 1: bright end cut, square root."""
    known = image[np.isfinite(image)]
    top = float(np.percentile(known, percentile)) if known.size else 1.0
    picture: FloatImage = np.sqrt(np.clip(np.nan_to_num(image) / max(top, 1e-9), 0.0, 1.0))
    return picture


def write_panels(panels: Sequence[Panel], path: Path, *, columns: int = 3, title: str = "") -> Path:
    """Draw ``panels`` row by row, ``columns`` of them in a row, and return ``path``.

    Raises
    ------
    DatasetError
        The file could not be written.
    """
    from matplotlib.figure import Figure

    across = min(columns, len(panels))
    rows = [panels[start : start + across] for start in range(0, len(panels), across)]
    tallest = [max(panel.image.shape[0] / panel.image.shape[1] for panel in row) for row in rows]
    size = (
        across * (_PANEL_IN + 0.8),
        sum(tallest) * _PANEL_IN + 0.6 * len(rows) + (0.4 if title else 0),
    )
    figure = Figure(figsize=size, dpi=DPI, facecolor="white", layout="constrained")
    if title:
        figure.suptitle(title, fontsize=FONT_SIZE * 1.3, color=INK)
    grid = figure.add_gridspec(len(rows), across, height_ratios=tallest)
    for row, chosen in enumerate(rows):
        for column, panel in enumerate(chosen):
            _draw(figure, figure.add_subplot(grid[row, column]), panel)
    return save_figure(figure, path)


def _draw(figure: Figure, axes: Axes, panel: Panel) -> None:
    axes.set_title(panel.title, loc="left", fontsize=FONT_SIZE * 1.1, color=INK)
    axes.tick_params(colors=INK, length=3, width=0.6, labelsize=FONT_SIZE * 0.9)
    axes.set_facecolor(_BLANK)
    extent = None
    if panel.width_um is None:
        axes.set_axis_off()
    else:
        half = panel.width_um / 2, panel.width_um * panel.image.shape[0] / panel.image.shape[1] / 2
        extent = (-half[0], half[0], -half[1], half[1])
    image = _reduced(panel.image)
    if not panel.unit:
        grey = np.clip(image, 0, 1)
        axes.imshow(grey, cmap="gray", vmin=0, vmax=1, extent=extent, interpolation="antialiased")
        return
    low, high = panel.span or _span(image)
    drawn = axes.imshow(
        image, cmap=panel.colours, vmin=low, vmax=high, extent=extent, interpolation="nearest"
    )
    bar = figure.colorbar(drawn, cax=axes.inset_axes((1.02, 0.0, 0.04, 1.0)))
    bar.set_label(panel.unit, fontsize=FONT_SIZE, color=INK)
    bar.ax.tick_params(colors=INK, length=3, width=0.6, labelsize=FONT_SIZE * 0.9)


def _reduced(image: FloatImage) -> FloatImage:
    """The image at no more than the pixels that a figure shows: block means of the pixels that are known."""
    rows, columns = image.shape[:2]
    if columns <= _WIDEST_PX:
        return image
    size = (_WIDEST_PX, max(1, round(rows * _WIDEST_PX / columns)))
    known = np.isfinite(image)
    if known.all():
        return np.asarray(cv2.resize(image, size, interpolation=cv2.INTER_AREA), np.float32)
    total = cv2.resize(np.nan_to_num(image), size, interpolation=cv2.INTER_AREA)
    share = cv2.resize(known.astype(np.float32), size, interpolation=cv2.INTER_AREA)
    mean = total / np.maximum(share, np.float32(1e-6))
    return np.where(share > 0.5, mean, np.float32(np.nan)).astype(np.float32)


def _span(values: NDArray[np.float32]) -> tuple[float, float]:
    known = values[np.isfinite(values)]
    if known.size == 0:
        return 0.0, 1.0
    low, high = (float(value) for value in np.percentile(known, (0.2, 99.8)))
    return (low, high) if high > low else (low - 0.5, high + 0.5)


def save_figure(figure: Figure, path: Path) -> Path:
    """Write a figure, whole or not at all; the suffix gives the format.

    Raises
    ------
    DatasetError
        The file could not be written.
    """
    making = path.with_name(f".making-{path.name}")
    options = {"quality": 85} if path.suffix.lower() in {".jpg", ".jpeg"} else {"compress_level": 6}
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        figure.savefig(making, pil_kwargs=options)
        making.replace(path)
    except OSError as error:
        raise DatasetError(
            f"A figure could not be written to {path}: {error.strerror or error}.",
            hint=f"Check space and permissions: `df -h {path.parent}`.",
        ) from error
    return path
