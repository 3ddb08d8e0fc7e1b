#pragma once

#include <optional>
#include <string>
#include <vector>

namespace sim::pocket {

/// A tool of a file, with the cutting values that its maker or its owner gives. Values that the
/// file does not give are empty.
struct MillTool {
  std::string name;
  std::string place;  ///< `FILE:LINE`.
  double diameter_mm = 0.0;
  std::optional<double> v_angle_deg;        ///< Included angle of a V tool.
  std::optional<double> flutes;             ///< Number of cutting edges.
  std::optional<double> feed_per_tooth_mm;  ///< Needs `flutes`, and replaces `feed_mm_min`.
  std::optional<double> feed_mm_min;
  std::optional<double> plunge_mm_min;
  std::optional<double> spindle_rpm;
  std::optional<double> depth_step_mm;
  std::optional<double> stepover_mm;

  /// Returns the feed at a spindle speed, mm/min: `feed_per_tooth_mm` for each tooth in each
  /// revolution, or `feed_mm_min`. Returns none where the file gives neither a feed nor a feed per
  /// tooth.
  [[nodiscard]] std::optional<double> feed_at(double spindle_rpm) const;
};

/// Reads tools, one in each line, as `NAME: diameter=MM, key=value …`. Ignores blank lines and
/// lines that begin with `#`. Throws std::invalid_argument with file and line for a line of another
/// form, for values out of range, for values that exclude each other, and for two tools with one
/// name.
[[nodiscard]] std::vector<MillTool> read_mill_tools(const std::string& text,
                                                    const std::string& file);

/// Returns the tool with a name. If there is none, throws std::invalid_argument that lists the
/// known names.
[[nodiscard]] const MillTool& tool_named(const std::vector<MillTool>& tools,
                                         const std::string& name,
                                         const std::string& file);

}  // namespace sim::pocket
