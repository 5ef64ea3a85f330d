"""Cameras are opened by the scheme of their URL, and by nothing else."""

from importlib.metadata import EntryPoint

import pytest

import reliefscope.camera as cameras
from reliefscope.camera import CameraSettings, camera_schemes, offers_camera, open_camera
from reliefscope.errors import CameraError, ExitCode, InvalidInputError


def backends(monkeypatch, *entries):
    monkeypatch.setattr(
        cameras, "entry_points", lambda group: [e for e in entries if e.group == group]
    )


def entry(name, value):
    return EntryPoint(name=name, value=value, group="reliefscope.cameras")


def test_scheme_chooses_the_backend_and_gets_the_whole_url(monkeypatch):
    backends(monkeypatch, entry("here", "urllib.parse:urlsplit"), entry("there", "nowhere:open"))
    assert camera_schemes() == ["here", "there"]
    assert offers_camera("HERE://x")
    assert not offers_camera("/dev/ttyACM0")
    assert open_camera("here://name?a=1").query == "a=1"


def test_unknown_scheme_names_those_that_are_installed(monkeypatch):
    backends(monkeypatch, entry("sim", "x:y"), entry("aravis", "x:y"))
    with pytest.raises(InvalidInputError, match=r"Did you mean `aravis`.*Installed: aravis, sim"):
        open_camera("aravi://Manta")
    with pytest.raises(InvalidInputError, match="no camera address"):
        open_camera("Manta")


def test_nothing_installed_says_how_to_install(monkeypatch):
    backends(monkeypatch)
    with pytest.raises(InvalidInputError, match="pip install"):
        open_camera("sim://benchtop")


def test_backend_that_cannot_be_loaded_names_its_extra(monkeypatch):
    backends(monkeypatch, entry("gentl", "no_such_module_here:open [gentl]"))
    with pytest.raises(CameraError, match=r"reliefscope\[gentl\]") as caught:
        open_camera("gentl://first")
    assert caught.value.exit_code is ExitCode.CAMERA


def test_the_twin_is_reached_through_its_entry_point():
    camera = open_camera("sim://opened-by-url?size=96x72&scene=flat")
    try:
        assert camera.configure(CameraSettings(1000, trigger=False)).exposure_us == 1000
        camera.arm()
        assert camera.next_frame(1.0).raw.shape == camera.info.shape == (72, 96)
    finally:
        camera.close()
