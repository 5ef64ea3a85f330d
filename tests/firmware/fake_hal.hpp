// A board in virtual time for the tests: records what the core does to SPI, pins and LEDs, and can
// be made late, full or forgetful. No heap.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/generated/protocol.hpp"
#include "core/hal.hpp"

namespace fake {

using reliefscope::BoardInfo;
using reliefscope::Input;
using reliefscope::kMaxLeds;
using reliefscope::kNever;
using reliefscope::Pin;
namespace wire = reliefscope::wire;

struct SpiRecord {
  std::uint64_t at_us;
  bool data;
  bool selected;
  std::uint8_t count;
  std::uint8_t bytes[reliefscope::kSpiChunk];
};

struct Edge {
  std::uint64_t at_us;
  Pin pin;
  bool high;
};

struct LedChange {
  std::uint64_t at_us;
  std::uint32_t sum;
};

// Keeps the first N; counts all.
template <class T, std::size_t N>
class Log {
 public:
  void add(const T& item) {
    if (size_ < N) {
      items_[size_] = item;
    }
    ++size_;
  }
  void clear() { size_ = 0; }
  std::size_t size() const { return size_; }
  const T& operator[](std::size_t i) const { return items_[i < N ? i : N - 1]; }
  const T& last() const { return (*this)[size_ - 1]; }

 private:
  T items_[N] = {};
  std::size_t size_ = 0;
};

class Hal final : public reliefscope::Hal {
 public:
  static constexpr std::size_t kMemory = 1024;

  Hal() { std::memset(memory, 0xFF, sizeof memory); }

  const BoardInfo& info() const override { return board; }
  std::uint64_t now_us() override { return now; }
  void arm_timer(std::uint64_t at_us) override { timer = at_us; }
  void spi_start(bool a0_high, const std::uint8_t* bytes, std::size_t count) override {
    SpiRecord record{now, a0_high, !pins[1], static_cast<std::uint8_t>(count), {}};
    std::memcpy(record.bytes, bytes, count);
    spi.add(record);
    spi_free = now + count * 2;
  }
  bool spi_busy() override { return now < spi_free; }
  void set_pin(Pin pin, bool high) override {
    bool& level = pins[static_cast<std::size_t>(pin)];
    if (level != high) {
      level = high;
      edges.add({now, pin, high});
    }
  }
  bool input_level(Input input) override { return inputs[static_cast<std::size_t>(input)]; }
  void set_leds(const std::uint16_t* levels, std::size_t count) override {
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (leds[i] == 0) {
        lit_since[i] = now;
      } else if (now - lit_since[i] > longest_lit) {
        longest_lit = now - lit_since[i];
      }
      leds[i] = levels[i];
      sum += levels[i];
    }
    led_changes.add({now, sum});
  }
  std::size_t serial_read(std::uint8_t* bytes, std::size_t capacity) override {
    const std::size_t left = rx_size - rx_at;
    const std::size_t count = capacity < left ? capacity : left;
    std::memcpy(bytes, rx + rx_at, count);
    rx_at += count;
    return count;
  }
  std::size_t serial_write(const std::uint8_t* bytes, std::size_t count) override {
    const std::size_t room = tx_limit - tx_size;
    count = count < room ? count : room;
    std::memcpy(tx + tx_size, bytes, count);
    tx_size += count;
    return count;
  }
  std::uint8_t nonvolatile_read(std::size_t address) override { return memory[address]; }
  void nonvolatile_write(std::size_t address, std::uint8_t value) override {
    ++writes;
    if (writes <= writes_until_cut) {
      memory[address] = value;
    }
  }
  std::int16_t temperature_centi() override { return temperature; }
  void kick_watchdog() override { ++kicks; }
  void reboot_to_bootloader() override { rebooted = true; }
  // Interrupts that are due come in just before the lock: the worst moment.
  std::uint32_t lock_interrupts() override {
    if (locks == 0 && on_lock != nullptr) {
      void (*interrupt)(void*) = on_lock;
      on_lock = nullptr;
      interrupt(on_lock_context);
      on_lock = interrupt;
    }
    return locks++;
  }
  void restore_interrupts(std::uint32_t state) override { locks = state; }

  // Bytes from the host.
  void feed(const std::uint8_t* bytes, std::size_t count) {
    if (rx_at == rx_size) {
      rx_at = 0;
      rx_size = 0;
    }
    std::memcpy(rx + rx_size, bytes, count);
    rx_size += count;
  }

  BoardInfo board{"fake", wire::Capability::kBootloader, 16, 4095 * 8, 2000000, 1, 0, 1};
  std::uint64_t now = 0;
  std::uint64_t timer = kNever;
  std::uint64_t spi_free = 0;
  bool pins[3] = {false, true, false};
  bool inputs[2] = {};
  std::uint16_t leds[kMaxLeds] = {};
  std::uint64_t lit_since[kMaxLeds] = {};
  std::uint64_t longest_lit = 0;
  std::uint8_t memory[kMemory];
  std::size_t writes = 0;
  std::size_t writes_until_cut = SIZE_MAX;
  std::int16_t temperature = 2500;
  std::uint32_t locks = 0;
  std::uint32_t kicks = 0;
  void (*on_lock)(void*) = nullptr;
  void* on_lock_context = nullptr;
  bool rebooted = false;
  Log<SpiRecord, 96> spi;
  Log<Edge, 64> edges;
  Log<LedChange, 64> led_changes;
  std::uint8_t rx[2048] = {};
  std::size_t rx_size = 0;
  std::size_t rx_at = 0;
  std::uint8_t tx[2048] = {};
  std::size_t tx_size = 0;
  std::size_t tx_limit = sizeof tx;
};

}  // namespace fake
