"""The camera's sensor: colour filters, electrons, noise, counts."""

from __future__ import annotations

import math

import numpy as np
from numba import njit, prange
from numpy.typing import NDArray
from scipy.special import ndtri

from reliefscope.models.instrument import CameraModel
from reliefscope.units import FloatImage, RawImage
from reliefscope_sim.flaws import SensorFlaws

RGB_RESPONSE = (0.9, 1.0, 0.8)
"""Response of red, green and blue pixels to the white LEDs, relative to a mono pixel."""
_TABLE_BITS = 12
_WORD = (1 << 64) - 1


@njit(cache=True, parallel=True, fastmath=True)
def _develop(
    signal: FloatImage,
    response: FloatImage,
    gain: FloatImage,
    dark: FloatImage,
    full_well: float,
    amplification: float,
    exposure: float,
    read_variance: float,
    black_counts: float,
    full_scale: float,
    key: np.uint64,
    normal: FloatImage,
    counts: NDArray[np.uint16],
) -> None:
    """Counts of a signal (fraction of the full well at unit response); noise from a counter per pixel.

    ``gain`` and ``dark`` are the maps of :class:`~reliefscope_sim.flaws.SensorFlaws`.

    A hash of (key, pixel index) gives 24 bits, two entries of the table ``normal`` of Gaussian quantiles,
    whose scaled sum is Gaussian to 5 standard deviations.
    """
    rows, columns = signal.shape
    well = np.float32(full_well)
    seconds = np.float32(exposure)
    floor = np.float32(read_variance)
    black = np.float32(black_counts)
    top = np.float32(full_scale)
    per_electron = top / well * np.float32(amplification)
    mask = np.uint64((1 << _TABLE_BITS) - 1)
    half = np.float32(math.sqrt(0.5))
    for row in prange(rows):
        for column in range(columns):
            word = key + np.uint64(row * columns + column) * np.uint64(0x9E3779B97F4A7C15)
            word = (word ^ (word >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
            word = (word ^ (word >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
            word ^= word >> np.uint64(31)
            draw = normal[word & mask] + normal[(word >> np.uint64(_TABLE_BITS)) & mask]
            light = signal[row, column] * response[row & 1, column & 1] * gain[row, column]
            electrons = light * well + dark[row, column] * seconds
            electrons += math.sqrt(max(electrons, np.float32(0.0)) + floor) * half * draw
            value = min(electrons, well) * per_electron + black + np.float32(0.5)
            counts[row, column] = np.uint16(min(max(value, np.float32(0.0)), top))


class Sensor:
    """Turns light into raw frames.

    A signal of 1 fills the well of a pixel of unit response, which is the largest count (the black level
    comes on top).  Noise is keyed: the same key gives the same frame whatever the number of threads.
    """

    def __init__(self, camera: CameraModel, flaws: SensorFlaws) -> None:
        self._camera = camera
        self._flaws = flaws
        self._response: FloatImage = np.ones((2, 2), dtype=np.float32)
        if camera.sensor == "bayer_rggb":
            red, green, blue = RGB_RESPONSE
            self._response = np.array([[red, green], [green, blue]], dtype=np.float32)
        size = 1 << _TABLE_BITS
        table = ndtri((np.arange(size) + 0.5) / size)
        self._normal: FloatImage = (table / table.std()).astype(np.float32)

    def expose(
        self,
        signal: FloatImage,
        exposure_s: float,
        noise_key: tuple[int, ...],
        gain: float = 1.0,
    ) -> RawImage:
        """Raw frame (H, W), uint8 or uint16, of a signal (H, W), the shape of the maps of flaws.

        With ``gain`` the converter's full scale stands at 1/gain of the full well; electrons and their noise are the
        same.
        """
        camera = self._camera
        counts = np.empty(signal.shape, dtype=np.uint16)
        _develop(
            signal,
            self._response,
            self._flaws.gain,
            self._flaws.dark_electrons_per_s,
            camera.full_well_electrons,
            gain,
            exposure_s,
            camera.read_noise_electrons**2,
            camera.black_level * camera.full_scale,
            camera.full_scale,
            np.uint64(fold_key(noise_key)),
            self._normal,
            counts,
        )
        return counts.astype(np.uint8) if camera.bit_depth == 8 else counts


def fold_key(noise_key: tuple[int, ...]) -> int:
    """One 64-bit word from any whole numbers (splitmix64 over their 64-bit digits)."""
    state = len(noise_key)
    for number in noise_key:
        rest = number
        while True:
            state = _mix((state ^ (rest & _WORD)) + 0x9E3779B97F4A7C15)
            rest >>= 64
            if rest in {0, -1}:
                break
    return state


def _mix(word: int) -> int:
    word &= _WORD
    word = ((word ^ (word >> 30)) * 0xBF58476D1CE4E5B9) & _WORD
    word = ((word ^ (word >> 27)) * 0x94D049BB133111EB) & _WORD
    return word ^ (word >> 31)
