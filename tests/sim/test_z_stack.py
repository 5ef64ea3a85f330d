"""The conventional microscope beside the simulated instrument."""

import numpy as np
import pytest

from reliefscope.dataset.image_stack import ImageStack, open_stack
from reliefscope.errors import InvalidInputError, OutputExistsError
from reliefscope.reconstruction.focus_stacking import focus_stack
from reliefscope_sim.scenes import Scene
from reliefscope_sim.z_stack import FocusingRenderer, record_z_stack, reference_microscope

SHAPE = (64, 72)


def renderer(height_um, albedo):
    """The microscope over a sample of one height."""
    scene = Scene(
        "test", 0.69, np.full(SHAPE, height_um, np.float32), np.asarray(albedo, np.float32)
    )
    return FocusingRenderer(reference_microscope((SHAPE[1], SHAPE[0])), scene, -75.0, 75.0)


def test_data_of_the_microscope_are_those_of_the_paper():
    optics = reference_microscope().optics
    assert reference_microscope().pixel_um == pytest.approx(0.69)
    ratio = optics.objective_focal_mm / optics.pupil_diameter_mm
    assert 2 * optics.wavelength_um * ratio**2 == pytest.approx(15.0, abs=0.3)


@pytest.mark.parametrize("height_um", [-20.0, 30.0])
def test_a_point_spreads_into_the_disc_that_geometry_gives(height_um):
    """Second moment of the image of a point out of focus: that of a disc of diameter z d / f."""
    albedo = np.zeros(SHAPE, np.float32)
    albedo[32, 36] = 0.9
    view = renderer(height_um, albedo)
    defocus_um = 35.0
    columns = np.arange(SHAPE[1]) - 36.0

    def variance(image):
        profile = image.sum(axis=0, dtype=np.float64)
        return (profile @ columns**2) / profile.sum()

    sharp = variance(view.focused(height_um))
    wide = variance(view.focused(height_um - defocus_um))
    optics = reference_microscope().optics
    disc_px = defocus_um * optics.pupil_diameter_mm / optics.objective_focal_mm / 0.69
    assert wide - sharp == pytest.approx((disc_px / 4) ** 2, rel=0.05)


def test_brightness_does_not_depend_on_the_focus():
    view = renderer(10.0, np.full(SHAPE, 0.5))
    sharp, blurred = view.focused(10.0), view.focused(-60.0)
    np.testing.assert_allclose(sharp, blurred, rtol=1e-3)


def test_stack_on_disk_gives_the_height_of_the_stage(tmp_path):
    url = "sim://z-test?scene=flat&scene.texture=0.4&stage_um=20&size=64x48"
    record_z_stack(url, tmp_path / "stack")
    stack = open_stack([tmp_path / "stack"])
    assert isinstance(stack, ImageStack)
    assert stack.description.sample == url
    assert stack.heights_um.tolist() == list(range(-75, 80, 5))
    result = focus_stack(stack.images(), stack.heights_um)
    known = result.picked_um[result.accepted()]
    assert np.median(known) == 20.0
    assert (np.abs(known - 20.0) <= 5.0).mean() > 0.9
    assert next(stack.images()).shape == (48 * 1.116 // 0.69, 64 * 1.116 // 0.69)
    with pytest.raises(OutputExistsError):
        record_z_stack(url, tmp_path / "stack")
    with pytest.raises(InvalidInputError, match="too small"):
        record_z_stack(url, tmp_path / "tiny", field_um=5.0)
