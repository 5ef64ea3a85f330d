#include "core/leds.hpp"

namespace reliefscope {

void Leds::begin() {
  std::memset(levels_, 0, sizeof levels_);
  lit_ = false;
  deadline_us_ = kNever;
  hal_.set_leds(levels_, hal_.info().led_count);
}

std::uint32_t Leds::level_sum(const std::uint16_t* levels) const {
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < hal_.info().led_count; ++i) {
    sum += levels[i];
  }
  return sum;
}

void Leds::correct(const std::uint8_t* factors) {
  std::memcpy(factors_, factors, sizeof factors_);
}

bool Leds::set(const std::uint16_t* levels) {
  const BoardInfo& info = hal_.info();
  if (level_sum(levels) > info.level_budget) {
    return false;
  }
  const std::uint64_t now = hal_.now_us();
  lit_ = false;
  deadline_us_ = kNever;
  for (std::size_t i = 0; i < info.led_count; ++i) {
    if (levels_[i] == 0 && levels[i] != 0) {
      lit_since_us_[i] = now;
    }
    levels_[i] = levels[i];
    if (levels_[i] != 0) {
      lit_ = true;
      const std::uint64_t end = lit_since_us_[i] + info.led_on_time_us;
      deadline_us_ = end < deadline_us_ ? end : deadline_us_;
    }
  }
  std::uint16_t currents[kMaxLeds];
  for (std::size_t i = 0; i < info.led_count; ++i) {
    currents[i] = static_cast<std::uint16_t>((levels_[i] * (factors_[i] + 1u)) >> 8);
  }
  hal_.set_leds(currents, info.led_count);
  return true;
}

void Leds::off() {
  if (lit_) {
    begin();
  }
}

}  // namespace reliefscope
