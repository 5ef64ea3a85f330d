"""Whether a result agrees with itself: faults of the instrument's description, told without any truth.

Three comparisons, each of two things that were measured independently:

- slopes of the stereo heights and of the normals (:mod:`~reliefscope.reconstruction.slope_agreement`);
- shadows that the heights cast, and dark places (:mod:`~reliefscope.reconstruction.shadow_agreement`);
- each light, and what all others predict for it (:mod:`~reliefscope.reconstruction.held_out_lights`).

Shadows decide where the sample casts any, because they do not depend on how it reflects.  Normals of granular and
glossy samples are biased by light from the surroundings, so slopes decide only where most of the surface agrees.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from reliefscope.models.light_field import LightField
from reliefscope.reconstruction import shadows as cast_shadows
from reliefscope.reconstruction.held_out_lights import HeldOutLights, hold_out_lights
from reliefscope.reconstruction.inputs import Inputs
from reliefscope.reconstruction.matching_error import error_share
from reliefscope.reconstruction.mvs import MvsResult
from reliefscope.reconstruction.photometric import PsResult
from reliefscope.reconstruction.shadow_agreement import ShadowAgreement, compare_shadows
from reliefscope.reconstruction.slope_agreement import SlopeAgreement, compare_slopes
from reliefscope.reconstruction.stage_clock import StageClock
from reliefscope.units import BoolImage, FloatImage

LEAST_CORRELATION = 0.35
"""Correlation of shadows below which a map does not fit."""
ANOTHER_SIDE = math.cos(math.radians(30.0))
"""Cosine between the azimuths of two lights below which they shine from different sides."""
LEAST_FIT = 0.5
"""Correlation of one light with the shadows of another from which it is taken for it."""
MARGIN = 0.1
"""By how much another map must fit better than the one given."""
LEAST_SHADED = 0.05
"""Share of the pairs of pixel and light, those where the light does not graze, that must be dark, and lie in a cast
shadow, for shadows to decide."""
LEAST_SHARE = 0.4
"""Share of the blocks that must agree for slopes to decide anything."""
TURN_TOLERANCE_DEG = 10.0
SCALE_TOLERANCE = 0.1
"""Relative error of z above which shadows show a fault; sound runs of seven samples showed up to 8 %.  Errors of the
heights cast shadows too, as if z were larger by their share of the relief's variance, which is therefore added: 14 to
22 % on the simulated simulants of regolith, whose gaps between grains are narrower than a matching window."""
SLOPE_SCALE_TOLERANCE = 0.2
"""The same by slopes alone, which gloss and interreflection bias by up to 10 %."""
LEVEL_TOLERANCE = 0.25
"""Relative difference of a light's level from what the others predict."""
MOST_SHARE = 0.35
"""Share of the lights above which it is the map as a whole that is wrong, not single LEDs."""
LEAST_KNOWN = 0.5
"""Share of the points at which stereo tells a height, below which the range of heights is in doubt."""
GOOD_STEREO, GOOD_NORMALS = 0.35, 0.5
"""Qualities from which pixels are compared."""
LEDS_HINT = (
    "Light one LED after the other with `reliefscope tui`, watch from where the sample is lit, correct "
    "led_positions_mm in the calibration, and reconstruct again with `--calibration FILE`."
)
VIEWS_HINT = (
    "Check the aperture map (glass_offset_mm, glass_rotation_rad, mounting of the glass) with "
    "`reliefscope tui`: the open disc must move as the picture on the screen does."
)


@dataclass(frozen=True, slots=True)
class Finding:
    """A fault that the frames show.

    Attributes
    ----------
    code:
        Stable name for programs.
    sentence:
        What it looks like.
    next_step:
        What to do about it.
    """

    code: str
    sentence: str
    next_step: str


@dataclass(frozen=True, slots=True)
class SelfCheck:
    """Figures of the comparisons, and what they show; empty findings: nothing is known to be wrong.

    Attributes
    ----------
    figures:
        Numbers by name; those of comparisons that were not possible are absent.
    findings:
        Faults, the gravest first.
    """

    figures: dict[str, Any]
    findings: tuple[Finding, ...]

    @property
    def verdict(self) -> str:
        """In one line."""
        if self.findings:
            return "; ".join(finding.sentence for finding in self.findings)
        return "no fault seen" if self.figures else "not possible with these frames"

    def as_dict(self) -> dict[str, Any]:
        """For files and ``--json``."""
        findings = [
            {"code": item.code, "sentence": item.sentence, "next_step": item.next_step}
            for item in self.findings
        ]
        return {"figures": self.figures, "findings": findings}

    @classmethod
    def from_dict(cls, content: dict[str, Any]) -> SelfCheck:
        """What :meth:`as_dict` wrote."""
        return cls(content["figures"], tuple(Finding(**item) for item in content["findings"]))


def check_result(
    *,
    height_um: FloatImage,
    normals: FloatImage,
    good: BoolImage,
    images: FloatImage,
    lights: LightField,
    light_names: Sequence[str],
    lit: BoolImage,
    pixel_um: float,
    error_share: float = 0.0,
) -> SelfCheck:
    """Compare a result with itself.

    Parameters
    ----------
    height_um:
        (H, W) stereo heights, without any that normals had a part in; NaN is missing.
    normals:
        (H, W, 3) of photometric stereo.
    good:
        (H, W) where both are of good quality.
    images:
        (L, H, W) linear intensities in the view s = 0, not divided by the lights' powers.
    lights, light_names:
        Where light comes from, and what the lights are called.
    lit:
        (L, H, W) where each light arrives over the surface (:func:`~reliefscope.reconstruction.shadows.lit`).
    pixel_um:
        Size of a pixel on the sample.
    error_share:
        Variance of the heights' errors over that of the heights.
    """
    known = np.isfinite(height_um)
    whole = np.where(known, height_um, np.float32(np.median(height_um[known])))
    slopes = compare_slopes(height_um, normals, good, pixel_um)
    shadows = compare_shadows(whole, normals, images, lights, pixel_um)
    held, faulty = _hold_out(images, lights, whole, good & lit.all(axis=0), pixel_um)
    findings = _map_findings(slopes, shadows, lights, light_names)
    if not findings:  # a wrong map has every other fault as its consequence
        findings = _scale_findings(slopes, shadows, error_share)
        if held is not None:
            findings += _level_findings(held, faulty, light_names)
    return SelfCheck(_figures(slopes, shadows, held), tuple(findings))


def check_run(
    inputs: Inputs,
    clock: StageClock,
    stereo: MvsResult,
    stereo_height_um: FloatImage,
    solved: PsResult,
    images: FloatImage,
    lit: BoolImage | None = None,
) -> SelfCheck:
    """:func:`check_result`, as a stage of a reconstruction from both methods.

    ``stereo_height_um`` (H, W) is filled where the heights of ``stereo`` were discarded; ``images`` (L, H, W) are in
    the view s = 0, divided by the relative powers of the lights; ``lit`` is worked out if left out.
    """
    with clock.timed("self-check"), clock.job.stage("self-check", 1):
        matched = inputs.with_mask(stereo.quality)
        lights, pixel_um = inputs.light_field, inputs.frames.pixel_um
        found = check_result(
            height_um=stereo_height_um,
            normals=solved.normals,
            good=(matched >= GOOD_STEREO) & (solved.quality >= GOOD_NORMALS),
            images=images,
            lights=lights,
            light_names=inputs.frames.light_names,
            lit=cast_shadows.lit(stereo_height_um, lights, pixel_um) if lit is None else lit,
            pixel_um=pixel_um,
            error_share=0.0
            if stereo.sigma_um is None
            else error_share(stereo.height_um, stereo.sigma_um, stereo.quality),
        )
    valid = np.ones(matched.shape, np.bool_) if inputs.mask is None else inputs.mask
    known = float(np.mean(matched[valid] > 0.0))
    if found.findings or known >= LEAST_KNOWN:
        return found
    return replace(found, findings=(_few_heights(known, inputs.range_um),))


def _few_heights(known: float, range_um: tuple[float, float]) -> Finding:
    return Finding(
        "few_heights",
        f"Stereo tells a height at {100 * known:.0f} % of the points only; the surface may lie outside the "
        f"{range_um[0]:g} to {range_um[1]:g} um that were searched",
        "Widen height_range_um in the settings; if heights stay unknown, check focus, exposure and texture.",
    )


def _hold_out(
    images: FloatImage,
    lights: LightField,
    height_um: FloatImage,
    good: BoolImage,
    pixel_um: float,
) -> tuple[HeldOutLights | None, list[int]]:
    """Held-out lights without those of wrong level, which are found one after the other, the worst first."""
    faulty: list[int] = []
    while True:
        held = hold_out_lights(images, lights, height_um, good, pixel_um, frozenset(faulty))
        if held is None:
            return None, []
        off = np.abs(np.log(np.maximum(held.levels, 1e-3)))
        off[faulty] = 0.0
        worst = int(np.argmax(off))
        if off[worst] <= math.log(1 + LEVEL_TOLERANCE) or len(faulty) > MOST_SHARE * len(lights):
            return held, faulty
        faulty.append(worst)


def _map_findings(
    slopes: SlopeAgreement | None,
    shadows: ShadowAgreement | None,
    lights: LightField,
    names: Sequence[str],
) -> list[Finding]:
    """What is wrong with the maps; by shadows where there are any.

    A steep side grows dark without an edge, so that shadows fit badly; slopes that agree acquit the maps.
    """
    if shadows is not None and min(shadows.dark_share, shadows.share) >= LEAST_SHADED:
        if shadows.upside_down > max(shadows.best, LEAST_CORRELATION) + MARGIN:
            return [_inverted()]
        turned = shadows.mirrored or abs(shadows.angle_deg) > TURN_TOLERANCE_DEG
        if turned and shadows.best > max(shadows.as_is + MARGIN, LEAST_CORRELATION):
            return [_wrong_map(shadows.mirrored, shadows.angle_deg)]
        displaced = _displaced_lights(shadows, lights)
        few = len(displaced) <= MOST_SHARE * len(names)
        alike = slopes is not None and slopes.share_as_is >= LEAST_SHARE
        if few and not alike and shadows.as_is < LEAST_CORRELATION:
            return [_views_disagree()]
        return _displaced_findings(displaced, names)
    if slopes is None or slopes.share < max(LEAST_SHARE, slopes.share_as_is + MARGIN):
        return []
    if slopes.mirrored or abs(slopes.angle_deg) > TURN_TOLERANCE_DEG:
        return [_wrong_map(slopes.mirrored, slopes.angle_deg)]
    return []


def _views_disagree() -> Finding:
    return Finding(
        "views_disagree",
        "The heights cast no shadow that is in the frames: the aperture map looks mirrored, turned or with its "
        "axes swapped, or the sample has too little texture or lies outside the range of heights",
        VIEWS_HINT,
    )


def _inverted() -> Finding:
    return Finding(
        "sign_wrong",
        "Heights look upside down: the aperture map looks turned by 180 degrees, or the slopes have the "
        "wrong sign",
        VIEWS_HINT,
    )


def _wrong_map(mirrored: bool, angle_deg: float) -> Finding:
    """LED map that a mirror in y, if any, and then a turn by ``angle_deg`` would put right."""
    if not mirrored:
        sense = "clockwise" if angle_deg > 0 else "counter-clockwise"
        sentence = f"LED map looks turned {sense} by {abs(angle_deg):.0f} degrees"
        return Finding("led_map_turned", sentence, LEDS_HINT)
    # a mirror in y and a turn by a is the mirror about the line at a / 2
    line = angle_deg / 2 % 180.0
    named = {
        0.0: ("led_map_mirrored_y", "LED map looks mirrored in y"),
        90.0: ("led_map_mirrored_x", "LED map looks mirrored in x"),
        45.0: ("led_map_axes_swapped", "LED map looks as if x and y were swapped"),
    }
    for direction, (code, sentence) in named.items():
        if abs((line - direction + 90.0) % 180.0 - 90.0) <= TURN_TOLERANCE_DEG:
            return Finding(code, sentence, LEDS_HINT)
    sentence = f"LED map looks mirrored about a line at {line:.0f} degrees"
    return Finding("led_map_mirrored", sentence, LEDS_HINT)


def _displaced_lights(shadows: ShadowAgreement, lights: LightField) -> dict[int, int]:
    """Lights whose dark places fit the shadows of another light from another side, and that other light."""
    own = np.diag(shadows.lights)
    best = shadows.lights.argmax(axis=1)
    fit = shadows.lights.max(axis=1)
    wrong = np.flatnonzero((fit >= LEAST_FIT) & (fit > own + MARGIN))
    level = lights.directions[:, :2]
    sides = level / np.maximum(np.linalg.norm(level, axis=1, keepdims=True), 1e-9)
    return {
        int(index): int(best[index])
        for index in wrong
        if sides[index] @ sides[best[index]] < ANOTHER_SIDE
    }


def _displaced_findings(displaced: dict[int, int], names: Sequence[str]) -> list[Finding]:
    """Single LEDs, exchanged ones, or too many to name."""
    if len(displaced) > MOST_SHARE * len(names):
        sentence = f"LED map looks scrambled: {len(displaced)} of {len(names)} lights shine from the place of another"
        return [Finding("led_map_scrambled", sentence, LEDS_HINT)]
    findings = []
    for index, place in displaced.items():
        if displaced.get(place) != index:
            sentence = (
                f"Light `{names[index]}` looks as if it were where `{names[place]}` should be"
            )
        elif index < place:
            sentence = f"Lights `{names[index]}` and `{names[place]}` look exchanged"
        else:
            continue  # told with its partner
        findings.append(Finding("light_displaced", sentence, LEDS_HINT))
    return findings


def _scale_findings(
    slopes: SlopeAgreement | None, shadows: ShadowAgreement | None, error_share: float
) -> list[Finding]:
    """Scale of z, by shadows where there are any."""
    if shadows is not None and shadows.scale_correlation >= LEAST_CORRELATION:
        excess, tolerance = 1.0 / shadows.scale - 1.0, SCALE_TOLERANCE
    elif slopes is not None and slopes.share >= LEAST_SHARE:
        excess, tolerance = slopes.scale - 1.0, SLOPE_SCALE_TOLERANCE
    else:
        return []
    if abs(excess) <= tolerance + error_share:
        return []
    return [
        Finding(
            "z_scale",
            f"z scale looks {100 * abs(excess):.0f} % too {'high' if excess > 0 else 'low'}",
            "Calibrate it with a stage (`reliefscope calibrate z`), or correct pupil_scale in the "
            "calibration, and reconstruct again with `--calibration FILE`.",
        )
    ]


def _level_findings(held: HeldOutLights, faulty: list[int], names: Sequence[str]) -> list[Finding]:
    """Single LEDs that are weaker or stronger than their calibration says."""
    if len(faulty) > MOST_SHARE * len(names):
        return []  # Lambert's law does not hold, or the map is wrong, which others tell
    return [
        Finding(
            "light_level",
            f"Light `{names[index]}` looks {100 * held.levels[index]:.0f} % as bright as the others predict",
            "Check its LED and its level in led_intensities; leave it out of the plan if it is broken.",
        )
        for index in sorted(faulty)
    ]


def _figures(
    slopes: SlopeAgreement | None,
    shadows: ShadowAgreement | None,
    held: HeldOutLights | None,
) -> dict[str, Any]:
    figures: dict[str, Any] = {}
    if slopes is not None:
        figures |= {
            "slope_matrix": np.round(slopes.matrix, 4).tolist(),
            "slope_scale": round(slopes.scale, 4),
            "slope_turn_deg": round(slopes.angle_deg, 2),
            "slope_mirrored": slopes.mirrored,
            "slope_share": round(slopes.share, 4),
            "slope_share_as_is": round(slopes.share_as_is, 4),
            "slope_blocks": slopes.blocks,
        }
    if shadows is not None:
        figures |= {
            "shadow_correlation": round(shadows.as_is, 4),
            "shadow_correlation_best": round(shadows.best, 4),
            "shadow_turn_deg": round(shadows.angle_deg, 2),
            "shadow_mirrored": shadows.mirrored,
            "shadow_z_scale": round(1.0 / shadows.scale, 4),
            "shadow_z_correlation": round(shadows.scale_correlation, 4),
            "shadow_share": round(shadows.share, 4),
            "shadow_dark_share": round(shadows.dark_share, 4),
        }
    if held is not None:
        figures |= {
            "held_out_error": round(held.error, 4),
            "held_out_levels": np.round(held.levels, 3).tolist(),
        }
    return figures
