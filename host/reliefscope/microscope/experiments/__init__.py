"""The paper's experiments: z calibration, the reference z-stack, Table I and the figures of the simulants."""

from reliefscope.microscope.experiments.focus import (
    FocusOutcome,
    focus_pictures,
    record_stack,
)
from reliefscope.microscope.experiments.simulants import (
    SIMULANTS,
    SimulantFigure,
    simulant_figures,
)
from reliefscope.microscope.experiments.table_one import TableOne, table_one
from reliefscope.microscope.experiments.z_stage import (
    ZCalibration,
    calibrate_z,
    take_z_stage,
)

__all__ = [
    "SIMULANTS",
    "FocusOutcome",
    "SimulantFigure",
    "TableOne",
    "ZCalibration",
    "calibrate_z",
    "focus_pictures",
    "record_stack",
    "simulant_figures",
    "table_one",
    "take_z_stage",
]
