"""The paper's experiments: z calibration, the reference z-stack, Table I and the figures of the simulants."""

from reliefscope.microscope.experiments.focus import (
    FocusOutcome,
    focus_pictures,
    record_stack,
)
from reliefscope.microscope.experiments.z_stage import (
    ZCalibration,
    calibrate_z,
    take_z_stage,
)

__all__ = [
    "FocusOutcome",
    "ZCalibration",
    "calibrate_z",
    "focus_pictures",
    "record_stack",
    "take_z_stage",
]
