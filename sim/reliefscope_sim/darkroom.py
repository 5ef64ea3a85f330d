"""Where exposures become pictures: the scene and its renderer, made when first needed.

Rendering needs neither the bench's lock nor its time, so the instrument goes on while a frame is developed.
"""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING

from reliefscope.models.instrument import InstrumentProfile
from reliefscope.units import US_PER_S, RawImage
from reliefscope_sim.shutter import Exposure
from reliefscope_sim.url import SimUrl

if TYPE_CHECKING:
    from reliefscope_sim.optics import Renderer


class Darkroom:
    """Renders the scene that ``url`` names, as the instrument of ``profile`` sees it.  Thread-safe."""

    def __init__(self, url: SimUrl, profile: InstrumentProfile) -> None:
        self._url = url
        self._profile = profile
        self._lock = threading.Lock()
        self._renderer: Renderer | None = None

    def set_up(self) -> None:
        """Make scene and renderer, if that has not been done.

        Raises
        ------
        InvalidInputError
            If the scene does not exist or has not the options that were given.
        """
        with self._lock:
            self._ready_renderer()

    def develop(self, exposure: Exposure) -> RawImage:
        """The picture (H, W) that the sensor took: the same one for the same exposure, bit for bit."""
        key = (self._url.seed, exposure.glass_key, exposure.light_key, exposure.repeat)
        exposure_s = exposure.exposure_us / US_PER_S
        gain = 10 ** (exposure.gain_db / 20)
        with self._lock:
            renderer = self._ready_renderer()
            raw = renderer.expose(exposure.transmission, exposure.led_energy, exposure_s, key, gain)
        return raw[: _rows_kept(exposure.kept, raw.shape[0])]

    def _ready_renderer(self) -> Renderer:
        if self._renderer is None:
            # Late: who only talks to the device does not wait for numba.
            from reliefscope_sim.optics import Renderer
            from reliefscope_sim.scenes import load_scene
            from reliefscope_sim.stage import lifted

            scene = load_scene(
                self._url.scene,
                self._url.seed,
                dict(self._url.scene_options),
                shape=self._profile.shape,
                pixel_um=self._profile.pixel_um,
            )
            scene = lifted(scene, self._url.stage_um)
            as_built = self._url.load_as_built(self._profile)
            flaws = self._url.load_flaws(self._profile)
            self._renderer = Renderer(self._profile, scene, as_built, flaws=flaws)
        return self._renderer


def _rows_kept(kept: float, rows: int) -> int:
    """Rows of a frame that arrived: an even number, so that the mosaic stays whole, at least two."""
    return rows if kept >= 1.0 else max(2, int(kept * rows) // 2 * 2)
