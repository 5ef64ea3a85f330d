// What stops a sequence, for good or for a while: pause, abort, the host, the camera, time.
#include "bench.hpp"
#include "unit.hpp"

namespace {

using fake::Bench;
using fake::kExposureUs;
using fake::kTailUs;
using fake::step;
namespace wire = reliefscope::wire;
using wire::ErrorCode;
using wire::SequenceNews;
using wire::SequenceState;

}  // namespace
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
