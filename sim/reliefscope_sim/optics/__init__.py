"""Light in the simulated instrument, traced from pixel and LED positions in millimetres."""

from reliefscope_sim.optics.renderer import WHITE_SIGNAL, Renderer

__all__ = ["WHITE_SIGNAL", "Renderer"]
