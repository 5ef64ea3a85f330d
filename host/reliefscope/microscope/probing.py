"""Lights found from photographs of mirroring spheres, or from those of the sample itself."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from reliefscope.dataset.import_spec import load_lights
from reliefscope.errors import DatasetError, InvalidInputError, OutputExistsError
from reliefscope.jobs import Job
from reliefscope.models.base import load_model

if TYPE_CHECKING:
    from reliefscope.calibration.probe_photographs import ProbedLights
    from reliefscope.reconstruction.light_estimation import LightEstimate


def calibrate_lights(
    description: Path | str,
    *,
    compare: Path | str | None = None,
    out: Path | str | None = None,
    job: Job | None = None,
) -> ProbedLights:
    """Directions of the lights from photographs of spheres, by the YAML file ``description``.

    Parameters
    ----------
    description:
        Spheres and files, see docs/guide/other-instruments.
    compare:
        YAML file with the key ``lights``, such as an import description: directions to compare with.
    out:
        YAML file to write; an import description takes it as ``lights: FILE``.
    job:
        Receives progress; may cancel.

    Raises
    ------
    InvalidInputError
        A wrong description, or a photograph without a highlight; nothing was written.
    OutputExistsError
        ``out`` exists.
    """
    from reliefscope.calibration.probe_photographs import LightProbeSet, probe_lights

    source = Path(description)
    probes = load_model(LightProbeSet, source)
    given = None if compare is None else _given(Path(compare))
    place = _new_file(out)
    lights = probe_lights(probes, source.parent, given, job)
    if place is not None:
        _write(lights, place, source)
    return lights


def estimate_lights(
    run: Path | str,
    *,
    reflectance: float | None = None,
    out: Path | str | None = None,
    job: Job | None = None,
) -> LightEstimate:
    """Near lights from the first view of a run whose sample is level, of one colour and matt for the most part.

    Parameters
    ----------
    run:
        Folder of the run; lights that its description gives are not looked at.
    reflectance:
        That of the sample, 0 to 1; a light grey coating's if left out.
    out:
        YAML file to write; an import description takes it as ``lights: FILE``.
    job:
        Receives progress; may cancel.

    Raises
    ------
    DatasetError
        The run cannot be read.
    InvalidInputError
        A sample that does not tell its lights; nothing was written.
    OutputExistsError
        ``out`` exists.
    """
    from reliefscope.dataset import Run
    from reliefscope.reconstruction import light_estimation

    place = _new_file(out)
    opened = Run.open(run)
    found = light_estimation.estimate_lights(
        opened.linear_stack(view=0, job=job),
        opened.pixel_um,
        reflectance=light_estimation.REFLECTANCE if reflectance is None else reflectance,
    )
    if place is not None:
        rows = [
            f"  - position_mm: {_numbers(position)}\n    power: {power:.5f}\n    level: {_numbers(level)}\n"
            for position, power, level in zip(
                found.positions_mm, found.powers, found.level, strict=True
            )
        ]
        _write_lights(place, f"Places of the lights, estimated from {opened.name}", "".join(rows))
    return found


def estimate_powers(
    run: Path | str, *, out: Path | str | None = None, job: Job | None = None
) -> NDArray[np.float64]:
    """Brightness (L,) of the lights, of mean 1, from the view of a run nearest to s = 0; their directions are known.

    Parameters
    ----------
    run:
        Folder of the run; its sample must be matt, with slopes to all sides.
    out:
        YAML file to write; an import description takes it as ``lights: FILE``.
    job:
        Receives progress; may cancel.

    Raises
    ------
    DatasetError
        The run cannot be read.
    InvalidInputError
        A direction is not known, there are fewer than five lights, or the sample does not tell their powers;
        nothing was written.
    OutputExistsError
        ``out`` exists.
    """
    from reliefscope.dataset import Run
    from reliefscope.reconstruction.light_estimation import refine_powers

    place = _new_file(out)
    opened = Run.open(run)
    field, directions = opened.light_field, opened.lights
    if field is None or directions is None:
        raise InvalidInputError(
            "The direction of a light is not known, so its power cannot be told from what slopes do.",
            hint="Give `direction: [x, y, z]` for every light, or leave `--powers` out on a level sample.",
        )
    slopes = opened.views
    nearest = 0 if slopes is None else int(np.argmin(np.linalg.norm(slopes, axis=1)))
    images = opened.linear_stack(view=nearest, job=job)
    powers = opened.powers * refine_powers(images, field, opened.pixel_um)
    powers /= powers.mean()
    if place is not None:
        described = opened.spec.imported.lights if opened.spec.imported is not None else ()
        places = [light.position_mm for light in described if light.position_mm is not None]
        near = len(places) == len(powers)
        rows = [
            f"  - {'position_mm' if near else 'direction'}: {_numbers(vector)}\n    power: {power:.5f}\n"
            for vector, power in zip(places if near else directions, powers, strict=True)
        ]
        _write_lights(place, f"Powers of the lights, estimated from {opened.name}", "".join(rows))
    return powers


def _given(path: Path) -> NDArray[np.float64]:
    listed = load_lights(path).lights
    known = [light.direction for light in listed if light.direction is not None]
    if len(known) < len(listed):
        raise InvalidInputError(
            f"{path} gives no direction for {len(listed) - len(known)} of its lights.",
            hint="Give `direction: [x, y, z]` for every light to compare with.",
        )
    return np.array(known)


def _write(lights: ProbedLights, place: Path, source: Path) -> None:
    rows = "".join(
        f"  - {{direction: {_numbers(vector)}}}  # {photograph}\n"
        for vector, photograph in zip(lights.directions, lights.photographs, strict=True)
    )
    _write_lights(place, f"Toward the lights, from {source.name}", rows)


def _numbers(values: Iterable[float]) -> str:
    return f"[{', '.join(f'{value:.5f}' for value in values)}]"


def _write_lights(place: Path, title: str, rows: str) -> None:
    text = f"# {title}\ny_axis: up\nlights:\n{rows}"
    try:
        place.parent.mkdir(parents=True, exist_ok=True)
        with place.open("x", encoding="utf-8") as stream:
            stream.write(text)
    except FileExistsError:
        raise _exists(place) from None
    except OSError as error:
        raise DatasetError(
            f"{place} could not be written: {error.strerror or error}.",
            hint="Check the disk and the permissions of the folder.",
        ) from error


def _new_file(out: Path | str | None) -> Path | None:
    """File to write, if any; refused before the work where it exists."""
    place = None if out is None else Path(out)
    if place is not None and place.exists():
        raise _exists(place)
    return place


def _exists(place: Path) -> OutputExistsError:
    return OutputExistsError(
        f"{place} exists already; nothing was changed.", hint="Give `--out` another name."
    )
