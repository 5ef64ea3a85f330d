"""Every benchmark of this folder, one after another; figures also go to ``build/bench.json``."""

from __future__ import annotations

import importlib
import json
import pkgutil
from pathlib import Path


def main() -> None:
    figures: dict[str, float] = {}
    for module in sorted(
        pkgutil.iter_modules([str(Path(__file__).parent)]), key=lambda found: found.name
    ):
        if module.name.startswith("bench_"):
            print(module.name)
            found: dict[str, float] = importlib.import_module(f"bench.{module.name}").run()
            for name, value in found.items():
                print(f"  {name:32s} {value:10.4g}")
            figures |= found
    target = Path("build/bench.json")
    target.parent.mkdir(exist_ok=True)
    target.write_text(json.dumps(figures, indent=2) + "\n", encoding="utf-8")
    print(f"written to {target}")


if __name__ == "__main__":
    main()
