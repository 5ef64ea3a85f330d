"""``reliefscope calibrate z``: the twin's hidden pupil scale is found, and used afterwards."""

import json

import pytest

from reliefscope.cli import main
from reliefscope.microscope import resolve_instrument
from reliefscope_sim.url import SimUrl

URL = "sim://benchtop?scene=grid&as_built=7&calibration=nominal&size=160x120"


def test_hidden_pupil_scale_of_the_twin_is_found_stored_and_used(tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("RELIEFSCOPE_CALIBRATIONS", str(tmp_path / "store"))
    out = tmp_path / "z"
    arguments = ["calibrate", "z", "--device", URL + "&stage_um={stage_um}", "--out", str(out)]
    arguments += ["--from-um", "-40", "--to-um", "40", "--step-um", "40", "--json"]
    assert main([*arguments, "--progress", "none"]) == 0
    found = json.loads(capsys.readouterr().out)

    address = SimUrl.parse(URL)
    truth = address.load_as_built(address.load_profile()).pupil_scale
    assert truth > 1.02
    assert found["pupil_scale"] == pytest.approx(truth, rel=0.005)
    assert found["residual_rms_um"] < 0.5
    assert [step["stage_um"] for step in found["steps"]] == [-40, 0, 40]

    held = resolve_instrument(URL, serial_number=address.device_serial).calibration
    assert (held.source, held.pupil_scale) == ("measured", pytest.approx(truth, rel=0.005))
    other = resolve_instrument(URL.replace("as_built=7", "as_built=8"), serial_number="SIM-other")
    assert other.calibration.source == "nominal"

    # the same from the runs that were taken, which a real stage would have given
    runs = [f"{run}={run.name[5:-2]}" for run in sorted(out.glob("stage*"))]
    assert main(["calibrate", "z", *runs, "--no-store", "--out", str(tmp_path / "again")]) == 0
    assert "Pupil scale" in capsys.readouterr().out
    again = json.loads((tmp_path / "again" / "z_scale.json").read_text())
    assert again["steps"] == found["steps"]
    assert again["stored"] is None
    calibration = json.loads((tmp_path / "again" / "calibration.json").read_text())
    assert calibration["pupil_scale"] == pytest.approx(found["pupil_scale"], abs=1e-4)


def test_a_stage_that_nobody_moves_is_refused_before_anything_is_taken(tmp_path, capsys):
    assert main(["calibrate", "z", "--device", URL, "--out", str(tmp_path / "z")]) == 3
    assert "{stage_um}" in capsys.readouterr().err
    assert not (tmp_path / "z").exists()


@pytest.mark.parametrize(
    ("arguments", "named"),
    [
        ([], "either runs"),
        (["runs/a"], "RUN=UM"),
        (["runs/a=high"], "RUN=UM"),
        (["--device", URL + "&stage_um={stage_um}", "--step-um", "-5"], "no steps"),
    ],
)
def test_wrong_arguments_are_refused(arguments, named, capsys):
    assert main(["calibrate", "z", *arguments]) == 3
    assert named in capsys.readouterr().err
