"""Runs and results of an experiment: what its folder holds already is used, the rest is made."""

from __future__ import annotations

from pathlib import Path

from reliefscope.errors import InvalidInputError
from reliefscope.jobs import Job
from reliefscope.microscope.live import Microscope
from reliefscope.microscope.reconstructing import reconstruct_run
from reliefscope.microscope.stored import StoredRun, open_run
from reliefscope.reconstruction.result import Reconstruction, load_result


def run_of(url: str, place: Path, sample: str, job: Job) -> StoredRun:
    """The run in ``place``, or a new one of the instrument at ``url``.

    Raises
    ------
    InvalidInputError
        The run in ``place`` is of another instrument, sample, seed or size.
    """
    if place.exists():
        run = open_run(place)
        if run.data.spec.notes != url:
            raise InvalidInputError(
                f"{place} was taken with {run.data.spec.notes or 'another program'}, not with {url}.",
                hint="Give another folder with `--out`, or the options of the runs that are there.",
            )
        return run
    with Microscope.open(url) as microscope:
        return microscope.acquire(out=place, job=job, sample=sample, notes=url)


def result_of(run: StoredRun, method: str, job: Job) -> Reconstruction:
    """The result of a method in a run, or a new one with its pictures."""
    if method in run.results:
        return load_result(run.path, method)
    return reconstruct_run(run, method=method, job=job).reconstruction
