"""What happens to a device before it is sold: it is told which glass it drives and gets a serial number."""

from __future__ import annotations

import dataclasses
import functools
from collections.abc import Iterator
from typing import Literal, TypeVar

from reliefscope.errors import DeviceError
from reliefscope.protocol import messages
from reliefscope.protocol.codec import Message, Request
from reliefscope.protocol.framing import Frame, FrameReader
from reliefscope_sim.display import Mounting
from reliefscope_sim.firmware import Firmware

_MOUNTINGS = {
    Mounting.BOTTOM_VIEW: messages.Mounting.BOTTOM_VIEW,
    Mounting.TOP_VIEW: messages.Mounting.TOP_VIEW,
}
_VARIANTS = {
    "E": messages.GlassVariant.E_STN_POSITIVE,
    "S": messages.GlassVariant.S_FSTN_NEGATIVE,
}
_PATIENCE_MS = 2000

ReplyT = TypeVar("ReplyT", bound=Message)


@functools.cache
def factory_settings(variant: Literal["E", "S"], mounting: Mounting, serial_number: str) -> bytes:
    """Non-volatile memory of a device that was set up for its glass.

    The settings are made by the firmware itself, over the protocol, so that their layout is its own affair.

    Raises
    ------
    DeviceError
        If the firmware does not answer: library and host are of different versions.
    """
    firmware = Firmware(b"", boot_nonce=1)
    try:
        answers = _answers(firmware)
        nonce = _ask(firmware, answers, messages.HelloRequest(), 1, 0).boot_nonce
        settings = _ask(firmware, answers, messages.GetSettingsRequest(), 2, nonce)
        wanted = dataclasses.asdict(settings) | {
            "serial_number": serial_number,
            "glass_variant": _VARIANTS[variant],
            "mounting": _MOUNTINGS[mounting],
        }
        _ask(firmware, answers, messages.SetSettingsRequest(**wanted), 3, nonce)
        return firmware.nonvolatile()
    finally:
        firmware.close()


def _answers(firmware: Firmware) -> Iterator[Frame | None]:
    """Frames of the device, None for every millisecond without one."""
    reader = FrameReader()
    for time_ms in range(_PATIENCE_MS):
        firmware.run_until(1000 * time_ms)
        firmware.trace()
        yield from reader.feed(firmware.serial_out())
        yield None


def _ask(
    firmware: Firmware,
    answers: Iterator[Frame | None],
    request: Request[ReplyT],
    request_id: int,
    nonce: int,
) -> ReplyT:
    firmware.serial_in(Frame(request.ID, request_id, nonce, request.pack()).encode())
    for frame in answers:
        if frame is not None and frame.message == request.REPLY.ID:
            return request.read_reply(frame.payload)
    raise DeviceError(
        f"The compiled firmware core did not answer {request.NAME}.",
        hint="Library and host are of different versions: `pip install -e .` builds it anew.",
    )
