"""One clear error each: a line, a hint, a status from the table; an object with ``--json``."""

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from reliefscope import cli
from reliefscope.cli import app as application
from reliefscope.errors import Cancelled, ExitCode, InvalidInputError, LockedError

Raised = Callable[[BaseException], None]


@pytest.fixture
def raised(monkeypatch: pytest.MonkeyPatch) -> Raised:
    """Make every run of the command line end with an exception."""

    def make(error: BaseException) -> None:
        def fail(**_: object) -> None:
            raise error

        monkeypatch.setattr(application, "app", fail)

    return make


@pytest.mark.parametrize(
    ("error", "status"),
    [
        (InvalidInputError("That is wrong.", hint="Do it right."), ExitCode.INVALID_INPUT),
        (LockedError("Process 12 holds the run.", hint="Wait for it."), ExitCode.LOCKED),
        (Cancelled("Stopped."), ExitCode.CANCELLED),
        (KeyboardInterrupt(), ExitCode.CANCELLED),
        (ZeroDivisionError("division by zero"), ExitCode.FAILURE),
    ],
)
def test_status_is_that_of_the_error(
    raised: Raised, capsys: pytest.CaptureFixture[str], error: BaseException, status: ExitCode
) -> None:
    raised(error)
    assert cli.main(["info", "x"]) == status
    shown = capsys.readouterr()
    assert shown.out == ""
    assert shown.err.startswith("error: ")
    assert "Traceback" not in shown.err


def test_message_and_hint_keep_their_brackets(
    raised: Raised, capsys: pytest.CaptureFixture[str]
) -> None:
    raised(InvalidInputError("views[0] is [bold].", hint="One.\nTwo [x]."))
    cli.main(["info", "x"])
    lines = capsys.readouterr().err.splitlines()
    assert lines == ["error: views[0] is [bold].", "hint:  One.", "hint:  Two [x]."]


def test_json_prints_one_object(raised: Raised, capsys: pytest.CaptureFixture[str]) -> None:
    raised(InvalidInputError("That is wrong.", hint="Do it right."))
    assert cli.main(["info", "x", "--json"]) == ExitCode.INVALID_INPUT
    assert json.loads(capsys.readouterr().out) == {
        "schema_version": 1,
        "error": {
            "kind": "InvalidInputError",
            "message": "That is wrong.",
            "hint": "Do it right.",
            "exit_code": 3,
        },
    }


def test_debug_shows_where(raised: Raised, capsys: pytest.CaptureFixture[str]) -> None:
    raised(ZeroDivisionError("division by zero"))
    assert cli.main(["--debug", "info", "x"]) == ExitCode.FAILURE
    assert "Traceback" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        (["fly"], "fly"),
        (["verify"], "RUN"),
        (["info", "x", "--colour"], "--colour"),
        (["reconstruct", "x", "--progress", "loud"], "loud"),
    ],
)
def test_wrong_command_line_is_a_usage_error(
    capsys: pytest.CaptureFixture[str], arguments: list[str], expected: str
) -> None:
    assert cli.main(arguments) == ExitCode.USAGE
    error = capsys.readouterr().err
    assert error.startswith("error: ")
    assert expected in error
    assert "--help" in error


def test_usage_error_as_json(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["verify", "--json"]) == ExitCode.USAGE
    assert json.loads(capsys.readouterr().out)["error"]["exit_code"] == ExitCode.USAGE


def test_no_screen_without_a_terminal(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["tui"]) == ExitCode.INVALID_INPUT
    assert "terminal" in capsys.readouterr().err


@pytest.mark.parametrize("size", ["320", "3x3", "axb", "320x-1"])
def test_wrong_size_is_refused_before_anything_happens(
    capsys: pytest.CaptureFixture[str], size: str
) -> None:
    assert cli.main(["demo", "--size", size]) == ExitCode.INVALID_INPUT
    assert "--size 320x240" in capsys.readouterr().err


def test_resume_takes_no_other_plan(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["acquire", "--resume", "r", "--out", "q"]) == ExitCode.INVALID_INPUT
    assert "--resume" in capsys.readouterr().err


@pytest.mark.parametrize("option", ["--sample", "--notes"])
def test_resume_takes_no_other_description(capsys: pytest.CaptureFixture[str], option: str) -> None:
    assert cli.main(["acquire", "--resume", "r", option, "foo"]) == ExitCode.INVALID_INPUT
    assert option in capsys.readouterr().err


@pytest.mark.parametrize(("option", "value"), [("--exposure-ms", "0"), ("--settle-ms", "-1")])
def test_a_wrong_duration_names_its_option_and_unit(
    capsys: pytest.CaptureFixture[str], option: str, value: str
) -> None:
    assert cli.main(["acquire", option, value]) == ExitCode.INVALID_INPUT
    shown = capsys.readouterr().err
    assert option in shown
    assert "milliseconds" in shown


def test_bundle_of_an_absent_run(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["bundle", "runs/nope"]) == ExitCode.DATASET
    assert "There is no run runs/nope" in " ".join(capsys.readouterr().err.split())


@pytest.fixture
def broken(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> tuple[Path, str, str]:
    """A run that a fault ended: folder, address of the instrument, and what was printed."""
    address = "sim://broken?size=32x24&seed=4&fault=camera_drop:9"
    out = tmp_path / "my run"
    arguments = ["acquire", "-d", address, "-o", str(out), "--progress", "none"]
    assert cli.main(arguments) == ExitCode.CAMERA
    return out.with_name("my run.partial"), address, " ".join(capsys.readouterr().err.split())


def test_the_way_on_names_the_run_and_the_instrument(broken: tuple[Path, str, str]) -> None:
    partial, address, shown = broken
    assert "RUN" not in shown
    shown = shown.replace(" ", "")  # lines are broken anywhere
    assert f"acquire--resume'{partial}'--device'{address}'`".replace(" ", "") in shown


@pytest.mark.parametrize("change", ["seed=5", "scene=flat", "as_built=3", "size=48x32"])
def test_another_twin_does_not_go_on(
    broken: tuple[Path, str, str], capsys: pytest.CaptureFixture[str], change: str
) -> None:
    partial, _, _ = broken
    key = change.partition("=")[0]
    options = {"size": "size=32x24", "seed": "seed=4"} | {key: change}
    address = "sim://broken?" + "&".join(options.values())
    status = cli.main(["acquire", "-d", address, "--resume", str(partial), "--progress", "none"])
    shown = capsys.readouterr().err
    assert status == ExitCode.INVALID_INPUT
    assert "--profile" not in shown
    assert "fault=camera_drop:9" in shown, "the instrument that began the run is named"
