#include "core/link.hpp"

#include <cstring>

namespace reliefscope {
namespace {

// Ids from here on are events and answers. A device gets them only as its own echo (a terminal that
// is not yet in raw mode); answering an echo would never end.
constexpr std::uint8_t kFirstEvent = 0x40;

}  // namespace

bool Link::poll() {
  if (encoded_at_ < encoded_size_) {
    return flush();
  }
  if (event_turn_) {
    event_turn_ = false;
    if (send_event()) {
      return true;
    }
  }
  return receive() || send_event();
}

bool Link::flush() {
  const std::size_t taken = hal_.serial_write(encoded_ + encoded_at_, encoded_size_ - encoded_at_);
  encoded_at_ += taken;
  return taken != 0;
}

bool Link::receive() {
  if (pending_at_ == pending_size_) {
    pending_at_ = 0;
    pending_size_ = hal_.serial_read(pending_, sizeof pending_);
    if (pending_size_ == 0) {
      return false;
    }
  }
  while (pending_at_ < pending_size_) {
    if (receiver_.push(pending_[pending_at_++])) {
      serve(receiver_.body(), receiver_.size());
      break;
    }
  }
  state_.framer = receiver_.counters();
  return true;
}

bool Link::send_event() {
  Event event;
  std::uint32_t number = 0;
  if (!instrument_.take_event(event, number)) {
    return false;
  }
  std::memcpy(out(), event.payload, event.size);
  send(static_cast<std::uint8_t>(event.message), number, event.size);
  return true;
}

void Link::serve(const std::uint8_t* body, std::size_t size) {
  wire::Header header;
  if (wire::decode(header, body, wire::kHeaderSize).code != wire::ErrorCode::kOk ||
      header.length != size - wire::kHeaderSize) {
    receiver_.count_framing_error();
    return;
  }
  instrument_.link_heard();
  if (header.message >= kFirstEvent) {
    ++state_.rejected;
    return;
  }
  event_turn_ = true;
  const std::uint8_t* payload = body + wire::kHeaderSize;
  state_.framer = receiver_.counters();
  if (!wire::uses_ring(header.message)) {
    answer(header, wire::dispatch(commands_, header.message, payload, header.length, out()));
    return;
  }
  if (header.boot_nonce != state_.boot_nonce) {
    ++state_.wrong_nonce;
    reject(header, wire::ErrorCode::kWrongNonce, state_.boot_nonce);
    return;
  }
  if (const Completion* done = find(header.request_id)) {
    if (done->frame_crc != receiver_.crc()) {
      reject(header, wire::ErrorCode::kRequestIdReused, 0);
      return;
    }
    ++state_.retries_answered;
    std::memcpy(out(), done->payload, done->size);
    send(done->message, header.request_id, done->size);
    return;
  }
  if (header.request_id <= state_.last_request_id) {
    reject(header, wire::ErrorCode::kRequestTooOld, state_.last_request_id);
    return;
  }
  run(header, payload);
}

void Link::run(const wire::Header& header, const std::uint8_t* payload) {
  const wire::Outcome outcome =
      wire::dispatch(commands_, header.message, payload, header.length, out());
  if (outcome.message != wire::MessageId::kRejected) {
    state_.last_request_id = header.request_id;
    Completion& done = ring_[ring_next_];
    ring_next_ = (ring_next_ + 1) % wire::kCompletionRing;
    done.used = true;
    done.message = static_cast<std::uint8_t>(outcome.message);
    done.size = static_cast<std::uint8_t>(outcome.size);
    done.request_id = header.request_id;
    done.frame_crc = receiver_.crc();
    std::memcpy(done.payload, out(), outcome.size);
  }
  answer(header, outcome);
}

void Link::reject(const wire::Header& header, wire::ErrorCode code, std::uint32_t detail) {
  answer(header, wire::refuse(header.message, code, detail, out()));
}

void Link::answer(const wire::Header& header, const wire::Outcome& outcome) {
  if (outcome.message == wire::MessageId::kRejected) {
    ++state_.rejected;
  } else if (outcome.message == wire::MessageId::kFailed) {
    ++state_.failed;
  }
  send(static_cast<std::uint8_t>(outcome.message), header.request_id, outcome.size);
}

void Link::send(std::uint8_t message, std::uint32_t number, std::size_t size) {
  wire::Header header;
  header.message = message;
  header.request_id = number;
  header.boot_nonce = state_.boot_nonce;
  header.length = static_cast<std::uint16_t>(size);
  wire::encode(header, body_);
  std::size_t lead = 0;
  if (first_frame_) {
    // A reset may have cut a frame in two: its rest must not swallow this one.
    encoded_[lead++] = 0;
    first_frame_ = false;
  }
  encoded_size_ = lead + frame_encode(body_, wire::kHeaderSize + size, encoded_ + lead);
  encoded_at_ = 0;
  ++state_.frames_sent;
}

Link::Completion* Link::find(std::uint32_t request_id) {
  for (Completion& done : ring_) {
    if (done.used && done.request_id == request_id) {
      return &done;
    }
  }
  return nullptr;
}

}  // namespace reliefscope
