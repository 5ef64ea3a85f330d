"""How an error is shown: one line and a hint for people, one object for programs."""

from __future__ import annotations

import json
import sys
from typing import Any

from reliefscope.errors import ReliefscopeError

JSON_SCHEMA_VERSION = 1


def error_object(error: ReliefscopeError) -> dict[str, Any]:
    """What ``--json`` prints instead of a result."""
    return {
        "schema_version": JSON_SCHEMA_VERSION,
        "error": {
            "kind": type(error).__name__.lstrip("_"),
            "message": error.message,
            "hint": error.hint,
            "exit_code": int(error.exit_code),
        },
    }


def print_error(error: ReliefscopeError, *, as_json: bool) -> None:
    """``error: message`` and the hint on standard error; with ``--json`` also an object on standard output."""
    from rich.console import Console
    from rich.markup import escape

    if as_json:
        sys.stdout.write(json.dumps(error_object(error)) + "\n")
        sys.stdout.flush()
    console = Console(stderr=True, highlight=False, soft_wrap=True)
    console.print(f"[bold red]error:[/] {escape(error.message)}")
    for line in error.hint.splitlines():
        console.print(f"[cyan]hint:[/]  {escape(line)}")


def print_traceback() -> None:
    """The traceback of the exception being handled, on standard error."""
    import traceback

    sys.stderr.write(traceback.format_exc())
