// Sequences in virtual time: order and times of glass, light and trigger, events, pause and abort.
#include <cstring>

#include "device.hpp"
#include "unit.hpp"

namespace {

using fake::Device;
using fake::Pin;
namespace wire = reliefscope::wire;
using wire::ErrorCode;
using wire::SequenceNews;
using wire::SequenceState;

constexpr std::uint32_t kExposureUs = 4000;
constexpr std::uint32_t kTailUs = reliefscope::Sequencer::kLightTailUs;

wire::Step step(std::uint8_t aperture, std::uint8_t light, std::uint16_t repeat,
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
    return load_steps(steps, count) == ErrorCode::kOk &&
           code<wire::StartReply>(start) == ErrorCode::kOk;
  }
  // Rising edges of the trigger.
  std::size_t triggers() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < hal.edges.size(); ++i) {
      count += hal.edges[i].pin == Pin::kCameraTrigger && hal.edges[i].high ? 1 : 0;
    }
    return count;
  }
  SequenceState pause() {
    wire::PauseRequest request;
    request.run_id = start.run_id;
    wire::PauseReply reply;
    ask(request, reply);
    return reply.sequence;
  }
  SequenceState resume() {
    wire::ResumeRequest request;
    request.run_id = start.run_id;
    wire::ResumeReply reply;
    ask(request, reply);
    return reply.sequence;
  }
  bool news(std::size_t index, SequenceNews expected) const {
    wire::SequenceEvent message;
    return event(index, message) && message.news == expected && message.run_id == start.run_id;
  }
  bool fault(std::size_t index, wire::FaultReason expected) const {
    wire::FaultEvent message;
    return event(index, message) && message.reason == expected;
  }
};

}  // namespace

TEST(sequencer_runs_the_table_and_tells_every_exposure) {
  Bench bench;
  const wire::Step steps[] = {step(0, 0, 2, 300000), step(0, 1, 1, 0), step(1, 1, 1, 200000),
                              step(255, 255, 1, 0)};
  CHECK(bench.begin(steps, 4));
  bench.run_for(2000000);
  bench.collect_events();
  CHECK(bench.events.size() == 7);
  CHECK(bench.news(0, SequenceNews::kStarted));
  CHECK(bench.news(6, SequenceNews::kFinished));
  const std::uint16_t step_of[] = {0, 0, 1, 2, 3};
  const std::uint16_t repeat_of[] = {0, 1, 0, 0, 0};
  for (std::uint32_t i = 0; i < 5; ++i) {
    wire::ExposureEvent event;
    CHECK(bench.event(i + 1, event));
    CHECK(event.index == i && event.step == step_of[i] && event.repeat == repeat_of[i]);
    CHECK(event.aperture == steps[step_of[i]].aperture);
    CHECK(event.light == steps[step_of[i]].light);
    CHECK(event.run_id == 7 && event.table_hash == bench.start.table_hash);
    CHECK(event.settle_waited_us >= steps[step_of[i]].settle_us);
    CHECK(event.flags == 0);
  }
  CHECK(bench.triggers() == 5);
  const wire::StatusReply status = bench.status();
  CHECK(status.sequence == SequenceState::kIdle && status.exposures == 5 && status.run_id == 7);
  CHECK(status.aperture == 255 && status.light == 255);
}

TEST(sequencer_keeps_its_times_to_the_microsecond) {
  Bench bench;
  const wire::Step steps[] = {step(0, 0, 2, 300000)};
  CHECK(bench.begin(steps, 1));
  bench.run_for(1000000);
  bench.collect_events();
  wire::ExposureEvent first;
  wire::ExposureEvent second;
  CHECK(bench.event(1, first) && bench.event(2, second));
  CHECK(first.settle_waited_us == 300000);
  const fake::Log<fake::Edge, 64>& edges = bench.hal.edges;
  std::size_t rise[2] = {};
  std::size_t found = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (edges[i].pin == Pin::kCameraTrigger && edges[i].high) {
      CHECK(found < 2);
      rise[found++] = i;
      CHECK(edges[i + 1].pin == Pin::kCameraTrigger && !edges[i + 1].high);
      CHECK(edges[i + 1].at_us - edges[i].at_us == 50);
    }
  }
  CHECK(found == 2);
  CHECK(edges[rise[0]].at_us == first.start_us && edges[rise[1]].at_us == second.start_us);
  // Light: on a lead before the trigger, off a tail after the exposure; dark in the gap.
  const fake::Log<fake::LedChange, 64>& led = bench.hal.led_changes;
  CHECK(led.size() == 4);
  CHECK(led[0].sum == 1000 && led[0].at_us == first.start_us - 500);
  CHECK(led[1].sum == 0 && led[1].at_us == first.start_us + kExposureUs + kTailUs);
  CHECK(led[2].sum == 1000 && led[2].at_us == led[1].at_us + 2000);
  CHECK(second.start_us == led[2].at_us + 500);
  CHECK(led[3].sum == 0 && led[3].at_us == second.start_us + kExposureUs + kTailUs);
}

TEST(sequencer_writes_the_glass_only_when_the_aperture_changes) {
  Bench bench;
  const wire::Step steps[] = {step(0, 0, 1, 0), step(0, 1, 1, 0), step(1, 0, 1, 0)};
  CHECK(bench.begin(steps, 3));
  bench.run_for(1000000);
  CHECK(bench.triggers() == 3);
  CHECK(bench.hal.spi.size() == 2 * (8 * 3 + 1));
}

TEST(sequencer_writes_the_glass_again_for_a_slot_that_was_loaded_anew) {
  Bench bench;
  wire::SelectApertureRequest select;
  CHECK(bench.code<wire::SelectApertureReply>(select) == ErrorCode::kOk);
  bench.run_for(10000);
  CHECK(bench.load_aperture(0, 0x3C) == ErrorCode::kOk);
  bench.hal.spi.clear();
  const wire::Step steps[] = {step(0, 0, 1, 0)};
  CHECK(bench.begin(steps, 1));
  bench.run_for(1000000);
  CHECK(bench.hal.spi.size() == 8 * 3 + 1);
  CHECK(bench.hal.spi[1].data && bench.hal.spi[1].bytes[0] == 0x3C);
}

TEST(sequencer_settles_each_step_that_asks_for_it_even_on_the_same_glass) {
  Bench bench;
  const wire::Step steps[] = {step(0, 0, 1, 0), step(0, 1, 1, 80000)};
  CHECK(bench.begin(steps, 2));
  bench.run_for(1000000);
  bench.collect_events();
  wire::ExposureEvent first;
  wire::ExposureEvent second;
  CHECK(bench.event(1, first) && bench.event(2, second));
  CHECK(second.start_us == first.start_us + kExposureUs + kTailUs + 2000 + 80000);
}

TEST(sequencer_keeps_the_gap_over_a_pause) {
  Bench bench;
  bench.start.gap_us = 1000000;
  const wire::Step steps[] = {step(0, 0, 2, 0)};
  CHECK(bench.begin(steps, 1));
  while (bench.triggers() == 0) {
    bench.run_for(100);
  }
  CHECK(bench.pause() == SequenceState::kPausing);
  while (bench.status().sequence != SequenceState::kPaused) {
    bench.run_for(100);
  }
  CHECK(bench.resume() == SequenceState::kRunning);
  bench.run_for(2000000);
  bench.collect_events();
  wire::ExposureEvent first;
  wire::ExposureEvent second;
  CHECK(bench.event(1, first) && bench.event(4, second));
  CHECK(second.start_us >= first.start_us + kExposureUs + kTailUs + 1000000);
}

TEST(sequencer_goes_on_in_silence) {
  Bench bench;
  wire::Step longer = step(0, 0, 3, 0);
  longer.exposure_us = 1500000;
  CHECK(bench.begin(&longer, 1));
  bench.run_for(6000000);
  bench.collect_events();
  CHECK(bench.news(4, SequenceNews::kFinished));
  const fake::Log<fake::LedChange, 64>& led = bench.hal.led_changes;
  CHECK(led.size() == 6);
  for (std::size_t i = 0; i < 6; i += 2) {
    CHECK(led[i].sum == 1000 && led[i + 1].sum == 0);
    CHECK(led[i + 1].at_us - led[i].at_us == 500 + 1500000 + kTailUs);
  }
  CHECK(bench.counters().link_timeouts == 0);
}

TEST(sequencer_turns_a_light_selected_by_hand_off_first) {
  Bench bench;
  wire::SelectLightRequest select;
  CHECK(bench.code<wire::SelectLightReply>(select) == ErrorCode::kOk);
  const wire::Step steps[] = {step(0, 1, 1, 100000)};
  CHECK(bench.begin(steps, 1));
  CHECK(bench.hal.leds[0] == 0);
}

TEST(sequencer_refuses_everything_else_while_it_runs) {
  Bench bench;
  const wire::Step steps[] = {step(0, 0, 1, 500000)};
  CHECK(bench.begin(steps, 1));
  CHECK(bench.load_aperture(3, 0) == ErrorCode::kBusy);
  CHECK(bench.load_light(3, 0, 1) == ErrorCode::kBusy);
  CHECK(bench.load_steps(steps, 1) == ErrorCode::kBusy);
  CHECK(bench.code<wire::SelectApertureReply>(wire::SelectApertureRequest{}) == ErrorCode::kBusy);
  CHECK(bench.code<wire::SelectLightReply>(wire::SelectLightRequest{}) == ErrorCode::kBusy);
  CHECK(bench.code<wire::SetSettingsReply>(wire::SetSettingsRequest{}) == ErrorCode::kBusy);
  CHECK(bench.code<wire::StartReply>(bench.start) == ErrorCode::kBusy);
  bench.run_for(1000000);
  CHECK(bench.triggers() == 1);
}

TEST(sequencer_start_needs_the_table_that_the_host_means) {
  Bench bench;
  const wire::Step steps[] = {step(0, 0, 1, 0)};
  CHECK(bench.load_steps(steps, 1) == ErrorCode::kOk);
  wire::StartRequest start = bench.start;
  start.table_hash ^= 1;
  wire::StartReply reply;
  const fake::Answer answer = bench.ask(start, reply);
  CHECK(answer.code == ErrorCode::kTableMismatch && answer.detail == bench.start.table_hash);
  start = bench.start;
  start.light_lead_us = 1000000;
  start.run_id = 9;
  wire::Step longer = steps[0];
  longer.exposure_us = 1500000;
  CHECK(bench.load_steps(&longer, 1) == ErrorCode::kOk);
  start.table_hash = bench.start.table_hash;
  CHECK(bench.code<wire::StartReply>(start) == ErrorCode::kOnTimeLimit);
}

TEST(sequencer_pause_during_settle_stands_at_once_and_settles_again) {
  Bench bench;
  const wire::Step steps[] = {step(0, 0, 1, 300000)};
  CHECK(bench.begin(steps, 1));
  bench.run_for(200000);
  CHECK(bench.pause() == SequenceState::kPaused);
  bench.run_for(5000000);
  CHECK(bench.triggers() == 0);
  const std::uint64_t resumed = bench.hal.now;
  CHECK(bench.resume() == SequenceState::kRunning);
  bench.run_for(1000000);
  bench.collect_events();
  CHECK(bench.news(1, SequenceNews::kPaused) && bench.news(2, SequenceNews::kResumed));
  wire::ExposureEvent event;
  CHECK(bench.event(3, event));
  CHECK(event.settle_waited_us == 300000);
  CHECK(event.start_us >= resumed + 300000);
}

TEST(sequencer_pause_during_lead_turns_the_light_off_at_once) {
  Bench bench;
  bench.start.light_lead_us = 100000;
  const wire::Step steps[] = {step(0, 0, 1, 300000)};
  CHECK(bench.begin(steps, 1));
  bench.run_for(250000);
  CHECK(bench.hal.leds[0] == 1000);
  CHECK(bench.pause() == SequenceState::kPaused);
  CHECK(bench.hal.leds[0] == 0);
  bench.run_for(1000000);
  CHECK(bench.triggers() == 0);
}

TEST(sequencer_pause_during_an_exposure_lets_it_end) {
  Bench bench;
  const wire::Step steps[] = {step(0, 0, 3, 10000)};
  CHECK(bench.begin(steps, 1));
  while (bench.triggers() == 0) {
    bench.run_for(100);
  }
  CHECK(bench.pause() == SequenceState::kPausing);
  CHECK(bench.hal.leds[0] == 1000);
  bench.run_for(1000000);
  CHECK(bench.triggers() == 1);
  CHECK(bench.status().sequence == SequenceState::kPaused);
  CHECK(bench.status().exposures == 1);
  CHECK(bench.resume() == SequenceState::kRunning);
  bench.run_for(1000000);
  bench.collect_events();
  CHECK(bench.triggers() == 3);
  CHECK(bench.events.size() == 7);
  CHECK(bench.news(2, SequenceNews::kPaused) && bench.news(6, SequenceNews::kFinished));
}

TEST(sequencer_abort_mid_exposure_is_dark_and_shut_within_a_millisecond) {
  Bench bench;
  const wire::Step steps[] = {step(0, 0, 3, 10000)};
  CHECK(bench.begin(steps, 1));
  while (bench.triggers() == 0) {
    bench.run_for(20);
  }
  bench.hal.spi.clear();
  const std::uint64_t asked = bench.hal.now;
  wire::AbortRequest request;
  request.run_id = 7;
  wire::AbortReply reply;
  CHECK(bench.ask(request, reply).code == ErrorCode::kOk);
  CHECK(reply.sequence == SequenceState::kIdle && reply.exposures == 0);
  CHECK(bench.hal.leds[0] == 0 && !bench.hal.pins[2]);
  CHECK(bench.hal.led_changes.last().at_us - asked <= 1000);
  bench.run_for(1000);
  CHECK(bench.hal.spi.size() > 0 && bench.hal.spi[0].bytes[0] == 0xAE);
  CHECK(bench.hal.spi[0].at_us - asked <= 1000);
  bench.run_for(1000000);
  bench.collect_events();
  CHECK(bench.triggers() == 1);
  CHECK(bench.events.size() == 2 && bench.news(1, SequenceNews::kAborted));
  CHECK(bench.status().aperture == 255);
}

TEST(sequencer_abort_is_bound_to_its_run_and_harmless_without_one) {
  Bench bench;
  wire::AbortRequest request;
  CHECK(bench.code<wire::AbortReply>(request) == ErrorCode::kOk);
  const wire::Step steps[] = {step(0, 0, 1, 500000)};
  CHECK(bench.begin(steps, 1));
  request.run_id = 8;
  wire::AbortReply reply;
  const fake::Answer answer = bench.ask(request, reply);
  CHECK(answer.code == ErrorCode::kNotRunning && answer.detail == 7);
  wire::PauseRequest pause;
  pause.run_id = 8;
  CHECK(bench.code<wire::PauseReply>(pause) == ErrorCode::kNotRunning);
  request.run_id = 0;
  CHECK(bench.code<wire::AbortReply>(request) == ErrorCode::kOk);
  CHECK(bench.status().sequence == SequenceState::kIdle);
}

TEST(sequencer_all_off_aborts_and_leaves_the_glass) {
  Bench bench;
  const wire::Step steps[] = {step(0, 0, 1, 500000)};
  CHECK(bench.begin(steps, 1));
  bench.run_for(10000);
  bench.hal.spi.clear();
  wire::AllOffReply reply;
  CHECK(bench.ask(wire::AllOffRequest{}, reply).code == ErrorCode::kOk);
  bench.run_for(1000000);
  CHECK(bench.triggers() == 0 && bench.hal.spi.size() == 0);
  CHECK(bench.status().aperture == 0);
}

TEST(sequencer_is_held_while_the_host_does_not_acknowledge) {
  Bench bench;
  const wire::Step steps[] = {step(0, 0, 100, 0)};
  CHECK(bench.begin(steps, 1));
  bench.run_for(10000000);
  const std::size_t most = wire::kEventQueue - wire::kEventReserve - 1;  // one place: started
  CHECK(bench.status().exposures == most);
  CHECK(bench.status().sequence == SequenceState::kHeld);
  CHECK(bench.hal.leds[0] == 0);
  bench.collect_events();
  bench.acknowledge();
  bench.run_for(10000000);
  bench.collect_events();
  CHECK(bench.status().sequence == SequenceState::kIdle);
  CHECK(bench.status().exposures == 100);
  CHECK(bench.events.size() > most && bench.status().fault == wire::FaultReason::kNone);
}

TEST(sequencer_ends_with_a_fault_when_its_deadline_passes) {
  Bench bench;
  bench.start.deadline_ms = 3000;
  const wire::Step steps[] = {step(0, 0, 100, 0)};
  CHECK(bench.begin(steps, 1));
  const std::uint64_t begun = bench.hal.now;
  bench.run_for(10000000);
  bench.collect_events();
  const std::size_t count = bench.events.size();
  CHECK(bench.fault(count - 2, wire::FaultReason::kSequenceDeadline));
  CHECK(bench.news(count - 1, SequenceNews::kAborted));
  wire::FaultEvent event;
  CHECK(bench.event(count - 2, event) && event.at_us == begun + 3000000);
  CHECK(bench.code<wire::StartReply>(bench.start) == ErrorCode::kFaultLatched);
}

TEST(sequencer_deadline_does_not_count_pauses) {
  Bench bench;
  bench.start.deadline_ms = 1000;
  const wire::Step steps[] = {step(0, 0, 1, 500000)};
  CHECK(bench.begin(steps, 1));
  CHECK(bench.pause() == SequenceState::kPaused);
  bench.run_for(20000000);
  CHECK(bench.resume() == SequenceState::kRunning);
  bench.run_for(2000000);
  CHECK(bench.status().exposures == 1 && bench.status().fault == wire::FaultReason::kNone);
}

TEST(sequencer_waits_for_the_ready_camera) {
  Bench bench;
  bench.hal.board.capabilities |= wire::Capability::kReady;
  bench.start.ready_timeout_ms = 1000;
  const wire::Step steps[] = {step(0, 0, 1, 100000)};
  CHECK(bench.begin(steps, 1));
  bench.run_for(500000);
  CHECK(bench.triggers() == 0 && bench.hal.leds[0] == 0);
  CHECK(!bench.status().camera_ready);
  const std::uint64_t ready = bench.hal.now;
  bench.set_input(fake::Input::kReady, true);
  bench.run_for(100000);
  bench.collect_events();
  wire::ExposureEvent event;
  CHECK(bench.event(1, event));
  CHECK(event.start_us == ready + 500);
  CHECK(event.flags == wire::ExposureFlag::kReadyWaited);
}

TEST(sequencer_gives_a_camera_up_that_never_gets_ready) {
  Bench bench;
  bench.hal.board.capabilities |= wire::Capability::kReady;
  bench.start.ready_timeout_ms = 1000;
  const wire::Step steps[] = {step(0, 0, 1, 100000)};
  CHECK(bench.begin(steps, 1));
  bench.run_for(2000000);
  bench.collect_events();
  CHECK(bench.triggers() == 0);
  CHECK(bench.fault(1, wire::FaultReason::kCameraNotReady));
  CHECK(bench.news(2, SequenceNews::kAborted));
}

TEST(sequencer_keeps_the_light_while_the_strobe_is_active) {
  Bench bench;
  bench.hal.board.capabilities |= wire::Capability::kStrobe;
  bench.start.require_strobe = true;
  const wire::Step steps[] = {step(0, 0, 1, 10000)};
  CHECK(bench.begin(steps, 1));
  while (bench.triggers() == 0) {
    bench.run_for(10);
  }
  bench.run_for(30);
  bench.set_input(fake::Input::kStrobe, true);
  bench.run_for(kExposureUs + 700);
  CHECK(bench.hal.leds[0] == 1000);
  bench.set_input(fake::Input::kStrobe, false);
  CHECK(bench.hal.leds[0] == 0);
  bench.collect_events();
  wire::ExposureEvent event;
  CHECK(bench.event(1, event) && event.flags == wire::ExposureFlag::kStrobeSeen);
}

TEST(sequencer_a_strobe_stuck_high_does_not_hold_the_light) {
  Bench bench;
  bench.hal.board.capabilities |= wire::Capability::kStrobe;
  bench.hal.inputs[0] = true;
  const wire::Step steps[] = {step(0, 0, 1, 10000)};
  CHECK(bench.begin(steps, 1));
  bench.run_for(200000);
  bench.collect_events();
  wire::ExposureEvent event;
  CHECK(bench.event(1, event));
  CHECK(bench.hal.led_changes.last().sum == 0);
  CHECK(bench.hal.led_changes.last().at_us ==
        event.start_us + kExposureUs + reliefscope::Sequencer::kAfterExposureUs);
}

TEST(sequencer_a_missing_strobe_is_a_fault_where_it_is_required) {
  Bench bench;
  bench.hal.board.capabilities |= wire::Capability::kStrobe;
  bench.start.require_strobe = true;
  const wire::Step steps[] = {step(0, 0, 2, 10000)};
  CHECK(bench.begin(steps, 1));
  bench.run_for(200000);
  bench.collect_events();
  CHECK(bench.triggers() == 1);
  CHECK(bench.fault(1, wire::FaultReason::kCameraNoStrobe));
  CHECK(bench.status().exposures == 0);
}

TEST(sequencer_a_late_trigger_is_a_fault) {
  Bench bench;
  bench.start.light_lead_us = 5000;
  const wire::Step steps[] = {step(0, 0, 2, 10000)};
  bench.lateness_us = reliefscope::Sequencer::kTriggerLateUs;
  CHECK(bench.begin(steps, 1));
  bench.run_for(200000);
  CHECK(bench.status().fault == wire::FaultReason::kNone && bench.status().exposures == 2);
  bench.lateness_us = reliefscope::Sequencer::kTriggerLateUs + 1;
  CHECK(bench.code<wire::StartReply>(bench.start) == ErrorCode::kOk);
  bench.run_for(200000);
  CHECK(bench.status().fault == wire::FaultReason::kTriggerLate);
  CHECK(!bench.hal.pins[2] && bench.hal.leds[0] == 0);
}

TEST(sequencer_a_pulse_may_outlast_the_exposure) {
  Bench bench;
  bench.start.trigger_us = 9000;
  const wire::Step steps[] = {step(0, 0, 2, 10000)};
  CHECK(bench.begin(steps, 1));
  bench.run_for(200000);
  bench.collect_events();
  wire::ExposureEvent first;
  wire::ExposureEvent second;
  CHECK(bench.event(1, first) && bench.event(2, second));
  CHECK(bench.hal.led_changes[1].at_us == first.start_us + kExposureUs + kTailUs);
  CHECK(second.start_us == first.start_us + 9000 + 2000 + 500);
}

TEST(sequencer_runs_the_longest_table) {
  Bench bench;
  bench.start.deadline_ms = 4000000;
  wire::StepChunkRequest chunk;
  reliefscope::Crc32 crc;
  chunk.steps_count = wire::kStepChunk;
  for (std::uint16_t first = 0; first < wire::kSteps; first += wire::kStepChunk) {
    chunk.first = first;
    for (std::uint8_t i = 0; i < wire::kStepChunk; ++i) {
      chunk.steps[i] = step(i % 2, i / 2 % 2, 1, 0);
      std::uint8_t bytes[wire::Step::kMaxSize];
      crc.add(bytes, wire::encode(chunk.steps[i], bytes));
    }
    CHECK(bench.code<wire::StepChunkReply>(chunk) == ErrorCode::kOk);
  }
  wire::CommitStepsRequest commit;
  commit.count = wire::kSteps;
  commit.crc32 = crc.value();
  bench.start.table_hash = crc.value();
  CHECK(bench.code<wire::CommitStepsReply>(commit) == ErrorCode::kOk);
  CHECK(bench.code<wire::StartReply>(bench.start) == ErrorCode::kOk);
  for (int i = 0; i < 200 && bench.status().sequence != SequenceState::kIdle; ++i) {
    bench.run_for(100000);
    bench.collect_events();
    bench.acknowledge();
  }
  CHECK(bench.status().exposures == wire::kSteps);
  CHECK(bench.counters().exposures == wire::kSteps);
  CHECK(bench.status().fault == wire::FaultReason::kNone);
}
