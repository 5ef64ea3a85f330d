#include "core/settings.hpp"

#include <cstring>

#include "core/crc32.hpp"

namespace reliefscope {
namespace {

// Changes with the fields of the settings: old ones are then not misread.
constexpr std::uint8_t kLayoutVersion = 1;
static_assert(wire::GetSettingsReply::kMaxSize == 20, "other settings: another layout version");
constexpr std::size_t kGenerationAt = 1;
constexpr std::size_t kValuesAt = kGenerationAt + 4;
constexpr std::size_t kCrcAt = kValuesAt + wire::GetSettingsReply::kMaxSize;
constexpr std::size_t kBankSize = kCrcAt + 4;
// Room for what later versions add to a bank.
constexpr std::size_t kBankStride = 256;
static_assert(kBankSize <= kBankStride, "a bank must fit into its stride");

// Glass DOGM128S-6 with the contrast that its maker starts from.
constexpr std::uint8_t kDefaultContrast = 22;
constexpr std::uint8_t kDefaultResistorRatio = 7;

std::uint32_t get_u32(const std::uint8_t* bytes) {
  wire::detail::Reader reader{bytes, 4};
  return static_cast<std::uint32_t>(reader.get(4));
}

void put_u32(std::uint8_t* bytes, std::uint32_t value) {
  wire::detail::Writer writer{bytes};
  writer.put(value, 4);
}

}  // namespace

void Settings::load() {
  values_ = wire::GetSettingsReply{};
  values_.glass_variant = wire::GlassVariant::kSFstnNegative;
  values_.mounting = wire::Mounting::kBottomView;
  values_.contrast = kDefaultContrast;
  values_.resistor_ratio = kDefaultResistorRatio;
  generation_ = 0;
  bank_ = 1;
  for (std::uint8_t bank = 0; bank < 2; ++bank) {
    std::uint8_t bytes[kBankSize];
    for (std::size_t i = 0; i < kBankSize; ++i) {
      bytes[i] = hal_.nonvolatile_read(bank * kBankStride + i);
    }
    const std::uint32_t generation = get_u32(bytes + kGenerationAt);
    wire::GetSettingsReply values;
    if (bytes[0] == kLayoutVersion && get_u32(bytes + kCrcAt) == crc32(bytes, kCrcAt) &&
        generation > generation_ &&
        wire::decode(values, bytes + kValuesAt, wire::GetSettingsReply::kMaxSize).code ==
            wire::ErrorCode::kOk) {
      values_ = values;
      generation_ = generation;
      bank_ = bank;
    }
  }
}

bool Settings::set(const wire::GetSettingsReply& values) {
  std::uint8_t bytes[kBankSize];
  std::uint8_t stored[wire::GetSettingsReply::kMaxSize];
  wire::encode(values, bytes);
  wire::encode(values_, stored);
  if (generation_ != 0 && std::memcmp(bytes, stored, sizeof stored) == 0) {
    return true;  // a retry, or nothing new: cells wear out
  }
  bytes[0] = kLayoutVersion;
  put_u32(bytes + kGenerationAt, generation_ + 1);
  wire::encode(values, bytes + kValuesAt);
  put_u32(bytes + kCrcAt, crc32(bytes, kCrcAt));
  const std::uint8_t bank = bank_ ^ 1u;
  const std::size_t base = bank * kBankStride;
  for (std::size_t i = 0; i < kBankSize; ++i) {
    if (hal_.nonvolatile_read(base + i) != bytes[i]) {
      hal_.nonvolatile_write(base + i, bytes[i]);
    }
    if (hal_.nonvolatile_read(base + i) != bytes[i]) {
      return false;
    }
  }
  values_ = values;
  ++generation_;
  bank_ = bank;
  return true;
}

}  // namespace reliefscope
