// Vector table of the unit tests: newlib starts, and a fault ends the emulator with status 77.
#include <cstdint>

extern "C" {
extern std::uint32_t __stack_top[];
void _start();

[[noreturn]] static void fault() {
  static const std::uint32_t status[] = {0x20026u, 77u};  // ADP_Stopped_ApplicationExit
  register std::uint32_t operation asm("r0") = 0x20u;     // SYS_EXIT_EXTENDED
  register const void* block asm("r1") = status;
  asm volatile("bkpt 0xAB" : : "r"(operation), "r"(block) : "memory");
  for (;;) {
  }
}
}

using Handler = void (*)();
[[gnu::section(".vectors"), gnu::used]] static Handler const vectors[] = {
    reinterpret_cast<Handler>(__stack_top), _start, fault, fault, fault, fault, fault};
