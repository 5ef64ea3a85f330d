// Driver of the aperture glass: EA DOGM128-6, controller ST7565R, 128 x 64 pixels, write-only SPI.
//
// A bitmap is 1,024 bytes in page order (page p, column c: byte p * 128 + c, bit b is row 8 p + b,
// row 0 on top), bit 1 = open. The driver owns a copy, so whoever called show() may overwrite its
// own. The controller's normal/inverse command makes RAM bit 1 mean "open" on both kinds of glass:
// normal on glass that is dark when off, inverse on glass that is clear when off.
//
// Shut is the state after reset and the first command on the bus, and shut() puts that command
// before anything else. It is one command: all points on where driven pixels are dark, display off
// where undriven pixels are dark. The RAM is then closed and normal drive resumes, so that closed
// pixels see the same voltages, and leak as much, as in every other view.
//
// Nothing waits: poll() hands at most one SPI chunk to the port. All functions run in main.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/hal.hpp"

namespace reliefscope {

constexpr std::size_t kGlassColumns = 128;
constexpr std::size_t kGlassPages = 8;
constexpr std::size_t kBitmapBytes = kGlassColumns * kGlassPages;

struct DisplayConfig {
  bool dark_when_off;           // FSTN negative ("S"); false: STN positive ("E"), clear when off
  bool top_view;                // mounted turned by 180 degrees: A0 C8, columns start at 4
  std::uint8_t contrast;        // electronic volume, 0 to 63
  std::uint8_t resistor_ratio;  // coarse contrast, 0 to 7
};

class Display {
 public:
  explicit Display(Hal& hal) : hal_(hal) {}

  // Starts the hardware reset; the glass shuts and stays shut until show().
  void begin(const DisplayConfig& config);
  // New settings: shuts, sends them, then shows the same bitmap again.
  void configure(const DisplayConfig& config);
  // Shows a copy of 1,024 bytes; nullptr shuts. A call before idle() replaces the one before.
  void show(const std::uint8_t* bitmap);
  void shut() { show(nullptr); }

  // The controller holds what was asked for, and its last byte has left.
  bool idle() const { return phase_ == Phase::kIdle; }
  // When that was; meaningful while idle().
  std::uint64_t idle_since_us() const { return idle_since_us_; }

  // Does at most one piece of work; false: nothing to do now.
  bool poll();
  // When poll() has work again without an SPI chunk having ended.
  std::uint64_t next_wakeup_us() const;

 private:
  enum class Phase : std::uint8_t {
    kOff,
    kResetLow,
    kResetHigh,
    kShut,
    kInit,
    kPageAddress,
    kPageData,
    kRelease,
    kFinish,
    kIdle
  };

  void enter(Phase phase) { phase_ = phase; }
  void send_commands(const std::uint8_t* bytes, std::size_t count);
  bool in_reset() const { return phase_ <= Phase::kResetHigh; }

  Hal& hal_;
  DisplayConfig config_{};
  Phase phase_ = Phase::kOff;
  bool initialised_ = false;
  bool selected_ = false;
  std::uint8_t page_ = 0;
  std::uint8_t column_ = 0;
  std::uint64_t deadline_us_ = 0;
  std::uint64_t idle_since_us_ = 0;
  std::uint8_t bitmap_[kBitmapBytes] = {};
};

}  // namespace reliefscope
