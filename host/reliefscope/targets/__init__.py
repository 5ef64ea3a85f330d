"""Objects of known shape: the 3D fiducial, grid and scale, from which truth and simulated samples are made."""

from reliefscope.targets.fiducial import SECTIONS, Fiducial3D, Hemisphere, Section, SlantedPlane
from reliefscope.targets.patterns import grid_coverage, scale_coverage

__all__ = [
    "SECTIONS",
    "Fiducial3D",
    "Hemisphere",
    "Section",
    "SlantedPlane",
    "grid_coverage",
    "scale_coverage",
]
