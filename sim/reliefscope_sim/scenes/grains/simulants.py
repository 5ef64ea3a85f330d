"""What the paper's planetary simulants are made of, as far as its section V.B and Figs. 10-12 tell.

The paper describes looks, not numbers: sizes, shares and reflectances are assumed.  Sizes are held small enough
for the relief of a levelled sample to fit the instrument's depth; colours are linear RGB.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from reliefscope_sim.scenes.grains.packing import LooseGrain
from reliefscope_sim.scenes.grains.shapes import GrainShape, Points, draw_shape

Colour = tuple[float, float, float]

_SHAPES_PER_KIND = 20
"""Shapes that a kind of grain has in one sample; turned and scaled, their repetition does not show."""


@dataclass(frozen=True)
class Gloss:
    """GGX lobe: reflectance at normal incidence (linear RGB) and width alpha."""

    f0: Colour
    alpha: float


@dataclass(frozen=True)
class Specks:
    """Glossy spots in the surface of a grain: their share of it, size (sigma of the pattern) and gloss."""

    share: float
    size_um: float
    gloss: Gloss


@dataclass(frozen=True)
class Material:
    """What a surface is made of.

    ``albedo`` (linear RGB) varies within a grain by the relative standard deviation ``mottling``.  ``sigma_rad``
    is its Oren-Nayar slope, or None where ``albedo`` is the single-scattering albedo of a Hapke layer.
    ``relief_um`` is the standard deviation of the microscopic roughness that pixels resolve.
    """

    albedo: Colour
    gloss: Gloss
    sigma_rad: float | None = 0.4
    mottling: float = 0.25
    relief_um: float = 0.3
    specks: Specks | None = None


@dataclass(frozen=True)
class GrainKind:
    """Grains of one material, with the shapes and sizes in which they come.

    ``share`` is by number.  Volume-equivalent radii run over ``radii_um`` with ``N(> r) ~ r^-steepness``.
    ``middle`` and ``short`` are ranges of the shorter axes relative to the longest.  ``variety`` is the
    relative standard deviation of the albedo from grain to grain.
    """

    name: str
    share: float
    family: str
    radii_um: tuple[float, float]
    steepness: float
    middle: tuple[float, float]
    short: tuple[float, float]
    variety: float
    material: Material


@dataclass(frozen=True)
class Simulant:
    """Kinds of grains, how many there are on a square millimetre, and one that lies on top of them all.

    They lie on a bed of ``dust``: grains too fine to be followed one by one.
    """

    name: str
    title: str
    kinds: tuple[GrainKind, ...]
    dust: Material
    grains_per_mm2: float
    on_top: GrainKind | None = None
    on_top_length_um: float = 0.0

    def draw(self, generator: np.random.Generator, count: int) -> list[LooseGrain]:
        """``count`` grains in the order in which they fall, without the one on top."""
        shares = np.array([kind.share for kind in self.kinds])
        shapes = [[_shape(generator, kind) for _ in range(_SHAPES_PER_KIND)] for kind in self.kinds]
        grains = []
        for number in generator.choice(len(self.kinds), count, p=shares / shares.sum()):
            kind = self.kinds[number]
            shape = shapes[number][generator.integers(_SHAPES_PER_KIND)]
            grains.append(LooseGrain(shape, _radius_um(generator, kind), int(number), kind.name))
        return grains

    @property
    def all_kinds(self) -> tuple[GrainKind, ...]:
        """All kinds, by the number that grains carry; the one on top comes last."""
        return self.kinds if self.on_top is None else (*self.kinds, self.on_top)

    def draw_on_top(
        self, generator: np.random.Generator, place_um: tuple[float, float]
    ) -> list[LooseGrain]:
        """The grain on top, if there is one, to be laid down at ``place_um`` with a lean of 15 degrees."""
        if self.on_top is None:
            return []
        azimuth = generator.uniform(np.radians(30), np.radians(70))
        shape = _shape(generator, self.on_top)
        return [
            LooseGrain(
                shape,
                self.on_top_length_um / shape.extents[0],
                len(self.kinds),
                self.on_top.name,
                place_um,
                _leaning(azimuth, np.radians(15)),
            )
        ]


def _shape(generator: np.random.Generator, kind: GrainKind) -> GrainShape:
    axes = (1.0, generator.uniform(*kind.middle), generator.uniform(*kind.short))
    return draw_shape(generator, kind.family, axes)


def _radius_um(generator: np.random.Generator, kind: GrainKind) -> float:
    """Radius from the truncated power law of a kind."""
    part = generator.uniform()
    smallest, largest = kind.radii_um
    if kind.steepness == 0:
        return float(smallest * (largest / smallest) ** part)
    low, high = smallest**-kind.steepness, largest**-kind.steepness
    return float((low + part * (high - low)) ** (-1 / kind.steepness))


def _leaning(azimuth: float, lean: float) -> Points:
    """Rotation (3, 3) whose long axis points to ``azimuth`` and leans up by ``lean``."""
    long = np.array([np.cos(lean) * np.cos(azimuth), np.cos(lean) * np.sin(azimuth), np.sin(lean)])
    middle = np.array([-np.sin(azimuth), np.cos(azimuth), 0.0])
    return np.column_stack([long, middle, np.cross(long, middle)])


_DULL = Gloss((0.02, 0.02, 0.02), 0.6)
_SHINY_SILICATE = Gloss((0.045, 0.045, 0.045), 0.3)
_GLASS = Gloss((0.05, 0.05, 0.05), 0.12)
_BLOCKY: tuple[tuple[float, float], tuple[float, float]] = ((0.65, 0.95), (0.5, 0.8))
_STOCKY: tuple[tuple[float, float], tuple[float, float]] = ((0.75, 1.0), (0.6, 0.9))
_BEAD: tuple[tuple[float, float], tuple[float, float]] = ((0.9, 1.0), (0.85, 1.0))
_PROLATE: tuple[tuple[float, float], tuple[float, float]] = ((0.34, 0.36), (0.31, 0.33))

_MATRIX = Material((0.30, 0.29, 0.28), _DULL, None, relief_um=0.45)
_OLIVINE = Material((0.20, 0.20, 0.17), _SHINY_SILICATE)
_CRYSTAL = Material(
    (0.05, 0.05, 0.05), Gloss((0.35, 0.35, 0.34), 0.16), mottling=0.1, relief_um=0.1
)
_WHITE = Material(
    (0.72, 0.71, 0.68), Gloss((0.08, 0.08, 0.08), 0.14), mottling=0.06, relief_um=0.15
)
DS1 = Simulant(
    "ds1",
    "asteroid, DS-1-CR-1",
    (
        GrainKind("dark matrix", 0.78, "angular", (8, 27), 1.0, *_BLOCKY, 0.2, _MATRIX),
        GrainKind("grey silicate", 0.12, "angular", (7, 23), 1.0, *_BLOCKY, 0.2, _OLIVINE),
        GrainKind("shining crystal", 0.10, "angular", (6, 13), 0.0, *_STOCKY, 0.1, _CRYSTAL),
    ),
    Material((0.30, 0.29, 0.28), _DULL, None, relief_um=0.8),
    grains_per_mm2=1700.0,
    on_top=GrainKind("white prolate grain", 0.0, "rounded", (60, 80), 0.0, *_PROLATE, 0.0, _WHITE),
    on_top_length_um=300.0,
)
"""Dark and angular with shining specks, and a white glossy grain of about 300 x 100 um on top (Fig. 10)."""

_RED_BROWN = Material((0.33, 0.17, 0.085), _DULL, 0.45)
_OCHRE = Material((0.46, 0.27, 0.13), _DULL, 0.45)
_SHEEN = Material((0.03, 0.03, 0.03), Gloss((0.22, 0.21, 0.20), 0.3), mottling=0.2)
MARS1 = Simulant(
    "mars1",
    "Mars, JSC Mars-1",
    (
        GrainKind("red-brown", 0.72, "rounded", (7, 42), 0.8, *_STOCKY, 0.3, _RED_BROWN),
        GrainKind("ochre", 0.20, "rounded", (7, 34), 0.8, *_STOCKY, 0.25, _OCHRE),
        GrainKind("metallic sheen", 0.08, "rough", (9, 32), 0.3, *_STOCKY, 0.2, _SHEEN),
    ),
    Material((0.36, 0.19, 0.095), _DULL, 0.45, relief_um=0.8),
    grains_per_mm2=1400.0,
)
"""Rounded, dull, red-brown, of wide sizes; a few dark rough grains with a metallic sheen (Fig. 11)."""

_ASH = Material(
    (0.115, 0.112, 0.11),
    Gloss((0.03, 0.03, 0.03), 0.5),
    0.5,
    specks=Specks(0.03, 1.6, Gloss((0.20, 0.20, 0.20), 0.18)),
)
_FELDSPAR = Material((0.38, 0.37, 0.35), _SHINY_SILICATE, 0.3)
_BLACK_GLASS = Material((0.03, 0.03, 0.032), _GLASS, mottling=0.1, relief_um=0.05)
JSC1A = Simulant(
    "jsc1a",
    "Moon, JSC-1A",
    (
        GrainKind("basaltic ash", 0.76, "rough", (8, 36), 0.8, *_BLOCKY, 0.2, _ASH),
        GrainKind("pale feldspar", 0.14, "angular", (8, 26), 0.8, *_BLOCKY, 0.2, _FELDSPAR),
        GrainKind("glass", 0.10, "rounded", (6, 14), 0.5, *_BEAD, 0.2, _BLACK_GLASS),
    ),
    Material((0.13, 0.127, 0.125), _DULL, 0.5, relief_um=0.8),
    grains_per_mm2=1400.0,
)
"""Rough, irregular and dark grey, with glossy specks and beads of glass (Fig. 12)."""

SIMULANTS = {simulant.name: simulant for simulant in (DS1, JSC1A, MARS1)}
