"""``reliefscope focus-stack``: a folder of pictures becomes a height map."""

import json

import cv2
import numpy as np

from reliefscope.cli import main


def pictures(folder):
    """Texture at the height of the fourth of eight pictures, 16 bits."""
    folder.mkdir()
    noise = np.random.default_rng(4).random((60, 80)).astype(np.float32)
    texture = cv2.GaussianBlur(noise, (0, 0), 1.0)
    for index in range(8):
        sigma = abs(index - 3)
        image = texture if sigma == 0 else cv2.GaussianBlur(texture, (0, 0), sigma)
        assert cv2.imwrite(str(folder / f"im{index}.png"), (60000 * image).astype(np.uint16))
    return folder


def test_folder_to_height_map(tmp_path, capsys):
    folder, out = pictures(tmp_path / "stack"), tmp_path / "out"
    command = ["focus-stack", str(folder), "--step-um", "5", "--pixel-um", "0.69"]
    command += ["--out", str(out), "--json", "--progress", "none"]
    assert main(command) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["summary"]["images"] == 8
    assert found["summary"]["size_px"] == [80, 60]
    with np.load(out / "arrays.npz") as arrays:
        assert abs(np.median(arrays["height_um"]) - 15.0) < 1e-3
        assert arrays["focused"].shape == (60, 80)
    assert {path.name for path in out.iterdir()} == {
        "arrays.npz",
        "result.json",
        "focused.png",
        "overview.png",
    }
    assert main(command) == 4
    assert json.loads(capsys.readouterr().out)["error"]["kind"] == "OutputExistsError"


def test_unknown_step_is_asked_for(tmp_path, capsys):
    assert main(["focus-stack", str(pictures(tmp_path / "stack"))]) == 3
    assert "--step-um" in capsys.readouterr().err
