// CRC-32 of IEEE 802.3 (reflected, polynomial 0xEDB88320, initial value and final XOR all ones):
// the same value as zlib.crc32. Sixteen table entries: 64 bytes of flash, two look-ups a byte.
#pragma once

#include <cstddef>
#include <cstdint>

namespace reliefscope {

class Crc32 {
 public:
  void add(std::uint8_t byte) {
    state_ = (state_ >> 4) ^ kTable[(state_ ^ byte) & 0x0Fu];
    state_ = (state_ >> 4) ^ kTable[(state_ ^ (byte >> 4)) & 0x0Fu];
  }
  void add(const std::uint8_t* bytes, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      add(bytes[i]);
    }
  }
  std::uint32_t value() const { return ~state_; }

 private:
  static constexpr std::uint32_t kTable[16] = {0x00000000u, 0x1DB71064u, 0x3B6E20C8u, 0x26D930ACu,
                                               0x76DC4190u, 0x6B6B51F4u, 0x4DB26158u, 0x5005713Cu,
                                               0xEDB88320u, 0xF00F9344u, 0xD6D6A3E8u, 0xCB61B38Cu,
                                               0x9B64C2B0u, 0x86D3D2D4u, 0xA00AE278u, 0xBDBDF21Cu};
  std::uint32_t state_ = 0xFFFFFFFFu;
};

inline std::uint32_t crc32(const std::uint8_t* bytes, std::size_t count) {
  Crc32 crc;
  crc.add(bytes, count);
  return crc.value();
}

}  // namespace reliefscope
