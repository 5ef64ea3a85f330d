"""The hardware guide says what the board header says."""

import subprocess
import sys

from tests.support import REPOSITORY


def test_tables_and_diagram_are_those_of_the_header():
    command = [sys.executable, str(REPOSITORY / "tools" / "hardware_tables.py"), "--check"]
    assert subprocess.run(command, check=False).returncode == 0
