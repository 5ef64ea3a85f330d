"""Grains of known shape, size, place and material, poured into a heap."""

from reliefscope_sim.scenes.grains.packing import Grain, Heap, LooseGrain, pour
from reliefscope_sim.scenes.grains.shapes import FAMILIES, GrainShape, draw_shape

__all__ = ["FAMILIES", "Grain", "GrainShape", "Heap", "LooseGrain", "draw_shape", "pour"]
