"""A firmware image for the Teensy 3.2, and everything that can be known of it before a board is touched."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

import bincopy

import reliefscope
from reliefscope.flash.errors import ImageError
from reliefscope.flash.identity import PRODUCT, FirmwareIdentity, find_identities
from reliefscope.protocol.messages import PROTOCOL_VERSION, SCHEMA_HASH

BOARD = "teensy31"
FLASH_BYTES = 256 * 1024
"""Program flash of the MK20DX256."""
BLOCK_BYTES = 1024
"""What the bootloader writes at once."""
SECURITY_AT = 0x40C
UNSECURED = 0xDE
"""Byte FSEC of the flash configuration field: not secured, may be erased.  Erased flash (0xFF) reads as secured."""
RAM = range(0x1FFF8000, 0x20008000 + 1)
"""Where the stack may start: it grows downward, so the address after the last byte is the usual one."""
ERASED = 0xFF
IMAGE_FOLDER = Path("build", "firmware", BOARD)
"""Where ``make firmware`` leaves the images of this board."""


@dataclass(frozen=True, slots=True)
class FirmwareImage:
    """An image that a Teensy 3.2 could run; ``data`` starts at address 0 and fills whole blocks.

    ``identity`` is None for a program that is not ours.
    """

    path: Path
    data: bytes = field(repr=False)
    identity: FirmwareIdentity | None

    @classmethod
    def load(cls, path: Path) -> FirmwareImage:
        """Read an Intel HEX file and check what holds for any program of this chip.

        Raises
        ------
        ImageError
            If it is not intact, does not fit, or would lock the chip.
        """
        data = _read(path)
        if data[SECURITY_AT] != UNSECURED:
            raise ImageError(
                f"{path} could lock the chip: byte 0x{SECURITY_AT:X} is 0x{data[SECURITY_AT]:02X}, "
                f"not 0x{UNSECURED:02X}.",
                hint=f"It was built for another chip or with another linker script. {_HOW_TO_GET_ONE}",
            )
        identities = set(find_identities(data))
        if len(identities) > 1:
            names = ", ".join(sorted(f"{i.product} {i.version} for {i.board}" for i in identities))
            raise ImageError(
                f"{path} says that it is several things: {names}.", hint=_HOW_TO_GET_ONE
            )
        return cls(path, data, identities.pop() if identities else None)

    @property
    def blocks(self) -> list[tuple[int, bytes]]:
        """(address, 1,024 bytes) in the order of writing: block 0 always, since it erases the chip; no blank ones."""
        found = []
        for address in range(0, len(self.data), BLOCK_BYTES):
            block = self.data[address : address + BLOCK_BYTES]
            if address == 0 or block.count(ERASED) != BLOCK_BYTES:
                found.append((address, block))
        return found

    @property
    def title(self) -> str:
        """The image in a few words."""
        if self.identity is None:
            return f"{self.path.name} (says nothing about itself)"
        i = self.identity
        return f"{i.product} {i.version} ({i.git_hash}) for {i.board}"

    def doubts(self) -> list[str]:
        """Reasons not to write this image, for which ``force`` may be given; none for the right one."""
        found = []
        stack, start = (int.from_bytes(self.data[at : at + 4], "little") for at in (0, 4))
        if stack not in RAM or stack % 4:
            found.append(f"its stack starts at 0x{stack:08X}, where a Teensy 3.2 has no memory")
        if not start % 2 or start >= len(self.data):
            found.append(f"it starts at 0x{start:08X}, which is not code of the image")
        identity = self.identity
        if identity is None:
            return [*found, "it has no identity block, so it is not firmware of reliefscope"]
        if identity.product != PRODUCT:
            found.append(f"it is firmware of {identity.product!r}, not of {PRODUCT}")
        if identity.board != BOARD:
            found.append(f"it is for the board {identity.board!r}, not for {BOARD}")
        if identity.schema_hash != SCHEMA_HASH:
            found.append(
                f"it speaks another protocol (version {identity.protocol_version}, schema "
                f"{identity.schema_hash.hex()[:12]}) than this program (version {PROTOCOL_VERSION}, schema "
                f"{SCHEMA_HASH.hex()[:12]})"
            )
        return found

    def check(self, *, force: bool = False) -> list[str]:
        """Refuse an image with doubts; with ``force`` return them instead.

        Raises
        ------
        ImageError
            If there are doubts and no ``force``.
        """
        doubts = self.doubts()
        if doubts and not force:
            raise ImageError(
                f"{self.path} was refused: {'; '.join(doubts)}.",
                hint=f"{_HOW_TO_GET_ONE} To write it all the same: reliefscope flash {self.path} --force",
            )
        return doubts


_HOW_TO_GET_ONE = "The right image is built in a checkout of reliefscope by: make firmware"


def _read(path: Path) -> bytes:
    try:
        text = path.read_text(encoding="ascii")
    except UnicodeDecodeError as error:
        raise ImageError(
            f"{path} is not an Intel HEX file: byte {error.start} is not text.",
            hint="Give the .hex file, not the .elf or .bin beside it.",
        ) from error
    except OSError as error:
        raise ImageError(
            f"{path} cannot be read: {error.strerror}.", hint=_HOW_TO_GET_ONE
        ) from error
    content = bincopy.BinFile()
    try:
        content.add_ihex(text)
    except (bincopy.Error, ValueError) as error:
        raise ImageError(
            f"{path} is not an intact Intel HEX file: {error}.",
            hint="Copy or build it again.",
        ) from error
    records = text.split()
    if not records or records[-1].upper() != ":00000001FF":
        raise ImageError(
            f"{path} has no end: the last record is missing.",
            hint="The file was cut off; copy or build it again.",
        )
    end = content.maximum_address or 0
    if end > FLASH_BYTES:
        raise ImageError(
            f"{path} reaches to address 0x{end:X}; the flash of this board ends at 0x{FLASH_BYTES:X}.",
            hint=f"It was built for another chip. {_HOW_TO_GET_ONE}",
        )
    if end <= SECURITY_AT:
        raise ImageError(
            f"{path} holds {end} bytes, too few for a program of this chip.", hint=_HOW_TO_GET_ONE
        )
    blocks = -(-end // BLOCK_BYTES)
    data = bytearray([ERASED]) * (blocks * BLOCK_BYTES)
    for segment in content.segments:
        data[segment.address : segment.address + len(segment.data)] = segment.data
    return bytes(data)


def newest_image(roots: Iterable[Path] | None = None) -> Path:
    """The image that ``make firmware`` built last, below the working folder or the checkout in use.

    Raises
    ------
    ImageError
        If there is none; says how to get one.
    """
    if roots is None:
        roots = (Path.cwd(), Path(reliefscope.__file__).resolve().parents[2])
    found = [path for root in roots for path in (root / IMAGE_FOLDER).rglob("*.hex")]
    if not found:
        raise ImageError(
            "There is no firmware image here.",
            hint=f"Build one in a checkout of reliefscope: make firmware (leaves it in {IMAGE_FOLDER}); or name a "
            "file: reliefscope flash firmware.hex",
        )
    return max(found, key=lambda path: path.stat().st_mtime)
