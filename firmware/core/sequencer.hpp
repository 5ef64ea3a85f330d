// Steps through the table by itself: glass, settle, light, trigger pulse, exposure, gap, repeat.
//
// Everything with a time runs in the timer interrupt; only the glass is written from main, because
// SPI goes out in chunks. One exposure:
//
//   glass written | settle ........................ | exposure ........ | tail | gap | next
//   light                              | lead ..... |xxxxxxxxxxxxxxxxxxxxxxxxx|
//   trigger                                         |pulse|
//
// The light is a constant current from light_lead_us before the trigger until the exposure has
// ended, plus a tail for the camera's own trigger delay, plus the rest of the strobe where that is
// wired; between exposures it is dark. An exposure starts only when the event queue has room for
// its event (else the sequence is held, dark) and the camera is ready (where wired and asked for).
//
// Pause lets the exposure under way end, and otherwise holds at once; after it the glass is written
// and settled again. A sequence that misses a deadline, or its camera, ends with a fault, which the
// functions return and the caller latches.
//
// poll() runs in main; all other functions under the interrupt lock or in an interrupt.
#pragma once

#include <cstdint>

#include "core/display.hpp"
#include "core/events.hpp"
#include "core/generated/protocol.hpp"
#include "core/hal.hpp"
#include "core/leds.hpp"
#include "core/store.hpp"

namespace reliefscope {

// Slots whose content the glass and the LEDs show.
struct Shown {
  std::uint8_t aperture = kSlotNone;
  std::uint8_t light = kSlotNone;
};

class Sequencer {
 public:
  // Time that the light stays on after an exposure, for the camera's delay after its trigger.
  static constexpr std::uint32_t kLightTailUs = 100;
  // How much longer the strobe may keep the light on; a line stuck high cannot.
  static constexpr std::uint32_t kStrobeSlackUs = 20000;
  // Longest time that the light stays on after an exposure.
  static constexpr std::uint32_t kAfterExposureUs = kLightTailUs + kStrobeSlackUs;
  // A trigger later than this is a fault.
  static constexpr std::uint32_t kTriggerLateUs = 1000;

  Sequencer(Hal& hal, const Store& store, Display& display, Leds& leds, EventQueue& events,
            Shown& shown)
      : hal_(hal), store_(store), display_(display), leds_(leds), events_(events), shown_(shown) {}

  // Starts the committed table; the caller has checked that there is one and nothing is under way.
  void start(const wire::StartRequest& request);
  void pause();
  void resume();
  // Ends at once: trigger line low, light off. The glass is the caller's.
  void abort();

  // Writes the glass when a step wants it.
  bool poll();
  wire::FaultReason on_timer();
  wire::FaultReason on_input(Input input, bool high);
  // Events were acknowledged: a held sequence may go on.
  wire::FaultReason on_event_room();
  // When on_timer() is wanted.
  std::uint64_t deadline_us() const;

  wire::SequenceState state() const;
  bool active() const { return phase_ != Phase::kIdle; }
  std::uint32_t run_id() const { return run_.run_id; }
  std::uint16_t step_index() const { return step_index_; }
  std::uint32_t exposures() const { return exposures_; }
  // Exposures of all runs since the start.
  std::uint32_t exposures_ever() const { return exposures_ever_; }
  // True once after an event found no room.
  bool take_event_lost();

 private:
  enum class Phase : std::uint8_t {
    kIdle,
    kLoad,       // main: hand the bitmap to the display
    kLoading,    // main: the display works
    kSettle,     // until the light is due
    kHeld,       // until the event queue has room
    kWaitReady,  // until the camera is ready
    kLead,       // light on, until the trigger
    kExpose,
    kGap,
    kPaused
  };

  const wire::Step& step() const { return store_.step(step_index_); }
  bool wired(std::uint32_t capability) const {
    return (hal_.info().capabilities & capability) != 0;
  }
  wire::FaultReason prepare();
  wire::FaultReason light_up();
  wire::FaultReason trigger();
  wire::FaultReason expose();
  wire::FaultReason finish_exposure();
  void enter_step();
  void settle();
  void stand();
  void end(wire::SequenceNews news);
  void light_off();
  void tell(wire::SequenceNews news);

  Hal& hal_;
  const Store& store_;
  Display& display_;
  Leds& leds_;
  EventQueue& events_;
  Shown& shown_;

  wire::StartRequest run_;
  Phase phase_ = Phase::kIdle;
  bool pause_wanted_ = false;
  bool glass_stale_ = false;  // the step's aperture must be written even if its slot is shown
  bool strobe_seen_ = false;
  bool ready_waited_ = false;
  bool trigger_high_ = false;
  bool event_lost_ = false;
  std::uint16_t step_index_ = 0;
  std::uint16_t repeat_ = 0;
  std::uint32_t exposures_ = 0;
  std::uint32_t exposures_ever_ = 0;
  std::uint64_t phase_deadline_us_ = kNever;
  std::uint64_t run_deadline_us_ = kNever;
  std::uint64_t paused_at_us_ = 0;
  std::uint64_t glass_written_us_ = 0;
  std::uint64_t step_entered_us_ = 0;
  std::uint64_t earliest_trigger_us_ = 0;  // settle and gap are over
  std::uint64_t trigger_due_us_ = 0;
  std::uint64_t triggered_us_ = 0;
  std::uint64_t exposure_end_us_ = 0;
};

}  // namespace reliefscope
