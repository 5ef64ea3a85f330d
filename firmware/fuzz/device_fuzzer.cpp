// libFuzzer over the whole core: what a host, a cable and a camera can do to a device, in virtual
// time. An input is a list of actions, each an opcode byte (kind in the upper 3 bits, size in the
// lower 5) and its bytes, so that a mutation of one action leaves the others as they were. Frames
// get their CRC here: a fuzzer does not find one by itself, and the garbage action has none.
//
// Sanitizers find what the language forbids; broken() finds what the instrument forbids.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

#include "device.hpp"

namespace {

using fake::Device;
using fake::Input;
namespace wire = reliefscope::wire;

// An input may not keep the device for longer than this, however it is written.
constexpr std::uint64_t kLongestUs = 6000000;
// A lock, a late interrupt and the cut-off itself take a moment.
constexpr std::uint64_t kSlackUs = 3000;
constexpr std::uint64_t kLinkTimeoutUs = std::uint64_t{wire::kLinkTimeoutMs} * 1000;

class Reader {
 public:
  Reader(const std::uint8_t* bytes, std::size_t size) : bytes_(bytes), size_(size) {}
  bool done() const { return at_ == size_; }
  std::uint8_t byte() { return done() ? 0 : bytes_[at_++]; }
  std::uint32_t number(unsigned bytes) {
    std::uint32_t value = 0;
    for (unsigned i = 0; i < bytes; ++i) {
      value |= std::uint32_t{byte()} << (8 * i);
    }
    return value;
  }
  // The next count bytes, or what is left of them.
  Reader part(std::size_t count) {
    const std::size_t left = size_ - at_;
    const Reader found(bytes_ + at_, count < left ? count : left);
    at_ += found.size_;
    return found;
  }
  const std::uint8_t* data() const { return bytes_ + at_; }
  std::size_t left() const { return size_ - at_; }

 private:
  const std::uint8_t* bytes_;
  std::size_t size_;
  std::size_t at_ = 0;
};

// silent_us: time that passed without an action.
bool broken(Device& device, std::uint64_t silent_us) {
  std::uint32_t sum = 0;
  for (const std::uint16_t level : device.hal.leds) {
    sum += level;
  }
  const bool idle = !device.core.sequence_active();
  return device.hal.locks != 0 || sum > device.hal.board.level_budget ||
         device.hal.longest_lit > device.hal.board.led_on_time_us + kSlackUs ||
         (idle && device.hal.pins[static_cast<std::size_t>(fake::Pin::kCameraTrigger)]) ||
         (idle && sum != 0 && silent_us > kLinkTimeoutUs + kSlackUs);
}

// Uploads two steps and starts them, so that a short input reaches the sequencer.
void sequence(Device& device, Reader in) {
  device.load_aperture(0, in.byte());
  device.load_light(0, static_cast<std::uint8_t>(in.byte() % 16), 2000);
  wire::Step steps[2];
  for (wire::Step& step : steps) {
    step.aperture = (in.byte() & 1) != 0 ? 255 : 0;
    step.light = (in.byte() & 1) != 0 ? 255 : 0;
    step.repeat = static_cast<std::uint16_t>(1 + in.byte() % 64);
    step.settle_us = in.number(2);
    step.exposure_us = 10 + in.number(2);
  }
  device.load_steps(steps, 2);
  device.start.deadline_ms = 1 + in.number(2);
  device.start.light_lead_us = in.number(1) * 16;
  device.start.trigger_us = 1 + in.number(2) % 9999;
  device.start.gap_us = in.number(2);
  device.start.ready_timeout_ms = static_cast<std::uint16_t>(in.number(1));
  device.start.require_strobe = (in.byte() & 1) != 0;
  device.code<wire::StartReply>(device.start);
}

void act(Device& device, unsigned kind, Reader in) {
  switch (kind) {
    case 0:  // bytes as they are
      device.hal.feed(in.data(), in.left());
      device.run_for(0);
      break;
    case 1:  // the next request, its payload from the input
    case 2: {
      const std::uint8_t message = in.byte();
      device.send(message, ++device.last_id, fake::kNonce, in.data(), in.left());
      break;
    }
    case 3: {  // a request under any id and nonce
      const std::uint8_t message = in.byte();
      const std::uint32_t id = in.number(1);
      const std::uint32_t nonce = (in.byte() & 1) != 0 ? fake::kNonce : in.number(4);
      device.send(message, id, nonce, in.data(), in.left());
      break;
    }
    case 4: {
      const std::uint32_t silent_us = in.number(2) * 64;
      device.run_for(silent_us);
      if (broken(device, silent_us)) {
        std::abort();
      }
      break;
    }
    case 5: {
      const std::uint8_t lines = in.byte();
      device.set_input((lines & 1) != 0 ? Input::kStrobe : Input::kReady, (lines & 2) != 0);
      break;
    }
    case 6:
      sequence(device, in);
      break;
    default: {  // a port that takes little, interrupts at the worst moments, late ones
      const std::uint8_t how = in.byte();
      device.hal.tx_limit = (how & 1) != 0 ? 1 + in.number(1) : sizeof device.hal.tx;
      device.lateness_us = (how & 2) != 0 ? in.number(1) * 8 : 0;
      if ((how & 4) != 0) {
        device.interrupt_at_every_lock();
      }
      break;
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  alignas(Device) static unsigned char memory[sizeof(Device)];
  Device& device = *new (memory) Device();
  device.hal.board.capabilities |=
      wire::Capability::kStrobe | wire::Capability::kReady | wire::Capability::kTemperature;
  Reader in(bytes, size);
  while (!in.done() && device.hal.now < kLongestUs) {
    const std::uint8_t head = in.byte();
    act(device, head >> 5, in.part(head & 31u));
    device.collect_events();
    if (broken(device, 0)) {
      std::abort();
    }
  }
  return 0;
}
