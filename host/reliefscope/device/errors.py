"""The ways in which a request to the device can end badly.

What the caller may assume is in the class: after :class:`RejectedError` and :class:`FailedError` nothing
happened, after :class:`OutcomeUnknownError` the device may or may not have acted, after
:class:`DeviceRebootedError` its light is off and its slots and table are gone.
"""

from __future__ import annotations

from reliefscope.errors import DeviceError, ExitCode
from reliefscope.protocol.codec import Message, wire_fields
from reliefscope.protocol.messages import ErrorCode, FaultReason, ResetCause


class DeviceNotFoundError(DeviceError):
    """There is no such port, or it may not be opened."""


class PortAccessError(DeviceNotFoundError):
    """The port is there, but this user may not open it."""


class DeviceTimeout(DeviceError):  # noqa: N818 - it ends a wait; the device itself is well
    """No event came within the time given; the link itself is alive."""


class RefusedError(DeviceError):
    """The device did not do what was asked; nothing happened.

    ``code`` says why, ``detail`` is a number whose meaning the code tells.
    """

    verb = "refused"

    def __init__(self, request: Message, code: ErrorCode, detail: int) -> None:
        text, cause, step = code.description, code.cause, code.next_step
        if code is ErrorCode.OUT_OF_RANGE:
            names = list(wire_fields(type(request)))
            text = f"Field {names[detail] if detail < len(names) else detail} is outside its range."
        elif code is ErrorCode.FAULT_LATCHED:
            reason = FaultReason(detail)
            text, cause, step = (
                f"A fault is latched. {reason.description}",
                reason.cause,
                reason.next_step,
            )
        elif "detail" in text:
            text = f"{text} (detail: {detail})"
        name = request.NAME.removesuffix("_request")
        super().__init__(
            f"The device {self.verb} `{name}` ({code.name}): {text}",
            hint=f"Likely cause: {cause} Next: {step}",
        )
        self.code = code
        self.detail = detail


class RejectedError(RefusedError):
    """The request did not reach its handler: it did not fit the protocol.  Nothing happened."""

    verb = "rejected"


class FailedError(RefusedError):
    """The device understood the request but could not do it.  Nothing happened."""

    verb = "could not do"


class OutcomeUnknownError(DeviceError):
    """No answer came before the deadline: the device may or may not have acted."""

    exit_code = ExitCode.OUTCOME_UNKNOWN


class LinkLostError(OutcomeUnknownError):
    """The port went away, or a read or write on it failed."""


class SchemaMismatchError(DeviceError):
    """Host and firmware speak different versions; only HELLO and enter_bootloader are possible."""


class DeviceRebootedError(DeviceError):
    """The device restarted since HELLO; ``cause`` says why.  Slots and table are gone, the light is off."""

    def __init__(self, cause: ResetCause) -> None:
        super().__init__(
            f"The device restarted ({cause.name}): {cause.description}",
            hint="Its light is off; slots and step table are gone. Connect again and repeat the command.",
        )
        self.cause = cause
