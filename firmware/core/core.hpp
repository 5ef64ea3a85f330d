// The whole firmware above the HAL: a port owns one Core and calls its four functions.
//
//   core.begin(cause, nonce);        once after reset, with interrupts still masked
//   for (;;) { core.poll(); }        main; may sleep until an interrupt when poll() was false
//   core.on_timer();                 interrupt: the time given to Hal::arm_timer() has come
//   core.on_input(input, high);      interrupt: a camera line changed
#pragma once

#include <cstdint>

#include "core/commands.hpp"
#include "core/hal.hpp"
#include "core/instrument.hpp"
#include "core/link.hpp"
#include "core/link_state.hpp"

namespace reliefscope {

class Core {
 public:
  explicit Core(Hal& hal)
      : hal_(hal),
        instrument_(hal),
        commands_(hal, instrument_, link_state_),
        link_(hal, instrument_, commands_, link_state_) {}

  // boot_nonce differs from boot to boot and is not 0.
  void begin(wire::ResetCause cause, std::uint32_t boot_nonce) {
    link_state_.boot_nonce = boot_nonce;
    link_state_.reset_cause = cause;
    link_state_.started_us = hal_.now_us();
    instrument_.begin(cause);
  }

  // A turn of the main loop; false: nothing to do before an interrupt, a received byte, the end of
  // an SPI chunk, or next_wakeup_us().
  bool poll() {
    if (hal_.now_us() >= link_state_.bootloader_at_us) {
      link_state_.bootloader_at_us = kNever;
      hal_.reboot_to_bootloader();
      return true;
    }
    const bool worked = instrument_.poll();
    return link_.poll() || worked;
  }

  std::uint64_t next_wakeup_us() const {
    const std::uint64_t wakeup = instrument_.next_wakeup_us();
    return wakeup < link_state_.bootloader_at_us ? wakeup : link_state_.bootloader_at_us;
  }

  // A sequence runs or is paused [main].
  bool sequence_active() const { return instrument_.sequencer().active(); }

  void on_timer() { instrument_.on_timer(); }
  void on_input(Input input, bool high) { instrument_.on_input(input, high); }

 private:
  Hal& hal_;
  LinkState link_state_;
  Instrument instrument_;
  Commands commands_;
  Link link_;
};

// Of the 48 KB of static RAM that the firmware may take, the rest is the port's.
static_assert(sizeof(Core) <= 40 * 1024, "the core outgrew its share of RAM");

}  // namespace reliefscope
