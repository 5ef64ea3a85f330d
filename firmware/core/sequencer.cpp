#include "core/sequencer.hpp"

namespace reliefscope {
namespace {

using wire::FaultReason;
using wire::SequenceNews;

constexpr std::uint64_t kUsPerMs = 1000;

constexpr std::uint64_t later(std::uint64_t a, std::uint64_t b) {
  return a > b ? a : b;
}
constexpr std::uint64_t earlier(std::uint64_t a, std::uint64_t b) {
  return a < b ? a : b;
}

}  // namespace

void Sequencer::start(const wire::StartRequest& request) {
  light_off();
  run_ = request;
  run_deadline_us_ = hal_.now_us() + request.deadline_ms * kUsPerMs;
  step_index_ = 0;
  repeat_ = 0;
  exposures_ = 0;
  pause_wanted_ = false;
  glass_stale_ = true;
  earliest_trigger_us_ = 0;
  tell(SequenceNews::kStarted);
  enter_step();
}

void Sequencer::pause() {
  if (phase_ == Phase::kExpose) {
    pause_wanted_ = true;
  } else if (phase_ != Phase::kIdle && phase_ != Phase::kPaused) {
    stand();
  }
}

void Sequencer::resume() {
  if (phase_ == Phase::kPaused) {
    run_deadline_us_ += hal_.now_us() - paused_at_us_;
    glass_stale_ = true;
    tell(SequenceNews::kResumed);
    enter_step();
  } else if (pause_wanted_) {
    pause_wanted_ = false;
  }
}

void Sequencer::abort() {
  if (active()) {
    end(SequenceNews::kAborted);
  }
}

bool Sequencer::poll() {
  if (phase_ == Phase::kLoad) {
    const std::uint8_t slot = step().aperture;
    const bool write = glass_stale_ || slot != shown_.aperture;
    if (write) {
      display_.show(store_.aperture(slot));
    }
    const InterruptLock lock(hal_);
    if (phase_ == Phase::kLoad) {
      shown_.aperture = slot;
      glass_stale_ = false;
      phase_ = Phase::kLoading;
    }
    return true;
  }
  if (phase_ == Phase::kLoading && display_.idle()) {
    const InterruptLock lock(hal_);
    if (phase_ == Phase::kLoading) {
      glass_written_us_ = display_.idle_since_us();
      settle();
    }
    return true;
  }
  return false;
}

FaultReason Sequencer::on_timer() {
  const std::uint64_t now = hal_.now_us();
  // The trigger goes first: whatever else is due can wait for it.
  if (phase_ == Phase::kLead && now >= phase_deadline_us_) {
    return trigger();
  }
  if (active() && phase_ != Phase::kPaused && now >= run_deadline_us_) {
    return FaultReason::kSequenceDeadline;
  }
  if (now < phase_deadline_us_) {
    return FaultReason::kNone;
  }
  switch (phase_) {
    case Phase::kSettle:
    case Phase::kGap:
      if (phase_ == Phase::kGap && repeat_ == 0) {
        enter_step();
        return FaultReason::kNone;
      }
      return prepare();
    case Phase::kWaitReady:
      return FaultReason::kCameraNotReady;
    case Phase::kExpose:
      return expose();
    default:
      return FaultReason::kNone;
  }
}

FaultReason Sequencer::on_input(Input input, bool high) {
  if (input == Input::kReady && high && phase_ == Phase::kWaitReady) {
    return light_up();
  }
  if (input == Input::kStrobe && phase_ == Phase::kExpose && wired(wire::Capability::kStrobe)) {
    if (high) {
      strobe_seen_ = true;
    } else {
      return expose();
    }
  }
  return FaultReason::kNone;
}

FaultReason Sequencer::on_event_room() {
  return phase_ == Phase::kHeld && events_.room_for_exposure() ? prepare() : FaultReason::kNone;
}

std::uint64_t Sequencer::deadline_us() const {
  switch (phase_) {
    case Phase::kIdle:
    case Phase::kPaused:
      return kNever;
    case Phase::kLoad:
    case Phase::kLoading:
    case Phase::kHeld:
      return run_deadline_us_;
    default:
      return earlier(phase_deadline_us_, run_deadline_us_);
  }
}

wire::SequenceState Sequencer::state() const {
  if (pause_wanted_) {
    return wire::SequenceState::kPausing;
  }
  switch (phase_) {
    case Phase::kIdle:
      return wire::SequenceState::kIdle;
    case Phase::kHeld:
      return wire::SequenceState::kHeld;
    case Phase::kPaused:
      return wire::SequenceState::kPaused;
    default:
      return wire::SequenceState::kRunning;
  }
}

bool Sequencer::take_event_lost() {
  const bool lost = event_lost_;
  event_lost_ = false;
  return lost;
}

void Sequencer::enter_step() {
  step_entered_us_ = hal_.now_us();
  phase_ = Phase::kLoad;
  phase_deadline_us_ = kNever;
}

// The glass holds the step's aperture: waits until the light is due.
void Sequencer::settle() {
  const std::uint64_t set_us = later(glass_written_us_, step_entered_us_);
  earliest_trigger_us_ = later(earliest_trigger_us_, set_us + step().settle_us);
  const std::uint64_t lead = earlier(run_.light_lead_us, earliest_trigger_us_);
  phase_deadline_us_ = earliest_trigger_us_ - lead;
  phase_ = Phase::kSettle;
}

// The light is due: only if the event has a place and the camera is ready.
FaultReason Sequencer::prepare() {
  ready_waited_ = false;
  if (!events_.room_for_exposure()) {
    phase_ = Phase::kHeld;
    return FaultReason::kNone;
  }
  if (run_.ready_timeout_ms != 0 && wired(wire::Capability::kReady) &&
      !hal_.input_level(Input::kReady)) {
    ready_waited_ = true;
    phase_ = Phase::kWaitReady;
    phase_deadline_us_ = hal_.now_us() + run_.ready_timeout_ms * kUsPerMs;
    return FaultReason::kNone;
  }
  return light_up();
}

FaultReason Sequencer::light_up() {
  if (!leds_.set(store_.light(step().light))) {
    return FaultReason::kCurrentBudget;
  }
  shown_.light = step().light;
  trigger_due_us_ = later(earliest_trigger_us_, hal_.now_us() + run_.light_lead_us);
  phase_deadline_us_ = trigger_due_us_;
  phase_ = Phase::kLead;
  // A lead of nothing: no second interrupt, the trigger is due now.
  return hal_.now_us() >= trigger_due_us_ ? trigger() : FaultReason::kNone;
}

FaultReason Sequencer::trigger() {
  strobe_seen_ = false;
  hal_.set_pin(Pin::kCameraTrigger, true);
  trigger_high_ = true;
  triggered_us_ = hal_.now_us();
  exposure_end_us_ = triggered_us_ + step().exposure_us + kLightTailUs;
  phase_ = Phase::kExpose;
  phase_deadline_us_ = earlier(triggered_us_ + run_.trigger_us, exposure_end_us_);
  return triggered_us_ - trigger_due_us_ > kTriggerLateUs ? FaultReason::kTriggerLate
                                                          : FaultReason::kNone;
}

// The pulse, the exposure or the strobe ended.
FaultReason Sequencer::expose() {
  const std::uint64_t now = hal_.now_us();
  const std::uint64_t pulse_end = triggered_us_ + run_.trigger_us;
  if (trigger_high_ && now >= pulse_end) {
    hal_.set_pin(Pin::kCameraTrigger, false);
    trigger_high_ = false;
  }
  std::uint64_t end = exposure_end_us_;
  if (wired(wire::Capability::kStrobe) && hal_.input_level(Input::kStrobe)) {
    strobe_seen_ = true;
    end += kStrobeSlackUs;
  }
  if (now >= end) {
    light_off();
    if (!trigger_high_) {
      return finish_exposure();
    }
    end = pulse_end;
  }
  phase_deadline_us_ = trigger_high_ ? earlier(pulse_end, end) : end;
  return FaultReason::kNone;
}

FaultReason Sequencer::finish_exposure() {
  if (run_.require_strobe && wired(wire::Capability::kStrobe) && !strobe_seen_) {
    return FaultReason::kCameraNoStrobe;
  }
  const wire::Step& now_step = step();
  wire::ExposureEvent event;
  event.table_hash = run_.table_hash;
  event.run_id = run_.run_id;
  event.index = exposures_;
  event.step = step_index_;
  event.repeat = repeat_;
  event.aperture = now_step.aperture;
  event.light = now_step.light;
  event.start_us = triggered_us_;
  const std::uint64_t waited = triggered_us_ - glass_written_us_;
  event.settle_waited_us = static_cast<std::uint32_t>(earlier(waited, UINT32_MAX));
  event.exposure_us = now_step.exposure_us;
  event.flags = static_cast<std::uint8_t>((strobe_seen_ ? wire::ExposureFlag::kStrobeSeen : 0) |
                                          (ready_waited_ ? wire::ExposureFlag::kReadyWaited : 0));
  event_lost_ = !events_.push(event) || event_lost_;
  ++exposures_;
  ++exposures_ever_;

  const bool step_done = repeat_ + 1 == now_step.repeat;
  if (step_done && step_index_ + 1 == store_.step_count()) {
    end(SequenceNews::kFinished);
    return FaultReason::kNone;
  }
  repeat_ = step_done ? 0 : static_cast<std::uint16_t>(repeat_ + 1);
  if (step_done) {
    ++step_index_;
  }
  const std::uint64_t gap_end = hal_.now_us() + run_.gap_us;
  earliest_trigger_us_ = gap_end + (repeat_ != 0 ? run_.light_lead_us : 0);
  if (pause_wanted_) {
    stand();
  } else {
    phase_ = Phase::kGap;
    phase_deadline_us_ = gap_end;
  }
  return FaultReason::kNone;
}

void Sequencer::stand() {
  light_off();
  pause_wanted_ = false;
  phase_ = Phase::kPaused;
  phase_deadline_us_ = kNever;
  paused_at_us_ = hal_.now_us();
  tell(SequenceNews::kPaused);
}

void Sequencer::end(SequenceNews news) {
  light_off();
  if (trigger_high_) {
    hal_.set_pin(Pin::kCameraTrigger, false);
    trigger_high_ = false;
  }
  pause_wanted_ = false;
  phase_ = Phase::kIdle;
  phase_deadline_us_ = kNever;
  run_deadline_us_ = kNever;
  tell(news);
}

void Sequencer::light_off() {
  leds_.off();
  shown_.light = kSlotNone;
}

void Sequencer::tell(SequenceNews news) {
  wire::SequenceEvent event;
  event.news = news;
  event.run_id = run_.run_id;
  event.table_hash = run_.table_hash;
  event.exposures = exposures_;
  event.at_us = hal_.now_us();
  event_lost_ = !events_.push(event) || event_lost_;
}

}  // namespace reliefscope
