"""Pixels whose count was at full scale: what they really received is not known."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from reliefscope.units import FloatImage


class SaturatingFrames(Protocol):
    """What is asked; :class:`reliefscope.dataset.Run` has it."""

    def saturation_level(self, view: int, light: int) -> FloatImage | float:
        """Linear luminance (H, W), or one for all pixels, from which a pixel counts as saturated."""


def blank_saturated(images: FloatImage, run: SaturatingFrames, view: int) -> int:
    """Set saturated pixels of a view's frames (L, H, W) to NaN in place; returns how many there were."""
    found = 0
    for light, image in enumerate(images):
        level = np.asarray(run.saturation_level(view, light), dtype=np.float32)
        if image.max() < level.min():
            continue
        saturated = image >= level
        found += int(np.count_nonzero(saturated))
        image[saturated] = np.nan
    return found
