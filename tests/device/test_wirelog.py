"""The log of the link: what it keeps, and that it never ends what it is about."""

import itertools
import json
import logging
from pathlib import Path

import pytest

from reliefscope.device import wirelog
from reliefscope.device.wirelog import WireLog
from reliefscope.protocol.framing import Frame
from reliefscope.protocol.messages import HelloRequest

FRAME = Frame(HelloRequest.ID, 1, 0, b"")


def lines(path):
    return [json.loads(line) for line in path.read_text().splitlines()]


def test_a_file_begins_with_what_was_noted_before_and_ends_with_its_context(tmp_path):
    ticks = itertools.count(1)
    log = WireLog(clock_s=lambda: next(ticks) / 4, device="sim://benchtop?seed=3")
    log.note("out", FRAME)
    with log.written_to(tmp_path / "a"):
        log.note("in", FRAME)
        log.note_dropped("bad_crc", 2)
        with log.written_to(tmp_path / "b"):
            log.note_camera("arm", {})
    log.note("out", FRAME)
    head, *rest = lines(tmp_path / "a")
    assert (head["device"], head["clock"]) == ("sim://benchtop?seed=3", "instrument")
    assert [line["t"] for line in rest] == [0.25, 0.5, 0.75, 1.0]
    assert [line["dir"] for line in rest] == ["out", "in", "in", "camera"]
    assert rest[0]["frame"] == FRAME.encode().hex()
    assert rest[2]["dropped"] == {"bad_crc": 2}
    assert lines(tmp_path / "b")[1:] == rest


def test_an_existing_file_is_not_touched(tmp_path):
    path = tmp_path / "log"
    path.write_text("mine")
    with pytest.raises(FileExistsError), WireLog().written_to(path):
        pass
    with pytest.raises(FileExistsError):
        WireLog(path)
    assert path.read_text() == "mine"


def test_what_was_forgotten_is_told(tmp_path, monkeypatch):
    monkeypatch.setattr(wirelog, "KEPT_LINES", 3)
    log = WireLog()
    for _ in range(5):
        log.note("out", FRAME)
    with log.written_to(tmp_path / "log"):
        log.note("in", FRAME)
    head, *rest = lines(tmp_path / "log")
    assert head["forgotten_lines"] == 2
    assert [line["dir"] for line in rest] == ["out", "out", "out", "in"]


def test_a_log_that_cannot_be_written_ends_with_a_warning(tmp_path, caplog):
    full = Path("/dev/full")
    if not full.exists():
        pytest.skip("left out: no /dev/full on this system")
    log = WireLog()
    with caplog.at_level(logging.WARNING), log.written_to(tmp_path / "log"):
        log._files[0].close()
        log._files[0] = full.open("w")
        log.note("out", FRAME)
        log.note("out", FRAME)
    assert caplog.text.count("ends here") == 1
