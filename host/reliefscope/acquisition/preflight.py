"""What is checked before anything moves: plan against device, camera and profile."""

from __future__ import annotations

import logging

from reliefscope.acquisition.batches import aperture_of, light_of
from reliefscope.dataset import FrameFormat
from reliefscope.device import Device, Step
from reliefscope.errors import CameraError, InvalidInputError
from reliefscope.models.calibration import Calibration
from reliefscope.models.camera import Camera, CameraInfo, CameraSettings
from reliefscope.models.instrument import InstrumentProfile
from reliefscope.models.plan import Plan
from reliefscope.protocol.codec import wire_fields
from reliefscope.units import US_PER_MS

log = logging.getLogger(__name__)

EXPOSURE_TOLERANCE = 0.02
"""Largest departure of the camera's exposure from the plan's, as a fraction."""


def frame_format(profile: InstrumentProfile) -> FrameFormat:
    """Form of the frames of an instrument."""
    camera = profile.camera
    return FrameFormat(
        rows=camera.rows,
        columns=camera.columns,
        sensor=camera.sensor,
        bit_depth=camera.bit_depth,
        black_level=camera.black_level,
    )


def check_plan(plan: Plan, profile: InstrumentProfile, calibration: Calibration) -> None:
    """Refuse a plan that the instrument of ``profile`` cannot carry out.

    Raises
    ------
    InvalidInputError
        Naming the LED, view or number that is out of range.
    """
    leds = profile.dome.count
    if len(calibration.led_positions_mm) != leds:
        raise InvalidInputError(
            f"The calibration knows {len(calibration.led_positions_mm)} LEDs, the profile "
            f"{profile.name} has {leds}.",
            hint="Use a calibration of this instrument, or none for the nominal one.",
        )
    for request in plan.requests():
        light, aperture = light_of(request, plan), aperture_of(request, plan)
        wrong = [led for led in (light.levels if light else {}) if not 0 <= led < leds]
        if light is not None and wrong:
            raise InvalidInputError(
                f"Light `{light.name}` names LED {wrong[0]}, but {profile.name} has LEDs 0 to {leds - 1}.",
                hint="Correct the lights of the plan.",
            )
        if aperture is not None and not aperture.open_pixels:
            raise InvalidInputError(
                f"View `{aperture.name}` opens no pixel of the glass.",
                hint="Give every view at least one open pixel.",
            )
    ranges = wire_fields(Step)
    for name, value_us in (
        ("exposure_us", plan.exposure_us),
        ("settle_us", round(plan.settle_ms * US_PER_MS)),
        ("settle_us", round(plan.light_settle_ms * US_PER_MS)),
    ):
        low, high = ranges[name].minimum or 0, ranges[name].maximum
        if value_us < low or (high is not None and value_us > high):
            raise InvalidInputError(
                f"{name} of {value_us} is outside the device's range of {low} to {high}.",
                hint="Correct exposure or settle time of the plan.",
            )


def check_device(device: Device, plan: Plan) -> None:
    """Refuse what the connected device would refuse in the middle of a run."""
    identity, limits = device.identity, device.limits()
    for request in plan.requests():
        light = light_of(request, plan)
        if light is None:
            continue
        if max(light.levels) >= identity.leds:
            raise InvalidInputError(
                f"Light `{light.name}` names LED {max(light.levels)}, but the device drives "
                f"{identity.leds} LEDs.",
                hint="Is this the right device? `reliefscope doctor` lists what is connected.",
            )
        if sum(light.levels.values()) > limits.level_budget:
            raise InvalidInputError(
                f"Light `{light.name}` needs a level sum of {sum(light.levels.values())}; the device "
                f"allows {limits.level_budget}.",
                hint="Lower its levels and lengthen the exposure.",
            )
        uneven = [i for i, level in light.levels.items() if level % limits.led_level_step]
        if uneven:
            raise InvalidInputError(
                f"Light `{light.name}` has levels that the device cannot make, of LED {uneven[0]} first.",
                hint=f"Take multiples of {limits.led_level_step}.",
            )
    if limits.led_period_us and plan.exposure_us % limits.led_period_us:
        raise InvalidInputError(
            f"The exposure of {plan.exposure_us} us is not a whole number of the periods of the device's "
            f"LED drivers ({limits.led_period_us} us): frames would differ in brightness.",
            hint=f"Take a multiple of {limits.led_period_us} us.",
        )
    if plan.exposure_us > limits.led_on_time_us:
        raise InvalidInputError(
            f"The exposure of {plan.exposure_us} us is longer than an LED may be on "
            f"({limits.led_on_time_us} us).",
            hint="Shorten the exposure and raise the light's level or the gain.",
        )


def check_camera(info: CameraInfo, profile: InstrumentProfile, *, resuming: bool = False) -> None:
    """Refuse a camera whose frames are not those of the profile, which is fixed once a run has begun."""
    advice = "Open the right camera, or "
    advice += (
        "begin a new run." if resuming else "give the profile that belongs to it with `--profile`."
    )
    camera = profile.camera
    for what, found, expected in (
        ("frames of (rows, columns)", info.shape, profile.shape),
        ("a sensor of kind", info.sensor, camera.sensor),
        ("a bit depth of", info.bit_depth, camera.bit_depth),
    ):
        if found != expected:
            raise InvalidInputError(
                f"The camera has {what} {found}, but the profile {profile.name} says {expected} "
                f"(camera: {info.vendor} {info.model}).",
                hint=advice,
            )
    if not info.trigger_inputs:
        raise InvalidInputError(
            f"The camera has no trigger input ({info.vendor} {info.model}).",
            hint="An acquisition needs a camera that the device can trigger.",
        )


def configure_camera(camera: Camera, plan: Plan) -> CameraSettings:
    """Set exposure, gain and trigger; return what the camera really uses."""
    wanted = CameraSettings(exposure_us=plan.exposure_us, gain_db=plan.gain_db, trigger=True)
    actual = camera.configure(wanted)
    if abs(actual.exposure_us - wanted.exposure_us) > EXPOSURE_TOLERANCE * wanted.exposure_us:
        raise CameraError(
            f"The camera exposes for {actual.exposure_us} us instead of {wanted.exposure_us} us.",
            hint="Choose an exposure within the camera's range.",
        )
    if actual.gain_db != wanted.gain_db:
        log.warning("the camera uses %g dB instead of %g dB", actual.gain_db, wanted.gain_db)
    return actual
