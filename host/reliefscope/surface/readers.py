"""Files of height maps: X3P, TIFF and NPZ, and the vendors' own where SurfaceTopography is installed."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from reliefscope.errors import InvalidInputError
from reliefscope.surface.height_map import HeightMap

FORMATS = {
    ".x3p": "X3P of ISO 25178-72",
    ".npz": "NumPy archive: `height_um` or one two-dimensional array in um, and `pixel_um`",
    ".tif": "TIFF with one channel: heights in um, pixel size in the resolution tags",
    ".tiff": "TIFF with one channel: heights in um, pixel size in the resolution tags",
}
"""Suffix -> what is read without further packages."""
VENDOR_SUFFIXES = (
    ".al3d", ".bcr", ".bcrf", ".datx", ".frt", ".gwy", ".ibw", ".lext", ".mnt", ".nms", ".opd", ".opdx",
    ".os3d", ".plu", ".plux", ".sdf", ".sur", ".tmd", ".vk3", ".vk4", ".vk6", ".vk7", ".zmg", ".zon",
)  # fmt: skip
"""Suffixes that the optional package SurfaceTopography reads."""
_UM_PER_M = 1e6
_TIFF_X, _TIFF_Y, _TIFF_UNIT = 282, 283, 296
_TIFF_UM = {2: 25_400.0, 3: 10_000.0}
"""Resolution unit (inch, centimetre) in um."""
_MOST_POINTS = 100_000_000

_Raw = tuple[NDArray[np.floating], tuple[float, float] | None]
"""Heights in um, row 0 on top, and the pixel size where the file tells it."""


def read_height_map(path: str | Path, *, width_um: float | None = None) -> HeightMap:
    """Read a height map; see :data:`FORMATS` and :data:`VENDOR_SUFFIXES`.

    Parameters
    ----------
    path:
        The file.  Of several layers or channels the first one is read.
    width_um:
        True extent along x, for a file that does not tell it or where another one is wanted; the extent along
        y follows.

    Raises
    ------
    InvalidInputError
        There is no such file, its format is unknown, it is damaged, or it tells no pixel size.
    """
    place = Path(path)
    suffix = place.suffix.lower()
    if not place.is_file():
        raise InvalidInputError(
            f"There is no height map `{place}`.",
            hint="Check the path; it starts at the current folder.",
        )
    if suffix not in _READERS:
        raise InvalidInputError(
            f"`{place.name}` is no height map that can be read.",
            hint=f"Use one of {', '.join(FORMATS)}"
            f" or, with SurfaceTopography installed, {', '.join(VENDOR_SUFFIXES)}.",
        )
    try:
        heights, pixel_um = _READERS[suffix](place)
    except InvalidInputError:
        raise
    except Exception as error:  # damaged files fail in every way that their libraries know
        raise InvalidInputError(
            f"`{place.name}` could not be read as {suffix}: {error}",
            hint="The file is damaged or of another kind. Export it again, for example as X3P.",
        ) from error
    if heights.size > _MOST_POINTS:
        raise InvalidInputError(
            f"`{place.name}` has {heights.size:,} points.",
            hint=f"Crop or reduce it to at most {_MOST_POINTS:,}.",
        )
    if pixel_um is None and width_um is None:
        raise InvalidInputError(
            f"`{place.name}` does not say how large its pixels are.",
            hint="Give the true width of the map in um: width_um=...",
        )
    height_map = HeightMap(
        np.ascontiguousarray(heights, dtype=np.float32), pixel_um or (1.0, 1.0), place.name
    )
    return height_map if width_um is None else height_map.widened(width_um)


def _read_x3p(path: Path) -> _Raw:
    """X3P counts y upward with the rows, so that its first row is the lowest."""
    import x3pio

    surface = x3pio.read(path)
    if not isinstance(surface, x3pio.Surface):
        raise InvalidInputError(
            f"`{path.name}` holds a {type(surface).__name__.lower()}, not a surface.",
            hint="Export the areal measurement.",
        )
    layer = surface.layers[0]
    across, along = layer.spacing
    return layer.z[::-1] * _UM_PER_M, (across * _UM_PER_M, along * _UM_PER_M)


def _read_npz(path: Path) -> _Raw:
    with path.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
        images = [name for name in archive.files if archive[name].ndim == 2]
        if "height_um" in images:
            name = "height_um"
        elif len(images) == 1:
            name = images[0]
        else:
            raise InvalidInputError(
                f"`{path.name}` has {len(images)} two-dimensional arrays and none is `height_um`.",
                hint=f"Save the heights as `height_um` (there are: {', '.join(archive.files)}).",
            )
        heights = archive[name].astype(np.float64)
        if "pixel_um" not in archive.files:
            return heights, None
        pixel_um = np.atleast_1d(archive["pixel_um"]).astype(np.float64)
    return heights, (float(pixel_um[0]), float(pixel_um[-1]))


def _read_tiff(path: Path) -> _Raw:
    from PIL import Image

    with warnings.catch_warnings():
        warnings.simplefilter("error", Image.DecompressionBombWarning)
        with Image.open(path, formats=["TIFF"]) as image:
            if len(image.getbands()) != 1 or image.mode in {"P", "1"}:
                raise InvalidInputError(
                    f"`{path.name}` is a picture ({image.mode}), not a height map.",
                    hint="Export the heights with one channel of 32-bit numbers in um.",
                )
            tags = dict(image.getexif())
            heights = np.asarray(image).astype(np.float64)
    unit_um = _TIFF_UM.get(int(tags.get(_TIFF_UNIT, 2)))
    resolution = [float(tags.get(tag, 0.0)) for tag in (_TIFF_X, _TIFF_Y)]
    if unit_um is None or min(resolution) <= 0:
        return heights, None
    return heights, (unit_um / resolution[0], unit_um / resolution[1])


def _read_vendor(path: Path) -> _Raw:
    try:
        with warnings.catch_warnings():
            # It announces at import that it runs without MPI.
            warnings.simplefilter("ignore", ImportWarning)
            from SurfaceTopography import read_topography
    except ImportError as error:
        raise InvalidInputError(
            f"Files of the kind `{path.suffix.lower()}` need the package SurfaceTopography.",
            hint="Type `pip install 'reliefscope[surfaces]'`, or export the measurement as X3P.",
        ) from error
    topography = read_topography(str(path))
    if topography.dim != 2 or topography.unit is None:
        raise InvalidInputError(
            f"`{path.name}` holds no surface with units.",
            hint="Export the areal measurement as X3P.",
        )
    topography = topography.to_unit("µm")
    # Its first index is x, its second y, which grows upward.
    heights = np.ma.filled(np.ma.asarray(topography.heights(), dtype=np.float64), np.nan)
    across, along = topography.pixel_size
    return heights.T[::-1], (float(across), float(along))


_READERS: dict[str, Callable[[Path], _Raw]] = {
    ".x3p": _read_x3p,
    ".npz": _read_npz,
    ".tif": _read_tiff,
    ".tiff": _read_tiff,
    **dict.fromkeys(VENDOR_SUFFIXES, _read_vendor),
}
