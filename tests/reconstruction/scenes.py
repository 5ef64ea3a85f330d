"""Small textured surfaces seen from several slopes, with the parallax of the world frame written out."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

HeightFunction = Callable[[NDArray[np.float64], NDArray[np.float64]], NDArray[np.float64]]
"""Height in um at (row, col) in pixels."""


@dataclass(frozen=True)
class ParallaxScene:
    views: NDArray[np.float32]
    slopes: NDArray[np.float64]
    height_um: NDArray[np.float64]
    reference: NDArray[np.float32]
    """The texture as the view s = 0 sees it."""
    pixel_um: float


def hexagon_slopes(count: int, radius: float = 0.12) -> NDArray[np.float64]:
    """A ring of slopes, turned so that no baseline lies along an axis."""
    angle = 2 * np.pi * np.arange(count) / count + 0.2
    return radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)


def texture(shape: tuple[int, int], seed: int, blur_px: float = 1.0) -> NDArray[np.float64]:
    """Band-limited noise with mean .5 and standard deviation .1."""
    noise = ndimage.gaussian_filter(np.random.default_rng(seed).standard_normal(shape), blur_px)
    return np.asarray(0.5 + 0.1 * noise / noise.std())


def render(
    height: HeightFunction,
    shape: tuple[int, int] = (96, 128),
    slopes: NDArray[np.float64] | None = None,
    pixel_um: float = 1.12,
    seed: int = 1,
    noise: float = 0.0,
) -> ParallaxScene:
    """A point at (row, col) and height z appears at (row + z sy / pixel, col - z sx / pixel)."""
    if slopes is None:
        slopes = hexagon_slopes(6)
    margin = 24
    canvas = texture((shape[0] + 2 * margin, shape[1] + 2 * margin), seed)
    rows, cols = np.mgrid[: shape[0], : shape[1]].astype(np.float64)
    rng = np.random.default_rng(seed + 1)
    views = []
    for sx, sy in slopes:
        r, c = rows.copy(), cols.copy()
        for _ in range(60):
            z = height(r, c) / pixel_um
            r, c = rows - z * sy, cols + z * sx
        view = ndimage.map_coordinates(canvas, [r + margin, c + margin], order=5)
        views.append(view + noise * rng.standard_normal(shape))
    return ParallaxScene(
        np.asarray(views, dtype=np.float32),
        slopes,
        height(rows, cols),
        canvas[margin:-margin, margin:-margin].astype(np.float32),
        pixel_um,
    )


def plane(row_slope: float, col_slope: float, offset_um: float) -> HeightFunction:
    """Heights rising by so many um per pixel."""
    return lambda row, col: offset_um + row_slope * row + col_slope * col


def dome(shape: tuple[int, int], radius_px: float, top_um: float) -> HeightFunction:
    """A smooth hill of ``top_um`` in the middle of the image."""

    def height(row: NDArray[np.float64], col: NDArray[np.float64]) -> NDArray[np.float64]:
        r2 = (row - shape[0] / 2) ** 2 + (col - shape[1] / 2) ** 2
        return np.asarray(top_um * np.exp(-r2 / (2 * radius_px**2)))

    return height
