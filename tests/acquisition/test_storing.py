"""The thread that stores images: order, errors, a disk that stands still."""

import logging
import threading
import time
from pathlib import Path

import pytest
from tests.dataset.helpers import pixels, record, small_spec

from reliefscope.acquisition import storing
from reliefscope.acquisition.storing import DiskThread
from reliefscope.dataset import RunWriter
from reliefscope.errors import DatasetError


def test_everything_given_is_stored_in_order(tmp_path: Path) -> None:
    with RunWriter.create(tmp_path / "run", small_spec()) as writer:
        order = [request.key for request in writer.missing()]
        with DiskThread(writer) as disk:
            for request in writer.missing():
                disk.put(record(request), pixels(request, writer.spec))
        assert writer.missing() == []
        assert len(order) == 10


def store(writer: RunWriter, count: int, error: type[Exception] | None = None) -> None:
    """Give ``count`` images to a thread, the first one a moment earlier; then fail where asked to."""
    with DiskThread(writer) as disk:
        for request in writer.missing()[:count]:
            disk.put(record(request), pixels(request, writer.spec))
            time.sleep(0.02)
        if error is not None:
            raise error


def fail_once(writer: RunWriter, monkeypatch: pytest.MonkeyPatch) -> None:
    put = writer.put

    def fail(*_: object) -> None:
        monkeypatch.setattr(writer, "put", put)
        raise DatasetError("no space", hint="free some space")

    monkeypatch.setattr(writer, "put", fail)


def test_an_error_surfaces_and_nothing_is_stored_after_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with RunWriter.create(tmp_path / "run", small_spec()) as writer:
        fail_once(writer, monkeypatch)
        with pytest.raises(DatasetError, match="no space"):
            store(writer, 10)
        assert len(writer.missing()) == 10


def test_an_error_of_the_last_image_surfaces(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with RunWriter.create(tmp_path / "run", small_spec()) as writer:
        fail_once(writer, monkeypatch)
        with pytest.raises(DatasetError, match="no space"):
            store(writer, 1)


def test_an_error_on_the_way_out_does_not_hide_the_first(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    with RunWriter.create(tmp_path / "run", small_spec()) as writer:
        fail_once(writer, monkeypatch)
        with caplog.at_level(logging.WARNING), pytest.raises(KeyError):
            store(writer, 1, KeyError)
    assert "no space" in caplog.text


def test_a_disk_that_stands_still_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(storing, "STALL_S", 0.05)
    monkeypatch.setattr(storing, "QUEUE_IMAGES", 2)
    release = threading.Event()
    with RunWriter.create(tmp_path / "run", small_spec()) as writer:
        monkeypatch.setattr(writer, "put", lambda *_: release.wait(10))
        with pytest.raises(DatasetError, match="The disk stalled"):
            store(writer, 10)
        release.set()
