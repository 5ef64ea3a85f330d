// Generated from protocol/protocol.yml by protocol/generator; do not edit. Link between the host and the device that drives the glass, the LEDs and the camera trigger.
//
// Every function is free of heap, exceptions and undefined behaviour: bytes are read and written one by one, sizes are
// checked first, and a value is cast to an enum only together with is_valid().
// clang-format off
#pragma once

#include <cstddef>
#include <cstdint>

namespace reliefscope::wire {

inline constexpr std::uint16_t kProtocolVersion = 1;
inline constexpr std::uint8_t kSchemaHash[16] = {0x57, 0x3B, 0x37, 0xB0, 0x39, 0xE3, 0xD6, 0x95, 0x74, 0xAB, 0x6D, 0x4E, 0x3C, 0xB9, 0x59, 0x78};
inline constexpr std::size_t kHeaderSize = 11;
inline constexpr std::size_t kCrcSize = 4;
inline constexpr std::size_t kMaxPayload = 258;
// Header, payload and CRC before COBS.
inline constexpr std::size_t kMaxFrame = kHeaderSize + kMaxPayload + kCrcSize;
// The same after COBS, with the delimiter.
inline constexpr std::size_t kMaxEncodedFrame = kMaxFrame + kMaxFrame / 254 + 2;
// Largest payload of an answer that the completion ring keeps, and of an event.
inline constexpr std::size_t kMaxRingReply = 56;
inline constexpr std::size_t kMaxEvent = 35;

// Aperture bitmaps that the device keeps.
inline constexpr std::uint32_t kApertureSlots = 16U;
// Lights (sets of LED levels) that the device keeps.
inline constexpr std::uint32_t kLightSlots = 32U;
// Steps in the table of a sequence.
inline constexpr std::uint32_t kSteps = 1024U;
// LED lines that the device can drive.
inline constexpr std::uint32_t kLeds = 48U;
// Full level of one LED.
inline constexpr std::uint32_t kLedLevelMax = 4095U;
// Columns of the glass.
inline constexpr std::uint32_t kGlassWidth = 128U;
// Rows of the glass.
inline constexpr std::uint32_t kGlassHeight = 64U;
// Bytes of one bitmap: byte p*128+c, bit b is row 8p+b, column c; row 0 on top; bit 1 is open.
inline constexpr std::uint32_t kApertureBytes = 1024U;
// Bytes of a bitmap that one request carries.
inline constexpr std::uint32_t kApertureChunk = 256U;
// Chunks that make one bitmap.
inline constexpr std::uint32_t kApertureChunks = 4U;
// Steps that one request carries at most.
inline constexpr std::uint32_t kStepChunk = 16U;
// Built-in slot: aperture shut, light off.
inline constexpr std::uint32_t kSlotNone = 255U;
// Completed requests whose answer the device keeps for a retry.
inline constexpr std::uint32_t kCompletionRing = 16U;
// Events that the device keeps until the host acknowledges them.
inline constexpr std::uint32_t kEventQueue = 64U;
// Places of the event queue that exposure events leave free, for fault, sequence and boot events.
inline constexpr std::uint32_t kEventReserve = 4U;
// Silence after which the device turns the light off outside a sequence.
inline constexpr std::uint32_t kLinkTimeoutMs = 2000U;
// The letters BOOT; guards enter_bootloader.
inline constexpr std::uint32_t kBootloaderMagic = 1414483778U;
// Error codes below this reject a request before it reaches its handler; from this on it failed.
inline constexpr std::uint32_t kFirstFailure = 16U;
// Temperature of a board that cannot measure it.
inline constexpr std::int32_t kTemperatureUnknown = -32768;

// Why the device started last.
enum class ResetCause : std::uint8_t {
  kUnknown = 0,  // The board cannot tell.
  kPowerOn = 1,  // Power was applied.
  kPin = 2,  // The reset line was pulled.
  kWatchdog = 3,  // The main loop stood still and the hardware watchdog ended it.
  kSoftware = 4,  // The firmware restarted itself.
  kBrownOut = 5,  // The supply fell below its limit.
  kLockup = 6,  // The processor met a fault that it could not handle.
  kBootloader = 7,  // New firmware was flashed.
};

constexpr bool is_valid(ResetCause value) {
  switch (value) {
    case ResetCause::kUnknown:
    case ResetCause::kPowerOn:
    case ResetCause::kPin:
    case ResetCause::kWatchdog:
    case ResetCause::kSoftware:
    case ResetCause::kBrownOut:
    case ResetCause::kLockup:
    case ResetCause::kBootloader:
      return true;
  }
  return false;
}

// What this board has beside the parts that every board has.
struct Capability {
  static constexpr std::uint32_t kStrobe = 1U;  // The camera's strobe (exposure active) line is wired.
  static constexpr std::uint32_t kReady = 2U;  // The camera's trigger-ready line is wired.
  static constexpr std::uint32_t kTemperature = 4U;  // The chip measures its temperature.
  static constexpr std::uint32_t kBootloader = 8U;  // enter_bootloader works on this board.
};

// Which glass is fitted; decides what a driven pixel does.
enum class GlassVariant : std::uint8_t {
  kEStnPositive = 0,  // Transmissive STN, positive: clear when not driven.
  kSFstnNegative = 1,  // Transmissive FSTN, negative: dark when not driven.
  kWFstnPositive = 2,  // Transflective FSTN, positive: clear when not driven.
};

constexpr bool is_valid(GlassVariant value) {
  switch (value) {
    case GlassVariant::kEStnPositive:
    case GlassVariant::kSFstnNegative:
    case GlassVariant::kWFstnPositive:
      return true;
  }
  return false;
}

// How the glass sits; decides the driver chip's scan directions.
enum class Mounting : std::uint8_t {
  kBottomView = 0,  // Segment direction reversed, rows normal (A1 C0), column offset 0.
  kTopView = 1,  // Turned by 180 degrees (A0 C8), column offset 4.
};

constexpr bool is_valid(Mounting value) {
  switch (value) {
    case Mounting::kBottomView:
    case Mounting::kTopView:
      return true;
  }
  return false;
}

// What the sequencer does.
enum class SequenceState : std::uint8_t {
  kIdle = 0,  // No sequence runs.
  kRunning = 1,  // Steps are being taken.
  kHeld = 2,  // Waits between exposures, light off, until the host has acknowledged events.
  kPausing = 3,  // Pause was asked for; the exposure under way ends first.
  kPaused = 4,  // Stopped between two exposures, light off; resume goes on.
};

constexpr bool is_valid(SequenceState value) {
  switch (value) {
    case SequenceState::kIdle:
    case SequenceState::kRunning:
    case SequenceState::kHeld:
    case SequenceState::kPausing:
    case SequenceState::kPaused:
      return true;
  }
  return false;
}

// What a sequence event tells.
enum class SequenceNews : std::uint8_t {
  kStarted = 1,  // The sequence started.
  kPaused = 2,  // The sequence stands between two exposures.
  kResumed = 3,  // The sequence goes on.
  kFinished = 4,  // Every exposure of the table was made.
  kAborted = 5,  // The sequence ended early: by request, or by the fault whose event came before.
};

constexpr bool is_valid(SequenceNews value) {
  switch (value) {
    case SequenceNews::kStarted:
    case SequenceNews::kPaused:
    case SequenceNews::kResumed:
    case SequenceNews::kFinished:
    case SequenceNews::kAborted:
      return true;
  }
  return false;
}

// What the device saw of the camera during an exposure.
struct ExposureFlag {
  static constexpr std::uint8_t kStrobeSeen = 1U;  // The strobe line went active after the trigger.
  static constexpr std::uint8_t kReadyWaited = 2U;  // The trigger had to wait for the camera's ready line.
};

// Why the device latched a fault (light off, glass shut, sequence ended).
enum class FaultReason : std::uint8_t {
  kNone = 0,  // No fault.
  kLedOnTime = 1,  // An LED was on for longer than its limit and was cut off.
  kCurrentBudget = 2,  // The levels of all LEDs together exceeded the current budget.
  kSequenceDeadline = 3,  // The sequence did not end within its deadline.
  kEventsLost = 4,  // The event queue was full although exposures had been held back.
  kCameraNotReady = 5,  // The camera's ready line stayed inactive for longer than the sequence allows.
  kCameraNoStrobe = 6,  // No strobe followed a trigger.
  kTriggerLate = 7,  // A trigger left later than allowed after its due time.
  kOverTemperature = 8,  // The chip is too hot.
  kInternal = 9,  // A check inside the firmware failed.
};

constexpr bool is_valid(FaultReason value) {
  switch (value) {
    case FaultReason::kNone:
    case FaultReason::kLedOnTime:
    case FaultReason::kCurrentBudget:
    case FaultReason::kSequenceDeadline:
    case FaultReason::kEventsLost:
    case FaultReason::kCameraNotReady:
    case FaultReason::kCameraNoStrobe:
    case FaultReason::kTriggerLate:
    case FaultReason::kOverTemperature:
    case FaultReason::kInternal:
      return true;
  }
  return false;
}

// Why a request was rejected or failed.
enum class ErrorCode : std::uint8_t {
  kOk = 0,  // No error; never sent.
  kUnknownMessage = 1,  // The device does not know this message.
  kBadLength = 2,  // The payload's length does not fit the message.
  kOutOfRange = 3,  // A field is outside its range; detail is the field's index, from 0.
  kWrongNonce = 4,  // The request carries another boot's nonce.
  kRequestTooOld = 5,  // A newer request was already run and this one is not among the answers that are kept; it was not run.
  kRequestIdReused = 6,  // Another request with this id was already run; this one was not.
  kBadMagic = 7,  // The guard word is wrong.
  kBusy = 16,  // Not possible while a sequence runs or is paused.
  kFaultLatched = 17,  // A fault is latched; detail is its FaultReason.
  kSlotEmpty = 18,  // The slot holds nothing valid; detail is the slot, or the step that names it.
  kCrcMismatch = 19,  // What was uploaded does not have the given CRC; detail is the CRC of what is there.
  kCurrentBudget = 20,  // The light exceeds the current budget; detail is the sum of its levels.
  kOnTimeLimit = 21,  // A step keeps a light on for longer than an LED may be on; detail is the step.
  kNoTable = 22,  // No step table is committed.
  kTableMismatch = 23,  // The committed table has another hash; detail is its hash.
  kNotRunning = 24,  // No sequence with this run id is under way; detail is the run id under way, or 0.
  kEventGone = 25,  // The event number is not in the queue; detail is the oldest number that is.
  kSettingsWrite = 26,  // The settings could not be stored.
  kNoBootloader = 27,  // This board has no bootloader.
  kLedPeriod = 28,  // An exposure with light is not a whole number of the LED drivers' pulse periods; detail is the step.
  kLedLevelStep = 29,  // This board cannot make a level; detail is the LED.
};

constexpr bool is_valid(ErrorCode value) {
  switch (value) {
    case ErrorCode::kOk:
    case ErrorCode::kUnknownMessage:
    case ErrorCode::kBadLength:
    case ErrorCode::kOutOfRange:
    case ErrorCode::kWrongNonce:
    case ErrorCode::kRequestTooOld:
    case ErrorCode::kRequestIdReused:
    case ErrorCode::kBadMagic:
    case ErrorCode::kBusy:
    case ErrorCode::kFaultLatched:
    case ErrorCode::kSlotEmpty:
    case ErrorCode::kCrcMismatch:
    case ErrorCode::kCurrentBudget:
    case ErrorCode::kOnTimeLimit:
    case ErrorCode::kNoTable:
    case ErrorCode::kTableMismatch:
    case ErrorCode::kNotRunning:
    case ErrorCode::kEventGone:
    case ErrorCode::kSettingsWrite:
    case ErrorCode::kNoBootloader:
    case ErrorCode::kLedPeriod:
    case ErrorCode::kLedLevelStep:
      return true;
  }
  return false;
}

enum class MessageId : std::uint8_t {
  kHelloRequest = 0x01,
  kHelloReply = 0x81,
  kEnterBootloaderRequest = 0x02,
  kEnterBootloaderReply = 0x82,
  kStatusRequest = 0x03,
  kStatusReply = 0x83,
  kLimitsRequest = 0x04,
  kLimitsReply = 0x84,
  kLoadLightRequest = 0x10,
  kLoadLightReply = 0x90,
  kApertureChunkRequest = 0x11,
  kApertureChunkReply = 0x91,
  kCommitApertureRequest = 0x12,
  kCommitApertureReply = 0x92,
  kSelectApertureRequest = 0x13,
  kSelectApertureReply = 0x93,
  kSelectLightRequest = 0x14,
  kSelectLightReply = 0x94,
  kAllOffRequest = 0x15,
  kAllOffReply = 0x95,
  kStepChunkRequest = 0x20,
  kStepChunkReply = 0xA0,
  kCommitStepsRequest = 0x21,
  kCommitStepsReply = 0xA1,
  kStartRequest = 0x22,
  kStartReply = 0xA2,
  kPauseRequest = 0x23,
  kPauseReply = 0xA3,
  kResumeRequest = 0x24,
  kResumeReply = 0xA4,
  kAbortRequest = 0x25,
  kAbortReply = 0xA5,
  kClearFaultRequest = 0x26,
  kClearFaultReply = 0xA6,
  kAcknowledgeEventsRequest = 0x27,
  kAcknowledgeEventsReply = 0xA7,
  kCountersRequest = 0x30,
  kCountersReply = 0xB0,
  kGetSettingsRequest = 0x31,
  kGetSettingsReply = 0xB1,
  kSetSettingsRequest = 0x32,
  kSetSettingsReply = 0xB2,
  kGetLedCorrectionRequest = 0x33,
  kGetLedCorrectionReply = 0xB3,
  kSetLedCorrectionRequest = 0x34,
  kSetLedCorrectionReply = 0xB4,
  kRejected = 0xFE,
  kFailed = 0xFF,
  kBootedEvent = 0x40,
  kExposureEvent = 0x41,
  kSequenceEvent = 0x42,
  kFaultEvent = 0x43,
};

// Whether a request with this error did not reach its handler; with others it failed there.
constexpr bool is_rejection(ErrorCode code) { return static_cast<std::uint8_t>(code) < kFirstFailure; }


// Head of every frame, for both directions. Frozen for ever.
struct Header {
  static constexpr std::size_t kMinSize = 11;
  static constexpr std::size_t kMaxSize = 11;
  std::uint8_t message = 0;  // Message id.
  std::uint32_t request_id = 0;  // Request and reply: the request's id. Event: the event's number.
  std::uint32_t boot_nonce = 0;  // Request: the nonce that HELLO gave (hello, enter_bootloader: any). Reply and event: the device's.
  std::uint16_t length = 0;  // Bytes of payload that follow.
};

// One line of the sequence's table.
struct Step {
  static constexpr std::size_t kMinSize = 12;
  static constexpr std::size_t kMaxSize = 12;
  std::uint8_t aperture = 0;  // Aperture slot; 255 is shut. (0..15 or 255)
  std::uint8_t light = 0;  // Light slot; 255 is off. (0..31 or 255)
  std::uint16_t repeat = 0;  // Exposures of this step. (1..65535)
  std::uint32_t settle_us = 0;  // Wait after aperture and light were set and before the first trigger. [us] (0..60000000)
  std::uint32_t exposure_us = 0;  // Exposure time. [us] (10..60000000)
};

// Who is there. Read-only, valid with any nonce and across any difference of versions. The host takes its next ids from above last_request_id.
struct HelloRequest {
  static constexpr MessageId kId = MessageId::kHelloRequest;
  static constexpr std::size_t kMinSize = 0;
  static constexpr std::size_t kMaxSize = 0;
};

// Answer to hello: what was set or found.
struct HelloReply {
  static constexpr MessageId kId = MessageId::kHelloReply;
  static constexpr std::size_t kMinSize = 108;
  static constexpr std::size_t kMaxSize = 108;
  std::uint16_t protocol_version = 0;  // Version of this protocol.
  std::uint8_t schema_hash[16] = {};  // First 16 bytes of the SHA-256 over everything that is on the wire.
  char firmware_version[16] = {};  // Version of the firmware.
  char git_hash[16] = {};  // Commit that the firmware was built from.
  char board[16] = {};  // Board: teensy31, qemu_m4 or host.
  char serial_number[16] = {};  // Serial number from the settings; empty when none was given.
  std::uint32_t capabilities = 0;  // What this board has.
  ResetCause reset_cause = ResetCause::kUnknown;  // Why it started last.
  std::uint32_t boot_nonce = 0;  // Number that differs from boot to boot; never 0. (1..4294967295)
  std::uint32_t last_request_id = 0;  // Highest request id that was run since the start.
  std::uint8_t aperture_slots = 0;  // Number of aperture slots.
  std::uint8_t light_slots = 0;  // Number of light slots.
  std::uint8_t leds = 0;  // Number of LED lines.
  std::uint16_t steps = 0;  // Number of steps that the table can hold.
  std::uint8_t reserved[8] = {};  // Zero; for what a later version adds.
};

// Light off, then leave for the bootloader after the reply was sent. Valid with any nonce and across any difference of versions, also during a sequence.
struct EnterBootloaderRequest {
  static constexpr MessageId kId = MessageId::kEnterBootloaderRequest;
  static constexpr std::size_t kMinSize = 4;
  static constexpr std::size_t kMaxSize = 4;
  std::uint32_t magic = 0;  // BOOTLOADER_MAGIC; anything else is rejected with BAD_MAGIC.
};

// Answer to enter_bootloader: what was set or found.
struct EnterBootloaderReply {
  static constexpr MessageId kId = MessageId::kEnterBootloaderReply;
  static constexpr std::size_t kMinSize = 2;
  static constexpr std::size_t kMaxSize = 2;
  std::uint16_t delay_ms = 0;  // Time until the device leaves. [ms]
};

// What the device does now.
struct StatusRequest {
  static constexpr MessageId kId = MessageId::kStatusRequest;
  static constexpr std::size_t kMinSize = 0;
  static constexpr std::size_t kMaxSize = 0;
};

// Answer to status: what was set or found.
struct StatusReply {
  static constexpr MessageId kId = MessageId::kStatusReply;
  static constexpr std::size_t kMinSize = 37;
  static constexpr std::size_t kMaxSize = 37;
  SequenceState sequence = SequenceState::kIdle;  // State of the sequencer.
  FaultReason fault = FaultReason::kNone;  // Latched fault, or NONE.
  std::uint8_t aperture = 0;  // Aperture slot that was last sent to the glass; 255 is shut. (0..15 or 255)
  std::uint8_t light = 0;  // Light slot that is on; 255 is off. (0..31 or 255)
  bool camera_ready = false;  // Level of the camera's ready line; true where it is not wired.
  std::uint64_t uptime_us = 0;  // Time since the start. [us]
  std::uint32_t table_hash = 0;  // Hash of the committed table; 0 when there is none.
  std::uint32_t run_id = 0;  // Run id of the sequence under way or last; 0 when there was none.
  std::uint16_t step = 0;  // Step that the sequencer is at.
  std::uint32_t exposures = 0;  // Exposures of this run that ended.
  std::uint32_t oldest_event = 0;  // Number of the oldest event that is not acknowledged; next_event when there is none.
  std::uint32_t next_event = 0;  // Number that the next event will get.
  std::int16_t temperature_centi = 0;  // Temperature of the chip; -32768 where it is not measured. [0.01 degC]
};

// Safety limits of this board. They are compiled in; no request changes them.
struct LimitsRequest {
  static constexpr MessageId kId = MessageId::kLimitsRequest;
  static constexpr std::size_t kMinSize = 0;
  static constexpr std::size_t kMaxSize = 0;
};

// Answer to limits: what was set or found.
struct LimitsReply {
  static constexpr MessageId kId = MessageId::kLimitsReply;
  static constexpr std::size_t kMinSize = 18;
  static constexpr std::size_t kMaxSize = 18;
  std::uint32_t led_on_time_us = 0;  // Longest time that an LED may be on without a break. [us]
  std::uint32_t level_budget = 0;  // Largest sum of the levels of all LEDs.
  std::uint32_t led_period_us = 0;  // Period of the LED drivers' pulses: an exposure with light must be a whole number of them; 0 where currents are constant. [us]
  std::uint16_t led_level_step = 0;  // Levels must be multiples of this; LED_LEVEL_MAX where an LED is on or off. (1..4095)
  std::uint16_t link_timeout_ms = 0;  // Silence after which the light goes off outside a sequence. [ms]
  std::uint16_t reset_ms = 0;  // Time that the device needs from reset until it answers. [ms]
};

// Loads a light slot. The light that is on does not change until it is selected again.
struct LoadLightRequest {
  static constexpr MessageId kId = MessageId::kLoadLightRequest;
  static constexpr std::size_t kMinSize = 2;
  static constexpr std::size_t kMaxSize = 98;
  std::uint8_t slot = 0;  // Slot to load. (0..31)
  std::uint8_t levels_count = 0;  // At most 48.
  std::uint16_t levels[48] = {};  // Level of LED 0, 1, ...; LEDs that are not named are off. (0..4095)
};

// Answer to load_light: what was set or found.
struct LoadLightReply {
  static constexpr MessageId kId = MessageId::kLoadLightReply;
  static constexpr std::size_t kMinSize = 9;
  static constexpr std::size_t kMaxSize = 9;
  std::uint8_t slot = 0;  // Slot that was loaded. (0..31)
  std::uint32_t crc32 = 0;  // CRC-32 over the levels of all LEDS LEDs as u16 little-endian.
  std::uint32_t level_sum = 0;  // Sum of the levels.
};

// Writes a part of an aperture slot. The slot is empty until it is committed.
struct ApertureChunkRequest {
  static constexpr MessageId kId = MessageId::kApertureChunkRequest;
  static constexpr std::size_t kMinSize = 258;
  static constexpr std::size_t kMaxSize = 258;
  std::uint8_t slot = 0;  // Slot to write. (0..15)
  std::uint8_t chunk = 0;  // Which quarter of the bitmap. (0..3)
  std::uint8_t data[256] = {};  // Bytes chunk*256 to chunk*256+255 of the bitmap.
};

// Answer to aperture_chunk: what was set or found.
struct ApertureChunkReply {
  static constexpr MessageId kId = MessageId::kApertureChunkReply;
  static constexpr std::size_t kMinSize = 2;
  static constexpr std::size_t kMaxSize = 2;
  std::uint8_t slot = 0;  // Slot that was written. (0..15)
  std::uint8_t chunk = 0;  // Chunk that was written. (0..3)
};

// Makes an aperture slot valid if all its 1,024 bytes have the given CRC.
struct CommitApertureRequest {
  static constexpr MessageId kId = MessageId::kCommitApertureRequest;
  static constexpr std::size_t kMinSize = 5;
  static constexpr std::size_t kMaxSize = 5;
  std::uint8_t slot = 0;  // Slot to commit. (0..15)
  std::uint32_t crc32 = 0;  // CRC-32 over the bitmap.
};

// Answer to commit_aperture: what was set or found.
struct CommitApertureReply {
  static constexpr MessageId kId = MessageId::kCommitApertureReply;
  static constexpr std::size_t kMinSize = 7;
  static constexpr std::size_t kMaxSize = 7;
  std::uint8_t slot = 0;  // Slot that is valid now. (0..15)
  std::uint32_t crc32 = 0;  // CRC-32 over the bitmap that is in the slot.
  std::uint16_t open_pixels = 0;  // Number of open pixels. (0..8192)
};

// Sends a slot to the glass. The glass takes its time to follow.
struct SelectApertureRequest {
  static constexpr MessageId kId = MessageId::kSelectApertureRequest;
  static constexpr std::size_t kMinSize = 1;
  static constexpr std::size_t kMaxSize = 1;
  std::uint8_t slot = 0;  // Slot; 255 is shut. (0..15 or 255)
};

// Answer to select_aperture: what was set or found.
struct SelectApertureReply {
  static constexpr MessageId kId = MessageId::kSelectApertureReply;
  static constexpr std::size_t kMinSize = 5;
  static constexpr std::size_t kMaxSize = 5;
  std::uint8_t slot = 0;  // Slot that is being sent. (0..15 or 255)
  std::uint32_t crc32 = 0;  // CRC-32 over its bitmap (shut: 1,024 zeros).
};

// Turns a light on, and any other off. The light goes off after the LED's on-time limit or when the link falls silent.
struct SelectLightRequest {
  static constexpr MessageId kId = MessageId::kSelectLightRequest;
  static constexpr std::size_t kMinSize = 1;
  static constexpr std::size_t kMaxSize = 1;
  std::uint8_t slot = 0;  // Slot; 255 is off. (0..31 or 255)
};

// Answer to select_light: what was set or found.
struct SelectLightReply {
  static constexpr MessageId kId = MessageId::kSelectLightReply;
  static constexpr std::size_t kMinSize = 5;
  static constexpr std::size_t kMaxSize = 5;
  std::uint8_t slot = 0;  // Slot that is on. (0..31 or 255)
  std::uint32_t level_sum = 0;  // Sum of the levels that are on.
};

// All LEDs off at once, always. Aborts a sequence; the glass stays as it is.
struct AllOffRequest {
  static constexpr MessageId kId = MessageId::kAllOffRequest;
  static constexpr std::size_t kMinSize = 0;
  static constexpr std::size_t kMaxSize = 0;
};

// Answer to all_off: what was set or found.
struct AllOffReply {
  static constexpr MessageId kId = MessageId::kAllOffReply;
  static constexpr std::size_t kMinSize = 1;
  static constexpr std::size_t kMaxSize = 1;
  SequenceState sequence = SequenceState::kIdle;  // State of the sequencer afterwards.
};

// Writes steps into the table. The table is not usable until it is committed.
struct StepChunkRequest {
  static constexpr MessageId kId = MessageId::kStepChunkRequest;
  static constexpr std::size_t kMinSize = 3;
  static constexpr std::size_t kMaxSize = 195;
  std::uint16_t first = 0;  // Index of the first step written. (0..1023)
  std::uint8_t steps_count = 0;  // At most 16.
  Step steps[16] = {};  // Steps from there on.
};

// Answer to step_chunk: what was set or found.
struct StepChunkReply {
  static constexpr MessageId kId = MessageId::kStepChunkReply;
  static constexpr std::size_t kMinSize = 3;
  static constexpr std::size_t kMaxSize = 3;
  std::uint16_t first = 0;  // Index of the first step written. (0..1023)
  std::uint8_t count = 0;  // Steps written. (0..16)
};

// Makes the first `count` steps the table, if they have the given CRC (over their wire form), every slot they name is loaded, and no limit is exceeded. The CRC is the table's hash.
struct CommitStepsRequest {
  static constexpr MessageId kId = MessageId::kCommitStepsRequest;
  static constexpr std::size_t kMinSize = 6;
  static constexpr std::size_t kMaxSize = 6;
  std::uint16_t count = 0;  // Steps of the table. (1..1024)
  std::uint32_t crc32 = 0;  // CRC-32 over the steps as they are on the wire.
};

// Answer to commit_steps: what was set or found.
struct CommitStepsReply {
  static constexpr MessageId kId = MessageId::kCommitStepsReply;
  static constexpr std::size_t kMinSize = 10;
  static constexpr std::size_t kMaxSize = 10;
  std::uint16_t count = 0;  // Steps of the table. (1..1024)
  std::uint32_t table_hash = 0;  // Hash of the table (its CRC-32).
  std::uint32_t exposures = 0;  // Exposures of the whole table.
};

// Starts the committed table.
struct StartRequest {
  static constexpr MessageId kId = MessageId::kStartRequest;
  static constexpr std::size_t kMinSize = 27;
  static constexpr std::size_t kMaxSize = 27;
  std::uint32_t run_id = 0;  // Number chosen by the host; every event of this sequence carries it. (1..4294967295)
  std::uint32_t table_hash = 0;  // Hash of the table that is to run.
  std::uint32_t deadline_ms = 0;  // Longest time from here to the end, pauses not counted; then SEQUENCE_DEADLINE. [ms] (1..4294967295)
  std::uint32_t light_lead_us = 0;  // Time that the light is on before each trigger. [us] (0..1000000)
  std::uint32_t trigger_us = 0;  // Length of the trigger pulse. [us] (1..100000)
  std::uint32_t gap_us = 0;  // Wait from the end of an exposure to what comes next. [us] (0..10000000)
  std::uint16_t ready_timeout_ms = 0;  // Longest wait for the camera's ready line (where wired); 0 ignores the line. [ms]
  bool require_strobe = false;  // A trigger without a strobe is a fault (where wired).
};

// Answer to start: what was set or found.
struct StartReply {
  static constexpr MessageId kId = MessageId::kStartReply;
  static constexpr std::size_t kMinSize = 12;
  static constexpr std::size_t kMaxSize = 12;
  std::uint32_t run_id = 0;  // Run that was started. (1..4294967295)
  std::uint32_t table_hash = 0;  // Hash of the table that runs.
  std::uint32_t exposures = 0;  // Exposures that will follow.
};

// No trigger after at most 1 ms; the exposure under way ends as planned. A sequence event tells when it stands.
struct PauseRequest {
  static constexpr MessageId kId = MessageId::kPauseRequest;
  static constexpr std::size_t kMinSize = 4;
  static constexpr std::size_t kMaxSize = 4;
  std::uint32_t run_id = 0;  // Run to pause. (1..4294967295)
};

// Answer to pause: what was set or found.
struct PauseReply {
  static constexpr MessageId kId = MessageId::kPauseReply;
  static constexpr std::size_t kMinSize = 5;
  static constexpr std::size_t kMaxSize = 5;
  SequenceState sequence = SequenceState::kIdle;  // State of the sequencer.
  std::uint32_t exposures = 0;  // Exposures that ended.
};

// Goes on after a pause, with the settle time of the step waited again.
struct ResumeRequest {
  static constexpr MessageId kId = MessageId::kResumeRequest;
  static constexpr std::size_t kMinSize = 4;
  static constexpr std::size_t kMaxSize = 4;
  std::uint32_t run_id = 0;  // Run to resume. (1..4294967295)
};

// Answer to resume: what was set or found.
struct ResumeReply {
  static constexpr MessageId kId = MessageId::kResumeReply;
  static constexpr std::size_t kMinSize = 5;
  static constexpr std::size_t kMaxSize = 5;
  SequenceState sequence = SequenceState::kIdle;  // State of the sequencer.
  std::uint32_t exposures = 0;  // Exposures that ended.
};

// Light off within 1 ms, glass shut, sequence ended. With no sequence under way nothing happens and that is no error.
struct AbortRequest {
  static constexpr MessageId kId = MessageId::kAbortRequest;
  static constexpr std::size_t kMinSize = 4;
  static constexpr std::size_t kMaxSize = 4;
  std::uint32_t run_id = 0;  // Run to abort; 0 is any.
};

// Answer to abort: what was set or found.
struct AbortReply {
  static constexpr MessageId kId = MessageId::kAbortReply;
  static constexpr std::size_t kMinSize = 5;
  static constexpr std::size_t kMaxSize = 5;
  SequenceState sequence = SequenceState::kIdle;  // State of the sequencer.
  std::uint32_t exposures = 0;  // Exposures that ended.
};

// Clears the latched fault if it is the one named. With none latched nothing happens and that is no error.
struct ClearFaultRequest {
  static constexpr MessageId kId = MessageId::kClearFaultRequest;
  static constexpr std::size_t kMinSize = 1;
  static constexpr std::size_t kMaxSize = 1;
  FaultReason reason = FaultReason::kNone;  // Fault that the host has seen.
};

// Answer to clear_fault: what was set or found.
struct ClearFaultReply {
  static constexpr MessageId kId = MessageId::kClearFaultReply;
  static constexpr std::size_t kMinSize = 1;
  static constexpr std::size_t kMaxSize = 1;
  FaultReason fault = FaultReason::kNone;  // Fault that is latched now.
};

// The host has every event below next_event: the device forgets them. With resend it also sends again what it still holds from there on.
struct AcknowledgeEventsRequest {
  static constexpr MessageId kId = MessageId::kAcknowledgeEventsRequest;
  static constexpr std::size_t kMinSize = 5;
  static constexpr std::size_t kMaxSize = 5;
  std::uint32_t next_event = 0;  // Number of the first event that the host does not have.
  bool resend = false;  // Send the events from there on again.
};

// Answer to acknowledge_events: what was set or found.
struct AcknowledgeEventsReply {
  static constexpr MessageId kId = MessageId::kAcknowledgeEventsReply;
  static constexpr std::size_t kMinSize = 8;
  static constexpr std::size_t kMaxSize = 8;
  std::uint32_t oldest_event = 0;  // Oldest event that is kept.
  std::uint32_t next_event = 0;  // Number that the next event will get.
};

// What the device counted since its start.
struct CountersRequest {
  static constexpr MessageId kId = MessageId::kCountersRequest;
  static constexpr std::size_t kMinSize = 0;
  static constexpr std::size_t kMaxSize = 0;
};

// Answer to counters: what was set or found.
struct CountersReply {
  static constexpr MessageId kId = MessageId::kCountersReply;
  static constexpr std::size_t kMinSize = 56;
  static constexpr std::size_t kMaxSize = 56;
  std::uint32_t frames_received = 0;  // Frames whose CRC was right.
  std::uint32_t frames_sent = 0;  // Frames sent.
  std::uint32_t crc_errors = 0;  // Frames dropped for their CRC.
  std::uint32_t framing_errors = 0;  // Frames dropped for their form: COBS, too short, length field.
  std::uint32_t overruns = 0;  // Frames dropped because they were too long.
  std::uint32_t rejected = 0;  // Requests rejected.
  std::uint32_t failed = 0;  // Requests failed.
  std::uint32_t retries_answered = 0;  // Retries answered from the ring.
  std::uint32_t wrong_nonce = 0;  // Requests with another boot's nonce.
  std::uint32_t events_sent = 0;  // Events sent for the first time.
  std::uint32_t events_resent = 0;  // Events sent again.
  std::uint32_t exposures = 0;  // Exposures made.
  std::uint32_t link_timeouts = 0;  // Times that the light was turned off because the link was silent.
  std::uint32_t faults = 0;  // Faults latched.
};

// Settings in the non-volatile memory; they survive flashing.
struct GetSettingsRequest {
  static constexpr MessageId kId = MessageId::kGetSettingsRequest;
  static constexpr std::size_t kMinSize = 0;
  static constexpr std::size_t kMaxSize = 0;
};

// Answer to get_settings: what was set or found.
struct GetSettingsReply {
  static constexpr MessageId kId = MessageId::kGetSettingsReply;
  static constexpr std::size_t kMinSize = 20;
  static constexpr std::size_t kMaxSize = 20;
  char serial_number[16] = {};  // Serial number of the instrument.
  GlassVariant glass_variant = GlassVariant::kEStnPositive;  // Glass that is fitted.
  Mounting mounting = Mounting::kBottomView;  // How the glass sits.
  std::uint8_t contrast = 0;  // Fine contrast of the driver chip (electronic volume). (0..63)
  std::uint8_t resistor_ratio = 0;  // Coarse contrast of the driver chip (resistor ratio). (0..7)
};

// Replaces all settings, stores them and sets the glass up again. Not during a sequence.
struct SetSettingsRequest {
  static constexpr MessageId kId = MessageId::kSetSettingsRequest;
  static constexpr std::size_t kMinSize = 20;
  static constexpr std::size_t kMaxSize = 20;
  char serial_number[16] = {};  // Serial number of the instrument.
  GlassVariant glass_variant = GlassVariant::kEStnPositive;  // Glass that is fitted.
  Mounting mounting = Mounting::kBottomView;  // How the glass sits.
  std::uint8_t contrast = 0;  // Fine contrast of the driver chip (electronic volume). (0..63)
  std::uint8_t resistor_ratio = 0;  // Coarse contrast of the driver chip (resistor ratio). (0..7)
};

// Answer to set_settings: what was set or found.
struct SetSettingsReply {
  static constexpr MessageId kId = MessageId::kSetSettingsReply;
  static constexpr std::size_t kMinSize = 20;
  static constexpr std::size_t kMaxSize = 20;
  char serial_number[16] = {};  // Serial number of the instrument.
  GlassVariant glass_variant = GlassVariant::kEStnPositive;  // Glass that is fitted.
  Mounting mounting = Mounting::kBottomView;  // How the glass sits.
  std::uint8_t contrast = 0;  // Fine contrast of the driver chip (electronic volume). (0..63)
  std::uint8_t resistor_ratio = 0;  // Coarse contrast of the driver chip (resistor ratio). (0..7)
};

// Correction of each LED in the non-volatile memory; it survives flashing.
struct GetLedCorrectionRequest {
  static constexpr MessageId kId = MessageId::kGetLedCorrectionRequest;
  static constexpr std::size_t kMinSize = 0;
  static constexpr std::size_t kMaxSize = 0;
};

// Answer to get_led_correction: what was set or found.
struct GetLedCorrectionReply {
  static constexpr MessageId kId = MessageId::kGetLedCorrectionReply;
  static constexpr std::size_t kMinSize = 48;
  static constexpr std::size_t kMaxSize = 48;
  std::uint8_t factors[48] = {};  // Factor of each LED: its current is level * (factor + 1) / 256, rounded down. 255: none.
};

// Replaces the correction of all LEDs and stores it. It acts when a light is next selected. Not during a sequence.
struct SetLedCorrectionRequest {
  static constexpr MessageId kId = MessageId::kSetLedCorrectionRequest;
  static constexpr std::size_t kMinSize = 48;
  static constexpr std::size_t kMaxSize = 48;
  std::uint8_t factors[48] = {};  // Factor of each LED: its current is level * (factor + 1) / 256, rounded down. 255: none.
};

// Answer to set_led_correction: what was set or found.
struct SetLedCorrectionReply {
  static constexpr MessageId kId = MessageId::kSetLedCorrectionReply;
  static constexpr std::size_t kMinSize = 48;
  static constexpr std::size_t kMaxSize = 48;
  std::uint8_t factors[48] = {};  // Factor of each LED: its current is level * (factor + 1) / 256, rounded down. 255: none.
};

// The request did not reach its handler. Nothing happened. Not kept in the ring.
struct Rejected {
  static constexpr MessageId kId = MessageId::kRejected;
  static constexpr std::size_t kMinSize = 6;
  static constexpr std::size_t kMaxSize = 6;
  ErrorCode code = ErrorCode::kOk;  // Why.
  std::uint8_t message = 0;  // Message id of the request.
  std::uint32_t detail = 0;  // Number whose meaning the error code tells.
};

// The request was understood but could not be done. Nothing happened. Kept in the ring.
struct Failed {
  static constexpr MessageId kId = MessageId::kFailed;
  static constexpr std::size_t kMinSize = 6;
  static constexpr std::size_t kMaxSize = 6;
  ErrorCode code = ErrorCode::kOk;  // Why.
  std::uint8_t message = 0;  // Message id of the request.
  std::uint32_t detail = 0;  // Number whose meaning the error code tells.
};

// First event after a start (number 0).
struct BootedEvent {
  static constexpr MessageId kId = MessageId::kBootedEvent;
  static constexpr std::size_t kMinSize = 1;
  static constexpr std::size_t kMaxSize = 1;
  ResetCause reset_cause = ResetCause::kUnknown;  // Why the device started.
};

// One exposure ended.
struct ExposureEvent {
  static constexpr MessageId kId = MessageId::kExposureEvent;
  static constexpr std::size_t kMinSize = 35;
  static constexpr std::size_t kMaxSize = 35;
  std::uint32_t table_hash = 0;  // Hash of the table.
  std::uint32_t run_id = 0;  // Run.
  std::uint32_t index = 0;  // Exposure within the run, from 0.
  std::uint16_t step = 0;  // Step of the table. (0..1023)
  std::uint16_t repeat = 0;  // Exposure within the step, from 0.
  std::uint8_t aperture = 0;  // Aperture slot that was on the glass. (0..15 or 255)
  std::uint8_t light = 0;  // Light slot that was on. (0..31 or 255)
  std::uint64_t start_us = 0;  // Device time of the trigger's edge. [us]
  std::uint32_t settle_waited_us = 0;  // Time from the last byte to the glass to the trigger. [us]
  std::uint32_t exposure_us = 0;  // Exposure that was made. [us]
  std::uint8_t flags = 0;  // What was seen of the camera.
};

// A sequence started, paused, went on or ended.
struct SequenceEvent {
  static constexpr MessageId kId = MessageId::kSequenceEvent;
  static constexpr std::size_t kMinSize = 21;
  static constexpr std::size_t kMaxSize = 21;
  SequenceNews news = SequenceNews::kStarted;  // What happened.
  std::uint32_t run_id = 0;  // Run.
  std::uint32_t table_hash = 0;  // Hash of the table.
  std::uint32_t exposures = 0;  // Exposures that ended.
  std::uint64_t at_us = 0;  // Device time. [us]
};

// A fault was latched. Light off, glass shut; a sequence under way ends with ABORTED.
struct FaultEvent {
  static constexpr MessageId kId = MessageId::kFaultEvent;
  static constexpr std::size_t kMinSize = 19;
  static constexpr std::size_t kMaxSize = 19;
  FaultReason reason = FaultReason::kNone;  // Why.
  std::uint32_t run_id = 0;  // Run under way; 0 when there was none.
  std::uint16_t step = 0;  // Step that the sequencer was at.
  std::uint64_t at_us = 0;  // Device time. [us]
  std::uint32_t detail = 0;  // Number that tells more to who maintains the firmware.
};

namespace detail {

// Writes little-endian; the caller provides room.
struct Writer {
  std::uint8_t* at;
  void put(std::uint64_t value, unsigned size) {
    for (unsigned i = 0; i < size; ++i) {
      *at++ = static_cast<std::uint8_t>(value >> (8U * i));
    }
  }
};

// Reads little-endian; past the end it yields zeros and remembers that bytes were missing.
struct Reader {
  const std::uint8_t* at;
  std::size_t left;
  bool complete = true;
  std::uint64_t get(unsigned size) {
    if (left < size) {
      complete = false;
      left = 0;
      return 0;
    }
    std::uint64_t value = 0;
    for (unsigned i = 0; i < size; ++i) {
      value |= static_cast<std::uint64_t>(at[i]) << (8U * i);
    }
    at += size;
    left -= size;
    return value;
  }
};

// Printable ASCII, then only zeros.
inline bool is_text(const char* text, std::size_t size) {
  bool ended = false;
  for (std::size_t i = 0; i < size; ++i) {
    const unsigned char c = static_cast<unsigned char>(text[i]);
    if (c == 0) {
      ended = true;
    } else if (ended || c < 0x20 || c > 0x7E) {
      return false;
    }
  }
  return true;
}

}  // namespace detail

// Result of decoding a payload: OK, BAD_LENGTH, or OUT_OF_RANGE with the index of the first bad field.
struct Check {
  ErrorCode code = ErrorCode::kOk;
  std::uint8_t field = 0;
};




// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const Header& m) {
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const Header& m) {
  out.put(static_cast<std::uint64_t>(m.message), 1);
  out.put(static_cast<std::uint64_t>(m.request_id), 4);
  out.put(static_cast<std::uint64_t>(m.boot_nonce), 4);
  out.put(static_cast<std::uint64_t>(m.length), 2);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] Header& m) {
  m.message = static_cast<std::uint8_t>(in.get(1));
  m.request_id = static_cast<std::uint32_t>(in.get(4));
  m.boot_nonce = static_cast<std::uint32_t>(in.get(4));
  m.length = static_cast<std::uint16_t>(in.get(2));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const Step& m) {
  if (m.aperture > 15U && m.aperture != 255U) {
    return 0;
  }
  if (m.light > 31U && m.light != 255U) {
    return 1;
  }
  if (m.repeat < 1U) {
    return 2;
  }
  if (m.settle_us > 60000000U) {
    return 3;
  }
  if (m.exposure_us < 10U || m.exposure_us > 60000000U) {
    return 4;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const Step& m) {
  out.put(static_cast<std::uint64_t>(m.aperture), 1);
  out.put(static_cast<std::uint64_t>(m.light), 1);
  out.put(static_cast<std::uint64_t>(m.repeat), 2);
  out.put(static_cast<std::uint64_t>(m.settle_us), 4);
  out.put(static_cast<std::uint64_t>(m.exposure_us), 4);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] Step& m) {
  m.aperture = static_cast<std::uint8_t>(in.get(1));
  m.light = static_cast<std::uint8_t>(in.get(1));
  m.repeat = static_cast<std::uint16_t>(in.get(2));
  m.settle_us = static_cast<std::uint32_t>(in.get(4));
  m.exposure_us = static_cast<std::uint32_t>(in.get(4));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const HelloRequest& m) {
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const HelloRequest& m) {
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] HelloRequest& m) {
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const HelloReply& m) {
  if (!detail::is_text(m.firmware_version, 16)) {
    return 2;
  }
  if (!detail::is_text(m.git_hash, 16)) {
    return 3;
  }
  if (!detail::is_text(m.board, 16)) {
    return 4;
  }
  if (!detail::is_text(m.serial_number, 16)) {
    return 5;
  }
  if (!is_valid(m.reset_cause)) {
    return 7;
  }
  if (m.boot_nonce < 1U) {
    return 8;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const HelloReply& m) {
  out.put(static_cast<std::uint64_t>(m.protocol_version), 2);
  for (std::size_t i = 0; i < 16; ++i) {
    out.put(static_cast<std::uint64_t>(m.schema_hash[i]), 1);
  }
  for (std::size_t i = 0; i < 16; ++i) {
    out.put(static_cast<unsigned char>(m.firmware_version[i]), 1);
  }
  for (std::size_t i = 0; i < 16; ++i) {
    out.put(static_cast<unsigned char>(m.git_hash[i]), 1);
  }
  for (std::size_t i = 0; i < 16; ++i) {
    out.put(static_cast<unsigned char>(m.board[i]), 1);
  }
  for (std::size_t i = 0; i < 16; ++i) {
    out.put(static_cast<unsigned char>(m.serial_number[i]), 1);
  }
  out.put(static_cast<std::uint64_t>(m.capabilities), 4);
  out.put(static_cast<std::uint64_t>(m.reset_cause), 1);
  out.put(static_cast<std::uint64_t>(m.boot_nonce), 4);
  out.put(static_cast<std::uint64_t>(m.last_request_id), 4);
  out.put(static_cast<std::uint64_t>(m.aperture_slots), 1);
  out.put(static_cast<std::uint64_t>(m.light_slots), 1);
  out.put(static_cast<std::uint64_t>(m.leds), 1);
  out.put(static_cast<std::uint64_t>(m.steps), 2);
  for (std::size_t i = 0; i < 8; ++i) {
    out.put(static_cast<std::uint64_t>(m.reserved[i]), 1);
  }
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] HelloReply& m) {
  m.protocol_version = static_cast<std::uint16_t>(in.get(2));
  for (std::size_t i = 0; i < 16; ++i) {
    m.schema_hash[i] = static_cast<std::uint8_t>(in.get(1));
  }
  for (std::size_t i = 0; i < 16; ++i) {
    m.firmware_version[i] = static_cast<char>(in.get(1));
  }
  for (std::size_t i = 0; i < 16; ++i) {
    m.git_hash[i] = static_cast<char>(in.get(1));
  }
  for (std::size_t i = 0; i < 16; ++i) {
    m.board[i] = static_cast<char>(in.get(1));
  }
  for (std::size_t i = 0; i < 16; ++i) {
    m.serial_number[i] = static_cast<char>(in.get(1));
  }
  m.capabilities = static_cast<std::uint32_t>(in.get(4));
  m.reset_cause = static_cast<ResetCause>(in.get(1));
  m.boot_nonce = static_cast<std::uint32_t>(in.get(4));
  m.last_request_id = static_cast<std::uint32_t>(in.get(4));
  m.aperture_slots = static_cast<std::uint8_t>(in.get(1));
  m.light_slots = static_cast<std::uint8_t>(in.get(1));
  m.leds = static_cast<std::uint8_t>(in.get(1));
  m.steps = static_cast<std::uint16_t>(in.get(2));
  for (std::size_t i = 0; i < 8; ++i) {
    m.reserved[i] = static_cast<std::uint8_t>(in.get(1));
  }
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const EnterBootloaderRequest& m) {
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const EnterBootloaderRequest& m) {
  out.put(static_cast<std::uint64_t>(m.magic), 4);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] EnterBootloaderRequest& m) {
  m.magic = static_cast<std::uint32_t>(in.get(4));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const EnterBootloaderReply& m) {
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const EnterBootloaderReply& m) {
  out.put(static_cast<std::uint64_t>(m.delay_ms), 2);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] EnterBootloaderReply& m) {
  m.delay_ms = static_cast<std::uint16_t>(in.get(2));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const StatusRequest& m) {
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const StatusRequest& m) {
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] StatusRequest& m) {
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const StatusReply& m) {
  if (!is_valid(m.sequence)) {
    return 0;
  }
  if (!is_valid(m.fault)) {
    return 1;
  }
  if (m.aperture > 15U && m.aperture != 255U) {
    return 2;
  }
  if (m.light > 31U && m.light != 255U) {
    return 3;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const StatusReply& m) {
  out.put(static_cast<std::uint64_t>(m.sequence), 1);
  out.put(static_cast<std::uint64_t>(m.fault), 1);
  out.put(static_cast<std::uint64_t>(m.aperture), 1);
  out.put(static_cast<std::uint64_t>(m.light), 1);
  out.put(m.camera_ready ? 1 : 0, 1);
  out.put(static_cast<std::uint64_t>(m.uptime_us), 8);
  out.put(static_cast<std::uint64_t>(m.table_hash), 4);
  out.put(static_cast<std::uint64_t>(m.run_id), 4);
  out.put(static_cast<std::uint64_t>(m.step), 2);
  out.put(static_cast<std::uint64_t>(m.exposures), 4);
  out.put(static_cast<std::uint64_t>(m.oldest_event), 4);
  out.put(static_cast<std::uint64_t>(m.next_event), 4);
  out.put(static_cast<std::uint64_t>(m.temperature_centi), 2);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] StatusReply& m) {
  int bad = -1;
  m.sequence = static_cast<SequenceState>(in.get(1));
  m.fault = static_cast<FaultReason>(in.get(1));
  m.aperture = static_cast<std::uint8_t>(in.get(1));
  m.light = static_cast<std::uint8_t>(in.get(1));
  {
    const std::uint64_t value = in.get(1);
    m.camera_ready = value == 1;
    if (value > 1 && bad < 0) {
      bad = 4;
    }
  }
  m.uptime_us = static_cast<std::uint64_t>(in.get(8));
  m.table_hash = static_cast<std::uint32_t>(in.get(4));
  m.run_id = static_cast<std::uint32_t>(in.get(4));
  m.step = static_cast<std::uint16_t>(in.get(2));
  m.exposures = static_cast<std::uint32_t>(in.get(4));
  m.oldest_event = static_cast<std::uint32_t>(in.get(4));
  m.next_event = static_cast<std::uint32_t>(in.get(4));
  m.temperature_centi = static_cast<std::int16_t>(in.get(2));
  return bad;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const LimitsRequest& m) {
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const LimitsRequest& m) {
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] LimitsRequest& m) {
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const LimitsReply& m) {
  if (m.led_level_step < 1U || m.led_level_step > 4095U) {
    return 3;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const LimitsReply& m) {
  out.put(static_cast<std::uint64_t>(m.led_on_time_us), 4);
  out.put(static_cast<std::uint64_t>(m.level_budget), 4);
  out.put(static_cast<std::uint64_t>(m.led_period_us), 4);
  out.put(static_cast<std::uint64_t>(m.led_level_step), 2);
  out.put(static_cast<std::uint64_t>(m.link_timeout_ms), 2);
  out.put(static_cast<std::uint64_t>(m.reset_ms), 2);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] LimitsReply& m) {
  m.led_on_time_us = static_cast<std::uint32_t>(in.get(4));
  m.level_budget = static_cast<std::uint32_t>(in.get(4));
  m.led_period_us = static_cast<std::uint32_t>(in.get(4));
  m.led_level_step = static_cast<std::uint16_t>(in.get(2));
  m.link_timeout_ms = static_cast<std::uint16_t>(in.get(2));
  m.reset_ms = static_cast<std::uint16_t>(in.get(2));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const LoadLightRequest& m) {
  if (m.slot > 31U) {
    return 0;
  }
  if (m.levels_count > 48) {
    return 1;
  }
  for (std::size_t i = 0; i < m.levels_count; ++i) {
    if (m.levels[i] > 4095U) {
      return 1;
    }
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const LoadLightRequest& m) {
  out.put(static_cast<std::uint64_t>(m.slot), 1);
  const std::uint8_t levels_count = m.levels_count < 48 ? m.levels_count : 48;
  out.put(levels_count, 1);
  for (std::size_t i = 0; i < levels_count; ++i) {
    out.put(static_cast<std::uint64_t>(m.levels[i]), 2);
  }
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] LoadLightRequest& m) {
  m.slot = static_cast<std::uint8_t>(in.get(1));
  m.levels_count = static_cast<std::uint8_t>(in.get(1));
  if (m.levels_count > 48) {
    m.levels_count = 0;
    in.complete = false;
  }
  for (std::size_t i = 0; i < m.levels_count; ++i) {
    m.levels[i] = static_cast<std::uint16_t>(in.get(2));
  }
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const LoadLightReply& m) {
  if (m.slot > 31U) {
    return 0;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const LoadLightReply& m) {
  out.put(static_cast<std::uint64_t>(m.slot), 1);
  out.put(static_cast<std::uint64_t>(m.crc32), 4);
  out.put(static_cast<std::uint64_t>(m.level_sum), 4);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] LoadLightReply& m) {
  m.slot = static_cast<std::uint8_t>(in.get(1));
  m.crc32 = static_cast<std::uint32_t>(in.get(4));
  m.level_sum = static_cast<std::uint32_t>(in.get(4));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const ApertureChunkRequest& m) {
  if (m.slot > 15U) {
    return 0;
  }
  if (m.chunk > 3U) {
    return 1;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const ApertureChunkRequest& m) {
  out.put(static_cast<std::uint64_t>(m.slot), 1);
  out.put(static_cast<std::uint64_t>(m.chunk), 1);
  for (std::size_t i = 0; i < 256; ++i) {
    out.put(static_cast<std::uint64_t>(m.data[i]), 1);
  }
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] ApertureChunkRequest& m) {
  m.slot = static_cast<std::uint8_t>(in.get(1));
  m.chunk = static_cast<std::uint8_t>(in.get(1));
  for (std::size_t i = 0; i < 256; ++i) {
    m.data[i] = static_cast<std::uint8_t>(in.get(1));
  }
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const ApertureChunkReply& m) {
  if (m.slot > 15U) {
    return 0;
  }
  if (m.chunk > 3U) {
    return 1;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const ApertureChunkReply& m) {
  out.put(static_cast<std::uint64_t>(m.slot), 1);
  out.put(static_cast<std::uint64_t>(m.chunk), 1);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] ApertureChunkReply& m) {
  m.slot = static_cast<std::uint8_t>(in.get(1));
  m.chunk = static_cast<std::uint8_t>(in.get(1));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const CommitApertureRequest& m) {
  if (m.slot > 15U) {
    return 0;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const CommitApertureRequest& m) {
  out.put(static_cast<std::uint64_t>(m.slot), 1);
  out.put(static_cast<std::uint64_t>(m.crc32), 4);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] CommitApertureRequest& m) {
  m.slot = static_cast<std::uint8_t>(in.get(1));
  m.crc32 = static_cast<std::uint32_t>(in.get(4));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const CommitApertureReply& m) {
  if (m.slot > 15U) {
    return 0;
  }
  if (m.open_pixels > 8192U) {
    return 2;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const CommitApertureReply& m) {
  out.put(static_cast<std::uint64_t>(m.slot), 1);
  out.put(static_cast<std::uint64_t>(m.crc32), 4);
  out.put(static_cast<std::uint64_t>(m.open_pixels), 2);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] CommitApertureReply& m) {
  m.slot = static_cast<std::uint8_t>(in.get(1));
  m.crc32 = static_cast<std::uint32_t>(in.get(4));
  m.open_pixels = static_cast<std::uint16_t>(in.get(2));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const SelectApertureRequest& m) {
  if (m.slot > 15U && m.slot != 255U) {
    return 0;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const SelectApertureRequest& m) {
  out.put(static_cast<std::uint64_t>(m.slot), 1);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] SelectApertureRequest& m) {
  m.slot = static_cast<std::uint8_t>(in.get(1));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const SelectApertureReply& m) {
  if (m.slot > 15U && m.slot != 255U) {
    return 0;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const SelectApertureReply& m) {
  out.put(static_cast<std::uint64_t>(m.slot), 1);
  out.put(static_cast<std::uint64_t>(m.crc32), 4);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] SelectApertureReply& m) {
  m.slot = static_cast<std::uint8_t>(in.get(1));
  m.crc32 = static_cast<std::uint32_t>(in.get(4));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const SelectLightRequest& m) {
  if (m.slot > 31U && m.slot != 255U) {
    return 0;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const SelectLightRequest& m) {
  out.put(static_cast<std::uint64_t>(m.slot), 1);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] SelectLightRequest& m) {
  m.slot = static_cast<std::uint8_t>(in.get(1));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const SelectLightReply& m) {
  if (m.slot > 31U && m.slot != 255U) {
    return 0;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const SelectLightReply& m) {
  out.put(static_cast<std::uint64_t>(m.slot), 1);
  out.put(static_cast<std::uint64_t>(m.level_sum), 4);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] SelectLightReply& m) {
  m.slot = static_cast<std::uint8_t>(in.get(1));
  m.level_sum = static_cast<std::uint32_t>(in.get(4));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const AllOffRequest& m) {
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const AllOffRequest& m) {
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] AllOffRequest& m) {
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const AllOffReply& m) {
  if (!is_valid(m.sequence)) {
    return 0;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const AllOffReply& m) {
  out.put(static_cast<std::uint64_t>(m.sequence), 1);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] AllOffReply& m) {
  m.sequence = static_cast<SequenceState>(in.get(1));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const StepChunkRequest& m) {
  if (m.first > 1023U) {
    return 0;
  }
  if (m.steps_count > 16) {
    return 1;
  }
  for (std::size_t i = 0; i < m.steps_count; ++i) {
    if (first_bad_field(m.steps[i]) >= 0) {
      return 1;
    }
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const StepChunkRequest& m) {
  out.put(static_cast<std::uint64_t>(m.first), 2);
  const std::uint8_t steps_count = m.steps_count < 16 ? m.steps_count : 16;
  out.put(steps_count, 1);
  for (std::size_t i = 0; i < steps_count; ++i) {
    write(out, m.steps[i]);
  }
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] StepChunkRequest& m) {
  m.first = static_cast<std::uint16_t>(in.get(2));
  m.steps_count = static_cast<std::uint8_t>(in.get(1));
  if (m.steps_count > 16) {
    m.steps_count = 0;
    in.complete = false;
  }
  for (std::size_t i = 0; i < m.steps_count; ++i) {
    read(in, m.steps[i]);
  }
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const StepChunkReply& m) {
  if (m.first > 1023U) {
    return 0;
  }
  if (m.count > 16U) {
    return 1;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const StepChunkReply& m) {
  out.put(static_cast<std::uint64_t>(m.first), 2);
  out.put(static_cast<std::uint64_t>(m.count), 1);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] StepChunkReply& m) {
  m.first = static_cast<std::uint16_t>(in.get(2));
  m.count = static_cast<std::uint8_t>(in.get(1));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const CommitStepsRequest& m) {
  if (m.count < 1U || m.count > 1024U) {
    return 0;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const CommitStepsRequest& m) {
  out.put(static_cast<std::uint64_t>(m.count), 2);
  out.put(static_cast<std::uint64_t>(m.crc32), 4);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] CommitStepsRequest& m) {
  m.count = static_cast<std::uint16_t>(in.get(2));
  m.crc32 = static_cast<std::uint32_t>(in.get(4));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const CommitStepsReply& m) {
  if (m.count < 1U || m.count > 1024U) {
    return 0;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const CommitStepsReply& m) {
  out.put(static_cast<std::uint64_t>(m.count), 2);
  out.put(static_cast<std::uint64_t>(m.table_hash), 4);
  out.put(static_cast<std::uint64_t>(m.exposures), 4);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] CommitStepsReply& m) {
  m.count = static_cast<std::uint16_t>(in.get(2));
  m.table_hash = static_cast<std::uint32_t>(in.get(4));
  m.exposures = static_cast<std::uint32_t>(in.get(4));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const StartRequest& m) {
  if (m.run_id < 1U) {
    return 0;
  }
  if (m.deadline_ms < 1U) {
    return 2;
  }
  if (m.light_lead_us > 1000000U) {
    return 3;
  }
  if (m.trigger_us < 1U || m.trigger_us > 100000U) {
    return 4;
  }
  if (m.gap_us > 10000000U) {
    return 5;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const StartRequest& m) {
  out.put(static_cast<std::uint64_t>(m.run_id), 4);
  out.put(static_cast<std::uint64_t>(m.table_hash), 4);
  out.put(static_cast<std::uint64_t>(m.deadline_ms), 4);
  out.put(static_cast<std::uint64_t>(m.light_lead_us), 4);
  out.put(static_cast<std::uint64_t>(m.trigger_us), 4);
  out.put(static_cast<std::uint64_t>(m.gap_us), 4);
  out.put(static_cast<std::uint64_t>(m.ready_timeout_ms), 2);
  out.put(m.require_strobe ? 1 : 0, 1);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] StartRequest& m) {
  int bad = -1;
  m.run_id = static_cast<std::uint32_t>(in.get(4));
  m.table_hash = static_cast<std::uint32_t>(in.get(4));
  m.deadline_ms = static_cast<std::uint32_t>(in.get(4));
  m.light_lead_us = static_cast<std::uint32_t>(in.get(4));
  m.trigger_us = static_cast<std::uint32_t>(in.get(4));
  m.gap_us = static_cast<std::uint32_t>(in.get(4));
  m.ready_timeout_ms = static_cast<std::uint16_t>(in.get(2));
  {
    const std::uint64_t value = in.get(1);
    m.require_strobe = value == 1;
    if (value > 1 && bad < 0) {
      bad = 7;
    }
  }
  return bad;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const StartReply& m) {
  if (m.run_id < 1U) {
    return 0;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const StartReply& m) {
  out.put(static_cast<std::uint64_t>(m.run_id), 4);
  out.put(static_cast<std::uint64_t>(m.table_hash), 4);
  out.put(static_cast<std::uint64_t>(m.exposures), 4);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] StartReply& m) {
  m.run_id = static_cast<std::uint32_t>(in.get(4));
  m.table_hash = static_cast<std::uint32_t>(in.get(4));
  m.exposures = static_cast<std::uint32_t>(in.get(4));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const PauseRequest& m) {
  if (m.run_id < 1U) {
    return 0;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const PauseRequest& m) {
  out.put(static_cast<std::uint64_t>(m.run_id), 4);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] PauseRequest& m) {
  m.run_id = static_cast<std::uint32_t>(in.get(4));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const PauseReply& m) {
  if (!is_valid(m.sequence)) {
    return 0;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const PauseReply& m) {
  out.put(static_cast<std::uint64_t>(m.sequence), 1);
  out.put(static_cast<std::uint64_t>(m.exposures), 4);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] PauseReply& m) {
  m.sequence = static_cast<SequenceState>(in.get(1));
  m.exposures = static_cast<std::uint32_t>(in.get(4));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const ResumeRequest& m) {
  if (m.run_id < 1U) {
    return 0;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const ResumeRequest& m) {
  out.put(static_cast<std::uint64_t>(m.run_id), 4);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] ResumeRequest& m) {
  m.run_id = static_cast<std::uint32_t>(in.get(4));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const ResumeReply& m) {
  if (!is_valid(m.sequence)) {
    return 0;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const ResumeReply& m) {
  out.put(static_cast<std::uint64_t>(m.sequence), 1);
  out.put(static_cast<std::uint64_t>(m.exposures), 4);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] ResumeReply& m) {
  m.sequence = static_cast<SequenceState>(in.get(1));
  m.exposures = static_cast<std::uint32_t>(in.get(4));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const AbortRequest& m) {
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const AbortRequest& m) {
  out.put(static_cast<std::uint64_t>(m.run_id), 4);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] AbortRequest& m) {
  m.run_id = static_cast<std::uint32_t>(in.get(4));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const AbortReply& m) {
  if (!is_valid(m.sequence)) {
    return 0;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const AbortReply& m) {
  out.put(static_cast<std::uint64_t>(m.sequence), 1);
  out.put(static_cast<std::uint64_t>(m.exposures), 4);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] AbortReply& m) {
  m.sequence = static_cast<SequenceState>(in.get(1));
  m.exposures = static_cast<std::uint32_t>(in.get(4));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const ClearFaultRequest& m) {
  if (!is_valid(m.reason)) {
    return 0;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const ClearFaultRequest& m) {
  out.put(static_cast<std::uint64_t>(m.reason), 1);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] ClearFaultRequest& m) {
  m.reason = static_cast<FaultReason>(in.get(1));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const ClearFaultReply& m) {
  if (!is_valid(m.fault)) {
    return 0;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const ClearFaultReply& m) {
  out.put(static_cast<std::uint64_t>(m.fault), 1);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] ClearFaultReply& m) {
  m.fault = static_cast<FaultReason>(in.get(1));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const AcknowledgeEventsRequest& m) {
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const AcknowledgeEventsRequest& m) {
  out.put(static_cast<std::uint64_t>(m.next_event), 4);
  out.put(m.resend ? 1 : 0, 1);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] AcknowledgeEventsRequest& m) {
  int bad = -1;
  m.next_event = static_cast<std::uint32_t>(in.get(4));
  {
    const std::uint64_t value = in.get(1);
    m.resend = value == 1;
    if (value > 1 && bad < 0) {
      bad = 1;
    }
  }
  return bad;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const AcknowledgeEventsReply& m) {
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const AcknowledgeEventsReply& m) {
  out.put(static_cast<std::uint64_t>(m.oldest_event), 4);
  out.put(static_cast<std::uint64_t>(m.next_event), 4);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] AcknowledgeEventsReply& m) {
  m.oldest_event = static_cast<std::uint32_t>(in.get(4));
  m.next_event = static_cast<std::uint32_t>(in.get(4));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const CountersRequest& m) {
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const CountersRequest& m) {
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] CountersRequest& m) {
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const CountersReply& m) {
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const CountersReply& m) {
  out.put(static_cast<std::uint64_t>(m.frames_received), 4);
  out.put(static_cast<std::uint64_t>(m.frames_sent), 4);
  out.put(static_cast<std::uint64_t>(m.crc_errors), 4);
  out.put(static_cast<std::uint64_t>(m.framing_errors), 4);
  out.put(static_cast<std::uint64_t>(m.overruns), 4);
  out.put(static_cast<std::uint64_t>(m.rejected), 4);
  out.put(static_cast<std::uint64_t>(m.failed), 4);
  out.put(static_cast<std::uint64_t>(m.retries_answered), 4);
  out.put(static_cast<std::uint64_t>(m.wrong_nonce), 4);
  out.put(static_cast<std::uint64_t>(m.events_sent), 4);
  out.put(static_cast<std::uint64_t>(m.events_resent), 4);
  out.put(static_cast<std::uint64_t>(m.exposures), 4);
  out.put(static_cast<std::uint64_t>(m.link_timeouts), 4);
  out.put(static_cast<std::uint64_t>(m.faults), 4);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] CountersReply& m) {
  m.frames_received = static_cast<std::uint32_t>(in.get(4));
  m.frames_sent = static_cast<std::uint32_t>(in.get(4));
  m.crc_errors = static_cast<std::uint32_t>(in.get(4));
  m.framing_errors = static_cast<std::uint32_t>(in.get(4));
  m.overruns = static_cast<std::uint32_t>(in.get(4));
  m.rejected = static_cast<std::uint32_t>(in.get(4));
  m.failed = static_cast<std::uint32_t>(in.get(4));
  m.retries_answered = static_cast<std::uint32_t>(in.get(4));
  m.wrong_nonce = static_cast<std::uint32_t>(in.get(4));
  m.events_sent = static_cast<std::uint32_t>(in.get(4));
  m.events_resent = static_cast<std::uint32_t>(in.get(4));
  m.exposures = static_cast<std::uint32_t>(in.get(4));
  m.link_timeouts = static_cast<std::uint32_t>(in.get(4));
  m.faults = static_cast<std::uint32_t>(in.get(4));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const GetSettingsRequest& m) {
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const GetSettingsRequest& m) {
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] GetSettingsRequest& m) {
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const GetSettingsReply& m) {
  if (!detail::is_text(m.serial_number, 16)) {
    return 0;
  }
  if (!is_valid(m.glass_variant)) {
    return 1;
  }
  if (!is_valid(m.mounting)) {
    return 2;
  }
  if (m.contrast > 63U) {
    return 3;
  }
  if (m.resistor_ratio > 7U) {
    return 4;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const GetSettingsReply& m) {
  for (std::size_t i = 0; i < 16; ++i) {
    out.put(static_cast<unsigned char>(m.serial_number[i]), 1);
  }
  out.put(static_cast<std::uint64_t>(m.glass_variant), 1);
  out.put(static_cast<std::uint64_t>(m.mounting), 1);
  out.put(static_cast<std::uint64_t>(m.contrast), 1);
  out.put(static_cast<std::uint64_t>(m.resistor_ratio), 1);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] GetSettingsReply& m) {
  for (std::size_t i = 0; i < 16; ++i) {
    m.serial_number[i] = static_cast<char>(in.get(1));
  }
  m.glass_variant = static_cast<GlassVariant>(in.get(1));
  m.mounting = static_cast<Mounting>(in.get(1));
  m.contrast = static_cast<std::uint8_t>(in.get(1));
  m.resistor_ratio = static_cast<std::uint8_t>(in.get(1));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const SetSettingsRequest& m) {
  if (!detail::is_text(m.serial_number, 16)) {
    return 0;
  }
  if (!is_valid(m.glass_variant)) {
    return 1;
  }
  if (!is_valid(m.mounting)) {
    return 2;
  }
  if (m.contrast > 63U) {
    return 3;
  }
  if (m.resistor_ratio > 7U) {
    return 4;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const SetSettingsRequest& m) {
  for (std::size_t i = 0; i < 16; ++i) {
    out.put(static_cast<unsigned char>(m.serial_number[i]), 1);
  }
  out.put(static_cast<std::uint64_t>(m.glass_variant), 1);
  out.put(static_cast<std::uint64_t>(m.mounting), 1);
  out.put(static_cast<std::uint64_t>(m.contrast), 1);
  out.put(static_cast<std::uint64_t>(m.resistor_ratio), 1);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] SetSettingsRequest& m) {
  for (std::size_t i = 0; i < 16; ++i) {
    m.serial_number[i] = static_cast<char>(in.get(1));
  }
  m.glass_variant = static_cast<GlassVariant>(in.get(1));
  m.mounting = static_cast<Mounting>(in.get(1));
  m.contrast = static_cast<std::uint8_t>(in.get(1));
  m.resistor_ratio = static_cast<std::uint8_t>(in.get(1));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const SetSettingsReply& m) {
  if (!detail::is_text(m.serial_number, 16)) {
    return 0;
  }
  if (!is_valid(m.glass_variant)) {
    return 1;
  }
  if (!is_valid(m.mounting)) {
    return 2;
  }
  if (m.contrast > 63U) {
    return 3;
  }
  if (m.resistor_ratio > 7U) {
    return 4;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const SetSettingsReply& m) {
  for (std::size_t i = 0; i < 16; ++i) {
    out.put(static_cast<unsigned char>(m.serial_number[i]), 1);
  }
  out.put(static_cast<std::uint64_t>(m.glass_variant), 1);
  out.put(static_cast<std::uint64_t>(m.mounting), 1);
  out.put(static_cast<std::uint64_t>(m.contrast), 1);
  out.put(static_cast<std::uint64_t>(m.resistor_ratio), 1);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] SetSettingsReply& m) {
  for (std::size_t i = 0; i < 16; ++i) {
    m.serial_number[i] = static_cast<char>(in.get(1));
  }
  m.glass_variant = static_cast<GlassVariant>(in.get(1));
  m.mounting = static_cast<Mounting>(in.get(1));
  m.contrast = static_cast<std::uint8_t>(in.get(1));
  m.resistor_ratio = static_cast<std::uint8_t>(in.get(1));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const GetLedCorrectionRequest& m) {
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const GetLedCorrectionRequest& m) {
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] GetLedCorrectionRequest& m) {
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const GetLedCorrectionReply& m) {
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const GetLedCorrectionReply& m) {
  for (std::size_t i = 0; i < 48; ++i) {
    out.put(static_cast<std::uint64_t>(m.factors[i]), 1);
  }
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] GetLedCorrectionReply& m) {
  for (std::size_t i = 0; i < 48; ++i) {
    m.factors[i] = static_cast<std::uint8_t>(in.get(1));
  }
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const SetLedCorrectionRequest& m) {
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const SetLedCorrectionRequest& m) {
  for (std::size_t i = 0; i < 48; ++i) {
    out.put(static_cast<std::uint64_t>(m.factors[i]), 1);
  }
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] SetLedCorrectionRequest& m) {
  for (std::size_t i = 0; i < 48; ++i) {
    m.factors[i] = static_cast<std::uint8_t>(in.get(1));
  }
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const SetLedCorrectionReply& m) {
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const SetLedCorrectionReply& m) {
  for (std::size_t i = 0; i < 48; ++i) {
    out.put(static_cast<std::uint64_t>(m.factors[i]), 1);
  }
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] SetLedCorrectionReply& m) {
  for (std::size_t i = 0; i < 48; ++i) {
    m.factors[i] = static_cast<std::uint8_t>(in.get(1));
  }
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const Rejected& m) {
  if (!is_valid(m.code)) {
    return 0;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const Rejected& m) {
  out.put(static_cast<std::uint64_t>(m.code), 1);
  out.put(static_cast<std::uint64_t>(m.message), 1);
  out.put(static_cast<std::uint64_t>(m.detail), 4);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] Rejected& m) {
  m.code = static_cast<ErrorCode>(in.get(1));
  m.message = static_cast<std::uint8_t>(in.get(1));
  m.detail = static_cast<std::uint32_t>(in.get(4));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const Failed& m) {
  if (!is_valid(m.code)) {
    return 0;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const Failed& m) {
  out.put(static_cast<std::uint64_t>(m.code), 1);
  out.put(static_cast<std::uint64_t>(m.message), 1);
  out.put(static_cast<std::uint64_t>(m.detail), 4);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] Failed& m) {
  m.code = static_cast<ErrorCode>(in.get(1));
  m.message = static_cast<std::uint8_t>(in.get(1));
  m.detail = static_cast<std::uint32_t>(in.get(4));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const BootedEvent& m) {
  if (!is_valid(m.reset_cause)) {
    return 0;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const BootedEvent& m) {
  out.put(static_cast<std::uint64_t>(m.reset_cause), 1);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] BootedEvent& m) {
  m.reset_cause = static_cast<ResetCause>(in.get(1));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const ExposureEvent& m) {
  if (m.step > 1023U) {
    return 3;
  }
  if (m.aperture > 15U && m.aperture != 255U) {
    return 5;
  }
  if (m.light > 31U && m.light != 255U) {
    return 6;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const ExposureEvent& m) {
  out.put(static_cast<std::uint64_t>(m.table_hash), 4);
  out.put(static_cast<std::uint64_t>(m.run_id), 4);
  out.put(static_cast<std::uint64_t>(m.index), 4);
  out.put(static_cast<std::uint64_t>(m.step), 2);
  out.put(static_cast<std::uint64_t>(m.repeat), 2);
  out.put(static_cast<std::uint64_t>(m.aperture), 1);
  out.put(static_cast<std::uint64_t>(m.light), 1);
  out.put(static_cast<std::uint64_t>(m.start_us), 8);
  out.put(static_cast<std::uint64_t>(m.settle_waited_us), 4);
  out.put(static_cast<std::uint64_t>(m.exposure_us), 4);
  out.put(static_cast<std::uint64_t>(m.flags), 1);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] ExposureEvent& m) {
  m.table_hash = static_cast<std::uint32_t>(in.get(4));
  m.run_id = static_cast<std::uint32_t>(in.get(4));
  m.index = static_cast<std::uint32_t>(in.get(4));
  m.step = static_cast<std::uint16_t>(in.get(2));
  m.repeat = static_cast<std::uint16_t>(in.get(2));
  m.aperture = static_cast<std::uint8_t>(in.get(1));
  m.light = static_cast<std::uint8_t>(in.get(1));
  m.start_us = static_cast<std::uint64_t>(in.get(8));
  m.settle_waited_us = static_cast<std::uint32_t>(in.get(4));
  m.exposure_us = static_cast<std::uint32_t>(in.get(4));
  m.flags = static_cast<std::uint8_t>(in.get(1));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const SequenceEvent& m) {
  if (!is_valid(m.news)) {
    return 0;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const SequenceEvent& m) {
  out.put(static_cast<std::uint64_t>(m.news), 1);
  out.put(static_cast<std::uint64_t>(m.run_id), 4);
  out.put(static_cast<std::uint64_t>(m.table_hash), 4);
  out.put(static_cast<std::uint64_t>(m.exposures), 4);
  out.put(static_cast<std::uint64_t>(m.at_us), 8);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] SequenceEvent& m) {
  m.news = static_cast<SequenceNews>(in.get(1));
  m.run_id = static_cast<std::uint32_t>(in.get(4));
  m.table_hash = static_cast<std::uint32_t>(in.get(4));
  m.exposures = static_cast<std::uint32_t>(in.get(4));
  m.at_us = static_cast<std::uint64_t>(in.get(8));
  return -1;
}

}  // namespace detail

// Index of the first field outside its range, or -1.
inline int first_bad_field([[maybe_unused]] const FaultEvent& m) {
  if (!is_valid(m.reason)) {
    return 0;
  }
  return -1;
}

namespace detail {

inline void write([[maybe_unused]] Writer& out, [[maybe_unused]] const FaultEvent& m) {
  out.put(static_cast<std::uint64_t>(m.reason), 1);
  out.put(static_cast<std::uint64_t>(m.run_id), 4);
  out.put(static_cast<std::uint64_t>(m.step), 2);
  out.put(static_cast<std::uint64_t>(m.at_us), 8);
  out.put(static_cast<std::uint64_t>(m.detail), 4);
}

// Returns the index of the first bool that is neither 0 nor 1, or -1.
inline int read([[maybe_unused]] Reader& in, [[maybe_unused]] FaultEvent& m) {
  m.reason = static_cast<FaultReason>(in.get(1));
  m.run_id = static_cast<std::uint32_t>(in.get(4));
  m.step = static_cast<std::uint16_t>(in.get(2));
  m.at_us = static_cast<std::uint64_t>(in.get(8));
  m.detail = static_cast<std::uint32_t>(in.get(4));
  return -1;
}

}  // namespace detail

// Writes a message's payload (or the header); `out` has room for M::kMaxSize bytes. Returns the number of bytes written.
template <class M>
std::size_t encode(const M& message, std::uint8_t* out) {
  detail::Writer writer{out};
  detail::write(writer, message);
  return static_cast<std::size_t>(writer.at - out);
}

// Reads a message's payload (or the header). Only when the code is OK may `message` be used.
template <class M>
Check decode(M& message, const std::uint8_t* payload, std::size_t size) {
  detail::Reader reader{payload, size};
  const int bad_bool = detail::read(reader, message);
  if (!reader.complete || reader.left != 0) {
    return {ErrorCode::kBadLength, 0};
  }
  const int bad = first_bad_field(message);
  if (bad >= 0 && (bad_bool < 0 || bad < bad_bool)) {
    return {ErrorCode::kOutOfRange, static_cast<std::uint8_t>(bad)};
  }
  if (bad_bool >= 0) {
    return {ErrorCode::kOutOfRange, static_cast<std::uint8_t>(bad_bool)};
  }
  return {};
}

// Whether the answer to this request is kept in the completion ring (and its boot nonce and id are checked).
constexpr bool uses_ring(std::uint8_t message) {
  switch (static_cast<MessageId>(message)) {
    case MessageId::kStatusRequest:
    case MessageId::kLimitsRequest:
    case MessageId::kLoadLightRequest:
    case MessageId::kApertureChunkRequest:
    case MessageId::kCommitApertureRequest:
    case MessageId::kSelectApertureRequest:
    case MessageId::kSelectLightRequest:
    case MessageId::kAllOffRequest:
    case MessageId::kStepChunkRequest:
    case MessageId::kCommitStepsRequest:
    case MessageId::kStartRequest:
    case MessageId::kPauseRequest:
    case MessageId::kResumeRequest:
    case MessageId::kAbortRequest:
    case MessageId::kClearFaultRequest:
    case MessageId::kAcknowledgeEventsRequest:
    case MessageId::kCountersRequest:
    case MessageId::kGetSettingsRequest:
    case MessageId::kSetSettingsRequest:
    case MessageId::kGetLedCorrectionRequest:
    case MessageId::kSetLedCorrectionRequest:
      return true;
    default:
      return false;
  }
}

constexpr bool is_request(std::uint8_t message) {
  switch (static_cast<MessageId>(message)) {
    case MessageId::kHelloRequest:
    case MessageId::kEnterBootloaderRequest:
    case MessageId::kStatusRequest:
    case MessageId::kLimitsRequest:
    case MessageId::kLoadLightRequest:
    case MessageId::kApertureChunkRequest:
    case MessageId::kCommitApertureRequest:
    case MessageId::kSelectApertureRequest:
    case MessageId::kSelectLightRequest:
    case MessageId::kAllOffRequest:
    case MessageId::kStepChunkRequest:
    case MessageId::kCommitStepsRequest:
    case MessageId::kStartRequest:
    case MessageId::kPauseRequest:
    case MessageId::kResumeRequest:
    case MessageId::kAbortRequest:
    case MessageId::kClearFaultRequest:
    case MessageId::kAcknowledgeEventsRequest:
    case MessageId::kCountersRequest:
    case MessageId::kGetSettingsRequest:
    case MessageId::kSetSettingsRequest:
    case MessageId::kGetLedCorrectionRequest:
    case MessageId::kSetLedCorrectionRequest:
      return true;
    default:
      return false;
  }
}

// What a request led to: the message id and payload size of the answer that was written.
struct Outcome {
  ErrorCode code = ErrorCode::kOk;
  MessageId message = MessageId::kRejected;
  std::size_t size = 0;
};

// Writes a refusal (rejected or failed, as the code says) for a request; `out` has room for Rejected::kMaxSize bytes.
inline Outcome refuse(std::uint8_t request, ErrorCode code, std::uint32_t detail_value, std::uint8_t* out) {
  Rejected refusal;
  refusal.code = code;
  refusal.message = request;
  refusal.detail = detail_value;
  return {code, is_rejection(code) ? MessageId::kRejected : MessageId::kFailed, encode(refusal, out)};
}

namespace detail {

template <class Request, class Reply, class Handler>
Outcome run(Handler& handler, const std::uint8_t* payload, std::size_t size, std::uint8_t* out) {
  constexpr std::uint8_t id = static_cast<std::uint8_t>(Request::kId);
  Request request;
  const Check check = decode(request, payload, size);
  if (check.code != ErrorCode::kOk) {
    return refuse(id, check.code, check.field, out);
  }
  Reply reply;
  std::uint32_t detail_value = 0;
  const ErrorCode code = handler.handle(request, reply, detail_value);
  if (code != ErrorCode::kOk) {
    return refuse(id, code, detail_value, out);
  }
  return {ErrorCode::kOk, Reply::kId, encode(reply, out)};
}

}  // namespace detail

// Decodes a request, has the handler run it, and writes the answer (reply or refusal) to `out`, which has room for
// kMaxPayload bytes. Handler offers, for every exchange X:
//   ErrorCode handle(const XRequest& request, XReply& reply, std::uint32_t& detail);
// Nonce, id and ring are the caller's business, before this is called.
template <class Handler>
Outcome dispatch(Handler& handler, std::uint8_t message, const std::uint8_t* payload, std::size_t size,
                 std::uint8_t* out) {
  switch (static_cast<MessageId>(message)) {
    case MessageId::kHelloRequest:
      return detail::run<HelloRequest, HelloReply>(handler, payload, size, out);
    case MessageId::kEnterBootloaderRequest:
      return detail::run<EnterBootloaderRequest, EnterBootloaderReply>(handler, payload, size, out);
    case MessageId::kStatusRequest:
      return detail::run<StatusRequest, StatusReply>(handler, payload, size, out);
    case MessageId::kLimitsRequest:
      return detail::run<LimitsRequest, LimitsReply>(handler, payload, size, out);
    case MessageId::kLoadLightRequest:
      return detail::run<LoadLightRequest, LoadLightReply>(handler, payload, size, out);
    case MessageId::kApertureChunkRequest:
      return detail::run<ApertureChunkRequest, ApertureChunkReply>(handler, payload, size, out);
    case MessageId::kCommitApertureRequest:
      return detail::run<CommitApertureRequest, CommitApertureReply>(handler, payload, size, out);
    case MessageId::kSelectApertureRequest:
      return detail::run<SelectApertureRequest, SelectApertureReply>(handler, payload, size, out);
    case MessageId::kSelectLightRequest:
      return detail::run<SelectLightRequest, SelectLightReply>(handler, payload, size, out);
    case MessageId::kAllOffRequest:
      return detail::run<AllOffRequest, AllOffReply>(handler, payload, size, out);
    case MessageId::kStepChunkRequest:
      return detail::run<StepChunkRequest, StepChunkReply>(handler, payload, size, out);
    case MessageId::kCommitStepsRequest:
      return detail::run<CommitStepsRequest, CommitStepsReply>(handler, payload, size, out);
    case MessageId::kStartRequest:
      return detail::run<StartRequest, StartReply>(handler, payload, size, out);
    case MessageId::kPauseRequest:
      return detail::run<PauseRequest, PauseReply>(handler, payload, size, out);
    case MessageId::kResumeRequest:
      return detail::run<ResumeRequest, ResumeReply>(handler, payload, size, out);
    case MessageId::kAbortRequest:
      return detail::run<AbortRequest, AbortReply>(handler, payload, size, out);
    case MessageId::kClearFaultRequest:
      return detail::run<ClearFaultRequest, ClearFaultReply>(handler, payload, size, out);
    case MessageId::kAcknowledgeEventsRequest:
      return detail::run<AcknowledgeEventsRequest, AcknowledgeEventsReply>(handler, payload, size, out);
    case MessageId::kCountersRequest:
      return detail::run<CountersRequest, CountersReply>(handler, payload, size, out);
    case MessageId::kGetSettingsRequest:
      return detail::run<GetSettingsRequest, GetSettingsReply>(handler, payload, size, out);
    case MessageId::kSetSettingsRequest:
      return detail::run<SetSettingsRequest, SetSettingsReply>(handler, payload, size, out);
    case MessageId::kGetLedCorrectionRequest:
      return detail::run<GetLedCorrectionRequest, GetLedCorrectionReply>(handler, payload, size, out);
    case MessageId::kSetLedCorrectionRequest:
      return detail::run<SetLedCorrectionRequest, SetLedCorrectionReply>(handler, payload, size, out);
    default:
      return refuse(message, ErrorCode::kUnknownMessage, 0, out);
  }
}

}  // namespace reliefscope::wire
