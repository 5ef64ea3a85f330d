"""Photographs as counts."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np

from reliefscope.errors import InvalidInputError
from reliefscope.units import RawImage


def read_picture(path: Path, hint: str) -> tuple[RawImage, bytes]:
    """Counts (H, W), or (H, W, 3) with red first, of 8 or 16 bits, and the content of the file.

    ``hint`` tells what to check where the file cannot be opened.

    Raises
    ------
    InvalidInputError
        No such file, no picture, a truncated one, or one with other channels or depths.
    """
    try:
        data = path.read_bytes()
    except OSError as error:
        raise InvalidInputError(
            f"{path} cannot be read: {error.strerror or error}.", hint=hint
        ) from error
    # Decoded from memory: the library does not open paths with letters beyond ASCII everywhere.
    flags = cv2.IMREAD_UNCHANGED
    decoded = cv2.imdecode(np.frombuffer(data, dtype=np.uint8), flags) if data else None
    if decoded is None:
        raise InvalidInputError(
            f"{path} is not a picture that can be read, or it is truncated.",
            hint="Give PNG, TIFF or JPEG.",
        )
    if decoded.dtype == np.uint8:
        pixels: RawImage = decoded.astype(np.uint8, copy=False)
    elif decoded.dtype == np.uint16:
        pixels = decoded.astype(np.uint16, copy=False)
    else:
        raise InvalidInputError(
            f"{path} holds {decoded.dtype} pixels.", hint="Give 8 or 16 bits per channel."
        )
    if pixels.ndim == 3:
        if pixels.shape[2] != 3:
            raise InvalidInputError(
                f"{path} has {pixels.shape[2]} channels.",
                hint="Save it without transparency: grey, or red, green and blue.",
            )
        pixels = pixels[:, :, ::-1].copy()
    return pixels, data
