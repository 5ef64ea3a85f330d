"""``reliefscope fiducial``: both files from one command."""

import json

import trimesh

from reliefscope.cli import main


def test_solid_and_truth_in_one_go_and_never_over_another_file(tmp_path, capsys):
    stl, truth = tmp_path / "f.stl", tmp_path / "f.npz"
    arguments = ["fiducial", "--stl", str(stl), "--truth", str(truth), "--json"]
    arguments += [
        "--unit",
        "um",
        "--scale",
        "0.5",
        "--seed",
        "3",
        "--size",
        "120x110",
        "--pixel-um",
        "5",
    ]
    assert main(arguments) == 0
    result = json.loads(capsys.readouterr().out)
    assert (result["schema_version"], result["seed"], result["scale"]) == (1, 3, 0.5)
    assert result["stl"]["watertight"] is True
    assert result["stl"]["euler_number"] == 2
    assert abs(result["stl"]["volume_difference"]) < 1e-4
    assert result["stl"]["extent"] == [600.0, 600.0, 150.0]
    assert trimesh.load_mesh(stl).is_watertight
    assert result["truth"]["shape"] == [110, 120]

    stl.unlink()
    assert main(arguments) == 4
    assert json.loads(capsys.readouterr().out)["error"]["kind"] == "OutputExistsError"
    assert not stl.exists(), "nothing is written when one of the places is taken"


def test_nothing_to_make_is_refused_with_an_example(capsys):
    assert main(["fiducial"]) == 3
    assert "--stl fiducial.stl" in capsys.readouterr().err
