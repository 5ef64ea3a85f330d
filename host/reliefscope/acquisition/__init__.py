"""Acquisition: a plan becomes tables that the device steps alone; its events and the frames become a run."""

from reliefscope.acquisition.acquire import acquire, resume
from reliefscope.acquisition.resuming import resumable

__all__ = ["acquire", "resumable", "resume"]
