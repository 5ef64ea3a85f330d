"""Compiled kernels of illumination: near-field LEDs with cast shadows, light between surfaces.

Positions are in pixels of the surface's grid relative to the focal point: x right, y up, z toward the
objective.  Every pixel is computed by one thread in a fixed order: the result does not depend on their number.
"""

from __future__ import annotations

import math

import numpy as np
from numba import njit, prange
from numpy.typing import NDArray

from reliefscope.units import FloatImage
from reliefscope_sim.optics.ray_kernels import bilinear

HitStack = NDArray[np.int32]


STRIDES_PX = (32, 8, 2)
"""Steps of the march toward an LED where nothing within such a distance rises above the horizon."""


@njit(cache=True, inline="always", fastmath=True)
def _crest(flat: FloatImage, stride: int, x: np.float32, y: np.float32) -> np.float32:
    """Height at (x, y), bilinear, but for a cell that two high pixels shut from corner to corner: their own.

    Where two towers touch in a corner light finds no way through; a bilinear surface has a notch there.
    """
    column = np.int32(x)
    row = np.int32(y)
    a = x - np.float32(column)
    b = y - np.float32(row)
    at = np.uint32(row * np.int32(stride) + column)
    below = np.uint32(at + np.uint32(stride))
    h00 = flat[at]
    h10 = flat[np.uint32(at + np.uint32(1))]
    h01 = flat[below]
    h11 = flat[np.uint32(below + np.uint32(1))]
    half = np.float32(0.5)
    upper = h00 + a * (h10 - h00)
    height: np.float32 = upper + b * (h01 + a * (h11 - h01) - upper)
    if min(h00, h11) > max(h10, h01):
        height = h00 + half * (a + b) * (h11 - h00)
    elif min(h10, h01) > max(h00, h11):
        height = h01 + half * (a + np.float32(1.0) - b) * (h10 - h01)
    return height


@njit(cache=True, inline="always", fastmath=True)
def _horizon(
    flat: FloatImage,
    ceilings: FloatImage,
    x0: np.float32,
    y0: np.float32,
    z0: np.float32,
    ux: np.float32,
    uy: np.float32,
    level: np.float32,
    lower: np.float32,
    upper: np.float32,
    top: np.float32,
) -> np.float32:
    """Steepest rise, at least ``lower``, from (x0, y0, z0) to anything on the way to a light ``level`` pixels off.

    The search ends where it reaches ``upper``.
    """
    rows, columns = ceilings.shape[1], ceilings.shape[2]
    last_x = np.float32(columns - 1)
    last_y = np.float32(rows - 1)
    one = np.float32(1.0)
    horizon = lower
    away = one
    while horizon < upper:
        x = x0 + away * ux
        y = y0 + away * uy
        reached = z0 + horizon * away
        if reached >= top or away >= level:
            break
        if x < np.float32(0.0) or y < np.float32(0.0) or x >= last_x or y >= last_y:
            break
        column = np.uint32(np.int32(x))
        row = np.uint32(np.int32(y))
        if reached >= ceilings[0, row, column]:
            away += np.float32(STRIDES_PX[0])
        elif reached >= ceilings[1, row, column]:
            away += np.float32(STRIDES_PX[1])
        elif reached >= ceilings[2, row, column]:
            away += np.float32(STRIDES_PX[2])
        else:
            horizon = max(horizon, (_crest(flat, columns, x, y) - z0) / away)
            away += one
    return horizon


@njit(cache=True, parallel=True, fastmath=True)
def irradiance(
    height: FloatImage,
    ceilings: FloatImage,
    rise_x: FloatImage,
    rise_y: FloatImage,
    optical_axis: FloatImage,
    led: FloatImage,
    reference: float,
    beam_exponent: float,
    source_radius: float,
    highest: float,
    out: FloatImage,
) -> None:
    """Irradiance (H', W') by one LED, relative to normal incidence on its axis at distance ``reference``.

    Falls off with 1/r^2, with ``cos^beam_exponent`` of the angle from the LED's axis (which points at the
    focal point) and with the cosine of incidence.  The shadow comes from the horizon on the way to the LED;
    its soft edge is the part of the source, seen under the angle ``source_radius`` to either side, that
    stands above that horizon.  ``ceilings`` (3, H', W') are the largest heights within ``STRIDES_PX`` pixels.
    ``optical_axis`` is (column, row) in the array.
    """
    rows, columns = height.shape
    flat = height.reshape(-1)
    top = np.float32(highest)
    one = np.float32(1.0)
    axis_length = np.float32(math.sqrt(led[0] * led[0] + led[1] * led[1] + led[2] * led[2]))
    strength = np.float32(reference * reference)
    source = np.float32(math.tan(source_radius))
    exponent = np.float32(beam_exponent)
    for row in prange(rows):
        unshaded = out[row]
        on_axis = np.empty(columns, np.float32)
        level = np.empty(columns, np.float32)
        dy = led[1] - (optical_axis[1] - np.float32(row))
        for column in range(columns):
            dx = led[0] + optical_axis[0] - np.float32(column)
            dz = led[2] - height[row, column]
            p = rise_x[row, column]
            q = rise_y[row, column]
            facing = max(dz - p * dx - q * dy, np.float32(0.0))
            aside = dx * dx + dy * dy
            distance = math.sqrt(aside + dz * dz)
            cosine = facing / (distance * math.sqrt(one + p * p + q * q))
            level[column] = math.sqrt(aside)
            along = dx * led[0] + dy * led[1] + dz * led[2]
            on_axis[column] = max(along, np.float32(0.0)) / (distance * axis_length)
            unshaded[column] = cosine * strength / (distance * distance)
        for column in range(columns):
            if unshaded[column] <= np.float32(0.0):
                continue
            unshaded[column] *= on_axis[column] ** exponent
            if level[column] <= one:
                continue
            # tan(elevation -+ source_radius), kept within 0 and nearly upright.
            rising = (led[2] - height[row, column]) / level[column]
            lower = max((rising - source) / (one + rising * source), np.float32(0.0))
            short = one - rising * source
            upper = (rising + source) / short if short > np.float32(0.02) else np.float32(50.0)
            horizon = _horizon(
                flat,
                ceilings,
                np.float32(column),
                np.float32(row),
                height[row, column],
                (led[0] + optical_axis[0] - np.float32(column)) / level[column],
                -dy / level[column],
                level[column],
                lower,
                upper,
                top,
            )
            if horizon > lower:
                unshaded[column] *= max(np.float32(0.0), (upper - horizon) / (upper - lower))


@njit(cache=True, inline="always", fastmath=True)
def _first_met(
    flat: FloatImage,
    ceilings: FloatImage,
    x0: np.float32,
    y0: np.float32,
    z0: np.float32,
    ux: np.float32,
    uy: np.float32,
    rise: np.float32,
    top: np.float32,
) -> int:
    """Flat index of the pixel in which a ray from (x0, y0, z0) meets the surface, -1 for the open sky."""
    rows, columns = ceilings.shape[1], ceilings.shape[2]
    last_x = np.float32(columns - 1)
    last_y = np.float32(rows - 1)
    one = np.float32(1.0)
    clear = np.float32(0.0)
    away = one
    while True:
        x = x0 + away * ux
        y = y0 + away * uy
        z = z0 + away * rise
        if z > top or x < np.float32(0.0) or y < np.float32(0.0) or x >= last_x or y >= last_y:
            return -1
        step = np.float32(0.0)
        if rise > np.float32(0.0):
            column = np.uint32(np.int32(x))
            row = np.uint32(np.int32(y))
            if z >= ceilings[0, row, column]:
                step = np.float32(STRIDES_PX[0])
            elif z >= ceilings[1, row, column]:
                step = np.float32(STRIDES_PX[1])
            elif z >= ceilings[2, row, column]:
                step = np.float32(STRIDES_PX[2])
        if step > np.float32(0.0):
            clear = np.float32(0.0)
            away += step
            continue
        depth = bilinear(flat, columns, x, y) - z
        if depth > np.float32(0.0):
            back = depth / (depth + clear) if clear > np.float32(0.0) else np.float32(0.0)
            half = np.float32(0.5)
            met: int = int(y - back * uy + half) * columns + int(x - back * ux + half)
            return met
        clear = -depth
        away += one


@njit(cache=True, parallel=True, fastmath=True)
def find_neighbours(
    height: FloatImage,
    ceilings: FloatImage,
    rise_x: FloatImage,
    rise_y: FloatImage,
    directions: FloatImage,
    highest: float,
    hits: HitStack,
) -> None:
    """Flat index of the pixel (H', W') that each direction of each cell meets, -1 for the open sky.

    A cell of r x r pixels looks around from the pixel in its middle.  ``directions`` (K, 3) are spread as the
    cosine about (0, 0, 1); each cell turns them about its normal by an angle of its own.  ``hits`` is
    (H'/r, W'/r, K).  A wall is met in its own pixels, which are lit as steep as they stand; on a coarser grid
    it would shine like the level ground at its top.
    """
    rows, columns, count = hits.shape
    cell = height.shape[1] // columns
    flat = height.reshape(-1)
    top = np.float32(highest)
    one = np.float32(1.0)
    for cell_row in prange(rows):
        row = cell_row * cell + cell // 2
        for cell_column in range(columns):
            column = cell_column * cell + cell // 2
            p = rise_x[row, column]
            q = rise_y[row, column]
            nz = one / math.sqrt(one + p * p + q * q)
            nx, ny = -p * nz, -q * nz
            place = np.uint32(cell_row * columns + cell_column)
            mixed = (place * np.uint32(2654435761)) >> np.uint32(8)
            turn = np.float32(mixed & np.uint32(0xFFFF)) * np.float32(2 * math.pi / 65536)
            cos, sin = math.cos(turn), math.sin(turn)
            # Orthonormal frame about the normal (nz > 0 always).
            a = one / (one + nz)
            b = -nx * ny * a
            for k in range(count):
                u = cos * directions[k, 0] - sin * directions[k, 1]
                v = sin * directions[k, 0] + cos * directions[k, 1]
                w = directions[k, 2]
                gx = u * (one - nx * nx * a) + v * b + w * nx
                gy = u * b + v * (one - ny * ny * a) + w * ny
                gz = -u * nx - v * ny + w * nz
                level = math.sqrt(gx * gx + gy * gy)
                hits[cell_row, cell_column, k] = -1
                if level > np.float32(1e-3):
                    hits[cell_row, cell_column, k] = _first_met(
                        flat,
                        ceilings,
                        np.float32(column),
                        np.float32(row),
                        height[row, column],
                        gx / level,
                        -gy / level,
                        gz / level,
                        top,
                    )


@njit(cache=True, parallel=True, fastmath=True)
def collect(radiosity: FloatImage, hits: HitStack, shift: int, out: FloatImage) -> None:
    """Add to ``out`` (h, w, C) the irradiance that each cell receives from the pixels that it sees.

    ``hits`` (h, w, K) counts pixels cell by cell; ``radiosity`` (N, C) is what each run of ``2^shift`` of them sends:
    every pixel, or every cell.
    """
    rows, columns, count = hits.shape
    channels = radiosity.shape[1]
    flat = radiosity.reshape(-1)
    part = np.float32(1.0 / count)
    for row in prange(rows):
        total = np.empty(channels, np.float32)
        for column in range(columns):
            total[:] = np.float32(0.0)
            for k in range(count):
                hit = hits[row, column, k]
                if hit >= 0:
                    at = (hit >> shift) * channels
                    for channel in range(channels):
                        total[channel] += flat[at + channel]
            for channel in range(channels):
                out[row, column, channel] += part * total[channel]
