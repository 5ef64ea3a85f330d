"""Each check of the doctor finds what it is there for."""

import datetime
import json
import shutil
from collections import namedtuple
from pathlib import Path

import pytest

from reliefscope import cli, doctor
from reliefscope.calibration.store import CalibrationStore
from reliefscope.device import PortInfo
from reliefscope.errors import ExitCode
from reliefscope.models.calibration import Calibration
from reliefscope.models.instrument import load_profile

Usage = namedtuple("Usage", "total used free")
TEENSY = PortInfo("/dev/null", "USB Serial", "1234560", is_teensy=True)


def test_simulated_instrument_answers() -> None:
    (check,) = doctor.check_instruments()
    assert check.status == "ok"
    assert "board host" in check.finding


def test_no_instrument_installed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(doctor, "entry_points", lambda group: [])
    (check,) = doctor.check_instruments()
    assert check.status == "failed"
    assert "pip install -e ." in check.hint


def test_other_protocol_version_prints_the_flash_command(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(doctor, "SCHEMA_HASH", bytes(16))
    (check,) = doctor.check_instruments()
    assert check.status == "failed"
    assert "reliefscope flash --port" in check.hint


def test_no_teensy_is_no_failure() -> None:
    (check,) = doctor.check_ports([PortInfo("/dev/ttyS0", "n/a", "", is_teensy=False)])
    assert check.status == "absent"
    assert "/dev/ttyS0" in check.finding


def test_forbidden_port_prints_the_udev_command(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(doctor.os, "access", lambda path, mode: False)
    (check,) = doctor.check_ports([TEENSY])
    assert check.status == "failed"
    assert "udev" in check.hint


def test_port_that_cannot_be_opened_is_told() -> None:
    (check,) = doctor.check_ports([PortInfo("/dev/no-such", "", "", is_teensy=True)])
    assert check.status == "failed"
    assert "/dev/no-such" in check.finding


@pytest.mark.parametrize(
    ("days", "status"), [(0, "ok"), (doctor.OLD_DAYS, "ok"), (doctor.OLD_DAYS + 2, "warning")]
)
def test_age_of_a_calibration(tmp_path: Path, days: int, status: str) -> None:
    store = CalibrationStore(tmp_path)
    created = datetime.datetime.now(datetime.UTC) - datetime.timedelta(days=days, hours=1)
    nominal = Calibration.nominal(load_profile("benchtop"))
    store.save(nominal.model_copy(update={"source": "measured", "created": created.isoformat()}))
    (check,) = doctor.check_calibrations(store)
    assert check.status == status
    assert f"{days} day" in check.finding


def test_damaged_and_absent_calibrations(tmp_path: Path) -> None:
    store = CalibrationStore(tmp_path)
    assert [check.status for check in doctor.check_calibrations(store)] == ["absent"]
    (tmp_path / "benchtop.json").write_text("{")
    assert [check.status for check in doctor.check_calibrations(store)] == ["failed"]


@pytest.mark.parametrize(("free", "status"), [(1e8, "failed"), (2e9, "warning"), (1e12, "ok")])
def test_room_on_the_disk(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, free: float, status: str
) -> None:
    monkeypatch.setattr(shutil, "disk_usage", lambda place: Usage(free, 0, free))
    assert doctor.check_disk(tmp_path / "runs" / "new").status == status


def test_doctor_as_json(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["doctor", "--json"]) == ExitCode.OK
    answer = json.loads(capsys.readouterr().out)
    assert answer["healthy"]
    assert {"versions", "sim://", "disk", "memory"} <= {check["name"] for check in answer["checks"]}


def test_failure_has_its_own_status(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(
        doctor, "examine", lambda: [doctor.Check("port", "failed", "It [is] broken.", "Mend it.")]
    )
    assert cli.main(["doctor"]) == ExitCode.CHECKS_FAILED
    text = capsys.readouterr().out
    assert "It [is] broken." in text
    assert "Mend it." in text
