// Settings in the non-volatile memory: two records, the instrument's settings and the correction of
// its LEDs. Each has two banks with a layout version, a generation number, the values as the wire
// carries them, and a CRC. A write goes to the older bank, so a power cut in the middle leaves the
// newer one. Values of another layout version are not read.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/generated/protocol.hpp"
#include "core/hal.hpp"

namespace reliefscope {

// Two banks of one kind of values, at fixed addresses.
class BankPair {
 public:
  static constexpr std::size_t kMaxValues = 64;
  // Room for what later versions add to a bank.
  static constexpr std::size_t kStride = 256;

  // size bytes of values, at most kMaxValues; banks at address and address + kStride.
  BankPair(Hal& hal, std::size_t address, std::uint8_t version, std::size_t size)
      : hal_(hal), address_(address), version_(version), size_(size) {}

  // As before the first read().
  void forget() { generation_ = 0; }
  // The values of the bank, if it is whole and newer than what was taken before. The caller takes
  // both banks in turn and judges the values, then calls take() for those that it accepts.
  bool read(std::uint8_t bank, std::uint8_t* values, std::uint32_t& generation) const;
  void take(std::uint8_t bank, std::uint32_t generation);
  // Whether any values were taken or written.
  bool holds_values() const { return generation_ != 0; }
  // Into the older bank; false: the memory did not keep them, and the newer bank holds.
  bool write(const std::uint8_t* values);

 private:
  Hal& hal_;
  std::size_t address_;
  std::uint8_t version_;
  std::size_t size_;
  std::uint32_t generation_ = 0;
  std::uint8_t bank_ = 1;  // that holds the values
};

class Settings {
 public:
  explicit Settings(Hal& hal);

  // Takes the newest valid banks, or the defaults: no serial number, the benchtop's glass, LEDs
  // uncorrected.
  void load();
  const wire::GetSettingsReply& get() const { return values_; }
  const wire::GetLedCorrectionReply& led_correction() const { return correction_; }
  // Stores and takes them over; false: the memory did not keep them, and the old ones stay.
  bool set(const wire::GetSettingsReply& values);
  bool set(const wire::GetLedCorrectionReply& values);

 private:
  BankPair settings_banks_;
  BankPair correction_banks_;
  wire::GetSettingsReply values_;
  wire::GetLedCorrectionReply correction_;
};

}  // namespace reliefscope
