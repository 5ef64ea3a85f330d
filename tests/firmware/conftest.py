"""Builds the firmware of this checkout once a session: the unit tests with sanitizers, and the host's library."""

import ctypes
import os
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest
from filelock import FileLock
from tests.firmware.compiled import load
from tests.support import REPOSITORY

collect_ignore = ["test_custom_runner.py"]  # PlatformIO's, not ours


@dataclass(frozen=True)
class FirmwareBuild:
    """What the build made."""

    tests: Path
    library: Path


def _tool(name: str) -> str:
    beside = shutil.which(name, path=str(Path(sys.executable).parent))
    return beside or name


@pytest.fixture(scope="session")
def firmware_build() -> FirmwareBuild:
    """Incremental; the folder is shared by all workers of a run."""
    folder = REPOSITORY / "build" / "firmware-tests"
    folder.mkdir(parents=True, exist_ok=True)
    configure = [
        _tool("cmake"),
        "-S",
        str(REPOSITORY / "firmware"),
        "-B",
        str(folder),
        "-G",
        "Ninja",
    ]
    configure += ["-DRELIEFSCOPE_FIRMWARE_TESTS=ON", f"-DCMAKE_MAKE_PROGRAM={_tool('ninja')}"]
    with FileLock(folder / ".lock"):
        for command in (configure, [_tool("cmake"), "--build", str(folder)]):
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            if done.returncode != 0:
                pytest.fail(f"{' '.join(command)}\n{done.stdout}{done.stderr}", pytrace=False)
    libraries = sorted(folder.glob("*reliefscope_firmware.*"))
    library = next(p for p in libraries if p.suffix in {".so", ".dylib", ".dll"})
    return FirmwareBuild(
        Path(shutil.which("reliefscope_firmware_tests", path=str(folder)) or ""), library
    )


@pytest.fixture(scope="session")
def core_results(firmware_build: FirmwareBuild) -> dict[str, str]:
    """Outcome of every C++ case: PASS, or FAIL with its place and reason."""
    environment = os.environ | {"UBSAN_OPTIONS": "print_stacktrace=1"}
    done = subprocess.run(
        [str(firmware_build.tests)],
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
        env=environment,
    )
    found = re.findall(r"^(.+):(\d+):(\w+):(PASS|FAIL.*)$", done.stdout, re.MULTILINE)
    results = {name: f"{verdict} ({file}:{line})" for file, line, name, verdict in found}
    results["crash"] = done.stderr if done.returncode not in {0, 100} else ""
    return results


@pytest.fixture(scope="session")
def library(firmware_build: FirmwareBuild) -> ctypes.CDLL:
    """The host's library with its signatures."""
    return load(firmware_build.library)
