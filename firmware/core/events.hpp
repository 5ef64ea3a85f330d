// Events on their way to the host. Each gets a number and is kept until the host acknowledges it,
// so that one lost on the wire can be sent again. The queue is bounded and nothing in it is ever
// overwritten: the sequencer takes an exposure only while room_for_exposure(), and the places that
// this leaves free belong to the rare other events.
// All functions run under the interrupt lock or in an interrupt.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/generated/protocol.hpp"

namespace reliefscope {

struct Event {
  wire::MessageId message;
  std::uint8_t size;
  std::uint8_t payload[wire::kMaxEvent];
};

class EventQueue {
 public:
  // False: the queue is full and the event is not in it.
  template <class M>
  bool push(const M& message) {
    if (kept() == wire::kEventQueue) {
      return false;
    }
    Event& event = events_[next_ % wire::kEventQueue];
    event.message = M::kId;
    event.size = static_cast<std::uint8_t>(wire::encode(message, event.payload));
    ++next_;
    return true;
  }

  // Puts a message into the newest place of a full queue, and on the wire again.
  template <class M>
  void replace_newest(const M& message) {
    --next_;
    send_ = send_ - oldest_ > kept() ? next_ : send_;
    push(message);
  }

  bool room_for_exposure() const { return kept() + wire::kEventReserve < wire::kEventQueue; }
  std::uint32_t oldest() const { return oldest_; }
  std::uint32_t next() const { return next_; }

  // Forgets events below next_event; with resend, sends those from there on again. False, and
  // nothing changed, when next_event lies outside oldest() to next().
  bool acknowledge(std::uint32_t next_event, bool resend) {
    if (next_event - oldest_ > kept()) {
      return false;
    }
    oldest_ = next_event;
    if (resend || send_ - oldest_ > kept()) {
      send_ = oldest_;
    }
    if (first_unsent_ - oldest_ > kept()) {
      first_unsent_ = oldest_;
    }
    return true;
  }

  // The event to send next and its number; false when all were sent.
  bool take(Event& event, std::uint32_t& number) {
    if (send_ == next_) {
      return false;
    }
    event = events_[send_ % wire::kEventQueue];
    number = send_++;
    if (number == first_unsent_) {
      ++first_unsent_;
      ++sent_;
    } else {
      ++resent_;
    }
    return true;
  }
  bool pending() const { return send_ != next_; }

  std::uint32_t sent() const { return sent_; }
  std::uint32_t resent() const { return resent_; }

 private:
  static_assert((wire::kEventQueue & (wire::kEventQueue - 1)) == 0,
                "numbers wrap round: the size of the queue must divide 2^32");
  std::uint32_t kept() const { return next_ - oldest_; }

  Event events_[wire::kEventQueue] = {};
  std::uint32_t oldest_ = 0;
  std::uint32_t next_ = 0;
  std::uint32_t send_ = 0;          // next to put on the wire
  std::uint32_t first_unsent_ = 0;  // below it, everything was on the wire once
  std::uint32_t sent_ = 0;
  std::uint32_t resent_ = 0;
};

}  // namespace reliefscope
