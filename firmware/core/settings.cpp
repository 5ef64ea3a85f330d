#include "core/settings.hpp"

#include <cstring>

#include "core/crc32.hpp"

namespace reliefscope {
namespace {

// A bank: u8 layout version, u32 generation (from 1), values, u32 CRC-32 of everything before it.
constexpr std::size_t kGenerationAt = 1;
constexpr std::size_t kValuesAt = kGenerationAt + 4;
constexpr std::size_t kBankRest = kValuesAt + 4;
static_assert(kBankRest + BankPair::kMaxValues <= BankPair::kStride, "a bank fits into its stride");

// Versions change with the fields: old ones are then not misread.
constexpr std::uint8_t kSettingsVersion = 1;
constexpr std::size_t kSettingsAddress = 0;
static_assert(wire::GetSettingsReply::kMaxSize == 20, "other settings: another layout version");
constexpr std::uint8_t kCorrectionVersion = 1;
constexpr std::size_t kCorrectionAddress = kSettingsAddress + 2 * BankPair::kStride;
static_assert(wire::GetLedCorrectionReply::kMaxSize == 48, "another layout: another version");

// Glass DOGM128S-6 with the contrast that its maker starts from.
constexpr std::uint8_t kDefaultContrast = 22;
constexpr std::uint8_t kDefaultResistorRatio = 7;
constexpr int kUncorrected = 0xFF;

std::uint32_t get_u32(const std::uint8_t* bytes) {
  wire::detail::Reader reader{bytes, 4};
  return static_cast<std::uint32_t>(reader.get(4));
}

void put_u32(std::uint8_t* bytes, std::uint32_t value) {
  wire::detail::Writer writer{bytes};
  writer.put(value, 4);
}

// The newest bank that the decoder accepts; nothing changes where there is none.
template <class M>
void load_newest(BankPair& banks, M& values) {
  banks.forget();
  for (std::uint8_t bank = 0; bank < 2; ++bank) {
    std::uint8_t bytes[BankPair::kMaxValues];
    std::uint32_t generation = 0;
    M found;
    if (banks.read(bank, bytes, generation) &&
        wire::decode(found, bytes, M::kMaxSize).code == wire::ErrorCode::kOk) {
      values = found;
      banks.take(bank, generation);
    }
  }
}

template <class M>
bool store(BankPair& banks, M& kept, const M& values) {
  std::uint8_t bytes[M::kMaxSize];
  std::uint8_t stored[M::kMaxSize];
  wire::encode(values, bytes);
  wire::encode(kept, stored);
  const bool same = std::memcmp(bytes, stored, sizeof stored) == 0;
  // The same again is a retry, or nothing new: cells wear out.
  if (!(banks.holds_values() && same) && !banks.write(bytes)) {
    return false;
  }
  kept = values;
  return true;
}

}  // namespace

bool BankPair::read(std::uint8_t bank, std::uint8_t* values, std::uint32_t& generation) const {
  std::uint8_t bytes[kBankRest + kMaxValues];
  const std::size_t crc_at = kValuesAt + size_;
  for (std::size_t i = 0; i < crc_at + 4; ++i) {
    bytes[i] = hal_.nonvolatile_read(address_ + bank * kStride + i);
  }
  generation = get_u32(bytes + kGenerationAt);
  if (bytes[0] != version_ || generation <= generation_ ||
      get_u32(bytes + crc_at) != crc32(bytes, crc_at)) {
    return false;
  }
  std::memcpy(values, bytes + kValuesAt, size_);
  return true;
}

void BankPair::take(std::uint8_t bank, std::uint32_t generation) {
  bank_ = bank;
  generation_ = generation;
}

bool BankPair::write(const std::uint8_t* values) {
  std::uint8_t bytes[kBankRest + kMaxValues];
  const std::size_t crc_at = kValuesAt + size_;
  bytes[0] = version_;
  put_u32(bytes + kGenerationAt, generation_ + 1);
  std::memcpy(bytes + kValuesAt, values, size_);
  put_u32(bytes + crc_at, crc32(bytes, crc_at));
  const auto bank = static_cast<std::uint8_t>(bank_ ^ 1u);
  for (std::size_t i = 0; i < crc_at + 4; ++i) {
    const std::size_t address = address_ + bank * kStride + i;
    if (hal_.nonvolatile_read(address) != bytes[i]) {
      hal_.nonvolatile_write(address, bytes[i]);
    }
    if (hal_.nonvolatile_read(address) != bytes[i]) {
      return false;
    }
  }
  take(bank, generation_ + 1);
  return true;
}

Settings::Settings(Hal& hal)
    : settings_banks_(hal, kSettingsAddress, kSettingsVersion, wire::GetSettingsReply::kMaxSize),
      correction_banks_(hal, kCorrectionAddress, kCorrectionVersion,
                        wire::GetLedCorrectionReply::kMaxSize) {}

void Settings::load() {
  values_ = wire::GetSettingsReply{};
  values_.glass_variant = wire::GlassVariant::kSFstnNegative;
  values_.mounting = wire::Mounting::kBottomView;
  values_.contrast = kDefaultContrast;
  values_.resistor_ratio = kDefaultResistorRatio;
  std::memset(correction_.factors, kUncorrected, sizeof correction_.factors);
  load_newest(settings_banks_, values_);
  load_newest(correction_banks_, correction_);
}

bool Settings::set(const wire::GetSettingsReply& values) {
  return store(settings_banks_, values_, values);
}

bool Settings::set(const wire::GetLedCorrectionReply& values) {
  return store(correction_banks_, correction_, values);
}

}  // namespace reliefscope
