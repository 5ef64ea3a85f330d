"""Cast shadows, computed from the height of the surface.

Seen from above, lines of sight to an LED are straight lines through its foot, the point below it.  Among the
points of such a line, with D the distance from the foot and Z the height of the LED, the one with the slope
``q = (Z - h) / D`` hides all those behind it whose q is larger.  So along each line the smallest q so far is all
that has to be carried on, and the cost per pixel and LED does not depend on how long shadows are.  Lights at
infinity are put so far away that their lines are parallel.
"""

from __future__ import annotations

import math

import numpy as np
from numba import njit
from numpy.typing import NDArray

from reliefscope.errors import InvalidInputError
from reliefscope.jobs import Job, ensure_job
from reliefscope.models.light_field import LightField
from reliefscope.reconstruction import tiles
from reliefscope.units import UM_PER_MM, BoolImage, FloatImage

TOLERANCE_UM = 2.0
"""Depth below the shadow's edge from which a point counts as shadowed: the noise of heights, not a caster."""
DARK_SHARE = 0.1
"""A light of several LEDs counts as shadowed where more than this share of its irradiance is missing."""
_FAR_PX = 1e7
"""Distance of lights at infinity, and of LEDs whose foot lies in or near the field."""
_NEAR_FIELDS = 2.0
"""LEDs whose foot is nearer than this many field sizes are taken as distant: they stand high, so that their
shadows are short, and their direction at the middle of the field serves."""
_SHORTEST_PX = 0.5
"""Lights whose longest shadow is shorter than this cast none."""


def lit(
    height_um: FloatImage,
    lights: LightField,
    pixel_um: float,
    *,
    tolerance_um: float = TOLERANCE_UM,
    job: Job | None = None,
) -> BoolImage:
    """Where each light arrives (L, H, W): no part of the surface stands between the point and its LEDs.

    Parameters
    ----------
    height_um:
        (H, W) in the view s = 0, the focal point in the middle; missing heights (NaN) cast no shadow and
        count as lit.
    lights:
        Where light comes from.
    pixel_um:
        Size of a pixel on the sample.
    tolerance_um:
        See :data:`TOLERANCE_UM`.
    job:
        Progress (stage ``shadows``, per LED) and cancellation.

    Only cast shadows are found; whether a surface faces away from the light is for its normal to tell.
    """
    if height_um.ndim != 2 or not math.isfinite(pixel_um) or pixel_um <= 0:
        raise InvalidInputError(
            f"Shadows need heights (H, W) and a positive pixel size, not {height_um.shape}, {pixel_um}.",
            hint="Give the sampling in um per pixel.",
        )
    known = np.isfinite(height_um)
    out = np.ones((len(lights), *height_um.shape), dtype=np.bool_)
    if not known.any():
        return out
    low, high = float(height_um[known].min()), float(height_um[known].max())
    height = np.where(known, height_um, np.float32(low)).astype(np.float32)
    sources, shares = _sources(lights)
    places = [_place_px(source, height.shape, pixel_um, high - low) for source in sources]
    by_rows = np.ascontiguousarray(height)
    by_columns = np.ascontiguousarray(height.T)

    def trace(source: int) -> BoolImage | None:
        """Where LED ``source`` arrives; None where it casts no shadow at all."""
        place = places[source]
        if place is None:
            return None
        column, row, z = place
        middle_row, middle_column = (height.shape[0] - 1) / 2, (height.shape[1] - 1) / 2
        seen = np.empty(height.shape, dtype=np.bool_)
        if abs(row - middle_row) >= abs(column - middle_column):
            sweep(by_rows, column, row, z * pixel_um, tolerance_um, seen)
            return seen
        turned = np.empty(by_columns.shape, dtype=np.bool_)
        sweep(by_columns, row, column, z * pixel_um, tolerance_um, turned)
        seen[:] = turned.T
        return seen

    def work(light: int) -> None:
        leds = np.flatnonzero(shares[light])
        if len(leds) == 1:
            seen = trace(int(leds[0]))
            if seen is not None:
                out[light] = seen
            return
        missing = np.zeros(height.shape, dtype=np.float32)
        for led in leds:
            seen = trace(int(led))
            if seen is not None:
                missing += np.float32(shares[light, led]) * ~seen
        out[light] = missing <= DARK_SHARE

    with ensure_job(job).stage("shadows", len(lights)) as stage:
        tiles.run_each(work, range(len(lights)), stage)
    out[:, ~known] = True
    return out


def _sources(
    lights: LightField,
) -> tuple[list[tuple[NDArray[np.float64], bool]], NDArray[np.float64]]:
    """(position in um or direction, whether it is a position) of each LED; share (L, N) of a light's strength."""
    if lights.positions_mm is None or lights.strengths is None:
        return [(vector, False) for vector in lights.directions], np.eye(len(lights))
    shares = lights.strengths / lights.strengths.sum(axis=1, keepdims=True)
    return [(position * UM_PER_MM, True) for position in lights.positions_mm], shares


def _place_px(
    source: tuple[NDArray[np.float64], bool],
    shape: tuple[int, ...],
    pixel_um: float,
    relief_um: float,
) -> tuple[float, float, float] | None:
    """Column, row and height in pixels of a light; None where its shadows are too short to matter."""
    place, near = source
    x, y, z = place / np.linalg.norm(place)
    level = math.hypot(x, y)
    if level * relief_um < _SHORTEST_PX * pixel_um * z:
        return None
    if near and math.hypot(place[0], place[1]) > _NEAR_FIELDS * max(shape) * pixel_um:
        x, y, z = place / pixel_um
    else:
        # as far as needed for the foot to lie far outside of the field
        x, y, z = (_FAR_PX / level * part for part in (x, y, z))
    return (shape[1] - 1) / 2 + x, (shape[0] - 1) / 2 - y, z


@njit(cache=True, nogil=True, error_model="numpy", fastmath={"contract", "nsz"})
def sweep(
    height: FloatImage,
    column: float,
    row: float,
    z_um: float,
    tolerance_um: float,
    out: BoolImage,
) -> None:
    """``out`` (H, W): lines of sight from a light at ``(column, row)``, height ``z_um``, that reach ``height``.

    The light lies beyond the first or the last row, nearer to the direction of the columns than to that of the
    rows.  Lines of sight are kept on a fan of lines through the light's foot, one to a pixel or closer; the
    height on a line is linear between the pixels of a row, and so is the smallest slope between two lines.
    """
    rows, columns = height.shape
    from_top = row < 0.0
    first, nearest = (0, -row) if from_top else (rows - 1, row - (rows - 1))
    furthest = nearest + rows - 1
    # lines by their place in the row furthest from the light, where the fan is widest
    left = min(-column * furthest / nearest, -column) + column
    right = max((columns - 1 - column) * furthest / nearest, columns - 1 - column) + column
    start = math.floor(left)
    count = math.ceil(right) - start + 2
    slope = np.full(count, np.inf)
    for step in range(rows):
        r = first + step if from_top else first - step
        distance = nearest + step
        spread = distance / furthest
        inverse = furthest / distance
        origin = column - spread * (column - start)  # column at which line 0 meets this row
        # how far the shadow's edge may lie above the surface, as slope
        margin = tolerance_um / distance
        if step > 0:
            for c in range(columns):
                place = (c - origin) * inverse
                line = int(place)
                t = place - line
                edge = slope[line] + t * (slope[line + 1] - slope[line])
                here = (z_um - height[r, c]) / distance
                out[r, c] = not (edge < here - margin)
        else:
            for c in range(columns):
                out[r, c] = True
        begin = max(0, math.ceil((0.0 - origin) * inverse))
        end = min(count - 1, math.floor((columns - 1 - origin) * inverse))
        for line in range(begin, end + 1):
            x = origin + line * spread
            c0 = min(int(x), max(columns - 2, 0))
            c1 = min(c0 + 1, columns - 1)
            t = x - c0
            surface = height[r, c0] + t * (height[r, c1] - height[r, c0])
            slope[line] = min(slope[line], (z_um - surface) / distance)
