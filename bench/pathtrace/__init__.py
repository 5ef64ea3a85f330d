"""The simulated instrument beside an independent path tracer, Mitsuba 3 (optional extra ``pathtrace``).

``python -m bench.pathtrace`` has two commands: ``compare`` renders the same frames with both and writes figures
and pictures; ``frames`` makes a set of photographs with the path tracer alone, for ``reliefscope import``.

Nothing here uses the simulated instrument's rays, nor the host's functions bitmap -> slope and LED -> direction:
the scene is a triangle mesh, the LEDs are luminous discs at their positions in millimetres, and rays start at
points of open glass pixels in millimetres.
"""
