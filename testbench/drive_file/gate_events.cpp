#include "testbench/drive_file/gate_events.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

#include "testbench/drive_file/csv_cells.hpp"
#include "testbench/drive_file/drive_file.hpp"

namespace steplock {
namespace {

constexpr std::string_view kHeader = "time_s,uh,ul,vh,vl,wh,wl,load_nm";
constexpr std::size_t kColumns = 8;

}  // namespace

std::vector<plant::GateEvent> read_gate_events(std::istream& in, const std::string& path) {
  std::vector<plant::GateEvent> events;
  std::string text;
  int line = 0;
  const auto refuse = [&](const std::string& what) {
    throw BadInput(fmt::format("{}:{}: {}", path, line == 0 ? 1 : line, what));
  };
  const auto number = [&](std::string_view cell, const char* column) {
    double x = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), x);
    if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(x)) {
      refuse(fmt::format("{} is \"{}\"; write a number", column, cell));
    }
    return x;
  };
  const auto gate = [&](std::string_view cell, std::string_view column) {
    if (cell != "0" && cell != "1") refuse(fmt::format("{} is \"{}\"; write 0 or 1", column, cell));
    return cell == "1";
  };

  const std::vector<std::string_view> names = csv_cells(kHeader);
  while (std::getline(in, text)) {
    ++line;
    if (text.ends_with('\r')) text.pop_back();
    if (line == 1) {
      if (csv_cells(text) != names) refuse(fmt::format("the first line must be {}", kHeader));
      continue;
    }
    if (text.empty()) continue;
    const std::vector<std::string_view> cells = csv_cells(text);
    if (cells.size() != kColumns) {
      refuse(fmt::format("{} columns; write {}: {}", cells.size(), kColumns, kHeader));
    }
    plant::GateEvent event;
    event.time = number(cells[0], "time_s");
    if (event.time < 0) refuse(fmt::format("time_s is {:g}; start at 0 or later", event.time));
    if (!events.empty() && event.time < events.back().time) {
      refuse(fmt::format("time_s falls from {:g} to {:g}; sort the events", events.back().time,
                         event.time));
    }
    bool* const gates[] = {&event.gates.uh, &event.gates.ul, &event.gates.vh,
                           &event.gates.vl, &event.gates.wh, &event.gates.wl};
    for (std::size_t i = 0; i < 6; ++i) *gates[i] = gate(cells[i + 1], names[i + 1]);
    event.load_torque = number(cells[7], "load_nm");
    if (event.load_torque < 0) {
      refuse(fmt::format("load_nm is {:g}; an opposing torque is not negative", event.load_torque));
    }
    events.push_back(event);
  }
  if (line == 0) refuse(fmt::format("the file is empty; the first line must be {}", kHeader));
  if (events.empty()) refuse("no events; add at least one line below the header");
  return events;
}

}  // namespace steplock
