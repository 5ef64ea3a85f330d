// Reset and vectors of the mps2-an386's image. A fault turns everything dark and stops; nothing in
// this image needs a C library but memcpy, memset and memcmp.
#include <cstdint>

extern "C" {
extern std::uint32_t __data_load[];
extern std::uint32_t __data_start[];
extern std::uint32_t __data_end[];
extern std::uint32_t __bss_start[];
extern std::uint32_t __bss_end[];
extern std::uint32_t __stack_top[];
extern void (*__init_array_start[])();
extern void (*__init_array_end[])();

int main();
void link_receive_handler();
void deadline_handler();
void tick_handler();

// As volatile: or else the compiler makes calls of memcpy and memset, which may not run yet.
[[noreturn]] void reset_handler() {
  const std::uint32_t* from = __data_load;
  for (volatile std::uint32_t* to = __data_start; to < __data_end; ++to) {
    *to = *from++;
  }
  for (volatile std::uint32_t* to = __bss_start; to < __bss_end; ++to) {
    *to = 0;
  }
  for (void (**constructor)() = __init_array_start; constructor < __init_array_end; ++constructor) {
    (*constructor)();
  }
  main();
  for (;;) {
  }
}

// The emulator says "Lockup" and ends: a fault on this board is a bug of the firmware.
[[noreturn]] static void fault_handler() {
  for (;;) {
    asm volatile("cpsid i\n udf #0");
  }
}

void __cxa_pure_virtual() {
  fault_handler();
}
}

using Handler = void (*)();
[[gnu::section(".vectors"), gnu::used]] static Handler const vectors[] = {
    reinterpret_cast<Handler>(__stack_top),
    reset_handler,
    fault_handler,  // NMI
    fault_handler,  // hard fault
    fault_handler,  // memory
    fault_handler,  // bus
    fault_handler,  // usage
    nullptr,
    nullptr,
    nullptr,
    nullptr,
    fault_handler,  // SVCall
    fault_handler,  // debug
    nullptr,
    fault_handler,         // PendSV
    tick_handler,          // SysTick
    link_receive_handler,  // 0: UART 0 received
    fault_handler,
    fault_handler,
    fault_handler,
    fault_handler,
    fault_handler,
    fault_handler,
    fault_handler,
    deadline_handler,  // 8: timer 0
};
