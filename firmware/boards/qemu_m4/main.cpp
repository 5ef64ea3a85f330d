// The core as ARM code in an emulator: mps2-an386, a Cortex-M4 with 25 MHz timers. UART 0 is the
// link; UART 1 carries what the outputs do, in the records of boards/host/reliefscope_host.h. There
// is no camera, no bootloader, and the non-volatile memory lasts as long as the emulator.
//
// The emulator's operator puts the boot nonce into the first word of the PSRAM
// (-device loader,addr=0x21000000,data=N,data-len=4), since nothing on this board is random. With
// -icount each instruction takes a fixed time. The main loop does not sleep in a sequence, for the
// clock of a sleeping emulator follows the PC's, however busy that is.
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/core.hpp"
#include "core/identity.hpp"

namespace {

namespace wire = reliefscope::wire;
using reliefscope::BoardInfo;
using reliefscope::Core;
using reliefscope::Input;
using reliefscope::kNever;
using reliefscope::Pin;

// CMSDK peripherals.
struct Uart {
  volatile std::uint32_t data;
  volatile std::uint32_t state;
  volatile std::uint32_t control;
  volatile std::uint32_t interrupts;
  volatile std::uint32_t divider;
};
constexpr std::uint32_t kUartTxFull = 1u << 0;
constexpr std::uint32_t kUartRxFull = 1u << 1;
constexpr std::uint32_t kUartTxOn = 1u << 0;
constexpr std::uint32_t kUartRxOn = 1u << 1;
constexpr std::uint32_t kUartRxInterruptOn = 1u << 3;
constexpr std::uint32_t kUartRxInterrupt = 1u << 1;

struct Timer {
  volatile std::uint32_t control;
  volatile std::uint32_t value;
  volatile std::uint32_t reload;
  volatile std::uint32_t interrupts;
};
constexpr std::uint32_t kTimerOn = 1u << 0;
constexpr std::uint32_t kTimerInterruptOn = 1u << 3;

template <class T>
T& at(std::uintptr_t address) {
  return *reinterpret_cast<T*>(address);
}
volatile std::uint32_t* const systick = &at<volatile std::uint32_t>(0xE000E010u);
Timer& deadline_timer = at<Timer>(0x40000000u);
Timer& clock_timer = at<Timer>(0x40001000u);
Uart& link = at<Uart>(0x40004000u);
Uart& tracer = at<Uart>(0x40005000u);
volatile std::uint32_t& interrupt_enable = at<volatile std::uint32_t>(0xE000E100u);
volatile std::uint32_t& interrupt_disable = at<volatile std::uint32_t>(0xE000E180u);
volatile std::uint8_t* const interrupt_priority = &at<volatile std::uint8_t>(0xE000E400u);
constexpr std::uint8_t kLowPriority = 0x80;
constexpr std::uint32_t kLinkInterrupt = 1u << 0;
constexpr std::uint32_t kDeadlineInterrupt = 1u << 8;

constexpr std::uint32_t kTicksPerUs = 25;
constexpr std::uint32_t kTicksPerMs = 1000 * kTicksPerUs;
// Longest deadline that is set at once; a later one is set again on the way.
constexpr std::uint64_t kLongestWaitUs = 10000000;

constexpr std::size_t kMemorySize = 1024;
constexpr std::size_t kRxSize = 512;
constexpr std::size_t kTraceSize = 2048;
// The main loop waits for the trace before it adds SPI bytes, so that interrupts find room for
// pins and all LEDs.
constexpr std::size_t kTraceBacklog = 256;
constexpr std::uint64_t kSpiByteUs = 2;  // 4 MHz

extern const reliefscope::Identity kIdentity = reliefscope::make_identity("qemu_m4");

constexpr std::uint32_t kLevelBudget = 400 / 20 * 4095;  // as on the host board
constexpr BoardInfo kInfo = {kIdentity.board,  0,  wire::kLeds, kLevelBudget,
                             60 * 1000 * 1000, 10, 0,           1};

class QemuBoard final : public reliefscope::Hal {
 public:
  void begin() {
    clock_timer.reload = UINT32_MAX;
    clock_timer.value = UINT32_MAX;
    clock_timer.control = kTimerOn;
    last_ticks_ = UINT32_MAX;
    tracer.divider = 16;
    tracer.control = kUartTxOn;
    link.divider = 16;
    link.control = kUartTxOn | kUartRxOn | kUartRxInterruptOn;
    static_cast<void>(link.data);  // or else the emulator never offers the first byte
    systick[1] = kTicksPerMs - 1;
    systick[2] = 0;
    systick[0] = 7;  // on, with interrupt: ends sleep()
    std::memset(memory_, 0xFF, sizeof memory_);
  }
  // Received bytes wait for the core's deadline, not the other way round.
  void open_interrupts() {
    interrupt_priority[0] = kLowPriority;
    interrupt_enable = kLinkInterrupt | kDeadlineInterrupt;
  }

  // Interrupts.
  void on_receive() {
    link.interrupts = kUartRxInterrupt;
    while ((link.state & kUartRxFull) != 0) {
      if (rx_head_ - rx_tail_ == kRxSize) {
        // The byte stays in the UART, and the sender waits.
        interrupt_disable = kLinkInterrupt;
        return;
      }
      rx_[rx_head_ % kRxSize] = static_cast<std::uint8_t>(link.data);
      rx_head_ = rx_head_ + 1;
    }
  }
  // True: the core's deadline.
  bool on_deadline() {
    deadline_timer.interrupts = 1;
    deadline_timer.control = 0;
    if (now_us() < deadline_us_) {
      arm_timer(deadline_us_);
      return false;
    }
    return deadline_us_ != kNever;
  }

  // Main: hands trace records to the UART while it takes them.
  void flush_trace() {
    while (trace_tail_ != trace_head_ && (tracer.state & kUartTxFull) == 0) {
      tracer.data = trace_[trace_tail_ % kTraceSize];
      trace_tail_ = trace_tail_ + 1;
    }
  }

  // Until an interrupt. Checked under the lock, or a wake-up could be missed.
  void sleep() {
    asm volatile("cpsid i" ::: "memory");
    if (rx_head_ == rx_tail_ && trace_head_ == trace_tail_) {
      asm volatile("wfi" ::: "memory");
    }
    asm volatile("cpsie i" ::: "memory");
  }

  // Hal
  const BoardInfo& info() const override { return kInfo; }

  std::uint64_t now_us() override {
    const std::uint32_t state = lock_interrupts();
    const std::uint32_t ticks = clock_timer.value;
    const std::uint32_t passed = last_ticks_ - ticks + part_ticks_;
    last_ticks_ = ticks;
    now_us_ += passed / kTicksPerUs;
    part_ticks_ = passed % kTicksPerUs;
    const std::uint64_t now = now_us_;
    restore_interrupts(state);
    return now;
  }

  void arm_timer(std::uint64_t at_us) override {
    const std::uint32_t state = lock_interrupts();
    deadline_us_ = at_us;
    deadline_timer.control = 0;
    deadline_timer.interrupts = 1;
    if (at_us != kNever) {
      const std::uint64_t now = now_us();
      std::uint64_t wait = at_us > now ? at_us - now : 0;
      wait = wait < kLongestWaitUs ? wait : kLongestWaitUs;
      const auto ticks = static_cast<std::uint32_t>(wait) * kTicksPerUs;
      deadline_timer.reload = UINT32_MAX;  // sets the value, too: so the value comes after it
      deadline_timer.value = ticks == 0 ? 1 : ticks;
      deadline_timer.control = kTimerOn | kTimerInterruptOn;
    }
    restore_interrupts(state);
  }

  void spi_start(bool a0_high, const std::uint8_t* bytes, std::size_t count) override {
    while (trace_head_ - trace_tail_ > kTraceBacklog) {
      flush_trace();
    }
    spi_busy_until_us_ = now_us() + count * kSpiByteUs;
    record(1, a0_high ? 1 : 0, bytes, count);
  }
  bool spi_busy() override { return now_us() < spi_busy_until_us_; }

  void set_pin(Pin pin, bool high) override {
    const auto index = static_cast<std::uint8_t>(pin);
    if (pins_[index] != high) {
      pins_[index] = high;
      const std::uint8_t level = high ? 1 : 0;
      record(2, index, &level, 1);
    }
  }
  bool input_level(Input) override { return false; }

  void set_leds(const std::uint16_t* levels, std::size_t count) override {
    for (std::size_t i = 0; i < count; ++i) {
      if (leds_[i] != levels[i]) {
        leds_[i] = levels[i];
        const std::uint8_t payload[] = {static_cast<std::uint8_t>(levels[i]),
                                        static_cast<std::uint8_t>(levels[i] >> 8)};
        record(3, static_cast<std::uint8_t>(i), payload, sizeof payload);
      }
    }
  }

  std::size_t serial_read(std::uint8_t* bytes, std::size_t capacity) override {
    std::size_t count = 0;
    while (count < capacity && rx_tail_ != rx_head_) {
      bytes[count++] = rx_[rx_tail_ % kRxSize];
      rx_tail_ = rx_tail_ + 1;
    }
    interrupt_enable = kLinkInterrupt;
    return count;
  }
  std::size_t serial_write(const std::uint8_t* bytes, std::size_t count) override {
    std::size_t taken = 0;
    while (taken < count && (link.state & kUartTxFull) == 0) {
      link.data = bytes[taken++];
    }
    return taken;
  }

  std::uint8_t nonvolatile_read(std::size_t address) override {
    return address < kMemorySize ? memory_[address] : 0xFF;
  }
  void nonvolatile_write(std::size_t address, std::uint8_t value) override {
    if (address < kMemorySize) {
      memory_[address] = value;
      const std::uint8_t payload[] = {static_cast<std::uint8_t>(address),
                                      static_cast<std::uint8_t>(address >> 8), value};
      record(4, 0, payload, sizeof payload);
    }
  }

  std::int16_t temperature_centi() override {
    return static_cast<std::int16_t>(wire::kTemperatureUnknown);
  }
  void kick_watchdog() override {}
  void reboot_to_bootloader() override {}

  std::uint32_t lock_interrupts() override {
    std::uint32_t state;
    asm volatile("mrs %0, primask\n cpsid i" : "=r"(state) : : "memory");
    return state;
  }
  void restore_interrupts(std::uint32_t state) override {
    asm volatile("msr primask, %0" : : "r"(state) : "memory");
  }

 private:
  void put(std::uint8_t byte) {
    trace_[trace_head_ % kTraceSize] = byte;
    trace_head_ = trace_head_ + 1;
  }
  void record(std::uint8_t kind, std::uint8_t arg, const std::uint8_t* payload, std::size_t size) {
    constexpr std::size_t kHead = 12;
    const std::uint32_t state = lock_interrupts();
    // The last head's worth of room is for the record that tells of a loss.
    if (trace_head_ - trace_tail_ + size + 2 * kHead > kTraceSize) {
      kind = 6;
      arg = 0;
      size = 0;
    }
    if (trace_head_ - trace_tail_ + kHead <= kTraceSize) {
      const std::uint64_t now = now_us();
      put(kind);
      put(arg);
      put(static_cast<std::uint8_t>(size));
      put(static_cast<std::uint8_t>(size >> 8));
      for (unsigned i = 0; i < 8; ++i) {
        put(static_cast<std::uint8_t>(now >> (8 * i)));
      }
      for (std::size_t i = 0; i < size; ++i) {
        put(payload[i]);
      }
    }
    restore_interrupts(state);
  }

  std::uint64_t now_us_ = 0;
  std::uint64_t deadline_us_ = kNever;
  std::uint64_t spi_busy_until_us_ = 0;
  std::uint32_t last_ticks_ = 0;
  std::uint32_t part_ticks_ = 0;
  bool pins_[3] = {false, true, false};
  std::uint16_t leds_[wire::kLeds] = {};
  std::uint8_t memory_[kMemorySize] = {};
  std::uint8_t rx_[kRxSize] = {};
  volatile std::uint32_t rx_head_ = 0;
  volatile std::uint32_t rx_tail_ = 0;
  std::uint8_t trace_[kTraceSize] = {};
  volatile std::uint32_t trace_head_ = 0;
  volatile std::uint32_t trace_tail_ = 0;
};

QemuBoard board;
Core core(board);

}  // namespace

extern "C" {

void link_receive_handler() {
  board.on_receive();
}
void deadline_handler() {
  if (board.on_deadline()) {
    core.on_timer();
  }
}

void tick_handler() {}

int main() {
  asm volatile("cpsid i" ::: "memory");
  board.begin();
  const std::uint32_t nonce = at<volatile std::uint32_t>(0x21000000u);
  core.begin(wire::ResetCause::kPowerOn, nonce == 0 ? 1 : nonce);
  board.open_interrupts();
  asm volatile("cpsie i" ::: "memory");
  for (;;) {
    const bool worked = core.poll();
    board.flush_trace();
    if (!worked && !core.sequence_active()) {
      board.sleep();
    }
  }
}
}
