"""Compiled kernel of robust photometric stereo: which lights tell the truth at a pixel, and what they say.

For every pixel: lights that are masked (cast shadow, saturated) or missing are left out; of the others the
brightest are set aside, because highlights and light from neighbouring surfaces only ever add; the rest is solved by
iteratively reweighted least squares (Cauchy's weights, against shadows that no mask knows); at last those set
aside come back where they agree after all (Tukey's biweight).

**Light from other surfaces.**  What surrounds a point is lit about as the level ground is, so what it passes on under
a light is ``c E_z`` of the light's irradiance vector E.  A lit point shows ``E . g + c E_z = E . (g + c z)``: its
normal comes out too upright, and no lit light tells by how much.  Those in shadow do: they show ``c E_z`` alone.

Built like :mod:`reliefscope.reconstruction.ps_kernels`: blocks in cache, vectors across pixels.
"""

from __future__ import annotations

import numpy as np
from numba import njit, prange

from reliefscope.reconstruction.ps_kernels import BLOCK, FLAGS, coefficients, store
from reliefscope.units import BoolImage, FloatImage

FEWEST_LIGHTS = 4
"""Fewer unmasked lights than this cannot be checked against each other: then the mask is disregarded."""
_STRIP = 8

_RIDGE = np.float32(1e-5)
"""Added to the mean of the squared irradiance, so that lights in one plane give a large error, not infinity."""
_CAUCHY = np.float32(1.5)
"""Residual, over the mean absolute residual, that halves the weight of a light."""
_TUKEY = np.float32(6.0)
"""Residual, over its standard deviation, from which a light that was set aside stays aside."""
_READMISSIONS = 2
_PASSED_ON = (np.float32(0.4), np.float32(0.6))
"""Light from other surfaces over the albedo up to which it is taken off, and from which on it is not: so much is
rather direct light under a shadow that the height has in the wrong place."""
_LEFT_UPRIGHT = np.float32(0.1)
"""Share of the upright part of a solution that is left at least."""
_MEAN_TO_DEVIATION = np.float32(1.25)
"""Standard deviation over mean absolute deviation of the normal distribution."""


@njit(cache=True, error_model="numpy", fastmath=FLAGS)
def _choose(
    values: FloatImage,
    usable: FloatImage,
    brighter: FloatImage,
    counts: FloatImage,
    bright: float,
    dim: float,
    at_least: float,
    count: int,
    kept: FloatImage,
) -> None:
    """Set the shares ``bright`` and ``dim`` of the usable lights aside, but keep ``at_least`` of them.

    All (L, B), ``counts`` (B,) usable lights; ``brighter`` is working space.  Equal values rank by index.
    """
    lights = values.shape[0]
    one = np.float32(1.0)
    brighter[:] = np.float32(0.0)
    for light in range(1, lights):
        for other in range(light):
            for i in range(count):
                more = one if values[other, i] > values[light, i] else np.float32(0.0)
                brighter[light, i] += more * usable[other, i]
                brighter[other, i] += (one - more) * usable[light, i]
    for light in range(lights):
        for i in range(count):
            room = max(counts[i] - np.float32(at_least), np.float32(0.0))
            first = min(np.floor(np.float32(bright) * counts[i]), room)
            last = counts[i] - min(np.floor(np.float32(dim) * counts[i]), room - first)
            inside = brighter[light, i] >= first and brighter[light, i] < last
            kept[light, i] = usable[light, i] if inside else np.float32(0.0)


@njit(cache=True, error_model="numpy", fastmath=FLAGS)
def _solve(
    values: FloatImage,
    weights: FloatImage,
    e0: FloatImage,
    de: FloatImage,
    count: int,
    sums: FloatImage,
    g: FloatImage,
) -> None:
    """Weighted least squares of a block; ``sums`` (11, B) are left for :func:`_spread`.

    Rows of ``sums``: xx, xy, xz, yy, yz, zz of the normal matrix, its right side, weight, determinant.
    """
    sums[:] = np.float32(0.0)
    for light in range(values.shape[0]):
        for i in range(count):
            at = np.float32(i)
            w = weights[light, i]
            x = e0[light, 0] + at * de[light, 0]
            y = e0[light, 1] + at * de[light, 1]
            z = e0[light, 2] + at * de[light, 2]
            wx = w * x
            wy = w * y
            wz = w * z
            value = values[light, i]
            sums[0, i] += wx * x
            sums[1, i] += wx * y
            sums[2, i] += wx * z
            sums[3, i] += wy * y
            sums[4, i] += wy * z
            sums[5, i] += wz * z
            sums[6, i] += wx * value
            sums[7, i] += wy * value
            sums[8, i] += wz * value
            sums[9, i] += w
    for i in range(count):
        ridge = _RIDGE * sums[9, i]
        xx = sums[0, i] + ridge
        yy = sums[3, i] + ridge
        zz = sums[5, i] + ridge
        xy = sums[1, i]
        xz = sums[2, i]
        yz = sums[4, i]
        cxx = yy * zz - yz * yz
        cxy = xz * yz - xy * zz
        cxz = xy * yz - xz * yy
        cyy = xx * zz - xz * xz
        cyz = xy * xz - xx * yz
        czz = xx * yy - xy * xy
        determinant = xx * cxx + xy * cxy + xz * cxz
        inverse = np.float32(1.0) / determinant
        sums[10, i] = inverse
        g[0, i] = inverse * (cxx * sums[6, i] + cxy * sums[7, i] + cxz * sums[8, i])
        g[1, i] = inverse * (cxy * sums[6, i] + cyy * sums[7, i] + cyz * sums[8, i])
        g[2, i] = inverse * (cxz * sums[6, i] + cyz * sums[7, i] + czz * sums[8, i])


@njit(cache=True, error_model="numpy", fastmath=FLAGS)
def _residuals(
    values: FloatImage, e0: FloatImage, de: FloatImage, g: FloatImage, count: int, out: FloatImage
) -> None:
    """Absolute residuals (L, B) of every light."""
    for light in range(values.shape[0]):
        for i in range(count):
            at = np.float32(i)
            model = (e0[light, 0] + at * de[light, 0]) * g[0, i]
            model += (e0[light, 1] + at * de[light, 1]) * g[1, i]
            model += (e0[light, 2] + at * de[light, 2]) * g[2, i]
            out[light, i] = abs(values[light, i] - model)


@njit(cache=True, error_model="numpy", fastmath=FLAGS)
def _mean_absolute(
    residuals: FloatImage,
    weights: FloatImage,
    g: FloatImage,
    floor: float,
    count: int,
    total: FloatImage,
    out: FloatImage,
) -> None:
    """Weighted mean (B,) of the absolute residuals, at least ``floor`` of the albedo."""
    total[:] = np.float32(0.0)
    out[:] = np.float32(0.0)
    for light in range(residuals.shape[0]):
        for i in range(count):
            out[i] += weights[light, i] * residuals[light, i]
            total[i] += weights[light, i]
    for i in range(count):
        norm = np.sqrt(g[0, i] * g[0, i] + g[1, i] * g[1, i] + g[2, i] * g[2, i])
        out[i] = max(out[i] / total[i], np.float32(floor) * norm)


@njit(cache=True, error_model="numpy", fastmath=FLAGS)
def _spread(sums: FloatImage, g: FloatImage, count: int, out: FloatImage) -> None:
    """Error (B,) across ``g`` that an error of 1 in every intensity causes.

    Root of the trace of the inverse normal matrix across the direction of ``g``.
    """
    for i in range(count):
        ridge = _RIDGE * sums[9, i]
        xx = sums[0, i] + ridge
        yy = sums[3, i] + ridge
        zz = sums[5, i] + ridge
        xy = sums[1, i]
        xz = sums[2, i]
        yz = sums[4, i]
        cxx = yy * zz - yz * yz
        cyy = xx * zz - xz * xz
        czz = xx * yy - xy * xy
        x = g[0, i]
        y = g[1, i]
        z = g[2, i]
        squared = x * x + y * y + z * z
        along = cxx * x * x + cyy * y * y + czz * z * z
        mixed = (xz * yz - xy * zz) * x * y + (xy * yz - xz * yy) * x * z
        mixed += (xy * xz - xx * yz) * y * z
        along += np.float32(2.0) * mixed
        across = (cxx + cyy + czz) - along / squared
        out[i] = np.sqrt(max(across * sums[10, i], np.float32(0.0)))


@njit(cache=True, error_model="numpy", fastmath=FLAGS)
def _take_off(shade: FloatImage, count: int, g: FloatImage) -> None:
    """Take the light from other surfaces off the solution ``g`` (3, B).

    ``shade`` (2, B): intensities under the lights in shadow, and the upright parts of their irradiance vectors.
    """
    zero = np.float32(0.0)
    one = np.float32(1.0)
    first, last = _PASSED_ON
    slope = one / (last - first)
    for i in range(count):
        passed = max(shade[0, i], zero) / max(shade[1, i], np.float32(1e-9))
        norm = np.sqrt(g[0, i] * g[0, i] + g[1, i] * g[1, i] + g[2, i] * g[2, i])
        trust = min(max((last - passed / norm) * slope, zero), one)
        g[2, i] = max(g[2, i] - trust * passed, _LEFT_UPRIGHT * g[2, i])


@njit(cache=True, error_model="numpy", fastmath=FLAGS)
def _doubt_gloss(
    g: FloatImage,
    used: FloatImage,
    arrived: FloatImage,
    per_aside: float,
    count: int,
    misfit: FloatImage,
) -> None:
    """Add to ``misfit`` (B,) what gloss may tilt: where lights were set aside, those left have some, too.

    It grows with the share set aside and the sine of twice the slant, at most that of 45 degrees.
    """
    one = np.float32(1.0)
    for i in range(count):
        level = g[0, i] * g[0, i] + g[1, i] * g[1, i]
        upright = g[2, i] * g[2, i]
        squared = level + upright
        sine = one if level > upright else np.float32(2.0) * np.sqrt(level * upright) / squared
        tilt = np.float32(per_aside) * max(one - used[i] / arrived[i], np.float32(0.0)) * sine
        misfit[i] = np.sqrt(misfit[i] * misfit[i] + tilt * tilt)


@njit(cache=True, parallel=True, error_model="numpy", fastmath=FLAGS)
def solve_robust(
    images: FloatImage,
    gains: FloatImage,
    fields: FloatImage,
    lit: BoolImage,
    bright: float,
    dim: float,
    at_least: int,
    rounds: int,
    floor: float,
    per_aside: float,
    normals: FloatImage,
    albedo: FloatImage,
    residuals: FloatImage,
    misfit: FloatImage,
    used: FloatImage,
) -> None:
    """Normal, albedo and what they rest on, for every pixel.

    ``images`` (L, H, W) times ``gains`` (L,) are the intensities, NaN is missing; ``fields`` (L, KR, KC, 3) the
    irradiance vectors at the knots; ``lit`` (L, H, W) the mask, False in cast shadow.  ``bright``, ``dim`` and
    ``at_least``: the shares of the brightest and darkest that are set aside, and how many are kept at least;
    ``rounds`` of reweighting; ``floor``: residual, as a fraction of the albedo, that is always tolerated;
    ``per_aside``: misfit of a slant of 45 degrees if all lights were set aside.

    Outputs ``normals`` (H, W, 3), the rest (H, W): ``residuals`` root mean square over the weights, ``misfit``
    standard deviation of the residuals over the albedo, more where the lights that count are badly spread or a slope
    may be glossy, ``used`` sum of the weights.
    """
    lights, height, width = images.shape
    one = np.float32(1.0)
    zero = np.float32(0.0)
    for strip in prange((height + _STRIP - 1) // _STRIP):
        e0 = np.empty((lights, 3), np.float32)
        de = np.empty((lights, 3), np.float32)
        values = np.empty((lights, BLOCK), np.float32)
        known = np.empty((lights, BLOCK), np.float32)
        usable = np.empty((lights, BLOCK), np.float32)
        kept = np.empty((lights, BLOCK), np.float32)
        weights = np.empty((lights, BLOCK), np.float32)
        apart = np.empty((lights, BLOCK), np.float32)
        sums = np.empty((11, BLOCK), np.float32)
        g = np.empty((3, BLOCK), np.float32)
        counts = np.empty(BLOCK, np.float32)
        total = np.empty(BLOCK, np.float32)
        scale = np.empty(BLOCK, np.float32)
        shade = np.empty((2, BLOCK), np.float32)
        arrived = np.empty(BLOCK, np.float32)
        for row in range(strip * _STRIP, min((strip + 1) * _STRIP, height)):
            for block in range((width + BLOCK - 1) // BLOCK):
                first = block * BLOCK
                count = min(BLOCK, width - first)
                coefficients(fields, row, block, e0, de)
                counts[:] = zero
                shade[:] = zero
                for light in range(lights):
                    line = images[light, row, first : first + count]
                    mask = lit[light, row, first : first + count]
                    gain = gains[light]
                    for i in range(count):
                        value = gain * line[i]
                        there = one if value == value else zero  # noqa: PLR0124 - NaN test
                        values[light, i] = value if value == value else zero  # noqa: PLR0124
                        known[light, i] = there
                        usable[light, i] = there if mask[i] else zero
                        counts[i] += usable[light, i]
                        hidden = there - usable[light, i]
                        shade[0, i] += hidden * values[light, i]
                        shade[1, i] += hidden * (e0[light, 2] + np.float32(i) * de[light, 2])
                total[:] = zero
                for light in range(lights):
                    for i in range(count):
                        few = counts[i] < np.float32(FEWEST_LIGHTS)
                        usable[light, i] = known[light, i] if few else usable[light, i]
                        total[i] += usable[light, i]
                for i in range(count):
                    shade[0, i] = zero if counts[i] < np.float32(FEWEST_LIGHTS) else shade[0, i]
                arrived[:] = total
                _choose(values, usable, apart, total, bright, dim, at_least, count, kept)
                weights[:] = kept
                _solve(values, weights, e0, de, count, sums, g)
                for _ in range(rounds):
                    _residuals(values, e0, de, g, count, apart)
                    _mean_absolute(apart, weights, g, floor, count, total, scale)
                    for light in range(lights):
                        for i in range(count):
                            over = apart[light, i] / (_CAUCHY * scale[i])
                            weights[light, i] = kept[light, i] / (one + over * over)
                    _solve(values, weights, e0, de, count, sums, g)
                for _ in range(_READMISSIONS):
                    _residuals(values, e0, de, g, count, apart)
                    _mean_absolute(apart, weights, g, floor, count, total, scale)
                    for light in range(lights):
                        for i in range(count):
                            deviation = _MEAN_TO_DEVIATION * scale[i]
                            over = apart[light, i] / (_CAUCHY * scale[i])
                            far = apart[light, i] / (_TUKEY * deviation)
                            agrees = max(one - far * far, zero)
                            weight = kept[light, i] / (one + over * over)
                            weights[light, i] = max(weight, usable[light, i] * agrees * agrees)
                    _solve(values, weights, e0, de, count, sums, g)
                _residuals(values, e0, de, g, count, apart)
                counts[:] = zero
                total[:] = zero
                for light in range(lights):
                    for i in range(count):
                        w = weights[light, i]
                        counts[i] += w
                        total[i] += w * apart[light, i] * apart[light, i]
                _spread(sums, g, count, scale)
                for i in range(count):
                    squared = g[0, i] * g[0, i] + g[1, i] * g[1, i] + g[2, i] * g[2, i]
                    # three of the lights are spent on the solution, and three alone have no residual
                    free = max(counts[i] - np.float32(3.0), np.float32(0.5))
                    least = np.float32(floor * floor) * squared
                    ratio = np.sqrt((total[i] + least) / (free * squared))
                    misfit[row, first + i] = ratio * max(scale[i], one)
                    used[row, first + i] = counts[i]
                    solved = counts[i] > np.float32(2.5)
                    g[2, i] = g[2, i] if solved else np.float32(np.nan)
                    total[i] = np.sqrt(total[i] / counts[i])
                _take_off(shade, count, g)
                line = misfit[row, first : first + count]
                _doubt_gloss(g, counts, arrived, per_aside, count, line)
                store(g, total, row, first, count, normals, albedo, residuals)


@njit(cache=True, parallel=True, error_model="numpy", fastmath=FLAGS)
def expected_error(
    change: FloatImage,
    slant: FloatImage,
    per_misfit: float,
    per_change: float,
    per_slant: float,
    least: float,
    sigma: FloatImage,
) -> None:
    """Replace the misfit in ``sigma`` by the angle (H, W) in radians by which normals may be wrong.

    The root of the sum of squares of what misfit, ``change`` per pixel and sine of twice the slant contribute,
    the latter at most that of 45 degrees, and of ``least``.
    """
    height, width = sigma.shape
    by_misfit = np.float32(per_misfit * per_misfit)
    by_change = np.float32(per_change * per_change)
    by_slant = np.float32(per_slant * per_slant)
    constant = np.float32(least * least)
    for row in prange(height):
        for column in range(width):
            misfit = sigma[row, column]
            # sin(2 x) by its series: below 1e-3 off up to 45 degrees
            x = min(np.float32(2.0) * slant[row, column], np.float32(1.5707964))
            square = x * x
            sine = x * (np.float32(1.0) - square / np.float32(6.0))
            sine += x * square * square * (np.float32(1.0 / 120.0) - square / np.float32(5040.0))
            variance = by_misfit * misfit * misfit
            variance += by_change * change[row, column] * change[row, column]
            variance += by_slant * sine * sine
            sigma[row, column] = np.sqrt(variance + constant)
