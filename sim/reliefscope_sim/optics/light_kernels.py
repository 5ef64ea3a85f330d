"""Compiled kernels of illumination: near-field LEDs with cast shadows, glossy lobes, light between surfaces.

Positions are in pixels of the surface's grid relative to the focal point: x right, y up, z toward the
objective.  Every pixel is computed by one thread in a fixed order: the result does not depend on their number.
"""

from __future__ import annotations

import math

import numpy as np
from numba import njit, prange
from numpy.typing import NDArray

from reliefscope.brdf import ggx
from reliefscope.units import FloatImage
from reliefscope_sim.optics.ray_kernels import bilinear

HitStack = NDArray[np.int32]


STRIDES_PX = (32, 8)
"""Steps of the march toward an LED where nothing within such a distance rises above the horizon."""


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
    stands above that horizon.  ``ceilings`` (2, H', W') are the largest heights within ``STRIDES_PX`` pixels.
    ``optical_axis`` is (column, row) in the array.
    """
    rows, columns = height.shape
    flat = height.reshape(-1)
    last_x = np.float32(columns - 1)
    last_y = np.float32(rows - 1)
    top = np.float32(highest)
    one = np.float32(1.0)
    axis_length = math.sqrt(led[0] * led[0] + led[1] * led[1] + led[2] * led[2])
    strength = np.float32(reference * reference)
    for row in prange(rows):
        dy = led[1] - (optical_axis[1] - np.float32(row))
        for column in range(columns):
            z = height[row, column]
            dx = led[0] - (np.float32(column) - optical_axis[0])
            dz = led[2] - z
            p = rise_x[row, column]
            q = rise_y[row, column]
            facing = dz - p * dx - q * dy
            if facing <= 0.0:
                out[row, column] = 0.0
                continue
            level = math.sqrt(dx * dx + dy * dy)
            distance = math.sqrt(dx * dx + dy * dy + dz * dz)
            incidence = facing / (distance * math.sqrt(one + p * p + q * q))
            on_axis = (dx * led[0] + dy * led[1] + dz * led[2]) / (distance * axis_length)
            beam = max(on_axis, np.float32(0.0)) ** np.float32(beam_exponent)
            falloff = strength / (distance * distance)
            visible = one
            if level > one:
                elevation = math.atan2(dz, level)
                lower = np.float32(math.tan(max(elevation - source_radius, 0.0)))
                upper = np.float32(math.tan(min(elevation + source_radius, 1.5533)))
                ux = dx / level
                uy = -dy / level
                horizon = np.float32(-1e9)
                away = one
                while horizon < upper:
                    x = np.float32(column) + away * ux
                    y = np.float32(row) + away * uy
                    reached = z + max(horizon, lower) * away
                    if reached >= top or away >= level:
                        break
                    if x < 0.0 or y < 0.0 or x >= last_x or y >= last_y:
                        break
                    near_column = np.uint32(np.int32(x))
                    near_row = np.uint32(np.int32(y))
                    if reached >= ceilings[0, near_row, near_column]:
                        away += np.float32(STRIDES_PX[0])
                    elif reached >= ceilings[1, near_row, near_column]:
                        away += np.float32(STRIDES_PX[1])
                    else:
                        horizon = max(horizon, (bilinear(flat, columns, x, y) - z) / away)
                        away += one
                if horizon > lower:
                    visible = max(np.float32(0.0), (upper - horizon) / (upper - lower))
            out[row, column] = visible * beam * falloff * incidence


@njit(cache=True, parallel=True, fastmath=True)
def add_reflected(
    albedo: FloatImage, arriving: FloatImage, share: float, radiance: FloatImage
) -> None:
    """Add ``share * albedo * arriving`` to ``radiance``; albedo and radiance are (C, H', W')."""
    channels, rows, _ = albedo.shape
    factor = np.float32(share)
    for row in prange(rows):
        for channel in range(channels):
            radiance[channel, row] += albedo[channel, row] * (factor * arriving[row])


@njit(cache=True, parallel=True, fastmath=True)
def add_gloss(
    direct: FloatImage,
    rise_x: FloatImage,
    rise_y: FloatImage,
    specular: FloatImage,
    roughness: FloatImage,
    optical_axis: FloatImage,
    led: FloatImage,
    view: FloatImage,
    share: float,
    radiance: FloatImage,
) -> None:
    """Add to ``radiance`` (C, H', W') ``share`` of the GGX lobe of light ``direct`` from ``led``.

    It is seen along the unit vector ``view``; ``specular`` is (C, H', W').
    """
    rows, columns = direct.shape
    channels = len(radiance)
    factor = np.float32(share)
    for row in prange(rows):
        dy = led[1] - (optical_axis[1] - np.float32(row))
        for column in range(columns):
            arriving = direct[row, column]
            if arriving <= np.float32(0.0):
                continue
            dx = led[0] - (np.float32(column) - optical_axis[0])
            p = rise_x[row, column]
            q = rise_y[row, column]
            nz = np.float32(1.0) / math.sqrt(np.float32(1.0) + p * p + q * q)
            nv = nz * (view[2] - p * view[0] - q * view[1])
            if nv <= np.float32(1e-3):
                continue
            inverse = np.float32(1.0) / math.sqrt(dx * dx + dy * dy + led[2] * led[2])
            lx, ly, lz = dx * inverse, dy * inverse, led[2] * inverse
            nl = max(nz * (lz - p * lx - q * ly), np.float32(1e-3))
            hx, hy, hz = lx + view[0], ly + view[1], lz + view[2]
            half = np.float32(1.0) / math.sqrt(hx * hx + hy * hy + hz * hz)
            nh = nz * half * (hz - p * hx - q * hy)
            vh = half * (view[0] * hx + view[1] * hy + view[2] * hz)
            alpha = roughness[row, column]
            for channel in range(channels):
                lobe = ggx(nl, nv, nh, vh, alpha, specular[channel, row, column])
                radiance[channel, row, column] += factor * arriving * lobe


@njit(cache=True, parallel=True, fastmath=True)
def find_neighbours(
    height: FloatImage,
    rise_x: FloatImage,
    rise_y: FloatImage,
    directions: FloatImage,
    highest: float,
    hits: HitStack,
) -> None:
    """Flat index of the surface point that each direction of each pixel meets, -1 for the open sky.

    ``directions`` (K, 3) are spread as the cosine about (0, 0, 1); each pixel turns them about its normal by
    an angle of its own.  ``hits`` is (H', W', K).
    """
    rows, columns, count = hits.shape
    flat = height.reshape(-1)
    for row in prange(rows):
        for column in range(columns):
            z0 = height[row, column]
            p = rise_x[row, column]
            q = rise_y[row, column]
            nz = np.float32(1.0) / math.sqrt(np.float32(1.0) + p * p + q * q)
            nx, ny = -p * nz, -q * nz
            mixed = (np.uint32(row * columns + column) * np.uint32(2654435761)) >> np.uint32(8)
            turn = np.float32(mixed & np.uint32(0xFFFF)) * np.float32(2 * math.pi / 65536)
            cos, sin = math.cos(turn), math.sin(turn)
            # Orthonormal frame about the normal (nz > 0 always).
            a = np.float32(1.0) / (np.float32(1.0) + nz)
            b = -nx * ny * a
            for k in range(count):
                u = cos * directions[k, 0] - sin * directions[k, 1]
                v = sin * directions[k, 0] + cos * directions[k, 1]
                w = directions[k, 2]
                gx = u * (np.float32(1.0) - nx * nx * a) + v * b + w * nx
                gy = u * b + v * (np.float32(1.0) - ny * ny * a) + w * ny
                gz = -u * nx - v * ny + w * nz
                found = -1
                level = math.sqrt(gx * gx + gy * gy)
                if level > np.float32(1e-3):
                    sx, sy, sz = gx / level, -gy / level, gz / level
                    x = np.float32(column)
                    y = np.float32(row)
                    z = z0
                    while True:
                        x += sx
                        y += sy
                        z += sz
                        if z > highest or x < 0.0 or y < 0.0 or x >= columns - 1 or y >= rows - 1:
                            break
                        if bilinear(flat, columns, x, y) > z:
                            found = int(y + np.float32(0.5)) * columns + int(x + np.float32(0.5))
                            break
                hits[row, column, k] = found


@njit(cache=True, parallel=True, fastmath=True)
def collect(radiosity: FloatImage, hits: HitStack, out: FloatImage) -> None:
    """Irradiance (H', W') that each pixel receives from the points it sees."""
    rows, columns, count = hits.shape
    flat = radiosity.reshape(-1)
    for row in prange(rows):
        for column in range(columns):
            total = np.float32(0.0)
            for k in range(count):
                at = hits[row, column, k]
                if at >= 0:
                    total += flat[at]
            out[row, column] = total / np.float32(count)
