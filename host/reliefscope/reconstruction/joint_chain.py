"""The method ``joint``: the default.

1. Every frame is read once.  For matching, each view is averaged over groups of lights; for registration the
   frames are kept, or read again where they take more memory than allowed.
2. Joint matching over the groups (:mod:`~reliefscope.reconstruction.joint`); heights of low quality are
   discarded and filled by robust smoothing.
3. Frames are brought to the view s = 0 by the height, and averaged over the views that see the point, light by
   light.
4. Photometric stereo with near lights, without the lights that the height puts into shadow, robust against
   highlights.
5. Fusion.

With one view there is no stereo, and the normals are integrated; with one light there is stereo only.
"""

from __future__ import annotations

import numpy as np

from reliefscope.errors import InvalidInputError
from reliefscope.reconstruction import fusion, joint, photometric, registration, shadows, smoothing
from reliefscope.reconstruction.channel_means import ChannelMeans, read_channel_means
from reliefscope.reconstruction.inputs import Inputs, refuse_undefined
from reliefscope.reconstruction.mvs import MvsResult
from reliefscope.reconstruction.result import Reconstruction
from reliefscope.reconstruction.self_check import SelfCheck, check_run
from reliefscope.reconstruction.stage_clock import StageClock, peak_memory_mb
from reliefscope.reconstruction.view_average import ViewAverage
from reliefscope.units import FloatImage


def reconstruct_jointly(
    inputs: Inputs, clock: StageClock, micrograph: FloatImage | None
) -> Reconstruction:
    """Surface, normals and albedo; see :func:`reliefscope.reconstruction.pipeline.reconstruct`."""
    settings = inputs.settings.joint
    figures: dict[str, float] = {}
    stereo: MvsResult | None = None
    filled: FloatImage | None = None
    means: ChannelMeans | None = None
    check: SelfCheck | None = None
    if inputs.stereo:
        means = read_channel_means(
            inputs,
            joint.light_groups(inputs.frames.lights, inputs.light_count),
            clock,
            keep=inputs.photometric and inputs.frames_mb() <= inputs.settings.frames_in_memory_mb,
        )
        if micrograph is None:
            micrograph = means.micrograph(inputs.nearest)
        stereo = _match(inputs, means.images, clock)
        filled = _fill(inputs, stereo, clock)
    solved: photometric.PsResult | None = None
    if inputs.photometric:
        images = (
            _nearest_view(inputs, clock)
            if means is None or filled is None
            else _registered(inputs, means, filled, clock)
        )
        if micrograph is None:
            micrograph = images.mean(axis=0)
        lights, pixel_um = inputs.light_field, inputs.frames.pixel_um
        usable = None
        if filled is not None and settings.shadows:
            with clock.timed("shadows"):
                usable = shadows.lit(filled, lights, pixel_um, job=clock.job)
        with clock.timed("photometric stereo"), clock.job.stage("photometric stereo", 1):
            solved = photometric.solve(images, lights, pixel_um, usable=usable)
        if stereo is not None and filled is not None:
            check = check_run(inputs, clock, stereo, filled, solved, images, usable)
        del images
    del means
    with clock.timed("fuse"):
        height, kind = _surface(inputs, stereo, filled, solved, clock, figures)
    if inputs.mask is not None:
        height = np.where(inputs.mask, height, np.float32(np.nan))
    return Reconstruction(
        height_um=height,
        pixel_um=inputs.frames.pixel_um,
        settings=inputs.settings,
        kind=kind,
        stereo_height_um=stereo.height_um if stereo else None,
        stereo_quality=stereo.quality if stereo else None,
        smoothed_height_um=filled,
        normals=solved.normals if solved else None,
        albedo=solved.albedo if solved else None,
        photometric_quality=solved.quality if solved else None,
        residual=solved.residual if solved else None,
        micrograph=micrograph,
        valid=inputs.mask,
        self_check=check,
        figures=figures,
        timings_s=clock.timings_s,
        peak_memory_mb=peak_memory_mb(),
    )


def _match(inputs: Inputs, channels: FloatImage, clock: StageClock) -> MvsResult:
    with clock.timed("match"):
        result = joint.match_jointly(
            channels, inputs.slopes, inputs.range_um, inputs.frames.pixel_um, clock.job
        )
        if inputs.mask is not None:
            result.quality[~inputs.mask] = 0.0
    return result


def _fill(inputs: Inputs, stereo: MvsResult, clock: StageClock) -> FloatImage:
    """Heights (H, W) with those of low quality filled."""
    threshold = inputs.settings.joint.stereo_quality
    with clock.timed("smooth"):
        accepted = stereo.accepted(threshold)
        if accepted.sum() < 3:
            raise InvalidInputError(
                f"No height reaches the quality of {threshold:g}.",
                hint="Check focus, exposure and the range of heights; look at a frame.",
            )
        return smoothing.smooth_robust(
            np.where(accepted, stereo.height_um, np.float32(np.nan)),
            np.where(accepted, stereo.quality, np.float32(0)),
            resolution=1.0,
            job=clock.job,
        ).values


def _nearest_view(inputs: Inputs, clock: StageClock) -> FloatImage:
    """Frames (L, H, W) of the view nearest to s = 0 as they are, of lights of equal power."""
    run, view = inputs.frames, inputs.nearest
    images = np.empty((inputs.light_count, *run.shape), np.float32)
    with clock.timed("read frames"), clock.job.stage("read frames", len(images)) as stage:
        for _, light, image in run.stack([view]):
            level = float(image.mean(dtype=np.float64))
            refuse_undefined(level, f"light {run.light_names[light]}")
            np.divide(image, np.float32(inputs.relative_powers[light]), out=images[light])
            stage.advance()
    return images


def _registered(
    inputs: Inputs, means: ChannelMeans, height_um: FloatImage, clock: StageClock
) -> FloatImage:
    """Mean over the views (L, H, W) in the view s = 0, of lights of equal power."""
    run = inputs.frames
    visible = None
    if inputs.settings.joint.occlusion:
        with clock.timed("visibility"):
            visible = registration.visibility(height_um, inputs.slopes, run.pixel_um, job=clock.job)
    average = ViewAverage(height_um, run.pixel_um, inputs.light_count)
    with clock.timed("register"), clock.job.stage("register", inputs.view_count) as stage:
        for view, (sx, sy) in enumerate(inputs.slopes):
            average.add(
                _frames(inputs, means, view),
                (float(sx), float(sy)),
                float(means.gains[view]),
                None if visible is None else visible[view],
            )
            stage.advance()
        return average.mean(1.0 / inputs.relative_powers)


def _frames(inputs: Inputs, means: ChannelMeans, view: int) -> FloatImage:
    """Frames (L, H, W) of one view, as read."""
    if means.kept is not None:
        kept: FloatImage = means.kept[view]
        return kept
    return np.stack([image for _, _, image in inputs.frames.stack([view])])


def _surface(
    inputs: Inputs,
    stereo: MvsResult | None,
    filled: FloatImage | None,
    solved: photometric.PsResult | None,
    clock: StageClock,
    figures: dict[str, float],
) -> tuple[FloatImage, str]:
    settings, pixel_um = inputs.settings.joint, inputs.frames.pixel_um
    if solved is None:
        assert filled is not None  # one of the two methods was run
        return filled, "stereo"
    q_ps = inputs.with_mask(
        np.where(solved.quality >= settings.photometric_quality, solved.quality, np.float32(0))
    )
    if stereo is None or filled is None:
        fused = fusion.integrate(
            solved.normals, q_ps, pixel_um, tolerance_um=settings.tolerance_um, job=clock.job
        )
        kind = "integrated"
    else:
        q_mvs = np.where(stereo.accepted(settings.stereo_quality), stereo.quality, 0.0)
        fused = fusion.fuse(
            filled,
            q_mvs,
            solved.normals,
            q_ps,
            pixel_um,
            tolerance_um=settings.tolerance_um,
            job=clock.job,
        )
        kind = "fused"
    figures["solver_iterations"] = fused.iterations
    figures["solver_error_um"] = fused.error_um
    return fused.height_um, kind
