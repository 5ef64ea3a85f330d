"""The 3D fiducial as files: an STL for a printer, and its truth as a height map.

Both are in the frame of :meth:`~reliefscope.targets.Fiducial3D.height_um`: x to the right, y up, origin in the
middle of the square, z = 0 in the focal plane, so that a scan of the print and the truth compare point by point.
"""

from __future__ import annotations

import io
import json
import logging
import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any, Literal

import numpy as np
import trimesh
from PIL import Image
from PIL.TiffImagePlugin import ImageFileDirectory_v2
from trimesh.exchange.stl import export_stl

from reliefscope.errors import DatasetError, InvalidInputError, OutputExistsError, ReliefscopeError
from reliefscope.export.solid import Plate, closed_form_volume_um3, fiducial_solid
from reliefscope.targets import SECTIONS, Fiducial3D

_LOG = logging.getLogger(__name__)

SCHEMA_VERSION = 1
"""Of the metadata within a truth file."""

Unit = Literal["mm", "um"]
UNIT_UM: Mapping[str, float] = MappingProxyType({"mm": 1000.0, "um": 1.0})
"""Micrometres in one unit of the STL, which itself names none."""

MAX_PIXELS = 50_000_000
_TIFF_DESCRIPTION, _TIFF_X, _TIFF_Y, _TIFF_UNIT, _TIFF_CENTIMETRE = 270, 282, 283, 296, 3


@dataclass(frozen=True, slots=True)
class StlReport:
    """What an STL holds, as checked on its mesh after rounding to the file's 32-bit numbers."""

    path: Path
    unit: str
    extent: tuple[float, float, float]
    triangles: int
    watertight: bool
    euler_number: int
    volume_um3: float
    closed_form_volume_um3: float

    def facts(self) -> dict[str, Any]:
        """The fields as plain values, with the relative difference of the volumes."""
        values = asdict(self)
        values["path"] = str(self.path)
        values["volume_difference"] = self.volume_um3 / self.closed_form_volume_um3 - 1
        return values


@dataclass(frozen=True, slots=True)
class TruthReport:
    """What a truth file holds."""

    path: Path
    shape: tuple[int, int]
    pixel_um: float
    lowest_um: float
    highest_um: float

    def facts(self) -> dict[str, Any]:
        """The fields as plain values."""
        return asdict(self) | {"path": str(self.path)}


def write_fiducial_stl(
    path: str | Path,
    fiducial: Fiducial3D | None = None,
    *,
    unit: Unit = "mm",
    plate: Plate | None = None,
    deviation_um: float = 0.05,
) -> StlReport:
    """Write the fiducial on its base plate as a binary STL.

    Parameters
    ----------
    path:
        A new file, ``.stl``.
    fiducial, plate, deviation_um:
        See :func:`~reliefscope.export.solid.fiducial_solid`.
    unit:
        What one unit of the coordinates means; slicers take millimetres for granted.

    Raises
    ------
    OutputExistsError
        The file exists; it is left alone.
    InvalidInputError
        An impossible plate or deviation, another suffix or unit, or a size that does not fit 32-bit coordinates.
    DatasetError
        The file could not be written.
    """
    place = Path(path)
    check_outputs(stl=place)
    if unit not in UNIT_UM:
        raise InvalidInputError(
            f"`{unit}` is no unit of the STL.", hint=f"Use one of: {', '.join(UNIT_UM)}."
        )
    target = fiducial or Fiducial3D()
    solid = fiducial_solid(target, plate, deviation_um=deviation_um)
    coordinates = (solid.vertices_um / UNIT_UM[unit]).astype(np.float32)
    mesh = trimesh.Trimesh(coordinates.astype(np.float64), solid.faces, process=False)
    # Faces that touch after rounding would pass the check by index, yet not in a program that joins equal corners.
    distinct = len(np.unique(coordinates, axis=0)) == len(coordinates)
    extent = [round(float(value), 6) for value in mesh.extents]
    report = StlReport(
        path=place,
        unit=unit,
        extent=(extent[0], extent[1], extent[2]),
        triangles=len(mesh.faces),
        watertight=bool(mesh.is_watertight and mesh.is_winding_consistent and distinct),
        euler_number=int(mesh.euler_number),
        volume_um3=float(mesh.volume) * UNIT_UM[unit] ** 3,
        closed_form_volume_um3=closed_form_volume_um3(target, plate),
    )
    if not report.watertight or report.euler_number != 2:
        raise InvalidInputError(
            f"At scale {target.scale:g} the fiducial's mesh does not close in the 32-bit numbers of an STL.",
            hint="Use a scale nearer to 1, a larger deviation, or `--unit um`.",
        )
    _write_new(place, export_stl(mesh))
    _LOG.info("wrote %s: %d triangles", place, report.triangles)
    return report


def write_fiducial_truth(
    path: str | Path,
    fiducial: Fiducial3D | None = None,
    *,
    pixel_um: float = 1.0,
    shape: tuple[int, int] | None = None,
) -> TruthReport:
    """Write the fiducial's height at pixel centres, in um, as 32-bit numbers.

    ``.npz``: ``height_um`` (H, W), ``pixel_um``, one mask (H, W) ``section_NAME`` per section of
    :data:`~reliefscope.targets.SECTIONS`, and ``metadata``, a JSON object.  ``.tif``: the heights, row 0 on top, the
    pixel size in the resolution tags, and the JSON object as description.

    Parameters
    ----------
    path:
        A new file, ``.npz``, ``.tif`` or ``.tiff``.
    fiducial:
        The shape; the default one if left out.
    pixel_um:
        Size of a pixel on the sample.
    shape:
        (H, W), the fiducial in the middle; just the square that holds the features if left out.

    Raises
    ------
    OutputExistsError
        The file exists; it is left alone.
    InvalidInputError
        Another suffix, a pixel size or a shape that makes no image.
    DatasetError
        The file could not be written.
    """
    place = Path(path)
    check_outputs(truth=place)
    target = fiducial or Fiducial3D()
    if not (math.isfinite(pixel_um) and pixel_um > 0):
        raise InvalidInputError(
            f"A pixel of {pixel_um:g} um makes no image.", hint="Give a pixel size above 0."
        )
    if shape is None:
        side = max(1, round(target.size_um / pixel_um))
        shape = (side, side)
    if not 1 <= shape[0] * shape[1] <= MAX_PIXELS:
        raise InvalidInputError(
            f"A truth of {shape[1]} x {shape[0]} pixels is out of bounds (1 to {MAX_PIXELS:,}).",
            hint="Give larger pixels or a smaller frame.",
        )
    height_um = target.height_um(shape, pixel_um)
    metadata = {
        "schema_version": SCHEMA_VERSION,
        "target": "fiducial",
        "seed": target.seed,
        "scale": target.scale,
        "base_um": target.base_um,
        "pixel_um": pixel_um,
        "height_unit": "um",
        "y_axis": "up",
    }
    stream = io.BytesIO()
    if place.suffix.lower() == ".npz":
        arrays: dict[str, Any] = {
            f"section_{name}": target.mask(name, shape, pixel_um) for name in SECTIONS
        }
        arrays |= {
            "height_um": height_um,
            "pixel_um": np.float64(pixel_um),
            "metadata": np.str_(json.dumps(metadata)),
        }
        np.savez_compressed(stream, **arrays)
    else:
        tags = ImageFileDirectory_v2()
        tags[_TIFF_DESCRIPTION] = json.dumps(metadata)
        tags[_TIFF_X] = tags[_TIFF_Y] = 1e4 / pixel_um
        tags[_TIFF_UNIT] = _TIFF_CENTIMETRE
        Image.fromarray(height_um).save(stream, format="TIFF", tiffinfo=tags)
    _write_new(place, stream.getvalue())
    _LOG.info("wrote %s: %d x %d", place, shape[1], shape[0])
    return TruthReport(place, shape, pixel_um, float(height_um.min()), float(height_um.max()))


def check_outputs(*, stl: Path | None = None, truth: Path | None = None) -> None:
    """Refuse names that cannot be written, before anything is.

    Raises
    ------
    OutputExistsError
        One of the files exists.
    InvalidInputError
        A suffix that is not that of the format.
    """
    for place, suffixes in ((stl, (".stl",)), (truth, (".npz", ".tif", ".tiff"))):
        if place is None:
            continue
        if place.suffix.lower() not in suffixes:
            raise InvalidInputError(
                f"{place} does not end in {' or '.join(suffixes)}.",
                hint=f"Name the file for example {place.with_suffix(suffixes[0]).name}.",
            )
        if place.exists():
            raise _exists(place)


def _write_new(place: Path, content: bytes) -> None:
    opened = False
    try:
        place.parent.mkdir(parents=True, exist_ok=True)
        with place.open("xb") as stream:
            opened = True
            stream.write(content)
    except FileExistsError:
        raise _exists(place) from None
    except OSError as error:
        if opened:
            place.unlink(missing_ok=True)
        raise DatasetError(
            f"{place} could not be written: {error.strerror or error}.",
            hint="Check the disk and the permissions of the folder.",
        ) from error


def _exists(place: Path) -> ReliefscopeError:
    return OutputExistsError(
        f"{place} exists already; nothing was changed.", hint="Give another name."
    )
