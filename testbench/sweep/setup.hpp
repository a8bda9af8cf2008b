// What a sweep is: the seed, the kind of runs, how many, and the drives, each with a fingerprint of
// its file and its words.  Kept as setup.json beside the runs, so that what is resumed or merged
// belongs together.
//
// Run `index` is of a drive that follows from the drives' weights, and in a shard that follows from
// its seed; neither depends on how many runs there are, so a sweep can be made longer.
//
// Doc: docs/sweep.md   Test: tests/testbench/sweep_test.cpp
#pragma once

#include <string>
#include <vector>

#include "testbench/drive_file/drive_file.hpp"
#include "testbench/sweep/seed.hpp"

namespace steplock {

struct Shard {
  std::uint64_t index = 0, count = 1;  // index from 0
  bool has(RunSeed seed) const { return Draw(seed.value).bits(~std::uint64_t{0}) % count == index; }
};

// start, disturb or hard.
const char* name_of(Matrix);

struct SweepDrive {
  std::string name;         // the file's, without folder and ending
  std::string fingerprint;
  double weight = 1;
  double limit_a = 0;       // what the drive itself keeps the current to, of which peaks are a part
  bool pilot = false;       // sinusoidal: pilot pulses find the rotor, no pattern turns it
};

struct SweepSetup {
  SweepKind kind;
  design::DriveKind drive_kind = design::DriveKind::kSixStep;  // of all the drives
  std::uint64_t runs = 0;
  std::vector<SweepDrive> drives;
  std::string judged = "";  // the digest that the seed follows from (tools/starts), if it does
};

// Throws BadInput if two files have the same name, or are of two kinds of drive.
SweepSetup sweep_setup(const SweepKind&, std::uint64_t runs, const std::vector<DriveFile>&);

// The drive of each run, as an index into setup.drives.
std::vector<std::size_t> drives_of_runs(const SweepSetup&);

std::string digest(const std::string& text);  // FNV-1a, 64 bits, in hexadecimal
std::string setup_text(const SweepSetup&);                   // setup.json
SweepSetup read_setup(const std::string& path);              // throws BadInput
// Throws BadInput at `path` if the two are not parts of one sweep; their numbers of runs may differ.
void check_same_sweep(const SweepSetup& mine, const SweepSetup& other, const std::string& path);

}  // namespace steplock
