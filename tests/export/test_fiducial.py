"""The fiducial's solid and truth: closed, exact, in one frame, and never in place of another file."""

import json

import numpy as np
import pytest
import trimesh
from PIL import Image

from reliefscope.errors import DatasetError, InvalidInputError, OutputExistsError
from reliefscope.export.fiducial import write_fiducial_stl, write_fiducial_truth
from reliefscope.export.solid import Plate, closed_form_volume_um3, fiducial_solid
from reliefscope.targets import SECTIONS, Fiducial3D


@pytest.fixture(scope="module")
def solid():
    return fiducial_solid(Fiducial3D())


def as_mesh(solid):
    return trimesh.Trimesh(solid.vertices_um, solid.faces, process=False)


@pytest.mark.parametrize(
    ("unit", "um", "scale", "seed"),
    [("mm", 1000, 1.0, 1), ("um", 1, 0.1, 5), ("mm", 1000, 10.0, 2)],
)
def test_a_program_that_reads_the_stl_finds_one_closed_manifold_solid(
    tmp_path, unit, um, scale, seed
):
    target = Fiducial3D(seed=seed, scale=scale)
    report = write_fiducial_stl(tmp_path / "f.stl", target, unit=unit)
    mesh = trimesh.load_mesh(tmp_path / "f.stl")  # corners joined by place, as a slicer does
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert mesh.euler_number == 2
    assert mesh.body_count == 1
    assert len(mesh.faces) == report.triangles
    low, high = mesh.bounds * um
    assert low == pytest.approx([-600 * scale, -600 * scale, -47 - 200 * scale], rel=1e-6)
    assert high == pytest.approx([600 * scale, 600 * scale, -47 + 100 * scale], rel=1e-5)
    assert mesh.volume * um**3 == pytest.approx(closed_form_volume_um3(target), rel=1e-4)


def test_volume_of_the_relief_alone_is_its_closed_form(solid):
    target = Fiducial3D()
    plate_um3 = 1200.0**2 * 200
    by_hand = (
        50 * 50**3
        + sum(100**2 * plane.lift_um for plane in target.planes)
        + 2 * 2 / 3 * np.pi * (100**3 + 75**3)
    )
    assert closed_form_volume_um3(target) - plate_um3 == pytest.approx(by_hand, rel=1e-9)
    assert as_mesh(solid).volume - plate_um3 == pytest.approx(by_hand, rel=1e-3)


def test_no_edge_of_the_solid_has_more_than_two_faces(solid):
    edges = np.sort(solid.faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    _, counts = np.unique(edges, axis=0, return_counts=True)
    assert (counts == 2).all()
    assert len(np.unique(solid.vertices_um, axis=0)) == len(solid.vertices_um)


def test_seen_from_above_the_solid_has_the_height_of_the_truth(solid):
    target = Fiducial3D()
    rng = np.random.default_rng(0)
    corners = solid.vertices_um[solid.faces]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    above = (normal[:, 2] > 1e-9) & (corners[..., 2].min(axis=1) >= -47 - 1e-9)
    chosen = np.flatnonzero(above)[rng.choice(above.sum(), 4000, replace=False)]
    weights = rng.dirichlet([2, 2, 2], size=len(chosen))
    points = np.einsum("fk,fkc->fc", weights, corners[chosen])
    pixel_um, middle = 0.4, 1500
    truth = target.height_um((2 * middle + 1, 2 * middle + 1), pixel_um)
    column = np.rint(points[:, 0] / pixel_um).astype(int) + middle
    row = middle - np.rint(points[:, 1] / pixel_um).astype(int)
    difference = np.abs(points[:, 2] - truth[row, column])
    # Half a pixel aside a plane of 40 degrees is 0.24 um higher; beside walls and rims the pixel may be another's.
    near = truth[np.clip(row + 1, 0, 3000), column] - truth[np.clip(row - 1, 0, 3000), column]
    across = truth[row, np.clip(column + 1, 0, 3000)] - truth[row, np.clip(column - 1, 0, 3000)]
    smooth = np.hypot(near, across) < 1.0
    assert smooth.sum() > 1500
    assert difference[smooth].max() < 0.6


def test_planes_are_exact_and_hemispheres_within_the_deviation(solid):
    target = Fiducial3D()
    vertices = solid.vertices_um
    for ball in target.hemispheres:
        offset = vertices - [*ball.centre_um, target.base_um]
        inside = np.hypot(offset[:, 0], offset[:, 1]) <= ball.radius_um + 1e-6
        # Also the plate's underside lies below: only what stands on the base.
        radius = np.linalg.norm(offset[inside & (offset[:, 2] > -1e-9)], axis=1)
        assert radius == pytest.approx(np.full(len(radius), ball.radius_um), abs=1e-6)
        middle = solid.vertices_um[solid.faces].mean(axis=1) - [*ball.centre_um, target.base_um]
        on_ball = (np.linalg.norm(middle, axis=1) < ball.radius_um) & (middle[:, 2] > 0)
        assert np.linalg.norm(middle[on_ball], axis=1).min() > ball.radius_um - 0.05
    mesh = as_mesh(solid)
    for plane in target.planes:
        centre = mesh.triangles_center - [*plane.centre_um, 0.0]
        top = (np.abs(centre[:, :2]).max(axis=1) < 49.99) & (mesh.face_normals[:, 2] > 0.1)
        wanted = np.array([-plane.slope_x, -plane.slope_y, 1.0])
        wanted /= np.linalg.norm(wanted)
        assert top.any()
        assert np.abs(mesh.face_normals[top] - wanted).max() < 1e-6
        assert mesh.area_faces[top].sum() == pytest.approx(100**2 / wanted[2], rel=1e-6)


def test_finer_facets_come_nearer_to_the_ball():
    target = Fiducial3D()
    lost = [
        closed_form_volume_um3(target) - as_mesh(fiducial_solid(target, deviation_um=value)).volume
        for value in (2.0, 0.2)
    ]
    assert 0 < lost[1] < lost[0] / 5


@pytest.mark.parametrize("name", ["t.npz", "t.tif"])
def test_truth_is_the_height_of_the_target_with_its_scale(tmp_path, name):
    target = Fiducial3D(seed=4, scale=0.5)
    report = write_fiducial_truth(tmp_path / name, target, pixel_um=2.5, shape=(210, 230))
    expected = target.height_um((210, 230), 2.5)
    if name.endswith("npz"):
        with np.load(tmp_path / name) as file:
            height, metadata = file["height_um"], json.loads(str(file["metadata"]))
            assert file["pixel_um"] == 2.5
            for section in SECTIONS:
                wanted = target.mask(section, (210, 230), 2.5)
                assert np.array_equal(file[f"section_{section}"], wanted)
    else:
        with Image.open(tmp_path / name) as image:
            height, metadata = np.asarray(image), json.loads(image.tag_v2[270])
            assert float(image.tag_v2[282]) == pytest.approx(4000)  # pixels per centimetre
            assert image.tag_v2[296] == 3
    assert height.dtype == np.float32
    assert np.array_equal(height, expected)
    assert (metadata["scale"], metadata["seed"], metadata["base_um"]) == (0.5, 4, -47.0)
    assert metadata["schema_version"] == 1
    assert report.lowest_um == expected.min()


def test_truth_without_a_shape_is_the_square(tmp_path):
    report = write_fiducial_truth(tmp_path / "t.npz", Fiducial3D(scale=2.0), pixel_um=10.0)
    assert report.shape == (200, 200)


def test_nothing_is_overwritten(tmp_path):
    for name, write in (("f.stl", write_fiducial_stl), ("f.npz", write_fiducial_truth)):
        place = tmp_path / name
        place.write_bytes(b"mine")
        with pytest.raises(OutputExistsError):
            write(place)
        assert place.read_bytes() == b"mine"


def test_refusals_leave_nothing_behind(tmp_path):
    with pytest.raises(InvalidInputError, match="does not end in"):
        write_fiducial_stl(tmp_path / "f.obj")
    with pytest.raises(InvalidInputError, match="no unit"):
        write_fiducial_stl(tmp_path / "f.stl", unit="inch")
    with pytest.raises(InvalidInputError, match="Facets"):
        write_fiducial_stl(tmp_path / "f.stl", deviation_um=0.0)
    with pytest.raises(InvalidInputError, match="thickness"):
        Plate(thickness_um=0.0)
    with pytest.raises(InvalidInputError, match="margin"):
        Plate(margin_um=float("nan"))
    with pytest.raises(InvalidInputError, match="out of bounds"):
        write_fiducial_truth(tmp_path / "f.tif", pixel_um=0.001)
    with pytest.raises(InvalidInputError, match="pixel"):
        write_fiducial_truth(tmp_path / "f.tif", pixel_um=0.0)
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_cannot_be_made_is_an_error_of_the_place(tmp_path):
    (tmp_path / "file").write_text("no folder")
    with pytest.raises(DatasetError):
        write_fiducial_truth(tmp_path / "file" / "t.npz", pixel_um=10.0)
