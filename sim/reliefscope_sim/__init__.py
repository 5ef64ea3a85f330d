"""The simulated instrument: compiled firmware core, virtual parts, optics."""
