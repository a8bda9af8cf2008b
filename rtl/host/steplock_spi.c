/* See steplock_spi.h. */
#include "steplock_spi.h"

#define FRAME 7U
#define WRITES 0x80U
#define ANSWERED 0x5aU

/* The frame's head; the rest is zeros. */
static void head(uint8_t *out, unsigned first, uint32_t offset) {
  size_t i;
  for (i = 0; i < FRAME; ++i) { out[i] = 0U; }
  out[0] = (uint8_t)(first | ((offset >> 8) & 0x0fU));
  out[1] = (uint8_t)(offset & 0xffU);
}

static int write_spi(void *context, uint32_t offset, uint32_t value) {
  const struct steplock_spi *spi = (const struct steplock_spi *)context;
  uint8_t out[FRAME], in[FRAME];
  size_t i;
  if (!spi->transfer) { return 1; }
  head(out, WRITES, offset);
  for (i = 0; i < 4U; ++i) { out[2U + i] = (uint8_t)((value >> (24U - 8U * i)) & 0xffU); }
  return spi->transfer(spi->context, out, in, FRAME) == 0 && in[6] == ANSWERED ? 0 : 1;
}

static int read_spi(void *context, uint32_t offset, uint32_t *value) {
  const struct steplock_spi *spi = (const struct steplock_spi *)context;
  uint8_t out[FRAME], in[FRAME];
  size_t i;
  if (!spi->transfer) { return 1; }
  head(out, 0, offset);
  if (spi->transfer(spi->context, out, in, FRAME) != 0 || in[2] != ANSWERED) { return 1; }
  *value = 0;
  for (i = 3U; i < FRAME; ++i) { *value = (*value << 8) | in[i]; }
  return 0;
}

struct steplock_bus steplock_over_spi(struct steplock_spi *spi) {
  struct steplock_bus bus;
  bus.write = spi ? write_spi : 0;
  bus.read = spi ? read_spi : 0;
  bus.context = spi;
  return bus;
}
