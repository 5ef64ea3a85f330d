"""The commands that look after the instrument: flash and link-test."""

import json

import pytest
from tests.flash.boards import Desk, Teensy, write_image

import reliefscope.flash.flasher as flasher_module
from reliefscope.cli import main


@pytest.fixture
def desk(monkeypatch):
    """A desk whose boards the commands see."""
    desk = Desk()
    monkeypatch.setattr(flasher_module, "Surroundings", desk.around)
    return desk


def test_flash_and_its_report(desk, tmp_path, capsys):
    desk.boards.append(Teensy(mode="bootloader"))
    path = write_image(tmp_path)
    assert main(["flash", str(path), "--json", "--progress", "json"]) == 0
    out, err = capsys.readouterr()
    told = json.loads(out)
    assert told["schema_version"] == 1
    assert (told["confirmed"], told["after"]) == (True, "0.1.0 (0123abcd)")
    events = [json.loads(line) for line in err.splitlines()]
    last = [e for e in events if e["stage"] == "write"][-1]
    assert (last["done"], last["finished"]) == (told["blocks"], True)


def test_dry_run_touches_nothing(desk, tmp_path, capsys):
    desk.boards.append(Teensy())
    assert main(["flash", str(write_image(tmp_path)), "--dry-run", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["board"]["port"] == "/dev/ttyACM0"
    assert told["blocks"] == 16
    assert desk.boards[0].mode == "serial"
    assert main(["flash", str(write_image(tmp_path)), "--dry-run"]) == 0
    assert "reliefscope 0.1.0 (0123abcd) for teensy31" in capsys.readouterr().out


def test_wrong_image_and_force(desk, tmp_path, capsys):
    desk.boards.append(Teensy(mode="bootloader"))
    path = str(write_image(tmp_path, product="blinky"))
    assert main(["flash", path, "--json"]) == 3
    assert "--force" in json.loads(capsys.readouterr().out)["error"]["hint"]
    assert not desk.boards[0].writes
    assert main(["flash", path, "--force", "--progress", "none"]) == 0
    assert "forced: it is firmware of 'blinky'" in capsys.readouterr().err


def test_without_an_image_it_says_how_to_get_one(desk, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr("reliefscope.flash.image.IMAGE_FOLDER", tmp_path / "absent")
    assert main(["flash"]) == 3
    assert "make firmware" in capsys.readouterr().err


def test_list_and_several_boards(desk, tmp_path, capsys):
    assert main(["flash", "--list"]) == 0
    assert "No Teensy is seen" in capsys.readouterr().out
    desk.boards += [Teensy(), Teensy(serial=7, port="/dev/ttyACM1", ports=(3,))]
    assert main(["flash", "--list"]) == 0
    assert "reliefscope flash --port /dev/ttyACM1" in capsys.readouterr().out
    assert main(["flash", "--list", "--json"]) == 0
    assert len(json.loads(capsys.readouterr().out)["boards"]) == 2
    assert main(["flash", str(write_image(tmp_path))]) == 5
    assert "There are 2 boards" in capsys.readouterr().err


def test_link_test(capsys):
    url = "sim://link-test-command?size=64x48"
    assert main(["link-test", url, "--requests", "20", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert (told["url"], told["unanswered"], told["lost_to_host"]) == (url, 0, 0)
    assert set(told["round_trip_ms"]) == {"min", "p50", "p99", "max"}
    assert main(["link-test", url + "&fault=link_loss:0.2", "--requests", "30"]) == 0
    shown = capsys.readouterr().out
    assert "retries" in shown
    assert "virtual time" in shown
