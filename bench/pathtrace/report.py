"""The comparison that docs/explanation/path-tracer.md shows: cases, tables and pictures."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path

import numpy as np
from bench.pathtrace import pictures
from bench.pathtrace.compare import Figures, Pair, compare, figures, plain_profile

from reliefscope_sim.scenes import load_scene

PAIRS = ((0, 0), (11, 9))
"""An aperture near the axis under an LED of 22.5 degrees, one far out under an LED of 45 degrees."""
WINDOW = (slice(150, 650), slice(300, 1000))
_PICTURE = (slice(20, 380), slice(60, 560))
_PIT_ROWS, _PIT_COLUMNS = slice(188, 200), slice(20, 300)


@dataclass(frozen=True)
class Case:
    """One scene of the report."""

    name: str
    scene: str
    options: dict[str, str | float]
    matt: bool = False
    """Whether gloss is taken out: in the simulated instrument it is a coat that dims what lies below."""


CASES = (
    Case("fiducial, dull", "fiducial", {"finish": "dull"}),
    Case("fiducial, metallic", "fiducial", {"finish": "metallic"}),
    Case("regolith, matt", "regolith", {}, matt=True),
)


def write(folder: Path, rays_per_pixel: int, cases: Sequence[Case] = CASES) -> None:
    """Compare every case; write ``tables.md``, ``figures.json`` and pictures into ``folder``."""
    folder.mkdir(parents=True, exist_ok=True)
    profile = plain_profile()
    tables = []
    kept: dict[str, object] = {}
    for case in cases:
        scene = load_scene(
            case.scene, 1, case.options, shape=profile.shape, pixel_um=profile.pixel_um
        )
        if case.matt:
            scene = replace(scene, specular=None, roughness=None)
        for pair in compare(scene, PAIRS, WINDOW, rays_per_pixel=rays_per_pixel):
            title = f"{case.name}, aperture {pair.view}, LED {pair.led}"
            rows = {seen: figures(pair, seen=seen) for seen in (False, True)}
            tables.append(table(title, pair, rows))
            kept[title] = {
                "noise": pair.noise,
                "displacement_px": pair.displacement_px,
                "rays": [asdict(row) for row in rows[False]],
                "diffraction": [asdict(row) for row in rows[True]],
            }
            name = f"{case.name.replace(', ', '-')}-{pair.view}-{pair.led}"
            pictures.side_by_side(pair, _PICTURE, folder / f"path-tracer-{name}.jpg")
            if case.scene == "fiducial":
                target = folder / f"path-tracer-{name}-pits.png"
                pictures.profile(pair, _PIT_ROWS, _PIT_COLUMNS, profile.pixel_um, target)
    (folder / "tables.md").write_text("\n".join(tables), encoding="utf-8")
    (folder / "figures.json").write_text(json.dumps(kept, indent=1) + "\n", encoding="utf-8")


def table(title: str, pair: Pair, rows: dict[bool, list[Figures]]) -> str:
    """One pair as a Markdown table: rays alone, and with diffraction."""
    x, y = pair.displacement_px
    lines = [
        f"**{title}**; noise of the tracer {pair.noise / float(np.mean(pair.tracer)):.1%} of the "
        f"mean, displacement ({x:+.3f}, {y:+.3f}) px",
        "",
        "| Where | Part | Radiance | Ratio | RMS | Median | Ratio, diffr. | RMS, diffr. |",
        "|---|---|---|---|---|---|---|---|",
    ]
    lines += [
        f"| {plain.region} | {plain.share:.0%} | {plain.radiance:.4f} | {plain.ratio:.3f} "
        f"| {plain.rms:.1%} | {plain.median:.1%} | {seen.ratio:.3f} | {seen.rms:.1%} |"
        for plain, seen in zip(rows[False], rows[True], strict=True)
    ]
    return "\n".join([*lines, ""])
