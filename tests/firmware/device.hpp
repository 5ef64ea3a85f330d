// A whole device on the fake board, and the host's side of the wire.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/core.hpp"
#include "core/framer.hpp"
#include "fake_hal.hpp"

namespace fake {

constexpr std::uint32_t kNonce = 0x1234ABCD;

struct Frame {
  wire::Header header;
  std::uint8_t payload[wire::kMaxPayload];
};

// What came back for a request.
struct Answer {
  bool any = false;
  wire::MessageId message = wire::MessageId::kRejected;
  wire::ErrorCode code = wire::ErrorCode::kOk;  // of a refusal
  std::uint32_t detail = 0;
};

class Device {
 public:
  explicit Device(wire::ResetCause cause = wire::ResetCause::kPowerOn) {
    core.begin(cause, kNonce);
    run_for(0);
  }

  // Main loop and interrupts up to a time; the timer fires lateness_us late.
  void run_until(std::uint64_t time_us) {
    for (;;) {
      for (;;) {
        if (hal.timer != kNever && hal.timer + lateness_us <= hal.now) {
          hal.timer = kNever;
          core.on_timer();
        } else if (!core.poll()) {
          break;
        }
      }
      std::uint64_t next = core.next_wakeup_us();
      const std::uint64_t timer = hal.timer == kNever ? kNever : hal.timer + lateness_us;
      next = timer < next ? timer : next;
      if (hal.spi_free > hal.now && hal.spi_free < next) {
        next = hal.spi_free;
      }
      if (next > time_us) {
        break;
      }
      hal.now = next > hal.now ? next : hal.now + 1;
    }
    hal.now = time_us > hal.now ? time_us : hal.now;
  }
  // From now on, the timer interrupt comes in before every lock at which it is due, and each lock
  // finds the clock a little later.
  void interrupt_at_every_lock() {
    hal.on_lock_context = this;
    hal.on_lock = [](void* context) {
      Device& device = *static_cast<Device*>(context);
      device.hal.now += 1;
      if (device.hal.timer <= device.hal.now) {
        device.hal.timer = kNever;
        device.core.on_timer();
      }
    };
  }
  void run_for(std::uint64_t us) { run_until(hal.now + us); }

  void set_input(Input input, bool high) {
    hal.inputs[static_cast<std::size_t>(input)] = high;
    core.on_input(input, high);
    run_for(0);
  }

  void send(std::uint8_t message, std::uint32_t id, std::uint32_t nonce,
            const std::uint8_t* payload, std::size_t size) {
    std::uint8_t body[wire::kMaxFrame];
    std::uint8_t encoded[wire::kMaxEncodedFrame];
    wire::Header header;
    header.message = message;
    header.request_id = id;
    header.boot_nonce = nonce;
    header.length = static_cast<std::uint16_t>(size);
    wire::encode(header, body);
    if (size != 0) {
      std::memcpy(body + wire::kHeaderSize, payload, size);
    }
    hal.feed(encoded, reliefscope::frame_encode(body, wire::kHeaderSize + size, encoded));
    run_for(0);
  }

  template <class M>
  void send(const M& message, std::uint32_t id, std::uint32_t nonce = kNonce) {
    std::uint8_t payload[M::kMaxSize + 1] = {};
    const std::size_t size = wire::encode(message, payload);
    send(static_cast<std::uint8_t>(M::kId), id, nonce, payload, size);
  }

  // Next frame from the device; false: none.
  bool receive(Frame& frame) {
    while (tx_at_ < hal.tx_size) {
      const bool complete = receiver_.push(hal.tx[tx_at_++]);
      if (tx_at_ == hal.tx_size) {
        tx_at_ = 0;
        hal.tx_size = 0;
        run_for(0);
      }
      if (complete) {
        wire::decode(frame.header, receiver_.body(), wire::kHeaderSize);
        std::memcpy(frame.payload, receiver_.body() + wire::kHeaderSize, frame.header.length);
        return true;
      }
    }
    return false;
  }

  // Events that pass on the way are kept.
  template <class Reply>
  Answer answer(std::uint32_t id, Reply& reply) {
    Frame frame;
    while (receive(frame)) {
      const auto message = static_cast<wire::MessageId>(frame.header.message);
      if (frame.header.message >= 0x40 && frame.header.message < 0x80) {
        events.add(frame);
        continue;
      }
      Answer result;
      result.any = frame.header.request_id == id && frame.header.boot_nonce == kNonce;
      result.message = message;
      if (message == Reply::kId) {
        result.any = result.any && wire::decode(reply, frame.payload, frame.header.length).code ==
                                       wire::ErrorCode::kOk;
      } else {
        wire::Failed refusal;
        result.any = result.any && wire::decode(refusal, frame.payload, frame.header.length).code ==
                                       wire::ErrorCode::kOk;
        result.code = refusal.code;
        result.detail = refusal.detail;
      }
      return result;
    }
    return Answer{};
  }

  template <class Reply, class Request>
  Answer ask(const Request& request, Reply& reply) {
    const std::uint32_t id = ++last_id;
    send(request, id);
    return answer(id, reply);
  }

  // Code of the answer; UNKNOWN_MESSAGE where there was none.
  template <class Reply, class Request>
  wire::ErrorCode code(const Request& request) {
    Reply reply;
    const Answer result = ask(request, reply);
    return result.any ? result.code : wire::ErrorCode::kUnknownMessage;
  }

  void collect_events() {
    Frame frame;
    while (receive(frame)) {
      events.add(frame);
    }
  }
  template <class M>
  bool event(std::size_t index, M& message) const {
    return index < events.size() &&
           static_cast<wire::MessageId>(events[index].header.message) == M::kId &&
           wire::decode(message, events[index].payload, events[index].header.length).code ==
               wire::ErrorCode::kOk;
  }

  // Everything that a sequence needs.
  wire::ErrorCode load_aperture(std::uint8_t slot, std::uint8_t fill) {
    wire::ApertureChunkRequest chunk;
    chunk.slot = slot;
    std::memset(chunk.data, fill, sizeof chunk.data);
    for (std::uint8_t i = 0; i < wire::kApertureChunks; ++i) {
      chunk.chunk = i;
      const wire::ErrorCode result = code<wire::ApertureChunkReply>(chunk);
      if (result != wire::ErrorCode::kOk) {
        return result;
      }
    }
    std::uint8_t bitmap[wire::kApertureBytes];
    std::memset(bitmap, fill, sizeof bitmap);
    wire::CommitApertureRequest commit;
    commit.slot = slot;
    commit.crc32 = reliefscope::crc32(bitmap, sizeof bitmap);
    return code<wire::CommitApertureReply>(commit);
  }
  wire::ErrorCode load_light(std::uint8_t slot, std::uint8_t led, std::uint16_t level) {
    wire::LoadLightRequest light;
    light.slot = slot;
    light.levels_count = static_cast<std::uint8_t>(led + 1);
    light.levels[led] = level;
    return code<wire::LoadLightReply>(light);
  }
  wire::ErrorCode load_steps(const wire::Step* steps, std::uint8_t count) {
    wire::StepChunkRequest chunk;
    reliefscope::Crc32 crc;
    chunk.steps_count = count;
    for (std::uint8_t i = 0; i < count; ++i) {
      chunk.steps[i] = steps[i];
      std::uint8_t bytes[wire::Step::kMaxSize];
      crc.add(bytes, wire::encode(steps[i], bytes));
    }
    const wire::ErrorCode result = code<wire::StepChunkReply>(chunk);
    if (result != wire::ErrorCode::kOk) {
      return result;
    }
    wire::CommitStepsRequest commit;
    commit.count = count;
    commit.crc32 = crc.value();
    start.table_hash = crc.value();
    return code<wire::CommitStepsReply>(commit);
  }
  wire::StatusReply status() {
    wire::StatusReply reply;
    ask(wire::StatusRequest{}, reply);
    return reply;
  }
  wire::CountersReply counters() {
    wire::CountersReply reply;
    ask(wire::CountersRequest{}, reply);
    return reply;
  }

  Hal hal;
  reliefscope::Core core{hal};
  std::uint64_t lateness_us = 0;
  std::uint32_t last_id = 0;
  Log<Frame, 80> events;
  wire::StartRequest start = default_start();

 private:
  static wire::StartRequest default_start() {
    wire::StartRequest request;
    request.run_id = 7;
    request.deadline_ms = 60000;
    request.light_lead_us = 500;
    request.trigger_us = 50;
    request.gap_us = 2000;
    return request;
  }

  std::uint8_t frame_[wire::kMaxFrame] = {};
  reliefscope::FrameReceiver receiver_{frame_, sizeof frame_};
  std::size_t tx_at_ = 0;
};

}  // namespace fake
