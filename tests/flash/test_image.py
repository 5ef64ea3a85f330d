"""Images: what is read from them, and which are refused."""

import struct
import zlib

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.flash.boards import identity_block, intel_hex, program, write_image

from reliefscope.errors import ExitCode
from reliefscope.flash import FirmwareImage, ImageError, find_identities, newest_image
from reliefscope.protocol import messages as m


def image(folder, **options):
    return FirmwareImage.load(write_image(folder, **options))


def other_image(folder, parts):
    path = folder / "other.hex"
    path.write_text(intel_hex(parts))
    return path


def test_right_image(tmp_path):
    loaded = image(tmp_path, version="1.2.3", git_hash="cafe")
    i = loaded.identity
    assert (i.product, i.board, i.version, i.git_hash) == (
        "reliefscope",
        "teensy31",
        "1.2.3",
        "cafe",
    )
    assert (i.protocol_version, i.schema_hash) == (m.PROTOCOL_VERSION, m.SCHEMA_HASH)
    assert loaded.check() == []
    assert loaded.title == "reliefscope 1.2.3 (cafe) for teensy31"


def test_blocks_are_whole_in_order_and_never_blank(tmp_path):
    parts = program(identity_block())
    loaded = image(tmp_path)
    addresses = [address for address, _ in loaded.blocks]
    # vectors, configuration field, 12 blocks of code from 0x1000, 1,500 bytes at 0x10000
    assert addresses == [0, 0x400, *range(0x1000, 0x4000, 1024), 0x10000, 0x10400]
    assert all(len(block) == 1024 for _, block in loaded.blocks)
    flash = bytearray(b"\xff" * (1 << 18))
    for address, block in loaded.blocks:
        flash[address : address + 1024] = block
    for address, data in parts.items():
        assert flash[address : address + len(data)] == data
    assert flash.count(0xFF, 0x10000 + 1500) == (1 << 18) - 0x10000 - 1500


def test_block_0_is_written_even_if_blank(tmp_path):
    parts = program(identity_block())
    del parts[0]
    loaded = FirmwareImage.load(other_image(tmp_path, parts))
    assert loaded.blocks[0] == (0, b"\xff" * 1024)
    assert len(loaded.doubts()) == 2


@pytest.mark.parametrize(
    ("options", "reason"),
    [
        ({"board": "qemu_m4"}, "for the board 'qemu_m4', not for teensy31"),
        ({"product": "blinky"}, "firmware of 'blinky'"),
        (
            {"schema": bytes(16), "protocol": 9},
            r"another protocol \(version 9, schema 000000000000\)",
        ),
    ],
)
def test_other_firmware_is_refused_unless_forced(tmp_path, options, reason):
    loaded = image(tmp_path, **options)
    with pytest.raises(ImageError, match=reason) as caught:
        loaded.check()
    assert caught.value.exit_code is ExitCode.INVALID_INPUT
    assert "--force" in caught.value.hint
    assert len(loaded.check(force=True)) == 1


@pytest.mark.parametrize(
    ("options", "reason"),
    [
        ({}, "no identity block"),
        ({"stack": 0x20002000 - 0x8000}, None),
        ({"stack": 0x20030000}, "stack starts at 0x20030000"),
        ({"start": 0x1000}, "starts at 0x00001000"),
        ({"start": 0x30001}, "starts at 0x00030001"),
    ],
)
def test_programs_of_others_are_refused_unless_forced(tmp_path, options, reason):
    loaded = FirmwareImage.load(other_image(tmp_path, program(**options)))
    with pytest.raises(ImageError, match=reason):
        loaded.check()
    assert loaded.check(force=True)


def test_identity_with_one_wrong_bit_is_none(tmp_path):
    block = bytearray(identity_block())
    block[44] ^= 1
    assert FirmwareImage.load(other_image(tmp_path, program(bytes(block)))).identity is None


def test_later_layouts_only_append():
    (found,) = find_identities(b"xx" + identity_block(extra=b"whatever") + b"yy")
    assert found.version == "0.1.0"


def test_two_identities_are_one_too_many(tmp_path):
    parts = program(identity_block()) | {0x20000: identity_block(version="9.9.9")}
    with pytest.raises(ImageError, match=r"several things: reliefscope 0\.1\.0.*9\.9\.9"):
        FirmwareImage.load(other_image(tmp_path, parts))
    parts[0x20000] = identity_block()
    assert FirmwareImage.load(other_image(tmp_path, parts)).identity.version == "0.1.0"


@given(st.binary(max_size=300), st.integers(0, 100), st.binary(max_size=50))
def test_any_bytes_can_be_searched(before, cut, after):
    whole = identity_block()
    assert len(list(find_identities(before + whole + after))) >= 1
    list(find_identities(before + whole[:cut] + after))
    size = struct.pack("<8sHH", whole[:8], 1, 0xFFFF)
    assert not list(find_identities(before.replace(b"\x89", b"") + size))


def test_image_that_could_lock_the_chip_cannot_be_forced(tmp_path):
    for parts in (program(identity_block(), fsec=0xFF), program(identity_block(), fsec=0x64)):
        with pytest.raises(ImageError, match="could lock the chip"):
            FirmwareImage.load(other_image(tmp_path, parts))


def test_too_large_and_too_small(tmp_path):
    with pytest.raises(ImageError, match=r"reaches to address 0x40001"):
        FirmwareImage.load(other_image(tmp_path, program() | {0x40000: b"\0"}))
    with pytest.raises(ImageError, match=r"holds 256 bytes, too few"):
        FirmwareImage.load(other_image(tmp_path, {0: bytes(256)}))


def test_damaged_files(tmp_path):
    path = write_image(tmp_path)
    text = path.read_text()
    lines = text.splitlines()
    damaged = {
        "expected crc": text.replace("77", "78", 1),
        "the last record is missing": "\n".join(lines[:-1]),
        "not an intact Intel HEX file": "\n".join([lines[0][:-4], *lines[1:]]),
        "has no end": "",
        "must be adjacent": "\n".join([*lines[:-1], lines[5], lines[-1]]),
    }
    for reason, content in damaged.items():
        path.write_text(content)
        with pytest.raises(ImageError, match=reason):
            FirmwareImage.load(path)
    path.write_bytes(b"\x7fELF\xff")
    with pytest.raises(ImageError, match="byte 4 is not text") as caught:
        FirmwareImage.load(path)
    assert ".elf" in caught.value.hint
    with pytest.raises(ImageError, match="cannot be read: No such file"):
        FirmwareImage.load(tmp_path / "absent.hex")


def test_newest_image_that_was_built(tmp_path):
    import os

    with pytest.raises(ImageError) as caught:
        newest_image([tmp_path])
    assert "make firmware" in caught.value.hint
    for age, name in enumerate(("release/firmware.hex", "debug/firmware.hex", "firmware.hex")):
        path = tmp_path / "build/firmware/teensy31" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.touch()
        os.utime(path, (1e9 - age, 1e9 - age))
    other = tmp_path / "build/firmware/qemu_m4/firmware.hex"
    other.parent.mkdir()
    other.touch()
    assert newest_image([tmp_path / "absent", tmp_path]).parent.name == "release"


def test_crc_of_the_block_is_zlibs():
    block = identity_block()
    assert int.from_bytes(block[96:], "little") == zlib.crc32(block[:96])
