#include "testbench/drive_file/drive_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "testbench/drive_file/renamed_keys.hpp"

namespace steplock {
namespace {

// The smallest file that is complete; line 1 is [drive].
const std::string kMinimal =
    "[drive]\n"                  // 1
    "name = \"Test\"\n"          // 2
    "source = \"nowhere\"\n"     // 3
    "[motor]\n"                  // 4
    "resistance_ohm = 0.4\n"     // 5
    "inductance_h = 0.2e-3\n"    // 6
    "flux_vs = 6e-3\n"           // 7
    "pole_pairs = 4\n"           // 8
    "inertia_kgm2 = 7e-6\n"      // 9
    "rated_current_a = 5\n"      // 10
    "[inverter]\n"               // 11
    "bus_v = 24\n"               // 12
    "[sensors]\n"                // 13
    "limit_a = 10\n"             // 14
    "[scenario]\n"               // 15
    "speed_rpm = 3000\n"         // 16
    "duration_s = 1\n";          // 17

std::string with(const std::string& from, const std::string& to) {
  std::string text = kMinimal;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return text.replace(at, from.size(), to);
}

std::string refusal(const std::string& text) {
  try {
    parse_drive_file(text, "x.toml");
  } catch (const BadInput& e) {
    return e.what();
  }
  return "accepted";
}

TEST(DriveFile, TheMinimalFileLoadsAndTakesDefaults) {
  const DriveFile file = parse_drive_file(kMinimal, "x.toml");
  EXPECT_EQ(file.settings.motor.pole_pairs, 4);
  EXPECT_EQ(file.settings.motor.resistance_ohm, 0.4);
  EXPECT_EQ(file.settings.inverter.dead_time_s, design::Settings{}.inverter.dead_time_s);
  EXPECT_FALSE(file.settings.start.ramp_rpm_s.has_value());
  EXPECT_EQ(file.line_of.at("motor.flux_vs"), 7);
}

TEST(DriveFile, AQuantityWithAUnitIsConverted) {
  const auto file = parse_drive_file(with("0.2e-3", "\"200 uH\""), "x.toml");
  EXPECT_DOUBLE_EQ(file.settings.motor.inductance_h, 200e-6);
  const auto turns = parse_drive_file(with("speed_rpm = 3000", "speed_rpm = \"50 Hz\""), "x.toml");
  EXPECT_NEAR(turns.settings.scenario.speed_rpm, 3000, 1e-9);
}

TEST(DriveFile, AnUnknownKeyIsNamedWithItsLineAndTheNearestKey) {
  EXPECT_EQ(refusal(with("pole_pairs = 4", "pole_pairs = 4\npole_pair = 4")),
            "x.toml:9: motor.pole_pair is an unknown key; did you mean pole_pairs?");
}

TEST(DriveFile, AKeyThatHadAnotherNameIsRefusedWithTheNewOne) {
  EXPECT_EQ(refusal(kMinimal + "[start]\nreset_s = 0.3\n"), "x.toml:19: start.reset_s is called align_s now; rename it");
  for (const RenamedKey& key : kRenamedKeys) {
    EXPECT_EQ(refusal(fmt::format("{}[start]\n{} = 0.3\n", kMinimal, key.was)),
              fmt::format("x.toml:19: start.{} is called {} now; rename it", key.was, key.is));
    EXPECT_NO_THROW(parse_drive_file(fmt::format("{}[start]\n{} = 0.3\n", kMinimal, key.is), "x.toml"));
  }
}

TEST(DriveFile, AKeyWithAnotherUnitInItsNameIsPointedToTheRightOne) {
  EXPECT_EQ(refusal(with("flux_vs = 6e-3", "flux_vs = 6e-3\ninductance_uh = 200")),
            "x.toml:8: motor.inductance_uh is an unknown key; did you mean inductance_h?");
}

TEST(DriveFile, AnUnknownSectionIsRefused) {
  EXPECT_EQ(refusal(kMinimal + "[motors]\nx = 1\n"),
            "x.toml:18: motors is no section of a drive file; did you mean [motor]?");
}

TEST(DriveFile, AMissingKeyNamesSectionUnitAndMeaning) {
  EXPECT_EQ(refusal(with("flux_vs = 6e-3\n", "")),
            "x.toml:4: motor.flux_vs is missing; add it in V s: "
            "peak phase back-EMF per electrical rad/s; or kv_rpm_per_v or torque_constant_nm_a or no_load_speed_rpm");
}

TEST(DriveFile, AMissingSectionIsReportedKeyByKey) {
  EXPECT_EQ(refusal(with("[inverter]\nbus_v = 24\n", "")),
            "x.toml:1: inverter.bus_v is missing; add it in V: of the source");
}

TEST(DriveFile, AWrongUnitIsRefused) {
  EXPECT_EQ(refusal(with("resistance_ohm = 0.4", "resistance_ohm = \"0.4 V\"")),
            "x.toml:5: motor.resistance_ohm = \"0.4 V\" has the wrong unit; give it in ohm");
  EXPECT_EQ(refusal(with("resistance_ohm = 0.4", "resistance_ohm = \"0.4 parsec\"")),
            "x.toml:5: motor.resistance_ohm = \"0.4 parsec\" is no quantity; "
            "write a number in ohm");
}

TEST(DriveFile, AWrongTypeIsRefused) {
  EXPECT_EQ(refusal(with("pole_pairs = 4", "pole_pairs = 4.5")),
            "x.toml:8: motor.pole_pairs is the number 4.5; give an integer");
  EXPECT_EQ(refusal(with("bus_v = 24", "bus_v = true")),
            "x.toml:12: inverter.bus_v is true; give a number in V");
  EXPECT_EQ(refusal(with("name = \"Test\"", "name = 3")),
            "x.toml:2: drive.name is the integer 3; write a text in quotes");
  EXPECT_EQ(refusal(with("pole_pairs = 4", "pole_pairs = 4\nshape = \"square\"")),
            "x.toml:9: motor.shape is \"square\"; "
            "write one of \"trapezoidal\", \"sinusoidal\", \"table\"");
  EXPECT_EQ(refusal(with("limit_a = 10", "limit_a = 10\nhall_error_deg = [1, 2]")),
            "x.toml:15: sensors.hall_error_deg is a list; give a list of three, one per phase");
}

TEST(DriveFile, AnAbsurdValueIsRefusedWithItsRange) {
  EXPECT_EQ(refusal(with("resistance_ohm = 0.4", "resistance_ohm = -0.4")),
            "x.toml:5: motor.resistance_ohm is -0.4 ohm; it must lie in 0.0001 to 1000 ohm");
  EXPECT_NE(refusal(with("bus_v = 24", "bus_v = 1e9")).find("x.toml:12: inverter.bus_v is 1e+09 V;"),
            std::string::npos);
  EXPECT_NE(refusal(with("bus_v = 24", "bus_v = nan")).find("x.toml:12: inverter.bus_v is nan V;"),
            std::string::npos);
}

TEST(DriveFile, EveryProblemIsListedInTheOrderOfLines) {
  std::string text = with("limit_a = 10", "limit_a = -1");
  text.replace(text.find("pole_pairs = 4"), 14, "pole_pairs = 0");
  const std::string lines = refusal(text);
  const std::size_t first = lines.find("x.toml:8: motor.pole_pairs"),
                    second = lines.find("\nx.toml:14: sensors.limit_a");
  EXPECT_EQ(first, 0u) << lines;
  EXPECT_NE(second, lines.npos) << lines;
}

TEST(DriveFile, BrokenTomlIsRefusedWithItsLine) {
  EXPECT_EQ(refusal("[drive]\nname = \n").substr(0, 9), "x.toml:2:");
}

TEST(DriveFile, AFileThatIsNotThereIsRefused) {
  EXPECT_THROW(load_drive_file("no/such/file.toml"), BadInput);
}

// Loads in the plant's own units: its validation must find nothing to complain about.
TEST(DriveFile, TheLoadedPlantIsSound) {
  const auto p = plant_parameters(parse_drive_file(kMinimal, "x.toml").settings);
  EXPECT_TRUE(plant::validate(p).empty());
  EXPECT_EQ(p.motor.flux, 6e-3);
  EXPECT_EQ(p.sensing.limit_threshold, 10);
}

TEST(DriveFile, TheReferencePageNamesEveryRequiredKey) {
  const std::string page = drive_file_reference();
  for (const char* key : {"`flux_vs` | V s | **required**", "## [scenario]", "`limit_a`"}) {
    EXPECT_NE(page.find(key), page.npos) << key;
  }
}

}  // namespace
}  // namespace steplock
