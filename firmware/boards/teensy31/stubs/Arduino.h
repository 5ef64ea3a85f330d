// What the teensy31 port uses of the Teensy core, declared but not defined: with these headers its
// sources are compiled where the core itself is not to be had. Names, types and addresses as there.
#pragma once

#include <cstddef>
#include <cstdint>

#define F_BUS 36000000
#define HIGH 1
#define LOW 0
#define INPUT 0
#define OUTPUT 1
#define CHANGE 4
#define MSBFIRST 1

extern "C" {
void pinMode(std::uint8_t pin, std::uint8_t mode);
void digitalWriteFast(std::uint8_t pin, std::uint8_t value);
std::uint8_t digitalReadFast(std::uint8_t pin);
void analogWriteFrequency(std::uint8_t pin, float frequency);
std::uint32_t analogWriteResolution(std::uint32_t bits);
void analogWrite(std::uint8_t pin, int value);
void analogReadResolution(unsigned int bits);
int analogRead(std::uint8_t pin);
std::uint32_t micros();
void attachInterrupt(std::uint8_t pin, void (*function)(), int mode);
[[noreturn]] void _reboot_Teensyduino_();
}
#define digitalPinToInterrupt(pin) (pin)
#define noInterrupts() asm volatile("cpsid i" ::: "memory")
#define interrupts() asm volatile("cpsie i" ::: "memory")

class usb_serial_class {
 public:
  void begin(long baud);
  int available();
  int read();
  int availableForWrite();
  std::size_t write(const std::uint8_t* bytes, std::size_t count);
  void send_now();
};
extern usb_serial_class Serial;

#define RELIEFSCOPE_REGISTER(type, address) (*reinterpret_cast<volatile std::type*>(address))
#define SIM_SCGC6 RELIEFSCOPE_REGISTER(uint32_t, 0x4004803Cu)
#define SIM_SCGC6_PIT 0x00800000u
#define SIM_UIDL RELIEFSCOPE_REGISTER(uint32_t, 0x40048060u)
#define PIT_MCR RELIEFSCOPE_REGISTER(uint32_t, 0x40037000u)
#define PIT_LDVAL3 RELIEFSCOPE_REGISTER(uint32_t, 0x40037130u)
#define PIT_TCTRL3 RELIEFSCOPE_REGISTER(uint32_t, 0x40037138u)
#define PIT_TFLG3 RELIEFSCOPE_REGISTER(uint32_t, 0x4003713Cu)
#define PIT_TCTRL_TIE 2u
#define PIT_TCTRL_TEN 1u
#define PIT_TFLG_TIF 1u
#define SPI0_MCR RELIEFSCOPE_REGISTER(uint32_t, 0x4002C000u)
#define SPI0_SR RELIEFSCOPE_REGISTER(uint32_t, 0x4002C02Cu)
#define SPI0_PUSHR RELIEFSCOPE_REGISTER(uint32_t, 0x4002C034u)
#define SPI0_POPR RELIEFSCOPE_REGISTER(uint32_t, 0x4002C038u)
#define SPI_MCR_CLR_TXF 0x00000800u
#define SPI_MCR_CLR_RXF 0x00000400u
#define SPI_PUSHR_CTAS(n) (((n) & 7u) << 28)
#define WDOG_STCTRLH RELIEFSCOPE_REGISTER(uint16_t, 0x40052000u)
#define WDOG_TOVALH RELIEFSCOPE_REGISTER(uint16_t, 0x40052004u)
#define WDOG_TOVALL RELIEFSCOPE_REGISTER(uint16_t, 0x40052006u)
#define WDOG_REFRESH RELIEFSCOPE_REGISTER(uint16_t, 0x4005200Cu)
#define WDOG_UNLOCK RELIEFSCOPE_REGISTER(uint16_t, 0x4005200Eu)
#define WDOG_PRESC RELIEFSCOPE_REGISTER(uint16_t, 0x40052016u)
#define WDOG_UNLOCK_SEQ1 0xC520u
#define WDOG_UNLOCK_SEQ2 0xD928u
#define WDOG_STCTRLH_WDOGEN 0x0001u
#define WDOG_STCTRLH_ALLOWUPDATE 0x0010u
#define WDOG_STCTRLH_STOPEN 0x0040u
#define WDOG_STCTRLH_WAITEN 0x0080u
#define RCM_SRS0 RELIEFSCOPE_REGISTER(uint8_t, 0x4007F000u)
#define RCM_SRS1 RELIEFSCOPE_REGISTER(uint8_t, 0x4007F001u)
#define RCM_SRS0_POR 0x80u
#define RCM_SRS0_PIN 0x40u
#define RCM_SRS0_WDOG 0x20u
#define RCM_SRS0_LVD 0x02u
#define RCM_SRS1_SW 0x04u
#define RCM_SRS1_LOCKUP 0x02u
#define SCB_AIRCR RELIEFSCOPE_REGISTER(uint32_t, 0xE000ED0Cu)
#define IRQ_PIT_CH3 71
#define IRQ_PORTD 90
#define NVIC_ENABLE_IRQ(n) \
  (RELIEFSCOPE_REGISTER(uint32_t, 0xE000E100u + ((n) >> 5) * 4) = 1u << ((n) & 31))
#define NVIC_SET_PRIORITY(n, priority) \
  (RELIEFSCOPE_REGISTER(uint8_t, 0xE000E400u + (n)) = (priority))

void setup();
void loop();
