"""From a run to a surface: section III of the paper, stage by stage.

1. Views for matching: the mean of each view over the lights (joint matching: over each group of lights), of
   equal gain.  These are luminances; a raw mosaic is never matched, because its pattern agrees with itself
   at zero parallax.
2. Multi-view stereo; heights of low quality are discarded; robust smoothing fills and cleans them.
3. Frames are brought to the view s = 0 by the smoothed height, and averaged over the views, light by light.
4. Photometric stereo; normals of low quality are discarded.
5. Fusion.

With one view there is no stereo, and the normals are integrated; with one light there is stereo only.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import Protocol

import numpy as np
import psutil
from numba import njit, prange
from numpy.typing import NDArray

from reliefscope.errors import InvalidInputError
from reliefscope.jobs import Job, ensure_job
from reliefscope.reconstruction import fusion, joint, mvs, photometric, registration, smoothing
from reliefscope.reconstruction.result import Reconstruction
from reliefscope.reconstruction.settings import Settings
from reliefscope.units import BoolImage, FloatImage


class Frames(Protocol):
    """What a reconstruction reads; :class:`reliefscope.dataset.Run` has it all."""

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns of a frame."""

    @property
    def pixel_um(self) -> float:
        """Size of a pixel on the sample."""

    @property
    def height_range_um(self) -> tuple[float, float] | None:
        """Heights worth searching, where known."""

    @property
    def view_names(self) -> tuple[str, ...]:
        """Names of the views."""

    @property
    def light_names(self) -> tuple[str, ...]:
        """Names of the lights."""

    @property
    def views(self) -> NDArray[np.float64] | None:
        """Slopes (K, 2), y up; None where one is unknown."""

    @property
    def lights(self) -> NDArray[np.float64] | None:
        """Directions (L, 3) toward the lights; None where one is unknown."""

    @property
    def powers(self) -> NDArray[np.float64]:
        """Brightness (L,) of the lights relative to each other."""

    @property
    def mask(self) -> BoolImage | None:
        """Valid pixels (H, W); None: all."""

    def stack(
        self, views: Iterable[int] | None = None, lights: Iterable[int] | None = None
    ) -> Iterator[tuple[int, int, FloatImage]]:
        """(view, light, linear luminance (H, W)) of every pair."""


def reconstruct(
    run: Frames,
    settings: Settings | None = None,
    job: Job | None = None,
    *,
    micrograph: FloatImage | None = None,
) -> Reconstruction:
    """Surface, normals and albedo of a run; touches no file but the run's frames.

    Parameters
    ----------
    run:
        Frames and geometry.
    settings:
        Defaults to the method ``paper``.
    job:
        Progress per stage, and cancellation.
    micrograph:
        (H, W) luminance to keep with the result; the mean of the view nearest to s = 0 if left out.

    Raises
    ------
    InvalidInputError
        Too few or badly spread lights, views without a baseline, unknown geometry, frames with NaN,
        no range of heights, or neither two views nor two lights.
    """
    return _Pipeline(run, settings or Settings(), ensure_job(job)).result(micrograph)


class _Pipeline:
    """Inputs that were checked, and the time that each stage took."""

    def __init__(self, run: Frames, settings: Settings, job: Job) -> None:
        self._run = run
        self._settings = settings
        self._job = job
        self._timings: dict[str, float] = {}
        views, lights = len(run.view_names), len(run.light_names)
        self._stereo = settings.use == "stereo" or (settings.use == "auto" and views > 1)
        self._photometric = settings.use == "photometric" or (settings.use == "auto" and lights > 1)
        if not self._stereo and not self._photometric:
            raise InvalidInputError(
                "One view under one light tells nothing about height.",
                hint="Take at least two views, or at least three lights.",
            )
        # everything that can be refused is refused before a frame is read
        self._slopes = self._checked_slopes() if self._stereo else _or_zero(run.views, views)
        self._heights = self._candidates() if self._stereo else np.zeros(0)
        self._directions = self._checked_directions() if self._photometric else np.zeros((0, 3))
        self._mask = run.mask
        size = views * lights * run.shape[0] * run.shape[1] * 4
        self._kept: dict[tuple[int, int], FloatImage] | None = (
            {} if self._stereo and size <= settings.frames_in_memory_mb * 1e6 else None
        )
        self._gains = np.ones(views)

    def result(self, micrograph: FloatImage | None) -> Reconstruction:
        """Run the stages."""
        run, settings = self._run, self._settings
        figures: dict[str, float] = {}
        stereo: mvs.MvsResult | None = None
        smoothed: FloatImage | None = None
        if self._stereo:
            channels, shares = self._channel_means()
            if micrograph is None:
                micrograph = np.tensordot(shares, channels[:, self._nearest()], axes=1)
            stereo = self._match(channels)
            del channels
            smoothed, figures["smoothing_parameter"] = self._smooth(stereo)
        solved: photometric.PsResult | None = None
        if self._photometric:
            images = self._registered(smoothed)
            if micrograph is None:
                micrograph = images.mean(axis=0)
            with self._timed("photometric stereo"), self._job.stage("photometric stereo", 1):
                full_scale = settings.full_scale or photometric.full_scale_of(images)
                figures["full_scale"] = full_scale
                solved = photometric.solve_lambert(
                    images, self._directions, trim=settings.trim, full_scale=full_scale
                )
            del images
        self._kept = None
        with self._timed("fuse"):
            height, kind = self._surface(stereo, smoothed, solved, figures)
        if self._mask is not None:
            height = np.where(self._mask, height, np.float32(np.nan))
        return Reconstruction(
            height_um=height,
            pixel_um=run.pixel_um,
            settings=settings,
            kind=kind,
            stereo_height_um=stereo.height_um if stereo else None,
            stereo_quality=stereo.quality if stereo else None,
            smoothed_height_um=smoothed,
            normals=solved.normals if solved else None,
            albedo=solved.albedo if solved else None,
            photometric_quality=solved.quality if solved else None,
            residual=solved.residual if solved else None,
            micrograph=micrograph,
            valid=self._mask,
            figures=figures,
            timings_s=self._timings,
            peak_memory_mb=peak_memory_mb(),
        )

    def _checked_slopes(self) -> NDArray[np.float64]:
        slopes = self._run.views
        if slopes is None:
            raise InvalidInputError(
                "The slope of a view is not known, so parallax cannot be turned into height.",
                hint=f"Give `slope: [sx, sy]` for every view{self._or_photometric()}.",
            )
        if len(slopes) < 2:
            raise InvalidInputError(
                "Stereo needs at least two views; there is one.",
                hint=f"Take more views{self._or_photometric()}.",
            )
        return slopes

    def _checked_directions(self) -> NDArray[np.float64]:
        directions = self._run.lights
        if directions is None:
            raise InvalidInputError(
                "The direction of a light is not known, so shading cannot be turned into slope.",
                hint=f"Give `direction: [x, y, z]` for every light{self._or_stereo()}.",
            )
        if len(directions) < 3:
            raise InvalidInputError(
                f"Photometric stereo needs at least 3 lights; there are {len(directions)}.",
                hint=f"Take the sample under more lights{self._or_stereo()}.",
            )
        directions = photometric.check_directions(directions)
        if self._settings.trim is not None:
            photometric.kept_ranks(len(directions), self._settings.trim)
        return directions

    def _or_stereo(self) -> str:
        """The other way out, where the views allow it."""
        possible = len(self._run.view_names) > 1 and self._run.views is not None
        return ", or reconstruct with `use: stereo` in a settings file" if possible else ""

    def _or_photometric(self) -> str:
        """The other way out, where the lights allow it."""
        possible = len(self._run.light_names) > 2 and self._run.lights is not None
        return ", or reconstruct with `use: photometric` in a settings file" if possible else ""

    def _candidates(self) -> NDArray[np.float64]:
        span = self._settings.height_range_um or self._run.height_range_um
        if span is None:
            raise InvalidInputError(
                "There is no range of heights to search.",
                hint="Give `height_range_um: [lowest, highest]` in the import file or the settings.",
            )
        count = round((span[1] - span[0]) / self._settings.height_step_um) + 1
        steps = np.arange(max(count, 3), dtype=np.float64)
        return np.asarray(span[0] + self._settings.height_step_um * steps)

    def _nearest(self) -> int:
        """View whose slope is nearest to zero."""
        return int(np.argmin(np.linalg.norm(self._slopes, axis=1)))

    @contextmanager
    def _timed(self, stage: str) -> Iterator[None]:
        self._job.check()
        begun = time.perf_counter()
        yield
        self._timings[stage] = self._timings.get(stage, 0.0) + time.perf_counter() - begun

    def _channel_means(self) -> tuple[FloatImage, FloatImage]:
        """Mean over each group of lights of every view (C, K, H, W), of equal mean; shares (C,) of the lights."""
        views, lights = len(self._run.view_names), len(self._run.light_names)
        groups = (
            joint.light_groups(self._run.lights, lights)
            if self._settings.matching == "joint"
            else [list(range(lights))]
        )
        channel = {light: c for c, group in enumerate(groups) for light in group}
        means = np.zeros((len(groups), views, *self._run.shape), np.float32)
        with (
            self._timed("read frames"),
            self._job.stage("read frames", views * lights) as stage,
        ):
            for view, light, image in self._run.stack():
                if self._kept is not None:
                    self._kept[view, light] = image
                means[channel[light], view] += image
                stage.advance()
            for c, group in enumerate(groups):
                means[c] /= np.float32(len(group))
            shares = np.array([len(group) for group in groups], np.float32) / np.float32(lights)
            levels = shares @ means.mean(axis=(2, 3), dtype=np.float64)
            for view, level in enumerate(levels):
                _refuse_undefined(float(level), f"view {self._run.view_names[view]}")
            self._gains = levels.mean() / levels
            means *= self._gains.astype(np.float32)[:, None, None]
        return means, shares

    def _match(self, channels: FloatImage) -> mvs.MvsResult:
        with self._timed("match"):
            if self._settings.matching == "joint":
                result = joint.match_jointly(
                    channels,
                    self._slopes,
                    (float(self._heights[0]), float(self._heights[-1])),
                    self._run.pixel_um,
                    self._job,
                )
            else:
                result = mvs.match_views(
                    channels[0],
                    self._slopes,
                    self._heights,
                    self._run.pixel_um,
                    self._settings.window,
                    self._job,
                    parabola=self._settings.parabola,
                )
            if self._mask is not None:
                result.quality[~self._mask] = 0.0
        return result

    def _smooth(self, stereo: mvs.MvsResult) -> tuple[FloatImage, float]:
        with self._timed("smooth"):
            accepted = stereo.accepted(self._settings.stereo_quality)
            if accepted.sum() < 3:
                raise InvalidInputError(
                    f"No height reaches the quality of {self._settings.stereo_quality:g}.",
                    hint="Check focus, exposure and the range of heights; look at a frame.",
                )
            smoothed = smoothing.smooth_robust(
                np.where(accepted, stereo.height_um, np.float32(np.nan)),
                np.where(accepted, stereo.quality, np.float32(0)),
                parameter=self._settings.smoothing_parameter,
                resolution=self._settings.height_step_um,
                job=self._job,
            )
        return smoothed.values, smoothed.parameter

    def _registered(self, height_um: FloatImage | None) -> FloatImage:
        """Frames (L, H, W) of the view s = 0, of lights of equal power."""
        lights = len(self._run.light_names)
        powers = self._run.powers / self._run.powers.mean()
        alone = height_um is None or self._settings.photometric_views == "nearest"
        chosen = [self._nearest()] if alone else list(range(len(self._slopes)))
        visible = self._visible(height_um, chosen)
        out = np.empty((lights, *self._run.shape), np.float32)
        with self._timed("register"), self._job.stage("register", lights) as stage:
            for light in range(lights):
                frames = self._frames(chosen, light)
                if height_um is not None:
                    frames = registration.to_reference(
                        frames,
                        self._slopes[chosen],
                        height_um,
                        self._run.pixel_um,
                        visible=visible,
                    )
                mean_of_known(frames, 1.0 / float(powers[light]), out[light])
                if height_um is None:
                    level = float(out[light].mean(dtype=np.float64))
                    _refuse_undefined(level, f"light {self._run.light_names[light]}")
                stage.advance()
        return out

    def _visible(self, height_um: FloatImage | None, chosen: list[int]) -> BoolImage | None:
        if not self._settings.occlusion or height_um is None:
            return None
        with self._timed("visibility"):
            return registration.visibility(
                height_um, self._slopes[chosen], self._run.pixel_um, job=self._job
            )

    def _frames(self, views: list[int], light: int) -> FloatImage:
        """Frames (K, H, W) of one light, of equal gain."""
        frames = np.empty((len(views), *self._run.shape), np.float32)
        if self._kept is not None:
            for place, view in enumerate(views):
                frames[place] = self._kept[view, light]
        else:
            for place, (_, _, image) in enumerate(self._run.stack(views, [light])):
                frames[place] = image
        frames *= self._gains[views].astype(np.float32)[:, None, None]
        return frames

    def _surface(
        self,
        stereo: mvs.MvsResult | None,
        smoothed: FloatImage | None,
        solved: photometric.PsResult | None,
        figures: dict[str, float],
    ) -> tuple[FloatImage, str]:
        settings = self._settings
        if solved is None:
            assert smoothed is not None  # one of the two methods was run
            return smoothed, "stereo"
        q_ps = np.where(solved.quality >= settings.photometric_quality, solved.quality, 0.0)
        if self._mask is not None:
            q_ps = np.where(self._mask, q_ps, 0.0)
        if stereo is None or smoothed is None:
            fused = fusion.integrate(
                solved.normals,
                q_ps,
                self._run.pixel_um,
                derivative=settings.derivative,
                tolerance_um=settings.tolerance_um,
                job=self._job,
            )
            kind = "integrated"
        else:
            accepted = stereo.accepted(settings.stereo_quality)
            fused = fusion.fuse(
                smoothed,
                np.where(accepted, stereo.quality, 0.0),
                solved.normals,
                q_ps,
                self._run.pixel_um,
                lam=settings.lam,
                derivative=settings.derivative,
                minimum_quality=settings.minimum_quality,
                tolerance_um=settings.tolerance_um,
                job=self._job,
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


def peak_memory_mb() -> float:
    """Greatest resident memory of this process so far, in MB."""
    if sys.platform == "win32":
        return float(psutil.Process().memory_info().peak_wset) / 1e6
    import resource

    unit = 1 if sys.platform == "darwin" else 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * unit / 1e6


def _or_zero(slopes: NDArray[np.float64] | None, count: int) -> NDArray[np.float64]:
    return np.zeros((count, 2)) if slopes is None else slopes


def _refuse_undefined(level: float, what: str) -> None:
    if not np.isfinite(level):
        raise InvalidInputError(
            f"Frames of {what} hold undefined values (NaN or infinite).",
            hint="Check the files that were imported; acquire or import them again.",
        )
    if level <= 0.0:
        raise InvalidInputError(
            f"Frames of {what} are black after the dark signal was subtracted.",
            hint="Check exposure, lights and the dark frames.",
        )
