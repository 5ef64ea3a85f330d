#include "core/commands.hpp"

#include <cstring>

#include "core/version.hpp"

namespace reliefscope {
namespace {

// Time in which the answer to enter_bootloader leaves.
constexpr std::uint16_t kBootloaderDelayMs = 50;

template <std::size_t N>
void set_text(char (&out)[N], const char* text) {
  std::size_t i = 0;
  for (; i < N && text[i] != '\0'; ++i) {
    out[i] = text[i];
  }
  std::memset(out + i, 0, N - i);
}

template <class To, class From>
To copy_settings(const From& from) {
  To to;
  std::memcpy(to.serial_number, from.serial_number, sizeof to.serial_number);
  to.glass_variant = from.glass_variant;
  to.mounting = from.mounting;
  to.contrast = from.contrast;
  to.resistor_ratio = from.resistor_ratio;
  return to;
}

}  // namespace

using Error = wire::ErrorCode;

Error Commands::handle(const wire::HelloRequest&, wire::HelloReply& reply, Detail&) {
  const BoardInfo& info = hal_.info();
  reply.protocol_version = wire::kProtocolVersion;
  std::memcpy(reply.schema_hash, wire::kSchemaHash, sizeof reply.schema_hash);
  set_text(reply.firmware_version, kFirmwareVersion);
  set_text(reply.git_hash, kGitHash);
  set_text(reply.board, info.name);
  std::memcpy(reply.serial_number, instrument_.settings().get().serial_number,
              sizeof reply.serial_number);
  reply.capabilities = info.capabilities;
  reply.reset_cause = link_.reset_cause;
  reply.boot_nonce = link_.boot_nonce;
  reply.last_request_id = link_.last_request_id;
  reply.aperture_slots = wire::kApertureSlots;
  reply.light_slots = wire::kLightSlots;
  reply.leds = info.led_count;
  reply.steps = wire::kSteps;
  return Error::kOk;
}

Error Commands::handle(const wire::EnterBootloaderRequest& request,
                       wire::EnterBootloaderReply& reply, Detail&) {
  if (request.magic != wire::kBootloaderMagic) {
    return Error::kBadMagic;
  }
  if ((hal_.info().capabilities & wire::Capability::kBootloader) == 0) {
    return Error::kNoBootloader;
  }
  instrument_.abort(true);
  reply.delay_ms = kBootloaderDelayMs;
  if (link_.bootloader_at_us == kNever) {
    link_.bootloader_at_us = hal_.now_us() + std::uint64_t{kBootloaderDelayMs} * 1000;
  }
  return Error::kOk;
}

Error Commands::handle(const wire::StatusRequest&, wire::StatusReply& reply, Detail&) {
  const InterruptLock lock(hal_);
  const Sequencer& sequencer = instrument_.sequencer();
  const bool ready_wired = (hal_.info().capabilities & wire::Capability::kReady) != 0;
  reply.sequence = sequencer.state();
  reply.fault = instrument_.fault();
  reply.aperture = instrument_.shown().aperture;
  reply.light = instrument_.shown().light;
  reply.camera_ready = !ready_wired || hal_.input_level(Input::kReady);
  reply.uptime_us = hal_.now_us() - link_.started_us;
  reply.table_hash = instrument_.store().table_hash();
  reply.run_id = sequencer.run_id();
  reply.step = sequencer.step_index();
  reply.exposures = sequencer.exposures();
  reply.oldest_event = instrument_.events().oldest();
  reply.next_event = instrument_.events().next();
  reply.temperature_centi = instrument_.temperature_centi();
  return Error::kOk;
}

Error Commands::handle(const wire::LimitsRequest&, wire::LimitsReply& reply, Detail&) {
  reply.led_on_time_us = hal_.info().led_on_time_us;
  reply.level_budget = hal_.info().level_budget;
  reply.led_period_us = hal_.info().led_period_us;
  reply.led_level_step = hal_.info().led_level_step;
  reply.link_timeout_ms = wire::kLinkTimeoutMs;
  reply.reset_ms = hal_.info().reset_ms;
  return Error::kOk;
}

Error Commands::handle(const wire::LoadLightRequest& request, wire::LoadLightReply& reply,
                       Detail& detail) {
  if (const Error busy = idle(); busy != Error::kOk) {
    return busy;
  }
  const BoardInfo& info = hal_.info();
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < request.levels_count; ++i) {
    if (i >= info.led_count && request.levels[i] != 0) {
      detail = 1;  // field "levels": this board has no such LED
      return Error::kOutOfRange;
    }
    if (request.levels[i] % info.led_level_step != 0) {
      detail = static_cast<Detail>(i);
      return Error::kLedLevelStep;
    }
    sum += request.levels[i];
  }
  if (sum > info.level_budget) {
    detail = sum;
    return Error::kCurrentBudget;
  }
  instrument_.store().load_light(request.slot, request.levels, request.levels_count);
  reply.slot = request.slot;
  reply.crc32 = instrument_.store().light_crc(request.slot);
  reply.level_sum = sum;
  return Error::kOk;
}

Error Commands::handle(const wire::ApertureChunkRequest& request, wire::ApertureChunkReply& reply,
                       Detail&) {
  if (const Error busy = idle(); busy != Error::kOk) {
    return busy;
  }
  instrument_.store().write_aperture(request.slot, request.chunk, request.data);
  reply.slot = request.slot;
  reply.chunk = request.chunk;
  return Error::kOk;
}

Error Commands::handle(const wire::CommitApertureRequest& request, wire::CommitApertureReply& reply,
                       Detail& detail) {
  if (const Error busy = idle(); busy != Error::kOk) {
    return busy;
  }
  Store& store = instrument_.store();
  if (!store.commit_aperture(request.slot, request.crc32, detail)) {
    return Error::kCrcMismatch;
  }
  reply.slot = request.slot;
  reply.crc32 = store.aperture_crc(request.slot);
  reply.open_pixels = store.open_pixels(request.slot);
  return Error::kOk;
}

Error Commands::handle(const wire::SelectApertureRequest& request, wire::SelectApertureReply& reply,
                       Detail& detail) {
  if (const Error busy = idle(); busy != Error::kOk) {
    return busy;
  }
  if (request.slot != kSlotNone && instrument_.fault() != wire::FaultReason::kNone) {
    detail = fault_number();
    return Error::kFaultLatched;
  }
  if (instrument_.store().aperture(request.slot) == nullptr) {
    detail = request.slot;
    return Error::kSlotEmpty;
  }
  instrument_.select_aperture(request.slot);
  reply.slot = request.slot;
  reply.crc32 = instrument_.store().aperture_crc(request.slot);
  return Error::kOk;
}

Error Commands::handle(const wire::SelectLightRequest& request, wire::SelectLightReply& reply,
                       Detail& detail) {
  if (const Error busy = idle(); busy != Error::kOk) {
    return busy;
  }
  const std::uint16_t* levels = instrument_.store().light(request.slot);
  if (levels == nullptr) {
    detail = request.slot;
    return Error::kSlotEmpty;
  }
  if (const Error error = instrument_.select_light(request.slot); error != Error::kOk) {
    detail = error == Error::kFaultLatched ? fault_number() : instrument_.leds().level_sum(levels);
    return error;
  }
  reply.slot = request.slot;
  reply.level_sum = instrument_.leds().level_sum();
  return Error::kOk;
}

Error Commands::handle(const wire::AllOffRequest&, wire::AllOffReply& reply, Detail&) {
  instrument_.abort(false);
  reply.sequence = instrument_.sequencer().state();
  return Error::kOk;
}

Error Commands::handle(const wire::StepChunkRequest& request, wire::StepChunkReply& reply,
                       Detail& detail) {
  if (const Error busy = idle(); busy != Error::kOk) {
    return busy;
  }
  if (std::uint32_t{request.first} + request.steps_count > wire::kSteps) {
    detail = 1;  // field "steps": beyond the end of the table
    return Error::kOutOfRange;
  }
  for (std::size_t i = 0; i < request.steps_count; ++i) {
    instrument_.store().write_step(request.first + i, request.steps[i]);
  }
  reply.first = request.first;
  reply.count = request.steps_count;
  return Error::kOk;
}

Error Commands::handle(const wire::CommitStepsRequest& request, wire::CommitStepsReply& reply,
                       Detail& detail) {
  if (const Error busy = idle(); busy != Error::kOk) {
    return busy;
  }
  Store& store = instrument_.store();
  const std::uint32_t limit = hal_.info().led_on_time_us - Sequencer::kAfterExposureUs;
  if (const Error error = store.commit_steps(request.count, request.crc32, limit,
                                             hal_.info().led_period_us, detail);
      error != Error::kOk) {
    return error;
  }
  reply.count = store.step_count();
  reply.table_hash = store.table_hash();
  reply.exposures = store.exposures();
  return Error::kOk;
}

Error Commands::handle(const wire::StartRequest& request, wire::StartReply& reply, Detail& detail) {
  if (const Error busy = idle(); busy != Error::kOk) {
    return busy;
  }
  const Store& store = instrument_.store();
  if (store.step_count() == 0) {
    return Error::kNoTable;
  }
  if (store.table_hash() != request.table_hash) {
    detail = store.table_hash();
    return Error::kTableMismatch;
  }
  const std::uint32_t around = request.light_lead_us + Sequencer::kAfterExposureUs;
  for (std::size_t i = 0; i < store.step_count(); ++i) {
    const wire::Step& step = store.step(i);
    if (step.light != kSlotNone && step.exposure_us + around > hal_.info().led_on_time_us) {
      detail = static_cast<std::uint32_t>(i);
      return Error::kOnTimeLimit;
    }
  }
  if (const Error error = instrument_.start(request); error != Error::kOk) {
    detail = fault_number();
    return error;
  }
  reply.run_id = request.run_id;
  reply.table_hash = store.table_hash();
  reply.exposures = store.exposures();
  return Error::kOk;
}

Error Commands::handle(const wire::PauseRequest& request, wire::PauseReply& reply, Detail& detail) {
  if (const Error error = running(request.run_id, detail); error != Error::kOk) {
    return error;
  }
  instrument_.pause();
  reply.sequence = instrument_.sequencer().state();
  reply.exposures = instrument_.sequencer().exposures();
  return Error::kOk;
}

Error Commands::handle(const wire::ResumeRequest& request, wire::ResumeReply& reply,
                       Detail& detail) {
  if (const Error error = running(request.run_id, detail); error != Error::kOk) {
    return error;
  }
  instrument_.resume();
  reply.sequence = instrument_.sequencer().state();
  reply.exposures = instrument_.sequencer().exposures();
  return Error::kOk;
}

Error Commands::handle(const wire::AbortRequest& request, wire::AbortReply& reply, Detail& detail) {
  if (instrument_.sequencer().active()) {
    if (request.run_id != 0) {
      if (const Error error = running(request.run_id, detail); error != Error::kOk) {
        return error;
      }
    }
    instrument_.abort(true);
  }
  reply.sequence = instrument_.sequencer().state();
  reply.exposures = instrument_.sequencer().exposures();
  return Error::kOk;
}

Error Commands::handle(const wire::ClearFaultRequest& request, wire::ClearFaultReply& reply,
                       Detail&) {
  instrument_.clear_fault(request.reason);
  reply.fault = instrument_.fault();
  return Error::kOk;
}

Error Commands::handle(const wire::AcknowledgeEventsRequest& request,
                       wire::AcknowledgeEventsReply& reply, Detail& detail) {
  if (!instrument_.acknowledge_events(request.next_event, request.resend)) {
    detail = instrument_.events().oldest();
    return Error::kEventGone;
  }
  reply.oldest_event = instrument_.events().oldest();
  reply.next_event = instrument_.events().next();
  return Error::kOk;
}

Error Commands::handle(const wire::CountersRequest&, wire::CountersReply& reply, Detail&) {
  const InterruptLock lock(hal_);
  reply.frames_received = link_.framer.frames;
  reply.frames_sent = link_.frames_sent;
  reply.crc_errors = link_.framer.crc_errors;
  reply.framing_errors = link_.framer.framing_errors;
  reply.overruns = link_.framer.overruns;
  reply.rejected = link_.rejected;
  reply.failed = link_.failed;
  reply.retries_answered = link_.retries_answered;
  reply.wrong_nonce = link_.wrong_nonce;
  reply.events_sent = instrument_.events().sent();
  reply.events_resent = instrument_.events().resent();
  reply.exposures = instrument_.sequencer().exposures_ever();
  reply.link_timeouts = instrument_.link_timeouts();
  reply.faults = instrument_.faults();
  return Error::kOk;
}

Error Commands::handle(const wire::GetSettingsRequest&, wire::GetSettingsReply& reply, Detail&) {
  reply = instrument_.settings().get();
  return Error::kOk;
}

Error Commands::handle(const wire::SetSettingsRequest& request, wire::SetSettingsReply& reply,
                       Detail&) {
  if (const Error busy = idle(); busy != Error::kOk) {
    return busy;
  }
  if (!instrument_.set_settings(copy_settings<wire::GetSettingsReply>(request))) {
    return Error::kSettingsWrite;
  }
  reply = copy_settings<wire::SetSettingsReply>(instrument_.settings().get());
  return Error::kOk;
}

Error Commands::handle(const wire::GetLedCorrectionRequest&, wire::GetLedCorrectionReply& reply,
                       Detail&) {
  reply = instrument_.settings().led_correction();
  return Error::kOk;
}

Error Commands::handle(const wire::SetLedCorrectionRequest& request,
                       wire::SetLedCorrectionReply& reply, Detail&) {
  if (const Error busy = idle(); busy != Error::kOk) {
    return busy;
  }
  wire::GetLedCorrectionReply values;
  std::memcpy(values.factors, request.factors, sizeof values.factors);
  if (!instrument_.set_led_correction(values)) {
    return Error::kSettingsWrite;
  }
  std::memcpy(reply.factors, request.factors, sizeof reply.factors);
  return Error::kOk;
}

Error Commands::idle() const {
  return instrument_.sequencer().active() ? Error::kBusy : Error::kOk;
}

Error Commands::running(std::uint32_t run_id, Detail& detail) const {
  const Sequencer& sequencer = instrument_.sequencer();
  if (sequencer.active() && sequencer.run_id() == run_id) {
    return Error::kOk;
  }
  detail = sequencer.active() ? sequencer.run_id() : 0;
  return Error::kNotRunning;
}

Commands::Detail Commands::fault_number() const {
  return static_cast<Detail>(instrument_.fault());
}

}  // namespace reliefscope
