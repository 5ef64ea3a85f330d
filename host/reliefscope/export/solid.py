"""The 3D fiducial as a closed triangle mesh.

The relief is a function of (x, y) with jumps, so the mesh is made from one conforming triangulation of the
plane: every triangle belongs to one region (base, a field of the checkerboard, a plane, a hemisphere) whose
height is a closed form, and an edge between two regions becomes a vertical wall where their heights differ.
Flat and slanted faces are thereby exact and no triangle is a step of a bitmap; only the hemispheres are
approximated, by facets whose corners lie on the ball.

Two raised fields of the checkerboard would meet in one vertical line, an edge of four faces that no solid
has.  Their corners are therefore cut off, by :data:`CHAMFER_UM`, as a printer's voxel rounds them anyway.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from reliefscope.errors import InvalidInputError
from reliefscope.targets import Fiducial3D, Hemisphere, SlantedPlane

CHAMFER_UM = 0.5
"""Leg of the triangle cut off a raised field where it meets its diagonal neighbour; the voxel of the paper's
printer is as large."""
SNAP_UM = 1e-4
"""Lengths below this are taken for none: two heights for equal, two coordinates for one."""

_BASE = 0
_AROUND = 1.1
"""Side of the square about a hemisphere that is triangulated round, in diameters."""

Point = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Plate:
    """Base plate under the relief; lengths at scale 1.

    ``thickness_um`` from the base down to the underside, ``margin_um`` beyond each side of the square.
    """

    thickness_um: float = 200.0
    margin_um: float = 100.0

    def __post_init__(self) -> None:
        for name, value, least in (
            ("thickness", self.thickness_um, 1.0),
            ("margin", self.margin_um, 1.0),
        ):
            if not (math.isfinite(value) and value >= least):
                raise InvalidInputError(
                    f"A base plate with a {name} of {value:g} um cannot be made.",
                    hint=f"Give a {name} of {least:g} um or more.",
                )


@dataclass(frozen=True)
class Solid:
    """Closed triangle mesh: ``vertices_um`` (N, 3), world frame; ``faces`` (M, 3), counter-clockwise from outside."""

    vertices_um: NDArray[np.float64]
    faces: NDArray[np.int64]


def fiducial_solid(
    fiducial: Fiducial3D, plate: Plate | None = None, *, deviation_um: float = 0.05
) -> Solid:
    """Mesh of ``fiducial`` on its base plate, in the frame of :meth:`Fiducial3D.height_um`.

    Parameters
    ----------
    fiducial:
        The shape; its base lies at z = ``fiducial.base_um``.
    plate:
        Size of the plate, scaled with the fiducial; the default one if left out.
    deviation_um:
        Largest distance of a hemisphere's facet from the ball at scale 1, um; scaled with the fiducial.

    Raises
    ------
    InvalidInputError
        A deviation outside 0.001 to 10 um.
    """
    if not 0.001 <= deviation_um <= 10.0:
        raise InvalidInputError(
            f"Facets cannot stay within {deviation_um:g} um of the hemispheres.",
            hint="Give a deviation between 0.001 and 10 um; 0.05 um is a tenth of a printer's layer.",
        )
    plate = plate or Plate()
    plan = _plan(fiducial, plate, deviation_um * fiducial.scale)
    return _raise_plan(plan, fiducial, plate.thickness_um * fiducial.scale)


def closed_form_volume_um3(fiducial: Fiducial3D, plate: Plate | None = None) -> float:
    """Volume of the uncut parametric shape on its plate, um^3."""
    plate = plate or Plate()
    side = fiducial.size_um + 2 * plate.margin_um * fiducial.scale
    fields = 50 * fiducial.field_um**2 * fiducial.step_um
    blocks = sum(plane.side_um**2 * plane.lift_um for plane in fiducial.planes)
    balls = sum(2 / 3 * math.pi * ball.radius_um**3 for ball in fiducial.hemispheres)
    return side**2 * plate.thickness_um * fiducial.scale + fields + blocks + balls


@dataclass
class _Plan:
    """Conforming triangulation of the plane; a triangle lists its corners counter-clockwise."""

    points: list[Point] = field(default_factory=list)
    triangles: list[tuple[int, int, int]] = field(default_factory=list)
    regions: list[int] = field(default_factory=list)
    _index: dict[tuple[int, int], int] = field(default_factory=dict)

    def point(self, x: float, y: float) -> int:
        """Index of a point, the same for the same place."""
        key = (round(x / SNAP_UM), round(y / SNAP_UM))
        if key not in self._index:
            self._index[key] = len(self.points)
            self.points.append((x, y))
        return self._index[key]

    def add(self, region: int, *corners: int) -> None:
        """Add a convex polygon as a fan from its first corner."""
        for second, third in pairwise(corners[1:]):
            self.triangles.append((corners[0], second, third))
            self.regions.append(region)


@dataclass(frozen=True, slots=True)
class _Features:
    """Regions by number: 0 is the base, 1 the tops of the checkerboard, then planes, then hemispheres."""

    fiducial: Fiducial3D

    def region(self, x: float, y: float) -> int:
        """Region of a point within no hemisphere."""
        target = self.fiducial
        half = target.size_um / 2
        if -half < x < 0 < y < half:
            raised = (math.floor(x / target.field_um) + math.floor(y / target.field_um)) % 2 == 0
            return 1 if raised else _BASE
        for index, plane in enumerate(target.planes):
            if max(abs(x - plane.centre_um[0]), abs(y - plane.centre_um[1])) < plane.side_um / 2:
                return 2 + index
        return _BASE

    def ball_region(self, index: int) -> int:
        """Region of a hemisphere."""
        return 2 + len(self.fiducial.planes) + index

    def above_um(self, region: int, x: float, y: float) -> float:
        """Height of a region's surface above the base at a point of it or of its rim."""
        if region == _BASE:
            return 0.0
        if region == 1:
            return self.fiducial.step_um
        if region < self.ball_region(0):
            return _plane_above(self.fiducial.planes[region - 2], x, y)
        return _ball_above(self.fiducial.hemispheres[region - self.ball_region(0)], x, y)


def _plane_above(plane: SlantedPlane, x: float, y: float) -> float:
    return (
        plane.lift_um
        + plane.slope_x * (x - plane.centre_um[0])
        + plane.slope_y * (y - plane.centre_um[1])
    )


def _ball_above(ball: Hemisphere, x: float, y: float) -> float:
    squared = ball.radius_um**2 - (x - ball.centre_um[0]) ** 2 - (y - ball.centre_um[1]) ** 2
    # The rim lies on the base: there rounding leaves a square of about 1e-12 instead of 0.
    return math.sqrt(squared) if squared > 1e-9 * ball.radius_um**2 else 0.0


def _plan(fiducial: Fiducial3D, plate: Plate, deviation_um: float) -> _Plan:
    features, plan = _Features(fiducial), _Plan()
    cut = CHAMFER_UM * fiducial.scale
    half = fiducial.size_um / 2
    edge = half + plate.margin_um * fiducial.scale
    fields = [index * fiducial.field_um for index in range(11)]
    xs, ys = [-edge, edge], [-edge, edge]
    for shift in (-cut, 0.0, cut):
        xs += [shift - value for value in fields]
        ys += [shift + value for value in fields]
    for centre, reach in _boxes(fiducial):
        for lines, middle in ((xs, centre[0]), (ys, centre[1])):
            lines += [middle - reach, middle + reach]
    columns, rows = _distinct(xs), _distinct(ys)
    boxes = [
        (ball.centre_um, _AROUND * ball.radius_um, index)
        for index, ball in enumerate(fiducial.hemispheres)
    ]  # triangulated round, not by the grid
    for left, right in pairwise(columns):
        for low, high in pairwise(rows):
            x, y = (left + right) / 2, (low + high) / 2
            if any(max(abs(x - c[0]), abs(y - c[1])) < reach for c, reach, _ in boxes):
                continue
            _add_cell(plan, features, (left, right, low, high), cut)
    for centre, reach, index in boxes:
        rim = list(_square(plan, columns, rows, centre, reach))
        _add_ball(plan, rim, fiducial.hemispheres[index], features.ball_region(index), deviation_um)
    return plan


def _boxes(fiducial: Fiducial3D) -> Iterator[tuple[Point, float]]:
    """Centre and half side of the squares on whose sides the lines of the plan run."""
    for plane in fiducial.planes:
        yield plane.centre_um, plane.side_um / 2
    for ball in fiducial.hemispheres:
        yield ball.centre_um, _AROUND * ball.radius_um


def _distinct(values: list[float]) -> list[float]:
    found: list[float] = []
    for value in sorted(values):
        if not found or value - found[-1] > SNAP_UM:
            found.append(value)
    return found


def _add_cell(
    plan: _Plan, features: _Features, cell: tuple[float, float, float, float], cut: float
) -> None:
    """A rectangle of the grid: two triangles, in two regions where a corner of a raised field is cut off."""
    left, right, low, high = cell
    corners = [
        plan.point(x, y) for x, y in ((left, low), (right, low), (right, high), (left, high))
    ]
    region = features.region((left + right) / 2, (low + high) / 2)
    if region == 1 and right - left < 1.5 * cut and high - low < 1.5 * cut:
        crossing = _crossing(features.fiducial, cell)
        if crossing is not None:
            outer = [*corners[crossing:], *corners[:crossing]]
            plan.add(_BASE, outer[3], outer[0], outer[1])
            plan.add(region, outer[1], outer[2], outer[3])
            return
    plan.add(region, *corners)


def _crossing(fiducial: Fiducial3D, cell: tuple[float, float, float, float]) -> int | None:
    """Which corner of a cell is a crossing of the checkerboard's inner lines, counter-clockwise from lower left."""
    left, right, low, high = cell
    half = fiducial.size_um / 2

    def inner(x: float, y: float) -> bool:
        on_line = all(
            abs(value / fiducial.field_um - round(value / fiducial.field_um)) * fiducial.field_um
            < SNAP_UM
            for value in (x, y)
        )
        return on_line and -half + SNAP_UM < x < -SNAP_UM and SNAP_UM < y < half - SNAP_UM

    corners = ((left, low), (right, low), (right, high), (left, high))
    return next((index for index, corner in enumerate(corners) if inner(*corner)), None)


def _square(
    plan: _Plan, columns: list[float], rows: list[float], centre: Point, reach: float
) -> Iterator[int]:
    """Points of the grid on the sides of a square, counter-clockwise from its lower left."""
    x0, x1, y0, y1 = centre[0] - reach, centre[0] + reach, centre[1] - reach, centre[1] + reach
    across = [x for x in columns if x0 - SNAP_UM < x < x1 + SNAP_UM]
    up = [y for y in rows if y0 - SNAP_UM < y < y1 + SNAP_UM]
    yield from (plan.point(x, up[0]) for x in across[:-1])
    yield from (plan.point(across[-1], y) for y in up[:-1])
    yield from (plan.point(x, up[-1]) for x in across[:0:-1])
    yield from (plan.point(across[0], y) for y in up[:0:-1])


def _add_ball(
    plan: _Plan, square: list[int], ball: Hemisphere, region: int, deviation_um: float
) -> None:
    """Rings of latitude within a hemisphere, and the base between its rim and the square around it."""
    # A chord under the angle t of a circle of radius r stays within r (1 - cos(t / 2)) of it; half of what is
    # allowed for each of the two directions.
    step = 2 * math.acos(max(1 - deviation_um / 2 / ball.radius_um, 0.5))
    around = 4 * math.ceil(math.pi / 2 / step)
    turns = [index * 2 * math.pi / around for index in range(around)]

    def ring(elevation: float) -> list[int]:
        reach = ball.radius_um * math.cos(elevation)
        return [
            plan.point(
                ball.centre_um[0] + reach * math.cos(turn),
                ball.centre_um[1] + reach * math.sin(turn),
            )
            for turn in turns
        ]

    outer = ring(0.0)
    _add_strip(plan, square, outer, ball.centre_um)
    for latitude in range(1, around // 4):
        inner = ring(latitude * 2 * math.pi / around)
        for index in range(around):
            after = (index + 1) % around
            plan.add(region, outer[index], outer[after], inner[after], inner[index])
        outer = inner
    top = plan.point(*ball.centre_um)
    for index in range(around):
        plan.add(region, outer[index], outer[(index + 1) % around], top)


def _add_strip(plan: _Plan, outer: list[int], inner: list[int], centre: Point) -> None:
    """Triangles of the base between two loops around ``centre``, both counter-clockwise."""

    def turn(index: int) -> float:
        x, y = plan.points[index]
        return math.atan2(y - centre[1], x - centre[0]) % (2 * math.pi)

    def from_east(loop: list[int]) -> list[tuple[float, int]]:
        # The angle of the first point may come out as just under a full turn.
        turned = sorted(
            (turn(index) if turn(index) < 2 * math.pi - 1e-9 else 0.0, index) for index in loop
        )
        return [*turned, (turned[0][0] + 2 * math.pi, turned[0][1])]

    far, near = from_east(outer), from_east(inner)
    i = j = 0
    while i + 1 < len(far) or j + 1 < len(near):
        if j + 1 == len(near) or (i + 1 < len(far) and far[i + 1][0] <= near[j + 1][0]):
            plan.add(_BASE, near[j][1], far[i][1], far[i + 1][1])
            i += 1
        else:
            plan.add(_BASE, near[j][1], far[i][1], near[j + 1][1])
            j += 1


def _raise_plan(plan: _Plan, fiducial: Fiducial3D, thickness_um: float) -> Solid:
    """Lift every triangle to its region's height, stand walls between regions, and close the plate below."""
    features = _Features(fiducial)
    vertices: list[tuple[float, float, float]] = []
    index: dict[tuple[int, int], int] = {}
    faces: list[tuple[int, int, int]] = []

    def vertex(point: int, above_um: float) -> int:
        key = (point, round(above_um / SNAP_UM))
        if key not in index:
            index[key] = len(vertices)
            vertices.append((*plan.points[point], fiducial.base_um + above_um))
        return index[key]

    def lifted(point: int, region: int) -> int:
        return vertex(point, features.above_um(region, *plan.points[point]))

    def face(a: int, b: int, c: int) -> None:
        if len({a, b, c}) == 3:
            faces.append((a, b, c))

    sides: dict[tuple[int, int], int] = {}
    for (a, b, c), region in zip(plan.triangles, plan.regions, strict=True):
        face(lifted(a, region), lifted(b, region), lifted(c, region))
        sides.update({(a, b): region, (b, c): region, (c, a): region})
    under = len(vertices)
    vertices.append((0.0, 0.0, fiducial.base_um - thickness_um))
    for (a, b), region in sides.items():
        other = sides.get((b, a))
        if other is None:
            # Rim of the plate: its side, and a slice of the underside.
            low_a, low_b = vertex(a, -thickness_um), vertex(b, -thickness_um)
            face(lifted(b, region), lifted(a, region), low_a)
            face(lifted(b, region), low_a, low_b)
            face(under, low_b, low_a)
        elif region > other:
            # Both ends in turn: where one end has no height, one of the two triangles has no area.
            face(lifted(b, region), lifted(a, region), lifted(a, other))
            face(lifted(b, region), lifted(a, other), lifted(b, other))
    return Solid(np.array(vertices), np.array(faces, dtype=np.int64))
