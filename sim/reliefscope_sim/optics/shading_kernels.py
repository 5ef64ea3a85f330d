"""Compiled kernel that turns light on a surface into radiance toward the viewer, after the models of brdf.

Positions are in pixels of the surface's grid relative to the focal point: x right, y up, z toward the objective.
Each row is worked through in loops that do one thing to all its pixels, which the compiler turns into vector
instructions; every row is computed by one thread, so the result does not depend on their number.
"""

from __future__ import annotations

import math

import numpy as np
from numba import njit, prange

from reliefscope.brdf import (
    REGOLITH,
    coated,
    fresnel,
    ggx_lobe,
    hapke_h_by_log,
    hapke_once,
    oren_nayar,
)
from reliefscope.units import FloatImage

_LEAST_COSINE = np.float32(1e-2)
"""Surfaces seen or lit at more than 89.4 degrees are treated as at that; their share of a picture is nil."""
_MOST_SCATTERING = np.float32(0.9999)
_ONE = np.float32(1.0)
_PHASE_B, _PHASE_C, _PHASE_B0, _PHASE_WIDTH = REGOLITH


@njit(cache=True, inline="always", fastmath=True)
def _cosines(
    rise_x: FloatImage,
    rise_y: FloatImage,
    first_dx: float,
    dy: float,
    led_z: float,
    view: FloatImage,
    cosines: FloatImage,
) -> None:
    """Fill ``cosines`` (5, W') of one row with n.l, n.v, n.h, v.h and l.v."""
    vx, vy, vz = view[0], view[1], view[2]
    one = np.float32(1.0)
    across = np.float32(first_dx)
    down = np.float32(dy)
    up = np.float32(led_z)
    for column in range(len(rise_x)):
        p = rise_x[column]
        q = rise_y[column]
        dx = across - np.float32(column)
        nz = one / math.sqrt(one + p * p + q * q)
        inverse = one / math.sqrt(dx * dx + down * down + up * up)
        lx, ly, lz = dx * inverse, down * inverse, up * inverse
        lv = lx * vx + ly * vy + lz * vz
        half = one / math.sqrt(np.float32(2.0) + np.float32(2.0) * lv)
        nl = nz * (lz - p * lx - q * ly)
        nv = nz * (vz - p * vx - q * vy)
        cosines[0, column] = max(nl, _LEAST_COSINE)
        cosines[1, column] = max(nv, _LEAST_COSINE)
        cosines[2, column] = max((nl + nv) * half, np.float32(0.0))
        cosines[3, column] = (one + lv) * half
        cosines[4, column] = lv


@njit(cache=True, inline="always", fastmath=True)
def _upsampled(coarse: FloatImage, row: int, ratio: int, line: FloatImage) -> None:
    """Fill ``line`` (W') with row ``row`` of ``coarse`` (H'/ratio, W'/ratio), bilinear, its edges repeated."""
    rows, columns = coarse.shape
    y = min(max((row + 0.5) / ratio - 0.5, 0.0), rows - 1.0)
    top = min(int(y), rows - 2)
    b = np.float32(y - top)
    upper, lower = coarse[top], coarse[top + 1]
    inverse = np.float32(1.0 / ratio)
    last = np.float32(columns - 1)
    for column in range(len(line)):
        x = (np.float32(column) + np.float32(0.5)) * inverse - np.float32(0.5)
        x = min(max(x, np.float32(0.0)), last)
        left = min(np.int32(x), np.int32(columns - 2))
        a = x - np.float32(left)
        above = upper[left] + a * (upper[left + 1] - upper[left])
        below = lower[left] + a * (lower[left + 1] - lower[left])
        line[column] = above + b * (below - above)


@njit(cache=True, parallel=True, fastmath=True)
def shade(
    direct: FloatImage,
    between: FloatImage,
    rise_x: FloatImage,
    rise_y: FloatImage,
    albedo: FloatImage,
    even: FloatImage,
    gloss: tuple[FloatImage, FloatImage],
    sigma: FloatImage,
    layered: FloatImage,
    source_variance: float,
    optical_axis: FloatImage,
    led: FloatImage,
    view: FloatImage,
    share: float,
    radiance: FloatImage,
) -> None:
    """Add to ``radiance`` (C, H', W') ``share`` of what a surface sends along the unit vector ``view``.

    ``direct`` (H', W') is the irradiance by the LED at ``led``; ``between`` (C, H'/r, W'/r) that from other
    surfaces, which is reflected by ``even`` (C, H', W'), the reflectance under light from all sides.
    ``gloss`` is (specular (C, H', W'), roughness (H', W')), ``sigma`` the slope of Oren and Nayar, ``layered``
    the share of Hapke; what the surface has not is an empty array.  ``source_variance`` widens a lobe,
    whose alpha^2 it is added to, by the extent of the source.
    """
    channels, rows, columns = albedo.shape
    ratio = columns // between.shape[2]
    specular, roughness = gloss
    has_gloss, has_sigma, has_layer = roughness.size > 0, sigma.size > 0, layered.size > 0
    factor = np.float32(share)
    extra = np.float32(source_variance)
    for row in prange(rows):
        cosines = np.empty((5, columns), np.float32)
        law = np.ones(columns, np.float32)
        lobe = np.empty(columns, np.float32)
        diffuse = np.empty(columns, np.float32)
        indirect = np.empty(columns, np.float32)
        log_l, log_v = np.empty(columns, np.float32), np.empty(columns, np.float32)
        scattered, spread = np.empty(columns, np.float32), np.empty(columns, np.float32)
        nl, nv, nh, vh, lv = cosines[0], cosines[1], cosines[2], cosines[3], cosines[4]
        arriving = direct[row]
        if has_gloss or has_sigma or has_layer:
            dy = led[1] - (optical_axis[1] - np.float32(row))
            first_dx = led[0] + optical_axis[0]
            _cosines(rise_x[row], rise_y[row], first_dx, dy, led[2], view, cosines)
        if has_sigma:
            for column in range(columns):
                law[column] = oren_nayar(
                    nl[column], nv[column], lv[column], 1.0, sigma[row, column]
                )
        if has_layer:
            for column in range(columns):
                log_l[column] = math.log((_ONE + nl[column]) / nl[column])
                log_v[column] = math.log((_ONE + nv[column]) / nv[column])
            for column in range(columns):
                once = hapke_once(lv[column], _PHASE_B, _PHASE_C, _PHASE_B0, _PHASE_WIDTH)
                scattered[column] = once - 1.0
                spread[column] = 0.25 / (nl[column] + nv[column])
        if has_gloss:
            width = roughness[row]
            for column in range(columns):
                alpha = math.sqrt(width[column] * width[column] + extra)
                lobe[column] = ggx_lobe(nl[column], nv[column], nh[column], alpha)
        for channel in range(channels):
            colour = albedo[channel, row]
            for column in range(columns):
                diffuse[column] = colour[column] * law[column]
            if has_layer:
                for column in range(columns):
                    w = min(colour[column], _MOST_SCATTERING)
                    h_l = hapke_h_by_log(nl[column], w, log_l[column])
                    h_v = hapke_h_by_log(nv[column], w, log_v[column])
                    grains = w * (scattered[column] + h_l * h_v) * spread[column]
                    diffuse[column] += layered[row, column] * (grains - diffuse[column])
            if has_gloss:
                f0 = specular[channel, row]
                for column in range(columns):
                    diffuse[column] = coated(
                        nl[column], nv[column], f0[column], diffuse[column]
                    ) + lobe[column] * fresnel(f0[column], vh[column])
            _upsampled(between[channel], row, ratio, indirect)
            response = even[channel, row]
            target = radiance[channel, row]
            for column in range(columns):
                target[column] += factor * (
                    arriving[column] * diffuse[column] + indirect[column] * response[column]
                )
