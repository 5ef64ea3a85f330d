"""The firmware's builds are those of tests/firmware."""

from tests.firmware.conftest import firmware_build, library

__all__ = ["firmware_build", "library"]
