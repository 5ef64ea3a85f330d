// The constellation of LEDs: the only way to light one, and so the place of its limits.
//
// Levels are currents, 0 to 4095 of full scale: constant, or pulsed with a period of which every
// exposure is a whole multiple, so that nothing can beat with it. What reaches the drivers is the
// level times the LED's correction, which can only lower it. A set of levels beyond the current
// budget is refused whole; a LED lit longer than the limit is reported by overdue(), and the caller
// turns everything off.
// All functions run under the interrupt lock or in an interrupt.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/hal.hpp"

namespace reliefscope {

constexpr std::uint16_t kLedLevelMax = 4095;

class Leds {
 public:
  explicit Leds(Hal& hal) : hal_(hal) { std::memset(factors_, 0xFF, sizeof factors_); }

  // Everything off, whatever the drivers showed before; the first thing after reset.
  void begin();

  // Sum of info().led_count levels: what the current budget limits.
  std::uint32_t level_sum(const std::uint16_t* levels) const;

  // Factors of all LEDs (see correction in protocol.yml), from the next set() on.
  void correct(const std::uint8_t* factors);

  // Sets all LEDs (info().led_count levels); false, and nothing changed, beyond the budget.
  bool set(const std::uint16_t* levels);
  void off();

  bool lit() const { return lit_; }
  std::uint32_t level_sum() const { return level_sum(levels_); }
  // When a LED will have been lit for too long; kNever while dark.
  std::uint64_t deadline_us() const { return deadline_us_; }
  bool overdue() const { return lit_ && hal_.now_us() >= deadline_us_; }

 private:
  Hal& hal_;
  bool lit_ = false;
  std::uint64_t deadline_us_ = kNever;
  std::uint16_t levels_[kMaxLeds] = {};
  std::uint8_t factors_[kMaxLeds];
  std::uint64_t lit_since_us_[kMaxLeds] = {};
};

}  // namespace reliefscope
