// The hardware that the core needs, and nothing else.
//
// An abstract class, not a template parameter: the core is compiled once and linked unchanged to
// every board and to the unit tests, a port cannot reach into it, and an indirect call costs some
// six cycles on a Cortex-M4, which is nothing beside SPI and USB. Ports are static objects; no
// RTTI, no heap, and the destructor is protected because nobody destroys a board.
//
// Contexts. "Main" is the loop that calls Core::poll(). "Interrupt" is the context in which the
// port calls Core::on_timer() and Core::on_input(); the two never interrupt each other. Functions
// marked [any] are called from both and must be short; the others are called from main only.
#pragma once

#include <cstddef>
#include <cstdint>

namespace reliefscope {

enum class Pin : std::uint8_t { kLcdReset = 0, kLcdSelect = 1, kCameraTrigger = 2 };
enum class Input : std::uint8_t { kStrobe = 0, kReady = 1 };

constexpr std::size_t kMaxLeds = 48;
// Longest SPI chunk: 64 bytes are 128 us at 4 MHz, well below the 1 ms in which a shut command
// must get onto the bus.
constexpr std::size_t kSpiChunk = 64;
constexpr std::uint64_t kNever = UINT64_MAX;

// What a port knows about itself; constant while the program runs.
struct BoardInfo {
  const char* name;              // at most 16 ASCII characters
  std::uint32_t capabilities;    // bits of Capability of protocol.yml
  std::uint8_t led_count;        // at most kMaxLeds
  std::uint32_t level_budget;    // largest sum of the levels of all LEDs
  std::uint32_t led_on_time_us;  // longest time that a LED may be lit without a break
  std::uint16_t reset_ms;        // from reset until the port answers
  // Drivers that dim by pulses: their period, of which lit exposures are whole multiples, so that
  // nothing beats. 0: constant currents.
  std::uint32_t led_period_us;
  std::uint16_t led_level_step;  // levels are multiples of it: 1, or 4095 for drivers on or off
};

class Hal {
 public:
  virtual const BoardInfo& info() const = 0;

  // Time since power-on, never going back [any].
  virtual std::uint64_t now_us() = 0;
  // One-shot: Core::on_timer() runs at at_us, at once if that is past. Replaces the last one;
  // kNever cancels [any].
  virtual void arm_timer(std::uint64_t at_us) = 0;

  // Starts to send 1 to kSpiChunk bytes with A0 at a0_high (false: command, true: data). The port
  // copies them; the caller has seen spi_busy() false and has selected the chip.
  virtual void spi_start(bool a0_high, const std::uint8_t* bytes, std::size_t count) = 0;
  virtual bool spi_busy() = 0;

  virtual void set_pin(Pin pin, bool high) = 0;  // [any]
  virtual bool input_level(Input input) = 0;     // [any]

  // Mean currents of all LEDs, 0 to 4095 each, constant or in pulses of info().led_period_us;
  // effective on return [any].
  virtual void set_leds(const std::uint16_t* levels, std::size_t count) = 0;

  // Bytes received and not yet read; bytes accepted for sending. Neither waits.
  virtual std::size_t serial_read(std::uint8_t* bytes, std::size_t capacity) = 0;
  virtual std::size_t serial_write(const std::uint8_t* bytes, std::size_t count) = 0;

  virtual std::uint8_t nonvolatile_read(std::size_t address) = 0;
  virtual void nonvolatile_write(std::size_t address, std::uint8_t value) = 0;

  // Hundredths of a degree Celsius; called only with Capability TEMPERATURE.
  virtual std::int16_t temperature_centi() = 0;

  virtual void kick_watchdog() = 0;
  // Returns on boards without a bootloader.
  virtual void reboot_to_bootloader() = 0;

  // Masks the interrupts that call the core; nests through the returned value. Both must be
  // compiler barriers [any].
  virtual std::uint32_t lock_interrupts() = 0;
  virtual void restore_interrupts(std::uint32_t state) = 0;

 protected:
  ~Hal() = default;
};

// Keeps Core::on_timer() and Core::on_input() out while it lives.
class InterruptLock {
 public:
  explicit InterruptLock(Hal& hal) : hal_(hal), state_(hal.lock_interrupts()) {}
  ~InterruptLock() { hal_.restore_interrupts(state_); }
  InterruptLock(const InterruptLock&) = delete;
  InterruptLock& operator=(const InterruptLock&) = delete;

 private:
  Hal& hal_;
  std::uint32_t state_;
};

}  // namespace reliefscope
