"""A full and a slow disk under an acquisition: what was journalled stays, the rest can be taken later."""

import sys

import pytest
from tests.acquisition.bench import instrument, small_plan
from tests.sim.disk import python, python_on_a_small_disk, slow_disk

BEGIN = """
import sys
from pathlib import Path
from tests.acquisition.bench import instrument, small_plan
from reliefscope.dataset import RunWriter
from reliefscope.errors import DatasetError
from reliefscope.jobs import Job

place = Path(sys.argv[1])
run = place / "run"
partial = place / "run.partial"
plan = small_plan(2, 16, dark_accumulate=0, leakage_accumulate=1)  # 49 images

def journalled():
    return len((partial / "journal.jsonl").read_text().splitlines())
"""
FULL_DISK = (
    BEGIN
    + """
filler = place / "filler"

def fill(progress):
    if progress.stage == "acquire" and progress.done == 8 and not filler.exists():
        with filler.open("wb", buffering=0) as file:
            try:
                while file.write(bytes(4096)):
                    pass
            except OSError:
                pass

with instrument() as bench:
    try:
        bench.acquire(run, plan, Job(fill))
    except DatasetError as error:
        print("error:", error.message, error.hint)
    kept = journalled()
    with RunWriter.resume(partial) as writer:
        print("missing:", len(writer.missing()), "kept:", kept)
    filler.unlink()
    print("complete:", bench.resume(partial).complete)
"""
)
FILE_LIMIT = (
    BEGIN
    + """
import resource
with instrument() as bench:
    bench.acquire(place / "first", small_plan(1, 1))  # compiles
with instrument() as bench:
    resource.setrlimit(resource.RLIMIT_FSIZE, (16_000, resource.RLIM_INFINITY))
    try:
        bench.acquire(run, plan)
    except DatasetError as error:
        print("error:", error.message, error.hint)
    kept = journalled()
    resource.setrlimit(resource.RLIMIT_FSIZE, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
    with RunWriter.resume(partial) as writer:
        print("missing:", len(writer.missing()), "kept:", kept)
    print("complete:", bench.resume(partial).complete)
"""
)


def check(done):
    assert done.returncode == 0, done.stderr
    error, missing, complete = done.stdout.splitlines()
    assert "disk is full" in error
    assert "--resume" in error
    _, missing_count, _, kept_count = missing.split()
    assert int(kept_count) > 0
    assert int(missing_count) + int(kept_count) == 49, "what was journalled verifies"
    assert complete == "complete: True"


@pytest.mark.skipif(sys.platform != "linux", reason="needs Linux namespaces")
def test_a_disk_that_fills_up_during_a_run(tmp_path):
    check(python_on_a_small_disk(FULL_DISK, tmp_path, "80m"))


@pytest.mark.skipif(sys.platform == "win32", reason="needs limits of POSIX systems")
def test_a_journal_that_may_not_grow(tmp_path):
    done = python(FILE_LIMIT, tmp_path)
    check(done)
    assert "wire log" in done.stderr, "the log ends, the run goes on"


def test_a_slow_disk_holds_the_run_up_and_loses_nothing(tmp_path, monkeypatch):
    plan = small_plan(1, 2, dark_accumulate=1, leakage_accumulate=1)
    with instrument() as bench:
        calls = slow_disk(monkeypatch, 0.02)
        run = bench.acquire(tmp_path / "run", plan)
        assert len(calls) > 2 * len(list(plan.requests()))
        assert run.complete
