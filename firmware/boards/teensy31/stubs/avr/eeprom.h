// See Arduino.h above this folder.
#pragma once

#include <cstdint>

extern "C" {
std::uint8_t eeprom_read_byte(const std::uint8_t* address);
void eeprom_write_byte(std::uint8_t* address, std::uint8_t value);
}
