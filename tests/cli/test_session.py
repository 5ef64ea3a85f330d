"""Progress for people and programs; Ctrl-C."""

import io
import json
import os
import signal

import pytest

from reliefscope.cli.options import ProgressMode
from reliefscope.cli.progress import JsonLines, SparseLines, duration
from reliefscope.cli.session import session
from reliefscope.errors import Cancelled
from reliefscope.jobs import Job, Progress


def test_json_lines_hold_first_and_last_event_of_a_stage() -> None:
    stream = io.StringIO()
    job = Job(JsonLines(stream, every_s=1000))
    with job.stage("acquire", 50) as stage:
        for _ in range(50):
            stage.advance()
    events = [json.loads(line) for line in stream.getvalue().splitlines()]
    assert [event["done"] for event in events] == [0, 50]
    assert events[0]["event"] == "progress"
    assert [event["finished"] for event in events] == [False, True]


def test_sparse_lines_are_sparse() -> None:
    lines: list[str] = []
    job = Job(SparseLines(lines.append, every_s=1000))
    with job.stage("robust_smoothing", 50) as stage:
        for _ in range(50):
            stage.advance()
    assert len(lines) == 1
    assert lines[0].startswith("robust smoothing: done in ")


def test_sparse_lines_tell_the_time_left() -> None:
    lines: list[str] = []
    show = SparseLines(lines.append, every_s=0)
    show(Progress("acquire", 30, 120, 10.0, 30.0, note="view 3"))
    assert lines == ["acquire: 30/120 (25 %), 30.0 s left (view 3)\n"]


@pytest.mark.parametrize(("seconds", "text"), [(8.24, "8.2 s"), (185, "3:05"), (7800, "2:10:00")])
def test_duration(seconds: float, text: str) -> None:
    assert duration(seconds) == text


def test_bar_ends_with_every_stage_done(capsys: pytest.CaptureFixture[str]) -> None:
    with session(ProgressMode.BAR, as_json=False) as this, this.job.stage("verify", 3) as stage:
        for _ in range(3):
            stage.advance()
    assert "3/3" in capsys.readouterr().err


def test_first_interrupt_cancels_the_job_second_one_raises() -> None:
    with session(ProgressMode.NONE, as_json=False) as this:
        os.kill(os.getpid(), signal.SIGINT)
        assert this.job.cancelled
        with pytest.raises(Cancelled):
            this.job.check()
        with pytest.raises(KeyboardInterrupt):
            os.kill(os.getpid(), signal.SIGINT)


def test_polite_end_cancels_the_job() -> None:
    with session(ProgressMode.NONE, as_json=False) as this:
        os.kill(os.getpid(), signal.SIGTERM)
        assert this.job.cancelled


def test_handlers_are_put_back() -> None:
    before = signal.getsignal(signal.SIGINT)
    with session(ProgressMode.NONE, as_json=False):
        assert signal.getsignal(signal.SIGINT) is not before
    assert signal.getsignal(signal.SIGINT) is before


def test_result_is_one_object(capsys: pytest.CaptureFixture[str]) -> None:
    with session(ProgressMode.NONE, as_json=True) as this:
        this.say("not for programs")
    this.result({"table": []}, lambda console: console.print("for people"))
    shown = capsys.readouterr()
    assert json.loads(shown.out) == {"schema_version": 1, "table": []}
    assert shown.err == ""
