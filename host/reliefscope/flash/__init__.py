"""Firmware onto the board: images that say what they are, boards on USB, the bootloader.

image = FirmwareImage.load(newest_image())
flasher = Flasher()
report = flasher.flash(image, flasher.select())
"""

from reliefscope.flash.boards import Board
from reliefscope.flash.errors import (
    FlashError,
    HalfWrittenError,
    ImageError,
    NotConfirmedError,
    UsbAccessError,
)
from reliefscope.flash.flasher import BUTTON_S, Flasher, FlashReport
from reliefscope.flash.identity import FirmwareIdentity, find_identities
from reliefscope.flash.image import FirmwareImage, newest_image
from reliefscope.flash.surroundings import Surroundings

__all__ = [
    "BUTTON_S",
    "Board",
    "FirmwareIdentity",
    "FirmwareImage",
    "FlashError",
    "FlashReport",
    "Flasher",
    "HalfWrittenError",
    "ImageError",
    "NotConfirmedError",
    "Surroundings",
    "UsbAccessError",
    "find_identities",
    "newest_image",
]
