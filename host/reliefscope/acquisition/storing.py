"""Disk work beside the exposures: one thread stores images while the next ones are taken."""

from __future__ import annotations

import logging
import queue
import threading
from types import TracebackType

from reliefscope.dataset import FrameRecord, RunWriter
from reliefscope.errors import DatasetError, ReliefscopeError
from reliefscope.units import RawImage

log = logging.getLogger(__name__)

QUEUE_IMAGES = 8
STALL_S = 60.0


class DiskThread:
    """Bounded queue in front of a :class:`RunWriter`; a context manager that stores all it was given on exit.

    An error of the disk surfaces at the next :meth:`put` or at the end; images that were acknowledged before
    stay valid, and none is acknowledged after it.
    """

    def __init__(self, writer: RunWriter) -> None:
        self._writer = writer
        self._queue: queue.Queue[tuple[FrameRecord, RawImage] | None] = queue.Queue(QUEUE_IMAGES)
        self._error: Exception | None = None
        self._thread = threading.Thread(target=self._work, name="store-run", daemon=True)

    def put(self, record: FrameRecord, raw: RawImage) -> None:
        """Hand over an image; waits while the disk is behind.

        Raises
        ------
        DatasetError
            If the disk failed, or stored nothing for a minute.
        """
        if self._error is not None:
            raise self._error
        self._give((record, raw))

    def __enter__(self) -> DiskThread:
        self._thread.start()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        try:
            self._give(None)
            self._thread.join(STALL_S)
            if self._thread.is_alive():
                raise self._stalled()
            if self._error is not None:
                raise self._error
        except ReliefscopeError as found:
            if error is None or error is found:
                raise
            log.warning("while storing the last images: %s", found.message)

    def _give(self, item: tuple[FrameRecord, RawImage] | None) -> None:
        try:
            self._queue.put(item, timeout=STALL_S)
        except queue.Full:
            raise self._stalled() from None

    def _stalled(self) -> DatasetError:
        return DatasetError(
            f"The disk stalled: no image was stored for {STALL_S:g} s.",
            hint="Check the disk; then go on with "
            f"{self._writer.spec.resume_command(self._writer.folder)}.",
        )

    def _work(self) -> None:
        while (item := self._queue.get()) is not None:
            if self._error is None:
                try:
                    self._writer.put(*item)
                except Exception as error:  # noqa: BLE001 - handed to the thread that acquires
                    self._error = error
