"""Which profile and which calibration hold for the instrument behind a URL: decided here and nowhere else.

Profile: the one that was asked for, else the one that belongs to the URL, else ``benchtop``.  Calibration: the
one that was asked for, else the one that belongs to the URL, else the newest one stored for this instrument
(by serial number, then by profile), else nominal.  Where the one that belongs to the URL is nominal itself, one
stored under the instrument's serial number comes first: it was measured since.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib.metadata import entry_points
from pathlib import Path

from reliefscope.calibration.store import CalibrationStore
from reliefscope.errors import InvalidInputError
from reliefscope.models.base import load_model
from reliefscope.models.calibration import Calibration, InstrumentOffer
from reliefscope.models.instrument import InstrumentProfile, load_profile

INSTRUMENT_GROUP = "reliefscope.instruments"
DEFAULT_PROFILE = "benchtop"
DEFAULT_SCENE = "fiducial"
DEMO_SCHEME = "sim"


@dataclass(frozen=True, slots=True)
class Instrument:
    """Profile and calibration that hold, and where each comes from."""

    profile: InstrumentProfile
    calibration: Calibration
    profile_from: str
    calibration_from: str


def scheme_of(url: str) -> str:
    """Scheme of a URL; empty for the name of a port."""
    return url.partition("://")[0].lower() if "://" in url else ""


def offer_of(url: str) -> InstrumentOffer | None:
    """Profile and calibration that belong to a URL, if any do."""
    for entry in entry_points(group=INSTRUMENT_GROUP, name=scheme_of(url)):
        describe: Callable[[str], InstrumentOffer] = entry.load()
        return describe(url)
    return None


def default_devices() -> list[tuple[str, str]]:
    """(URL, description) of the instruments that need no hardware: one per profile and scheme on offer."""
    return [
        (f"{entry.name}://{name}?scene={DEFAULT_SCENE}", f"instrument `{name}` without hardware")
        for entry in entry_points(group=INSTRUMENT_GROUP)
        for name in ("benchtop", "miniature")
    ]


def load_calibration(calibration: Calibration | Path | str) -> Calibration:
    """A calibration as it is, or read from its file."""
    if isinstance(calibration, Calibration):
        return calibration
    return load_model(Calibration, Path(calibration))


def resolve_instrument(
    url: str,
    *,
    profile: InstrumentProfile | str | None = None,
    calibration: Calibration | Path | str | None = None,
    serial_number: str = "",
    store: CalibrationStore | None = None,
) -> Instrument:
    """Decide which profile and calibration hold for ``url``.

    Raises
    ------
    InvalidInputError
        If a name or file is wrong, or the calibration belongs to another kind of instrument.
    """
    offer = offer_of(url)
    chosen, profile_from = _choose_profile(profile, offer)
    if calibration is not None:
        source = str(calibration) if not isinstance(calibration, Calibration) else "given"
        found = load_calibration(calibration)
        _check_leds(found, chosen, source)
        return Instrument(chosen, found, profile_from, source)
    shelf = store or CalibrationStore()
    stored = shelf.find(chosen.name, serial_number)
    if offer is not None and offer.profile.name == chosen.name:
        found = offer.calibration
        measured = stored is not None and stored[0] == shelf.path(chosen.name, serial_number)
        better = found.source == "nominal" and serial_number and measured
        if len(found.led_positions_mm) == chosen.dome.count and not better:
            return Instrument(chosen, found, profile_from, f"{found.source}, came with {url}")
    if stored is not None:
        path, found = stored
        _check_leds(found, chosen, str(path))
        return Instrument(chosen, found, profile_from, f"{found.source}, {path}")
    return Instrument(chosen, Calibration.nominal(chosen), profile_from, "nominal")


def _choose_profile(
    wanted: InstrumentProfile | str | None, offer: InstrumentOffer | None
) -> tuple[InstrumentProfile, str]:
    if isinstance(wanted, InstrumentProfile):
        return wanted, "given"
    if wanted is not None:
        loaded = load_profile(wanted)
        if offer is not None and wanted == offer.profile.name:
            return offer.profile, "the URL"  # the same one, at the size that the URL asks for
        return loaded, wanted
    if offer is not None:
        return offer.profile, "the URL"
    return load_profile(DEFAULT_PROFILE), "default"


def _check_leds(calibration: Calibration, profile: InstrumentProfile, source: str) -> None:
    leds = len(calibration.led_positions_mm)
    if calibration.profile != profile.name or leds != profile.dome.count:
        raise InvalidInputError(
            f"The calibration ({source}) is of a `{calibration.profile}` with {leds} LEDs; the profile "
            f"`{profile.name}` has {profile.dome.count}.",
            hint="Give the calibration of this instrument with --calibration, or the right --profile.",
        )
