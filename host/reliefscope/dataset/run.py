"""A run on disk, for reading: geometry, pixels as counts, pixels as linear light."""

from __future__ import annotations

import copy
import logging
import threading
import warnings
from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from reliefscope.dataset.frames import FrameStore
from reliefscope.dataset.layout import Layout
from reliefscope.dataset.lock import RunLock
from reliefscope.dataset.radiometry import Radiometry
from reliefscope.dataset.records import JOURNAL_FILE, FrameKey, Journal, JournalEntry, key_text
from reliefscope.dataset.sensor_image import SATURATED_SHARE, colour, luminance
from reliefscope.dataset.spec import ImportedLight, RunSpec, read_spec, resume_command_of
from reliefscope.dataset.verify import VerifyReport, verify_frames
from reliefscope.dataset.writer import PARTIAL_SUFFIX, partial_path
from reliefscope.errors import DatasetError, InvalidInputError
from reliefscope.jobs import Job, ensure_job
from reliefscope.models.calibration import Calibration
from reliefscope.models.geometry import light_direction, light_power, slope_of_bitmap
from reliefscope.models.instrument import InstrumentProfile
from reliefscope.models.light_field import LightField
from reliefscope.models.plan import FrameKind, Plan
from reliefscope.units import UM_PER_MM, BoolImage, FloatImage, RawImage

log = logging.getLogger(__name__)

MASK_FILE = "mask.png"
PREFETCH_THREADS = 2
PREFETCH_FRAMES = 16
"""Frames read ahead: the threads go on while whoever reads works on a view."""


class IncompleteRunWarning(UserWarning):
    """The run that was opened lacks frames."""


class Run:
    """One run.  Reading takes no lock, and works while the run is still being taken."""

    def __init__(self, path: Path, spec: RunSpec, journal: Journal) -> None:
        self.path = path
        self.spec = spec
        self.journal = journal
        self.layout = Layout(spec)
        self.calibration: Calibration | None = spec.calibration
        self._store = FrameStore(path, self.layout, read_only=True)
        self._radiometry = Radiometry(spec, lambda key: self.record(*key), self._store.read)
        self._cache_lock = threading.Lock()
        self._offsets: dict[tuple[FrameKind, int | None], FloatImage | None] = {}

    @classmethod
    def open(cls, path: Path | str) -> Run:
        """Open a run, finished or not; warns with :class:`IncompleteRunWarning` where frames are missing.

        Raises
        ------
        DatasetError
            If the folder is absent, is no run, or its description is damaged; the message says which.
        """
        folder = Path(path)
        if not folder.is_dir():
            partial = partial_path(folder)
            if partial.is_dir():
                raise DatasetError(
                    f"The run {folder} is not finished: there is only {partial}.",
                    hint=f"Finish it with {resume_command_of(partial)}, or open {partial} as it is.",
                )
            raise DatasetError(
                f"There is no run {folder}.", hint=f"Look for it: `ls {folder.absolute().parent}`."
            )
        run = cls(folder, read_spec(folder), Journal.read(folder / JOURNAL_FILE))
        if run.missing:  # otherwise what a damaged line recorded was taken again
            for problem in run.journal.problems:
                log.warning("%s: %s", folder, problem)
        if not run.complete:
            taken = run.planned - len(run.missing)
            warnings.warn(
                f"{folder} is incomplete: {taken} of {run.planned} frames are there.",
                IncompleteRunWarning,
                stacklevel=2,
            )
        return run

    @property
    def name(self) -> str:
        """Name of the run's folder, without the mark of an unfinished one."""
        return self.path.name.removesuffix(PARTIAL_SUFFIX)

    @property
    def planned(self) -> int:
        """Number of images that belong to the run."""
        return len(self.layout.places)

    @property
    def missing(self) -> list[FrameKey]:
        """Images that were not taken."""
        return [key for key in self.layout.places if key not in self.journal.entries]

    @property
    def complete(self) -> bool:
        """Whether every planned image was taken, verified, and the run got its final name."""
        return not self.missing and not self.path.name.endswith(PARTIAL_SUFFIX)

    @property
    def results_dir(self) -> Path:
        """Folder for what is computed from the run; made on first use by who writes."""
        return self.path / "results"

    @property
    def shape(self) -> tuple[int, int]:
        """Frame shape (rows, columns)."""
        return self.spec.frame.shape

    @property
    def pixel_um(self) -> float:
        """Size of a pixel in the sample plane."""
        return self.spec.pixel_um if self.calibration is None else self.calibration.pixel_um

    @property
    def height_range_um(self) -> tuple[float, float] | None:
        """Heights worth searching, where known."""
        return self.spec.height_range_um

    @property
    def view_names(self) -> tuple[str, ...]:
        """Names of the views in the order of their index."""
        return self.spec.view_names

    @property
    def light_names(self) -> tuple[str, ...]:
        """Names of the lights in the order of their index."""
        return self.spec.light_names

    @property
    def views(self) -> NDArray[np.float64] | None:
        """Slopes (K, 2), y up, after the calibration in use; None where a slope is not known."""
        if self.spec.imported is not None:
            slopes = [view.slope for view in self.spec.imported.views]
            return None if None in slopes else np.array(slopes, dtype=np.float64)
        plan, profile, calibration = self._instrument()
        return np.array([slope_of_bitmap(view.bitmap, profile, calibration) for view in plan.views])

    @property
    def telecentricity_per_um(self) -> float:
        """Growth of the slopes with the position from the middle of the field; 0 for imported photographs."""
        if self.spec.imported is not None:
            return 0.0
        return self._instrument()[2].telecentricity_per_mm / UM_PER_MM

    @property
    def lights(self) -> NDArray[np.float64] | None:
        """Unit directions (L, 3) toward the lights after the calibration in use; None where one is not known."""
        if self.spec.imported is not None:
            directions = [light.direction for light in self.spec.imported.lights]
            return None if None in directions else np.array(directions, dtype=np.float64)
        plan, _, calibration = self._instrument()
        return np.array([light_direction(light.levels, calibration) for light in plan.lights])

    @property
    def powers(self) -> NDArray[np.float64]:
        """Brightness (L,) of the lights relative to each other, after the calibration in use."""
        if self.spec.imported is not None:
            return np.array([light.power for light in self.spec.imported.lights])
        plan, profile, calibration = self._instrument()
        full = profile.dome.full_level
        return np.array([light_power(light.levels, calibration, full) for light in plan.lights])

    @property
    def light_field(self) -> LightField | None:
        """Irradiance by the lights at every point: near where LED positions are known, else distant.

        None where a direction is not known.
        """
        if self.spec.imported is not None:
            return _imported_field(self.spec.imported.lights)
        plan, profile, calibration = self._instrument()
        return LightField.of_instrument(plan.lights, profile, calibration)

    def with_calibration(self, calibration: Calibration) -> Run:
        """The same run seen through another calibration of its instrument."""
        if self.spec.acquired is None:
            raise InvalidInputError(
                f"{self.path} was imported; a calibration does not apply to it.",
                hint="Correct the slopes and directions in its description and import it again.",
            )
        own = self.spec.acquired.calibration
        if calibration.profile != own.profile or len(calibration.led_positions_mm) != len(
            own.led_positions_mm
        ):
            raise InvalidInputError(
                f"The calibration is of a `{calibration.profile}` with {len(calibration.led_positions_mm)} LEDs, the "
                f"run of a `{own.profile}` with {len(own.led_positions_mm)}.",
                hint="Use a calibration of the instrument that took the run.",
            )
        other = copy.copy(self)
        other.calibration = calibration
        return other

    @property
    def mask(self) -> BoolImage | None:
        """Valid pixels (H, W); None where all of them are."""
        if self.spec.imported is None or self.spec.imported.mask_sha256 is None:
            return None
        path = self.path / MASK_FILE
        pixels = cv2.imread(str(path), cv2.IMREAD_UNCHANGED) if path.exists() else None
        if pixels is None or pixels.shape != self.shape:
            raise DatasetError(
                f"{path} is missing or damaged.",
                hint="Import the photographs again under another name.",
            )
        valid: BoolImage = pixels > 127
        return valid

    def record(self, kind: FrameKind, view: int | None, light: int | None) -> JournalEntry:
        """What the journal says of an image; raises DatasetError where it was not taken."""
        key = (kind, view, light)
        entry = self.journal.entries.get(key)
        if entry is None:
            raise DatasetError(
                f"{self.path} holds no frame {key_text(key)}.",
                hint=self.spec.repair_hint(self.path)
                if key in self.layout.places
                else "It was not part of the plan; `reliefscope info RUN` shows what was.",
            )
        return entry

    def has(self, kind: FrameKind, view: int | None = None, light: int | None = None) -> bool:
        """Whether an image was taken."""
        return (kind, view, light) in self.journal.entries

    def raw(self, kind: FrameKind, view: int | None, light: int | None) -> RawImage:
        """Counts (H, W) as stored: the exact sum where exposures were accumulated."""
        self.record(kind, view, light)
        return self._store.read((kind, view, light))

    def linear(self, view: int, light: int, out: FloatImage | None = None) -> FloatImage:
        """Linear luminance (H, W) float32 of a view under a light, full scale 1; in ``out`` where given.

        The dark signal is subtracted (the averaged dark frame, else the black level), the leakage of this
        light where it was taken, and the result is brought to the plan's exposure and to the mean number of
        open pixels, so that all views have equal gain.  Not divided by the light's power.
        """
        return self.luminance("view", view, light, out)

    def luminance(
        self,
        kind: FrameKind,
        view: int | None,
        light: int | None,
        out: FloatImage | None = None,
    ) -> FloatImage:
        """Linear luminance (H, W) of any image but the dark one; see :meth:`linear`."""
        entry = self.record(kind, view, light)
        scale = self._radiometry.scale(entry)
        image = luminance(self._store.read(entry.key), self.spec.frame.sensor, scale, out)
        gain = self._radiometry.gain(entry)
        offset = self._offset(kind, light)
        if offset is None:
            image -= np.float32(self._radiometry.black_level * gain)
        elif gain == 1.0:
            cv2.subtract(image, offset, dst=image)
        else:
            cv2.scaleAdd(offset, -gain, image, dst=image)
        return image

    def saturation_level(self, view: int, light: int) -> FloatImage | float:
        """Linear luminance, as :meth:`linear` gives it, from which a pixel counts as saturated.

        (H, W), or one for all pixels.  On a mosaic one colour saturates before the luminance does.
        """
        share = SATURATED_SHARE[self.spec.frame.sensor]
        gain = share * self._radiometry.gain(self.record("view", view, light))
        offset = self._offset("view", light)
        if offset is None:
            return gain * (1.0 - self._radiometry.black_level)
        level: FloatImage = np.float32(gain) * (np.float32(1.0) - offset)
        return level

    @property
    def in_colour(self) -> bool:
        """Whether the sensor sees red, green and blue."""
        return self.spec.frame.sensor != "mono"

    def rgb(self, kind: FrameKind, view: int | None, light: int | None) -> FloatImage:
        """Linear red, green and blue (H, W, 3), corrected like :meth:`linear`, without white balance."""
        entry = self.record(kind, view, light)
        counts = np.multiply(
            self._store.read(entry.key), np.float32(self._radiometry.scale(entry)), dtype=np.float32
        )
        offset = self._radiometry.offset(kind, light)
        gain = np.float32(self._radiometry.gain(entry))
        counts -= gain * (np.float32(self._radiometry.black_level) if offset is None else offset)
        return colour(counts, self.spec.frame.sensor)

    def stack(
        self, views: Iterable[int] | None = None, lights: Iterable[int] | None = None
    ) -> Iterator[tuple[int, int, FloatImage]]:
        """(view, light, linear luminance) of every pair, lights fastest; read ahead by two threads.

        An image is overwritten when the next one is asked for: copy what is to be kept.
        """
        chosen_views = range(len(self.view_names)) if views is None else views
        chosen_lights = list(range(len(self.light_names)) if lights is None else lights)
        pairs = iter([(view, light) for view in chosen_views for light in chosen_lights])
        # memory that is used again costs nothing; memory fresh from the system costs more than reading
        free = [np.empty(self.shape, np.float32) for _ in range(PREFETCH_FRAMES)]
        with ThreadPoolExecutor(PREFETCH_THREADS, thread_name_prefix="read-run") as pool:
            ahead: deque[tuple[int, int, Future[FloatImage]]] = deque()

            def request_next() -> None:
                for view, light in pairs:
                    ahead.append((view, light, pool.submit(self.linear, view, light, free.pop())))
                    return

            for _ in range(PREFETCH_FRAMES):
                request_next()
            try:
                while ahead:
                    view, light, image = ahead.popleft()
                    ready = image.result()
                    yield view, light, ready
                    free.append(ready)
                    request_next()
            finally:
                for _, _, image in ahead:
                    image.cancel()

    def linear_stack(
        self,
        view: int | None = None,
        light: int | None = None,
        out: FloatImage | None = None,
        job: Job | None = None,
    ) -> FloatImage:
        """Linear luminance of several frames at once.

        (L, H, W) of one view, (K, H, W) of one light, (K, L, H, W) of all.  ``out`` of that shape, float32,
        is filled and returned where given.
        """
        views: Sequence[int] = range(len(self.view_names)) if view is None else [view]
        lights: Sequence[int] = range(len(self.light_names)) if light is None else [light]
        axes = [len(n) for n, one in ((views, view), (lights, light)) if one is None]
        shape = (*axes, *self.shape)
        if out is None:
            out = np.empty(shape, dtype=np.float32)
        elif out.shape != shape or out.dtype != np.float32:
            raise ValueError(f"out is {out.dtype} {out.shape}, not float32 {shape}")
        flat = out.reshape(-1, *self.shape)
        with ensure_job(job).stage("read frames", len(flat)) as stage:
            for index, (_, _, image) in enumerate(self.stack(views, lights)):
                flat[index] = image
                stage.advance()
        return out

    def verify(self, job: Job | None = None) -> VerifyReport:
        """Hash every frame and compare with the journal; changes nothing."""
        return verify_frames(self._store, self.journal, job)

    def lock(self) -> RunLock:
        """Exclusive use of the run, for who writes results into it."""
        return RunLock(self.path)

    def _offset(self, kind: FrameKind, light: int | None) -> FloatImage | None:
        """Luminance of what is subtracted, kept per light: it serves every view."""
        key = (kind if kind == "centre" else "view", light)
        with self._cache_lock:
            if key not in self._offsets:
                counts = self._radiometry.offset(kind, light)
                sensor = self.spec.frame.sensor
                self._offsets[key] = None if counts is None else luminance(counts, sensor)
            return self._offsets[key]

    def _instrument(self) -> tuple[Plan, InstrumentProfile, Calibration]:
        acquired = self.spec.acquired
        assert acquired is not None  # a run is acquired where it is not imported
        assert self.calibration is not None  # set from the acquired part
        return acquired.plan, acquired.profile, self.calibration


def _imported_field(lights: Sequence[ImportedLight]) -> LightField | None:
    """Near lights where the place of each is known, distant ones where their directions are; else None."""
    directions = [light.direction for light in lights if light.direction is not None]
    positions = [light.position_mm for light in lights if light.position_mm is not None]
    powers = np.array([light.power for light in lights])
    if len(directions) < len(lights):
        return None
    if len(positions) < len(lights):
        field = LightField.distant(directions, powers)
    else:
        field = LightField.of_leds(positions, np.diag(powers))
    levels = [light.level for light in lights if light.level is not None]
    return field if len(levels) < len(lights) else field.with_level(levels)
