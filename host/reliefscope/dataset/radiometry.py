"""Corrections that bring all frames of a run to one scale of linear light."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

import numpy as np

from reliefscope.dataset.records import FrameKey, JournalEntry, key_of
from reliefscope.dataset.spec import RunSpec
from reliefscope.models.plan import FrameKind, Plan
from reliefscope.units import FloatImage, RawImage


class Radiometry:
    """Scale, gain and offset of each image of a run.

    A frame's linear light is ``gain * (counts / accumulated / full scale - offset)``, where the offset is the
    dark signal plus the leakage of the light.  Shut pixels pass 1/contrast of the light, and open ones are
    among them when the leakage frame is taken, so subtracting it leaves ``1 - 1/contrast`` of what came
    through the open pixels and nothing of what came through the shut ones.

    ``record`` gives the journal's entry of an image, or raises DatasetError where it was not taken: what the
    plan asks for and the run lacks is refused, because heights would come out wrong without it.
    """

    def __init__(
        self,
        spec: RunSpec,
        record: Callable[[FrameKey], JournalEntry],
        read: Callable[[FrameKey], RawImage],
    ) -> None:
        self._spec = spec
        self._record = record
        self._read = read
        self._planned = {key_of(request) for request in spec.requests()}
        self._plan = spec.plan
        self._mean_open = (
            float(np.mean([view.open_pixels for view in self._plan.views])) if self._plan else 0.0
        )

    @property
    def black_level(self) -> float:
        """Signal without light, fraction of full scale, where no dark frame was taken."""
        return self._spec.frame.black_level

    def gain(self, entry: JournalEntry) -> float:
        """Factor that brings an image to the plan's exposure and to the mean number of open pixels."""
        if self._plan is None:
            return 1.0
        gain = self._plan.exposure_us / (entry.exposure_us or self._plan.exposure_us)
        if entry.kind == "view" and entry.view is not None:
            gain *= self._mean_open / self._plan.views[entry.view].open_pixels
        elif entry.kind == "centre" and self._plan.centre is not None:
            gain *= self._mean_open / self._plan.centre.open_pixels
        return gain

    def scale(self, entry: JournalEntry) -> float:
        """Factor from stored counts to linear light, before the offset."""
        return self.gain(entry) / (entry.accumulated * self._spec.frame.full_scale)

    def offset(self, kind: FrameKind, light: int | None) -> FloatImage | None:
        """Dark signal plus leakage (H, W), as counts of the sensor over full scale; None without dark frame.

        A leakage frame without a dark frame is brought above the black level the same way.

        Raises
        ------
        DatasetError
            If the plan has dark or leakage frames that were not taken.
        """
        dark = self._dark
        total = dark
        if kind == "leakage":
            return total
        for led_light, weight in self._leaking(kind, light):
            leakage = self._averaged(("leakage", None, led_light))
            if leakage is None:
                continue
            leakage -= np.float32(self.black_level) if dark is None else dark
            if total is None:
                total = np.full(leakage.shape, self.black_level, dtype=np.float32)
            total = total + np.float32(weight) * leakage
        return total

    def _leaking(self, kind: FrameKind, light: int | None) -> list[tuple[int, float]]:
        """Lights whose leakage frames make up that of an image, with their weights."""
        if kind == "view" and light is not None:
            return [(light, 1.0)]
        if kind == "centre" and self._plan is not None:
            return _shares(self._plan)
        return []

    @cached_property
    def _dark(self) -> FloatImage | None:
        """Averaged dark frame, read once: it serves every light."""
        return self._averaged(("dark", None, None))

    def _averaged(self, key: FrameKey) -> FloatImage | None:
        if key not in self._planned:
            return None
        entry = self._record(key)
        scale = np.float32(1.0 / (entry.accumulated * self._spec.frame.full_scale))
        return np.multiply(self._read(key), scale, dtype=np.float32)


def _shares(plan: Plan) -> list[tuple[int, float]]:
    """Centre light as a sum of lights that are single LEDs (light adds up); empty where it is none."""
    if plan.centre_light is None:
        return []
    single = {
        next(iter(light.levels)): (index, next(iter(light.levels.values())))
        for index, light in enumerate(plan.lights)
        if len(light.levels) == 1
    }
    if not set(plan.centre_light.levels) <= set(single):
        return []
    return [
        (single[led][0], level / single[led][1]) for led, level in plan.centre_light.levels.items()
    ]
