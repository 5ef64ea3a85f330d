"""The truth about a simulated sample, as files."""

import csv

import numpy as np
import pytest

from reliefscope.errors import InvalidInputError, OutputExistsError
from reliefscope.surface import read_height_map
from reliefscope.targets import Fiducial3D
from reliefscope_sim.truth import COLUMNS, Truth


def test_heights_are_those_under_the_frame_and_the_stage(tmp_path):
    truth = Truth.under("sim://benchtop?scene=fiducial&size=128x96&stage_um=7")
    truth.save(tmp_path / "truth.npz")
    height_map = read_height_map(tmp_path / "truth.npz")
    design = Fiducial3D().height_um((96, 128), truth.scene.pixel_um)
    assert np.abs(height_map.height_um - 7 - design).mean() < 0.3
    assert height_map.pixel_um[0] == pytest.approx(truth.scene.pixel_um)
    assert truth.rows() == []
    with pytest.raises(OutputExistsError, match="exists"):
        truth.save(tmp_path / "truth.npz")
    with pytest.raises(InvalidInputError, match="no grains"):
        truth.save(tmp_path / "other.npz", tmp_path / "grains.csv")
    with pytest.raises(InvalidInputError, match="does not end in"):
        truth.save(tmp_path / "other.tif")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["truth.npz"]


def test_the_table_of_grains_agrees_with_their_map(tmp_path):
    truth = Truth.under("sim://benchtop?scene=regolith&simulant=jsc1a&size=128x96&seed=4")
    truth.save(tmp_path / "truth.npz", tmp_path / "grains.csv")
    index = np.load(tmp_path / "truth.npz")["grain_index"]
    with (tmp_path / "grains.csv").open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert tuple(rows[0]) == COLUMNS
    assert len(rows) == len(truth.grains)
    visible = np.array([float(row["visible_um2"]) for row in rows])
    assert visible.sum() == pytest.approx((index >= 0).sum() * truth.scene.pixel_um**2, rel=1e-3)
    for row in rows:
        assert float(row["volume_um3"]) == pytest.approx(
            4 / 3 * np.pi * float(row["radius_um"]) ** 3, rel=1e-3
        )
        assert row["name"] in {"basaltic ash", "pale feldspar", "glass"}
        assert float(row["long_um"]) >= 0.9 * float(row["short_um"])
