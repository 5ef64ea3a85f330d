"""Commands over the simulated instrument at a small size: what they print, leave, and refuse."""

import json
import shutil
from pathlib import Path
from typing import Any

import pytest

from reliefscope import cli
from reliefscope.cli.tables import readable_result
from reliefscope.errors import ExitCode
from reliefscope.microscope import Microscope, open_run
from reliefscope.models.plan import Plan, default_plan

Captured = pytest.CaptureFixture[str]
DEVICE = "sim://cli?scene=fiducial&size=96x72"


@pytest.fixture(scope="module")
def plan_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Four views under four lights."""
    with Microscope.open(DEVICE) as microscope:
        plan = default_plan(microscope.profile)
    small = plan.model_copy(
        update={
            "views": plan.views[:4],
            "lights": plan.lights[::4],
            "dark_accumulate": 2,
            "leakage_accumulate": 2,
        }
    )
    path = tmp_path_factory.mktemp("plan") / "small.json"
    path.write_text(small.model_dump_json(), encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def taken(plan_file: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A complete run."""
    run = tmp_path_factory.mktemp("runs") / "taken"
    arguments = ["acquire", "-d", DEVICE, "--plan", str(plan_file), "-o", str(run), "--json"]
    assert cli.main([*arguments, "--progress", "none", "--sample", "fiducial"]) == ExitCode.OK
    return run


@pytest.fixture
def run(taken: Path, tmp_path: Path) -> Path:
    """A copy of it."""
    return Path(shutil.copytree(taken, tmp_path / "run"))


def invoke(captured: Captured, *arguments: str) -> tuple[int, dict[str, Any]]:
    captured.readouterr()
    status = cli.main([*arguments, "--json"])
    shown = captured.readouterr()
    return status, json.loads(shown.out)


def test_acquire_tells_what_it_took(taken: Path, capsys: Captured) -> None:
    status, facts = invoke(capsys, "info", str(taken))
    assert status == ExitCode.OK
    assert facts["schema_version"] == 1
    assert facts["complete"]
    assert facts["views"] == 4
    assert facts["lights"] == 4
    assert facts["sample"] == "fiducial"


def test_info_for_people(taken: Path, capsys: Captured) -> None:
    assert cli.main(["info", str(taken)]) == ExitCode.OK
    text = capsys.readouterr().out
    assert "benchtop" in text
    assert "96 x 72 px" in text


def test_dry_run_moves_nothing(plan_file: Path, tmp_path: Path, capsys: Captured) -> None:
    place = tmp_path / "new"
    status, facts = invoke(
        capsys, "acquire", "-d", DEVICE, "--plan", str(plan_file), "-o", str(place),
        "--dry-run", "--exposure-ms", "10", "--settle-ms", "100",
    )  # fmt: skip
    assert status == ExitCode.OK
    assert not place.exists()
    plan = Plan.model_validate(facts["plan"])
    assert plan.exposure_us == 10_000
    assert plan.settle_ms == 100
    assert facts["views"] == 4


def test_verify_names_a_flipped_byte_and_changes_nothing(run: Path, capsys: Captured) -> None:
    status, report = invoke(capsys, "verify", str(run))
    assert status == ExitCode.OK
    assert report["ok"]
    chunk = next(path for path in sorted(run.rglob("c/*")) if path.is_file() or path.is_dir())
    chunk = next(path for path in sorted(chunk.rglob("*")) if path.is_file())
    data = bytearray(chunk.read_bytes())
    data[100] ^= 1
    chunk.write_bytes(data)
    status, report = invoke(capsys, "verify", str(run))
    assert status == ExitCode.VERIFICATION
    assert not report["ok"]
    assert len(report["damaged"]) == 1
    assert cli.main(["verify", str(run)]) == ExitCode.VERIFICATION
    assert "--resume" in capsys.readouterr().err
    assert chunk.read_bytes() == data


def test_resume_takes_what_is_damaged(run: Path, capsys: Captured) -> None:
    chunk = next(path for path in sorted(run.rglob("c/*/*")) if path.is_file() or path.is_dir())
    chunk = next(path for path in sorted(chunk.rglob("*")) if path.is_file())
    chunk.write_bytes(b"")
    assert not open_run(run).verify().ok
    status, facts = invoke(capsys, "acquire", "-d", DEVICE, "--resume", str(run))
    assert status == ExitCode.OK
    assert facts["complete"]
    assert open_run(run).verify().ok


def test_reconstruct_prints_and_stores_the_result(run: Path, capsys: Captured) -> None:
    status, result = invoke(capsys, "reconstruct", str(run), "--no-pictures")
    assert status == ExitCode.OK
    assert Path(result["results"]) == run / "results" / "joint"
    assert result["summary"]["kind"] == "fused"
    assert {"match", "fuse"} <= result["stages_s"].keys()
    again, error = invoke(capsys, "reconstruct", str(run), "--no-pictures")
    assert again == ExitCode.DATASET
    assert "--overwrite" in error["error"]["hint"]
    assert cli.main(["reconstruct", str(run), "--no-pictures", "--overwrite"]) == ExitCode.OK
    assert f"results  {run / 'results' / 'joint'}\n" in capsys.readouterr().out
    assert open_run(run).results == ["joint"]


def test_result_for_people_has_words_and_units(run: Path) -> None:
    outcome = open_run(run).reconstruct(pictures=False)
    shown = readable_result(outcome.facts(), stereo_quality=0.3, photometric_quality=0.25)
    assert len(shown) == len(outcome.facts())
    assert not [name for name in shown if "_" in name or name.endswith(" um")]
    assert shown["height known in"].endswith("% of the valid pixels")
    assert shown["size"] == "96 x 72 px"
    assert shown["greatest memory"].endswith(" MB")


def test_progress_as_json_lines(run: Path, capsys: Captured) -> None:
    assert cli.main(["verify", str(run), "--json", "--progress", "json"]) == ExitCode.OK
    shown = capsys.readouterr()
    assert json.loads(shown.out)["ok"]
    events = [json.loads(line) for line in shown.err.splitlines()]
    assert {event["event"] for event in events} == {"progress"}
    assert events[-1]["finished"]


@pytest.mark.parametrize(
    ("arguments", "status", "words"),
    [
        (["info", "no-such-run"], ExitCode.DATASET, "no-such-run"),
        (["verify", "no-such-run"], ExitCode.DATASET, "no-such-run"),
        (["reconstruct", "no-such-run"], ExitCode.DATASET, "no-such-run"),
        (["evaluate", "no-such-run"], ExitCode.DATASET, "no-such-run"),
        (["acquire", "--resume", "no-such-run", "-d", DEVICE], ExitCode.DATASET, "no-such-run"),
        (["import", "no-such.yml"], ExitCode.INVALID_INPUT, "no-such.yml"),
        (["acquire", "-d", DEVICE, "--profile", "desktop"], ExitCode.INVALID_INPUT, "benchtop"),
        (["acquire", "-d", "sim://x?scene=moon"], ExitCode.INVALID_INPUT, "fiducial"),
        (["acquire", "-d", "sim://x?scen=flat"], ExitCode.INVALID_INPUT, "scene"),
        (["acquire", "-d", "/dev/no-such-port"], ExitCode.DEVICE, "doctor"),
        (["acquire", "-d", DEVICE, "--plan", "no-such.yml"], ExitCode.INVALID_INPUT, "no-such.yml"),
        (["demo", "--scene", "moon"], ExitCode.INVALID_INPUT, "fiducial"),
        (["demo", "--finish", "velvet"], ExitCode.INVALID_INPUT, "dull"),
        (["demo", "--profile", "desktop"], ExitCode.INVALID_INPUT, "miniature"),
        (["demo", "--method", "papr"], ExitCode.INVALID_INPUT, "paper"),
    ],
)
def test_bad_input_is_one_clear_error(
    arguments: list[str],
    status: ExitCode,
    words: str,
    capsys: Captured,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    given, answer = invoke(capsys, *arguments)
    assert given == status
    error = answer["error"]
    assert error["exit_code"] == status
    assert words in error["message"] + error["hint"]
    assert error["hint"]
    assert not list(tmp_path.iterdir()), "nothing may be left behind"


def test_evaluate_without_a_result_tells_how_to_make_one(run: Path, capsys: Captured) -> None:
    status, answer = invoke(capsys, "evaluate", str(run))
    assert status == ExitCode.DATASET
    assert "reliefscope reconstruct" in answer["error"]["hint"]


@pytest.mark.parametrize(
    ("url", "sample", "known"),
    [
        ("sim://a?scene=fiducial", "", True),
        ("sim://a", "", True),
        ("sim://a?scene=regolith", "beside the fiducial", False),
        ("/dev/ttyACM0", "Fiducial 3", True),
        ("/dev/ttyACM0", "basalt", False),
    ],
)
def test_evaluate_refuses_another_sample_than_the_fiducial(
    url: str, sample: str, known: bool, run: Path, capsys: Captured
) -> None:
    assert cli.main(["reconstruct", str(run), "--no-pictures", "--progress", "none"]) == 0
    spec = json.loads((run / "run.json").read_text(encoding="utf-8"))
    assert spec["acquired"]["sessions"][0]["device"]["url"] == DEVICE
    spec["acquired"]["sessions"][0]["device"]["url"] = url
    spec["sample"] = sample
    (run / "run.json").write_text(json.dumps(spec), encoding="utf-8")
    status, answer = invoke(capsys, "evaluate", str(run))
    assert status == (ExitCode.OK if known else ExitCode.INVALID_INPUT)
    if not known:
        assert "reliefscope reconstruct" in answer["error"]["hint"]
        assert "reliefscope info" in answer["error"]["hint"]
    status, stated = invoke(capsys, "evaluate", str(run), "--fiducial")
    assert status == ExitCode.OK
    assert stated["table"]


def test_import_tells_the_next_command(tmp_path: Path, capsys: Captured) -> None:
    import cv2
    import numpy as np

    generator = np.random.default_rng(0)
    for light in range(3):
        image = generator.integers(0, 255, (24, 32), dtype=np.uint8)
        cv2.imwrite(str(tmp_path / f"light{light}.png"), image)
    (tmp_path / "set.yml").write_text(
        "pixel_um: 2.0\nviews: [{slope: [0, 0]}]\n"
        "lights: [{direction: [1, 0, 1]}, {direction: [0, 1, 1]}, {direction: [-1, -1, 1]}]\n"
        "pattern: light{light}.png\nsensor: mono\nbit_depth: 8\ny_axis: up\n",
        encoding="utf-8",
    )
    arguments = ["import", str(tmp_path / "set.yml"), "-o", str(tmp_path / "run")]
    assert cli.main(arguments) == ExitCode.OK
    assert "reliefscope reconstruct" in capsys.readouterr().out
    status, facts = invoke(capsys, "reconstruct", str(tmp_path / "run"), "--no-pictures")
    assert status == ExitCode.OK
    assert facts["summary"]["kind"] == "integrated"
