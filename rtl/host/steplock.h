/* Driver of the drives for a bare-metal host: C99, no allocation, no state of its own.  All of it serves the
 * six-step drive; the sinusoidal one all but what its comment says, and steplock_sinusoidal.h the rest.
 *
 * Every function gets the bus, two functions that read and write one register.  For a drive in the
 * address space of the processor steplock_memory_mapped() gives them.  Config for a motor come from
 * `steplock design FILE --c-header`.  Registers: docs/six_step_registers.md.  Test:
 * tests/testbench/host_driver_test.cpp, where this driver turns a motor through the RTL.
 */
#ifndef STEPLOCK_H
#define STEPLOCK_H

#include <stddef.h>
#include <stdint.h>

#include "steplock_registers.h"

#ifdef __cplusplus
extern "C" {
#endif

enum steplock_result {
  STEPLOCK_OK = 0,
  STEPLOCK_BUS_ERROR,   /* an access was answered with an error */
  STEPLOCK_NO_DRIVE,    /* another ID, another major version or an older minor one stands there */
  STEPLOCK_NOT_STOPPED, /* the drive has to be stopped for this */
  STEPLOCK_NOT_KEPT,    /* a register does not read back what was written */
  STEPLOCK_FAULT_LATCHED, /* a fault is latched; for clear_fault: its cause lasts */
  STEPLOCK_NO_PERIOD,    /* the configuration leaves PWM.period 0, or too short: the bridge stays off */
  STEPLOCK_NO_HALL,      /* the configuration asks for Hall sensors, whose decoder this drive was made without */
  STEPLOCK_NO_METHOD,    /* the configuration asks for a start (START_LOCK.method) that this drive was made without */
  STEPLOCK_REFUSED,      /* an argument that cannot be: no bus, or a value that its register does not hold; nothing was written */
  STEPLOCK_TRY_AGAIN,    /* of clear_fault: an over-current, which lasts for a PWM period after its comparator fell */
  STEPLOCK_WRONG_CLOCK   /* the configuration was made for another clock than the drive's (CLOCK); nothing was written */
};
const char *steplock_result_name(enum steplock_result result);

enum steplock_kind { STEPLOCK_SIX_STEP = 1, STEPLOCK_SINUSOIDAL = 2 };

/* Offsets in bytes from the drive's base; 0 when the access was answered well. */
struct steplock_bus {
  int (*write)(void *context, uint32_t offset, uint32_t value);
  int (*read)(void *context, uint32_t offset, uint32_t *value);
  void *context;
};

struct steplock_word {
  uint32_t offset, value;
};

struct steplock_status {
  unsigned state, reason; /* enum steplock_state and steplock_reason, or steplock_sinusoidal_state and _reason */
  int locked, reverse, stopped, fault, watchdog;
};

/* All of one instant. */
struct steplock_telemetry {
  uint32_t frequency;  /* u0.32 VCO turns per clock */
  uint16_t duty;       /* u1.15 */
  int16_t phase_error; /* s0.16 of a step */
  uint16_t crossings, missed, freewheel_long, limit_hits, retries;
};

/* A drive at `base` of the processor's own addresses. */
struct steplock_bus steplock_memory_mapped(volatile uint32_t *base);

/* Finds the drive, writes all words behind the lock, reads them back and enables the bridge.  A word at STEPLOCK_CLOCK is the
 * clock in kHz for which the others were made: it is compared, if the drive tells its own, and not written. */
enum steplock_result steplock_init(const struct steplock_bus *bus,
                                   const struct steplock_word *words, size_t count);

/* One of enum steplock_kind; its words are of that kind. */
enum steplock_result steplock_get_kind(const struct steplock_bus *bus, unsigned *kind);

/* The drive's clock, to the kHz; 0: its pins clock_khz are tied to 0, and it does not tell. */
enum steplock_result steplock_get_clock(const struct steplock_bus *bus, uint32_t *clock_hz);

/* Drives on this bus, each 0x100 behind the one before. */
enum steplock_result steplock_get_axes(const struct steplock_bus *bus, unsigned *axes);

/* These three write no bit of CONTROL but their own: an interrupt may stop the drive while the main program reverses it. */
enum steplock_result steplock_start(const struct steplock_bus *bus, int reverse);
enum steplock_result steplock_stop(const struct steplock_bus *bus, int brake);
/* Turns round: slows down, brakes and starts the other way; also while running. */
enum steplock_result steplock_reverse(const struct steplock_bus *bus, int reverse);

/* `speed` as steplock_speed() or steplock_sinusoidal_speed() gives it; acts from the next PWM period on.  More than the drive's
 * SPEED_TARGET holds is refused. */
enum steplock_result steplock_set_speed(const struct steplock_bus *bus, uint32_t speed);
/* What these two give for a clock of 0 Hz and the like; steplock_set_speed() refuses it. */
#define STEPLOCK_NO_SPEED 0xffffffffu
/* The word of a speed in electrical revolutions per minute; stops at the largest word.  STEPLOCK_NO_SPEED for a clock of 0 Hz
 * or a `divide` that LOOP.divide does not hold.  Six-step. */
uint32_t steplock_speed(uint32_t erpm, uint32_t clock_hz, unsigned divide);

enum steplock_result steplock_get_status(const struct steplock_bus *bus,
                                         struct steplock_status *status);
/* In words; "unknown" for any other number.  Six-step; steplock_sinusoidal.h has those of the other drive. */
const char *steplock_state_name(unsigned state);
const char *steplock_reason_name(unsigned reason);
/* Six-step. */
enum steplock_result steplock_get_telemetry(const struct steplock_bus *bus,
                                            struct steplock_telemetry *telemetry);

/* Stops, and re-arms drive and watchdog.  STEPLOCK_FAULT_LATCHED: the cause lasts, such as a fault pin that is low.
   STEPLOCK_TRY_AGAIN: an over-current, whose comparator has to be low for an off-time and a PWM period; one that goes on
   answering so has a comparator that is stuck. */
enum steplock_result steplock_clear_fault(const struct steplock_bus *bus);

/* Longest time between two heartbeats in ticks, at most 4095; 0: none.  Only while stopped. */
enum steplock_result steplock_set_watchdog(const struct steplock_bus *bus, uint32_t ticks);
enum steplock_result steplock_heartbeat(const struct steplock_bus *bus);

/* Bits of INTERRUPT that raise the pin; and reads and acknowledges what is set. */
enum steplock_result steplock_enable_interrupts(const struct steplock_bus *bus, uint32_t bits);
enum steplock_result steplock_take_interrupts(const struct steplock_bus *bus, uint32_t *bits);

#ifdef __cplusplus
}
#endif
#endif
