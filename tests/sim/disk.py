"""Disks that are full or slow, as the system makes them: nothing of the host knows of it.

A full disk is a small one of its own (a tmpfs in namespaces of a child process, which needs no root), or a limit
on the size of files; both are the kernel's.  A slow disk is one whose ``fsync`` takes its time.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest
from tests.support import REPOSITORY

NAMESPACES = ["unshare", "--user", "--map-root-user", "--mount"]


def python_on_a_small_disk(program: str, folder: Path, size: str) -> subprocess.CompletedProcess:
    """Run ``program`` (argument: a folder) with ``folder`` on a disk of ``size``; skips where that cannot be."""
    if shutil.which("unshare") is None:
        pytest.skip("left out: no unshare on this system")
    mount = f"mount -t tmpfs -o size={size} tmpfs '{folder}'"
    probe = subprocess.run([*NAMESPACES, "sh", "-c", mount], capture_output=True, check=False)
    if probe.returncode:
        pytest.skip("left out: user namespaces are not allowed here")
    command = [*NAMESPACES, "sh", "-c", f'{mount} && exec "$@"', "sh"]
    return _run([*command, sys.executable, "-c", program, str(folder)])


def python(program: str, folder: Path) -> subprocess.CompletedProcess:
    """Run ``program`` (argument: a folder) in a process of its own."""
    return _run([sys.executable, "-c", program, str(folder)])


def _run(command: list[str]) -> subprocess.CompletedProcess:
    return subprocess.run(
        command, cwd=REPOSITORY, capture_output=True, text=True, check=False, timeout=120
    )


def slow_disk(monkeypatch: pytest.MonkeyPatch, seconds: float) -> list[float]:
    """Every ``fsync`` takes ``seconds`` longer; returns the list to which each of them is added."""
    calls: list[float] = []
    fsync = os.fsync

    def slowly(descriptor: int) -> None:
        time.sleep(seconds)
        calls.append(time.monotonic())
        fsync(descriptor)

    monkeypatch.setattr(os, "fsync", slowly)
    return calls
