"""A session that was recorded comes again, bit for bit, out of its bundle."""

import json
import zipfile
from pathlib import Path

import pytest
from tests.acquisition.bench import instrument, small_plan
from tests.sim.flow import LEFT, SHUT, SIZE, one_led, step, take

from reliefscope.camera import CameraSettings, RecordedCamera, open_camera
from reliefscope.cli import main
from reliefscope.device import Device
from reliefscope.errors import DatasetError, InvalidInputError, OutputExistsError, ReliefscopeError
from reliefscope.microscope import bundle_run
from reliefscope_sim.bench import Bench
from reliefscope_sim.recording import Recording
from reliefscope_sim.replay import play_file
from reliefscope_sim.serve import InstrumentServer
from reliefscope_sim.url import SimUrl

LINK = "link_loss:0.03,link_flip:0.001,link_duplicate:0.03,link_delay:3,link_loss_at:5"
PLAN = small_plan(dark_accumulate=2, leakage_accumulate=1)


@pytest.fixture(scope="module")
def bundle(tmp_path_factory) -> Path:
    """Of a run over a bad link."""
    place = tmp_path_factory.mktemp("bad-link") / "run"
    with instrument(LINK) as bench:
        bench.acquire(place, PLAN)
    return bundle_run(place)


def test_a_run_over_a_bad_link_comes_again_with_all_that_was_lost(bundle):
    recording = Recording.load(bundle)
    dropped = [h for h in recording.happenings if "dropped" in h.content]
    assert dropped, "the log tells of damaged frames"
    report = play_file(bundle)
    assert report.difference == ""
    assert report.same_answers == report.answers > 50
    assert report.same_pictures == report.pictures == 2 + 3 + 6 + 1
    assert report.sent == sum(h.direction == "out" for h in recording.happenings)
    assert Bench.in_use() == []


def test_a_bundle_holds_the_run_but_no_pixels(bundle):
    with zipfile.ZipFile(bundle) as packed:
        names = set(packed.namelist())
        assert names == {"bundle.json", "run.json", "journal.jsonl", "wire-01.jsonl"}
        about = json.loads(packed.read("bundle.json"))
    assert about["sessions"][0]["clock"] == "instrument"
    assert LINK in about["sessions"][0]["device"]
    assert bundle.stat().st_size < 200_000


@pytest.mark.parametrize(
    "fault",
    [
        "brown_out_at:4",
        "watchdog_at:4",
        "stall_at:4",
        "camera_drop:6",
        "camera_torn:5",
        "link_cut:5",
    ],
)
def test_a_failure_reproduces_itself(tmp_path, fault):
    with pytest.raises(ReliefscopeError), instrument(fault) as bench:
        bench.acquire(tmp_path / "run", PLAN)
    report = play_file(bundle_run(tmp_path / "run"))
    assert report.difference == ""
    assert report.answers > 20
    assert report.pictures > 1


def test_every_session_of_a_run_is_recorded(tmp_path):
    with pytest.raises(ReliefscopeError), instrument("camera_drop:6", name="same") as bench:
        bench.acquire(tmp_path / "run", PLAN)
    with instrument(name="same") as bench:
        run = bench.resume(tmp_path / "run")
    with zipfile.ZipFile(bundle_run(run.path)) as packed:
        names = packed.namelist()
    assert {"wire-01.jsonl", "wire-02.jsonl"} <= set(names)
    for number, pictures in ((1, 6), (2, 7)):
        report = play_file(run.path / f"wire-{number:02d}.jsonl")
        assert report.same
        assert report.pictures >= pictures - 1


def test_an_instrument_can_be_switched_on_where_a_recording_ends(tmp_path):
    with pytest.raises(ReliefscopeError), instrument("stall_at:4") as bench:
        bench.acquire(tmp_path / "run", PLAN)
    bundle = bundle_run(tmp_path / "run")
    url = f"sim://replay={bundle}"
    replayed = Bench.attach(url)
    try:
        assert replayed.shutter.pulses == 5
        assert replayed.profile.shape == (48, 64)
        with pytest.raises(ReliefscopeError):
            Device.open(url, 0.5)  # it stands still, as it did
    finally:
        replayed.release()
    named = f"sim://mine?replay={bundle}"
    assert SimUrl.parse(named).identity == SimUrl.parse(url).identity != "mine"
    camera = open_camera(named)
    assert camera.info.shape == (48, 64)
    camera.close()


def test_the_device_goes_on_from_there(bundle):
    with Device.open(f"sim://replay={bundle}") as device:
        assert device.counters().exposures == 12


def test_a_difference_is_told_with_its_time(tmp_path, bundle, capsys):
    with zipfile.ZipFile(bundle) as packed:
        lines = packed.read("wire-01.jsonl").decode().splitlines()
    frames = [n for n, line in enumerate(lines) if '"says": "frame"' in line]
    changed = json.loads(lines[frames[3]]) | {"crc32": 1}
    lines[frames[3]] = json.dumps(changed)
    altered = tmp_path / "wire-01.jsonl"
    altered.write_text("\n".join(lines) + "\n")
    assert main(["sim", "replay", str(altered), "--json"]) == 8
    said = json.loads(capsys.readouterr().out)
    assert not said["same"]
    assert said["same_pictures"] == said["pictures"] - 1
    assert f"At {changed['t']:.6f} s" in said["difference"]
    assert main(["sim", "replay", str(altered), "--no-pictures"]) == 0
    assert "Everything was the same" in capsys.readouterr().out


def test_a_session_over_tcp_is_repeated_by_the_hosts_clock(tmp_path):
    url = f"sim://benchtop?{SIZE}&scene=flat&seed=2"
    log = tmp_path / "wire.jsonl"
    with InstrumentServer(url) as server, Device.open(server.device_url, wire_log=log) as device:
        camera = RecordedCamera(open_camera(server.camera_url), device.log.note_camera)
        device.load_aperture(0, LEFT)
        device.load_light(0, one_led(8))
        camera.configure(CameraSettings(20_000))
        camera.arm()
        take(device, camera, [step(SHUT, 0, 1, 100_000), step(0, 0, 2, 400_000)])
        camera.close()
    report = play_file(log, instrument=url)
    assert report.pictures == report.same_pictures == 3
    assert report.same_answers > report.answers / 2
    other = play_file(log, instrument=url.replace("seed=2", "seed=3"))
    assert other.same_pictures == 0


def test_the_command_makes_a_bundle(tmp_path, capsys):
    with instrument() as bench:
        bench.acquire(tmp_path / "run", small_plan(1, 1, dark_accumulate=0, leakage_accumulate=0))
    out = tmp_path / "bug.zip"
    assert main(["bundle", str(tmp_path / "run"), "--out", str(out), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["bytes"] == out.stat().st_size
    with pytest.raises(OutputExistsError):
        bundle_run(tmp_path / "run", out)
    for log in (tmp_path / "run").glob("wire-*.jsonl"):
        log.unlink()
    with pytest.raises(DatasetError, match="no record"):
        bundle_run(tmp_path / "run")


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        ("", "first line"),
        ('{"t": 0, "dir": "log", "schema_version": 99}\n', "first line"),
        (
            '{"t": 0, "dir": "log", "schema_version": 1, "forgotten_lines": 3}\n',
            "beginning is lost",
        ),
        ('{"t": 0, "dir": "log", "schema_version": 1}\n{"t": 1, "dir": "out"}\n', "damaged"),
        ("[1]\n", "no objects"),
        ("{\n", "Expecting"),
    ],
)
def test_what_is_no_recording_is_refused(tmp_path, content, reason):
    path = tmp_path / "wire.jsonl"
    path.write_text(content)
    with pytest.raises(InvalidInputError, match=reason):
        Recording.load(path)
    with pytest.raises(InvalidInputError, match="no recording"):
        Recording.load(tmp_path / "absent")
