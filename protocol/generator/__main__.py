"""Command line of the generator: writes every generated file, or checks that they are up to date."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from protocol.generator.render import generate
from protocol.generator.schema import SchemaError, load

ROOT = Path(__file__).parents[2]


def main(arguments: list[str] | None = None, *, root: Path = ROOT) -> int:
    """Run; returns 0 if all is well, 1 if a file differs under ``--check``, 2 if protocol.yml is wrong."""
    parser = argparse.ArgumentParser(prog="python -m protocol.generator", description=__doc__)
    parser.add_argument(
        "--check", action="store_true", help="compare with what is there; write nothing"
    )
    check = parser.parse_args(arguments).check
    try:
        files = generate(load(ROOT / "protocol" / "protocol.yml"))
    except SchemaError as error:
        sys.stderr.write(f"protocol.yml: {error}\n")
        return 2
    changed = [path for path, text in files.items() if _read(root / path) != text]
    for path in changed:
        if check:
            sys.stderr.write(
                f"{path} differs from protocol.yml; run: python -m protocol.generator\n"
            )
        else:
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_text(files[path], encoding="utf-8", newline="\n")
            sys.stdout.write(f"wrote {path}\n")
    return int(check and bool(changed))


def _read(path: Path) -> str | None:
    return path.read_text(encoding="utf-8") if path.is_file() else None


if __name__ == "__main__":
    sys.exit(main())
