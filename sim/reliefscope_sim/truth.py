"""What really lies under a simulated instrument, as files: heights, grains, and what they are made of."""

from __future__ import annotations

import csv
import io
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from reliefscope.errors import DatasetError, InvalidInputError, OutputExistsError
from reliefscope_sim.scenes import Scene, load_scene
from reliefscope_sim.scenes.grains import Grain
from reliefscope_sim.scenes.scene import MARGIN_PX
from reliefscope_sim.stage import lifted
from reliefscope_sim.url import SimUrl

COLUMNS = (
    "grain", "name", "x_um", "y_um", "z_um", "volume_um3", "radius_um", "long_um", "middle_um", "short_um",
    "visible_um2",
)  # fmt: skip
"""Columns of the table of grains."""


@dataclass(frozen=True)
class Truth:
    """The sample of one instrument, cut to the frame."""

    scene: Scene
    """On the frame's grid (H, W)."""

    @classmethod
    def under(cls, url: str) -> Truth:
        """The sample under the instrument of an address, at the height of its stage.

        Raises
        ------
        InvalidInputError
            The address or the scene is not possible.
        """
        instrument = SimUrl.parse(url)
        profile = instrument.load_profile()
        scene = load_scene(
            instrument.scene,
            instrument.seed,
            dict(instrument.scene_options),
            shape=profile.shape,
            pixel_um=profile.pixel_um,
        )
        return cls(_cropped(lifted(scene, instrument.stage_um)))

    @property
    def grains(self) -> tuple[Grain, ...]:
        """Grains of the heap, whether they show or not; none where the sample has no grains."""
        return tuple(grain for grain in self.scene.grains if isinstance(grain, Grain))

    def arrays(self) -> dict[str, Any]:
        """Maps (H, W) of the frame: ``height_um``, ``albedo``, where there are ``grain_index`` and gloss."""
        scene = self.scene
        maps = {
            "height_um": scene.height_um,
            "pixel_um": np.float64(scene.pixel_um),
            "albedo": scene.albedo,
            "specular": scene.specular,
            "roughness": scene.roughness,
            "grain_index": scene.grain_index,
        }
        return {name: values for name, values in maps.items() if values is not None}

    def rows(self) -> list[tuple[int | float | str, ...]]:
        """One row per grain, see :data:`COLUMNS`; (x, y, z) is the centre of mass, lengths along principal axes."""
        index = self.scene.grain_index
        if index is None:
            return []
        pixels = np.bincount(index[index >= 0], minlength=len(self.grains))
        area_um2 = pixels * self.scene.pixel_um**2
        return [
            (
                number,
                grain.name,
                *(round(value, 3) for value in grain.centre_um),
                round(grain.volume_um3, 1),
                round(grain.radius_um, 3),
                *(round(value, 3) for value in grain.size_um),
                round(float(area_um2[number]), 1),
            )
            for number, grain in enumerate(self.grains)
        ]

    def save(self, out: Path, grains: Path | None = None) -> None:
        """Write the maps to ``out`` (.npz) and the table of grains to ``grains`` (.csv).

        Raises
        ------
        OutputExistsError
            A file is there already; nothing is written.
        InvalidInputError
            A wrong suffix, or a table is wanted of a sample without grains.
        DatasetError
            A file cannot be written.
        """
        for place, suffix in ((out, ".npz"), (grains, ".csv")):
            if place is not None and place.suffix.lower() != suffix:
                raise InvalidInputError(
                    f"{place} does not end in {suffix}.", hint=f"Choose a name with {suffix}."
                )
            if place is not None and place.exists():
                raise OutputExistsError(f"{place} exists.", hint="Choose another name.")
        if grains is not None and not self.grains:
            raise InvalidInputError(
                f"Scene `{self.scene.name}` has no grains.", hint="Leave --grains out."
            )
        content = io.BytesIO()
        np.savez_compressed(content, **self.arrays())
        _write(out, content.getvalue())
        if grains is not None:
            table = io.StringIO(newline="")
            writer = csv.writer(table)
            writer.writerow(COLUMNS)
            writer.writerows(self.rows())
            _write(grains, table.getvalue().encode("utf-8"))


def _cropped(scene: Scene) -> Scene:
    """The part of a scene that the frame shows, without the margin around it."""
    inside = (slice(MARGIN_PX, -MARGIN_PX), slice(MARGIN_PX, -MARGIN_PX))

    def cut(values: Any) -> Any:
        return None if values is None else np.ascontiguousarray(values[inside])

    return Scene(
        scene.name,
        scene.pixel_um,
        cut(scene.height_um),
        cut(scene.albedo),
        cut(scene.specular),
        cut(scene.roughness),
        diffuse_sigma_rad=cut(scene.diffuse_sigma_rad),
        hapke=cut(scene.hapke),
        grain_index=cut(scene.grain_index),
        grains=scene.grains,
    )


def _write(place: Path, content: bytes) -> None:
    """Write a new file, whole or not at all."""
    making = place.with_name(f"{place.name}.partial")
    try:
        place.parent.mkdir(parents=True, exist_ok=True)
        making.write_bytes(content)
        making.replace(place)
    except OSError as error:
        raise DatasetError(
            f"{place} cannot be written: {error.strerror or error}.", hint="Choose another place."
        ) from error
