"""The whole pipeline against truth: a shaded, textured relief seen from several slopes under several lights."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace

import numba
import numpy as np
import pytest
from scipy import ndimage

from reliefscope import axes
from reliefscope.errors import Cancelled, InvalidInputError
from reliefscope.jobs import Job
from reliefscope.models.light_field import LightField
from reliefscope.reconstruction.pipeline import reconstruct
from reliefscope.reconstruction.settings import JointSettings, PaperSettings, Settings

PIXEL_UM = 1.12
SHAPE = (96, 112)
PAPER = Settings(method="paper", paper=PaperSettings(height_step_um=2.0, window=11))
JOINT = Settings()
TINT = np.array([1.6, 0.9, 0.6], np.float32)
"""Red, green and blue over luminance, of which green is one half."""
BOTH = pytest.mark.parametrize("settings", [PAPER, JOINT], ids=["paper", "joint"])


@dataclass(frozen=True)
class ArrayFrames:
    """Frames in memory, as `reliefscope.reconstruction.pipeline.Frames` asks for them."""

    images: np.ndarray
    views: np.ndarray | None
    lights: np.ndarray | None
    height_range_um: tuple[float, float] | None = (-20.0, 20.0)
    pixel_um: float = PIXEL_UM
    mask: np.ndarray | None = None
    powers: np.ndarray = field(default_factory=lambda: np.ones(1))
    full_scale: float = 1e3
    telecentricity_per_um: float = 0.0

    @property
    def shape(self) -> tuple[int, int]:
        return self.images.shape[2:]

    @property
    def view_names(self) -> tuple[str, ...]:
        return tuple(f"v{k}" for k in range(self.images.shape[0]))

    @property
    def light_names(self) -> tuple[str, ...]:
        return tuple(f"l{k}" for k in range(self.images.shape[1]))

    @property
    def light_field(self) -> LightField | None:
        return None if self.lights is None else LightField.distant(self.lights, self.powers)

    @property
    def in_colour(self) -> bool:
        return True

    def rgb(self, kind: str, view: int, light: int) -> np.ndarray:
        """A sample that is reddish as a whole, of the same luminance."""
        assert kind == "view"
        return self.images[view, light][..., None] * TINT

    def saturation_level(self, view: int, light: int) -> float:
        return self.full_scale

    def stack(
        self, views: Iterable[int] | None = None, lights: Iterable[int] | None = None
    ) -> Iterator[tuple[int, int, np.ndarray]]:
        for view in range(self.images.shape[0]) if views is None else views:
            for light in range(self.images.shape[1]) if lights is None else lights:
                yield view, light, self.images[view, light].copy()


def relief(x_um: np.ndarray, y_um: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Height and its slopes: a smooth hill, off the middle and longer in x, on an incline."""
    hill = 14.0 * np.exp(-((x_um - 8) ** 2) / 1100 - (y_um + 5) ** 2 / 600)
    height = hill + 0.05 * x_um - 5.0
    return height, -2 * (x_um - 8) / 1100 * hill + 0.05, -2 * (y_um + 5) / 600 * hill


def make_frames(slopes: np.ndarray, lights: np.ndarray, seed: int = 1) -> ArrayFrames:
    """Lambert shading of a mottled relief; each view is sampled along its own rays."""
    rng = np.random.default_rng(seed)
    margin = 40
    noise = ndimage.gaussian_filter(rng.standard_normal(tuple(n + 2 * margin for n in SHAPE)), 1.0)
    albedo = 0.5 + 0.12 * noise / noise.std()
    x_um, y_um = axes.pixel_grid_um(SHAPE, PIXEL_UM)
    x, y = np.meshgrid(x_um, y_um)
    images = np.empty((len(slopes), len(lights), *SHAPE), np.float32)
    for k, (sx, sy) in enumerate(slopes):
        # the surface point seen at (x, y) of this view: (x + z sx, y + z sy)
        px, py = x.copy(), y.copy()
        for _ in range(40):
            z, _, _ = relief(px, py)
            px, py = x + z * sx, y + z * sy
        _, gx, gy = relief(px, py)
        columns = px / PIXEL_UM + (SHAPE[1] - 1) / 2 + margin
        rows = (SHAPE[0] - 1) / 2 - py / PIXEL_UM + margin
        rho = ndimage.map_coordinates(albedo, [rows, columns], order=3)
        for m, (lx, ly, lz) in enumerate(lights):
            shade = (-gx * lx - gy * ly + lz) / np.sqrt(1 + gx**2 + gy**2)
            images[k, m] = rho * np.maximum(shade, 0.0)
    images += rng.normal(0.0, 0.002, images.shape).astype(np.float32)
    return ArrayFrames(images, slopes, lights, powers=np.ones(len(lights)))


@pytest.fixture(scope="module")
def frames() -> ArrayFrames:
    angles = 2 * np.pi * np.arange(6) / 6 + 0.2
    slopes = 0.13 * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    lights = np.array([axes.direction(np.radians(45), 2 * np.pi * k / 6) for k in range(6)])
    return make_frames(slopes, lights)


@pytest.fixture(scope="module")
def truth() -> np.ndarray:
    x_um, y_um = axes.pixel_grid_um(SHAPE, PIXEL_UM)
    return relief(*np.meshgrid(x_um, y_um))[0]


INNER = (slice(12, -12), slice(12, -12))


def mean_error(height: np.ndarray, truth: np.ndarray) -> float:
    return float(np.abs(height - truth)[INNER].mean())


@BOTH
def test_the_relief_is_recovered(
    frames: ArrayFrames, truth: np.ndarray, settings: Settings
) -> None:
    job = Job()
    stages: set[str] = set()
    job.subscribe(lambda progress: stages.add(progress.stage))
    result = reconstruct(frames, settings, job)
    assert result.kind == "fused"
    assert mean_error(result.height_um, truth) < 0.35
    assert mean_error(result.height_um, truth) < mean_error(result.stereo_height_um, truth)
    x_um, y_um = axes.pixel_grid_um(SHAPE, PIXEL_UM)
    _, gx, gy = relief(*np.meshgrid(x_um, y_um))
    slope_x, slope_y = axes.gradient_from_normals(result.normals)
    assert np.abs(slope_x - gx)[INNER].mean() < 0.02
    assert np.abs(slope_y - gy)[INNER].mean() < 0.02
    named = {"read frames", "match", "register", "photometric stereo", "self-check", "fuse"}
    named |= {"visibility", "shadows"} if settings.method == "joint" else {"smooth", "saturation"}
    assert stages >= named, "progress and the table of times use the same names"
    assert set(result.timings_s) == named
    assert result.peak_memory_mb > 10
    summary = result.summary()
    assert summary["stereo_accepted"] > 0.5
    assert summary["height_known"] == 1.0


@BOTH
def test_unequal_gain_of_views_and_power_of_lights_are_taken_off(
    frames: ArrayFrames, truth: np.ndarray, settings: Settings
) -> None:
    gains = np.array([1.0, 0.8, 1.2, 0.9, 1.1, 0.7])
    powers = np.array([1.0, 1.3, 0.8, 1.1, 0.9, 1.0])
    images = (frames.images * gains[:, None, None, None] * powers[None, :, None, None]) / 2
    other = replace(frames, images=images.astype(np.float32), powers=powers)
    result = reconstruct(other, settings)
    assert mean_error(result.height_um, truth) < 0.4


@pytest.mark.parametrize("views", [1, 6])
def test_albedo_in_colour_on_demand(frames: ArrayFrames, views: int) -> None:
    seen = replace(frames, images=frames.images[:views], views=frames.views[:views])
    assert reconstruct(seen).albedo_rgb is None
    result = reconstruct(seen, Settings(joint=JointSettings(colour=True)))
    expected = result.albedo[..., None] * TINT
    np.testing.assert_allclose(result.albedo_rgb[INNER], expected[INNER], rtol=2e-3)
    assert "colour" in result.timings_s


@BOTH
def test_one_view_is_integrated(frames: ArrayFrames, truth: np.ndarray, settings: Settings) -> None:
    lone = make_frames(np.zeros((1, 2)), frames.lights)
    result = reconstruct(lone, settings)
    assert result.kind == "integrated"
    assert result.stereo_height_um is None
    assert mean_error(result.height_um, truth - truth.mean()) < 0.3


@BOTH
def test_one_light_is_stereo_only(
    frames: ArrayFrames, truth: np.ndarray, settings: Settings
) -> None:
    lone = replace(frames, images=frames.images[:, :1], lights=None, powers=np.ones(1))
    result = reconstruct(lone, settings)
    assert result.kind == "stereo"
    assert result.normals is None
    assert mean_error(result.height_um, truth) < 1.5


def test_hints_offer_only_what_the_run_allows(frames: ArrayFrames) -> None:
    def hint(views: int, lights: int, *, unknown: bool = False) -> str:
        few = ArrayFrames(
            images=frames.images[:views, :lights],
            views=frames.views[:views],
            lights=None if unknown else frames.lights[:lights],
            powers=np.ones(lights),
        )
        with pytest.raises(InvalidInputError) as caught:
            reconstruct(few, JOINT)
        return caught.value.hint

    assert "stereo" not in hint(1, 2)
    assert "more lights" in hint(1, 2)
    assert "use: stereo" in hint(2, 2)
    assert "use: stereo" not in hint(1, 4, unknown=True)
    assert "use: stereo" in hint(2, 4, unknown=True)


@BOTH
@pytest.mark.parametrize("count", [(6, 6), (1, 6), (6, 1)], ids=["both", "one view", "one light"])
def test_saturated_points_are_told(
    frames: ArrayFrames, settings: Settings, count: tuple[int, int]
) -> None:
    views, lights = count
    images = frames.images[:views, :lights].copy()
    images[0, 0, 50:53, 60:63] = frames.full_scale
    part = replace(
        frames,
        images=images,
        views=frames.views[:views],
        lights=frames.lights if lights > 1 else None,
        powers=np.ones(lights),
    )
    result = reconstruct(part, settings)
    places = np.argwhere(result.saturated)
    assert 9 <= len(places) <= 30
    assert (np.abs(places - (51, 61)) <= 6).all(), "where that view sees it, moved by its parallax"
    assert result.summary()["saturated"] == pytest.approx(len(places) / np.prod(SHAPE), abs=1e-4)


@BOTH
def test_mask_leaves_the_rest_missing(frames: ArrayFrames, settings: Settings) -> None:
    mask = np.ones(SHAPE, bool)
    mask[:, :20] = False
    result = reconstruct(replace(frames, mask=mask), settings)
    assert np.isnan(result.height_um[:, :20]).all()
    assert np.isfinite(result.height_um[:, 20:]).all()


def test_bad_input_is_refused_before_a_frame_is_read(frames: ArrayFrames) -> None:
    class Untouched(ArrayFrames):
        def stack(self, views: object = None, lights: object = None) -> Iterator[object]:
            raise AssertionError("a frame was read")

    good = Untouched(frames.images, frames.views, frames.lights, powers=frames.powers)
    cases: list[tuple[dict, str]] = [
        ({"images": frames.images[:, :2], "lights": frames.lights[:2]}, "there are 2"),
        ({"lights": np.array([[0.0, y, 1.0] for y in (-1, 0, 1, 2, 3, 4)])}, "condition number"),
        ({"lights": None}, "direction of a light is not known"),
        ({"views": None}, "slope of a view is not known"),
        ({"height_range_um": None}, "no range of heights"),
        ({"images": frames.images[:1, :1]}, "tells nothing"),
    ]
    for change, message in cases:
        with pytest.raises(InvalidInputError, match=message) as caught:
            reconstruct(replace(good, **change), JOINT)
        assert caught.value.hint
    with pytest.raises(InvalidInputError, match="no baseline"):
        reconstruct(replace(frames, views=np.zeros((6, 2))), JOINT)


@BOTH
def test_undefined_and_black_frames_are_refused(frames: ArrayFrames, settings: Settings) -> None:
    images = frames.images.copy()
    images[2, 1, 5, 5] = np.nan
    with pytest.raises(InvalidInputError, match=r"view v2 hold undefined values"):
        reconstruct(replace(frames, images=images), settings)
    single = replace(frames, images=images[2:3], views=np.zeros((1, 2)))
    with pytest.raises(InvalidInputError, match=r"light l1 hold undefined values"):
        reconstruct(single, settings)
    with pytest.raises(InvalidInputError, match="black"):
        reconstruct(replace(frames, images=np.zeros_like(images)), settings)


def test_cancelling(frames: ArrayFrames) -> None:
    job = Job()
    job.cancel()
    with pytest.raises(Cancelled):
        reconstruct(frames, JOINT, job)


def test_the_result_is_the_same_for_any_number_of_threads(frames: ArrayFrames) -> None:
    whole = reconstruct(frames, JOINT)
    threads = numba.get_num_threads()
    numba.set_num_threads(1)
    try:
        alone = reconstruct(frames, JOINT)
    finally:
        numba.set_num_threads(threads)
    for name in ("height_um", "sigma_um", "normals", "albedo"):
        np.testing.assert_allclose(
            getattr(whole, name), getattr(alone, name), rtol=0, atol=1e-4, err_msg=name
        )
