"""``--help`` answers at once: it loads nothing heavy."""

import json
import subprocess
import sys

import pytest

from reliefscope import __version__
from reliefscope.cli import main
from reliefscope.cli.app import app, prose
from reliefscope.cli.options import METHOD_NAMES

COMMANDS = [
    "demo",
    "acquire",
    "reconstruct",
    "evaluate",
    "experiment",
    "fiducial",
    "focus-stack",
    "verify",
    "bundle",
    "calibrate",
    "sim",
    "info",
    "import",
    "doctor",
    "tui",
    "flash",
    "light-probe",
    "estimate-lights",
    "link-test",
]
HEAVY = [
    "numpy",
    "numba",
    "scipy",
    "textual",
    "matplotlib",
    "cv2",
    "zarr",
    "serial",
    "usb",
    "bincopy",
    "trimesh",
    "PIL",
]
PROGRAM = """
import sys, json
from reliefscope.cli import main
from reliefscope.cli.app import app, prose
from reliefscope.cli.options import METHOD_NAMES
status = main({arguments!r})
sys.stdout.flush()
print(json.dumps({{"status": status, "modules": [m for m in {heavy!r} if m in sys.modules]}}))
"""


def help_of(arguments: list[str]) -> tuple[str, dict[str, object]]:
    program = PROGRAM.format(arguments=arguments, heavy=HEAVY)
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, timeout=60, check=True
    )
    text, last = done.stdout.rstrip("\n").rsplit("\n", 1)
    return text, json.loads(last)


@pytest.mark.parametrize("command", [None, *COMMANDS])
def test_help_loads_nothing_heavy(command: str | None) -> None:
    text, found = help_of(["--help"] if command is None else [command, "--help"])
    assert found == {"status": 0, "modules": []}
    assert "Usage" in text
    assert len(text.splitlines()) > 5


def test_help_names_every_command() -> None:
    text, _ = help_of(["-h"])
    for command in COMMANDS:
        assert f" {command} " in text


def test_without_a_command_the_help_is_shown_and_the_status_says_so() -> None:
    text, found = help_of([])
    assert found["status"] == 2
    assert "Usage" in text


def test_help_of_method_lists_the_methods() -> None:
    from reliefscope.reconstruction.settings import METHODS

    assert tuple(METHODS) == METHOD_NAMES
    for command in ("reconstruct", "demo"):
        text, _ = help_of([command, "--help"])
        assert all(name in text for name in METHOD_NAMES)


def test_help_joins_the_lines_of_a_paragraph() -> None:
    text = "One,\n    beside two.\n\n    Three\n    four.\n    "
    assert prose(text) == "One, beside two.\n\nThree four."
    for command in app.registered_commands:
        assert command.help
        assert "\n" not in command.help.replace("\n\n", "")


def test_version(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--version"]) == 0
    assert capsys.readouterr().out == f"reliefscope {__version__}\n"
