# Generated from protocol/protocol.yml by protocol/generator; do not edit.
"""Typed wire messages: Link between the host and the device that drives the glass, the LEDs and the camera trigger.

Every message is a frozen dataclass that checks its ranges when it is made; ``pack`` and ``unpack`` turn it into
the payload of a frame and back.  Units, ranges and meanings are in the fields' :class:`Wire` annotations.
"""

from enum import IntFlag
from dataclasses import dataclass
from typing import Annotated, ClassVar, Final

from reliefscope.protocol.codec import Event, Message, Refusal, Reply, Request, Struct, Wire, WireEnum

PROTOCOL_VERSION: Final = 1
SCHEMA_HASH: Final = bytes.fromhex("573b37b039e3d69574ab6d4e3cb95978")
MAX_PAYLOAD: Final = 258

APERTURE_SLOTS: Final = 16
"""Aperture bitmaps that the device keeps."""
LIGHT_SLOTS: Final = 32
"""Lights (sets of LED levels) that the device keeps."""
STEPS: Final = 1024
"""Steps in the table of a sequence."""
LEDS: Final = 48
"""LED lines that the device can drive."""
LED_LEVEL_MAX: Final = 4095
"""Full level of one LED."""
GLASS_WIDTH: Final = 128
"""Columns of the glass."""
GLASS_HEIGHT: Final = 64
"""Rows of the glass."""
APERTURE_BYTES: Final = 1024
"""Bytes of one bitmap: byte p*128+c, bit b is row 8p+b, column c; row 0 on top; bit 1 is open."""
APERTURE_CHUNK: Final = 256
"""Bytes of a bitmap that one request carries."""
APERTURE_CHUNKS: Final = 4
"""Chunks that make one bitmap."""
STEP_CHUNK: Final = 16
"""Steps that one request carries at most."""
SLOT_NONE: Final = 255
"""Built-in slot: aperture shut, light off."""
COMPLETION_RING: Final = 16
"""Completed requests whose answer the device keeps for a retry."""
EVENT_QUEUE: Final = 64
"""Events that the device keeps until the host acknowledges them."""
EVENT_RESERVE: Final = 4
"""Places of the event queue that exposure events leave free, for fault, sequence and boot events."""
LINK_TIMEOUT_MS: Final = 2000
"""Silence after which the device turns the light off outside a sequence."""
BOOTLOADER_MAGIC: Final = 1414483778
"""The letters BOOT; guards enter_bootloader."""
FIRST_FAILURE: Final = 16
"""Error codes below this reject a request before it reaches its handler; from this on it failed."""
TEMPERATURE_UNKNOWN: Final = -32768
"""Temperature of a board that cannot measure it."""


class ResetCause(WireEnum):
    """Why the device started last."""

    UNKNOWN = (0, "The board cannot tell.")
    POWER_ON = (1, "Power was applied.")
    PIN = (2, "The reset line was pulled.")
    WATCHDOG = (3, "The main loop stood still and the hardware watchdog ended it.")
    SOFTWARE = (4, "The firmware restarted itself.")
    BROWN_OUT = (5, "The supply fell below its limit.")
    LOCKUP = (6, "The processor met a fault that it could not handle.")
    BOOTLOADER = (7, "New firmware was flashed.")


class Capability(IntFlag):
    """What this board has beside the parts that every board has."""

    STROBE = 1
    """The camera's strobe (exposure active) line is wired."""
    READY = 2
    """The camera's trigger-ready line is wired."""
    TEMPERATURE = 4
    """The chip measures its temperature."""
    BOOTLOADER = 8
    """enter_bootloader works on this board."""


class GlassVariant(WireEnum):
    """Which glass is fitted; decides what a driven pixel does."""

    E_STN_POSITIVE = (0, "Transmissive STN, positive: clear when not driven.")
    S_FSTN_NEGATIVE = (1, "Transmissive FSTN, negative: dark when not driven.")
    W_FSTN_POSITIVE = (2, "Transflective FSTN, positive: clear when not driven.")


class Mounting(WireEnum):
    """How the glass sits; decides the driver chip's scan directions."""

    BOTTOM_VIEW = (0, "Segment direction reversed, rows normal (A1 C0), column offset 0.")
    TOP_VIEW = (1, "Turned by 180 degrees (A0 C8), column offset 4.")


class SequenceState(WireEnum):
    """What the sequencer does."""

    IDLE = (0, "No sequence runs.")
    RUNNING = (1, "Steps are being taken.")
    HELD = (2, "Waits between exposures, light off, until the host has acknowledged events.")
    PAUSING = (3, "Pause was asked for; the exposure under way ends first.")
    PAUSED = (4, "Stopped between two exposures, light off; resume goes on.")


class SequenceNews(WireEnum):
    """What a sequence event tells."""

    STARTED = (1, "The sequence started.")
    PAUSED = (2, "The sequence stands between two exposures.")
    RESUMED = (3, "The sequence goes on.")
    FINISHED = (4, "Every exposure of the table was made.")
    ABORTED = (5, "The sequence ended early: by request, or by the fault whose event came before.")


class ExposureFlag(IntFlag):
    """What the device saw of the camera during an exposure."""

    STROBE_SEEN = 1
    """The strobe line went active after the trigger."""
    READY_WAITED = 2
    """The trigger had to wait for the camera's ready line."""


class FaultReason(WireEnum):
    """Why the device latched a fault (light off, glass shut, sequence ended)."""

    NONE = (
        0,
        "No fault.",
        "Nothing is wrong.",
        "Go on.",
    )
    LED_ON_TIME = (
        1,
        "An LED was on for longer than its limit and was cut off.",
        "The exposure or a light that was selected by hand lasted longer than the LED may be on.",
        "Shorten the exposure or lower the number of repeats, then clear the fault.",
    )
    CURRENT_BUDGET = (
        2,
        "The levels of all LEDs together exceeded the current budget.",
        "A light asks for more LEDs at a higher level than the supply allows.",
        "Lower the levels of the light, then clear the fault.",
    )
    SEQUENCE_DEADLINE = (
        3,
        "The sequence did not end within its deadline.",
        "The camera stopped taking triggers, or the host stopped acknowledging events.",
        "Check that the camera delivers frames and that the host was not suspended, then clear the fault and resume the run.",
    )
    EVENTS_LOST = (
        4,
        "The event queue was full although exposures had been held back.",
        "The host is connected but does not read; several faults followed each other.",
        "Close other programs that hold the port, then clear the fault.",
    )
    CAMERA_NOT_READY = (
        5,
        "The camera's ready line stayed inactive for longer than the sequence allows.",
        "The camera is not armed, or its exposure is longer than the plan's.",
        "Arm the camera, check its trigger mode and exposure, then clear the fault.",
    )
    CAMERA_NO_STROBE = (
        6,
        "No strobe followed a trigger.",
        "The trigger cable is loose or the camera is not in hardware-trigger mode.",
        "Check the trigger and strobe cables and the camera's trigger mode, then clear the fault.",
    )
    TRIGGER_LATE = (
        7,
        "A trigger left later than allowed after its due time.",
        "The firmware was kept from its timer.",
        "Clear the fault and repeat; if it comes back, report it with the counters.",
    )
    OVER_TEMPERATURE = (
        8,
        "The chip is too hot.",
        "The LEDs or the board lack cooling, or a driver is shorted.",
        "Switch off, let the board cool down and check the LED drivers.",
    )
    INTERNAL = (
        9,
        "A check inside the firmware failed.",
        "A defect of the firmware.",
        "Restart the device, and report the fault with its detail number.",
    )


class ErrorCode(WireEnum):
    """Why a request was rejected or failed."""

    OK = (
        0,
        "No error; never sent.",
        "Nothing is wrong.",
        "Go on.",
    )
    UNKNOWN_MESSAGE = (
        1,
        "The device does not know this message.",
        "Host and firmware are of different versions.",
        "Flash the firmware that belongs to this host.",
    )
    BAD_LENGTH = (
        2,
        "The payload's length does not fit the message.",
        "Host and firmware are of different versions.",
        "Flash the firmware that belongs to this host.",
    )
    OUT_OF_RANGE = (
        3,
        "A field is outside its range; detail is the field's index, from 0.",
        "The host sent a value that the protocol does not allow.",
        "Check the value against the protocol reference.",
    )
    WRONG_NONCE = (
        4,
        "The request carries another boot's nonce.",
        "The device restarted since the host last asked who it is.",
        "Connect again; slots and tables must be loaded anew.",
    )
    REQUEST_TOO_OLD = (
        5,
        "A newer request was already run and this one is not among the answers that are kept; it was not run.",
        "A frame was delayed, or two programs use the port at once.",
        "Make sure that only one program uses the port, then connect again.",
    )
    REQUEST_ID_REUSED = (
        6,
        "Another request with this id was already run; this one was not.",
        "Two programs use the port at once.",
        "Make sure that only one program uses the port, then connect again.",
    )
    BAD_MAGIC = (
        7,
        "The guard word is wrong.",
        "The frame was not made by this host program.",
        "Use reliefscope flash to enter the bootloader.",
    )
    BUSY = (
        16,
        "Not possible while a sequence runs or is paused.",
        "A sequence is under way.",
        "Wait until it ends, or abort it.",
    )
    FAULT_LATCHED = (
        17,
        "A fault is latched; detail is its FaultReason.",
        "The device stopped itself for safety.",
        "Remove the cause, then clear the fault.",
    )
    SLOT_EMPTY = (
        18,
        "The slot holds nothing valid; detail is the slot, or the step that names it.",
        "The slot was not loaded since the device started, or only a part of it arrived.",
        "Load the slot again.",
    )
    CRC_MISMATCH = (
        19,
        "What was uploaded does not have the given CRC; detail is the CRC of what is there.",
        "A chunk is missing or belongs to another upload.",
        "Upload it again.",
    )
    CURRENT_BUDGET = (
        20,
        "The light exceeds the current budget; detail is the sum of its levels.",
        "Too many LEDs at too high a level.",
        "Lower the levels.",
    )
    ON_TIME_LIMIT = (
        21,
        "A step keeps a light on for longer than an LED may be on; detail is the step.",
        "Exposure too long.",
        "Shorten the exposure and take more repeats.",
    )
    NO_TABLE = (
        22,
        "No step table is committed.",
        "The table was not loaded since the device started, or a slot that it names changed.",
        "Load the step table again.",
    )
    TABLE_MISMATCH = (
        23,
        "The committed table has another hash; detail is its hash.",
        "Another table was loaded meanwhile.",
        "Load the step table again.",
    )
    NOT_RUNNING = (
        24,
        "No sequence with this run id is under way; detail is the run id under way, or 0.",
        "The sequence ended before.",
        "Read the status.",
    )
    EVENT_GONE = (
        25,
        "The event number is not in the queue; detail is the oldest number that is.",
        "The event was acknowledged before, or never happened.",
        "Read the status.",
    )
    SETTINGS_WRITE = (
        26,
        "The settings could not be stored.",
        "The non-volatile memory did not keep what was written.",
        "Try again; if it persists, the chip's memory is worn out.",
    )
    NO_BOOTLOADER = (
        27,
        "This board has no bootloader.",
        "It is a simulated or emulated board.",
        "Start it with the new firmware instead.",
    )
    LED_PERIOD = (
        28,
        "An exposure with light is not a whole number of the LED drivers' pulse periods; detail is the step.",
        "The drivers of this board dim by pulses, which would beat with the exposure.",
        "Take an exposure that is a multiple of led_period_us of the limits.",
    )
    LED_LEVEL_STEP = (
        29,
        "This board cannot make a level; detail is the LED.",
        "The drivers of this board know fewer levels than the request.",
        "Take multiples of led_level_step of the limits.",
    )


@dataclass(frozen=True, slots=True)
class Header(Struct):
    """Head of every frame, for both directions. Frozen for ever."""

    SIZE: ClassVar[int] = 11

    message: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Message id.",
        ),
    ]
    request_id: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Request and reply: the request's id. Event: the event's number.",
        ),
    ]
    boot_nonce: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Request: the nonce that HELLO gave (hello, enter_bootloader: any). Reply and event: the device's.",
        ),
    ]
    length: Annotated[
        int,
        Wire(
            "int",
            "u16",
            description="Bytes of payload that follow.",
        ),
    ]


@dataclass(frozen=True, slots=True)
class Step(Struct):
    """One line of the sequence's table."""

    SIZE: ClassVar[int] = 12

    aperture: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Aperture slot; 255 is shut.",
            maximum=15,
            also=(255,),
        ),
    ]
    light: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Light slot; 255 is off.",
            maximum=31,
            also=(255,),
        ),
    ]
    repeat: Annotated[
        int,
        Wire(
            "int",
            "u16",
            description="Exposures of this step.",
            minimum=1,
        ),
    ]
    settle_us: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Wait after aperture and light were set and before the first trigger.",
            unit="us",
            maximum=60000000,
        ),
    ]
    exposure_us: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Exposure time.",
            unit="us",
            minimum=10,
            maximum=60000000,
        ),
    ]


@dataclass(frozen=True, slots=True)
class HelloReply(Reply):
    """Answer to hello: what was set or found."""

    ID: ClassVar[int] = 0x81
    NAME: ClassVar[str] = "hello_reply"

    protocol_version: Annotated[
        int,
        Wire(
            "int",
            "u16",
            description="Version of this protocol.",
        ),
    ]
    schema_hash: Annotated[
        bytes,
        Wire(
            "int",
            "u8",
            description="First 16 bytes of the SHA-256 over everything that is on the wire.",
            count=16,
        ),
    ]
    firmware_version: Annotated[
        str,
        Wire(
            "ascii",
            "u8",
            description="Version of the firmware.",
            count=16,
        ),
    ]
    git_hash: Annotated[
        str,
        Wire(
            "ascii",
            "u8",
            description="Commit that the firmware was built from.",
            count=16,
        ),
    ]
    board: Annotated[
        str,
        Wire(
            "ascii",
            "u8",
            description="Board: teensy31, qemu_m4 or host.",
            count=16,
        ),
    ]
    serial_number: Annotated[
        str,
        Wire(
            "ascii",
            "u8",
            description="Serial number from the settings; empty when none was given.",
            count=16,
        ),
    ]
    capabilities: Annotated[
        Capability,
        Wire(
            "enum",
            "u32",
            description="What this board has.",
            of=Capability,
        ),
    ]
    reset_cause: Annotated[
        ResetCause,
        Wire(
            "enum",
            "u8",
            description="Why it started last.",
            of=ResetCause,
        ),
    ]
    boot_nonce: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Number that differs from boot to boot; never 0.",
            minimum=1,
        ),
    ]
    last_request_id: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Highest request id that was run since the start.",
        ),
    ]
    aperture_slots: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Number of aperture slots.",
        ),
    ]
    light_slots: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Number of light slots.",
        ),
    ]
    leds: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Number of LED lines.",
        ),
    ]
    steps: Annotated[
        int,
        Wire(
            "int",
            "u16",
            description="Number of steps that the table can hold.",
        ),
    ]
    reserved: Annotated[
        bytes,
        Wire(
            "int",
            "u8",
            description="Zero; for what a later version adds.",
            count=8,
        ),
    ]


@dataclass(frozen=True, slots=True)
class EnterBootloaderReply(Reply):
    """Answer to enter_bootloader: what was set or found."""

    ID: ClassVar[int] = 0x82
    NAME: ClassVar[str] = "enter_bootloader_reply"

    delay_ms: Annotated[
        int,
        Wire(
            "int",
            "u16",
            description="Time until the device leaves.",
            unit="ms",
        ),
    ]


@dataclass(frozen=True, slots=True)
class StatusReply(Reply):
    """Answer to status: what was set or found."""

    ID: ClassVar[int] = 0x83
    NAME: ClassVar[str] = "status_reply"

    sequence: Annotated[
        SequenceState,
        Wire(
            "enum",
            "u8",
            description="State of the sequencer.",
            of=SequenceState,
        ),
    ]
    fault: Annotated[
        FaultReason,
        Wire(
            "enum",
            "u8",
            description="Latched fault, or NONE.",
            of=FaultReason,
        ),
    ]
    aperture: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Aperture slot that was last sent to the glass; 255 is shut.",
            maximum=15,
            also=(255,),
        ),
    ]
    light: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Light slot that is on; 255 is off.",
            maximum=31,
            also=(255,),
        ),
    ]
    camera_ready: Annotated[
        bool,
        Wire(
            "bool",
            "u8",
            description="Level of the camera's ready line; true where it is not wired.",
        ),
    ]
    uptime_us: Annotated[
        int,
        Wire(
            "int",
            "u64",
            description="Time since the start.",
            unit="us",
        ),
    ]
    table_hash: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Hash of the committed table; 0 when there is none.",
        ),
    ]
    run_id: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Run id of the sequence under way or last; 0 when there was none.",
        ),
    ]
    step: Annotated[
        int,
        Wire(
            "int",
            "u16",
            description="Step that the sequencer is at.",
        ),
    ]
    exposures: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Exposures of this run that ended.",
        ),
    ]
    oldest_event: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Number of the oldest event that is not acknowledged; next_event when there is none.",
        ),
    ]
    next_event: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Number that the next event will get.",
        ),
    ]
    temperature_centi: Annotated[
        int,
        Wire(
            "int",
            "i16",
            description="Temperature of the chip; -32768 where it is not measured.",
            unit="0.01 degC",
        ),
    ]


@dataclass(frozen=True, slots=True)
class LimitsReply(Reply):
    """Answer to limits: what was set or found."""

    ID: ClassVar[int] = 0x84
    NAME: ClassVar[str] = "limits_reply"

    led_on_time_us: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Longest time that an LED may be on without a break.",
            unit="us",
        ),
    ]
    level_budget: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Largest sum of the levels of all LEDs.",
        ),
    ]
    led_period_us: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Period of the LED drivers' pulses: an exposure with light must be a whole number of them; 0 where currents are constant.",
            unit="us",
        ),
    ]
    led_level_step: Annotated[
        int,
        Wire(
            "int",
            "u16",
            description="Levels must be multiples of this; LED_LEVEL_MAX where an LED is on or off.",
            minimum=1,
            maximum=4095,
        ),
    ]
    link_timeout_ms: Annotated[
        int,
        Wire(
            "int",
            "u16",
            description="Silence after which the light goes off outside a sequence.",
            unit="ms",
        ),
    ]
    reset_ms: Annotated[
        int,
        Wire(
            "int",
            "u16",
            description="Time that the device needs from reset until it answers.",
            unit="ms",
        ),
    ]


@dataclass(frozen=True, slots=True)
class LoadLightReply(Reply):
    """Answer to load_light: what was set or found."""

    ID: ClassVar[int] = 0x90
    NAME: ClassVar[str] = "load_light_reply"

    slot: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Slot that was loaded.",
            maximum=31,
        ),
    ]
    crc32: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="CRC-32 over the levels of all LEDS LEDs as u16 little-endian.",
        ),
    ]
    level_sum: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Sum of the levels.",
        ),
    ]


@dataclass(frozen=True, slots=True)
class ApertureChunkReply(Reply):
    """Answer to aperture_chunk: what was set or found."""

    ID: ClassVar[int] = 0x91
    NAME: ClassVar[str] = "aperture_chunk_reply"

    slot: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Slot that was written.",
            maximum=15,
        ),
    ]
    chunk: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Chunk that was written.",
            maximum=3,
        ),
    ]


@dataclass(frozen=True, slots=True)
class CommitApertureReply(Reply):
    """Answer to commit_aperture: what was set or found."""

    ID: ClassVar[int] = 0x92
    NAME: ClassVar[str] = "commit_aperture_reply"

    slot: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Slot that is valid now.",
            maximum=15,
        ),
    ]
    crc32: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="CRC-32 over the bitmap that is in the slot.",
        ),
    ]
    open_pixels: Annotated[
        int,
        Wire(
            "int",
            "u16",
            description="Number of open pixels.",
            maximum=8192,
        ),
    ]


@dataclass(frozen=True, slots=True)
class SelectApertureReply(Reply):
    """Answer to select_aperture: what was set or found."""

    ID: ClassVar[int] = 0x93
    NAME: ClassVar[str] = "select_aperture_reply"

    slot: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Slot that is being sent.",
            maximum=15,
            also=(255,),
        ),
    ]
    crc32: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="CRC-32 over its bitmap (shut: 1,024 zeros).",
        ),
    ]


@dataclass(frozen=True, slots=True)
class SelectLightReply(Reply):
    """Answer to select_light: what was set or found."""

    ID: ClassVar[int] = 0x94
    NAME: ClassVar[str] = "select_light_reply"

    slot: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Slot that is on.",
            maximum=31,
            also=(255,),
        ),
    ]
    level_sum: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Sum of the levels that are on.",
        ),
    ]


@dataclass(frozen=True, slots=True)
class AllOffReply(Reply):
    """Answer to all_off: what was set or found."""

    ID: ClassVar[int] = 0x95
    NAME: ClassVar[str] = "all_off_reply"

    sequence: Annotated[
        SequenceState,
        Wire(
            "enum",
            "u8",
            description="State of the sequencer afterwards.",
            of=SequenceState,
        ),
    ]


@dataclass(frozen=True, slots=True)
class StepChunkReply(Reply):
    """Answer to step_chunk: what was set or found."""

    ID: ClassVar[int] = 0xA0
    NAME: ClassVar[str] = "step_chunk_reply"

    first: Annotated[
        int,
        Wire(
            "int",
            "u16",
            description="Index of the first step written.",
            maximum=1023,
        ),
    ]
    count: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Steps written.",
            maximum=16,
        ),
    ]


@dataclass(frozen=True, slots=True)
class CommitStepsReply(Reply):
    """Answer to commit_steps: what was set or found."""

    ID: ClassVar[int] = 0xA1
    NAME: ClassVar[str] = "commit_steps_reply"

    count: Annotated[
        int,
        Wire(
            "int",
            "u16",
            description="Steps of the table.",
            minimum=1,
            maximum=1024,
        ),
    ]
    table_hash: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Hash of the table (its CRC-32).",
        ),
    ]
    exposures: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Exposures of the whole table.",
        ),
    ]


@dataclass(frozen=True, slots=True)
class StartReply(Reply):
    """Answer to start: what was set or found."""

    ID: ClassVar[int] = 0xA2
    NAME: ClassVar[str] = "start_reply"

    run_id: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Run that was started.",
            minimum=1,
        ),
    ]
    table_hash: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Hash of the table that runs.",
        ),
    ]
    exposures: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Exposures that will follow.",
        ),
    ]


@dataclass(frozen=True, slots=True)
class PauseReply(Reply):
    """Answer to pause: what was set or found."""

    ID: ClassVar[int] = 0xA3
    NAME: ClassVar[str] = "pause_reply"

    sequence: Annotated[
        SequenceState,
        Wire(
            "enum",
            "u8",
            description="State of the sequencer.",
            of=SequenceState,
        ),
    ]
    exposures: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Exposures that ended.",
        ),
    ]


@dataclass(frozen=True, slots=True)
class ResumeReply(Reply):
    """Answer to resume: what was set or found."""

    ID: ClassVar[int] = 0xA4
    NAME: ClassVar[str] = "resume_reply"

    sequence: Annotated[
        SequenceState,
        Wire(
            "enum",
            "u8",
            description="State of the sequencer.",
            of=SequenceState,
        ),
    ]
    exposures: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Exposures that ended.",
        ),
    ]


@dataclass(frozen=True, slots=True)
class AbortReply(Reply):
    """Answer to abort: what was set or found."""

    ID: ClassVar[int] = 0xA5
    NAME: ClassVar[str] = "abort_reply"

    sequence: Annotated[
        SequenceState,
        Wire(
            "enum",
            "u8",
            description="State of the sequencer.",
            of=SequenceState,
        ),
    ]
    exposures: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Exposures that ended.",
        ),
    ]


@dataclass(frozen=True, slots=True)
class ClearFaultReply(Reply):
    """Answer to clear_fault: what was set or found."""

    ID: ClassVar[int] = 0xA6
    NAME: ClassVar[str] = "clear_fault_reply"

    fault: Annotated[
        FaultReason,
        Wire(
            "enum",
            "u8",
            description="Fault that is latched now.",
            of=FaultReason,
        ),
    ]


@dataclass(frozen=True, slots=True)
class AcknowledgeEventsReply(Reply):
    """Answer to acknowledge_events: what was set or found."""

    ID: ClassVar[int] = 0xA7
    NAME: ClassVar[str] = "acknowledge_events_reply"

    oldest_event: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Oldest event that is kept.",
        ),
    ]
    next_event: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Number that the next event will get.",
        ),
    ]


@dataclass(frozen=True, slots=True)
class CountersReply(Reply):
    """Answer to counters: what was set or found."""

    ID: ClassVar[int] = 0xB0
    NAME: ClassVar[str] = "counters_reply"

    frames_received: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Frames whose CRC was right.",
        ),
    ]
    frames_sent: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Frames sent.",
        ),
    ]
    crc_errors: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Frames dropped for their CRC.",
        ),
    ]
    framing_errors: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Frames dropped for their form: COBS, too short, length field.",
        ),
    ]
    overruns: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Frames dropped because they were too long.",
        ),
    ]
    rejected: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Requests rejected.",
        ),
    ]
    failed: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Requests failed.",
        ),
    ]
    retries_answered: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Retries answered from the ring.",
        ),
    ]
    wrong_nonce: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Requests with another boot's nonce.",
        ),
    ]
    events_sent: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Events sent for the first time.",
        ),
    ]
    events_resent: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Events sent again.",
        ),
    ]
    exposures: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Exposures made.",
        ),
    ]
    link_timeouts: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Times that the light was turned off because the link was silent.",
        ),
    ]
    faults: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Faults latched.",
        ),
    ]


@dataclass(frozen=True, slots=True)
class GetSettingsReply(Reply):
    """Answer to get_settings: what was set or found."""

    ID: ClassVar[int] = 0xB1
    NAME: ClassVar[str] = "get_settings_reply"

    serial_number: Annotated[
        str,
        Wire(
            "ascii",
            "u8",
            description="Serial number of the instrument.",
            count=16,
        ),
    ]
    glass_variant: Annotated[
        GlassVariant,
        Wire(
            "enum",
            "u8",
            description="Glass that is fitted.",
            of=GlassVariant,
        ),
    ]
    mounting: Annotated[
        Mounting,
        Wire(
            "enum",
            "u8",
            description="How the glass sits.",
            of=Mounting,
        ),
    ]
    contrast: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Fine contrast of the driver chip (electronic volume).",
            maximum=63,
        ),
    ]
    resistor_ratio: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Coarse contrast of the driver chip (resistor ratio).",
            maximum=7,
        ),
    ]


@dataclass(frozen=True, slots=True)
class SetSettingsReply(Reply):
    """Answer to set_settings: what was set or found."""

    ID: ClassVar[int] = 0xB2
    NAME: ClassVar[str] = "set_settings_reply"

    serial_number: Annotated[
        str,
        Wire(
            "ascii",
            "u8",
            description="Serial number of the instrument.",
            count=16,
        ),
    ]
    glass_variant: Annotated[
        GlassVariant,
        Wire(
            "enum",
            "u8",
            description="Glass that is fitted.",
            of=GlassVariant,
        ),
    ]
    mounting: Annotated[
        Mounting,
        Wire(
            "enum",
            "u8",
            description="How the glass sits.",
            of=Mounting,
        ),
    ]
    contrast: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Fine contrast of the driver chip (electronic volume).",
            maximum=63,
        ),
    ]
    resistor_ratio: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Coarse contrast of the driver chip (resistor ratio).",
            maximum=7,
        ),
    ]


@dataclass(frozen=True, slots=True)
class GetLedCorrectionReply(Reply):
    """Answer to get_led_correction: what was set or found."""

    ID: ClassVar[int] = 0xB3
    NAME: ClassVar[str] = "get_led_correction_reply"

    factors: Annotated[
        bytes,
        Wire(
            "int",
            "u8",
            description="Factor of each LED: its current is level * (factor + 1) / 256, rounded down. 255: none.",
            count=48,
        ),
    ]


@dataclass(frozen=True, slots=True)
class SetLedCorrectionReply(Reply):
    """Answer to set_led_correction: what was set or found."""

    ID: ClassVar[int] = 0xB4
    NAME: ClassVar[str] = "set_led_correction_reply"

    factors: Annotated[
        bytes,
        Wire(
            "int",
            "u8",
            description="Factor of each LED: its current is level * (factor + 1) / 256, rounded down. 255: none.",
            count=48,
        ),
    ]


@dataclass(frozen=True, slots=True)
class Rejected(Refusal):
    """The request did not reach its handler. Nothing happened. Not kept in the ring."""

    ID: ClassVar[int] = 0xFE
    NAME: ClassVar[str] = "rejected"

    code: Annotated[
        ErrorCode,
        Wire(
            "enum",
            "u8",
            description="Why.",
            of=ErrorCode,
        ),
    ]
    message: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Message id of the request.",
        ),
    ]
    detail: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Number whose meaning the error code tells.",
        ),
    ]


@dataclass(frozen=True, slots=True)
class Failed(Refusal):
    """The request was understood but could not be done. Nothing happened. Kept in the ring."""

    ID: ClassVar[int] = 0xFF
    NAME: ClassVar[str] = "failed"

    code: Annotated[
        ErrorCode,
        Wire(
            "enum",
            "u8",
            description="Why.",
            of=ErrorCode,
        ),
    ]
    message: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Message id of the request.",
        ),
    ]
    detail: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Number whose meaning the error code tells.",
        ),
    ]


@dataclass(frozen=True, slots=True)
class BootedEvent(Event):
    """First event after a start (number 0)."""

    ID: ClassVar[int] = 0x40
    NAME: ClassVar[str] = "booted_event"

    reset_cause: Annotated[
        ResetCause,
        Wire(
            "enum",
            "u8",
            description="Why the device started.",
            of=ResetCause,
        ),
    ]


@dataclass(frozen=True, slots=True)
class ExposureEvent(Event):
    """One exposure ended."""

    ID: ClassVar[int] = 0x41
    NAME: ClassVar[str] = "exposure_event"

    table_hash: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Hash of the table.",
        ),
    ]
    run_id: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Run.",
        ),
    ]
    index: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Exposure within the run, from 0.",
        ),
    ]
    step: Annotated[
        int,
        Wire(
            "int",
            "u16",
            description="Step of the table.",
            maximum=1023,
        ),
    ]
    repeat: Annotated[
        int,
        Wire(
            "int",
            "u16",
            description="Exposure within the step, from 0.",
        ),
    ]
    aperture: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Aperture slot that was on the glass.",
            maximum=15,
            also=(255,),
        ),
    ]
    light: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Light slot that was on.",
            maximum=31,
            also=(255,),
        ),
    ]
    start_us: Annotated[
        int,
        Wire(
            "int",
            "u64",
            description="Device time of the trigger's edge.",
            unit="us",
        ),
    ]
    settle_waited_us: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Time from the last byte to the glass to the trigger.",
            unit="us",
        ),
    ]
    exposure_us: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Exposure that was made.",
            unit="us",
        ),
    ]
    flags: Annotated[
        ExposureFlag,
        Wire(
            "enum",
            "u8",
            description="What was seen of the camera.",
            of=ExposureFlag,
        ),
    ]


@dataclass(frozen=True, slots=True)
class SequenceEvent(Event):
    """A sequence started, paused, went on or ended."""

    ID: ClassVar[int] = 0x42
    NAME: ClassVar[str] = "sequence_event"

    news: Annotated[
        SequenceNews,
        Wire(
            "enum",
            "u8",
            description="What happened.",
            of=SequenceNews,
        ),
    ]
    run_id: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Run.",
        ),
    ]
    table_hash: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Hash of the table.",
        ),
    ]
    exposures: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Exposures that ended.",
        ),
    ]
    at_us: Annotated[
        int,
        Wire(
            "int",
            "u64",
            description="Device time.",
            unit="us",
        ),
    ]


@dataclass(frozen=True, slots=True)
class FaultEvent(Event):
    """A fault was latched. Light off, glass shut; a sequence under way ends with ABORTED."""

    ID: ClassVar[int] = 0x43
    NAME: ClassVar[str] = "fault_event"

    reason: Annotated[
        FaultReason,
        Wire(
            "enum",
            "u8",
            description="Why.",
            of=FaultReason,
        ),
    ]
    run_id: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Run under way; 0 when there was none.",
        ),
    ]
    step: Annotated[
        int,
        Wire(
            "int",
            "u16",
            description="Step that the sequencer was at.",
        ),
    ]
    at_us: Annotated[
        int,
        Wire(
            "int",
            "u64",
            description="Device time.",
            unit="us",
        ),
    ]
    detail: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Number that tells more to who maintains the firmware.",
        ),
    ]


@dataclass(frozen=True, slots=True)
class HelloRequest(Request[HelloReply]):
    """Who is there. Read-only, valid with any nonce and across any difference of versions. The host takes its next ids from above last_request_id."""

    ID: ClassVar[int] = 0x01
    NAME: ClassVar[str] = "hello_request"
    REPLY: ClassVar[type[Message]] = HelloReply
    RING: ClassVar[bool] = False



@dataclass(frozen=True, slots=True)
class EnterBootloaderRequest(Request[EnterBootloaderReply]):
    """Light off, then leave for the bootloader after the reply was sent. Valid with any nonce and across any difference of versions, also during a sequence."""

    ID: ClassVar[int] = 0x02
    NAME: ClassVar[str] = "enter_bootloader_request"
    REPLY: ClassVar[type[Message]] = EnterBootloaderReply
    RING: ClassVar[bool] = False

    magic: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="BOOTLOADER_MAGIC; anything else is rejected with BAD_MAGIC.",
        ),
    ]


@dataclass(frozen=True, slots=True)
class StatusRequest(Request[StatusReply]):
    """What the device does now."""

    ID: ClassVar[int] = 0x03
    NAME: ClassVar[str] = "status_request"
    REPLY: ClassVar[type[Message]] = StatusReply
    RING: ClassVar[bool] = True



@dataclass(frozen=True, slots=True)
class LimitsRequest(Request[LimitsReply]):
    """Safety limits of this board. They are compiled in; no request changes them."""

    ID: ClassVar[int] = 0x04
    NAME: ClassVar[str] = "limits_request"
    REPLY: ClassVar[type[Message]] = LimitsReply
    RING: ClassVar[bool] = True



@dataclass(frozen=True, slots=True)
class LoadLightRequest(Request[LoadLightReply]):
    """Loads a light slot. The light that is on does not change until it is selected again."""

    ID: ClassVar[int] = 0x10
    NAME: ClassVar[str] = "load_light_request"
    REPLY: ClassVar[type[Message]] = LoadLightReply
    RING: ClassVar[bool] = True

    slot: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Slot to load.",
            maximum=31,
        ),
    ]
    levels: Annotated[
        tuple[int, ...],
        Wire(
            "int",
            "u16",
            description="Level of LED 0, 1, ...; LEDs that are not named are off.",
            count=48,
            bounded=True,
            maximum=4095,
        ),
    ]


@dataclass(frozen=True, slots=True)
class ApertureChunkRequest(Request[ApertureChunkReply]):
    """Writes a part of an aperture slot. The slot is empty until it is committed."""

    ID: ClassVar[int] = 0x11
    NAME: ClassVar[str] = "aperture_chunk_request"
    REPLY: ClassVar[type[Message]] = ApertureChunkReply
    RING: ClassVar[bool] = True

    slot: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Slot to write.",
            maximum=15,
        ),
    ]
    chunk: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Which quarter of the bitmap.",
            maximum=3,
        ),
    ]
    data: Annotated[
        bytes,
        Wire(
            "int",
            "u8",
            description="Bytes chunk*256 to chunk*256+255 of the bitmap.",
            count=256,
        ),
    ]


@dataclass(frozen=True, slots=True)
class CommitApertureRequest(Request[CommitApertureReply]):
    """Makes an aperture slot valid if all its 1,024 bytes have the given CRC."""

    ID: ClassVar[int] = 0x12
    NAME: ClassVar[str] = "commit_aperture_request"
    REPLY: ClassVar[type[Message]] = CommitApertureReply
    RING: ClassVar[bool] = True

    slot: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Slot to commit.",
            maximum=15,
        ),
    ]
    crc32: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="CRC-32 over the bitmap.",
        ),
    ]


@dataclass(frozen=True, slots=True)
class SelectApertureRequest(Request[SelectApertureReply]):
    """Sends a slot to the glass. The glass takes its time to follow."""

    ID: ClassVar[int] = 0x13
    NAME: ClassVar[str] = "select_aperture_request"
    REPLY: ClassVar[type[Message]] = SelectApertureReply
    RING: ClassVar[bool] = True

    slot: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Slot; 255 is shut.",
            maximum=15,
            also=(255,),
        ),
    ]


@dataclass(frozen=True, slots=True)
class SelectLightRequest(Request[SelectLightReply]):
    """Turns a light on, and any other off. The light goes off after the LED's on-time limit or when the link falls silent."""

    ID: ClassVar[int] = 0x14
    NAME: ClassVar[str] = "select_light_request"
    REPLY: ClassVar[type[Message]] = SelectLightReply
    RING: ClassVar[bool] = True

    slot: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Slot; 255 is off.",
            maximum=31,
            also=(255,),
        ),
    ]


@dataclass(frozen=True, slots=True)
class AllOffRequest(Request[AllOffReply]):
    """All LEDs off at once, always. Aborts a sequence; the glass stays as it is."""

    ID: ClassVar[int] = 0x15
    NAME: ClassVar[str] = "all_off_request"
    REPLY: ClassVar[type[Message]] = AllOffReply
    RING: ClassVar[bool] = True



@dataclass(frozen=True, slots=True)
class StepChunkRequest(Request[StepChunkReply]):
    """Writes steps into the table. The table is not usable until it is committed."""

    ID: ClassVar[int] = 0x20
    NAME: ClassVar[str] = "step_chunk_request"
    REPLY: ClassVar[type[Message]] = StepChunkReply
    RING: ClassVar[bool] = True

    first: Annotated[
        int,
        Wire(
            "int",
            "u16",
            description="Index of the first step written.",
            maximum=1023,
        ),
    ]
    steps: Annotated[
        tuple[Step, ...],
        Wire(
            "struct",
            "Step",
            description="Steps from there on.",
            of=Step,
            count=16,
            bounded=True,
        ),
    ]


@dataclass(frozen=True, slots=True)
class CommitStepsRequest(Request[CommitStepsReply]):
    """Makes the first `count` steps the table, if they have the given CRC (over their wire form), every slot they name is loaded, and no limit is exceeded. The CRC is the table's hash."""

    ID: ClassVar[int] = 0x21
    NAME: ClassVar[str] = "commit_steps_request"
    REPLY: ClassVar[type[Message]] = CommitStepsReply
    RING: ClassVar[bool] = True

    count: Annotated[
        int,
        Wire(
            "int",
            "u16",
            description="Steps of the table.",
            minimum=1,
            maximum=1024,
        ),
    ]
    crc32: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="CRC-32 over the steps as they are on the wire.",
        ),
    ]


@dataclass(frozen=True, slots=True)
class StartRequest(Request[StartReply]):
    """Starts the committed table."""

    ID: ClassVar[int] = 0x22
    NAME: ClassVar[str] = "start_request"
    REPLY: ClassVar[type[Message]] = StartReply
    RING: ClassVar[bool] = True

    run_id: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Number chosen by the host; every event of this sequence carries it.",
            minimum=1,
        ),
    ]
    table_hash: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Hash of the table that is to run.",
        ),
    ]
    deadline_ms: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Longest time from here to the end, pauses not counted; then SEQUENCE_DEADLINE.",
            unit="ms",
            minimum=1,
        ),
    ]
    light_lead_us: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Time that the light is on before each trigger.",
            unit="us",
            maximum=1000000,
        ),
    ]
    trigger_us: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Length of the trigger pulse.",
            unit="us",
            minimum=1,
            maximum=100000,
        ),
    ]
    gap_us: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Wait from the end of an exposure to what comes next.",
            unit="us",
            maximum=10000000,
        ),
    ]
    ready_timeout_ms: Annotated[
        int,
        Wire(
            "int",
            "u16",
            description="Longest wait for the camera's ready line (where wired); 0 ignores the line.",
            unit="ms",
        ),
    ]
    require_strobe: Annotated[
        bool,
        Wire(
            "bool",
            "u8",
            description="A trigger without a strobe is a fault (where wired).",
        ),
    ]


@dataclass(frozen=True, slots=True)
class PauseRequest(Request[PauseReply]):
    """No trigger after at most 1 ms; the exposure under way ends as planned. A sequence event tells when it stands."""

    ID: ClassVar[int] = 0x23
    NAME: ClassVar[str] = "pause_request"
    REPLY: ClassVar[type[Message]] = PauseReply
    RING: ClassVar[bool] = True

    run_id: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Run to pause.",
            minimum=1,
        ),
    ]


@dataclass(frozen=True, slots=True)
class ResumeRequest(Request[ResumeReply]):
    """Goes on after a pause, with the settle time of the step waited again."""

    ID: ClassVar[int] = 0x24
    NAME: ClassVar[str] = "resume_request"
    REPLY: ClassVar[type[Message]] = ResumeReply
    RING: ClassVar[bool] = True

    run_id: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Run to resume.",
            minimum=1,
        ),
    ]


@dataclass(frozen=True, slots=True)
class AbortRequest(Request[AbortReply]):
    """Light off within 1 ms, glass shut, sequence ended. With no sequence under way nothing happens and that is no error."""

    ID: ClassVar[int] = 0x25
    NAME: ClassVar[str] = "abort_request"
    REPLY: ClassVar[type[Message]] = AbortReply
    RING: ClassVar[bool] = True

    run_id: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Run to abort; 0 is any.",
        ),
    ]


@dataclass(frozen=True, slots=True)
class ClearFaultRequest(Request[ClearFaultReply]):
    """Clears the latched fault if it is the one named. With none latched nothing happens and that is no error."""

    ID: ClassVar[int] = 0x26
    NAME: ClassVar[str] = "clear_fault_request"
    REPLY: ClassVar[type[Message]] = ClearFaultReply
    RING: ClassVar[bool] = True

    reason: Annotated[
        FaultReason,
        Wire(
            "enum",
            "u8",
            description="Fault that the host has seen.",
            of=FaultReason,
        ),
    ]


@dataclass(frozen=True, slots=True)
class AcknowledgeEventsRequest(Request[AcknowledgeEventsReply]):
    """The host has every event below next_event: the device forgets them. With resend it also sends again what it still holds from there on."""

    ID: ClassVar[int] = 0x27
    NAME: ClassVar[str] = "acknowledge_events_request"
    REPLY: ClassVar[type[Message]] = AcknowledgeEventsReply
    RING: ClassVar[bool] = True

    next_event: Annotated[
        int,
        Wire(
            "int",
            "u32",
            description="Number of the first event that the host does not have.",
        ),
    ]
    resend: Annotated[
        bool,
        Wire(
            "bool",
            "u8",
            description="Send the events from there on again.",
        ),
    ]


@dataclass(frozen=True, slots=True)
class CountersRequest(Request[CountersReply]):
    """What the device counted since its start."""

    ID: ClassVar[int] = 0x30
    NAME: ClassVar[str] = "counters_request"
    REPLY: ClassVar[type[Message]] = CountersReply
    RING: ClassVar[bool] = True



@dataclass(frozen=True, slots=True)
class GetSettingsRequest(Request[GetSettingsReply]):
    """Settings in the non-volatile memory; they survive flashing."""

    ID: ClassVar[int] = 0x31
    NAME: ClassVar[str] = "get_settings_request"
    REPLY: ClassVar[type[Message]] = GetSettingsReply
    RING: ClassVar[bool] = True



@dataclass(frozen=True, slots=True)
class SetSettingsRequest(Request[SetSettingsReply]):
    """Replaces all settings, stores them and sets the glass up again. Not during a sequence."""

    ID: ClassVar[int] = 0x32
    NAME: ClassVar[str] = "set_settings_request"
    REPLY: ClassVar[type[Message]] = SetSettingsReply
    RING: ClassVar[bool] = True

    serial_number: Annotated[
        str,
        Wire(
            "ascii",
            "u8",
            description="Serial number of the instrument.",
            count=16,
        ),
    ]
    glass_variant: Annotated[
        GlassVariant,
        Wire(
            "enum",
            "u8",
            description="Glass that is fitted.",
            of=GlassVariant,
        ),
    ]
    mounting: Annotated[
        Mounting,
        Wire(
            "enum",
            "u8",
            description="How the glass sits.",
            of=Mounting,
        ),
    ]
    contrast: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Fine contrast of the driver chip (electronic volume).",
            maximum=63,
        ),
    ]
    resistor_ratio: Annotated[
        int,
        Wire(
            "int",
            "u8",
            description="Coarse contrast of the driver chip (resistor ratio).",
            maximum=7,
        ),
    ]


@dataclass(frozen=True, slots=True)
class GetLedCorrectionRequest(Request[GetLedCorrectionReply]):
    """Correction of each LED in the non-volatile memory; it survives flashing."""

    ID: ClassVar[int] = 0x33
    NAME: ClassVar[str] = "get_led_correction_request"
    REPLY: ClassVar[type[Message]] = GetLedCorrectionReply
    RING: ClassVar[bool] = True



@dataclass(frozen=True, slots=True)
class SetLedCorrectionRequest(Request[SetLedCorrectionReply]):
    """Replaces the correction of all LEDs and stores it. It acts when a light is next selected. Not during a sequence."""

    ID: ClassVar[int] = 0x34
    NAME: ClassVar[str] = "set_led_correction_request"
    REPLY: ClassVar[type[Message]] = SetLedCorrectionReply
    RING: ClassVar[bool] = True

    factors: Annotated[
        bytes,
        Wire(
            "int",
            "u8",
            description="Factor of each LED: its current is level * (factor + 1) / 256, rounded down. 255: none.",
            count=48,
        ),
    ]


MESSAGES: Final[dict[int, type[Message]]] = {
    message.ID: message
    for message in (
        HelloRequest,
        HelloReply,
        EnterBootloaderRequest,
        EnterBootloaderReply,
        StatusRequest,
        StatusReply,
        LimitsRequest,
        LimitsReply,
        LoadLightRequest,
        LoadLightReply,
        ApertureChunkRequest,
        ApertureChunkReply,
        CommitApertureRequest,
        CommitApertureReply,
        SelectApertureRequest,
        SelectApertureReply,
        SelectLightRequest,
        SelectLightReply,
        AllOffRequest,
        AllOffReply,
        StepChunkRequest,
        StepChunkReply,
        CommitStepsRequest,
        CommitStepsReply,
        StartRequest,
        StartReply,
        PauseRequest,
        PauseReply,
        ResumeRequest,
        ResumeReply,
        AbortRequest,
        AbortReply,
        ClearFaultRequest,
        ClearFaultReply,
        AcknowledgeEventsRequest,
        AcknowledgeEventsReply,
        CountersRequest,
        CountersReply,
        GetSettingsRequest,
        GetSettingsReply,
        SetSettingsRequest,
        SetSettingsReply,
        GetLedCorrectionRequest,
        GetLedCorrectionReply,
        SetLedCorrectionRequest,
        SetLedCorrectionReply,
        Rejected,
        Failed,
        BootedEvent,
        ExposureEvent,
        SequenceEvent,
        FaultEvent,
    )
}
"""Every message by its id."""
