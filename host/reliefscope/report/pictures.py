"""Pictures of a reconstruction as PNG files: maps with scales, an oblique view and an overview.

Drawn with matplotlib's Agg canvas, without its global state, so that any thread may draw.  Maps are coloured
here and reduced to what a screen shows before matplotlib sees them: that is what takes the time.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import cv2
import numpy as np
from scipy.ndimage import distance_transform_edt

from reliefscope.errors import DatasetError
from reliefscope.jobs import Job, ensure_job
from reliefscope.reconstruction.result import Reconstruction
from reliefscope.report.map_figures import (
    ColourMap,
    Extent,
    Rgb,
    length_unit,
    overview_figure,
    save_figure,
    save_image,
    save_map,
)
from reliefscope.report.oblique import FLAT_LIGHT, render_oblique, shade
from reliefscope.units import BoolImage, FloatImage

_WIDTH_PX = 1100
"""Width to which maps are reduced."""
_MOST_RELIEF = 0.5
"""Height range over image size above which the oblique view flattens heights to stay in the picture."""
_BLANK = np.array([232, 234, 237], np.uint8)
_SATURATED = np.array([214, 39, 40], np.uint8)


def write_pictures(
    reconstruction: Reconstruction, folder: Path, job: Job | None = None
) -> tuple[Path, ...]:
    """Draw every picture that the reconstruction allows for and return the files, overview first.

    Files: ``overview``, ``fused`` (or ``stereo``, ``integrated``), ``oblique``, ``uncertainty``, ``height_map``,
    ``quality_stereo``, ``normals``, ``slant``, ``quality_photometric``, ``micrograph``, ``saturated`` (where some
    pixel is), all ``.png``.

    Raises
    ------
    DatasetError
        A file could not be written.
    """
    view = _Reduced(reconstruction)
    makers: list[tuple[str, Callable[[], ColourMap]]] = [(reconstruction.kind, view.surface)]
    if view.sigma is not None:
        makers.append(("uncertainty", view.uncertainty))
    if view.stereo is not None:
        makers += [("height_map", view.height_map), ("quality_stereo", view.quality_stereo)]
    if view.normals is not None:
        makers += [
            ("normals", view.normal_map),
            ("slant", view.slant),
            ("quality_photometric", view.quality_photometric),
        ]
    if view.albedo_rgb is not None:
        makers.append(("albedo", view.albedo_map))
    if view.micrograph is not None:
        makers.append(("micrograph", view.micrograph_map))
        if view.saturated is not None and view.saturated.any():
            makers.append(("saturated", view.saturated_map))
    maps: dict[str, ColourMap] = {}
    written: list[Path] = []
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with ensure_job(job).stage("pictures", len(makers) + 2) as stage:
            for name, make in makers:
                maps[name] = make()
                written.append(save_map(maps[name], view.extent_um, folder / f"{name}.png"))
                stage.advance()
            oblique = view.oblique()
            written.insert(1, save_image(oblique, folder / "oblique.png"))
            stage.advance()
            overview = overview_figure(maps, oblique, view.relief, view.extent_um)
            written.insert(0, save_figure(overview, folder / "overview.png"))
    except OSError as error:
        raise DatasetError(
            f"A picture could not be written to {folder}: {error.strerror or error}.",
            hint=f"Check space and permissions: `df -h {folder.parent}`.",
        ) from error
    return tuple(written)


class _Reduced:
    """Maps of a reconstruction at the size of the pictures."""

    def __init__(self, reconstruction: Reconstruction) -> None:
        rows, columns = reconstruction.height_um.shape
        factor = min(1.0, _WIDTH_PX / columns)
        self._size = (max(1, round(columns * factor)), max(1, round(rows * factor)))
        self._settings = reconstruction.settings.chosen
        self._kind = reconstruction.kind
        self.pixel_um = reconstruction.pixel_um * columns / self._size[0]
        half = reconstruction.pixel_um * columns / 2, reconstruction.pixel_um * rows / 2
        self.extent_um: Extent = (-half[0], half[0], -half[1], half[1])
        self.height = self._reduce(reconstruction.height_um)
        self.known: BoolImage = np.asarray(np.isfinite(self.height))
        self.span = _span(self.height)
        deepest = _MOST_RELIEF * min(self._size) * self.pixel_um
        self.relief = min(1.0, deepest / (self.span[1] - self.span[0]))
        self.filled = _filled(self.height, self.known)
        self.light = shade(self.filled, self.pixel_um)
        self.sigma = _maybe(reconstruction.sigma_um, self._reduce)
        self.stereo = _maybe(reconstruction.stereo_height_um, self._reduce)
        self._stereo_quality = _maybe(reconstruction.stereo_quality, self._reduce)
        self.normals = _maybe(reconstruction.normals, self._reduce)
        self._photometric_quality = _maybe(reconstruction.photometric_quality, self._reduce)
        self._albedo = _maybe(reconstruction.albedo, self._reduce)
        self.albedo_rgb = _maybe(reconstruction.albedo_rgb, self._reduce)
        self.micrograph = _maybe(reconstruction.micrograph, self._reduce)
        self.saturated: BoolImage | None = None
        if reconstruction.saturated is not None:
            self.saturated = self._reduce(reconstruction.saturated.astype(np.float32)) > 0.0
        if reconstruction.valid is not None:
            outside = self._reduce(reconstruction.valid.astype(np.float32)) < 0.5
            for image in (self.sigma, self.stereo, self._stereo_quality, self._photometric_quality):
                if image is not None:
                    image[outside] = np.nan
            if self.normals is not None:
                self.normals[outside] = np.nan

    def _reduce(self, image: FloatImage) -> FloatImage:
        if image.shape[1::-1] == self._size:
            return image.copy()
        # where some of the pixels under one are missing it is the mean of the others
        known = np.isfinite(image).astype(np.float32)
        total = cv2.resize(np.nan_to_num(image), self._size, interpolation=cv2.INTER_AREA)
        share = cv2.resize(known, self._size, interpolation=cv2.INTER_AREA)
        with np.errstate(invalid="ignore", divide="ignore"):
            reduced: FloatImage = np.where(share > 0.25, total / share, np.float32(np.nan))
        return reduced

    def surface(self) -> ColourMap:
        """The result, coloured by height and lit from the upper left."""
        colours = _coloured(self.height, self.span, "viridis")
        lit = colours * np.clip(self.light / FLAT_LIGHT, 0.3, 1.25)[..., None]
        rgb = np.where(self.known[..., None], np.clip(lit, 0, 255), _BLANK).astype(np.uint8)
        titles = {"fused": "Fused height", "stereo": "Height by stereo", "integrated": "Relief"}
        title = titles.get(self._kind, "Height")
        return self._heights(title, rgb)

    def uncertainty(self) -> ColourMap:
        """Standard error of the height; the scale ends where all but one in a hundred lie."""
        assert self.sigma is not None  # asked for only where there is one
        known = self.sigma[np.isfinite(self.sigma)]
        top = float(np.percentile(known, 99)) if known.size else 1.0
        name, factor = length_unit(top)
        return ColourMap(
            "Standard error of the height (68 % of errors are smaller)",
            _coloured(self.sigma, (0.0, max(top, 1e-6)), "inferno"),
            f"standard error ({name})",
            "inferno",
            0.0,
            factor * top,
        )

    def height_map(self) -> ColourMap:
        """Stereo heights as matched, low quality left blank."""
        assert self.stereo is not None  # asked for only where there is one
        assert self._stereo_quality is not None
        kept = self._stereo_quality >= self._settings.stereo_quality
        height = np.where(kept, self.stereo, np.float32(np.nan))
        return self._heights("Stereo height", _coloured(height, self.span, "viridis"))

    def _heights(self, title: str, rgb: Rgb) -> ColourMap:
        name, factor = length_unit(max(abs(value) for value in self.span))
        low, high = (factor * value for value in self.span)
        return ColourMap(title, rgb, f"height ({name})", "viridis", low, high)

    def quality_stereo(self) -> ColourMap:
        """Peak minus median of the mean correlation."""
        assert self._stereo_quality is not None  # comes with the stereo height
        title = f"Stereo quality (< {self._settings.stereo_quality:g} blank)"
        return self._quality(title, self._stereo_quality, self._settings.stereo_quality)

    def quality_photometric(self) -> ColourMap:
        """Score of eq. 10."""
        assert self._photometric_quality is not None  # comes with the normals
        limit = self._settings.photometric_quality
        title = f"Photometric quality (< {limit:g} blank)"
        return self._quality(title, self._photometric_quality, limit)

    def _quality(self, title: str, quality: FloatImage, limit: float) -> ColourMap:
        kept = np.where(quality >= limit, quality, np.float32(np.nan))
        return ColourMap(
            title, _coloured(kept, (0.0, 1.0), "cividis"), "quality", "cividis", 0.0, 1.0
        )

    def normal_map(self) -> ColourMap:
        """Normals as colours: x in red, y in green, z in blue."""
        assert self.normals is not None  # asked for only where there are some
        known = np.isfinite(self.normals[..., 2])
        colours = np.nan_to_num(127.5 * (self.normals + 1.0))
        rgb = np.where(known[..., None], np.clip(colours, 0, 255), _BLANK).astype(np.uint8)
        return ColourMap("Normals (red: x, green: y, blue: z)", rgb)

    def slant(self) -> ColourMap:
        """Angle between normal and optical axis."""
        assert self.normals is not None  # asked for only where there are some
        angle = np.degrees(np.arccos(np.clip(self.normals[..., 2], -1.0, 1.0)))
        return ColourMap(
            "Slant", _coloured(angle, (0.0, 80.0), "magma"), "slant (degrees)", "magma", 0.0, 80.0
        )

    def albedo_map(self) -> ColourMap:
        """Albedo in colour with the tone curve of a screen, one scale for all channels."""
        assert self.albedo_rgb is not None  # asked for only where there is one
        return ColourMap("Albedo", (255 * _toned(self.albedo_rgb)).astype(np.uint8))

    def micrograph_map(self) -> ColourMap:
        """Luminance with the tone curve of a screen."""
        return ColourMap("Micrograph", self._micrograph())

    def saturated_map(self) -> ColourMap:
        """The micrograph, red where the sensor was at full scale in any of the frames."""
        assert self.saturated is not None  # asked for only where there are some
        rgb = self._micrograph()
        rgb[self.saturated] = _SATURATED
        return ColourMap("Saturated in a frame (red)", rgb)

    def _micrograph(self) -> Rgb:
        assert self.micrograph is not None  # asked for only where there is one
        return np.repeat((255 * _toned(self.micrograph))[..., None], 3, -1).astype(np.uint8)

    def oblique(self) -> Rgb:
        """The surface seen at a tilt, in the colour or the grey of its albedo where it is known."""
        albedo = self._albedo if self._albedo is not None else self.micrograph
        tone = np.full((*self.height.shape, 1), 0.8, np.float32)
        if self.albedo_rgb is not None:
            tone = (0.38 + 0.55 * _toned(self.albedo_rgb)).astype(np.float32)
        elif albedo is not None:
            tone = (0.38 + 0.55 * _toned(albedo)).astype(np.float32)[..., None]
        warm = np.array([1.0, 0.975, 0.94], np.float32)
        colour = np.clip(1.12 * tone * self.light[..., None] * warm, 0.0, 1.0)
        colour = np.where(self.known[..., None], colour, np.float32(0.25)) ** np.float32(0.8)
        background = (0.955, 0.96, 0.968)
        low, high = self.span
        spare = 0.03 * (high - low)  # single wild pixels are not drawn as towers
        box = _box(self.known)
        image = render_oblique(
            np.clip(self.filled, low - spare, high + spare)[box],
            colour.astype(np.float32)[box],
            self.pixel_um,
            relief=self.relief,
            known=self.known[box],
            background=background,
        )
        return (255 * np.clip(image, 0, 1) + 0.5).astype(np.uint8)


def _box(known: BoolImage) -> tuple[slice, slice]:
    """Rows and columns with known pixels, and a few around them; all where none is known."""
    if not known.any():
        return slice(None), slice(None)
    rows, columns = (np.flatnonzero(known.any(axis=axis)) for axis in (1, 0))
    room = 1 + known.shape[1] // 50
    return (
        slice(max(0, int(rows[0]) - room), int(rows[-1]) + 1 + room),
        slice(max(0, int(columns[0]) - room), int(columns[-1]) + 1 + room),
    )


def _filled(height: FloatImage, known: BoolImage) -> FloatImage:
    """Heights with the nearest known one where one is missing, so that edges are lit as what they belong to."""
    if known.all() or not known.any():
        return np.nan_to_num(height)
    nearest = distance_transform_edt(~known, return_distances=False, return_indices=True)
    filled: FloatImage = height[tuple(nearest)]
    return filled


def _maybe(
    image: FloatImage | None, reduce: Callable[[FloatImage], FloatImage]
) -> FloatImage | None:
    return None if image is None else reduce(image)


def _span(values: FloatImage) -> tuple[float, float]:
    """Range that all but two in a thousand at either end lie in; never empty."""
    known = values[np.isfinite(values)]
    if known.size == 0:
        return 0.0, 1.0
    low, high = (float(value) for value in np.percentile(known, (0.2, 99.8)))
    return (low, high) if high - low > 1e-3 else (low - 0.5, low + 0.5)


def _toned(image: FloatImage) -> FloatImage:
    """Luminance from 0 to 1 for a screen: dark and light ends cut, square root."""
    known = image[np.isfinite(image)]
    top = float(np.percentile(known, 99.5)) if known.size else 1.0
    toned: FloatImage = np.sqrt(np.clip(np.nan_to_num(image) / max(top, 1e-9), 0.0, 1.0))
    return toned


def _coloured(values: FloatImage, span: tuple[float, float], colours: str) -> Rgb:
    """Colours (H, W, 3) of values over a span; what is missing is blank."""
    from matplotlib import colormaps

    table = (255 * colormaps[colours](np.linspace(0, 1, 256))[:, :3] + 0.5).astype(np.uint8)
    known = np.isfinite(values)
    index = np.clip((np.nan_to_num(values) - span[0]) * (255 / (span[1] - span[0])), 0, 255)
    rgb: Rgb = np.take(table, index.astype(np.uint8), axis=0)
    rgb[~known] = _BLANK
    return rgb
