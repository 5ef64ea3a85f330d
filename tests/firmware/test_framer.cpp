// Framer against the golden vectors, and against itself on what no vector has.
#include <cstring>

#include "core/framer.hpp"
#include "generated/vectors.hpp"
#include "unit.hpp"

namespace {

namespace wire = reliefscope::wire;
namespace vectors = reliefscope::vectors;
using reliefscope::FrameReceiver;
using vectors::Verdict;

struct Receiver {
  std::uint8_t buffer[wire::kMaxFrame] = {};
  FrameReceiver framer{buffer, sizeof buffer};

  // Frames that came out of the bytes.
  int feed(const std::uint8_t* bytes, std::size_t count) {
    int frames = 0;
    for (std::size_t i = 0; i < count; ++i) {
      frames += framer.push(bytes[i]) ? 1 : 0;
    }
    return frames;
  }
};

bool length_fits(const FrameReceiver& framer, wire::Header& header) {
  return wire::decode(header, framer.body(), wire::kHeaderSize).code == wire::ErrorCode::kOk &&
         header.length + wire::kHeaderSize == framer.size();
}

Verdict verdict_of(Receiver& receiver, const vectors::FrameVector& vector, wire::Header& header) {
  const int frames = receiver.feed(vector.frame, vector.frame_size);
  const reliefscope::FramerCounters& counters = receiver.framer.counters();
  if (frames == 0) {
    return counters.crc_errors != 0       ? Verdict::kCrc
           : counters.framing_errors != 0 ? Verdict::kFraming
           : counters.overruns != 0       ? Verdict::kOverrun
                                          : Verdict::kEmpty;
  }
  if (!length_fits(receiver.framer, header)) {
    return Verdict::kFraming;
  }
  if (vector.decode == nullptr) {
    return Verdict::kUnknownMessage;
  }
  const wire::Check check =
      vector.decode(receiver.framer.body() + wire::kHeaderSize, header.length);
  return check.code == wire::ErrorCode::kOk          ? Verdict::kOk
         : check.code == wire::ErrorCode::kBadLength ? Verdict::kBadLength
                                                     : Verdict::kOutOfRange;
}

}  // namespace

TEST(framer_stuffs_as_the_vectors_say) {
  for (const vectors::StuffingVector& vector : vectors::kStuffing) {
    std::uint8_t out[2048];
    CHECK(reliefscope::cobs_frame_size(vector.plain_size) <= sizeof out);
    const std::size_t size = reliefscope::cobs_encode(vector.plain, vector.plain_size, out);
    CHECK(size <= reliefscope::cobs_frame_size(vector.plain_size));
    CHECK(out[size - 1] == 0);
    // Vectors may or may not name the delimiter.
    CHECK(size == vector.stuffed_size || size == vector.stuffed_size + 1);
    CHECK(std::memcmp(out, vector.stuffed, vector.stuffed_size) == 0);
  }
}

TEST(framer_gives_every_vector_its_verdict) {
  for (const vectors::FrameVector& vector : vectors::kFrames) {
    Receiver receiver;
    wire::Header header;
    const Verdict verdict = verdict_of(receiver, vector, header);
    if (verdict != vector.verdict) {
      std::printf("vector %s: verdict %d\n", vector.name, static_cast<int>(verdict));
    }
    CHECK(verdict == vector.verdict);
    if (verdict == Verdict::kOk || verdict >= Verdict::kUnknownMessage) {
      const std::uint8_t* payload = receiver.framer.body() + wire::kHeaderSize;
      CHECK(header.message == vector.message);
      CHECK(header.request_id == vector.request_id);
      CHECK(header.boot_nonce == vector.boot_nonce);
      CHECK(header.length == vector.payload_size);
      CHECK(header.length == 0 || std::memcmp(payload, vector.payload, header.length) == 0);
    }
    if (verdict == Verdict::kOk) {
      CHECK(vector.matches(receiver.framer.body() + wire::kHeaderSize, header.length));
    }
    if (verdict == Verdict::kOutOfRange) {
      CHECK(vector.decode(vector.payload, vector.payload_size).field == vector.bad_field);
    }
  }
}

TEST(framer_encodes_the_frames_of_the_vectors) {
  for (const vectors::FrameVector& vector : vectors::kFrames) {
    if (vector.verdict != Verdict::kOk) {
      continue;
    }
    std::uint8_t body[wire::kMaxFrame];
    std::uint8_t out[wire::kMaxEncodedFrame];
    wire::Header header;
    header.message = vector.message;
    header.request_id = vector.request_id;
    header.boot_nonce = vector.boot_nonce;
    header.length = static_cast<std::uint16_t>(vector.payload_size);
    wire::encode(header, body);
    if (vector.payload_size != 0) {
      std::memcpy(body + wire::kHeaderSize, vector.payload, vector.payload_size);
    }
    const std::size_t size =
        reliefscope::frame_encode(body, wire::kHeaderSize + vector.payload_size, out);
    CHECK(size == vector.frame_size);
    CHECK(std::memcmp(out, vector.frame, size) == 0);
  }
}

TEST(framer_finds_its_place_at_the_next_zero) {
  const vectors::FrameVector& good = vectors::kFrames[0];
  for (std::size_t cut = 1; cut < good.frame_size; ++cut) {
    Receiver receiver;
    CHECK(receiver.feed(good.frame + cut, good.frame_size - cut) == 0);
    CHECK(receiver.feed(good.frame, good.frame_size) == 1);
    const reliefscope::FramerCounters& counters = receiver.framer.counters();
    CHECK(counters.frames == 1);
    // A cut just before the delimiter leaves an empty frame.
    const std::uint32_t dropped = cut + 1 == good.frame_size ? 0 : 1;
    CHECK(counters.crc_errors + counters.framing_errors + counters.overruns == dropped);
  }
}

TEST(framer_is_bounded_and_counts_one_overrun) {
  Receiver receiver;
  for (int i = 0; i < 100000; ++i) {
    CHECK(!receiver.framer.push(static_cast<std::uint8_t>(1 + i % 255)));
  }
  const vectors::FrameVector& good = vectors::kFrames[0];
  const std::uint8_t zero = 0;
  CHECK(receiver.feed(&zero, 1) == 0);
  CHECK(receiver.framer.counters().overruns == 1);
  CHECK(receiver.feed(good.frame, good.frame_size) == 1);
  CHECK(receiver.framer.counters().framing_errors == 0);
}

TEST(framer_ignores_empty_frames) {
  Receiver receiver;
  const std::uint8_t zeros[16] = {};
  CHECK(receiver.feed(zeros, sizeof zeros) == 0);
  const reliefscope::FramerCounters& counters = receiver.framer.counters();
  CHECK(counters.frames + counters.crc_errors + counters.framing_errors + counters.overruns == 0);
}

TEST(crc32_is_the_one_of_zlib) {
  const char* digits = "123456789";
  CHECK(reliefscope::crc32(reinterpret_cast<const std::uint8_t*>(digits), 9) == 0xCBF43926u);
}
