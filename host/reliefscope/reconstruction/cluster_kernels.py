"""Compiled parts of the multigrid below the pixel grid: networks of springs between clusters of pixels.

A network is stored row by row: node i is held by ``hold[i]`` and joined to ``neighbour[e]`` by ``spring[e]`` for
``begin[i] <= e < begin[i + 1]``; both ends list a spring.  All is float32 but inner products, which are summed as
float64.

Nodes are worked on in chunks of fixed size, one thread to a chunk: what crosses from one chunk to another waits for
the next pass, so that no result depends on the number of threads.
"""

from __future__ import annotations

import numpy as np
from numba import njit, prange
from numpy.typing import NDArray

from reliefscope.units import FloatArray

Vector = NDArray[np.float32]
Index = NDArray[np.int32]

CHUNK = 32768
"""Nodes to a chunk."""
WORST = 4.0
"""Two nodes of stiffness a and b may become a cluster where a b / (a + b) is at most this multiple of their spring: the
bound of a pair's quality (Napov and Notay 2012)."""
HELD = 0.25
"""Nodes whose hold is a larger share of their stiffness are left to the sweeps."""
LARGEST = 3
"""Nodes to a cluster at most."""

_ALONE, _OPEN = -1, -2
"""Labels of a node that belongs to no cluster, and of one that has none yet."""


@njit(cache=True, parallel=True)
def network_of_grid(
    across: FloatArray, down: FloatArray, begin: Index, neighbour: Index, spring: Vector
) -> None:
    """Springs across (H, W-1) and down (H-1, W) as a network of pixels, which are numbered row by row.

    Each has four springs; those of the border that would lead out of the image have no strength.
    """
    height, width = across.shape[0], down.shape[1]
    begin[0] = 0
    for row in prange(height):
        for column in range(width):
            node = row * width + column
            entry = 4 * node
            begin[node + 1] = entry + 4
            for side in range(4):
                neighbour[entry + side] = node
                spring[entry + side] = 0.0
            if row > 0:
                neighbour[entry] = node - width
                spring[entry] = down[row - 1, column]
            if column > 0:
                neighbour[entry + 1] = node - 1
                spring[entry + 1] = across[row, column - 1]
            if column < width - 1:
                neighbour[entry + 2] = node + 1
                spring[entry + 2] = across[row, column]
            if row < height - 1:
                neighbour[entry + 3] = node + width
                spring[entry + 3] = down[row, column]


@njit(cache=True, parallel=True)
def diagonal(hold: Vector, begin: Index, spring: Vector, out: Vector) -> None:
    """What a node is held with while all others stay."""
    for node in prange(len(hold)):
        total = hold[node]
        for entry in range(begin[node], begin[node + 1]):
            total += spring[entry]
        out[node] = total


@njit(cache=True, parallel=True)
def cluster(
    hold: Vector,
    begin: Index,
    neighbour: Index,
    spring: Vector,
    stiffness: Vector,
    label: Index,
) -> int:
    """Number (``label``) the clusters of nodes that are joined most strongly; returns how many there are.

    A node makes a pair with the one to which it is joined most strongly among those left over, or else joins the
    pair of its strongest neighbour.  The spring must be strong beside the ``stiffness`` of the two: what sweeps of
    the finer network meet with when they move one against the other.  Nodes that are held firmly by themselves
    belong to no cluster: -1.
    """
    nodes = len(label)
    chunks = (nodes + CHUNK - 1) // CHUNK
    counts = np.zeros(chunks + 1, np.int64)
    for chunk in prange(chunks):
        low, high = chunk * CHUNK, min((chunk + 1) * CHUNK, nodes)
        sizes = np.zeros(high - low, np.int8)
        for node in range(low, high):
            alone = hold[node] >= np.float32(HELD) * stiffness[node]
            label[node] = _ALONE if alone else _OPEN
        count = 0
        for node in range(low, high):
            if label[node] != _OPEN:
                continue
            strongest = pull = np.float32(0.0)
            nearest = chosen = -1
            for entry in range(begin[node], begin[node + 1]):
                other, force = neighbour[entry], spring[entry]
                if not low <= other < high or label[other] == _ALONE:
                    continue
                together = stiffness[node] + stiffness[other]
                if stiffness[node] * stiffness[other] > np.float32(WORST) * force * together:
                    continue
                if force > strongest:
                    strongest, nearest = force, other
                if force > pull and label[other] == _OPEN:
                    pull, chosen = force, other
            if chosen >= 0:
                label[node] = label[chosen] = count
                sizes[count] = 2
                count += 1
            elif nearest >= 0 and sizes[label[nearest]] < LARGEST:
                label[node] = label[nearest]
                sizes[label[nearest]] += 1
            else:
                label[node] = count
                sizes[count] = 1
                count += 1
        counts[chunk + 1] = count
    starts = np.cumsum(counts)
    for chunk in prange(chunks):
        for node in range(chunk * CHUNK, min((chunk + 1) * CHUNK, nodes)):
            if label[node] >= 0:
                label[node] += starts[chunk]
    return int(starts[-1])


@njit(cache=True)
def members_of(label: Index, first: Index, members: Index) -> None:
    """Nodes of each cluster k: ``members[first[k] : first[k + 1]]``, by counting."""
    clusters = len(first) - 1
    first[:] = 0
    for node in range(len(label)):
        if label[node] >= 0:
            first[label[node] + 1] += 1
    for k in range(clusters):
        first[k + 1] += first[k]
    for node in range(len(label)):
        if label[node] >= 0:
            members[first[label[node]]] = node
            first[label[node]] += 1
    for k in range(clusters, 0, -1):
        first[k] = first[k - 1]
    first[0] = 0


@njit(cache=True, parallel=True)
def room(begin: Index, first: Index, members: Index, out: Index) -> None:
    """Where each cluster's springs can be put: there are at most those of its members."""
    out[0] = 0
    for k in prange(len(first) - 1):
        total = 0
        for place in range(first[k], first[k + 1]):
            total += begin[members[place] + 1] - begin[members[place]]
        out[k + 1] = total
    for k in range(len(first) - 1):
        out[k + 1] += out[k]


@njit(cache=True, parallel=True)
def join(
    hold: Vector,
    begin: Index,
    neighbour: Index,
    spring: Vector,
    stiffness: Vector,
    label: Index,
    first: Index,
    members: Index,
    joint_hold: Vector,
    joint_stiffness: Vector,
    joint_begin: Index,
    loose_begin: Index,
    loose_neighbour: Index,
    loose_spring: Vector,
) -> None:
    """Network of clusters that move as one: holds and parallel springs add up, springs within are gone.

    Springs to nodes that belong to no cluster hold the cluster.  Springs are put where there is :func:`room`;
    ``joint_begin`` tells where they will be when packed.
    """
    joint_begin[0] = 0
    for k in prange(len(first) - 1):
        start = loose_begin[k]
        stop = start
        held = stiff = np.float32(0.0)
        for member in range(first[k], first[k + 1]):
            node = members[member]
            held += hold[node]
            stiff += stiffness[node]
            for entry in range(begin[node], begin[node + 1]):
                other = label[neighbour[entry]]
                if other == k:
                    continue
                if other < 0:
                    held += spring[entry]
                    continue
                place = start
                while place < stop and loose_neighbour[place] != other:
                    place += 1
                if place == stop:
                    loose_neighbour[place] = other
                    loose_spring[place] = spring[entry]
                    stop += 1
                else:
                    loose_spring[place] += spring[entry]
        joint_begin[k + 1] = stop - start
        joint_hold[k] = held
        joint_stiffness[k] = stiff
    for k in range(len(first) - 1):
        joint_begin[k + 1] += joint_begin[k]


@njit(cache=True, parallel=True)
def pack(
    loose_begin: Index,
    loose_neighbour: Index,
    loose_spring: Vector,
    begin: Index,
    neighbour: Index,
    spring: Vector,
) -> None:
    """Springs without the room that was left between them."""
    for node in prange(len(begin) - 1):
        apart = loose_begin[node] - begin[node]
        for entry in range(begin[node], begin[node + 1]):
            neighbour[entry] = loose_neighbour[entry + apart]
            spring[entry] = loose_spring[entry + apart]


@njit(cache=True, parallel=True)
def arrange(begin: Index, neighbour: Index, spring: Vector, lower: Index, upper: Index) -> None:
    """Order the springs of each node by whither they lead.

    First come lower nodes of its chunk, up to entry ``lower``, then higher ones, up to ``upper``, then other chunks.
    """
    for node in prange(len(lower)):
        chunk = node // CHUNK
        low = begin[node]
        place = low
        high = begin[node + 1]
        while place < high:
            other = neighbour[place]
            if other // CHUNK != chunk:
                high -= 1
                _swap(neighbour, spring, place, high)
            elif other < node:
                _swap(neighbour, spring, place, low)
                low += 1
                place += 1
            else:
                place += 1
        lower[node] = low
        upper[node] = high


@njit(cache=True, inline="always")
def _swap(neighbour: Index, spring: Vector, a: int, b: int) -> None:
    neighbour[a], neighbour[b] = neighbour[b], neighbour[a]
    spring[a], spring[b] = spring[b], spring[a]


@njit(cache=True, parallel=True)
def sweep_forward(
    begin: Index,
    lower: Index,
    neighbour: Index,
    spring: Vector,
    inverse: Vector,
    right: Vector,
    z: Vector,
) -> None:
    """First Gauss-Seidel sweep in ascending order, from z = 0; other chunks stay at 0 meanwhile."""
    nodes = len(z)
    for chunk in prange((nodes + CHUNK - 1) // CHUNK):
        for node in range(chunk * CHUNK, min((chunk + 1) * CHUNK, nodes)):
            total = right[node]
            for entry in range(begin[node], lower[node]):
                total += spring[entry] * z[neighbour[entry]]
            z[node] = total * inverse[node]


@njit(cache=True, parallel=True)
def remainder(
    begin: Index, lower: Index, neighbour: Index, spring: Vector, z: Vector, out: Vector
) -> None:
    """Residual after :func:`sweep_forward`: what springs pull with that it did not see."""
    for node in prange(len(z)):
        total = np.float32(0.0)
        for entry in range(lower[node], begin[node + 1]):
            total += spring[entry] * z[neighbour[entry]]
        out[node] = total


@njit(cache=True, parallel=True)
def gather(first: Index, members: Index, fine: Vector, coarse: Vector) -> None:
    """Sum over the members of each cluster; the transpose of :func:`spread`."""
    for k in prange(len(coarse)):
        total = np.float32(0.0)
        for place in range(first[k], first[k + 1]):
            total += fine[members[place]]
        coarse[k] = total


@njit(cache=True, parallel=True)
def sweep_backward(
    begin: Index,
    upper: Index,
    neighbour: Index,
    spring: Vector,
    inverse: Vector,
    right: Vector,
    before: Vector,
    z: Vector,
) -> None:
    """Gauss-Seidel sweep in descending order: the transpose of :func:`sweep_forward`.

    Other chunks stay as they were ``before``, which is z.
    """
    nodes = len(z)
    for chunk in prange((nodes + CHUNK - 1) // CHUNK):
        low, high = chunk * CHUNK, min((chunk + 1) * CHUNK, nodes)
        for back in range(high - low):
            node = high - 1 - back
            total = right[node]
            for entry in range(begin[node], upper[node]):
                total += spring[entry] * z[neighbour[entry]]
            for entry in range(upper[node], begin[node + 1]):
                total += spring[entry] * before[neighbour[entry]]
            z[node] = total * inverse[node]


@njit(cache=True, parallel=True)
def pull_after(
    begin: Index,
    lower: Index,
    upper: Index,
    neighbour: Index,
    spring: Vector,
    right: Vector,
    before: Vector,
    z: Vector,
    out: Vector,
) -> None:
    """``out = A z`` after :func:`sweep_backward`: the right-hand side but for what moved after a node was solved."""
    for node in prange(len(z)):
        total = right[node]
        for entry in range(begin[node], lower[node]):
            other = neighbour[entry]
            total += spring[entry] * (before[other] - z[other])
        for entry in range(upper[node], begin[node + 1]):
            other = neighbour[entry]
            total += spring[entry] * (before[other] - z[other])
        out[node] = total


@njit(cache=True, parallel=True)
def spread(label: Index, coarse: Vector, fine: Vector, after: Vector) -> None:
    """Move every node by as much as its cluster; ``after`` is a copy of the result."""
    for node in prange(len(label)):
        here = fine[node]
        if label[node] >= 0:
            here += coarse[label[node]]
        fine[node] = here
        after[node] = here


@njit(cache=True, parallel=True)
def inner(a: Vector, b: Vector) -> float:
    """Inner product, summed chunk by chunk."""
    nodes = len(a)
    chunks = (nodes + CHUNK - 1) // CHUNK
    sums = np.zeros(chunks, np.float64)
    for chunk in prange(chunks):
        total = 0.0
        for node in range(chunk * CHUNK, min((chunk + 1) * CHUNK, nodes)):
            total += a[node] * b[node]
        sums[chunk] = total
    return float(sums.sum())


@njit(cache=True, parallel=True)
def combine(a: float, x: Vector, b: float, y: Vector, out: Vector) -> None:
    """``out = a x + b y``."""
    for node in prange(len(x)):
        out[node] = np.float32(a) * x[node] + np.float32(b) * y[node]
