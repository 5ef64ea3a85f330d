"""Photographs of a plaster cat under twelve known lights: import, normals, relief."""

from pathlib import Path

import cv2
import numpy as np
import pytest
import yaml
from tests.support import shared_data

from reliefscope.dataset import import_photographs
from reliefscope.evaluation.heights import height_errors
from reliefscope.microscope import estimate_lights
from reliefscope.reconstruction.pipeline import reconstruct
from reliefscope.reconstruction.result import Reconstruction
from reliefscope.reconstruction.settings import settings_for


@pytest.fixture(scope="module")
def description(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The cat stands before black cloth: its mask is what the photographs show of it."""
    data = shared_data("psbox_cat")
    folder = tmp_path_factory.mktemp("cat")
    photographs = [cv2.imread(str(path), 0) for path in sorted((data / "Objects").glob("*.png"))]
    bright = (np.mean(photographs, axis=0) > 25).astype(np.uint8)
    opened = cv2.morphologyEx(bright, cv2.MORPH_OPEN, np.ones((9, 9)))
    _, labels, sizes, _ = cv2.connectedComponentsWithStats(opened)
    cv2.imwrite(
        str(folder / "mask.png"), 255 * (labels == 1 + sizes[1:, 4].argmax()).astype(np.uint8)
    )
    directions = np.loadtxt(data / "light_directions.txt").T
    content = {
        "folder": str(data / "Objects"),
        "pixel_um": 1.0,
        "lights": [{"direction": [float(v) for v in vector]} for vector in directions],
        "pattern": "Image_{light:02d}.png",
        "first": 1,
        "sensor": "mono",
        "bit_depth": 8,
        "y_axis": "up",
        "mask": {"file": str(folder / "mask.png")},
    }
    path = folder / "cat.yml"
    path.write_text(yaml.safe_dump(content))
    return path


@pytest.fixture(scope="module")
def cat(description: Path, tmp_path_factory: pytest.TempPathFactory) -> Reconstruction:
    run = import_photographs(description, tmp_path_factory.mktemp("runs") / "cat")
    return reconstruct(run, settings_for("paper"))


def test_normals_and_relief_of_the_cat(cat: Reconstruction) -> None:
    assert cat.kind == "integrated"
    assert cat.normals is not None
    assert cat.photometric_quality is not None
    assert cat.residual is not None
    inside = np.isfinite(cat.height_um)
    assert 0.25 < inside.mean() < 0.6
    assert np.median(cat.residual[inside]) < 0.1
    assert np.mean(cat.photometric_quality[inside] >= 0.25) > 0.9
    # a closed outline: normals lean outward, left half to the left and upper part of the head upward
    columns = np.indices(inside.shape)[1]
    middle = np.median(columns[inside])
    assert cat.normals[inside & (columns < middle - 80), 0].mean() < -0.2
    assert cat.normals[inside & (columns > middle + 80), 0].mean() > 0.1
    top = inside & (np.indices(inside.shape)[0] < np.indices(inside.shape)[0][inside].min() + 90)
    assert cat.normals[top, 1].mean() > 0.1
    # the nose is nearer than the ears
    nose, ears = cat.height_um[140:165, 185:215], cat.height_um[60:110]
    assert np.nanmedian(nose) > np.nanmedian(ears) + 30


def test_slopes_of_the_relief_are_those_of_the_normals(cat: Reconstruction) -> None:
    assert cat.normals is not None
    assert cat.photometric_quality is not None
    d_row, d_column = np.gradient(cat.height_um.astype(np.float64))
    good = (cat.photometric_quality > 0.5) & np.isfinite(d_row) & np.isfinite(d_column)
    slope_x = -cat.normals[..., 0] / cat.normals[..., 2]
    slope_y = -cat.normals[..., 1] / cat.normals[..., 2]
    assert good.mean() > 0.15
    assert np.median(np.abs(d_column - slope_x)[good]) < 0.05
    assert np.median(np.abs(-d_row - slope_y)[good]) < 0.05


def test_trimming_leaves_less_unexplained(
    description: Path, cat: Reconstruction, tmp_path: Path
) -> None:
    run = import_photographs(description, tmp_path / "cat")
    robust = reconstruct(run)
    assert cat.residual is not None
    assert robust.residual is not None
    inside = np.isfinite(cat.height_um)
    assert np.median(robust.residual[inside]) < 0.8 * np.median(cat.residual[inside])


def test_groove_under_unknown_lights(tmp_path: Path) -> None:
    """A gel-coated groove under six LEDs of which nothing is given; the instrument's own height is the reference."""
    data = shared_data("gelsight_groove")
    content = {
        "folder": str(data),
        "pixel_um": 27.4581,
        "lights": [{} for _ in range(6)],
        "pattern": "image{light:02d}.png",
        "first": 1,
        "sensor": "mono",
        "bit_depth": 8,
    }
    description = tmp_path / "groove.yml"
    description.write_text(yaml.safe_dump(content))
    unknown = import_photographs(description, tmp_path / "unknown")
    estimate_lights(unknown.path, out=tmp_path / "lights.yml")
    description.write_text(yaml.safe_dump(content | {"lights": "lights.yml"}))
    found = reconstruct(import_photographs(description, tmp_path / "known"))
    reference_um = 1000.0 * np.load(data / "heightmap_mm.npy")
    assert found.kind == "integrated"
    everywhere = np.ones(reference_um.shape, bool)
    assert height_errors(found.height_um, reference_um, everywhere).plane_um <= 25.0
