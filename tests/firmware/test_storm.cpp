// Random requests, valid and not, at random times, with interrupts at the worst moments: what must
// always hold.
#include "device.hpp"
#include "unit.hpp"

namespace {

using fake::Device;
using fake::Pin;
namespace wire = reliefscope::wire;

struct Random {
  std::uint32_t state;
  std::uint32_t next() {
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    return state;
  }
  std::uint32_t below(std::uint32_t limit) { return next() % limit; }
};

// The device, and an observer of its outputs.
struct Storm : Device {
  explicit Storm(std::uint32_t seed) : random{seed} {
    hal.board.capabilities |= wire::Capability::kStrobe | wire::Capability::kReady;
    load_aperture(0, 0xAA);
    load_aperture(1, 0x55);
    load_light(0, 0, 4095);
    load_light(1, 15, 1);
    interrupt_at_every_lock();
  }

  std::uint8_t slot() {
    const std::uint8_t slots[] = {0, 1, 2, 255};
    return slots[random.below(4)];
  }
  void table() {
    wire::Step steps[4];
    const std::uint8_t count = static_cast<std::uint8_t>(1 + random.below(4));
    for (wire::Step& step : steps) {
      step.aperture = slot();
      step.light = slot();
      step.repeat = static_cast<std::uint16_t>(1 + random.below(40));
      step.settle_us = random.below(30000);
      step.exposure_us = 10 + random.below(random.below(8) == 0 ? 1900000 : 9000);
    }
    load_steps(steps, count);
    start.deadline_ms = 1 + random.below(8000);
    start.light_lead_us = random.below(3000);
    start.trigger_us = 1 + random.below(9000);
    start.gap_us = random.below(5000);
    start.ready_timeout_ms = static_cast<std::uint16_t>(random.below(3) * 200);
    start.require_strobe = random.below(10) == 0;
    code<wire::StartReply>(start);
  }
  void clear() {
    wire::ClearFaultRequest request;
    request.reason = status().fault;
    code<wire::ClearFaultReply>(request);
  }
  void acknowledge() {
    wire::AcknowledgeEventsRequest request;
    request.next_event = status().next_event;
    request.resend = random.below(4) == 0;
    code<wire::AcknowledgeEventsReply>(request);
  }
  void raw() {
    std::uint8_t payload[40];
    for (std::uint8_t& byte : payload) {
      byte = static_cast<std::uint8_t>(random.next());
    }
    // Everything but the bootloader.
    const std::uint8_t message = static_cast<std::uint8_t>(3 + random.below(0x3D));
    send(message, ++last_id, fake::kNonce, payload, random.below(sizeof payload));
    collect_events();
  }
  void act() {
    wire::SelectApertureRequest aperture;
    aperture.slot = slot();
    wire::SelectLightRequest light;
    light.slot = slot();
    wire::PauseRequest pause;
    pause.run_id = start.run_id;
    wire::ResumeRequest resume;
    resume.run_id = start.run_id;
    switch (random.below(14)) {
      case 0:
      case 1:
        return table();
      case 2:
        code<wire::SelectApertureReply>(aperture);
        return;
      case 3:
        code<wire::SelectLightReply>(light);
        return;
      case 4:
        code<wire::PauseReply>(pause);
        return;
      case 5:
        code<wire::ResumeReply>(resume);
        return;
      case 6:
        if (random.below(3) == 0) {
          code<wire::AbortReply>(wire::AbortRequest{});
        }
        return;
      case 7:
      case 8:
        return clear();
      case 9:
        return acknowledge();
      case 10:
        return raw();
      case 11:
        return set_input(fake::Input::kStrobe, random.below(2) == 0);
      case 12:
        return set_input(fake::Input::kReady, random.below(3) != 0);
      default:
        load_light(static_cast<std::uint8_t>(random.below(3)),
                   static_cast<std::uint8_t>(random.below(16)),
                   static_cast<std::uint16_t>(random.below(4096)));
        return;
    }
  }

  Random random;
};

}  // namespace

TEST(storm_light_and_trigger_keep_their_rules) {
  std::uint32_t exposures = 0;
  std::uint32_t faults = 0;
  std::uint32_t silences = 0;
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    Storm storm(seed);
    for (int i = 0; i < 400; ++i) {
      storm.act();
      const std::uint64_t acted = storm.hal.now;
      storm.run_for(storm.random.below(storm.random.below(8) == 0 ? 4000000 : 60000));
      std::uint32_t sum = 0;
      for (const std::uint16_t level : storm.hal.leds) {
        sum += level;
      }
      const std::uint64_t silent = storm.hal.now - acted;
      const std::size_t outputs = storm.hal.led_changes.size() + storm.hal.edges.size();
      const wire::StatusReply status = storm.status();
      if (storm.hal.led_changes.size() + storm.hal.edges.size() != outputs) {
        continue;  // time passed while the status was asked, and it is of another moment
      }
      const bool active = status.sequence != wire::SequenceState::kIdle;
      CHECK(storm.hal.locks == 0);
      CHECK(sum <= storm.hal.board.level_budget);
      CHECK(status.fault == wire::FaultReason::kNone || (sum == 0 && !active));
      CHECK(active || silent <= 2000000 || sum == 0);
      CHECK(active || !storm.hal.pins[2]);
      CHECK(status.sequence != wire::SequenceState::kPaused || sum == 0);
      CHECK(status.sequence != wire::SequenceState::kHeld || sum == 0);
      CHECK(status.next_event - status.oldest_event <= wire::kEventQueue);
      CHECK(sum == 0 || status.light != 255);
    }
    // On time is looked at by interrupts that a lock can hold up for a moment.
    CHECK(storm.hal.longest_lit <= storm.hal.board.led_on_time_us + 50);
    const wire::CountersReply counters = storm.counters();
    exposures += counters.exposures;
    faults += counters.faults;
    silences += counters.link_timeouts;
  }
  // The storm reached what it is about.
  CHECK(exposures > 5000 && faults > 200 && silences > 10);
}
