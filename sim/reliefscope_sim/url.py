"""The address of a simulated instrument.

``sim://NAME?KEY=VALUE&...`` names a bench; device and camera with the same NAME share it.  NAME gives the
profile where it is the name of one (``sim://benchtop``, ``sim://miniature``); other names get the benchtop or
what ``profile=`` says, and names that look like a misspelt profile need ``profile=``.  Keys: see :data:`KEYS`;
what begins with ``scene.`` goes to the scene by the name behind the dot (``scene.tilt_deg=10``).
"""

from __future__ import annotations

import difflib
import hashlib
import math
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal, cast
from urllib.parse import parse_qsl, urlsplit

from reliefscope.errors import InvalidInputError
from reliefscope.models.instrument import InstrumentProfile, builtin_profiles, load_profile
from reliefscope_sim.as_built import AsBuilt
from reliefscope_sim.clock import TimeMode
from reliefscope_sim.display import Mounting
from reliefscope_sim.faults import Faults
from reliefscope_sim.flaws import FlawLevels, SensorFlaws
from reliefscope_sim.liquid_crystal import ROOM_C, TEMPERATURE_RANGE_C
from reliefscope_sim.recording import Recording

SCHEME = "sim"
DEFAULT_PROFILE = "benchtop"
STN_CONTRAST = 10.0
"""Typical of positive STN glass (variant E); film-compensated glass (S) reaches 15."""
ALIKE = 0.75
"""Share of letters in common from which a name is taken for a misspelt profile's."""
STAGE_RANGE_UM = (-1000.0, 1000.0)
KEYS = {
    "scene": "what lies under the instrument (default: fiducial)",
    "finish": "surface of the fiducial: dull, half or metallic",
    "simulant": "what regolith is made of: ds1, jsc1a or mars1",
    "file": "height map of scene=heightmap",
    "stage_um": "height to which the stage lifts the sample, in um (default: 0)",
    "seed": "seed of everything random (default: 1)",
    "profile": "instrument profile by name or path",
    "as_built": "seed of hidden departures from the profile (default: none)",
    "calibration": "factory (default: knows the departures) or nominal (has to be found)",
    "size": "region that the camera reads out, COLUMNSxROWS",
    "time": "virtual (default: as fast as frames can be rendered) or real",
    "glass": "variant of the glass that is fitted, E or S (default: the profile's)",
    "mounting": "how the glass sits: bottom_view (default) or top_view",
    "contrast": "contrast ratio of the glass (default: the profile's; 10 where glass=E is fitted instead of S)",
    "temperature": "of the glass in degrees Celsius (default: 25)",
    "led_droop": "part of an LED's light that is lost when it is warm (default: 0)",
    "bits": "depth of the camera's pixels, 8, 10 or 12 (default: the profile's)",
    "shading": "part of the light that is lost in the camera's furthest corner (default: 0.04)",
    "dust": "specks on the camera's sensor (default: 3)",
    "dust_px": "mean diameter of the specks in pixels (default: 24)",
    "hot_pixels": "pixels per million with much dark current (default: 50)",
    "replay": "bundle or wire log that is played when the instrument is switched on",
    "fault": "what goes wrong, as in fault=link_loss:0.05,camera_drop:3",
}


@dataclass(frozen=True)
class SimUrl:
    """A parsed address.  ``given`` holds the options as they were written, for comparing two addresses."""

    name: str
    identity: str = ""
    """What the device calls itself: the name, or that of the recording that is replayed."""
    scene: str = "fiducial"
    scene_options: tuple[tuple[str, str], ...] = ()
    stage_um: float = 0.0
    seed: int = 1
    profile: str = DEFAULT_PROFILE
    as_built: int | None = None
    calibration: Literal["factory", "nominal"] = "factory"
    size: tuple[int, int] | None = None
    """(columns, rows)."""
    time: TimeMode = "virtual"
    glass: Literal["E", "S"] | None = None
    mounting: Mounting = Mounting.BOTTOM_VIEW
    contrast: float | None = None
    temperature_c: float = ROOM_C
    led_droop: float = 0.0
    bits: Literal[8, 10, 12] | None = None
    flaws: FlawLevels = field(default_factory=FlawLevels)
    replay: str | None = None
    faults: Faults = field(default_factory=Faults)
    given: tuple[tuple[str, str], ...] = ()

    @classmethod
    def parse(cls, url: str) -> SimUrl:
        """Read ``url``.

        Raises
        ------
        InvalidInputError
            If it is no address of a simulated instrument, or an option is unknown, doubled or malformed.
        """
        if match := re.fullmatch(rf"{SCHEME}://replay=([^&?]+)(?:[&?](.*))?", url):
            url = f"{SCHEME}://replay?replay={match[1]}&{match[2] or ''}".rstrip("&")
        parts = urlsplit(url)
        name = parts.netloc
        if parts.scheme.lower() != SCHEME or not re.fullmatch(r"[\w.-]+", name) or parts.path:
            raise InvalidInputError(
                f"`{url}` is no address of a simulated instrument.",
                hint="Write sim://NAME?KEY=VALUE&..., for example "
                "`sim://benchtop?scene=fiducial&seed=1`.",
            )
        options: dict[str, str] = {}
        for key, value in parse_qsl(parts.query, keep_blank_values=True):
            if key not in KEYS and not key.startswith("scene."):
                raise _unknown_key(key)
            if key == "fault" and key in options:
                options[key] += f",{value}"
            elif key in options:
                raise InvalidInputError(
                    f"`{key}` occurs twice in `{url}`.", hint="Give every option once."
                )
            else:
                options[key] = value
        return cls._from_options(name, options)

    @classmethod
    def of_recording(cls, path: Path, instrument: str | None = None) -> SimUrl:
        """The instrument of a bundle or wire log, with the options of ``instrument`` over its own."""
        wanted = cls.parse(instrument) if instrument else None
        options = dict(wanted.given) if wanted else {}
        name = wanted.name if wanted else "replay"
        return cls._from_options(name, {**options, "replay": str(path)})

    @classmethod
    def _from_options(cls, name: str, given: dict[str, str]) -> SimUrl:
        recorded = None
        if "replay" in given:
            device = Recording.load(Path(given["replay"])).device
            if device.lower().startswith(f"{SCHEME}://"):
                recorded = cls.parse(device)
        identity = recorded.identity if recorded else name
        # What is replayed runs as fast as it can, however it was recorded.
        options = {**dict(recorded.given if recorded else ()), "time": "virtual", **given}
        if recorded is None and "time" not in given:
            del options["time"]
        scene_options = {
            key.removeprefix("scene."): value
            for key, value in options.items()
            if key.startswith("scene.")
        }
        scene_options |= {key: options[key] for key in _SCENE_KEYS if key in options}
        if recorded is None and "profile" not in given:
            _refuse_misspelt(name)
        default_profile = identity if identity in builtin_profiles() else DEFAULT_PROFILE
        glass = _choice("glass", options, ("E", "S")) if "glass" in options else None
        as_built = _whole("as_built", options["as_built"]) if "as_built" in options else None
        bits = int(_choice("bits", options, ("8", "10", "12"))) if "bits" in options else None
        seed = _whole("seed", options.get("seed", "1"))
        return cls(
            name=name,
            identity=identity,
            replay=options.get("replay"),
            scene=options.get("scene", "fiducial"),
            scene_options=tuple(sorted(scene_options.items())),
            stage_um=_within("stage_um", options, STAGE_RANGE_UM),
            seed=seed,
            profile=options.get("profile", default_profile),
            as_built=as_built,
            calibration=cast(
                Literal["factory", "nominal"],
                _choice("calibration", options, ("factory", "nominal")),
            ),
            size=_size(options["size"]) if "size" in options else None,
            time=cast(TimeMode, _choice("time", options, ("virtual", "real"))),
            glass=cast(Literal["E", "S"] | None, glass),
            mounting=Mounting(_choice("mounting", options, [item.value for item in Mounting])),
            contrast=_within("contrast", options, (1.1, 10_000.0))
            if "contrast" in options
            else None,
            temperature_c=_within("temperature", options, TEMPERATURE_RANGE_C, ROOM_C),
            led_droop=_within("led_droop", options, (0.0, 0.5), 0.0),
            bits=cast(Literal[8, 10, 12] | None, bits),
            flaws=_flaws(options),
            faults=Faults.parse(options.get("fault", ""), seed),
            given=tuple(sorted(given.items())),
        )

    @property
    def device_serial(self) -> str:
        """Serial number of the device, at most 16 characters, which tells hidden departures apart.

        Calibrations are kept by it, so that it depends on the instrument alone and not on the sample.
        """
        name = f"SIM-{self.identity}"
        if self.as_built is None:
            return name[:16]
        return f"{name[:11]}-{_short_hash(self.as_built)[:4]}"

    @property
    def camera_serial(self) -> str:
        """Serial number of the camera, which tells apart what else decides the pixels: scene, stage, seed and flaws.

        A run that was begun with one sample is not continued with another.
        """
        content: tuple[object, ...] = (self.scene, self.scene_options, self.seed)
        if self.stage_um:
            content = (*content, self.stage_um)
        if self.flaws != FlawLevels():
            content = (*content, self.flaws)
        return f"{self.device_serial}-{_short_hash(*content)}"

    def load_profile(self) -> InstrumentProfile:
        """The profile as designed, with the glass and the region of the camera that the address names."""
        profile = load_profile(self.profile)
        glass: dict[str, object] = {}
        if self.glass is not None and self.glass != profile.glass.variant:
            glass["variant"] = self.glass
            if self.glass == "E":
                glass["contrast_ratio"] = STN_CONTRAST
        if self.contrast is not None:
            glass["contrast_ratio"] = self.contrast
        camera = {} if self.bits is None else {"bit_depth": self.bits}
        profile = profile.model_copy(
            update={
                "glass": profile.glass.model_copy(update=glass),
                "camera": profile.camera.model_copy(update=camera),
            }
        )
        if self.size is None:
            return profile
        columns, rows = self.size
        limit = (profile.camera.columns, profile.camera.rows)
        if not (16 <= columns <= limit[0] and 16 <= rows <= limit[1]):
            raise InvalidInputError(
                f"The camera of {profile.name} cannot read out {columns}x{rows} pixels.",
                hint=f"Choose a size from 16x16 to {limit[0]}x{limit[1]}.",
            )
        if profile.camera.sensor == "bayer_rggb" and (columns % 2 or rows % 2):
            raise InvalidInputError(
                f"A region of {columns}x{rows} pixels cuts through the colour mosaic.",
                hint="Give even numbers of columns and rows.",
            )
        return profile.resized(columns, rows)

    def load_as_built(self, profile: InstrumentProfile) -> AsBuilt:
        """How the instrument of this address really is."""
        if self.as_built is None:
            return AsBuilt.nominal(profile)
        return AsBuilt.draw(profile, self.as_built)

    def load_flaws(self, profile: InstrumentProfile) -> SensorFlaws:
        """What is uneven about the sensor of this address, in the region that ``profile`` reads out.

        It belongs to the camera and stays the same whatever lies under the instrument: ``as_built`` draws it.
        """
        whole = load_profile(self.profile).shape
        return SensorFlaws.draw(whole, self.flaws, self.as_built or 0).region(profile.shape)

    def check_agrees(self, later: SimUrl) -> None:
        """Raise InvalidInputError if ``later`` asks the bench of this address for something else."""
        conflicts = [
            f"{key}={value}"
            for key, value in later.given
            if self._resolved(key) != later._resolved(key)
        ]
        if conflicts:
            raise InvalidInputError(
                f"The simulated instrument `{self.name}` is already in use, and without "
                f"{', '.join(conflicts)}.",
                hint="Open device and camera with the same options, or choose another NAME.",
            )

    def _resolved(self, key: str) -> object:
        """What holds for an option, whether it was written or not."""
        if key in _FLAW_KEYS:
            return getattr(self.flaws, key)
        if key in _FIELD_OF_KEY:
            return getattr(self, _FIELD_OF_KEY[key])
        return dict(self.scene_options).get(key.removeprefix("scene."))


_OTHER_FIELDS = {"fault": "faults", "temperature": "temperature_c"}
_SCENE_KEYS = ("finish", "simulant", "file")
"""Options of scenes that may be written without `scene.`."""
_FLAW_KEYS = ("shading", "dust", "dust_px", "hot_pixels")
_FIELD_OF_KEY = {key: _OTHER_FIELDS.get(key, key) for key in KEYS if key not in _SCENE_KEYS}


def _short_hash(*content: object) -> str:
    return hashlib.sha256(repr(content).encode("utf-8")).hexdigest()[:8]


def _unknown_key(key: str) -> InvalidInputError:
    nearest = difflib.get_close_matches(key, KEYS, n=1)
    advice = f"Did you mean `{nearest[0]}`? " if nearest else ""
    return InvalidInputError(
        f"A simulated instrument has no option `{key}`.",
        hint=f"{advice}Known options: {', '.join(KEYS)}, and scene.NAME for the scene.",
    )


def _refuse_misspelt(name: str) -> None:
    """Refuse a name that is nearly that of a profile: it would silently get another instrument than was meant."""
    known = builtin_profiles()
    if any(name.startswith(profile) for profile in known):
        return
    for nearest in difflib.get_close_matches(name.lower(), known, n=1, cutoff=ALIKE):
        raise InvalidInputError(
            f"There is no simulated instrument `{name}`; there are {' and '.join(known)}.",
            hint=f"Did you mean `{SCHEME}://{nearest}`? A bench of your own may have any other name; "
            f"this one, too, with its profile: `{SCHEME}://{name}?profile={nearest}`.",
        )


def _choice(key: str, options: dict[str, str], known: list[str] | tuple[str, ...]) -> str:
    value = options.get(key, known[0])
    if value not in known:
        raise InvalidInputError(
            f"`{key}={value}` is not possible.", hint=f"Choose one of: {', '.join(known)}."
        )
    return value


def _whole(key: str, value: str) -> int:
    if not re.fullmatch(r"\d{1,9}", value):
        raise InvalidInputError(
            f"`{key}={value}` is no seed.", hint=f"Give a whole number from 0 on, as in {key}=1."
        )
    return int(value)


def _within(
    key: str, options: dict[str, str], limits: tuple[float, float], default: float = 0.0
) -> float:
    low, high = limits
    try:
        value = float(options.get(key, default))
    except ValueError:
        value = math.nan
    if not low <= value <= high:
        raise InvalidInputError(
            f"`{key}={options[key]}` is not possible.",
            hint=f"Give a number from {low:g} to {high:g}.",
        )
    return value


def _flaws(options: dict[str, str]) -> FlawLevels:
    usual = FlawLevels()
    return FlawLevels(
        shading=_within("shading", options, (0.0, 0.9), usual.shading),
        dust=round(_within("dust", options, (0.0, 1000.0), usual.dust)),
        dust_px=_within("dust_px", options, (2.0, 500.0), usual.dust_px),
        hot_pixels=_within("hot_pixels", options, (0.0, 100_000.0), usual.hot_pixels),
    )


def _size(value: str) -> tuple[int, int]:
    match = re.fullmatch(r"(\d{1,5})x(\d{1,5})", value)
    if match is None:
        raise InvalidInputError(
            f"`size={value}` is no size.", hint="Write COLUMNSxROWS, as in size=640x480."
        )
    return int(match[1]), int(match[2])
