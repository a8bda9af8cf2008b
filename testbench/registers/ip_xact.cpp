#include <fmt/format.h>

#include "testbench/registers/registers.hpp"

namespace steplock::registers {
namespace {

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  }
  return out;
}

const char* access(Access a) {
  return a == Access::kReadOnly    ? "read-only"
         : a == Access::kWriteOnly ? "write-only"
                                   : "read-write";
}

std::string field_text(const Field& f) {
  const std::string unit = *f.unit != 0 ? fmt::format(" Unit: {}.", f.unit) : "";
  return fmt::format(
      "            <ipxact:field>\n"
      "              <ipxact:name>{}</ipxact:name>\n"
      "              <ipxact:description>{}</ipxact:description>\n"
      "              <ipxact:bitOffset>{}</ipxact:bitOffset>\n"
      "              <ipxact:resets><ipxact:reset><ipxact:value>{}</ipxact:value>"
      "</ipxact:reset></ipxact:resets>\n"
      "              <ipxact:bitWidth>{}</ipxact:bitWidth>\n"
      "              <ipxact:access>{}</ipxact:access>\n{}"
      "            </ipxact:field>\n",
      f.name, escaped(f.prose + unit), f.lsb, f.reset, f.width, access(f.access),
      f.access == Access::kWriteOneToClear
          ? "              <ipxact:modifiedWriteValue>oneToClear</ipxact:modifiedWriteValue>\n"
          : "");
}

}  // namespace

std::string ip_xact(const Map& map) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<!-- Printed by `steplock registers{}` (its option ip-xact); do not edit. -->\n"
      "<ipxact:component xmlns:ipxact=\"http://www.accellera.org/XMLSchema/IPXACT/1685-2014\"\n"
      "    xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\"\n"
      "    xsi:schemaLocation=\"http://www.accellera.org/XMLSchema/IPXACT/1685-2014\n"
      "    http://www.accellera.org/XMLSchema/IPXACT/1685-2014/index.xsd\">\n"
      "  <ipxact:vendor>steplock</ipxact:vendor>\n"
      "  <ipxact:library>motor</ipxact:library>\n"
      "  <ipxact:name>{}</ipxact:name>\n"
      "  <ipxact:version>{}.{}.{}</ipxact:version>\n"
      "  <ipxact:memoryMaps>\n"
      "    <ipxact:memoryMap>\n"
      "      <ipxact:name>registers</ipxact:name>\n"
      "      <ipxact:addressBlock>\n"
      "        <ipxact:name>drive</ipxact:name>\n"
      "        <ipxact:baseAddress>0</ipxact:baseAddress>\n"
      "        <ipxact:range>{}</ipxact:range>\n"
      "        <ipxact:width>32</ipxact:width>\n"
      "        <ipxact:usage>register</ipxact:usage>\n",
      // No two hyphens in a row in a comment of XML.
      std::string_view(map.option).empty() ? "" : fmt::format(", for the {} drive,", map.drive),
      map.top, kMapVersion >> 16, kMapVersion >> 8 & 255, kMapVersion & 255, kMapBytes);
  for (const Register& r : registers(map)) {
    text += fmt::format(
        "        <ipxact:register>\n"
        "          <ipxact:name>{}</ipxact:name>\n"
        "          <ipxact:addressOffset>{}</ipxact:addressOffset>\n"
        "          <ipxact:size>32</ipxact:size>\n",
        r.name, r.address);
    for (const Field& f : r.fields) text += field_text(f);
    text += "        </ipxact:register>\n";
  }
  return text +
         "      </ipxact:addressBlock>\n"
         "      <ipxact:addressUnitBits>8</ipxact:addressUnitBits>\n"
         "    </ipxact:memoryMap>\n"
         "  </ipxact:memoryMaps>\n"
         "</ipxact:component>\n";
}

}  // namespace steplock::registers
