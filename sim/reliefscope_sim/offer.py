"""What comes with a simulated instrument: its profile and its factory calibration."""

from __future__ import annotations

from reliefscope.models.calibration import Calibration, InstrumentOffer
from reliefscope_sim.url import SimUrl


def describe(url: str) -> InstrumentOffer:
    """Profile (with the size that ``url`` asks for) and calibration of the instrument at ``url``.

    The factory calibration holds the true numbers of the instrument, departures of ``as_built=`` included;
    with ``calibration=nominal`` it comes without, so that calibration has something to find.
    """
    address = SimUrl.parse(url)
    profile = address.load_profile()
    if address.calibration == "nominal":
        return InstrumentOffer(profile=profile, calibration=Calibration.nominal(profile))
    built = address.load_as_built(profile)
    return InstrumentOffer(profile=profile, calibration=built.factory_calibration(profile))
