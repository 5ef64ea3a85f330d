"""Which profile and calibration hold, and that the answer says where they come from."""

from pathlib import Path

import pytest

from reliefscope.calibration.store import CalibrationStore
from reliefscope.errors import InvalidInputError
from reliefscope.microscope import fresh_path, resolve_instrument
from reliefscope.models.calibration import Calibration
from reliefscope.models.instrument import load_profile

PORT = "/dev/ttyACM0"


@pytest.fixture
def store(tmp_path: Path) -> CalibrationStore:
    return CalibrationStore(tmp_path / "calibrations")


def measured(profile: str = "benchtop", **changes: object) -> Calibration:
    nominal = Calibration.nominal(load_profile(profile))
    return nominal.model_copy(update={"source": "measured", **changes})


def test_nominal_where_nothing_else_is_known(store: CalibrationStore) -> None:
    found = resolve_instrument(PORT, store=store)
    assert found.profile.name == "benchtop"
    assert found.calibration == Calibration.nominal(found.profile)
    assert (found.profile_from, found.calibration_from) == ("default", "nominal")


def test_stored_calibration_of_this_serial_number_comes_first(store: CalibrationStore) -> None:
    store.save(measured(pupil_scale=1.1))
    store.save(measured(pupil_scale=1.2), "RS-7")
    assert resolve_instrument(PORT, store=store).calibration.pupil_scale == 1.1
    found = resolve_instrument(PORT, serial_number="RS-7", store=store)
    assert found.calibration.pupil_scale == 1.2
    assert "RS-7" in found.calibration_from
    other = resolve_instrument(PORT, serial_number="RS-8", store=store)
    assert other.calibration.pupil_scale == 1.1


def test_given_calibration_wins(store: CalibrationStore, tmp_path: Path) -> None:
    store.save(measured(pupil_scale=1.1))
    path = tmp_path / "mine.json"
    path.write_text(measured(pupil_scale=1.3).model_dump_json())
    found = resolve_instrument(PORT, calibration=path, store=store)
    assert found.calibration.pupil_scale == 1.3
    assert found.calibration_from == str(path)


def test_what_comes_with_the_url_is_used(store: CalibrationStore) -> None:
    store.save(measured(pupil_scale=1.1))
    found = resolve_instrument("sim://benchtop?size=96x72&as_built=4", store=store)
    assert found.profile.shape == (72, 96)
    assert found.calibration.source == "factory"
    assert found.calibration.pupil_scale != 1.1
    named = resolve_instrument("sim://benchtop?size=96x72", profile="benchtop", store=store)
    assert named.profile.shape == (72, 96)
    other = resolve_instrument("sim://benchtop?size=96x72", profile="miniature", store=store)
    assert other.profile.name == "miniature"
    assert other.calibration_from == "nominal"


def test_calibration_of_another_instrument_is_refused(store: CalibrationStore) -> None:
    nominal = Calibration.nominal(load_profile("benchtop"))
    few = nominal.model_copy(
        update={
            "led_positions_mm": nominal.led_positions_mm[:8],
            "led_intensities": nominal.led_intensities[:8],
        }
    )
    with pytest.raises(InvalidInputError, match="8 LEDs"):
        resolve_instrument(PORT, calibration=few, store=store)


def test_unknown_profile_names_the_known_ones(store: CalibrationStore) -> None:
    with pytest.raises(InvalidInputError) as caught:
        resolve_instrument(PORT, profile="desktop", store=store)
    assert "benchtop" in caught.value.hint
    assert "miniature" in caught.value.hint


def test_damaged_stored_calibration_is_not_passed_over(store: CalibrationStore) -> None:
    path = store.save(measured())
    path.write_text('{"profile": "benchtop"}')
    with pytest.raises(InvalidInputError, match="pixel_um"):
        resolve_instrument(PORT, store=store)
    assert store.list() == [(path, None)]


def test_saving_keeps_the_former_calibration(store: CalibrationStore) -> None:
    store.save(measured(pupil_scale=1.1))
    path = store.save(measured(pupil_scale=1.2))
    kept = list(path.parent.glob("*.old"))
    assert len(kept) == 1
    assert '"pupil_scale": 1.1' in kept[0].read_text()
    assert [calibration.pupil_scale for _, calibration in store.list() if calibration] == [1.2]


def test_names_from_the_device_cannot_leave_the_folder(store: CalibrationStore) -> None:
    assert store.path("benchtop", "../../etc/passwd").parent == store.folder


def test_fresh_path_skips_finished_and_unfinished_runs(tmp_path: Path) -> None:
    assert fresh_path("run", tmp_path).name == "run-001"
    (tmp_path / "run-001").mkdir()
    (tmp_path / "run-002.partial").mkdir()
    assert fresh_path("run", tmp_path).name == "run-003"
