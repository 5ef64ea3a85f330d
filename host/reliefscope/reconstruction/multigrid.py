"""Multigrid for networks of springs on a pixel grid.

The operator is ``hold z + sum over neighbours of w (z - z_neighbour)``: a weight ``hold`` per pixel
(what holds the height) and a weight ``w`` per pair of neighbours (what holds the slope).  One cycle takes an error
down at every scale at once; as a preconditioner it makes the number of conjugate-gradient iterations independent of
the image size.

What makes this network hard is not its size but its cuts: at the edges of grains springs are 10^6 times weaker than
beside them, and between two cuts there are bands of single pixels that move as one.  Grids of every second pixel do
not see these.  The coarse problems are therefore networks of clusters, chosen by the springs: the two nodes that
are joined most strongly become a pair, two such pairs a cluster of up to four, and holds and parallel springs add up.
No cluster reaches across a cut, whatever its shape.  Pixels that their own heights hold firmly need no coarser level.

Clusters move as rigid bodies, which approximates a smooth surface poorly; two conjugate-gradient steps on every level,
each preconditioned by the next coarser one (the K-cycle), make up for it.

Sources: Y. Notay, "An aggregation-based algebraic multigrid method", Electronic Transactions on Numerical Analysis 37
(2010); A. Napov, Y. Notay, "An algebraic multigrid method with guaranteed convergence rate", SIAM Journal on
Scientific Computing 34 (2012).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numba
import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.linalg import splu

from reliefscope.reconstruction import cluster_kernels, multigrid_kernels
from reliefscope.reconstruction.cluster_kernels import Index, Vector

_COARSEST = 3000
"""Nodes at which a network is solved exactly."""
_ROUNDS = 2
"""Rounds of pairing from one level to the next."""
_DEEPEST = 12
"""Levels after which it is solved exactly in any case: nodes that no spring joins do not become fewer."""
_ENOUGH = 0.25
"""Share of the residual at which the second step on a level is left out."""
_REGULAR = 1e-6
"""Share of the diagonal that is added to it on the coarsest level, where it may be that nothing holds a network."""
_SHARED = 100_000
"""Nodes from which work is worth several threads: on fewer they wait for each other longer than they work."""


@dataclass(frozen=True, slots=True)
class _Network:
    """Springs between nodes; see :mod:`~reliefscope.reconstruction.cluster_kernels`."""

    hold: Vector
    begin: Index
    neighbour: Index
    spring: Vector

    @property
    def rows(self) -> tuple[Index, Index, Vector]:
        """Where the springs of each node are, whither they lead and how strong they are."""
        return self.begin, self.neighbour, self.spring

    def diagonal(self) -> Vector:
        """What each node is held with while all others stay."""
        out = np.empty_like(self.hold)
        cluster_kernels.diagonal(self.hold, self.begin, self.spring, out)
        return out


@dataclass(frozen=True, slots=True)
class _Clusters:
    """The cluster of each node (-1: none), and the nodes of cluster k: ``members[first[k] : first[k + 1]]``."""

    label: Index
    first: Index
    members: Index


class _Level:
    """A network of clusters, what they consist of, and room for the vectors of a cycle."""

    def __init__(self, network: _Network, clusters: _Clusters) -> None:
        self.network = network
        self.clusters = clusters
        nodes = len(network.hold)
        diagonal = network.diagonal()
        self.inverse = np.divide(1, diagonal, out=np.zeros_like(diagonal), where=diagonal > 0)
        self.lower, self.upper = np.empty(nodes, np.int32), np.empty(nodes, np.int32)
        cluster_kernels.arrange(*network.rows, self.lower, self.upper)
        self.right, self.z, self.first, self.pulled, self.left, self.before = (
            np.empty(nodes, np.float32) for _ in range(6)
        )

    def pull(self, right: Vector, z: Vector) -> None:
        """Write what the network pulls with at ``z``, which was just swept backward for ``right``."""
        network = self.network
        cluster_kernels.pull_after(
            network.begin,
            self.lower,
            self.upper,
            network.neighbour,
            network.spring,
            right,
            self.before,
            z,
            self.pulled,
        )


class Multigrid:
    """Cycle for a network of springs.

    ``hold`` (H, W) holds pixels, ``across`` (H, W-1) and ``down`` (H-1, W) hold neighbours together:
    ``across[r, c]`` joins columns c and c + 1, ``down[r, c]`` rows r and r + 1.  Weights are not
    negative; a pixel that nothing holds is left at zero.  Arithmetic is float32: a preconditioner
    needs no more.

    The cycle is not quite linear in the residual: the iteration around it must allow for that (flexible conjugate
    gradients).
    """

    def __init__(
        self,
        hold: NDArray[np.floating[Any]],
        across: NDArray[np.floating[Any]],
        down: NDArray[np.floating[Any]],
    ) -> None:
        height, width = hold.shape
        self._east, self._south, self._inverse, self._right, self._z, self._residual = (
            np.zeros((height + 2, width + 2), np.float32) for _ in range(6)
        )
        multigrid_kernels.from_springs(hold, across, down, self._east, self._south, self._inverse)
        self._levels: list[_Level] = []
        network = _network_of_grid(hold, across, down)
        while len(network.hold) > _COARSEST and len(self._levels) < _DEEPEST:
            with _Threads(len(network.hold)):
                network, clusters = _clustered(network)
                self._levels.append(_Level(network, clusters))
        self._exact = _exact(network)
        self._pixels = _with_margin(self._levels[0].clusters if self._levels else None, width)

    @property
    def depth(self) -> int:
        """Number of levels."""
        return 1 + len(self._levels)

    def cycle(self, residual: NDArray[np.float64], out: NDArray[np.float64]) -> None:
        """Write an approximate solution for the right-hand side ``residual`` (H, W) to ``out`` (H, W)."""
        if not self._levels:
            out[...] = self._exact(residual.ravel()).reshape(out.shape)
            return
        kernels = multigrid_kernels
        springs = self._east, self._south
        coarser = self._levels[0]
        clusters = coarser.clusters
        with _Threads(out.size):
            kernels.start(residual, self._inverse, self._right, self._z)
            kernels.smooth(*springs, self._inverse, self._right, self._z, 1)
            kernels.remainder(*springs, self._z, self._residual)
            cluster_kernels.gather(
                clusters.first, self._pixels, self._residual.ravel(), coarser.right
            )
        self._approach(0)
        with _Threads(out.size):
            kernels.spread(clusters.label, coarser.z, self._z)
            kernels.smooth(*springs, self._inverse, self._right, self._z, 1)
            kernels.smooth(*springs, self._inverse, self._right, self._z, 0)
            kernels.leave(self._z, out)

    def _approach(self, depth: int) -> None:
        """Solve a level for its right-hand side, by up to two steps of flexible conjugate gradients."""
        level = self._levels[depth]
        if depth == len(self._levels) - 1:
            level.z[...] = self._exact(level.right)
            return
        inner, combine = cluster_kernels.inner, cluster_kernels.combine
        first, pulled, left, z = level.first, level.pulled, level.left, level.z
        with _Threads(len(z)):
            self._cycle(depth, level.right, first)
            level.pull(level.right, first)
            curvature = inner(first, pulled)
            if curvature <= 0.0:
                z.fill(0.0)
                return
            step = inner(first, level.right) / curvature
            combine(1.0, level.right, -step, pulled, left)
            if inner(left, left) <= _ENOUGH**2 * inner(level.right, level.right):
                np.multiply(first, np.float32(step), out=z)
                return
            self._cycle(depth, left, z)
            common = inner(z, pulled) / curvature
            level.pull(left, z)
            own = inner(z, pulled) - common**2 * curvature
            second = inner(z, left) / own if own > 0.0 else 0.0
            combine(step - common * second, first, second, z, z)

    def _cycle(self, depth: int, right: Vector, out: Vector) -> None:
        """One symmetric cycle of a level: sweep, correction of the coarser level, sweep in the opposite order."""
        kernels = cluster_kernels
        level, coarser = self._levels[depth], self._levels[depth + 1]
        network, clusters = level.network, coarser.clusters
        springs = network.neighbour, network.spring
        kernels.sweep_forward(network.begin, level.lower, *springs, level.inverse, right, out)
        kernels.remainder(network.begin, level.lower, *springs, out, level.before)
        kernels.gather(clusters.first, clusters.members, level.before, coarser.right)
        self._approach(depth + 1)
        kernels.spread(clusters.label, coarser.z, out, level.before)
        kernels.sweep_backward(
            network.begin, level.upper, *springs, level.inverse, right, level.before, out
        )


class _Threads:
    """One thread for small problems, those allowed for large ones."""

    def __init__(self, nodes: int) -> None:
        self._one = nodes < _SHARED
        self._allowed = 1

    def __enter__(self) -> None:
        self._allowed = numba.get_num_threads()
        if self._one:
            numba.set_num_threads(1)

    def __exit__(self, *_: object) -> None:
        numba.set_num_threads(self._allowed)


def _network_of_grid(
    hold: NDArray[np.floating[Any]],
    across: NDArray[np.floating[Any]],
    down: NDArray[np.floating[Any]],
) -> _Network:
    nodes = hold.size
    network = _Network(
        hold.ravel().astype(np.float32),
        np.empty(nodes + 1, np.int32),
        np.empty(4 * nodes, np.int32),
        np.empty(4 * nodes, np.float32),
    )
    cluster_kernels.network_of_grid(across, down, *network.rows)
    return network


def _clustered(network: _Network) -> tuple[_Network, _Clusters]:
    """Clusters of clusters, and the network between them."""
    joint, clusters, stiffness = _joined(network, network.diagonal())
    label = clusters.label
    for _ in range(_ROUNDS - 1):
        joint, clusters, stiffness = _joined(joint, stiffness)
        label = np.append(clusters.label, np.int32(-1))[label]  # none stays none
    return joint, _numbered(label, len(joint.hold))


def _joined(network: _Network, stiffness: Vector) -> tuple[_Network, _Clusters, Vector]:
    """Network between clusters of two or three nodes, the clusters, and the sums of their nodes' stiffness."""
    kernels = cluster_kernels
    label = np.empty(len(network.hold), np.int32)
    count = kernels.cluster(network.hold, *network.rows, stiffness, label)
    clusters = _numbered(label, count)
    hold, total = np.empty(count, np.float32), np.empty(count, np.float32)
    begin, loose_begin = np.empty(count + 1, np.int32), np.empty(count + 1, np.int32)
    kernels.room(network.begin, clusters.first, clusters.members, loose_begin)
    loose = _Network(hold, loose_begin, *_springs(loose_begin))
    kernels.join(
        network.hold,
        *network.rows,
        stiffness,
        label,
        clusters.first,
        clusters.members,
        hold,
        total,
        begin,
        loose.begin,
        loose.neighbour,
        loose.spring,
    )
    joint = _Network(hold, begin, *_springs(begin))
    kernels.pack(*loose.rows, *joint.rows)
    return joint, clusters, total


def _springs(begin: Index) -> tuple[Index, Vector]:
    """Room for the springs that ``begin`` divides among nodes."""
    return np.empty(begin[-1], np.int32), np.empty(begin[-1], np.float32)


def _numbered(label: Index, count: int) -> _Clusters:
    first, members = np.empty(count + 1, np.int32), np.empty(len(label), np.int32)
    cluster_kernels.members_of(label, first, members)
    return _Clusters(label, first, members[: first[-1]])


def _with_margin(clusters: _Clusters | None, width: int) -> Index:
    """Members of clusters of pixels of an image of ``width`` columns, numbered in the image with its margin."""
    if clusters is None:
        return np.empty(0, np.int32)
    rows, columns = np.divmod(clusters.members, np.int32(width))
    numbered: Index = (rows + np.int32(1)) * np.int32(width + 2) + columns + np.int32(1)
    return numbered


def _exact(network: _Network) -> Callable[[NDArray[np.floating[Any]]], NDArray[np.float64]]:
    """Solver of a network for a right-hand side (nodes,)."""
    nodes = len(network.hold)
    if nodes == 0:
        return lambda right: right.astype(np.float64)
    diagonal = network.diagonal().astype(np.float64)
    diagonal = np.where(diagonal > 0.0, diagonal * (1.0 + _REGULAR), 1.0)
    springs = sparse.csr_array((network.spring, network.neighbour, network.begin), (nodes, nodes))
    matrix = sparse.diags_array(diagonal) - springs.astype(np.float64)
    factors = splu(matrix.tocsc(), permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True})
    return lambda right: factors.solve(right.astype(np.float64))
