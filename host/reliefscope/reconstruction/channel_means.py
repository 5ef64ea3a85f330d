"""One pass over the frames: means over groups of lights, for matching."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from reliefscope.reconstruction.inputs import Inputs, refuse_undefined
from reliefscope.reconstruction.stage_clock import StageClock
from reliefscope.units import FloatImage


@dataclass(frozen=True)
class ChannelMeans:
    """What one pass over the frames leaves.

    Attributes
    ----------
    images:
        (C, K, H, W) mean of each view over each group of lights, of equal gain.
    shares:
        (C,) share of the lights in each group.
    gains:
        (K,) factors that brought the views to equal mean.
    """

    images: FloatImage
    shares: NDArray[np.float32]
    gains: NDArray[np.float64]

    def micrograph(self, view: int) -> FloatImage:
        """Mean over all lights (H, W) of one view."""
        mean: FloatImage = np.tensordot(self.shares, self.images[:, view], axes=1)
        return mean


def read_channel_means(inputs: Inputs, groups: list[list[int]], clock: StageClock) -> ChannelMeans:
    """Read every frame and add it up.

    Parameters
    ----------
    inputs:
        The run.
    groups:
        Lights of each channel; every light belongs to one.
    clock:
        Progress (stage ``read frames``, per frame), cancellation and time.

    Raises
    ------
    InvalidInputError
        A view is black or holds undefined values.
    """
    frames, views, lights = inputs.frames, inputs.view_count, inputs.light_count
    channel = {light: c for c, group in enumerate(groups) for light in group}
    means = np.zeros((len(groups), views, *frames.shape), np.float32)
    with clock.timed("read frames"), clock.job.stage("read frames", views * lights) as stage:
        for view, light, image in frames.stack():
            means[channel[light], view] += image
            stage.advance()
        sums = np.array([[cv2.mean(image)[0] for image in images] for images in means])
        levels = sums.sum(axis=0) / lights
        for view, level in enumerate(levels):
            refuse_undefined(float(level), f"view {frames.view_names[view]}")
        gains = levels.mean() / levels
        for images, group in zip(means, groups, strict=True):
            for image, gain in zip(images, gains, strict=True):
                image *= np.float32(gain / len(group))
    shares = np.array([len(group) for group in groups], np.float32) / np.float32(lights)
    return ChannelMeans(means, shares, gains)
