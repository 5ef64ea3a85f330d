"""The line of the z calibration, and the height of a flat target in a run."""

import numpy as np
import pytest

from reliefscope.calibration.z_scale import fit_z_scale, measure_height
from reliefscope.errors import InvalidInputError
from reliefscope.microscope import calibrate_z
from reliefscope.microscope.experiments.z_figure import plot_z_scale
from reliefscope.models.calibration import Calibration
from reliefscope.models.instrument import load_profile

STAGE = np.arange(-50.0, 55.0, 10.0)


def test_a_line_without_scatter_gives_the_pupil_scale_exactly():
    fit = fit_z_scale(STAGE, (STAGE - 7.0) / 1.125)
    assert fit.pupil_scale == pytest.approx(1.125, rel=1e-12)
    assert fit.offset_um == pytest.approx(-7.0 / 1.125)
    assert fit.rms_um == pytest.approx(0.0, abs=1e-9)
    again = fit_z_scale(STAGE, STAGE, pupil_scale=1.125)
    assert again.pupil_scale == pytest.approx(1.125)


def test_scatter_is_told_as_true_height_and_sets_the_error_of_the_slope():
    scatter = np.array([1.0, -1, 1, -1, 1, 0, -1, 1, -1, 1, -1]) * 1.8
    fit = fit_z_scale(STAGE, (STAGE + scatter) / 1.25)
    expected = STAGE + scatter
    line = np.polynomial.Polynomial.fit(STAGE, expected, 1)
    residual = expected - line(STAGE)
    assert fit.rms_um == pytest.approx(np.sqrt(np.mean(residual**2)), rel=0.02)
    several = [
        fit_z_scale(STAGE, STAGE + np.random.default_rng(seed).normal(0, 2, STAGE.size))
        for seed in range(200)
    ]
    spread = np.std([each.slope for each in several])
    assert np.mean([each.slope_error for each in several]) == pytest.approx(spread, rel=0.15)


def test_the_calibration_keeps_everything_else():
    nominal = Calibration.nominal(load_profile("benchtop"))
    better = fit_z_scale(STAGE, STAGE / 1.1).calibrated(nominal, "2026-01-01T00:00:00+00:00")
    assert (better.source, better.created) == ("measured", "2026-01-01T00:00:00+00:00")
    assert better.pupil_scale == pytest.approx(1.1)
    same = {"pupil_scale", "source", "created"}
    assert better.model_dump(exclude=same) == nominal.model_dump(exclude=same)


def test_heights_that_make_no_line_are_refused():
    with pytest.raises(InvalidInputError, match="2 heights"):
        fit_z_scale([0.0, 10.0], [0.0, 10.0])
    with pytest.raises(InvalidInputError, match="3 heights"):
        fit_z_scale([5.0, 5.0, 5.0], [5.0, 5.1, 4.9])
    with pytest.raises(InvalidInputError, match="falls as the stage rises"):
        fit_z_scale(STAGE, -STAGE)
    with pytest.raises(InvalidInputError, match="no run"):
        calibrate_z({}, keep=False)


class FakeRun:
    """Views of a flat target in closed form: a texture shifted by eq. 1, rows down."""

    pixel_um, shape, light_names, path = 1.0, (110, 120), ("all",), "fake"
    height_range_um = (-60.0, 60.0)

    def __init__(self, height_um, noise=0.0):
        azimuth = np.arange(6) * np.pi / 3
        self.views = 0.1 * np.stack([np.cos(azimuth), np.sin(azimuth)], axis=1)
        self.view_names = tuple("abcdef")
        self._height_um, self._noise = height_um, noise

    def stack(self):
        row, column = np.mgrid[: self.shape[0], : self.shape[1]].astype(float)
        generator = np.random.default_rng(3)
        for view, (sx, sy) in enumerate(self.views):
            x, y = column + self._height_um * sx, row - self._height_um * sy
            image = np.sin(x / 3.1) * np.cos(y / 4.3 + 0.02 * x) + np.sin((x + 2 * y) / 9)
            image = (1 - self._noise) * image + 2 * self._noise * generator.random(self.shape)
            yield view, 0, image.astype(np.float32)


@pytest.mark.parametrize("height_um", [-63.0, 0.4, 27.25])
def test_height_of_a_flat_target_in_closed_form(height_um):
    assert measure_height(FakeRun(height_um)).height_um == pytest.approx(height_um, abs=0.1)


def test_a_target_out_of_range_or_not_seen_is_refused():
    with pytest.raises(InvalidInputError, match="no height between"):
        measure_height(FakeRun(-95.0))
    with pytest.raises(InvalidInputError, match="do not agree"):
        measure_height(FakeRun(10.0, noise=0.95))


def test_the_plot_is_drawn(tmp_path):
    fit = fit_z_scale(STAGE, STAGE / 1.1 + np.sin(STAGE))
    assert plot_z_scale(fit, tmp_path / "new" / "z.png").stat().st_size > 5000
