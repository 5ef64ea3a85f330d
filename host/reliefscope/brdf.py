"""Reflectance models, compiled for use pixel by pixel.

Every function gives ``pi f_r``, the radiance relative to that of a perfect white diffuser under the same
irradiance, so that a Lambert surface is its albedo alone and the radiance is always
``albedo_or_lobe * irradiance / pi``.  ``nl``, ``nv``, ``nh``, ``vh`` are cosines between the normal n, the
direction to the light l, the direction to the viewer v and the half vector h; the caller sees to
``nl > 0`` and ``nv > 0``.
"""

from __future__ import annotations

import math

from numba import njit

PI = math.pi


@njit(cache=True, inline="always", fastmath=True)
def fresnel(f0: float, vh: float) -> float:
    """Schlick's reflectance at the half angle, ``f0`` at normal incidence."""
    missing = 1.0 - vh
    squared = missing * missing
    return f0 + (1.0 - f0) * squared * squared * missing


@njit(cache=True, inline="always", fastmath=True)
def ggx(nl: float, nv: float, nh: float, vh: float, alpha: float, f0: float) -> float:
    """``pi f_r`` of a rough mirror: GGX facets of width ``alpha``, height-correlated Smith shadowing.

    Walter et al. 2007 for the distribution, Heitz 2014 (eq. 99) for the shadowing, Schlick 1994 for
    Fresnel's term.  A metal has ``f0`` of 0.5 to 1, a dielectric of refractive index 1.5 has 0.04.
    """
    a2 = alpha * alpha
    bump = nh * nh * (a2 - 1.0) + 1.0
    facets = a2 / (bump * bump)
    shadowing = nl * math.sqrt(a2 + (1.0 - a2) * nv * nv) + nv * math.sqrt(
        a2 + (1.0 - a2) * nl * nl
    )
    return fresnel(f0, vh) * facets * 0.5 / shadowing


@njit(cache=True, inline="always", fastmath=True)
def oren_nayar(nl: float, nv: float, lv: float, albedo: float, sigma: float) -> float:
    """``pi f_r`` of a rough diffuser: Oren and Nayar 1994, qualitative form (eq. 30), facet slope ``sigma`` rad.

    ``lv`` is the cosine between l and v.
    """
    s2 = sigma * sigma
    a = 1.0 - 0.5 * s2 / (s2 + 0.33)
    b = 0.45 * s2 / (s2 + 0.09)
    across = lv - nl * nv
    steeper = max(nl, nv) if across > 0.0 else 1.0
    return albedo * (a + b * across / steeper)
