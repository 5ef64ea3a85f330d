// What the host uploads: aperture slots, light slots and the table of steps, and which of it is
// valid. A slot or table that is being written is empty until it is committed; changing a slot
// that the table names makes the table void. Nothing here is touched while a sequence runs.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/display.hpp"
#include "core/generated/protocol.hpp"
#include "core/hal.hpp"

namespace reliefscope {

static_assert(kMaxLeds == wire::kLeds, "hal.hpp and protocol.yml disagree");
static_assert(kBitmapBytes == wire::kApertureBytes, "display.hpp and protocol.yml disagree");

constexpr std::uint8_t kSlotNone = static_cast<std::uint8_t>(wire::kSlotNone);

class Store {
 public:
  // 1,024 bytes; nullptr where the slot is empty. SLOT_NONE: all closed.
  const std::uint8_t* aperture(std::uint8_t slot) const;
  std::uint32_t aperture_crc(std::uint8_t slot) const;
  void write_aperture(std::uint8_t slot, std::uint8_t chunk, const std::uint8_t* bytes);
  // Valid from now on if the CRC is right; actual returns what it is.
  bool commit_aperture(std::uint8_t slot, std::uint32_t crc, std::uint32_t& actual);
  std::uint16_t open_pixels(std::uint8_t slot) const;

  // kMaxLeds levels; nullptr where the slot is empty. SLOT_NONE: all off.
  const std::uint16_t* light(std::uint8_t slot) const;
  // Levels of the first count LEDs; the others are off.
  void load_light(std::uint8_t slot, const std::uint16_t* levels, std::size_t count);
  std::uint32_t light_crc(std::uint8_t slot) const;

  const wire::Step& step(std::size_t index) const { return steps_[index]; }
  void write_step(std::size_t index, const wire::Step& step);
  // Valid from now on, or why not and the detail of it. on_time_us limits an exposure with light,
  // and period_us, unless 0, divides it.
  wire::ErrorCode commit_steps(std::uint16_t count, std::uint32_t crc, std::uint32_t on_time_us,
                               std::uint32_t period_us, std::uint32_t& detail);
  std::uint16_t step_count() const { return step_count_; }  // 0: no table
  std::uint32_t table_hash() const { return step_count_ == 0 ? 0 : table_hash_; }
  std::uint32_t exposures() const { return exposures_; }

 private:
  void aperture_changed(std::uint8_t slot);
  void light_changed(std::uint8_t slot);

  std::uint8_t apertures_[wire::kApertureSlots][kBitmapBytes] = {};
  std::uint16_t lights_[wire::kLightSlots][kMaxLeds] = {};
  wire::Step steps_[wire::kSteps] = {};
  std::uint32_t aperture_crcs_[wire::kApertureSlots] = {};
  std::uint32_t apertures_valid_ = 0;  // bit per slot
  std::uint32_t lights_valid_ = 0;
  std::uint32_t apertures_named_ = 0;  // by the table
  std::uint32_t lights_named_ = 0;
  std::uint32_t table_hash_ = 0;
  std::uint32_t exposures_ = 0;
  std::uint16_t step_count_ = 0;
};

}  // namespace reliefscope
