#pragma once

#include <optional>
#include <string>
#include <vector>

namespace sim::pocket {

/// A tool of a tool file, with its cutting values. Values that the file does not give are empty.
struct MillTool {
  std::string name;
  std::string place;  ///< Source of the tool, as `FILE:LINE`.
  double diameter_mm = 0.0;
  std::optional<double> v_angle_deg;  ///< Angle between the two sides of a V tool's tip.
  std::optional<double> flutes;       ///< Number of cutting edges.
  /// Feed per cutting edge and revolution; requires `flutes`, and replaces `feed_mm_min`.
  std::optional<double> feed_per_tooth_mm;
  std::optional<double> feed_mm_min;
  std::optional<double> plunge_mm_min;
  std::optional<double> spindle_rpm;
  std::optional<double> depth_step_mm;
  std::optional<double> stepover_mm;

  /// Returns the feed at a spindle speed, mm/min. The feed is `feed_per_tooth_mm` for each tooth in
  /// each revolution, or `feed_mm_min`. Returns none if the file gives neither a feed nor a feed
  /// per tooth.
  [[nodiscard]] std::optional<double> feed_at(double spindle_rpm) const;
};

/// Reads tools, one in each line, as `NAME: diameter=MM, key=value …`. Ignores blank lines and
/// lines that begin with `#`. Throws std::invalid_argument with file and line for a line of another
/// form, for a value out of range, for values that exclude each other, and for a repeated name.
[[nodiscard]] std::vector<MillTool> read_mill_tools(const std::string& text,
                                                    const std::string& file);

/// Returns the tool with a name. If there is none, throws std::invalid_argument with a list of the
/// known names.
[[nodiscard]] const MillTool& tool_named(const std::vector<MillTool>& tools,
                                         const std::string& name,
                                         const std::string& file);

}  // namespace sim::pocket
