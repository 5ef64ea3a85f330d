"""Slopes of the stereo heights against slopes of the normals, over small blocks of smooth surface.

Stereo and photometric stereo measure the same surface independently, the one by the map of the apertures and
the pupil, the other by the map of the LEDs.  Where both maps hold the slopes agree.  A mirrored map mirrors
one of the two, a turned one turns it, and a wrong scale of z stretches it.  Normals err in pits and on gloss,
stereo at edges, so the transform is sought that the most blocks agree with, not the one that fits all best.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from reliefscope import axes
from reliefscope.units import BoolImage, FloatImage

BLOCK_PX = 12
"""Side of the blocks: about the window of matching."""
STEEPEST = 1.0
"""Slope above which a block is left out: there normals are biased most."""
FLATTEST = 0.1
"""Mean of the two slopes below which a block tells nothing about a transform."""
ROUGHNESS = 0.12
"""Standard deviation of the normals' slope within a block above which it is no smooth surface."""
UNEVENNESS_PX = 1.0
"""RMS of the heights about the plane of a block, in sizes of a pixel, above which it is no smooth surface."""
TOLERANCE = (0.04, 0.2)
"""Difference of slopes at which blocks no longer agree at all: a constant, and a share of the slope."""
LEAST_BLOCKS = 30
"""Blocks below which nothing is said."""
MOST_BLOCKS = 1500
"""Blocks, evenly chosen, on which transforms are tried."""
ANGLES = 72
SCALES = np.geomspace(0.6, 1.6, 11)
"""Turns and scales that are tried."""
ROUNDS = 30


@dataclass(frozen=True, slots=True)
class SlopeAgreement:
    """The transform of the normals' slopes with which most blocks agree.

    Attributes
    ----------
    matrix:
        (2, 2) regression ``g_stereo = A g_normals`` over the blocks that agree, weighted by how well.
    mirrored, angle_deg, scale:
        The transform: a mirror that swaps the sign of y, if any, then a turn counter-clockwise, then a stretch.
    share:
        Agreement of the blocks with it, 0 to 1.
    share_as_is:
        Agreement with no transform.
    blocks:
        Blocks compared.
    """

    matrix: NDArray[np.float64]
    mirrored: bool
    angle_deg: float
    scale: float
    share: float
    share_as_is: float
    blocks: int


def compare_slopes(
    height_um: FloatImage,
    normals: FloatImage,
    good: BoolImage,
    pixel_um: float,
    block_px: int = BLOCK_PX,
) -> SlopeAgreement | None:
    """Agreement of the slopes of ``height_um`` (H, W) with those of ``normals`` (H, W, 3).

    Blocks count all of whose pixels are ``good``, whose slopes hardly vary, and which are not level.  None
    where fewer than :data:`LEAST_BLOCKS` are left.
    """
    slope_x, slope_y = axes.gradient_from_normals(normals)
    usable = good & np.isfinite(height_um) & np.isfinite(slope_x) & np.isfinite(slope_y)
    whole = _blocks(usable, block_px).all(axis=(1, 2))

    def parts(image: NDArray[Any]) -> NDArray[np.float64]:
        filled = np.where(usable, image, np.float32(0))
        return _blocks(filled, block_px)[whole].astype(np.float64)

    along_x, along_y = parts(slope_x), parts(slope_y)
    shading = along_x.mean(axis=(1, 2)) + 1j * along_y.mean(axis=(1, 2))
    rough = np.sqrt(along_x.var(axis=(1, 2)) + along_y.var(axis=(1, 2)))
    stereo, uneven = _planes(parts(height_um), pixel_um)
    size = np.maximum(np.abs(shading), np.abs(stereo))
    kept = (
        (rough < ROUGHNESS)
        & (uneven < UNEVENNESS_PX * pixel_um)
        & (size < STEEPEST)
        & (np.abs(shading) + np.abs(stereo) > 2 * FLATTEST)
    )
    places = np.flatnonzero(kept)
    if len(places) < LEAST_BLOCKS:
        return None
    places = places[:: math.ceil(len(places) / MOST_BLOCKS)]
    return _consensus(stereo[places], shading[places])


def _blocks(image: NDArray[Any], side: int) -> NDArray[Any]:
    """Whole blocks (N, side, side) of an image (H, W)."""
    rows, columns = (size // side for size in image.shape)
    cut = image[: rows * side, : columns * side].reshape(rows, side, columns, side)
    return cut.transpose(0, 2, 1, 3).reshape(-1, side, side)


def _planes(
    heights_um: NDArray[np.float64], pixel_um: float
) -> tuple[NDArray[np.complex128], NDArray[np.float64]]:
    """Slopes (N,) x + iy of the least-squares planes of blocks (N, side, side), and the RMS left (N,), um."""
    side = heights_um.shape[1]
    offset = (np.arange(side) - (side - 1) / 2) * pixel_um
    norm = side * (offset**2).sum()
    along_x = np.einsum("nrc,c->n", heights_um, offset) / norm
    along_y = -np.einsum("nrc,r->n", heights_um, offset) / norm
    plane = along_x[:, None, None] * offset - along_y[:, None, None] * offset[:, None]
    left = heights_um - heights_um.mean(axis=(1, 2), keepdims=True) - plane
    return along_x + 1j * along_y, left.std(axis=(1, 2))


def _agreement(
    stereo: NDArray[np.complex128], shading: NDArray[np.complex128], transform: complex
) -> NDArray[np.float64]:
    """Weight (N,) from 1, where slopes are equal after the transform, to 0."""
    moved = transform * shading
    constant, share = TOLERANCE
    unit = constant + share * (np.abs(stereo) + np.abs(moved)) / 2
    weight: NDArray[np.float64] = np.maximum(0.0, 1.0 - (np.abs(stereo - moved) / unit) ** 2)
    return weight


def _consensus(stereo: NDArray[np.complex128], shading: NDArray[np.complex128]) -> SlopeAgreement:
    turns = np.exp(2j * np.pi * np.arange(ANGLES) / ANGLES)
    found: list[tuple[float, bool, complex]] = []
    for mirrored in (False, True):
        source = np.conj(shading) if mirrored else shading
        transform = max(
            (complex(scale * turn) for turn in turns for scale in SCALES),
            key=lambda tried: float(_agreement(stereo, source, tried).sum()),
        )
        transform = _refined(stereo, source, transform)
        share = float(_agreement(stereo, source, transform).mean())
        found.append((share, mirrored, transform))
    share, mirrored, transform = max(found, key=lambda item: item[0])
    weights = _agreement(stereo, np.conj(shading) if mirrored else shading, transform)
    return SlopeAgreement(
        matrix=_matrix(stereo, shading, weights),
        mirrored=mirrored,
        angle_deg=math.degrees(np.angle(transform)),
        scale=abs(transform),
        share=share,
        share_as_is=float(_agreement(stereo, shading, 1.0).mean()),
        blocks=len(stereo),
    )


def _refined(
    stereo: NDArray[np.complex128], source: NDArray[np.complex128], transform: complex
) -> complex:
    """Turn by least squares, stretch as the ratio of the lengths, so that neither side's noise shortens it."""
    for _ in range(ROUNDS):
        weights = _agreement(stereo, source, transform)
        lengths = (weights * np.abs(stereo) ** 2).sum(), (weights * np.abs(source) ** 2).sum()
        if min(lengths) <= 0.0:
            break
        turn = np.angle((weights * stereo * np.conj(source)).sum())
        transform = complex(math.sqrt(lengths[0] / lengths[1]) * np.exp(1j * turn))
    return transform


def _matrix(
    stereo: NDArray[np.complex128],
    shading: NDArray[np.complex128],
    weights: NDArray[np.float64],
) -> NDArray[np.float64]:
    design = np.stack([shading.real, shading.imag], axis=1)
    values = np.stack([stereo.real, stereo.imag], axis=1)
    scaled = design * weights[:, None]
    matrix: NDArray[np.float64] = (np.linalg.pinv(scaled.T @ design) @ (scaled.T @ values)).T
    return matrix
