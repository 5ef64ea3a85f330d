"""Cameras by URL.

The scheme of the URL chooses the entry point of the group ``reliefscope.cameras``, a callable
``open(url) -> Camera``; a package that brings a camera registers itself there.  What a camera must do is said
by :class:`reliefscope.models.camera.Camera`.
"""

from __future__ import annotations

import difflib
from collections.abc import Callable
from importlib.metadata import EntryPoint, entry_points
from typing import cast

from reliefscope.camera.recorded import RecordedCamera
from reliefscope.errors import CameraError, InvalidInputError
from reliefscope.models.camera import (
    Camera,
    CameraBusyError,
    CameraInfo,
    CameraLostError,
    CameraSettings,
    CameraTimeout,
    Frame,
)

__all__ = [
    "Camera",
    "CameraBusyError",
    "CameraInfo",
    "CameraLostError",
    "CameraSettings",
    "CameraTimeout",
    "Frame",
    "RecordedCamera",
    "camera_schemes",
    "offers_camera",
    "open_camera",
]

GROUP = "reliefscope.cameras"


def camera_schemes() -> list[str]:
    """URL schemes for which a camera backend is installed."""
    return sorted({entry.name for entry in entry_points(group=GROUP)})


def offers_camera(url: str) -> bool:
    """Whether the scheme of ``url`` names an installed camera backend."""
    return _scheme(url) in camera_schemes()


def open_camera(url: str) -> Camera:
    """Open the camera at ``url``, for example ``sim://benchtop``.

    Raises
    ------
    InvalidInputError
        If no camera backend is installed for the scheme; names those that are.
    CameraError
        If the backend cannot be loaded or the camera cannot be opened.
    """
    entry = _backend(url)
    try:
        opener = cast(Callable[[str], Camera], entry.load())
    except ImportError as error:
        needed = (
            f"`pip install 'reliefscope[{entry.extras[0]}]'`" if entry.extras else "its package"
        )
        raise CameraError(
            f"The camera backend for {entry.name}:// cannot be loaded: {error}.",
            hint=f"Install what it needs: {needed}.",
        ) from error
    return opener(url)


def _scheme(url: str) -> str:
    scheme, separator, _ = url.partition(":")
    return scheme.lower() if separator else ""


def _backend(url: str) -> EntryPoint:
    scheme = _scheme(url)
    found = [entry for entry in entry_points(group=GROUP) if entry.name == scheme]
    if found:
        return found[0]
    known = camera_schemes()
    if not scheme:
        raise InvalidInputError(
            f"`{url}` is no camera address.",
            hint=f"Write SCHEME://NAME with one of these schemes: {_listed(known)}.",
        )
    nearest = difflib.get_close_matches(scheme, known, n=1)
    advice = f"Did you mean `{nearest[0]}`? " if nearest else ""
    raise InvalidInputError(
        f"No camera backend is installed for {scheme}://.",
        hint=f"{advice}Installed: {_listed(known)}. Others come as extras or packages that register "
        f"in the entry point group {GROUP}.",
    )


def _listed(schemes: list[str]) -> str:
    return ", ".join(schemes) if schemes else "none; run `pip install -e .` in the checkout"
