"""A plan as the device takes it: slots and step tables, in batches where it exceeds a capacity."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from dataclasses import dataclass, field

from reliefscope.dataset import Confirmed
from reliefscope.device import Step
from reliefscope.models.apertures import pack_bitmap
from reliefscope.models.plan import Aperture, FrameRequest, Light, Plan
from reliefscope.protocol.messages import SLOT_NONE
from reliefscope.units import US_PER_MS

_SHUT_SHA256 = hashlib.sha256(bytes(1024)).hexdigest()


@dataclass(frozen=True, slots=True)
class Capacity:
    """What the device can hold at once."""

    apertures: int
    lights: int
    steps: int


@dataclass(slots=True)
class Batch:
    """One step table with the slots that it names; step k takes the image ``requests[k]``."""

    apertures: list[Aperture] = field(default_factory=list)
    lights: list[Light] = field(default_factory=list)
    steps: list[Step] = field(default_factory=list)
    requests: list[FrameRequest] = field(default_factory=list)

    @property
    def exposures(self) -> int:
        """Exposures of the whole table."""
        return sum(step.repeat for step in self.steps)

    def confirmed(self, step: int) -> Confirmed:
        """State that the events of a step confirm when they name its slots."""
        aperture_slot, light_slot = self.steps[step].aperture, self.steps[step].light
        if aperture_slot == SLOT_NONE:
            digest, open_pixels = _SHUT_SHA256, 0
        else:
            aperture = self.apertures[aperture_slot]
            digest = hashlib.sha256(pack_bitmap(aperture.bitmap)).hexdigest()
            open_pixels = aperture.open_pixels
        levels = {} if light_slot == SLOT_NONE else self.lights[light_slot].levels
        return Confirmed(
            aperture_slot=aperture_slot,
            aperture_sha256=digest,
            open_pixels=open_pixels,
            light_slot=light_slot,
            levels=levels,
        )


def aperture_of(request: FrameRequest, plan: Plan) -> Aperture | None:
    """Bitmap on the glass during an image; None is shut."""
    if request.kind == "view" and request.view is not None:
        return plan.views[request.view]
    return plan.centre if request.kind == "centre" else None


def light_of(request: FrameRequest, plan: Plan) -> Light | None:
    """Light during an image; None is off."""
    if request.kind == "centre":
        return plan.centre_light
    return None if request.light is None else plan.lights[request.light]


def make_batches(
    requests: Iterable[FrameRequest], plan: Plan, capacity: Capacity, exposure_us: int
) -> list[Batch]:
    """Tables that take ``requests`` in their order, each within the device's capacity.

    The settle time of the glass is waited where a batch begins or the bitmap changes, that of the light
    elsewhere.
    """
    batches: list[Batch] = []
    apertures: dict[bytes, int] = {}
    lights: dict[tuple[tuple[int, int], ...], int] = {}
    for request in requests:
        aperture, light = aperture_of(request, plan), light_of(request, plan)
        bitmap = None if aperture is None else pack_bitmap(aperture.bitmap)
        levels = None if light is None else tuple(sorted(light.levels.items()))
        full = (
            not batches
            or len(batches[-1].steps) == capacity.steps
            or (
                bitmap is not None
                and bitmap not in apertures
                and len(apertures) == capacity.apertures
            )
            or (levels is not None and levels not in lights and len(lights) == capacity.lights)
        )
        if full:
            batches.append(Batch())
            apertures.clear()
            lights.clear()
        batch = batches[-1]
        aperture_slot = light_slot = SLOT_NONE
        if aperture is not None and bitmap is not None:
            aperture_slot = apertures.setdefault(bitmap, len(apertures))
            if aperture_slot == len(batch.apertures):
                batch.apertures.append(aperture)
        if light is not None and levels is not None:
            light_slot = lights.setdefault(levels, len(lights))
            if light_slot == len(batch.lights):
                batch.lights.append(light)
        same_glass = bool(batch.steps) and batch.steps[-1].aperture == aperture_slot
        settle_ms = plan.light_settle_ms if same_glass else plan.settle_ms
        batch.steps.append(
            Step(
                aperture=aperture_slot,
                light=light_slot,
                repeat=request.accumulate,
                settle_us=round(settle_ms * US_PER_MS),
                exposure_us=exposure_us,
            )
        )
        batch.requests.append(request)
    return batches
