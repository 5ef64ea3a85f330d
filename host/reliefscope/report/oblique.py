"""An oblique, shaded view of a height map by a floating horizon.

The view is orthographic: a camera that looks down along -z is tilted about the x axis.  A point (x, y, z) is
drawn at ``u = x``, ``v = y cos(tilt) + z sin(tilt)``, so every column of the image is its own: it is walked
from the front to the back, and whatever rises above the highest point so far is visible.
"""

from __future__ import annotations

import math

import cv2
import numpy as np
from numba import njit, prange

from reliefscope import axes
from reliefscope.units import BoolImage, FloatImage

TILT_DEG = 30.0
"""Tilt of the paper's oblique views."""
_SUPERSAMPLING = 3
_LIGHT = axes.direction(math.radians(38.0), math.radians(135.0))
_FILL = axes.direction(math.radians(60.0), math.radians(-35.0))
_BASE, _KEY, _SECOND = 0.14, 0.72, 0.24
"""Light from everywhere, from the lamp and from the fill light."""
FLAT_LIGHT = float(_BASE + _KEY * _LIGHT[2] + _SECOND * _FILL[2])
"""What :func:`shade` gives for a flat surface."""
_SIDE = np.array([0.30, 0.31, 0.34], np.float32)
"""Colour of the cut face in front."""


def shade(height_um: FloatImage, pixel_um: float, relief: float = 1.0) -> FloatImage:
    """Light (H, W) that a matt surface returns, about 0 to 1: one lamp, a weak second one, and crevices.

    ``height_um`` must be finite.  ``relief`` multiplies heights.
    """
    smooth = cv2.GaussianBlur(height_um * relief, (0, 0), 0.8).astype(np.float32)
    normals = axes.normals_from_height(smooth, pixel_um)
    lamp = np.maximum(normals @ _LIGHT.astype(np.float32), 0.0)
    fill = np.maximum(normals @ _FILL.astype(np.float32), 0.0)
    depth = np.zeros_like(height_um)
    for sigma in (4.0, 16.0):
        around = cv2.GaussianBlur(height_um, (0, 0), sigma)
        depth += np.clip((around - height_um) / (sigma * pixel_um), 0.0, 1.0)
    light = (_BASE + _KEY * lamp + _SECOND * fill) / (1.0 + 0.55 * depth)
    return light.astype(np.float32)


def render_oblique(
    height_um: FloatImage,
    colour: FloatImage,
    pixel_um: float,
    *,
    tilt_deg: float = TILT_DEG,
    relief: float = 1.0,
    known: BoolImage | None = None,
    background: tuple[float, float, float] = (1.0, 1.0, 1.0),
) -> FloatImage:
    """Oblique view (H', W, 3), 0 to 1.

    Parameters
    ----------
    height_um:
        (H, W) finite heights.
    colour:
        (H, W, 3) colour of the surface, light included, 0 to 1.
    pixel_um:
        Size of a pixel on the sample.
    tilt_deg:
        Tilt of the camera from looking straight down.
    relief:
        Factor on the heights.
    known:
        (H, W) pixels to draw; all of them if left out.
    background:
        Colour around the sample.
    """
    tilt = math.radians(tilt_deg)
    rows, columns = height_um.shape
    lowest = float(height_um.min())
    thickness = 0.04 * columns
    rise = ((height_um - lowest) * (relief / pixel_um) + thickness).astype(np.float32)
    up = rise.T * np.float32(math.sin(tilt))
    margin = 0.02 * columns
    tall = rows * math.cos(tilt) + float(rise.max()) * math.sin(tilt) + 2 * margin
    size = math.ceil(tall) * _SUPERSAMPLING
    drawn = np.ones(height_um.shape, np.bool_) if known is None else known
    canvas = np.empty((columns, size, 3), np.float32)
    canvas[:] = np.asarray(background, np.float32)
    _walk(
        np.ascontiguousarray(up),
        np.ascontiguousarray(drawn.T),
        np.ascontiguousarray(colour.transpose(1, 0, 2)),
        math.cos(tilt) * _SUPERSAMPLING,
        float(_SUPERSAMPLING),
        margin * _SUPERSAMPLING,
        _SIDE,
        canvas,
    )
    upright = np.ascontiguousarray(canvas.transpose(1, 0, 2)[::-1])
    flat = cv2.resize(upright, (columns, size // _SUPERSAMPLING), interpolation=cv2.INTER_AREA)
    return flat.astype(np.float32)


@njit(cache=True, parallel=True)
def _walk(
    up: FloatImage,
    drawn: BoolImage,
    colour: FloatImage,
    row_step: float,
    scale: float,
    start: float,
    side: FloatImage,
    canvas: FloatImage,
) -> None:
    """Draw every column from the front (last row of the map) to the back.

    ``up`` and ``drawn`` (W, H), ``colour`` (W, H, 3), ``canvas`` (W, V, 3) with v upward.
    """
    columns, rows = up.shape
    size = canvas.shape[1]
    for column in prange(columns):
        horizon = start
        for step in range(rows):
            row = rows - 1 - step
            if not drawn[column, row]:
                continue
            v = start + step * row_step + up[column, row] * scale
            if v <= horizon:
                continue
            joined = step > 0 and drawn[column, row + 1]
            # what lies below this point: the surface in front, the cut face, or nothing
            below = v - row_step
            if joined:
                below = start + (step - 1) * row_step + up[column, row + 1] * scale
            elif step == 0:
                below = start
            first = math.ceil(max(horizon, below))
            for place in range(first, min(math.ceil(v), size)):
                part = (place - below) / (v - below) if v > below else 1.0
                for channel in range(3):
                    value = colour[column, row, channel]
                    if step == 0:
                        value = side[channel] * (0.55 + 0.45 * part)
                    elif joined:
                        near = colour[column, row + 1, channel]
                        value = near + part * (value - near)
                    canvas[column, place, channel] = value
            horizon = v
