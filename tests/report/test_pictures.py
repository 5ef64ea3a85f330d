from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from reliefscope import axes
from reliefscope.jobs import Job
from reliefscope.reconstruction.result import Reconstruction
from reliefscope.reconstruction.settings import Settings
from reliefscope.report.oblique import FLAT_LIGHT, render_oblique, shade
from reliefscope.report.pictures import write_pictures

PIXEL_UM = 1.12


@pytest.fixture(scope="module")
def example() -> Reconstruction:
    x_um, y_um = axes.pixel_grid_um((60, 80), PIXEL_UM)
    height = (20 * np.exp(-(x_um[None, :] ** 2 + y_um[:, None] ** 2) / 300)).astype(np.float32)
    height[:4, :4] = np.nan
    quality = np.linspace(0, 1, 4800, dtype=np.float32).reshape(60, 80)
    normals = axes.normals_from_height(np.nan_to_num(height), PIXEL_UM)
    return Reconstruction(
        height_um=height,
        pixel_um=PIXEL_UM,
        settings=Settings(),
        kind="fused",
        sigma_um=quality + np.float32(0.2),
        stereo_height_um=height,
        stereo_quality=quality,
        normals=normals,
        albedo=quality + 0.1,
        photometric_quality=quality,
        micrograph=quality,
    )


def test_every_picture_is_written(example: Reconstruction, tmp_path: Path) -> None:
    stages: list[str] = []
    job = Job(lambda progress: stages.append(progress.stage))
    written = write_pictures(example, tmp_path / "new", job)
    assert [path.stem for path in written] == [
        "overview",
        "fused",
        "oblique",
        "uncertainty",
        "height_map",
        "quality_stereo",
        "normals",
        "slant",
        "quality_photometric",
        "micrograph",
    ]
    assert set(stages) == {"pictures"}
    for path in written:
        image = cv2.imread(str(path))
        assert image is not None, path
        assert image.std() > 5
    assert len(list((tmp_path / "new").iterdir())) == len(written)


def test_only_what_is_there_is_drawn(example: Reconstruction, tmp_path: Path) -> None:
    lone = replace(
        example,
        kind="stereo",
        sigma_um=None,
        normals=None,
        albedo=None,
        photometric_quality=None,
        micrograph=None,
    )
    names = {path.stem for path in write_pictures(lone, tmp_path)}
    assert names == {"overview", "stereo", "oblique", "height_map", "quality_stereo"}
    nothing = replace(lone, height_um=np.full((60, 80), np.nan, np.float32))
    write_pictures(nothing, tmp_path)


def test_saturated_pixels_are_red(example: Reconstruction, tmp_path: Path) -> None:
    assert example.micrograph is not None
    saturated = np.zeros((60, 80), bool)
    clean = write_pictures(replace(example, saturated=saturated), tmp_path / "clean")
    assert "saturated" not in {path.stem for path in clean}
    saturated[:, 40:] = True
    written = write_pictures(replace(example, saturated=saturated), tmp_path / "burnt")
    image = cv2.imread(str(next(path for path in written if path.stem == "saturated")))
    assert image is not None
    row = image.shape[0] // 2
    assert (image[row, 145] == (40, 39, 214)).all()  # blue first
    assert np.ptp(image[row, 100]) == 0


def test_what_the_mask_leaves_out_is_blank(example: Reconstruction, tmp_path: Path) -> None:
    valid = np.zeros((60, 80), bool)
    valid[:, 40:] = True
    masked = replace(example, valid=valid, height_um=np.where(valid, example.height_um, np.nan))
    before = {path.stem: cv2.imread(str(path)) for path in write_pictures(example, tmp_path / "a")}
    after = {path.stem: cv2.imread(str(path)) for path in write_pictures(masked, tmp_path / "b")}
    for name in ("height_map", "normals", "slant", "quality_stereo", "quality_photometric"):
        blank = (237, 234, 232)  # blue first
        left, right = slice(100, 104), slice(145, 149)
        row = before[name].shape[0] // 2
        assert (after[name][row, left] == blank).all(), name
        assert not (before[name][row, left] == blank).all(), name
        assert (after[name][row, right] == before[name][row, right]).all(), name


def test_large_things_are_shown_in_millimetres(
    example: Reconstruction, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from matplotlib.axes import Axes

    labels: list[str] = []
    monkeypatch.setattr(Axes, "set_xlabel", lambda _, text, **__: labels.append(text))
    statue = replace(example, pixel_um=400.0, height_um=example.height_um * 400)
    write_pictures(statue, tmp_path / "statue")
    assert set(labels) == {"x (mm)"}
    labels.clear()
    write_pictures(example, tmp_path / "fiducial")
    assert set(labels) == {"x (µm)"}


def test_oblique_view_hides_what_lies_behind_a_wall() -> None:
    """A wall of 40 um across the middle hides 40 tan(30 deg) um of the floor behind it."""
    height = np.zeros((100, 40), np.float32)
    height[50:54] = 40.0
    colour = np.zeros((100, 40, 3), np.float32)
    colour[:50, :, 0] = 1.0  # behind the wall: red
    colour[50:54, :, 1] = 1.0  # the wall: green
    colour[54:, :, 2] = 1.0  # in front: blue
    image = render_oblique(height, colour, 1.0, tilt_deg=30.0)
    column = image[:, 20]
    red = np.sum((column[:, 0] > 0.6) & (column[:, 2] < 0.5))
    blue = np.sum((column[:, 2] > 0.99) & (column[:, 0] < 0.5))
    assert red == pytest.approx(50 * np.cos(np.pi / 6) - 40 * np.sin(np.pi / 6), abs=2.5)
    assert blue == pytest.approx(46 * np.cos(np.pi / 6), abs=2.5)


def test_shade_lights_slopes_toward_the_upper_left() -> None:
    x_um, y_um = axes.pixel_grid_um((40, 40), 1.0)
    slope = (0.5 * x_um[None, :] - 0.5 * y_um[:, None]).astype(np.float32)
    toward = shade(slope, 1.0)[20, 20]
    away = shade(-slope, 1.0)[20, 20]
    assert toward > FLAT_LIGHT > away
    assert shade(np.zeros((40, 40), np.float32), 1.0)[20, 20] == pytest.approx(FLAT_LIGHT)
