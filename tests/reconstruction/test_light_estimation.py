"""Lights from the photographs of the sample, against rendered scenes of known lights."""

from pathlib import Path

import cv2
import numpy as np
import pytest
import yaml

from reliefscope import axes
from reliefscope.errors import InvalidInputError, OutputExistsError
from reliefscope.microscope import estimate_powers, import_photographs
from reliefscope.models.light_field import LightField
from reliefscope.reconstruction.light_estimation import estimate_lights, refine_powers
from reliefscope.reconstruction.photometric import solve

PIXEL_UM = 90.0
SHAPE = (120, 160)


def grooves() -> np.ndarray:
    """Level ground with grooves along y and x, flanks of 10 to 35 degrees."""
    x_um, y_um = axes.pixel_grid_um(SHAPE, PIXEL_UM)
    height = np.zeros(SHAPE)
    for centre, width, depth in ((-4500, 700, 350), (0, 500, 120), (3500, 600, 250)):
        height -= np.clip(depth * (1.5 - np.abs(x_um - centre) / width), 0, depth)[None, :]
    for centre, width, depth in ((-3000, 600, 200), (2500, 500, 250)):
        height -= np.clip(depth * (1.5 - np.abs(y_um - centre) / width), 0, depth)[:, None]
    return height


def shaded(positions_mm: np.ndarray, intensities: np.ndarray, bounce: float = 0.0) -> np.ndarray:
    """Point lights over the grooves, each with what level surroundings add to a slope."""
    normals = axes.normals_from_height(grooves(), PIXEL_UM).astype(np.float64)
    x_um, y_um = axes.pixel_grid_um(SHAPE, PIXEL_UM)
    points = np.stack(np.broadcast_arrays(x_um[None], y_um[:, None], 0.0), axis=-1) / 1000
    images = []
    for place, intensity in zip(positions_mm, intensities, strict=True):
        way = place - points
        cubed = np.linalg.norm(way, axis=-1) ** 3
        direct = np.maximum((way * normals).sum(axis=-1), 0.0) / cubed
        level = way[..., 2] / cubed
        images.append(intensity * (direct + bounce * (1 - normals[..., 2]) * level))
    stack = np.array(images)
    return (0.6 * stack / stack.max()).astype(np.float32)


def ring(elevation_deg: float, distance_mm: float, count: int = 6) -> np.ndarray:
    return distance_mm * np.array(
        [
            axes.direction(np.radians(elevation_deg), 2 * np.pi * k / count + 0.3)
            for k in range(count)
        ]
    )


@pytest.mark.parametrize(("elevation_deg", "reflectance"), [(35.0, 0.0), (50.0, 0.6)])
def test_near_lights_are_found_from_falloff_and_slopes(
    elevation_deg: float, reflectance: float
) -> None:
    rng = np.random.default_rng(1)
    positions = ring(elevation_deg, 25.0)
    intensities = rng.uniform(0.7, 1.3, 6)
    images = shaded(positions, intensities, bounce=reflectance / 2)
    images += rng.normal(0, 0.002, images.shape).astype(np.float32)
    found = estimate_lights(images, PIXEL_UM, reflectance=reflectance)
    assert np.degrees(found.elevation_rad) == pytest.approx(elevation_deg, abs=3.0)
    cosines = np.sum(found.light_field.directions * positions / 25.0, axis=1)
    assert np.degrees(np.arccos(cosines)).max() < 4.0
    result = solve(images, found.light_field, PIXEL_UM)
    truth = axes.normals_from_height(grooves(), PIXEL_UM)
    cross = np.linalg.norm(np.cross(result.normals, truth), axis=-1)
    errors = np.degrees(np.arctan2(cross, np.sum(result.normals * truth, axis=-1)))
    assert np.median(errors) < 1.0
    assert np.mean(errors) < 2.5


def test_samples_that_do_not_tell_their_lights_are_refused() -> None:
    lights, intensities = ring(40.0, 25.0), np.ones(6)
    images = shaded(lights, intensities)
    with pytest.raises(InvalidInputError, match="at least 3"):
        estimate_lights(images[:2], PIXEL_UM)
    rng = np.random.default_rng(2)
    with pytest.raises(InvalidInputError, match="level"):
        estimate_lights(images * rng.uniform(0.4, 1.0, SHAPE).astype(np.float32), PIXEL_UM)
    with pytest.raises(InvalidInputError, match="does not fall off"):
        estimate_lights(np.full((6, 60, 80), 0.5, np.float32), PIXEL_UM)
    with pytest.raises(InvalidInputError, match="dark"):
        estimate_lights(np.zeros((6, 60, 80), np.float32), PIXEL_UM)


def bumps(lights: LightField, pixel_um: float) -> np.ndarray:
    """Photographs (16, H, W) of bumps of mixed albedo, some in shadow, some with highlights."""
    rng = np.random.default_rng(3)
    shape = (96, 128)
    height = rng.normal(0, 1, shape)
    for _ in range(3):
        height = sum(np.roll(height, (i, j), (0, 1)) for i in (-2, 0, 2) for j in (-2, 0, 2)) / 4
    normals = axes.normals_from_height(height * 3.0, pixel_um).astype(np.float64)
    x_um, y_um = axes.pixel_grid_um(shape, pixel_um)
    points = np.stack(np.broadcast_arrays(x_um[None], y_um[:, None], 0.0), axis=-1)
    albedo = rng.uniform(0.2, 0.8, shape)
    images = albedo * np.maximum(
        np.einsum("lhwc,hwc->lhw", lights.irradiance(points), normals), 0.0
    )
    images += 0.3 * (rng.random(images.shape) < 0.03)
    return (images + rng.normal(0, 0.003, images.shape)).astype(np.float32)


SIXTEEN = np.concatenate([ring(22.5, 30.0, 8), ring(45.0, 30.0, 8)])
ACTUAL = np.random.default_rng(8).uniform(0.8, 1.2, 16)
"""Places of lights, and powers that nothing tells but the photographs."""


def test_powers_that_are_off_by_a_fifth_are_found() -> None:
    nominal = LightField.of_leds(SIXTEEN, np.eye(16), beam_exponent=8.75)
    images = bumps(nominal.scaled(ACTUAL), 8.0)
    factors = refine_powers(images, nominal, 8.0)
    expected = ACTUAL / np.exp(np.log(ACTUAL).mean())
    assert np.abs(factors / expected - 1).max() < 0.02
    before = solve(images, nominal, 8.0)
    after = solve(images, nominal.scaled(factors), 8.0)
    assert np.median(after.residual) < 0.6 * np.median(before.residual)


def test_powers_of_imported_photographs_go_back_into_their_description(tmp_path: Path) -> None:
    images = bumps(LightField.of_leds(SIXTEEN, np.diag(ACTUAL)), 8.0)
    for index, image in enumerate(images):
        counts = np.clip(65535 * (0.1 + 0.4 * image), 0, 65535).astype(np.uint16)
        assert cv2.imwrite(str(tmp_path / f"{index}.png"), counts)
    description = tmp_path / "bumps.yml"
    content = {
        "pixel_um": 8.0,
        "bit_depth": 16,
        "black_level": 0.1,
        "pattern": "{light}.png",
        "lights": [{"position_mm": place.tolist()} for place in SIXTEEN],
    }
    description.write_text(yaml.safe_dump(content))
    run = import_photographs(description, tmp_path / "equal")
    powers = estimate_powers(run.path, out=tmp_path / "lights.yml")
    assert powers.mean() == pytest.approx(1.0)
    assert np.abs(powers / (ACTUAL / ACTUAL.mean()) - 1).max() < 0.02
    with pytest.raises(OutputExistsError):
        estimate_powers(run.path, out=tmp_path / "lights.yml")
    description.write_text(yaml.safe_dump(content | {"lights": "lights.yml"}))
    again = import_photographs(description, tmp_path / "weighed").data
    np.testing.assert_allclose(again.powers, powers, atol=1e-5)
    assert again.light_field.positions_mm == pytest.approx(SIXTEEN, abs=1e-4)
    description.write_text(yaml.safe_dump(content | {"lights": [{} for _ in SIXTEEN]}))
    with pytest.raises(InvalidInputError, match="direction of a light is not known"):
        estimate_powers(import_photographs(description, tmp_path / "unknown").path)


def test_powers_that_the_sample_does_not_tell_are_refused() -> None:
    rng = np.random.default_rng(4)
    lights = LightField.of_leds(
        np.concatenate([ring(22.5, 30.0, 8), ring(45.0, 30.0, 8)]), np.eye(16)
    )
    scattered = rng.uniform(0.45, 0.55, (16, 60, 80)).astype(np.float32)
    with pytest.raises(InvalidInputError, match="does not tell"):
        refine_powers(scattered, lights, 8.0)
    with pytest.raises(InvalidInputError, match="at least 5"):
        refine_powers(scattered[:4], lights.subset(range(4)), 8.0)
