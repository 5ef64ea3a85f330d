"""The camera behind the glass: rays through open glass pixels, and the diffraction of their outline.

Point (x, y) of a frame is lit by rays that pass the focal plane z = 0 there and lean toward a point a of the
pupil by ``a / f``; a point of the pupil is a point of an open glass pixel that the round pupil does not cut off.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from bench.pathtrace.tracer import FirstHits, Tracer, mitsuba
from numpy.typing import NDArray
from scipy.signal import fftconvolve

from reliefscope.models.instrument import InstrumentProfile
from reliefscope.units import BoolImage, FloatArray, FloatImage

_GOLDEN_5 = 1.1347241384015194
"""Root of x^6 = x + 1: its powers spread points evenly in five dimensions."""
_CLEARANCE_UM = 5.0
_RAYS_AT_ONCE = 6_000_000


@dataclass(frozen=True)
class Aperture:
    """Open glass pixels: centres (K, 2) in mm in the pupil, y up, and their size (2,)."""

    centres_mm: FloatArray
    size_mm: tuple[float, float]
    focal_mm: float
    pupil_radius_mm: float

    @classmethod
    def of_bitmap(cls, bitmap: BoolImage, profile: InstrumentProfile) -> Aperture:
        """The open pixels of a bitmap (64, 128), row 0 on top, of a glass that sits as designed."""
        glass = profile.glass
        rows, columns = np.nonzero(bitmap)
        x = (columns + 0.5 - glass.columns / 2) * glass.pitch_x_mm
        y = (glass.rows / 2 - rows - 0.5) * glass.pitch_y_mm
        return cls(
            np.stack([x, y], axis=-1),
            (glass.pitch_x_mm - glass.gap_mm, glass.pitch_y_mm - glass.gap_mm),
            profile.optics.pupil_scale * profile.optics.objective_focal_mm,
            profile.optics.pupil_diameter_mm / 2,
        )

    @property
    def mean_slope(self) -> tuple[float, float]:
        """Slope of the middle of the open pixels."""
        x, y = self.centres_mm.mean(axis=0) / self.focal_mm
        return float(x), float(y)

    @property
    def area_mm2(self) -> float:
        """Open area before the pupil cuts anything off."""
        return len(self.centres_mm) * self.size_mm[0] * self.size_mm[1]


@dataclass(frozen=True)
class Frame:
    """A frame (rows, columns) of pixels of ``pixel_um``, or a ``window`` of its rows and columns."""

    shape: tuple[int, int]
    pixel_um: float
    window: tuple[slice, slice] = (slice(None), slice(None))

    @property
    def corner(self) -> tuple[int, int]:
        """First row and column of the window."""
        return (
            self.window[0].indices(self.shape[0])[0],
            self.window[1].indices(self.shape[1])[0],
        )

    @property
    def size(self) -> tuple[int, int]:
        """Rows and columns of the window."""
        top, left = self.corner
        return (
            self.window[0].indices(self.shape[0])[1] - top,
            self.window[1].indices(self.shape[1])[1] - left,
        )

    def rays(self, row: Any, column: Any, lean: tuple[Any, Any], start_um: float) -> Any:
        """Origins at height ``start_um`` and directions of rays that pass the focal plane at a point.

        ``row`` and ``column`` count from the upper left corner of the window's first pixel; ``lean`` is the slope.
        """
        mi = mitsuba()
        import drjit as dr

        top, left = self.corner
        x = (column + (left - self.shape[1] / 2)) * self.pixel_um
        y = (self.shape[0] / 2 - top - row) * self.pixel_um
        origin = mi.Point3f(x + start_um * lean[0], y + start_um * lean[1], start_um)
        return origin, dr.normalize(mi.Vector3f(-lean[0], -lean[1], -1.0))


def photograph(
    tracer: Tracer, aperture: Aperture, frame: Frame, rays_per_pixel: int, seed: int
) -> FloatImage:
    """Picture (H, W) without noise and diffraction: radiance times open area in mm^2.

    Rays start at evenly spread points of the pixel and of the aperture.
    """
    mi = mitsuba()
    import drjit as dr

    rows, columns = frame.size
    at_once = max(1, _RAYS_AT_ONCE // (columns * rays_per_pixel))
    centre_x = mi.Float(aperture.centres_mm[:, 0].astype(np.float32))
    centre_y = mi.Float(aperture.centres_mm[:, 1].astype(np.float32))
    many = len(aperture.centres_mm)
    picture = np.empty((rows, columns), dtype=np.float32)
    for first in range(0, rows, at_once):
        block = min(at_once, rows - first)
        index = dr.arange(mi.UInt32, block * columns * rays_per_pixel)
        pixel = index // rays_per_pixel + dr.opaque(mi.UInt32, first * columns)
        turn = mi.Float(index % rays_per_pixel)
        spread = []
        for axis in range(5):
            start = mi.sample_tea_float32(pixel, dr.opaque(mi.UInt32, seed * 5 + axis))
            value = start + turn * _GOLDEN_5 ** -(axis + 1)
            spread.append(value - dr.floor(value))
        slot = dr.minimum(mi.UInt32(spread[0] * many), many - 1)
        pupil_x = dr.gather(mi.Float, centre_x, slot) + (spread[1] - 0.5) * aperture.size_mm[0]
        pupil_y = dr.gather(mi.Float, centre_y, slot) + (spread[2] - 0.5) * aperture.size_mm[1]
        passes = pupil_x**2 + pupil_y**2 <= aperture.pupil_radius_mm**2
        origin, direction = frame.rays(
            mi.Float(pixel // columns) + spread[4],
            mi.Float(pixel % columns) + spread[3],
            (pupil_x / aperture.focal_mm, pupil_y / aperture.focal_mm),
            tracer.top_um + _CLEARANCE_UM,
        )
        value = tracer.radiance(origin, direction, seed * 1009 + first)
        mean = dr.block_sum(dr.select(passes, value, 0.0), rays_per_pixel) / rays_per_pixel
        picture[first : first + block] = np.asarray(mean).reshape(block, columns)
    return picture * np.float32(aperture.area_mm2)


def first_hits(tracer: Tracer, aperture: Aperture, frame: Frame, led: int) -> FirstHits:
    """What each pixel (H, W) shows at its middle through the middle of the aperture.

    A hair beside the middle: exactly there a ray may run along the edges of triangles, and slip between them.
    """
    mi = mitsuba()
    import drjit as dr

    rows, columns = frame.size
    pixel = dr.arange(mi.UInt32, rows * columns)
    origin, direction = frame.rays(
        mi.Float(pixel // columns) + 0.51,
        mi.Float(pixel % columns) + 0.51,
        aperture.mean_slope,
        tracer.top_um + _CLEARANCE_UM,
    )
    hits = tracer.first_hits(origin, direction, led)
    return FirstHits(*(np.reshape(part, (rows, columns)) for part in vars(hits).values()))


def diffracted(
    frame: FloatImage, aperture: Aperture, wavelength_um: float, pixel_um: float
) -> FloatImage:
    """The frame with the spot of its aperture, the square of the outline's Fourier transform."""
    spot = spot_image(aperture, wavelength_um, pixel_um)
    reach = spot.shape[0] // 2
    padded = np.pad(frame, reach, mode="edge")
    blurred: FloatImage = fftconvolve(padded, spot, mode="valid").astype(np.float32)
    return blurred


def spot_image(
    aperture: Aperture, wavelength_um: float, pixel_um: float, reach_um: float = 40.0
) -> NDArray[np.float64]:
    """Fraunhofer spot (2n + 1, 2n + 1) of the open pixels in the focal plane, of sum 1.

    The amplitude at (x, y) is the sum over open pixels of ``exp(2 pi i (a . x) / (lambda f))`` times the sinc of
    one pixel.
    """
    reach = int(np.ceil(reach_um / pixel_um))
    offset_um = np.arange(-reach, reach + 1) * pixel_um
    per_mm = offset_um / (wavelength_um * aperture.focal_mm)
    wave_x = np.exp(2j * np.pi * np.outer(per_mm, aperture.centres_mm[:, 0]))
    wave_y = np.exp(-2j * np.pi * np.outer(per_mm, aperture.centres_mm[:, 1]))
    outline = np.outer(np.sinc(per_mm * aperture.size_mm[1]), np.sinc(per_mm * aperture.size_mm[0]))
    intensity = np.abs(outline * (wave_y @ wave_x.T)) ** 2
    spot: NDArray[np.float64] = intensity / intensity.sum()
    return spot
