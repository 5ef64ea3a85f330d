"""The 3D fiducial of the paper's section IV.B as a parametric solid.

Plan view (x to the right, y up, 1 x 1 mm, origin in the middle)::

    +-----------+-----------+
    |  checker  |   four    |
    |  10 x 10  |hemispheres|
    +-----------+-----------+
    |   18 slanted planes   |
    |        6 x 3          |
    +-----------------------+

Everything stands on one flat base that continues around the square.  A height is counted from the focal
plane z = 0: the base lies at ``base_um`` (-47 um by default), the highest point, the top of the large
hemispheres, 100 um above it (+53 um).  The relief is thus nearly symmetric about the focal plane, and off by
3 um on purpose: no flat part lies at height 0, where anything fixed to the sensor instead of the sample
would match.

The paper fixes the sizes of the features, not their places, angles or signs; those are our choice (raised
features, angles from ``seed``).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from reliefscope.axes import pixel_grid_um
from reliefscope.errors import InvalidInputError
from reliefscope.units import BoolImage, FloatImage

Section = Literal["checker_tops", "checker_floors", "planes", "hemispheres", "full"]
SECTIONS: tuple[Section, ...] = get_args(Section)

_FIELD_UM = 50.0
_CHECKER_FIELDS = 10
_CHECKER_STEP_UM = 50.0
_QUARTER_UM = 500.0
_PLANE_COLUMNS, _PLANE_ROWS = 6, 3
_PLANE_SIDE_UM = 100.0
_PLANE_RISE_UM = 95.0
"""A plane rises no further than this over its base, so that it stays within the depth of the whole."""
_PLANE_ANGLES_DEG = (5.0, 40.0)
_RADII_UM = (100.0, 75.0, 75.0, 100.0)
_DEPTH_UM = 100.0
_SIZE_UM = 1000.0


@dataclass(frozen=True, slots=True)
class SlantedPlane:
    """Square block with a slanted top; its lowest corner touches the base.

    Height above the base: ``lift_um + slope_x (x - x0) + slope_y (y - y0)``.
    """

    centre_um: tuple[float, float]
    side_um: float
    slope_x: float
    slope_y: float

    @property
    def lift_um(self) -> float:
        """Height of the middle of the top above the base."""
        return self.side_um / 2 * (abs(self.slope_x) + abs(self.slope_y))

    @property
    def angle_rad(self) -> float:
        """Slant of the top against the sample plane."""
        return math.atan(math.hypot(self.slope_x, self.slope_y))


@dataclass(frozen=True, slots=True)
class Hemisphere:
    """Half a ball lying on the base."""

    centre_um: tuple[float, float]
    radius_um: float


@dataclass(frozen=True)
class Fiducial3D:
    """Checkerboard, slanted planes and hemispheres on a base, scalable as a whole.

    ``seed`` draws angles and directions of the planes; ``base_um`` is the height of the base in the world
    frame; ``scale`` multiplies every length of the features (not ``base_um``).
    """

    seed: int = 1
    base_um: float = -47.0
    scale: float = 1.0

    def __post_init__(self) -> None:
        if not (math.isfinite(self.scale) and self.scale > 0):
            raise InvalidInputError(
                f"A fiducial cannot be scaled by {self.scale:g}.", hint="Give a scale above 0."
            )

    @property
    def size_um(self) -> float:
        """Side of the square that holds the features."""
        return _SIZE_UM * self.scale

    @property
    def depth_um(self) -> float:
        """Height of the highest feature above the base."""
        return _DEPTH_UM * self.scale

    @property
    def field_um(self) -> float:
        """Side of a field of the checkerboard."""
        return _FIELD_UM * self.scale

    @property
    def step_um(self) -> float:
        """Height of the checkerboard's tops above its floors, which are part of the base."""
        return _CHECKER_STEP_UM * self.scale

    @cached_property
    def planes(self) -> tuple[SlantedPlane, ...]:
        """The 18 slanted planes, row by row from the upper left."""
        generator = np.random.default_rng(self.seed)
        count = _PLANE_COLUMNS * _PLANE_ROWS
        low, high = _PLANE_ANGLES_DEG
        strata = low + (np.arange(count) + generator.random(count)) * (high - low) / count
        angles = np.radians(generator.permutation(strata))
        directions = generator.uniform(0.0, 2 * math.pi, count)
        planes = []
        for index in range(count):
            column, row = index % _PLANE_COLUMNS, index // _PLANE_COLUMNS
            centre = (
                ((column + 0.5) * 2 / _PLANE_COLUMNS - 1) * _QUARTER_UM,
                -(row + 0.5) / _PLANE_ROWS * _QUARTER_UM,
            )
            cos, sin = math.cos(directions[index]), math.sin(directions[index])
            steepest = _PLANE_RISE_UM / (_PLANE_SIDE_UM * (abs(cos) + abs(sin)))
            slope = min(math.tan(angles[index]), steepest)
            planes.append(
                SlantedPlane(
                    centre_um=(centre[0] * self.scale, centre[1] * self.scale),
                    side_um=_PLANE_SIDE_UM * self.scale,
                    slope_x=slope * cos,
                    slope_y=slope * sin,
                )
            )
        return tuple(planes)

    @cached_property
    def hemispheres(self) -> tuple[Hemisphere, ...]:
        """The four hemispheres, two of each radius, equal ones across a diagonal."""
        near, far = 0.25 * _QUARTER_UM, 0.75 * _QUARTER_UM
        centres = ((near, far), (far, far), (near, near), (far, near))
        return tuple(
            Hemisphere((x * self.scale, y * self.scale), radius * self.scale)
            for (x, y), radius in zip(centres, _RADII_UM, strict=True)
        )

    def height_um(self, shape: tuple[int, int], pixel_um: float) -> FloatImage:
        """Height (H, W) in um at the pixel centres of a frame whose middle is the middle of the square."""
        x_um, y_um = pixel_grid_um(shape, pixel_um)
        above: NDArray[np.float64] = np.zeros(shape)
        above[self._fields(x_um, y_um, raised=True)] = self.step_um
        for plane in self.planes:
            inside, dx, dy = _patch(x_um, y_um, plane.centre_um, plane.side_um / 2)
            above[inside] = (
                plane.lift_um + plane.slope_x * dx[None, :] + plane.slope_y * dy[:, None]
            )
        for ball in self.hemispheres:
            inside, dx, dy = _patch(x_um, y_um, ball.centre_um, ball.radius_um)
            squared = ball.radius_um**2 - dx[None, :] ** 2 - dy[:, None] ** 2
            above[inside] = np.sqrt(np.maximum(squared, 0.0))
        return (above + self.base_um).astype(np.float32)

    def mask(self, section: Section, shape: tuple[int, int], pixel_um: float) -> BoolImage:
        """Pixels (H, W) whose centre lies in a section; nothing is eroded.

        ``full`` is the whole square: every feature and the base between them.
        """
        x_um, y_um = pixel_grid_um(shape, pixel_um)
        if section == "checker_tops":
            return self._fields(x_um, y_um, raised=True)
        if section == "checker_floors":
            return self._fields(x_um, y_um, raised=False)
        half = self.size_um / 2
        mask: BoolImage = np.zeros(shape, dtype=bool)
        if section == "full":
            mask |= (np.abs(y_um) <= half)[:, None] & (np.abs(x_um) <= half)[None, :]
        elif section == "planes":
            for plane in self.planes:
                inside, _, _ = _patch(x_um, y_um, plane.centre_um, plane.side_um / 2)
                mask[inside] = True
        elif section == "hemispheres":
            for ball in self.hemispheres:
                distance = np.hypot(
                    x_um[None, :] - ball.centre_um[0], y_um[:, None] - ball.centre_um[1]
                )
                mask |= distance <= ball.radius_um
        else:
            raise InvalidInputError(
                f"The fiducial has no section `{section}`.",
                hint=f"Use one of: {', '.join(SECTIONS)}.",
            )
        return mask

    def _fields(
        self, x_um: NDArray[np.float64], y_um: NDArray[np.float64], *, raised: bool
    ) -> BoolImage:
        """Pixels of the raised or of the low fields of the checkerboard (the corner fields are raised)."""
        column = np.floor(x_um / self.field_um).astype(int) + _CHECKER_FIELDS
        row = np.floor(y_um / self.field_um).astype(int)
        inside = ((row >= 0) & (row < _CHECKER_FIELDS))[:, None] & (
            (column >= 0) & (column < _CHECKER_FIELDS)
        )[None, :]
        even = (row[:, None] + column[None, :]) % 2 == 0
        fields: BoolImage = inside & (even if raised else ~even)
        return fields


def _patch(
    x_um: NDArray[np.float64],
    y_um: NDArray[np.float64],
    centre_um: tuple[float, float],
    half_um: float,
) -> tuple[tuple[slice, slice], NDArray[np.float64], NDArray[np.float64]]:
    """Index of the pixels within a square, and their offsets (dx, dy) from its centre."""
    columns = np.flatnonzero(np.abs(x_um - centre_um[0]) <= half_um)
    rows = np.flatnonzero(np.abs(y_um - centre_um[1]) <= half_um)
    across = slice(columns[0], columns[-1] + 1) if columns.size else slice(0, 0)
    down = slice(rows[0], rows[-1] + 1) if rows.size else slice(0, 0)
    return (down, across), x_um[across] - centre_um[0], y_um[down] - centre_um[1]
