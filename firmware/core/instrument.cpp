#include "core/instrument.hpp"

namespace reliefscope {
namespace {

using wire::FaultReason;

constexpr std::uint64_t kLinkTimeoutUs = std::uint64_t{wire::kLinkTimeoutMs} * 1000;
constexpr std::uint64_t kTemperaturePeriodUs = 1000000;
// The K20 is specified to 85 degrees of ambient air.
constexpr std::int16_t kTemperatureLimitCenti = 8500;

constexpr std::uint64_t earlier(std::uint64_t a, std::uint64_t b) {
  return a < b ? a : b;
}

}  // namespace

void Instrument::begin(wire::ResetCause cause) {
  leds_.begin();
  hal_.set_pin(Pin::kCameraTrigger, false);
  settings_.load();
  leds_.correct(settings_.led_correction().factors);
  display_.begin(display_config());
  wire::BootedEvent event;
  event.reset_cause = cause;
  const InterruptLock lock(hal_);
  events_.push(event);
  link_heard_us_ = hal_.now_us();
  temperature_due_us_ = link_heard_us_;
}

bool Instrument::poll() {
  hal_.kick_watchdog();
  if (take_shut_wanted()) {
    display_.shut();
  }
  const bool heat = check_temperature();
  const bool steps = sequencer_.poll();
  const bool glass = display_.poll();
  if (heat || steps || glass) {
    const InterruptLock lock(hal_);
    arm();
    return true;
  }
  return false;
}

std::uint64_t Instrument::next_wakeup_us() const {
  const bool measures = (hal_.info().capabilities & wire::Capability::kTemperature) != 0;
  return earlier(display_.next_wakeup_us(), measures ? temperature_due_us_ : kNever);
}

void Instrument::on_timer() {
  armed_us_ = kNever;
  const FaultReason reason = sequencer_.on_timer();
  const std::uint64_t now = hal_.now_us();
  if (leds_.overdue()) {
    latch(FaultReason::kLedOnTime, shown_.light);
  } else if (leds_.lit() && !sequencer_.active() && now >= link_heard_us_ + kLinkTimeoutUs) {
    leds_.off();
    shown_.light = kSlotNone;
    ++link_timeouts_;
  }
  after(reason);
}

void Instrument::on_input(Input input, bool high) {
  after(sequencer_.on_input(input, high));
}

void Instrument::link_heard() {
  const InterruptLock lock(hal_);
  link_heard_us_ = hal_.now_us();
  arm();
}

void Instrument::select_aperture(std::uint8_t slot) {
  display_.show(slot == kSlotNone ? nullptr : store_.aperture(slot));
  shown_.aperture = slot;
}

wire::ErrorCode Instrument::select_light(std::uint8_t slot) {
  const InterruptLock lock(hal_);
  if (slot != kSlotNone && fault_ != FaultReason::kNone) {
    return wire::ErrorCode::kFaultLatched;
  }
  if (!leds_.set(store_.light(slot))) {
    return wire::ErrorCode::kCurrentBudget;
  }
  shown_.light = slot;
  arm();
  return wire::ErrorCode::kOk;
}

wire::ErrorCode Instrument::start(const wire::StartRequest& request) {
  const InterruptLock lock(hal_);
  if (fault_ != FaultReason::kNone) {
    return wire::ErrorCode::kFaultLatched;
  }
  sequencer_.start(request);
  after(FaultReason::kNone);
  return wire::ErrorCode::kOk;
}

void Instrument::pause() {
  const InterruptLock lock(hal_);
  sequencer_.pause();
  after(FaultReason::kNone);
}

void Instrument::resume() {
  const InterruptLock lock(hal_);
  sequencer_.resume();
  after(FaultReason::kNone);
}

void Instrument::abort(bool shut) {
  const InterruptLock lock(hal_);
  shut_wanted_ = shut_wanted_ || (shut && sequencer_.active());
  sequencer_.abort();
  leds_.off();
  shown_.light = kSlotNone;
  after(FaultReason::kNone);
}

void Instrument::clear_fault(FaultReason reason) {
  const InterruptLock lock(hal_);
  if (fault_ == reason) {
    fault_ = FaultReason::kNone;
  }
}

bool Instrument::acknowledge_events(std::uint32_t next_event, bool resend) {
  const InterruptLock lock(hal_);
  if (!events_.acknowledge(next_event, resend)) {
    return false;
  }
  after(sequencer_.on_event_room());
  return true;
}

bool Instrument::take_event(Event& event, std::uint32_t& number) {
  const InterruptLock lock(hal_);
  return events_.take(event, number);
}

bool Instrument::event_pending() {
  const InterruptLock lock(hal_);
  return events_.pending();
}

bool Instrument::set_settings(const wire::GetSettingsReply& values) {
  if (!settings_.set(values)) {
    return false;
  }
  display_.configure(display_config());
  return true;
}

bool Instrument::set_led_correction(const wire::GetLedCorrectionReply& values) {
  if (!settings_.set(values)) {
    return false;
  }
  const InterruptLock lock(hal_);
  leds_.correct(values.factors);
  return true;
}

std::int16_t Instrument::temperature_centi() {
  const bool measures = (hal_.info().capabilities & wire::Capability::kTemperature) != 0;
  return measures ? hal_.temperature_centi() : static_cast<std::int16_t>(wire::kTemperatureUnknown);
}

DisplayConfig Instrument::display_config() const {
  const wire::GetSettingsReply& values = settings_.get();
  DisplayConfig config{};
  config.dark_when_off = values.glass_variant == wire::GlassVariant::kSFstnNegative;
  config.top_view = values.mounting == wire::Mounting::kTopView;
  config.contrast = values.contrast;
  config.resistor_ratio = values.resistor_ratio;
  return config;
}

void Instrument::latch(FaultReason reason, std::uint32_t detail) {
  leds_.off();
  shown_.light = kSlotNone;
  shut_wanted_ = true;
  if (fault_ == FaultReason::kNone) {
    fault_ = reason;
    ++faults_;
    wire::FaultEvent event;
    event.reason = reason;
    event.run_id = sequencer_.active() ? sequencer_.run_id() : 0;
    event.step = sequencer_.active() ? sequencer_.step_index() : 0;
    event.at_us = hal_.now_us();
    event.detail = detail;
    if (!events_.push(event)) {
      events_.replace_newest(event);
    }
  }
  sequencer_.abort();
  sequencer_.take_event_lost();  // the latch tells more than its event would
}

// Whatever may have moved a deadline or met a fault ends here.
void Instrument::after(FaultReason reason) {
  if (reason != FaultReason::kNone) {
    latch(reason, sequencer_.exposures());
  }
  if (sequencer_.take_event_lost()) {
    latch(FaultReason::kEventsLost, events_.next());
  }
  arm();
}

void Instrument::arm() {
  std::uint64_t due = earlier(sequencer_.deadline_us(), leds_.deadline_us());
  if (leds_.lit() && !sequencer_.active()) {
    due = earlier(due, link_heard_us_ + kLinkTimeoutUs);
  }
  if (due != armed_us_) {
    armed_us_ = due;
    hal_.arm_timer(due);
  }
}

// The lock also makes the compiler read anew, once a turn, what interrupts may have changed.
bool Instrument::take_shut_wanted() {
  const InterruptLock lock(hal_);
  const bool wanted = shut_wanted_;
  if (wanted) {
    shut_wanted_ = false;
    shown_.aperture = kSlotNone;
  }
  return wanted;
}

bool Instrument::check_temperature() {
  if ((hal_.info().capabilities & wire::Capability::kTemperature) == 0 ||
      hal_.now_us() < temperature_due_us_) {
    return false;
  }
  temperature_due_us_ = hal_.now_us() + kTemperaturePeriodUs;
  const std::int16_t centi = hal_.temperature_centi();
  if (centi > kTemperatureLimitCenti && fault_ == FaultReason::kNone) {
    const InterruptLock lock(hal_);
    latch(FaultReason::kOverTemperature, static_cast<std::uint32_t>(centi));
  }
  return true;
}

}  // namespace reliefscope
