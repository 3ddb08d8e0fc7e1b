#include "host-sim/pocket/mill_tool.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "host-sim/cut/named_values.hpp"
#include "host-sim/report/nearest_name.hpp"

namespace sim::pocket {
namespace {

constexpr std::string_view kForm = "tool `NAME: diameter=MM, key=value`";

/// A key that a tool may have, with the range of its value.
struct ToolKey {
  std::string_view name;
  std::optional<double> MillTool::*value;
  double least;
  double most;
  const char* unit;
};
constexpr std::array<ToolKey, 8> kKeys{{
    {"angle", &MillTool::v_angle_deg, 1.0, 175.0, "degrees"},
    {"flutes", &MillTool::flutes, 1.0, 100.0, "flutes"},
    {"feed-per-tooth", &MillTool::feed_per_tooth_mm, 1.0e-4, 100.0, "mm"},
    {"feed", &MillTool::feed_mm_min, 0.1, 1.0e6, "mm/min"},
    {"plunge-feed", &MillTool::plunge_mm_min, 0.1, 1.0e6, "mm/min"},
    {"spindle", &MillTool::spindle_rpm, 0.0, 1.0e6, "rpm"},
    {"depth-step", &MillTool::depth_step_mm, 0.001, 1000.0, "mm"},
    {"stepover", &MillTool::stepover_mm, 0.001, 500.0, "mm"},
}};

void set(MillTool& tool, const std::string& key, const std::string& text) {
  if (key == "diameter") {
    tool.diameter_mm = cut::number_from(key, text, 0.01, 500.0, "mm");
    return;
  }
  for (const ToolKey& known : kKeys) {
    if (known.name != key) continue;
    tool.*known.value = cut::number_from(key, text, known.least, known.most, known.unit);
    return;
  }
  std::vector<std::string> names{"diameter"};
  for (const ToolKey& known : kKeys) names.emplace_back(known.name);
  throw std::invalid_argument(fmt::format("{}: tools have no such value; the known values are {}{}",
                                          key,
                                          fmt::join(names, ", "),
                                          did_you_mean(key, names)));
}

/// Checks a tool. Throws std::invalid_argument for missing values and for values that exclude each
/// other.
void check(const MillTool& tool) {
  if (tool.name.empty()) throw std::invalid_argument("a tool without a name");
  if (tool.diameter_mm == 0.0) throw std::invalid_argument("a tool without diameter=MM");
  if (tool.flutes && *tool.flutes != std::floor(*tool.flutes)) {
    throw std::invalid_argument(fmt::format("flutes={}: requires an integer", *tool.flutes));
  }
  if (!tool.feed_per_tooth_mm) return;
  if (!tool.flutes) throw std::invalid_argument("feed-per-tooth: requires flutes, too");
  if (tool.feed_mm_min) throw std::invalid_argument("feed-per-tooth and feed: give one of them");
}

MillTool tool_of(const cut::NamedValues& named) {
  MillTool tool;
  tool.name = named.name;
  tool.place = named.place;
  try {
    for (const auto& [key, value] : named.values) set(tool, key, value);
    check(tool);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", named.place, error.what()));
  }
  return tool;
}

}  // namespace

std::optional<double> MillTool::feed_at(double rpm) const {
  if (!feed_per_tooth_mm) return feed_mm_min;
  return *flutes * *feed_per_tooth_mm * rpm;
}

std::vector<MillTool> read_mill_tools(const std::string& text, const std::string& file) {
  std::vector<MillTool> tools;
  for (const cut::NamedValues& named : cut::read_named_values(text, file, kForm)) {
    const auto same = std::ranges::find(tools, named.name, &MillTool::name);
    if (same != tools.end()) {
      throw std::invalid_argument(fmt::format(
          "{}: there is a tool {} in {} already", named.place, named.name, same->place));
    }
    tools.push_back(tool_of(named));
  }
  return tools;
}

const MillTool& tool_named(const std::vector<MillTool>& tools,
                           const std::string& name,
                           const std::string& file) {
  const auto tool = std::ranges::find(tools, name, &MillTool::name);
  if (tool != tools.end()) return *tool;
  std::vector<std::string> names;
  names.reserve(tools.size());
  for (const MillTool& other : tools) names.push_back(other.name);
  throw std::invalid_argument(fmt::format("{}: has no tool {}; there are {}{}",
                                          file,
                                          name,
                                          fmt::join(names, ", "),
                                          did_you_mean(name, names)));
}

}  // namespace sim::pocket
