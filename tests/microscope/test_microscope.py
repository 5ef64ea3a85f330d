"""The public API over the simulated instrument, at a small size."""

import itertools
import threading
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from reliefscope.errors import (
    CameraError,
    Cancelled,
    DeviceError,
    InvalidInputError,
    OutputExistsError,
)
from reliefscope.jobs import Job
from reliefscope.microscope import Microscope, open_run
from reliefscope.models.camera import Frame
from reliefscope.models.plan import Plan, default_plan

NUMBERS = itertools.count(1)


def address(options: str = "") -> str:
    """A bench of its own for every test."""
    return f"sim://microscope-{next(NUMBERS)}?scene=flat&size=96x72{options}"


@pytest.fixture
def microscope() -> Iterator[Microscope]:
    with Microscope.open(address()) as opened:
        yield opened


def small_plan(microscope: Microscope) -> Plan:
    plan = default_plan(microscope.profile)
    return plan.model_copy(
        update={
            "views": plan.views[:2],
            "lights": plan.lights[:3],
            "dark_accumulate": 2,
            "leakage_accumulate": 2,
        }
    )


def test_snap_shows_what_glass_and_light_are(microscope: Microscope) -> None:
    dark = microscope.snap().raw.mean()
    microscope.show_disc(0.0, 0.0)
    unlit = microscope.snap().raw.mean()
    microscope.set_light({8: 4095})
    lit = microscope.snap().raw.mean()
    microscope.set_light({8: 2048})
    half = microscope.snap().raw.mean()
    microscope.shut()
    leaking = microscope.snap().raw.mean()
    assert dark == pytest.approx(unlit, rel=0.05)
    assert lit > 5 * dark
    assert (half - dark) / (lit - dark) == pytest.approx(0.5, abs=0.03)
    assert dark < leaking < lit + 3 * (lit - dark)
    assert microscope.device.status().light == 0, "the light that was on is on again"


def test_exposure_scales_the_signal(microscope: Microscope) -> None:
    microscope.show_disc(0.0, 0.0)
    black = microscope.snap(10_000).raw.mean()
    microscope.set_light({8: 4095})
    short, long = (microscope.snap(us).raw.mean() - black for us in (5_000, 10_000))
    assert long / short == pytest.approx(2.0, rel=0.03)


def test_live_keeps_the_light_on_past_every_limit(microscope: Microscope) -> None:
    """Link watchdog and on-time limit are both shorter than this live view."""
    microscope.show_disc(0.0, 0.0)
    microscope.set_light({8: 400})
    microscope.live_exposure_us = 200_000  # few frames for much time
    limit_us = microscope.device.limits().led_on_time_us
    stop = threading.Event()
    means: list[float] = []
    first_us = last_us = 0
    for frame in microscope.live(stop):
        first_us = first_us or frame.time_us
        last_us = frame.time_us
        means.append(float(frame.raw.mean()))
        if last_us - first_us > 1.5 * limit_us + 3_000_000:
            stop.set()
    settled = np.array(means[5:])
    assert len(settled) > 30
    assert settled.min() > 0.5 * np.median(settled)
    assert microscope.device.status().light == 0


def test_light_goes_off_when_the_microscope_is_closed() -> None:
    url = address()
    microscope = Microscope.open(url)
    microscope.set_light({1: 100})
    microscope.close()
    with Microscope.open(url) as again:
        assert again.device.status().light == 255


def test_all_off_tells_the_truth(microscope: Microscope) -> None:
    microscope.set_light({1: 100, 2: 0})
    assert dict(microscope.light) == {1: 100}
    microscope.all_off()
    assert not microscope.light
    assert microscope.device.status().light == 255
    microscope.set_light({3: 50})
    microscope.set_light({})
    assert microscope.device.status().light == 255


@pytest.mark.parametrize("levels", [{16: 100}, {-1: 100}, {0: 5000}, {0: -1}])
def test_wrong_light_is_refused_before_it_is_sent(
    microscope: Microscope, levels: dict[int, int]
) -> None:
    with pytest.raises(InvalidInputError, match="level"):
        microscope.set_light(levels)


def test_acquire_verifies_and_hands_on_every_frame(microscope: Microscope, tmp_path: Path) -> None:
    frames: list[Frame] = []
    plan = small_plan(microscope)
    run = microscope.acquire(
        plan, tmp_path / "r", sample="basalt", notes="first", on_frame=frames.append
    )
    exposures = sum(request.accumulate for request in plan.requests())
    assert len(frames) == exposures
    facts = run.describe()
    assert facts["complete"]
    assert facts["sample"] == "basalt"
    assert facts["images"] == "11 of 11"
    assert facts["results"] == {}
    assert run.verify().ok
    assert microscope.device.status().light == 255
    assert microscope.aperture_name == "shut"
    microscope.set_light({3: 100})
    with pytest.raises(OutputExistsError):
        microscope.acquire(plan, tmp_path / "r")
    assert not microscope.light
    assert microscope.device.status().light == 255


def test_cancelled_run_is_resumed(microscope: Microscope, tmp_path: Path) -> None:
    job = Job()
    job.subscribe(lambda event: job.cancel() if event.done == 4 else None)
    with pytest.raises(Cancelled):
        microscope.acquire(small_plan(microscope), tmp_path / "r", job=job)
    partial = tmp_path / "r.partial"
    facts = open_run(partial).describe()
    assert not facts["complete"]
    assert facts["images"] != "11 of 11"
    run = microscope.resume(partial)
    assert run.path == tmp_path / "r"
    assert run.verify().ok


def test_plan_summary_adds_up(microscope: Microscope) -> None:
    facts = microscope.plan_summary(small_plan(microscope))
    assert facts["images"] == 1 + 3 + 6 + 1
    assert facts["exposures"] == 2 + 6 + 6 + 1


def test_device_without_a_camera(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr("reliefscope.microscope.live.offers_camera", lambda url: False)
    with Microscope.open(address()) as microscope:
        assert not microscope.has_camera
        microscope.set_light({0: 100})
        with pytest.raises(CameraError) as caught:
            microscope.acquire(small_plan(microscope), tmp_path / "r")
        assert "--camera" in caught.value.hint
    assert not list(tmp_path.iterdir())


def test_nothing_is_opened_with_a_wrong_profile() -> None:
    with pytest.raises(InvalidInputError, match="desktop"):
        Microscope.open("/dev/no-such-port", profile="desktop")
    with pytest.raises(DeviceError):
        Microscope.open("/dev/no-such-port")
