#include "boards/teensy31/leds.hpp"

#include <Arduino.h>

#include "boards/teensy31/board.hpp"

namespace teensy31 {
namespace {

constexpr bool kGray = kLedDriver == LedDriver::kTlc5940Chain;
constexpr unsigned kBitsPerLed = kGray ? 12 : 1;
constexpr std::uint32_t kUsPerSecond = 1000000;
// Of 65,536 parts of a period: 0.5 us of BLANK.
constexpr int kBlankPulse = 65536 / 2 / kLedPeriodUs;
constexpr std::uint16_t kFull = 4095;

}  // namespace

void LedChain::begin() {
  blank();
  pinMode(kLedData, OUTPUT);
  pinMode(kLedClock, OUTPUT);
  pinMode(kLedLatch, OUTPUT);
  digitalWriteFast(kLedClock, LOW);
  digitalWriteFast(kLedLatch, LOW);
  if (kGray) {
    analogWriteResolution(2);
    analogWriteFrequency(kLedGrayClock, kGrayClockHz);
    analogWrite(kLedGrayClock, 2);
    analogWriteResolution(16);
    analogWriteFrequency(kLedBlank, kUsPerSecond / kLedPeriodUs);
  }
}

void LedChain::set(const std::uint16_t* levels, std::size_t count) {
  blank();
  bool lit = false;
  for (std::size_t i = 0; i < count; ++i) {
    lit = lit || levels[i] != 0;
  }
  if (!lit) {
    return;
  }
  // The last LED of the last chip goes first, its highest bit ahead.
  for (std::size_t led = kLeds; led-- > 0;) {
    const std::uint16_t level = led < count ? levels[led] : 0;
    const std::uint16_t bits = kGray ? level : static_cast<std::uint16_t>(level == kFull ? 1 : 0);
    for (unsigned bit = kBitsPerLed; bit-- > 0;) {
      digitalWriteFast(kLedData, (bits >> bit) & 1u);
      digitalWriteFast(kLedClock, HIGH);
      digitalWriteFast(kLedClock, LOW);
    }
  }
  digitalWriteFast(kLedLatch, HIGH);
  digitalWriteFast(kLedLatch, LOW);
  unblank();
}

// The pin leaves the timer at the second line; the level is there before.
void LedChain::blank() {
  digitalWriteFast(kLedBlank, HIGH);
  pinMode(kLedBlank, OUTPUT);
  digitalWriteFast(kLedBlank, HIGH);
}

void LedChain::unblank() {
  if (kGray) {
    analogWrite(kLedBlank, kBlankPulse);
  } else {
    digitalWriteFast(kLedBlank, LOW);
  }
}

}  // namespace teensy31
