"""The paper's experiments: z calibration, the reference z-stack, Table I and the figures of the simulants."""

from reliefscope.microscope.experiments.focus import (
    FocusOutcome,
    focus_pictures,
    record_stack,
)

__all__ = [
    "FocusOutcome",
    "focus_pictures",
    "record_stack",
]
