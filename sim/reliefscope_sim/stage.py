"""The z stage under the sample."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from reliefscope_sim.scenes.scene import Scene


def lifted(scene: Scene, stage_um: float) -> Scene:
    """The same sample moved by ``stage_um`` along z, toward the objective."""
    if stage_um == 0.0:
        return scene
    return replace(scene, height_um=scene.height_um + np.float32(stage_um))
