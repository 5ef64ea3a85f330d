"""How flashing can end badly; the class says in what state the board is left."""

from __future__ import annotations

from reliefscope.errors import DeviceError, InvalidInputError


class ImageError(InvalidInputError):
    """The image was refused; no board was touched."""


class FlashError(DeviceError):
    """No board was found, or it could not be made ready; its old firmware is untouched."""


class UsbAccessError(FlashError):
    """The operating system does not let this user, or this program, talk to the board."""


class HalfWrittenError(FlashError):
    """Writing ended early: the old firmware is gone, the bootloader is not.  Flashing again mends it."""


class NotConfirmedError(FlashError):
    """The image was written, but the board does not say that this is what it runs."""
