// A gallery: the scenario of each file run once by the fixed engine, in one table of motors and one of what they did, with the
// curves of each start.
//
// Doc: docs/gallery.md (printed)   Test: tests/testbench/gallery_test.cpp
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "testbench/drive_file/drive_file.hpp"
#include "testbench/report/figure.hpp"
#include "testbench/drive/six_step/summary.hpp"

namespace steplock {

struct GalleryEntry {
  std::string file;           // as it was named
  design::Settings settings;
  Summary summary;
  Figure start;               // speed and current, from rest until a little after the set speed; no panels if there is no curve
};

// Throws Stopped where progress() returns false.
GalleryEntry gallery_entry(const DriveFile&, const std::function<bool(double done)>& progress = {});
// Markdown; the figures stand in figures/ beside it.
std::string gallery_page(const std::vector<GalleryEntry>&);

}  // namespace steplock
