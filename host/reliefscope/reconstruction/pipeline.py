"""From a run to a surface, by one of the methods.

``joint`` (:mod:`~reliefscope.reconstruction.joint_chain`) is the default, ``paper``
(:mod:`~reliefscope.reconstruction.paper_chain`) the faithful reference.
"""

from __future__ import annotations

from reliefscope.jobs import Job, ensure_job
from reliefscope.reconstruction.inputs import Frames, check_inputs
from reliefscope.reconstruction.result import Reconstruction
from reliefscope.reconstruction.settings import Settings
from reliefscope.reconstruction.stage_clock import StageClock
from reliefscope.units import FloatImage


def reconstruct(
    run: Frames,
    settings: Settings | None = None,
    job: Job | None = None,
    *,
    micrograph: FloatImage | None = None,
) -> Reconstruction:
    """Surface, normals and albedo of a run; touches no file but the run's frames.

    Parameters
    ----------
    run:
        Frames and geometry.
    settings:
        Defaults to the method ``joint``.
    job:
        Progress per stage, and cancellation.
    micrograph:
        (H, W) luminance to keep with the result; the mean of the view nearest to s = 0 if left out.

    Raises
    ------
    InvalidInputError
        Too few or badly spread lights, views without a baseline, unknown geometry, frames with NaN,
        no range of heights, or neither two views nor two lights.
    """
    inputs = check_inputs(run, settings or Settings())
    clock = StageClock(ensure_job(job))
    # the other method's packages would take longer to import than some of the stages run
    if inputs.settings.method == "joint":
        from reliefscope.reconstruction.joint_chain import reconstruct_jointly as chain
    else:
        from reliefscope.reconstruction.paper_chain import reconstruct_by_paper as chain
    return chain(inputs, clock, micrograph)
