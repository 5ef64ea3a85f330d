// The core on a Teensy 3.2: HAL over the Arduino framework and a few registers of the MK20DX256.
#include <Arduino.h>
#include <SPI.h>
#include <avr/eeprom.h>

#include "boards/teensy31/board.hpp"
#include "boards/teensy31/leds.hpp"
#include "core/core.hpp"
#include "core/identity.hpp"

namespace {

namespace wire = reliefscope::wire;
using reliefscope::BoardInfo;
using reliefscope::Core;
using reliefscope::Input;
using reliefscope::kNever;
using reliefscope::Pin;

extern const reliefscope::Identity kIdentity = reliefscope::make_identity("teensy31");

constexpr bool kPulsed = teensy31::kLedDriver == teensy31::LedDriver::kTlc5940Chain;
constexpr std::uint16_t kFullLevel = reliefscope::kLedLevelMax;
constexpr BoardInfo kInfo = {
    kIdentity.board,
    wire::Capability::kStrobe | wire::Capability::kReady | wire::Capability::kTemperature |
        wire::Capability::kBootloader,
    teensy31::kLeds,
    teensy31::kBudgetMilliamperes * kFullLevel / teensy31::kLedMilliamperes,
    teensy31::kLedOnTimeUs,
    teensy31::kResetMs,
    kPulsed ? teensy31::kLedPeriodUs : 0,
    kPulsed ? std::uint16_t{1} : kFullLevel};

constexpr std::size_t kMemorySize = 2048;
// Behind the core's settings: how often the board started.
constexpr std::size_t kBootCountAt = 2040;
constexpr std::uint32_t kTicksPerUs = F_BUS / 1000000;
// Longest deadline that is set at once; a later one is set again on the way.
constexpr std::uint64_t kLongestWaitUs = 10000000;
constexpr std::uint32_t kSpiFifo = 4;
// The deadline and the camera's lines; USB (112) and the tick (32 on this core) do not matter to it
// as long as they are lower: the tick alone is higher and takes less than a microsecond.
constexpr std::uint8_t kCorePriority = 48;
// Internal sensor, after the MK20DX256's data sheet: 719 mV at 25 degrees, 1.715 mV a degree less.
constexpr int kTemperatureChannel = 38;
constexpr std::int32_t kSupplyMillivolts = 3300;

class TeensyBoard final : public reliefscope::Hal {
 public:
  void begin() {
    leds_.begin();
    pinMode(teensy31::kCameraTrigger, OUTPUT);
    digitalWriteFast(teensy31::kCameraTrigger, LOW);
    pinMode(teensy31::kLcdReset, OUTPUT);
    digitalWriteFast(teensy31::kLcdReset, LOW);
    pinMode(teensy31::kLcdSelect, OUTPUT);
    digitalWriteFast(teensy31::kLcdSelect, HIGH);
    pinMode(teensy31::kLcdA0, OUTPUT);
    pinMode(teensy31::kCameraStrobe, INPUT);
    pinMode(teensy31::kCameraReady, INPUT);
    SPI.begin();
    SPI.beginTransaction(SPISettings(teensy31::kLcdClockHz, MSBFIRST, SPI_MODE0));
    SPI0_MCR |= SPI_MCR_CLR_RXF | SPI_MCR_CLR_TXF;
    analogReadResolution(12);
    SIM_SCGC6 |= SIM_SCGC6_PIT;
    PIT_MCR = 0;
    start_watchdog();
  }

  std::uint32_t next_boot() {
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < sizeof count; ++i) {
      count |= std::uint32_t{nonvolatile_read(kBootCountAt + i)} << (8 * i);
    }
    ++count;
    for (std::size_t i = 0; i < sizeof count; ++i) {
      nonvolatile_write(kBootCountAt + i, static_cast<std::uint8_t>(count >> (8 * i)));
    }
    // An odd factor keeps numbers apart, and makes those of two boards look different.
    const std::uint32_t nonce = (count ^ SIM_UIDL) * 2654435761u;
    return nonce == 0 ? 1 : nonce;
  }

  // True: the core's deadline.
  bool on_deadline() {
    PIT_TCTRL3 = 0;
    PIT_TFLG3 = PIT_TFLG_TIF;
    if (now_us() < deadline_us_) {
      arm_timer(deadline_us_);
      return false;
    }
    return deadline_us_ != kNever;
  }

  void blank() { leds_.blank(); }

  // Hal
  const BoardInfo& info() const override { return kInfo; }

  std::uint64_t now_us() override {
    const std::uint32_t state = lock_interrupts();
    const std::uint32_t now = micros();
    now_us_ += now - last_micros_;
    last_micros_ = now;
    const std::uint64_t result = now_us_;
    restore_interrupts(state);
    return result;
  }

  void arm_timer(std::uint64_t at_us) override {
    const std::uint32_t state = lock_interrupts();
    deadline_us_ = at_us;
    PIT_TCTRL3 = 0;
    PIT_TFLG3 = PIT_TFLG_TIF;
    if (at_us != kNever) {
      const std::uint64_t now = now_us();
      std::uint64_t wait = at_us > now ? at_us - now : 0;
      wait = wait < kLongestWaitUs ? wait : kLongestWaitUs;
      const auto ticks = static_cast<std::uint32_t>(wait) * kTicksPerUs;
      PIT_LDVAL3 = ticks == 0 ? 1 : ticks;
      PIT_TCTRL3 = PIT_TCTRL_TIE | PIT_TCTRL_TEN;
    }
    restore_interrupts(state);
  }

  void spi_start(bool a0_high, const std::uint8_t* bytes, std::size_t count) override {
    digitalWriteFast(teensy31::kLcdA0, a0_high ? HIGH : LOW);
    for (std::size_t i = 0; i < count; ++i) {
      spi_[i] = bytes[i];
    }
    spi_count_ = count;
    spi_pushed_ = 0;
    spi_done_ = 0;
    spi_busy();
  }
  // Fills the FIFO: the main loop asks in every turn. A byte has left when one has come in.
  bool spi_busy() override {
    while ((SPI0_SR & kReceivedMask) != 0) {
      static_cast<void>(SPI0_POPR);
      ++spi_done_;
    }
    while (spi_pushed_ < spi_count_ && spi_pushed_ - spi_done_ < kSpiFifo) {
      SPI0_PUSHR = spi_[spi_pushed_++] | SPI_PUSHR_CTAS(0);
    }
    return spi_done_ < spi_count_;
  }

  void set_pin(Pin pin, bool high) override {
    switch (pin) {
      case Pin::kLcdReset:
        digitalWriteFast(teensy31::kLcdReset, high ? HIGH : LOW);
        break;
      case Pin::kLcdSelect:
        digitalWriteFast(teensy31::kLcdSelect, high ? HIGH : LOW);
        break;
      case Pin::kCameraTrigger:
        digitalWriteFast(teensy31::kCameraTrigger, high ? HIGH : LOW);
        break;
    }
  }
  bool input_level(Input input) override {
    return (input == Input::kStrobe ? digitalReadFast(teensy31::kCameraStrobe)
                                    : digitalReadFast(teensy31::kCameraReady)) != 0;
  }
  void set_leds(const std::uint16_t* levels, std::size_t count) override {
    leds_.set(levels, count);
  }

  std::size_t serial_read(std::uint8_t* bytes, std::size_t capacity) override {
    std::size_t count = 0;
    while (count < capacity && Serial.available() > 0) {
      bytes[count++] = static_cast<std::uint8_t>(Serial.read());
    }
    return count;
  }
  // Never more than there is room for: a write without a reader would wait.
  std::size_t serial_write(const std::uint8_t* bytes, std::size_t count) override {
    const int room = Serial.availableForWrite();
    if (room <= 0) {
      return 0;
    }
    const std::size_t wanted = count < static_cast<std::size_t>(room) ? count : room;
    const std::size_t taken = Serial.write(bytes, wanted);
    if (taken == count) {
      Serial.send_now();
    }
    return taken;
  }

  std::uint8_t nonvolatile_read(std::size_t address) override {
    return address < kMemorySize ? eeprom_read_byte(eeprom(address)) : 0xFF;
  }
  void nonvolatile_write(std::size_t address, std::uint8_t value) override {
    if (address < kMemorySize) {
      eeprom_write_byte(eeprom(address), value);
    }
  }

  std::int16_t temperature_centi() override {
    const std::int32_t millivolts_4096 = analogRead(kTemperatureChannel) * kSupplyMillivolts;
    const std::int32_t microvolts = millivolts_4096 / 512 * 125;  // times 1000 / 4096
    return static_cast<std::int16_t>(2500 - (microvolts - 719000) * 20 / 343);
  }

  void kick_watchdog() override {
    const std::uint32_t state = lock_interrupts();
    WDOG_REFRESH = 0xA602;
    WDOG_REFRESH = 0xB480;
    restore_interrupts(state);
  }
  void reboot_to_bootloader() override {
    blank();
    _reboot_Teensyduino_();
  }

  std::uint32_t lock_interrupts() override {
    std::uint32_t state;
    asm volatile("mrs %0, primask\n cpsid i" : "=r"(state) : : "memory");
    return state;
  }
  void restore_interrupts(std::uint32_t state) override {
    asm volatile("msr primask, %0" : : "r"(state) : "memory");
  }

 private:
  static constexpr std::uint32_t kReceivedMask = 0xF0;  // RXCTR of SPI0_SR

  static std::uint8_t* eeprom(std::size_t address) {
    return reinterpret_cast<std::uint8_t*>(address);
  }
  // 1 kHz oscillator, so it runs whatever the clocks do.
  static void start_watchdog() {
    noInterrupts();
    WDOG_UNLOCK = WDOG_UNLOCK_SEQ1;
    WDOG_UNLOCK = WDOG_UNLOCK_SEQ2;
    asm volatile("nop\n nop");
    WDOG_TOVALH = 0;
    WDOG_TOVALL = static_cast<std::uint16_t>(teensy31::kWatchdogMs);
    WDOG_PRESC = 0;
    WDOG_STCTRLH =
        WDOG_STCTRLH_ALLOWUPDATE | WDOG_STCTRLH_WDOGEN | WDOG_STCTRLH_WAITEN | WDOG_STCTRLH_STOPEN;
    interrupts();
  }

  teensy31::LedChain leds_;
  std::uint64_t now_us_ = 0;
  std::uint64_t deadline_us_ = kNever;
  std::uint32_t last_micros_ = 0;
  std::uint8_t spi_[reliefscope::kSpiChunk] = {};
  std::size_t spi_count_ = 0;
  std::size_t spi_pushed_ = 0;
  std::size_t spi_done_ = 0;
};

TeensyBoard board;
Core core(board);

void on_strobe() {
  core.on_input(Input::kStrobe, board.input_level(Input::kStrobe));
}
void on_ready() {
  core.on_input(Input::kReady, board.input_level(Input::kReady));
}

wire::ResetCause reset_cause() {
  const std::uint8_t first = RCM_SRS0;
  const std::uint8_t second = RCM_SRS1;
  if ((first & RCM_SRS0_POR) != 0) {
    return wire::ResetCause::kPowerOn;
  }
  if ((first & RCM_SRS0_LVD) != 0) {
    return wire::ResetCause::kBrownOut;
  }
  if ((first & RCM_SRS0_WDOG) != 0) {
    return wire::ResetCause::kWatchdog;
  }
  if ((second & RCM_SRS1_LOCKUP) != 0) {
    return wire::ResetCause::kLockup;
  }
  if ((second & RCM_SRS1_SW) != 0) {
    return wire::ResetCause::kSoftware;
  }
  return (first & RCM_SRS0_PIN) != 0 ? wire::ResetCause::kPin : wire::ResetCause::kUnknown;
}

// A fault of the processor: dark at once, then a reset that finds the glass shut.
[[noreturn]] void stop() {
  board.blank();
  SCB_AIRCR = 0x05FA0004;  // SYSRESETREQ
  for (;;) {
  }
}

}  // namespace

extern "C" {

void pit3_isr() {
  if (board.on_deadline()) {
    core.on_timer();
  }
}
void hard_fault_isr() {
  stop();
}
void memmanage_fault_isr() {
  stop();
}
void bus_fault_isr() {
  stop();
}
void usage_fault_isr() {
  stop();
}
}

void setup() {
  board.begin();
  Serial.begin(0);
  const std::uint32_t nonce = board.next_boot();
  noInterrupts();
  core.begin(reset_cause(), nonce);
  interrupts();
  // One priority for all that calls the core: they never interrupt each other.
  NVIC_SET_PRIORITY(IRQ_PIT_CH3, kCorePriority);
  NVIC_SET_PRIORITY(IRQ_PORTD, kCorePriority);
  attachInterrupt(digitalPinToInterrupt(teensy31::kCameraStrobe), on_strobe, CHANGE);
  attachInterrupt(digitalPinToInterrupt(teensy31::kCameraReady), on_ready, CHANGE);
  NVIC_SET_PRIORITY(IRQ_PORTD, kCorePriority);  // attachInterrupt may have set its own
  NVIC_ENABLE_IRQ(IRQ_PIT_CH3);
}

void loop() {
  core.poll();
}
