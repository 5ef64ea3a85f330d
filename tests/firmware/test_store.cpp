// Uploads, their CRCs, and settings in the non-volatile memory.
#include <cstring>

#include "core/settings.hpp"
#include "device.hpp"
#include "unit.hpp"

namespace {

using fake::Answer;
using fake::Device;
namespace wire = reliefscope::wire;
using wire::ErrorCode;

wire::Step step(std::uint8_t aperture, std::uint8_t light) {
  wire::Step value;
  value.aperture = aperture;
  value.light = light;
  value.repeat = 1;
  value.exposure_us = 1000;
  return value;
}

wire::GetSettingsReply named(const char* name) {
  wire::GetSettingsReply values;
  std::strncpy(values.serial_number, name, sizeof values.serial_number);
  values.contrast = 33;
  values.mounting = wire::Mounting::kTopView;
  return values;
}

}  // namespace

TEST(store_aperture_is_valid_only_after_a_right_crc) {
  Device device;
  wire::ApertureChunkRequest chunk;
  std::memset(chunk.data, 0x81, sizeof chunk.data);
  for (std::uint8_t i = 0; i < 4; ++i) {
    chunk.chunk = i;
    CHECK(device.code<wire::ApertureChunkReply>(chunk) == ErrorCode::kOk);
  }
  wire::SelectApertureRequest select;
  CHECK(device.code<wire::SelectApertureReply>(select) == ErrorCode::kSlotEmpty);
  std::uint8_t bitmap[1024];
  std::memset(bitmap, 0x81, sizeof bitmap);
  wire::CommitApertureRequest commit;
  commit.crc32 = reliefscope::crc32(bitmap, sizeof bitmap) ^ 1;
  wire::CommitApertureReply reply;
  Answer answer = device.ask(commit, reply);
  CHECK(answer.code == ErrorCode::kCrcMismatch);
  CHECK(answer.detail == (commit.crc32 ^ 1));
  commit.crc32 ^= 1;
  CHECK(device.ask(commit, reply).code == ErrorCode::kOk);
  CHECK(reply.open_pixels == 2 * 1024);
  CHECK(device.code<wire::SelectApertureReply>(select) == ErrorCode::kOk);
  // A new chunk empties the slot; the glass keeps its copy.
  chunk.chunk = 0;
  CHECK(device.code<wire::ApertureChunkReply>(chunk) == ErrorCode::kOk);
  CHECK(device.code<wire::SelectApertureReply>(select) == ErrorCode::kSlotEmpty);
}

TEST(store_built_in_slots_are_always_there) {
  Device device;
  wire::SelectApertureRequest aperture;
  aperture.slot = 255;
  wire::SelectApertureReply shut;
  CHECK(device.ask(aperture, shut).code == ErrorCode::kOk);
  const std::uint8_t zeros[1024] = {};
  CHECK(shut.crc32 == reliefscope::crc32(zeros, sizeof zeros));
  wire::SelectLightRequest light;
  light.slot = 255;
  CHECK(device.code<wire::SelectLightReply>(light) == ErrorCode::kOk);
}

TEST(store_light_is_refused_beyond_the_budget_or_the_board) {
  Device device;  // budget: eight LEDs at full level; sixteen LEDs
  wire::LoadLightRequest light;
  light.levels_count = 9;
  for (int i = 0; i < 9; ++i) {
    light.levels[i] = 4095;
  }
  wire::LoadLightReply reply;
  Answer answer = device.ask(light, reply);
  CHECK(answer.code == ErrorCode::kCurrentBudget && answer.detail == 9 * 4095);
  light.levels[8] = 0;
  CHECK(device.ask(light, reply).code == ErrorCode::kOk && reply.level_sum == 8 * 4095);
  light.levels_count = 20;
  CHECK(device.ask(light, reply).code == ErrorCode::kOk);
  light.levels[0] = 0;
  light.levels[19] = 1;
  CHECK(device.ask(light, reply).code == ErrorCode::kOutOfRange);
}

TEST(store_table_needs_its_slots_its_crc_and_the_on_time_limit) {
  Device device;  // on-time limit 2 s
  wire::Step steps[2] = {step(0, 0), step(255, 255)};
  CHECK(device.load_steps(steps, 2) == ErrorCode::kSlotEmpty);
  CHECK(device.load_aperture(0, 0x0F) == ErrorCode::kOk);
  CHECK(device.load_light(0, 3, 1000) == ErrorCode::kOk);
  CHECK(device.load_steps(steps, 2) == ErrorCode::kOk);
  steps[0].exposure_us = 2000000;
  CHECK(device.load_steps(steps, 2) == ErrorCode::kOnTimeLimit);
  steps[0].exposure_us = 1000;
  steps[1].exposure_us = 2000000;  // dark: no limit
  CHECK(device.load_steps(steps, 2) == ErrorCode::kOk);
  wire::CommitStepsRequest commit;
  commit.count = 1;  // another count, so another CRC
  commit.crc32 = device.start.table_hash;
  CHECK(device.code<wire::CommitStepsReply>(commit) == ErrorCode::kCrcMismatch);
}

TEST(store_table_never_holds_a_step_that_was_not_written) {
  Device device;
  wire::CommitStepsRequest commit;
  commit.count = 1;
  const std::uint8_t zeros[wire::Step::kMaxSize] = {};
  commit.crc32 = reliefscope::crc32(zeros, sizeof zeros);  // right for an empty step
  CHECK(device.load_aperture(0, 0x0F) == ErrorCode::kOk);
  CHECK(device.load_light(0, 3, 1000) == ErrorCode::kOk);
  CHECK(device.code<wire::CommitStepsReply>(commit) == ErrorCode::kCrcMismatch);
}

TEST(store_a_changed_slot_voids_the_table_that_names_it) {
  Device device;
  const wire::Step steps[1] = {step(0, 0)};
  CHECK(device.load_aperture(0, 0x0F) == ErrorCode::kOk);
  CHECK(device.load_light(0, 3, 1000) == ErrorCode::kOk);
  CHECK(device.load_steps(steps, 1) == ErrorCode::kOk);
  CHECK(device.load_light(1, 3, 1000) == ErrorCode::kOk);
  CHECK(device.load_aperture(1, 0x0F) == ErrorCode::kOk);
  CHECK(device.status().table_hash == device.start.table_hash);
  CHECK(device.load_light(0, 3, 1000) == ErrorCode::kOk);
  CHECK(device.status().table_hash == 0);
  CHECK(device.code<wire::StartReply>(device.start) == ErrorCode::kNoTable);
  CHECK(device.load_steps(steps, 1) == ErrorCode::kOk);
  CHECK(device.load_aperture(0, 0x0F) == ErrorCode::kOk);
  CHECK(device.code<wire::StartReply>(device.start) == ErrorCode::kNoTable);
}

TEST(store_table_ends_where_it_ends) {
  Device device;
  wire::StepChunkRequest chunk;
  chunk.first = 1020;
  chunk.steps_count = 5;
  for (wire::Step& value : chunk.steps) {
    value = step(255, 255);
  }
  CHECK(device.code<wire::StepChunkReply>(chunk) == ErrorCode::kOutOfRange);
  chunk.steps_count = 4;
  CHECK(device.code<wire::StepChunkReply>(chunk) == ErrorCode::kOk);
}

TEST(settings_of_an_erased_memory_are_the_defaults) {
  Device device;
  wire::GetSettingsReply reply;
  CHECK(device.ask(wire::GetSettingsRequest{}, reply).code == ErrorCode::kOk);
  CHECK(reply.serial_number[0] == 0);
  CHECK(reply.glass_variant == wire::GlassVariant::kSFstnNegative);
  CHECK(reply.contrast == 22 && reply.resistor_ratio == 7);
}

TEST(settings_are_stored_and_set_the_glass_up_again) {
  Device device;
  device.run_for(10000);
  device.hal.spi.clear();
  wire::SetSettingsRequest request;
  std::strncpy(request.serial_number, "RS-0007", sizeof request.serial_number);
  request.glass_variant = wire::GlassVariant::kWFstnPositive;
  request.mounting = wire::Mounting::kTopView;
  request.contrast = 50;
  request.resistor_ratio = 6;
  wire::SetSettingsReply reply;
  CHECK(device.ask(request, reply).code == ErrorCode::kOk && reply.contrast == 50);
  device.run_for(10000);
  CHECK(device.hal.spi[0].bytes[0] == 0xA5);  // clear when off: all points on shuts
  CHECK(device.hal.spi[1].bytes[1] == 0xA0);

  reliefscope::Settings settings(device.hal);
  settings.load();
  CHECK(std::strcmp(settings.get().serial_number, "RS-0007") == 0);
  CHECK(settings.get().mounting == wire::Mounting::kTopView);
  wire::HelloReply hello;
  CHECK(device.ask(wire::HelloRequest{}, hello).any);
  CHECK(std::strcmp(hello.serial_number, "RS-0007") == 0);
}

TEST(settings_survive_a_power_cut_at_every_byte_of_a_write) {
  for (std::size_t cut = 0; cut < 40; ++cut) {
    fake::Hal hal;
    reliefscope::Settings settings(hal);
    settings.load();
    CHECK(settings.set(named("OLD")));
    hal.writes = 0;
    hal.writes_until_cut = cut;
    const bool kept = settings.set(named("NEW"));
    reliefscope::Settings after(hal);
    after.load();
    CHECK(std::strcmp(after.get().serial_number, kept ? "NEW" : "OLD") == 0);
    CHECK(std::strcmp(settings.get().serial_number, kept ? "NEW" : "OLD") == 0);
    CHECK(after.get().contrast == 33);
  }
}

TEST(settings_of_the_leds_are_stored_beside_the_others) {
  Device device;
  wire::GetLedCorrectionReply found;
  CHECK(device.ask(wire::GetLedCorrectionRequest{}, found).code == ErrorCode::kOk);
  CHECK(found.factors[0] == 255 && found.factors[47] == 255);
  wire::SetLedCorrectionRequest request;
  for (std::size_t i = 0; i < sizeof request.factors; ++i) {
    request.factors[i] = static_cast<std::uint8_t>(200 + i);
  }
  wire::SetLedCorrectionReply reply;
  CHECK(device.ask(request, reply).code == ErrorCode::kOk && reply.factors[3] == 203);
  wire::SetSettingsRequest other;
  other.contrast = 9;
  CHECK(device.code<wire::SetSettingsReply>(other) == ErrorCode::kOk);
  reliefscope::Settings settings(device.hal);
  settings.load();
  settings.load();
  CHECK(settings.get().contrast == 9);
  CHECK(settings.led_correction().factors[47] == 247);
}

TEST(settings_of_the_leds_survive_a_power_cut_at_every_byte_of_a_write) {
  for (std::size_t cut = 0; cut < 60; ++cut) {
    fake::Hal hal;
    reliefscope::Settings settings(hal);
    settings.load();
    wire::GetLedCorrectionReply values;
    std::memset(values.factors, 100, sizeof values.factors);
    CHECK(settings.set(values));
    hal.writes = 0;
    hal.writes_until_cut = cut;
    std::memset(values.factors, 200, sizeof values.factors);
    const bool kept = settings.set(values);
    CHECK(kept == (cut >= 57));
    reliefscope::Settings after(hal);
    after.load();
    for (const std::uint8_t factor : after.led_correction().factors) {
      CHECK(factor == (kept ? 200 : 100));
    }
  }
}

TEST(settings_alternate_banks_and_find_the_newest) {
  fake::Hal hal;
  reliefscope::Settings settings(hal);
  settings.load();
  char name[] = "A";
  for (int i = 0; i < 9; ++i) {
    name[0] = static_cast<char>('A' + i);
    CHECK(settings.set(named(name)));
    reliefscope::Settings after(hal);
    after.load();
    CHECK(std::strcmp(after.get().serial_number, name) == 0);
  }
  // The newest bank spoiled: the one before holds.
  for (std::size_t i = 0; i < 256; ++i) {
    hal.memory[i] = 0;
  }
  reliefscope::Settings after(hal);
  after.load();
  CHECK(std::strcmp(after.get().serial_number, "H") == 0);
}

TEST(settings_that_do_not_stay_are_a_failure) {
  Device device;
  device.hal.writes_until_cut = 3;
  wire::SetSettingsRequest request;
  request.contrast = 1;
  CHECK(device.code<wire::SetSettingsReply>(request) == ErrorCode::kSettingsWrite);
  wire::GetSettingsReply reply;
  CHECK(device.ask(wire::GetSettingsRequest{}, reply).any && reply.contrast == 22);
}
