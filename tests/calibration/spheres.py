"""Pictures of mirroring spheres."""

import numpy as np

from reliefscope.calibration.light_probe import Sphere

SPHERE = Sphere(column=70.0, row=58.0, radius=50.0)


def photograph(light: np.ndarray, shape: tuple[int, int] = (120, 140)) -> np.ndarray:
    """A mirroring sphere: the reflected ray of each pixel, with a lamp of a few degrees."""
    rows, columns = np.indices(shape)
    nx = (columns - SPHERE.column) / SPHERE.radius
    ny = (SPHERE.row - rows) / SPHERE.radius
    nz = np.sqrt(np.maximum(1 - nx**2 - ny**2, 0))
    mirrored = np.stack([2 * nz * nx, 2 * nz * ny, 2 * nz**2 - 1], axis=-1)
    image = 0.02 + np.exp((mirrored @ light - 1) / 0.004)
    image[nz == 0] = 0.9  # a bright background must not win
    return image
