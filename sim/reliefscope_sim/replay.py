"""A recorded session, played again: the same bytes to the device at the same times, the same use of the camera.

The bench runs with the seed and the faults of the recording, so its answers and its pictures have to be those
that were recorded; the report says whether they were.
"""

from __future__ import annotations

import zlib
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from reliefscope.models.camera import CameraBusyError, CameraLostError
from reliefscope.protocol.framing import Frame, FrameReader
from reliefscope.units import US_PER_S
from reliefscope_sim.recording import Happening, Recording

if TYPE_CHECKING:
    from reliefscope_sim.bench import Bench

DELIMITER = b"\0"
"""Sent ahead of each frame by the host."""
BOOT_US = 1_000_000
"""Time that a device has to start before a recording by the host's clock begins."""


@dataclass(frozen=True, slots=True)
class ReplayReport:
    """How a session went when it was played again.

    ``answers`` counts the frames that the device sent according to the recording, ``pictures`` the camera's;
    ``same_*`` those that came again, bit for bit.  ``difference`` tells of the first that did not.
    """

    duration_s: float
    sent: int
    answers: int
    same_answers: int
    pictures: int
    same_pictures: int
    pictures_compared: bool
    difference: str = ""

    @property
    def same(self) -> bool:
        """Whether everything that was compared was the same."""
        return not self.difference

    def as_dict(self) -> dict[str, Any]:
        """For ``--json``."""
        return {"same": self.same, **asdict(self)}


class Player:
    """Plays ``recording`` on ``bench``, which nobody else uses meanwhile."""

    def __init__(self, bench: Bench, recording: Recording, *, pictures: bool = True) -> None:
        self._bench = bench
        self._recording = recording
        self._pictures = pictures
        self._reader = FrameReader()
        self._answered: list[Frame] = []
        self._matched = 0
        self._sent = self._answers = self._same_answers = 0
        self._taken = self._same_taken = 0
        self._difference = ""

    def play(self) -> ReplayReport:
        """Play it to its end; the port is closed and the camera let go afterwards."""
        bench = self._bench
        begin_us = 0 if self._recording.keeps_time else BOOT_US
        bench.run_to(begin_us)
        bench.open_port()
        bench.open_camera(set_up=self._pictures)
        try:
            for happening in self._recording.happenings:
                bench.run_to(begin_us + happening.time_us)
                self._follow(happening)
        finally:
            bench.close_camera()
            bench.close_port()
        return ReplayReport(
            bench.time_us / US_PER_S,
            self._sent,
            self._answers,
            self._same_answers,
            self._taken,
            self._same_taken,
            self._pictures,
            self._difference,
        )

    def _follow(self, happening: Happening) -> None:
        self._answered += self._reader.feed(self._bench.take_received())
        if happening.direction == "out" and happening.frame is not None:
            self._bench.send(DELIMITER + happening.frame.encode(), timeout_us=0)
            self._sent += 1
        elif happening.direction == "in" and happening.frame is not None:
            self._compare_answer(happening, happening.frame)
        elif happening.direction == "camera":
            self._use_camera(happening)

    def _compare_answer(self, happening: Happening, frame: Frame) -> None:
        """The host may have thrown answers away unread, so what came in between does not count."""
        self._answers += 1
        try:
            place = self._answered.index(frame, self._matched)
        except ValueError:
            came = self._answered[self._matched : self._matched + 1]
            self._differ(happening, str(came[0]) if came else "nothing")
            return
        self._matched = place + 1
        self._same_answers += 1

    def _use_camera(self, happening: Happening) -> None:
        bench, content = self._bench, happening.content
        try:
            match happening.says:
                case "configure":
                    bench.configure_camera(
                        int(content["exposure_us"]),
                        triggered=bool(content["trigger"]),
                        gain_db=float(content["gain_db"]),
                    )
                case "arm":
                    bench.arm_camera()
                case "disarm":
                    bench.disarm_camera()
                case "frame":
                    self._compare_picture(happening)
        except (CameraBusyError, CameraLostError) as error:
            self._differ(happening, error.message)

    def _compare_picture(self, happening: Happening) -> None:
        self._taken += 1
        exposure = self._bench.take_exposure()
        if exposure is None:
            self._differ(happening, "no frame")
            return
        recorded = (happening.content["frame_id"], happening.content["time_us"])
        start_us = exposure.start_us if self._recording.keeps_time else recorded[1]
        if (exposure.frame_id, start_us) != recorded:
            self._differ(happening, f"frame {exposure.frame_id} of {exposure.start_us} us")
            return
        if self._pictures:
            raw = np.ascontiguousarray(self._bench.darkroom.develop(exposure))
            if zlib.crc32(raw.data) != happening.content["crc32"]:
                self._differ(happening, "other pixels")
                return
        self._same_taken += 1

    def _differ(self, happening: Happening, instead: str) -> None:
        self._difference = self._difference or (
            f"At {happening.time_us / US_PER_S:.6f} s the recording has {happening.says}; "
            f"this time it was {instead}."
        )


def play_file(path: Path, *, instrument: str | None = None, pictures: bool = True) -> ReplayReport:
    """Play a bundle or a wire log on a bench of its own.

    ``instrument`` is a ``sim://`` address with the options to use instead of those of the recording.

    Raises
    ------
    InvalidInputError
        If the file cannot be played, or the address is wrong.
    """
    from reliefscope_sim.bench import Bench
    from reliefscope_sim.url import SimUrl

    recording = Recording.load(path)
    bench = Bench(SimUrl.of_recording(path, instrument), recording.nonces)
    try:
        return Player(bench, recording, pictures=pictures).play()
    finally:
        bench.switch_off()
