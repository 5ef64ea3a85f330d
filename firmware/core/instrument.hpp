// The parts together, and what keeps them safe without the host asking:
//
// - from reset, before anything else, the LEDs are off, and the glass shuts first;
// - no LED stays lit beyond its on-time (fault), no set of levels beyond the budget is taken;
// - outside a sequence the light goes off after 2 s without a valid frame (counted, no fault);
// - a sequence ends with a fault when it misses its own deadline;
// - the first fault is latched with its reason: light off, glass shut, sequence ended, and nothing
//   lights up or opens until the host clears it.
//
// Times are watched in the timer interrupt, so they hold while main is busy or stuck.
#pragma once

#include <cstdint>

#include "core/display.hpp"
#include "core/events.hpp"
#include "core/generated/protocol.hpp"
#include "core/hal.hpp"
#include "core/leds.hpp"
#include "core/sequencer.hpp"
#include "core/settings.hpp"
#include "core/store.hpp"

namespace reliefscope {

class Instrument {
 public:
  explicit Instrument(Hal& hal)
      : hal_(hal),
        settings_(hal),
        display_(hal),
        leds_(hal),
        sequencer_(hal, store_, display_, leds_, events_, shown_) {}

  void begin(wire::ResetCause cause);

  // Main: one piece of work; false: nothing to do now.
  bool poll();
  std::uint64_t next_wakeup_us() const;
  // Interrupt.
  void on_timer();
  void on_input(Input input, bool high);

  // A valid frame came in [main].
  void link_heard();

  // Requests, from main; the caller has checked slots and that no sequence is under way.
  void select_aperture(std::uint8_t slot);
  // CURRENT_BUDGET, or FAULT_LATCHED for anything but darkness while a fault is latched: the fault
  // may have come since the caller looked.
  wire::ErrorCode select_light(std::uint8_t slot);
  // FAULT_LATCHED likewise.
  wire::ErrorCode start(const wire::StartRequest& request);
  void pause();
  void resume();
  void abort(bool shut);
  void clear_fault(wire::FaultReason reason);
  bool acknowledge_events(std::uint32_t next_event, bool resend);
  bool take_event(Event& event, std::uint32_t& number);
  bool event_pending();
  bool set_settings(const wire::GetSettingsReply& values);
  bool set_led_correction(const wire::GetLedCorrectionReply& values);

  const Settings& settings() const { return settings_; }
  Store& store() { return store_; }
  const Leds& leds() const { return leds_; }
  const EventQueue& events() const { return events_; }
  const Sequencer& sequencer() const { return sequencer_; }
  const Shown& shown() const { return shown_; }
  wire::FaultReason fault() const { return fault_; }
  std::uint32_t faults() const { return faults_; }
  std::uint32_t link_timeouts() const { return link_timeouts_; }
  std::int16_t temperature_centi();

 private:
  DisplayConfig display_config() const;
  // Under the lock or in an interrupt:
  void latch(wire::FaultReason reason, std::uint32_t detail);
  void after(wire::FaultReason reason);
  void arm();
  bool take_shut_wanted();
  bool check_temperature();

  Hal& hal_;
  Settings settings_;
  Store store_;
  EventQueue events_;
  Shown shown_;
  Display display_;
  Leds leds_;
  Sequencer sequencer_;

  wire::FaultReason fault_ = wire::FaultReason::kNone;
  bool shut_wanted_ = false;  // by a fault; main does it first
  std::uint32_t faults_ = 0;
  std::uint32_t link_timeouts_ = 0;
  std::uint64_t link_heard_us_ = 0;
  std::uint64_t armed_us_ = kNever;
  std::uint64_t temperature_due_us_ = 0;
};

}  // namespace reliefscope
