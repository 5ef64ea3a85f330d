"""Grains are rigid bodies of known size: checked on their meshes, not on the height map they were packed with."""

import math

import numpy as np
import pytest
from scipy.optimize import linprog
from scipy.spatial import cKDTree

from reliefscope_sim.scenes.grains import FAMILIES, Grain, LooseGrain, draw_shape, pour
from reliefscope_sim.scenes.grains.packing import FRICTION
from reliefscope_sim.scenes.grains.shapes import UNIT_VOLUME, mesh_moments

SHAPE, PITCH, RIM_UM = (220, 240), 1.25, 110.0
SPAN_UM = (np.array(SHAPE[::-1]) + math.ceil(RIM_UM / PITCH)) * PITCH
CONTACT_UM = 1.5
"""Gap up to which two grains count as touching: a pixel and a fifth."""


def draw_loose(generator, family, count, low=9.0, high=34.0):
    shapes = [draw_shape(generator, family, (1.0, 0.8, 0.65)) for _ in range(8)]
    radii = np.exp(generator.uniform(np.log(low), np.log(high), count))
    return [LooseGrain(shapes[i % 8], radius, i % 3) for i, radius in enumerate(radii)]


@pytest.fixture(scope="module", params=FAMILIES)
def heap(request):
    generator = np.random.default_rng(5)
    return pour(generator, draw_loose(generator, request.param, 150), SHAPE, PITCH, RIM_UM)


def distances_to(grain: Grain, points):
    """Signed distance in um of points (N, 3) from the surface of a grain, below 0 inside, and normals (N, 3)."""
    vertices, faces = grain.mesh_um()
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    if grain.shape.family == "angular":  # convex: the plane that is farthest below a point
        heights = points @ normals.T - np.einsum("ij,ij->i", normals, a)
        return heights.max(axis=1), normals[heights.argmax(axis=1)]
    at_vertex = np.zeros_like(vertices)
    for corner in range(3):
        np.add.at(at_vertex, faces[:, corner], normals)
    at_vertex /= np.linalg.norm(at_vertex, axis=1, keepdims=True)
    _, nearest = cKDTree(vertices).query(points)
    outward = at_vertex[nearest]
    return np.einsum("ij,ij->i", points - vertices[nearest], outward), outward


def contacts(grains, number):
    """Where a grain touches those below it: arms from its centre, normals toward it, gaps (negative: overlap)."""
    grain = grains[number]
    centre = np.array(grain.centre_um)
    arms = grain.radius_um * grain.shape.contacts[-1] @ grain.rotation.T
    plate = arms[:, 2] + centre[2]
    found = [(arms, np.tile([0.0, 0.0, 1.0], (len(arms), 1)), plate)]
    for other in grains[:number]:
        away = centre - np.array(other.centre_um)
        away[:2] -= SPAN_UM * np.round(away[:2] / SPAN_UM)
        reach = other.radius_um * other.shape.reach
        if np.linalg.norm(away) > reach + grain.radius_um * grain.shape.reach:
            continue
        theirs = np.array(other.centre_um) + away
        close = arms[np.linalg.norm(arms + away, axis=1) < reach + CONTACT_UM]
        if len(close):
            gaps, normals = distances_to(other, close + theirs)
            found.append((close, normals, gaps))
        # Corners of the other one may touch a face between the points of this one.
        vertices, _ = other.mesh_um()
        vertices = vertices + (centre - theirs)
        vertices = vertices[
            np.linalg.norm(vertices - centre, axis=1) < grain.radius_um * grain.shape.reach + 1
        ]
        if len(vertices):
            gaps, normals = distances_to(grain, vertices)
            found.append((vertices - centre, -normals, gaps))
    return tuple(np.concatenate(parts) for parts in zip(*found, strict=True))


def unbalanced(grain, arms, normals, friction):
    """Smallest part of a grain's weight (forces, and moments by its radius) that its contacts cannot carry."""
    thinned = slice(None, None, 1 + len(arms) // 40)  # what some of them can carry, all can
    arms, normals = arms[thinned], normals[thinned]
    generators = []
    for normal, arm in zip(normals, arms, strict=True):
        across = np.cross(normal, [1.0, 0.0, 0.0] if abs(normal[0]) < 0.9 else [0.0, 1.0, 0.0])
        across /= np.linalg.norm(across)
        along = np.cross(normal, across)
        for angle in np.arange(8) * math.pi / 4:
            force = normal + friction * (math.cos(angle) * across + math.sin(angle) * along)
            generators.append([*force, *np.cross(arm, force) / grain.radius_um])
    pushes = np.array(generators).reshape(-1, 6).T
    count = pushes.shape[1]
    return linprog(
        np.r_[np.zeros(count), np.ones(12)],
        A_eq=np.hstack([pushes, np.eye(6), -np.eye(6)]),
        b_eq=[0, 0, 1, 0, 0, 0],
    ).fun


def test_grains_rest_on_each_other_without_running_through(heap):
    """Balance by friction of what touches, on the meshes: on a height map overhangs would carry too."""
    sunk, carried = [], []
    for number in range(0, len(heap.grains), 5):
        arms, normals, gaps = contacts(heap.grains, number)
        touching = gaps < CONTACT_UM
        assert touching.any()
        sunk.append(-gaps.min())
        rest = unbalanced(heap.grains[number], arms[touching], normals[touching], FRICTION)
        carried.append(rest < 0.05)
    # Grains are 18 to 68 um large, and the contacts give way by a fraction of a um.
    assert np.median(sunk) < 1.2
    assert np.quantile(sunk, 0.95) < 3.0
    assert max(sunk) < 5.0
    assert np.mean(carried) > 0.93


def test_a_grain_that_hangs_in_the_air_or_over_an_edge_is_not_balanced():
    grain = pour(
        np.random.default_rng(1),
        draw_loose(np.random.default_rng(1), "angular", 1),
        SHAPE,
        PITCH,
        RIM_UM,
    ).grains[0]
    arms, normals, gaps = contacts((grain,), 0)
    touching = gaps < CONTACT_UM
    assert unbalanced(grain, arms[touching], normals[touching], FRICTION) < 1e-6
    one_side = touching & (arms[:, 0] > 0.2 * grain.radius_um)
    assert unbalanced(grain, arms[one_side], normals[one_side], FRICTION) > 0.1
    assert unbalanced(grain, arms[:0], normals[:0], FRICTION) == pytest.approx(1.0)


def highest_above(grain: Grain, x, y):
    """Height of a grain's surface on the vertical line through (x, y), by the triangles that it meets."""
    vertices, faces = grain.mesh_um()
    (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (vertices[faces[:, k]].T for k in range(3))
    twice = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
    with np.errstate(divide="ignore", invalid="ignore"):
        u = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / twice
        v = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / twice
    met = (u >= 0) & (v >= 0) & (u + v <= 1)
    return (az + u * (bz - az) + v * (cz - az))[met].max(initial=0.0)


def test_surface_and_labels_are_those_of_the_grains(heap):
    rows, columns = SHAPE
    for row, column in np.random.default_rng(7).integers(0, SHAPE, (40, 2)):
        place = np.array([column - (columns - 1) / 2, (rows - 1) / 2 - row]) * PITCH
        heights = []
        for grain in heap.grains:
            away = np.array(grain.centre_um[:2]) - place
            around = SPAN_UM * np.round(away / SPAN_UM)
            near = np.hypot(*(away - around)) < grain.radius_um * grain.shape.reach
            heights.append(highest_above(grain, *(place + around)) if near else 0.0)
        assert heap.height_um[row, column] == pytest.approx(max(heights), abs=1e-3)
        number = heap.grain_index[row, column]
        assert number == (np.argmax(heights) if max(heights) > 0 else -1)


@pytest.mark.parametrize("family", FAMILIES)
def test_a_shape_has_the_volume_of_its_scale_about_its_centre_of_mass(family):
    generator = np.random.default_rng(3)
    for _ in range(5):
        shape = draw_shape(generator, family, (1.0, 0.7, 0.5))
        volume, centre, second = mesh_moments(shape.vertices, shape.faces)
        assert volume == pytest.approx(UNIT_VOLUME, rel=1e-9)
        assert np.abs(centre).max() < 1e-9
        assert np.allclose(second, np.diag(np.diag(second)), atol=1e-9)
        assert second[0, 0] > second[1, 1] > second[2, 2]
        edges = np.sort(shape.faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
        _, uses = np.unique(edges, axis=0, return_counts=True)
        assert (uses == 2).all()
        # Every contact point lies on the surface: none is farther out than the mesh's vertices.
        assert all(len(points) >= 42 for points in shape.contacts)
        assert np.linalg.norm(shape.contacts[-1], axis=1).max() <= shape.reach + 1e-9


def test_moments_of_a_box_are_those_of_the_text_book():
    corners = np.array([[x, y, z] for x in (1, 4) for y in (0, 2) for z in (-1, 0)], dtype=float)
    faces = np.array(
        [
            [0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
            [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3],
        ]
    )  # fmt: skip
    volume, centre, second = mesh_moments(corners, faces)
    assert volume == pytest.approx(6.0)
    assert np.allclose(centre, [2.5, 1.0, -0.5])
    assert np.allclose(second, np.diag([9 / 12, 4 / 12, 1 / 12]))


def test_angular_grains_are_convex_and_rough_ones_are_not():
    generator = np.random.default_rng(4)

    def bulge(family):
        shape = draw_shape(generator, family, (1.0, 0.8, 0.7))
        a, b, c = (shape.vertices[shape.faces[:, k]] for k in range(3))
        normals = np.cross(b - a, c - a)
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        above = shape.vertices[::8] @ normals.T - np.einsum("ij,ij->i", normals, a)
        return above.max()

    assert bulge("angular") < 1e-9
    assert bulge("rough") > 0.05


def test_a_ball_that_is_dropped_on_the_plate_stays_where_it_fell_and_a_tall_grain_falls_over():
    generator = np.random.default_rng(6)
    ball = draw_shape(generator, "rounded", (1.0, 1.0, 1.0))
    slab = draw_shape(generator, "angular", (1.0, 0.8, 0.3))
    on_edge = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]).T
    tilted = on_edge @ np.array([[1, 0, 0], [0, 0.94, -0.34], [0, 0.34, 0.94]])
    loose = [
        LooseGrain(ball, 20.0, 0, "ball", (-80.0, 0.0), np.eye(3)),
        LooseGrain(slab, 20.0, 0, "slab", (80.0, 0.0), tilted),
    ]
    heap = pour(generator, loose, SHAPE, PITCH, RIM_UM)
    fallen_ball, fallen_slab = heap.grains
    assert np.hypot(fallen_ball.centre_um[0] + 80, fallen_ball.centre_um[1]) < 15
    assert 15 < fallen_ball.centre_um[2] < 22
    assert abs(fallen_slab.rotation[2, 2]) > 0.85
    assert fallen_slab.centre_um[2] < 0.75 * fallen_slab.size_um[2]
    for grain in heap.grains:
        assert np.allclose(grain.rotation @ grain.rotation.T, np.eye(3), atol=1e-9)
        assert grain.volume_um3 == pytest.approx(4 / 3 * math.pi * 20**3)
