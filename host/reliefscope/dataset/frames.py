"""Reading and writing single frames of a run."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import zarr

from reliefscope.dataset.durable import DurableStore
from reliefscope.dataset.layout import Layout
from reliefscope.dataset.records import FrameKey, key_text
from reliefscope.errors import DatasetError
from reliefscope.units import RawImage


class FrameStore:
    """The frames of one run as arrays.  Thread-safe for frames that differ."""

    def __init__(self, folder: Path, layout: Layout, *, read_only: bool) -> None:
        self.folder = folder
        self.layout = layout
        store = DurableStore(folder, read_only=read_only)
        self._arrays: list[zarr.Array[Any]] = []
        for image in layout.images:
            path = layout.array_path(image.index)
            expected = (len(image.channels), *layout.spec.frame.shape)
            try:
                array = zarr.open_array(store, path=path, mode="r" if read_only else "r+")
            except Exception as error:  # whatever zarr makes of damaged metadata
                raise DatasetError(
                    f"{folder / path} is not a readable Zarr array: {error}.",
                    hint="Restore its zarr.json from a copy of the run.",
                ) from error
            if array.shape != expected or array.dtype != np.dtype(layout.dtype(image)):
                raise DatasetError(
                    f"{folder / path} holds {array.dtype} {array.shape}, but run.json tells of "
                    f"{layout.dtype(image)} {expected}.",
                    hint="run.json and the frames belong to different runs; restore both from one copy.",
                )
            self._arrays.append(array)

    def read(self, key: FrameKey) -> RawImage:
        """Pixels (H, W) of a frame.

        Raises
        ------
        DatasetError
            If its chunk is absent, truncated, or does not agree with its CRC-32C.
        """
        image, channel = self.layout.places[key]
        chunk = self.folder / self.layout.chunk_path(key)
        if not chunk.exists():  # Zarr would read an absent chunk as zeros
            raise DatasetError(
                f"Frame {key_text(key)} is missing: {chunk} does not exist.",
                hint=self.layout.spec.repair_hint(self.folder),
            )
        try:
            return np.asarray(self._arrays[image][channel])
        except Exception as error:  # codecs raise what they please on damaged bytes
            raise DatasetError(
                f"Frame {key_text(key)} is damaged: {chunk} cannot be decoded ({error}).",
                hint=self.layout.spec.repair_hint(self.folder),
            ) from error

    def write(self, key: FrameKey, raw: RawImage) -> None:
        """Store the pixels (H, W) of a frame; they are on the disk when this returns.  Raises OSError."""
        image, channel = self.layout.places[key]
        self._arrays[image][channel] = raw
