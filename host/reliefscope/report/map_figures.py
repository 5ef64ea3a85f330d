"""Maps with scales and bars as figures, and the overview of a reconstruction.

Drawn with matplotlib's Agg canvas, without its global state, so that any thread may draw.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

import cv2
import numpy as np
from numpy.typing import NDArray

from reliefscope.report.oblique import TILT_DEG

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Rgb = NDArray[np.uint8]
Extent = tuple[float, float, float, float]
"""Left, right, bottom and top of a map on the sample, um."""

_DPI = 130
_MILLIMETRES_FROM_UM = 5000.0
_TALLEST_IN = 9.6
"""Height of the oblique view in the overview, inches."""
_INK = "#22262b"
_FONT_SIZE = 9.0


@dataclass(frozen=True, slots=True)
class ColourMap:
    """A coloured map (h, w, 3) and the bar that explains it; no bar where ``unit`` is empty."""

    title: str
    rgb: Rgb
    unit: str = ""
    colours: str = "viridis"
    low: float = 0.0
    high: float = 1.0


def length_unit(length_um: float) -> tuple[str, float]:
    """Unit to show lengths like this one in, and what micrometres are multiplied by."""
    return ("mm", 1e-3) if length_um >= _MILLIMETRES_FROM_UM else ("µm", 1.0)


def save_map(image: ColourMap, extent_um: Extent, path: Path) -> Path:
    """Draw one map with its axes and its bar into a PNG file."""
    from matplotlib.figure import Figure

    rows, columns = image.rgb.shape[:2]
    width, height = columns / _DPI, rows / _DPI
    size = (width + 0.75 + (1.15 if image.unit else 0.2), height + 0.9)
    figure = Figure(figsize=size, dpi=_DPI, facecolor="white")
    axes = figure.add_axes((0.7 / size[0], 0.52 / size[1], width / size[0], height / size[1]))
    _draw(axes, image, extent_um, _FONT_SIZE)
    name, _ = length_unit(2 * extent_um[1])
    axes.set_xlabel(f"x ({name})", color=_INK, fontsize=_FONT_SIZE)
    axes.set_ylabel(f"y ({name})", color=_INK, fontsize=_FONT_SIZE, labelpad=1)
    if image.unit:
        slot = ((0.84 + width) / size[0], 0.52 / size[1], 0.16 / size[0], height / size[1])
        _bar(figure, figure.add_axes(slot), image, _FONT_SIZE)
    return save_figure(figure, path)


def _draw(axes: Axes, image: ColourMap, extent_um: Extent, font_size: float) -> None:
    _, factor = length_unit(2 * extent_um[1])
    left, right, bottom, top = (factor * edge for edge in extent_um)
    extent = (left, right, bottom, top)
    axes.imshow(image.rgb, extent=extent, interpolation="antialiased", aspect="equal")
    axes.set_title(image.title, loc="left", fontsize=font_size * 1.15, color=_INK, pad=5)
    axes.tick_params(colors=_INK, length=3, width=0.6, labelsize=font_size)
    for spine in axes.spines.values():
        spine.set(color="#9aa0a6", linewidth=0.6)


def _bar(figure: Figure, slot: Axes, image: ColourMap, font_size: float) -> None:
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize

    bar = figure.colorbar(ScalarMappable(Normalize(image.low, image.high), image.colours), cax=slot)
    bar.set_label(image.unit, color=_INK, fontsize=font_size)
    bar.ax.tick_params(colors=_INK, length=3, width=0.6, labelsize=font_size)
    for spine in bar.ax.spines.values():
        spine.set_visible(False)


def overview_figure(
    maps: dict[str, ColourMap], oblique: Rgb, relief: float, extent_um: Extent
) -> Figure:
    """The steps of a reconstruction side by side, after the paper's Fig. 6, above the oblique view."""
    from matplotlib.figure import Figure

    order = ["micrograph", "height_map", "quality_stereo", "slant", "quality_photometric"]
    if "height_map" not in maps:
        order.insert(1, "normals")
    chosen = [maps[name] for name in order if name in maps]
    chosen += [image for name, image in maps.items() if name in ("fused", "stereo", "integrated")]
    across = 3 if len(chosen) > 5 else len(chosen)
    width, pitch, left, gap = 3.05, 4.15, 0.5, 0.62
    height = width * chosen[0].rgb.shape[0] / chosen[0].rgb.shape[1]
    room = wide = across * pitch - 0.55
    tall = wide * oblique.shape[0] / oblique.shape[1]
    if tall > _TALLEST_IN:
        tall, wide = _TALLEST_IN, wide * _TALLEST_IN / tall
    rows = -(-len(chosen) // across)
    size = (left + across * pitch, rows * (height + gap) + tall + 0.55)
    figure = Figure(figsize=size, dpi=_DPI, facecolor="white")
    for index, image in enumerate(chosen):
        x = left + (index % across) * pitch
        y = size[1] - (index // across + 1) * (height + gap) + 0.3
        axes = figure.add_axes((x / size[0], y / size[1], width / size[0], height / size[1]))
        _draw(axes, _halved(image), extent_um, _FONT_SIZE)
        axes.annotate(
            length_unit(2 * extent_um[1])[0],
            xy=(1.0, 0.0),
            xycoords="axes fraction",
            xytext=(6.0, -14.0),
            textcoords="offset points",
            color=_INK,
            fontsize=_FONT_SIZE,
        )
        if image.unit:
            slot = ((x + width + 0.08) / size[0], y / size[1], 0.1 / size[0], height / size[1])
            _bar(figure, figure.add_axes(slot), image, _FONT_SIZE)
    begin = left + (room - wide) / 2
    axes = figure.add_axes((begin / size[0], 0.12 / size[1], wide / size[0], tall / size[1]))
    axes.imshow(oblique, interpolation="antialiased", aspect="auto")
    axes.set_axis_off()
    flattened = "" if relief == 1.0 else f", heights × {relief:.2f}"
    title = f"Oblique view, {TILT_DEG:g}° tilt{flattened}"
    axes.set_title(title, loc="left", fontsize=_FONT_SIZE * 1.15, color=_INK, pad=5)
    return figure


def _halved(image: ColourMap) -> ColourMap:
    rows, columns = image.rgb.shape[:2]
    size = (max(1, columns // 2), max(1, rows // 2))
    rgb = cv2.resize(image.rgb, size, interpolation=cv2.INTER_AREA).astype(np.uint8)
    return replace(image, rgb=rgb)


def save_figure(figure: Figure, path: Path) -> Path:
    """Write a figure as PNG, whole or not at all."""
    making = path.with_name(f".{path.name}.making")
    figure.savefig(making, format="png", pil_kwargs={"compress_level": 2})
    making.replace(path)
    return path


def save_image(rgb: Rgb, path: Path) -> Path:
    """Write a picture (H, W, 3) as PNG, whole or not at all; OSError where the disk does not take it."""
    good, encoded = cv2.imencode(
        ".png", np.ascontiguousarray(rgb[..., ::-1]), [cv2.IMWRITE_PNG_COMPRESSION, 4]
    )
    if not good:
        raise OSError(f"{path.name} could not be encoded")
    making = path.with_name(f".{path.name}.making")
    making.write_bytes(encoded.tobytes())
    making.replace(path)
    return path
