"""A run on disk: OME-Zarr frames, ``run.json`` and an append-only journal.  Knows nothing of hardware."""

from reliefscope.dataset.importer import import_photographs
from reliefscope.dataset.records import Confirmed, FrameRecord, SourceFile
from reliefscope.dataset.run import IncompleteRunWarning, Run
from reliefscope.dataset.spec import (
    AcquiredSpec,
    FrameFormat,
    ImportedLight,
    ImportedSpec,
    ImportedView,
    RunSpec,
    Session,
)
from reliefscope.dataset.verify import VerifyReport
from reliefscope.dataset.writer import RunWriter

__all__ = [
    "AcquiredSpec",
    "Confirmed",
    "FrameFormat",
    "FrameRecord",
    "ImportedLight",
    "ImportedSpec",
    "ImportedView",
    "IncompleteRunWarning",
    "Run",
    "RunSpec",
    "RunWriter",
    "Session",
    "SourceFile",
    "VerifyReport",
    "import_photographs",
]
