"""Shapes of grains as closed meshes: rounded, angular, and rough.

Every shape is scaled to the volume of the unit sphere and turned into its principal axes, so that a grain of
scale ``s`` um has the volume ``4/3 pi s^3`` exactly and ``s`` is its volume-equivalent radius.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache, cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull, HalfspaceIntersection

Points = NDArray[np.float64]
Faces = NDArray[np.int32]

FAMILIES = ("rounded", "angular", "rough")
UNIT_VOLUME = 4 / 3 * math.pi
_FINE = 4
"""Subdivisions of the icosahedron for surfaces without facets: 2562 vertices."""
_CONTACT_LEVELS = (1, 2, 3)
"""Subdivisions for contacts: 42, 162 and 642 points."""


@dataclass(frozen=True)
class GrainShape:
    """Closed surface about its centre of mass, principal axes along x (long), y, z (short).

    ``vertices`` (V, 3) and ``faces`` (F, 3; counter-clockwise seen from outside) are the surface itself,
    ``contacts`` sets of points (N, 3) spread over it, from few to many, at which it touches others.  Lengths
    in units of the volume-equivalent radius.
    """

    family: str
    vertices: Points
    faces: Faces
    contacts: tuple[Points, ...]

    @cached_property
    def extents(self) -> tuple[float, float, float]:
        """Size along the principal axes, longest first."""
        spans = np.ptp(self.vertices, axis=0)
        return float(spans[0]), float(spans[1]), float(spans[2])

    @cached_property
    def reach(self) -> float:
        """Largest distance of the surface from the centre of mass."""
        return float(np.linalg.norm(self.vertices, axis=1).max())


def draw_shape(
    generator: np.random.Generator, family: str, axes: tuple[float, float, float]
) -> GrainShape:
    """A shape of a family, stretched in the proportions ``axes``.

    ``rounded``: superellipsoid with gentle waves.  ``angular``: convex polyhedron of 12 to 22 random planes.
    ``rough``: lumpy in several octaves, with hollows.
    """
    if family == "angular":
        return _finish(family, *_polyhedron(generator, np.array(axes)))
    if family == "rounded":
        directions, faces = _icosphere(_FINE)
        blunt = generator.uniform(2.0, 2.8)
        radius = (np.abs(directions) ** blunt).sum(axis=1) ** (-1 / blunt)
        radius *= 1 + _waves(generator, directions, ((2.0, 0.10), (4.5, 0.03), (9.0, 0.010)))
    else:
        directions, faces = _icosphere(_FINE)
        bumps = ((2.0, 0.20), (4.5, 0.11), (9.0, 0.05), (18.0, 0.02))
        field = _waves(generator, directions, bumps)
        # Hollows are deeper than bumps are high, as in broken slag.
        radius = np.exp(field - 0.8 * np.maximum(-field, 0.0))
    return _finish(family, radius[:, None] * directions * np.array(axes), faces)


def _finish(family: str, vertices: Points, faces: Faces) -> GrainShape:
    """Scale to the unit sphere's volume, and move and turn into centre of mass and principal axes."""
    volume, centre, second = mesh_moments(vertices, faces)
    _, axes = np.linalg.eigh(second)
    axes = axes[:, ::-1]
    if np.linalg.det(axes) < 0:
        axes[:, 2] *= -1
    vertices = (vertices - centre) @ axes * (UNIT_VOLUME / volume) ** (1 / 3)
    contacts = tuple(_surface_points(vertices, faces, level) for level in _CONTACT_LEVELS)
    return GrainShape(family, vertices, faces, contacts)


def mesh_moments(vertices: Points, faces: Faces) -> tuple[float, Points, Points]:
    """Volume, centre of mass (3,) and second moments (3, 3) about it of a closed mesh of even density.

    Sums over the tetrahedra that the faces span with the origin.
    """
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    parts = np.einsum("ij,ij->i", a, np.cross(b, c)) / 6
    volume = float(parts.sum())
    together = a + b + c
    centre = (parts @ together) / (4 * volume)
    products = sum(
        np.einsum("n,ni,nj->ij", parts, corner, corner) for corner in (a, b, c, together)
    )
    second = products / 20 / volume - np.outer(centre, centre)
    return volume, centre, second


def _polyhedron(generator: np.random.Generator, axes: Points) -> tuple[Points, Faces]:
    """Intersection of random half spaces, as triangles."""
    count = int(generator.integers(12, 23))
    normals = _spread(generator, count)
    offsets = generator.uniform(0.78, 1.15, count)
    planes = np.column_stack([normals, -offsets])
    corners = HalfspaceIntersection(planes, np.zeros(3)).intersections * axes
    hull = ConvexHull(corners)
    vertices = hull.points[hull.vertices]
    number = np.full(len(hull.points), -1)
    number[hull.vertices] = np.arange(len(hull.vertices))
    faces: Faces = number[hull.simplices].astype(np.int32)
    # Qhull leaves the sense of rotation open: make every face look outward.
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    inward = np.einsum("ij,ij->i", np.cross(b - a, c - a), hull.equations[:, :3]) < 0
    faces[inward] = faces[inward][:, ::-1]
    return vertices, faces


def _spread(generator: np.random.Generator, count: int) -> Points:
    """Directions that keep apart: of eight random ones always the one farthest from those there are."""
    chosen = [_directions(generator, 1)[0]]
    while len(chosen) < count:
        candidates = _directions(generator, 8)
        nearest = (candidates @ np.array(chosen).T).max(axis=1)
        chosen.append(candidates[np.argmin(nearest)])
    return np.array(chosen)


def _directions(generator: np.random.Generator, count: int) -> Points:
    vectors: Points = generator.normal(size=(count, 3))
    vectors /= np.linalg.norm(vectors, axis=1, keepdims=True)
    return vectors


def _waves(
    generator: np.random.Generator, directions: Points, octaves: tuple[tuple[float, float], ...]
) -> Points:
    """Random field (N,) over directions: per octave (wave number, standard deviation) 16 plane waves."""
    field = np.zeros(len(directions))
    for wave_number, deviation in octaves:
        waves = _directions(generator, 16) * wave_number * generator.uniform(0.7, 1.3, (16, 1))
        phases = generator.uniform(0, 2 * math.pi, 16)
        field += deviation * math.sqrt(2 / 16) * np.cos(directions @ waves.T + phases).sum(axis=1)
    return field


def _surface_points(vertices: Points, faces: Faces, level: int) -> Points:
    """Points of a star-shaped mesh, one in each direction of an icosphere."""
    directions, _ = _icosphere(level)
    if len(vertices) > len(directions):
        # The finer icosphere has the coarser one's directions first; turning changes nothing.
        return vertices[: len(directions)]
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    distances = np.einsum("ij,ij->i", normals, a)
    toward = directions @ normals.T
    # A convex body ends at the first plane that a ray meets.
    reach = np.where(toward > 1e-12, distances / np.maximum(toward, 1e-12), np.inf).min(axis=1)
    return np.concatenate([vertices, reach[:, None] * directions])


@cache
def _icosphere(level: int) -> tuple[Points, Faces]:
    """Directions (10 * 4^level + 2, 3) and triangles of a subdivided icosahedron; coarser levels come first."""
    golden = (1 + math.sqrt(5)) / 2
    corners = [(sign * 1.0, other * golden, 0.0) for other in (1, -1) for sign in (-1, 1)]
    points = np.array(
        [np.roll(corner, turn) for turn in (0, 1, 2) for corner in corners], dtype=np.float64
    )
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    hull = ConvexHull(points)
    faces: Faces = hull.simplices.astype(np.int32)
    a, b, c = (points[faces[:, k]] for k in range(3))
    inward = np.einsum("ij,ij->i", np.cross(b - a, c - a), a) < 0
    faces[inward] = faces[inward][:, ::-1]
    for _ in range(level):
        edges = np.sort(faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
        unique, inverse = np.unique(edges, axis=0, return_inverse=True)
        middles = points[unique].sum(axis=1)
        middles /= np.linalg.norm(middles, axis=1, keepdims=True)
        ab, bc, ca = (inverse.reshape(-1, 3)[:, k] + len(points) for k in range(3))
        a, b, c = faces.T
        faces = np.concatenate(
            [
                np.stack(corner, axis=1)
                for corner in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))
            ]
        )
        points = np.concatenate([points, middles])
    return points, faces.astype(np.int32)
