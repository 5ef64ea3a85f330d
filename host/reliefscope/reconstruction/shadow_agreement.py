"""Shadows that the stereo height casts under each LED, against the dark places of the frames.

Shadows hardly ask how the surface reflects: metal and dust cast the same.  They test the map of the LEDs
against that of the apertures, and the scale of z against the elevation of the LEDs.  For the scale, points whose
shadow may come from outside the field are left out, and surfaces that a light grazes: they grow dark little by
little, with no edge that would tell a height.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property

import cv2
import numpy as np
from numpy.typing import NDArray

from reliefscope.models.light_field import LightField
from reliefscope.reconstruction import shadows
from reliefscope.units import BoolImage, FloatImage

PIXELS = 40_000
"""Pixels, at most, of the reduced maps on which shadows are cast."""
LEAST_FACTOR = 4
"""Pixels per side that are averaged at least: matching resolves no finer, and its noise would cast shadows."""
BRIGHT = 0.6
"""Intensity under a light over the mean of all lights from which a pixel counts as fully lit."""
DARK = 0.25
"""The same below which a pixel counts as dark."""
LEAST_COSINE = 0.3
"""Cosine between normal and light below which a light grazes a surface."""
TOP_PERCENTILE = 99.0
"""Percentile of the heights above which nothing casts shadows worth mentioning."""
LEAST_ENTRIES = 1000
"""Pairs of pixel and light below which nothing is said."""
SCALES = np.geomspace(0.7, 1.43, 9)
"""Scales of z that are tried."""
ANGLES_DEG = np.linspace(-30.0, 30.0, 7)
"""Turns of the LED map that are tried around the best of the coarse ones."""


@dataclass(frozen=True, slots=True)
class ShadowAgreement:
    """Correlation of cast shadows with dark places under hypotheses about the LED map and z.

    Attributes
    ----------
    as_is:
        Correlation with the map as given.
    mirrored, angle_deg:
        The map with the greatest correlation: mirrored in y, if at all, then turned counter-clockwise.
    best:
        Its correlation.
    upside_down:
        Correlation of the heights' opposite.
    scale:
        What heights would have to be multiplied by for their shadows to fit best.
    scale_correlation:
        The correlation with that scale.
    lights:
        (L, L) correlation of the dark places under light i with the shadows that light j would cast.
    share:
        Share of the pairs of pixel and light that should lie in a cast shadow, among those where the light does not
        graze.
    dark_share:
        Share of the same pairs that are dark.
    """

    as_is: float
    mirrored: bool
    angle_deg: float
    best: float
    upside_down: float
    scale: float
    scale_correlation: float
    lights: NDArray[np.float64]
    share: float
    dark_share: float


def compare_shadows(
    height_um: FloatImage,
    normals: FloatImage,
    images: FloatImage,
    lights: LightField,
    pixel_um: float,
) -> ShadowAgreement | None:
    """Agreement of the shadows of ``height_um`` (H, W) with ``images`` (L, H, W) in the view s = 0.

    Heights are known everywhere; images are linear and lit by ``lights``.  ``normals`` (H, W, 3) tell which light
    grazes a surface.  None where too few shadows can be told.
    """
    scene = _Scene.reduced(height_um, normals, images, lights, pixel_um)
    if scene.known.sum() < LEAST_ENTRIES:
        return None
    as_is = scene.score()
    mirrored, angle = scene.best_map()
    best = scene.score(mirrored=mirrored, angle_deg=angle)
    if best <= as_is:
        mirrored, angle, best = False, 0.0, as_is
    facing = scene.known & scene.facing
    sharp = replace(scene, known=facing & scene.inside)
    scores = np.array([sharp.score(float(scale)) for scale in SCALES])
    return ShadowAgreement(
        as_is=as_is,
        mirrored=mirrored,
        angle_deg=angle,
        best=best,
        upside_down=scene.score(-1.0),
        scale=math.exp(_peak(np.log(SCALES), scores)),
        scale_correlation=float(scores.max()),
        lights=scene.cross_correlation(),
        share=_share(~scene.lit(), facing),
        dark_share=_share(scene.arrived < DARK / BRIGHT, facing),
    )


@dataclass(frozen=True)
class _Scene:
    """Reduced heights (h, w), and the light that arrived (L, h, w): 1 where fully lit.

    ``known`` (L, h, w) is where it is known, ``inside`` where all that can cast a shadow lies in the field, and
    ``facing`` where the light does not graze.
    """

    height_um: FloatImage
    arrived: FloatImage
    known: BoolImage
    inside: BoolImage
    facing: BoolImage
    lights: LightField
    pixel_um: float

    @classmethod
    def reduced(
        cls,
        height_um: FloatImage,
        normals: FloatImage,
        images: FloatImage,
        lights: LightField,
        pixel_um: float,
    ) -> _Scene:
        """The scene on at most :data:`PIXELS` pixels."""
        rows, columns = height_um.shape
        factor = max(LEAST_FACTOR, math.ceil(math.sqrt(rows * columns / PIXELS)))
        size = (columns // factor, rows // factor)
        crop = np.s_[: size[1] * factor, : size[0] * factor]

        def mean(image: FloatImage) -> FloatImage:
            return cv2.resize(image[crop], size, interpolation=cv2.INTER_AREA).astype(np.float32)

        height, upright = mean(height_um), mean(normals)
        frames = np.stack([mean(image) for image in images])
        frames /= lights.powers.astype(np.float32)[:, None, None]
        with np.errstate(invalid="ignore", divide="ignore"):
            arrived = np.clip(frames / (BRIGHT * frames.mean(axis=0)), 0.0, 1.0)
        directions = lights.directions.astype(np.float32)
        inside = [_inside(height, direction, pixel_um * factor) for direction in directions]
        facing = [upright @ direction >= LEAST_COSINE for direction in directions]
        return cls(
            height_um=height,
            arrived=arrived,
            known=np.isfinite(arrived),
            inside=np.stack(inside),
            facing=np.stack(facing),
            lights=lights,
            pixel_um=pixel_um * factor,
        )

    def lit(self, scale: float = 1.0, mirrored: bool = False, angle_deg: float = 0.0) -> BoolImage:
        """Where each light (L, h, w) arrives over the heights times ``scale``."""
        return shadows.lit(
            self.height_um * np.float32(scale),
            _moved(self.lights, mirrored, angle_deg),
            self.pixel_um,
            tolerance_um=0.0,
        )

    def score(self, scale: float = 1.0, mirrored: bool = False, angle_deg: float = 0.0) -> float:
        """Correlation, over lights and pixels, of the light that arrived with what shadows leave."""
        cast = self._without_mean(self.lit(scale, mirrored, angle_deg)).ravel()
        seen = self._seen.ravel()
        norm = math.sqrt(float(cast @ cast) * float(seen @ seen))
        return float(cast @ seen) / norm if norm > 0 else 0.0

    def cross_correlation(self) -> NDArray[np.float64]:
        """(L, L) correlation of the light that arrives from i with what the shadows of light j leave."""
        cast = self._without_mean(self.lit()).reshape(len(self.arrived), -1)
        seen = self._seen.reshape(len(self.arrived), -1)
        norm = np.sqrt(np.outer((seen**2).sum(axis=1), (cast**2).sum(axis=1)))
        correlation: NDArray[np.float64] = (seen @ cast.T) / np.maximum(norm, 1e-12)
        return correlation

    def best_map(self) -> tuple[bool, float]:
        """Mirror and turn with the greatest correlation: in steps of 45 degrees, then in between."""
        coarse = [
            (self.score(1.0, mirrored, angle), mirrored, angle)
            for mirrored in (False, True)
            for angle in np.arange(0.0, 360.0, 45.0)
        ]
        _, mirrored, angle = max(coarse)
        fine = [self.score(1.0, mirrored, angle + turn) for turn in ANGLES_DEG]
        turned = angle + _peak(ANGLES_DEG, np.array(fine))
        return mirrored, float((turned + 180.0) % 360.0 - 180.0)

    @cached_property
    def _seen(self) -> FloatImage:
        """Light that arrived (L, h, w), less its mean over the lights."""
        return self._without_mean(self.arrived)

    @cached_property
    def _weight(self) -> FloatImage:
        """1 where the light (L, h, w) is known, else 0."""
        return self.known.astype(np.float32)

    def _without_mean(self, values: NDArray[np.float32] | BoolImage) -> FloatImage:
        """Values (L, h, w) less their mean over the lights for which the pixel is known; 0 elsewhere."""
        known = np.where(self.known, values, np.float32(0.0))
        mean = known.sum(axis=0) / np.maximum(self._weight.sum(axis=0), np.float32(1.0))
        known -= self._weight * mean
        return known


def _share(chosen: BoolImage, among: BoolImage) -> float:
    """Share of the pairs (L, h, w) ``among`` which are ``chosen``; 0 where there are none."""
    return float(chosen[among].mean()) if among.any() else 0.0


def _inside(height_um: FloatImage, direction: NDArray[np.float64], pixel_um: float) -> BoolImage:
    """Points (h, w) whose line of sight to the light leaves the field above everything in it."""
    rows, columns = height_um.shape
    x, y, z = direction
    level = math.hypot(x, y)
    if level < 1e-6:
        return np.ones(height_um.shape, np.bool_)
    right, up = x / level, y / level
    column, row = np.arange(columns), np.arange(rows)
    across = (columns - 1 - column if right > 0 else column) / max(abs(right), 1e-9)
    along = (row if up > 0 else rows - 1 - row) / max(abs(up), 1e-9)
    distance = np.minimum(across[None, :], along[:, None])
    top = float(np.percentile(height_um, TOP_PERCENTILE))
    clear: BoolImage = height_um + distance * pixel_um * (z / level) >= top
    return clear


def _moved(lights: LightField, mirrored: bool, angle_deg: float) -> LightField:
    """The lights mirrored in y, if at all, then turned counter-clockwise about the axis."""
    cos, sin = math.cos(math.radians(angle_deg)), math.sin(math.radians(angle_deg))
    turn = np.array([[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]])
    if mirrored:
        turn = turn @ np.diag([1.0, -1.0, 1.0])
    positions = lights.positions_mm
    return replace(
        lights,
        vectors=lights.vectors @ turn.T,
        positions_mm=None if positions is None else positions @ turn.T,
    )


def _peak(places: NDArray[np.float64], scores: NDArray[np.float64]) -> float:
    """Place of the greatest score on evenly spaced places, by a parabola through it and its neighbours."""
    top = int(np.argmax(scores))
    if top in (0, len(scores) - 1):
        return float(places[top])
    before, middle, after = scores[top - 1 : top + 2]
    bend = before - 2 * middle + after
    offset = 0.5 * (before - after) / bend if bend < 0 else 0.0
    return float(places[top] + offset * (places[1] - places[0]))
