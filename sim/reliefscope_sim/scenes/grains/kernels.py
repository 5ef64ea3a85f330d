"""Compiled kernels of the heap: one grain comes to rest on it, and becomes part of it.

The heap is a height map (rows, columns) in um that repeats itself in both directions, so that it has no walls.
A grain's position is (x, y, z) in um with y up: column ``x / pixel_um``, row ``-y / pixel_um``.  The grain's
mass and gravity are 1 and lengths um, which sets the unit of time: only the rest matters, not how long it
took to get there.  One thread does all of it in a fixed order: the result does not depend on their number.
"""

from __future__ import annotations

import math

import numpy as np
from numba import njit
from numpy.typing import NDArray

from reliefscope.units import FloatImage

Vectors = NDArray[np.float64]
"""Points or vectors (N, 3) in um."""

STIFFNESS = 6.0
"""Weights per um: one point that carries the whole grain sinks by 0.17 um."""
_DAMPING = 1.0
"""Share of a contact's speed that is lost per unit of time and mass."""
_DRAG = 0.3
_GRIP = 1.0
"""Friction per speed of sliding, up to Coulomb's limit: at rest it holds but for a slow creep."""
_STEP = 0.16
_DEEPEST_UM = 2.0
"""Overlap from which a contact does not get stiffer: a wall that is met at speed does not throw the grain."""
_LOOK_AROUND, _NEAR_UM = 4, 4.0
"""Every so many steps the points are found that are less than so far above the heap: only they can touch."""
_WALL_PX = 8
"""Pixels within which a point behind a wall looks for the way back."""
_COMPASS = np.array(
    [(math.cos(k * math.pi / 4), math.sin(k * math.pi / 4)) for k in range(8)], dtype=np.float64
)
_SLOWEST = 0.1
"""Speed (um per unit of time) below which a grain in contact is at rest."""
_REST_STEPS = 12


@njit(cache=True)
def rest_height(
    heap: FloatImage, pixel_um: float, points: Vectors, rotation: Vectors, x: float, y: float
) -> float:
    """Height of the centre at which a grain that falls straight down first touches."""
    per_um = 1.0 / pixel_um
    highest = -1e30
    for i in range(len(points)):
        dx, dy, dz = _turned(rotation, points[i])
        highest = max(highest, _ground(heap, per_um, x + dx, y + dy) - dz)
    return highest


@njit(cache=True)
def settle(
    heap: FloatImage,
    pixel_um: float,
    points: Vectors,
    reach_um: float,
    friction: float,
    most_steps: int,
    position: Vectors,
    rotation: Vectors,
) -> int:
    """Let a grain roll and slide under gravity until it rests; returns the steps it took.

    ``points`` (N, 3) lie on its surface, about its centre of mass; ``position`` (3,) and ``rotation`` (3, 3,
    body to world) are changed in place.  Contacts are damped springs along the heap's normal with Coulomb
    ``friction``; the moment of inertia is that of a sphere of ``reach_um``, the largest
    distance of a point from the centre: larger than it is, which keeps long grains from being shaken by their
    own contacts.
    """
    inertia = 0.4 * reach_um * reach_um
    top = 0.5 * reach_um
    per_um = 1.0 / pixel_um
    velocity = np.zeros(3)
    spin = np.zeros(3)
    near = np.empty(len(points), dtype=np.int64)
    count = 0
    quiet = 0
    for step in range(most_steps):
        fx, fy, fz = 0.0, 0.0, 0.0
        tx, ty, tz = 0.0, 0.0, 0.0
        touching = 0
        if step % _LOOK_AROUND == 0:
            count = _find_near(heap, per_um, points, top, position, rotation, near)
        for k in range(count):
            dx, dy, dz = _turned(rotation, points[near[k]])
            x, y, z = position[0] + dx, position[1] + dy, position[2] + dz
            sunk = _ground(heap, per_um, x, y) - z
            if sunk <= 0.0:
                continue
            touching += 1
            nx, ny, nz = _normal(heap, per_um, x, y)
            depth = sunk * nz
            if depth > pixel_um:
                nx, ny, nz, depth = _way_out(heap, pixel_um, x, y, z, nx, ny, nz, depth)
            vx = velocity[0] + spin[1] * dz - spin[2] * dy
            vy = velocity[1] + spin[2] * dx - spin[0] * dz
            vz = velocity[2] + spin[0] * dy - spin[1] * dx
            approach = vx * nx + vy * ny + vz * nz
            normal = max(STIFFNESS * min(depth, _DEEPEST_UM) - _DAMPING * approach, 0.0)
            vx, vy, vz = vx - approach * nx, vy - approach * ny, vz - approach * nz
            sliding = math.sqrt(vx * vx + vy * vy + vz * vz) + 1e-12
            hold = min(_GRIP, friction * normal / sliding)
            px, py, pz = normal * nx - hold * vx, normal * ny - hold * vy, normal * nz - hold * vz
            fx, fy, fz = fx + px, fy + py, fz + pz
            tx += dy * pz - dz * py
            ty += dz * px - dx * pz
            tz += dx * py - dy * px
        # A face that lies flat touches in many points: together they are as stiff as two.
        share = min(1.0, 2.0 / max(touching, 1))
        keep = 1.0 - _DRAG * _STEP
        velocity[0] = keep * (velocity[0] + _STEP * share * fx)
        velocity[1] = keep * (velocity[1] + _STEP * share * fy)
        velocity[2] = keep * (velocity[2] + _STEP * (share * fz - 1.0))
        spin[0] = keep * (spin[0] + _STEP * share * tx / inertia)
        spin[1] = keep * (spin[1] + _STEP * share * ty / inertia)
        spin[2] = keep * (spin[2] + _STEP * share * tz / inertia)
        position += _STEP * velocity
        _spin(rotation, spin * _STEP)
        speed = math.sqrt((velocity**2).sum()) + reach_um * math.sqrt((spin**2).sum())
        quiet = quiet + 1 if touching > 0 and speed < _SLOWEST else 0
        if quiet == _REST_STEPS:
            return step + 1
    return most_steps


@njit(cache=True)
def _find_near(
    heap: FloatImage,
    per_um: float,
    points: Vectors,
    top: float,
    position: Vectors,
    rotation: Vectors,
    near: NDArray[np.int64],
) -> int:
    """List in ``near`` the points that may touch within the next steps; returns how many there are."""
    count = 0
    for i in range(len(points)):
        dx, dy, dz = _turned(rotation, points[i])
        if dz > top:
            continue
        above = position[2] + dz - _ground(heap, per_um, position[0] + dx, position[1] + dy)
        if above < _NEAR_UM:
            near[count] = i
            count += 1
    return count


@njit(cache=True)
def cover(
    heap: FloatImage,
    owner: NDArray[np.int32],
    pixel_um: float,
    vertices: Vectors,
    faces: NDArray[np.int32],
    index: int,
) -> None:
    """Make the upper side of a mesh part of the heap; ``owner`` gets ``index`` where it is on top.

    Vertices (V, 3) in um, faces (F, 3) counter-clockwise seen from outside.
    """
    rows, columns = heap.shape
    for f in range(len(faces)):
        a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
        ax, ay, az = vertices[a, 0] / pixel_um, -vertices[a, 1] / pixel_um, vertices[a, 2]
        bx, by, bz = vertices[b, 0] / pixel_um, -vertices[b, 1] / pixel_um, vertices[b, 2]
        cx, cy, cz = vertices[c, 0] / pixel_um, -vertices[c, 1] / pixel_um, vertices[c, 2]
        # Rows grow downward: seen from above, upper faces run clockwise in the array.
        area = (cx - ax) * (by - ay) - (bx - ax) * (cy - ay)
        if area <= 1e-12:
            continue
        for row in range(math.ceil(min(ay, by, cy)), math.floor(max(ay, by, cy)) + 1):
            for column in range(math.ceil(min(ax, bx, cx)), math.floor(max(ax, bx, cx)) + 1):
                wb = ((cx - ax) * (row - ay) - (column - ax) * (cy - ay)) / area
                wc = ((column - ax) * (by - ay) - (bx - ax) * (row - ay)) / area
                wa = 1.0 - wb - wc
                if wa < -1e-9 or wb < -1e-9 or wc < -1e-9:
                    continue
                height = np.float32(wa * az + wb * bz + wc * cz)
                if height > heap[row % rows, column % columns]:
                    heap[row % rows, column % columns] = height
                    owner[row % rows, column % columns] = index


@njit(cache=True, inline="always")
def _turned(rotation: Vectors, point: Vectors) -> tuple[float, float, float]:
    return (
        rotation[0, 0] * point[0] + rotation[0, 1] * point[1] + rotation[0, 2] * point[2],
        rotation[1, 0] * point[0] + rotation[1, 1] * point[1] + rotation[1, 2] * point[2],
        rotation[2, 0] * point[0] + rotation[2, 1] * point[1] + rotation[2, 2] * point[2],
    )


@njit(cache=True, inline="always")
def _corner(place: float, count: int) -> tuple[int, int, float]:
    """The two neighbours of a place in pixels on an axis that repeats itself, and how far it is between them."""
    first = math.floor(place)
    part = place - first
    index = int(first)
    while index < 0:
        index += count
    while index >= count:
        index -= count
    return index, index + 1 if index + 1 < count else 0, part


@njit(cache=True, inline="always")
def _ground(heap: FloatImage, per_um: float, x: float, y: float) -> float:
    """Height of the heap at a point; ``per_um`` is pixels per um."""
    c0, c1, u = _corner(x * per_um, heap.shape[1])
    r0, r1, v = _corner(-y * per_um, heap.shape[0])
    upper = heap[r0, c0] + u * (heap[r0, c1] - heap[r0, c0])
    lower = heap[r1, c0] + u * (heap[r1, c1] - heap[r1, c0])
    height: float = upper + v * (lower - upper)
    return height


@njit(cache=True, inline="always")
def _normal(heap: FloatImage, per_um: float, x: float, y: float) -> tuple[float, float, float]:
    """Unit normal of the heap at a point."""
    c0, c1, u = _corner(x * per_um, heap.shape[1])
    r0, r1, v = _corner(-y * per_um, heap.shape[0])
    h00, h01 = heap[r0, c0], heap[r0, c1]
    h10, h11 = heap[r1, c0], heap[r1, c1]
    rise_x = ((1.0 - v) * (h01 - h00) + v * (h11 - h10)) * per_um
    rise_y = ((1.0 - u) * (h00 - h10) + u * (h01 - h11)) * per_um
    nz = 1.0 / math.sqrt(1.0 + rise_x * rise_x + rise_y * rise_y)
    return -rise_x * nz, -rise_y * nz, nz


@njit(cache=True)
def _way_out(
    heap: FloatImage,
    pixel_um: float,
    x: float,
    y: float,
    z: float,
    nx: float,
    ny: float,
    nz: float,
    depth: float,
) -> tuple[float, float, float, float]:
    """Shortest way out of the heap for a point in it: unit vector and length.

    The normal of a height map says nothing behind a wall, so look level in eight directions too.
    """
    nearest = depth
    for k in range(8):
        ux, uy = _COMPASS[k, 0], _COMPASS[k, 1]
        away = pixel_um
        while away < nearest and away <= _WALL_PX * pixel_um:
            if _ground(heap, 1.0 / pixel_um, x + away * ux, y + away * uy) < z:
                nearest = away
                nx, ny, nz = ux, uy, 0.0
                break
            away += pixel_um
    return nx, ny, nz, nearest


@njit(cache=True, inline="always")
def _spin(rotation: Vectors, turn: Vectors) -> None:
    """Turn a rotation matrix by the small vector ``turn`` (rad, world axes), keeping it orthonormal."""
    for k in range(3):
        a, b, c = rotation[0, k], rotation[1, k], rotation[2, k]
        rotation[0, k] = a + turn[1] * c - turn[2] * b
        rotation[1, k] = b + turn[2] * a - turn[0] * c
        rotation[2, k] = c + turn[0] * b - turn[1] * a
    norm = math.sqrt((rotation[:, 0] ** 2).sum())
    rotation[:, 0] /= norm
    rotation[:, 1] -= (rotation[:, 0] * rotation[:, 1]).sum() * rotation[:, 0]
    norm = math.sqrt((rotation[:, 1] ** 2).sum())
    rotation[:, 1] /= norm
    rotation[0, 2] = rotation[1, 0] * rotation[2, 1] - rotation[2, 0] * rotation[1, 1]
    rotation[1, 2] = rotation[2, 0] * rotation[0, 1] - rotation[0, 0] * rotation[2, 1]
    rotation[2, 2] = rotation[0, 0] * rotation[1, 1] - rotation[1, 0] * rotation[0, 1]
