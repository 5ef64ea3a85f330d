"""Readers of height maps: files that we write here, and real ones of instruments."""

import sys

import numpy as np
import pytest
import x3pio
from PIL import Image
from tests.support import shared_data

from reliefscope.errors import InvalidInputError
from reliefscope.export.fiducial import write_fiducial_truth
from reliefscope.surface import read_height_map
from reliefscope.surface.readers import FORMATS
from reliefscope.targets import Fiducial3D

HEIGHTS_UM = np.arange(20.0).reshape(4, 5) ** 1.5 - 10


def test_x3p_comes_in_um_with_its_first_row_at_the_bottom(tmp_path):
    metres = HEIGHTS_UM * 1e-6
    metres[1, 2] = np.nan
    x3pio.write(tmp_path / "a.x3p", metres, x_scale=0.5e-6, y_scale=2e-6)
    height_map = read_height_map(tmp_path / "a.x3p")
    assert np.allclose(height_map.height_um, metres[::-1] * 1e6, rtol=1e-6, equal_nan=True)
    assert height_map.pixel_um == pytest.approx((0.5, 2.0))
    assert height_map.name == "a.x3p"


@pytest.mark.parametrize("suffix", [".npz", ".tif"])
def test_the_truth_of_the_fiducial_can_be_read_back(tmp_path, suffix):
    fiducial = Fiducial3D(scale=0.2)
    write_fiducial_truth(tmp_path / f"truth{suffix}", fiducial, pixel_um=1.25, shape=(90, 120))
    height_map = read_height_map(tmp_path / f"truth{suffix}")
    assert np.allclose(height_map.height_um, fiducial.height_um((90, 120), 1.25), atol=1e-4)
    assert height_map.pixel_um == pytest.approx((1.25, 1.25))


def test_npz_takes_the_only_image_and_two_pixel_sizes(tmp_path):
    np.savez(tmp_path / "a.npz", relief=HEIGHTS_UM, pixel_um=[1.0, 3.0])
    height_map = read_height_map(tmp_path / "a.npz")
    assert np.allclose(height_map.height_um, HEIGHTS_UM)
    assert height_map.pixel_um == (1.0, 3.0)


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16, np.int32, np.float32])
def test_tiff_without_resolution_needs_its_width(tmp_path, dtype):
    values = np.abs(HEIGHTS_UM).astype(dtype)
    Image.fromarray(values).save(tmp_path / "a.tiff")
    with pytest.raises(InvalidInputError, match="does not say how large") as caught:
        read_height_map(tmp_path / "a.tiff")
    assert "width_um" in caught.value.hint
    height_map = read_height_map(tmp_path / "a.tiff", width_um=10.0)
    assert np.allclose(height_map.height_um, values)
    assert height_map.pixel_um == (2.0, 2.0)


def test_what_cannot_be_read_is_refused_with_what_can(tmp_path):
    with pytest.raises(InvalidInputError, match="There is no height map"):
        read_height_map(tmp_path / "absent.x3p")
    for name, content, said in (
        ("a.docx", b"text", "no height map that can be read"),
        ("a.x3p", b"no archive", "could not be read as .x3p"),
        ("a.npz", b"no archive", "could not be read as .npz"),
        ("a.tif", b"no picture", "could not be read as .tif"),
    ):
        (tmp_path / name).write_bytes(content)
        with pytest.raises(InvalidInputError, match=said) as caught:
            read_height_map(tmp_path / name)
        assert caught.value.hint
        if name == "a.docx":
            assert all(suffix in caught.value.hint for suffix in FORMATS)


def test_archives_without_heights_and_pictures_in_colour_are_refused(tmp_path):
    np.savez(tmp_path / "two.npz", a=HEIGHTS_UM, b=HEIGHTS_UM)
    np.savez(tmp_path / "pickled.npz", height_um=np.array([[{}]], dtype=object))
    Image.fromarray(np.zeros((4, 4, 3), dtype=np.uint8)).save(tmp_path / "rgb.tif")
    x3pio.Profile.from_array(np.zeros(9), x_scale=1e-6).save(tmp_path / "profile.x3p")
    for name, said in (
        ("two.npz", "none is `height_um`"),
        ("pickled.npz", "could not be read"),
        ("rgb.tif", "picture"),
        ("profile.x3p", "not a surface"),
    ):
        with pytest.raises(InvalidInputError, match=said):
            read_height_map(tmp_path / name)


def test_real_maps_of_instruments():
    """Sizes, extents and roughness are those of TABLE.txt beside them."""
    folder = shared_data("surface_heightmaps")
    for name, shape, width_um, sq_um, missing in (
        ("x3p-2.x3p", (650, 650), 83.0, 0.0772, 0.0),
        ("x3p-2_um.npz", (650, 650), 83.0, 0.0772, 0.0),
        ("al3d-1_um.npz", (296, 200), 87.6, 0.2898, 0.0),
        ("plu-1_um.npz", (576, 768), 1274.9, 0.0183, 0.0),
        ("sur-2_um.npz", (484, 563), 1961.5, 0.0171, 0.0004),
        ("frt-1_um.npz", (500, 500), 12000.0, 4.396, 0.306),
    ):
        height_map = read_height_map(folder / name)
        assert height_map.height_um.shape == shape
        assert height_map.width_um == pytest.approx(width_um, abs=0.06)
        assert height_map.missing == pytest.approx(missing, abs=5e-4)
        levelled = height_map.levelled().height_um
        assert np.nanstd(levelled) == pytest.approx(sq_um, rel=0.01)
    ours = read_height_map(folder / "x3p-2.x3p").levelled().height_um
    theirs = read_height_map(folder / "x3p-2_um.npz").height_um
    # The archive keeps the rows in the order of the file, lowest first.
    assert np.abs(ours[::-1] - theirs).max() < 1e-6


def test_without_its_library_a_vendor_file_is_refused_with_what_to_install(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "SurfaceTopography", None)
    (tmp_path / "a.sur").write_bytes(b"no surface")
    with pytest.raises(InvalidInputError, match="need the package") as caught:
        read_height_map(tmp_path / "a.sur")
    assert "pip install" in caught.value.hint


def test_a_vendor_file_is_read_where_its_library_is_installed(tmp_path):
    folder = shared_data("surface_heightmaps")
    pytest.importorskip(
        "SurfaceTopography", reason="SurfaceTopography is not installed", exc_type=ImportError
    )
    (tmp_path / "a.sur").write_bytes(b"no surface")
    with pytest.raises(InvalidInputError, match="could not be read as"):
        read_height_map(tmp_path / "a.sur")
    height_map = read_height_map(folder / "sur-2.sur").levelled()
    reference = read_height_map(folder / "sur-2_um.npz")
    assert height_map.pixel_um == pytest.approx(reference.pixel_um, rel=1e-6)
    assert np.nanmax(np.abs(height_map.height_um - reference.height_um[::-1])) < 1e-5
