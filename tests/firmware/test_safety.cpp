// What the device does for safety without being asked.
#include "core/leds.hpp"
#include "device.hpp"
#include "unit.hpp"

namespace {

using fake::Device;
namespace wire = reliefscope::wire;
using wire::ErrorCode;
using wire::FaultReason;

// A light on by hand.
struct Lit : Device {
  Lit() {
    run_for(10000);
    load_aperture(0, 0xFF);
    load_light(0, 2, 3000);
    code<wire::SelectApertureReply>(wire::SelectApertureRequest{});
    code<wire::SelectLightReply>(wire::SelectLightRequest{});
    run_for(10000);
  }
  bool dark() const {
    for (const std::uint16_t level : hal.leds) {
      if (level != 0) {
        return false;
      }
    }
    return true;
  }
};

}  // namespace

TEST(safety_leds_are_off_before_anything_else_after_reset) {
  fake::Hal hal;
  hal.leds[4] = 4095;  // as the reset found it
  reliefscope::Core core(hal);
  core.begin(wire::ResetCause::kWatchdog, fake::kNonce);
  CHECK(hal.led_changes.size() == 1 && hal.led_changes[0].sum == 0);
  CHECK(hal.led_changes[0].at_us == 0);
  CHECK(hal.leds[4] == 0 && !hal.pins[2]);
}

TEST(safety_leds_take_no_set_beyond_the_budget_whoever_asks) {
  fake::Hal hal;
  reliefscope::Leds leds(hal);
  leds.begin();
  std::uint16_t levels[reliefscope::kMaxLeds] = {};
  for (int i = 0; i < 9; ++i) {
    levels[i] = 4095;
  }
  CHECK(!leds.set(levels));
  CHECK(!leds.lit() && hal.leds[0] == 0);
  levels[8] = 0;
  CHECK(leds.set(levels));
  CHECK(leds.level_sum() == hal.board.level_budget);
}

TEST(safety_a_correction_lowers_the_current_of_its_led) {
  Device device;
  wire::SetLedCorrectionRequest request;
  std::memset(request.factors, 255, sizeof request.factors);
  request.factors[2] = 127;
  CHECK(device.code<wire::SetLedCorrectionReply>(request) == ErrorCode::kOk);
  wire::LoadLightRequest both;
  both.levels_count = 4;
  both.levels[2] = 3001;
  both.levels[3] = 4095;
  CHECK(device.code<wire::LoadLightReply>(both) == ErrorCode::kOk);
  wire::SelectLightReply reply;
  CHECK(device.ask(wire::SelectLightRequest{}, reply).code == ErrorCode::kOk);
  CHECK(device.hal.leds[2] == 1500 && device.hal.leds[3] == 4095);
  CHECK(reply.level_sum == 7096);  // what was asked for is what the budget counts
}

TEST(safety_an_exposure_is_whole_periods_of_pulsing_drivers) {
  Lit device;
  device.hal.board.led_period_us = 500;
  wire::LimitsReply limits;
  CHECK(device.ask(wire::LimitsRequest{}, limits).any && limits.led_period_us == 500);
  wire::Step steps[2];
  for (wire::Step& step : steps) {
    step.repeat = 1;
    step.exposure_us = 4000;
  }
  CHECK(device.load_steps(steps, 2) == ErrorCode::kOk);
  steps[1].exposure_us = 4250;
  CHECK(device.load_steps(steps, 2) == ErrorCode::kLedPeriod);
  steps[1].light = 255;  // in the dark nothing beats
  CHECK(device.load_steps(steps, 2) == ErrorCode::kOk);
}

TEST(safety_a_level_that_the_drivers_cannot_make_is_refused) {
  Device device;
  device.hal.board.led_level_step = 4095;
  CHECK(device.load_light(0, 3, 4095) == ErrorCode::kOk);
  CHECK(device.load_light(0, 3, 2000) == ErrorCode::kLedLevelStep);
  CHECK(device.load_light(0, 3, 0) == ErrorCode::kOk);
}

TEST(safety_the_link_may_be_silent_for_two_seconds) {
  Lit device;
  device.hal.board.led_on_time_us = 60000000;
  CHECK(device.code<wire::SelectLightReply>(wire::SelectLightRequest{}) == ErrorCode::kOk);
  CHECK(!device.dark());
  device.status();
  const std::uint64_t heard = device.hal.now;
  device.run_until(heard + 1999999);
  CHECK(!device.dark());
  device.run_until(heard + 2000000);
  CHECK(device.dark());
  CHECK(device.counters().link_timeouts == 1);
  CHECK(device.status().light == 255 && device.status().fault == FaultReason::kNone);
}

TEST(safety_garbage_is_silence) {
  Lit device;
  device.hal.board.led_on_time_us = 60000000;
  const std::uint8_t garbage[] = {5, 1, 2, 3, 0, 200, 1, 0};
  for (int i = 0; i < 30; ++i) {
    device.hal.feed(garbage, sizeof garbage);
    device.run_for(100000);
  }
  CHECK(device.dark());
}

TEST(safety_a_led_is_cut_off_after_its_on_time) {
  Lit device;  // 2 s
  const std::uint64_t lit = device.hal.led_changes.last().at_us;
  while (device.hal.now < lit + 1950000) {
    device.status();
    device.run_for(10000);
  }
  CHECK(!device.dark());
  device.run_until(lit + 2000000);
  CHECK(device.dark());
  CHECK(device.status().fault == FaultReason::kLedOnTime);
  device.collect_events();
  wire::FaultEvent event;
  CHECK(device.event(device.events.size() - 1, event));
  CHECK(event.reason == FaultReason::kLedOnTime && event.at_us == lit + 2000000);
}

TEST(safety_selecting_a_light_again_does_not_extend_its_on_time) {
  Lit device;
  const std::uint64_t lit = device.hal.led_changes.last().at_us;
  while (device.hal.now < lit + 1950000) {
    CHECK(device.code<wire::SelectLightReply>(wire::SelectLightRequest{}) == ErrorCode::kOk);
    device.run_for(10000);
  }
  device.run_until(lit + 2000000);
  CHECK(device.dark());
}

TEST(safety_on_time_is_counted_per_led) {
  Lit device;
  wire::LoadLightRequest both;
  both.slot = 1;
  both.levels_count = 4;
  both.levels[2] = 3000;
  both.levels[3] = 100;
  CHECK(device.code<wire::LoadLightReply>(both) == ErrorCode::kOk);
  const std::uint64_t first = device.hal.led_changes.last().at_us;
  device.run_for(1000000);
  wire::SelectLightRequest select;
  select.slot = 1;
  CHECK(device.code<wire::SelectLightReply>(select) == ErrorCode::kOk);
  device.run_until(first + 1999999);
  CHECK(!device.dark());
  device.run_until(first + 2000000);
  CHECK(device.dark());
}

TEST(safety_a_fault_is_dark_shut_and_latched) {
  Lit device;
  device.hal.spi.clear();
  for (int i = 0; i < 25; ++i) {
    device.run_for(100000);
    device.status();
  }
  CHECK(device.dark());
  CHECK(device.hal.spi.size() > 0 && device.hal.spi[0].bytes[0] == 0xAE);
  CHECK(device.status().aperture == 255);
  CHECK(device.code<wire::SelectLightReply>(wire::SelectLightRequest{}) ==
        ErrorCode::kFaultLatched);
  CHECK(device.code<wire::SelectApertureReply>(wire::SelectApertureRequest{}) ==
        ErrorCode::kFaultLatched);
  wire::SelectLightRequest off;
  off.slot = 255;
  CHECK(device.code<wire::SelectLightReply>(off) == ErrorCode::kOk);
  wire::ClearFaultRequest clear;
  clear.reason = FaultReason::kTriggerLate;  // not the one that is latched
  wire::ClearFaultReply reply;
  CHECK(device.ask(clear, reply).code == ErrorCode::kOk && reply.fault == FaultReason::kLedOnTime);
  clear.reason = FaultReason::kLedOnTime;
  CHECK(device.ask(clear, reply).code == ErrorCode::kOk && reply.fault == FaultReason::kNone);
  CHECK(device.code<wire::SelectLightReply>(wire::SelectLightRequest{}) == ErrorCode::kOk);
  CHECK(device.counters().faults == 1);
}

TEST(safety_all_off_works_at_any_time) {
  Lit device;
  wire::AllOffReply reply;
  CHECK(device.ask(wire::AllOffRequest{}, reply).code == ErrorCode::kOk);
  CHECK(device.dark());
  CHECK(device.status().light == 255);
  CHECK(device.ask(wire::AllOffRequest{}, reply).code == ErrorCode::kOk);
}

TEST(safety_a_hot_chip_is_a_fault_that_comes_back) {
  Lit device;
  device.hal.board.capabilities |= wire::Capability::kTemperature;
  CHECK(device.status().temperature_centi == 2500);
  device.hal.temperature = 8600;
  device.run_for(1000000);
  CHECK(device.dark() && device.status().fault == FaultReason::kOverTemperature);
  wire::ClearFaultRequest clear;
  clear.reason = FaultReason::kOverTemperature;
  wire::ClearFaultReply reply;
  device.ask(clear, reply);
  device.run_for(1000000);
  CHECK(device.status().fault == FaultReason::kOverTemperature);
  device.hal.temperature = 4000;
  device.ask(clear, reply);
  device.run_for(2000000);
  CHECK(device.status().fault == FaultReason::kNone);
}

TEST(safety_a_full_event_queue_still_tells_the_fault) {
  Lit device;
  wire::PauseReply paused;
  wire::ResumeReply resumed;
  wire::Step step;
  step.aperture = 255;
  step.light = 255;
  step.repeat = 1;
  step.settle_us = 60000000;
  step.exposure_us = 1000;
  CHECK(device.load_steps(&step, 1) == ErrorCode::kOk);
  CHECK(device.code<wire::StartReply>(device.start) == ErrorCode::kOk);
  wire::PauseRequest pause;
  pause.run_id = 7;
  wire::ResumeRequest resume;
  resume.run_id = 7;
  for (int i = 0; i < 40 && device.status().fault == FaultReason::kNone; ++i) {
    device.ask(pause, paused);
    device.ask(resume, resumed);
  }
  device.collect_events();
  const wire::StatusReply status = device.status();
  CHECK(status.fault == FaultReason::kEventsLost);
  CHECK(status.sequence == wire::SequenceState::kIdle);
  CHECK(status.next_event - status.oldest_event == wire::kEventQueue);
  wire::FaultEvent event;
  CHECK(device.event(device.events.size() - 1, event));
  CHECK(event.reason == FaultReason::kEventsLost);
}

TEST(safety_the_watchdog_is_fed_by_the_main_loop) {
  Device device;
  const std::uint32_t before = device.hal.kicks;
  device.run_for(100000);
  CHECK(device.hal.kicks > before);
}

TEST(safety_bootloader_request_ends_a_sequence_dark) {
  Lit device;
  wire::Step step;
  step.repeat = 100;
  step.exposure_us = 100000;
  CHECK(device.load_steps(&step, 1) == ErrorCode::kOk);
  CHECK(device.code<wire::StartReply>(device.start) == ErrorCode::kOk);
  device.run_for(20000);
  CHECK(!device.dark());
  wire::EnterBootloaderRequest request;
  request.magic = wire::kBootloaderMagic;
  CHECK(device.code<wire::EnterBootloaderReply>(request) == ErrorCode::kOk);
  CHECK(device.dark() && device.status().sequence == wire::SequenceState::kIdle);
}
