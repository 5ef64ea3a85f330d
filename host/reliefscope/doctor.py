"""Whether everything is here that the instrument needs: ports, cameras, calibration, versions, disk.

Every check says what was found and, where something is wrong, the next command to type.  Nothing is changed,
no LED is lit.
"""

from __future__ import annotations

import datetime
import os
import platform
import shutil
from collections.abc import Callable, Iterable, Iterator
from dataclasses import asdict, dataclass
from importlib.metadata import PackageNotFoundError, entry_points, version
from pathlib import Path
from typing import Any, Literal

import psutil

from reliefscope import __version__
from reliefscope.calibration.store import CalibrationStore
from reliefscope.camera import camera_schemes
from reliefscope.device import Device, PortInfo, list_ports
from reliefscope.device.ports import UDEV_COMMAND
from reliefscope.errors import LockedError, ReliefscopeError
from reliefscope.models.calibration import Calibration
from reliefscope.protocol.messages import SCHEMA_HASH
from reliefscope.units import format_bytes

Status = Literal["ok", "warning", "failed", "absent"]

INSTRUMENT_GROUP = "reliefscope.instruments"
LIBRARIES = ("numpy", "numba", "scipy", "opencv-python-headless", "zarr", "pyserial", "textual")
OLD_DAYS = 90
RUN_BYTES = 700e6
"""A full-size run of 12 x 16 frames with its corrections and one result."""
NEEDED_MEMORY_BYTES = 3e9
PROBE = "doctor?scene=flat&size=32x32"
"""Name under which an instrument without hardware is asked for its HELLO."""


@dataclass(frozen=True, slots=True)
class Check:
    """One finding."""

    name: str
    status: Status
    finding: str
    hint: str = ""

    def as_dict(self) -> dict[str, Any]:
        """For ``--json``."""
        return asdict(self)


def healthy(checks: Iterable[Check]) -> bool:
    """Whether nothing keeps the instrument from working."""
    return all(check.status != "failed" for check in checks)


def examine(
    runs: Path = Path("runs"),
    store: CalibrationStore | None = None,
    ports: Callable[[], list[PortInfo]] = list_ports,
) -> list[Check]:
    """Every check, in the order in which to read them; ``runs`` is where runs are going to be written."""
    return [
        check_versions(),
        *check_instruments(),
        *check_ports(ports()),
        check_cameras(),
        *check_calibrations(store or CalibrationStore()),
        check_disk(runs),
        check_memory(),
        check_kernel_cache(),
    ]


def check_versions() -> Check:
    """Versions of this program, Python and the libraries that figures depend on."""
    found = []
    for library in LIBRARIES:
        try:
            found.append(f"{library} {version(library)}")
        except PackageNotFoundError:
            return Check(
                "versions",
                "failed",
                f"{library} is not installed.",
                "Install the program with its dependencies: `pip install -e .` in the checkout.",
            )
    text = f"reliefscope {__version__}, Python {platform.python_version()}, {', '.join(found)}"
    if __version__.startswith("0+"):
        return Check(
            "versions", "warning", text, "Not installed; `pip install -e .` in the checkout."
        )
    return Check("versions", "ok", text)


def check_instruments() -> Iterator[Check]:
    """Instruments without hardware: each must answer HELLO with the protocol of this host."""
    entries = list(entry_points(group=INSTRUMENT_GROUP))
    if not entries:
        yield Check(
            "simulation",
            "failed",
            "No simulated instrument is installed.",
            "`pip install -e .` in the checkout compiles and installs it.",
        )
    for entry in entries:
        url = f"{entry.name}://{PROBE}"
        yield _greet(f"{entry.name}://", url)


def _greet(name: str, url: str) -> Check:
    try:
        with Device.open(url, allow_mismatch=True) as device:
            identity = device.identity
    except LockedError as error:
        return Check(name, "warning", error.message, error.hint)
    except ReliefscopeError as error:
        return Check(name, "failed", error.message, error.hint)
    finding = (
        f"board {identity.board}, firmware {identity.firmware_version} ({identity.git_hash}), "
        f"serial number {identity.serial_number or 'none'}"
    )
    if bytes(identity.schema_hash) != bytes(SCHEMA_HASH):
        return Check(
            name,
            "failed",
            f"{finding}; it speaks another version of the protocol.",
            f"Flash the firmware that belongs to this host: `reliefscope flash --port {url}`.",
        )
    return Check(name, "ok", finding)


def check_ports(ports: list[PortInfo]) -> Iterator[Check]:
    """Serial ports with a Teensy: permission, then HELLO."""
    teensies = [port for port in ports if port.is_teensy]
    if not teensies:
        others = ", ".join(port.port for port in ports) or "none"
        yield Check(
            "device",
            "absent",
            f"No Teensy is plugged in (other ports: {others}).",
            "Plug it in by USB; without one everything can be tried on `sim://benchtop`.",
        )
    for port in teensies:
        if Path(port.port).exists() and not os.access(port.port, os.R_OK | os.W_OK):
            yield Check(
                port.port,
                "failed",
                "This user may not open the port.",
                f"Allow it once with: {UDEV_COMMAND}; then plug the device in again.",
            )
        else:
            yield _greet(port.port, port.port)


def check_cameras() -> Check:
    """Camera backends that are installed."""
    schemes = camera_schemes()
    if not schemes:
        return Check(
            "cameras",
            "failed",
            "No camera backend is installed.",
            "`pip install -e .` in the checkout installs the simulated one.",
        )
    return Check("cameras", "ok", "backends: " + ", ".join(f"{scheme}://" for scheme in schemes))


def check_calibrations(store: CalibrationStore) -> Iterator[Check]:
    """Stored calibrations and their age."""
    found = store.list()
    if not found:
        yield Check(
            "calibration",
            "absent",
            f"None is stored in {store.folder}; factory or nominal values are used.",
        )
    for path, calibration in found:
        yield _judge_calibration(path, calibration)


def _judge_calibration(path: Path, calibration: Calibration | None) -> Check:
    name = f"calibration {path.stem}"
    if calibration is None:
        return Check(
            name,
            "failed",
            f"{path} is damaged.",
            f"Restore it from a copy, or remove it: `rm {path}`.",
        )
    if calibration.created is None:
        return Check(name, "ok", f"{calibration.source}, without a date")
    try:
        made = datetime.datetime.fromisoformat(calibration.created)
    except ValueError:
        return Check(
            name, "warning", f"`{calibration.created}` is no date.", f"Correct it in {path}."
        )
    if made.tzinfo is None:
        made = made.replace(tzinfo=datetime.UTC)
    days = (datetime.datetime.now(datetime.UTC) - made).days
    finding = f"{calibration.source}, {days} day{'s' if days != 1 else ''} old"
    if days > OLD_DAYS:
        return Check(name, "warning", finding, f"Older than {OLD_DAYS} days: calibrate again.")
    return Check(name, "ok", finding)


def check_disk(runs: Path) -> Check:
    """Room for runs."""
    place = runs.absolute()
    while not place.exists():
        place = place.parent
    free = shutil.disk_usage(place).free
    finding = f"{format_bytes(free)} free in {place}: about {int(free // RUN_BYTES)} full-size runs"
    if free < RUN_BYTES:
        return Check(
            "disk", "failed", finding, "Free some space, or write runs elsewhere with --out."
        )
    if not os.access(place, os.W_OK):
        return Check(
            "disk", "failed", f"{place} is not writable.", "Write runs elsewhere with --out."
        )
    if free < 5 * RUN_BYTES:
        return Check("disk", "warning", finding, "Free some space before a campaign.")
    return Check("disk", "ok", finding)


def check_memory() -> Check:
    """Memory for a full-size reconstruction."""
    memory = psutil.virtual_memory()
    finding = (
        f"{format_bytes(memory.available)} of {format_bytes(memory.total)} available, "
        f"{os.cpu_count()} processors"
    )
    if memory.available < NEEDED_MEMORY_BYTES:
        return Check(
            "memory",
            "warning",
            finding,
            f"A full-size reconstruction takes up to {format_bytes(NEEDED_MEMORY_BYTES)}; "
            "close other programs.",
        )
    return Check("memory", "ok", finding)


def check_kernel_cache() -> Check:
    """Whether compiled kernels can be kept, so that only the first run waits for the compiler."""
    given = os.environ.get("NUMBA_CACHE_DIR")
    place = Path(given) if given else Path(__file__).parent / "reconstruction"
    while not place.exists():
        place = place.parent
    if os.access(place, os.W_OK):
        return Check("kernel cache", "ok", f"compiled kernels are kept in {place}")
    return Check(
        "kernel cache",
        "warning",
        f"{place} is not writable.",
        "Every run may compile its kernels anew; set NUMBA_CACHE_DIR to a writable folder.",
    )
