// ST7565R driver: what goes out on SPI, in which order, and when.
#include <cstring>
#include <initializer_list>

#include "core/display.hpp"
#include "fake_hal.hpp"
#include "unit.hpp"

namespace {

using reliefscope::Display;
using reliefscope::DisplayConfig;

constexpr DisplayConfig kNegativeBottom = {true, false, 22, 7};
constexpr DisplayConfig kPositiveTop = {false, true, 40, 5};

// Replays the controller's RAM from the SPI log.
struct Controller {
  std::uint8_t ram[9][132] = {};
  std::uint8_t page = 0;
  std::uint8_t column = 0;

  void replay(const fake::Hal& hal) {
    for (std::size_t i = 0; i < hal.spi.size(); ++i) {
      const fake::SpiRecord& record = hal.spi[i];
      for (std::size_t k = 0; k < record.count; ++k) {
        const std::uint8_t byte = record.bytes[k];
        if (record.data) {
          ram[page][column] = byte;
          column = static_cast<std::uint8_t>(column < 131 ? column + 1 : 131);
        } else if ((byte & 0xF0) == 0xB0) {
          page = byte & 0x0F;
        } else if ((byte & 0xF0) == 0x10) {
          column = static_cast<std::uint8_t>((column & 0x0F) | (byte & 0x0F) << 4);
        } else if ((byte & 0xF0) == 0x00) {
          column = static_cast<std::uint8_t>((column & 0xF0) | (byte & 0x0F));
        }
      }
    }
  }
};

// Runs until idle; time passes as SPI and resets need it.
void settle(fake::Hal& hal, Display& display) {
  for (int i = 0; i < 1000 && !display.idle(); ++i) {
    if (!display.poll()) {
      hal.now = hal.spi_busy() ? hal.spi_free : display.next_wakeup_us();
    }
  }
}

bool sent(const fake::SpiRecord& record, const std::uint8_t* bytes, std::size_t count) {
  return !record.data && record.count == count && std::memcmp(record.bytes, bytes, count) == 0;
}

void fill(std::uint8_t* bitmap) {
  for (std::size_t i = 0; i < reliefscope::kBitmapBytes; ++i) {
    bitmap[i] = static_cast<std::uint8_t>(i * 7 + i / 128);
  }
}

}  // namespace

TEST(display_shuts_first_then_sets_up_glass_that_is_dark_when_off) {
  fake::Hal hal;
  Display display(hal);
  display.begin(kNegativeBottom);
  settle(hal, display);
  const std::uint8_t shut[] = {0xAE};
  const std::uint8_t init[] = {0x40, 0xA1, 0xC0, 0xA6, 0xA2, 0x2F, 0xF8,
                               0x00, 0x27, 0x81, 0x16, 0xAC, 0x00};
  const std::uint8_t address[] = {0xB0, 0x10, 0x00};
  const std::uint8_t release[] = {0xAF, 0xA4};
  CHECK(display.idle());
  CHECK(hal.spi.size() == 2 + 8 * 3 + 1);
  CHECK(sent(hal.spi[0], shut, sizeof shut));
  CHECK(sent(hal.spi[1], init, sizeof init));
  CHECK(sent(hal.spi[2], address, sizeof address));
  CHECK(sent(hal.spi[hal.spi.size() - 1], release, sizeof release));
}

TEST(display_shuts_first_then_sets_up_glass_that_is_clear_when_off) {
  fake::Hal hal;
  Display display(hal);
  display.begin(kPositiveTop);
  settle(hal, display);
  const std::uint8_t shut[] = {0xA5};
  const std::uint8_t init[] = {0x40, 0xA0, 0xC8, 0xA7, 0xA2, 0x2F, 0xF8,
                               0x00, 0x25, 0x81, 40,   0xAC, 0x00};
  const std::uint8_t address[] = {0xB0, 0x10, 0x04};
  CHECK(sent(hal.spi[0], shut, sizeof shut));
  CHECK(sent(hal.spi[1], init, sizeof init));
  CHECK(sent(hal.spi[2], address, sizeof address));
}

TEST(display_resets_the_controller_before_it_talks) {
  fake::Hal hal;
  hal.pins[0] = true;
  hal.now = 500;
  Display display(hal);
  display.begin(kNegativeBottom);
  settle(hal, display);
  CHECK(hal.edges[0].pin == fake::Pin::kLcdReset && !hal.edges[0].high);
  CHECK(hal.edges[1].pin == fake::Pin::kLcdReset && hal.edges[1].high);
  CHECK(hal.edges[1].at_us - hal.edges[0].at_us >= 1000);
  CHECK(hal.spi[0].at_us - hal.edges[1].at_us >= 1000);
  for (std::size_t i = 0; i < hal.spi.size(); ++i) {
    CHECK(hal.spi[i].selected);
    CHECK(hal.spi[i].count <= reliefscope::kSpiChunk);
  }
  CHECK(hal.pins[1]);  // released when done
}

TEST(display_writes_every_byte_to_its_place_in_both_mountings) {
  std::uint8_t bitmap[reliefscope::kBitmapBytes];
  fill(bitmap);
  for (const DisplayConfig& config : {kNegativeBottom, kPositiveTop}) {
    fake::Hal hal;
    Display display(hal);
    display.begin(config);
    settle(hal, display);
    hal.spi.clear();
    display.show(bitmap);
    settle(hal, display);
    Controller controller;
    controller.replay(hal);
    const std::size_t offset = config.top_view ? 4 : 0;
    for (std::size_t page = 0; page < 8; ++page) {
      CHECK(std::memcmp(controller.ram[page] + offset, bitmap + page * 128, 128) == 0);
    }
    // 1,024 bytes, 3 for each page's address, 2 to release: 2.1 ms at 4 MHz.
    CHECK(display.idle_since_us() - hal.spi[0].at_us == 2 * (1024 + 8 * 3 + 2));
  }
}

TEST(display_owns_a_copy_of_what_it_shows) {
  fake::Hal hal;
  Display display(hal);
  display.begin(kNegativeBottom);
  settle(hal, display);
  hal.spi.clear();
  std::uint8_t bitmap[reliefscope::kBitmapBytes];
  std::memset(bitmap, 0x5A, sizeof bitmap);
  display.show(bitmap);
  std::memset(bitmap, 0xFF, sizeof bitmap);
  settle(hal, display);
  Controller controller;
  controller.replay(hal);
  CHECK(controller.ram[7][127] == 0x5A);
}

TEST(display_shut_overtakes_a_bitmap_at_the_next_chunk) {
  fake::Hal hal;
  Display display(hal);
  display.begin(kNegativeBottom);
  settle(hal, display);
  hal.spi.clear();
  std::uint8_t bitmap[reliefscope::kBitmapBytes];
  std::memset(bitmap, 0xFF, sizeof bitmap);
  display.show(bitmap);
  for (int i = 0; i < 9; ++i) {
    display.poll();
    hal.now = hal.spi_free;
  }
  const std::size_t before = hal.spi.size();
  const std::uint64_t asked = hal.now;
  display.shut();
  settle(hal, display);
  const std::uint8_t shut[] = {0xAE};
  CHECK(sent(hal.spi[before], shut, 1));
  CHECK(hal.spi[before].at_us - asked <= 2 * reliefscope::kSpiChunk);
  Controller controller;
  controller.replay(hal);
  const std::uint8_t closed[128] = {};
  for (std::size_t page = 0; page < 8; ++page) {
    CHECK(std::memcmp(controller.ram[page], closed, 128) == 0);
  }
}

TEST(display_asked_during_reset_shows_the_last_bitmap) {
  fake::Hal hal;
  Display display(hal);
  display.begin(kNegativeBottom);
  std::uint8_t bitmap[reliefscope::kBitmapBytes];
  std::memset(bitmap, 0x11, sizeof bitmap);
  display.show(bitmap);
  std::memset(bitmap, 0x22, sizeof bitmap);
  display.show(bitmap);
  settle(hal, display);
  const std::uint8_t shut[] = {0xAE};
  CHECK(sent(hal.spi[0], shut, 1));
  Controller controller;
  controller.replay(hal);
  CHECK(controller.ram[0][0] == 0x22 && controller.ram[7][127] == 0x22);
}

TEST(display_new_settings_shut_set_up_and_show_again) {
  fake::Hal hal;
  Display display(hal);
  display.begin(kNegativeBottom);
  std::uint8_t bitmap[reliefscope::kBitmapBytes];
  std::memset(bitmap, 0x33, sizeof bitmap);
  display.show(bitmap);
  settle(hal, display);
  hal.spi.clear();
  DisplayConfig config = kNegativeBottom;
  config.contrast = 63;
  display.configure(config);
  settle(hal, display);
  CHECK(hal.spi[0].bytes[0] == 0xAE);
  CHECK(hal.spi[1].bytes[9] == 0x81 && hal.spi[1].bytes[10] == 63);
  Controller controller;
  controller.replay(hal);
  CHECK(controller.ram[3][64] == 0x33);
}
