"""Builds a program for the emulator with the arm-none-eabi tools on the path."""

from SCons.Script import AlwaysBuild, Default, DefaultEnvironment

env = DefaultEnvironment()
PREFIX = "arm-none-eabi-"
CPU = ["-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=soft"]
BOARD = "$PROJECT_DIR/firmware/boards/qemu_m4"

env.Replace(
    CC=PREFIX + "gcc",
    CXX=PREFIX + "g++",
    AR=PREFIX + "gcc-ar",
    AS=PREFIX + "as",
    RANLIB=PREFIX + "gcc-ranlib",
    OBJCOPY=PREFIX + "objcopy",
    SIZETOOL=PREFIX + "size",
    SIZEPRINTCMD="$SIZETOOL -B -d $SOURCES",
    SIZECHECKCMD="$SIZETOOL -A -d $SOURCES",
    PROGSUFFIX=".elf",
)
env.Append(
    CCFLAGS=[*CPU, "-Os", "-ffunction-sections", "-fdata-sections"],
    CXXFLAGS=["-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics"],
    LINKFLAGS=[
        *CPU,
        "--specs=nano.specs",
        "--specs=rdimon.specs",
        "-Wl,--gc-sections",
        "-T",
        BOARD + "/tests.ld",
    ],
)
env.BuildSources("$BUILD_DIR/board", BOARD, "+<tests_vectors.cpp>")
program = env.BuildProgram()
AlwaysBuild(env.Alias("size", program, env.VerboseAction("$SIZEPRINTCMD", "Size of $SOURCE")))
Default([program])
