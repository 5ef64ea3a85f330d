"""The method ``joint``: the default.

1. Each view is averaged over groups of lights for matching.  No frame is kept: for registration all are read again.
2. Joint matching over the groups (:mod:`~reliefscope.reconstruction.joint`); heights of low quality are
   discarded, and filled from their surroundings for the steps in between.
3. Frames are brought to the view s = 0 by the height, and averaged over the views that see the point, light by
   light.
4. Photometric stereo with near lights, without the lights that the height puts into shadow, robust against
   highlights.
5. Comparison of the result with itself (:mod:`~reliefscope.reconstruction.self_check`).
6. Fusion of heights and normals by their standard errors (:mod:`~reliefscope.reconstruction.joint_fusion`).
7. On demand, the albedo in colour, from the view nearest to s = 0 (:mod:`~reliefscope.reconstruction.colour`).

With one view there is no stereo, and the normals are integrated; with one light there is stereo only, and robust
smoothing fills and cleans the heights.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from reliefscope.errors import InvalidInputError
from reliefscope.reconstruction import (
    fusion,
    joint,
    joint_fusion,
    photometric,
    registration,
    shadows,
)
from reliefscope.reconstruction.assembly import assembled
from reliefscope.reconstruction.channel_means import ChannelMeans, read_channel_means
from reliefscope.reconstruction.colour import colour_albedo
from reliefscope.reconstruction.filling import fill_heights
from reliefscope.reconstruction.inputs import Inputs, refuse_undefined
from reliefscope.reconstruction.matching_error import knows_nothing_um
from reliefscope.reconstruction.mvs import MvsResult
from reliefscope.reconstruction.result import Reconstruction
from reliefscope.reconstruction.saturation import blank_saturated, saturated_points
from reliefscope.reconstruction.self_check import SelfCheck, check_run
from reliefscope.reconstruction.stage_clock import StageClock
from reliefscope.reconstruction.view_average import ViewAverage
from reliefscope.reconstruction.view_frames import unsaturated_views
from reliefscope.units import BoolImage, FloatImage


@dataclass(frozen=True)
class _Stereo:
    """Heights as matched, where they are accepted (H, W), and heights (H, W) without gaps."""

    matched: MvsResult
    accepted: BoolImage
    filled_um: FloatImage


@dataclass(frozen=True)
class _Shading:
    """Images (L, H, W) in the view s = 0, where each light arrives (None: unknown), and the normals from them."""

    images: FloatImage
    lit: BoolImage | None
    solved: photometric.PsResult


def reconstruct_jointly(
    inputs: Inputs, clock: StageClock, micrograph: FloatImage | None
) -> Reconstruction:
    """Surface, normals and albedo; see :func:`reliefscope.reconstruction.pipeline.reconstruct`."""
    figures: dict[str, float] = {}
    stereo: _Stereo | None = None
    shading: _Shading | None = None
    check: SelfCheck | None = None
    saturated: BoolImage
    gains = np.ones(inputs.view_count)
    if inputs.stereo:
        means = _read(inputs, clock)
        if micrograph is None:
            micrograph = means.micrograph(inputs.nearest)
        stereo = _matched(inputs, means.images, clock)
        if inputs.photometric:
            gains = means.gains
            del means  # its images are the largest array of all
            images, saturated = _registered(inputs, gains, stereo.filled_um, clock)
            shading = _solved(inputs, images, stereo.filled_um, clock)
            check = check_run(
                inputs,
                clock,
                stereo.matched,
                np.where(stereo.accepted, stereo.matched.height_um, stereo.filled_um),
                shading.solved,
                shading.images,
                shading.lit,
            )
        else:
            saturated = saturated_points(inputs, stereo.filled_um, clock)
    else:
        images = _nearest_view(inputs, clock)
        if micrograph is None:
            micrograph = images.mean(axis=0)
        blank_saturated(images, inputs.frames, inputs.nearest)
        saturated = np.isnan(images.sum(axis=0))
        images /= inputs.relative_powers.astype(np.float32)[:, None, None]
        shading = _solved(inputs, images, None, clock)
    if micrograph is None:
        assert shading is not None  # one of the two methods was run
        micrograph = shading.images.mean(axis=0)
    height, sigma, kind = _surface(inputs, stereo, shading, clock, figures)
    albedo_rgb = None
    if shading is not None and inputs.settings.joint.colour and inputs.frames.in_colour:
        albedo_rgb = _in_colour(inputs, gains, height if stereo else None, shading.solved, clock)
    solved = shading.solved if shading else None
    result = assembled(
        inputs,
        clock,
        height_um=height,
        kind=kind,
        stereo=stereo.matched if stereo else None,
        solved=solved,
        micrograph=micrograph,
        saturated=saturated,
        check=check,
        figures=figures,
    )
    return replace(
        result,
        sigma_um=sigma,
        stereo_accepted=stereo.accepted if stereo else None,
        normal_sigma_rad=solved.sigma_rad if solved else None,
        albedo_rgb=albedo_rgb,
        lights_used=solved.lights_used if solved else None,
    )


def _read(inputs: Inputs, clock: StageClock) -> ChannelMeans:
    return read_channel_means(
        inputs,
        joint.light_groups(inputs.frames.lights, inputs.light_count),
        clock,
    )


def _matched(inputs: Inputs, channels: FloatImage, clock: StageClock) -> _Stereo:
    threshold = inputs.settings.joint.stereo_quality
    with clock.timed("match"):
        matched = joint.match_jointly(
            channels,
            inputs.slopes,
            inputs.range_um,
            inputs.frames.pixel_um,
            clock.job,
            telecentricity_per_um=inputs.frames.telecentricity_per_um,
        )
        if inputs.mask is not None:
            matched.quality[~inputs.mask] = 0.0
        accepted = matched.accepted(threshold)
        if accepted.sum() < 3:
            raise InvalidInputError(
                f"No height reaches the quality of {threshold:g}.",
                hint="Check focus, exposure and the range of heights; look at a frame.",
            )
        if inputs.photometric:
            assert matched.sigma_um is not None  # joint matching tells it
            sigma_um = np.where(accepted, matched.sigma_um, np.float32(np.inf))
            filled_um = fill_heights(matched.height_um, sigma_um, job=clock.job)
            return _Stereo(matched, accepted, filled_um)
    # imported here because SciPy, which only a single light needs, takes longer to import than some stages to run
    from reliefscope.reconstruction import smoothing

    with clock.timed("smooth"):
        trust = np.where(accepted, matched.quality, np.float32(0))
        known = np.where(accepted, matched.height_um, np.float32(np.nan))
        smoothed = smoothing.smooth_robust(known, trust, resolution=1.0, job=clock.job)
    return _Stereo(matched, accepted, smoothed.values)


def _solved(
    inputs: Inputs, images: FloatImage, height_um: FloatImage | None, clock: StageClock
) -> _Shading:
    lights, pixel_um = inputs.light_field, inputs.frames.pixel_um
    lit = None
    if height_um is not None:
        with clock.timed("shadows"):
            lit = shadows.lit(height_um, lights, pixel_um, job=clock.job)
    with clock.timed("photometric stereo"), clock.job.stage("photometric stereo", 1):
        known = lit if inputs.settings.joint.shadows else None
        solved = photometric.solve(images, lights, pixel_um, lit=known)
        if inputs.mask is not None:
            solved.quality[~inputs.mask] = 0.0
    return _Shading(images, lit, solved)


def _nearest_view(inputs: Inputs, clock: StageClock) -> FloatImage:
    """Frames (L, H, W) of the view nearest to s = 0 as they are."""
    run, view = inputs.frames, inputs.nearest
    images = np.empty((inputs.light_count, *run.shape), np.float32)
    with clock.timed("read frames"), clock.job.stage("read frames", len(images)) as stage:
        for _, light, image in run.stack([view]):
            level = float(image.mean(dtype=np.float64))
            refuse_undefined(level, f"light {run.light_names[light]}")
            images[light] = image
            stage.advance()
    return images


def _registered(
    inputs: Inputs, gains: NDArray[np.float64], height_um: FloatImage, clock: StageClock
) -> tuple[FloatImage, BoolImage]:
    """Mean over the views (L, H, W) in the view s = 0, of lights of equal power; points (H, W) saturated in a frame."""
    run = inputs.frames
    visible = None
    if inputs.settings.joint.occlusion:
        with clock.timed("visibility"):
            visible = registration.visibility(
                height_um,
                inputs.slopes,
                run.pixel_um,
                telecentricity_per_um=run.telecentricity_per_um,
                job=clock.job,
            )
    average = ViewAverage(height_um, run.pixel_um, inputs.light_count, run.telecentricity_per_um)
    with clock.timed("register"), clock.job.stage("register", inputs.view_count) as stage:
        for view, frames in unsaturated_views(inputs):
            sx, sy = inputs.slopes[view]
            average.add(
                frames,
                (float(sx), float(sy)),
                float(gains[view]),
                None if visible is None else visible[view],
            )
            stage.advance()
        return average.mean(1.0 / inputs.relative_powers), average.incomplete


def _in_colour(
    inputs: Inputs,
    gains: NDArray[np.float64],
    height_um: FloatImage | None,
    solved: photometric.PsResult,
    clock: StageClock,
) -> FloatImage:
    """Albedo (H, W, 3) from the view nearest to s = 0; ``height_um`` None: it is there."""
    view = inputs.nearest
    sx, sy = inputs.slopes[view]
    with clock.timed("colour"):
        return colour_albedo(
            inputs.frames,
            view,
            (float(sx), float(sy)),
            float(gains[view]),
            height_um,
            inputs.light_field.scaled(inputs.relative_powers),
            solved,
            clock.job,
        )


def _surface(
    inputs: Inputs,
    stereo: _Stereo | None,
    shading: _Shading | None,
    clock: StageClock,
    figures: dict[str, float],
) -> tuple[FloatImage, FloatImage | None, str]:
    """Height (H, W), its standard error where it is known, and what it was made from."""
    pixel_um = inputs.frames.pixel_um
    guess_um = np.float32(knows_nothing_um(inputs.range_um))
    if shading is None:
        assert stereo is not None  # one of the two methods was run
        assert stereo.matched.sigma_um is not None  # joint matching tells it
        return stereo.filled_um, np.fmin(stereo.matched.sigma_um, guess_um), "stereo"
    solved = shading.solved
    with clock.timed("fuse"):
        if stereo is None:
            trusted = solved.quality >= inputs.settings.joint.photometric_quality
            weight = np.where(trusted, solved.quality, np.float32(0))
            integrated = fusion.integrate(solved.normals, weight, pixel_um, job=clock.job)
            figures["solver_iterations"] = integrated.iterations
            figures["solver_error_um"] = integrated.error_um
            return integrated.height_um, None, "integrated"
        assert stereo.matched.sigma_um is not None  # joint matching tells it
        assert solved.sigma_rad is not None  # the robust form tells it
        none = np.float32(np.inf)
        fused = joint_fusion.fuse_robust(
            stereo.matched.height_um,
            np.where(stereo.accepted, stereo.matched.sigma_um, none),
            solved.normals,
            np.where(np.isfinite(solved.normals).all(axis=-1), solved.sigma_rad, none),
            pixel_um,
            images=np.nan_to_num(shading.images, copy=False),
            job=clock.job,
        )
    figures["solver_iterations"] = fused.iterations
    figures["solver_error_um"] = fused.error_um
    return fused.height_um, np.fmin(fused.sigma_um, guess_um), "fused"
