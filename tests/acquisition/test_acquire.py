"""Acquisition through the real protocol, the compiled firmware and the simulated instrument."""

import errno
import os
import signal
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.acquisition.bench import (
    Instrument,
    OtherCamera,
    OtherDevice,
    instrument,
    small_plan,
)
from tests.support import REPOSITORY

from reliefscope.acquisition import acquire, resume
from reliefscope.dataset import Run, RunWriter, durable
from reliefscope.device import DeviceRebootedError
from reliefscope.errors import (
    CameraError,
    Cancelled,
    DatasetError,
    DeviceError,
    InvalidInputError,
    LockedError,
    OutputExistsError,
    ReliefscopeError,
)
from reliefscope.jobs import Job, Progress
from reliefscope.models.camera import Frame
from reliefscope.models.plan import Aperture, Light
from reliefscope.protocol.messages import SLOT_NONE, SequenceState

IMAGES = 1 + 3 + 6 + 1


@pytest.fixture(scope="module")
def reference(tmp_path_factory: pytest.TempPathFactory) -> Run:
    """A run taken without interruption."""
    with instrument() as bench:
        return bench.acquire(tmp_path_factory.mktemp("reference") / "run")


def assert_same_pixels(run: Run, reference: Run) -> None:
    """Equal but for the glass: 0.4 s after a switch it still has up to 0.8 % of its way to go, later less."""
    for key, request in reference.layout.requests.items():
        np.testing.assert_allclose(
            run.raw(*key).astype(float),
            reference.raw(*key),
            rtol=0.005,
            atol=1.5 * request.accumulate,
            err_msg=str(key),
        )


def assert_dark(bench: Instrument) -> None:
    status = bench.device.status()
    assert status.light == SLOT_NONE
    assert status.sequence is SequenceState.IDLE


def test_a_plan_becomes_a_verified_run(reference: Run) -> None:
    assert reference.complete
    assert reference.verify().ok
    assert reference.planned == IMAGES
    assert reference.spec.sample == "tilted plane"
    acquired = reference.spec.acquired
    assert acquired is not None
    assert acquired.sessions[0].device["board"] == "host"
    assert acquired.sessions[0].camera["vendor"] == "reliefscope"
    leakage = reference.record("leakage", None, 2)
    assert leakage.accumulated == len(leakage.frame_ids) == 3
    assert leakage.confirmed is not None
    assert leakage.confirmed.open_pixels == 0
    view = reference.record("view", 1, 2)
    assert view.confirmed is not None
    assert view.confirmed.levels == {2: 4095}
    assert view.settle_waited_us is not None
    assert view.settle_waited_us >= 400_000
    times = [entry.device_time_us for entry in reference.journal.entries.values()]
    assert times == sorted(times)


def test_the_picture_is_what_the_plan_lit(reference: Run) -> None:
    black = 0.01 * 4095
    dark = reference.raw("dark", None, None).mean() / 4
    assert dark == pytest.approx(black, abs=2)
    for light in range(3):
        leakage = reference.raw("leakage", None, light).mean() / 3
        view = reference.raw("view", 0, light).mean()
        assert dark + 50 < leakage < view - 20
        assert reference.linear(0, light).mean() > 0.005


def test_progress_counts_exposures_and_tells_device_time(tmp_path: Path) -> None:
    events: list[Progress] = []
    with instrument() as bench:
        bench.acquire(tmp_path / "run", job=Job(events.append))
        assert_dark(bench)
    taken = [event for event in events if event.stage == "acquire"]
    assert taken[-1].finished
    assert taken[-1].total == 4 + 3 * 3 + 6 + 1
    assert len([event for event in taken if event.note]) == IMAGES
    assert taken[1].note.startswith("dark, ")
    assert taken[-2].note == "centre, 0.0 s of the device's time left"


def cancel_after(images: int) -> Job:
    job = Job()
    seen = []

    def listen(event: Progress) -> None:
        if event.stage == "acquire" and event.note:
            seen.append(event.note)
            if len(seen) == images:
                job.cancel()

    job.subscribe(listen)
    return job


@pytest.mark.parametrize("images", [1, 6])
def test_cancel_pauses_and_resume_takes_the_rest(
    tmp_path: Path, images: int, reference: Run
) -> None:
    with instrument() as bench:
        with pytest.raises(Cancelled):
            bench.acquire(tmp_path / "run", job=cancel_after(images))
        assert_dark(bench)
        partial = tmp_path / "run.partial"
        taken = len((partial / "journal.jsonl").read_text().splitlines())
        assert images <= taken < IMAGES
        with pytest.warns(UserWarning, match="incomplete"):
            assert Run.open(partial).verify().damaged == {}
        run = bench.resume(partial)
        assert_dark(bench)
    assert run.complete
    assert len((run.path / "journal.jsonl").read_text().splitlines()) == IMAGES
    assert run.spec.acquired is not None
    assert len(run.spec.acquired.sessions) == 2
    assert_same_pixels(run, reference)


@pytest.mark.parametrize(
    ("fault", "kind", "message"),
    [
        ("camera_drop:9", CameraError, "The camera lost a frame: number 10 came instead of 9"),
        ("camera_drop:19", CameraError, "The camera stalled: the frame of exposure 19"),
        ("camera_unplug:7", CameraError, "The camera stalled at step 2: No strobe"),
        ("brown_out_at:8", DeviceRebootedError, "The device restarted"),
        ("stall_at:8", DeviceError, "did not answer"),
        ("link_cut:8", DeviceError, "lost"),
    ],
)
def test_a_fault_names_its_part_and_the_run_goes_on_later(
    tmp_path: Path, fault: str, kind: type[Exception], message: str, reference: Run
) -> None:
    with pytest.raises(kind, match=message) as caught, instrument(fault) as bench:
        bench.acquire(tmp_path / "run")
    assert isinstance(caught.value, ReliefscopeError)
    assert caught.value.hint
    partial = tmp_path / "run.partial"
    assert 0 < len((partial / "journal.jsonl").read_text().splitlines()) < IMAGES
    with RunWriter.resume(partial) as writer:
        spec = writer.spec
        assert spec.acquired is not None
        # The instrument is another bench in this test; what it calls itself is not what is tested here.
        name = spec.acquired.sessions[0].device["serial_number"]
    with instrument(name=f"repaired-{fault.partition(':')[0]}") as bench:
        device = OtherDevice(bench.device)
        device.identity = replace(device.identity, serial_number=name)
        camera = OtherCamera(bench.camera, lambda frame: frame)
        camera.info = replace(bench.camera.info, serial=spec.acquired.sessions[0].camera["serial"])
        run = resume(partial, device, camera)  # type: ignore[arg-type]
    assert run.verify().ok
    assert_same_pixels(run, reference)


def test_a_bad_link_costs_only_time(tmp_path: Path, reference: Run) -> None:
    with instrument("link_loss:0.05,link_duplicate:0.05") as bench:
        run = bench.acquire(tmp_path / "run")
        assert bench.device.link_counters["retries"] > 0
    assert_same_pixels(run, reference)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"index": 1}, "exposure number 1 instead of 0"),
        ({"step": 3}, "step 3 instead of 0"),
        ({"repeat": 1}, "repeat 1 instead of 0"),
        ({"aperture": 2}, "aperture slot 2 instead of 255"),
        ({"light": 1}, "light slot 1 instead of 255"),
        ({"table_hash": 5}, "table 5 instead of"),
        ({"run_id": 7}, "sequence 7 instead of"),
        ({"exposure_us": 100}, "exposure time .* 100 instead of 20000"),
        ({"settle_waited_us": 10}, "waited 10 us instead of 400000"),
    ],
)
def test_an_event_that_disagrees_ends_the_run(
    tmp_path: Path, change: dict[str, int], message: str
) -> None:
    with instrument() as bench:
        bench.device = OtherDevice(bench.device, lambda event: replace(event, **change))  # type: ignore[assignment]
        with pytest.raises(DeviceError, match=message) as caught:
            bench.acquire(tmp_path / "run")
        assert_dark(bench)
    assert "--resume" in caught.value.hint
    assert (tmp_path / "run.partial" / "journal.jsonl").read_text() == ""


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda frame: replace(frame, raw=frame.raw[:, 1:]), r"frame of uint16 \(48, 63\)"),
        (lambda frame: replace(frame, raw=frame.raw + np.uint16(5000)), "12 bits reach 4095"),
        (lambda frame: replace(frame, frame_id=frame.frame_id + 1), "lost a frame"),
        (lambda frame: replace(frame, frame_id=min(frame.frame_id, 2)), "gave a frame twice"),
    ],
)
def test_a_frame_that_disagrees_ends_the_run(
    tmp_path: Path, change: Callable[[Frame], Frame], message: str
) -> None:
    with instrument() as bench:
        bench.camera = OtherCamera(bench.camera, change)  # type: ignore[assignment]
        with pytest.raises(CameraError, match=message):
            bench.acquire(tmp_path / "run")
        assert_dark(bench)


def test_a_device_with_little_room_takes_several_tables(tmp_path: Path, reference: Run) -> None:
    with instrument() as bench:
        bench.device = OtherDevice(bench.device, aperture_slots=1, light_slots=2, steps=4)  # type: ignore[assignment]
        run = bench.acquire(tmp_path / "run")
    assert_same_pixels(run, reference)


def test_a_disk_that_fails_surfaces_and_loses_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, reference: Run
) -> None:
    real = durable.AppendFile.append
    calls = 0

    def fail_later(self: durable.AppendFile, line: bytes) -> None:
        nonlocal calls
        calls += 1
        if calls > 4:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        real(self, line)

    with instrument() as bench:
        monkeypatch.setattr(durable.AppendFile, "append", fail_later)
        with pytest.raises(DatasetError, match="disk is full"):
            bench.acquire(tmp_path / "run")
        monkeypatch.undo()
        assert_dark(bench)
        run = bench.resume(tmp_path / "run")
    assert_same_pixels(run, reference)


def test_damaged_pixels_are_taken_again(tmp_path: Path, reference: Run) -> None:
    with instrument() as bench:
        run = bench.acquire(tmp_path / "run")
        chunk = run.path / run.layout.chunk_path(("view", 1, 1))
        chunk.write_bytes(chunk.read_bytes()[:-100])
        again = bench.resume(run.path)
    assert again.verify().ok
    assert_same_pixels(again, reference)
    assert len((run.path / "journal.jsonl").read_text().splitlines()) == IMAGES + 1


KILLED = """
import sys
from pathlib import Path
from reliefscope.jobs import Job
from tests.acquisition.bench import instrument
def told(progress):
    if progress.stage == "acquire" and progress.note:
        print(progress.done, flush=True)
with instrument(name="killed") as bench:
    bench.acquire(Path(sys.argv[1]), job=Job(told))
"""


def test_kill_in_the_middle_keeps_what_was_acknowledged(tmp_path: Path, reference: Run) -> None:
    process = subprocess.Popen(
        [sys.executable, "-c", KILLED, str(tmp_path / "run")],
        stdout=subprocess.PIPE,
        text=True,
        cwd=REPOSITORY,
    )
    assert process.stdout is not None
    for _ in range(4):
        process.stdout.readline()
    process.send_signal(signal.SIGKILL)
    process.wait()
    process.stdout.close()
    partial = tmp_path / "run.partial"
    with pytest.warns(UserWarning, match="incomplete"):
        halfway = Run.open(partial)
    taken = set(halfway.journal.entries)
    assert halfway.verify().damaged == {}
    with instrument(name="killed") as bench:
        run = bench.resume(partial)
    assert run.verify().ok
    second = {key for key, entry in run.journal.entries.items() if key not in taken}
    assert len(second) == IMAGES - len(taken)
    assert len((run.path / "journal.jsonl").read_text().splitlines()) == IMAGES
    assert_same_pixels(run, reference)


def test_a_run_in_use_is_not_resumed_twice(tmp_path: Path) -> None:
    with instrument() as bench:
        with pytest.raises(Cancelled):
            bench.acquire(tmp_path / "run", job=cancel_after(2))
        with RunWriter.resume(tmp_path / "run"), pytest.raises(LockedError, match="process"):
            bench.resume(tmp_path / "run.partial")


def test_another_instrument_is_refused(tmp_path: Path) -> None:
    with instrument() as bench:
        with pytest.raises(Cancelled):
            bench.acquire(tmp_path / "run", job=cancel_after(2))
        other = OtherCamera(bench.camera, lambda frame: frame)
        other.info = replace(bench.camera.info, serial="another")
        with pytest.raises(InvalidInputError, match="camera serial"):
            resume(tmp_path / "run", bench.device, other)  # type: ignore[arg-type]


def _refused(bench: Instrument, out: Path, **changes: Any) -> None:
    arguments: dict[str, Any] = {
        "device": bench.device,
        "camera": bench.camera,
        "plan": small_plan(),
        "profile": bench.profile,
        "calibration": bench.calibration,
        "out": out,
    }
    acquire(**(arguments | changes))


def test_preflight_refuses_before_anything_moves(tmp_path: Path) -> None:
    out = tmp_path / "run"
    with instrument() as bench:
        before = bench.device.counters()
        far = small_plan(lights=1).model_copy(
            update={"lights": (Light(name="far", levels={16: 4095}),)}
        )
        with pytest.raises(InvalidInputError, match="names LED 16"):
            _refused(bench, out, plan=far)
        with pytest.raises(InvalidInputError, match=r"frames of .* \(48, 64\)"):
            _refused(bench, out, profile=bench.profile.resized(32, 32))
        short = bench.calibration.model_copy(update={"led_positions_mm": (), "led_intensities": ()})
        with pytest.raises(InvalidInputError, match="calibration knows 0 LEDs"):
            _refused(bench, out, calibration=short)
        weak = OtherDevice(bench.device)
        weak.limits = lambda: replace(bench.device.limits(), level_budget=4000)
        with pytest.raises(InvalidInputError, match="level sum of 4095"):
            _refused(bench, out, device=weak)
        weak.limits = lambda: replace(bench.device.limits(), led_on_time_us=10_000)
        with pytest.raises(InvalidInputError, match="longer than an LED may be on"):
            _refused(bench, out, device=weak)
        weak.limits = lambda: replace(bench.device.limits(), led_period_us=333)
        with pytest.raises(InvalidInputError, match="not a whole number"):
            _refused(bench, out, device=weak)
        weak.limits = lambda: replace(bench.device.limits(), led_level_step=4001)
        with pytest.raises(InvalidInputError, match="cannot make"):
            _refused(bench, out, device=weak)
        with pytest.raises(InvalidInputError, match="drives 2 LEDs"):
            _refused(bench, out, device=OtherDevice(bench.device, leds=2))
        shut = Aperture(name="shut", bitmap=np.zeros((64, 128), dtype=bool))
        with pytest.raises(InvalidInputError, match="opens no pixel"):
            _refused(bench, out, plan=small_plan(views=1, centre=shut))
        soft = OtherCamera(bench.camera, lambda frame: frame)
        soft.info = replace(bench.camera.info, trigger_inputs=False)
        with pytest.raises(InvalidInputError, match="no trigger input"):
            _refused(bench, out, camera=soft)
        slow = OtherCamera(bench.camera, lambda frame: frame)
        slow.configure = lambda settings: replace(settings, exposure_us=50_000)
        with pytest.raises(CameraError, match="exposes for 50000 us"):
            _refused(bench, out, camera=slow)
        assert list(tmp_path.iterdir()) == []
        out.mkdir()
        with pytest.raises(OutputExistsError):
            _refused(bench, out)
        after = bench.device.counters()
        assert after.exposures == before.exposures == 0
    assert list(tmp_path.iterdir()) == [out]
    assert list(out.iterdir()) == []
