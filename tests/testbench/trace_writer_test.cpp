// Writes a wave and reads it back with GTKWave's own reader.
#include "testbench/drive/six_step/recorder.hpp"

#include <gtest/gtest.h>
#include <gtkwave/fstapi.h>

#include <filesystem>
#include <map>

#include "tests/testbench/own_folder.hpp"

namespace steplock {
namespace {

struct Wave {
  std::map<std::string, fstHandle> signals;
  std::map<fstHandle, std::vector<std::pair<std::uint64_t, std::string>>> changes;
};

void collect(void* user, std::uint64_t time, fstHandle handle, const unsigned char* value) {
  static_cast<Wave*>(user)->changes[handle].emplace_back(time, reinterpret_cast<const char*>(value));
}
void collect_text(void* user, std::uint64_t time, fstHandle handle, const unsigned char* value,
                  std::uint32_t length) {
  static_cast<Wave*>(user)->changes[handle].emplace_back(
      time, std::string(reinterpret_cast<const char*>(value), length));
}

Wave read_wave(const std::string& path) {
  Wave wave;
  void* file = fstReaderOpen(path.c_str());
  EXPECT_NE(file, nullptr);
  if (file == nullptr) return wave;
  while (const fstHier* h = fstReaderIterateHier(file)) {
    if (h->htyp == FST_HT_VAR) wave.signals[h->u.var.name] = h->u.var.handle;
  }
  fstReaderSetFacProcessMaskAll(file);
  fstReaderIterBlocks2(file, collect, collect_text, &wave, nullptr);
  fstReaderClose(file);
  return wave;
}

TEST(TraceWriter, EveryChangeIsInTheWaveAtItsTime) {
  const std::string path = (own_folder() / "wave.fst").string();
  {
    TraceWriter writer(path, SixStepRecording::wave(), 4);
    const SixStepRecording recording(RecorderSettings{});
    Sample s;
    s.watch.bits = static_cast<std::uint32_t>(State::kAlign) << Watch::kState | 1u;  // uh on
    recording.trace_logic(writer, s);
    s.time = 2e-6;
    s.watch.bits = static_cast<std::uint32_t>(State::kRun) << Watch::kState | 5u << Watch::kStep;
    recording.trace_logic(writer, s);
    s.time = 3e-6;
    s.plant.current = {1.5, -1.5, 0};
    recording.trace_analog(writer, s);
    writer.pins(4e-6, plant::Pins{.comparator = {false, true, false}});
  }
  Wave wave = read_wave(path);
  using Changes = std::vector<std::pair<std::uint64_t, std::string>>;
  EXPECT_EQ(wave.changes[wave.signals.at("uh")], (Changes{{0, "1"}, {2000000, "0"}}));
  EXPECT_EQ(wave.changes[wave.signals.at("step")].back(), (Changes::value_type{2000000, "101"}));
  EXPECT_EQ(wave.changes[wave.signals.at("state")], (Changes{{0, "align"}, {2000000, "run"}}));
  EXPECT_EQ(wave.changes[wave.signals.at("comparator_v")].back(),
            (Changes::value_type{4000000, "1"}));
  const auto& current = wave.changes[wave.signals.at("iu_a")];
  ASSERT_FALSE(current.empty());
  EXPECT_EQ(current.back().first, 3000000u);
  EXPECT_EQ(std::stod(current.back().second), 1.5);
}

TEST(TraceWriter, TheSaveFileNamesOnlySignalsOfTheWave) {
  const std::string path = (own_folder() / "names.fst").string();
  { TraceWriter writer(path, SixStepRecording::wave(), 4); SixStepRecording(RecorderSettings{}).trace_logic(writer, Sample{}); }
  const Wave wave = read_wave(path);
  const std::string save = gtkwave_save_file("names.fst", SixStepRecording::wave());
  EXPECT_NE(save.find("[dumpfile] \"names.fst\""), save.npos);
  std::size_t named = 0;
  for (std::size_t at = 0; (at = save.find('\n', at)) != save.npos;) {
    ++at;
    for (const std::string scope : {"drive.", "plant."}) {
      if (save.compare(at, scope.size(), scope) != 0) continue;
      const std::string name = save.substr(at + 6, save.find_first_of("[\n", at) - at - 6);
      EXPECT_TRUE(wave.signals.contains(name)) << name;
      ++named;
    }
  }
  EXPECT_GE(named, 30u);
}

TEST(TraceWriter, AFileThatCannotBeMadeIsSaid) {
  EXPECT_THROW(TraceWriter("no/such/directory/wave.fst", SixStepRecording::wave(), 4), std::runtime_error);
}

}  // namespace
}  // namespace steplock
