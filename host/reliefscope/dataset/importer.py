"""Photographs of any instrument, plus a small YAML that tells about them, become a run."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import cv2
import numpy as np
from numpy.typing import NDArray

from reliefscope.dataset.durable import disk_error, write_file
from reliefscope.dataset.import_spec import PhotographSet, load_photograph_set
from reliefscope.dataset.pictures import read_picture
from reliefscope.dataset.records import FrameRecord, SourceFile, pixel_hash
from reliefscope.dataset.run import MASK_FILE, Run
from reliefscope.dataset.spec import FrameFormat, ImportedSpec, RunSpec
from reliefscope.dataset.writer import RunWriter, check_output, now, software_name
from reliefscope.errors import InvalidInputError
from reliefscope.jobs import Job, ensure_job
from reliefscope.units import RawImage

LUMINANCE_WEIGHTS = np.array([0.2126, 0.7152, 0.0722], dtype=np.float32)
"""Rec. 709 weights of linear red, green and blue."""


@dataclass(frozen=True)
class _Photograph:
    """Decoded file: (H, W) or (H, W, 3) with red first."""

    pixels: RawImage
    source: SourceFile


def import_photographs(description: Path, out: Path, job: Job | None = None) -> Run:
    """Turn photographs into the run ``out``.

    Grey linear photographs and mosaics are stored count for count.  Colour photographs become luminance (Rec.
    709 weights on linear light), photographs with the sRGB curve become linear; both are then stored with 16
    bits.  Every file is read and checked before ``out`` is touched.

    Raises
    ------
    InvalidInputError
        If the description or a photograph is wrong; the message names it.
    OutputExistsError
        If ``out`` exists.
    """
    photographs = load_photograph_set(description)
    folder = description.parent / photographs.folder
    files = photographs.files()
    check_output(out)
    job = ensure_job(job)
    with job.stage("check photographs", len(files) + len(photographs.dark_files)) as stage:
        shape, converted = None, False
        for name in [*files.values(), *photographs.dark_files]:
            photograph = _read(folder, name, photographs)
            if shape is not None and photograph.pixels.shape[:2] != shape:
                raise InvalidInputError(
                    f"{folder / name} has {_size(photograph.pixels.shape)} pixels, the others "
                    f"{_size(shape)}.",
                    hint="All photographs of a set must come from one camera at one setting.",
                )
            shape = photograph.pixels.shape[:2]
            converted |= photograph.pixels.ndim == 3 or photographs.transfer == "srgb"
            stage.advance(note=name)
    assert shape is not None  # a set holds at least one photograph
    mask = _mask(folder, photographs, shape)
    spec = _run_spec(photographs, description, shape, mask, converted=converted)
    with RunWriter.create(out, spec) as writer:
        if mask is not None:
            _write_mask(writer.folder / MASK_FILE, mask)
        with job.stage("import", sum(1 for _ in spec.requests())) as stage:
            for request in writer.missing():
                if request.kind == "dark":
                    names: tuple[str, ...] = photographs.dark_files
                else:
                    assert request.view is not None  # an imported frame has both
                    assert request.light is not None
                    names = (files[request.view, request.light],)
                taken = [_read(folder, name, photographs) for name in names]
                counts = [_stored(photograph, photographs, converted) for photograph in taken]
                dtype = spec.frame.dtype(len(counts))
                record = FrameRecord(
                    kind=request.kind,
                    view=request.view,
                    light=request.light,
                    accumulated=len(counts),
                    sources=tuple(photograph.source for photograph in taken),
                    time=now(),
                )
                writer.put(record, _sum(counts, dtype))
                stage.advance(note=names[0])
        return Run.open(writer.finish(job))


def _read(folder: Path, name: str, photographs: PhotographSet) -> _Photograph:
    path = folder / name
    pixels, data = read_picture(
        path, hint="Check `folder`, `frames` or `pattern`, and `first` in the description."
    )
    if pixels.ndim == 3 and photographs.sensor == "bayer_rggb":
        raise InvalidInputError(
            f"{path} is a colour picture, but the description says `sensor: bayer_rggb`.",
            hint="Give the raw mosaic as a grey picture, or say `sensor: mono`.",
        )
    if pixels.dtype == np.uint8 and photographs.bit_depth > 8:
        raise InvalidInputError(
            f"{path} has 8 bits per channel, but the description says "
            f"`bit_depth: {photographs.bit_depth}`.",
            hint="Say `bit_depth: 8`, or give the pictures as 16-bit files.",
        )
    top = (1 << photographs.bit_depth) - 1
    if int(pixels.max()) > top:
        raise InvalidInputError(
            f"{path} holds counts up to {int(pixels.max())}, more than {photographs.bit_depth} bits.",
            hint="Correct `bit_depth`; pictures that were scaled to 16 bits have `bit_depth: 16`.",
        )
    return _Photograph(pixels, SourceFile(file=name, sha256=hashlib.sha256(data).hexdigest()))


def _stored(photograph: _Photograph, photographs: PhotographSet, converted: bool) -> RawImage:
    """Counts as they are stored: unchanged, or 16-bit linear luminance."""
    pixels = photograph.pixels
    if not converted:
        return pixels
    light = pixels.astype(np.float32) / np.float32((1 << photographs.bit_depth) - 1)
    if photographs.transfer == "srgb":
        light = srgb_to_linear(light)
    if light.ndim == 3:
        light = light @ LUMINANCE_WEIGHTS
    stored: NDArray[np.uint16] = np.rint(np.clip(light, 0, 1) * 0xFFFF).astype(np.uint16)
    return stored


def _sum(counts: list[RawImage], dtype: Literal["uint8", "uint16"]) -> RawImage:
    """Exact sum of counts; the specification holds that it fits."""
    total = np.zeros(counts[0].shape, dtype=np.uint16)
    for one in counts:
        total += one
    return total if dtype == "uint16" else total.astype(np.uint8)


def srgb_to_linear(value: NDArray[np.float32]) -> NDArray[np.float32]:
    """Linear light 0..1 of sRGB values 0..1 (IEC 61966-2-1)."""
    linear = np.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4)
    return linear.astype(np.float32)


def _run_spec(
    photographs: PhotographSet,
    description: Path,
    shape: tuple[int, ...],
    mask: NDArray[np.uint8] | None,
    *,
    converted: bool,
) -> RunSpec:
    bit_depth = 16 if converted else photographs.bit_depth
    darks = len(photographs.dark_files)
    if darks * ((1 << bit_depth) - 1) > 0xFFFF:
        raise InvalidInputError(
            f"The sum of {darks} dark photographs of {bit_depth} bits does not fit into 16 bits.",
            hint=f"Give at most {0xFFFF // ((1 << bit_depth) - 1)}.",
        )
    conversion = ""
    if converted:
        conversion = (
            f"{photographs.bit_depth}-bit {photographs.transfer} to 16-bit linear luminance"
        )
    return RunSpec(
        created=now(),
        software=software_name(),
        sample=photographs.sample,
        notes=photographs.notes,
        frame=FrameFormat(
            rows=shape[0],
            columns=shape[1],
            sensor=photographs.sensor,
            bit_depth=bit_depth,
            black_level=photographs.black_level,
        ),
        imported=ImportedSpec(
            source=description.name,
            pixel_um=photographs.pixel_um,
            height_range_um=photographs.height_range_um,
            views=photographs.imported_views(),
            lights=photographs.imported_lights(),
            dark_accumulate=darks,
            mask_sha256=None if mask is None else pixel_hash(mask),
            conversion=conversion,
        ),
    )


def _mask(
    folder: Path, photographs: PhotographSet, shape: tuple[int, ...]
) -> NDArray[np.uint8] | None:
    if photographs.mask is None:
        return None
    if photographs.mask.circle is not None:
        circle = photographs.mask.circle
        rows, columns = np.ogrid[: shape[0], : shape[1]]
        valid = np.hypot(rows - circle.row, columns - circle.column) <= circle.radius_px
    else:
        assert photographs.mask.file is not None  # the validator holds it
        path = folder / photographs.mask.file
        pixels = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE) if path.exists() else None
        if pixels is None or pixels.shape != shape:
            found = "cannot be read" if pixels is None else f"has {_size(pixels.shape)} pixels"
            raise InvalidInputError(
                f"The mask {path} {found}; the photographs have {_size(shape)}.",
                hint="Give a picture of the photographs' size, white where they are valid.",
            )
        valid = pixels > 127
    if not valid.any():
        raise InvalidInputError("The mask leaves no valid pixel.", hint="Correct `mask`.")
    return np.where(valid, np.uint8(255), np.uint8(0))


def _write_mask(path: Path, mask: NDArray[np.uint8]) -> None:
    _, encoded = cv2.imencode(".png", mask)
    try:
        write_file(path, encoded.tobytes())
    except OSError as error:
        raise disk_error(error, path) from error


def _size(shape: tuple[int, ...]) -> str:
    return f"{shape[1]}x{shape[0]}"
