"""The method ``paper``: section III of the paper, stage by stage.

1. Views for matching: the mean of each view over all lights, of equal gain.  These are luminances; a raw
   mosaic is never matched, because its pattern agrees with itself at zero parallax.
2. Multi-view stereo; heights of low quality are discarded; robust smoothing fills and cleans them.
3. Frames are brought to the view s = 0 by the smoothed height, and averaged over the views, light by light.
4. Photometric stereo; normals of low quality are discarded.
5. Fusion.

With one view there is no stereo, and the normals are integrated; with one light there is stereo only.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numba import njit, prange
from numpy.typing import NDArray

from reliefscope.errors import InvalidInputError
from reliefscope.reconstruction import fusion, mvs, photometric, registration, smoothing
from reliefscope.reconstruction.assembly import assembled
from reliefscope.reconstruction.channel_means import ChannelMeans, read_channel_means
from reliefscope.reconstruction.inputs import Inputs, refuse_undefined
from reliefscope.reconstruction.result import Reconstruction
from reliefscope.reconstruction.saturation import saturated_points
from reliefscope.reconstruction.self_check import SelfCheck, check_run
from reliefscope.reconstruction.stage_clock import StageClock
from reliefscope.units import FloatImage


def reconstruct_by_paper(
    inputs: Inputs, clock: StageClock, micrograph: FloatImage | None
) -> Reconstruction:
    """Surface, normals and albedo; see :func:`reliefscope.reconstruction.pipeline.reconstruct`."""
    settings = inputs.settings.paper
    figures: dict[str, float] = {}
    stereo: mvs.MvsResult | None = None
    smoothed: FloatImage | None = None
    means: ChannelMeans | None = None
    check: SelfCheck | None = None
    if inputs.stereo:
        means = read_channel_means(inputs, [list(range(inputs.light_count))], clock)
        if micrograph is None:
            micrograph = means.micrograph(inputs.nearest)
        stereo = _match(inputs, means.images[0], clock)
        smoothed, figures["smoothing_parameter"] = _smooth(inputs, stereo, clock)
    solved: photometric.PsResult | None = None
    if inputs.photometric:
        images = _registered(inputs, means, smoothed, clock)
        if micrograph is None:
            micrograph = images.mean(axis=0)
        with clock.timed("photometric stereo"), clock.job.stage("photometric stereo", 1):
            full_scale = settings.full_scale or photometric.full_scale_of(images)
            figures["full_scale"] = full_scale
            solved = photometric.solve_lambert(images, inputs.directions, full_scale=full_scale)
        if stereo is not None and smoothed is not None:
            check = check_run(inputs, clock, stereo, smoothed, solved, images)
        del images
    del means
    saturated = saturated_points(inputs, smoothed, clock)
    with clock.timed("fuse"):
        height, kind = _surface(inputs, stereo, smoothed, solved, clock, figures)
    result = assembled(
        inputs,
        clock,
        height_um=height,
        kind=kind,
        stereo=stereo,
        solved=solved,
        micrograph=micrograph,
        saturated=saturated,
        check=check,
        figures=figures,
    )
    return replace(result, smoothed_height_um=smoothed)


def _match(inputs: Inputs, views: FloatImage, clock: StageClock) -> mvs.MvsResult:
    settings = inputs.settings.paper
    low, high = inputs.range_um
    count = round((high - low) / settings.height_step_um) + 1
    heights = low + settings.height_step_um * np.arange(max(count, 3), dtype=np.float64)
    with clock.timed("match"):
        result = mvs.match_views(
            views,
            inputs.slopes,
            heights,
            inputs.frames.pixel_um,
            settings.window,
            clock.job,
            parabola=settings.parabola,
        )
        if inputs.mask is not None:
            result.quality[~inputs.mask] = 0.0
    return result


def _smooth(inputs: Inputs, stereo: mvs.MvsResult, clock: StageClock) -> tuple[FloatImage, float]:
    """Heights with those of low quality filled, and the parameter of the smoothing."""
    settings = inputs.settings.paper
    with clock.timed("smooth"):
        accepted = stereo.accepted(settings.stereo_quality)
        if accepted.sum() < 3:
            raise InvalidInputError(
                f"No height reaches the quality of {settings.stereo_quality:g}.",
                hint="Check focus, exposure and the range of heights; look at a frame.",
            )
        smoothed = smoothing.smooth_robust(
            np.where(accepted, stereo.height_um, np.float32(np.nan)),
            np.where(accepted, stereo.quality, np.float32(0)),
            parameter=settings.smoothing_parameter,
            resolution=settings.height_step_um,
            job=clock.job,
        )
    return smoothed.values, smoothed.parameter


def _registered(
    inputs: Inputs, means: ChannelMeans | None, height_um: FloatImage | None, clock: StageClock
) -> FloatImage:
    """Mean over the views (L, H, W) in the view s = 0, of lights of equal power; one view without height."""
    run = inputs.frames
    views = [inputs.nearest] if height_um is None else list(range(inputs.view_count))
    gains = np.ones(inputs.view_count) if means is None else means.gains
    out = np.empty((inputs.light_count, *run.shape), np.float32)
    with clock.timed("register"), clock.job.stage("register", inputs.light_count) as stage:
        for light, power in enumerate(inputs.relative_powers):
            frames = np.stack([image.copy() for _, _, image in run.stack(views, [light])])
            frames *= gains[views].astype(np.float32)[:, None, None]
            if height_um is not None:
                frames = registration.to_reference(
                    frames, inputs.slopes[views], height_um, run.pixel_um
                )
            mean_of_known(frames, 1.0 / float(power), out[light])
            if height_um is None:
                level = float(out[light].mean(dtype=np.float64))
                refuse_undefined(level, f"light {run.light_names[light]}")
            stage.advance()
    return out


def _surface(
    inputs: Inputs,
    stereo: mvs.MvsResult | None,
    smoothed: FloatImage | None,
    solved: photometric.PsResult | None,
    clock: StageClock,
    figures: dict[str, float],
) -> tuple[FloatImage, str]:
    settings = inputs.settings.paper
    if solved is None:
        assert smoothed is not None  # one of the two methods was run
        return smoothed, "stereo"
    q_ps: NDArray[np.float32] = inputs.with_mask(
        np.where(solved.quality >= settings.photometric_quality, solved.quality, np.float32(0))
    )
    if stereo is None or smoothed is None:
        fused = fusion.integrate(
            solved.normals,
            q_ps,
            inputs.frames.pixel_um,
            derivative=settings.derivative,
            tolerance_um=settings.tolerance_um,
            job=clock.job,
        )
        kind = "integrated"
    else:
        accepted = stereo.accepted(settings.stereo_quality)
        fused = fusion.fuse(
            smoothed,
            np.where(accepted, stereo.quality, 0.0),
            solved.normals,
            q_ps,
            inputs.frames.pixel_um,
            lam=settings.lam,
            derivative=settings.derivative,
            minimum_quality=settings.minimum_quality,
            tolerance_um=settings.tolerance_um,
            job=clock.job,
        )
        kind = "fused"
    figures["solver_iterations"] = fused.iterations
    figures["solver_error_um"] = fused.error_um
    return fused.height_um, kind


@njit(cache=True, parallel=True)
def mean_of_known(frames: FloatImage, factor: float, out: FloatImage) -> None:
    """``factor`` times the mean over the frames (K, H, W) that are not NaN; NaN where all are."""
    count, height, width = frames.shape
    for row in prange(height):
        for column in range(width):
            total = 0.0
            known = 0
            for k in range(count):
                value = frames[k, row, column]
                if not np.isnan(value):
                    total += value
                    known += 1
            out[row, column] = factor * total / known if known > 0 else np.nan
