/* The firmware core as a shared library: one device in virtual time, with a plain C interface.
 *
 * Everything is deterministic: the same calls give the same bytes. Not thread-safe; one device may
 * be used from one thread at a time. Time is in microseconds since power-on.
 *
 * Trace record (little-endian): u8 kind, u8 arg, u16 payload length, u64 time_us, payload.
 *   1 SPI bytes           arg: A0 level; payload: the bytes, the first of them leaving at time_us
 *   2 output pin          arg: 0 LCD reset, 1 LCD chip select, 2 camera trigger; payload: u8 level
 *   3 LED                 arg: LED index; payload: u16 level, 0 to 4095
 *   4 non-volatile byte   payload: u16 address, u8 value
 *   5 bootloader entered  (nothing runs until rs_reset)
 *   6 trace overflow      records after this one were lost until it was read
 */
#ifndef RELIEFSCOPE_HOST_H
#define RELIEFSCOPE_HOST_H

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32)
#define RS_API __declspec(dllexport)
#else
#define RS_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef struct rs_device rs_device;

/* A device at time 0, reset by power-on, its main loop about to start. size bytes of non-volatile
 * memory are copied (more than the memory has are ignored, missing ones read 0xFF, as erased
 * EEPROM does); nonvolatile may be NULL. NULL when there is no memory. */
RS_API rs_device* rs_create(const uint8_t* nonvolatile, size_t size, uint32_t boot_nonce);
RS_API void rs_destroy(rs_device* device);

/* Reset for cause (ResetCause of protocol.yml): RAM and serial buffers are lost, outputs fall to
 * their reset levels, time goes on, non-volatile memory stays. */
RS_API void rs_reset(rs_device* device, uint32_t cause, uint32_t boot_nonce);

/* Bytes from the host to the device; returns how many its receive buffer took. */
RS_API size_t rs_serial_in(rs_device* device, const uint8_t* bytes, size_t n);
/* Bytes from the device to the host; returns how many were there. */
RS_API size_t rs_serial_out(rs_device* device, uint8_t* buffer, size_t capacity);

/* Runs main loop and timer interrupts up to and including time_us; an earlier time is ignored. */
RS_API void rs_run_until(rs_device* device, uint64_t time_us);
/* Earliest time at which something happens without input; UINT64_MAX: never. */
RS_API uint64_t rs_next_wakeup_us(rs_device* device);

/* Level of an input line from now on: 0 camera strobe (high: exposing), 1 camera ready. */
RS_API void rs_set_input(rs_device* device, uint32_t input, uint32_t level);

/* Whole trace records only, oldest first; returns bytes written. */
RS_API size_t rs_trace_read(rs_device* device, uint8_t* buffer, size_t capacity);
/* Copy of the non-volatile memory; returns bytes written. */
RS_API size_t rs_nonvolatile_read(rs_device* device, uint8_t* buffer, size_t capacity);

#ifdef __cplusplus
}
#endif
#endif
