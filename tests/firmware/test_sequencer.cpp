// Sequences in virtual time: order and times of glass, light and trigger, and their events.
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
    if (edges[i].pin == fake::Pin::kCameraTrigger && edges[i].high) {
      CHECK(found < 2);
      rise[found++] = i;
      CHECK(edges[i + 1].pin == fake::Pin::kCameraTrigger && !edges[i + 1].high);
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
