"""The block as compilers write it, from firmware/core/identity.hpp, read back by the host."""

import shutil
import subprocess

import pytest
from tests.support import REPOSITORY

from reliefscope.flash import FirmwareImage, find_identities
from reliefscope.protocol import messages as m

FIRMWARE = REPOSITORY / "firmware"
DEFINES = [
    "-std=c++17",
    "-Wall",
    "-Wextra",
    "-Werror",
    f"-I{FIRMWARE}",
    '-DRELIEFSCOPE_GIT_HASH="feed1234"',
]
BLOCK = """
#include "core/identity.hpp"
namespace reliefscope {
extern const Identity kIdentity;
constexpr Identity kIdentity = make_identity("teensy31");
static_assert(kIdentity.crc != 0, "made by the compiler, not at start-up");
}
"""
# The least that a Teensy 3.2 would start: vectors, flash configuration field, and code that uses the block.
BARE_PROGRAM = (
    BLOCK
    + """
extern "C" {
extern const char* volatile board;
const char* volatile board;
[[noreturn]] void start() {
  board = reliefscope::kIdentity.board;
  for (;;) {
  }
}
[[gnu::section(".vectors"), gnu::used]] void (*const vectors[])() = {
    reinterpret_cast<void (*)()>(0x20008000), start};
[[gnu::section(".config"), gnu::used]] const unsigned char config[16] = {
    255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 0xDE, 255, 255, 255};
}
"""
)
LINKER_SCRIPT = """
ENTRY(start)
SECTIONS {
  .vectors 0 : { KEEP(*(.vectors)) }
  .config 0x400 : { KEEP(*(.config)) }
  .text 0x410 : { *(.text*) *(.rodata*) }
  .bss 0x1FFF8000 (NOLOAD) : { *(.bss*) *(COMMON) }
  /DISCARD/ : { *(.ARM.*) }
}
"""


def compiler(*names):
    found = next(filter(None, map(shutil.which, names)), None)
    if found is None:
        pytest.skip(f"left out: none of {', '.join(names)} is installed")
    return found


def check(identity):
    assert (identity.product, identity.board) == ("reliefscope", "teensy31")
    assert (identity.git_hash, identity.protocol_version) == ("feed1234", m.PROTOCOL_VERSION)
    assert identity.schema_hash == m.SCHEMA_HASH
    version = (FIRMWARE / "core/version.hpp").read_text()
    assert f'"{identity.version}"' in version


def test_block_of_the_hosts_compiler(tmp_path):
    source, made = tmp_path / "block.cpp", tmp_path / "block.o"
    source.write_text(BLOCK)
    command = [compiler("c++", "g++", "clang++"), *DEFINES, "-c", str(source), "-o", str(made)]
    subprocess.run(command, check=True)
    (identity,) = find_identities(made.read_bytes())
    check(identity)


def test_block_in_an_arm_image(tmp_path):
    gcc, objcopy = compiler("arm-none-eabi-g++"), compiler("arm-none-eabi-objcopy")
    source, script = tmp_path / "bare.cpp", tmp_path / "bare.ld"
    elf, hex_file = tmp_path / "bare.elf", tmp_path / "bare.hex"
    source.write_text(BARE_PROGRAM)
    script.write_text(LINKER_SCRIPT)
    flags = ["-mcpu=cortex-m4", "-mthumb", "-Os", "-ffunction-sections", "-fdata-sections"]
    flags += ["-nostdlib", "-nostartfiles", "-Wl,--gc-sections", f"-T{script}"]
    subprocess.run([gcc, *DEFINES, *flags, str(source), "-o", str(elf)], check=True)
    subprocess.run([objcopy, "-O", "ihex", str(elf), str(hex_file)], check=True)
    image = FirmwareImage.load(hex_file)
    check(image.identity)
    assert image.check() == []
