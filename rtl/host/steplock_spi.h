/* The drive's registers over SPI, for a companion processor beside six_step_spi or sinusoidal_spi: C99, no allocation.
 *
 *     struct steplock_spi spi = {my_transfer, my_port};
 *     struct steplock_bus bus = steplock_over_spi(&spi);
 *
 * and all of steplock.h and steplock_sinusoidal.h works over it.  Mode 0, SCLK at most an eighth of the drive's clock.
 * Frames: docs/blocks/spi.md.  Test: tests/hls/six_step_spi_test.cpp, tests/hls/sinusoidal_spi_test.cpp
 */
#ifndef STEPLOCK_SPI_H
#define STEPLOCK_SPI_H

#include "steplock.h"

#ifdef __cplusplus
extern "C" {
#endif

struct steplock_spi {
  /* Select low, `bytes` bytes out and in, highest bit first, select high; 0 when that was done. */
  int (*transfer)(void *context, const uint8_t *out, uint8_t *in, size_t bytes);
  void *context;
};

/* `spi` is kept by its address: let it live as long as the bus. */
struct steplock_bus steplock_over_spi(struct steplock_spi *spi);

#ifdef __cplusplus
}
#endif
#endif
