"""The firmware as ARM code in QEMU: the link on a TCP port for any client, the trace of its outputs collected."""

import ctypes
import shutil
import signal
import socket
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Self

import pytest
from filelock import FileLock

from reliefscope_sim.trace import TraceRecord, parse_trace
from tests.support import REPOSITORY

NONCE = 0x0A5EED01
SHIFT = 5
"""32 ns an instruction: a 72 MHz clock at 2.3 cycles an instruction (flash with wait states)."""
_MACHINE = ["-M", "mps2-an386", "-nodefaults", "-display", "none", "-monitor", "none"]
_NEEDED = ("arm-none-eabi-g++", "qemu-system-arm")
_PR_SET_PDEATHSIG = 1


def images() -> Path:
    """Folder with the ARM images of this checkout, built if need be; skips where the tools are absent."""
    for tool in _NEEDED:
        if shutil.which(tool) is None:
            pytest.skip(f"{tool} is absent")
    folder = REPOSITORY / "build" / "firmware-arm"
    folder.mkdir(parents=True, exist_ok=True)
    beside = Path(sys.executable).parent
    cmake, ninja = (
        shutil.which(name, path=str(beside)) or shutil.which(name) or name
        for name in ("cmake", "ninja")
    )
    configure = [cmake, "-S", str(REPOSITORY / "firmware"), "-B", str(folder), "-G", "Ninja"]
    configure += [f"-DCMAKE_MAKE_PROGRAM={ninja}"]
    configure += [
        f"-DCMAKE_TOOLCHAIN_FILE={REPOSITORY / 'firmware' / 'cmake' / 'arm-none-eabi.cmake'}"
    ]
    with FileLock(folder / ".lock"):
        for command in (configure, [cmake, "--build", str(folder)]):
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            if done.returncode != 0:
                pytest.fail(f"{' '.join(command)}\n{done.stdout}{done.stderr}", pytrace=False)
    return folder


def _die_with_parent() -> None:
    ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)


def run_tests(image: Path, timeout_s: float = 120) -> subprocess.CompletedProcess[str]:
    """Runs the unit tests' image to its end."""
    command = ["qemu-system-arm", *_MACHINE, "-serial", "null"]
    command += ["-semihosting-config", "enable=on,target=native", "-kernel", str(image)]
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=timeout_s)


class QemuBoard:
    """A running board; a context manager. ``url`` is for any client, one at a time.

    instruction_shift:
        Each instruction takes 2**instruction_shift ns of the board's time, however busy the machine is.
    """

    def __init__(self, image: Path, instruction_shift: int = SHIFT) -> None:
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.url = f"socket://127.0.0.1:{self._listener.getsockname()[1]}"
        self._trace, theirs = socket.socketpair()
        self._received = bytearray()
        link, trace = self._listener.fileno(), theirs.fileno()
        command = ["qemu-system-arm", *_MACHINE, "-kernel", str(image)]
        command += ["-device", f"loader,addr=0x21000000,data={NONCE},data-len=4"]
        command += ["-chardev", f"socket,id=link,fd={link},server=on,wait=off,nodelay=on"]
        command += ["-serial", "chardev:link"]
        command += ["-chardev", f"socket,id=trace,fd={trace}", "-serial", "chardev:trace"]
        command += ["-icount", f"shift={instruction_shift}"]
        self._process = subprocess.Popen(
            command,
            pass_fds=(link, trace),
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
            preexec_fn=_die_with_parent,  # noqa: PLW1509  no threads of ours hold locks here
        )
        theirs.close()
        self._reader = threading.Thread(target=self._collect, daemon=True)
        self._reader.start()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._process.terminate()
        self._process.communicate(timeout=20)
        self._reader.join(timeout=20)
        self._listener.close()
        self._trace.close()

    def _collect(self) -> None:
        try:
            while data := self._trace.recv(1 << 16):
                self._received += data
        except OSError:
            return

    def received(self) -> bytes:
        """Bytes of the trace so far."""
        return bytes(self._received)

    def settled_trace(self, patience_s: float = 0.3) -> list[TraceRecord]:
        """All records so far, once none came for a while."""
        size = -1
        while size != len(self._received):
            size = len(self._received)
            time.sleep(patience_s)
        return list(parse_trace(bytes(self._received)))
