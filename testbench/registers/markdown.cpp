#include <fmt/format.h>

#include "testbench/registers/registers.hpp"

namespace steplock::registers {
namespace {

std::string bits(const Field& f) {
  const int top = f.lsb + f.width - 1;
  return f.width == 1 ? fmt::format("{}", f.lsb) : fmt::format("{}:{}", top, f.lsb);
}

// The register as a strip of boxes, the highest bit left; a long name is cut to its box.
std::string drawing(const Register& r) {
  std::string top, middle;
  int bit = 32;
  const auto box = [&](int width, const std::string& name) {
    const int room = 3 * width - 1;
    const std::string shown = name.substr(0, std::size_t(room));
    top += "+" + std::string(std::size_t(room), '-');
    middle += fmt::format("|{:^{}}", shown, room);
    bit -= width;
  };
  for (auto f = r.fields.rbegin(); f != r.fields.rend(); ++f) {
    if (bit > f->lsb + f->width) box(bit - f->lsb - f->width, "");
    box(f->width, f->name);
  }
  if (bit > 0) box(bit, "");
  std::string numbers;
  for (int b = 31; b >= 0; --b) numbers += fmt::format("{:3}", b);
  return fmt::format("    {}\n    {}+\n    {}|\n    {}+\n", numbers, top, middle, top);
}

// How each page begins.
std::string six_step_head() {
  return
      "# Registers\n\n"
      "Printed by `steplock registers --markdown` from `hls/bus/six_step_registers.hpp` and "
      "`hls/bus/word_rows.hpp`; the\ntest `Registers.EveryPrintIsCurrent` fails when this page is "
      "stale. The same table makes the decoder in `rtl/`,\n"
      "`rtl/host/steplock_registers.h`, `rtl/host/steplock.rdl` (SystemRDL) and "
      "`rtl/host/steplock.xml` (IP-XACT).\n\n";
}
std::string sinusoidal_head() {
  return
      "# Registers of the sinusoidal drive\n\n"
      "Printed by `steplock registers --sinusoidal --markdown` from `hls/bus/sinusoidal_registers.hpp` and "
      "`hls/bus/sinusoidal_rows.hpp`; the\ntest `Registers.EveryPrintIsCurrent` fails when this page is "
      "stale. The same table makes the decoder in `rtl/`,\n"
      "`rtl/host/steplock_sinusoidal_registers.h`, `rtl/host/steplock_sinusoidal.rdl` (SystemRDL) and "
      "`rtl/host/steplock_sinusoidal.xml` (IP-XACT).\n\n"
      "Up to 0x2c, and at `SPEED_TARGET`, this is the map of [the six-step drive](six_step_registers.md), so that one driver serves both; "
      "states and reasons\nare this drive's own, and so are telemetry and words. A tick of the watchdog is 16 PWM periods.\n\n";
}

}  // namespace

std::string markdown(const Map& map) {
  const bool is_six_step = map.fields.data() == kFields.data();
  std::string page = is_six_step ? six_step_head() : sinusoidal_head();
  page +=
      "All registers have 32 bits, little-endian; byte strobes count. Addresses are bytes from the "
      "drive's base. A read of an\naddress without a register, and every write that is refused, is "
      "answered with an error (AXI: `SLVERR`) and changes nothing.\n"
      "Bits without a field read 0 and take no write.\n\n";
  if (is_six_step) {
    page +=
        "The same map stands behind AXI4-Lite, Wishbone and APB; behind SPI, where a frame is a head "
        "of 16 bits (write, three\nzeros, 12 bits of address), and either 32 bits of data and 8 of "
        "status, or, for a read, 8 of status and 32 of data: 0x5a\nis well, 0x5e an error "
        "([SPI slave](blocks/spi.md)); and once for each axis, 0x100 bytes apart, where one bus has "
        "several drives\n([axes](blocks/six_step_axes.md)).\n\n";
  } else {
    page +=
        "The same map stands behind [AXI4-Lite](blocks/sinusoidal_axi.md), [Wishbone](blocks/sinusoidal_wb.md) and "
        "[APB](blocks/sinusoidal_apb.md);\nand, in [frames](blocks/spi.md), behind [SPI](blocks/sinusoidal_spi.md).\n\n";
  }
  page += fmt::format(
      "| access | |\n|---|---|\n"
      "| ro | read only; writes are refused |\n"
      "| rw | read and write at any time |\n"
      "| rw, shadowed | read back at once, acts from the next {} on |\n"
      "| rw, stopped | a write is refused unless STATUS.stopped |\n"
      "| rw, keyed | a write is refused unless STATUS.stopped and STATUS.unlocked |\n"
      "| wo | write only, reads 0 |\n"
      "| w1c | a one clears, a zero leaves |\n\n"
      "| address | register | access | reset |\n|---|---|---|---|\n",
      is_six_step ? "PWM period" : "sample");
  for (const Register& r : registers(map)) {
    page += fmt::format("| 0x{:02x} | [{}](#{}) | {} | 0x{:08x} |\n", r.address, r.name,
                        lower(r.name), access_name(r.access), r.reset);
  }
  for (const Register& r : registers(map)) {
    page += fmt::format("\n## {}\n\nAddress 0x{:02x}, {}, reset 0x{:08x}.\n\n{}\n", r.name,
                        r.address, access_name(r.access), r.reset, drawing(r));
    page += "| bits | field | access | reset | unit | |\n|---|---|---|---|---|---|\n";
    for (const Field& f : r.fields) {
      page += fmt::format("| {} | {} | {} | {:#x} | {} | {} |\n", bits(f), f.name,
                          access_name(f.access), f.reset, f.unit, f.prose);
    }
  }
  return page;
}

}  // namespace steplock::registers
