// Wiring of the Teensy 3.2 and the limits of its LEDs: the one place to change either. The tables
// of docs/hardware.md are made from this file by tools/hardware_tables.py; what follows a constant
// is the text of its row.
#pragma once

#include <cstdint>

namespace teensy31 {

// Pins.
constexpr std::uint8_t kLcdData = 11;    // glass SI (SPI MOSI)
constexpr std::uint8_t kLcdClock = 13;   // glass SCL (SPI SCK)
constexpr std::uint8_t kLcdSelect = 10;  // glass CS1B, with 10 kOhm to 3.3 V
constexpr std::uint8_t kLcdA0 = 9;       // glass A0
constexpr std::uint8_t kLcdReset = 14;   // glass RESB, with 10 kOhm to ground
constexpr std::uint8_t kLedData = 17;    // first driver's SIN
constexpr std::uint8_t kLedClock = 16;   // all drivers' SCLK
constexpr std::uint8_t kLedLatch = 15;   // all drivers' XLAT
constexpr std::uint8_t kLedBlank = 20;   // all drivers' BLANK, with 10 kOhm to 3.3 V: dark in reset
constexpr std::uint8_t kLedGrayClock = 3;    // all drivers' GSCLK
constexpr std::uint8_t kCameraTrigger = 21;  // camera trigger in, 3.3 V, rising edge
constexpr std::uint8_t kCameraStrobe =
    7;  // camera strobe out, high while it exposes, with 10 kOhm to ground
constexpr std::uint8_t kCameraReady =
    8;  // camera ready out, high when it takes a trigger, with 10 kOhm to 3.3 V

// LEDs.
enum class LedDriver : std::uint8_t {
  kTlc5940Chain,   // constant-current sinks, 16 a chip, 4,096 levels in pulses of kLedPeriodUs
  kTransistorBank  // one transistor and resistor an LED on a chain of 74HC595: on or off
};
constexpr LedDriver kLedDriver = LedDriver::kTlc5940Chain;
constexpr std::uint8_t kLeds = 48;              // LED lines: 3 chips of 16
constexpr std::uint32_t kLedMilliamperes = 20;  // mA of one LED at full level
constexpr std::uint32_t kBudgetMilliamperes =
    400;                                          // mA of all LEDs together, from a USB port of 500
constexpr std::uint32_t kLedOnTimeUs = 10000000;  // us that one LED may be lit without a break
// 9 MHz are a quarter of the bus clock; 4,096 of its periods (455.1 us) end within one of 500 us.
constexpr std::uint32_t kGrayClockHz = 9000000;  // Hz of GSCLK
constexpr std::uint32_t kLedPeriodUs = 500;      // us from one BLANK pulse to the next

// Glass.
constexpr std::uint32_t kLcdClockHz = 4000000;  // Hz of the SPI clock

constexpr std::uint32_t kWatchdogMs = 1000;  // ms without a turn of the main loop before a reset
constexpr std::uint16_t kResetMs = 1500;     // ms from reset until USB answers

}  // namespace teensy31
