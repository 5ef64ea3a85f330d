"""Reflectance models, compiled for use pixel by pixel.

Every function gives ``pi f_r``, the radiance relative to that of a perfect white diffuser under the same
irradiance, so that a Lambert surface is its albedo alone and the radiance is always
``albedo_or_lobe * irradiance / pi``.  It is dimensionless.  ``nl``, ``nv``, ``nh``, ``vh``, ``lv`` are cosines
between the normal n, the direction to the light l, the direction to the viewer v and the half vector h; the
caller sees to ``nl > 0`` and ``nv > 0``.

======================  ==================================================  ======================================
Model                   Source                                              Parameters
======================  ==================================================  ======================================
:func:`lambert`         Lambert 1760                                        albedo 0..1
:func:`oren_nayar`      Oren and Nayar 1994, eq. 30                         albedo 0..1, slope sigma rad
:func:`ggx`             Walter 2007, Heitz 2014, Schlick 1994               width alpha 0..1, F0 0..1
:func:`ggx_metal`       the same with Fresnel's equations                   alpha, index n + i k
:func:`ggx_dielectric`  the same over a diffuser below a smooth boundary    alpha, index n > 1, albedo 0..1
:func:`coated`          Schlick 1994, Ashikhmin and Shirley 2000            F0 0..1, diffuse part
:func:`hapke`           Hapke 1981, 2002                                    w 0..1, b 0..1, c -1..1, B0 >= 0, h > 0
======================  ==================================================  ======================================

All are reciprocal: nothing changes when l and v change places.  What a model does not keep is said with it.
For colour, call a model once per channel with that channel's parameters.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from numba import njit

PI = math.pi


class HapkePhase(NamedTuple):
    """How a layer of grains scatters, but for the albedo of its grains; see :func:`hapke`."""

    b: float
    c: float
    b0: float
    width: float


REGOLITH = HapkePhase(b=0.25, c=0.3, b0=0.8, width=0.06)
"""Rough, moderately backscattering grains with the surge of dark powders (assumed: within the range that fits to
planetary soils and to laboratory powders give)."""


@njit(cache=True, inline="always", fastmath=True)
def lambert(albedo: float) -> float:
    """``pi f_r`` of a perfect diffuser: the fraction ``albedo`` of the light, evenly over all directions."""
    return albedo


@njit(cache=True, inline="always", fastmath=True)
def fresnel(f0: float, vh: float) -> float:
    """Schlick's reflectance at the half angle, ``f0`` at normal incidence.

    It rises to 1 at grazing angles, but below an ``f0`` of 0.02, which no solid in air has, only to ``50 f0``
    (Lagarde and de Rousiers 2014), so that a surface without gloss has none.
    """
    missing = 1.0 - vh
    squared = missing * missing
    return f0 + (min(1.0, 50.0 * f0) - f0) * squared * squared * missing


@njit(cache=True, inline="always", fastmath=True)
def fresnel_dielectric(index: float, cosine: float) -> float:
    """Unpolarised reflectance of a smooth boundary to a medium of refractive ``index`` > 1.

    Walter et al. 2007, eq. 22; ``cosine`` of the angle of incidence, from outside.
    """
    g = math.sqrt(index * index - 1.0 + cosine * cosine)
    across = (g - cosine) / (g + cosine)
    along = (cosine * (g + cosine) - 1.0) / (cosine * (g - cosine) + 1.0)
    return 0.5 * across * across * (1.0 + along * along)


@njit(cache=True, inline="always", fastmath=True)
def fresnel_conductor(index: float, extinction: float, cosine: float) -> float:
    """Unpolarised reflectance of a smooth metal of refractive index ``index + i extinction``.

    Fresnel's equations for a complex index (Born and Wolf, Principles of Optics, the chapter on metals);
    ``cosine`` of the angle of incidence.
    """
    c2 = cosine * cosine
    s2 = 1.0 - c2
    real = index * index - extinction * extinction - s2
    size = math.sqrt(real * real + 4.0 * index * index * extinction * extinction)
    cross = 2.0 * cosine * math.sqrt(max(0.5 * (size + real), 0.0))
    perpendicular = (size + c2 - cross) / (size + c2 + cross)
    ratio = (c2 * size + s2 * s2 - cross * s2) / (c2 * size + s2 * s2 + cross * s2)
    return 0.5 * perpendicular * (1.0 + ratio)


@njit(cache=True)
def diffuse_fresnel(index: float) -> float:
    """Reflectance of a smooth boundary to ``index`` > 1 under even light from outside (Walsh 1926)."""
    n2 = index * index
    n4 = n2 * n2
    return (
        0.5
        + (index - 1.0) * (3.0 * index + 1.0) / (6.0 * (index + 1.0) ** 2)
        + n2 * (n2 - 1.0) ** 2 / (n2 + 1.0) ** 3 * math.log((index - 1.0) / (index + 1.0))
        - 2.0 * n2 * index * (n2 + 2.0 * index - 1.0) / ((n2 + 1.0) * (n4 - 1.0))
        + 8.0 * n4 * (n4 + 1.0) / ((n2 + 1.0) * (n4 - 1.0) ** 2) * math.log(index)
    )


@njit(cache=True, inline="always", fastmath=True)
def ggx_lobe(nl: float, nv: float, nh: float, alpha: float) -> float:
    """``pi f_r`` of facets that reflect everything: GGX of width ``alpha``, height-correlated Smith shadowing.

    Walter et al. 2007, eq. 33, for the distribution, Heitz 2014, eq. 99, for the shadowing.  Light that meets a
    second facet is lost: a wide lobe returns less than arrives (for alpha = 1 seen from above, 1 - ln 2).
    """
    a2 = alpha * alpha
    bump = nh * nh * (a2 - 1.0) + 1.0
    facets = a2 / (bump * bump)
    shadowing = nl * math.sqrt(a2 + (1.0 - a2) * nv * nv) + nv * math.sqrt(
        a2 + (1.0 - a2) * nl * nl
    )
    return facets * 0.5 / shadowing


@njit(cache=True, inline="always", fastmath=True)
def ggx(nl: float, nv: float, nh: float, vh: float, alpha: float, f0: float) -> float:
    """``pi f_r`` of a rough mirror: :func:`ggx_lobe` with Schlick's form of Fresnel's term (Schlick 1994).

    A metal has ``f0`` of 0.5 to 1, a dielectric of refractive index 1.5 has 0.04.
    """
    return fresnel(f0, vh) * ggx_lobe(nl, nv, nh, alpha)


@njit(cache=True, inline="always", fastmath=True)
def ggx_metal(
    nl: float, nv: float, nh: float, vh: float, alpha: float, index: float, extinction: float
) -> float:
    """``pi f_r`` of a rough metal of refractive index ``index + i extinction``."""
    return fresnel_conductor(index, extinction, vh) * ggx_lobe(nl, nv, nh, alpha)


@njit(cache=True, inline="always", fastmath=True)
def ggx_dielectric(
    nl: float, nv: float, nh: float, vh: float, alpha: float, index: float, albedo: float
) -> float:
    """``pi f_r`` of a rough dielectric: gloss over a diffuser of ``albedo`` that lies below the boundary.

    The gloss is :func:`ggx_lobe` with Fresnel's equations.  What enters is scattered evenly, and some of it is
    thrown back at the boundary, any number of times: ``(1 - F(l)) (1 - F(v)) albedo / (n^2 (1 - albedo F_i))``,
    ``F_i = 1 - (1 - F_e) / n^2`` the diffuse reflectance from within, which follows by reciprocity from that from
    outside, ``F_e``, :func:`diffuse_fresnel`.  With a smooth
    boundary and ``albedo`` 1 all light comes back, at every angle.
    """
    gloss = fresnel_dielectric(index, vh) * ggx_lobe(nl, nv, nh, alpha)
    leaving = (1.0 - diffuse_fresnel(index)) / (index * index)
    entering = (1.0 - fresnel_dielectric(index, nl)) * (1.0 - fresnel_dielectric(index, nv))
    return gloss + entering * albedo / (index * index * (1.0 - albedo * (1.0 - leaving)))


@njit(cache=True, inline="always", fastmath=True)
def coated(nl: float, nv: float, f0: float, diffuse: float) -> float:
    """``pi f_r`` of a diffuse surface below facets: what they reflect does not reach it, nor leave it.

    ``diffuse`` is the surface's own ``pi f_r``, ``f0`` the facets' reflectance at normal incidence.  With
    ``R(x) = (1 - F(x)) / (1 - F0)`` by :func:`fresnel` and its cosine-weighted mean ``M`` it is multiplied by
    ``R(nl) R(nv) / M``.  So of light at the cosine ``nl`` a Lambert surface of ``albedo`` returns
    ``albedo R(nl)``, and with smooth facets on top ``F(nl) + albedo R(nl)``: all light where
    ``albedo = 1 - F0``, at every angle, and never more.  The same form as in :func:`ggx_dielectric`; here
    ``albedo`` is the share that comes back of light from straight above.
    """
    grazing = (min(1.0, 50.0 * f0) - f0) / max(1.0 - f0, 1e-6)
    toward, away = 1.0 - nl, 1.0 - nv
    toward2, away2 = toward * toward, away * away
    entering = 1.0 - grazing * toward2 * toward2 * toward
    leaving = 1.0 - grazing * away2 * away2 * away
    return diffuse * entering * leaving / (1.0 - grazing / 21.0)


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


@njit(cache=True, inline="always", fastmath=True)
def hapke_h(x: float, w: float) -> float:
    """Chandrasekhar's H function of isotropic scatterers, approximated within 1 % (Hapke 2002).

    ``x`` is the cosine of incidence or emission, ``w`` the single-scattering albedo.
    """
    return hapke_h_by_log(x, w, math.log((1.0 + x) / x))


@njit(cache=True, inline="always", fastmath=True)
def hapke_h_by_log(x: float, w: float, log: float) -> float:
    """:func:`hapke_h` where ``log`` = ln((1 + x) / x) is known, as it is for every colour but the first."""
    gamma = math.sqrt(1.0 - w)
    r0 = (1.0 - gamma) / (1.0 + gamma)
    return 1.0 / (1.0 - w * x * (r0 + 0.5 * (1.0 - 2.0 * r0 * x) * log))


@njit(cache=True, inline="always", fastmath=True)
def double_henyey_greenstein(lv: float, b: float, c: float) -> float:
    """Phase function of a grain, 1 on average over the sphere; ``lv`` is the cosine of the phase angle.

    ``b`` (0 to below 1) is the narrowness of its two lobes, ``c`` their balance: 1 backward only, -1 forward
    only.
    """
    squared = b * b
    toward, away = 1.0 - 2.0 * b * lv + squared, 1.0 + 2.0 * b * lv + squared
    backward = (1.0 - squared) / (toward * math.sqrt(toward))
    forward = (1.0 - squared) / (away * math.sqrt(away))
    return 0.5 * (1.0 + c) * backward + 0.5 * (1.0 - c) * forward


@njit(cache=True, inline="always", fastmath=True)
def hapke_once(lv: float, b: float, c: float, b0: float, width: float) -> float:
    """``(1 + B(g)) p(g)`` of light that met a single grain; see :func:`hapke`."""
    # tan(g / 2) by the cosine of g; opposite the light the surge is gone.
    half = math.sqrt(max(1.0 - lv, 0.0) / max(1.0 + lv, 1e-12))
    return (1.0 + b0 / (1.0 + half / width)) * double_henyey_greenstein(lv, b, c)


@njit(cache=True, inline="always", fastmath=True)
def hapke(
    nl: float, nv: float, lv: float, w: float, b: float, c: float, b0: float, width: float
) -> float:
    """``pi f_r`` of a deep layer of dark or bright grains (regolith).

    ``w / 4 / (nl + nv) * ((1 + B(g)) p(g) + H(nl) H(nv) - 1)`` for the phase angle g between light and viewer:
    Hapke 1981, eq. 16, as a BRDF, with H of Hapke 2002.  ``p`` is :func:`double_henyey_greenstein`,
    ``B(g) = b0 / (1 + tan(g / 2) / width)`` the opposition surge by shadows that hide behind their grains,
    ``width`` (rad) its angular width.

    The total reflectance of isotropic grains (``b = 0``, ``b0 = 0``) is ``1 - sqrt(1 - w) H(nv)``; with the
    approximated H it comes out up to 0.015 lower.  Scattering more than once is taken for isotropic and the surge
    comes on top of it, so bright lobed grains return a little too much: 1.03 of the light from above for
    ``w = 1, b = 0.3, c = 0.4``, 1.06 with ``b0 = 1, width = 0.05``; 0.45 and 0.48 for ``w = 0.9``.

    Macroscopic roughness (Hapke 1984) is left out: relief that is larger than a pixel is in the height map.
    """
    once = hapke_once(lv, b, c, b0, width)
    return 0.25 * w / (nl + nv) * (once + hapke_h(nl, w) * hapke_h(nv, w) - 1.0)
