"""Prepares a PlatformIO core folder that needs no registry: tools/platformio_core.py FOLDER.

Run it with a Python that has `platformio` and `scons`, then set PLATFORMIO_CORE_DIR to the folder. PlatformIO asks its
registry for its build tool and for the platform `native`; the first is the SCons of the Python package index, the
second is a builder for the system's compiler, written here. Both carry the owner mark that PlatformIO checks.
"""

import json
import re
import sys
from pathlib import Path

from platformio.dependencies import get_core_dependencies

NATIVE = '''"""Builds a program with the system's compiler."""

from SCons.Script import AlwaysBuild, Default, DefaultEnvironment

env = DefaultEnvironment()
flags = {name: env.get(name, []) for name in ("CFLAGS", "CXXFLAGS")}
for name in ("CC", "CXX"):
    if name in env:
        del env[name]
env.Tool("gcc")
env.Tool("g++")
env.Append(**flags)
# The sanitizers of the compiler are wanted by the linker, too.
env.Append(LINKFLAGS=[flag for flag in env.get("CCFLAGS", []) if flag.startswith("-fsanitize")])
program = env.BuildProgram()
AlwaysBuild(env.Alias("exec", program, env.VerboseAction("$SOURCE", "Running $SOURCE")))
Default([program])
'''


def write_package(
    folder: Path, kind: str, manifest_name: str, manifest: dict[str, object], files: dict[str, str]
) -> None:
    """A package as PlatformIO would have installed it."""
    spec = {"owner": "platformio", "id": None, "requirements": None, "uri": None}
    mark = {"type": kind, "name": manifest["name"], "version": manifest["version"]}
    mark["spec"] = spec | {"name": manifest["name"]}
    folder.mkdir(parents=True, exist_ok=True)
    (folder / manifest_name).write_text(json.dumps(manifest, indent=1))
    (folder / ".piopm").write_text(json.dumps(mark))
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def main() -> int:
    """Write the folder named on the command line; returns the exit code."""
    if len(sys.argv) != 2:
        sys.stderr.write("usage: platformio_core.py FOLDER\n")
        return 2
    core = Path(sys.argv[1])
    wanted = re.sub(r"[^\d.]", "", get_core_dependencies()["tool-scons"])
    write_package(
        core / "packages" / "tool-scons",
        "tool",
        "package.json",
        {"name": "tool-scons", "version": wanted, "description": "SCons of the package index"},
        {"scons.py": "import sys\n\nimport SCons.Script\n\nsys.exit(SCons.Script.main())\n"},
    )
    write_package(
        core / "platforms" / "native",
        "platform",
        "platform.json",
        {
            "name": "native",
            "title": "Native",
            "description": "the system's compiler",
            "version": "1.2.1",
            "engines": {"platformio": "^6"},
        },
        {"builder/main.py": NATIVE},
    )
    return 0


if __name__ == "__main__":
    sys.exit(main())
