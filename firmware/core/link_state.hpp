// What the link knows about this boot, for the requests that report it.
#pragma once

#include <cstdint>

#include "core/framer.hpp"
#include "core/generated/protocol.hpp"
#include "core/hal.hpp"

namespace reliefscope {

struct LinkState {
  std::uint32_t boot_nonce = 0;
  wire::ResetCause reset_cause = wire::ResetCause::kUnknown;
  std::uint64_t started_us = 0;
  std::uint32_t last_request_id = 0;  // highest that was run
  FramerCounters framer{};
  std::uint32_t frames_sent = 0;
  std::uint32_t rejected = 0;
  std::uint32_t failed = 0;
  std::uint32_t retries_answered = 0;
  std::uint32_t wrong_nonce = 0;
  std::uint64_t bootloader_at_us = kNever;
};

}  // namespace reliefscope
