"""The terminal screen: a thin face over :mod:`reliefscope.microscope`."""

from __future__ import annotations

from pathlib import Path

__all__ = ["run"]


def run(
    device_url: str | None = None,
    *,
    camera_url: str | None = None,
    profile: str | None = None,
    calibration: Path | None = None,
) -> None:
    """Open the screen and stay until the user quits; connects to ``device_url`` at once where given."""
    from reliefscope.microscope import Microscope
    from reliefscope.tui.app import ReliefscopeApp

    def opener(url: str) -> Microscope:
        return Microscope.open(url, camera_url, profile=profile, calibration=calibration)

    ReliefscopeApp(opener, device_url).run()
