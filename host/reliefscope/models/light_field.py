"""Light that arrives at the sample: its direction and strength at every point.

LEDs a few centimetres away are near: across a field of 1.5 mm the direction of a light turns by 1.5 to 3
degrees, and its strength changes by several per cent.  A light is the sum of the irradiance vectors of its
LEDs; the irradiance of a surface with the unit normal n that sees all of them is ``E . n``.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from reliefscope.axes import pixel_grid_um
from reliefscope.errors import InvalidInputError
from reliefscope.models.calibration import Calibration
from reliefscope.models.instrument import InstrumentProfile
from reliefscope.models.plan import Light
from reliefscope.units import UM_PER_MM, FloatImage


@dataclass(frozen=True, slots=True, eq=False)
class LightField:
    """Irradiance vectors of L lights, from N LEDs at known places or from infinity.

    Attributes
    ----------
    vectors:
        (L, 3) irradiance vectors at the focal point, toward the light; their lengths are relative to each other.
    positions_mm:
        (N, 3) LEDs in the world frame, origin at the focal point; None: the lights are distant, and
        ``vectors`` hold everywhere.
    strengths:
        (L, N) irradiance that each LED gives at the focal point as part of each light.
    beam_exponent:
        LEDs point at the focal point and shine with ``cos^beam_exponent`` of the angle from there; 0: evenly.
    level:
        (L, 10) coefficients of :func:`level_powers`: the logarithm of the intensity that a level surface shows, where
        it was measured; None: as positions and strengths say.
    """

    vectors: NDArray[np.float64]
    positions_mm: NDArray[np.float64] | None = None
    strengths: NDArray[np.float64] | None = None
    beam_exponent: float = 0.0
    level: NDArray[np.float64] | None = None

    @classmethod
    def distant(cls, directions: ArrayLike, powers: ArrayLike | None = None) -> LightField:
        """Parallel light along ``directions`` (L, 3), of any length, with relative ``powers`` (L,).

        Raises
        ------
        InvalidInputError
            Shapes that do not belong together, or a direction that is zero or not finite.
        """
        towards = np.asarray(directions, dtype=np.float64)
        if towards.ndim != 2 or towards.shape[1] != 3:
            raise InvalidInputError(
                f"Light directions must have the shape (lights, 3), not {towards.shape}.",
                hint="Give one vector [x, y, z] per light, from the sample to the light.",
            )
        power = np.ones(len(towards)) if powers is None else np.asarray(powers, dtype=np.float64)
        if power.shape != (len(towards),) or not np.all(power > 0):
            raise InvalidInputError(
                f"Powers {power.shape} do not belong to {len(towards)} lights, or are not positive.",
                hint="Give one positive power per light.",
            )
        lengths = np.linalg.norm(towards, axis=1)
        if not np.all(np.isfinite(lengths)) or np.any(lengths == 0.0):
            bad = [int(i) for i in np.flatnonzero(~np.isfinite(lengths) | (lengths == 0.0))]
            raise InvalidInputError(
                f"Light directions {bad} are zero or not finite.",
                hint="Correct `direction` of these lights in the profile or the import file.",
            )
        return cls(towards * (power / lengths)[:, None])

    @classmethod
    def of_leds(
        cls, positions_mm: ArrayLike, strengths: ArrayLike, beam_exponent: float = 0.0
    ) -> LightField:
        """Near light: ``positions_mm`` (N, 3), ``strengths`` (L, N) as in the attributes.

        Raises
        ------
        InvalidInputError
            Shapes that do not belong together, an LED at or below the sample plane, a light without any LED.
        """
        places = np.asarray(positions_mm, dtype=np.float64)
        parts = np.asarray(strengths, dtype=np.float64)
        if places.ndim != 2 or places.shape[1] != 3 or parts.ndim != 2:
            raise InvalidInputError(
                f"LED positions {places.shape} must be (LEDs, 3), strengths {parts.shape} (lights, LEDs).",
                hint="Give one position in mm per LED, and one strength per light and LED.",
            )
        if parts.shape[1] != len(places):
            raise InvalidInputError(
                f"Strengths for {parts.shape[1]} LEDs do not belong to {len(places)} positions.",
                hint="Give one position per LED.",
            )
        if not np.all(np.isfinite(places)) or np.any(places[:, 2] <= 0.0):
            raise InvalidInputError(
                "An LED lies at or below the sample plane (z is not positive).",
                hint="Positions are in mm from the focal point, z toward the objective; check the axes.",
            )
        if np.any(parts < 0.0) or not np.all(parts.sum(axis=1) > 0.0):
            raise InvalidInputError(
                "A light has no LED that shines, or one of negative strength.",
                hint="Leave lights without any level out of the plan.",
            )
        unit = places / np.linalg.norm(places, axis=1, keepdims=True)
        return cls(parts @ unit, places, parts, beam_exponent)

    @classmethod
    def of_instrument(
        cls, lights: tuple[Light, ...], profile: InstrumentProfile, calibration: Calibration
    ) -> LightField:
        """Lights of a plan, from the calibrated positions and intensities of the LEDs."""
        positions = np.asarray(calibration.led_positions_mm, dtype=np.float64)
        strengths = np.zeros((len(lights), len(positions)))
        for index, light in enumerate(lights):
            for led, level in light.levels.items():
                share = level / profile.dome.full_level * calibration.led_intensities[led]
                distance = float(np.linalg.norm(positions[led])) / profile.dome.radius_mm
                strengths[index, led] = share / distance**2
        return cls.of_leds(positions, strengths, beam_exponent(profile.dome.half_angle_deg))

    def __len__(self) -> int:
        return len(self.vectors)

    @property
    def directions(self) -> NDArray[np.float64]:
        """Unit vectors (L, 3) toward the lights at the focal point."""
        unit: NDArray[np.float64] = self.vectors / np.linalg.norm(
            self.vectors, axis=1, keepdims=True
        )
        return unit

    @property
    def powers(self) -> NDArray[np.float64]:
        """Irradiance (L,) at the focal point of a surface that faces the light."""
        lengths: NDArray[np.float64] = np.linalg.norm(self.vectors, axis=1)
        return lengths

    def scaled(self, factors: ArrayLike) -> LightField:
        """The same lights, each ``factors`` (L,) times as strong."""
        by = np.asarray(factors, dtype=np.float64)[:, None]
        strengths = None if self.strengths is None else self.strengths * by
        level = self.level
        if level is not None:
            level = level.copy()
            level[:, 0] += np.log(by[:, 0])
        return LightField(
            self.vectors * by, self.positions_mm, strengths, self.beam_exponent, level
        )

    def subset(self, lights: ArrayLike) -> LightField:
        """Some of the lights, by index."""
        chosen = np.asarray(lights, dtype=np.intp)
        strengths = None if self.strengths is None else self.strengths[chosen]
        level = None if self.level is None else self.level[chosen]
        vectors = self.vectors[chosen]
        return LightField(vectors, self.positions_mm, strengths, self.beam_exponent, level)

    def with_level(self, level: ArrayLike) -> LightField:
        """The same lights with a measured level intensity (L, 10)."""
        measured = np.asarray(level, dtype=np.float64)
        if measured.shape != (len(self), LEVEL_TERMS):
            raise InvalidInputError(
                f"A level intensity {measured.shape} does not belong to {len(self)} lights.",
                hint=f"Give {LEVEL_TERMS} coefficients per light.",
            )
        return replace(self, level=measured)

    def over_level(self, images: FloatImage) -> FloatImage:
        """Images (L, H, W) over what a level surface shows under each light.

        A surface with the unit normal n shows ``E . n / E_z``.
        """
        if self.level is None:
            raise ValueError("the level intensity of these lights was not measured")
        terms = level_powers((images.shape[1], images.shape[2]))
        out = np.empty(images.shape, np.float32)
        for light, coefficients in enumerate(self.level):
            out[light] = images[light] / np.exp(terms @ coefficients)
        return out

    def irradiance(self, points_um: ArrayLike) -> NDArray[np.float64]:
        """Irradiance vectors (L, ..., 3) at ``points_um`` (..., 3) of the world frame."""
        points = np.asarray(points_um, dtype=np.float64)
        if self.positions_mm is None or self.strengths is None:
            spread = self.vectors.reshape(len(self), *(1,) * (points.ndim - 1), 3)
            return np.broadcast_to(spread, (len(self), *points.shape)).copy()
        total = np.zeros((len(self), *points.shape))
        for position, strength in zip(self.positions_mm, self.strengths.T, strict=True):
            if not strength.any():
                continue
            away = position - points / UM_PER_MM
            distance = np.linalg.norm(away, axis=-1, keepdims=True)
            reach = float(np.linalg.norm(position))
            on_axis = np.maximum((away @ (position / reach))[..., None] / distance, 0.0)
            single = away * (reach**2 * on_axis**self.beam_exponent / distance**3)
            total += strength.reshape(-1, *(1,) * points.ndim) * single
        return total


LEVEL_TERMS = 10
_POWERS = [(i, j) for i in range(4) for j in range(4 - i)]


def level_powers(shape: tuple[int, int]) -> NDArray[np.float64]:
    """Terms (H, W, 10) of a cubic in u (to the right) and v (upward), +-1 at the ends of the longer side.

    In the order 1, v, v^2, v^3, u, u v, u v^2, u^2, u^2 v, u^3.
    """
    half = max(max(shape) - 1, 1) / 2
    u, v = pixel_grid_um(shape, 1.0 / half)
    return np.stack([u[None, :] ** i * v[:, None] ** j for i, j in _POWERS], axis=-1)


def mirrored_level(level: tuple[float, ...]) -> tuple[float, ...]:
    """Coefficients (10,) of the same level intensity with the y axis turned over."""
    return tuple(-c if j % 2 else c for c, (_, j) in zip(level, _POWERS, strict=True))


def beam_exponent(half_angle_deg: float) -> float:
    """Exponent of the cosine that falls to one half at ``half_angle_deg`` from the axis; 0 at 90 degrees."""
    if half_angle_deg >= 90.0:
        return 0.0
    return math.log(0.5) / math.log(math.cos(math.radians(half_angle_deg)))
