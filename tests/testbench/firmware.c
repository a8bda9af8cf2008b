/* A whole program for a bare-metal host, as docs/programmers_guide.md has it: cross-compiled, not run. */
#include "my_motor.h" /* steplock design FILE --c-header */

enum { kBase = 0x40000000, kRpm = 3000, kPolePairs = 4 };

int main(void) {
  const struct steplock_bus bus = steplock_memory_mapped((volatile uint32_t *)kBase);
  struct steplock_status status;
  if (steplock_init(&bus, my_motor_config, sizeof my_motor_config / sizeof my_motor_config[0]) != STEPLOCK_OK) {
    return 1;
  }
  if (steplock_set_watchdog(&bus, 100) != STEPLOCK_OK) return 1;
  const uint32_t speed = steplock_speed((uint32_t)kRpm * kPolePairs, my_motor_clock_hz, my_motor_divide);
  if (steplock_set_speed(&bus, speed) != STEPLOCK_OK || steplock_start(&bus, 0) != STEPLOCK_OK) return 1;
  do {
    if (steplock_heartbeat(&bus) != STEPLOCK_OK || steplock_get_status(&bus, &status) != STEPLOCK_OK) return 1;
  } while (!status.fault && !status.watchdog);
  return (int)status.reason;
}
