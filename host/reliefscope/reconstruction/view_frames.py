"""Frames view by view, without what was saturated, the next view being read meanwhile."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from reliefscope.reconstruction.inputs import Inputs
from reliefscope.reconstruction.saturation import blank_saturated
from reliefscope.units import FloatImage


def unsaturated_views(inputs: Inputs) -> Iterator[tuple[int, FloatImage]]:
    """Views in order with their frames (L, H, W); saturated pixels are NaN.

    The frames are overwritten two views later.
    """
    run = inputs.frames
    frames = run.stack()
    buffers = [np.empty((inputs.light_count, *run.shape), np.float32) for _ in range(2)]

    def read(view: int) -> FloatImage:
        images = buffers[view % 2]
        for target in images:
            target[...] = next(frames)[2]
        blank_saturated(images, run, view)
        return images

    with ThreadPoolExecutor(1, thread_name_prefix="read-view") as pool:
        ahead = pool.submit(read, 0)
        for view in range(inputs.view_count):
            images = ahead.result()
            if view + 1 < inputs.view_count:
                ahead = pool.submit(read, view + 1)
            yield view, images
