"""The ``reliefscope`` command: its subcommands, and what happens to an error.

Nothing here, nor in the modules of the subcommands, imports numpy, numba or textual before a command really
runs: ``--help`` answers at once.
"""

from __future__ import annotations

import inspect
import logging
import re
import sys
from collections.abc import Sequence
from importlib.metadata import entry_points
from typing import Annotated

import typer

from reliefscope import __version__
from reliefscope.cli.commands import (
    acquire,
    bundle,
    calibrate,
    dataset,
    demo,
    diagnose,
    estimate_lights,
    evaluate,
    experiment,
    fiducial,
    flash,
    focus_stack,
    light_probe,
    link_test,
    reconstruct,
    tui,
)
from reliefscope.cli.errors import print_error, print_traceback
from reliefscope.errors import Cancelled, ExitCode, ReliefscopeError

app = typer.Typer(
    name="reliefscope",
    help="A miniature 3D microscope and reflectometer without a moving part.",
    epilog="Start with `reliefscope demo`; it needs no instrument.",
    add_completion=True,
    context_settings={"help_option_names": ["-h", "--help"]},
)

app.command("demo", rich_help_panel="Start here")(demo.demo)
app.command("doctor", rich_help_panel="Start here")(diagnose.doctor)
app.command("tui", rich_help_panel="Measure")(tui.tui)
app.command("acquire", rich_help_panel="Measure")(acquire.acquire)
app.command("import", rich_help_panel="Measure")(dataset.import_photographs)
app.command("light-probe", rich_help_panel="Measure")(light_probe.light_probe)
app.command("estimate-lights", rich_help_panel="Measure")(estimate_lights.estimate_lights)
app.command("reconstruct", rich_help_panel="Process")(reconstruct.reconstruct)
app.command("evaluate", rich_help_panel="Process")(evaluate.evaluate)
app.command("focus-stack", rich_help_panel="Process")(focus_stack.focus_stack)
app.command("fiducial", rich_help_panel="Make targets")(fiducial.fiducial)
app.command("info", rich_help_panel="Look after runs")(dataset.info)
app.command("verify", rich_help_panel="Look after runs")(dataset.verify)
app.command("bundle", rich_help_panel="Look after runs")(bundle.bundle)
app.command("flash", rich_help_panel="Look after the instrument")(flash.flash)
app.command("link-test", rich_help_panel="Look after the instrument")(link_test.link_test)
app.add_typer(calibrate.app, name="calibrate", rich_help_panel="Measure")
app.add_typer(experiment.app, name="experiment", rich_help_panel="Start here")

COMMAND_GROUP = "reliefscope.commands"
for _entry in entry_points(group=COMMAND_GROUP):
    app.add_typer(_entry.load(), name=_entry.name, rich_help_panel="From installed packages")


def prose(text: str) -> str:
    """``text`` with the lines of each paragraph joined, so that help wraps where the terminal does."""
    paragraphs = re.split(r"\n\s*\n", inspect.cleandoc(text))
    return "\n\n".join(" ".join(paragraph.split()) for paragraph in paragraphs)


def _join_lines(commands: typer.Typer) -> None:
    for command in commands.registered_commands:
        if command.callback is not None:
            command.help = prose(command.help or command.callback.__doc__ or "")
    for group in commands.registered_groups:
        if group.typer_instance is not None:
            _join_lines(group.typer_instance)


_join_lines(app)


@app.callback(invoke_without_command=True)
def _common(
    context: typer.Context,
    verbose: Annotated[
        int,
        typer.Option("--verbose", "-v", count=True, help="Log what is done; twice: every detail."),
    ] = 0,
    debug: Annotated[
        bool, typer.Option("--debug", help="Show the traceback of an error, and log every detail.")
    ] = False,
    version: Annotated[bool, typer.Option("--version", help="Print the version.")] = False,
) -> None:
    if version:
        typer.echo(f"reliefscope {__version__}")
        raise typer.Exit
    if context.invoked_subcommand is None:
        typer.echo(context.get_help())
        raise typer.Exit(ExitCode.USAGE)
    levels = (logging.WARNING, logging.INFO, logging.DEBUG)
    logging.basicConfig(
        level=levels[2 if debug else min(verbose, 2)],
        format="%(asctime)s %(levelname)s %(name)s: %(message)s",
        stream=sys.stderr,
        force=True,
    )
    for library in ("matplotlib", "numba", "PIL", "asyncio"):
        logging.getLogger(library).setLevel(logging.WARNING)


def run(arguments: Sequence[str] | None = None) -> int:
    """Run the command line; every outcome ends as one of :class:`~reliefscope.errors.ExitCode`."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    as_json, debug = "--json" in given, "--debug" in given
    try:
        status = app(args=given, prog_name="reliefscope", standalone_mode=False)
    except ReliefscopeError as error:
        if debug:
            print_traceback()
        print_error(error, as_json=as_json)
        return int(error.exit_code)
    except typer.TyperException as error:
        print_error(_usage_error(error), as_json=as_json)
        return int(ExitCode.USAGE)
    except (typer.Abort, KeyboardInterrupt):
        print_error(Cancelled("Stopped; everything finished so far is kept."), as_json=as_json)
        return int(ExitCode.CANCELLED)
    except BrokenPipeError:  # the reader of our output went away, as in `| head`
        sys.stderr.close()
        return int(ExitCode.OK)
    except Exception as error:  # noqa: BLE001 - the last resort: one line for people, not a traceback
        if debug:
            print_traceback()
        print_error(_unforeseen(error, given), as_json=as_json)
        return int(ExitCode.FAILURE)
    return status if isinstance(status, int) else int(ExitCode.OK)


class _UsageError(ReliefscopeError):
    """The command line itself was wrong."""

    exit_code = ExitCode.USAGE


def _usage_error(error: typer.TyperException) -> ReliefscopeError:
    context = getattr(error, "ctx", None)
    command = context.command_path if context is not None else "reliefscope"
    return _UsageError(error.format_message(), hint=f"See `{command} --help`.")


def _unforeseen(error: Exception, given: Sequence[str]) -> ReliefscopeError:
    command = " ".join(["reliefscope", "--debug", *given])
    return ReliefscopeError(
        f"Unforeseen {type(error).__name__}: {error}",
        hint=f"This is a defect of the program. `{command}` shows where; please report its output.",
    )
