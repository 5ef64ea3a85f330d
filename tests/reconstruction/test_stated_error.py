"""The error stated for each normal against the true one, on the simulated fiducial."""

from pathlib import Path

import numpy as np
import pytest
from scipy.stats import spearmanr

from reliefscope import axes
from reliefscope.microscope import Microscope
from reliefscope.reconstruction.pipeline import reconstruct
from reliefscope.targets import Fiducial3D


@pytest.mark.soak
@pytest.mark.parametrize("finish", ["dull", "half", "metallic"])
def test_stated_error_predicts_the_true_one(tmp_path: Path, finish: str) -> None:
    """About 68 % of the errors lie within it, and it ranks them."""
    url = f"sim://stated?size=480x360&scene=fiducial&finish={finish}&seed=3"
    with Microscope.open(url) as microscope:
        run = microscope.acquire(microscope.default_plan(), tmp_path / "run").data
    result = reconstruct(run)
    assert result.normals is not None
    assert result.normal_sigma_rad is not None
    truth = axes.normals_from_height(Fiducial3D().height_um(run.shape, run.pixel_um), run.pixel_um)
    cross = np.linalg.norm(np.cross(result.normals, truth), axis=-1)
    errors = np.arctan2(cross, np.sum(result.normals * truth, axis=-1))
    known = np.isfinite(errors)
    assert known.mean() > 0.95
    within = np.mean(errors[known] < result.normal_sigma_rad[known])
    assert 0.58 < within < 0.85
    assert spearmanr(errors[known], result.normal_sigma_rad[known]).statistic > 0.45
