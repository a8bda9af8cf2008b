/* What the driver of steplock.h has beside for the sinusoidal drive: its speeds and its telemetry.
 *
 * Start, stop, faults, interrupts, watchdog and the set speed are those of steplock.h, for both drives.  A tick of
 * the watchdog is 16 PWM periods.  Registers: docs/sinusoidal_registers.md.  Test:
 * tests/testbench/sinusoidal_host_test.cpp, where this driver turns a motor through the RTL.
 */
#ifndef STEPLOCK_SINUSOIDAL_H
#define STEPLOCK_SINUSOIDAL_H

#include "steplock.h"
#include "steplock_sinusoidal_registers.h"

#ifdef __cplusplus
extern "C" {
#endif

/* All of one instant; full scales are those of the drive file. */
struct steplock_sinusoidal_telemetry {
  int16_t speed, reference;    /* s0.15 of 1/16 electrical turn per PWM period */
  int16_t i_gamma, i_delta;    /* s0.15: along the estimated field, and across it */
  uint16_t angle;              /* u0.16 electrical turns */
  uint16_t v_dc;               /* u0.12 */
  uint16_t on_u, on_v, on_w;   /* clocks, of the next PWM period */
  uint16_t retries;
};

/* The word of a speed in electrical revolutions per minute, for steplock_set_speed(); `period` is PWM.period in
 * clocks.  Stops at the largest word; STEPLOCK_NO_SPEED for a clock of 0 Hz or a period of 0. */
uint32_t steplock_sinusoidal_speed(uint32_t erpm, uint32_t clock_hz, uint32_t period);
/* A speed of the telemetry in electrical revolutions per minute; 0 for a period of 0. */
int32_t steplock_sinusoidal_erpm(int16_t speed, uint32_t clock_hz, uint32_t period);

enum steplock_result steplock_sinusoidal_get_telemetry(const struct steplock_bus *bus,
                                                       struct steplock_sinusoidal_telemetry *telemetry);
/* In words; "unknown" for any other number. */
const char *steplock_sinusoidal_state_name(unsigned state);
const char *steplock_sinusoidal_reason_name(unsigned reason);

#ifdef __cplusplus
}
#endif
#endif
