#include "core/framer.hpp"

namespace reliefscope {
namespace {

constexpr std::uint8_t kDelimiter = 0x00;
constexpr std::uint8_t kFullBlock = 0xFF;  // 254 data bytes and no zero after them

std::uint32_t read_u32(const std::uint8_t* bytes) {
  return std::uint32_t{bytes[0]} | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 |
         std::uint32_t{bytes[3]} << 24;
}

}  // namespace

std::size_t cobs_encode(const std::uint8_t* bytes, std::size_t count, std::uint8_t* out) {
  std::size_t code_at = 0;
  std::size_t size = 1;
  std::uint8_t code = 1;
  for (std::size_t i = 0; i < count; ++i) {
    if (code == kFullBlock) {
      out[code_at] = code;
      code_at = size++;
      code = 1;
    }
    if (bytes[i] == 0) {
      out[code_at] = code;
      code_at = size++;
      code = 1;
    } else {
      out[size++] = bytes[i];
      ++code;
    }
  }
  out[code_at] = code;
  out[size++] = kDelimiter;
  return size;
}

std::size_t frame_encode(std::uint8_t* body, std::size_t count, std::uint8_t* out) {
  const std::uint32_t crc = crc32(body, count);
  for (std::size_t i = 0; i < wire::kCrcSize; ++i) {
    body[count + i] = static_cast<std::uint8_t>(crc >> (8 * i));
  }
  return cobs_encode(body, count + wire::kCrcSize, out);
}

bool FrameReceiver::push(std::uint8_t byte) {
  if (byte == kDelimiter) {
    const bool valid = started_ && finish();
    restart();
    return valid;
  }
  started_ = true;
  if (block_left_ == 0) {
    if (zero_due_) {
      append(0);
    }
    block_left_ = static_cast<std::uint8_t>(byte - 1);
    zero_due_ = byte != kFullBlock;
  } else {
    append(byte);
    --block_left_;
  }
  return false;
}

bool FrameReceiver::finish() {
  if (overrun_) {
    ++counters_.overruns;
    return false;
  }
  if (block_left_ != 0 || size_ < wire::kHeaderSize + wire::kCrcSize) {
    ++counters_.framing_errors;
    return false;
  }
  body_size_ = size_ - wire::kCrcSize;
  crc_ = crc32(buffer_, body_size_);
  if (crc_ != read_u32(buffer_ + body_size_)) {
    ++counters_.crc_errors;
    return false;
  }
  ++counters_.frames;
  return true;
}

void FrameReceiver::append(std::uint8_t byte) {
  if (size_ == capacity_) {
    overrun_ = true;
    return;
  }
  buffer_[size_++] = byte;
}

void FrameReceiver::restart() {
  size_ = 0;
  block_left_ = 0;
  zero_due_ = false;
  started_ = false;
  overrun_ = false;
}

}  // namespace reliefscope
