"""Samples for the simulated instrument, by name.

``load_scene("fiducial", seed=1, options={"finish": "metallic"}, shape=(1038, 1388), pixel_um=1.116)``
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from reliefscope.errors import InvalidInputError
from reliefscope_sim.scenes.chrome import chrome
from reliefscope_sim.scenes.fiducial import fiducial
from reliefscope_sim.scenes.heightmap import heightmap
from reliefscope_sim.scenes.options import Options, OptionValue
from reliefscope_sim.scenes.regolith import regolith
from reliefscope_sim.scenes.scene import MARGIN_PX, Scene
from reliefscope_sim.scenes.simple import flat, grid, hemisphere, plane, scale

__all__ = ["SCENES", "Scene", "load_scene"]

SceneMaker = Callable[[int, Options, tuple[int, int], float], Scene]

SCENES: dict[str, SceneMaker] = {
    "chrome": chrome,
    "fiducial": fiducial,
    "flat": flat,
    "grid": grid,
    "heightmap": heightmap,
    "hemisphere": hemisphere,
    "plane": plane,
    "regolith": regolith,
    "scale": scale,
}


def load_scene(
    name: str,
    seed: int = 0,
    options: Mapping[str, OptionValue] | None = None,
    *,
    shape: tuple[int, int],
    pixel_um: float,
) -> Scene:
    """Scene ``name`` for frames of ``shape`` (rows, columns) at ``pixel_um``, with a margin around them.

    ``seed`` draws textures and grains; ``options`` are the scene's own, as text or numbers.

    Raises
    ------
    InvalidInputError
        Unknown scene or option, or a value out of range; the hint lists what is known.
    """
    if name not in SCENES:
        raise InvalidInputError(
            f"There is no scene `{name}`.", hint=f"Use one of: {', '.join(sorted(SCENES))}."
        )
    chosen = Options(name, options)
    grid_shape = (shape[0] + 2 * MARGIN_PX, shape[1] + 2 * MARGIN_PX)
    scene = SCENES[name](seed, chosen, grid_shape, pixel_um)
    chosen.finish()
    return scene
