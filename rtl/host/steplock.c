/* See steplock.h. */
#include "steplock.h"

#include "steplock_sinusoidal_registers.h" /* the bounds of the other drive */

#define GET(name, value) (((value) & STEPLOCK_##name##_MASK) >> STEPLOCK_##name##_LSB)

static int write_mapped(void *context, uint32_t offset, uint32_t value) {
  ((volatile uint32_t *)context)[offset / 4u] = value;
  return 0;
}

static int read_mapped(void *context, uint32_t offset, uint32_t *value) {
  *value = ((volatile uint32_t *)context)[offset / 4u];
  return 0;
}

struct steplock_bus steplock_memory_mapped(volatile uint32_t *base) {
  struct steplock_bus bus;
  bus.write = write_mapped;
  bus.read = read_mapped;
  bus.context = (void *)(uintptr_t)base;
  return bus;
}

static int usable(const struct steplock_bus *bus) { return bus && bus->write && bus->read; }

static enum steplock_result put(const struct steplock_bus *bus, uint32_t offset, uint32_t value) {
  if (!usable(bus)) { return STEPLOCK_REFUSED; }
  return bus->write(bus->context, offset, value) == 0 ? STEPLOCK_OK : STEPLOCK_BUS_ERROR;
}

static enum steplock_result get(const struct steplock_bus *bus, uint32_t offset, uint32_t *value) {
  if (!usable(bus)) { return STEPLOCK_REFUSED; }
  return bus->read(bus->context, offset, value) == 0 ? STEPLOCK_OK : STEPLOCK_BUS_ERROR;
}

/* Bits of CONTROL: no other one is written, so that a stop from an interrupt is not undone. Those to be set last,
   which may be a run. */
static enum steplock_result control(const struct steplock_bus *bus, uint32_t clear, uint32_t set) {
  enum steplock_result result = STEPLOCK_OK;
  if (clear != 0u) { result = put(bus, STEPLOCK_CONTROL_CLEAR, clear); }
  if (result == STEPLOCK_OK && set != 0u) { result = put(bus, STEPLOCK_CONTROL_SET, set); }
  return result;
}

static enum steplock_result need_stopped(const struct steplock_bus *bus) {
  uint32_t status;
  const enum steplock_result result = get(bus, STEPLOCK_STATUS, &status);
  if (result != STEPLOCK_OK) { return result; }
  return GET(STATUS_STOPPED, status) ? STEPLOCK_OK : STEPLOCK_NOT_STOPPED;
}

/* Config of Hall sensors for a drive that was synthesized without their decoder. */
static int need_hall(const struct steplock_word *words, size_t count) {
  size_t i;
  uint32_t hall = 0u;
  for (i = 0; i < count; ++i) {
    if (words[i].offset == STEPLOCK_LOOP) { hall = GET(LOOP_SOURCE, words[i].value); }
  }
  return hall != 0u;
}

/* Config of a start that this drive was synthesized without. */
static int need_method(const struct steplock_word *words, size_t count, uint32_t capability) {
  size_t i;
  int lacks = 0;
  for (i = 0; i < count; ++i) {
    if (words[i].offset == STEPLOCK_START_LOCK) {
      lacks = GET(START_LOCK_METHOD, words[i].value) ? !GET(CAPABILITY_FOLLOWER, capability)
                                                     : !GET(CAPABILITY_RAMP, capability);
    }
  }
  return lacks;
}

/* A clock is told to the kHz: two that round it otherwise mean the same one. */
static enum steplock_result same_clock(const struct steplock_word *words, size_t count, uint32_t khz) {
  enum steplock_result result = STEPLOCK_OK;
  size_t i;
  for (i = 0; i < count; ++i) {
    if (words[i].offset == STEPLOCK_CLOCK && khz != 0u) {
      const uint32_t apart = words[i].value > khz ? words[i].value - khz : khz - words[i].value;
      if (apart > 1u) { result = STEPLOCK_WRONG_CLOCK; }
    }
  }
  return result;
}

static enum steplock_result write_config(const struct steplock_bus *bus,
                                        const struct steplock_word *words, size_t count) {
  size_t i;
  for (i = 0; i < count; ++i) {
    if (words[i].offset != STEPLOCK_CLOCK) {
      uint32_t kept;
      enum steplock_result result = put(bus, words[i].offset, words[i].value);
      if (result == STEPLOCK_OK) { result = get(bus, words[i].offset, &kept); }
      if (result != STEPLOCK_OK) { return result; }
      if (kept != words[i].value) { return STEPLOCK_NOT_KEPT; }
    }
  }
  return STEPLOCK_OK;
}

enum steplock_result steplock_init(const struct steplock_bus *bus,
                                   const struct steplock_word *words, size_t count) {
  uint32_t id, version, capability, khz, status;
  enum steplock_result result, closed;
  if (!usable(bus) || (!words && count != 0u)) { return STEPLOCK_REFUSED; }
  if (get(bus, STEPLOCK_ID, &id) != STEPLOCK_OK || id != STEPLOCK_ID_RESET ||
      get(bus, STEPLOCK_VERSION, &version) != STEPLOCK_OK ||
      GET(VERSION_MAJOR, version) != GET(VERSION_MAJOR, STEPLOCK_VERSION_RESET) ||
      GET(VERSION_MINOR, version) < GET(VERSION_MINOR, STEPLOCK_VERSION_RESET)) {
    return STEPLOCK_NO_DRIVE;
  }
  result = get(bus, STEPLOCK_CAPABILITY, &capability);
  if (result != STEPLOCK_OK) { return result; }
  if (!GET(CAPABILITY_HALL, capability) && GET(CAPABILITY_KIND, capability) == (uint32_t)STEPLOCK_SIX_STEP &&
      need_hall(words, count)) {
    return STEPLOCK_NO_HALL;
  }
  if (GET(CAPABILITY_KIND, capability) == (uint32_t)STEPLOCK_SIX_STEP &&
      need_method(words, count, capability)) {
    return STEPLOCK_NO_METHOD;
  }
  result = get(bus, STEPLOCK_CLOCK, &khz);
  if (result == STEPLOCK_OK) { result = same_clock(words, count, GET(CLOCK_KHZ, khz)); }
  if (result != STEPLOCK_OK) { return result; }
  result = need_stopped(bus);
  if (result != STEPLOCK_OK) { return result; }
  result = put(bus, STEPLOCK_CONTROL, 0);
  if (result == STEPLOCK_OK) { result = put(bus, STEPLOCK_LOCK, STEPLOCK_LOCK_KEY); }
  if (result == STEPLOCK_OK) { result = write_config(bus, words, count); }
  closed = put(bus, STEPLOCK_LOCK, 0); /* in any case */
  if (result == STEPLOCK_OK) { result = closed; }
  if (result != STEPLOCK_OK) { return result; }
  result = get(bus, STEPLOCK_STATUS, &status);
  if (result != STEPLOCK_OK) { return result; }
  if (GET(STATUS_NO_PERIOD, status) != 0u) { return STEPLOCK_NO_PERIOD; }
  return put(bus, STEPLOCK_CONTROL, STEPLOCK_CONTROL_CONFIGURED_MASK);
}

enum steplock_result steplock_get_kind(const struct steplock_bus *bus, unsigned *kind) {
  uint32_t capability;
  const enum steplock_result result = kind ? get(bus, STEPLOCK_CAPABILITY, &capability) : STEPLOCK_REFUSED;
  if (result == STEPLOCK_OK) { *kind = (unsigned)GET(CAPABILITY_KIND, capability); }
  return result;
}

enum steplock_result steplock_get_clock(const struct steplock_bus *bus, uint32_t *clock_hz) {
  uint32_t khz;
  const enum steplock_result result = clock_hz ? get(bus, STEPLOCK_CLOCK, &khz) : STEPLOCK_REFUSED;
  if (result == STEPLOCK_OK) { *clock_hz = 1000u * GET(CLOCK_KHZ, khz); }
  return result;
}

enum steplock_result steplock_get_axes(const struct steplock_bus *bus, unsigned *axes) {
  uint32_t capability;
  const enum steplock_result result = axes ? get(bus, STEPLOCK_CAPABILITY, &capability) : STEPLOCK_REFUSED;
  if (result == STEPLOCK_OK) { *axes = (unsigned)GET(CAPABILITY_AXES, capability); }
  return result;
}

enum steplock_result steplock_start(const struct steplock_bus *bus, int reverse) {
  uint32_t fault;
  const enum steplock_result result = get(bus, STEPLOCK_FAULT, &fault);
  if (result != STEPLOCK_OK) { return result; }
  if (GET(FAULT_DRIVE, fault) || GET(FAULT_WATCHDOG, fault)) { return STEPLOCK_FAULT_LATCHED; }
  return control(bus, STEPLOCK_CONTROL_BRAKE_TO_STOP_MASK | (reverse ? 0u : STEPLOCK_CONTROL_REVERSE_MASK),
                 STEPLOCK_CONTROL_RUN_MASK | (reverse ? STEPLOCK_CONTROL_REVERSE_MASK : 0u));
}

enum steplock_result steplock_stop(const struct steplock_bus *bus, int brake) {
  /* How it is to stop first: a drive that is told to stop looks at that once. */
  const enum steplock_result result = control(bus, brake ? 0u : STEPLOCK_CONTROL_BRAKE_TO_STOP_MASK,
                                              brake ? STEPLOCK_CONTROL_BRAKE_TO_STOP_MASK : 0u);
  return result == STEPLOCK_OK ? control(bus, STEPLOCK_CONTROL_RUN_MASK, 0) : result;
}

enum steplock_result steplock_reverse(const struct steplock_bus *bus, int reverse) {
  return control(bus, reverse ? 0u : STEPLOCK_CONTROL_REVERSE_MASK, reverse ? STEPLOCK_CONTROL_REVERSE_MASK : 0u);
}

enum steplock_result steplock_set_speed(const struct steplock_bus *bus, uint32_t speed) {
  unsigned kind;
  uint32_t most;
  const enum steplock_result result = steplock_get_kind(bus, &kind);
  if (result != STEPLOCK_OK) { return result; }
  most = kind == (unsigned)STEPLOCK_SIX_STEP ? STEPLOCK_SPEED_TARGET_TARGET_MASK : STEPLOCK_SINUSOIDAL_SPEED_TARGET_TARGET_MASK;
  return speed > most ? STEPLOCK_REFUSED : put(bus, STEPLOCK_SPEED_TARGET, speed);
}

uint32_t steplock_speed(uint32_t erpm, uint32_t clock_hz, unsigned divide) {
  const uint32_t most = STEPLOCK_SPEED_TARGET_TARGET_MASK;
  uint64_t turns;
  if (clock_hz == 0u || divide > GET(LOOP_DIVIDE, STEPLOCK_LOOP_DIVIDE_MASK)) { return STEPLOCK_NO_SPEED; }
  /* Steps per second are a tenth of the electrical revolutions per minute. */
  turns = ((uint64_t)erpm << 32) / 10u / clock_hz; /* below 2^64 for all erpm */
  return turns > (most >> divide) ? most : (uint32_t)turns << divide;
}

enum steplock_result steplock_get_status(const struct steplock_bus *bus,
                                         struct steplock_status *status) {
  uint32_t now, fault;
  enum steplock_result result = status ? get(bus, STEPLOCK_STATUS, &now) : STEPLOCK_REFUSED;
  if (result == STEPLOCK_OK) { result = get(bus, STEPLOCK_FAULT, &fault); }
  if (result != STEPLOCK_OK) { return result; }
  status->state = GET(STATUS_STATE, now);
  status->locked = (int)GET(STATUS_LOCKED, now);
  status->reverse = (int)GET(STATUS_REVERSE, now);
  status->stopped = (int)GET(STATUS_STOPPED, now);
  status->fault = (int)GET(FAULT_DRIVE, fault);
  status->watchdog = (int)GET(FAULT_WATCHDOG, fault);
  status->reason = status->fault ? GET(FAULT_REASON, fault) : GET(STATUS_REASON, now);
  return STEPLOCK_OK;
}

enum steplock_result steplock_get_telemetry(const struct steplock_bus *bus,
                                            struct steplock_telemetry *telemetry) {
  uint32_t speed, loop, crossings, limits, retries;
  enum steplock_result result = telemetry ? put(bus, STEPLOCK_SNAPSHOT, 1) : STEPLOCK_REFUSED;
  if (result == STEPLOCK_OK) { result = get(bus, STEPLOCK_TELEMETRY_SPEED, &speed); }
  if (result == STEPLOCK_OK) { result = get(bus, STEPLOCK_TELEMETRY_LOOP, &loop); }
  if (result == STEPLOCK_OK) { result = get(bus, STEPLOCK_TELEMETRY_CROSSINGS, &crossings); }
  if (result == STEPLOCK_OK) { result = get(bus, STEPLOCK_TELEMETRY_LIMITS, &limits); }
  if (result == STEPLOCK_OK) { result = get(bus, STEPLOCK_TELEMETRY_RETRIES, &retries); }
  if (result != STEPLOCK_OK) { return result; }
  telemetry->frequency = GET(TELEMETRY_SPEED_FREQUENCY, speed);
  telemetry->duty = (uint16_t)GET(TELEMETRY_LOOP_DUTY, loop);
  telemetry->phase_error = (int16_t)GET(TELEMETRY_LOOP_PHASE_ERROR, loop);
  telemetry->crossings = (uint16_t)GET(TELEMETRY_CROSSINGS_CROSSINGS, crossings);
  telemetry->missed = (uint16_t)GET(TELEMETRY_CROSSINGS_MISSED, crossings);
  telemetry->freewheel_long = (uint16_t)GET(TELEMETRY_LIMITS_FREEWHEEL_LONG, limits);
  telemetry->limit_hits = (uint16_t)GET(TELEMETRY_LIMITS_LIMIT_HITS, limits);
  telemetry->retries = (uint16_t)GET(TELEMETRY_RETRIES_RETRIES, retries);
  return STEPLOCK_OK;
}

enum steplock_result steplock_clear_fault(const struct steplock_bus *bus) {
  uint32_t fault;
  enum steplock_result result = steplock_stop(bus, 0);
  if (result == STEPLOCK_OK) {
    result = put(bus, STEPLOCK_FAULT, STEPLOCK_FAULT_DRIVE_MASK | STEPLOCK_FAULT_WATCHDOG_MASK);
  }
  if (result == STEPLOCK_OK) { result = get(bus, STEPLOCK_FAULT, &fault); }
  if (result != STEPLOCK_OK) { return result; }
  if (!GET(FAULT_DRIVE, fault)) { return STEPLOCK_OK; }
  /* Of both drives. */
  return GET(FAULT_REASON, fault) == (uint32_t)STEPLOCK_REASON_OVER_CURRENT ? STEPLOCK_TRY_AGAIN : STEPLOCK_FAULT_LATCHED;
}

enum steplock_result steplock_set_watchdog(const struct steplock_bus *bus, uint32_t ticks) {
  const struct steplock_word word = {STEPLOCK_WATCHDOG, ticks};
  enum steplock_result result, closed;
  if (ticks > STEPLOCK_WATCHDOG_PERIOD_MASK) { return STEPLOCK_REFUSED; }
  result = need_stopped(bus);
  if (result != STEPLOCK_OK) { return result; }
  result = put(bus, STEPLOCK_LOCK, STEPLOCK_LOCK_KEY);
  if (result == STEPLOCK_OK) { result = write_config(bus, &word, 1); }
  closed = put(bus, STEPLOCK_LOCK, 0);
  return result == STEPLOCK_OK ? closed : result;
}

enum steplock_result steplock_heartbeat(const struct steplock_bus *bus) {
  return put(bus, STEPLOCK_HEARTBEAT, 1);
}

enum steplock_result steplock_enable_interrupts(const struct steplock_bus *bus, uint32_t bits) {
  if ((bits & ~STEPLOCK_INTERRUPT_ENABLE_ENABLE_MASK) != 0u) { return STEPLOCK_REFUSED; }
  return put(bus, STEPLOCK_INTERRUPT_ENABLE, bits);
}

enum steplock_result steplock_take_interrupts(const struct steplock_bus *bus, uint32_t *bits) {
  const enum steplock_result result = bits ? get(bus, STEPLOCK_INTERRUPT, bits) : STEPLOCK_REFUSED;
  return result != STEPLOCK_OK || *bits == 0u ? result : put(bus, STEPLOCK_INTERRUPT, *bits);
}

static const char *name_of(const char *const *names, size_t count, unsigned value) {
  return value < count ? names[value] : "unknown";
}

const char *steplock_state_name(unsigned state) {
  static const char *const names[] = {STEPLOCK_STATE_NAMES};
  return name_of(names, sizeof names / sizeof names[0], state);
}

const char *steplock_reason_name(unsigned reason) {
  static const char *const names[] = {STEPLOCK_REASON_NAMES};
  return name_of(names, sizeof names / sizeof names[0], reason);
}

const char *steplock_result_name(enum steplock_result result) {
  static const char *const names[] = {
      "done", "bus error", "no such drive", "not stopped", "not kept", "fault latched", "no PWM period",
      "no Hall decoder", "no such start", "refused", "try again", "wrong clock"};
  return name_of(names, sizeof names / sizeof names[0], (unsigned)result);
}
