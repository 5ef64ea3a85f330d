"""``reliefscope doctor``: whether everything is here that the instrument needs."""

from __future__ import annotations

import typer

from reliefscope.cli.options import JsonFlag
from reliefscope.errors import ExitCode


def doctor(as_json: JsonFlag = False) -> None:
    """Check ports, permissions, cameras, the simulated instrument, calibrations, versions and disk.

    Ends with a status of its own when something keeps the instrument from working.
    """
    from reliefscope.cli.options import ProgressMode
    from reliefscope.cli.session import session

    with session(ProgressMode.NONE, as_json=as_json) as this:
        from reliefscope import doctor as examination
        from reliefscope.cli.tables import show_checks

        checks = examination.examine()
    healthy = examination.healthy(checks)
    content = {"healthy": healthy, "checks": [check.as_dict() for check in checks]}
    this.result(content, lambda console: show_checks(console, checks))
    if not healthy:
        raise typer.Exit(ExitCode.CHECKS_FAILED)
