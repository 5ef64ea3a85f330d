"""Whatever a test left open must not reach the next one."""

import pytest

from reliefscope_sim.bench import Bench


@pytest.fixture(autouse=True)
def _no_bench_left_behind():
    yield
    left = sorted(Bench.in_use())
    assert left == [], f"left switched on: {left}"
