"""The guide says what the program does: its examples run, its table of statuses is the real one."""

import re
from pathlib import Path

import pytest
from tests.support import REPOSITORY

from reliefscope.errors import ExitCode

GUIDE = REPOSITORY / "docs" / "guide"


def test_table_of_statuses_is_that_of_the_program() -> None:
    text = (GUIDE / "operator.md").read_text(encoding="utf-8")
    table = {
        int(status): meaning for status, meaning in re.findall(r"^\| (\d+) \| (.+) \|$", text, re.M)
    }
    assert table == {int(code): code.meaning for code in ExitCode}


def test_examples_of_the_scripting_guide_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    text = (GUIDE / "scripting.md").read_text(encoding="utf-8")
    examples = re.findall(r"^```python\n(.*?)^```", text, re.M | re.S)
    assert len(examples) >= 6
    names: dict[str, object] = {}
    for number, example in enumerate(examples):
        exec(compile(example, f"scripting.md, example {number}", "exec"), names)
    printed = capsys.readouterr().out
    assert "planes" in printed
    assert "['joint', 'wide']" in printed
    made = {path.name for path in (tmp_path / "runs").iterdir()}
    assert made >= {"first", "basalt-01", "campaign-A", "campaign-B"}


def test_every_command_of_the_guides_exists() -> None:
    from reliefscope.cli.app import app

    known = {command.name for command in (*app.registered_commands, *app.registered_groups)}
    for page in GUIDE.glob("*.md"):
        for command in re.findall(
            r"^ {4}reliefscope ([\w-]+)", page.read_text(encoding="utf-8"), re.M
        ):
            assert command in known, f"{page.name} uses `reliefscope {command}`"
