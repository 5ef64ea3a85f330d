"""Tables within the device's capacity, in the order of the plan."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from reliefscope.acquisition.batches import Capacity, aperture_of, light_of, make_batches
from reliefscope.models.apertures import pack_bitmap
from reliefscope.models.instrument import load_profile
from reliefscope.models.plan import default_plan
from reliefscope.protocol.messages import SLOT_NONE

PROFILE = load_profile("benchtop")
PLAN = default_plan(PROFILE)


def test_the_default_plan_is_one_table() -> None:
    batches = make_batches(PLAN.requests(), PLAN, Capacity(16, 32, 1024), PLAN.exposure_us)
    assert len(batches) == 1
    batch = batches[0]
    assert len(batch.apertures) == 13
    assert len(batch.lights) == 17
    assert batch.exposures == 16 + 16 * 16 + 12 * 16 + 1
    glass_changes = sum(step.settle_us == 400_000 for step in batch.steps)
    assert glass_changes == 1 + 12 + 1
    assert batch.steps[0].aperture == batch.steps[0].light == SLOT_NONE  # dark
    assert batch.steps[1].aperture == SLOT_NONE  # leakage: shut, lit
    assert batch.steps[1].light == 0


@given(
    apertures=st.integers(1, 16),
    lights=st.integers(1, 32),
    steps=st.integers(1, 300),
    skip=st.integers(0, 200),
)
def test_every_batch_fits_and_shows_what_the_plan_says(
    apertures: int, lights: int, steps: int, skip: int
) -> None:
    requests = list(PLAN.requests())[skip:]
    capacity = Capacity(apertures, lights, steps)
    batches = make_batches(requests, PLAN, capacity, 12345)
    assert [request for batch in batches for request in batch.requests] == requests
    for batch in batches:
        assert len(batch.apertures) <= apertures
        assert len(batch.lights) <= lights
        assert 1 <= len(batch.steps) <= steps
        before = None
        for request, step in zip(batch.requests, batch.steps, strict=True):
            aperture, light = aperture_of(request, PLAN), light_of(request, PLAN)
            shown = None if step.aperture == SLOT_NONE else batch.apertures[step.aperture]
            lit = None if step.light == SLOT_NONE else batch.lights[step.light]
            assert (shown and pack_bitmap(shown.bitmap)) == (
                aperture and pack_bitmap(aperture.bitmap)
            )
            assert (lit and lit.levels) == (light and light.levels)
            settle_ms = PLAN.light_settle_ms if step.aperture == before else PLAN.settle_ms
            assert step.settle_us == settle_ms * 1000
            assert step.repeat == request.accumulate
            assert step.exposure_us == 12345
            before = step.aperture


def test_confirmed_state_names_the_bitmap() -> None:
    batch = make_batches(PLAN.requests(), PLAN, Capacity(16, 32, 1024), PLAN.exposure_us)[0]
    view = next(k for k, request in enumerate(batch.requests) if request.kind == "view")
    confirmed = batch.confirmed(view)
    assert confirmed.open_pixels == int(np.count_nonzero(PLAN.views[0].bitmap))
    assert confirmed.levels == PLAN.lights[0].levels
    dark = batch.confirmed(0)
    assert (dark.open_pixels, dark.levels) == (0, {})
