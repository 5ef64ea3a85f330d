"""Small instruments and samples for the tests of the simulated optics."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from reliefscope.axes import pixel_grid_um
from reliefscope.models.instrument import InstrumentProfile, load_profile
from reliefscope_sim.as_built import AsBuilt
from reliefscope_sim.optics import Renderer
from reliefscope_sim.scenes import Scene

SHAPE = (96, 128)
ENERGY_S = 0.02


def profile(**optics: float) -> InstrumentProfile:
    """The benchtop with a small mono sensor; ``optics`` replaces some of its optical data."""
    bench = load_profile("benchtop").resized(SHAPE[1], SHAPE[0])
    camera = bench.camera.model_copy(update={"sensor": "mono"})
    return bench.model_copy(
        update={"camera": camera, "optics": bench.optics.model_copy(update=optics)}
    )


def without_diffraction() -> InstrumentProfile:
    """The same, with light of hardly any wavelength."""
    return profile(wavelength_um=1e-4)


def as_built(instrument: InstrumentProfile, **changes: object) -> AsBuilt:
    """As designed, but for the changes named."""
    return replace(AsBuilt.nominal(instrument), **changes)


def overhead(instrument: InstrumentProfile, **changes: object) -> AsBuilt:
    """Every LED far above the sample: even light without shadows."""
    positions = np.tile([0.0, 0.0, 3000.0], (instrument.dome.count, 1))
    intensities = np.full(instrument.dome.count, (3000.0 / instrument.dome.radius_mm) ** 2)
    return as_built(instrument, led_positions_mm=positions, led_intensities=intensities, **changes)


def coordinates(instrument: InstrumentProfile, shape: tuple[int, int] = SHAPE):
    """x (1, W) and y (H, 1) in um of the pixels of a frame."""
    x_um, y_um = pixel_grid_um(shape, instrument.pixel_um)
    return x_um[None, :], y_um[:, None]


def sample(instrument: InstrumentProfile, height_um, albedo, **more: object) -> Scene:
    """Scene on the camera's grid from arrays that broadcast to it."""
    shape = (*SHAPE, 3) if np.ndim(albedo) == 3 else SHAPE
    return Scene(
        "test",
        instrument.pixel_um,
        np.broadcast_to(np.asarray(height_um, dtype=np.float32), SHAPE).copy(),
        np.broadcast_to(np.asarray(albedo, dtype=np.float32), shape).copy(),
        **more,
    )


def bump(instrument: InstrumentProfile, sigma_um: float, at_um=(0.0, 0.0)) -> np.ndarray:
    """Albedo: one soft bright spot on black."""
    x_um, y_um = coordinates(instrument)
    squared = (x_um - at_um[0]) ** 2 + (y_um - at_um[1]) ** 2
    return 0.9 * np.exp(-squared / (2 * sigma_um**2))


def pixels(*places: tuple[int, int]) -> np.ndarray:
    """Transmission (64, 128): 1 at the places (row, column), 0 elsewhere."""
    transmission = np.zeros((64, 128))
    for row, column in places:
        transmission[row, column] = 1.0
    return transmission


def disc(instrument: InstrumentProfile, diameter_mm: float, centre_mm=(0.0, 0.0)) -> np.ndarray:
    """Transmission of an open disc in a glass that leaks nothing."""
    glass = instrument.glass
    x_mm = (np.arange(128) - 63.5) * glass.pitch_x_mm
    y_mm = (31.5 - np.arange(64)) * glass.pitch_y_mm
    distance = np.hypot(x_mm[None, :] - centre_mm[0], y_mm[:, None] - centre_mm[1])
    return (distance <= diameter_mm / 2).astype(float)


def one_led(instrument: InstrumentProfile, led: int = 8) -> np.ndarray:
    """Energy of one LED at full level for the default exposure."""
    energy = np.zeros(instrument.dome.count)
    energy[led] = ENERGY_S
    return energy


def render(
    instrument: InstrumentProfile,
    scene: Scene,
    built: AsBuilt,
    transmission: np.ndarray,
    led: int = 8,
) -> np.ndarray:
    """Signal without noise, float64."""
    renderer = Renderer(instrument, scene, built, SHAPE, cache_mb=64)
    return renderer.signal(transmission, one_led(instrument, led)).astype(np.float64)


def moments(image: np.ndarray):
    """Centroid (column, row) and variance (column, row) of an image, in pixels."""
    total = image.sum()
    rows, columns = np.arange(image.shape[0]), np.arange(image.shape[1])
    across, down = image.sum(axis=0) / total, image.sum(axis=1) / total
    column, row = across @ columns, down @ rows
    return (column, row), (across @ (columns - column) ** 2, down @ (rows - row) ** 2)
