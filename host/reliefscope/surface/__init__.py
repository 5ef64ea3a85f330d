"""Height maps of real surfaces, and the readers of the files that instruments write."""

from reliefscope.surface.height_map import HeightMap
from reliefscope.surface.readers import read_height_map

__all__ = ["HeightMap", "read_height_map"]
