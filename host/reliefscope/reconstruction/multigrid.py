"""Multigrid for networks of springs on a pixel grid.

The operator is ``hold z + sum over neighbours of w (z - z_neighbour)``: a weight ``hold`` per pixel
(what holds the height) and a weight ``w`` per pair of neighbours (what holds the slope).  One
V-cycle costs a few passes over the image and takes an error down at every scale at once; as a
preconditioner it makes the number of conjugate-gradient iterations independent of the image size.

Interpolation follows the springs and coarse grids are Galerkin products, so that the cycle stays
positive definite and effective where springs are cut: at the edges of grains, which is where fusion
is hard. Smoothing is Gauss-Seidel in four colours, in the opposite order on the way up: the cycle
is symmetric.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numba
import numpy as np
from numpy.typing import NDArray

from reliefscope.reconstruction import multigrid_kernels as kernels
from reliefscope.units import FloatImage

_COARSEST = 30
"""Pixels at which a level is smoothed to convergence instead of coarsened further."""
_COARSEST_SWEEPS = 16
_FINEST_SWEEPS = 4
"""Sweeps on the finest level for each on the others: they are cheap there, and chains of pixels between cut springs,
which coarse grids cannot see, are smoothed nowhere else."""
_SHARED = 40_000
"""Pixels from which a level is worth the threads: on small ones they wait for each other longer than they work."""


@dataclass(frozen=True, slots=True)
class _Level:
    """One grid; ``weights`` lead from the next coarser one and are None on the coarsest.

    Arrays but ``weights`` have a margin of zeros.  ``inverse`` of the diagonal is 0 where nothing holds a pixel.
    """

    couplings: FloatImage
    inverse: FloatImage
    weights: FloatImage | None
    solution: FloatImage
    right: FloatImage
    residual: FloatImage


class Multigrid:
    """V-cycle for a network of springs.

    ``hold`` (H, W) holds pixels, ``across`` (H, W-1) and ``down`` (H-1, W) hold neighbours together:
    ``across[r, c]`` joins columns c and c + 1, ``down[r, c]`` rows r and r + 1.  Weights are not
    negative; a pixel that nothing holds is left at zero.  Arithmetic is float32: a preconditioner
    needs no more.
    """

    def __init__(
        self,
        hold: NDArray[np.floating[Any]],
        across: NDArray[np.floating[Any]],
        down: NDArray[np.floating[Any]],
        sweeps: int = 1,
    ) -> None:
        self._sweeps = sweeps
        self._levels: list[_Level] = []
        height, width = hold.shape
        couplings = np.zeros((5, height + 2, width + 2), np.float32)
        kernels.from_springs(hold, across, down, couplings)
        while height * width > _COARSEST and min(height, width) > 1:
            rows, columns = (height + 1) // 2, (width + 1) // 2
            weights = np.empty((rows, columns, 3, 3), np.float32)
            kernels.interpolation(couplings, weights)
            self._append(couplings, weights)
            coarse = np.zeros((5, rows + 2, columns + 2), np.float32)
            kernels.coarsen(couplings, weights, coarse)
            couplings, height, width = coarse, rows, columns
        self._append(couplings, None)

    def _append(self, couplings: FloatImage, weights: FloatImage | None) -> None:
        room = [np.zeros(couplings.shape[1:], np.float32) for _ in range(3)]
        diagonal = couplings[kernels.DIAGONAL]
        inverse = np.divide(1, diagonal, out=np.zeros_like(diagonal), where=diagonal > 0)
        self._levels.append(_Level(couplings, inverse, weights, *room))

    @property
    def depth(self) -> int:
        """Number of levels."""
        return len(self._levels)

    def cycle(self, residual: NDArray[np.float64], out: NDArray[np.float64]) -> None:
        """Write an approximate solution for the right-hand side ``residual`` (H, W) to ``out`` (H, W)."""
        levels = self._levels
        threads = numba.get_num_threads()
        try:
            self._down_and_up(levels, residual, threads)
        finally:
            numba.set_num_threads(threads)
        kernels.leave(levels[0].solution, out)

    def _down_and_up(
        self, levels: list[_Level], residual: NDArray[np.float64], threads: int
    ) -> None:
        kernels.enter(residual, levels[0].right)
        for level, coarser in zip(levels, [*levels[1:], None], strict=True):
            level.solution.fill(0.0)
            numba.set_num_threads(threads if level.solution.size >= _SHARED else 1)
            self._smooth(level, up=False)
            if level.weights is not None and coarser is not None:
                finest = level is levels[0]
                find_residual = kernels.residual_five if finest else kernels.residual
                find_residual(level.couplings, level.right, level.solution, level.residual)
                kernels.restrict(level.weights, level.residual, coarser.right)
        coarser = None
        for level in reversed(levels):
            numba.set_num_threads(threads if level.solution.size >= _SHARED else 1)
            if level.weights is not None and coarser is not None:
                kernels.prolong(level.weights, coarser.solution, level.solution)
            self._smooth(level, up=True)
            coarser = level

    def _smooth(self, level: _Level, *, up: bool) -> None:
        """Gauss-Seidel in two colours on the finest level, which has no diagonal neighbours, else in four."""
        finest = level is self._levels[0]
        smooth = kernels.smooth_five if finest else kernels.smooth
        colours = range(2 if finest else 4)
        sweeps = self._sweeps * (_FINEST_SWEEPS if finest else 1)
        if level.weights is None:
            sweeps = _COARSEST_SWEEPS
        for _ in range(sweeps):
            for colour in reversed(colours) if up else colours:
                smooth(level.couplings, level.inverse, level.right, level.solution, colour)
