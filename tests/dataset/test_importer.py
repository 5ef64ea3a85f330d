"""Photographs become runs; every wrong description is named before anything is touched."""

from pathlib import Path

import cv2
import numpy as np
import pytest
import yaml
from numpy.typing import NDArray
from tests.support import shared_data

from reliefscope.dataset import Run, import_photographs
from reliefscope.dataset.importer import srgb_to_linear
from reliefscope.errors import InvalidInputError, OutputExistsError

SHAPE = (20, 30)


def photographs(folder: Path, count: int = 3, dtype: type = np.uint8) -> list[NDArray[np.integer]]:
    rng = np.random.default_rng(5)
    top = np.iinfo(dtype).max
    images = [rng.integers(0, top, SHAPE, endpoint=True).astype(dtype) for _ in range(count)]
    for number, image in enumerate(images, start=1):
        cv2.imwrite(str(folder / f"Image_{number:02d}.png"), image)
    return images


def describe(place: Path, **content: object) -> Path:
    description: dict[str, object] = {
        "pixel_um": 2.5,
        "bit_depth": 8,
        "lights": [{"direction": [1, 0, 1]}, {"direction": [0, 2, 1]}, {"direction": [0, 0, 3]}],
        "pattern": "Image_{light:02d}.png",
        "first": 1,
    }
    description |= content
    path = place / "set.yml"
    path.write_text(
        yaml.safe_dump({key: value for key, value in description.items() if value is not None})
    )
    return path


def test_grey_photographs_are_stored_count_for_count(tmp_path: Path) -> None:
    images = photographs(tmp_path)
    run = import_photographs(describe(tmp_path, sample="s1"), tmp_path / "run")
    assert run.complete
    assert run.spec.origin == "imported"
    assert run.spec.sample == "s1"
    assert run.pixel_um == 2.5
    assert run.spec.plan is None
    assert run.views is not None
    np.testing.assert_array_equal(run.views, [[0, 0]])
    for light, image in enumerate(images):
        np.testing.assert_array_equal(run.raw("view", 0, light), image)
        np.testing.assert_allclose(run.linear(0, light), image / 255, rtol=1e-6)
        assert run.record("view", 0, light).sources[0].file == f"Image_{light + 1:02d}.png"
    expected = np.array([[1, 0, 1], [0, 2, 1], [0, 0, 3]]) / np.sqrt([[2], [5], [9]])
    np.testing.assert_allclose(run.lights, expected)
    assert Run.open(tmp_path / "run").verify().ok


def test_y_down_turns_slopes_and_directions(tmp_path: Path) -> None:
    photographs(tmp_path)
    run = import_photographs(
        describe(tmp_path, y_axis="down", views=[{"slope": [0.1, 0.2]}]), tmp_path / "run"
    )
    np.testing.assert_array_equal(run.views, [[0.1, -0.2]])
    assert run.lights is not None
    assert run.lights[1, 1] == pytest.approx(-2 / np.sqrt(5))


def test_frames_may_be_listed(tmp_path: Path) -> None:
    images = photographs(tmp_path, 2)
    run = import_photographs(
        describe(
            tmp_path,
            lights=None,
            pattern=None,
            first=None,
            views=[{"slope": [0.1, 0], "name": "right"}, {"slope": [-0.1, 0]}],
            frames=[
                {"view": 1, "file": "Image_01.png"},
                {"view": 0, "light": 0, "file": "Image_02.png"},
            ],
        ),
        tmp_path / "run",
    )
    assert run.view_names == ("right", "view-01")
    assert run.lights is None  # no direction was given
    np.testing.assert_array_equal(run.raw("view", 0, 0), images[1])
    np.testing.assert_array_equal(run.raw("view", 1, 0), images[0])


def test_colour_photographs_become_luminance(tmp_path: Path) -> None:
    rgb = np.random.default_rng(6).integers(0, 256, (*SHAPE, 3)).astype(np.uint8)
    for number in range(3):
        cv2.imwrite(str(tmp_path / f"Image_{number + 1:02d}.png"), rgb[:, :, ::-1])
    linear = import_photographs(describe(tmp_path), tmp_path / "linear")
    weights = [0.2126, 0.7152, 0.0722]
    np.testing.assert_allclose(linear.linear(0, 0), rgb / 255 @ weights, atol=1 / 65535)
    assert "luminance" in linear.spec.imported.conversion
    curve = import_photographs(describe(tmp_path, transfer="srgb"), tmp_path / "srgb")
    expected = srgb_to_linear((rgb / 255).astype(np.float32)) @ weights
    np.testing.assert_allclose(curve.linear(0, 0), expected, atol=1 / 65535)


def test_srgb_curve_at_known_points() -> None:
    values = np.array([0, 0.04045, 0.5, 1], dtype=np.float32)
    np.testing.assert_allclose(srgb_to_linear(values), [0, 0.0031308, 0.2140411, 1], rtol=1e-5)


def test_mosaics_and_deep_pictures_keep_their_counts(tmp_path: Path) -> None:
    images = photographs(tmp_path, dtype=np.uint16)
    for number, image in enumerate(images, start=1):
        cv2.imwrite(str(tmp_path / f"Image_{number:02d}.png"), image >> 4)
    run = import_photographs(
        describe(tmp_path, bit_depth=12, sensor="bayer_rggb"), tmp_path / "run"
    )
    np.testing.assert_array_equal(run.raw("view", 0, 0), images[0] >> 4)
    assert run.linear(0, 0).max() <= 1


def test_dark_photographs_are_averaged_and_subtracted(tmp_path: Path) -> None:
    images = photographs(tmp_path)
    for number, level in enumerate((3, 6), start=1):
        cv2.imwrite(str(tmp_path / f"dark{number}.png"), np.full(SHAPE, level, np.uint8))
    run = import_photographs(describe(tmp_path, dark=["dark1.png", "dark2.png"]), tmp_path / "run")
    np.testing.assert_allclose(run.linear(0, 1), (images[1] - 4.5) / 255, atol=1e-6)
    assert run.record("dark", None, None).accumulated == 2


@pytest.mark.parametrize("kind", ["circle", "file"])
def test_masks(tmp_path: Path, kind: str) -> None:
    photographs(tmp_path)
    rows, columns = np.mgrid[: SHAPE[0], : SHAPE[1]]
    valid = (rows - 8) ** 2 + (columns - 12) ** 2 <= 36
    cv2.imwrite(str(tmp_path / "valid.png"), valid.astype(np.uint8) * 255)
    circle = {"circle": {"row": 8, "column": 12, "radius_px": 6}}
    mask = circle if kind == "circle" else {"file": "valid.png"}
    run = import_photographs(describe(tmp_path, mask=mask), tmp_path / "run")
    assert run.mask is not None
    np.testing.assert_array_equal(run.mask, valid)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"pixel_mm": 1}, "did you mean `pixel_um`"),
        ({"views": [{"slop": [0, 0]}]}, "did you mean `slope`"),
        ({"pixel_um": None}, "pixel_um: Field required"),
        ({"pixel_um": 0}, "greater than 0"),
        ({"lights": []}, "lights"),
        ({"lights": [{"direction": [0, 0, -1]}]}, "below the sample plane"),
        ({"pattern": None}, "either `frames`"),
        ({"pattern": "Image.png"}, r"no \{light\}"),
        ({"pattern": "Image_{led}.png"}, "only"),
        ({"pattern": "Image_{light"}, "no valid pattern"),
        ({"pattern": None, "frames": [{"light": 3, "file": "x"}]}, "0 to 2"),
        ({"pattern": None, "frames": [{"light": 1, "file": "Image_01.png"}]}, "2 frames are not"),
        (
            {"pattern": None, "frames": [{"file": "a"}, {"file": "b"}]},
            "listed more than once",
        ),
        ({"height_range_um": [5, 5]}, "low < high"),
        ({"first": 2}, "Image_04.png cannot be read"),
        ({"bit_depth": 7}, "more than 7 bits"),
        ({"sensor": "bayer_rggb", "transfer": "srgb"}, "must be linear"),
        ({"mask": {"circle": {"row": 900, "column": 0, "radius_px": 2}}}, "no valid pixel"),
        ({"mask": {"file": "absent.png"}}, "absent.png cannot be read"),
        ({"mask": {}}, "either file or circle"),
        ({"dark": "absent.png"}, "absent.png"),
        ({"y_axis": "left"}, "y_axis"),
    ],
)
def test_wrong_descriptions_are_named_and_touch_nothing(
    tmp_path: Path, change: dict[str, object], message: str
) -> None:
    photographs(tmp_path)
    description = describe(tmp_path, **change)
    with pytest.raises(InvalidInputError, match=message):
        import_photographs(description, tmp_path / "run")
    assert not list(tmp_path.glob("run*"))


def test_wrong_photographs_are_named_and_touch_nothing(tmp_path: Path) -> None:
    photographs(tmp_path)
    description = describe(tmp_path)
    second = tmp_path / "Image_02.png"
    good = second.read_bytes()
    second.write_bytes(good[: len(good) // 4])
    with pytest.raises(InvalidInputError, match=r"Image_02\.png is not a picture"):
        import_photographs(description, tmp_path / "run")
    cv2.imwrite(str(second), np.zeros((20, 31), np.uint8))
    with pytest.raises(InvalidInputError, match="31x20 pixels, the others 30x20"):
        import_photographs(description, tmp_path / "run")
    cv2.imwrite(str(second), np.zeros((20, 30, 4), np.uint8))
    with pytest.raises(InvalidInputError, match="4 channels"):
        import_photographs(description, tmp_path / "run")
    assert not list(tmp_path.glob("run*"))


def test_an_existing_output_is_refused(tmp_path: Path) -> None:
    photographs(tmp_path)
    (tmp_path / "run").mkdir()
    with pytest.raises(OutputExistsError):
        import_photographs(describe(tmp_path), tmp_path / "run")


def test_cat_of_psbox_has_its_normals_the_right_way_round(tmp_path: Path) -> None:
    folder = shared_data("psbox_cat")
    directions = np.loadtxt(folder / "light_directions.txt").T
    run = import_photographs(
        describe(
            tmp_path,
            folder=str(folder / "Objects"),
            pixel_um=1000.0,
            lights=[{"direction": row.tolist()} for row in directions],
        ),
        tmp_path / "run",
    )
    assert run.shape == (550, 430)
    assert run.lights is not None
    images = run.linear_stack(view=0).reshape(12, -1)
    scaled = np.linalg.lstsq(run.lights, images, rcond=None)[0].reshape(3, *run.shape)
    head = scaled[:, 90:235, 100:300]  # a bulging head: normals lean outwards on every side
    rows, columns = head.shape[1:]
    assert head[0, :, : columns // 3].mean() < -0.02
    assert head[0, :, -columns // 3 :].mean() > 0.02
    assert head[1, : rows // 3].mean() > 0.02
    assert head[1, -rows // 3 :].mean() < -0.02
    assert head[2].mean() > 0.1


def lightfield_description(folder: Path, tmp_path: Path) -> Path:
    views = yaml.safe_load((folder / "views.json").read_text())
    # A point at height z appears at (x - z sx, y - z sy), y up; rows grow downward.  A disparity of d pixels
    # per lens pitch moves it by d v_col columns and d u_row rows, so that z = d in units of a pixel.
    slopes = [[-view["v_col"], view["u_row"]] for view in views["views"]]
    return describe(
        tmp_path,
        folder=str(folder),
        pixel_um=1.0,
        views=[{"slope": slope} for slope in slopes],
        lights=None,
        pattern="view_{view}.png",
        first=0,
        height_range_um=[0, 28],
        mask={"circle": {"row": 221.5, "column": 221.5, "radius_px": views["valid_radius_px"]}},
    )


def test_light_field_views_agree_at_the_height_of_the_rods(tmp_path: Path) -> None:
    folder = shared_data("lightfield_microscope_chips") / "Chips_4_views"
    run = import_photographs(lightfield_description(folder, tmp_path), tmp_path / "run")
    assert run.views is not None
    assert run.mask is not None
    assert run.mask.mean() == pytest.approx(np.pi * 214**2 / 444**2, rel=0.01)
    images = run.linear_stack(light=0)
    row, column, half = 165, 110, 25  # speckled part of the upper rod

    def likeness(height: float) -> float:
        patch = images[3, row - half : row + half, column - half : column + half]
        scores = []
        for view in (0, 1, 2, 4, 5, 6):
            d_col, d_row = -height * run.views[view, 0], height * run.views[view, 1]
            centre = (column - 0.5 + d_col, row - 0.5 + d_row)
            seen = cv2.getRectSubPix(images[view], (2 * half, 2 * half), centre)
            scores.append(np.corrcoef(patch.ravel(), seen.ravel())[0, 1])
        return float(np.mean(scores))

    heights = np.arange(-28, 29)
    curve = [likeness(height) for height in heights]
    assert 3 <= heights[int(np.argmax(curve))] <= 25
    assert max(curve) > 0.7


def test_files_of_8_bits_cannot_hold_more(tmp_path: Path) -> None:
    photographs(tmp_path)
    with pytest.raises(InvalidInputError, match="8 bits per channel") as caught:
        import_photographs(describe(tmp_path, bit_depth=12), tmp_path / "run")
    assert "bit_depth: 8" in caught.value.hint
    assert not (tmp_path / "run").exists()
