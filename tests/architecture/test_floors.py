"""Imports run downward: the floors are declared in pyproject.toml."""

import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest
from tests.support import REPOSITORY


def run_linter(folder: Path) -> subprocess.CompletedProcess[str]:
    """The import linter over the packages in ``folder``, not over the installed ones.

    ``-S`` keeps the import hook of an editable installation out, which would lead back to this checkout.
    """
    code = (
        f"import sys; sys.path[:0] = ['host', 'sim', {sysconfig.get_path('purelib')!r}];"
        "from importlinter.cli import lint_imports_command; lint_imports_command()"
    )
    return subprocess.run(
        [sys.executable, "-S", "-c", code, "--no-cache"],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
    )


def test_imports_run_downward() -> None:
    result = run_linter(REPOSITORY)
    assert result.returncode == 0, result.stdout + result.stderr


@pytest.mark.parametrize(
    ("module", "line"),
    [
        ("host/reliefscope/dataset/__init__.py", "import reliefscope.reconstruction"),
        ("host/reliefscope/errors.py", "import reliefscope.models.plan"),
        ("sim/reliefscope_sim/url.py", "import reliefscope.models.geometry"),
        ("host/reliefscope/camera/__init__.py", "import reliefscope_sim"),
    ],
)
def test_an_upward_import_is_found(tmp_path: Path, module: str, line: str) -> None:
    for part in ("host", "sim"):
        shutil.copytree(
            REPOSITORY / part, tmp_path / part, ignore=shutil.ignore_patterns("__pycache__")
        )
    shutil.copy(REPOSITORY / "pyproject.toml", tmp_path)
    broken = tmp_path / module
    broken.write_text(broken.read_text() + f"\n{line}\n")
    result = run_linter(tmp_path)
    assert result.returncode != 0
    assert "BROKEN" in result.stdout
