"""Focus stacking against stacks whose heights are known in closed form, and against a real one."""

import cv2
import numpy as np
import pytest
from tests.support import shared_data

from reliefscope.errors import InvalidInputError
from reliefscope.reconstruction.focus_stacking import (
    QUALITY_THRESHOLD,
    focus_measure,
    focus_stack,
)

SHAPE = (96, 128)
HEIGHTS_UM = np.arange(-40.0, 45.0, 5.0)


def speckle(seed=1, shape=SHAPE):
    fine = np.random.default_rng(seed).random(shape).astype(np.float32)
    return cv2.GaussianBlur(fine, (0, 0), 1.0)


def blurred(image, defocus_um):
    """Gaussian defocus that grows as geometry says: one pixel (sigma) for 5 um, none in focus."""
    sigma = abs(defocus_um) / 5
    return image if sigma == 0 else cv2.GaussianBlur(image, (0, 0), sigma)


def steps(heights_um):
    """A stack of vertical strips at ``heights_um``, each blurred by its own distance from the focus."""
    texture = speckle()
    edges = np.linspace(0, SHAPE[1], len(heights_um) + 1).astype(int)
    truth = np.zeros(SHAPE, np.float32)
    planes = []
    for focus in HEIGHTS_UM:
        plane = np.empty(SHAPE, np.float32)
        for left, right, height in zip(edges, edges[1:], heights_um, strict=False):
            truth[:, left:right] = height
            plane[:, left:right] = blurred(texture, focus - height)[:, left:right]
        planes.append(plane)
    return planes, truth, texture


def inner(truth):
    """Pixels further than the window and the smoothing reach from a step."""
    edge = cv2.morphologyEx(truth, cv2.MORPH_GRADIENT, np.ones((3, 3))) > 0
    return cv2.dilate(edge.astype(np.uint8), np.ones((25, 25))) == 0


def test_every_strip_gets_the_height_of_its_plane():
    planes, truth, texture = steps([-20.0, 5.0, 25.0])
    result = focus_stack(planes, HEIGHTS_UM)
    inside = inner(truth)
    hit = inside & (result.picked_um == truth)
    assert hit.sum() > 0.99 * inside.sum()
    assert np.abs(result.height_um - truth)[inside].max() < 1.0
    np.testing.assert_array_equal(result.focused[hit], texture[hit])
    assert result.accepted()[inside].all()


def test_smoothing_is_a_gaussian_of_three_pixels():
    planes, _, _ = steps([-20.0, 25.0])
    result = focus_stack(planes, HEIGHTS_UM)
    expected = cv2.GaussianBlur(result.picked_um, (0, 0), 3.0)
    np.testing.assert_allclose(result.height_um, expected, atol=1e-4)
    bare = focus_stack(planes, HEIGHTS_UM, smoothing_px=0)
    np.testing.assert_array_equal(bare.height_um, result.picked_um)


@pytest.mark.parametrize("height_um", [-11.5, 2.0, 13.0])
def test_gaussian_peak_finds_heights_between_the_planes(height_um):
    planes, truth, _ = steps([height_um])
    inside = np.ones(SHAPE, bool)
    inside[:8], inside[-8:], inside[:, :8], inside[:, -8:] = False, False, False, False
    plane = focus_stack(planes, HEIGHTS_UM)
    between = focus_stack(planes, HEIGHTS_UM, peak="gaussian")
    error = np.abs(between.height_um - truth)[inside].mean()
    assert error < 0.3
    assert error < 0.5 * np.abs(plane.height_um - truth)[inside].mean()


def test_unevenly_spaced_planes():
    heights = np.array([-30.0, -14.0, -6.0, 0.0, 3.0, 11.0, 30.0])
    texture = speckle()
    planes = [blurred(texture, height - 3.0) for height in heights]
    result = focus_stack(planes, heights, peak="gaussian")
    assert abs(float(np.median(result.height_um)) - 3.0) < 1.0


def test_quality_tells_texture_from_noise_and_from_the_ends_of_the_stack():
    generator = np.random.default_rng(2)
    texture = speckle()
    planes = []
    for focus in HEIGHTS_UM:
        plane = blurred(texture, focus - 10.0)
        plane[:, :64] = 0.5
        planes.append(plane + 0.004 * generator.standard_normal(SHAPE, dtype=np.float32))
    quality = focus_stack(planes, HEIGHTS_UM).quality
    assert (quality[8:-8, 76:-8] > QUALITY_THRESHOLD).mean() > 0.95
    assert (quality[8:-8, 8:52] > QUALITY_THRESHOLD).mean() < 0.1
    beyond = focus_stack([blurred(texture, focus - 46.0) for focus in HEIGHTS_UM], HEIGHTS_UM)
    assert (beyond.quality == 0).mean() > 0.7


def test_measure_of_an_edge_is_its_gradient_and_reaches_half_the_window():
    image = np.zeros((20, 31), np.float32)
    image[:, 15] = 0.5
    image[:, 16:] = 1.0
    measure = focus_measure(image, window=5)
    np.testing.assert_allclose(measure[5:-5, 15], 0.5)
    np.testing.assert_allclose(measure[5:-5, 13:18], 0.5)
    assert measure[5:-5, :12].max() == 0.0


def test_colour_is_kept():
    planes, truth, _ = steps([-20.0, 25.0])
    tint = np.array([1.0, 0.6, 0.3], np.float32)
    result = focus_stack([plane[..., None] * tint for plane in planes], HEIGHTS_UM)
    assert result.focused.shape == (*SHAPE, 3)
    assert (result.picked_um == truth)[inner(truth)].mean() > 0.99


def test_what_does_not_belong_together_is_refused():
    planes, _, _ = steps([0.0])
    with pytest.raises(InvalidInputError, match="17 images for 3 heights"):
        focus_stack(planes, [0.0, 1.0, 2.0])
    with pytest.raises(InvalidInputError, match="increasing"):
        focus_stack(planes[:3], [0.0, 2.0, 1.0])
    with pytest.raises(InvalidInputError, match="odd"):
        focus_stack(planes, HEIGHTS_UM, window=4)
    with pytest.raises(InvalidInputError, match="Image 1 of the stack has shape"):
        focus_stack([planes[0], planes[1][:-2], planes[2]], [0.0, 1.0, 2.0])


def test_real_stack_of_a_push_button_is_in_the_right_order():
    """Board below the body of the switch, the body below its button."""
    folder = shared_data("focus_stack_pcb")
    images = [
        cv2.imread(str(path), cv2.IMREAD_GRAYSCALE)[::2, ::2].astype(np.float32) / 255
        for path in sorted(folder.glob("*.JPG"))
    ]
    result = focus_stack(images, np.arange(10.0), window=21)

    def median(rows, columns):
        part = (slice(*rows), slice(*columns))
        return float(np.median(result.height_um[part][result.accepted()[part]]))

    board = median((140, 190), (390, 500))
    body = median((560, 610), (360, 660))
    button = median((350, 480), (460, 620))
    assert board < body - 0.5 < button - 1.0
