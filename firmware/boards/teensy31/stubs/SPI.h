// See Arduino.h beside this file.
#pragma once

#include <cstdint>

#define SPI_MODE0 0x00

class SPISettings {
 public:
  SPISettings(std::uint32_t clock, std::uint8_t bit_order, std::uint8_t mode);
};
class SPIClass {
 public:
  void begin();
  void beginTransaction(SPISettings settings);
};
extern SPIClass SPI;
