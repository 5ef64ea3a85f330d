"""Ctrl-C in a real process: once pauses after the current frame, twice stops; nothing is lost."""

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from reliefscope.errors import ExitCode
from reliefscope.microscope import Microscope, open_run

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")

# Real time, so that there is something to interrupt: the whole run would take most of a minute.
DEVICE = "sim://interrupted?scene=flat&size=96x72&time=real"


def begin(out: Path) -> subprocess.Popen[str]:
    arguments = ["acquire", "-d", DEVICE, "-o", str(out), "--settle-ms", "20"]
    return subprocess.Popen(
        [sys.executable, "-m", "reliefscope", *arguments, "--progress", "json"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def wait(ready: Callable[[], bool], process: subprocess.Popen[str]) -> None:
    for _ in range(1200):
        if ready():
            return
        assert process.poll() is None, process.communicate()
        time.sleep(0.05)
    process.kill()
    pytest.fail("the acquisition did not get under way")


def frames(partial: Path) -> int:
    journal = partial / "journal.jsonl"
    return len(journal.read_text().splitlines()) if journal.exists() else 0


def test_once_pauses_and_the_run_resumes(tmp_path: Path) -> None:
    partial = tmp_path / "run.partial"
    process = begin(tmp_path / "run")
    wait(lambda: frames(partial) >= 2, process)
    os.kill(process.pid, signal.SIGINT)
    out, err = process.communicate(timeout=60)
    assert process.returncode == ExitCode.CANCELLED, err
    assert out == ""
    assert "Pausing after the current frame" in err
    assert "Traceback" not in err
    assert "--resume" in err
    events = [json.loads(line) for line in err.splitlines() if line.startswith("{")]
    assert events
    taken = frames(partial)
    report = open_run(partial).verify()
    assert not report.damaged
    assert 0 < report.verified == taken < report.planned
    with Microscope.open(DEVICE.replace("&time=real", "")) as microscope:
        assert microscope.resume(partial).verify().ok


def test_twice_stops_at_once_and_keeps_what_is_there(tmp_path: Path) -> None:
    partial = tmp_path / "run.partial"
    process = begin(tmp_path / "run")
    wait(lambda: frames(partial) >= 2, process)
    os.kill(process.pid, signal.SIGINT)
    os.kill(process.pid, signal.SIGINT)
    time.sleep(0.01)
    if process.poll() is None:
        os.kill(process.pid, signal.SIGINT)
    _, err = process.communicate(timeout=60)
    assert process.returncode == ExitCode.CANCELLED, err
    assert "Traceback" not in err
    assert not open_run(partial).verify().damaged
