#include "testbench/sweep/setup.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "model/design/design.hpp"
#include "model/design/sinusoidal/design.hpp"
#include "model/design/sinusoidal/config.hpp"
#include "model/design/config.hpp"

namespace steplock {
namespace {

using Json = nlohmann::ordered_json;

// Of the file and of what the design library makes of it: either may change the runs.
std::string fingerprint(const DriveFile& file) {
  std::ostringstream text;
  text << std::ifstream(file.path, std::ios::binary).rdbuf();
  const design::Settings& s = file.settings;
  const auto add = [&](const auto& quantised) {
    for (const auto& word : quantised.rows) text << ' ' << word.word;
  };
  if (s.drive.kind == design::DriveKind::kSinusoidal) {
    add(design::sinusoidal::quantise(s));
  } else {
    add(design::quantise(design::design_drive(s).parameters, s.control.clock_hz));
  }
  return digest(text.str());
}

}  // namespace

const char* name_of(Matrix m) {
  constexpr const char* kNames[] = {"start", "disturb", "hard"};
  return kNames[static_cast<int>(m)];
}

std::string digest(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return fmt::format("{:016x}", hash);
}

SweepSetup sweep_setup(const SweepKind& kind, std::uint64_t runs, const std::vector<DriveFile>& files) {
  SweepSetup setup{.kind = kind, .runs = runs, .drives = {}};
  if (!files.empty()) setup.drive_kind = files.front().settings.drive.kind;
  std::set<std::string> names;
  for (const DriveFile& file : files) {
    const std::string name = std::filesystem::path(file.path).stem().string();
    if (!names.insert(name).second) {
      throw BadInput(fmt::format("{}:1: a second drive of the name {}; name each file once", file.path,
                                 name));
    }
    if (file.settings.drive.kind != setup.drive_kind) {
      throw BadInput(fmt::format("{}:1: drive.kind is another than that of {}; sweep each kind by itself",
                                 file.path, files.front().path));
    }
    // What the drive itself keeps the current to; a sinusoidal one's over-current level would end the run.
    const bool sinusoidal = setup.drive_kind == design::DriveKind::kSinusoidal;
    const double limit_a = sinusoidal ? design::sinusoidal::current_limit(file.settings) : file.settings.sensors.limit_a;
    setup.drives.push_back({name, fingerprint(file), file.settings.envelope.weight, limit_a,
                            sinusoidal && file.settings.sinusoidal_start.by == design::StartBy::kPilot});
  }
  return setup;
}

// Each run goes to the drive that is farthest behind its share.
std::vector<std::size_t> drives_of_runs(const SweepSetup& setup) {
  double weights = 0;
  for (const SweepDrive& d : setup.drives) weights += d.weight;
  std::vector<std::uint64_t> given(setup.drives.size());
  std::vector<std::size_t> all;
  for (std::uint64_t k = 0; k < setup.runs; ++k) {
    std::size_t next = 0;
    double most = -1;
    for (std::size_t d = 0; d < given.size(); ++d) {
      const double share = setup.drives[d].weight / weights;
      const double behind = share * static_cast<double>(k + 1) - static_cast<double>(given[d]);
      // Rounding must not decide between equals.
      if (behind > most + 1e-9) next = d, most = behind;
    }
    ++given[next];
    all.push_back(next);
  }
  return all;
}

std::string setup_text(const SweepSetup& s) {
  Json j;
  const bool sinusoidal = s.drive_kind == design::DriveKind::kSinusoidal;
  if (sinusoidal) j["drive_kind"] = "sinusoidal";  // what says nothing is of six-step drives
  if (!s.judged.empty()) j["judged"] = s.judged;
  j["seed"] = s.kind.seed;
  j["matrix"] = name_of(s.kind.matrix);
  j["outside"] = s.kind.outside;
  j["rtl"] = s.kind.rtl;
  j["runs"] = s.runs;
  for (const SweepDrive& d : s.drives) {
    j["drives"].push_back({{"name", d.name}, {"fingerprint", d.fingerprint}, {"weight", d.weight}});
    if (d.limit_a > 0) j["drives"].back()["limit_a"] = d.limit_a;
    if (d.pilot) j["drives"].back()["pilot"] = true;
  }
  return j.dump(2) + "\n";
}

SweepSetup read_setup(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw BadInput(fmt::format("{}:1: cannot read this file; name a folder of a sweep", path));
  try {
    const Json j = Json::parse(in);
    SweepSetup s;
    const std::string matrix = j.at("matrix");
    s.kind = {.matrix = matrix == "disturb" ? Matrix::kDisturb : matrix == "hard" ? Matrix::kHard : Matrix::kStart,
              .seed = j.at("seed"),
              .outside = j.at("outside"),
              .rtl = j.at("rtl")};
    if (j.value("drive_kind", "six_step") == "sinusoidal") s.drive_kind = design::DriveKind::kSinusoidal;
    s.judged = j.value("judged", "");
    s.runs = j.at("runs");
    for (const Json& d : j.at("drives")) {
      s.drives.push_back({d.at("name"), d.at("fingerprint"), d.at("weight"), d.value("limit_a", 0.0), d.value("pilot", false)});
    }
    return s;
  } catch (const Json::exception& e) {
    throw BadInput(fmt::format("{}:1: {}; begin the sweep anew in another folder", path, e.what()));
  }
}

void check_same_sweep(const SweepSetup& mine, const SweepSetup& other, const std::string& path) {
  const auto need = [&](bool same, const std::string& what) {
    if (!same) {
      throw BadInput(fmt::format("{}:1: {}; these runs do not belong together, use another folder",
                                 path, what));
    }
  };
  const SweepKind &a = mine.kind, &b = other.kind;
  need(mine.drive_kind == other.drive_kind, "the drives are of the other kind");
  need(a.matrix == b.matrix, "this is the other matrix");
  need(a.seed == b.seed, fmt::format("the seed is {}, not {}", b.seed, a.seed));
  need(a.outside == b.outside, fmt::format("outside is {:g}, not {:g}", b.outside, a.outside));
  need(a.rtl == b.rtl, fmt::format("the RTL's share is {:g}, not {:g}", b.rtl, a.rtl));
  need(mine.drives.size() == other.drives.size(),
       fmt::format("{} drives, not {}", other.drives.size(), mine.drives.size()));
  for (std::size_t k = 0; k < mine.drives.size(); ++k) {
    const SweepDrive &x = mine.drives[k], &y = other.drives[k];
    need(x.name == y.name, fmt::format("drive {} is {}, not {}", k, y.name, x.name));
    need(x.fingerprint == y.fingerprint,
         fmt::format("{} has changed, its file or its words", x.name));
  }
}

}  // namespace steplock
