"""Coloured albedo against a rendered scene of known colours."""

from dataclasses import dataclass

import numpy as np

from reliefscope import axes
from reliefscope.models.light_field import LightField
from reliefscope.reconstruction.colour import LUMINANCE, colour_albedo
from reliefscope.reconstruction.photometric import solve


@dataclass(frozen=True)
class Rendered:
    images: np.ndarray
    pixel_um: float = 2.0

    def rgb(self, kind: str, view: int | None, light: int | None) -> np.ndarray:
        assert (kind, view) == ("view", 3)
        assert light is not None
        return self.images[light]


def test_colours_of_a_matt_sample_with_white_highlights() -> None:
    rng = np.random.default_rng(1)
    shape = (40, 60)
    lights = LightField.distant(
        [axes.direction(np.radians(e), np.radians(a)) for e in (25, 45) for a in range(0, 360, 45)],
        rng.uniform(0.7, 1.4, 16),
    )
    normals = np.concatenate([rng.uniform(-0.3, 0.3, (*shape, 2)), np.ones((*shape, 1))], axis=-1)
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    patches = rng.uniform(0.05, 0.9, (4, 6, 3)).repeat(10, axis=0).repeat(10, axis=1)
    shading = np.maximum(np.einsum("lc,hwc->lhw", lights.vectors, normals), 0.0)
    images = (shading[..., None] * patches).astype(np.float32)
    images += 0.8 * (rng.random(shading.shape) < 0.05)[..., None].astype(np.float32)
    solved = solve(images @ np.array(LUMINANCE, np.float32), lights, 2.0)
    found = colour_albedo(Rendered(images / 1.25), 3, (0.0, 0.0), 1.25, None, lights, solved)
    mean = lights.powers.mean()
    assert np.median(np.abs(found / mean - patches)) < 0.005
    assert np.mean(np.abs(found / mean - patches)) < 0.02
    np.testing.assert_allclose(found @ np.array(LUMINANCE), solved.albedo, rtol=1e-4)


def test_the_view_is_brought_to_the_reference_by_the_height() -> None:
    """A colour edge on a raised plane, seen from aside, comes back to where it is."""
    shape, slope, height_um = (24, 40), (0.2, 0.0), 30.0
    lights = LightField.distant([axes.direction(1.0, a) for a in (0.0, 1.5, 3.0, 4.5)])
    colours = np.zeros((*shape, 3), np.float32)
    colours[:, :20] = 0.8, 0.2, 0.1
    colours[:, 20:] = 0.1, 0.3, 0.7
    columns, _ = axes.apparent_shift_px(height_um, slope, 2.0)
    seen = np.roll(colours, round(columns), axis=1)
    shading = lights.vectors[:, 2].astype(np.float32)[:, None, None, None]
    solved = solve(shading[..., 0] * (colours @ np.array(LUMINANCE, np.float32)), lights, 2.0)
    height = np.full(shape, height_um, np.float32)
    found = colour_albedo(Rendered(shading * seen), 3, slope, 1.0, height, lights, solved)
    np.testing.assert_allclose(found[:, 5:35], colours[:, 5:35], atol=0.02)
