#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "host-sim/cli/pocket_options.hpp"
#include "host-sim/pocket/mill_tool.hpp"

namespace sim {
namespace {

/// Returns the number if the text is a number and nothing more; otherwise empty.
std::optional<double> number_in(const std::string& text) {
  const char* const end = text.data() + text.size();
  double value = 0.0;
  const auto read = std::from_chars(text.data(), end, value);
  if (read.ec != std::errc{} || read.ptr != end) return std::nullopt;
  return value;
}

/// Sets `value` to that of the tool, unless the call gives it.
void take(const CLI::App& command,
          const char* option,
          const std::optional<double>& value,
          double& target) {
  if (command.count(option) == 0 && value) target = *value;
}

void take_values(const CLI::App& command,
                 const pocket::MillTool& tool,
                 PocketCommandOptions& options) {
  options.tool_mm = tool.diameter_mm;
  take(command, "--spindle", tool.spindle_rpm, options.mill.spindle_rpm);
  take(command, "--plunge-feed", tool.plunge_mm_min, options.mill.plunge_mm_min);
  take(command, "--depth-step", tool.depth_step_mm, options.depth_step_mm);
  take(command, "--stepover", tool.stepover_mm, options.stepover_mm);
  take(command, "--v-angle", tool.v_angle_deg, options.v_angle_deg);
  take(command, "--feed", tool.feed_at(options.mill.spindle_rpm), options.mill.feed_mm_min);
  if (tool.v_angle_deg && options.v_angle_deg != *tool.v_angle_deg) {
    throw std::invalid_argument{fmt::format("--v-angle {:g}: the tool {} of {} has {:g} degrees",
                                            options.v_angle_deg,
                                            tool.name,
                                            tool.place,
                                            *tool.v_angle_deg)};
  }
  if (tool.feed_per_tooth_mm && options.mill.feed_mm_min == 0.0) {
    throw std::invalid_argument{fmt::format(
        "--spindle is missing: the tool {} of {} has a feed per tooth and no spindle speed",
        tool.name,
        tool.place)};
  }
}

}  // namespace

void apply_tool(const CLI::App& command, PocketCommandOptions& options, InputFiles& inputs) {
  std::vector<pocket::MillTool> tools;
  if (!options.tools_file.empty()) {
    tools = pocket::read_mill_tools(inputs.read_and_add("tools", options.tools_file),
                                    options.tools_file);
  }
  if (const std::optional<double> diameter = number_in(options.tool)) {
    if (!(*diameter >= kMinToolMm && *diameter <= kGreatestToolMm)) {
      throw std::invalid_argument{fmt::format(
          "--tool {}: must be {:g} to {:g} mm", options.tool, kMinToolMm, kGreatestToolMm)};
    }
    options.tool_mm = *diameter;
  } else if (options.tools_file.empty()) {
    throw std::invalid_argument{
        fmt::format("--tool {}: is no diameter in mm; a name requires --tools, the file of tools",
                    options.tool)};
  } else {
    take_values(command, pocket::tool_named(tools, options.tool, options.tools_file), options);
  }
  for (const auto& [option, value] : {std::pair{"--feed", options.mill.feed_mm_min},
                                      std::pair{"--plunge-feed", options.mill.plunge_mm_min}}) {
    if (value > 0.0) continue;
    throw std::invalid_argument{
        fmt::format("{} is required, in mm/min, unless a tool of --tools has it", option)};
  }
}

}  // namespace sim
