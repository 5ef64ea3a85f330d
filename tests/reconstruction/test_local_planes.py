"""Local planes against least squares."""

import numpy as np

from reliefscope.reconstruction.local_planes import fit_planes


def test_planes_are_those_of_least_squares() -> None:
    rng = np.random.default_rng(1)
    rows, cols = np.mgrid[:20, :24]
    height = (40 + 3.0 * rows - 2.0 * cols + rng.normal(0, 0.5, rows.shape)).astype(np.float32)
    found = fit_planes(height, 5)
    for r, c in ((8, 9), (10, 15)):
        part = height[r - 2 : r + 3, c - 2 : c + 3].astype(np.float64).ravel()
        y, x = np.mgrid[-2:3, -2:3]
        basis = np.stack([np.ones(25), y.ravel(), x.ravel()], axis=1)
        middle, down, along = np.linalg.lstsq(basis, part, rcond=None)[0]
        residual = np.sqrt(np.mean((part - basis @ [middle, down, along]) ** 2))
        assert np.allclose(
            [found.middle[r, c], found.down[r, c], found.along[r, c], found.residual[r, c]],
            [middle, down, along, residual],
            atol=1e-3,
        )
