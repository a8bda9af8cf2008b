// What is printed of the register map is what is committed, and says what the table says.
#include "testbench/registers/registers.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

#include "model/design/design.hpp"
#include "model/design/config.hpp"
#include "testbench/drive/six_step/config.hpp"
#include "testbench/drive/sinusoidal/config.hpp"
#include "tests/testbench/short_drive.hpp"

namespace steplock::registers {
namespace {

std::string committed(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(STEPLOCK_DOCS "/../" + path).rdbuf();
  return text.str();
}

std::string memory_maps(const std::string& xml) {
  const std::size_t from = xml.find("<ipxact:memoryMaps>"), to = xml.find("</ipxact:memoryMaps>");
  EXPECT_LT(from, to);
  return xml.substr(from, to - from);
}

TEST(Registers, EveryPrintIsCurrent) {
  for (const Map* map : {&six_step(), &sinusoidal()}) {
    const std::string stem = std::string("rtl/host/") + map->stem;
    EXPECT_EQ(markdown(*map), committed(page_of(*map))) << "steplock registers" << map->option << " --markdown";
    EXPECT_EQ(c_header(*map), committed(stem + "_registers.h")) << "--c-header";
    EXPECT_EQ(systemrdl(*map), committed(stem + ".rdl")) << "--systemrdl";
    EXPECT_EQ(memory_maps(ip_xact(*map)), memory_maps(committed(stem + ".xml"))) << "tools/ip_xact puts the rest around it";
  }
}

int count(const std::string& text, const std::string& what) {
  int n = 0;
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++n;
  return n;
}

TEST(Registers, EveryFieldIsInEveryPrint) {
  for (const Map* map : {&six_step(), &sinusoidal()}) {
    const int fields = int(map->fields.size()), all = int(registers(*map).size());
    EXPECT_EQ(count(c_header(*map), "_MASK "), fields);
    EXPECT_EQ(count(systemrdl(*map), "    field {"), fields);
    EXPECT_EQ(count(systemrdl(*map), "  reg {"), all);
    EXPECT_EQ(count(ip_xact(*map), "<ipxact:field>"), fields);
    EXPECT_EQ(count(ip_xact(*map), "<ipxact:register>"), all);
    EXPECT_EQ(count(markdown(*map), "\n## "), all);
  }
}

TEST(Registers, ADrawingHasAColumnForEveryBit) {
  std::istringstream page(markdown(six_step()) + markdown(sinusoidal()));
  int drawings = 0;
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("    |")) continue;
    ++drawings;
    EXPECT_EQ(line.size(), 4 + 3 * 32 + 1u) << line;
  }
  EXPECT_EQ(drawings, int(registers(six_step()).size() + registers(sinusoidal()).size()));
}

// The initialisers, written into empty registers, give the words they were made of.
TEST(Registers, TheInitialisersOfADriveAreItsWords) {
  const design::Settings s = short_drive();
  const double clock_hz = s.control.clock_hz;
  const auto parameters = design::design_drive(s).parameters;
  const SixStepConfig config = hls_config(design::quantise(parameters, clock_hz).config);
  const std::string text = config_c_header(config, "short", clock_hz);
  int read = 0;
  const auto check = [&](const auto& row) {
    using Word = typename std::remove_cvref_t<decltype(row)>::Word;
    const std::regex line("STEPLOCK_" + std::string(row.group) + ", 0x([0-9a-f]+)u");
    std::smatch found;
    ASSERT_TRUE(std::regex_search(text, found, line)) << row.group;
    const auto value = std::uint32_t(std::stoul(found[1], nullptr, 16));
    EXPECT_EQ((value & mask_of(row)) >> row.lsb, bits_of(Word::of(config)).raw()) << row.name;
    ++read;
  };
  std::apply([&](const auto&... row) { (check(row), ...); }, kWordRows);
  EXPECT_EQ(read, 60);
  EXPECT_EQ(count(text, "    {STEPLOCK_"), 31);
  EXPECT_NE(text.find(fmt::format("    {{STEPLOCK_CLOCK, {:.0f}u}},", clock_hz / 1e3)), text.npos);
}

TEST(Registers, TheInitialisersOfASinusoidalDriveAreItsWords) {
  const design::Settings s = open_drive_file(STEPLOCK_DRIVES "/matsui1996.toml").settings;
  const SinusoidalConfig config = sinusoidal::config_of(s);
  const std::string text = config_c_header(config, "matsui", s.control.clock_hz);
  int read = 0;
  const auto check = [&](const auto& row) {
    using Word = typename std::remove_cvref_t<decltype(row)>::Word;
    const std::regex line("STEPLOCK_SINUSOIDAL_" + std::string(row.group) + ", 0x([0-9a-f]+)u");
    std::smatch found;
    ASSERT_TRUE(std::regex_search(text, found, line)) << row.group;
    const auto value = std::uint32_t(std::stoul(found[1], nullptr, 16));
    EXPECT_EQ((value & mask_of(row)) >> row.lsb, bits_of(Word::of(config)).raw()) << row.name;
    ++read;
  };
  std::apply([&](const auto&... row) { (check(row), ...); }, kSinusoidalWordRows);
  EXPECT_EQ(read, 54);
  EXPECT_EQ(count(text, "    {STEPLOCK_"), 32);
  EXPECT_NE(text.find("    {STEPLOCK_SINUSOIDAL_CLOCK, 24000u},"), text.npos);
  EXPECT_NE(text.find("#include \"steplock_sinusoidal.h\""), text.npos);
  EXPECT_NE(text.find(std::to_string(int(config.bridge.period.raw()))), text.npos);
}

// Every word that the design library names is tied to the port of that name; the tests of boards tell
// whether the module is a whole one.
TEST(Registers, TheConstantsAroundTheStandaloneDriveAreItsWords) {
  const design::Settings s = short_drive();
  const double clock_hz = s.control.clock_hz;
  const auto quantised = design::quantise(design::design_drive(s).parameters, clock_hz);
  const std::string text = config_verilog(hls_config(quantised.config), "short", clock_hz);
  for (const auto& row : quantised.rows) {
    std::string port = "config_" + row.name + "_i";
    std::ranges::replace(port, '.', '_');
    const std::regex tie("\\." + port + "\\(([0-9]+)'d([0-9]+)\\)");
    std::smatch found;
    ASSERT_TRUE(std::regex_search(text, found, tie)) << port;
    // The library counts these two in units of the bits that the filter reads.
    const int unused = row.name == "loop.alpha" ? 1 : row.name == "loop.scale" ? 4 : 0;
    EXPECT_EQ(std::stoul(found[2]), std::uint64_t{row.word} << unused) << port;
  }
  EXPECT_GT(quantised.rows.size(), 40u);
  EXPECT_EQ(count(text, "      .config_"), 60);
  EXPECT_NE(text.find("12000000 Hz"), std::string::npos);
}

TEST(Registers, AStandaloneDriveThatNeverAsksTheHallDecoderIsPrintedWithoutIt) {
  SixStepConfig config;
  const auto printed = [&] { return config_verilog(config, "drive", 12e6); };
  EXPECT_NE(printed().find("#(.WITH_HALL_DECODER(0), .WITH_RAMP(1), .WITH_FOLLOWER(0)) drive ("), std::string::npos);
  config.start.method = Method::kFollow;
  EXPECT_NE(printed().find(".WITH_RAMP(0), .WITH_FOLLOWER(1)) drive ("), std::string::npos) << "one start alone";
  config.start.detect_spin = 1;
  EXPECT_NE(printed().find(".WITH_HALL_DECODER(1)"), std::string::npos) << "it looks for a rotor that turns";
  config.start.detect_spin = 0;
  config.source = Source::kHall;
  EXPECT_NE(printed().find(".WITH_HALL_DECODER(1)"), std::string::npos) << "it has Hall sensors";
}

TEST(Registers, TheConstantsAroundTheSinusoidalStandaloneDriveAreItsWords) {
  const design::Settings s = open_drive_file(STEPLOCK_DRIVES "/ipm_2k2.toml").settings;
  const auto quantised = design::sinusoidal::quantise(s);
  const std::string text = config_verilog(sinusoidal::hls_config(quantised.config),
                                         sinusoidal::adc_config_of(s), "ipm", 24e6);
  for (const auto& row : quantised.rows) {
    std::string port = "config_" + row.name + "_i";
    std::ranges::replace(port, '.', '_');
    const std::regex tie("\\." + port + "\\(([0-9]+)'d([0-9]+)\\)");
    std::smatch found;
    ASSERT_TRUE(std::regex_search(text, found, tie)) << port;
    EXPECT_EQ(std::stoul(found[2]), std::uint64_t(row.word)) << port;
  }
  EXPECT_GT(quantised.rows.size(), 40u);
  EXPECT_NE(text.find(".config_sequence_pilot_i(1'd1)"), text.npos);
  EXPECT_NE(text.find(".config_sequence_arbitrary_i(1'd0)"), text.npos);
  // Every port is passed through or tied.
  const std::string rtl = committed("rtl/sinusoidal_standalone.sv");
  const std::string ports = rtl.substr(0, rtl.find(");"));
  EXPECT_EQ(count(text, "      ."), count(ports, "put  logic") + count(ports, "put logic"));
}

// 20 MHz of SCLK, 300 ns to acquire; and the period has to hold a sample.
TEST(Registers, TheConvertersWordsFollowTheClock) {
  design::Settings s = open_drive_file(STEPLOCK_DRIVES "/m2310p_sinusoidal.toml").settings;
  const auto config = [&](double clock_hz) {
    s.control.clock_hz = clock_hz;
    return sinusoidal::adc_config_of(s);
  };
  EXPECT_EQ(config(24e6).half, 1);
  EXPECT_EQ(config(24e6).quiet, 8);
  EXPECT_EQ(config(40e6).half, 1);
  EXPECT_EQ(config(40.1e6).half, 2);
  EXPECT_EQ(config(100e6).half, 3);
  EXPECT_EQ(config(100e6).quiet, 30);
  EXPECT_NO_THROW(config(11.8e6));
  EXPECT_THROW(config(11.5e6), std::invalid_argument);
}

}  // namespace
}  // namespace steplock::registers
