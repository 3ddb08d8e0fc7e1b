#pragma once

#include <fmt/format.h>

#include <map>
#include <stdexcept>
#include <string>

#include "host-sim/sheet/place_parts.hpp"
#include "host-sim/sheet/sheet_check.hpp"
#include "tests/host-sim/import/support.hpp"

namespace sim::sheet {

/// Returns the text of a sheet of 200 mm by 100 mm.
inline std::string sheet_with(const std::string& parts, const std::string& more = {}) {
  return fmt::format(
      R"({{"kerfline_sheet": 1, "stock": {{"width_mm": 200, "height_mm": 100}}{}, "parts": [{}]}})",
      more,
      parts);
}

/// Drawings by name, each on a page of 100 mm by 100 mm.
using TestFiles = std::map<std::string, std::string>;

inline drawing::Drawing placed(const std::string& text, const TestFiles& files) {
  const auto read = [&files](const std::string& name) {
    const auto found = files.find(name);
    if (found == files.end()) throw std::runtime_error(name + ": No such file or directory");
    return found->second;
  };
  return place_parts(read_sheet("test.json", text), read, {});
}

/// Returns uses in which all closed contours are edges with a kerf of 0.5 mm.
inline std::vector<ContourUse> edges_of(const drawing::Drawing& drawn) {
  std::vector<ContourUse> uses;
  for (const auto& contour : drawn.contours) uses.push_back({true, contour.closed, 0.5});
  return uses;
}

inline std::vector<std::string> texts_of(const std::vector<drawing::Fault>& faults) {
  std::vector<std::string> texts;
  for (const auto& fault : faults) texts.push_back(to_string(fault, "test.json"));
  return texts;
}

}  // namespace sim::sheet
