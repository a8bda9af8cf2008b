#!/usr/bin/env bash
# cross_compile.sh STEPLOCK DRIVE.toml OUT [EXTRA_OPTION...]: a program for a RISC-V of 32 and of 64 bits, of
# the C driver and a drive's printed words; strict C99, without warnings, and without a library but libgcc.
set -euo pipefail
steplock=$1 drive=$2 out=$3
shift 3
mkdir -p "$out"
cp "$drive" "$out/my_motor.toml"
"$steplock" design "$out/my_motor.toml" --c-header >"$out/my_motor.h"
for target in rv32imc:ilp32 rv64imac:lp64; do
  # medany: the driver's home may be anywhere.
  riscv64-unknown-elf-gcc "-march=${target%:*}" "-mabi=${target#*:}" -mcmodel=medany -std=c99 -ffreestanding -Os \
    -Wall -Wextra -Werror -Wpedantic -Wconversion -Wshadow -Wstrict-prototypes -Irtl/host -I"$out" "$@" \
    -nostdlib -Wl,-e,main tests/testbench/firmware.c rtl/host/steplock.c rtl/host/steplock_spi.c -lgcc -o "$out/firmware.${target%:*}"
  riscv64-unknown-elf-size "$out/firmware.${target%:*}"
done
