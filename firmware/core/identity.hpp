// The block by which a firmware image says what it is: reliefscope flash refuses any image without
// one, or with one for another board. A port defines exactly one, and hands out its board name:
//
//   extern const Identity kIdentity = make_identity("teensy31");
//   const BoardInfo kInfo = {kIdentity.board, ...};
//
// so that HELLO and image cannot disagree and the linker cannot drop the block. A reader finds it
// by magic and checks its CRC; integers are little-endian, as every board of this core is.
//
//   offset size
//        0    8  magic: 89 'R' 'S' 'I' 'D' 0D 0A 1A
//        8    2  layout version, 1: later versions only append
//       10    2  size of the block with its CRC, 100
//       12   16  product, "reliefscope" (texts: ASCII, padded with zeros)
//       28   16  board, as in HELLO
//       44   16  firmware version, as in HELLO
//       60   16  commit, as in HELLO
//       76    2  protocol version
//       78    2  zero
//       80   16  schema hash of the protocol, as in HELLO
//       96    4  CRC-32 of everything before it
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/generated/protocol.hpp"
#include "core/version.hpp"

namespace reliefscope {

struct Identity {
  std::uint8_t magic[8];
  std::uint16_t layout;
  std::uint16_t size;
  char product[16];
  char board[16];
  char version[16];
  char git_hash[16];
  std::uint16_t protocol_version;
  std::uint16_t reserved;
  std::uint8_t schema_hash[16];
  std::uint32_t crc;
};
static_assert(sizeof(Identity) == 100 && offsetof(Identity, crc) == 96, "no padding");

namespace detail {

// CRC-32 as in crc32.hpp, bit by bit because the compiler alone runs it.
class IdentityCrc {
 public:
  constexpr void add(std::uint32_t byte) {
    state_ ^= byte & 0xFFu;
    for (int bit = 0; bit < 8; ++bit) {
      state_ = (state_ >> 1) ^ ((state_ & 1u) != 0 ? 0xEDB88320u : 0u);
    }
  }
  constexpr void add16(std::uint32_t value) {
    add(value);
    add(value >> 8);
  }
  template <class T, std::size_t N>
  constexpr void add(const T (&bytes)[N]) {
    for (const T byte : bytes) {
      add(static_cast<std::uint32_t>(byte));
    }
  }
  constexpr std::uint32_t value() const { return ~state_; }

 private:
  std::uint32_t state_ = 0xFFFFFFFFu;
};

template <std::size_t N, std::size_t M>
constexpr void set_identity_text(char (&out)[N], const char (&text)[M]) {
  static_assert(M <= N,
                "the last of 16 bytes stays zero: HELLO takes the board's name as a C string");
  for (std::size_t i = 0; i < M; ++i) {
    out[i] = text[i];
  }
}

}  // namespace detail

template <std::size_t N>
constexpr Identity make_identity(const char (&board)[N]) {
  Identity identity{{0x89, 'R', 'S', 'I', 'D', 0x0D, 0x0A, 0x1A},
                    1,
                    sizeof(Identity),
                    {},
                    {},
                    {},
                    {},
                    wire::kProtocolVersion,
                    0,
                    {},
                    0};
  detail::set_identity_text(identity.product, "reliefscope");
  detail::set_identity_text(identity.board, board);
  detail::set_identity_text(identity.version, kFirmwareVersion);
  detail::set_identity_text(identity.git_hash, kGitHash);
  for (std::size_t i = 0; i < sizeof identity.schema_hash; ++i) {
    identity.schema_hash[i] = wire::kSchemaHash[i];
  }
  detail::IdentityCrc crc;
  crc.add(identity.magic);
  crc.add16(identity.layout);
  crc.add16(identity.size);
  crc.add(identity.product);
  crc.add(identity.board);
  crc.add(identity.version);
  crc.add(identity.git_hash);
  crc.add16(identity.protocol_version);
  crc.add16(identity.reserved);
  crc.add(identity.schema_hash);
  identity.crc = crc.value();
  return identity;
}

}  // namespace reliefscope
