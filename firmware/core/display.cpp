#include "core/display.hpp"

#include <cstring>

namespace reliefscope {
namespace {

// Commands of the ST7565R.
constexpr std::uint8_t kStartLine0 = 0x40;
constexpr std::uint8_t kColumnsNormal = 0xA0;
constexpr std::uint8_t kColumnsReverse = 0xA1;
constexpr std::uint8_t kInverseOff = 0xA6;
constexpr std::uint8_t kInverseOn = 0xA7;
constexpr std::uint8_t kAllPointsNormal = 0xA4;
constexpr std::uint8_t kAllPointsOn = 0xA5;
constexpr std::uint8_t kBias1To9 = 0xA2;
constexpr std::uint8_t kRowsNormal = 0xC0;
constexpr std::uint8_t kRowsReverse = 0xC8;
constexpr std::uint8_t kPowerAllOn = 0x2F;     // booster, regulator, follower
constexpr std::uint8_t kBoosterRatio = 0xF8;   // next byte 0: four times
constexpr std::uint8_t kResistorRatio = 0x20;  // low bits: ratio
constexpr std::uint8_t kVolume = 0x81;         // next byte: contrast
constexpr std::uint8_t kIndicatorOff = 0xAC;   // next byte 0
constexpr std::uint8_t kDisplayOff = 0xAE;
constexpr std::uint8_t kDisplayOn = 0xAF;
constexpr std::uint8_t kPageAddress = 0xB0;
constexpr std::uint8_t kColumnHigh = 0x10;
constexpr std::uint8_t kColumnLow = 0x00;

// The display RAM has 132 columns; turned by 180 degrees the glass is wired to the last 128.
constexpr std::uint8_t kTopViewOffset = 4;
constexpr std::uint8_t kContrastMask = 0x3F;
constexpr std::uint8_t kRatioMask = 0x07;
// The controller asks for microseconds; 1 ms each leaves room for a slow supply.
constexpr std::uint64_t kResetUs = 1000;

}  // namespace

void Display::begin(const DisplayConfig& config) {
  config_ = config;
  std::memset(bitmap_, 0, sizeof bitmap_);
  initialised_ = false;
  selected_ = false;
  hal_.set_pin(Pin::kLcdSelect, true);
  hal_.set_pin(Pin::kLcdReset, false);
  deadline_us_ = hal_.now_us() + kResetUs;
  enter(Phase::kResetLow);
}

void Display::configure(const DisplayConfig& config) {
  config_ = config;
  initialised_ = false;
  if (!in_reset()) {
    enter(Phase::kShut);
  }
}

void Display::show(const std::uint8_t* bitmap) {
  if (bitmap == nullptr) {
    std::memset(bitmap_, 0, sizeof bitmap_);
  } else {
    std::memcpy(bitmap_, bitmap, sizeof bitmap_);
  }
  if (in_reset()) {
    return;
  }
  if (bitmap == nullptr) {
    enter(Phase::kShut);
  } else if (phase_ > Phase::kInit) {
    page_ = 0;
    enter(Phase::kPageAddress);
  }
}

bool Display::poll() {
  if (phase_ == Phase::kOff || phase_ == Phase::kIdle) {
    return false;
  }
  if (in_reset()) {
    if (hal_.now_us() < deadline_us_) {
      return false;
    }
    if (phase_ == Phase::kResetLow) {
      hal_.set_pin(Pin::kLcdReset, true);
      deadline_us_ = hal_.now_us() + kResetUs;
      enter(Phase::kResetHigh);
    } else {
      enter(Phase::kShut);
    }
    return true;
  }
  if (hal_.spi_busy()) {
    return false;
  }
  if (!selected_) {
    hal_.set_pin(Pin::kLcdSelect, false);
    selected_ = true;
  }
  switch (phase_) {
    case Phase::kShut: {
      const std::uint8_t command = config_.dark_when_off ? kDisplayOff : kAllPointsOn;
      send_commands(&command, 1);
      page_ = 0;
      enter(initialised_ ? Phase::kPageAddress : Phase::kInit);
      break;
    }
    case Phase::kInit: {
      const std::uint8_t commands[] = {
          kStartLine0,
          config_.top_view ? kColumnsNormal : kColumnsReverse,
          config_.top_view ? kRowsReverse : kRowsNormal,
          config_.dark_when_off ? kInverseOff : kInverseOn,
          kBias1To9,
          kPowerAllOn,
          kBoosterRatio,
          0x00,
          static_cast<std::uint8_t>(kResistorRatio | (config_.resistor_ratio & kRatioMask)),
          kVolume,
          static_cast<std::uint8_t>(config_.contrast & kContrastMask),
          kIndicatorOff,
          0x00};
      send_commands(commands, sizeof commands);
      initialised_ = true;
      page_ = 0;
      enter(Phase::kPageAddress);
      break;
    }
    case Phase::kPageAddress: {
      const std::uint8_t first = config_.top_view ? kTopViewOffset : 0;
      const std::uint8_t commands[] = {static_cast<std::uint8_t>(kPageAddress | page_),
                                       static_cast<std::uint8_t>(kColumnHigh | (first >> 4)),
                                       static_cast<std::uint8_t>(kColumnLow | (first & 0x0F))};
      send_commands(commands, sizeof commands);
      column_ = 0;
      enter(Phase::kPageData);
      break;
    }
    case Phase::kPageData: {
      hal_.spi_start(true, bitmap_ + page_ * kGlassColumns + column_, kSpiChunk);
      column_ = static_cast<std::uint8_t>(column_ + kSpiChunk);
      if (column_ == kGlassColumns) {
        ++page_;
        enter(page_ < kGlassPages ? Phase::kPageAddress : Phase::kRelease);
      }
      break;
    }
    case Phase::kRelease: {
      // On before leaving "all points on": the glass never passes through an open state.
      const std::uint8_t commands[] = {kDisplayOn, kAllPointsNormal};
      send_commands(commands, sizeof commands);
      enter(Phase::kFinish);
      break;
    }
    default:  // kFinish: the last byte has left
      hal_.set_pin(Pin::kLcdSelect, true);
      selected_ = false;
      idle_since_us_ = hal_.now_us();
      enter(Phase::kIdle);
      break;
  }
  return true;
}

std::uint64_t Display::next_wakeup_us() const {
  return in_reset() && phase_ != Phase::kOff ? deadline_us_ : kNever;
}

void Display::send_commands(const std::uint8_t* bytes, std::size_t count) {
  hal_.spi_start(false, bytes, count);
}

}  // namespace reliefscope
