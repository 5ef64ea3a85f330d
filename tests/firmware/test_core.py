"""The C++ unit tests, one case each; built with address and undefined-behaviour sanitizers."""

import re
from pathlib import Path

import pytest

SOURCES = sorted(Path(__file__).parent.glob("*.cpp"))
CASES = [case for path in SOURCES for case in re.findall(r"^TEST\((\w+)\)", path.read_text(), re.M)]


@pytest.mark.parametrize("case", CASES)
def test_case(core_results, case):
    assert core_results["crash"] == ""
    assert core_results.get(case, "was not run").startswith("PASS"), core_results.get(case)


def test_every_case_that_runs_is_known_by_name(core_results):
    assert set(core_results) - {"crash"} == set(CASES)
    assert len(CASES) == len(set(CASES))
