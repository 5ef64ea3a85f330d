"""Declarative models: the instrument, the plan of a run, its calibration; frames and cameras as protocols."""
