"""Writing, resuming and verifying: nothing acknowledged is lost, nothing is overwritten."""

import errno
import json
import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from tests.dataset.helpers import fill, make_run, pixels, record, small_spec
from tests.support import REPOSITORY

from reliefscope.dataset import IncompleteRunWarning, Run, RunWriter, durable
from reliefscope.dataset.records import Journal, key_text
from reliefscope.errors import (
    DatasetError,
    InvalidInputError,
    LockedError,
    OutputExistsError,
    VerificationError,
)


def test_a_whole_run_comes_back_bit_for_bit(tmp_path: Path) -> None:
    run = make_run(tmp_path / "run")
    assert run.complete
    assert run.path == tmp_path / "run"
    assert not (tmp_path / "run.partial").exists()
    for key, request in run.layout.requests.items():
        np.testing.assert_array_equal(run.raw(*key), pixels(request, run.spec))
        assert run.record(*key).settle_waited_us == 400_000
    report = run.verify()
    assert report.ok
    assert report.verified == report.planned == 3 * 2 + 1 + 1 + 2


def test_the_run_has_its_final_name_only_when_complete(tmp_path: Path) -> None:
    with RunWriter.create(tmp_path / "run", small_spec()) as writer:
        fill(writer, limit=4)
        with pytest.raises(VerificationError, match="6 of 10 frames"):
            writer.finish()
    assert not (tmp_path / "run").exists()
    with pytest.warns(IncompleteRunWarning, match="4 of 10"):
        run = Run.open(tmp_path / "run.partial")
    assert not run.complete
    assert run.name == "run"
    with pytest.raises(DatasetError, match="view-02-light-01"):
        run.raw("view", 2, 1)
    with pytest.raises(DatasetError, match="not finished") as caught:
        Run.open(tmp_path / "run")
    assert "--resume" in caught.value.hint


def test_resume_takes_only_what_is_missing(tmp_path: Path) -> None:
    with RunWriter.create(tmp_path / "run", small_spec()) as writer:
        order = [request.key for request in writer.missing()]
        fill(writer, limit=7)
    with RunWriter.resume(tmp_path / "run") as writer:
        assert [request.key for request in writer.missing()] == order[7:]
        fill(writer)
        run = Run.open(writer.finish())
    assert run.verify().ok


def test_a_torn_journal_line_is_ignored_and_its_frame_retaken(tmp_path: Path) -> None:
    with RunWriter.create(tmp_path / "run", small_spec()) as writer:
        fill(writer, limit=3)
    journal = tmp_path / "run.partial" / "journal.jsonl"
    journal.write_bytes(journal.read_bytes()[:-40])
    with pytest.warns(IncompleteRunWarning, match="2 of 10"):
        Run.open(tmp_path / "run.partial")
    with RunWriter.resume(tmp_path / "run") as writer:
        assert len(writer.missing()) == 8
        fill(writer)
        writer.finish()
    lines = (tmp_path / "run" / "journal.jsonl").read_text().splitlines()
    assert len([json.loads(line) for line in lines]) == 10


def test_a_journal_cut_anywhere_gives_the_lines_before_the_cut(tmp_path: Path) -> None:
    run = make_run(tmp_path / "run")
    data = (run.path / "journal.jsonl").read_bytes()
    ends = [index + 1 for index, byte in enumerate(data) if byte == ord("\n")]
    keys = list(run.journal.entries)
    cut = tmp_path / "cut.jsonl"
    for length in {*range(0, len(data), 37), *ends, *(end - 1 for end in ends)}:
        cut.write_bytes(data[:length])
        journal = Journal.read(cut)
        whole = sum(end <= length for end in ends)
        assert list(journal.entries) == keys[:whole]
        assert journal.problems == []
        assert journal.whole_bytes == ([0, *ends])[whole]


def test_a_damaged_line_in_the_middle_costs_one_frame(tmp_path: Path) -> None:
    with RunWriter.create(tmp_path / "run", small_spec()) as writer:
        fill(writer)
    journal = tmp_path / "run.partial" / "journal.jsonl"
    lines = journal.read_bytes().splitlines(keepends=True)
    lines[4] = b"#" + lines[4][1:]
    journal.write_bytes(b"".join(lines))
    with RunWriter.resume(tmp_path / "run") as writer:
        report = writer.verify()
        assert not report.ok
        assert any("line 5" in problem for problem in report.problems)
        assert len(writer.missing()) == 1
        fill(writer)
        run = Run.open(writer.finish())
    assert run.complete
    assert run.verify().ok


def test_verify_names_a_flipped_byte_and_resume_retakes_that_frame(tmp_path: Path) -> None:
    run = make_run(tmp_path / "run")
    chunk = run.path / run.layout.chunk_path(("view", 1, 0))
    data = bytearray(chunk.read_bytes())
    data[100] ^= 0x10
    chunk.write_bytes(data)
    report = Run.open(run.path).verify()
    assert list(report.damaged) == [("view", 1, 0)]
    assert report.as_dict()["damaged"].keys() == {"view-01-light-00"}
    with pytest.raises(VerificationError, match="view-01-light-00"):
        report.require_ok()
    with RunWriter.resume(run.path) as writer:
        assert [request.key for request in writer.missing()] == ["view-01-light-00"]
        fill(writer)
        assert Run.open(writer.finish()).verify().ok
    assert (run.path / "superseded" / "view-01-light-00.1").read_bytes() == data


def test_a_frame_that_was_replaced_behind_the_checksum_is_found(tmp_path: Path) -> None:
    run = make_run(tmp_path / "run")
    first, second = (run.path / run.layout.chunk_path(("view", view, 0)) for view in (0, 1))
    second.write_bytes(first.read_bytes())  # its CRC-32C is right, it is just another frame
    report = run.verify()
    assert list(report.damaged) == [("view", 1, 0)]
    assert "SHA-256" in report.damaged["view", 1, 0]


def test_a_retake_supersedes_and_keeps_the_former_pixels(tmp_path: Path) -> None:
    with RunWriter.create(tmp_path / "run", small_spec()) as writer:
        request = writer.missing()[5]
        old = pixels(request, writer.spec, seed=1)
        writer.put(record(request), old)
        chunk = next((tmp_path / "run.partial").rglob("c/*/0/0")).read_bytes()
        fill(writer, seed=2)
        writer.put(record(request), pixels(request, writer.spec, seed=3))
        run = Run.open(writer.finish())
    key = (request.kind, request.view, request.light)
    np.testing.assert_array_equal(run.raw(*key), pixels(request, run.spec, seed=3))
    assert (run.path / "superseded" / f"{request.key}.1").read_bytes() == chunk
    assert len((run.path / "journal.jsonl").read_text().splitlines()) == 11
    assert run.verify().ok


def test_places_that_are_taken_are_refused(tmp_path: Path) -> None:
    make_run(tmp_path / "run")
    with pytest.raises(OutputExistsError):
        RunWriter.create(tmp_path / "run", small_spec())
    RunWriter.create(tmp_path / "other", small_spec()).close()
    with pytest.raises(OutputExistsError, match="unfinished"):
        RunWriter.create(tmp_path / "other", small_spec())
    with pytest.raises(InvalidInputError):
        RunWriter.create(tmp_path / "third.partial", small_spec())


def test_finish_does_not_overwrite_a_run_that_appeared_meanwhile(tmp_path: Path) -> None:
    with RunWriter.create(tmp_path / "run", small_spec()) as writer:
        fill(writer)
        (tmp_path / "run").mkdir()
        with pytest.raises(OutputExistsError, match="stays in"):
            writer.finish()
    assert (tmp_path / "run.partial" / "journal.jsonl").exists()


def test_a_second_writer_is_told_who_holds_the_run(tmp_path: Path) -> None:
    writer = RunWriter.create(tmp_path / "run", small_spec())
    with pytest.raises(LockedError, match=f"process {os.getpid()}"):
        RunWriter.resume(tmp_path / "run")
    writer.close()
    RunWriter.resume(tmp_path / "run").close()


def test_a_full_disk_is_one_clear_error_and_loses_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    real_fsync = os.fsync

    def full(handle: int) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    with RunWriter.create(tmp_path / "run", small_spec()) as writer:
        fill(writer, limit=3)
        monkeypatch.setattr(durable.os, "fsync", full)
        with pytest.raises(DatasetError, match="disk is full") as caught:
            fill(writer, limit=1)
        assert "--resume" in caught.value.hint
        monkeypatch.setattr(durable.os, "fsync", real_fsync)
    with RunWriter.resume(tmp_path / "run") as writer:
        assert len(writer.missing()) == 7
        fill(writer)
        assert Run.open(writer.finish()).verify().ok


def test_a_full_disk_at_the_beginning_leaves_nothing_behind(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(handle: int) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(durable.os, "fsync", full)
    with pytest.raises(DatasetError, match="disk is full"):
        RunWriter.create(tmp_path / "folder" / "run", small_spec())
    monkeypatch.undo()
    assert list((tmp_path / "folder").iterdir()) == []
    RunWriter.create(tmp_path / "folder" / "run", small_spec()).close()


def test_a_journal_line_that_does_not_fit_leaves_no_part_behind(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = durable.AppendFile(tmp_path / "lines")
    file.append(b"whole")
    real_write = os.write
    calls = 0

    def short(handle: int, data: bytes) -> int:
        nonlocal calls
        calls += 1
        if calls == 1:
            return real_write(handle, bytes(data)[:3])
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(durable.os, "write", short)
    with pytest.raises(OSError, match="space"):
        file.append(b"another")
    monkeypatch.setattr(durable.os, "write", real_write)
    file.append(b"third")
    file.close()
    assert (tmp_path / "lines").read_bytes() == b"whole\nthird\n"


def test_too_little_space_is_refused_before_anything_is_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("shutil.disk_usage", lambda _: type("Usage", (), {"free": 1000})())
    with pytest.raises(DatasetError, match=r"1\.0 kB free"):
        RunWriter.create(tmp_path / "run", small_spec())
    assert list(tmp_path.iterdir()) == []


KILLED = """
import sys
from pathlib import Path
from reliefscope.dataset import RunWriter
from tests.dataset.helpers import pixels, record, small_spec
with RunWriter.create(Path(sys.argv[1]), small_spec()) as writer:
    for request in writer.missing():
        writer.put(record(request), pixels(request, writer.spec))
        print(request.key, flush=True)
"""


RESUMED = (
    "(RunWriter.resume if Path(sys.argv[1] + '.partial').exists() else "
    "lambda path: RunWriter.create(path, small_spec()))(Path(sys.argv[1]))"
)


@pytest.mark.parametrize("acknowledged", [1, 4])
def test_kill_in_the_middle_loses_nothing_acknowledged(tmp_path: Path, acknowledged: int) -> None:
    process = subprocess.Popen(
        [sys.executable, "-c", KILLED, str(tmp_path / "run")],
        stdout=subprocess.PIPE,
        text=True,
        cwd=REPOSITORY,
    )
    assert process.stdout is not None
    told = [process.stdout.readline().strip() for _ in range(acknowledged)]
    time.sleep(0.005 * acknowledged)
    process.send_signal(signal.SIGKILL)
    told += process.stdout.read().split()
    process.wait()
    process.stdout.close()
    with RunWriter.resume(tmp_path / "run") as writer:
        missing = {request.key for request in writer.missing()}
        assert missing.isdisjoint(told)
        assert len(missing) in (10 - len(told), 9 - len(told))
        fill(writer)
        run = Run.open(writer.finish())
    assert run.verify().ok


@pytest.mark.soak
def test_many_kills_at_random_moments_lose_nothing(tmp_path: Path) -> None:
    rng = random.Random(3)
    resumed = KILLED.replace("RunWriter.create(Path(sys.argv[1]), small_spec())", RESUMED)
    kept: dict[str, str] = {}
    for _ in range(40):
        process = subprocess.Popen(
            [sys.executable, "-c", resumed, str(tmp_path / "run")],
            stdout=subprocess.PIPE,
            text=True,
            cwd=REPOSITORY,
        )
        assert process.stdout is not None
        told = [process.stdout.readline().strip()]
        time.sleep(rng.uniform(0, 0.1))
        process.send_signal(signal.SIGKILL)
        told += process.stdout.read().split()
        process.wait()
        process.stdout.close()
        journal = Journal.read(next(tmp_path.glob("run*")) / "journal.jsonl")
        hashes = {key_text(key): entry.sha256 for key, entry in journal.entries.items()}
        assert set(filter(None, told)) <= set(hashes)
        assert kept.items() <= hashes.items()
        kept = hashes
        if len(kept) == 10:
            break
    with RunWriter.resume(tmp_path / "run") as writer:
        assert writer.verify().damaged == {}
        assert len(writer.missing()) == 10 - len(kept)


def test_a_repaired_journal_does_not_warn(tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    run = make_run(tmp_path / "run")
    journal = run.path / "journal.jsonl"
    lines = journal.read_bytes().splitlines(keepends=True)
    journal.write_bytes(b"".join([*lines[:4], b"#" + lines[4][1:], *lines[5:]]))
    with pytest.warns(IncompleteRunWarning):
        damaged = Run.open(run.path)
    assert "line 5" in caplog.text
    with pytest.raises(VerificationError, match="1 of 10 frames") as caught:
        damaged.verify().require_ok()
    assert "line 5" in caught.value.message
    with RunWriter.resume(run.path) as writer:
        fill(writer)
        writer.finish()
    caplog.clear()
    assert Run.open(run.path).verify().ok
    assert caplog.text == ""
