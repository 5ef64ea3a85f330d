"""Results for people, drawn with rich."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from rich.console import Console
from rich.markup import escape
from rich.table import Table
from rich.text import Text

from reliefscope.cli.progress import duration, label

if TYPE_CHECKING:
    from reliefscope.doctor import Check
    from reliefscope.microscope import DemoResult, Evaluation, Outcome
    from reliefscope.reconstruction.self_check import SelfCheck

SECTIONS = {
    "checker_tops": "checker tops",
    "checker_floors": "checker floors",
    "planes": "planes",
    "hemispheres": "hemispheres",
    "full": "full",
}


def show_facts(console: Console, title: str, facts: Mapping[str, Any]) -> None:
    """Names and values, two columns; nested facts are indented."""
    table = Table(
        title=title, show_header=False, box=None, title_justify="left", title_style="bold"
    )
    table.add_column(style="cyan", no_wrap=True)
    table.add_column(overflow="fold")
    _add_facts(table, facts, "")
    console.print(table)


def _add_facts(table: Table, facts: Mapping[str, Any], indent: str) -> None:
    for name, value in facts.items():
        if isinstance(value, Mapping):
            table.add_row(f"{indent}{label(name)}", "")
            _add_facts(table, value, indent + "  ")
        else:
            table.add_row(f"{indent}{label(name)}", escape(_text(value)))


def _text(value: Any) -> str:
    if value is None:
        return "-"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:,.0f}" if abs(value) >= 1000 else f"{value:.4g}"
    if isinstance(value, list | tuple):
        return ", ".join(_text(item) for item in value) or "none"
    return str(value)


def show_table(console: Console, evaluation: Evaluation) -> None:
    """Mean absolute errors beside Table I of the paper."""
    rows = evaluation.table
    for method in dict.fromkeys(row["method"] for row in rows):
        table = Table(
            title=f"Mean absolute error in µm, method {method}",
            title_justify="left",
            title_style="bold",
        )
        table.add_column("section")
        table.add_column("raw", justify="right")
        table.add_column("after one\nmedian offset", justify="right", style="bold")
        table.add_column("after\nplane fit", justify="right")
        table.add_column("paper,\nTable I", justify="right", style="cyan")
        for row in rows:
            if row["method"] == method:
                _add_errors(table, row, evaluation.paper_um.get(row["section"]))
        console.print(table)
    if not evaluation.whole:
        console.print(
            "[yellow]The frames show only a part of the fiducial: the paper's figures are for the whole.[/]"
        )
    console.print(
        "[dim]Every pixel counts, a missing height as 100 µm. The paper does not tell its alignment, "
        "nor how it counted the floors, which lie in shadow.[/]"
    )


def _add_errors(table: Table, row: Mapping[str, Any], reference: float | None) -> None:
    offset = row["mae_offset_um"]
    colour = "" if reference is None else ("green" if offset <= reference else "yellow")
    table.add_row(
        SECTIONS.get(row["section"], label(row["section"])),
        f"{row['mae_raw_um']:.2f}",
        Text(f"{offset:.2f}", style=colour),
        f"{row['mae_plane_um']:.2f}",
        "-" if reference is None else f"{reference:.1f}",
    )


def show_stages(console: Console, stages_s: Mapping[str, float], total_s: float) -> None:
    """Time of each stage."""
    table = Table(title="Time", title_justify="left", title_style="bold", show_header=False)
    table.add_column()
    table.add_column(justify="right")
    for stage, spent in stages_s.items():
        table.add_row(label(stage), duration(spent))
    table.add_section()
    table.add_row("[bold]total[/]", f"[bold]{duration(total_s)}[/]")
    console.print(table)


def show_demo(console: Console, result: DemoResult) -> None:
    """The demo's table, times and places."""
    if result.evaluation is not None:
        show_table(console, result.evaluation)
    if result.outcome.reconstruction.self_check is not None:
        show_findings(console, result.outcome.reconstruction.self_check)
    show_stages(console, result.stages_s, result.total_s)
    _show_places(console, result.outcome)


def show_reconstruction(console: Console, outcome: Outcome) -> None:
    """What a reconstruction found, and where it lies."""
    settings = outcome.reconstruction.settings.chosen
    facts = readable_result(
        outcome.facts(),
        stereo_quality=settings.stereo_quality,
        photometric_quality=settings.photometric_quality,
    )
    show_facts(console, f"Reconstruction {outcome.name}", facts)
    if outcome.reconstruction.self_check is not None:
        show_findings(console, outcome.reconstruction.self_check)
    show_stages(console, outcome.stages_s, outcome.total_s)
    _show_places(console, outcome)


def show_findings(console: Console, check: SelfCheck) -> None:
    """Faults that the comparison of a result with itself shows, each with what to do."""
    for finding in check.findings:
        console.print(f"[bold yellow]{escape(finding.sentence)}.[/]", soft_wrap=True)
        console.print(f"[cyan]next[/] {escape(finding.next_step)}", soft_wrap=True)
    if check.findings:
        console.print()


KINDS = {
    "fused": "stereo and photometric stereo, fused",
    "stereo": "stereo only",
    "integrated": "integrated normals, no absolute height",
}


def readable_result(
    facts: Mapping[str, Any], *, stereo_quality: float, photometric_quality: float
) -> dict[str, str]:
    """Figures of a result in words and with units; the qualities are the least that were accepted."""
    share = "{:.1%} of the valid pixels".format
    forms: dict[str, tuple[str, Callable[[Any], str]]] = {
        "method": ("method", str),
        "kind": ("surface from", lambda kind: KINDS.get(kind, str(kind))),
        "size_px": ("size", lambda size: f"{size[0]} x {size[1]} px"),
        "pixel_um": ("pixel on the sample", "{:g} µm".format),
        "height_known": ("height known in", share),
        "height_1_to_99_percent_um": (
            "height, 1st to 99th percentile",
            lambda span: f"{span[0]:.1f} to {span[1]:.1f} µm",
        ),
        "standard_error_median_um": ("median standard error of the height", "{:.2g} µm".format),
        "self_check": ("compared with itself", str),
        "stereo_accepted": (
            "stereo accepted in",
            lambda part: f"{share(part)} (quality {stereo_quality:g} or better)",
        ),
        "stereo_quality_median": ("median quality of stereo", "{:.2f} (0 to 1)".format),
        "photometric_accepted": (
            "normals accepted in",
            lambda part: f"{share(part)} (quality {photometric_quality:g} or better)",
        ),
        "photometric_quality_median": ("median quality of normals", "{:.2f} (0 to 1)".format),
        "saturated": ("saturated in a frame", share),
        "smoothing_parameter": ("parameter of the smoothing", "{:.3g}".format),
        "full_scale": ("full scale of photometric stereo", "{:.3g} of the camera range".format),
        "solver_iterations": ("iterations of the solver", "{:.0f}".format),
        "solver_error_um": ("error left by the solver", "{:.2g} µm RMS".format),
        "peak_memory_mb": ("greatest memory", "{:,.0f} MB".format),
    }
    shown: dict[str, str] = {}
    for name, value in facts.items():
        title, form = forms.get(name, (label(name), _text))
        shown[title] = form(value)
    return shown


def _show_places(console: Console, outcome: Outcome) -> None:
    console.print()
    console.print(f"[cyan]run[/]      {escape(str(outcome.run))}", soft_wrap=True)
    console.print(f"[cyan]results[/]  {escape(str(outcome.folder))}", soft_wrap=True)
    if outcome.pictures:
        first, *others = outcome.pictures
        console.print(f"[cyan]look at[/]  [bold]{escape(str(first))}[/]", soft_wrap=True)
        names = ", ".join(path.stem for path in others)
        console.print(f"         [dim]beside it: {names}[/]", soft_wrap=True)


def show_checks(console: Console, checks: Sequence[Check]) -> None:
    """The doctor's findings, each failure with what to do."""
    marks = {
        "ok": "[green]ok[/]",
        "warning": "[yellow]warning[/]",
        "failed": "[bold red]failed[/]",
        "absent": "[dim]absent[/]",
    }
    table = Table(box=None, show_header=False, padding=(0, 1))
    table.add_column(no_wrap=True)
    table.add_column(style="bold", no_wrap=True)
    table.add_column(overflow="fold")
    for check in checks:
        table.add_row(marks[check.status], check.name, escape(check.finding))
        if check.hint:
            table.add_row("", "", f"[cyan]{escape(check.hint)}[/]")
    console.print(table)
