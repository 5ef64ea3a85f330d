"""The compiled core through ctypes: finding it, and what its lines do."""

import shutil

import pytest

from reliefscope.errors import DeviceError
from reliefscope_sim import firmware as binding
from reliefscope_sim.display import Mounting
from reliefscope_sim.factory import factory_settings
from reliefscope_sim.firmware import LIBRARY_VARIABLE, Firmware, locate_library
from reliefscope_sim.trace import OutputPin, TraceKind


@pytest.fixture
def device():
    made = Firmware(b"", boot_nonce=5)
    yield made
    made.close()


def test_library_of_the_variable_comes_first(tmp_path, monkeypatch):
    copy = tmp_path / "core.so"
    shutil.copy(locate_library(), copy)
    monkeypatch.setenv(LIBRARY_VARIABLE, str(copy))
    assert locate_library() == copy
    monkeypatch.setenv(LIBRARY_VARIABLE, str(tmp_path / "absent.so"))
    with pytest.raises(DeviceError, match="does not exist"):
        locate_library()


def test_library_beside_the_package_is_found(tmp_path, monkeypatch):
    folder = tmp_path / "reliefscope_sim" / "_firmware"
    folder.mkdir(parents=True)
    (folder / binding.library_name()).touch()
    monkeypatch.delenv(LIBRARY_VARIABLE, raising=False)
    monkeypatch.setattr(binding.reliefscope_sim, "__path__", [str(folder.parent)])
    monkeypatch.setattr("sys.path", [])
    assert locate_library().parent == folder
    monkeypatch.setattr(binding.reliefscope_sim, "__path__", [str(tmp_path)])
    with pytest.raises(DeviceError, match="pip install -e"):
        locate_library()
    monkeypatch.setattr("sys.path", [str(tmp_path)])
    assert locate_library().parent == folder


def test_what_is_no_library_is_refused(tmp_path, monkeypatch):
    wrong = tmp_path / "wrong.so"
    wrong.write_text("not a library")
    monkeypatch.setenv(LIBRARY_VARIABLE, str(wrong))
    with pytest.raises(DeviceError, match="builds it anew"):
        Firmware(b"", boot_nonce=1)


def test_glass_is_shut_by_the_first_command_after_reset(device):
    device.run_until(100_000)
    records = device.trace()
    times = [record.time_us for record in records]
    assert times == sorted(times)
    first = next(record for record in records if record.kind is TraceKind.SPI)
    released = next(
        record
        for record in records
        if (record.kind, record.argument, record.level) == (TraceKind.PIN, OutputPin.LCD_RESET, 1)
    )
    assert 0 < released.time_us < first.time_us
    assert first.argument == 0
    assert first.payload[0] in {0xAE, 0xA5}
    assert device.trace() == []


def test_same_calls_give_the_same_bytes():
    def trace():
        made = Firmware(b"", boot_nonce=5)
        for time_us in (10, 500, 20_000, 300_000):
            made.run_until(time_us)
        records = made.trace()
        made.close()
        return records

    assert trace() == trace()


def test_idle_device_needs_no_time(device):
    device.run_until(1_000_000)
    device.serial_out()
    device.run_until(1_000_001)
    assert device.next_wakeup_us() > 1_000_001


def test_closing_twice_does_no_harm(device):
    device.close()


def test_factory_settings_differ_by_glass_and_mounting():
    images = {
        factory_settings(variant, mounting, "SIM-test")
        for variant in ("E", "S")
        for mounting in Mounting
    }
    assert len(images) == 4
    assert all(b"SIM-test" in image for image in images)
