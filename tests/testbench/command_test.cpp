// The program itself: exit codes, messages and files, as a user or a script meets them.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace {

namespace fs = std::filesystem;

struct Result {
  int exit_code = -1;
  std::string output;  // both streams
};

Result steplock(const std::string& arguments, bool errors = true) {
  const std::string command =
      std::string(STEPLOCK_PROGRAM) + " " + arguments + (errors ? " 2>&1" : " 2>/dev/null");
  Result r;
  std::FILE* pipe = popen(command.c_str(), "r");
  std::array<char, 4096> buffer;
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
    r.output.append(buffer.data(), n);
  }
  r.exit_code = WEXITSTATUS(pclose(pipe));
  return r;
}

const std::string kDrive = STEPLOCK_TESTS "/short.toml";

fs::path fresh(const std::string& name) {
  const fs::path path = fs::path(testing::TempDir()) / ("steplock_" + name);
  fs::remove_all(path);
  fs::create_directories(path);
  return path;
}

std::string write(const fs::path& path, const std::string& text) {
  std::ofstream(path) << text;
  return path.string();
}

TEST(Command, HelpOfEverySubCommandHasAnExample) {
  EXPECT_EQ(steplock("--help").exit_code, 0);
  for (const char* name : {"run", "sweep", "merge", "compare", "design", "plant", "keys", "new", "motors", "registers",
                           "gallery", "hold"}) {
    const Result r = steplock(std::string(name) + " --help");
    EXPECT_EQ(r.exit_code, 0) << name;
    EXPECT_NE(r.output.find("Example: steplock " + std::string(name)), r.output.npos) << r.output;
  }
}

TEST(Command, BadUsageIsExitCodeTwo) {
  EXPECT_EQ(steplock("").exit_code, 2);
  EXPECT_EQ(steplock("frobnicate").exit_code, 2);
  EXPECT_EQ(steplock("run").exit_code, 2);
  EXPECT_EQ(steplock("run " + kDrive + " --engine steam").exit_code, 2);
}

TEST(Command, ABadDriveFileIsExitCodeTwoAndLeavesNothingBehind) {
  const fs::path here = fresh("bad");
  const std::string file = write(here / "bad.toml", "[motor]\nresistence_ohm = 1\n");
  const Result r = steplock("run " + file + " --out " + (here / "out").string());
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_NE(r.output.find(file + ":2: motor.resistence_ohm is an unknown key"), r.output.npos)
      << r.output;
  EXPECT_FALSE(fs::exists(here / "out"));
}

TEST(Command, NewWritesADriveFileOfASheetAndNothingOfOneThatContradictsItself) {
  const fs::path here = fresh("new");
  const std::string file = (here / "flat.toml").string();
  const std::string sheet = "new flat --bus 24 --poles 14 --kv 179 --resistance-line 0.307 --inductance-line 0.188e-3 --rated-current 5.5 --out " + file;
  const Result wrong = steplock(sheet + " --torque-constant 0.1");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.output.find("by --torque-constant and"), wrong.output.npos) << wrong.output;
  EXPECT_FALSE(fs::exists(file));
  EXPECT_EQ(steplock(sheet).exit_code, 0);
  EXPECT_EQ(steplock("design " + file).exit_code, 0);
  const Result again = steplock(sheet);
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_NE(again.output.find("is there already"), again.output.npos) << again.output;
  EXPECT_EQ(steplock(sheet + " --force").exit_code, 0);
  EXPECT_EQ(steplock("new ../flat --bus 24").exit_code, 2);
}

// A line for each entry; an answer that is no number is asked for again.
TEST(Command, NewAsksWhenItIsToldNothing) {
  const fs::path here = fresh("asked");
  const std::string answers = write(here / "answers", "24\n14\n\n179 rpm\n179\n\n\n\n0.307\n\n0.188e-3\n\n\n5.5\n\n\n\n");
  const Result r = steplock("new asked --out " + (here / "asked.toml").string() + " < " + answers);
  EXPECT_EQ(r.exit_code, 0) << r.output;
  EXPECT_NE(r.output.find("'179 rpm' is no number"), r.output.npos) << r.output;
  EXPECT_EQ(steplock("design " + (here / "asked.toml").string()).exit_code, 0);
}

TEST(Command, APartOfAPageThatIsNotThereIsRefused) {
  const fs::path here = fresh("part");
  const std::string out = " --out " + (here / "out").string(), drives = STEPLOCK_DRIVES;
  const Result paper = steplock("paper amano2003 --section 11 --drives " + drives + out);
  EXPECT_EQ(paper.exit_code, 2);
  EXPECT_EQ(paper.output, "--section 11 is not measured: name one of 1 to 10\n");
  // Its first section is of all others.
  EXPECT_EQ(steplock("paper matsui1996 --section 1 --drives " + drives + out).output,
            "--section 1 is not measured: name one of 2 to 10\n");
  const Result range = steplock("range " + drives + "/br2804_drone.toml --from 2e6" + out);
  EXPECT_EQ(range.exit_code, 2);
  EXPECT_EQ(range.output, "--from 2e+06 leaves no speed: name one up to 1.2e+06\n");
  EXPECT_EQ(steplock("range " + drives + "/br2804_drone.toml --from nan" + out).output,
            "--from nan leaves no speed: name one up to 1.2e+06\n");
  EXPECT_FALSE(fs::exists(here / "out"));
}

TEST(Command, RunWithJsonPrintsTheSummaryItWrites) {
  const fs::path out = fresh("run");
  const Result r = steplock("run " + kDrive + " --engine fixed --angle 60 --json --trace --out " +
                                out.string(), false);
  EXPECT_EQ(r.exit_code, 0) << r.output;
  std::ostringstream file;
  file << std::ifstream(out / "summary.json").rdbuf();
  EXPECT_EQ(r.output, file.str());
  const auto j = nlohmann::json::parse(r.output);
  EXPECT_EQ(j["engine"], "fixed");
  EXPECT_EQ(j["start_angle_deg"], 60);
  EXPECT_TRUE(j["passed"].get<bool>());
  for (const char* name : {"wave.fst", "wave.gtkw", "report.html", "start.svg"}) {
    EXPECT_TRUE(fs::exists(out / name)) << name;
  }
}

TEST(Command, ARunThatFailsIsExitCodeOneAndSaysWhy) {
  const fs::path here = fresh("fails");
  std::ostringstream text;
  text << std::ifstream(kDrive).rdbuf();
  std::string drive = text.str();
  // A load beyond what the motor can give at rated voltage.
  drive += "load_step_nm = 4\n";
  const Result r = steplock("run " + write(here / "heavy.toml", drive) + " --engine float --out " +
                            (here / "out").string());
  EXPECT_EQ(r.exit_code, 1) << r.output;
  EXPECT_NE(r.output.find("FAILED:"), r.output.npos);
}

TEST(Command, DesignPrintsEveryWordAsTextAndAsJson) {
  const fs::path out = fresh("design");
  const Result text = steplock("design " + kDrive + " --out " + out.string());
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_TRUE(fs::exists(out / "bode.svg"));
  const auto j = nlohmann::json::parse(steplock("design " + kDrive + " --json", false).output);
  EXPECT_GT(j["config"].size(), 40u);
  for (const auto& word : j["config"]) {
    EXPECT_NE(text.output.find(word["name"].get<std::string>()), text.output.npos);
  }
}

TEST(Command, DesignPrintsTheWordsOfASinusoidalDriveToo) {
  const std::string file = STEPLOCK_DRIVES "/m2310p_sinusoidal.toml";
  const Result text = steplock("design " + file);
  const auto j = nlohmann::json::parse(steplock("design " + file + " --json", false).output);
  ASSERT_GT(j["config"].size(), 40u);
  for (const auto& w : j["config"]) {
    EXPECT_NE(text.output.find("  " + w["name"].get<std::string>() + " "), std::string::npos) << w;
  }
  EXPECT_EQ(j["config"][0]["word"], 1200) << "bridge.period: 24 MHz / 20 kHz";
}

TEST(Command, RunWritesPageAndWaveOfASinusoidalDriveInLockstep) {
  const fs::path out = fresh("sinusoidal");
  const std::string run = "run " STEPLOCK_DRIVES "/m2310p_sinusoidal.toml --out " + out.string();
  const Result r = steplock(run + " --lockstep --trace --json", false);
  EXPECT_EQ(r.exit_code, 0);
  const auto j = nlohmann::json::parse(r.output);
  EXPECT_TRUE(j["rtl_equals_fixed"]["equal"]);
  EXPECT_EQ(j["rtl_equals_fixed"]["clocks"], j["clocks"]);
  for (const char* name : {"report.html", "wave.fst", "wave.gtkw", "lock.csv", "steady.svg"}) {
    EXPECT_TRUE(fs::exists(out / name)) << name;
  }
  const Result compared = steplock(run + " --engine fixed --compare --json", false);
  EXPECT_EQ(compared.exit_code, 0);
  EXPECT_TRUE(nlohmann::json::parse(compared.output)["fixed_against_float"]["within"]);
}

TEST(Command, ASweepWritesWhatItPrintsAndReplaysItsRuns) {
  const fs::path out = fresh("sweep"), again = fresh("replay");
  fs::remove_all(out);
  const std::string sweep = "sweep " + kDrive + " --runs 2 --seed 3 --rtl 0 --out " + out.string();
  const Result r = steplock(sweep + " --json", false);
  EXPECT_LE(r.exit_code, 1);  // whatever became of these two
  std::ostringstream file;
  file << std::ifstream(out / "sweep.json").rdbuf();
  EXPECT_EQ(r.output, file.str());
  const auto j = nlohmann::json::parse(r.output);
  EXPECT_EQ(j["runs"], 2);
  for (const char* name : {"runs.csv", "setup.json", "sweep.html", "lock_time.svg"}) {
    EXPECT_TRUE(fs::exists(out / name)) << name;
  }
  EXPECT_EQ(steplock(sweep).exit_code, 2) << "a folder with runs is not overwritten";
  EXPECT_LE(steplock(sweep + " --resume").exit_code, 1);

  std::ifstream csv(out / "runs.csv");
  std::string header, line;
  std::getline(csv, header);
  std::getline(csv, line);
  const auto cell = [](const std::string& text, int k) {
    std::istringstream in(text);
    std::string value;
    for (; k >= 0; --k) std::getline(in, value, ',');
    return value;
  };
  const Result one = steplock("run " + kDrive + " --engine fixed --trace --json --out " + again.string() +
                              " --replay " + cell(line, 2), false);
  const auto row = nlohmann::json::parse(one.output);
  for (int k = 2; k < 28; ++k) EXPECT_EQ(row[cell(header, k)], cell(line, k)) << cell(header, k);
  EXPECT_TRUE(fs::exists(again / "wave.fst"));
}

// A sweep's runs have a scenario of their own: what the file's profile asks for has no part in them, nor in a replay.
TEST(Command, ASweepOfADriveWithAProfileIsThatOfTheDriveWithoutIt) {
  std::ostringstream text;
  text << std::ifstream(kDrive).rdbuf();
  const fs::path folder = fresh("profile"), own = fresh("without");
  const std::string with = write(folder / "short.toml", text.str() + "set_speed_s = [0.01, 0.02]\nset_speed_rpm = [1500, 2900]\n");
  fs::create_directories(folder), fs::create_directories(own);
  const auto rows = [](const std::string& file, const fs::path& out) {
    const Result r = steplock("sweep " + file + " --runs 3 --seed 3 --rtl 0 --out " + out.string());
    EXPECT_LE(r.exit_code, 1) << r.output;
    std::ostringstream csv;
    csv << std::ifstream(out / "runs.csv").rdbuf();
    return csv.str();
  };
  const std::string wanted = rows(kDrive, own / "out");
  EXPECT_EQ(rows(with, folder / "out"), wanted);
  const auto replay = [](const std::string& file, const fs::path& out) {
    return steplock("run " + file + " --engine fixed --json --replay 3408613289919824 --out " + out.string(), false).output;
  };
  EXPECT_EQ(replay(with, folder / "run"), replay(kDrive, own / "run"));
}

TEST(Command, ABadShardOrASecondDriveOfANameIsExitCodeTwo) {
  for (const char* shard : {"2/2", "1", "a/b", "0/0", "-1/2"}) {
    EXPECT_EQ(steplock("sweep " + kDrive + " --shard=" + shard).exit_code, 2) << shard;
  }
  EXPECT_EQ(steplock("sweep " + kDrive + " " + kDrive).exit_code, 2);
  EXPECT_EQ(steplock("merge /nowhere --out " + fresh("merge").string()).exit_code, 2);
}

// One gate pair on at standstill, rotor held by friction: i = V/R (1 - exp(-t R/L)), two phases.
TEST(Command, PlantReplaysGatesOntoTheGrid) {
  const fs::path here = fresh("plant");
  const std::string gates = write(here / "gates.csv",
                                  "time_s,uh,ul,vh,vl,wh,wl,load_nm\n"
                                  "0,1,0,0,1,0,0,1\n"
                                  "1e-3,1,0,0,1,0,0,1\n");
  const std::string out = (here / "plant.csv").string();
  ASSERT_EQ(steplock("plant " + kDrive + " --gates " + gates + " --out " + out + " --dt 1e-4").exit_code,
            0);
  std::ifstream in(out);
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "time_s,iu,iv,iw,vu,vv,vw,speed_rad_s,angle_rad,neutral_v,bus_v,source_a,torque_nm");
  int rows = 0;
  double t = 0, iu = 0, iv = 0;
  while (std::getline(in, line)) {
    ++rows;
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf", &t, &iu, &iv), 3);
  }
  EXPECT_EQ(rows, 11);
  EXPECT_NEAR(t, 1e-3, 1e-12);
  // 24 V behind 0.05 ohm (bus), 2 x 0.01 (switches), 2 x 0.38 ohm and 2 x 0.2 mH; the bus capacitor
  // holds the voltage up meanwhile, so the current lies between a stiff bus and none at all.
  const double stiff = 24 / 0.78 * (1 - std::exp(-1e-3 * 0.78 / 0.4e-3));
  const double soft = 24 / 0.83 * (1 - std::exp(-1e-3 * 0.83 / 0.4e-3));
  EXPECT_LT(iu, stiff * 1.0001);
  EXPECT_GT(iu, soft * 0.98);
  EXPECT_NEAR(iu, -iv, 1e-9 * iu);
}

TEST(Command, ABadGateFileIsExitCodeTwoWithItsLine) {
  const fs::path here = fresh("gates");
  const std::string gates =
      write(here / "gates.csv", "time_s,uh,ul,vh,vl,wh,wl,load_nm\n0,1,0,0,2,0,0,0\n");
  const std::string out = (here / "plant.csv").string();
  const Result r = steplock("plant " + kDrive + " --gates " + gates + " --out " + out);
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_EQ(r.output, gates + ":2: vl is \"2\"; write 0 or 1\n");
  EXPECT_FALSE(fs::exists(out));
}

TEST(Command, ADirectoryThatCannotBeWrittenIsExitCodeThree) {
  EXPECT_EQ(steplock("run " + kDrive + " --engine float --out /proc/steplock").exit_code, 3);
}

TEST(Command, MotorsOfAnySizeAreWrittenAndHeldOrNot) {
  const fs::path here = fresh("decades");
  ASSERT_EQ(steplock("motors --decades --count 2 --seed 5 --out " + here.string()).exit_code, 0);
  const Result held = steplock("hold " + (here / "decades_0000.toml").string());
  EXPECT_EQ(held.exit_code, 0) << held.output;
  EXPECT_NE(held.output.find("  1 of 1 held\n"), held.output.npos) << held.output;
  // Comparators that see no back-EMF, whatever the start does.
  std::ifstream in(here / "decades_0000.toml");
  std::stringstream text;
  text << in.rdbuf();
  std::string blind = text.str();
  const std::size_t at = blind.find("comparator_noise_v");
  blind.replace(at, blind.find('\n', at) - at, "comparator_noise_v = " + std::to_string(10));
  const Result lost = steplock("hold " + write(here / "blind.toml", blind));
  EXPECT_EQ(lost.exit_code, 1) << lost.output;
  EXPECT_NE(lost.output.find("NOT HELD"), lost.output.npos) << lost.output;
  EXPECT_NE(lost.output.find("  0 of 1 held\n"), lost.output.npos) << lost.output;
  const Result none = steplock("hold " STEPLOCK_DRIVES "/matsui1996.toml");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_NE(none.output.find("matsui1996.toml"), none.output.npos) << none.output;
}

TEST(Command, AGalleryOfAFileThatIsNotThereWritesNothing) {
  const fs::path out = fresh("gallery") / "page";
  const Result r = steplock("gallery nowhere.toml --out " + out.string());
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_FALSE(fs::exists(out));
}

TEST(Command, TheKeysPageInDocsIsWhatTheProgramPrints) {
  std::ostringstream page;
  page << std::ifstream(STEPLOCK_DOCS "/drive_file.md").rdbuf();
  EXPECT_EQ(steplock("keys").output, page.str())
      << "print it again: steplock keys > docs/drive_file.md";
}

}  // namespace
