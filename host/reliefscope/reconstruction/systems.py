"""The normal equations of eq. 12 as operators that are never written out as a matrix.

Three kinds of equation hold a surface z (H, W): ``hold`` pulls a pixel to a height, and a slope in
x and one in y pull on its neighbourhood.  How a slope is taken from z is the difference between the
systems.

The Sobel operator of eq. 9 is the mean of the six differences between neighbours in its 3 x 3
window, weighted 1, 2, 1 across.  A mean does not see how its terms differ among themselves: every
(-1)^x g(y) and f(x) (-1)^y has Sobel derivatives of exactly zero, so that noise of the slopes comes
out as stripes and chequerboards and, where no height is known, the system is singular.
:class:`SobelSystem` therefore also takes a ``stabiliser`` e: it adds e times the mean of the
squared deviations of the six single differences from the slope,

    q^2 [(mean_i d_i - s)^2 + e mean_i (d_i - s)^2].

Both terms ask for the same slope, so a surface that fits the slopes is not changed; but no surface
other than a constant is invisible to the second.  By Cauchy-Schwarz the first is never larger than
the second without its factor, which is therefore the preconditioner, and bounds the condition
number by 1 + 1 / e.
"""

from __future__ import annotations

import copy
import math
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from reliefscope.reconstruction import fusion_kernels as kernels
from reliefscope.reconstruction.multigrid import Multigrid

Field = NDArray[np.float64]
Slopes = NDArray[np.floating[Any]]
Springs = NDArray[np.floating[Any]]

_BLOCK = 4
"""Side in pixels of the blocks over which the least held part of a surface is sought."""


class System(Protocol):
    """Symmetric positive semi-definite operator with right-hand side and preconditioner."""

    @property
    def right(self) -> Field:
        """Right-hand side (H, W)."""

    @property
    def softness(self) -> float:
        """Energy per um^2 and pixel of the softest smooth mode: turns energy into height."""

    def apply(self, z: Field, out: Field) -> None:
        """Write the operator's value at ``z`` (H, W) to ``out`` (H, W)."""

    def touched(self) -> NDArray[np.bool_]:
        """Pixels (H, W) that any equation holds."""

    def preconditioner(self) -> Multigrid:
        """Multigrid whose cycle approximates the inverse."""


class SobelSystem:
    """Eq. 12 with the Sobel operators of eq. 9, one pair of slope equations per pixel.

    The outermost pixels have no whole window: their slope equations are left out.

    Parameters
    ----------
    hold:
        (H, W) squared weights of the heights, ``(lambda q_mvs)^2``.
    target_um:
        (H, W) heights to hold; finite everywhere.
    slope_x, slope_y:
        (H, W) slopes dz/dx and dz/dy, y up; finite everywhere.
    quality:
        (H, W) weights of the slopes.
    pixel_um:
        Size of a pixel on the sample.
    stabiliser:
        e of the module's text; 0 is the literal form.
    """

    def __init__(
        self,
        hold: Field,
        target_um: Field,
        slope_x: Slopes,
        slope_y: Slopes,
        quality: Slopes,
        pixel_um: float,
        stabiliser: float = 0.0,
    ) -> None:
        self._hold = hold
        weight = quality.astype(np.float64) ** 2 / pixel_um**2
        for border in (weight[:1], weight[-1:], weight[:, :1], weight[:, -1:]):
            border[...] = 0.0
        self._weight = weight
        height, width = hold.shape
        self._flux_x = np.zeros((height + 2, width + 2))
        self._flux_y = np.zeros((height + 2, width + 2))
        rise_x = weight * slope_x * pixel_um
        rise_y = weight * slope_y * pixel_um
        self._flux_x[1:-1, 1:-1] = rise_x
        self._flux_y[1:-1, 1:-1] = rise_y
        self.right = np.empty_like(hold)
        kernels.sobel_gather(hold, target_um, self._flux_x, self._flux_y, self.right)
        self._across, self._down = _spread_across(weight), _spread_across(weight.T).T
        self._stiffness = stabiliser
        if stabiliser > 0.0:
            across = stabiliser * _spread_across(rise_x)
            down = -stabiliser * _spread_across(rise_y.T).T
            _add_rises(self.right, across, down)
            self._weak_across = stabiliser * self._across
            self._weak_down = stabiliser * self._down
        self.softness = _softness(hold, float(weight.mean()))

    def apply(self, z: Field, out: Field) -> None:
        """Normal operator ``hold + Tx' Q^2 Tx + Ty' Q^2 Ty`` plus the stabiliser, at ``z``."""
        kernels.sobel_fluxes(z, self._weight, self._flux_x, self._flux_y)
        kernels.sobel_gather(self._hold, z, self._flux_x, self._flux_y, out)
        if self._stiffness > 0.0:
            kernels.spring_add(self._weak_across, self._weak_down, z, out)

    def touched(self) -> NDArray[np.bool_]:
        """Pixels that are held or lie in the window of a slope equation."""
        return _touched(self._hold, self._across, self._down)

    def preconditioner(self) -> Multigrid:
        """Multigrid of the single differences, at the full weight of the slope equations."""
        factor = 1.0 + self._stiffness
        return Multigrid(self._hold, factor * self._across, factor * self._down)


class SpringSystem:
    """Neighbours joined by springs of a weight and a wanted rise each, and pixels held at heights.

    Nothing but a constant is invisible to it, and it has the fewest unknowns per equation.

    Parameters
    ----------
    hold:
        (H, W) squared weights of the heights.
    target_um:
        (H, W) heights to hold; finite everywhere.
    across, down:
        (H, W-1) and (H-1, W) squared weights of the springs, per um^2.
    rise_across, rise_down:
        Height by which the right end should lie above the left, and the lower above the upper, um.
    """

    def __init__(
        self,
        hold: Springs,
        target_um: Springs,
        across: Springs,
        down: Springs,
        rise_across: Springs,
        rise_down: Springs,
    ) -> None:
        self._hold, self._across, self._down = (
            np.ascontiguousarray(weights, np.float64) for weights in (hold, across, down)
        )
        springs = float(self._across.mean() + self._down.mean()) / 2
        self.softness = _softness(self._hold, springs)
        self._multigrid: Multigrid | None = None
        self.right: Field = self._hold * target_um
        _add_rises(self.right, self._across * rise_across, self._down * rise_down)

    def weights(self) -> tuple[Field, Field, Field]:
        """Squared weights: ``hold``, ``across`` and ``down``."""
        return self._hold, self._across, self._down

    def renewed(self) -> SpringSystem:
        """The same system without the preconditioner that was made for it."""
        other = copy.copy(self)
        other._multigrid = None
        return other

    def drawn(self, generator: np.random.Generator) -> SpringSystem:
        """The same springs with a right-hand side drawn at random: of covariance A, so its solution has A^-1."""
        sample = copy.copy(self)
        sample.right = np.sqrt(self._hold) * generator.standard_normal(self._hold.shape)
        pulls = (
            np.sqrt(springs) * generator.standard_normal(springs.shape)
            for springs in (self._across, self._down)
        )
        _add_rises(sample.right, *pulls)
        return sample

    def apply(self, z: Field, out: Field) -> None:
        """Springs between neighbours plus ``hold``, at ``z``."""
        kernels.spring_pull(self._hold, self._across, self._down, z, out)

    def touched(self) -> NDArray[np.bool_]:
        """Pixels that are held or joined to a neighbour."""
        return _touched(self._hold, self._across, self._down)

    def preconditioner(self) -> Multigrid:
        """Multigrid of the very same springs."""
        if self._multigrid is None:
            self._multigrid = Multigrid(self._hold, self._across, self._down)
        return self._multigrid


def forward_system(
    hold: Field,
    target_um: Field,
    slope_x: Slopes,
    slope_y: Slopes,
    quality: Slopes,
    pixel_um: float,
) -> SpringSystem:
    """Eq. 12 with the difference of two neighbours, asked for the slope of either, half each.

    The sharpest and fastest form, and the one that hands a wrong slope at an edge on least forgivingly.
    Parameters as of :class:`SobelSystem`.
    """
    weight = quality.astype(np.float64) ** 2 / pixel_um**2
    across = 0.5 * (weight[:, 1:] + weight[:, :-1])
    down = 0.5 * (weight[1:] + weight[:-1])
    # the row below lies lower in y
    return SpringSystem(
        hold,
        target_um,
        across,
        down,
        _weighted_mean(weight, slope_x * pixel_um, across, 1),
        _weighted_mean(weight, -slope_y * pixel_um, down, 0),
    )


def _weighted_mean(weight: Field, rise: Slopes, springs: Field, axis: int) -> Field:
    """Rise of each spring along an axis: mean over its two ends by weight; 0 where nothing joins them."""
    moment = weight * rise
    ends = moment[:, 1:] + moment[:, :-1] if axis else moment[1:] + moment[:-1]
    mean: Field = np.divide(0.5 * ends, springs, out=np.zeros_like(springs), where=springs > 0.0)
    return mean


def _spread_across(values: Field) -> Field:
    """Share (H, W-1) of every horizontal difference in the Sobel windows that contain it.

    ``values`` (H, W) belong to windows and are zero on the border, where there is none.
    """
    rows = 0.5 * values
    rows[1:] += 0.25 * values[:-1]
    rows[:-1] += 0.25 * values[1:]
    spread: Field = 0.5 * (rows[:, 1:] + rows[:, :-1])
    return spread


def _add_rises(right: Field, across: Field, down: Field) -> None:
    """Add weight times wanted rise of the springs across and down to a right-hand side."""
    right[:, 1:] += across
    right[:, :-1] -= across
    right[1:] += down
    right[:-1] -= down


def _touched(hold: Field, across: Field, down: Field) -> NDArray[np.bool_]:
    held: NDArray[np.bool_] = hold > 0.0
    held[:, 1:] |= across > 0.0
    held[:, :-1] |= across > 0.0
    held[1:] |= down > 0.0
    held[:-1] |= down > 0.0
    return held


def _softness(hold: Field, spring: float) -> float:
    """Energy per um^2 and pixel of the softest smooth mode: held by heights, or a half wave of slopes.

    Where heights hold some parts far less than others, the parts that are held least decide: the harmonic mean
    over blocks, which amounts to as much energy in each.
    """
    wave = (math.pi / max(hold.shape)) ** 2 * spring
    rows, columns = (min(side, _BLOCK) for side in hold.shape)
    cropped = hold[: hold.shape[0] // rows * rows, : hold.shape[1] // columns * columns]
    blocks = cropped.reshape(cropped.shape[0] // rows, rows, -1, columns).mean(axis=(1, 3))
    held = blocks + wave
    return float(1.0 / np.mean(1.0 / held)) if held.min() > 0.0 else float(held.mean())
