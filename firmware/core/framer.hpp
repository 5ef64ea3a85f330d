// Frames on the byte stream: body (header, payload), CRC-32 little-endian, COBS, 0x00.
//
// FrameReceiver decodes byte by byte into one bounded buffer. 0x00 ends a frame, whatever came
// before, so a receiver that lost its place finds it at the next 0x00; every frame that it drops
// is counted once, under one cause. Empty frames (0x00 after 0x00) are no frames.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/crc32.hpp"
#include "core/generated/protocol.hpp"

namespace reliefscope {

// Bytes of COBS for n bytes of data, and the 0x00 that ends the frame.
constexpr std::size_t cobs_frame_size(std::size_t n) {
  return n + n / 254 + 1 + 1;
}

// Encodes count bytes and ends them with 0x00; out holds cobs_frame_size(count). Returns bytes.
std::size_t cobs_encode(const std::uint8_t* bytes, std::size_t count, std::uint8_t* out);

// Adds the CRC to a body of count bytes (which needs wire::kCrcSize of room behind it) and encodes
// it; out holds cobs_frame_size(count + wire::kCrcSize). Returns bytes.
std::size_t frame_encode(std::uint8_t* body, std::size_t count, std::uint8_t* out);

struct FramerCounters {
  std::uint32_t frames;
  std::uint32_t crc_errors;
  std::uint32_t framing_errors;  // COBS or too short
  std::uint32_t overruns;        // longer than the buffer
};

class FrameReceiver {
 public:
  // Body and CRC in buffer, which the caller owns.
  FrameReceiver(std::uint8_t* buffer, std::size_t capacity)
      : buffer_(buffer), capacity_(capacity) {}

  // True when this byte ended a frame with a correct CRC: body() and size() hold until the next
  // call.
  bool push(std::uint8_t byte);

  const std::uint8_t* body() const { return buffer_; }
  std::size_t size() const { return body_size_; }
  // Of the body: equal for frames that are equal byte for byte.
  std::uint32_t crc() const { return crc_; }
  const FramerCounters& counters() const { return counters_; }
  // For what only the reader of the body can see: a length field that does not fit.
  void count_framing_error() {
    --counters_.frames;
    ++counters_.framing_errors;
  }

 private:
  bool finish();
  void append(std::uint8_t byte);
  void restart();

  std::uint8_t* buffer_;
  std::size_t capacity_;
  std::size_t size_ = 0;
  std::size_t body_size_ = 0;
  std::uint32_t crc_ = 0;
  std::uint8_t block_left_ = 0;  // data bytes still to come in this COBS block
  bool zero_due_ = false;        // the block that ended stands for a zero, unless it was the last
  bool started_ = false;
  bool overrun_ = false;
  FramerCounters counters_{};
};

}  // namespace reliefscope
