"""What the camera records while the glass and the LEDs are in a given state.

The glass is a grid of pixels, each with its own transmission; light through different pixels adds up without
interference.  So a frame is a sum of images through sets of pixels that share a transmission: one image of
the whole pupil (what leaks everywhere), and one per set that differs from it (the open disc; during switching
also the disc that is closing).  Images without noise are kept per set and light within a bound of memory.
"""

from __future__ import annotations

import math

import cv2
import numpy as np
from numpy.typing import NDArray

from reliefscope.errors import InvalidInputError
from reliefscope.jobs import Job, ensure_job
from reliefscope.models.instrument import InstrumentProfile
from reliefscope.units import FloatArray, FloatImage, RawImage
from reliefscope_sim.as_built import AsBuilt
from reliefscope_sim.flaws import SensorFlaws
from reliefscope_sim.optics.cache import ByteCache
from reliefscope_sim.optics.lighting import Lighting, LitSurface
from reliefscope_sim.optics.pupil import Pupil, PupilPoints
from reliefscope_sim.optics.surface import Surface, as_float_image
from reliefscope_sim.optics.views import Shader, Viewer
from reliefscope_sim.scenes.scene import Scene
from reliefscope_sim.sensor import Sensor

WHITE_SIGNAL = 0.6
"""Signal (fraction of full scale, unit response) of a level white Lambert sample of albedo 0.9 under one LED
at 45 degrees at full level, through one open disc of the profile's diameter and all that the shut glass
leaks, exposed for the profile's default time.  It fixes the LEDs' brightness, which no profile gives."""
_WHITE_ALBEDO = 0.9

_TRANSMISSION_LEVELS = 4096
_RATIO_LEVELS = 1024
_GLOSS_CELL_MM = 3.0
"""Points of an aperture that lie within so much share one direction of view for gloss..."""
_WIDE_GLOSS_CELL_MM = 4.6
"""...and of the whole pupil, whose leakage is a blur in any case."""
_MB = 1 << 20

LightKey = tuple[tuple[int, float], ...]
"""LEDs that shine and their share of the brightest one's energy."""


class Renderer:
    """Frames of one scene seen by one instrument as it was really built.

    ``shape`` is (rows, columns) of the frames, the profile's where absent.  Geometry, lighting and images
    are computed when first needed and kept within ``cache_mb`` megabytes.  Without ``flaws`` the sensor is even.
    """

    def __init__(
        self,
        profile: InstrumentProfile,
        scene: Scene,
        as_built: AsBuilt,
        shape: tuple[int, int] | None = None,
        cache_mb: int = 560,
        flaws: SensorFlaws | None = None,
    ) -> None:
        self.profile = profile
        self.shape = shape or profile.shape
        self._as_built = as_built
        self._pupil = Pupil(profile, as_built)
        self._colour = scene.coloured and profile.camera.sensor == "bayer_rggb"
        focal_mm = as_built.pupil_scale * profile.optics.objective_focal_mm
        field_mm = math.hypot(*self.shape) * profile.pixel_um / 2000
        steepest = profile.optics.pupil_diameter_mm / 2 / focal_mm + (
            abs(as_built.telecentricity_per_mm) * field_mm
        )
        self._surface = Surface.on_frame(
            scene, self.shape, profile.pixel_um, steepest, colour=self._colour
        )
        self._coarse = self._surface.coarser(2)
        self._lighting = Lighting(self._surface, profile.dome, as_built)
        glossy = self._surface.specular is not None
        cells_mm = (_GLOSS_CELL_MM, _WIDE_GLOSS_CELL_MM) if glossy else (0.0, 0.0)
        sizes = [int(cache_mb * share * _MB) for share in (0.2, 0.08, 0.3, 0.2, 0.22)]
        self._viewer = Viewer(self._surface, profile.optics, as_built, cells_mm[0], sizes[0])
        self._wide = Viewer(self._coarse, profile.optics, as_built, cells_mm[1], sizes[1])
        self._lit: ByteCache[LitSurface] = ByteCache(sizes[2], lambda lit: lit.nbytes)
        self._images: ByteCache[FloatImage] = ByteCache(sizes[3], lambda image: image.nbytes)
        self._wide_images: ByteCache[FloatImage] = ByteCache(sizes[4], lambda image: image.nbytes)
        self._sensor = Sensor(profile.camera, flaws or SensorFlaws.none(self.shape))
        self._signal_per_mm2_s = signal_per_mm2_s(profile)

    def prepare(self, job: Job | None = None) -> None:
        """Compute the lighting of every LED now (shadows, light between surfaces) instead of when needed."""
        count = self.profile.dome.count
        with ensure_job(job).stage("lighting", count) as stage:
            for led in range(count):
                self._lit_by(led)
                stage.advance()

    def expose(
        self,
        pixel_transmission: FloatArray,
        led_energy: FloatArray,
        exposure_s: float,
        noise_key: tuple[int, ...],
        gain: float = 1.0,
    ) -> RawImage:
        """One raw frame (H, W).

        Parameters
        ----------
        pixel_transmission:
            (64, 128), 0 to 1, of every glass pixel averaged over the exposure, row 0 on top.
        led_energy:
            (n_leds,), level as a fraction of full times on-time in seconds, within the exposure.
        exposure_s:
            Length of the exposure.
        noise_key:
            Names the noise: the same key gives the same noise.
        gain:
            Amplification of the camera.
        """
        signal = self.signal(pixel_transmission, led_energy)
        return self._sensor.expose(signal, exposure_s, noise_key, gain)

    def signal(self, pixel_transmission: FloatArray, led_energy: FloatArray) -> FloatImage:
        """The frame (H, W) without noise, as a fraction of full scale at unit response; see :meth:`expose`."""
        transmission = np.asarray(pixel_transmission, dtype=np.float64)
        energy = np.asarray(led_energy, dtype=np.float64)
        leds = self.profile.dome.count
        if transmission.shape != self._pupil.area_mm2.shape or energy.shape != (leds,):
            raise InvalidInputError(
                f"The renderer was given a glass of {transmission.shape} and {energy.shape} LEDs.",
                hint=f"It needs {self._pupil.area_mm2.shape} pixels and ({leds},) LED energies.",
            )
        brightest = float(energy.max(initial=0.0))
        signal: FloatImage = np.zeros(self.shape, dtype=np.float32)
        if brightest <= 0:
            return signal
        ratios = np.rint(energy / brightest * _RATIO_LEVELS) / _RATIO_LEVELS
        light = tuple((int(led), float(ratios[led])) for led in np.flatnonzero(ratios))
        scale = brightest * self._signal_per_mm2_s
        inside = self._pupil.area_mm2 > 0
        level = np.rint(transmission * _TRANSMISSION_LEVELS).astype(np.int64)
        values, counts = np.unique(level[inside], return_counts=True)
        common = int(values[np.argmax(counts)])
        fill = self._pupil.fill_factor
        gap = (1 - fill) / self.profile.glass.contrast_ratio
        everywhere = fill * float(transmission[inside & (level == common)].mean())
        _accumulate(signal, self._pupil_image(light), scale * (everywhere + gap))
        for value in values:
            if value == common:
                continue
            mask = inside & (level == value)
            difference = fill * float(transmission[mask].mean()) - everywhere
            _accumulate(signal, self._set_image(mask, light), scale * difference)
        return signal

    def _set_image(self, mask: NDArray[np.bool_], light: LightKey) -> FloatImage:
        """Image through the pixels of ``mask`` at full transmission: radiance times mm^2."""
        key = np.packbits(mask).tobytes()

        def compute() -> FloatImage:
            points = self._points(mask, self._viewer)
            return self._viewer.mosaic(key, points, self._shader(light))

        return self._images.get((key, light), compute)

    def _pupil_image(self, light: LightKey) -> FloatImage:
        """Image through the whole pupil; blurred by its own width, it is made at half the resolution."""

        def compute() -> FloatImage:
            points = self._points(self._pupil.area_mm2 > 0, self._wide)
            image = self._wide.image(b"pupil", points, self._shader(light, coarse=True))
            rows, columns = self.shape
            red, green, blue = (
                as_float_image(cv2.resize(image[channel], None, fx=2, fy=2))[:rows, :columns]
                for channel in (0, len(image) // 2, -1)
            )
            mosaic = green.copy()
            mosaic[0::2, 0::2] = red[0::2, 0::2]
            mosaic[1::2, 1::2] = blue[1::2, 1::2]
            return mosaic

        return self._wide_images.get(light, compute)

    def _points(self, mask: NDArray[np.bool_], viewer: Viewer) -> PupilPoints:
        return self._pupil.points(mask, viewer.spacing_mm(self._pupil.pixels(mask)))

    def _lit_by(self, led: int) -> LitSurface:
        return self._lit.get(led, lambda: self._lighting.lit_by(led))

    def _shader(self, light: LightKey, *, coarse: bool = False) -> Shader:
        """Radiance of the surface under a light, for rays of any one slope."""
        surface = self._coarse if coarse else self._surface
        lights = [
            (led, share, self._lit_by(led).coarser(2) if coarse else self._lit_by(led))
            for led, share in light
        ]

        def shade(lean: NDArray[np.float64]) -> FloatImage:
            radiance: FloatImage = np.zeros(surface.albedo.shape, dtype=np.float32)
            for led, share, lit in lights:
                self._lighting.add_radiance(surface, lit, led, lean, share, radiance)
            return radiance

        return shade


def signal_per_mm2_s(profile: InstrumentProfile) -> float:
    """Signal of a perfect diffuser at normal incidence per open mm^2 of the pupil and second of one LED."""
    disc_mm2 = math.pi * profile.apertures.disc_diameter_mm**2 / 4
    pupil_mm2 = math.pi * profile.optics.pupil_diameter_mm**2 / 4
    contrast = profile.glass.contrast_ratio
    open_mm2 = disc_mm2 + max(pupil_mm2 - disc_mm2, 0.0) / contrast
    white = _WHITE_ALBEDO * math.sin(math.pi / 4) * open_mm2 * profile.exposure_ms / 1000
    return WHITE_SIGNAL / white


def _accumulate(total: FloatImage, part: FloatImage, factor: float) -> None:
    """``total += factor * part`` in place."""
    cv2.scaleAdd(part, factor, total, dst=total)
