"""Results against truth: heights of the 3D fiducial beside Table I of the paper."""

from reliefscope.evaluation.fiducial import PAPER_TABLE_I, TableRow, evaluate_fiducial
from reliefscope.evaluation.heights import HeightErrors, height_errors

__all__ = [
    "PAPER_TABLE_I",
    "HeightErrors",
    "TableRow",
    "evaluate_fiducial",
    "height_errors",
]
