"""Table I of the paper, finish by finish, beside what was measured here."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from reliefscope.evaluation.fiducial import TableRow
from reliefscope.targets import SECTIONS

Z_STACK = "z-stack"
PAPER_SECTIONS = ("checker_tops", "planes", "hemispheres", "full")
"""Columns of the paper's table; its checkerboard stands at the tops."""


@dataclass(frozen=True, slots=True)
class PaperRow:
    """One fiducial of the paper: mean absolute errors in um."""

    version: str
    sections_um: Mapping[str, float]
    z_stack_um: float
    """Of the full fiducial, by the commercial microscope."""


def _row(version: str, errors_um: Sequence[float], z_stack_um: float) -> PaperRow:
    sections = dict(zip(PAPER_SECTIONS, errors_um, strict=True))
    return PaperRow(version, MappingProxyType(sections), z_stack_um)


PAPER_ROWS: Mapping[str, PaperRow] = MappingProxyType(
    {
        "dull": _row("O2 long", (1.9, 4.9, 7.1, 11.0), 17.2),
        "half": _row("LoS + O2", (2.2, 6.1, 5.6, 14.4), 6.0),
        "metallic": _row("O2 short", (2.1, 6.4, 9.1, 13.1), 10.0),
    }
)
"""The simulated finish that stands for each version: the paper calls the three "from dull to highly specular" and
orders their pictures so (Fig. 8); which is how dull it does not tell."""
FINISHES = tuple(PAPER_ROWS)


def table_markdown(rows: Mapping[str, Sequence[TableRow]], alignment: str = "offset") -> str:
    """The table as Markdown, in um.

    Parameters
    ----------
    rows:
        Rows of :func:`~reliefscope.evaluation.evaluate_fiducial` for each finish.
    alignment:
        ``raw``, ``offset`` or ``plane``: which of the errors.
    """
    names = [section for section in SECTIONS if any(_find(each, section) for each in rows.values())]
    lines = [
        "| finish | measured by | " + " | ".join(name.replace("_", " ") for name in names) + " |",
        "|---|---|" + "---:|" * len(names),
    ]
    columns: dict[str, list[list[float | None]]] = {}
    for finish, measured in rows.items():
        for method in dict.fromkeys(row["method"] for row in measured):
            own = [row for row in measured if row["method"] == method]
            values = [_error(_find(own, name), alignment) for name in names]
            columns.setdefault(method, []).append(values)
            lines.append(_line(finish, method, values))
        if finish in PAPER_ROWS:
            paper = PAPER_ROWS[finish]
            lines.append(
                _line(
                    finish,
                    f"published, {paper.version}",
                    [paper.sections_um.get(name) for name in names],
                )
            )
            lines.append(
                _line(
                    finish,
                    "published z-stack",
                    [paper.z_stack_um if name == "full" else None for name in names],
                )
            )
    if len(rows) > 1:
        for method, each in columns.items():
            if len(each) == len(rows):
                lines.append(_line("**mean**", method, _means(each)))
    return "\n".join(lines) + "\n"


def _means(rows: Sequence[Sequence[float | None]]) -> list[float | None]:
    return [
        None if None in column else float(np.mean([value for value in column if value is not None]))
        for column in zip(*rows, strict=True)
    ]


def _find(rows: Sequence[TableRow], section: str) -> TableRow | None:
    return next((row for row in rows if row["section"] == section), None)


def _error(row: TableRow | None, alignment: str) -> float | None:
    if row is None:
        return None
    errors = {
        "raw": row["mae_raw_um"],
        "offset": row["mae_offset_um"],
        "plane": row["mae_plane_um"],
    }
    return errors[alignment]


def _line(finish: str, method: str, values: Sequence[float | None]) -> str:
    cells = ["-" if value is None else f"{value:.1f}" for value in values]
    return f"| {finish} | {method} | " + " | ".join(cells) + " |"
