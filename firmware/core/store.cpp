#include "core/store.hpp"

#include <cstring>

#include "core/crc32.hpp"

namespace reliefscope {
namespace {

constexpr std::uint8_t kClosed[kBitmapBytes] = {};
constexpr std::uint16_t kDark[kMaxLeds] = {};

constexpr std::uint32_t bit(std::uint8_t slot) {
  return std::uint32_t{1} << slot;
}

}  // namespace

static_assert(wire::kApertureSlots <= 32 && wire::kLightSlots <= 32, "one bit per slot");

const std::uint8_t* Store::aperture(std::uint8_t slot) const {
  if (slot == kSlotNone) {
    return kClosed;
  }
  return slot < wire::kApertureSlots && (apertures_valid_ & bit(slot)) != 0 ? apertures_[slot]
                                                                            : nullptr;
}

std::uint32_t Store::aperture_crc(std::uint8_t slot) const {
  return slot == kSlotNone ? crc32(kClosed, sizeof kClosed) : aperture_crcs_[slot];
}

void Store::write_aperture(std::uint8_t slot, std::uint8_t chunk, const std::uint8_t* bytes) {
  aperture_changed(slot);
  std::memcpy(apertures_[slot] + chunk * wire::kApertureChunk, bytes, wire::kApertureChunk);
}

bool Store::commit_aperture(std::uint8_t slot, std::uint32_t crc, std::uint32_t& actual) {
  actual = crc32(apertures_[slot], kBitmapBytes);
  if (actual != crc) {
    return false;
  }
  apertures_valid_ |= bit(slot);
  aperture_crcs_[slot] = crc;
  return true;
}

std::uint16_t Store::open_pixels(std::uint8_t slot) const {
  std::uint16_t count = 0;
  for (std::uint8_t byte : apertures_[slot]) {
    for (; byte != 0; byte = static_cast<std::uint8_t>(byte & (byte - 1))) {
      ++count;
    }
  }
  return count;
}

const std::uint16_t* Store::light(std::uint8_t slot) const {
  if (slot == kSlotNone) {
    return kDark;
  }
  return slot < wire::kLightSlots && (lights_valid_ & bit(slot)) != 0 ? lights_[slot] : nullptr;
}

void Store::load_light(std::uint8_t slot, const std::uint16_t* levels, std::size_t count) {
  light_changed(slot);
  std::memset(lights_[slot], 0, sizeof lights_[slot]);
  std::memcpy(lights_[slot], levels, count * sizeof levels[0]);
  lights_valid_ |= bit(slot);
}

std::uint32_t Store::light_crc(std::uint8_t slot) const {
  Crc32 crc;
  for (std::uint16_t level : lights_[slot]) {
    crc.add(static_cast<std::uint8_t>(level));
    crc.add(static_cast<std::uint8_t>(level >> 8));
  }
  return crc.value();
}

void Store::write_step(std::size_t index, const wire::Step& step) {
  step_count_ = 0;
  steps_[index] = step;
}

wire::ErrorCode Store::commit_steps(std::uint16_t count, std::uint32_t crc,
                                    std::uint32_t on_time_us, std::uint32_t period_us,
                                    std::uint32_t& detail) {
  step_count_ = 0;
  Crc32 sum;
  bool complete = true;
  for (std::size_t i = 0; i < count; ++i) {
    std::uint8_t bytes[wire::Step::kMaxSize];
    sum.add(bytes, wire::encode(steps_[i], bytes));
    complete = complete && wire::first_bad_field(steps_[i]) < 0;
  }
  if (sum.value() != crc || !complete) {
    detail = sum.value();
    return wire::ErrorCode::kCrcMismatch;
  }
  std::uint32_t apertures = 0;
  std::uint32_t lights = 0;
  std::uint32_t exposures = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const wire::Step& step = steps_[i];
    detail = static_cast<std::uint32_t>(i);
    if (aperture(step.aperture) == nullptr || light(step.light) == nullptr) {
      return wire::ErrorCode::kSlotEmpty;
    }
    if (step.light != kSlotNone && step.exposure_us > on_time_us) {
      return wire::ErrorCode::kOnTimeLimit;
    }
    if (step.light != kSlotNone && period_us != 0 && step.exposure_us % period_us != 0) {
      return wire::ErrorCode::kLedPeriod;
    }
    apertures |= step.aperture == kSlotNone ? 0 : bit(step.aperture);
    lights |= step.light == kSlotNone ? 0 : bit(step.light);
    exposures += step.repeat;
  }
  apertures_named_ = apertures;
  lights_named_ = lights;
  exposures_ = exposures;
  table_hash_ = crc;
  step_count_ = count;
  return wire::ErrorCode::kOk;
}

void Store::aperture_changed(std::uint8_t slot) {
  apertures_valid_ &= ~bit(slot);
  if ((apertures_named_ & bit(slot)) != 0) {
    step_count_ = 0;
  }
}

void Store::light_changed(std::uint8_t slot) {
  lights_valid_ &= ~bit(slot);
  if ((lights_named_ & bit(slot)) != 0) {
    step_count_ = 0;
  }
}

}  // namespace reliefscope
