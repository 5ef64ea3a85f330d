"""A sample as the paper shows its simulants: micrograph, oblique view, height and slant (Figs. 10 to 12)."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np

from reliefscope.reconstruction.result import Reconstruction
from reliefscope.report.oblique import FLAT_LIGHT, TILT_DEG, render_oblique, shade
from reliefscope.report.panels import Panel, toned, write_panels
from reliefscope.units import FloatImage

_OBLIQUE_PX = 900
"""Columns of the height map that the oblique view is drawn from."""
_DRAWN_PERCENT = (0.2, 99.8)
"""Single wild heights beyond these are not drawn as towers and wells."""
_BACKGROUND = (0.955, 0.96, 0.968)
_STEEPEST_DEG = 80.0


def simulant_figure(
    result: Reconstruction, colour: FloatImage | None, title: str, path: Path
) -> Path:
    """Draw the four panels of a result and return ``path``.

    Parameters
    ----------
    result:
        Height, and normals where there are some.
    colour:
        (H, W, 3) linear colours of the micrograph; its luminance is shown where there are none.
    title:
        What the sample is.
    path:
        File to write; the suffix gives the format.

    Raises
    ------
    DatasetError
        The file could not be written.
    """
    width_um = result.pixel_um * result.height_um.shape[1]
    picture = _picture(result, colour)
    panels = [
        Panel("A: micrograph", picture, width_um=width_um),
        Panel(f"B: oblique view, {TILT_DEG:g}° tilt", _oblique(result, picture)),
        Panel("C: height", result.height_um, "height (µm)", width_um=width_um),
    ]
    slant = result.slant_rad
    if slant is not None:
        degrees = np.degrees(slant).astype(np.float32)
        panels.append(
            Panel("D: slant", degrees, "slant (°)", "magma", (0.0, _STEEPEST_DEG), width_um)
        )
    return write_panels(panels, path, columns=2, title=title)


def _picture(result: Reconstruction, colour: FloatImage | None) -> FloatImage:
    if colour is not None:
        return toned(colour)
    grey = result.micrograph if result.micrograph is not None else result.albedo
    return toned(result.height_um if grey is None else grey)


def _oblique(result: Reconstruction, picture: FloatImage) -> FloatImage:
    """The surface in the colours of the micrograph, lit from the upper left."""
    rows, columns = result.height_um.shape
    factor = min(1.0, _OBLIQUE_PX / columns)
    size = (round(columns * factor), round(rows * factor))
    height = _resized(result.height_um, size)
    known = np.isfinite(height)
    low, high = np.percentile(height[known], _DRAWN_PERCENT)
    height = np.clip(np.where(known, height, low), low, high).astype(np.float32)
    pixel_um = result.pixel_um * columns / size[0]
    shown = _resized(picture, size)
    if shown.ndim == 2:
        shown = np.repeat(shown[..., None], 3, axis=-1)
    light = shade(height, pixel_um) / np.float32(FLAT_LIGHT)
    lit = np.clip(shown * light[..., None], 0.0, 1.0).astype(np.float32)
    return render_oblique(height, lit, pixel_um, known=known, background=_BACKGROUND)


def _resized(image: FloatImage, size: tuple[int, int]) -> FloatImage:
    return np.asarray(cv2.resize(image, size, interpolation=cv2.INTER_AREA), np.float32)
