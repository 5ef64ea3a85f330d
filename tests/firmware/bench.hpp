// A device that is ready for a sequence, and what a host does with one.
#pragma once

#include "core/sequencer.hpp"
#include "device.hpp"

namespace fake {

constexpr std::uint32_t kExposureUs = 4000;
constexpr std::uint32_t kTailUs = reliefscope::Sequencer::kLightTailUs;

inline wire::Step step(std::uint8_t aperture, std::uint8_t light, std::uint16_t repeat,
                       std::uint32_t settle_us) {
  wire::Step value;
  value.aperture = aperture;
  value.light = light;
  value.repeat = repeat;
  value.settle_us = settle_us;
  value.exposure_us = kExposureUs;
  return value;
}

// Two apertures, two lights, glass at rest, events read.
struct Bench : Device {
  Bench() {
    run_for(10000);
    load_aperture(0, 0xFF);
    load_aperture(1, 0x0F);
    load_light(0, 0, 1000);
    load_light(1, 5, 2000);
    collect_events();
    acknowledge();
    events.clear();
    hal.edges.clear();
    hal.led_changes.clear();
    hal.spi.clear();
  }
  void acknowledge() {
    wire::AcknowledgeEventsRequest request;
    request.next_event = status().next_event;
    code<wire::AcknowledgeEventsReply>(request);
  }
  bool begin(const wire::Step* steps, std::uint8_t count) {
    return load_steps(steps, count) == wire::ErrorCode::kOk &&
           code<wire::StartReply>(start) == wire::ErrorCode::kOk;
  }
  // Rising edges of the trigger.
  std::size_t triggers() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < hal.edges.size(); ++i) {
      count += hal.edges[i].pin == Pin::kCameraTrigger && hal.edges[i].high ? 1 : 0;
    }
    return count;
  }
  wire::SequenceState pause() {
    wire::PauseRequest request;
    request.run_id = start.run_id;
    wire::PauseReply reply;
    ask(request, reply);
    return reply.sequence;
  }
  wire::SequenceState resume() {
    wire::ResumeRequest request;
    request.run_id = start.run_id;
    wire::ResumeReply reply;
    ask(request, reply);
    return reply.sequence;
  }
  bool news(std::size_t index, wire::SequenceNews expected) const {
    wire::SequenceEvent message;
    return event(index, message) && message.news == expected && message.run_id == start.run_id;
  }
  bool fault(std::size_t index, wire::FaultReason expected) const {
    wire::FaultEvent message;
    return event(index, message) && message.reason == expected;
  }
};

}  // namespace fake
