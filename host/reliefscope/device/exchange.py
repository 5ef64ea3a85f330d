"""One request at a time, repeated under the same id until it is answered: the part below the client's methods.

The device runs a request at most once and answers repeats from its completion ring (see the protocol reference),
so repeating is always safe and a lost reply costs only time.
"""

from __future__ import annotations

import logging
import threading
import time
from collections import deque
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TypeVar

from reliefscope.device.errors import (
    DeviceNotFoundError,
    DeviceRebootedError,
    DeviceTimeout,
    FailedError,
    OutcomeUnknownError,
    RejectedError,
    SchemaMismatchError,
)
from reliefscope.device.link import Deadline, Link
from reliefscope.errors import DeviceError
from reliefscope.protocol.codec import Event, Message, PayloadError, Request
from reliefscope.protocol.framing import Frame
from reliefscope.protocol.messages import (
    MESSAGES,
    PROTOCOL_VERSION,
    SCHEMA_HASH,
    AcknowledgeEventsRequest,
    BootedEvent,
    ErrorCode,
    Failed,
    HelloReply,
    HelloRequest,
    Rejected,
    StatusReply,
    StatusRequest,
)

logger = logging.getLogger(__name__)

R = TypeVar("R", bound=Message)

REQUEST_DEADLINE_S = 3.0
ACKNOWLEDGE_EVERY = 16
PROBE_AFTER_S = 0.5
"""Silence after which a wait for events asks whether the device is still there."""
ID_BLOCK = 256
_FIRST_RETRY_S, _RETRY_GROWTH, _RETRY_MAX_S = 0.03, 1.25, 0.1


class Exchange:
    """HELLO, requests and events over a link.  Thread-safe; requests of other threads pass a wait for events.

    ``url`` is only for messages.  After construction nothing was sent: call :meth:`hello` first.
    """

    def __init__(self, link: Link, url: str = "") -> None:
        self.link = link
        self.url = url
        self.identity: HelloReply | None = None
        self._lock = threading.RLock()
        self._urgent: set[int] = set()  # threads that want the link now
        self._asking_hello = False
        self._hello_id = 0
        self._next_id = 0
        self._reply_s = 0.05  # smoothed time from request to answer
        self._events: deque[Event] = deque()
        self._next_event = 0
        self._acknowledged = 0
        self._event_gap = False
        self._rebooted: DeviceRebootedError | None = None
        self._probed: StatusReply | None = None

    # -- HELLO ------------------------------------------------------------------------------------

    def hello(self, timeout_s: float) -> HelloReply:
        """Ask who is there, and take over the identity; valid across any mismatch of versions.

        Raises
        ------
        DeviceNotFoundError
            If nothing answers as a reliefscope device.
        """
        with self._turn():
            self.link.flush_input()
            identity = self._ask_hello(Deadline(timeout_s))
            if identity is None:
                raise DeviceNotFoundError(
                    f"No reliefscope device answered on {self.url or 'the link'} within {timeout_s:g} s.",
                    hint="Check that this is the right port and that the firmware runs: `reliefscope doctor`; "
                    f"a board without firmware gets it by: reliefscope flash --port {self.url}",
                )
            self.identity = identity
            self._rebooted = None
            self._next_id = (identity.last_request_id // ID_BLOCK + 1) * ID_BLOCK
            self._events.clear()
            self._event_gap = False
            return identity

    @property
    def mismatch(self) -> SchemaMismatchError | None:
        """Why nothing but HELLO and enter_bootloader is possible, or None."""
        identity = self.identity
        if identity is None or identity.schema_hash == SCHEMA_HASH:
            return None
        return SchemaMismatchError(
            f"The firmware on {self.url} ({identity.board}, version {identity.firmware_version}, protocol "
            f"{identity.protocol_version}, schema {identity.schema_hash.hex()[:12]}) does not fit this program "
            f"(protocol {PROTOCOL_VERSION}, schema {SCHEMA_HASH.hex()[:12]}).",
            hint=f"Flash the firmware that belongs to it: reliefscope flash --port {self.url}",
        )

    def skip_old_events(self) -> None:
        """Acknowledge every event up to now: they belong to whoever used the device before."""
        with self._turn():
            self._next_event = self._request(StatusRequest(), REQUEST_DEADLINE_S).next_event
            self._acknowledge(resend=False)
            self._events.clear()

    # -- requests ---------------------------------------------------------------------------------

    def request(self, request: Request[R], deadline_s: float = REQUEST_DEADLINE_S) -> R:
        """Have the device do something, at most once, and return what it says.

        Raises
        ------
        RejectedError, FailedError
            Nothing happened.
        OutcomeUnknownError
            No answer before the deadline.
        DeviceRebootedError
            The device restarted since HELLO.
        SchemaMismatchError
            The request was not sent: host and firmware are of different versions.
        """
        with self._turn():
            return self._request(request, deadline_s)

    def _request(self, request: Request[R], deadline_s: float) -> R:
        identity = self.identity
        if identity is None:
            raise DeviceNotFoundError("No device is connected.", hint="Open the port again.")
        if request.RING and self.mismatch:
            raise self.mismatch
        if self._rebooted:
            raise self._rebooted
        request_id, self._next_id = self._next_id, self._next_id + 1
        frame = Frame(request.ID, request_id, identity.boot_nonce, request.pack())
        answer = self._repeat(frame, Deadline(deadline_s), identity.boot_nonce)
        if answer is None:
            name = request.NAME.removesuffix("_request")
            raise OutcomeUnknownError(
                f"The device did not answer `{name}` within {deadline_s:g} s; it may or may not have acted.",
                hint="Check cable and supply, then connect again and read the status: reliefscope doctor",
            )
        return self._read_answer(request, answer)

    def _read_answer(self, request: Request[R], answer: Frame) -> R:
        if answer.message in {Rejected.ID, Failed.ID}:
            kind = Rejected if answer.message == Rejected.ID else Failed
            refusal = kind.unpack(answer.payload)
            error = RejectedError if answer.message == Rejected.ID else FailedError
            if refusal.code is ErrorCode.WRONG_NONCE:
                self._find_reboot()
            raise error(request, refusal.code, refusal.detail)
        if answer.message != request.REPLY.ID:
            raise PayloadError(
                f"The device answered {request.NAME} with {answer}.",
                hint=f"Flash the firmware that belongs to this program: reliefscope flash --port {self.url}",
            )
        return request.read_reply(answer.payload)

    def _repeat(self, frame: Frame, deadline: Deadline, nonce: int | None) -> Frame | None:
        """Send a frame until it is answered; None when the deadline ends.  ``nonce`` None takes any boot's."""
        wait_s = max(_FIRST_RETRY_S, 4 * self._reply_s)
        first = True
        while deadline.remaining_s > 0:
            self.link.send(frame)
            attempt = Deadline(min(wait_s, deadline.remaining_s))
            answer = self._await(frame.request_id, attempt, nonce)
            if answer is not None:
                if first:
                    self._reply_s += (attempt.spent_s - self._reply_s) / 8
                return answer
            deadline.idle(attempt.seconds)
            self.link.count("retries")
            wait_s = max(wait_s, min(wait_s * _RETRY_GROWTH, _RETRY_MAX_S))
            first = False
        return None

    def _await(self, request_id: int, attempt: Deadline, nonce: int | None) -> Frame | None:
        while True:
            frame = self.link.receive(attempt)
            if frame is None:
                if attempt.remaining_s <= 0:
                    return None
                continue
            if _is_event(frame):
                self._take_event(frame)
            elif frame.request_id != request_id or (
                nonce is None and frame.message != HelloReply.ID
            ):
                self.link.count("stale_answers")
            elif nonce is None or frame.boot_nonce == nonce:
                return frame
            else:
                self._find_reboot()

    def _ask_hello(self, deadline: Deadline) -> HelloReply | None:
        self._hello_id += 1
        frame = Frame(HelloRequest.ID, self._hello_id, 0, HelloRequest().pack())
        self._asking_hello = True
        try:
            answer = self._repeat(frame, deadline, None)
        finally:
            self._asking_hello = False
        return None if answer is None else HelloReply.unpack(answer.payload)

    def _find_reboot(self) -> None:
        """A frame carried another nonce: ask, and raise if the device did restart (it may be a late frame)."""
        if self.identity is None or self._rebooted:
            return
        now = self._ask_hello(Deadline(REQUEST_DEADLINE_S))
        if now is not None and now.boot_nonce != self.identity.boot_nonce:
            self._rebooted = DeviceRebootedError(now.reset_cause)
            raise self._rebooted

    # -- events -----------------------------------------------------------------------------------

    def next_event(self, timeout_s: float) -> Event:
        """Wait for the next event; lost ones are fetched again, doubled ones dropped.

        Raises
        ------
        DeviceTimeout
            If none comes in time, with what the device does meanwhile.
        DeviceRebootedError, OutcomeUnknownError
            If the device restarted or is gone.
        """
        deadline = Deadline(timeout_s)
        self._probed = None
        while True:
            while self._urgent:
                time.sleep(0.0005)
            with self._lock:
                event = self._poll_event(deadline)
            if event is not None:
                return event
            if deadline.remaining_s <= 0:
                raise _no_event(timeout_s, self._probed)

    def _poll_event(self, deadline: Deadline) -> Event | None:
        if self.mismatch:
            raise self.mismatch
        if self._rebooted:
            raise self._rebooted
        if not self._events:
            frame = self.link.receive(deadline)
            while frame is not None:
                if _is_event(frame):
                    self._take_event(frame)
                else:
                    self.link.count("stale_answers")
                frame = self.link.receive(Deadline(0))
            if self.link.silent_s >= PROBE_AFTER_S:
                self.link.silent_s = 0.0
                self._probed = self._request(StatusRequest(), REQUEST_DEADLINE_S)
                self._event_gap |= self._probed.next_event != self._next_event
        if self._event_gap:
            self._acknowledge(resend=True)
        elif self._next_event - self._acknowledged >= ACKNOWLEDGE_EVERY:
            self._acknowledge(resend=False)
        return self._events.popleft() if self._events else None

    def _acknowledge(self, *, resend: bool) -> None:
        self._event_gap = False
        if resend:
            self.link.count("event_gaps")
        self._request(AcknowledgeEventsRequest(self._next_event, resend), REQUEST_DEADLINE_S)
        self._acknowledged = self._next_event

    def _take_event(self, frame: Frame) -> None:
        if self.identity is None:
            return
        if frame.boot_nonce != self.identity.boot_nonce:
            if not self._asking_hello:
                self._find_reboot()
            return
        if frame.request_id != self._next_event:
            self._event_gap |= frame.request_id > self._next_event
            self.link.count("events_out_of_order")
            return
        kind = MESSAGES.get(frame.message)
        event = kind.unpack(frame.payload) if kind else None
        if not isinstance(event, Event):
            raise DeviceError(f"The device sent an event that is not known: {frame}.")
        self._next_event += 1
        if not isinstance(event, BootedEvent):
            self._events.append(event)

    @contextmanager
    def _turn(self) -> Iterator[None]:
        """Take the link ahead of a wait for events."""
        me = threading.get_ident()
        self._urgent.add(me)
        try:
            self._lock.acquire()
        finally:
            self._urgent.discard(me)
        try:
            yield
        finally:
            self._lock.release()


def _no_event(timeout_s: float, status: StatusReply | None) -> DeviceTimeout:
    text = f"The device sent no event within {timeout_s:g} s"
    if status is None:
        return DeviceTimeout(f"{text}.", hint="Wait for longer, or read its status.")
    camera = "ready" if status.camera_ready else "not ready"
    return DeviceTimeout(
        f"{text}: it is {status.sequence.name} at step {status.step} after {status.exposures} exposures, "
        f"fault {status.fault.name}, camera {camera}.",
        hint="The device itself answers. A camera that is not ready is not armed or stalled; a HELD sequence waits "
        "for events to be read; an IDLE one was never started or has ended.",
    )


def _is_event(frame: Frame) -> bool:
    kind = MESSAGES.get(frame.message)
    return kind is not None and issubclass(kind, Event)
