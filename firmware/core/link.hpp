// The wire seen from the device: frames in, answers and events out, one at a time.
//
// A request carries the nonce of this boot and an id above all before. It is run once; its answer
// is kept in a ring and sent again for a retry, which is byte for byte the same frame. An id that
// is not in the ring and not above the last is rejected and never run. Rejected requests (which
// reached no handler) leave no trace but a count. hello and enter_bootloader stand outside all
// this: they can be repeated at will and are valid with any nonce.
//
// Nothing waits: while the port does not take the bytes of one answer, no further request is read.
// Answers and events take turns, so neither starves the other. All functions run in main.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/commands.hpp"
#include "core/framer.hpp"
#include "core/generated/protocol.hpp"
#include "core/hal.hpp"
#include "core/instrument.hpp"
#include "core/link_state.hpp"

namespace reliefscope {

class Link {
 public:
  Link(Hal& hal, Instrument& instrument, Commands& commands, LinkState& state)
      : hal_(hal), instrument_(instrument), commands_(commands), state_(state) {}

  // One piece of work; false: nothing to do now.
  bool poll();

 private:
  struct Completion {
    bool used;
    std::uint8_t message;  // of the answer
    std::uint8_t size;
    std::uint32_t request_id;
    std::uint32_t frame_crc;  // of the request
    std::uint8_t payload[wire::kMaxRingReply];
  };

  bool flush();
  bool receive();
  bool send_event();
  void serve(const std::uint8_t* body, std::size_t size);
  void run(const wire::Header& header, const std::uint8_t* payload);
  void reject(const wire::Header& header, wire::ErrorCode code, std::uint32_t detail);
  void answer(const wire::Header& header, const wire::Outcome& outcome);
  // Frames the size bytes that stand in body_ after the header.
  void send(std::uint8_t message, std::uint32_t number, std::size_t size);
  Completion* find(std::uint32_t request_id);
  std::uint8_t* out() { return body_ + wire::kHeaderSize; }

  Hal& hal_;
  Instrument& instrument_;
  Commands& commands_;
  LinkState& state_;

  std::uint8_t frame_[wire::kMaxFrame] = {};
  FrameReceiver receiver_{frame_, sizeof frame_};
  std::uint8_t pending_[64] = {};  // bytes that the port gave and nobody looked at
  std::size_t pending_size_ = 0;
  std::size_t pending_at_ = 0;

  std::uint8_t body_[wire::kMaxFrame] = {};
  std::uint8_t encoded_[wire::kMaxEncodedFrame + 1] = {};
  std::size_t encoded_size_ = 0;
  std::size_t encoded_at_ = 0;
  bool first_frame_ = true;
  bool event_turn_ = true;

  Completion ring_[wire::kCompletionRing] = {};
  std::size_t ring_next_ = 0;
};

}  // namespace reliefscope
