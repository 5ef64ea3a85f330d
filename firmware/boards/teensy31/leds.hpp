// The LED drivers: shift register, latch, and a BLANK line that is high, so that everything is
// dark, from reset until levels were latched. Going dark is one write to a pin, from any context.
//
// TLC5940: the timer that makes BLANK pulses also bounds the pulses of light, and GSCLK comes from
// the same clock, so each period holds the same light. Exposures are whole periods (the core sees
// to it) and so all hold the same, wherever in a period they begin.
#pragma once

#include <cstddef>
#include <cstdint>

namespace teensy31 {

class LedChain {
 public:
  void begin();
  // Levels 0 to 4095; all zero blanks. About 100 us for 48 LEDs, during which it is dark.
  void set(const std::uint16_t* levels, std::size_t count);
  void blank();

 private:
  void unblank();
};

}  // namespace teensy31
