from pathlib import Path

import numpy as np
import pytest

from reliefscope.errors import Cancelled, DatasetError, InvalidInputError, OutputExistsError
from reliefscope.reconstruction import result
from reliefscope.reconstruction.result import Reconstruction
from reliefscope.reconstruction.settings import PaperSettings, Settings


def example(offset: float = 0.0) -> Reconstruction:
    rng = np.random.default_rng(1)
    height = rng.normal(offset, 1, (7, 9)).astype(np.float32)
    height[0, 0] = np.nan
    return Reconstruction(
        height_um=height,
        pixel_um=1.12,
        settings=Settings(method="paper", paper=PaperSettings(lam=0.07)),
        kind="fused",
        stereo_quality=rng.random((7, 9), dtype=np.float32),
        normals=rng.random((7, 9, 3), dtype=np.float32),
        figures={"solver_iterations": 9},
        timings_s={"match": 1.5},
        peak_memory_mb=321.0,
    )


def test_a_result_comes_back_as_it_was(tmp_path: Path) -> None:
    saved = example()
    folder = result.save_result(saved, tmp_path, "paper")
    assert folder == tmp_path / "results" / "paper"
    loaded = result.load_result(tmp_path, "paper")
    np.testing.assert_array_equal(loaded.height_um, saved.height_um)
    np.testing.assert_array_equal(loaded.normals, saved.normals)
    assert loaded.albedo is None
    assert loaded.settings == saved.settings
    assert loaded.summary() == saved.summary()
    assert loaded.timings_s == {"match": 1.5}
    assert result.list_results(tmp_path) == ["paper"]


def test_shares_are_of_the_valid_pixels(tmp_path: Path) -> None:
    """Half the image is masked: a perfect other half is a coverage of 1, not of 0.5."""
    valid = np.zeros((7, 9), bool)
    valid[:, 4:] = True
    height = np.where(valid, np.float32(1), np.float32(np.nan))
    masked = Reconstruction(
        height_um=height,
        pixel_um=1.0,
        settings=Settings(),
        kind="stereo",
        stereo_quality=np.where(valid, np.float32(0.7), np.float32(0)),
        valid=valid,
    )
    facts = masked.summary()
    assert facts["height_known"] == facts["stereo_accepted"] == 1.0
    assert facts["stereo_quality_median"] == pytest.approx(0.7)
    result.save_result(masked, tmp_path, "half")
    loaded = result.load_result(tmp_path, "half")
    np.testing.assert_array_equal(loaded.valid, valid)
    assert loaded.summary() == facts


def test_nothing_is_replaced_unasked(tmp_path: Path) -> None:
    result.save_result(example(), tmp_path, "one")
    with pytest.raises(OutputExistsError, match="nothing was changed") as caught:
        result.save_result(example(50.0), tmp_path, "one")
    assert "--name one-2" in caught.value.hint
    assert np.nanmean(result.load_result(tmp_path, "one").height_um) < 10
    result.save_result(example(50.0), tmp_path, "one", overwrite=True)
    assert np.nanmean(result.load_result(tmp_path, "one").height_um) > 10
    assert [path.name for path in (tmp_path / "results").iterdir()] == ["one"]


def test_a_failed_write_leaves_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object, **__: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(np, "savez", fail)
    with pytest.raises(DatasetError, match="No space left"):
        result.save_result(example(), tmp_path, "one")
    assert list((tmp_path / "results").iterdir()) == []


def test_a_result_whose_drawing_was_stopped_replaces_nothing(tmp_path: Path) -> None:
    def draw(place: Path) -> None:
        (place / "half.png").touch()
        raise Cancelled("Stopped.")

    result.save_result(example(), tmp_path, "one")
    with pytest.raises(Cancelled):
        result.save_result(example(50.0), tmp_path, "one", overwrite=True, draw=draw)
    assert np.nanmean(result.load_result(tmp_path, "one").height_um) < 10
    assert [path.name for path in (tmp_path / "results").iterdir()] == ["one"]


def test_damage_is_told(tmp_path: Path) -> None:
    with pytest.raises(DatasetError, match="there are: none"):
        result.load_result(tmp_path, "one")
    folder = result.save_result(example(), tmp_path, "one")
    text = (folder / "result.json").read_text()
    (folder / "result.json").write_text(text.replace('"schema_version": 2', '"schema_version": 99'))
    with pytest.raises(DatasetError, match="version 99"):
        result.load_result(tmp_path, "one")
    (folder / "result.json").write_text(text)
    data = (folder / "arrays.npz").read_bytes()
    (folder / "arrays.npz").write_bytes(data[: len(data) // 2])
    with pytest.raises(DatasetError, match="damaged"):
        result.load_result(tmp_path, "one")
    (folder / "result.json").write_text(text[:-30])
    with pytest.raises(DatasetError, match="damaged"):
        result.load_result(tmp_path, "one")


@pytest.mark.parametrize("name", ["", "../x", "a/b", ".hidden"])
def test_names_stay_in_the_folder(tmp_path: Path, name: str) -> None:
    with pytest.raises(InvalidInputError, match="cannot be the name"):
        result.save_result(example(), tmp_path, name)
