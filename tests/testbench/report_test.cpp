#include "testbench/drive/six_step/report.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "testbench/drive/six_step/csv.hpp"
#include "testbench/report/page.hpp"
#include "testbench/report/zoom.hpp"
#include "tests/testbench/own_folder.hpp"
#include "tests/testbench/short_drive.hpp"

namespace steplock {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

TEST(Report, AllFilesAreWrittenAndThePageNeedsNoOther) {
  const DriveFile file = open_drive_file(STEPLOCK_TESTS "/short.toml");
  const RunOptions options{.engine = EngineKind::kFloat};
  const Record record = run_drive(file.settings, options);
  const Summary summary = summarise(file.settings, options, record);
  const fs::path out = own_folder();
  const ReportFiles files = write_report(out, file.settings, summary, record, false);
  EXPECT_TRUE(files.warnings.empty());
  for (const char* name : {"summary.json", "run.csv", "lock.csv", "steady.csv", "start.svg", "lock.svg",
                           "steady.svg", "load_step.svg", "power.svg", "report.html"}) {
    EXPECT_GT(fs::file_size(out / name), 100u) << name;
  }
  std::string page = read(out / "report.html");
  const std::string library = zoom_head();
  ASSERT_NE(page.find(library), page.npos) << "what it zooms with is in it; that this loads nothing, zoom.sh sees";
  page.erase(page.find(library), library.size());
  EXPECT_NE(page.find("<svg"), page.npos);
  EXPECT_NE(page.find("passed"), page.npos);
  for (const char* outside : {"href=\"http", "src=", "@import", "<link"}) {
    EXPECT_EQ(page.find(outside), page.npos) << outside;
  }
  EXPECT_EQ(nlohmann::json::parse(read(out / "summary.json"))["engine"], "float");
}

TEST(Report, AFigureThatZoomsHasItsPointsAndNothingThatEndsItsScript) {
  const Figure f{.name = "f", .title = "T", .axis = "time, s",
                 .panels = {{.label = "</script>", .curves = {{"a", "#000000", {{0, 1}, {0.25, std::nan("")}}}}}},
                 .marks = {{0.5, "load"}}};
  const std::string body = zoom_body(f);
  EXPECT_NE(body.find(R"("x":[0,0.25],"y":[1,null])"), body.npos) << body;
  EXPECT_NE(body.find(R"("marks":[[0.5,"load"]])"), body.npos) << body;
  EXPECT_EQ(body.find("</script>"), body.rfind("</script>")) << body;
  Figure logarithmic = f;
  logarithmic.logarithmic = true;
  EXPECT_EQ(zoom_body(logarithmic), "");
}

TEST(Report, WithoutTheLibraryAPageHasItsPicturesAlone) { EXPECT_EQ(zoom_head(own_folder()), ""); }

TEST(Report, CsvHasOneLineASampleAndAsManyCellsAsNames) {
  Sample s;
  s.time = 0.5;
  s.plant.speed = 100;
  const std::string csv = samples_csv({s, s, s}, 4);
  std::istringstream in(csv);
  std::string line, header;
  std::getline(in, header);
  int lines = 0;
  while (std::getline(in, line)) {
    ++lines;
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), std::count(header.begin(), header.end(), ','));
  }
  EXPECT_EQ(lines, 3);
  EXPECT_NE(csv.find("\n0.500000000,954.93,"), csv.npos);  // 100 rad/s
}

TEST(Report, TextOfADriveFileCannotBreakThePage) {
  EXPECT_EQ(escaped("<b>&\"x\"</b>"), "&lt;b&gt;&amp;&quot;x&quot;&lt;/b&gt;");
}

}  // namespace
}  // namespace steplock
