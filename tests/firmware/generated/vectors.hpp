// Generated from protocol/protocol.yml by protocol/generator; do not edit.
//
// Golden vectors for the C++ tests: the same as protocol/vectors/*.json.
// clang-format off
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "generated/protocol.hpp"

namespace reliefscope::vectors {

enum class Verdict { kOk, kEmpty, kFraming, kCrc, kOverrun, kUnknownMessage, kBadLength, kOutOfRange };

struct FrameVector {
  const char* name;
  Verdict verdict;
  // On the wire, delimiter included.
  const std::uint8_t* frame;
  std::size_t frame_size;
  // What is in it; only where the frame itself is sound.
  std::uint8_t message;
  std::uint32_t request_id;
  std::uint32_t boot_nonce;
  const std::uint8_t* payload;
  std::size_t payload_size;
  // Index of the field that is out of range.
  std::uint8_t bad_field;
  // Decodes the payload, compares every field, encodes it again and compares the bytes; null where nothing may be decoded.
  bool (*matches)(const std::uint8_t* payload, std::size_t size);
  // Decodes the payload of this message only; null for an unknown message and for broken frames.
  wire::Check (*decode)(const std::uint8_t* payload, std::size_t size);
};

struct StuffingVector {
  const std::uint8_t* plain;
  std::size_t plain_size;
  const std::uint8_t* stuffed;
  std::size_t stuffed_size;
};

namespace data {

template <class M>
wire::Check decode_as(const std::uint8_t* payload, std::size_t size) {
  M message;
  return wire::decode(message, payload, size);
}

template <class M>
bool encodes_to(const M& message, const std::uint8_t* payload, std::size_t size) {
  std::uint8_t out[M::kMaxSize + 1] = {};
  return wire::encode(message, out) == size && (size == 0 || std::memcmp(out, payload, size) == 0);
}


inline constexpr std::uint8_t kFrame0[] = {10,1,5,3,2,1,2,176,173,27,1,5,50,177,130,99,0};
inline bool matches0(const std::uint8_t* payload, std::size_t size) {
  wire::HelloRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size);
}
inline constexpr std::uint8_t kFrame1[] = {11,129,133,3,2,1,2,176,173,27,108,45,17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,102,105,114,109,119,97,114,101,95,118,101,114,115,105,111,110,103,105,116,95,104,97,115,104,45,51,1,1,1,1,1,8,98,111,97,114,100,45,52,1,1,1,1,1,1,1,1,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,53,2,8,1,1,27,4,73,90,107,124,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,164,242,45,95,166,0};
inline constexpr std::uint8_t kPayload1[] = {17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,102,105,114,109,119,97,114,101,95,118,101,114,115,105,111,110,103,105,116,95,104,97,115,104,45,51,0,0,0,0,0,0,98,111,97,114,100,45,52,0,0,0,0,0,0,0,0,0,115,101,114,105,97,108,95,110,117,109,98,101,114,45,53,0,8,0,0,0,4,73,90,107,124,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,164};
inline bool matches1(const std::uint8_t* payload, std::size_t size) {
  wire::HelloReply m;
  static constexpr std::uint8_t schema_hash[] = {24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129};
  static constexpr std::uint8_t reserved[] = {115,122,129,136,143,150,157,164};
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.protocol_version == 8721ULL && std::memcmp(m.schema_hash, schema_hash, sizeof schema_hash) == 0 && std::strncmp(m.firmware_version, "firmware_version", 16) == 0 && std::strncmp(m.git_hash, "git_hash-3", 16) == 0 && std::strncmp(m.board, "board-4", 16) == 0 && std::strncmp(m.serial_number, "serial_number-5", 16) == 0 && m.capabilities == 8ULL && m.reset_cause == static_cast<wire::ResetCause>(4) && m.boot_nonce == 2087410249ULL && m.last_request_id == 2205311312ULL && m.aperture_slots == 87ULL && m.light_slots == 94ULL && m.leds == 101ULL && m.steps == 32108ULL && std::memcmp(m.reserved, reserved, sizeof reserved) == 0;
}
inline constexpr std::uint8_t kFrame2[] = {11,129,133,3,2,1,2,176,173,27,108,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,2,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,5,232,75,8,98,0};
inline constexpr std::uint8_t kPayload2[] = {0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0};
inline bool matches2(const std::uint8_t* payload, std::size_t size) {
  wire::HelloReply m;
  static constexpr std::uint8_t schema_hash[] = {0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0};
  static constexpr std::uint8_t reserved[] = {0,0,0,0,0,0,0,0};
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.protocol_version == 0ULL && std::memcmp(m.schema_hash, schema_hash, sizeof schema_hash) == 0 && std::strncmp(m.firmware_version, "", 16) == 0 && std::strncmp(m.git_hash, "", 16) == 0 && std::strncmp(m.board, "", 16) == 0 && std::strncmp(m.serial_number, "", 16) == 0 && m.capabilities == 0ULL && m.reset_cause == static_cast<wire::ResetCause>(0) && m.boot_nonce == 1ULL && m.last_request_id == 0ULL && m.aperture_slots == 0ULL && m.light_slots == 0ULL && m.leds == 0ULL && m.steps == 0ULL && std::memcmp(m.reserved, reserved, sizeof reserved) == 0;
}
inline constexpr std::uint8_t kFrame3[] = {11,129,133,3,2,1,2,176,173,27,108,84,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,15,1,1,27,7,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,216,86,46,116,0};
inline constexpr std::uint8_t kPayload3[] = {255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,15,0,0,0,7,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255};
inline bool matches3(const std::uint8_t* payload, std::size_t size) {
  wire::HelloReply m;
  static constexpr std::uint8_t schema_hash[] = {255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255};
  static constexpr std::uint8_t reserved[] = {255,255,255,255,255,255,255,255};
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.protocol_version == 65535ULL && std::memcmp(m.schema_hash, schema_hash, sizeof schema_hash) == 0 && std::strncmp(m.firmware_version, "~~~~~~~~~~~~~~~~", 16) == 0 && std::strncmp(m.git_hash, "~~~~~~~~~~~~~~~~", 16) == 0 && std::strncmp(m.board, "~~~~~~~~~~~~~~~~", 16) == 0 && std::strncmp(m.serial_number, "~~~~~~~~~~~~~~~~", 16) == 0 && m.capabilities == 15ULL && m.reset_cause == static_cast<wire::ResetCause>(7) && m.boot_nonce == 4294967295ULL && m.last_request_id == 4294967295ULL && m.aperture_slots == 255ULL && m.light_slots == 255ULL && m.leds == 255ULL && m.steps == 65535ULL && std::memcmp(m.reserved, reserved, sizeof reserved) == 0;
}
inline constexpr std::uint8_t kFrame4[] = {11,2,6,3,2,1,2,176,173,27,4,9,17,34,51,68,67,254,207,194,0};
inline constexpr std::uint8_t kPayload4[] = {17,34,51,68};
inline bool matches4(const std::uint8_t* payload, std::size_t size) {
  wire::EnterBootloaderRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.magic == 1144201745ULL;
}
inline constexpr std::uint8_t kFrame5[] = {11,2,6,3,2,1,2,176,173,27,4,1,1,1,1,5,142,188,121,148,0};
inline constexpr std::uint8_t kPayload5[] = {0,0,0,0};
inline bool matches5(const std::uint8_t* payload, std::size_t size) {
  wire::EnterBootloaderRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.magic == 0ULL;
}
inline constexpr std::uint8_t kFrame6[] = {11,2,6,3,2,1,2,176,173,27,4,9,255,255,255,255,109,156,194,74,0};
inline constexpr std::uint8_t kPayload6[] = {255,255,255,255};
inline bool matches6(const std::uint8_t* payload, std::size_t size) {
  wire::EnterBootloaderRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.magic == 4294967295ULL;
}
inline constexpr std::uint8_t kFrame7[] = {11,130,134,3,2,1,2,176,173,27,2,7,17,34,160,248,134,54,0};
inline constexpr std::uint8_t kPayload7[] = {17,34};
inline bool matches7(const std::uint8_t* payload, std::size_t size) {
  wire::EnterBootloaderReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.delay_ms == 8721ULL;
}
inline constexpr std::uint8_t kFrame8[] = {11,130,134,3,2,1,2,176,173,27,2,1,1,5,84,154,63,176,0};
inline constexpr std::uint8_t kPayload8[] = {0,0};
inline bool matches8(const std::uint8_t* payload, std::size_t size) {
  wire::EnterBootloaderReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.delay_ms == 0ULL;
}
inline constexpr std::uint8_t kFrame9[] = {11,130,134,3,2,1,2,176,173,27,2,7,255,255,171,136,25,14,0};
inline constexpr std::uint8_t kPayload9[] = {255,255};
inline bool matches9(const std::uint8_t* payload, std::size_t size) {
  wire::EnterBootloaderReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.delay_ms == 65535ULL;
}
inline constexpr std::uint8_t kFrame10[] = {10,3,7,3,2,1,2,176,173,27,1,5,206,216,27,63,0};
inline bool matches10(const std::uint8_t* payload, std::size_t size) {
  wire::StatusRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size);
}
inline constexpr std::uint8_t kFrame11[] = {11,131,135,3,2,1,2,176,173,27,37,42,2,5,15,6,1,52,69,86,103,120,137,154,171,59,76,93,110,66,83,100,117,73,90,80,97,114,131,87,104,121,138,94,111,128,145,101,118,122,91,10,182,0};
inline constexpr std::uint8_t kPayload11[] = {2,5,15,6,1,52,69,86,103,120,137,154,171,59,76,93,110,66,83,100,117,73,90,80,97,114,131,87,104,121,138,94,111,128,145,101,118};
inline bool matches11(const std::uint8_t* payload, std::size_t size) {
  wire::StatusReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.sequence == static_cast<wire::SequenceState>(2) && m.fault == static_cast<wire::FaultReason>(5) && m.aperture == 15ULL && m.light == 6ULL && m.camera_ready == true && m.uptime_us == 12365346877121905972ULL && m.table_hash == 1851608123ULL && m.run_id == 1969509186ULL && m.step == 23113ULL && m.exposures == 2205311312ULL && m.oldest_event == 2323212375ULL && m.next_event == 2441113438ULL && m.temperature_centi == 30309;
}
inline constexpr std::uint8_t kFrame12[] = {11,131,135,3,2,1,2,176,173,27,37,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,6,128,155,19,247,51,0};
inline constexpr std::uint8_t kPayload12[] = {0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,128};
inline bool matches12(const std::uint8_t* payload, std::size_t size) {
  wire::StatusReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.sequence == static_cast<wire::SequenceState>(0) && m.fault == static_cast<wire::FaultReason>(0) && m.aperture == 0ULL && m.light == 0ULL && m.camera_ready == false && m.uptime_us == 0ULL && m.table_hash == 0ULL && m.run_id == 0ULL && m.step == 0ULL && m.exposures == 0ULL && m.oldest_event == 0ULL && m.next_event == 0ULL && m.temperature_centi == -32768;
}
inline constexpr std::uint8_t kFrame13[] = {11,131,135,3,2,1,2,176,173,27,37,42,4,9,255,255,1,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,127,28,206,20,137,0};
inline constexpr std::uint8_t kPayload13[] = {4,9,255,255,1,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,127};
inline bool matches13(const std::uint8_t* payload, std::size_t size) {
  wire::StatusReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.sequence == static_cast<wire::SequenceState>(4) && m.fault == static_cast<wire::FaultReason>(9) && m.aperture == 255ULL && m.light == 255ULL && m.camera_ready == true && m.uptime_us == 18446744073709551615ULL && m.table_hash == 4294967295ULL && m.run_id == 4294967295ULL && m.step == 65535ULL && m.exposures == 4294967295ULL && m.oldest_event == 4294967295ULL && m.next_event == 4294967295ULL && m.temperature_centi == 32767;
}
inline constexpr std::uint8_t kFrame14[] = {10,4,8,3,2,1,2,176,173,27,1,5,192,150,43,231,0};
inline bool matches14(const std::uint8_t* payload, std::size_t size) {
  wire::LimitsRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size);
}
inline constexpr std::uint8_t kFrame15[] = {11,132,136,3,2,1,2,176,173,27,18,23,17,34,51,68,24,41,58,75,31,48,65,82,42,7,45,62,52,69,253,223,93,11,0};
inline constexpr std::uint8_t kPayload15[] = {17,34,51,68,24,41,58,75,31,48,65,82,42,7,45,62,52,69};
inline bool matches15(const std::uint8_t* payload, std::size_t size) {
  wire::LimitsReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.led_on_time_us == 1144201745ULL && m.level_budget == 1262102808ULL && m.led_period_us == 1380003871ULL && m.led_level_step == 1834ULL && m.link_timeout_ms == 15917ULL && m.reset_ms == 17716ULL;
}
inline constexpr std::uint8_t kFrame16[] = {11,132,136,3,2,1,2,176,173,27,18,1,1,1,1,1,1,1,1,1,1,1,1,2,1,1,1,1,1,5,145,171,128,117,0};
inline constexpr std::uint8_t kPayload16[] = {0,0,0,0,0,0,0,0,0,0,0,0,1,0,0,0,0,0};
inline bool matches16(const std::uint8_t* payload, std::size_t size) {
  wire::LimitsReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.led_on_time_us == 0ULL && m.level_budget == 0ULL && m.led_period_us == 0ULL && m.led_level_step == 1ULL && m.link_timeout_ms == 0ULL && m.reset_ms == 0ULL;
}
inline constexpr std::uint8_t kFrame17[] = {11,132,136,3,2,1,2,176,173,27,18,23,255,255,255,255,255,255,255,255,255,255,255,255,255,15,255,255,255,255,201,69,38,172,0};
inline constexpr std::uint8_t kPayload17[] = {255,255,255,255,255,255,255,255,255,255,255,255,255,15,255,255,255,255};
inline bool matches17(const std::uint8_t* payload, std::size_t size) {
  wire::LimitsReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.led_on_time_us == 4294967295ULL && m.level_budget == 4294967295ULL && m.led_period_us == 4294967295ULL && m.led_level_step == 4095ULL && m.link_timeout_ms == 65535ULL && m.reset_ms == 65535ULL;
}
inline constexpr std::uint8_t kFrame18[] = {11,16,20,3,2,1,2,176,173,27,34,6,17,16,24,9,31,33,38,7,45,14,52,5,59,12,66,3,73,10,80,1,87,8,94,15,101,6,108,13,115,4,122,11,129,2,142,33,101,44,0};
inline constexpr std::uint8_t kPayload18[] = {17,16,24,9,31,0,38,7,45,14,52,5,59,12,66,3,73,10,80,1,87,8,94,15,101,6,108,13,115,4,122,11,129,2};
inline bool matches18(const std::uint8_t* payload, std::size_t size) {
  wire::LoadLightRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 17ULL && m.levels_count == 16 && m.levels[0] == 2328ULL && m.levels[1] == 31ULL && m.levels[2] == 1830ULL && m.levels[3] == 3629ULL && m.levels[4] == 1332ULL && m.levels[5] == 3131ULL && m.levels[6] == 834ULL && m.levels[7] == 2633ULL && m.levels[8] == 336ULL && m.levels[9] == 2135ULL && m.levels[10] == 3934ULL && m.levels[11] == 1637ULL && m.levels[12] == 3436ULL && m.levels[13] == 1139ULL && m.levels[14] == 2938ULL && m.levels[15] == 641ULL;
}
inline constexpr std::uint8_t kFrame19[] = {11,16,20,3,2,1,2,176,173,27,2,1,1,5,81,176,234,68,0};
inline constexpr std::uint8_t kPayload19[] = {0,0};
inline bool matches19(const std::uint8_t* payload, std::size_t size) {
  wire::LoadLightRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 0ULL && m.levels_count == 0;
}
inline constexpr std::uint8_t kFrame20[] = {11,16,20,3,2,1,2,176,173,27,98,103,31,48,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,196,3,62,178,0};
inline constexpr std::uint8_t kPayload20[] = {31,48,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15,255,15};
inline bool matches20(const std::uint8_t* payload, std::size_t size) {
  wire::LoadLightRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 31ULL && m.levels_count == 48 && m.levels[0] == 4095ULL && m.levels[1] == 4095ULL && m.levels[2] == 4095ULL && m.levels[3] == 4095ULL && m.levels[4] == 4095ULL && m.levels[5] == 4095ULL && m.levels[6] == 4095ULL && m.levels[7] == 4095ULL && m.levels[8] == 4095ULL && m.levels[9] == 4095ULL && m.levels[10] == 4095ULL && m.levels[11] == 4095ULL && m.levels[12] == 4095ULL && m.levels[13] == 4095ULL && m.levels[14] == 4095ULL && m.levels[15] == 4095ULL && m.levels[16] == 4095ULL && m.levels[17] == 4095ULL && m.levels[18] == 4095ULL && m.levels[19] == 4095ULL && m.levels[20] == 4095ULL && m.levels[21] == 4095ULL && m.levels[22] == 4095ULL && m.levels[23] == 4095ULL && m.levels[24] == 4095ULL && m.levels[25] == 4095ULL && m.levels[26] == 4095ULL && m.levels[27] == 4095ULL && m.levels[28] == 4095ULL && m.levels[29] == 4095ULL && m.levels[30] == 4095ULL && m.levels[31] == 4095ULL && m.levels[32] == 4095ULL && m.levels[33] == 4095ULL && m.levels[34] == 4095ULL && m.levels[35] == 4095ULL && m.levels[36] == 4095ULL && m.levels[37] == 4095ULL && m.levels[38] == 4095ULL && m.levels[39] == 4095ULL && m.levels[40] == 4095ULL && m.levels[41] == 4095ULL && m.levels[42] == 4095ULL && m.levels[43] == 4095ULL && m.levels[44] == 4095ULL && m.levels[45] == 4095ULL && m.levels[46] == 4095ULL && m.levels[47] == 4095ULL;
}
inline constexpr std::uint8_t kFrame21[] = {11,144,148,3,2,1,2,176,173,27,9,14,17,24,41,58,75,31,48,65,82,145,128,195,34,0};
inline constexpr std::uint8_t kPayload21[] = {17,24,41,58,75,31,48,65,82};
inline bool matches21(const std::uint8_t* payload, std::size_t size) {
  wire::LoadLightReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 17ULL && m.crc32 == 1262102808ULL && m.level_sum == 1380003871ULL;
}
inline constexpr std::uint8_t kFrame22[] = {11,144,148,3,2,1,2,176,173,27,9,1,1,1,1,1,1,1,1,1,5,36,33,215,166,0};
inline constexpr std::uint8_t kPayload22[] = {0,0,0,0,0,0,0,0,0};
inline bool matches22(const std::uint8_t* payload, std::size_t size) {
  wire::LoadLightReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 0ULL && m.crc32 == 0ULL && m.level_sum == 0ULL;
}
inline constexpr std::uint8_t kFrame23[] = {11,144,148,3,2,1,2,176,173,27,9,14,31,255,255,255,255,255,255,255,255,241,172,200,145,0};
inline constexpr std::uint8_t kPayload23[] = {31,255,255,255,255,255,255,255,255};
inline bool matches23(const std::uint8_t* payload, std::size_t size) {
  wire::LoadLightReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 31ULL && m.crc32 == 4294967295ULL && m.level_sum == 4294967295ULL;
}
inline constexpr std::uint8_t kFrame24[] = {13,17,21,3,2,1,2,176,173,27,2,1,1,216,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,90,97,104,111,118,125,132,139,146,153,160,167,174,181,188,195,202,209,216,223,230,237,244,251,2,9,16,23,30,37,44,51,58,65,72,79,86,93,100,107,114,121,128,135,142,149,156,163,170,177,184,191,198,205,212,219,226,233,240,247,254,5,12,19,26,33,40,47,54,61,68,75,82,89,96,103,110,117,124,131,138,145,152,159,166,173,180,187,194,201,208,215,222,229,236,243,250,1,8,15,22,29,36,43,50,57,64,71,78,85,92,99,106,113,120,127,134,141,148,155,162,169,176,183,190,197,204,211,218,225,232,239,246,253,4,11,18,25,32,39,46,53,60,67,74,81,88,95,102,109,116,123,130,137,144,151,158,165,172,179,186,193,200,207,214,221,228,235,242,249,45,7,14,21,28,35,42,49,56,63,70,77,84,91,98,105,112,119,126,133,140,147,154,161,168,175,182,189,196,203,210,217,224,231,238,245,252,3,10,17,24,219,166,128,152,0};
inline constexpr std::uint8_t kPayload24[] = {1,0,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,90,97,104,111,118,125,132,139,146,153,160,167,174,181,188,195,202,209,216,223,230,237,244,251,2,9,16,23,30,37,44,51,58,65,72,79,86,93,100,107,114,121,128,135,142,149,156,163,170,177,184,191,198,205,212,219,226,233,240,247,254,5,12,19,26,33,40,47,54,61,68,75,82,89,96,103,110,117,124,131,138,145,152,159,166,173,180,187,194,201,208,215,222,229,236,243,250,1,8,15,22,29,36,43,50,57,64,71,78,85,92,99,106,113,120,127,134,141,148,155,162,169,176,183,190,197,204,211,218,225,232,239,246,253,4,11,18,25,32,39,46,53,60,67,74,81,88,95,102,109,116,123,130,137,144,151,158,165,172,179,186,193,200,207,214,221,228,235,242,249,0,7,14,21,28,35,42,49,56,63,70,77,84,91,98,105,112,119,126,133,140,147,154,161,168,175,182,189,196,203,210,217,224,231,238,245,252,3,10,17,24};
inline bool matches24(const std::uint8_t* payload, std::size_t size) {
  wire::ApertureChunkRequest m;
  static constexpr std::uint8_t data[] = {31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,90,97,104,111,118,125,132,139,146,153,160,167,174,181,188,195,202,209,216,223,230,237,244,251,2,9,16,23,30,37,44,51,58,65,72,79,86,93,100,107,114,121,128,135,142,149,156,163,170,177,184,191,198,205,212,219,226,233,240,247,254,5,12,19,26,33,40,47,54,61,68,75,82,89,96,103,110,117,124,131,138,145,152,159,166,173,180,187,194,201,208,215,222,229,236,243,250,1,8,15,22,29,36,43,50,57,64,71,78,85,92,99,106,113,120,127,134,141,148,155,162,169,176,183,190,197,204,211,218,225,232,239,246,253,4,11,18,25,32,39,46,53,60,67,74,81,88,95,102,109,116,123,130,137,144,151,158,165,172,179,186,193,200,207,214,221,228,235,242,249,0,7,14,21,28,35,42,49,56,63,70,77,84,91,98,105,112,119,126,133,140,147,154,161,168,175,182,189,196,203,210,217,224,231,238,245,252,3,10,17,24};
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 1ULL && m.chunk == 0ULL && std::memcmp(m.data, data, sizeof data) == 0;
}
inline constexpr std::uint8_t kFrame25[] = {12,17,21,3,2,1,2,176,173,27,2,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,5,77,4,54,155,0};
inline constexpr std::uint8_t kPayload25[] = {0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0};
inline bool matches25(const std::uint8_t* payload, std::size_t size) {
  wire::ApertureChunkRequest m;
  static constexpr std::uint8_t data[] = {0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0};
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 0ULL && m.chunk == 0ULL && std::memcmp(m.data, data, sizeof data) == 0;
}
inline constexpr std::uint8_t kFrame26[] = {255,17,21,3,2,1,2,176,173,27,2,1,15,3,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,20,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,91,222,195,41,0};
inline constexpr std::uint8_t kPayload26[] = {15,3,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255};
inline bool matches26(const std::uint8_t* payload, std::size_t size) {
  wire::ApertureChunkRequest m;
  static constexpr std::uint8_t data[] = {255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255};
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 15ULL && m.chunk == 3ULL && std::memcmp(m.data, data, sizeof data) == 0;
}
inline constexpr std::uint8_t kFrame27[] = {11,145,149,3,2,1,2,176,173,27,2,2,1,5,13,94,111,219,0};
inline constexpr std::uint8_t kPayload27[] = {1,0};
inline bool matches27(const std::uint8_t* payload, std::size_t size) {
  wire::ApertureChunkReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 1ULL && m.chunk == 0ULL;
}
inline constexpr std::uint8_t kFrame28[] = {11,145,149,3,2,1,2,176,173,27,2,1,1,5,76,111,116,194,0};
inline constexpr std::uint8_t kPayload28[] = {0,0};
inline bool matches28(const std::uint8_t* payload, std::size_t size) {
  wire::ApertureChunkReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 0ULL && m.chunk == 0ULL;
}
inline constexpr std::uint8_t kFrame29[] = {11,145,149,3,2,1,2,176,173,27,2,7,15,3,57,34,229,220,0};
inline constexpr std::uint8_t kPayload29[] = {15,3};
inline bool matches29(const std::uint8_t* payload, std::size_t size) {
  wire::ApertureChunkReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 15ULL && m.chunk == 3ULL;
}
inline constexpr std::uint8_t kFrame30[] = {11,18,22,3,2,1,2,176,173,27,5,10,1,24,41,58,75,189,255,82,135,0};
inline constexpr std::uint8_t kPayload30[] = {1,24,41,58,75};
inline bool matches30(const std::uint8_t* payload, std::size_t size) {
  wire::CommitApertureRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 1ULL && m.crc32 == 1262102808ULL;
}
inline constexpr std::uint8_t kFrame31[] = {11,18,22,3,2,1,2,176,173,27,5,1,1,1,1,1,5,115,146,164,220,0};
inline constexpr std::uint8_t kPayload31[] = {0,0,0,0,0};
inline bool matches31(const std::uint8_t* payload, std::size_t size) {
  wire::CommitApertureRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 0ULL && m.crc32 == 0ULL;
}
inline constexpr std::uint8_t kFrame32[] = {11,18,22,3,2,1,2,176,173,27,5,10,15,255,255,255,255,65,37,79,128,0};
inline constexpr std::uint8_t kPayload32[] = {15,255,255,255,255};
inline bool matches32(const std::uint8_t* payload, std::size_t size) {
  wire::CommitApertureRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 15ULL && m.crc32 == 4294967295ULL;
}
inline constexpr std::uint8_t kFrame33[] = {11,146,150,3,2,1,2,176,173,27,7,12,1,24,41,58,75,30,16,129,128,87,206,0};
inline constexpr std::uint8_t kPayload33[] = {1,24,41,58,75,30,16};
inline bool matches33(const std::uint8_t* payload, std::size_t size) {
  wire::CommitApertureReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 1ULL && m.crc32 == 1262102808ULL && m.open_pixels == 4126ULL;
}
inline constexpr std::uint8_t kFrame34[] = {11,146,150,3,2,1,2,176,173,27,7,1,1,1,1,1,1,1,5,233,19,219,97,0};
inline constexpr std::uint8_t kPayload34[] = {0,0,0,0,0,0,0};
inline bool matches34(const std::uint8_t* payload, std::size_t size) {
  wire::CommitApertureReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 0ULL && m.crc32 == 0ULL && m.open_pixels == 0ULL;
}
inline constexpr std::uint8_t kFrame35[] = {11,146,150,3,2,1,2,176,173,27,7,6,15,255,255,255,255,6,32,148,29,192,226,0};
inline constexpr std::uint8_t kPayload35[] = {15,255,255,255,255,0,32};
inline bool matches35(const std::uint8_t* payload, std::size_t size) {
  wire::CommitApertureReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 15ULL && m.crc32 == 4294967295ULL && m.open_pixels == 8192ULL;
}
inline constexpr std::uint8_t kFrame36[] = {11,19,23,3,2,1,2,176,173,27,1,6,1,116,104,202,122,0};
inline constexpr std::uint8_t kPayload36[] = {1};
inline bool matches36(const std::uint8_t* payload, std::size_t size) {
  wire::SelectApertureRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 1ULL;
}
inline constexpr std::uint8_t kFrame37[] = {11,19,23,3,2,1,2,176,173,27,1,1,5,226,88,205,13,0};
inline constexpr std::uint8_t kPayload37[] = {0};
inline bool matches37(const std::uint8_t* payload, std::size_t size) {
  wire::SelectApertureRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 0ULL;
}
inline constexpr std::uint8_t kFrame38[] = {11,19,23,3,2,1,2,176,173,27,1,6,255,111,183,207,32,0};
inline constexpr std::uint8_t kPayload38[] = {255};
inline bool matches38(const std::uint8_t* payload, std::size_t size) {
  wire::SelectApertureRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 255ULL;
}
inline constexpr std::uint8_t kFrame39[] = {11,147,151,3,2,1,2,176,173,27,5,10,1,24,41,58,75,139,168,187,130,0};
inline constexpr std::uint8_t kPayload39[] = {1,24,41,58,75};
inline bool matches39(const std::uint8_t* payload, std::size_t size) {
  wire::SelectApertureReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 1ULL && m.crc32 == 1262102808ULL;
}
inline constexpr std::uint8_t kFrame40[] = {11,147,151,3,2,1,2,176,173,27,5,1,1,1,1,1,5,69,197,77,217,0};
inline constexpr std::uint8_t kPayload40[] = {0,0,0,0,0};
inline bool matches40(const std::uint8_t* payload, std::size_t size) {
  wire::SelectApertureReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 0ULL && m.crc32 == 0ULL;
}
inline constexpr std::uint8_t kFrame41[] = {11,147,151,3,2,1,2,176,173,27,5,10,255,255,255,255,255,42,34,146,205,0};
inline constexpr std::uint8_t kPayload41[] = {255,255,255,255,255};
inline bool matches41(const std::uint8_t* payload, std::size_t size) {
  wire::SelectApertureReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 255ULL && m.crc32 == 4294967295ULL;
}
inline constexpr std::uint8_t kFrame42[] = {11,20,24,3,2,1,2,176,173,27,1,6,17,89,101,29,128,0};
inline constexpr std::uint8_t kPayload42[] = {17};
inline bool matches42(const std::uint8_t* payload, std::size_t size) {
  wire::SelectLightRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 17ULL;
}
inline constexpr std::uint8_t kFrame43[] = {11,20,24,3,2,1,2,176,173,27,1,1,5,171,69,173,234,0};
inline constexpr std::uint8_t kPayload43[] = {0};
inline bool matches43(const std::uint8_t* payload, std::size_t size) {
  wire::SelectLightRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 0ULL;
}
inline constexpr std::uint8_t kFrame44[] = {11,20,24,3,2,1,2,176,173,27,1,6,255,38,170,175,199,0};
inline constexpr std::uint8_t kPayload44[] = {255};
inline bool matches44(const std::uint8_t* payload, std::size_t size) {
  wire::SelectLightRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 255ULL;
}
inline constexpr std::uint8_t kFrame45[] = {11,148,152,3,2,1,2,176,173,27,5,10,17,24,41,58,75,225,4,42,75,0};
inline constexpr std::uint8_t kPayload45[] = {17,24,41,58,75};
inline bool matches45(const std::uint8_t* payload, std::size_t size) {
  wire::SelectLightReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 17ULL && m.level_sum == 1262102808ULL;
}
inline constexpr std::uint8_t kFrame46[] = {11,148,152,3,2,1,2,176,173,27,5,1,1,1,1,1,5,173,254,60,112,0};
inline constexpr std::uint8_t kPayload46[] = {0,0,0,0,0};
inline bool matches46(const std::uint8_t* payload, std::size_t size) {
  wire::SelectLightReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 0ULL && m.level_sum == 0ULL;
}
inline constexpr std::uint8_t kFrame47[] = {11,148,152,3,2,1,2,176,173,27,5,10,255,255,255,255,255,194,25,227,100,0};
inline constexpr std::uint8_t kPayload47[] = {255,255,255,255,255};
inline bool matches47(const std::uint8_t* payload, std::size_t size) {
  wire::SelectLightReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 255ULL && m.level_sum == 4294967295ULL;
}
inline constexpr std::uint8_t kFrame48[] = {10,21,25,3,2,1,2,176,173,27,1,5,29,103,63,64,0};
inline bool matches48(const std::uint8_t* payload, std::size_t size) {
  wire::AllOffRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size);
}
inline constexpr std::uint8_t kFrame49[] = {11,149,153,3,2,1,2,176,173,27,1,6,2,87,237,174,73,0};
inline constexpr std::uint8_t kPayload49[] = {2};
inline bool matches49(const std::uint8_t* payload, std::size_t size) {
  wire::AllOffReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.sequence == static_cast<wire::SequenceState>(2);
}
inline constexpr std::uint8_t kFrame50[] = {11,149,153,3,2,1,2,176,173,27,1,1,5,123,140,160,167,0};
inline constexpr std::uint8_t kPayload50[] = {0};
inline bool matches50(const std::uint8_t* payload, std::size_t size) {
  wire::AllOffReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.sequence == static_cast<wire::SequenceState>(0);
}
inline constexpr std::uint8_t kFrame51[] = {11,149,153,3,2,1,2,176,173,27,1,6,4,98,72,205,160,0};
inline constexpr std::uint8_t kPayload51[] = {4};
inline bool matches51(const std::uint8_t* payload, std::size_t size) {
  wire::AllOffReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.sequence == static_cast<wire::SequenceState>(4);
}
inline constexpr std::uint8_t kFrame52[] = {11,32,36,3,2,1,2,176,173,27,63,68,17,2,5,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,226,3,191,7,0};
inline constexpr std::uint8_t kPayload52[] = {17,2,5,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3};
inline bool matches52(const std::uint8_t* payload, std::size_t size) {
  wire::StepChunkRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.first == 529ULL && m.steps_count == 5 && m.steps[0].aperture == 1ULL && m.steps[0].light == 24ULL && m.steps[0].repeat == 12319ULL && m.steps[0].settle_us == 57904910ULL && m.steps[0].exposure_us == 55806241ULL && m.steps[1].aperture == 1ULL && m.steps[1].light == 24ULL && m.steps[1].repeat == 12319ULL && m.steps[1].settle_us == 57904910ULL && m.steps[1].exposure_us == 55806241ULL && m.steps[2].aperture == 1ULL && m.steps[2].light == 24ULL && m.steps[2].repeat == 12319ULL && m.steps[2].settle_us == 57904910ULL && m.steps[2].exposure_us == 55806241ULL && m.steps[3].aperture == 1ULL && m.steps[3].light == 24ULL && m.steps[3].repeat == 12319ULL && m.steps[3].settle_us == 57904910ULL && m.steps[3].exposure_us == 55806241ULL && m.steps[4].aperture == 1ULL && m.steps[4].light == 24ULL && m.steps[4].repeat == 12319ULL && m.steps[4].settle_us == 57904910ULL && m.steps[4].exposure_us == 55806241ULL;
}
inline constexpr std::uint8_t kFrame53[] = {11,32,36,3,2,1,2,176,173,27,3,1,1,1,5,116,228,229,95,0};
inline constexpr std::uint8_t kPayload53[] = {0,0,0};
inline bool matches53(const std::uint8_t* payload, std::size_t size) {
  wire::StepChunkRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.first == 0ULL && m.steps_count == 0;
}
inline constexpr std::uint8_t kFrame54[] = {11,32,36,3,2,1,2,176,173,27,195,8,255,3,16,255,255,255,255,4,135,147,3,8,135,147,3,255,255,255,255,4,135,147,3,8,135,147,3,255,255,255,255,4,135,147,3,8,135,147,3,255,255,255,255,4,135,147,3,8,135,147,3,255,255,255,255,4,135,147,3,8,135,147,3,255,255,255,255,4,135,147,3,8,135,147,3,255,255,255,255,4,135,147,3,8,135,147,3,255,255,255,255,4,135,147,3,8,135,147,3,255,255,255,255,4,135,147,3,8,135,147,3,255,255,255,255,4,135,147,3,8,135,147,3,255,255,255,255,4,135,147,3,8,135,147,3,255,255,255,255,4,135,147,3,8,135,147,3,255,255,255,255,4,135,147,3,8,135,147,3,255,255,255,255,4,135,147,3,8,135,147,3,255,255,255,255,4,135,147,3,8,135,147,3,255,255,255,255,4,135,147,3,8,135,147,3,222,144,58,21,0};
inline constexpr std::uint8_t kPayload54[] = {255,3,16,255,255,255,255,0,135,147,3,0,135,147,3,255,255,255,255,0,135,147,3,0,135,147,3,255,255,255,255,0,135,147,3,0,135,147,3,255,255,255,255,0,135,147,3,0,135,147,3,255,255,255,255,0,135,147,3,0,135,147,3,255,255,255,255,0,135,147,3,0,135,147,3,255,255,255,255,0,135,147,3,0,135,147,3,255,255,255,255,0,135,147,3,0,135,147,3,255,255,255,255,0,135,147,3,0,135,147,3,255,255,255,255,0,135,147,3,0,135,147,3,255,255,255,255,0,135,147,3,0,135,147,3,255,255,255,255,0,135,147,3,0,135,147,3,255,255,255,255,0,135,147,3,0,135,147,3,255,255,255,255,0,135,147,3,0,135,147,3,255,255,255,255,0,135,147,3,0,135,147,3,255,255,255,255,0,135,147,3,0,135,147,3};
inline bool matches54(const std::uint8_t* payload, std::size_t size) {
  wire::StepChunkRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.first == 1023ULL && m.steps_count == 16 && m.steps[0].aperture == 255ULL && m.steps[0].light == 255ULL && m.steps[0].repeat == 65535ULL && m.steps[0].settle_us == 60000000ULL && m.steps[0].exposure_us == 60000000ULL && m.steps[1].aperture == 255ULL && m.steps[1].light == 255ULL && m.steps[1].repeat == 65535ULL && m.steps[1].settle_us == 60000000ULL && m.steps[1].exposure_us == 60000000ULL && m.steps[2].aperture == 255ULL && m.steps[2].light == 255ULL && m.steps[2].repeat == 65535ULL && m.steps[2].settle_us == 60000000ULL && m.steps[2].exposure_us == 60000000ULL && m.steps[3].aperture == 255ULL && m.steps[3].light == 255ULL && m.steps[3].repeat == 65535ULL && m.steps[3].settle_us == 60000000ULL && m.steps[3].exposure_us == 60000000ULL && m.steps[4].aperture == 255ULL && m.steps[4].light == 255ULL && m.steps[4].repeat == 65535ULL && m.steps[4].settle_us == 60000000ULL && m.steps[4].exposure_us == 60000000ULL && m.steps[5].aperture == 255ULL && m.steps[5].light == 255ULL && m.steps[5].repeat == 65535ULL && m.steps[5].settle_us == 60000000ULL && m.steps[5].exposure_us == 60000000ULL && m.steps[6].aperture == 255ULL && m.steps[6].light == 255ULL && m.steps[6].repeat == 65535ULL && m.steps[6].settle_us == 60000000ULL && m.steps[6].exposure_us == 60000000ULL && m.steps[7].aperture == 255ULL && m.steps[7].light == 255ULL && m.steps[7].repeat == 65535ULL && m.steps[7].settle_us == 60000000ULL && m.steps[7].exposure_us == 60000000ULL && m.steps[8].aperture == 255ULL && m.steps[8].light == 255ULL && m.steps[8].repeat == 65535ULL && m.steps[8].settle_us == 60000000ULL && m.steps[8].exposure_us == 60000000ULL && m.steps[9].aperture == 255ULL && m.steps[9].light == 255ULL && m.steps[9].repeat == 65535ULL && m.steps[9].settle_us == 60000000ULL && m.steps[9].exposure_us == 60000000ULL && m.steps[10].aperture == 255ULL && m.steps[10].light == 255ULL && m.steps[10].repeat == 65535ULL && m.steps[10].settle_us == 60000000ULL && m.steps[10].exposure_us == 60000000ULL && m.steps[11].aperture == 255ULL && m.steps[11].light == 255ULL && m.steps[11].repeat == 65535ULL && m.steps[11].settle_us == 60000000ULL && m.steps[11].exposure_us == 60000000ULL && m.steps[12].aperture == 255ULL && m.steps[12].light == 255ULL && m.steps[12].repeat == 65535ULL && m.steps[12].settle_us == 60000000ULL && m.steps[12].exposure_us == 60000000ULL && m.steps[13].aperture == 255ULL && m.steps[13].light == 255ULL && m.steps[13].repeat == 65535ULL && m.steps[13].settle_us == 60000000ULL && m.steps[13].exposure_us == 60000000ULL && m.steps[14].aperture == 255ULL && m.steps[14].light == 255ULL && m.steps[14].repeat == 65535ULL && m.steps[14].settle_us == 60000000ULL && m.steps[14].exposure_us == 60000000ULL && m.steps[15].aperture == 255ULL && m.steps[15].light == 255ULL && m.steps[15].repeat == 65535ULL && m.steps[15].settle_us == 60000000ULL && m.steps[15].exposure_us == 60000000ULL;
}
inline constexpr std::uint8_t kFrame55[] = {11,160,164,3,2,1,2,176,173,27,3,8,17,2,7,231,16,74,205,0};
inline constexpr std::uint8_t kPayload55[] = {17,2,7};
inline bool matches55(const std::uint8_t* payload, std::size_t size) {
  wire::StepChunkReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.first == 529ULL && m.count == 7ULL;
}
inline constexpr std::uint8_t kFrame56[] = {11,160,164,3,2,1,2,176,173,27,3,1,1,1,5,129,46,252,124,0};
inline constexpr std::uint8_t kPayload56[] = {0,0,0};
inline bool matches56(const std::uint8_t* payload, std::size_t size) {
  wire::StepChunkReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.first == 0ULL && m.count == 0ULL;
}
inline constexpr std::uint8_t kFrame57[] = {11,160,164,3,2,1,2,176,173,27,3,8,255,3,16,203,89,254,244,0};
inline constexpr std::uint8_t kPayload57[] = {255,3,16};
inline bool matches57(const std::uint8_t* payload, std::size_t size) {
  wire::StepChunkReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.first == 1023ULL && m.count == 16ULL;
}
inline constexpr std::uint8_t kFrame58[] = {11,33,37,3,2,1,2,176,173,27,6,11,18,2,24,41,58,75,230,217,173,117,0};
inline constexpr std::uint8_t kPayload58[] = {18,2,24,41,58,75};
inline bool matches58(const std::uint8_t* payload, std::size_t size) {
  wire::CommitStepsRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.count == 530ULL && m.crc32 == 1262102808ULL;
}
inline constexpr std::uint8_t kFrame59[] = {11,33,37,3,2,1,2,176,173,27,6,2,1,1,1,1,1,5,205,190,185,236,0};
inline constexpr std::uint8_t kPayload59[] = {1,0,0,0,0,0};
inline bool matches59(const std::uint8_t* payload, std::size_t size) {
  wire::CommitStepsRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.count == 1ULL && m.crc32 == 0ULL;
}
inline constexpr std::uint8_t kFrame60[] = {11,33,37,3,2,1,2,176,173,27,6,1,10,4,255,255,255,255,75,235,222,12,0};
inline constexpr std::uint8_t kPayload60[] = {0,4,255,255,255,255};
inline bool matches60(const std::uint8_t* payload, std::size_t size) {
  wire::CommitStepsRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.count == 1024ULL && m.crc32 == 4294967295ULL;
}
inline constexpr std::uint8_t kFrame61[] = {11,161,165,3,2,1,2,176,173,27,10,15,18,2,24,41,58,75,31,48,65,82,155,244,144,119,0};
inline constexpr std::uint8_t kPayload61[] = {18,2,24,41,58,75,31,48,65,82};
inline bool matches61(const std::uint8_t* payload, std::size_t size) {
  wire::CommitStepsReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.count == 530ULL && m.table_hash == 1262102808ULL && m.exposures == 1380003871ULL;
}
inline constexpr std::uint8_t kFrame62[] = {11,161,165,3,2,1,2,176,173,27,10,2,1,1,1,1,1,1,1,1,1,5,113,17,80,170,0};
inline constexpr std::uint8_t kPayload62[] = {1,0,0,0,0,0,0,0,0,0};
inline bool matches62(const std::uint8_t* payload, std::size_t size) {
  wire::CommitStepsReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.count == 1ULL && m.table_hash == 0ULL && m.exposures == 0ULL;
}
inline constexpr std::uint8_t kFrame63[] = {11,161,165,3,2,1,2,176,173,27,10,1,14,4,255,255,255,255,255,255,255,255,54,43,24,92,0};
inline constexpr std::uint8_t kPayload63[] = {0,4,255,255,255,255,255,255,255,255};
inline bool matches63(const std::uint8_t* payload, std::size_t size) {
  wire::CommitStepsReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.count == 1024ULL && m.table_hash == 4294967295ULL && m.exposures == 4294967295ULL;
}
inline constexpr std::uint8_t kFrame64[] = {11,34,38,3,2,1,2,176,173,27,27,16,17,34,51,68,24,41,58,75,31,48,65,82,13,201,13,3,110,23,1,4,7,144,56,8,59,76,1,252,59,237,15,0};
inline constexpr std::uint8_t kPayload64[] = {17,34,51,68,24,41,58,75,31,48,65,82,13,201,13,0,110,23,0,0,7,144,56,0,59,76,1};
inline bool matches64(const std::uint8_t* payload, std::size_t size) {
  wire::StartRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.run_id == 1144201745ULL && m.table_hash == 1262102808ULL && m.deadline_ms == 1380003871ULL && m.light_lead_us == 903437ULL && m.trigger_us == 5998ULL && m.gap_us == 3706887ULL && m.ready_timeout_ms == 19515ULL && m.require_strobe == true;
}
inline constexpr std::uint8_t kFrame65[] = {11,34,38,3,2,1,2,176,173,27,27,2,1,1,1,1,1,1,1,2,1,1,1,1,1,1,1,2,1,1,1,1,1,1,1,1,1,1,5,106,167,225,158,0};
inline constexpr std::uint8_t kPayload65[] = {1,0,0,0,0,0,0,0,1,0,0,0,0,0,0,0,1,0,0,0,0,0,0,0,0,0,0};
inline bool matches65(const std::uint8_t* payload, std::size_t size) {
  wire::StartRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.run_id == 1ULL && m.table_hash == 0ULL && m.deadline_ms == 1ULL && m.light_lead_us == 0ULL && m.trigger_us == 1ULL && m.gap_us == 0ULL && m.ready_timeout_ms == 0ULL && m.require_strobe == false;
}
inline constexpr std::uint8_t kFrame66[] = {11,34,38,3,2,1,2,176,173,27,27,16,255,255,255,255,255,255,255,255,255,255,255,255,64,66,15,4,160,134,1,4,128,150,152,8,255,255,1,249,99,137,19,0};
inline constexpr std::uint8_t kPayload66[] = {255,255,255,255,255,255,255,255,255,255,255,255,64,66,15,0,160,134,1,0,128,150,152,0,255,255,1};
inline bool matches66(const std::uint8_t* payload, std::size_t size) {
  wire::StartRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.run_id == 4294967295ULL && m.table_hash == 4294967295ULL && m.deadline_ms == 4294967295ULL && m.light_lead_us == 1000000ULL && m.trigger_us == 100000ULL && m.gap_us == 10000000ULL && m.ready_timeout_ms == 65535ULL && m.require_strobe == true;
}
inline constexpr std::uint8_t kFrame67[] = {11,162,166,3,2,1,2,176,173,27,12,17,17,34,51,68,24,41,58,75,31,48,65,82,124,72,239,71,0};
inline constexpr std::uint8_t kPayload67[] = {17,34,51,68,24,41,58,75,31,48,65,82};
inline bool matches67(const std::uint8_t* payload, std::size_t size) {
  wire::StartReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.run_id == 1144201745ULL && m.table_hash == 1262102808ULL && m.exposures == 1380003871ULL;
}
inline constexpr std::uint8_t kFrame68[] = {11,162,166,3,2,1,2,176,173,27,12,2,1,1,1,1,1,1,1,1,1,1,1,5,33,15,18,170,0};
inline constexpr std::uint8_t kPayload68[] = {1,0,0,0,0,0,0,0,0,0,0,0};
inline bool matches68(const std::uint8_t* payload, std::size_t size) {
  wire::StartReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.run_id == 1ULL && m.table_hash == 0ULL && m.exposures == 0ULL;
}
inline constexpr std::uint8_t kFrame69[] = {11,162,166,3,2,1,2,176,173,27,12,17,255,255,255,255,255,255,255,255,255,255,255,255,171,122,251,241,0};
inline constexpr std::uint8_t kPayload69[] = {255,255,255,255,255,255,255,255,255,255,255,255};
inline bool matches69(const std::uint8_t* payload, std::size_t size) {
  wire::StartReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.run_id == 4294967295ULL && m.table_hash == 4294967295ULL && m.exposures == 4294967295ULL;
}
inline constexpr std::uint8_t kFrame70[] = {11,35,39,3,2,1,2,176,173,27,4,9,17,34,51,68,155,130,154,163,0};
inline constexpr std::uint8_t kPayload70[] = {17,34,51,68};
inline bool matches70(const std::uint8_t* payload, std::size_t size) {
  wire::PauseRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.run_id == 1144201745ULL;
}
inline constexpr std::uint8_t kFrame71[] = {11,35,39,3,2,1,2,176,173,27,4,2,1,1,1,5,51,167,144,77,0};
inline constexpr std::uint8_t kPayload71[] = {1,0,0,0};
inline bool matches71(const std::uint8_t* payload, std::size_t size) {
  wire::PauseRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.run_id == 1ULL;
}
inline constexpr std::uint8_t kFrame72[] = {11,35,39,3,2,1,2,176,173,27,4,9,255,255,255,255,181,224,151,43,0};
inline constexpr std::uint8_t kPayload72[] = {255,255,255,255};
inline bool matches72(const std::uint8_t* payload, std::size_t size) {
  wire::PauseRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.run_id == 4294967295ULL;
}
inline constexpr std::uint8_t kFrame73[] = {11,163,167,3,2,1,2,176,173,27,5,10,2,24,41,58,75,105,54,164,248,0};
inline constexpr std::uint8_t kPayload73[] = {2,24,41,58,75};
inline bool matches73(const std::uint8_t* payload, std::size_t size) {
  wire::PauseReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.sequence == static_cast<wire::SequenceState>(2) && m.exposures == 1262102808ULL;
}
inline constexpr std::uint8_t kFrame74[] = {11,163,167,3,2,1,2,176,173,27,5,1,1,1,1,1,5,119,33,242,228,0};
inline constexpr std::uint8_t kPayload74[] = {0,0,0,0,0};
inline bool matches74(const std::uint8_t* payload, std::size_t size) {
  wire::PauseReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.sequence == static_cast<wire::SequenceState>(0) && m.exposures == 0ULL;
}
inline constexpr std::uint8_t kFrame75[] = {11,163,167,3,2,1,2,176,173,27,5,10,4,255,255,255,255,84,167,201,207,0};
inline constexpr std::uint8_t kPayload75[] = {4,255,255,255,255};
inline bool matches75(const std::uint8_t* payload, std::size_t size) {
  wire::PauseReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.sequence == static_cast<wire::SequenceState>(4) && m.exposures == 4294967295ULL;
}
inline constexpr std::uint8_t kFrame76[] = {11,36,40,3,2,1,2,176,173,27,4,9,17,34,51,68,119,57,15,110,0};
inline constexpr std::uint8_t kPayload76[] = {17,34,51,68};
inline bool matches76(const std::uint8_t* payload, std::size_t size) {
  wire::ResumeRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.run_id == 1144201745ULL;
}
inline constexpr std::uint8_t kFrame77[] = {11,36,40,3,2,1,2,176,173,27,4,2,1,1,1,5,223,28,5,128,0};
inline constexpr std::uint8_t kPayload77[] = {1,0,0,0};
inline bool matches77(const std::uint8_t* payload, std::size_t size) {
  wire::ResumeRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.run_id == 1ULL;
}
inline constexpr std::uint8_t kFrame78[] = {11,36,40,3,2,1,2,176,173,27,4,9,255,255,255,255,89,91,2,230,0};
inline constexpr std::uint8_t kPayload78[] = {255,255,255,255};
inline bool matches78(const std::uint8_t* payload, std::size_t size) {
  wire::ResumeRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.run_id == 4294967295ULL;
}
inline constexpr std::uint8_t kFrame79[] = {11,164,168,3,2,1,2,176,173,27,5,10,2,24,41,58,75,129,13,213,81,0};
inline constexpr std::uint8_t kPayload79[] = {2,24,41,58,75};
inline bool matches79(const std::uint8_t* payload, std::size_t size) {
  wire::ResumeReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.sequence == static_cast<wire::SequenceState>(2) && m.exposures == 1262102808ULL;
}
inline constexpr std::uint8_t kFrame80[] = {11,164,168,3,2,1,2,176,173,27,5,1,1,1,1,1,5,159,26,131,77,0};
inline constexpr std::uint8_t kPayload80[] = {0,0,0,0,0};
inline bool matches80(const std::uint8_t* payload, std::size_t size) {
  wire::ResumeReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.sequence == static_cast<wire::SequenceState>(0) && m.exposures == 0ULL;
}
inline constexpr std::uint8_t kFrame81[] = {11,164,168,3,2,1,2,176,173,27,5,10,4,255,255,255,255,188,156,184,102,0};
inline constexpr std::uint8_t kPayload81[] = {4,255,255,255,255};
inline bool matches81(const std::uint8_t* payload, std::size_t size) {
  wire::ResumeReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.sequence == static_cast<wire::SequenceState>(4) && m.exposures == 4294967295ULL;
}
inline constexpr std::uint8_t kFrame82[] = {11,37,41,3,2,1,2,176,173,27,4,9,17,34,51,68,233,3,251,74,0};
inline constexpr std::uint8_t kPayload82[] = {17,34,51,68};
inline bool matches82(const std::uint8_t* payload, std::size_t size) {
  wire::AbortRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.run_id == 1144201745ULL;
}
inline constexpr std::uint8_t kFrame83[] = {11,37,41,3,2,1,2,176,173,27,4,1,1,1,1,5,36,65,77,28,0};
inline constexpr std::uint8_t kPayload83[] = {0,0,0,0};
inline bool matches83(const std::uint8_t* payload, std::size_t size) {
  wire::AbortRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.run_id == 0ULL;
}
inline constexpr std::uint8_t kFrame84[] = {11,37,41,3,2,1,2,176,173,27,4,9,255,255,255,255,199,97,246,194,0};
inline constexpr std::uint8_t kPayload84[] = {255,255,255,255};
inline bool matches84(const std::uint8_t* payload, std::size_t size) {
  wire::AbortRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.run_id == 4294967295ULL;
}
inline constexpr std::uint8_t kFrame85[] = {11,165,169,3,2,1,2,176,173,27,5,10,2,24,41,58,75,248,71,70,70,0};
inline constexpr std::uint8_t kPayload85[] = {2,24,41,58,75};
inline bool matches85(const std::uint8_t* payload, std::size_t size) {
  wire::AbortReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.sequence == static_cast<wire::SequenceState>(2) && m.exposures == 1262102808ULL;
}
inline constexpr std::uint8_t kFrame86[] = {11,165,169,3,2,1,2,176,173,27,5,1,1,1,1,1,5,230,80,16,90,0};
inline constexpr std::uint8_t kPayload86[] = {0,0,0,0,0};
inline bool matches86(const std::uint8_t* payload, std::size_t size) {
  wire::AbortReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.sequence == static_cast<wire::SequenceState>(0) && m.exposures == 0ULL;
}
inline constexpr std::uint8_t kFrame87[] = {11,165,169,3,2,1,2,176,173,27,5,10,4,255,255,255,255,197,214,43,113,0};
inline constexpr std::uint8_t kPayload87[] = {4,255,255,255,255};
inline bool matches87(const std::uint8_t* payload, std::size_t size) {
  wire::AbortReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.sequence == static_cast<wire::SequenceState>(4) && m.exposures == 4294967295ULL;
}
inline constexpr std::uint8_t kFrame88[] = {11,38,42,3,2,1,2,176,173,27,1,6,5,98,235,211,18,0};
inline constexpr std::uint8_t kPayload88[] = {5};
inline bool matches88(const std::uint8_t* payload, std::size_t size) {
  wire::ClearFaultRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.reason == static_cast<wire::FaultReason>(5);
}
inline constexpr std::uint8_t kFrame89[] = {11,38,42,3,2,1,2,176,173,27,1,1,5,237,31,185,98,0};
inline constexpr std::uint8_t kPayload89[] = {0};
inline bool matches89(const std::uint8_t* payload, std::size_t size) {
  wire::ClearFaultRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.reason == static_cast<wire::FaultReason>(0);
}
inline constexpr std::uint8_t kFrame90[] = {11,38,42,3,2,1,2,176,173,27,1,6,9,73,167,101,27,0};
inline constexpr std::uint8_t kPayload90[] = {9};
inline bool matches90(const std::uint8_t* payload, std::size_t size) {
  wire::ClearFaultRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.reason == static_cast<wire::FaultReason>(9);
}
inline constexpr std::uint8_t kFrame91[] = {11,166,170,3,2,1,2,176,173,27,1,6,5,29,177,245,5,0};
inline constexpr std::uint8_t kPayload91[] = {5};
inline bool matches91(const std::uint8_t* payload, std::size_t size) {
  wire::ClearFaultReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.fault == static_cast<wire::FaultReason>(5);
}
inline constexpr std::uint8_t kFrame92[] = {11,166,170,3,2,1,2,176,173,27,1,1,5,146,69,159,117,0};
inline constexpr std::uint8_t kPayload92[] = {0};
inline bool matches92(const std::uint8_t* payload, std::size_t size) {
  wire::ClearFaultReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.fault == static_cast<wire::FaultReason>(0);
}
inline constexpr std::uint8_t kFrame93[] = {11,166,170,3,2,1,2,176,173,27,1,6,9,54,253,67,12,0};
inline constexpr std::uint8_t kPayload93[] = {9};
inline bool matches93(const std::uint8_t* payload, std::size_t size) {
  wire::ClearFaultReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.fault == static_cast<wire::FaultReason>(9);
}
inline constexpr std::uint8_t kFrame94[] = {11,39,43,3,2,1,2,176,173,27,5,10,17,34,51,68,1,130,225,200,245,0};
inline constexpr std::uint8_t kPayload94[] = {17,34,51,68,1};
inline bool matches94(const std::uint8_t* payload, std::size_t size) {
  wire::AcknowledgeEventsRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.next_event == 1144201745ULL && m.resend == true;
}
inline constexpr std::uint8_t kFrame95[] = {11,39,43,3,2,1,2,176,173,27,5,1,1,1,1,1,5,91,217,76,103,0};
inline constexpr std::uint8_t kPayload95[] = {0,0,0,0,0};
inline bool matches95(const std::uint8_t* payload, std::size_t size) {
  wire::AcknowledgeEventsRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.next_event == 0ULL && m.resend == false;
}
inline constexpr std::uint8_t kFrame96[] = {11,39,43,3,2,1,2,176,173,27,5,10,255,255,255,255,1,47,225,150,41,0};
inline constexpr std::uint8_t kPayload96[] = {255,255,255,255,1};
inline bool matches96(const std::uint8_t* payload, std::size_t size) {
  wire::AcknowledgeEventsRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.next_event == 4294967295ULL && m.resend == true;
}
inline constexpr std::uint8_t kFrame97[] = {11,167,171,3,2,1,2,176,173,27,8,13,17,34,51,68,24,41,58,75,92,8,132,208,0};
inline constexpr std::uint8_t kPayload97[] = {17,34,51,68,24,41,58,75};
inline bool matches97(const std::uint8_t* payload, std::size_t size) {
  wire::AcknowledgeEventsReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.oldest_event == 1144201745ULL && m.next_event == 1262102808ULL;
}
inline constexpr std::uint8_t kFrame98[] = {11,167,171,3,2,1,2,176,173,27,8,1,1,1,1,1,1,1,1,5,168,222,188,113,0};
inline constexpr std::uint8_t kPayload98[] = {0,0,0,0,0,0,0,0};
inline bool matches98(const std::uint8_t* payload, std::size_t size) {
  wire::AcknowledgeEventsReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.oldest_event == 0ULL && m.next_event == 0ULL;
}
inline constexpr std::uint8_t kFrame99[] = {11,167,171,3,2,1,2,176,173,27,8,13,255,255,255,255,255,255,255,255,221,222,218,53,0};
inline constexpr std::uint8_t kPayload99[] = {255,255,255,255,255,255,255,255};
inline bool matches99(const std::uint8_t* payload, std::size_t size) {
  wire::AcknowledgeEventsReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.oldest_event == 4294967295ULL && m.next_event == 4294967295ULL;
}
inline constexpr std::uint8_t kFrame100[] = {10,48,52,3,2,1,2,176,173,27,1,5,232,204,87,13,0};
inline bool matches100(const std::uint8_t* payload, std::size_t size) {
  wire::CountersRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size);
}
inline constexpr std::uint8_t kFrame101[] = {11,176,180,3,2,1,2,176,173,27,56,61,17,34,51,68,24,41,58,75,31,48,65,82,38,55,72,89,45,62,79,96,52,69,86,103,59,76,93,110,66,83,100,117,73,90,107,124,80,97,114,131,87,104,121,138,94,111,128,145,101,118,135,152,108,125,142,159,58,181,106,131,0};
inline constexpr std::uint8_t kPayload101[] = {17,34,51,68,24,41,58,75,31,48,65,82,38,55,72,89,45,62,79,96,52,69,86,103,59,76,93,110,66,83,100,117,73,90,107,124,80,97,114,131,87,104,121,138,94,111,128,145,101,118,135,152,108,125,142,159};
inline bool matches101(const std::uint8_t* payload, std::size_t size) {
  wire::CountersReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.frames_received == 1144201745ULL && m.frames_sent == 1262102808ULL && m.crc_errors == 1380003871ULL && m.framing_errors == 1497904934ULL && m.overruns == 1615805997ULL && m.rejected == 1733707060ULL && m.failed == 1851608123ULL && m.retries_answered == 1969509186ULL && m.wrong_nonce == 2087410249ULL && m.events_sent == 2205311312ULL && m.events_resent == 2323212375ULL && m.exposures == 2441113438ULL && m.link_timeouts == 2559014501ULL && m.faults == 2676915564ULL;
}
inline constexpr std::uint8_t kFrame102[] = {11,176,180,3,2,1,2,176,173,27,56,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,5,249,123,13,206,0};
inline constexpr std::uint8_t kPayload102[] = {0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0};
inline bool matches102(const std::uint8_t* payload, std::size_t size) {
  wire::CountersReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.frames_received == 0ULL && m.frames_sent == 0ULL && m.crc_errors == 0ULL && m.framing_errors == 0ULL && m.overruns == 0ULL && m.rejected == 0ULL && m.failed == 0ULL && m.retries_answered == 0ULL && m.wrong_nonce == 0ULL && m.events_sent == 0ULL && m.events_resent == 0ULL && m.exposures == 0ULL && m.link_timeouts == 0ULL && m.faults == 0ULL;
}
inline constexpr std::uint8_t kFrame103[] = {11,176,180,3,2,1,2,176,173,27,56,61,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,75,117,126,197,0};
inline constexpr std::uint8_t kPayload103[] = {255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255};
inline bool matches103(const std::uint8_t* payload, std::size_t size) {
  wire::CountersReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.frames_received == 4294967295ULL && m.frames_sent == 4294967295ULL && m.crc_errors == 4294967295ULL && m.framing_errors == 4294967295ULL && m.overruns == 4294967295ULL && m.rejected == 4294967295ULL && m.failed == 4294967295ULL && m.retries_answered == 4294967295ULL && m.wrong_nonce == 4294967295ULL && m.events_sent == 4294967295ULL && m.events_resent == 4294967295ULL && m.exposures == 4294967295ULL && m.link_timeouts == 4294967295ULL && m.faults == 4294967295ULL;
}
inline constexpr std::uint8_t kFrame104[] = {10,49,53,3,2,1,2,176,173,27,1,5,22,120,27,35,0};
inline bool matches104(const std::uint8_t* payload, std::size_t size) {
  wire::GetSettingsRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size);
}
inline constexpr std::uint8_t kFrame105[] = {11,177,181,3,2,1,2,176,173,27,20,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,9,1,1,38,5,241,233,253,58,0};
inline constexpr std::uint8_t kPayload105[] = {115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,0,1,1,38,5};
inline bool matches105(const std::uint8_t* payload, std::size_t size) {
  wire::GetSettingsReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && std::strncmp(m.serial_number, "serial_number-0", 16) == 0 && m.glass_variant == static_cast<wire::GlassVariant>(1) && m.mounting == static_cast<wire::Mounting>(1) && m.contrast == 38ULL && m.resistor_ratio == 5ULL;
}
inline constexpr std::uint8_t kFrame106[] = {11,177,181,3,2,1,2,176,173,27,20,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,5,145,19,247,110,0};
inline constexpr std::uint8_t kPayload106[] = {0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0};
inline bool matches106(const std::uint8_t* payload, std::size_t size) {
  wire::GetSettingsReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && std::strncmp(m.serial_number, "", 16) == 0 && m.glass_variant == static_cast<wire::GlassVariant>(0) && m.mounting == static_cast<wire::Mounting>(0) && m.contrast == 0ULL && m.resistor_ratio == 0ULL;
}
inline constexpr std::uint8_t kFrame107[] = {11,177,181,3,2,1,2,176,173,27,20,25,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,2,1,63,7,75,148,126,122,0};
inline constexpr std::uint8_t kPayload107[] = {126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,2,1,63,7};
inline bool matches107(const std::uint8_t* payload, std::size_t size) {
  wire::GetSettingsReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && std::strncmp(m.serial_number, "~~~~~~~~~~~~~~~~", 16) == 0 && m.glass_variant == static_cast<wire::GlassVariant>(2) && m.mounting == static_cast<wire::Mounting>(1) && m.contrast == 63ULL && m.resistor_ratio == 7ULL;
}
inline constexpr std::uint8_t kFrame108[] = {11,50,54,3,2,1,2,176,173,27,20,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,9,1,1,38,5,140,104,199,66,0};
inline constexpr std::uint8_t kPayload108[] = {115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,0,1,1,38,5};
inline bool matches108(const std::uint8_t* payload, std::size_t size) {
  wire::SetSettingsRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && std::strncmp(m.serial_number, "serial_number-0", 16) == 0 && m.glass_variant == static_cast<wire::GlassVariant>(1) && m.mounting == static_cast<wire::Mounting>(1) && m.contrast == 38ULL && m.resistor_ratio == 5ULL;
}
inline constexpr std::uint8_t kFrame109[] = {11,50,54,3,2,1,2,176,173,27,20,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,5,236,146,205,22,0};
inline constexpr std::uint8_t kPayload109[] = {0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0};
inline bool matches109(const std::uint8_t* payload, std::size_t size) {
  wire::SetSettingsRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && std::strncmp(m.serial_number, "", 16) == 0 && m.glass_variant == static_cast<wire::GlassVariant>(0) && m.mounting == static_cast<wire::Mounting>(0) && m.contrast == 0ULL && m.resistor_ratio == 0ULL;
}
inline constexpr std::uint8_t kFrame110[] = {11,50,54,3,2,1,2,176,173,27,20,25,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,2,1,63,7,54,21,68,2,0};
inline constexpr std::uint8_t kPayload110[] = {126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,2,1,63,7};
inline bool matches110(const std::uint8_t* payload, std::size_t size) {
  wire::SetSettingsRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && std::strncmp(m.serial_number, "~~~~~~~~~~~~~~~~", 16) == 0 && m.glass_variant == static_cast<wire::GlassVariant>(2) && m.mounting == static_cast<wire::Mounting>(1) && m.contrast == 63ULL && m.resistor_ratio == 7ULL;
}
inline constexpr std::uint8_t kFrame111[] = {11,178,182,3,2,1,2,176,173,27,20,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,9,1,1,38,5,154,245,116,109,0};
inline constexpr std::uint8_t kPayload111[] = {115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,0,1,1,38,5};
inline bool matches111(const std::uint8_t* payload, std::size_t size) {
  wire::SetSettingsReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && std::strncmp(m.serial_number, "serial_number-0", 16) == 0 && m.glass_variant == static_cast<wire::GlassVariant>(1) && m.mounting == static_cast<wire::Mounting>(1) && m.contrast == 38ULL && m.resistor_ratio == 5ULL;
}
inline constexpr std::uint8_t kFrame112[] = {11,178,182,3,2,1,2,176,173,27,20,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,5,250,15,126,57,0};
inline constexpr std::uint8_t kPayload112[] = {0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0};
inline bool matches112(const std::uint8_t* payload, std::size_t size) {
  wire::SetSettingsReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && std::strncmp(m.serial_number, "", 16) == 0 && m.glass_variant == static_cast<wire::GlassVariant>(0) && m.mounting == static_cast<wire::Mounting>(0) && m.contrast == 0ULL && m.resistor_ratio == 0ULL;
}
inline constexpr std::uint8_t kFrame113[] = {11,178,182,3,2,1,2,176,173,27,20,25,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,2,1,63,7,32,136,247,45,0};
inline constexpr std::uint8_t kPayload113[] = {126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,126,2,1,63,7};
inline bool matches113(const std::uint8_t* payload, std::size_t size) {
  wire::SetSettingsReply m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && std::strncmp(m.serial_number, "~~~~~~~~~~~~~~~~", 16) == 0 && m.glass_variant == static_cast<wire::GlassVariant>(2) && m.mounting == static_cast<wire::Mounting>(1) && m.contrast == 63ULL && m.resistor_ratio == 7ULL;
}
inline constexpr std::uint8_t kFrame114[] = {10,51,55,3,2,1,2,176,173,27,1,5,234,17,130,127,0};
inline bool matches114(const std::uint8_t* payload, std::size_t size) {
  wire::GetLedCorrectionRequest m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size);
}
inline constexpr std::uint8_t kFrame115[] = {11,179,183,3,2,1,2,176,173,27,48,53,17,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,90,206,250,13,153,0};
inline constexpr std::uint8_t kPayload115[] = {17,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,90};
inline bool matches115(const std::uint8_t* payload, std::size_t size) {
  wire::GetLedCorrectionReply m;
  static constexpr std::uint8_t factors[] = {17,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,90};
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && std::memcmp(m.factors, factors, sizeof factors) == 0;
}
inline constexpr std::uint8_t kFrame116[] = {11,179,183,3,2,1,2,176,173,27,48,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,5,180,91,20,236,0};
inline constexpr std::uint8_t kPayload116[] = {0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0};
inline bool matches116(const std::uint8_t* payload, std::size_t size) {
  wire::GetLedCorrectionReply m;
  static constexpr std::uint8_t factors[] = {0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0};
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && std::memcmp(m.factors, factors, sizeof factors) == 0;
}
inline constexpr std::uint8_t kFrame117[] = {11,179,183,3,2,1,2,176,173,27,48,53,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,132,248,0};
inline constexpr std::uint8_t kPayload117[] = {255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255};
inline bool matches117(const std::uint8_t* payload, std::size_t size) {
  wire::GetLedCorrectionReply m;
  static constexpr std::uint8_t factors[] = {255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255};
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && std::memcmp(m.factors, factors, sizeof factors) == 0;
}
inline constexpr std::uint8_t kFrame118[] = {11,52,56,3,2,1,2,176,173,27,48,53,17,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,90,96,214,153,140,0};
inline constexpr std::uint8_t kPayload118[] = {17,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,90};
inline bool matches118(const std::uint8_t* payload, std::size_t size) {
  wire::SetLedCorrectionRequest m;
  static constexpr std::uint8_t factors[] = {17,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,90};
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && std::memcmp(m.factors, factors, sizeof factors) == 0;
}
inline constexpr std::uint8_t kFrame119[] = {11,52,56,3,2,1,2,176,173,27,48,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,5,26,119,128,249,0};
inline constexpr std::uint8_t kPayload119[] = {0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0};
inline bool matches119(const std::uint8_t* payload, std::size_t size) {
  wire::SetLedCorrectionRequest m;
  static constexpr std::uint8_t factors[] = {0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0};
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && std::memcmp(m.factors, factors, sizeof factors) == 0;
}
inline constexpr std::uint8_t kFrame120[] = {11,52,56,3,2,1,2,176,173,27,48,53,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,81,211,16,237,0};
inline constexpr std::uint8_t kPayload120[] = {255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255};
inline bool matches120(const std::uint8_t* payload, std::size_t size) {
  wire::SetLedCorrectionRequest m;
  static constexpr std::uint8_t factors[] = {255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255};
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && std::memcmp(m.factors, factors, sizeof factors) == 0;
}
inline constexpr std::uint8_t kFrame121[] = {11,180,184,3,2,1,2,176,173,27,48,53,17,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,90,187,187,23,72,0};
inline constexpr std::uint8_t kPayload121[] = {17,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,90};
inline bool matches121(const std::uint8_t* payload, std::size_t size) {
  wire::SetLedCorrectionReply m;
  static constexpr std::uint8_t factors[] = {17,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,90};
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && std::memcmp(m.factors, factors, sizeof factors) == 0;
}
inline constexpr std::uint8_t kFrame122[] = {11,180,184,3,2,1,2,176,173,27,48,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,5,193,26,14,61,0};
inline constexpr std::uint8_t kPayload122[] = {0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0};
inline bool matches122(const std::uint8_t* payload, std::size_t size) {
  wire::SetLedCorrectionReply m;
  static constexpr std::uint8_t factors[] = {0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0};
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && std::memcmp(m.factors, factors, sizeof factors) == 0;
}
inline constexpr std::uint8_t kFrame123[] = {11,180,184,3,2,1,2,176,173,27,48,53,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,138,190,158,41,0};
inline constexpr std::uint8_t kPayload123[] = {255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255};
inline bool matches123(const std::uint8_t* payload, std::size_t size) {
  wire::SetLedCorrectionReply m;
  static constexpr std::uint8_t factors[] = {255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255};
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && std::memcmp(m.factors, factors, sizeof factors) == 0;
}
inline constexpr std::uint8_t kFrame124[] = {11,254,2,4,2,1,2,176,173,27,6,11,19,24,31,48,65,82,125,165,255,245,0};
inline constexpr std::uint8_t kPayload124[] = {19,24,31,48,65,82};
inline bool matches124(const std::uint8_t* payload, std::size_t size) {
  wire::Rejected m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.code == static_cast<wire::ErrorCode>(19) && m.message == 24ULL && m.detail == 1380003871ULL;
}
inline constexpr std::uint8_t kFrame125[] = {11,254,2,4,2,1,2,176,173,27,6,1,1,1,1,1,1,5,206,229,59,96,0};
inline constexpr std::uint8_t kPayload125[] = {0,0,0,0,0,0};
inline bool matches125(const std::uint8_t* payload, std::size_t size) {
  wire::Rejected m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.code == static_cast<wire::ErrorCode>(0) && m.message == 0ULL && m.detail == 0ULL;
}
inline constexpr std::uint8_t kFrame126[] = {11,254,2,4,2,1,2,176,173,27,6,11,29,255,255,255,255,255,228,19,172,203,0};
inline constexpr std::uint8_t kPayload126[] = {29,255,255,255,255,255};
inline bool matches126(const std::uint8_t* payload, std::size_t size) {
  wire::Rejected m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.code == static_cast<wire::ErrorCode>(29) && m.message == 255ULL && m.detail == 4294967295ULL;
}
inline constexpr std::uint8_t kFrame127[] = {11,255,3,4,2,1,2,176,173,27,6,11,19,24,31,48,65,82,175,255,49,220,0};
inline constexpr std::uint8_t kPayload127[] = {19,24,31,48,65,82};
inline bool matches127(const std::uint8_t* payload, std::size_t size) {
  wire::Failed m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.code == static_cast<wire::ErrorCode>(19) && m.message == 24ULL && m.detail == 1380003871ULL;
}
inline constexpr std::uint8_t kFrame128[] = {11,255,3,4,2,1,2,176,173,27,6,1,1,1,1,1,1,5,28,191,245,73,0};
inline constexpr std::uint8_t kPayload128[] = {0,0,0,0,0,0};
inline bool matches128(const std::uint8_t* payload, std::size_t size) {
  wire::Failed m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.code == static_cast<wire::ErrorCode>(0) && m.message == 0ULL && m.detail == 0ULL;
}
inline constexpr std::uint8_t kFrame129[] = {11,255,3,4,2,1,2,176,173,27,6,11,29,255,255,255,255,255,54,73,98,226,0};
inline constexpr std::uint8_t kPayload129[] = {29,255,255,255,255,255};
inline bool matches129(const std::uint8_t* payload, std::size_t size) {
  wire::Failed m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.code == static_cast<wire::ErrorCode>(29) && m.message == 255ULL && m.detail == 4294967295ULL;
}
inline constexpr std::uint8_t kFrame130[] = {11,64,68,3,2,1,2,176,173,27,1,6,4,34,175,25,160,0};
inline constexpr std::uint8_t kPayload130[] = {4};
inline bool matches130(const std::uint8_t* payload, std::size_t size) {
  wire::BootedEvent m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.reset_cause == static_cast<wire::ResetCause>(4);
}
inline constexpr std::uint8_t kFrame131[] = {11,64,68,3,2,1,2,176,173,27,1,1,5,59,107,116,167,0};
inline constexpr std::uint8_t kPayload131[] = {0};
inline bool matches131(const std::uint8_t* payload, std::size_t size) {
  wire::BootedEvent m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.reset_cause == static_cast<wire::ResetCause>(0);
}
inline constexpr std::uint8_t kFrame132[] = {11,64,68,3,2,1,2,176,173,27,1,6,7,152,254,16,57,0};
inline constexpr std::uint8_t kPayload132[] = {7};
inline bool matches132(const std::uint8_t* payload, std::size_t size) {
  wire::BootedEvent m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.reset_cause == static_cast<wire::ResetCause>(7);
}
inline constexpr std::uint8_t kFrame133[] = {11,65,69,3,2,1,2,176,173,27,35,40,17,34,51,68,24,41,58,75,31,48,65,82,38,3,45,62,4,27,66,83,100,117,134,151,168,185,73,90,107,124,80,97,114,131,2,31,190,186,210,0};
inline constexpr std::uint8_t kPayload133[] = {17,34,51,68,24,41,58,75,31,48,65,82,38,3,45,62,4,27,66,83,100,117,134,151,168,185,73,90,107,124,80,97,114,131,2};
inline bool matches133(const std::uint8_t* payload, std::size_t size) {
  wire::ExposureEvent m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.table_hash == 1144201745ULL && m.run_id == 1262102808ULL && m.index == 1380003871ULL && m.step == 806ULL && m.repeat == 15917ULL && m.aperture == 4ULL && m.light == 27ULL && m.start_us == 13378109296854979394ULL && m.settle_waited_us == 2087410249ULL && m.exposure_us == 2205311312ULL && m.flags == 2ULL;
}
inline constexpr std::uint8_t kFrame134[] = {11,65,69,3,2,1,2,176,173,27,35,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,5,122,206,44,227,0};
inline constexpr std::uint8_t kPayload134[] = {0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0};
inline bool matches134(const std::uint8_t* payload, std::size_t size) {
  wire::ExposureEvent m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.table_hash == 0ULL && m.run_id == 0ULL && m.index == 0ULL && m.step == 0ULL && m.repeat == 0ULL && m.aperture == 0ULL && m.light == 0ULL && m.start_us == 0ULL && m.settle_waited_us == 0ULL && m.exposure_us == 0ULL && m.flags == 0ULL;
}
inline constexpr std::uint8_t kFrame135[] = {11,65,69,3,2,1,2,176,173,27,35,40,255,255,255,255,255,255,255,255,255,255,255,255,255,3,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,3,191,112,171,229,0};
inline constexpr std::uint8_t kPayload135[] = {255,255,255,255,255,255,255,255,255,255,255,255,255,3,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,3};
inline bool matches135(const std::uint8_t* payload, std::size_t size) {
  wire::ExposureEvent m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.table_hash == 4294967295ULL && m.run_id == 4294967295ULL && m.index == 4294967295ULL && m.step == 1023ULL && m.repeat == 65535ULL && m.aperture == 255ULL && m.light == 255ULL && m.start_us == 18446744073709551615ULL && m.settle_waited_us == 4294967295ULL && m.exposure_us == 4294967295ULL && m.flags == 3ULL;
}
inline constexpr std::uint8_t kFrame136[] = {11,66,70,3,2,1,2,176,173,27,21,26,3,24,41,58,75,31,48,65,82,38,55,72,89,45,62,79,96,113,130,147,164,53,175,234,208,0};
inline constexpr std::uint8_t kPayload136[] = {3,24,41,58,75,31,48,65,82,38,55,72,89,45,62,79,96,113,130,147,164};
inline bool matches136(const std::uint8_t* payload, std::size_t size) {
  wire::SequenceEvent m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.news == static_cast<wire::SequenceNews>(3) && m.run_id == 1262102808ULL && m.table_hash == 1380003871ULL && m.exposures == 1497904934ULL && m.at_us == 11858965667255369261ULL;
}
inline constexpr std::uint8_t kFrame137[] = {11,66,70,3,2,1,2,176,173,27,21,2,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,5,42,68,101,203,0};
inline constexpr std::uint8_t kPayload137[] = {1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0};
inline bool matches137(const std::uint8_t* payload, std::size_t size) {
  wire::SequenceEvent m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.news == static_cast<wire::SequenceNews>(1) && m.run_id == 0ULL && m.table_hash == 0ULL && m.exposures == 0ULL && m.at_us == 0ULL;
}
inline constexpr std::uint8_t kFrame138[] = {11,66,70,3,2,1,2,176,173,27,21,26,5,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,172,169,190,250,0};
inline constexpr std::uint8_t kPayload138[] = {5,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255};
inline bool matches138(const std::uint8_t* payload, std::size_t size) {
  wire::SequenceEvent m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.news == static_cast<wire::SequenceNews>(5) && m.run_id == 4294967295ULL && m.table_hash == 4294967295ULL && m.exposures == 4294967295ULL && m.at_us == 18446744073709551615ULL;
}
inline constexpr std::uint8_t kFrame139[] = {11,67,71,3,2,1,2,176,173,27,19,24,5,24,41,58,75,31,48,38,55,72,89,106,123,140,157,45,62,79,96,158,228,210,85,0};
inline constexpr std::uint8_t kPayload139[] = {5,24,41,58,75,31,48,38,55,72,89,106,123,140,157,45,62,79,96};
inline bool matches139(const std::uint8_t* payload, std::size_t size) {
  wire::FaultEvent m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.reason == static_cast<wire::FaultReason>(5) && m.run_id == 1262102808ULL && m.step == 12319ULL && m.at_us == 11352584457388832550ULL && m.detail == 1615805997ULL;
}
inline constexpr std::uint8_t kFrame140[] = {11,67,71,3,2,1,2,176,173,27,19,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,5,91,120,219,55,0};
inline constexpr std::uint8_t kPayload140[] = {0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0};
inline bool matches140(const std::uint8_t* payload, std::size_t size) {
  wire::FaultEvent m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.reason == static_cast<wire::FaultReason>(0) && m.run_id == 0ULL && m.step == 0ULL && m.at_us == 0ULL && m.detail == 0ULL;
}
inline constexpr std::uint8_t kFrame141[] = {11,67,71,3,2,1,2,176,173,27,19,24,9,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,38,136,86,179,0};
inline constexpr std::uint8_t kPayload141[] = {9,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255};
inline bool matches141(const std::uint8_t* payload, std::size_t size) {
  wire::FaultEvent m;
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.reason == static_cast<wire::FaultReason>(9) && m.run_id == 4294967295ULL && m.step == 65535ULL && m.at_us == 18446744073709551615ULL && m.detail == 4294967295ULL;
}
inline constexpr std::uint8_t kFrame142[] = {14,17,21,3,2,1,2,176,173,27,2,1,3,2,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,5,251,215,211,146,0};
inline constexpr std::uint8_t kPayload142[] = {3,2,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0};
inline bool matches142(const std::uint8_t* payload, std::size_t size) {
  wire::ApertureChunkRequest m;
  static constexpr std::uint8_t data[] = {0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0};
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 3ULL && m.chunk == 2ULL && std::memcmp(m.data, data, sizeof data) == 0;
}
inline constexpr std::uint8_t kFrame143[] = {255,17,21,3,2,1,2,176,173,27,2,1,3,2,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,20,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,130,250,237,97,0};
inline constexpr std::uint8_t kPayload143[] = {3,2,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255};
inline bool matches143(const std::uint8_t* payload, std::size_t size) {
  wire::ApertureChunkRequest m;
  static constexpr std::uint8_t data[] = {255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255,255};
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 3ULL && m.chunk == 2ULL && std::memcmp(m.data, data, sizeof data) == 0;
}
inline constexpr std::uint8_t kFrame144[] = {14,17,21,3,2,1,2,176,173,27,2,1,3,2,254,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,1,5,237,234,55,93,0};
inline constexpr std::uint8_t kPayload144[] = {3,2,0,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,0,0};
inline bool matches144(const std::uint8_t* payload, std::size_t size) {
  wire::ApertureChunkRequest m;
  static constexpr std::uint8_t data[] = {0,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,0,0};
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 3ULL && m.chunk == 2ULL && std::memcmp(m.data, data, sizeof data) == 0;
}
inline constexpr std::uint8_t kFrame145[] = {14,17,21,3,2,1,2,176,173,27,2,1,3,2,255,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,1,5,51,95,99,29,0};
inline constexpr std::uint8_t kPayload145[] = {3,2,0,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,0};
inline bool matches145(const std::uint8_t* payload, std::size_t size) {
  wire::ApertureChunkRequest m;
  static constexpr std::uint8_t data[] = {0,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,0};
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 3ULL && m.chunk == 2ULL && std::memcmp(m.data, data, sizeof data) == 0;
}
inline constexpr std::uint8_t kFrame146[] = {14,17,21,3,2,1,2,176,173,27,2,1,3,2,255,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,6,90,217,231,221,150,0};
inline constexpr std::uint8_t kPayload146[] = {3,2,0,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90};
inline bool matches146(const std::uint8_t* payload, std::size_t size) {
  wire::ApertureChunkRequest m;
  static constexpr std::uint8_t data[] = {0,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90,90};
  return wire::decode(m, payload, size).code == wire::ErrorCode::kOk && encodes_to(m, payload, size) && m.slot == 3ULL && m.chunk == 2ULL && std::memcmp(m.data, data, sizeof data) == 0;
}
inline constexpr std::uint8_t kFrame147[] = {11,1,5,3,2,1,2,176,173,27,1,6,1,29,102,115,108,0};
inline constexpr std::uint8_t kPayload147[] = {1};
inline constexpr std::uint8_t kFrame148[] = {11,129,133,3,2,1,2,176,173,27,109,45,17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,102,105,114,109,119,97,114,101,95,118,101,114,115,105,111,110,103,105,116,95,104,97,115,104,45,51,1,1,1,1,1,8,98,111,97,114,100,45,52,1,1,1,1,1,1,1,1,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,53,2,8,1,1,28,4,73,90,107,124,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,164,1,168,195,174,96,0};
inline constexpr std::uint8_t kPayload148[] = {17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,102,105,114,109,119,97,114,101,95,118,101,114,115,105,111,110,103,105,116,95,104,97,115,104,45,51,0,0,0,0,0,0,98,111,97,114,100,45,52,0,0,0,0,0,0,0,0,0,115,101,114,105,97,108,95,110,117,109,98,101,114,45,53,0,8,0,0,0,4,73,90,107,124,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,164,1};
inline constexpr std::uint8_t kFrame149[] = {11,129,133,3,2,1,2,176,173,27,107,45,17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,102,105,114,109,119,97,114,101,95,118,101,114,115,105,111,110,103,105,116,95,104,97,115,104,45,51,1,1,1,1,1,8,98,111,97,114,100,45,52,1,1,1,1,1,1,1,1,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,53,2,8,1,1,26,4,73,90,107,124,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,158,185,246,219,0};
inline constexpr std::uint8_t kPayload149[] = {17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,102,105,114,109,119,97,114,101,95,118,101,114,115,105,111,110,103,105,116,95,104,97,115,104,45,51,0,0,0,0,0,0,98,111,97,114,100,45,52,0,0,0,0,0,0,0,0,0,115,101,114,105,97,108,95,110,117,109,98,101,114,45,53,0,8,0,0,0,4,73,90,107,124,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157};
inline constexpr std::uint8_t kFrame150[] = {11,129,133,3,2,1,2,176,173,27,108,22,17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,97,10,98,1,1,1,1,1,1,1,1,1,1,1,1,11,103,105,116,95,104,97,115,104,45,51,1,1,1,1,1,8,98,111,97,114,100,45,52,1,1,1,1,1,1,1,1,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,53,2,8,1,1,27,4,73,90,107,124,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,164,82,86,104,118,0};
inline constexpr std::uint8_t kPayload150[] = {17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,97,10,98,0,0,0,0,0,0,0,0,0,0,0,0,0,103,105,116,95,104,97,115,104,45,51,0,0,0,0,0,0,98,111,97,114,100,45,52,0,0,0,0,0,0,0,0,0,115,101,114,105,97,108,95,110,117,109,98,101,114,45,53,0,8,0,0,0,4,73,90,107,124,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,164};
inline constexpr std::uint8_t kFrame151[] = {11,129,133,3,2,1,2,176,173,27,108,20,17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,97,2,98,1,1,1,1,1,1,1,1,1,1,1,1,11,103,105,116,95,104,97,115,104,45,51,1,1,1,1,1,8,98,111,97,114,100,45,52,1,1,1,1,1,1,1,1,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,53,2,8,1,1,27,4,73,90,107,124,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,164,128,237,17,41,0};
inline constexpr std::uint8_t kPayload151[] = {17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,97,0,98,0,0,0,0,0,0,0,0,0,0,0,0,0,103,105,116,95,104,97,115,104,45,51,0,0,0,0,0,0,98,111,97,114,100,45,52,0,0,0,0,0,0,0,0,0,115,101,114,105,97,108,95,110,117,109,98,101,114,45,53,0,8,0,0,0,4,73,90,107,124,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,164};
inline constexpr std::uint8_t kFrame152[] = {11,129,133,3,2,1,2,176,173,27,108,38,17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,102,105,114,109,119,97,114,101,95,118,101,114,115,105,111,110,97,10,98,1,1,1,1,1,1,1,1,1,1,1,1,8,98,111,97,114,100,45,52,1,1,1,1,1,1,1,1,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,53,2,8,1,1,27,4,73,90,107,124,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,164,51,203,33,65,0};
inline constexpr std::uint8_t kPayload152[] = {17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,102,105,114,109,119,97,114,101,95,118,101,114,115,105,111,110,97,10,98,0,0,0,0,0,0,0,0,0,0,0,0,0,98,111,97,114,100,45,52,0,0,0,0,0,0,0,0,0,115,101,114,105,97,108,95,110,117,109,98,101,114,45,53,0,8,0,0,0,4,73,90,107,124,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,164};
inline constexpr std::uint8_t kFrame153[] = {11,129,133,3,2,1,2,176,173,27,108,36,17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,102,105,114,109,119,97,114,101,95,118,101,114,115,105,111,110,97,2,98,1,1,1,1,1,1,1,1,1,1,1,1,8,98,111,97,114,100,45,52,1,1,1,1,1,1,1,1,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,53,2,8,1,1,27,4,73,90,107,124,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,164,26,140,110,166,0};
inline constexpr std::uint8_t kPayload153[] = {17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,102,105,114,109,119,97,114,101,95,118,101,114,115,105,111,110,97,0,98,0,0,0,0,0,0,0,0,0,0,0,0,0,98,111,97,114,100,45,52,0,0,0,0,0,0,0,0,0,115,101,114,105,97,108,95,110,117,109,98,101,114,45,53,0,8,0,0,0,4,73,90,107,124,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,164};
inline constexpr std::uint8_t kFrame154[] = {11,129,133,3,2,1,2,176,173,27,108,45,17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,102,105,114,109,119,97,114,101,95,118,101,114,115,105,111,110,103,105,116,95,104,97,115,104,45,51,1,1,1,1,1,4,97,10,98,1,1,1,1,1,1,1,1,1,1,1,1,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,53,2,8,1,1,27,4,73,90,107,124,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,164,16,57,184,249,0};
inline constexpr std::uint8_t kPayload154[] = {17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,102,105,114,109,119,97,114,101,95,118,101,114,115,105,111,110,103,105,116,95,104,97,115,104,45,51,0,0,0,0,0,0,97,10,98,0,0,0,0,0,0,0,0,0,0,0,0,0,115,101,114,105,97,108,95,110,117,109,98,101,114,45,53,0,8,0,0,0,4,73,90,107,124,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,164};
inline constexpr std::uint8_t kFrame155[] = {11,129,133,3,2,1,2,176,173,27,108,45,17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,102,105,114,109,119,97,114,101,95,118,101,114,115,105,111,110,103,105,116,95,104,97,115,104,45,51,1,1,1,1,1,2,97,2,98,1,1,1,1,1,1,1,1,1,1,1,1,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,53,2,8,1,1,27,4,73,90,107,124,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,164,248,14,187,13,0};
inline constexpr std::uint8_t kPayload155[] = {17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,102,105,114,109,119,97,114,101,95,118,101,114,115,105,111,110,103,105,116,95,104,97,115,104,45,51,0,0,0,0,0,0,97,0,98,0,0,0,0,0,0,0,0,0,0,0,0,0,115,101,114,105,97,108,95,110,117,109,98,101,114,45,53,0,8,0,0,0,4,73,90,107,124,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,164};
inline constexpr std::uint8_t kFrame156[] = {11,129,133,3,2,1,2,176,173,27,108,45,17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,102,105,114,109,119,97,114,101,95,118,101,114,115,105,111,110,103,105,116,95,104,97,115,104,45,51,1,1,1,1,1,8,98,111,97,114,100,45,52,1,1,1,1,1,1,1,1,4,97,10,98,1,1,1,1,1,1,1,1,1,1,1,1,2,8,1,1,27,4,73,90,107,124,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,164,117,185,82,112,0};
inline constexpr std::uint8_t kPayload156[] = {17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,102,105,114,109,119,97,114,101,95,118,101,114,115,105,111,110,103,105,116,95,104,97,115,104,45,51,0,0,0,0,0,0,98,111,97,114,100,45,52,0,0,0,0,0,0,0,0,0,97,10,98,0,0,0,0,0,0,0,0,0,0,0,0,0,8,0,0,0,4,73,90,107,124,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,164};
inline constexpr std::uint8_t kFrame157[] = {11,129,133,3,2,1,2,176,173,27,108,45,17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,102,105,114,109,119,97,114,101,95,118,101,114,115,105,111,110,103,105,116,95,104,97,115,104,45,51,1,1,1,1,1,8,98,111,97,114,100,45,52,1,1,1,1,1,1,1,1,2,97,2,98,1,1,1,1,1,1,1,1,1,1,1,1,2,8,1,1,27,4,73,90,107,124,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,164,122,2,116,86,0};
inline constexpr std::uint8_t kPayload157[] = {17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,102,105,114,109,119,97,114,101,95,118,101,114,115,105,111,110,103,105,116,95,104,97,115,104,45,51,0,0,0,0,0,0,98,111,97,114,100,45,52,0,0,0,0,0,0,0,0,0,97,0,98,0,0,0,0,0,0,0,0,0,0,0,0,0,8,0,0,0,4,73,90,107,124,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,164};
inline constexpr std::uint8_t kFrame158[] = {11,129,133,3,2,1,2,176,173,27,108,45,17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,102,105,114,109,119,97,114,101,95,118,101,114,115,105,111,110,103,105,116,95,104,97,115,104,45,51,1,1,1,1,1,8,98,111,97,114,100,45,52,1,1,1,1,1,1,1,1,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,53,2,8,1,1,27,8,73,90,107,124,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,164,242,152,189,67,0};
inline constexpr std::uint8_t kPayload158[] = {17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,102,105,114,109,119,97,114,101,95,118,101,114,115,105,111,110,103,105,116,95,104,97,115,104,45,51,0,0,0,0,0,0,98,111,97,114,100,45,52,0,0,0,0,0,0,0,0,0,115,101,114,105,97,108,95,110,117,109,98,101,114,45,53,0,8,0,0,0,8,73,90,107,124,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,164};
inline constexpr std::uint8_t kFrame159[] = {11,129,133,3,2,1,2,176,173,27,108,45,17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,102,105,114,109,119,97,114,101,95,118,101,114,115,105,111,110,103,105,116,95,104,97,115,104,45,51,1,1,1,1,1,8,98,111,97,114,100,45,52,1,1,1,1,1,1,1,1,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,53,2,8,1,1,2,4,1,1,1,22,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,164,180,173,87,126,0};
inline constexpr std::uint8_t kPayload159[] = {17,34,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,102,105,114,109,119,97,114,101,95,118,101,114,115,105,111,110,103,105,116,95,104,97,115,104,45,51,0,0,0,0,0,0,98,111,97,114,100,45,52,0,0,0,0,0,0,0,0,0,115,101,114,105,97,108,95,110,117,109,98,101,114,45,53,0,8,0,0,0,4,0,0,0,0,80,97,114,131,87,94,101,108,125,115,122,129,136,143,150,157,164};
inline constexpr std::uint8_t kFrame160[] = {11,2,6,3,2,1,2,176,173,27,5,10,17,34,51,68,1,123,11,101,236,0};
inline constexpr std::uint8_t kPayload160[] = {17,34,51,68,1};
inline constexpr std::uint8_t kFrame161[] = {11,2,6,3,2,1,2,176,173,27,3,8,17,34,51,206,72,75,165,0};
inline constexpr std::uint8_t kPayload161[] = {17,34,51};
inline constexpr std::uint8_t kFrame162[] = {11,130,134,3,2,1,2,176,173,27,3,8,17,34,1,187,211,133,78,0};
inline constexpr std::uint8_t kPayload162[] = {17,34,1};
inline constexpr std::uint8_t kFrame163[] = {11,130,134,3,2,1,2,176,173,27,1,6,17,247,152,158,136,0};
inline constexpr std::uint8_t kPayload163[] = {17};
inline constexpr std::uint8_t kFrame164[] = {11,3,7,3,2,1,2,176,173,27,1,6,1,67,65,36,216,0};
inline constexpr std::uint8_t kPayload164[] = {1};
inline constexpr std::uint8_t kFrame165[] = {11,131,135,3,2,1,2,176,173,27,38,43,2,5,15,6,1,52,69,86,103,120,137,154,171,59,76,93,110,66,83,100,117,73,90,80,97,114,131,87,104,121,138,94,111,128,145,101,118,1,234,253,223,63,0};
inline constexpr std::uint8_t kPayload165[] = {2,5,15,6,1,52,69,86,103,120,137,154,171,59,76,93,110,66,83,100,117,73,90,80,97,114,131,87,104,121,138,94,111,128,145,101,118,1};
inline constexpr std::uint8_t kFrame166[] = {11,131,135,3,2,1,2,176,173,27,36,41,2,5,15,6,1,52,69,86,103,120,137,154,171,59,76,93,110,66,83,100,117,73,90,80,97,114,131,87,104,121,138,94,111,128,145,101,141,202,148,238,0};
inline constexpr std::uint8_t kPayload166[] = {2,5,15,6,1,52,69,86,103,120,137,154,171,59,76,93,110,66,83,100,117,73,90,80,97,114,131,87,104,121,138,94,111,128,145,101};
inline constexpr std::uint8_t kFrame167[] = {11,131,135,3,2,1,2,176,173,27,37,42,5,5,15,6,1,52,69,86,103,120,137,154,171,59,76,93,110,66,83,100,117,73,90,80,97,114,131,87,104,121,138,94,111,128,145,101,118,165,50,56,130,0};
inline constexpr std::uint8_t kPayload167[] = {5,5,15,6,1,52,69,86,103,120,137,154,171,59,76,93,110,66,83,100,117,73,90,80,97,114,131,87,104,121,138,94,111,128,145,101,118};
inline constexpr std::uint8_t kFrame168[] = {11,131,135,3,2,1,2,176,173,27,37,42,2,10,15,6,1,52,69,86,103,120,137,154,171,59,76,93,110,66,83,100,117,73,90,80,97,114,131,87,104,121,138,94,111,128,145,101,118,61,201,26,154,0};
inline constexpr std::uint8_t kPayload168[] = {2,10,15,6,1,52,69,86,103,120,137,154,171,59,76,93,110,66,83,100,117,73,90,80,97,114,131,87,104,121,138,94,111,128,145,101,118};
inline constexpr std::uint8_t kFrame169[] = {11,131,135,3,2,1,2,176,173,27,37,42,2,5,16,6,1,52,69,86,103,120,137,154,171,59,76,93,110,66,83,100,117,73,90,80,97,114,131,87,104,121,138,94,111,128,145,101,118,143,211,252,48,0};
inline constexpr std::uint8_t kPayload169[] = {2,5,16,6,1,52,69,86,103,120,137,154,171,59,76,93,110,66,83,100,117,73,90,80,97,114,131,87,104,121,138,94,111,128,145,101,118};
inline constexpr std::uint8_t kFrame170[] = {11,131,135,3,2,1,2,176,173,27,37,42,2,5,15,32,1,52,69,86,103,120,137,154,171,59,76,93,110,66,83,100,117,73,90,80,97,114,131,87,104,121,138,94,111,128,145,101,118,136,142,107,38,0};
inline constexpr std::uint8_t kPayload170[] = {2,5,15,32,1,52,69,86,103,120,137,154,171,59,76,93,110,66,83,100,117,73,90,80,97,114,131,87,104,121,138,94,111,128,145,101,118};
inline constexpr std::uint8_t kFrame171[] = {11,131,135,3,2,1,2,176,173,27,37,42,2,5,15,6,2,52,69,86,103,120,137,154,171,59,76,93,110,66,83,100,117,73,90,80,97,114,131,87,104,121,138,94,111,128,145,101,118,111,234,29,237,0};
inline constexpr std::uint8_t kPayload171[] = {2,5,15,6,2,52,69,86,103,120,137,154,171,59,76,93,110,66,83,100,117,73,90,80,97,114,131,87,104,121,138,94,111,128,145,101,118};
inline constexpr std::uint8_t kFrame172[] = {11,4,8,3,2,1,2,176,173,27,1,6,1,10,92,68,63,0};
inline constexpr std::uint8_t kPayload172[] = {1};
inline constexpr std::uint8_t kFrame173[] = {11,132,136,3,2,1,2,176,173,27,19,24,17,34,51,68,24,41,58,75,31,48,65,82,42,7,45,62,52,69,1,251,143,216,249,0};
inline constexpr std::uint8_t kPayload173[] = {17,34,51,68,24,41,58,75,31,48,65,82,42,7,45,62,52,69,1};
inline constexpr std::uint8_t kFrame174[] = {11,132,136,3,2,1,2,176,173,27,17,22,17,34,51,68,24,41,58,75,31,48,65,82,42,7,45,62,52,5,42,60,42,0};
inline constexpr std::uint8_t kPayload174[] = {17,34,51,68,24,41,58,75,31,48,65,82,42,7,45,62,52};
inline constexpr std::uint8_t kFrame175[] = {11,132,136,3,2,1,2,176,173,27,18,13,17,34,51,68,24,41,58,75,31,48,65,82,10,16,45,62,52,69,63,178,170,127,0};
inline constexpr std::uint8_t kPayload175[] = {17,34,51,68,24,41,58,75,31,48,65,82,0,16,45,62,52,69};
inline constexpr std::uint8_t kFrame176[] = {11,132,136,3,2,1,2,176,173,27,18,13,17,34,51,68,24,41,58,75,31,48,65,82,1,9,45,62,52,69,189,37,74,31,0};
inline constexpr std::uint8_t kPayload176[] = {17,34,51,68,24,41,58,75,31,48,65,82,0,0,45,62,52,69};
inline constexpr std::uint8_t kFrame177[] = {11,16,20,3,2,1,2,176,173,27,35,6,17,16,24,9,31,34,38,7,45,14,52,5,59,12,66,3,73,10,80,1,87,8,94,15,101,6,108,13,115,4,122,11,129,2,1,2,3,217,47,0};
inline constexpr std::uint8_t kPayload177[] = {17,16,24,9,31,0,38,7,45,14,52,5,59,12,66,3,73,10,80,1,87,8,94,15,101,6,108,13,115,4,122,11,129,2,1};
inline constexpr std::uint8_t kFrame178[] = {11,16,20,3,2,1,2,176,173,27,33,6,17,16,24,9,31,32,38,7,45,14,52,5,59,12,66,3,73,10,80,1,87,8,94,15,101,6,108,13,115,4,122,11,129,131,75,6,56,0};
inline constexpr std::uint8_t kPayload178[] = {17,16,24,9,31,0,38,7,45,14,52,5,59,12,66,3,73,10,80,1,87,8,94,15,101,6,108,13,115,4,122,11,129};
inline constexpr std::uint8_t kFrame179[] = {11,16,20,3,2,1,2,176,173,27,34,6,32,16,24,9,31,33,38,7,45,14,52,5,59,12,66,3,73,10,80,1,87,8,94,15,101,6,108,13,115,4,122,11,129,2,93,90,61,102,0};
inline constexpr std::uint8_t kPayload179[] = {32,16,24,9,31,0,38,7,45,14,52,5,59,12,66,3,73,10,80,1,87,8,94,15,101,6,108,13,115,4,122,11,129,2};
inline constexpr std::uint8_t kFrame180[] = {11,16,20,3,2,1,2,176,173,27,4,3,17,1,6,16,56,32,145,11,0};
inline constexpr std::uint8_t kPayload180[] = {17,1,0,16};
inline constexpr std::uint8_t kFrame181[] = {11,144,148,3,2,1,2,176,173,27,10,15,17,24,41,58,75,31,48,65,82,1,185,109,177,85,0};
inline constexpr std::uint8_t kPayload181[] = {17,24,41,58,75,31,48,65,82,1};
inline constexpr std::uint8_t kFrame182[] = {11,144,148,3,2,1,2,176,173,27,8,13,17,24,41,58,75,31,48,65,252,51,62,33,0};
inline constexpr std::uint8_t kPayload182[] = {17,24,41,58,75,31,48,65};
inline constexpr std::uint8_t kFrame183[] = {11,144,148,3,2,1,2,176,173,27,9,10,32,24,41,58,75,31,48,65,82,4,84,137,27,0};
inline constexpr std::uint8_t kPayload183[] = {32,24,41,58,75,31,48,65,82};
inline constexpr std::uint8_t kFrame184[] = {13,17,21,3,2,1,2,176,173,27,1,1,1,216,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,90,97,104,111,118,125,132,139,146,153,160,167,174,181,188,195,202,209,216,223,230,237,244,251,2,9,16,23,30,37,44,51,58,65,72,79,86,93,100,107,114,121,128,135,142,149,156,163,170,177,184,191,198,205,212,219,226,233,240,247,254,5,12,19,26,33,40,47,54,61,68,75,82,89,96,103,110,117,124,131,138,145,152,159,166,173,180,187,194,201,208,215,222,229,236,243,250,1,8,15,22,29,36,43,50,57,64,71,78,85,92,99,106,113,120,127,134,141,148,155,162,169,176,183,190,197,204,211,218,225,232,239,246,253,4,11,18,25,32,39,46,53,60,67,74,81,88,95,102,109,116,123,130,137,144,151,158,165,172,179,186,193,200,207,214,221,228,235,242,249,44,7,14,21,28,35,42,49,56,63,70,77,84,91,98,105,112,119,126,133,140,147,154,161,168,175,182,189,196,203,210,217,224,231,238,245,252,3,10,17,46,230,254,97,0};
inline constexpr std::uint8_t kPayload184[] = {1,0,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,90,97,104,111,118,125,132,139,146,153,160,167,174,181,188,195,202,209,216,223,230,237,244,251,2,9,16,23,30,37,44,51,58,65,72,79,86,93,100,107,114,121,128,135,142,149,156,163,170,177,184,191,198,205,212,219,226,233,240,247,254,5,12,19,26,33,40,47,54,61,68,75,82,89,96,103,110,117,124,131,138,145,152,159,166,173,180,187,194,201,208,215,222,229,236,243,250,1,8,15,22,29,36,43,50,57,64,71,78,85,92,99,106,113,120,127,134,141,148,155,162,169,176,183,190,197,204,211,218,225,232,239,246,253,4,11,18,25,32,39,46,53,60,67,74,81,88,95,102,109,116,123,130,137,144,151,158,165,172,179,186,193,200,207,214,221,228,235,242,249,0,7,14,21,28,35,42,49,56,63,70,77,84,91,98,105,112,119,126,133,140,147,154,161,168,175,182,189,196,203,210,217,224,231,238,245,252,3,10,17};
inline constexpr std::uint8_t kFrame185[] = {13,17,21,3,2,1,2,176,173,27,2,1,16,216,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,90,97,104,111,118,125,132,139,146,153,160,167,174,181,188,195,202,209,216,223,230,237,244,251,2,9,16,23,30,37,44,51,58,65,72,79,86,93,100,107,114,121,128,135,142,149,156,163,170,177,184,191,198,205,212,219,226,233,240,247,254,5,12,19,26,33,40,47,54,61,68,75,82,89,96,103,110,117,124,131,138,145,152,159,166,173,180,187,194,201,208,215,222,229,236,243,250,1,8,15,22,29,36,43,50,57,64,71,78,85,92,99,106,113,120,127,134,141,148,155,162,169,176,183,190,197,204,211,218,225,232,239,246,253,4,11,18,25,32,39,46,53,60,67,74,81,88,95,102,109,116,123,130,137,144,151,158,165,172,179,186,193,200,207,214,221,228,235,242,249,45,7,14,21,28,35,42,49,56,63,70,77,84,91,98,105,112,119,126,133,140,147,154,161,168,175,182,189,196,203,210,217,224,231,238,245,252,3,10,17,24,7,54,68,103,0};
inline constexpr std::uint8_t kPayload185[] = {16,0,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,90,97,104,111,118,125,132,139,146,153,160,167,174,181,188,195,202,209,216,223,230,237,244,251,2,9,16,23,30,37,44,51,58,65,72,79,86,93,100,107,114,121,128,135,142,149,156,163,170,177,184,191,198,205,212,219,226,233,240,247,254,5,12,19,26,33,40,47,54,61,68,75,82,89,96,103,110,117,124,131,138,145,152,159,166,173,180,187,194,201,208,215,222,229,236,243,250,1,8,15,22,29,36,43,50,57,64,71,78,85,92,99,106,113,120,127,134,141,148,155,162,169,176,183,190,197,204,211,218,225,232,239,246,253,4,11,18,25,32,39,46,53,60,67,74,81,88,95,102,109,116,123,130,137,144,151,158,165,172,179,186,193,200,207,214,221,228,235,242,249,0,7,14,21,28,35,42,49,56,63,70,77,84,91,98,105,112,119,126,133,140,147,154,161,168,175,182,189,196,203,210,217,224,231,238,245,252,3,10,17,24};
inline constexpr std::uint8_t kFrame186[] = {229,17,21,3,2,1,2,176,173,27,2,1,1,4,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,90,97,104,111,118,125,132,139,146,153,160,167,174,181,188,195,202,209,216,223,230,237,244,251,2,9,16,23,30,37,44,51,58,65,72,79,86,93,100,107,114,121,128,135,142,149,156,163,170,177,184,191,198,205,212,219,226,233,240,247,254,5,12,19,26,33,40,47,54,61,68,75,82,89,96,103,110,117,124,131,138,145,152,159,166,173,180,187,194,201,208,215,222,229,236,243,250,1,8,15,22,29,36,43,50,57,64,71,78,85,92,99,106,113,120,127,134,141,148,155,162,169,176,183,190,197,204,211,218,225,232,239,246,253,4,11,18,25,32,39,46,53,60,67,74,81,88,95,102,109,116,123,130,137,144,151,158,165,172,179,186,193,200,207,214,221,228,235,242,249,45,7,14,21,28,35,42,49,56,63,70,77,84,91,98,105,112,119,126,133,140,147,154,161,168,175,182,189,196,203,210,217,224,231,238,245,252,3,10,17,24,255,7,96,169,0};
inline constexpr std::uint8_t kPayload186[] = {1,4,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,90,97,104,111,118,125,132,139,146,153,160,167,174,181,188,195,202,209,216,223,230,237,244,251,2,9,16,23,30,37,44,51,58,65,72,79,86,93,100,107,114,121,128,135,142,149,156,163,170,177,184,191,198,205,212,219,226,233,240,247,254,5,12,19,26,33,40,47,54,61,68,75,82,89,96,103,110,117,124,131,138,145,152,159,166,173,180,187,194,201,208,215,222,229,236,243,250,1,8,15,22,29,36,43,50,57,64,71,78,85,92,99,106,113,120,127,134,141,148,155,162,169,176,183,190,197,204,211,218,225,232,239,246,253,4,11,18,25,32,39,46,53,60,67,74,81,88,95,102,109,116,123,130,137,144,151,158,165,172,179,186,193,200,207,214,221,228,235,242,249,0,7,14,21,28,35,42,49,56,63,70,77,84,91,98,105,112,119,126,133,140,147,154,161,168,175,182,189,196,203,210,217,224,231,238,245,252,3,10,17,24};
inline constexpr std::uint8_t kFrame187[] = {11,145,149,3,2,1,2,176,173,27,3,2,1,6,1,72,229,15,230,0};
inline constexpr std::uint8_t kPayload187[] = {1,0,1};
inline constexpr std::uint8_t kFrame188[] = {11,145,149,3,2,1,2,176,173,27,1,6,1,85,21,187,217,0};
inline constexpr std::uint8_t kPayload188[] = {1};
inline constexpr std::uint8_t kFrame189[] = {11,145,149,3,2,1,2,176,173,27,2,2,16,5,29,125,182,136,0};
inline constexpr std::uint8_t kPayload189[] = {16,0};
inline constexpr std::uint8_t kFrame190[] = {11,145,149,3,2,1,2,176,173,27,2,7,1,4,20,154,2,220,0};
inline constexpr std::uint8_t kPayload190[] = {1,4};
inline constexpr std::uint8_t kFrame191[] = {11,18,22,3,2,1,2,176,173,27,6,11,1,24,41,58,75,1,54,69,221,158,0};
inline constexpr std::uint8_t kPayload191[] = {1,24,41,58,75,1};
inline constexpr std::uint8_t kFrame192[] = {11,18,22,3,2,1,2,176,173,27,4,9,1,24,41,58,89,204,106,158,0};
inline constexpr std::uint8_t kPayload192[] = {1,24,41,58};
inline constexpr std::uint8_t kFrame193[] = {11,18,22,3,2,1,2,176,173,27,5,10,16,24,41,58,75,143,65,210,218,0};
inline constexpr std::uint8_t kPayload193[] = {16,24,41,58,75};
inline constexpr std::uint8_t kFrame194[] = {11,146,150,3,2,1,2,176,173,27,8,13,1,24,41,58,75,30,16,1,160,96,127,206,0};
inline constexpr std::uint8_t kPayload194[] = {1,24,41,58,75,30,16,1};
inline constexpr std::uint8_t kFrame195[] = {11,146,150,3,2,1,2,176,173,27,6,11,1,24,41,58,75,30,223,110,164,245,0};
inline constexpr std::uint8_t kPayload195[] = {1,24,41,58,75,30};
inline constexpr std::uint8_t kFrame196[] = {11,146,150,3,2,1,2,176,173,27,7,12,16,24,41,58,75,30,16,251,23,254,15,0};
inline constexpr std::uint8_t kPayload196[] = {16,24,41,58,75,30,16};
inline constexpr std::uint8_t kFrame197[] = {11,146,150,3,2,1,2,176,173,27,7,12,1,24,41,58,75,1,32,179,190,212,37,0};
inline constexpr std::uint8_t kPayload197[] = {1,24,41,58,75,1,32};
inline constexpr std::uint8_t kFrame198[] = {11,19,23,3,2,1,2,176,173,27,2,7,1,1,184,15,162,224,0};
inline constexpr std::uint8_t kPayload198[] = {1,1};
inline constexpr std::uint8_t kFrame199[] = {10,19,23,3,2,1,2,176,173,27,1,5,237,157,67,182,0};
inline constexpr std::uint8_t kFrame200[] = {11,19,23,3,2,1,2,176,173,27,1,6,16,134,72,122,16,0};
inline constexpr std::uint8_t kPayload200[] = {16};
inline constexpr std::uint8_t kFrame201[] = {11,147,151,3,2,1,2,176,173,27,6,11,1,24,41,58,75,1,248,57,98,81,0};
inline constexpr std::uint8_t kPayload201[] = {1,24,41,58,75,1};
inline constexpr std::uint8_t kFrame202[] = {11,147,151,3,2,1,2,176,173,27,4,9,1,24,41,58,158,233,106,119,0};
inline constexpr std::uint8_t kPayload202[] = {1,24,41,58};
inline constexpr std::uint8_t kFrame203[] = {11,147,151,3,2,1,2,176,173,27,5,10,16,24,41,58,75,185,22,59,223,0};
inline constexpr std::uint8_t kPayload203[] = {16,24,41,58,75};
inline constexpr std::uint8_t kFrame204[] = {11,20,24,3,2,1,2,176,173,27,2,7,17,1,192,132,135,165,0};
inline constexpr std::uint8_t kPayload204[] = {17,1};
inline constexpr std::uint8_t kFrame205[] = {10,20,24,3,2,1,2,176,173,27,1,5,227,211,115,110,0};
inline constexpr std::uint8_t kFrame206[] = {11,20,24,3,2,1,2,176,173,27,1,6,32,99,101,195,209,0};
inline constexpr std::uint8_t kPayload206[] = {32};
inline constexpr std::uint8_t kFrame207[] = {11,148,152,3,2,1,2,176,173,27,6,11,17,24,41,58,75,1,18,32,204,252,0};
inline constexpr std::uint8_t kPayload207[] = {17,24,41,58,75,1};
inline constexpr std::uint8_t kFrame208[] = {11,148,152,3,2,1,2,176,173,27,4,9,17,24,41,58,237,5,230,234,0};
inline constexpr std::uint8_t kPayload208[] = {17,24,41,58};
inline constexpr std::uint8_t kFrame209[] = {11,148,152,3,2,1,2,176,173,27,5,10,32,24,41,58,75,215,149,107,215,0};
inline constexpr std::uint8_t kPayload209[] = {32,24,41,58,75};
inline constexpr std::uint8_t kFrame210[] = {11,21,25,3,2,1,2,176,173,27,1,6,1,146,230,129,199,0};
inline constexpr std::uint8_t kPayload210[] = {1};
inline constexpr std::uint8_t kFrame211[] = {11,149,153,3,2,1,2,176,173,27,2,7,2,1,79,26,246,66,0};
inline constexpr std::uint8_t kPayload211[] = {2,1};
inline constexpr std::uint8_t kFrame212[] = {10,149,153,3,2,1,2,176,173,27,1,5,131,91,219,209,0};
inline constexpr std::uint8_t kFrame213[] = {11,149,153,3,2,1,2,176,173,27,1,6,5,244,120,202,215,0};
inline constexpr std::uint8_t kPayload213[] = {5};
inline constexpr std::uint8_t kFrame214[] = {11,32,36,3,2,1,2,176,173,27,64,69,17,2,5,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,104,159,114,236,0};
inline constexpr std::uint8_t kPayload214[] = {17,2,5,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1};
inline constexpr std::uint8_t kFrame215[] = {11,32,36,3,2,1,2,176,173,27,62,67,17,2,5,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,180,166,152,82,0};
inline constexpr std::uint8_t kPayload215[] = {17,2,5,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83};
inline constexpr std::uint8_t kFrame216[] = {11,32,36,3,2,1,2,176,173,27,63,1,67,4,5,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,155,154,215,94,0};
inline constexpr std::uint8_t kPayload216[] = {0,4,5,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,33,137,83,3};
inline constexpr std::uint8_t kFrame217[] = {11,32,36,3,2,1,2,176,173,27,27,32,17,2,2,1,24,31,48,14,143,115,3,33,137,83,3,16,24,31,48,14,143,115,3,33,137,83,3,218,94,5,8,0};
inline constexpr std::uint8_t kPayload217[] = {17,2,2,1,24,31,48,14,143,115,3,33,137,83,3,16,24,31,48,14,143,115,3,33,137,83,3};
inline constexpr std::uint8_t kFrame218[] = {11,32,36,3,2,1,2,176,173,27,27,32,17,2,2,1,24,31,48,14,143,115,3,33,137,83,3,1,32,31,48,14,143,115,3,33,137,83,3,16,85,17,13,0};
inline constexpr std::uint8_t kPayload218[] = {17,2,2,1,24,31,48,14,143,115,3,33,137,83,3,1,32,31,48,14,143,115,3,33,137,83,3};
inline constexpr std::uint8_t kFrame219[] = {11,32,36,3,2,1,2,176,173,27,27,18,17,2,2,1,24,31,48,14,143,115,3,33,137,83,3,1,24,1,13,14,143,115,3,33,137,83,3,254,229,44,103,0};
inline constexpr std::uint8_t kPayload219[] = {17,2,2,1,24,31,48,14,143,115,3,33,137,83,3,1,24,0,0,14,143,115,3,33,137,83,3};
inline constexpr std::uint8_t kFrame220[] = {11,32,36,3,2,1,2,176,173,27,27,28,17,2,2,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,1,135,147,3,33,137,83,3,4,184,51,99,0};
inline constexpr std::uint8_t kPayload220[] = {17,2,2,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,1,135,147,3,33,137,83,3};
inline constexpr std::uint8_t kFrame221[] = {11,32,36,3,2,1,2,176,173,27,27,32,17,2,2,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,1,135,147,3,51,170,238,254,0};
inline constexpr std::uint8_t kPayload221[] = {17,2,2,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,1,135,147,3};
inline constexpr std::uint8_t kFrame222[] = {11,32,36,3,2,1,2,176,173,27,27,25,17,2,2,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,9,1,1,5,186,7,69,28,0};
inline constexpr std::uint8_t kPayload222[] = {17,2,2,1,24,31,48,14,143,115,3,33,137,83,3,1,24,31,48,14,143,115,3,9,0,0,0};
inline constexpr std::uint8_t kFrame223[] = {11,160,164,3,2,1,2,176,173,27,4,9,17,2,7,1,104,210,163,134,0};
inline constexpr std::uint8_t kPayload223[] = {17,2,7,1};
inline constexpr std::uint8_t kFrame224[] = {11,160,164,3,2,1,2,176,173,27,2,7,17,2,177,99,192,42,0};
inline constexpr std::uint8_t kPayload224[] = {17,2};
inline constexpr std::uint8_t kFrame225[] = {11,160,164,3,2,1,2,176,173,27,3,1,7,4,7,38,126,244,134,0};
inline constexpr std::uint8_t kPayload225[] = {0,4,7};
inline constexpr std::uint8_t kFrame226[] = {11,160,164,3,2,1,2,176,173,27,3,8,17,2,17,182,165,158,57,0};
inline constexpr std::uint8_t kPayload226[] = {17,2,17};
inline constexpr std::uint8_t kFrame227[] = {11,33,37,3,2,1,2,176,173,27,7,12,18,2,24,41,58,75,1,204,33,98,251,0};
inline constexpr std::uint8_t kPayload227[] = {18,2,24,41,58,75,1};
inline constexpr std::uint8_t kFrame228[] = {11,33,37,3,2,1,2,176,173,27,5,10,18,2,24,41,58,50,16,248,249,0};
inline constexpr std::uint8_t kPayload228[] = {18,2,24,41,58};
inline constexpr std::uint8_t kFrame229[] = {11,33,37,3,2,1,2,176,173,27,6,11,1,4,24,41,58,75,115,92,175,127,0};
inline constexpr std::uint8_t kPayload229[] = {1,4,24,41,58,75};
inline constexpr std::uint8_t kFrame230[] = {11,33,37,3,2,1,2,176,173,27,6,1,1,9,24,41,58,75,22,41,115,65,0};
inline constexpr std::uint8_t kPayload230[] = {0,0,24,41,58,75};
inline constexpr std::uint8_t kFrame231[] = {11,161,165,3,2,1,2,176,173,27,11,16,18,2,24,41,58,75,31,48,65,82,1,166,220,57,31,0};
inline constexpr std::uint8_t kPayload231[] = {18,2,24,41,58,75,31,48,65,82,1};
inline constexpr std::uint8_t kFrame232[] = {11,161,165,3,2,1,2,176,173,27,9,14,18,2,24,41,58,75,31,48,65,116,27,76,1,0};
inline constexpr std::uint8_t kPayload232[] = {18,2,24,41,58,75,31,48,65};
inline constexpr std::uint8_t kFrame233[] = {11,161,165,3,2,1,2,176,173,27,10,15,1,4,24,41,58,75,31,48,65,82,250,183,19,200,0};
inline constexpr std::uint8_t kPayload233[] = {1,4,24,41,58,75,31,48,65,82};
inline constexpr std::uint8_t kFrame234[] = {11,161,165,3,2,1,2,176,173,27,10,1,1,13,24,41,58,75,31,48,65,82,200,141,61,122,0};
inline constexpr std::uint8_t kPayload234[] = {0,0,24,41,58,75,31,48,65,82};
inline constexpr std::uint8_t kFrame235[] = {11,34,38,3,2,1,2,176,173,27,28,16,17,34,51,68,24,41,58,75,31,48,65,82,13,201,13,3,110,23,1,4,7,144,56,9,59,76,1,1,47,37,35,164,0};
inline constexpr std::uint8_t kPayload235[] = {17,34,51,68,24,41,58,75,31,48,65,82,13,201,13,0,110,23,0,0,7,144,56,0,59,76,1,1};
inline constexpr std::uint8_t kFrame236[] = {11,34,38,3,2,1,2,176,173,27,26,16,17,34,51,68,24,41,58,75,31,48,65,82,13,201,13,3,110,23,1,4,7,144,56,7,59,76,115,69,29,227,0};
inline constexpr std::uint8_t kPayload236[] = {17,34,51,68,24,41,58,75,31,48,65,82,13,201,13,0,110,23,0,0,7,144,56,0,59,76};
inline constexpr std::uint8_t kFrame237[] = {11,34,38,3,2,1,2,176,173,27,27,1,1,1,1,12,24,41,58,75,31,48,65,82,13,201,13,3,110,23,1,4,7,144,56,8,59,76,1,61,203,132,55,0};
inline constexpr std::uint8_t kPayload237[] = {0,0,0,0,24,41,58,75,31,48,65,82,13,201,13,0,110,23,0,0,7,144,56,0,59,76,1};
inline constexpr std::uint8_t kFrame238[] = {11,34,38,3,2,1,2,176,173,27,27,9,17,34,51,68,24,41,58,75,1,1,1,4,13,201,13,3,110,23,1,4,7,144,56,8,59,76,1,160,49,204,185,0};
inline constexpr std::uint8_t kPayload238[] = {17,34,51,68,24,41,58,75,0,0,0,0,13,201,13,0,110,23,0,0,7,144,56,0,59,76,1};
inline constexpr std::uint8_t kFrame239[] = {11,34,38,3,2,1,2,176,173,27,27,16,17,34,51,68,24,41,58,75,31,48,65,82,65,66,15,3,110,23,1,4,7,144,56,8,59,76,1,33,136,244,44,0};
inline constexpr std::uint8_t kPayload239[] = {17,34,51,68,24,41,58,75,31,48,65,82,65,66,15,0,110,23,0,0,7,144,56,0,59,76,1};
inline constexpr std::uint8_t kFrame240[] = {11,34,38,3,2,1,2,176,173,27,27,16,17,34,51,68,24,41,58,75,31,48,65,82,13,201,13,4,161,134,1,4,7,144,56,8,59,76,1,222,20,174,4,0};
inline constexpr std::uint8_t kPayload240[] = {17,34,51,68,24,41,58,75,31,48,65,82,13,201,13,0,161,134,1,0,7,144,56,0,59,76,1};
inline constexpr std::uint8_t kFrame241[] = {11,34,38,3,2,1,2,176,173,27,27,16,17,34,51,68,24,41,58,75,31,48,65,82,13,201,13,1,1,1,1,4,7,144,56,8,59,76,1,83,28,61,200,0};
inline constexpr std::uint8_t kPayload241[] = {17,34,51,68,24,41,58,75,31,48,65,82,13,201,13,0,0,0,0,0,7,144,56,0,59,76,1};
inline constexpr std::uint8_t kFrame242[] = {11,34,38,3,2,1,2,176,173,27,27,16,17,34,51,68,24,41,58,75,31,48,65,82,13,201,13,3,110,23,1,4,129,150,152,8,59,76,1,191,152,85,66,0};
inline constexpr std::uint8_t kPayload242[] = {17,34,51,68,24,41,58,75,31,48,65,82,13,201,13,0,110,23,0,0,129,150,152,0,59,76,1};
inline constexpr std::uint8_t kFrame243[] = {11,34,38,3,2,1,2,176,173,27,27,16,17,34,51,68,24,41,58,75,31,48,65,82,13,201,13,3,110,23,1,4,7,144,56,8,59,76,2,70,106,228,150,0};
inline constexpr std::uint8_t kPayload243[] = {17,34,51,68,24,41,58,75,31,48,65,82,13,201,13,0,110,23,0,0,7,144,56,0,59,76,2};
inline constexpr std::uint8_t kFrame244[] = {11,162,166,3,2,1,2,176,173,27,13,18,17,34,51,68,24,41,58,75,31,48,65,82,1,172,214,10,69,0};
inline constexpr std::uint8_t kPayload244[] = {17,34,51,68,24,41,58,75,31,48,65,82,1};
inline constexpr std::uint8_t kFrame245[] = {11,162,166,3,2,1,2,176,173,27,11,16,17,34,51,68,24,41,58,75,31,48,65,194,117,158,47,0};
inline constexpr std::uint8_t kPayload245[] = {17,34,51,68,24,41,58,75,31,48,65};
inline constexpr std::uint8_t kFrame246[] = {11,162,166,3,2,1,2,176,173,27,12,1,1,1,1,13,24,41,58,75,31,48,65,82,201,180,24,14,0};
inline constexpr std::uint8_t kPayload246[] = {0,0,0,0,24,41,58,75,31,48,65,82};
inline constexpr std::uint8_t kFrame247[] = {11,35,39,3,2,1,2,176,173,27,5,10,17,34,51,68,1,225,4,12,100,0};
inline constexpr std::uint8_t kPayload247[] = {17,34,51,68,1};
inline constexpr std::uint8_t kFrame248[] = {11,35,39,3,2,1,2,176,173,27,3,8,17,34,51,16,67,200,155,0};
inline constexpr std::uint8_t kPayload248[] = {17,34,51};
inline constexpr std::uint8_t kFrame249[] = {11,35,39,3,2,1,2,176,173,27,4,1,1,1,1,5,86,192,44,245,0};
inline constexpr std::uint8_t kPayload249[] = {0,0,0,0};
inline constexpr std::uint8_t kFrame250[] = {11,163,167,3,2,1,2,176,173,27,6,11,2,24,41,58,75,1,50,165,28,31,0};
inline constexpr std::uint8_t kPayload250[] = {2,24,41,58,75,1};
inline constexpr std::uint8_t kFrame251[] = {11,163,167,3,2,1,2,176,173,27,4,9,2,24,41,58,21,163,174,2,0};
inline constexpr std::uint8_t kPayload251[] = {2,24,41,58};
inline constexpr std::uint8_t kFrame252[] = {11,163,167,3,2,1,2,176,173,27,5,10,5,24,41,58,75,121,234,132,74,0};
inline constexpr std::uint8_t kPayload252[] = {5,24,41,58,75};
inline constexpr std::uint8_t kFrame253[] = {11,36,40,3,2,1,2,176,173,27,5,10,17,34,51,68,1,9,63,125,205,0};
inline constexpr std::uint8_t kPayload253[] = {17,34,51,68,1};
inline constexpr std::uint8_t kFrame254[] = {11,36,40,3,2,1,2,176,173,27,3,8,17,34,51,229,60,117,217,0};
inline constexpr std::uint8_t kPayload254[] = {17,34,51};
inline constexpr std::uint8_t kFrame255[] = {11,36,40,3,2,1,2,176,173,27,4,1,1,1,1,5,186,123,185,56,0};
inline constexpr std::uint8_t kPayload255[] = {0,0,0,0};
inline constexpr std::uint8_t kFrame256[] = {11,164,168,3,2,1,2,176,173,27,6,11,2,24,41,58,75,1,67,190,100,177,0};
inline constexpr std::uint8_t kPayload256[] = {2,24,41,58,75,1};
inline constexpr std::uint8_t kFrame257[] = {11,164,168,3,2,1,2,176,173,27,4,9,2,24,41,58,249,24,59,207,0};
inline constexpr std::uint8_t kPayload257[] = {2,24,41,58};
inline constexpr std::uint8_t kFrame258[] = {11,164,168,3,2,1,2,176,173,27,5,10,5,24,41,58,75,145,209,245,227,0};
inline constexpr std::uint8_t kPayload258[] = {5,24,41,58,75};
inline constexpr std::uint8_t kFrame259[] = {11,37,41,3,2,1,2,176,173,27,5,10,17,34,51,68,1,112,117,238,218,0};
inline constexpr std::uint8_t kPayload259[] = {17,34,51,68,1};
inline constexpr std::uint8_t kFrame260[] = {11,37,41,3,2,1,2,176,173,27,3,8,17,34,51,22,4,236,153,0};
inline constexpr std::uint8_t kPayload260[] = {17,34,51};
inline constexpr std::uint8_t kFrame261[] = {11,165,169,3,2,1,2,176,173,27,6,11,2,24,41,58,75,1,145,228,170,152,0};
inline constexpr std::uint8_t kPayload261[] = {2,24,41,58,75,1};
inline constexpr std::uint8_t kFrame262[] = {11,165,169,3,2,1,2,176,173,27,4,9,2,24,41,58,103,34,207,235,0};
inline constexpr std::uint8_t kPayload262[] = {2,24,41,58};
inline constexpr std::uint8_t kFrame263[] = {11,165,169,3,2,1,2,176,173,27,5,10,5,24,41,58,75,232,155,102,244,0};
inline constexpr std::uint8_t kPayload263[] = {5,24,41,58,75};
inline constexpr std::uint8_t kFrame264[] = {11,38,42,3,2,1,2,176,173,27,2,7,5,1,106,163,30,20,0};
inline constexpr std::uint8_t kPayload264[] = {5,1};
inline constexpr std::uint8_t kFrame265[] = {10,38,42,3,2,1,2,176,173,27,1,5,59,115,115,114,0};
inline constexpr std::uint8_t kFrame266[] = {11,38,42,3,2,1,2,176,173,27,1,6,10,243,246,108,130,0};
inline constexpr std::uint8_t kPayload266[] = {10};
inline constexpr std::uint8_t kFrame267[] = {11,166,170,3,2,1,2,176,173,27,2,7,5,1,157,233,179,212,0};
inline constexpr std::uint8_t kPayload267[] = {5,1};
inline constexpr std::uint8_t kFrame268[] = {10,166,170,3,2,1,2,176,173,27,1,5,165,79,151,227,0};
inline constexpr std::uint8_t kFrame269[] = {11,166,170,3,2,1,2,176,173,27,1,6,10,140,172,74,149,0};
inline constexpr std::uint8_t kPayload269[] = {10};
inline constexpr std::uint8_t kFrame270[] = {11,39,43,3,2,1,2,176,173,27,6,11,17,34,51,68,1,1,21,242,201,40,0};
inline constexpr std::uint8_t kPayload270[] = {17,34,51,68,1,1};
inline constexpr std::uint8_t kFrame271[] = {11,39,43,3,2,1,2,176,173,27,4,9,17,34,51,68,213,118,19,3,0};
inline constexpr std::uint8_t kPayload271[] = {17,34,51,68};
inline constexpr std::uint8_t kFrame272[] = {11,39,43,3,2,1,2,176,173,27,5,10,17,34,51,68,2,56,176,193,108,0};
inline constexpr std::uint8_t kPayload272[] = {17,34,51,68,2};
inline constexpr std::uint8_t kFrame273[] = {11,167,171,3,2,1,2,176,173,27,9,14,17,34,51,68,24,41,58,75,1,12,153,134,6,0};
inline constexpr std::uint8_t kPayload273[] = {17,34,51,68,24,41,58,75,1};
inline constexpr std::uint8_t kFrame274[] = {11,167,171,3,2,1,2,176,173,27,7,12,17,34,51,68,24,41,58,89,20,205,52,0};
inline constexpr std::uint8_t kPayload274[] = {17,34,51,68,24,41,58};
inline constexpr std::uint8_t kFrame275[] = {11,48,52,3,2,1,2,176,173,27,1,6,1,170,136,27,10,0};
inline constexpr std::uint8_t kPayload275[] = {1};
inline constexpr std::uint8_t kFrame276[] = {11,176,180,3,2,1,2,176,173,27,57,62,17,34,51,68,24,41,58,75,31,48,65,82,38,55,72,89,45,62,79,96,52,69,86,103,59,76,93,110,66,83,100,117,73,90,107,124,80,97,114,131,87,104,121,138,94,111,128,145,101,118,135,152,108,125,142,159,1,237,105,198,10,0};
inline constexpr std::uint8_t kPayload276[] = {17,34,51,68,24,41,58,75,31,48,65,82,38,55,72,89,45,62,79,96,52,69,86,103,59,76,93,110,66,83,100,117,73,90,107,124,80,97,114,131,87,104,121,138,94,111,128,145,101,118,135,152,108,125,142,159,1};
inline constexpr std::uint8_t kFrame277[] = {11,176,180,3,2,1,2,176,173,27,55,60,17,34,51,68,24,41,58,75,31,48,65,82,38,55,72,89,45,62,79,96,52,69,86,103,59,76,93,110,66,83,100,117,73,90,107,124,80,97,114,131,87,104,121,138,94,111,128,145,101,118,135,152,108,125,142,178,33,88,56,0};
inline constexpr std::uint8_t kPayload277[] = {17,34,51,68,24,41,58,75,31,48,65,82,38,55,72,89,45,62,79,96,52,69,86,103,59,76,93,110,66,83,100,117,73,90,107,124,80,97,114,131,87,104,121,138,94,111,128,145,101,118,135,152,108,125,142};
inline constexpr std::uint8_t kFrame278[] = {11,49,53,3,2,1,2,176,173,27,1,6,1,5,27,48,80,0};
inline constexpr std::uint8_t kPayload278[] = {1};
inline constexpr std::uint8_t kFrame279[] = {11,177,181,3,2,1,2,176,173,27,21,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,10,1,1,38,5,1,172,10,246,244,0};
inline constexpr std::uint8_t kPayload279[] = {115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,0,1,1,38,5,1};
inline constexpr std::uint8_t kFrame280[] = {11,177,181,3,2,1,2,176,173,27,19,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,8,1,1,38,26,201,53,46,0};
inline constexpr std::uint8_t kPayload280[] = {115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,0,1,1,38};
inline constexpr std::uint8_t kFrame281[] = {11,177,181,3,2,1,2,176,173,27,20,4,97,10,98,1,1,1,1,1,1,1,1,1,1,1,1,9,1,1,38,5,148,26,84,177,0};
inline constexpr std::uint8_t kPayload281[] = {97,10,98,0,0,0,0,0,0,0,0,0,0,0,0,0,1,1,38,5};
inline constexpr std::uint8_t kFrame282[] = {11,177,181,3,2,1,2,176,173,27,20,2,97,2,98,1,1,1,1,1,1,1,1,1,1,1,1,9,1,1,38,5,224,1,65,204,0};
inline constexpr std::uint8_t kPayload282[] = {97,0,98,0,0,0,0,0,0,0,0,0,0,0,0,0,1,1,38,5};
inline constexpr std::uint8_t kFrame283[] = {11,177,181,3,2,1,2,176,173,27,20,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,9,3,1,38,5,122,33,244,144,0};
inline constexpr std::uint8_t kPayload283[] = {115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,0,3,1,38,5};
inline constexpr std::uint8_t kFrame284[] = {11,177,181,3,2,1,2,176,173,27,20,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,9,1,2,38,5,168,87,187,56,0};
inline constexpr std::uint8_t kPayload284[] = {115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,0,1,2,38,5};
inline constexpr std::uint8_t kFrame285[] = {11,177,181,3,2,1,2,176,173,27,20,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,9,1,1,64,5,208,37,90,9,0};
inline constexpr std::uint8_t kPayload285[] = {115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,0,1,1,64,5};
inline constexpr std::uint8_t kFrame286[] = {11,177,181,3,2,1,2,176,173,27,20,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,9,1,1,38,8,76,149,76,68,0};
inline constexpr std::uint8_t kPayload286[] = {115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,0,1,1,38,8};
inline constexpr std::uint8_t kFrame287[] = {11,50,54,3,2,1,2,176,173,27,21,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,10,1,1,38,5,1,172,61,58,218,0};
inline constexpr std::uint8_t kPayload287[] = {115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,0,1,1,38,5,1};
inline constexpr std::uint8_t kFrame288[] = {11,50,54,3,2,1,2,176,173,27,19,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,8,1,1,38,82,22,125,19,0};
inline constexpr std::uint8_t kPayload288[] = {115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,0,1,1,38};
inline constexpr std::uint8_t kFrame289[] = {11,50,54,3,2,1,2,176,173,27,20,4,97,10,98,1,1,1,1,1,1,1,1,1,1,1,1,9,1,1,38,5,233,155,110,201,0};
inline constexpr std::uint8_t kPayload289[] = {97,10,98,0,0,0,0,0,0,0,0,0,0,0,0,0,1,1,38,5};
inline constexpr std::uint8_t kFrame290[] = {11,50,54,3,2,1,2,176,173,27,20,2,97,2,98,1,1,1,1,1,1,1,1,1,1,1,1,9,1,1,38,5,157,128,123,180,0};
inline constexpr std::uint8_t kPayload290[] = {97,0,98,0,0,0,0,0,0,0,0,0,0,0,0,0,1,1,38,5};
inline constexpr std::uint8_t kFrame291[] = {11,50,54,3,2,1,2,176,173,27,20,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,9,3,1,38,5,7,160,206,232,0};
inline constexpr std::uint8_t kPayload291[] = {115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,0,3,1,38,5};
inline constexpr std::uint8_t kFrame292[] = {11,50,54,3,2,1,2,176,173,27,20,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,9,1,2,38,5,213,214,129,64,0};
inline constexpr std::uint8_t kPayload292[] = {115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,0,1,2,38,5};
inline constexpr std::uint8_t kFrame293[] = {11,50,54,3,2,1,2,176,173,27,20,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,9,1,1,64,5,173,164,96,113,0};
inline constexpr std::uint8_t kPayload293[] = {115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,0,1,1,64,5};
inline constexpr std::uint8_t kFrame294[] = {11,50,54,3,2,1,2,176,173,27,20,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,9,1,1,38,8,49,20,118,60,0};
inline constexpr std::uint8_t kPayload294[] = {115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,0,1,1,38,8};
inline constexpr std::uint8_t kFrame295[] = {11,178,182,3,2,1,2,176,173,27,21,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,10,1,1,38,5,1,96,59,193,46,0};
inline constexpr std::uint8_t kPayload295[] = {115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,0,1,1,38,5,1};
inline constexpr std::uint8_t kFrame296[] = {11,178,182,3,2,1,2,176,173,27,19,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,8,1,1,38,110,135,156,207,0};
inline constexpr std::uint8_t kPayload296[] = {115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,0,1,1,38};
inline constexpr std::uint8_t kFrame297[] = {11,178,182,3,2,1,2,176,173,27,20,4,97,10,98,1,1,1,1,1,1,1,1,1,1,1,1,9,1,1,38,5,255,6,221,230,0};
inline constexpr std::uint8_t kPayload297[] = {97,10,98,0,0,0,0,0,0,0,0,0,0,0,0,0,1,1,38,5};
inline constexpr std::uint8_t kFrame298[] = {11,178,182,3,2,1,2,176,173,27,20,2,97,2,98,1,1,1,1,1,1,1,1,1,1,1,1,9,1,1,38,5,139,29,200,155,0};
inline constexpr std::uint8_t kPayload298[] = {97,0,98,0,0,0,0,0,0,0,0,0,0,0,0,0,1,1,38,5};
inline constexpr std::uint8_t kFrame299[] = {11,178,182,3,2,1,2,176,173,27,20,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,9,3,1,38,5,17,61,125,199,0};
inline constexpr std::uint8_t kPayload299[] = {115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,0,3,1,38,5};
inline constexpr std::uint8_t kFrame300[] = {11,178,182,3,2,1,2,176,173,27,20,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,9,1,2,38,5,195,75,50,111,0};
inline constexpr std::uint8_t kPayload300[] = {115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,0,1,2,38,5};
inline constexpr std::uint8_t kFrame301[] = {11,178,182,3,2,1,2,176,173,27,20,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,9,1,1,64,5,187,57,211,94,0};
inline constexpr std::uint8_t kPayload301[] = {115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,0,1,1,64,5};
inline constexpr std::uint8_t kFrame302[] = {11,178,182,3,2,1,2,176,173,27,20,16,115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,9,1,1,38,8,39,137,197,19,0};
inline constexpr std::uint8_t kPayload302[] = {115,101,114,105,97,108,95,110,117,109,98,101,114,45,48,0,1,1,38,8};
inline constexpr std::uint8_t kFrame303[] = {11,51,55,3,2,1,2,176,173,27,1,6,1,91,60,103,228,0};
inline constexpr std::uint8_t kPayload303[] = {1};
inline constexpr std::uint8_t kFrame304[] = {11,179,183,3,2,1,2,176,173,27,49,54,17,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,90,1,197,206,126,19,0};
inline constexpr std::uint8_t kPayload304[] = {17,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,90,1};
inline constexpr std::uint8_t kFrame305[] = {11,179,183,3,2,1,2,176,173,27,47,52,17,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,231,116,243,40,0};
inline constexpr std::uint8_t kPayload305[] = {17,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83};
inline constexpr std::uint8_t kFrame306[] = {11,52,56,3,2,1,2,176,173,27,49,54,17,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,90,1,6,212,5,34,0};
inline constexpr std::uint8_t kPayload306[] = {17,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,90,1};
inline constexpr std::uint8_t kFrame307[] = {11,52,56,3,2,1,2,176,173,27,47,52,17,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,186,147,242,102,0};
inline constexpr std::uint8_t kPayload307[] = {17,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83};
inline constexpr std::uint8_t kFrame308[] = {11,180,184,3,2,1,2,176,173,27,49,54,17,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,90,1,55,81,192,51,0};
inline constexpr std::uint8_t kPayload308[] = {17,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,90,1};
inline constexpr std::uint8_t kFrame309[] = {11,180,184,3,2,1,2,176,173,27,47,52,17,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83,67,240,213,137,0};
inline constexpr std::uint8_t kPayload309[] = {17,24,31,38,45,52,59,66,73,80,87,94,101,108,115,122,129,136,143,150,157,164,171,178,185,192,199,206,213,220,227,234,241,248,255,6,13,20,27,34,41,48,55,62,69,76,83};
inline constexpr std::uint8_t kFrame310[] = {11,254,2,4,2,1,2,176,173,27,7,12,19,24,31,48,65,82,1,124,57,63,156,0};
inline constexpr std::uint8_t kPayload310[] = {19,24,31,48,65,82,1};
inline constexpr std::uint8_t kFrame311[] = {11,254,2,4,2,1,2,176,173,27,5,10,19,24,31,48,65,190,64,227,206,0};
inline constexpr std::uint8_t kPayload311[] = {19,24,31,48,65};
inline constexpr std::uint8_t kFrame312[] = {11,254,2,4,2,1,2,176,173,27,6,11,30,24,31,48,65,82,163,182,97,73,0};
inline constexpr std::uint8_t kPayload312[] = {30,24,31,48,65,82};
inline constexpr std::uint8_t kFrame313[] = {11,255,3,4,2,1,2,176,173,27,7,12,19,24,31,48,65,82,1,222,68,203,244,0};
inline constexpr std::uint8_t kPayload313[] = {19,24,31,48,65,82,1};
inline constexpr std::uint8_t kFrame314[] = {11,255,3,4,2,1,2,176,173,27,5,10,19,24,31,48,65,199,10,112,217,0};
inline constexpr std::uint8_t kPayload314[] = {19,24,31,48,65};
inline constexpr std::uint8_t kFrame315[] = {11,255,3,4,2,1,2,176,173,27,6,11,30,24,31,48,65,82,113,236,175,96,0};
inline constexpr std::uint8_t kPayload315[] = {30,24,31,48,65,82};
inline constexpr std::uint8_t kFrame316[] = {11,64,68,3,2,1,2,176,173,27,2,7,4,1,190,40,112,98,0};
inline constexpr std::uint8_t kPayload316[] = {4,1};
inline constexpr std::uint8_t kFrame317[] = {10,64,68,3,2,1,2,176,173,27,1,5,131,27,60,5,0};
inline constexpr std::uint8_t kFrame318[] = {11,64,68,3,2,1,2,176,173,27,1,6,8,9,227,175,169,0};
inline constexpr std::uint8_t kPayload318[] = {8};
inline constexpr std::uint8_t kFrame319[] = {11,65,69,3,2,1,2,176,173,27,36,41,17,34,51,68,24,41,58,75,31,48,65,82,38,3,45,62,4,27,66,83,100,117,134,151,168,185,73,90,107,124,80,97,114,131,2,1,124,149,135,62,0};
inline constexpr std::uint8_t kPayload319[] = {17,34,51,68,24,41,58,75,31,48,65,82,38,3,45,62,4,27,66,83,100,117,134,151,168,185,73,90,107,124,80,97,114,131,2,1};
inline constexpr std::uint8_t kFrame320[] = {11,65,69,3,2,1,2,176,173,27,34,39,17,34,51,68,24,41,58,75,31,48,65,82,38,3,45,62,4,27,66,83,100,117,134,151,168,185,73,90,107,124,80,97,114,131,151,70,33,45,0};
inline constexpr std::uint8_t kPayload320[] = {17,34,51,68,24,41,58,75,31,48,65,82,38,3,45,62,4,27,66,83,100,117,134,151,168,185,73,90,107,124,80,97,114,131};
inline constexpr std::uint8_t kFrame321[] = {11,65,69,3,2,1,2,176,173,27,35,13,17,34,51,68,24,41,58,75,31,48,65,82,27,4,45,62,4,27,66,83,100,117,134,151,168,185,73,90,107,124,80,97,114,131,2,189,254,76,88,0};
inline constexpr std::uint8_t kPayload321[] = {17,34,51,68,24,41,58,75,31,48,65,82,0,4,45,62,4,27,66,83,100,117,134,151,168,185,73,90,107,124,80,97,114,131,2};
inline constexpr std::uint8_t kFrame322[] = {11,65,69,3,2,1,2,176,173,27,35,40,17,34,51,68,24,41,58,75,31,48,65,82,38,3,45,62,16,27,66,83,100,117,134,151,168,185,73,90,107,124,80,97,114,131,2,247,136,144,40,0};
inline constexpr std::uint8_t kPayload322[] = {17,34,51,68,24,41,58,75,31,48,65,82,38,3,45,62,16,27,66,83,100,117,134,151,168,185,73,90,107,124,80,97,114,131,2};
inline constexpr std::uint8_t kFrame323[] = {11,65,69,3,2,1,2,176,173,27,35,40,17,34,51,68,24,41,58,75,31,48,65,82,38,3,45,62,4,32,66,83,100,117,134,151,168,185,73,90,107,124,80,97,114,131,2,89,41,136,92,0};
inline constexpr std::uint8_t kPayload323[] = {17,34,51,68,24,41,58,75,31,48,65,82,38,3,45,62,4,32,66,83,100,117,134,151,168,185,73,90,107,124,80,97,114,131,2};
inline constexpr std::uint8_t kFrame324[] = {11,66,70,3,2,1,2,176,173,27,22,27,3,24,41,58,75,31,48,65,82,38,55,72,89,45,62,79,96,113,130,147,164,1,191,88,120,171,0};
inline constexpr std::uint8_t kPayload324[] = {3,24,41,58,75,31,48,65,82,38,55,72,89,45,62,79,96,113,130,147,164,1};
inline constexpr std::uint8_t kFrame325[] = {11,66,70,3,2,1,2,176,173,27,20,25,3,24,41,58,75,31,48,65,82,38,55,72,89,45,62,79,96,113,130,147,167,214,251,146,0};
inline constexpr std::uint8_t kPayload325[] = {3,24,41,58,75,31,48,65,82,38,55,72,89,45,62,79,96,113,130,147};
inline constexpr std::uint8_t kFrame326[] = {11,66,70,3,2,1,2,176,173,27,21,26,6,24,41,58,75,31,48,65,82,38,55,72,89,45,62,79,96,113,130,147,164,16,40,201,93,0};
inline constexpr std::uint8_t kPayload326[] = {6,24,41,58,75,31,48,65,82,38,55,72,89,45,62,79,96,113,130,147,164};
inline constexpr std::uint8_t kFrame327[] = {11,67,71,3,2,1,2,176,173,27,20,25,5,24,41,58,75,31,48,38,55,72,89,106,123,140,157,45,62,79,96,1,252,141,62,215,0};
inline constexpr std::uint8_t kPayload327[] = {5,24,41,58,75,31,48,38,55,72,89,106,123,140,157,45,62,79,96,1};
inline constexpr std::uint8_t kFrame328[] = {11,67,71,3,2,1,2,176,173,27,18,23,5,24,41,58,75,31,48,38,55,72,89,106,123,140,157,45,62,79,183,250,207,189,0};
inline constexpr std::uint8_t kPayload328[] = {5,24,41,58,75,31,48,38,55,72,89,106,123,140,157,45,62,79};
inline constexpr std::uint8_t kFrame329[] = {11,67,71,3,2,1,2,176,173,27,19,24,10,24,41,58,75,31,48,38,55,72,89,106,123,140,157,45,62,79,96,80,114,77,22,0};
inline constexpr std::uint8_t kPayload329[] = {10,24,41,58,75,31,48,38,55,72,89,106,123,140,157,45,62,79,96};
inline constexpr std::uint8_t kFrame330[] = {0};
inline constexpr std::uint8_t kFrame331[] = {3,3,7,1,1,5,2,176,173,27,1,5,194,232,196,242,0};
inline constexpr std::uint8_t kFrame332[] = {3,2,7,1,1,5,2,176,173,27,1,5,194,232,196,226,0};
inline constexpr std::uint8_t kFrame333[] = {3,63,7,1,1,6,2,176,173,27,3,7,1,2,3,213,18,186,0};
inline constexpr std::uint8_t kFrame334[] = {3,3,7,1,1,5,2,176,173,27,1,4,194,232,196,0};
inline constexpr std::uint8_t kFrame335[] = {3,3,7,1,1,5,116,181,85,28,0};
inline constexpr std::uint8_t kFrame336[] = {2,1,0};
inline constexpr std::uint8_t kFrame337[] = {3,3,7,1,1,6,2,176,173,27,3,7,1,2,62,208,100,243,0};
inline constexpr std::uint8_t kFrame338[] = {3,3,7,1,1,6,2,176,173,27,1,7,1,2,181,24,109,89,0};
inline constexpr std::uint8_t kFrame339[] = {255,3,7,7,7,7,2,176,173,27,7,7,194,232,196,226,0};
inline constexpr std::uint8_t kFrame340[] = {3,3,7,1,1,255,2,176,173,27,3,1,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,51,16,51,51,51,51,51,51,51,51,51,51,51,53,139,168,158,0};
inline constexpr std::uint8_t kFrame341[] = {11,63,67,3,2,1,2,176,173,27,3,8,1,2,3,231,233,190,182,0};
inline constexpr std::uint8_t kPayload341[] = {1,2,3};

inline constexpr std::uint8_t kStuffed0[] = {1};
inline constexpr std::uint8_t kPlain1[] = {0};
inline constexpr std::uint8_t kStuffed1[] = {1,1};
inline constexpr std::uint8_t kPlain2[] = {0,0};
inline constexpr std::uint8_t kStuffed2[] = {1,1,1};
inline constexpr std::uint8_t kPlain3[] = {1};
inline constexpr std::uint8_t kStuffed3[] = {2,1};
inline constexpr std::uint8_t kPlain4[] = {1,0};
inline constexpr std::uint8_t kStuffed4[] = {2,1,1};
inline constexpr std::uint8_t kPlain5[] = {0,1};
inline constexpr std::uint8_t kStuffed5[] = {1,2,1};
inline constexpr std::uint8_t kPlain6[] = {17,34,0,51};
inline constexpr std::uint8_t kStuffed6[] = {3,17,34,2,51};
inline constexpr std::uint8_t kPlain7[] = {255,255,255};
inline constexpr std::uint8_t kStuffed7[] = {4,255,255,255};
inline constexpr std::uint8_t kPlain8[] = {1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253};
inline constexpr std::uint8_t kStuffed8[] = {254,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253};
inline constexpr std::uint8_t kPlain9[] = {1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,254};
inline constexpr std::uint8_t kStuffed9[] = {255,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,254};
inline constexpr std::uint8_t kPlain10[] = {1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,254,255};
inline constexpr std::uint8_t kStuffed10[] = {255,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,254,2,255};
inline constexpr std::uint8_t kPlain11[] = {1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,0};
inline constexpr std::uint8_t kStuffed11[] = {254,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,1};
inline constexpr std::uint8_t kPlain12[] = {1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,254,0};
inline constexpr std::uint8_t kStuffed12[] = {255,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,254,1,1};
inline constexpr std::uint8_t kPlain13[] = {1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,254,255,0};
inline constexpr std::uint8_t kStuffed13[] = {255,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,254,2,255,1};
inline constexpr std::uint8_t kPlain14[] = {0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253};
inline constexpr std::uint8_t kStuffed14[] = {1,254,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253};
inline constexpr std::uint8_t kPlain15[] = {0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,254};
inline constexpr std::uint8_t kStuffed15[] = {1,255,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,254};
inline constexpr std::uint8_t kPlain16[] = {0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,254,255};
inline constexpr std::uint8_t kStuffed16[] = {1,255,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,254,2,255};
inline constexpr std::uint8_t kPlain17[] = {1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,254,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,254};
inline constexpr std::uint8_t kStuffed17[] = {255,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,254,255,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,254};
inline constexpr std::uint8_t kPlain18[] = {1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,254,1};
inline constexpr std::uint8_t kStuffed18[] = {255,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,254,2,1};
inline constexpr std::uint8_t kPlain19[] = {1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,254,0,1};
inline constexpr std::uint8_t kStuffed19[] = {255,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,254,1,2,1};
inline constexpr std::uint8_t kPlain20[] = {0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0};
inline constexpr std::uint8_t kStuffed20[] = {1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1};
inline constexpr std::uint8_t kPlain21[] = {1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,254,255,0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,254,255};
inline constexpr std::uint8_t kStuffed21[] = {255,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,254,2,255,255,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64,65,66,67,68,69,70,71,72,73,74,75,76,77,78,79,80,81,82,83,84,85,86,87,88,89,90,91,92,93,94,95,96,97,98,99,100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,121,122,123,124,125,126,127,128,129,130,131,132,133,134,135,136,137,138,139,140,141,142,143,144,145,146,147,148,149,150,151,152,153,154,155,156,157,158,159,160,161,162,163,164,165,166,167,168,169,170,171,172,173,174,175,176,177,178,179,180,181,182,183,184,185,186,187,188,189,190,191,192,193,194,195,196,197,198,199,200,201,202,203,204,205,206,207,208,209,210,211,212,213,214,215,216,217,218,219,220,221,222,223,224,225,226,227,228,229,230,231,232,233,234,235,236,237,238,239,240,241,242,243,244,245,246,247,248,249,250,251,252,253,254,2,255};

}  // namespace data

inline constexpr FrameVector kFrames[] = {
    {"hello_request_typical", Verdict::kOk, data::kFrame0, sizeof data::kFrame0, 1, 16909061U, 464367618U, nullptr, 0, 0, data::matches0, data::decode_as<wire::HelloRequest>},
    {"hello_reply_typical", Verdict::kOk, data::kFrame1, sizeof data::kFrame1, 129, 16909189U, 464367618U, data::kPayload1, sizeof data::kPayload1, 0, data::matches1, data::decode_as<wire::HelloReply>},
    {"hello_reply_least", Verdict::kOk, data::kFrame2, sizeof data::kFrame2, 129, 16909189U, 464367618U, data::kPayload2, sizeof data::kPayload2, 0, data::matches2, data::decode_as<wire::HelloReply>},
    {"hello_reply_greatest", Verdict::kOk, data::kFrame3, sizeof data::kFrame3, 129, 16909189U, 464367618U, data::kPayload3, sizeof data::kPayload3, 0, data::matches3, data::decode_as<wire::HelloReply>},
    {"enter_bootloader_request_typical", Verdict::kOk, data::kFrame4, sizeof data::kFrame4, 2, 16909062U, 464367618U, data::kPayload4, sizeof data::kPayload4, 0, data::matches4, data::decode_as<wire::EnterBootloaderRequest>},
    {"enter_bootloader_request_least", Verdict::kOk, data::kFrame5, sizeof data::kFrame5, 2, 16909062U, 464367618U, data::kPayload5, sizeof data::kPayload5, 0, data::matches5, data::decode_as<wire::EnterBootloaderRequest>},
    {"enter_bootloader_request_greatest", Verdict::kOk, data::kFrame6, sizeof data::kFrame6, 2, 16909062U, 464367618U, data::kPayload6, sizeof data::kPayload6, 0, data::matches6, data::decode_as<wire::EnterBootloaderRequest>},
    {"enter_bootloader_reply_typical", Verdict::kOk, data::kFrame7, sizeof data::kFrame7, 130, 16909190U, 464367618U, data::kPayload7, sizeof data::kPayload7, 0, data::matches7, data::decode_as<wire::EnterBootloaderReply>},
    {"enter_bootloader_reply_least", Verdict::kOk, data::kFrame8, sizeof data::kFrame8, 130, 16909190U, 464367618U, data::kPayload8, sizeof data::kPayload8, 0, data::matches8, data::decode_as<wire::EnterBootloaderReply>},
    {"enter_bootloader_reply_greatest", Verdict::kOk, data::kFrame9, sizeof data::kFrame9, 130, 16909190U, 464367618U, data::kPayload9, sizeof data::kPayload9, 0, data::matches9, data::decode_as<wire::EnterBootloaderReply>},
    {"status_request_typical", Verdict::kOk, data::kFrame10, sizeof data::kFrame10, 3, 16909063U, 464367618U, nullptr, 0, 0, data::matches10, data::decode_as<wire::StatusRequest>},
    {"status_reply_typical", Verdict::kOk, data::kFrame11, sizeof data::kFrame11, 131, 16909191U, 464367618U, data::kPayload11, sizeof data::kPayload11, 0, data::matches11, data::decode_as<wire::StatusReply>},
    {"status_reply_least", Verdict::kOk, data::kFrame12, sizeof data::kFrame12, 131, 16909191U, 464367618U, data::kPayload12, sizeof data::kPayload12, 0, data::matches12, data::decode_as<wire::StatusReply>},
    {"status_reply_greatest", Verdict::kOk, data::kFrame13, sizeof data::kFrame13, 131, 16909191U, 464367618U, data::kPayload13, sizeof data::kPayload13, 0, data::matches13, data::decode_as<wire::StatusReply>},
    {"limits_request_typical", Verdict::kOk, data::kFrame14, sizeof data::kFrame14, 4, 16909064U, 464367618U, nullptr, 0, 0, data::matches14, data::decode_as<wire::LimitsRequest>},
    {"limits_reply_typical", Verdict::kOk, data::kFrame15, sizeof data::kFrame15, 132, 16909192U, 464367618U, data::kPayload15, sizeof data::kPayload15, 0, data::matches15, data::decode_as<wire::LimitsReply>},
    {"limits_reply_least", Verdict::kOk, data::kFrame16, sizeof data::kFrame16, 132, 16909192U, 464367618U, data::kPayload16, sizeof data::kPayload16, 0, data::matches16, data::decode_as<wire::LimitsReply>},
    {"limits_reply_greatest", Verdict::kOk, data::kFrame17, sizeof data::kFrame17, 132, 16909192U, 464367618U, data::kPayload17, sizeof data::kPayload17, 0, data::matches17, data::decode_as<wire::LimitsReply>},
    {"load_light_request_typical", Verdict::kOk, data::kFrame18, sizeof data::kFrame18, 16, 16909076U, 464367618U, data::kPayload18, sizeof data::kPayload18, 0, data::matches18, data::decode_as<wire::LoadLightRequest>},
    {"load_light_request_least", Verdict::kOk, data::kFrame19, sizeof data::kFrame19, 16, 16909076U, 464367618U, data::kPayload19, sizeof data::kPayload19, 0, data::matches19, data::decode_as<wire::LoadLightRequest>},
    {"load_light_request_greatest", Verdict::kOk, data::kFrame20, sizeof data::kFrame20, 16, 16909076U, 464367618U, data::kPayload20, sizeof data::kPayload20, 0, data::matches20, data::decode_as<wire::LoadLightRequest>},
    {"load_light_reply_typical", Verdict::kOk, data::kFrame21, sizeof data::kFrame21, 144, 16909204U, 464367618U, data::kPayload21, sizeof data::kPayload21, 0, data::matches21, data::decode_as<wire::LoadLightReply>},
    {"load_light_reply_least", Verdict::kOk, data::kFrame22, sizeof data::kFrame22, 144, 16909204U, 464367618U, data::kPayload22, sizeof data::kPayload22, 0, data::matches22, data::decode_as<wire::LoadLightReply>},
    {"load_light_reply_greatest", Verdict::kOk, data::kFrame23, sizeof data::kFrame23, 144, 16909204U, 464367618U, data::kPayload23, sizeof data::kPayload23, 0, data::matches23, data::decode_as<wire::LoadLightReply>},
    {"aperture_chunk_request_typical", Verdict::kOk, data::kFrame24, sizeof data::kFrame24, 17, 16909077U, 464367618U, data::kPayload24, sizeof data::kPayload24, 0, data::matches24, data::decode_as<wire::ApertureChunkRequest>},
    {"aperture_chunk_request_least", Verdict::kOk, data::kFrame25, sizeof data::kFrame25, 17, 16909077U, 464367618U, data::kPayload25, sizeof data::kPayload25, 0, data::matches25, data::decode_as<wire::ApertureChunkRequest>},
    {"aperture_chunk_request_greatest", Verdict::kOk, data::kFrame26, sizeof data::kFrame26, 17, 16909077U, 464367618U, data::kPayload26, sizeof data::kPayload26, 0, data::matches26, data::decode_as<wire::ApertureChunkRequest>},
    {"aperture_chunk_reply_typical", Verdict::kOk, data::kFrame27, sizeof data::kFrame27, 145, 16909205U, 464367618U, data::kPayload27, sizeof data::kPayload27, 0, data::matches27, data::decode_as<wire::ApertureChunkReply>},
    {"aperture_chunk_reply_least", Verdict::kOk, data::kFrame28, sizeof data::kFrame28, 145, 16909205U, 464367618U, data::kPayload28, sizeof data::kPayload28, 0, data::matches28, data::decode_as<wire::ApertureChunkReply>},
    {"aperture_chunk_reply_greatest", Verdict::kOk, data::kFrame29, sizeof data::kFrame29, 145, 16909205U, 464367618U, data::kPayload29, sizeof data::kPayload29, 0, data::matches29, data::decode_as<wire::ApertureChunkReply>},
    {"commit_aperture_request_typical", Verdict::kOk, data::kFrame30, sizeof data::kFrame30, 18, 16909078U, 464367618U, data::kPayload30, sizeof data::kPayload30, 0, data::matches30, data::decode_as<wire::CommitApertureRequest>},
    {"commit_aperture_request_least", Verdict::kOk, data::kFrame31, sizeof data::kFrame31, 18, 16909078U, 464367618U, data::kPayload31, sizeof data::kPayload31, 0, data::matches31, data::decode_as<wire::CommitApertureRequest>},
    {"commit_aperture_request_greatest", Verdict::kOk, data::kFrame32, sizeof data::kFrame32, 18, 16909078U, 464367618U, data::kPayload32, sizeof data::kPayload32, 0, data::matches32, data::decode_as<wire::CommitApertureRequest>},
    {"commit_aperture_reply_typical", Verdict::kOk, data::kFrame33, sizeof data::kFrame33, 146, 16909206U, 464367618U, data::kPayload33, sizeof data::kPayload33, 0, data::matches33, data::decode_as<wire::CommitApertureReply>},
    {"commit_aperture_reply_least", Verdict::kOk, data::kFrame34, sizeof data::kFrame34, 146, 16909206U, 464367618U, data::kPayload34, sizeof data::kPayload34, 0, data::matches34, data::decode_as<wire::CommitApertureReply>},
    {"commit_aperture_reply_greatest", Verdict::kOk, data::kFrame35, sizeof data::kFrame35, 146, 16909206U, 464367618U, data::kPayload35, sizeof data::kPayload35, 0, data::matches35, data::decode_as<wire::CommitApertureReply>},
    {"select_aperture_request_typical", Verdict::kOk, data::kFrame36, sizeof data::kFrame36, 19, 16909079U, 464367618U, data::kPayload36, sizeof data::kPayload36, 0, data::matches36, data::decode_as<wire::SelectApertureRequest>},
    {"select_aperture_request_least", Verdict::kOk, data::kFrame37, sizeof data::kFrame37, 19, 16909079U, 464367618U, data::kPayload37, sizeof data::kPayload37, 0, data::matches37, data::decode_as<wire::SelectApertureRequest>},
    {"select_aperture_request_greatest", Verdict::kOk, data::kFrame38, sizeof data::kFrame38, 19, 16909079U, 464367618U, data::kPayload38, sizeof data::kPayload38, 0, data::matches38, data::decode_as<wire::SelectApertureRequest>},
    {"select_aperture_reply_typical", Verdict::kOk, data::kFrame39, sizeof data::kFrame39, 147, 16909207U, 464367618U, data::kPayload39, sizeof data::kPayload39, 0, data::matches39, data::decode_as<wire::SelectApertureReply>},
    {"select_aperture_reply_least", Verdict::kOk, data::kFrame40, sizeof data::kFrame40, 147, 16909207U, 464367618U, data::kPayload40, sizeof data::kPayload40, 0, data::matches40, data::decode_as<wire::SelectApertureReply>},
    {"select_aperture_reply_greatest", Verdict::kOk, data::kFrame41, sizeof data::kFrame41, 147, 16909207U, 464367618U, data::kPayload41, sizeof data::kPayload41, 0, data::matches41, data::decode_as<wire::SelectApertureReply>},
    {"select_light_request_typical", Verdict::kOk, data::kFrame42, sizeof data::kFrame42, 20, 16909080U, 464367618U, data::kPayload42, sizeof data::kPayload42, 0, data::matches42, data::decode_as<wire::SelectLightRequest>},
    {"select_light_request_least", Verdict::kOk, data::kFrame43, sizeof data::kFrame43, 20, 16909080U, 464367618U, data::kPayload43, sizeof data::kPayload43, 0, data::matches43, data::decode_as<wire::SelectLightRequest>},
    {"select_light_request_greatest", Verdict::kOk, data::kFrame44, sizeof data::kFrame44, 20, 16909080U, 464367618U, data::kPayload44, sizeof data::kPayload44, 0, data::matches44, data::decode_as<wire::SelectLightRequest>},
    {"select_light_reply_typical", Verdict::kOk, data::kFrame45, sizeof data::kFrame45, 148, 16909208U, 464367618U, data::kPayload45, sizeof data::kPayload45, 0, data::matches45, data::decode_as<wire::SelectLightReply>},
    {"select_light_reply_least", Verdict::kOk, data::kFrame46, sizeof data::kFrame46, 148, 16909208U, 464367618U, data::kPayload46, sizeof data::kPayload46, 0, data::matches46, data::decode_as<wire::SelectLightReply>},
    {"select_light_reply_greatest", Verdict::kOk, data::kFrame47, sizeof data::kFrame47, 148, 16909208U, 464367618U, data::kPayload47, sizeof data::kPayload47, 0, data::matches47, data::decode_as<wire::SelectLightReply>},
    {"all_off_request_typical", Verdict::kOk, data::kFrame48, sizeof data::kFrame48, 21, 16909081U, 464367618U, nullptr, 0, 0, data::matches48, data::decode_as<wire::AllOffRequest>},
    {"all_off_reply_typical", Verdict::kOk, data::kFrame49, sizeof data::kFrame49, 149, 16909209U, 464367618U, data::kPayload49, sizeof data::kPayload49, 0, data::matches49, data::decode_as<wire::AllOffReply>},
    {"all_off_reply_least", Verdict::kOk, data::kFrame50, sizeof data::kFrame50, 149, 16909209U, 464367618U, data::kPayload50, sizeof data::kPayload50, 0, data::matches50, data::decode_as<wire::AllOffReply>},
    {"all_off_reply_greatest", Verdict::kOk, data::kFrame51, sizeof data::kFrame51, 149, 16909209U, 464367618U, data::kPayload51, sizeof data::kPayload51, 0, data::matches51, data::decode_as<wire::AllOffReply>},
    {"step_chunk_request_typical", Verdict::kOk, data::kFrame52, sizeof data::kFrame52, 32, 16909092U, 464367618U, data::kPayload52, sizeof data::kPayload52, 0, data::matches52, data::decode_as<wire::StepChunkRequest>},
    {"step_chunk_request_least", Verdict::kOk, data::kFrame53, sizeof data::kFrame53, 32, 16909092U, 464367618U, data::kPayload53, sizeof data::kPayload53, 0, data::matches53, data::decode_as<wire::StepChunkRequest>},
    {"step_chunk_request_greatest", Verdict::kOk, data::kFrame54, sizeof data::kFrame54, 32, 16909092U, 464367618U, data::kPayload54, sizeof data::kPayload54, 0, data::matches54, data::decode_as<wire::StepChunkRequest>},
    {"step_chunk_reply_typical", Verdict::kOk, data::kFrame55, sizeof data::kFrame55, 160, 16909220U, 464367618U, data::kPayload55, sizeof data::kPayload55, 0, data::matches55, data::decode_as<wire::StepChunkReply>},
    {"step_chunk_reply_least", Verdict::kOk, data::kFrame56, sizeof data::kFrame56, 160, 16909220U, 464367618U, data::kPayload56, sizeof data::kPayload56, 0, data::matches56, data::decode_as<wire::StepChunkReply>},
    {"step_chunk_reply_greatest", Verdict::kOk, data::kFrame57, sizeof data::kFrame57, 160, 16909220U, 464367618U, data::kPayload57, sizeof data::kPayload57, 0, data::matches57, data::decode_as<wire::StepChunkReply>},
    {"commit_steps_request_typical", Verdict::kOk, data::kFrame58, sizeof data::kFrame58, 33, 16909093U, 464367618U, data::kPayload58, sizeof data::kPayload58, 0, data::matches58, data::decode_as<wire::CommitStepsRequest>},
    {"commit_steps_request_least", Verdict::kOk, data::kFrame59, sizeof data::kFrame59, 33, 16909093U, 464367618U, data::kPayload59, sizeof data::kPayload59, 0, data::matches59, data::decode_as<wire::CommitStepsRequest>},
    {"commit_steps_request_greatest", Verdict::kOk, data::kFrame60, sizeof data::kFrame60, 33, 16909093U, 464367618U, data::kPayload60, sizeof data::kPayload60, 0, data::matches60, data::decode_as<wire::CommitStepsRequest>},
    {"commit_steps_reply_typical", Verdict::kOk, data::kFrame61, sizeof data::kFrame61, 161, 16909221U, 464367618U, data::kPayload61, sizeof data::kPayload61, 0, data::matches61, data::decode_as<wire::CommitStepsReply>},
    {"commit_steps_reply_least", Verdict::kOk, data::kFrame62, sizeof data::kFrame62, 161, 16909221U, 464367618U, data::kPayload62, sizeof data::kPayload62, 0, data::matches62, data::decode_as<wire::CommitStepsReply>},
    {"commit_steps_reply_greatest", Verdict::kOk, data::kFrame63, sizeof data::kFrame63, 161, 16909221U, 464367618U, data::kPayload63, sizeof data::kPayload63, 0, data::matches63, data::decode_as<wire::CommitStepsReply>},
    {"start_request_typical", Verdict::kOk, data::kFrame64, sizeof data::kFrame64, 34, 16909094U, 464367618U, data::kPayload64, sizeof data::kPayload64, 0, data::matches64, data::decode_as<wire::StartRequest>},
    {"start_request_least", Verdict::kOk, data::kFrame65, sizeof data::kFrame65, 34, 16909094U, 464367618U, data::kPayload65, sizeof data::kPayload65, 0, data::matches65, data::decode_as<wire::StartRequest>},
    {"start_request_greatest", Verdict::kOk, data::kFrame66, sizeof data::kFrame66, 34, 16909094U, 464367618U, data::kPayload66, sizeof data::kPayload66, 0, data::matches66, data::decode_as<wire::StartRequest>},
    {"start_reply_typical", Verdict::kOk, data::kFrame67, sizeof data::kFrame67, 162, 16909222U, 464367618U, data::kPayload67, sizeof data::kPayload67, 0, data::matches67, data::decode_as<wire::StartReply>},
    {"start_reply_least", Verdict::kOk, data::kFrame68, sizeof data::kFrame68, 162, 16909222U, 464367618U, data::kPayload68, sizeof data::kPayload68, 0, data::matches68, data::decode_as<wire::StartReply>},
    {"start_reply_greatest", Verdict::kOk, data::kFrame69, sizeof data::kFrame69, 162, 16909222U, 464367618U, data::kPayload69, sizeof data::kPayload69, 0, data::matches69, data::decode_as<wire::StartReply>},
    {"pause_request_typical", Verdict::kOk, data::kFrame70, sizeof data::kFrame70, 35, 16909095U, 464367618U, data::kPayload70, sizeof data::kPayload70, 0, data::matches70, data::decode_as<wire::PauseRequest>},
    {"pause_request_least", Verdict::kOk, data::kFrame71, sizeof data::kFrame71, 35, 16909095U, 464367618U, data::kPayload71, sizeof data::kPayload71, 0, data::matches71, data::decode_as<wire::PauseRequest>},
    {"pause_request_greatest", Verdict::kOk, data::kFrame72, sizeof data::kFrame72, 35, 16909095U, 464367618U, data::kPayload72, sizeof data::kPayload72, 0, data::matches72, data::decode_as<wire::PauseRequest>},
    {"pause_reply_typical", Verdict::kOk, data::kFrame73, sizeof data::kFrame73, 163, 16909223U, 464367618U, data::kPayload73, sizeof data::kPayload73, 0, data::matches73, data::decode_as<wire::PauseReply>},
    {"pause_reply_least", Verdict::kOk, data::kFrame74, sizeof data::kFrame74, 163, 16909223U, 464367618U, data::kPayload74, sizeof data::kPayload74, 0, data::matches74, data::decode_as<wire::PauseReply>},
    {"pause_reply_greatest", Verdict::kOk, data::kFrame75, sizeof data::kFrame75, 163, 16909223U, 464367618U, data::kPayload75, sizeof data::kPayload75, 0, data::matches75, data::decode_as<wire::PauseReply>},
    {"resume_request_typical", Verdict::kOk, data::kFrame76, sizeof data::kFrame76, 36, 16909096U, 464367618U, data::kPayload76, sizeof data::kPayload76, 0, data::matches76, data::decode_as<wire::ResumeRequest>},
    {"resume_request_least", Verdict::kOk, data::kFrame77, sizeof data::kFrame77, 36, 16909096U, 464367618U, data::kPayload77, sizeof data::kPayload77, 0, data::matches77, data::decode_as<wire::ResumeRequest>},
    {"resume_request_greatest", Verdict::kOk, data::kFrame78, sizeof data::kFrame78, 36, 16909096U, 464367618U, data::kPayload78, sizeof data::kPayload78, 0, data::matches78, data::decode_as<wire::ResumeRequest>},
    {"resume_reply_typical", Verdict::kOk, data::kFrame79, sizeof data::kFrame79, 164, 16909224U, 464367618U, data::kPayload79, sizeof data::kPayload79, 0, data::matches79, data::decode_as<wire::ResumeReply>},
    {"resume_reply_least", Verdict::kOk, data::kFrame80, sizeof data::kFrame80, 164, 16909224U, 464367618U, data::kPayload80, sizeof data::kPayload80, 0, data::matches80, data::decode_as<wire::ResumeReply>},
    {"resume_reply_greatest", Verdict::kOk, data::kFrame81, sizeof data::kFrame81, 164, 16909224U, 464367618U, data::kPayload81, sizeof data::kPayload81, 0, data::matches81, data::decode_as<wire::ResumeReply>},
    {"abort_request_typical", Verdict::kOk, data::kFrame82, sizeof data::kFrame82, 37, 16909097U, 464367618U, data::kPayload82, sizeof data::kPayload82, 0, data::matches82, data::decode_as<wire::AbortRequest>},
    {"abort_request_least", Verdict::kOk, data::kFrame83, sizeof data::kFrame83, 37, 16909097U, 464367618U, data::kPayload83, sizeof data::kPayload83, 0, data::matches83, data::decode_as<wire::AbortRequest>},
    {"abort_request_greatest", Verdict::kOk, data::kFrame84, sizeof data::kFrame84, 37, 16909097U, 464367618U, data::kPayload84, sizeof data::kPayload84, 0, data::matches84, data::decode_as<wire::AbortRequest>},
    {"abort_reply_typical", Verdict::kOk, data::kFrame85, sizeof data::kFrame85, 165, 16909225U, 464367618U, data::kPayload85, sizeof data::kPayload85, 0, data::matches85, data::decode_as<wire::AbortReply>},
    {"abort_reply_least", Verdict::kOk, data::kFrame86, sizeof data::kFrame86, 165, 16909225U, 464367618U, data::kPayload86, sizeof data::kPayload86, 0, data::matches86, data::decode_as<wire::AbortReply>},
    {"abort_reply_greatest", Verdict::kOk, data::kFrame87, sizeof data::kFrame87, 165, 16909225U, 464367618U, data::kPayload87, sizeof data::kPayload87, 0, data::matches87, data::decode_as<wire::AbortReply>},
    {"clear_fault_request_typical", Verdict::kOk, data::kFrame88, sizeof data::kFrame88, 38, 16909098U, 464367618U, data::kPayload88, sizeof data::kPayload88, 0, data::matches88, data::decode_as<wire::ClearFaultRequest>},
    {"clear_fault_request_least", Verdict::kOk, data::kFrame89, sizeof data::kFrame89, 38, 16909098U, 464367618U, data::kPayload89, sizeof data::kPayload89, 0, data::matches89, data::decode_as<wire::ClearFaultRequest>},
    {"clear_fault_request_greatest", Verdict::kOk, data::kFrame90, sizeof data::kFrame90, 38, 16909098U, 464367618U, data::kPayload90, sizeof data::kPayload90, 0, data::matches90, data::decode_as<wire::ClearFaultRequest>},
    {"clear_fault_reply_typical", Verdict::kOk, data::kFrame91, sizeof data::kFrame91, 166, 16909226U, 464367618U, data::kPayload91, sizeof data::kPayload91, 0, data::matches91, data::decode_as<wire::ClearFaultReply>},
    {"clear_fault_reply_least", Verdict::kOk, data::kFrame92, sizeof data::kFrame92, 166, 16909226U, 464367618U, data::kPayload92, sizeof data::kPayload92, 0, data::matches92, data::decode_as<wire::ClearFaultReply>},
    {"clear_fault_reply_greatest", Verdict::kOk, data::kFrame93, sizeof data::kFrame93, 166, 16909226U, 464367618U, data::kPayload93, sizeof data::kPayload93, 0, data::matches93, data::decode_as<wire::ClearFaultReply>},
    {"acknowledge_events_request_typical", Verdict::kOk, data::kFrame94, sizeof data::kFrame94, 39, 16909099U, 464367618U, data::kPayload94, sizeof data::kPayload94, 0, data::matches94, data::decode_as<wire::AcknowledgeEventsRequest>},
    {"acknowledge_events_request_least", Verdict::kOk, data::kFrame95, sizeof data::kFrame95, 39, 16909099U, 464367618U, data::kPayload95, sizeof data::kPayload95, 0, data::matches95, data::decode_as<wire::AcknowledgeEventsRequest>},
    {"acknowledge_events_request_greatest", Verdict::kOk, data::kFrame96, sizeof data::kFrame96, 39, 16909099U, 464367618U, data::kPayload96, sizeof data::kPayload96, 0, data::matches96, data::decode_as<wire::AcknowledgeEventsRequest>},
    {"acknowledge_events_reply_typical", Verdict::kOk, data::kFrame97, sizeof data::kFrame97, 167, 16909227U, 464367618U, data::kPayload97, sizeof data::kPayload97, 0, data::matches97, data::decode_as<wire::AcknowledgeEventsReply>},
    {"acknowledge_events_reply_least", Verdict::kOk, data::kFrame98, sizeof data::kFrame98, 167, 16909227U, 464367618U, data::kPayload98, sizeof data::kPayload98, 0, data::matches98, data::decode_as<wire::AcknowledgeEventsReply>},
    {"acknowledge_events_reply_greatest", Verdict::kOk, data::kFrame99, sizeof data::kFrame99, 167, 16909227U, 464367618U, data::kPayload99, sizeof data::kPayload99, 0, data::matches99, data::decode_as<wire::AcknowledgeEventsReply>},
    {"counters_request_typical", Verdict::kOk, data::kFrame100, sizeof data::kFrame100, 48, 16909108U, 464367618U, nullptr, 0, 0, data::matches100, data::decode_as<wire::CountersRequest>},
    {"counters_reply_typical", Verdict::kOk, data::kFrame101, sizeof data::kFrame101, 176, 16909236U, 464367618U, data::kPayload101, sizeof data::kPayload101, 0, data::matches101, data::decode_as<wire::CountersReply>},
    {"counters_reply_least", Verdict::kOk, data::kFrame102, sizeof data::kFrame102, 176, 16909236U, 464367618U, data::kPayload102, sizeof data::kPayload102, 0, data::matches102, data::decode_as<wire::CountersReply>},
    {"counters_reply_greatest", Verdict::kOk, data::kFrame103, sizeof data::kFrame103, 176, 16909236U, 464367618U, data::kPayload103, sizeof data::kPayload103, 0, data::matches103, data::decode_as<wire::CountersReply>},
    {"get_settings_request_typical", Verdict::kOk, data::kFrame104, sizeof data::kFrame104, 49, 16909109U, 464367618U, nullptr, 0, 0, data::matches104, data::decode_as<wire::GetSettingsRequest>},
    {"get_settings_reply_typical", Verdict::kOk, data::kFrame105, sizeof data::kFrame105, 177, 16909237U, 464367618U, data::kPayload105, sizeof data::kPayload105, 0, data::matches105, data::decode_as<wire::GetSettingsReply>},
    {"get_settings_reply_least", Verdict::kOk, data::kFrame106, sizeof data::kFrame106, 177, 16909237U, 464367618U, data::kPayload106, sizeof data::kPayload106, 0, data::matches106, data::decode_as<wire::GetSettingsReply>},
    {"get_settings_reply_greatest", Verdict::kOk, data::kFrame107, sizeof data::kFrame107, 177, 16909237U, 464367618U, data::kPayload107, sizeof data::kPayload107, 0, data::matches107, data::decode_as<wire::GetSettingsReply>},
    {"set_settings_request_typical", Verdict::kOk, data::kFrame108, sizeof data::kFrame108, 50, 16909110U, 464367618U, data::kPayload108, sizeof data::kPayload108, 0, data::matches108, data::decode_as<wire::SetSettingsRequest>},
    {"set_settings_request_least", Verdict::kOk, data::kFrame109, sizeof data::kFrame109, 50, 16909110U, 464367618U, data::kPayload109, sizeof data::kPayload109, 0, data::matches109, data::decode_as<wire::SetSettingsRequest>},
    {"set_settings_request_greatest", Verdict::kOk, data::kFrame110, sizeof data::kFrame110, 50, 16909110U, 464367618U, data::kPayload110, sizeof data::kPayload110, 0, data::matches110, data::decode_as<wire::SetSettingsRequest>},
    {"set_settings_reply_typical", Verdict::kOk, data::kFrame111, sizeof data::kFrame111, 178, 16909238U, 464367618U, data::kPayload111, sizeof data::kPayload111, 0, data::matches111, data::decode_as<wire::SetSettingsReply>},
    {"set_settings_reply_least", Verdict::kOk, data::kFrame112, sizeof data::kFrame112, 178, 16909238U, 464367618U, data::kPayload112, sizeof data::kPayload112, 0, data::matches112, data::decode_as<wire::SetSettingsReply>},
    {"set_settings_reply_greatest", Verdict::kOk, data::kFrame113, sizeof data::kFrame113, 178, 16909238U, 464367618U, data::kPayload113, sizeof data::kPayload113, 0, data::matches113, data::decode_as<wire::SetSettingsReply>},
    {"get_led_correction_request_typical", Verdict::kOk, data::kFrame114, sizeof data::kFrame114, 51, 16909111U, 464367618U, nullptr, 0, 0, data::matches114, data::decode_as<wire::GetLedCorrectionRequest>},
    {"get_led_correction_reply_typical", Verdict::kOk, data::kFrame115, sizeof data::kFrame115, 179, 16909239U, 464367618U, data::kPayload115, sizeof data::kPayload115, 0, data::matches115, data::decode_as<wire::GetLedCorrectionReply>},
    {"get_led_correction_reply_least", Verdict::kOk, data::kFrame116, sizeof data::kFrame116, 179, 16909239U, 464367618U, data::kPayload116, sizeof data::kPayload116, 0, data::matches116, data::decode_as<wire::GetLedCorrectionReply>},
    {"get_led_correction_reply_greatest", Verdict::kOk, data::kFrame117, sizeof data::kFrame117, 179, 16909239U, 464367618U, data::kPayload117, sizeof data::kPayload117, 0, data::matches117, data::decode_as<wire::GetLedCorrectionReply>},
    {"set_led_correction_request_typical", Verdict::kOk, data::kFrame118, sizeof data::kFrame118, 52, 16909112U, 464367618U, data::kPayload118, sizeof data::kPayload118, 0, data::matches118, data::decode_as<wire::SetLedCorrectionRequest>},
    {"set_led_correction_request_least", Verdict::kOk, data::kFrame119, sizeof data::kFrame119, 52, 16909112U, 464367618U, data::kPayload119, sizeof data::kPayload119, 0, data::matches119, data::decode_as<wire::SetLedCorrectionRequest>},
    {"set_led_correction_request_greatest", Verdict::kOk, data::kFrame120, sizeof data::kFrame120, 52, 16909112U, 464367618U, data::kPayload120, sizeof data::kPayload120, 0, data::matches120, data::decode_as<wire::SetLedCorrectionRequest>},
    {"set_led_correction_reply_typical", Verdict::kOk, data::kFrame121, sizeof data::kFrame121, 180, 16909240U, 464367618U, data::kPayload121, sizeof data::kPayload121, 0, data::matches121, data::decode_as<wire::SetLedCorrectionReply>},
    {"set_led_correction_reply_least", Verdict::kOk, data::kFrame122, sizeof data::kFrame122, 180, 16909240U, 464367618U, data::kPayload122, sizeof data::kPayload122, 0, data::matches122, data::decode_as<wire::SetLedCorrectionReply>},
    {"set_led_correction_reply_greatest", Verdict::kOk, data::kFrame123, sizeof data::kFrame123, 180, 16909240U, 464367618U, data::kPayload123, sizeof data::kPayload123, 0, data::matches123, data::decode_as<wire::SetLedCorrectionReply>},
    {"rejected_typical", Verdict::kOk, data::kFrame124, sizeof data::kFrame124, 254, 16909314U, 464367618U, data::kPayload124, sizeof data::kPayload124, 0, data::matches124, data::decode_as<wire::Rejected>},
    {"rejected_least", Verdict::kOk, data::kFrame125, sizeof data::kFrame125, 254, 16909314U, 464367618U, data::kPayload125, sizeof data::kPayload125, 0, data::matches125, data::decode_as<wire::Rejected>},
    {"rejected_greatest", Verdict::kOk, data::kFrame126, sizeof data::kFrame126, 254, 16909314U, 464367618U, data::kPayload126, sizeof data::kPayload126, 0, data::matches126, data::decode_as<wire::Rejected>},
    {"failed_typical", Verdict::kOk, data::kFrame127, sizeof data::kFrame127, 255, 16909315U, 464367618U, data::kPayload127, sizeof data::kPayload127, 0, data::matches127, data::decode_as<wire::Failed>},
    {"failed_least", Verdict::kOk, data::kFrame128, sizeof data::kFrame128, 255, 16909315U, 464367618U, data::kPayload128, sizeof data::kPayload128, 0, data::matches128, data::decode_as<wire::Failed>},
    {"failed_greatest", Verdict::kOk, data::kFrame129, sizeof data::kFrame129, 255, 16909315U, 464367618U, data::kPayload129, sizeof data::kPayload129, 0, data::matches129, data::decode_as<wire::Failed>},
    {"booted_event_typical", Verdict::kOk, data::kFrame130, sizeof data::kFrame130, 64, 16909124U, 464367618U, data::kPayload130, sizeof data::kPayload130, 0, data::matches130, data::decode_as<wire::BootedEvent>},
    {"booted_event_least", Verdict::kOk, data::kFrame131, sizeof data::kFrame131, 64, 16909124U, 464367618U, data::kPayload131, sizeof data::kPayload131, 0, data::matches131, data::decode_as<wire::BootedEvent>},
    {"booted_event_greatest", Verdict::kOk, data::kFrame132, sizeof data::kFrame132, 64, 16909124U, 464367618U, data::kPayload132, sizeof data::kPayload132, 0, data::matches132, data::decode_as<wire::BootedEvent>},
    {"exposure_event_typical", Verdict::kOk, data::kFrame133, sizeof data::kFrame133, 65, 16909125U, 464367618U, data::kPayload133, sizeof data::kPayload133, 0, data::matches133, data::decode_as<wire::ExposureEvent>},
    {"exposure_event_least", Verdict::kOk, data::kFrame134, sizeof data::kFrame134, 65, 16909125U, 464367618U, data::kPayload134, sizeof data::kPayload134, 0, data::matches134, data::decode_as<wire::ExposureEvent>},
    {"exposure_event_greatest", Verdict::kOk, data::kFrame135, sizeof data::kFrame135, 65, 16909125U, 464367618U, data::kPayload135, sizeof data::kPayload135, 0, data::matches135, data::decode_as<wire::ExposureEvent>},
    {"sequence_event_typical", Verdict::kOk, data::kFrame136, sizeof data::kFrame136, 66, 16909126U, 464367618U, data::kPayload136, sizeof data::kPayload136, 0, data::matches136, data::decode_as<wire::SequenceEvent>},
    {"sequence_event_least", Verdict::kOk, data::kFrame137, sizeof data::kFrame137, 66, 16909126U, 464367618U, data::kPayload137, sizeof data::kPayload137, 0, data::matches137, data::decode_as<wire::SequenceEvent>},
    {"sequence_event_greatest", Verdict::kOk, data::kFrame138, sizeof data::kFrame138, 66, 16909126U, 464367618U, data::kPayload138, sizeof data::kPayload138, 0, data::matches138, data::decode_as<wire::SequenceEvent>},
    {"fault_event_typical", Verdict::kOk, data::kFrame139, sizeof data::kFrame139, 67, 16909127U, 464367618U, data::kPayload139, sizeof data::kPayload139, 0, data::matches139, data::decode_as<wire::FaultEvent>},
    {"fault_event_least", Verdict::kOk, data::kFrame140, sizeof data::kFrame140, 67, 16909127U, 464367618U, data::kPayload140, sizeof data::kPayload140, 0, data::matches140, data::decode_as<wire::FaultEvent>},
    {"fault_event_greatest", Verdict::kOk, data::kFrame141, sizeof data::kFrame141, 67, 16909127U, 464367618U, data::kPayload141, sizeof data::kPayload141, 0, data::matches141, data::decode_as<wire::FaultEvent>},
    {"cobs_zeros", Verdict::kOk, data::kFrame142, sizeof data::kFrame142, 17, 16909077U, 464367618U, data::kPayload142, sizeof data::kPayload142, 0, data::matches142, data::decode_as<wire::ApertureChunkRequest>},
    {"cobs_ones", Verdict::kOk, data::kFrame143, sizeof data::kFrame143, 17, 16909077U, 464367618U, data::kPayload143, sizeof data::kPayload143, 0, data::matches143, data::decode_as<wire::ApertureChunkRequest>},
    {"cobs_run_253", Verdict::kOk, data::kFrame144, sizeof data::kFrame144, 17, 16909077U, 464367618U, data::kPayload144, sizeof data::kPayload144, 0, data::matches144, data::decode_as<wire::ApertureChunkRequest>},
    {"cobs_run_254", Verdict::kOk, data::kFrame145, sizeof data::kFrame145, 17, 16909077U, 464367618U, data::kPayload145, sizeof data::kPayload145, 0, data::matches145, data::decode_as<wire::ApertureChunkRequest>},
    {"cobs_run_255", Verdict::kOk, data::kFrame146, sizeof data::kFrame146, 17, 16909077U, 464367618U, data::kPayload146, sizeof data::kPayload146, 0, data::matches146, data::decode_as<wire::ApertureChunkRequest>},
    {"hello_request_too_long", Verdict::kBadLength, data::kFrame147, sizeof data::kFrame147, 1, 16909061U, 464367618U, data::kPayload147, sizeof data::kPayload147, 0, nullptr, data::decode_as<wire::HelloRequest>},
    {"hello_reply_too_long", Verdict::kBadLength, data::kFrame148, sizeof data::kFrame148, 129, 16909189U, 464367618U, data::kPayload148, sizeof data::kPayload148, 0, nullptr, data::decode_as<wire::HelloReply>},
    {"hello_reply_too_short", Verdict::kBadLength, data::kFrame149, sizeof data::kFrame149, 129, 16909189U, 464367618U, data::kPayload149, sizeof data::kPayload149, 0, nullptr, data::decode_as<wire::HelloReply>},
    {"hello_reply_bad_firmware_version", Verdict::kOutOfRange, data::kFrame150, sizeof data::kFrame150, 129, 16909189U, 464367618U, data::kPayload150, sizeof data::kPayload150, 2, nullptr, data::decode_as<wire::HelloReply>},
    {"hello_reply_bad_firmware_version1", Verdict::kOutOfRange, data::kFrame151, sizeof data::kFrame151, 129, 16909189U, 464367618U, data::kPayload151, sizeof data::kPayload151, 2, nullptr, data::decode_as<wire::HelloReply>},
    {"hello_reply_bad_git_hash", Verdict::kOutOfRange, data::kFrame152, sizeof data::kFrame152, 129, 16909189U, 464367618U, data::kPayload152, sizeof data::kPayload152, 3, nullptr, data::decode_as<wire::HelloReply>},
    {"hello_reply_bad_git_hash1", Verdict::kOutOfRange, data::kFrame153, sizeof data::kFrame153, 129, 16909189U, 464367618U, data::kPayload153, sizeof data::kPayload153, 3, nullptr, data::decode_as<wire::HelloReply>},
    {"hello_reply_bad_board", Verdict::kOutOfRange, data::kFrame154, sizeof data::kFrame154, 129, 16909189U, 464367618U, data::kPayload154, sizeof data::kPayload154, 4, nullptr, data::decode_as<wire::HelloReply>},
    {"hello_reply_bad_board1", Verdict::kOutOfRange, data::kFrame155, sizeof data::kFrame155, 129, 16909189U, 464367618U, data::kPayload155, sizeof data::kPayload155, 4, nullptr, data::decode_as<wire::HelloReply>},
    {"hello_reply_bad_serial_number", Verdict::kOutOfRange, data::kFrame156, sizeof data::kFrame156, 129, 16909189U, 464367618U, data::kPayload156, sizeof data::kPayload156, 5, nullptr, data::decode_as<wire::HelloReply>},
    {"hello_reply_bad_serial_number1", Verdict::kOutOfRange, data::kFrame157, sizeof data::kFrame157, 129, 16909189U, 464367618U, data::kPayload157, sizeof data::kPayload157, 5, nullptr, data::decode_as<wire::HelloReply>},
    {"hello_reply_bad_reset_cause", Verdict::kOutOfRange, data::kFrame158, sizeof data::kFrame158, 129, 16909189U, 464367618U, data::kPayload158, sizeof data::kPayload158, 7, nullptr, data::decode_as<wire::HelloReply>},
    {"hello_reply_bad_boot_nonce", Verdict::kOutOfRange, data::kFrame159, sizeof data::kFrame159, 129, 16909189U, 464367618U, data::kPayload159, sizeof data::kPayload159, 8, nullptr, data::decode_as<wire::HelloReply>},
    {"enter_bootloader_request_too_long", Verdict::kBadLength, data::kFrame160, sizeof data::kFrame160, 2, 16909062U, 464367618U, data::kPayload160, sizeof data::kPayload160, 0, nullptr, data::decode_as<wire::EnterBootloaderRequest>},
    {"enter_bootloader_request_too_short", Verdict::kBadLength, data::kFrame161, sizeof data::kFrame161, 2, 16909062U, 464367618U, data::kPayload161, sizeof data::kPayload161, 0, nullptr, data::decode_as<wire::EnterBootloaderRequest>},
    {"enter_bootloader_reply_too_long", Verdict::kBadLength, data::kFrame162, sizeof data::kFrame162, 130, 16909190U, 464367618U, data::kPayload162, sizeof data::kPayload162, 0, nullptr, data::decode_as<wire::EnterBootloaderReply>},
    {"enter_bootloader_reply_too_short", Verdict::kBadLength, data::kFrame163, sizeof data::kFrame163, 130, 16909190U, 464367618U, data::kPayload163, sizeof data::kPayload163, 0, nullptr, data::decode_as<wire::EnterBootloaderReply>},
    {"status_request_too_long", Verdict::kBadLength, data::kFrame164, sizeof data::kFrame164, 3, 16909063U, 464367618U, data::kPayload164, sizeof data::kPayload164, 0, nullptr, data::decode_as<wire::StatusRequest>},
    {"status_reply_too_long", Verdict::kBadLength, data::kFrame165, sizeof data::kFrame165, 131, 16909191U, 464367618U, data::kPayload165, sizeof data::kPayload165, 0, nullptr, data::decode_as<wire::StatusReply>},
    {"status_reply_too_short", Verdict::kBadLength, data::kFrame166, sizeof data::kFrame166, 131, 16909191U, 464367618U, data::kPayload166, sizeof data::kPayload166, 0, nullptr, data::decode_as<wire::StatusReply>},
    {"status_reply_bad_sequence", Verdict::kOutOfRange, data::kFrame167, sizeof data::kFrame167, 131, 16909191U, 464367618U, data::kPayload167, sizeof data::kPayload167, 0, nullptr, data::decode_as<wire::StatusReply>},
    {"status_reply_bad_fault", Verdict::kOutOfRange, data::kFrame168, sizeof data::kFrame168, 131, 16909191U, 464367618U, data::kPayload168, sizeof data::kPayload168, 1, nullptr, data::decode_as<wire::StatusReply>},
    {"status_reply_bad_aperture", Verdict::kOutOfRange, data::kFrame169, sizeof data::kFrame169, 131, 16909191U, 464367618U, data::kPayload169, sizeof data::kPayload169, 2, nullptr, data::decode_as<wire::StatusReply>},
    {"status_reply_bad_light", Verdict::kOutOfRange, data::kFrame170, sizeof data::kFrame170, 131, 16909191U, 464367618U, data::kPayload170, sizeof data::kPayload170, 3, nullptr, data::decode_as<wire::StatusReply>},
    {"status_reply_bad_camera_ready", Verdict::kOutOfRange, data::kFrame171, sizeof data::kFrame171, 131, 16909191U, 464367618U, data::kPayload171, sizeof data::kPayload171, 4, nullptr, data::decode_as<wire::StatusReply>},
    {"limits_request_too_long", Verdict::kBadLength, data::kFrame172, sizeof data::kFrame172, 4, 16909064U, 464367618U, data::kPayload172, sizeof data::kPayload172, 0, nullptr, data::decode_as<wire::LimitsRequest>},
    {"limits_reply_too_long", Verdict::kBadLength, data::kFrame173, sizeof data::kFrame173, 132, 16909192U, 464367618U, data::kPayload173, sizeof data::kPayload173, 0, nullptr, data::decode_as<wire::LimitsReply>},
    {"limits_reply_too_short", Verdict::kBadLength, data::kFrame174, sizeof data::kFrame174, 132, 16909192U, 464367618U, data::kPayload174, sizeof data::kPayload174, 0, nullptr, data::decode_as<wire::LimitsReply>},
    {"limits_reply_bad_led_level_step", Verdict::kOutOfRange, data::kFrame175, sizeof data::kFrame175, 132, 16909192U, 464367618U, data::kPayload175, sizeof data::kPayload175, 3, nullptr, data::decode_as<wire::LimitsReply>},
    {"limits_reply_bad_led_level_step1", Verdict::kOutOfRange, data::kFrame176, sizeof data::kFrame176, 132, 16909192U, 464367618U, data::kPayload176, sizeof data::kPayload176, 3, nullptr, data::decode_as<wire::LimitsReply>},
    {"load_light_request_too_long", Verdict::kBadLength, data::kFrame177, sizeof data::kFrame177, 16, 16909076U, 464367618U, data::kPayload177, sizeof data::kPayload177, 0, nullptr, data::decode_as<wire::LoadLightRequest>},
    {"load_light_request_too_short", Verdict::kBadLength, data::kFrame178, sizeof data::kFrame178, 16, 16909076U, 464367618U, data::kPayload178, sizeof data::kPayload178, 0, nullptr, data::decode_as<wire::LoadLightRequest>},
    {"load_light_request_bad_slot", Verdict::kOutOfRange, data::kFrame179, sizeof data::kFrame179, 16, 16909076U, 464367618U, data::kPayload179, sizeof data::kPayload179, 0, nullptr, data::decode_as<wire::LoadLightRequest>},
    {"load_light_request_bad_levels", Verdict::kOutOfRange, data::kFrame180, sizeof data::kFrame180, 16, 16909076U, 464367618U, data::kPayload180, sizeof data::kPayload180, 1, nullptr, data::decode_as<wire::LoadLightRequest>},
    {"load_light_reply_too_long", Verdict::kBadLength, data::kFrame181, sizeof data::kFrame181, 144, 16909204U, 464367618U, data::kPayload181, sizeof data::kPayload181, 0, nullptr, data::decode_as<wire::LoadLightReply>},
    {"load_light_reply_too_short", Verdict::kBadLength, data::kFrame182, sizeof data::kFrame182, 144, 16909204U, 464367618U, data::kPayload182, sizeof data::kPayload182, 0, nullptr, data::decode_as<wire::LoadLightReply>},
    {"load_light_reply_bad_slot", Verdict::kOutOfRange, data::kFrame183, sizeof data::kFrame183, 144, 16909204U, 464367618U, data::kPayload183, sizeof data::kPayload183, 0, nullptr, data::decode_as<wire::LoadLightReply>},
    {"aperture_chunk_request_too_short", Verdict::kBadLength, data::kFrame184, sizeof data::kFrame184, 17, 16909077U, 464367618U, data::kPayload184, sizeof data::kPayload184, 0, nullptr, data::decode_as<wire::ApertureChunkRequest>},
    {"aperture_chunk_request_bad_slot", Verdict::kOutOfRange, data::kFrame185, sizeof data::kFrame185, 17, 16909077U, 464367618U, data::kPayload185, sizeof data::kPayload185, 0, nullptr, data::decode_as<wire::ApertureChunkRequest>},
    {"aperture_chunk_request_bad_chunk", Verdict::kOutOfRange, data::kFrame186, sizeof data::kFrame186, 17, 16909077U, 464367618U, data::kPayload186, sizeof data::kPayload186, 1, nullptr, data::decode_as<wire::ApertureChunkRequest>},
    {"aperture_chunk_reply_too_long", Verdict::kBadLength, data::kFrame187, sizeof data::kFrame187, 145, 16909205U, 464367618U, data::kPayload187, sizeof data::kPayload187, 0, nullptr, data::decode_as<wire::ApertureChunkReply>},
    {"aperture_chunk_reply_too_short", Verdict::kBadLength, data::kFrame188, sizeof data::kFrame188, 145, 16909205U, 464367618U, data::kPayload188, sizeof data::kPayload188, 0, nullptr, data::decode_as<wire::ApertureChunkReply>},
    {"aperture_chunk_reply_bad_slot", Verdict::kOutOfRange, data::kFrame189, sizeof data::kFrame189, 145, 16909205U, 464367618U, data::kPayload189, sizeof data::kPayload189, 0, nullptr, data::decode_as<wire::ApertureChunkReply>},
    {"aperture_chunk_reply_bad_chunk", Verdict::kOutOfRange, data::kFrame190, sizeof data::kFrame190, 145, 16909205U, 464367618U, data::kPayload190, sizeof data::kPayload190, 1, nullptr, data::decode_as<wire::ApertureChunkReply>},
    {"commit_aperture_request_too_long", Verdict::kBadLength, data::kFrame191, sizeof data::kFrame191, 18, 16909078U, 464367618U, data::kPayload191, sizeof data::kPayload191, 0, nullptr, data::decode_as<wire::CommitApertureRequest>},
    {"commit_aperture_request_too_short", Verdict::kBadLength, data::kFrame192, sizeof data::kFrame192, 18, 16909078U, 464367618U, data::kPayload192, sizeof data::kPayload192, 0, nullptr, data::decode_as<wire::CommitApertureRequest>},
    {"commit_aperture_request_bad_slot", Verdict::kOutOfRange, data::kFrame193, sizeof data::kFrame193, 18, 16909078U, 464367618U, data::kPayload193, sizeof data::kPayload193, 0, nullptr, data::decode_as<wire::CommitApertureRequest>},
    {"commit_aperture_reply_too_long", Verdict::kBadLength, data::kFrame194, sizeof data::kFrame194, 146, 16909206U, 464367618U, data::kPayload194, sizeof data::kPayload194, 0, nullptr, data::decode_as<wire::CommitApertureReply>},
    {"commit_aperture_reply_too_short", Verdict::kBadLength, data::kFrame195, sizeof data::kFrame195, 146, 16909206U, 464367618U, data::kPayload195, sizeof data::kPayload195, 0, nullptr, data::decode_as<wire::CommitApertureReply>},
    {"commit_aperture_reply_bad_slot", Verdict::kOutOfRange, data::kFrame196, sizeof data::kFrame196, 146, 16909206U, 464367618U, data::kPayload196, sizeof data::kPayload196, 0, nullptr, data::decode_as<wire::CommitApertureReply>},
    {"commit_aperture_reply_bad_open_pixels", Verdict::kOutOfRange, data::kFrame197, sizeof data::kFrame197, 146, 16909206U, 464367618U, data::kPayload197, sizeof data::kPayload197, 2, nullptr, data::decode_as<wire::CommitApertureReply>},
    {"select_aperture_request_too_long", Verdict::kBadLength, data::kFrame198, sizeof data::kFrame198, 19, 16909079U, 464367618U, data::kPayload198, sizeof data::kPayload198, 0, nullptr, data::decode_as<wire::SelectApertureRequest>},
    {"select_aperture_request_too_short", Verdict::kBadLength, data::kFrame199, sizeof data::kFrame199, 19, 16909079U, 464367618U, nullptr, 0, 0, nullptr, data::decode_as<wire::SelectApertureRequest>},
    {"select_aperture_request_bad_slot", Verdict::kOutOfRange, data::kFrame200, sizeof data::kFrame200, 19, 16909079U, 464367618U, data::kPayload200, sizeof data::kPayload200, 0, nullptr, data::decode_as<wire::SelectApertureRequest>},
    {"select_aperture_reply_too_long", Verdict::kBadLength, data::kFrame201, sizeof data::kFrame201, 147, 16909207U, 464367618U, data::kPayload201, sizeof data::kPayload201, 0, nullptr, data::decode_as<wire::SelectApertureReply>},
    {"select_aperture_reply_too_short", Verdict::kBadLength, data::kFrame202, sizeof data::kFrame202, 147, 16909207U, 464367618U, data::kPayload202, sizeof data::kPayload202, 0, nullptr, data::decode_as<wire::SelectApertureReply>},
    {"select_aperture_reply_bad_slot", Verdict::kOutOfRange, data::kFrame203, sizeof data::kFrame203, 147, 16909207U, 464367618U, data::kPayload203, sizeof data::kPayload203, 0, nullptr, data::decode_as<wire::SelectApertureReply>},
    {"select_light_request_too_long", Verdict::kBadLength, data::kFrame204, sizeof data::kFrame204, 20, 16909080U, 464367618U, data::kPayload204, sizeof data::kPayload204, 0, nullptr, data::decode_as<wire::SelectLightRequest>},
    {"select_light_request_too_short", Verdict::kBadLength, data::kFrame205, sizeof data::kFrame205, 20, 16909080U, 464367618U, nullptr, 0, 0, nullptr, data::decode_as<wire::SelectLightRequest>},
    {"select_light_request_bad_slot", Verdict::kOutOfRange, data::kFrame206, sizeof data::kFrame206, 20, 16909080U, 464367618U, data::kPayload206, sizeof data::kPayload206, 0, nullptr, data::decode_as<wire::SelectLightRequest>},
    {"select_light_reply_too_long", Verdict::kBadLength, data::kFrame207, sizeof data::kFrame207, 148, 16909208U, 464367618U, data::kPayload207, sizeof data::kPayload207, 0, nullptr, data::decode_as<wire::SelectLightReply>},
    {"select_light_reply_too_short", Verdict::kBadLength, data::kFrame208, sizeof data::kFrame208, 148, 16909208U, 464367618U, data::kPayload208, sizeof data::kPayload208, 0, nullptr, data::decode_as<wire::SelectLightReply>},
    {"select_light_reply_bad_slot", Verdict::kOutOfRange, data::kFrame209, sizeof data::kFrame209, 148, 16909208U, 464367618U, data::kPayload209, sizeof data::kPayload209, 0, nullptr, data::decode_as<wire::SelectLightReply>},
    {"all_off_request_too_long", Verdict::kBadLength, data::kFrame210, sizeof data::kFrame210, 21, 16909081U, 464367618U, data::kPayload210, sizeof data::kPayload210, 0, nullptr, data::decode_as<wire::AllOffRequest>},
    {"all_off_reply_too_long", Verdict::kBadLength, data::kFrame211, sizeof data::kFrame211, 149, 16909209U, 464367618U, data::kPayload211, sizeof data::kPayload211, 0, nullptr, data::decode_as<wire::AllOffReply>},
    {"all_off_reply_too_short", Verdict::kBadLength, data::kFrame212, sizeof data::kFrame212, 149, 16909209U, 464367618U, nullptr, 0, 0, nullptr, data::decode_as<wire::AllOffReply>},
    {"all_off_reply_bad_sequence", Verdict::kOutOfRange, data::kFrame213, sizeof data::kFrame213, 149, 16909209U, 464367618U, data::kPayload213, sizeof data::kPayload213, 0, nullptr, data::decode_as<wire::AllOffReply>},
    {"step_chunk_request_too_long", Verdict::kBadLength, data::kFrame214, sizeof data::kFrame214, 32, 16909092U, 464367618U, data::kPayload214, sizeof data::kPayload214, 0, nullptr, data::decode_as<wire::StepChunkRequest>},
    {"step_chunk_request_too_short", Verdict::kBadLength, data::kFrame215, sizeof data::kFrame215, 32, 16909092U, 464367618U, data::kPayload215, sizeof data::kPayload215, 0, nullptr, data::decode_as<wire::StepChunkRequest>},
    {"step_chunk_request_bad_first", Verdict::kOutOfRange, data::kFrame216, sizeof data::kFrame216, 32, 16909092U, 464367618U, data::kPayload216, sizeof data::kPayload216, 0, nullptr, data::decode_as<wire::StepChunkRequest>},
    {"step_chunk_request_bad_steps", Verdict::kOutOfRange, data::kFrame217, sizeof data::kFrame217, 32, 16909092U, 464367618U, data::kPayload217, sizeof data::kPayload217, 1, nullptr, data::decode_as<wire::StepChunkRequest>},
    {"step_chunk_request_bad_steps1", Verdict::kOutOfRange, data::kFrame218, sizeof data::kFrame218, 32, 16909092U, 464367618U, data::kPayload218, sizeof data::kPayload218, 1, nullptr, data::decode_as<wire::StepChunkRequest>},
    {"step_chunk_request_bad_steps2", Verdict::kOutOfRange, data::kFrame219, sizeof data::kFrame219, 32, 16909092U, 464367618U, data::kPayload219, sizeof data::kPayload219, 1, nullptr, data::decode_as<wire::StepChunkRequest>},
    {"step_chunk_request_bad_steps3", Verdict::kOutOfRange, data::kFrame220, sizeof data::kFrame220, 32, 16909092U, 464367618U, data::kPayload220, sizeof data::kPayload220, 1, nullptr, data::decode_as<wire::StepChunkRequest>},
    {"step_chunk_request_bad_steps4", Verdict::kOutOfRange, data::kFrame221, sizeof data::kFrame221, 32, 16909092U, 464367618U, data::kPayload221, sizeof data::kPayload221, 1, nullptr, data::decode_as<wire::StepChunkRequest>},
    {"step_chunk_request_bad_steps5", Verdict::kOutOfRange, data::kFrame222, sizeof data::kFrame222, 32, 16909092U, 464367618U, data::kPayload222, sizeof data::kPayload222, 1, nullptr, data::decode_as<wire::StepChunkRequest>},
    {"step_chunk_reply_too_long", Verdict::kBadLength, data::kFrame223, sizeof data::kFrame223, 160, 16909220U, 464367618U, data::kPayload223, sizeof data::kPayload223, 0, nullptr, data::decode_as<wire::StepChunkReply>},
    {"step_chunk_reply_too_short", Verdict::kBadLength, data::kFrame224, sizeof data::kFrame224, 160, 16909220U, 464367618U, data::kPayload224, sizeof data::kPayload224, 0, nullptr, data::decode_as<wire::StepChunkReply>},
    {"step_chunk_reply_bad_first", Verdict::kOutOfRange, data::kFrame225, sizeof data::kFrame225, 160, 16909220U, 464367618U, data::kPayload225, sizeof data::kPayload225, 0, nullptr, data::decode_as<wire::StepChunkReply>},
    {"step_chunk_reply_bad_count", Verdict::kOutOfRange, data::kFrame226, sizeof data::kFrame226, 160, 16909220U, 464367618U, data::kPayload226, sizeof data::kPayload226, 1, nullptr, data::decode_as<wire::StepChunkReply>},
    {"commit_steps_request_too_long", Verdict::kBadLength, data::kFrame227, sizeof data::kFrame227, 33, 16909093U, 464367618U, data::kPayload227, sizeof data::kPayload227, 0, nullptr, data::decode_as<wire::CommitStepsRequest>},
    {"commit_steps_request_too_short", Verdict::kBadLength, data::kFrame228, sizeof data::kFrame228, 33, 16909093U, 464367618U, data::kPayload228, sizeof data::kPayload228, 0, nullptr, data::decode_as<wire::CommitStepsRequest>},
    {"commit_steps_request_bad_count", Verdict::kOutOfRange, data::kFrame229, sizeof data::kFrame229, 33, 16909093U, 464367618U, data::kPayload229, sizeof data::kPayload229, 0, nullptr, data::decode_as<wire::CommitStepsRequest>},
    {"commit_steps_request_bad_count1", Verdict::kOutOfRange, data::kFrame230, sizeof data::kFrame230, 33, 16909093U, 464367618U, data::kPayload230, sizeof data::kPayload230, 0, nullptr, data::decode_as<wire::CommitStepsRequest>},
    {"commit_steps_reply_too_long", Verdict::kBadLength, data::kFrame231, sizeof data::kFrame231, 161, 16909221U, 464367618U, data::kPayload231, sizeof data::kPayload231, 0, nullptr, data::decode_as<wire::CommitStepsReply>},
    {"commit_steps_reply_too_short", Verdict::kBadLength, data::kFrame232, sizeof data::kFrame232, 161, 16909221U, 464367618U, data::kPayload232, sizeof data::kPayload232, 0, nullptr, data::decode_as<wire::CommitStepsReply>},
    {"commit_steps_reply_bad_count", Verdict::kOutOfRange, data::kFrame233, sizeof data::kFrame233, 161, 16909221U, 464367618U, data::kPayload233, sizeof data::kPayload233, 0, nullptr, data::decode_as<wire::CommitStepsReply>},
    {"commit_steps_reply_bad_count1", Verdict::kOutOfRange, data::kFrame234, sizeof data::kFrame234, 161, 16909221U, 464367618U, data::kPayload234, sizeof data::kPayload234, 0, nullptr, data::decode_as<wire::CommitStepsReply>},
    {"start_request_too_long", Verdict::kBadLength, data::kFrame235, sizeof data::kFrame235, 34, 16909094U, 464367618U, data::kPayload235, sizeof data::kPayload235, 0, nullptr, data::decode_as<wire::StartRequest>},
    {"start_request_too_short", Verdict::kBadLength, data::kFrame236, sizeof data::kFrame236, 34, 16909094U, 464367618U, data::kPayload236, sizeof data::kPayload236, 0, nullptr, data::decode_as<wire::StartRequest>},
    {"start_request_bad_run_id", Verdict::kOutOfRange, data::kFrame237, sizeof data::kFrame237, 34, 16909094U, 464367618U, data::kPayload237, sizeof data::kPayload237, 0, nullptr, data::decode_as<wire::StartRequest>},
    {"start_request_bad_deadline_ms", Verdict::kOutOfRange, data::kFrame238, sizeof data::kFrame238, 34, 16909094U, 464367618U, data::kPayload238, sizeof data::kPayload238, 2, nullptr, data::decode_as<wire::StartRequest>},
    {"start_request_bad_light_lead_us", Verdict::kOutOfRange, data::kFrame239, sizeof data::kFrame239, 34, 16909094U, 464367618U, data::kPayload239, sizeof data::kPayload239, 3, nullptr, data::decode_as<wire::StartRequest>},
    {"start_request_bad_trigger_us", Verdict::kOutOfRange, data::kFrame240, sizeof data::kFrame240, 34, 16909094U, 464367618U, data::kPayload240, sizeof data::kPayload240, 4, nullptr, data::decode_as<wire::StartRequest>},
    {"start_request_bad_trigger_us1", Verdict::kOutOfRange, data::kFrame241, sizeof data::kFrame241, 34, 16909094U, 464367618U, data::kPayload241, sizeof data::kPayload241, 4, nullptr, data::decode_as<wire::StartRequest>},
    {"start_request_bad_gap_us", Verdict::kOutOfRange, data::kFrame242, sizeof data::kFrame242, 34, 16909094U, 464367618U, data::kPayload242, sizeof data::kPayload242, 5, nullptr, data::decode_as<wire::StartRequest>},
    {"start_request_bad_require_strobe", Verdict::kOutOfRange, data::kFrame243, sizeof data::kFrame243, 34, 16909094U, 464367618U, data::kPayload243, sizeof data::kPayload243, 7, nullptr, data::decode_as<wire::StartRequest>},
    {"start_reply_too_long", Verdict::kBadLength, data::kFrame244, sizeof data::kFrame244, 162, 16909222U, 464367618U, data::kPayload244, sizeof data::kPayload244, 0, nullptr, data::decode_as<wire::StartReply>},
    {"start_reply_too_short", Verdict::kBadLength, data::kFrame245, sizeof data::kFrame245, 162, 16909222U, 464367618U, data::kPayload245, sizeof data::kPayload245, 0, nullptr, data::decode_as<wire::StartReply>},
    {"start_reply_bad_run_id", Verdict::kOutOfRange, data::kFrame246, sizeof data::kFrame246, 162, 16909222U, 464367618U, data::kPayload246, sizeof data::kPayload246, 0, nullptr, data::decode_as<wire::StartReply>},
    {"pause_request_too_long", Verdict::kBadLength, data::kFrame247, sizeof data::kFrame247, 35, 16909095U, 464367618U, data::kPayload247, sizeof data::kPayload247, 0, nullptr, data::decode_as<wire::PauseRequest>},
    {"pause_request_too_short", Verdict::kBadLength, data::kFrame248, sizeof data::kFrame248, 35, 16909095U, 464367618U, data::kPayload248, sizeof data::kPayload248, 0, nullptr, data::decode_as<wire::PauseRequest>},
    {"pause_request_bad_run_id", Verdict::kOutOfRange, data::kFrame249, sizeof data::kFrame249, 35, 16909095U, 464367618U, data::kPayload249, sizeof data::kPayload249, 0, nullptr, data::decode_as<wire::PauseRequest>},
    {"pause_reply_too_long", Verdict::kBadLength, data::kFrame250, sizeof data::kFrame250, 163, 16909223U, 464367618U, data::kPayload250, sizeof data::kPayload250, 0, nullptr, data::decode_as<wire::PauseReply>},
    {"pause_reply_too_short", Verdict::kBadLength, data::kFrame251, sizeof data::kFrame251, 163, 16909223U, 464367618U, data::kPayload251, sizeof data::kPayload251, 0, nullptr, data::decode_as<wire::PauseReply>},
    {"pause_reply_bad_sequence", Verdict::kOutOfRange, data::kFrame252, sizeof data::kFrame252, 163, 16909223U, 464367618U, data::kPayload252, sizeof data::kPayload252, 0, nullptr, data::decode_as<wire::PauseReply>},
    {"resume_request_too_long", Verdict::kBadLength, data::kFrame253, sizeof data::kFrame253, 36, 16909096U, 464367618U, data::kPayload253, sizeof data::kPayload253, 0, nullptr, data::decode_as<wire::ResumeRequest>},
    {"resume_request_too_short", Verdict::kBadLength, data::kFrame254, sizeof data::kFrame254, 36, 16909096U, 464367618U, data::kPayload254, sizeof data::kPayload254, 0, nullptr, data::decode_as<wire::ResumeRequest>},
    {"resume_request_bad_run_id", Verdict::kOutOfRange, data::kFrame255, sizeof data::kFrame255, 36, 16909096U, 464367618U, data::kPayload255, sizeof data::kPayload255, 0, nullptr, data::decode_as<wire::ResumeRequest>},
    {"resume_reply_too_long", Verdict::kBadLength, data::kFrame256, sizeof data::kFrame256, 164, 16909224U, 464367618U, data::kPayload256, sizeof data::kPayload256, 0, nullptr, data::decode_as<wire::ResumeReply>},
    {"resume_reply_too_short", Verdict::kBadLength, data::kFrame257, sizeof data::kFrame257, 164, 16909224U, 464367618U, data::kPayload257, sizeof data::kPayload257, 0, nullptr, data::decode_as<wire::ResumeReply>},
    {"resume_reply_bad_sequence", Verdict::kOutOfRange, data::kFrame258, sizeof data::kFrame258, 164, 16909224U, 464367618U, data::kPayload258, sizeof data::kPayload258, 0, nullptr, data::decode_as<wire::ResumeReply>},
    {"abort_request_too_long", Verdict::kBadLength, data::kFrame259, sizeof data::kFrame259, 37, 16909097U, 464367618U, data::kPayload259, sizeof data::kPayload259, 0, nullptr, data::decode_as<wire::AbortRequest>},
    {"abort_request_too_short", Verdict::kBadLength, data::kFrame260, sizeof data::kFrame260, 37, 16909097U, 464367618U, data::kPayload260, sizeof data::kPayload260, 0, nullptr, data::decode_as<wire::AbortRequest>},
    {"abort_reply_too_long", Verdict::kBadLength, data::kFrame261, sizeof data::kFrame261, 165, 16909225U, 464367618U, data::kPayload261, sizeof data::kPayload261, 0, nullptr, data::decode_as<wire::AbortReply>},
    {"abort_reply_too_short", Verdict::kBadLength, data::kFrame262, sizeof data::kFrame262, 165, 16909225U, 464367618U, data::kPayload262, sizeof data::kPayload262, 0, nullptr, data::decode_as<wire::AbortReply>},
    {"abort_reply_bad_sequence", Verdict::kOutOfRange, data::kFrame263, sizeof data::kFrame263, 165, 16909225U, 464367618U, data::kPayload263, sizeof data::kPayload263, 0, nullptr, data::decode_as<wire::AbortReply>},
    {"clear_fault_request_too_long", Verdict::kBadLength, data::kFrame264, sizeof data::kFrame264, 38, 16909098U, 464367618U, data::kPayload264, sizeof data::kPayload264, 0, nullptr, data::decode_as<wire::ClearFaultRequest>},
    {"clear_fault_request_too_short", Verdict::kBadLength, data::kFrame265, sizeof data::kFrame265, 38, 16909098U, 464367618U, nullptr, 0, 0, nullptr, data::decode_as<wire::ClearFaultRequest>},
    {"clear_fault_request_bad_reason", Verdict::kOutOfRange, data::kFrame266, sizeof data::kFrame266, 38, 16909098U, 464367618U, data::kPayload266, sizeof data::kPayload266, 0, nullptr, data::decode_as<wire::ClearFaultRequest>},
    {"clear_fault_reply_too_long", Verdict::kBadLength, data::kFrame267, sizeof data::kFrame267, 166, 16909226U, 464367618U, data::kPayload267, sizeof data::kPayload267, 0, nullptr, data::decode_as<wire::ClearFaultReply>},
    {"clear_fault_reply_too_short", Verdict::kBadLength, data::kFrame268, sizeof data::kFrame268, 166, 16909226U, 464367618U, nullptr, 0, 0, nullptr, data::decode_as<wire::ClearFaultReply>},
    {"clear_fault_reply_bad_fault", Verdict::kOutOfRange, data::kFrame269, sizeof data::kFrame269, 166, 16909226U, 464367618U, data::kPayload269, sizeof data::kPayload269, 0, nullptr, data::decode_as<wire::ClearFaultReply>},
    {"acknowledge_events_request_too_long", Verdict::kBadLength, data::kFrame270, sizeof data::kFrame270, 39, 16909099U, 464367618U, data::kPayload270, sizeof data::kPayload270, 0, nullptr, data::decode_as<wire::AcknowledgeEventsRequest>},
    {"acknowledge_events_request_too_short", Verdict::kBadLength, data::kFrame271, sizeof data::kFrame271, 39, 16909099U, 464367618U, data::kPayload271, sizeof data::kPayload271, 0, nullptr, data::decode_as<wire::AcknowledgeEventsRequest>},
    {"acknowledge_events_request_bad_resend", Verdict::kOutOfRange, data::kFrame272, sizeof data::kFrame272, 39, 16909099U, 464367618U, data::kPayload272, sizeof data::kPayload272, 1, nullptr, data::decode_as<wire::AcknowledgeEventsRequest>},
    {"acknowledge_events_reply_too_long", Verdict::kBadLength, data::kFrame273, sizeof data::kFrame273, 167, 16909227U, 464367618U, data::kPayload273, sizeof data::kPayload273, 0, nullptr, data::decode_as<wire::AcknowledgeEventsReply>},
    {"acknowledge_events_reply_too_short", Verdict::kBadLength, data::kFrame274, sizeof data::kFrame274, 167, 16909227U, 464367618U, data::kPayload274, sizeof data::kPayload274, 0, nullptr, data::decode_as<wire::AcknowledgeEventsReply>},
    {"counters_request_too_long", Verdict::kBadLength, data::kFrame275, sizeof data::kFrame275, 48, 16909108U, 464367618U, data::kPayload275, sizeof data::kPayload275, 0, nullptr, data::decode_as<wire::CountersRequest>},
    {"counters_reply_too_long", Verdict::kBadLength, data::kFrame276, sizeof data::kFrame276, 176, 16909236U, 464367618U, data::kPayload276, sizeof data::kPayload276, 0, nullptr, data::decode_as<wire::CountersReply>},
    {"counters_reply_too_short", Verdict::kBadLength, data::kFrame277, sizeof data::kFrame277, 176, 16909236U, 464367618U, data::kPayload277, sizeof data::kPayload277, 0, nullptr, data::decode_as<wire::CountersReply>},
    {"get_settings_request_too_long", Verdict::kBadLength, data::kFrame278, sizeof data::kFrame278, 49, 16909109U, 464367618U, data::kPayload278, sizeof data::kPayload278, 0, nullptr, data::decode_as<wire::GetSettingsRequest>},
    {"get_settings_reply_too_long", Verdict::kBadLength, data::kFrame279, sizeof data::kFrame279, 177, 16909237U, 464367618U, data::kPayload279, sizeof data::kPayload279, 0, nullptr, data::decode_as<wire::GetSettingsReply>},
    {"get_settings_reply_too_short", Verdict::kBadLength, data::kFrame280, sizeof data::kFrame280, 177, 16909237U, 464367618U, data::kPayload280, sizeof data::kPayload280, 0, nullptr, data::decode_as<wire::GetSettingsReply>},
    {"get_settings_reply_bad_serial_number", Verdict::kOutOfRange, data::kFrame281, sizeof data::kFrame281, 177, 16909237U, 464367618U, data::kPayload281, sizeof data::kPayload281, 0, nullptr, data::decode_as<wire::GetSettingsReply>},
    {"get_settings_reply_bad_serial_number1", Verdict::kOutOfRange, data::kFrame282, sizeof data::kFrame282, 177, 16909237U, 464367618U, data::kPayload282, sizeof data::kPayload282, 0, nullptr, data::decode_as<wire::GetSettingsReply>},
    {"get_settings_reply_bad_glass_variant", Verdict::kOutOfRange, data::kFrame283, sizeof data::kFrame283, 177, 16909237U, 464367618U, data::kPayload283, sizeof data::kPayload283, 1, nullptr, data::decode_as<wire::GetSettingsReply>},
    {"get_settings_reply_bad_mounting", Verdict::kOutOfRange, data::kFrame284, sizeof data::kFrame284, 177, 16909237U, 464367618U, data::kPayload284, sizeof data::kPayload284, 2, nullptr, data::decode_as<wire::GetSettingsReply>},
    {"get_settings_reply_bad_contrast", Verdict::kOutOfRange, data::kFrame285, sizeof data::kFrame285, 177, 16909237U, 464367618U, data::kPayload285, sizeof data::kPayload285, 3, nullptr, data::decode_as<wire::GetSettingsReply>},
    {"get_settings_reply_bad_resistor_ratio", Verdict::kOutOfRange, data::kFrame286, sizeof data::kFrame286, 177, 16909237U, 464367618U, data::kPayload286, sizeof data::kPayload286, 4, nullptr, data::decode_as<wire::GetSettingsReply>},
    {"set_settings_request_too_long", Verdict::kBadLength, data::kFrame287, sizeof data::kFrame287, 50, 16909110U, 464367618U, data::kPayload287, sizeof data::kPayload287, 0, nullptr, data::decode_as<wire::SetSettingsRequest>},
    {"set_settings_request_too_short", Verdict::kBadLength, data::kFrame288, sizeof data::kFrame288, 50, 16909110U, 464367618U, data::kPayload288, sizeof data::kPayload288, 0, nullptr, data::decode_as<wire::SetSettingsRequest>},
    {"set_settings_request_bad_serial_number", Verdict::kOutOfRange, data::kFrame289, sizeof data::kFrame289, 50, 16909110U, 464367618U, data::kPayload289, sizeof data::kPayload289, 0, nullptr, data::decode_as<wire::SetSettingsRequest>},
    {"set_settings_request_bad_serial_number1", Verdict::kOutOfRange, data::kFrame290, sizeof data::kFrame290, 50, 16909110U, 464367618U, data::kPayload290, sizeof data::kPayload290, 0, nullptr, data::decode_as<wire::SetSettingsRequest>},
    {"set_settings_request_bad_glass_variant", Verdict::kOutOfRange, data::kFrame291, sizeof data::kFrame291, 50, 16909110U, 464367618U, data::kPayload291, sizeof data::kPayload291, 1, nullptr, data::decode_as<wire::SetSettingsRequest>},
    {"set_settings_request_bad_mounting", Verdict::kOutOfRange, data::kFrame292, sizeof data::kFrame292, 50, 16909110U, 464367618U, data::kPayload292, sizeof data::kPayload292, 2, nullptr, data::decode_as<wire::SetSettingsRequest>},
    {"set_settings_request_bad_contrast", Verdict::kOutOfRange, data::kFrame293, sizeof data::kFrame293, 50, 16909110U, 464367618U, data::kPayload293, sizeof data::kPayload293, 3, nullptr, data::decode_as<wire::SetSettingsRequest>},
    {"set_settings_request_bad_resistor_ratio", Verdict::kOutOfRange, data::kFrame294, sizeof data::kFrame294, 50, 16909110U, 464367618U, data::kPayload294, sizeof data::kPayload294, 4, nullptr, data::decode_as<wire::SetSettingsRequest>},
    {"set_settings_reply_too_long", Verdict::kBadLength, data::kFrame295, sizeof data::kFrame295, 178, 16909238U, 464367618U, data::kPayload295, sizeof data::kPayload295, 0, nullptr, data::decode_as<wire::SetSettingsReply>},
    {"set_settings_reply_too_short", Verdict::kBadLength, data::kFrame296, sizeof data::kFrame296, 178, 16909238U, 464367618U, data::kPayload296, sizeof data::kPayload296, 0, nullptr, data::decode_as<wire::SetSettingsReply>},
    {"set_settings_reply_bad_serial_number", Verdict::kOutOfRange, data::kFrame297, sizeof data::kFrame297, 178, 16909238U, 464367618U, data::kPayload297, sizeof data::kPayload297, 0, nullptr, data::decode_as<wire::SetSettingsReply>},
    {"set_settings_reply_bad_serial_number1", Verdict::kOutOfRange, data::kFrame298, sizeof data::kFrame298, 178, 16909238U, 464367618U, data::kPayload298, sizeof data::kPayload298, 0, nullptr, data::decode_as<wire::SetSettingsReply>},
    {"set_settings_reply_bad_glass_variant", Verdict::kOutOfRange, data::kFrame299, sizeof data::kFrame299, 178, 16909238U, 464367618U, data::kPayload299, sizeof data::kPayload299, 1, nullptr, data::decode_as<wire::SetSettingsReply>},
    {"set_settings_reply_bad_mounting", Verdict::kOutOfRange, data::kFrame300, sizeof data::kFrame300, 178, 16909238U, 464367618U, data::kPayload300, sizeof data::kPayload300, 2, nullptr, data::decode_as<wire::SetSettingsReply>},
    {"set_settings_reply_bad_contrast", Verdict::kOutOfRange, data::kFrame301, sizeof data::kFrame301, 178, 16909238U, 464367618U, data::kPayload301, sizeof data::kPayload301, 3, nullptr, data::decode_as<wire::SetSettingsReply>},
    {"set_settings_reply_bad_resistor_ratio", Verdict::kOutOfRange, data::kFrame302, sizeof data::kFrame302, 178, 16909238U, 464367618U, data::kPayload302, sizeof data::kPayload302, 4, nullptr, data::decode_as<wire::SetSettingsReply>},
    {"get_led_correction_request_too_long", Verdict::kBadLength, data::kFrame303, sizeof data::kFrame303, 51, 16909111U, 464367618U, data::kPayload303, sizeof data::kPayload303, 0, nullptr, data::decode_as<wire::GetLedCorrectionRequest>},
    {"get_led_correction_reply_too_long", Verdict::kBadLength, data::kFrame304, sizeof data::kFrame304, 179, 16909239U, 464367618U, data::kPayload304, sizeof data::kPayload304, 0, nullptr, data::decode_as<wire::GetLedCorrectionReply>},
    {"get_led_correction_reply_too_short", Verdict::kBadLength, data::kFrame305, sizeof data::kFrame305, 179, 16909239U, 464367618U, data::kPayload305, sizeof data::kPayload305, 0, nullptr, data::decode_as<wire::GetLedCorrectionReply>},
    {"set_led_correction_request_too_long", Verdict::kBadLength, data::kFrame306, sizeof data::kFrame306, 52, 16909112U, 464367618U, data::kPayload306, sizeof data::kPayload306, 0, nullptr, data::decode_as<wire::SetLedCorrectionRequest>},
    {"set_led_correction_request_too_short", Verdict::kBadLength, data::kFrame307, sizeof data::kFrame307, 52, 16909112U, 464367618U, data::kPayload307, sizeof data::kPayload307, 0, nullptr, data::decode_as<wire::SetLedCorrectionRequest>},
    {"set_led_correction_reply_too_long", Verdict::kBadLength, data::kFrame308, sizeof data::kFrame308, 180, 16909240U, 464367618U, data::kPayload308, sizeof data::kPayload308, 0, nullptr, data::decode_as<wire::SetLedCorrectionReply>},
    {"set_led_correction_reply_too_short", Verdict::kBadLength, data::kFrame309, sizeof data::kFrame309, 180, 16909240U, 464367618U, data::kPayload309, sizeof data::kPayload309, 0, nullptr, data::decode_as<wire::SetLedCorrectionReply>},
    {"rejected_too_long", Verdict::kBadLength, data::kFrame310, sizeof data::kFrame310, 254, 16909314U, 464367618U, data::kPayload310, sizeof data::kPayload310, 0, nullptr, data::decode_as<wire::Rejected>},
    {"rejected_too_short", Verdict::kBadLength, data::kFrame311, sizeof data::kFrame311, 254, 16909314U, 464367618U, data::kPayload311, sizeof data::kPayload311, 0, nullptr, data::decode_as<wire::Rejected>},
    {"rejected_bad_code", Verdict::kOutOfRange, data::kFrame312, sizeof data::kFrame312, 254, 16909314U, 464367618U, data::kPayload312, sizeof data::kPayload312, 0, nullptr, data::decode_as<wire::Rejected>},
    {"failed_too_long", Verdict::kBadLength, data::kFrame313, sizeof data::kFrame313, 255, 16909315U, 464367618U, data::kPayload313, sizeof data::kPayload313, 0, nullptr, data::decode_as<wire::Failed>},
    {"failed_too_short", Verdict::kBadLength, data::kFrame314, sizeof data::kFrame314, 255, 16909315U, 464367618U, data::kPayload314, sizeof data::kPayload314, 0, nullptr, data::decode_as<wire::Failed>},
    {"failed_bad_code", Verdict::kOutOfRange, data::kFrame315, sizeof data::kFrame315, 255, 16909315U, 464367618U, data::kPayload315, sizeof data::kPayload315, 0, nullptr, data::decode_as<wire::Failed>},
    {"booted_event_too_long", Verdict::kBadLength, data::kFrame316, sizeof data::kFrame316, 64, 16909124U, 464367618U, data::kPayload316, sizeof data::kPayload316, 0, nullptr, data::decode_as<wire::BootedEvent>},
    {"booted_event_too_short", Verdict::kBadLength, data::kFrame317, sizeof data::kFrame317, 64, 16909124U, 464367618U, nullptr, 0, 0, nullptr, data::decode_as<wire::BootedEvent>},
    {"booted_event_bad_reset_cause", Verdict::kOutOfRange, data::kFrame318, sizeof data::kFrame318, 64, 16909124U, 464367618U, data::kPayload318, sizeof data::kPayload318, 0, nullptr, data::decode_as<wire::BootedEvent>},
    {"exposure_event_too_long", Verdict::kBadLength, data::kFrame319, sizeof data::kFrame319, 65, 16909125U, 464367618U, data::kPayload319, sizeof data::kPayload319, 0, nullptr, data::decode_as<wire::ExposureEvent>},
    {"exposure_event_too_short", Verdict::kBadLength, data::kFrame320, sizeof data::kFrame320, 65, 16909125U, 464367618U, data::kPayload320, sizeof data::kPayload320, 0, nullptr, data::decode_as<wire::ExposureEvent>},
    {"exposure_event_bad_step", Verdict::kOutOfRange, data::kFrame321, sizeof data::kFrame321, 65, 16909125U, 464367618U, data::kPayload321, sizeof data::kPayload321, 3, nullptr, data::decode_as<wire::ExposureEvent>},
    {"exposure_event_bad_aperture", Verdict::kOutOfRange, data::kFrame322, sizeof data::kFrame322, 65, 16909125U, 464367618U, data::kPayload322, sizeof data::kPayload322, 5, nullptr, data::decode_as<wire::ExposureEvent>},
    {"exposure_event_bad_light", Verdict::kOutOfRange, data::kFrame323, sizeof data::kFrame323, 65, 16909125U, 464367618U, data::kPayload323, sizeof data::kPayload323, 6, nullptr, data::decode_as<wire::ExposureEvent>},
    {"sequence_event_too_long", Verdict::kBadLength, data::kFrame324, sizeof data::kFrame324, 66, 16909126U, 464367618U, data::kPayload324, sizeof data::kPayload324, 0, nullptr, data::decode_as<wire::SequenceEvent>},
    {"sequence_event_too_short", Verdict::kBadLength, data::kFrame325, sizeof data::kFrame325, 66, 16909126U, 464367618U, data::kPayload325, sizeof data::kPayload325, 0, nullptr, data::decode_as<wire::SequenceEvent>},
    {"sequence_event_bad_news", Verdict::kOutOfRange, data::kFrame326, sizeof data::kFrame326, 66, 16909126U, 464367618U, data::kPayload326, sizeof data::kPayload326, 0, nullptr, data::decode_as<wire::SequenceEvent>},
    {"fault_event_too_long", Verdict::kBadLength, data::kFrame327, sizeof data::kFrame327, 67, 16909127U, 464367618U, data::kPayload327, sizeof data::kPayload327, 0, nullptr, data::decode_as<wire::FaultEvent>},
    {"fault_event_too_short", Verdict::kBadLength, data::kFrame328, sizeof data::kFrame328, 67, 16909127U, 464367618U, data::kPayload328, sizeof data::kPayload328, 0, nullptr, data::decode_as<wire::FaultEvent>},
    {"fault_event_bad_reason", Verdict::kOutOfRange, data::kFrame329, sizeof data::kFrame329, 67, 16909127U, 464367618U, data::kPayload329, sizeof data::kPayload329, 0, nullptr, data::decode_as<wire::FaultEvent>},
    {"empty", Verdict::kEmpty, data::kFrame330, sizeof data::kFrame330, 0, 0U, 0U, nullptr, 0, 0, nullptr, nullptr},
    {"crc_flipped", Verdict::kCrc, data::kFrame331, sizeof data::kFrame331, 0, 0U, 0U, nullptr, 0, 0, nullptr, nullptr},
    {"payload_flipped", Verdict::kCrc, data::kFrame332, sizeof data::kFrame332, 0, 0U, 0U, nullptr, 0, 0, nullptr, nullptr},
    {"truncated", Verdict::kCrc, data::kFrame333, sizeof data::kFrame333, 0, 0U, 0U, nullptr, 0, 0, nullptr, nullptr},
    {"truncated_to_less_than_a_frame", Verdict::kFraming, data::kFrame334, sizeof data::kFrame334, 0, 0U, 0U, nullptr, 0, 0, nullptr, nullptr},
    {"too_short", Verdict::kFraming, data::kFrame335, sizeof data::kFrame335, 0, 0U, 0U, nullptr, 0, 0, nullptr, nullptr},
    {"one_byte", Verdict::kFraming, data::kFrame336, sizeof data::kFrame336, 0, 0U, 0U, nullptr, 0, 0, nullptr, nullptr},
    {"length_above", Verdict::kFraming, data::kFrame337, sizeof data::kFrame337, 0, 0U, 0U, nullptr, 0, 0, nullptr, nullptr},
    {"length_below", Verdict::kFraming, data::kFrame338, sizeof data::kFrame338, 0, 0U, 0U, nullptr, 0, 0, nullptr, nullptr},
    {"cobs_beyond_end", Verdict::kFraming, data::kFrame339, sizeof data::kFrame339, 0, 0U, 0U, nullptr, 0, 0, nullptr, nullptr},
    {"overrun", Verdict::kOverrun, data::kFrame340, sizeof data::kFrame340, 0, 0U, 0U, nullptr, 0, 0, nullptr, nullptr},
    {"unknown_message", Verdict::kUnknownMessage, data::kFrame341, sizeof data::kFrame341, 63, 16909123U, 464367618U, data::kPayload341, sizeof data::kPayload341, 0, nullptr, nullptr},
};

inline constexpr StuffingVector kStuffing[] = {
    {nullptr, 0, data::kStuffed0, sizeof data::kStuffed0},
    {data::kPlain1, sizeof data::kPlain1, data::kStuffed1, sizeof data::kStuffed1},
    {data::kPlain2, sizeof data::kPlain2, data::kStuffed2, sizeof data::kStuffed2},
    {data::kPlain3, sizeof data::kPlain3, data::kStuffed3, sizeof data::kStuffed3},
    {data::kPlain4, sizeof data::kPlain4, data::kStuffed4, sizeof data::kStuffed4},
    {data::kPlain5, sizeof data::kPlain5, data::kStuffed5, sizeof data::kStuffed5},
    {data::kPlain6, sizeof data::kPlain6, data::kStuffed6, sizeof data::kStuffed6},
    {data::kPlain7, sizeof data::kPlain7, data::kStuffed7, sizeof data::kStuffed7},
    {data::kPlain8, sizeof data::kPlain8, data::kStuffed8, sizeof data::kStuffed8},
    {data::kPlain9, sizeof data::kPlain9, data::kStuffed9, sizeof data::kStuffed9},
    {data::kPlain10, sizeof data::kPlain10, data::kStuffed10, sizeof data::kStuffed10},
    {data::kPlain11, sizeof data::kPlain11, data::kStuffed11, sizeof data::kStuffed11},
    {data::kPlain12, sizeof data::kPlain12, data::kStuffed12, sizeof data::kStuffed12},
    {data::kPlain13, sizeof data::kPlain13, data::kStuffed13, sizeof data::kStuffed13},
    {data::kPlain14, sizeof data::kPlain14, data::kStuffed14, sizeof data::kStuffed14},
    {data::kPlain15, sizeof data::kPlain15, data::kStuffed15, sizeof data::kStuffed15},
    {data::kPlain16, sizeof data::kPlain16, data::kStuffed16, sizeof data::kStuffed16},
    {data::kPlain17, sizeof data::kPlain17, data::kStuffed17, sizeof data::kStuffed17},
    {data::kPlain18, sizeof data::kPlain18, data::kStuffed18, sizeof data::kStuffed18},
    {data::kPlain19, sizeof data::kPlain19, data::kStuffed19, sizeof data::kStuffed19},
    {data::kPlain20, sizeof data::kPlain20, data::kStuffed20, sizeof data::kStuffed20},
    {data::kPlain21, sizeof data::kPlain21, data::kStuffed21, sizeof data::kStuffed21},
};

}  // namespace reliefscope::vectors
