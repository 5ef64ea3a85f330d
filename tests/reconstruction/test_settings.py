from pathlib import Path

import pytest

from reliefscope.errors import InvalidInputError
from reliefscope.reconstruction.settings import (
    METHODS,
    PaperSettings,
    Settings,
    load_settings,
    settings_for,
)


def test_methods_have_names() -> None:
    assert Settings() == settings_for("joint")
    assert [settings_for(name).method for name in METHODS] == list(METHODS)
    with pytest.raises(InvalidInputError, match="papr") as caught:
        settings_for("papr")
    assert "paper" in caught.value.hint


def test_what_cannot_be_meant_is_refused() -> None:
    with pytest.raises(ValueError, match="must be odd"):
        PaperSettings(window=14)
    with pytest.raises(ValueError, match=r"must be \[lowest, highest\]"):
        Settings(height_range_um=(5.0, 5.0))
    with pytest.raises(ValueError, match="`paper` must be left out with `method: joint`"):
        Settings(paper=PaperSettings(window=11))


def test_only_the_part_of_the_method_is_saved_and_read_back() -> None:
    settings = Settings(method="paper", paper=PaperSettings(lam=0.07))
    saved = settings.as_dict()
    assert saved["paper"]["lam"] == 0.07
    assert "joint" not in saved
    assert Settings.model_validate(saved) == settings


def test_a_file_names_the_nearest_key(tmp_path: Path) -> None:
    path = tmp_path / "mine.yml"
    path.write_text("method: paper\npaper:\n  windw: 11\n", encoding="utf-8")
    with pytest.raises(InvalidInputError, match="did you mean `window`"):
        load_settings(path)
    path.write_text("method: paper\npaper:\n  window: 11\n", encoding="utf-8")
    assert load_settings(path) == Settings(method="paper", paper=PaperSettings(window=11))
