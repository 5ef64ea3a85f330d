"""A whole image shifted with the interpolation of matching, for comparison."""

import numpy as np

from reliefscope.reconstruction.shifts import TAPS, sample_block, split_shift, valid_span
from reliefscope.units import FloatImage


def shift_image(image: FloatImage, row_px: float, col_px: float) -> FloatImage:
    """``image`` (H, W) sampled at ``(row + row_px, col + col_px)``; NaN where a sample is not valid."""
    height, width = image.shape
    rows, row_weights = split_shift(np.array([row_px]))
    cols, col_weights = split_shift(np.array([col_px]))
    row_first, row_stop = (int(v[0]) for v in valid_span(np.array([row_px]), height, 0))
    col_first, col_stop = (int(v[0]) for v in valid_span(np.array([col_px]), width, 0))
    out = np.full((height, width), np.nan, dtype=np.float32)
    block = out[row_first:row_stop, col_first:col_stop]
    if block.size:
        padded = np.pad(np.asarray(image, dtype=np.float32), TAPS // 2, mode="edge")
        sampled = np.empty(block.shape, dtype=np.float32)
        sample_block(
            padded,
            row_first + int(rows[0]) + TAPS // 2,
            col_first + int(cols[0]) + TAPS // 2,
            row_weights[0],
            col_weights[0],
            np.float32(0.0),
            np.empty(block.shape[1] + TAPS, dtype=np.float32),
            sampled,
        )
        block[...] = sampled
    return out
