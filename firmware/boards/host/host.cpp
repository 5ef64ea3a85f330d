// The core on a PC, in virtual time: code takes no time, SPI takes its clock's, and time passes
// only in rs_run_until(). The hardware around it is the trace.
#include <cstring>
#include <deque>
#include <new>
#include <optional>
#include <vector>

#include "boards/host/reliefscope_host.h"
#include "core/core.hpp"

namespace {

using reliefscope::BoardInfo;
using reliefscope::Core;
using reliefscope::Input;
using reliefscope::kNever;
using reliefscope::Pin;
namespace wire = reliefscope::wire;

constexpr std::size_t kNonvolatileSize = 2048;  // the Teensy 3.2's
// Room of a USB serial port's buffers on both sides together.
constexpr std::size_t kSerialCapacity = 4096;
constexpr std::size_t kTraceCapacity = std::size_t{1} << 22;
constexpr std::uint64_t kSpiByteUs = 2;  // 4 MHz
constexpr std::size_t kInputs = 2;
constexpr std::size_t kPins = 3;

enum class Trace : std::uint8_t {
  kSpi = 1,
  kPin = 2,
  kLed = 3,
  kNonvolatile = 4,
  kBootloader = 5,
  kOverflow = 6
};

// LEDs at 20 mA full scale, and 400 mA for all of them from a USB port.
constexpr std::uint32_t kLevelBudget = 400 / 20 * 4095;
constexpr BoardInfo kInfo = {
    "host",
    wire::Capability::kStrobe | wire::Capability::kReady | wire::Capability::kBootloader,
    wire::kLeds,
    kLevelBudget,
    60 * 1000 * 1000,
    10,
    0,
    1};

class HostBoard final : public reliefscope::Hal {
 public:
  HostBoard(const std::uint8_t* nonvolatile, std::size_t size)
      : nonvolatile_(kNonvolatileSize, 0xFF) {
    if (nonvolatile != nullptr) {
      std::memcpy(nonvolatile_.data(), nonvolatile,
                  size < kNonvolatileSize ? size : kNonvolatileSize);
    }
  }

  void reset(std::uint32_t cause, std::uint32_t nonce) {
    core_.reset();
    timer_us_ = kNever;
    spi_busy_until_us_ = 0;
    serial_in_.clear();
    serial_out_.clear();
    // What the board's resistors do: LED drivers blanked, glass deselected, no trigger.
    const std::uint16_t dark[wire::kLeds] = {};
    set_leds(dark, wire::kLeds);
    set_pin(Pin::kCameraTrigger, false);
    set_pin(Pin::kLcdSelect, true);
    auto reason = static_cast<wire::ResetCause>(cause);
    if (cause > UINT8_MAX || !wire::is_valid(reason)) {
      reason = wire::ResetCause::kUnknown;
    }
    core_.emplace(*this);
    core_->begin(reason, nonce == 0 ? 1 : nonce);
    main_due_ = true;
  }

  void run_until(std::uint64_t time_us) {
    for (;;) {
      run_now();
      std::uint64_t next = next_wakeup_us();
      // A turn of the main loop that led to nothing takes a moment.
      next = next > now_us_ ? next : now_us_ + 1;
      if (next > time_us) {
        break;
      }
      now_us_ = next;
    }
    now_us_ = time_us > now_us_ ? time_us : now_us_;
  }

  std::uint64_t next_wakeup_us() const {
    if (!core_) {
      return kNever;
    }
    if (main_due_) {
      return now_us_;
    }
    std::uint64_t next = core_->next_wakeup_us();
    next = timer_us_ < next ? timer_us_ : next;
    if (spi_busy_until_us_ > now_us_ && spi_busy_until_us_ < next) {
      next = spi_busy_until_us_;
    }
    return next > now_us_ ? next : now_us_;
  }

  std::size_t receive(const std::uint8_t* bytes, std::size_t count) {
    const std::size_t room = kSerialCapacity - serial_in_.size();
    count = count < room ? count : room;
    serial_in_.insert(serial_in_.end(), bytes, bytes + count);
    main_due_ = main_due_ || count != 0;
    return count;
  }

  std::size_t transmit(std::uint8_t* bytes, std::size_t capacity) {
    const std::size_t count = take(serial_out_, bytes, capacity);
    main_due_ = main_due_ || count != 0;
    return count;
  }

  void set_input(std::size_t input, bool level) {
    if (input >= kInputs || inputs_[input] == level) {
      return;
    }
    inputs_[input] = level;
    if (core_) {
      core_->on_input(static_cast<Input>(input), level);
      main_due_ = true;
    }
  }

  std::size_t read_trace(std::uint8_t* bytes, std::size_t capacity) {
    std::size_t size = 0;
    while (!record_sizes_.empty() && size + record_sizes_.front() <= capacity) {
      size += take(trace_, bytes + size, record_sizes_.front());
      record_sizes_.pop_front();
      overflown_ = false;
    }
    return size;
  }

  std::size_t read_nonvolatile(std::uint8_t* bytes, std::size_t capacity) const {
    const std::size_t count = capacity < kNonvolatileSize ? capacity : kNonvolatileSize;
    std::memcpy(bytes, nonvolatile_.data(), count);
    return count;
  }

  // Hal
  const BoardInfo& info() const override { return kInfo; }
  std::uint64_t now_us() override { return now_us_; }
  void arm_timer(std::uint64_t at_us) override { timer_us_ = at_us; }

  void spi_start(bool a0_high, const std::uint8_t* bytes, std::size_t count) override {
    spi_busy_until_us_ = now_us_ + count * kSpiByteUs;
    record(Trace::kSpi, a0_high ? 1 : 0, bytes, count);
  }
  bool spi_busy() override { return now_us_ < spi_busy_until_us_; }

  void set_pin(Pin pin, bool high) override {
    const auto index = static_cast<std::uint8_t>(pin);
    if (pins_[index] != high) {
      pins_[index] = high;
      const std::uint8_t level = high ? 1 : 0;
      record(Trace::kPin, index, &level, 1);
    }
  }
  bool input_level(Input input) override { return inputs_[static_cast<std::size_t>(input)]; }

  void set_leds(const std::uint16_t* levels, std::size_t count) override {
    for (std::size_t i = 0; i < count; ++i) {
      if (leds_[i] != levels[i]) {
        leds_[i] = levels[i];
        const std::uint8_t payload[] = {static_cast<std::uint8_t>(levels[i]),
                                        static_cast<std::uint8_t>(levels[i] >> 8)};
        record(Trace::kLed, static_cast<std::uint8_t>(i), payload, sizeof payload);
      }
    }
  }

  std::size_t serial_read(std::uint8_t* bytes, std::size_t capacity) override {
    return take(serial_in_, bytes, capacity);
  }
  std::size_t serial_write(const std::uint8_t* bytes, std::size_t count) override {
    const std::size_t room = kSerialCapacity - serial_out_.size();
    count = count < room ? count : room;
    serial_out_.insert(serial_out_.end(), bytes, bytes + count);
    return count;
  }

  std::uint8_t nonvolatile_read(std::size_t address) override {
    return address < kNonvolatileSize ? nonvolatile_[address] : 0xFF;
  }
  void nonvolatile_write(std::size_t address, std::uint8_t value) override {
    if (address < kNonvolatileSize) {
      nonvolatile_[address] = value;
      const std::uint8_t payload[] = {static_cast<std::uint8_t>(address),
                                      static_cast<std::uint8_t>(address >> 8), value};
      record(Trace::kNonvolatile, 0, payload, sizeof payload);
    }
  }

  std::int16_t temperature_centi() override {
    return static_cast<std::int16_t>(wire::kTemperatureUnknown);
  }
  void kick_watchdog() override {}
  void reboot_to_bootloader() override {
    record(Trace::kBootloader, 0, nullptr, 0);
    in_bootloader_ = true;
  }

  // Interrupts come only between the calls of this class.
  std::uint32_t lock_interrupts() override { return 0; }
  void restore_interrupts(std::uint32_t) override {}

 private:
  // Everything that can be done at this moment.
  void run_now() {
    main_due_ = false;
    while (core_) {
      if (timer_us_ <= now_us_) {
        timer_us_ = kNever;
        core_->on_timer();
        continue;
      }
      const bool worked = core_->poll();
      if (in_bootloader_) {
        in_bootloader_ = false;
        core_.reset();
        const std::uint16_t dark[wire::kLeds] = {};
        set_leds(dark, wire::kLeds);
        set_pin(Pin::kCameraTrigger, false);
        set_pin(Pin::kLcdSelect, true);
        break;
      }
      if (!worked && timer_us_ > now_us_) {
        break;
      }
    }
  }

  static std::size_t take(std::deque<std::uint8_t>& from, std::uint8_t* bytes,
                          std::size_t capacity) {
    const std::size_t count = capacity < from.size() ? capacity : from.size();
    for (std::size_t i = 0; i < count; ++i) {
      bytes[i] = from[i];
    }
    from.erase(from.begin(), from.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }

  void record(Trace kind, std::uint8_t arg, const std::uint8_t* payload, std::size_t size) {
    constexpr std::size_t kHead = 12;
    if (overflown_) {
      return;
    }
    if (trace_.size() + 2 * kHead + size > kTraceCapacity) {
      overflown_ = true;
      kind = Trace::kOverflow;
      size = 0;
    }
    std::uint8_t head[kHead] = {static_cast<std::uint8_t>(kind), arg,
                                static_cast<std::uint8_t>(size),
                                static_cast<std::uint8_t>(size >> 8)};
    for (unsigned i = 0; i < 8; ++i) {
      head[4 + i] = static_cast<std::uint8_t>(now_us_ >> (8 * i));
    }
    trace_.insert(trace_.end(), head, head + kHead);
    trace_.insert(trace_.end(), payload, payload + size);
    record_sizes_.push_back(kHead + size);
  }

  std::uint64_t now_us_ = 0;
  std::uint64_t timer_us_ = kNever;
  std::uint64_t spi_busy_until_us_ = 0;
  bool main_due_ = false;  // the main loop has not run since something changed
  bool in_bootloader_ = false;
  bool overflown_ = false;
  bool inputs_[kInputs] = {};
  bool pins_[kPins] = {false, true, false};
  std::uint16_t leds_[wire::kLeds] = {};
  std::vector<std::uint8_t> nonvolatile_;
  std::deque<std::uint8_t> serial_in_;
  std::deque<std::uint8_t> serial_out_;
  std::deque<std::uint8_t> trace_;
  std::deque<std::size_t> record_sizes_;
  std::optional<Core> core_;
};

}  // namespace

struct rs_device {
  HostBoard board;
};

extern "C" {

rs_device* rs_create(const uint8_t* nonvolatile, size_t size, uint32_t boot_nonce) {
  auto* device = new (std::nothrow) rs_device{HostBoard(nonvolatile, size)};
  if (device != nullptr) {
    device->board.reset(static_cast<std::uint32_t>(wire::ResetCause::kPowerOn), boot_nonce);
  }
  return device;
}

void rs_destroy(rs_device* device) {
  delete device;
}

void rs_reset(rs_device* device, uint32_t cause, uint32_t boot_nonce) {
  device->board.reset(cause, boot_nonce);
}

size_t rs_serial_in(rs_device* device, const uint8_t* bytes, size_t n) {
  return device->board.receive(bytes, n);
}

size_t rs_serial_out(rs_device* device, uint8_t* buffer, size_t capacity) {
  return device->board.transmit(buffer, capacity);
}

void rs_run_until(rs_device* device, uint64_t time_us) {
  device->board.run_until(time_us);
}

uint64_t rs_next_wakeup_us(rs_device* device) {
  return device->board.next_wakeup_us();
}

void rs_set_input(rs_device* device, uint32_t input, uint32_t level) {
  device->board.set_input(input, level != 0);
}

size_t rs_trace_read(rs_device* device, uint8_t* buffer, size_t capacity) {
  return device->board.read_trace(buffer, capacity);
}

size_t rs_nonvolatile_read(rs_device* device, uint8_t* buffer, size_t capacity) {
  return device->board.read_nonvolatile(buffer, capacity);
}

}  // extern "C"
