"""The public API: everything that the command line and the terminal screen can do.

Example::

    from reliefscope.microscope import Microscope

    with Microscope.open("sim://benchtop?scene=fiducial") as microscope:
        run = microscope.acquire(out="runs/first")
    outcome = run.reconstruct()
    print(outcome.reconstruction.height_um.shape, run.evaluate().table)
"""

from reliefscope.microscope.bundles import bundle_run
from reliefscope.microscope.demonstration import DemoResult, demo
from reliefscope.microscope.evaluating import Evaluation, evaluate_run
from reliefscope.microscope.experiments import (
    SIMULANTS,
    FocusOutcome,
    SimulantFigure,
    TableOne,
    ZCalibration,
    calibrate_z,
    focus_pictures,
    record_stack,
    simulant_figures,
    table_one,
    take_z_stage,
)
from reliefscope.microscope.instruments import Instrument, default_devices, resolve_instrument
from reliefscope.microscope.live import Microscope
from reliefscope.microscope.places import fresh_path
from reliefscope.microscope.probing import calibrate_lights, estimate_lights, estimate_powers
from reliefscope.microscope.reconstructing import Outcome, reconstruct_run
from reliefscope.microscope.stored import StoredRun, import_photographs, open_run

__all__ = [
    "SIMULANTS",
    "DemoResult",
    "Evaluation",
    "FocusOutcome",
    "Instrument",
    "Microscope",
    "Outcome",
    "SimulantFigure",
    "StoredRun",
    "TableOne",
    "ZCalibration",
    "bundle_run",
    "calibrate_lights",
    "calibrate_z",
    "default_devices",
    "demo",
    "estimate_lights",
    "estimate_powers",
    "evaluate_run",
    "focus_pictures",
    "fresh_path",
    "import_photographs",
    "open_run",
    "reconstruct_run",
    "record_stack",
    "resolve_instrument",
    "simulant_figures",
    "table_one",
    "take_z_stage",
]
