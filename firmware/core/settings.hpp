// Settings in the non-volatile memory: two banks, each with a layout version, a generation number,
// the settings as the wire carries them, and a CRC. A write goes to the older bank, so a power cut
// in the middle leaves the newer one. Settings of another layout version are not read.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/generated/protocol.hpp"
#include "core/hal.hpp"

namespace reliefscope {

class Settings {
 public:
  explicit Settings(Hal& hal) : hal_(hal) {}

  // Takes the newest valid bank, or the defaults: no serial number, the benchtop's glass.
  void load();
  const wire::GetSettingsReply& get() const { return values_; }
  // Stores and takes them over; false: the memory did not keep them, and the old ones stay.
  bool set(const wire::GetSettingsReply& values);

 private:
  Hal& hal_;
  wire::GetSettingsReply values_;
  std::uint32_t generation_ = 0;
  std::uint8_t bank_ = 0;  // that holds values_
};

}  // namespace reliefscope
