"""Stacks of images on disk."""

import cv2
import numpy as np
import pytest

from reliefscope.dataset.image_stack import open_stack
from reliefscope.errors import InvalidInputError


def write(folder, names, dtype=np.uint8):
    folder.mkdir(exist_ok=True)
    for index, name in enumerate(names):
        value = np.full((8, 9), 10 * (index + 1), dtype)
        assert cv2.imwrite(str(folder / name), value)
    return folder


def test_folder_is_read_by_number(tmp_path):
    folder = write(tmp_path / "s", ["im10.png", "im2.png", "im1.png"])
    stack = open_stack([folder], step_um=5.0, pixel_um=0.69)
    assert stack.heights_um.tolist() == [0.0, 5.0, 10.0]
    assert [image[0, 0] * 255 for image in stack.images()] == pytest.approx([30, 20, 10])
    assert stack.description.pixel_um == 0.69


def test_negative_step_turns_the_stack_over(tmp_path):
    folder = write(tmp_path / "s", ["a.png", "b.png", "c.png"], np.uint16)
    files = [folder / name for name in ("a.png", "b.png", "c.png")]
    stack = open_stack(files, step_um=-2.0)
    assert stack.heights_um.tolist() == [0.0, 2.0, 4.0]
    assert [image[0, 0] * 65535 for image in stack.images()] == pytest.approx([30, 20, 10])


def test_photographs_become_linear(tmp_path):
    folder = write(tmp_path / "s", ["a.jpg", "b.jpg", "c.jpg"])
    image = next(open_stack([folder], step_um=1.0).images())
    assert image.mean() == pytest.approx((10 / 255) / 12.92, rel=0.05)


def test_what_is_missing_is_named(tmp_path):
    folder = write(tmp_path / "s", ["a.png", "b.png", "c.png"])
    with pytest.raises(InvalidInputError, match="distance between the pictures") as caught:
        open_stack([folder])
    assert "--step-um" in caught.value.hint
    with pytest.raises(InvalidInputError, match="2 pictures are no stack"):
        open_stack([folder / "a.png", folder / "b.png"], step_um=1.0)
    (folder / "stack.yml").write_text(
        "planes: [{file: a.png, height_um: 0}, {file: b.png, height_um: 2}, {file: c.png, height_um: 1}]"
    )
    with pytest.raises(InvalidInputError, match="order of height_um"):
        open_stack([folder])
    (folder / "stack.yml").write_text(
        "planes: [{file: a.png, height_um: 0}, {file: x.png, height_um: 1}, {file: c.png, height_um: 2}]"
    )
    with pytest.raises(InvalidInputError, match=r"x\.png"):
        list(open_stack([folder]).images())
    with pytest.raises(InvalidInputError, match="gives the heights already"):
        open_stack([folder], step_um=1.0)
