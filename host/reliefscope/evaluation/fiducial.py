"""A result against the true shape of the 3D fiducial, section by section, beside Table I of the paper.

The fiducial lies in the middle of the field, its axes along those of the image: the twin places it so.  The
paper aligned each section in a way that it does not tell; hence three alignments, each section on its own.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any, TypedDict

import numpy as np
from numpy.typing import NDArray

from reliefscope.evaluation.heights import height_errors
from reliefscope.jobs import Job, ensure_job
from reliefscope.targets import SECTIONS, Fiducial3D

PAPER_TABLE_I: Mapping[str, float] = MappingProxyType(
    {"checker_tops": 2.1, "planes": 5.8, "hemispheres": 7.3, "full": 12.8}
)
"""Average row of Table I, um.  The paper's checkerboard column stands at the tops: it does not tell how it
counted the floors, almost all of which lie in the shadow of every light."""


class TableRow(TypedDict):
    """Mean absolute errors of one method on one section, um."""

    method: str
    section: str
    mae_raw_um: float
    mae_offset_um: float
    mae_plane_um: float


def evaluate_fiducial(
    height_um: NDArray[np.floating[Any]],
    pixel_um: float,
    method: str,
    fiducial: Fiducial3D | None = None,
    *,
    sections: Sequence[str] = SECTIONS,
    job: Job | None = None,
) -> list[TableRow]:
    """Rows of the table for one result.

    Parameters
    ----------
    height_um:
        (H, W) heights, um; NaN is missing and counts as 100 um of error.
    pixel_um:
        Size of a pixel on the sample.
    method:
        What the rows are called.
    fiducial:
        The true shape; the default one if left out.
    sections:
        Which sections, in which order.
    job:
        Progress per section, and cancellation.

    Raises
    ------
    InvalidInputError
        A section that the frame does not show.
    """
    target = fiducial if fiducial is not None else Fiducial3D()
    shape = (height_um.shape[0], height_um.shape[1])
    truth = target.height_um(shape, pixel_um)
    rows: list[TableRow] = []
    with ensure_job(job).stage("evaluate", len(sections)) as stage:
        for section in SECTIONS:
            if section not in sections:
                continue
            errors = height_errors(height_um, truth, target.mask(section, shape, pixel_um))
            rows.append(
                TableRow(
                    method=method,
                    section=section,
                    mae_raw_um=round(errors.raw_um, 4),
                    mae_offset_um=round(errors.offset_um, 4),
                    mae_plane_um=round(errors.plane_um, 4),
                )
            )
            stage.advance()
    return rows
