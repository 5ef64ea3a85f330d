"""Progress, time left and cancellation."""

import pytest

from reliefscope.errors import Cancelled, ExitCode, ReliefscopeError
from reliefscope.jobs import Job, Progress
from reliefscope.units import format_bytes, format_duration


def test_a_stage_reports_every_unit_and_its_end() -> None:
    events: list[Progress] = []
    job = Job(events.append)
    with job.stage("expose", 3) as stage:
        for _ in range(3):
            stage.advance()
    assert [event.done for event in events] == [0, 1, 2, 3, 3]
    assert events[0].seconds_left is None
    assert events[-1].finished
    assert events[1].seconds_left == pytest.approx(2 * events[1].elapsed_s)
    assert set(job.timings_s) == {"expose"}


def test_the_same_stage_twice_adds_its_time() -> None:
    job = Job()
    with job.stage("fuse", 1):
        pass
    first = job.timings_s["fuse"]
    with job.stage("fuse", 1):
        pass
    assert job.timings_s["fuse"] > first


def test_cancellation_stops_at_the_next_unit_and_not_before() -> None:
    job = Job()
    done = 0
    with pytest.raises(Cancelled) as caught, job.stage("expose", 5) as stage:  # noqa: PT012
        for _ in range(5):
            done += 1
            if done == 2:
                job.cancel()
            stage.advance()
    assert done == 2
    assert caught.value.exit_code is ExitCode.CANCELLED
    assert "expose" in job.timings_s


def test_every_exit_code_has_a_meaning() -> None:
    assert all(code.meaning.endswith(".") for code in ExitCode)


def test_an_error_shows_its_hint() -> None:
    error = ReliefscopeError("The run is damaged.", hint="Type `reliefscope verify RUN`.")
    assert str(error) == "The run is damaged.\nType `reliefscope verify RUN`."


@pytest.mark.parametrize(
    ("seconds", "text"), [(8.24, "8.2 s"), (185, "3 min 05 s"), (7800, "2 h 10 min")]
)
def test_durations_read_well(seconds: float, text: str) -> None:
    assert format_duration(seconds) == text


@pytest.mark.parametrize(("count", "text"), [(12, "12 B"), (1024, "1.0 kB"), (5.53e8, "553.0 MB")])
def test_sizes_read_well(count: float, text: str) -> None:
    assert format_bytes(count) == text
