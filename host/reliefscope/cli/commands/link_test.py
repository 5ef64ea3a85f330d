"""``reliefscope link-test``: how well the link to the device does."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from reliefscope.cli.options import (
    DEVICE_VARIABLE,
    JsonFlag,
    ProgressMode,
    ProgressOption,
)
from reliefscope.cli.session import session
from reliefscope.errors import DEFAULT_DEVICE, ExitCode

if TYPE_CHECKING:
    from rich.console import Console

    from reliefscope.device import LinkHealth


def link_test(
    url: Annotated[
        str,
        typer.Argument(
            metavar="[URL]",
            envvar=DEVICE_VARIABLE,
            help="Serial port, socket://HOST:PORT, or a simulated instrument.",
        ),
    ] = DEFAULT_DEVICE,
    requests: Annotated[
        int, typer.Option("--requests", min=1, help="Round trips to measure.")
    ] = 500,
    as_json: JsonFlag = False,
    progress: ProgressOption = ProgressMode.AUTO,
) -> None:
    """Measure round trips, throughput, errors and retries of the link; counted on both sides.

    Lights nothing; overwrites the last aperture slot. Ends with the status of an unknown outcome when a request
    was never answered.
    """
    with session(progress, as_json=as_json) as this:
        from reliefscope.device import Device, measure_link

        with Device.open(url) as device:
            health = measure_link(device, requests, job=this.job)
    content = {"url": url, **health.as_dict()}
    this.result(content, lambda console: _show(console, health))
    if health.unanswered:
        raise typer.Exit(ExitCode.OUTCOME_UNKNOWN)


def _show(console: Console, health: LinkHealth) -> None:
    from reliefscope.cli.tables import show_facts

    trip = health.round_trip_ms
    facts = {
        "device": f"{health.board}, firmware {health.firmware}",
        "round trip p50": f"{trip['p50']:.3g} ms" if trip else None,
        "round trip p99": f"{trip['p99']:.3g} ms" if trip else None,
        "requests": f"{health.requests_per_s:.0f} /s",
        "upload": f"{health.upload_bytes_per_s / 1000:.1f} kB/s",
        "unanswered": health.unanswered,
        "refused": health.refused,
        "retries": health.retries,
        "frames lost, to device": health.lost_to_device,
        "frames lost, to host": health.lost_to_host,
        "frames damaged, to device": health.damaged_to_device,
        "frames damaged, to host": health.damaged_to_host,
        "counted by the host": {n: v for n, v in health.host.items() if v},
        "counted by the device": {n: v for n, v in health.device.items() if v},
    }
    show_facts(console, "Link", facts)
    if health.is_virtual_time:
        console.print("The device lives in virtual time: times are those of the simulation.")
    console.print(health.verdict)
