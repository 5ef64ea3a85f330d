"""The table beside the paper's."""

import numpy as np
import pytest

from reliefscope.evaluation import PAPER_TABLE_I, evaluate_fiducial
from reliefscope.evaluation.table_one import (
    FINISHES,
    PAPER_ROWS,
    PAPER_SECTIONS,
    Z_STACK,
    table_markdown,
)
from reliefscope.targets import Fiducial3D

SHAPE, PIXEL_UM = (260, 260), 4.0


def rows(offset_um, bump_um):
    """Truth plus an offset that alignment removes, and a chequer of errors that it does not."""
    sign = np.where(np.indices(SHAPE).sum(axis=0) % 2, 1.0, -1.0)
    height = Fiducial3D().height_um(SHAPE, PIXEL_UM) + offset_um + bump_um * sign
    return [
        *evaluate_fiducial(height, PIXEL_UM, "joint"),
        *evaluate_fiducial(height + sign, PIXEL_UM, Z_STACK),
    ]


def test_the_papers_average_row_follows_from_its_rows():
    for section in PAPER_SECTIONS:
        mean = np.mean([row.sections_um[section] for row in PAPER_ROWS.values()])
        assert mean == pytest.approx(PAPER_TABLE_I[section], abs=0.051)
    assert np.mean([row.z_stack_um for row in PAPER_ROWS.values()]) == pytest.approx(11.1, abs=0.05)


def test_every_finish_method_and_mean_has_its_line():
    measured = {name: rows(7.0, bump) for name, bump in zip(FINISHES, (1.0, 2.0, 3.0), strict=True)}
    lines = table_markdown(measured).splitlines()
    cells = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]
    assert cells[0][2:] == ["checker tops", "checker floors", "planes", "hemispheres", "full"]
    table = {(row[0], row[1]): row[2:] for row in cells[2:]}
    assert [float(table[name, "joint"][4]) for name in FINISHES] == pytest.approx(
        [1, 2, 3], abs=0.05
    )
    assert table["dull", "published, O2 long"] == ["1.9", "-", "4.9", "7.1", "11.0"]
    assert table["metallic", "published z-stack"][-1] == "10.0"
    assert float(table["**mean**", "joint"][4]) == pytest.approx(2.0, abs=0.05)
    assert float(table["**mean**", Z_STACK][4]) == pytest.approx(3.0, abs=0.05)
    raw = table_markdown({"half": measured["half"]}, "raw").splitlines()
    assert float(raw[2].split("|")[-2]) == pytest.approx(7.0, abs=0.05)
    assert len(raw) == 6
