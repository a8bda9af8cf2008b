/* See steplock_sinusoidal.h. */
#include "steplock_sinusoidal.h"

#define GET(name, value) (((value) & STEPLOCK_SINUSOIDAL_##name##_MASK) >> STEPLOCK_SINUSOIDAL_##name##_LSB)

uint32_t steplock_sinusoidal_speed(uint32_t erpm, uint32_t clock_hz, uint32_t period) {
  /* u0.25 of 1/16 turn per period: below that the shift stays within 64 bits. */
  const uint64_t turns = (uint64_t)erpm * period, most = (uint64_t)clock_hz * 60u;
  if (clock_hz == 0u || period == 0u) { return STEPLOCK_NO_SPEED; }
  if (turns >= most / 16u) { return STEPLOCK_SINUSOIDAL_SPEED_TARGET_TARGET_MASK; }
  return (uint32_t)((turns << 29) / most);
}

int32_t steplock_sinusoidal_erpm(int16_t speed, uint32_t clock_hz, uint32_t period) {
  if (period == 0u) { return 0; }
  return (int32_t)((int64_t)speed * (int64_t)clock_hz * 60 / ((int64_t)period * 0x80000));
}

enum steplock_result steplock_sinusoidal_get_telemetry(const struct steplock_bus *bus,
                                                       struct steplock_sinusoidal_telemetry *telemetry) {
  static const uint32_t offsets[5] = {STEPLOCK_SINUSOIDAL_TELEMETRY_SPEED, STEPLOCK_SINUSOIDAL_TELEMETRY_CURRENT,
                                      STEPLOCK_SINUSOIDAL_TELEMETRY_ANGLE, STEPLOCK_SINUSOIDAL_TELEMETRY_LEGS,
                                      STEPLOCK_SINUSOIDAL_TELEMETRY_RETRIES};
  uint32_t value[5];
  int i;
  if (!bus || !bus->write || !bus->read || !telemetry) { return STEPLOCK_REFUSED; }
  if (bus->write(bus->context, STEPLOCK_SINUSOIDAL_SNAPSHOT, 1) != 0) { return STEPLOCK_BUS_ERROR; }
  for (i = 0; i < 5; ++i) {
    if (bus->read(bus->context, offsets[i], &value[i]) != 0) { return STEPLOCK_BUS_ERROR; }
  }
  telemetry->speed = (int16_t)GET(TELEMETRY_SPEED_SPEED, value[0]);
  telemetry->reference = (int16_t)GET(TELEMETRY_SPEED_REFERENCE, value[0]);
  telemetry->i_gamma = (int16_t)GET(TELEMETRY_CURRENT_I_GAMMA, value[1]);
  telemetry->i_delta = (int16_t)GET(TELEMETRY_CURRENT_I_DELTA, value[1]);
  telemetry->angle = (uint16_t)GET(TELEMETRY_ANGLE_ANGLE, value[2]);
  telemetry->v_dc = (uint16_t)GET(TELEMETRY_ANGLE_V_DC, value[2]);
  telemetry->on_u = (uint16_t)GET(TELEMETRY_LEGS_ON_U, value[3]);
  telemetry->on_v = (uint16_t)GET(TELEMETRY_LEGS_ON_V, value[3]);
  telemetry->on_w = (uint16_t)GET(TELEMETRY_RETRIES_ON_W, value[4]);
  telemetry->retries = (uint16_t)GET(TELEMETRY_RETRIES_RETRIES, value[4]);
  return STEPLOCK_OK;
}

const char *steplock_sinusoidal_state_name(unsigned state) {
  static const char *const names[] = {STEPLOCK_SINUSOIDAL_STATE_NAMES};
  return state < sizeof names / sizeof names[0] ? names[state] : "unknown";
}

const char *steplock_sinusoidal_reason_name(unsigned reason) {
  static const char *const names[] = {STEPLOCK_SINUSOIDAL_REASON_NAMES};
  return reason < sizeof names / sizeof names[0] ? names[reason] : "unknown";
}
