"""The result that both methods make of their stages."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from reliefscope.reconstruction.inputs import Inputs
from reliefscope.reconstruction.mvs import MvsResult
from reliefscope.reconstruction.photometric import PsResult
from reliefscope.reconstruction.result import Reconstruction
from reliefscope.reconstruction.self_check import SelfCheck
from reliefscope.reconstruction.stage_clock import StageClock, peak_memory_mb
from reliefscope.units import BoolImage, FloatImage


def assembled(
    inputs: Inputs,
    clock: StageClock,
    *,
    height_um: FloatImage,
    kind: str,
    stereo: MvsResult | None,
    solved: PsResult | None,
    micrograph: FloatImage | None,
    saturated: BoolImage,
    check: SelfCheck | None,
    figures: Mapping[str, float],
) -> Reconstruction:
    """Maps (H, W) that every method has, times and memory; heights outside the run's mask are NaN.

    What only one method knows is for it to add (:func:`dataclasses.replace`).
    """
    if inputs.mask is not None:
        height_um = np.where(inputs.mask, height_um, np.float32(np.nan))
    return Reconstruction(
        height_um=height_um,
        pixel_um=inputs.frames.pixel_um,
        settings=inputs.settings,
        kind=kind,
        stereo_height_um=stereo.height_um if stereo else None,
        stereo_quality=stereo.quality if stereo else None,
        normals=solved.normals if solved else None,
        albedo=solved.albedo if solved else None,
        photometric_quality=solved.quality if solved else None,
        residual=solved.residual if solved else None,
        micrograph=micrograph,
        saturated=saturated,
        valid=inputs.mask,
        self_check=check,
        figures=figures,
        timings_s=clock.timings_s,
        peak_memory_mb=peak_memory_mb(),
    )
