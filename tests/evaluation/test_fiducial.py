import numpy as np
import pytest

from reliefscope.errors import InvalidInputError
from reliefscope.evaluation import PAPER_TABLE_I, evaluate_fiducial, height_errors
from reliefscope.targets import SECTIONS, Fiducial3D

SHAPE = (130, 174)
PIXEL_UM = 8.96


def rows_of(height_um: np.ndarray) -> dict[str, dict]:
    return {row["section"]: row for row in evaluate_fiducial(height_um, PIXEL_UM, "test")}


def test_truth_has_no_error() -> None:
    truth = Fiducial3D().height_um(SHAPE, PIXEL_UM)
    rows = rows_of(truth)
    assert set(rows) == set(SECTIONS)
    for row in rows.values():
        assert row["method"] == "test"
        for key in ("mae_raw_um", "mae_offset_um", "mae_plane_um"):
            assert row[key] == pytest.approx(0.0, abs=1e-3)


def test_offset_and_tilt_are_taken_off_by_the_right_alignment() -> None:
    truth = Fiducial3D().height_um(SHAPE, PIXEL_UM)
    row, column = np.indices(SHAPE)
    shifted = rows_of(truth + 7.0)["full"]
    assert shifted["mae_raw_um"] == pytest.approx(7.0, abs=1e-3)
    assert shifted["mae_offset_um"] == pytest.approx(0.0, abs=1e-3)
    tilted = rows_of(truth + 0.1 * column - 0.05 * row)["planes"]
    assert tilted["mae_offset_um"] > 1.0
    assert tilted["mae_plane_um"] == pytest.approx(0.0, abs=1e-3)


def test_every_pixel_counts_and_a_missing_height_is_100_um() -> None:
    truth = Fiducial3D().height_um(SHAPE, PIXEL_UM)
    mask = Fiducial3D().mask("checker_tops", SHAPE, PIXEL_UM)
    holes = truth.copy()
    chosen = np.flatnonzero(mask)[: mask.sum() // 4]
    holes.ravel()[chosen] = np.nan
    share = chosen.size / mask.sum()
    row = rows_of(holes)["checker_tops"]
    for key in ("mae_raw_um", "mae_offset_um", "mae_plane_um"):
        assert row[key] == pytest.approx(100.0 * share, abs=1e-2)
    nothing = rows_of(np.full(SHAPE, np.nan, np.float32))["planes"]
    assert nothing["mae_offset_um"] == 100.0


def test_median_offset_is_the_best_constant() -> None:
    rng = np.random.default_rng(1)
    truth = np.zeros((20, 30))
    height = rng.exponential(5.0, truth.shape)
    errors = height_errors(height, truth, np.ones(truth.shape, bool))
    best = min(np.abs(height - c).mean() for c in np.linspace(0, 10, 400))
    assert errors.offset_um == pytest.approx(best, abs=0.01)
    assert errors.coverage == 1.0


def test_what_cannot_be_compared_is_refused() -> None:
    with pytest.raises(InvalidInputError, match="does not belong"):
        height_errors(np.zeros((4, 5)), np.zeros((4, 6)), np.ones((4, 6), bool))
    with pytest.raises(InvalidInputError, match="field of view"):
        height_errors(np.zeros((4, 5)), np.zeros((4, 5)), np.zeros((4, 5), bool))


def test_reference_is_the_paper() -> None:
    assert dict(PAPER_TABLE_I) == {
        "checker_tops": 2.1,
        "planes": 5.8,
        "hemispheres": 7.3,
        "full": 12.8,
    }
