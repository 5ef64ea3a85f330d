// What this firmware is. The build gives the commit, where it knows one.
#pragma once

#ifndef RELIEFSCOPE_GIT_HASH
#define RELIEFSCOPE_GIT_HASH "unknown"
#endif

namespace reliefscope {

inline constexpr char kFirmwareVersion[] = "0.1.0";
inline constexpr char kGitHash[] = RELIEFSCOPE_GIT_HASH;
static_assert(sizeof kFirmwareVersion <= 17 && sizeof kGitHash <= 17, "16 characters on the wire");

}  // namespace reliefscope
