"""What is uneven about a real sensor: shading, unequal pixels, dust, hot pixels.

Nothing here is taken out of the frames again: a host that wants to be rid of it takes dark and flat frames, as on
the bench.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from reliefscope.units import FloatImage

DARK_ELECTRONS_PER_S = 5.0
"""Of an ordinary pixel at room temperature."""
PIXEL_SPREAD = 0.005
"""Standard deviation of the response from pixel to pixel."""
_HOT_ELECTRONS_PER_S = (500.0, 50_000.0)
_DUST_DEPTH = (0.02, 0.08)
_DECENTRED = 0.1
"""Largest distance of the middle of the shading from that of the sensor, in half diagonals."""


@dataclass(frozen=True)
class FlawLevels:
    """How much of each flaw a sensor has.

    ``shading`` is the part of the light that lens and filter keep from the furthest corner, ``dust`` the number of
    specks on the sensor's cover glass, out of focus and ``dust_px`` wide, ``hot_pixels`` those per million whose
    dark current is 100 to 10 000 times the ordinary one.
    """

    shading: float = 0.04
    dust: int = 3
    dust_px: float = 24.0
    hot_pixels: float = 50.0


@dataclass(frozen=True)
class SensorFlaws:
    """Maps (H, W) of a sensor: ``gain`` relative to an even one, and dark current in electrons a second."""

    gain: FloatImage
    dark_electrons_per_s: FloatImage

    @classmethod
    def none(cls, shape: tuple[int, int]) -> SensorFlaws:
        """An even sensor, whose pixels all have the ordinary dark current."""
        return cls(
            np.ones(shape, dtype=np.float32),
            np.full(shape, DARK_ELECTRONS_PER_S, dtype=np.float32),
        )

    @classmethod
    def draw(cls, shape: tuple[int, int], levels: FlawLevels, seed: int) -> SensorFlaws:
        """The whole sensor (H, W) of one camera, always the same one for a seed."""
        generator = np.random.default_rng([seed, 0xF1A])
        gain = _shading(generator, shape, levels.shading)
        gain *= 1 + np.float32(PIXEL_SPREAD) * generator.standard_normal(shape, dtype=np.float32)
        for _ in range(levels.dust):
            _lay_speck(generator, gain, levels.dust_px)
        flaws = cls(gain, cls.none(shape).dark_electrons_per_s)
        count = generator.poisson(levels.hot_pixels * gain.size / 1e6)
        hot = generator.integers(0, gain.size, count)
        low, high = np.log(_HOT_ELECTRONS_PER_S)
        flaws.dark_electrons_per_s.reshape(-1)[hot] = np.exp(generator.uniform(low, high, count))
        return flaws

    def region(self, shape: tuple[int, int]) -> SensorFlaws:
        """The middle of the sensor, as a camera that reads out a region of ``shape`` uses it."""
        top, left = (
            (whole - part) // 2 for whole, part in zip(self.gain.shape, shape, strict=True)
        )
        window = np.s_[top : top + shape[0], left : left + shape[1]]
        return SensorFlaws(
            np.ascontiguousarray(self.gain[window]),
            np.ascontiguousarray(self.dark_electrons_per_s[window]),
        )


def _shading(
    generator: np.random.Generator, shape: tuple[int, int], corner_loss: float
) -> FloatImage:
    """Response (H, W) that falls with the square of the distance from a point near the middle."""
    half_diagonal = math.hypot(*shape) / 2
    row, column = (
        (size - 1) / 2 + _DECENTRED * half_diagonal * generator.uniform(-1, 1) / math.sqrt(2)
        for size in shape
    )
    down = np.square(np.arange(shape[0], dtype=np.float32) - np.float32(row))
    across = np.square(np.arange(shape[1], dtype=np.float32) - np.float32(column))
    furthest = max(down[0], down[-1]) + max(across[0], across[-1])
    gain: FloatImage = 1 - np.float32(corner_loss / furthest) * (down[:, None] + across[None, :])
    return gain


def _lay_speck(generator: np.random.Generator, gain: FloatImage, diameter_px: float) -> None:
    """Darken ``gain`` by one speck: deepest in the middle, fading as a cosine to its rim."""
    radius = diameter_px / 2 * generator.uniform(0.7, 1.3)
    depth = generator.uniform(*_DUST_DEPTH)
    row, column = (generator.uniform(0, size - 1) for size in gain.shape)
    reach = math.ceil(radius)
    top, left = max(int(row) - reach, 0), max(int(column) - reach, 0)
    part = gain[top : int(row) + reach + 2, left : int(column) + reach + 2]
    rows, columns = np.indices(part.shape)
    distance = np.hypot(rows + top - row, columns + left - column)
    shadow = depth * 0.5 * (1 + np.cos(np.pi * np.minimum(distance / radius, 1.0)))
    part *= (1 - shadow).astype(np.float32)
