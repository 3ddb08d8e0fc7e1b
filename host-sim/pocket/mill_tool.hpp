#pragma once

#include <optional>
#include <string>
#include <vector>

namespace sim::pocket {

/// A tool of a file, with the values at which its maker or its owner drives it. What the file does
/// not say is empty.
struct MillTool {
  std::string name;
  std::string place;  ///< `FILE:LINE`.
  double diameter_mm = 0.0;
  std::optional<double> v_angle_deg;        ///< Included angle of a V tool.
  std::optional<double> flutes;             ///< Number of cutting edges.
  std::optional<double> feed_per_tooth_mm;  ///< Needs `flutes`, and takes the place of a feed.
  std::optional<double> feed_mm_min;
  std::optional<double> plunge_mm_min;
  std::optional<double> spindle_rpm;
  std::optional<double> depth_step_mm;
  std::optional<double> stepover_mm;

  /// Returns the feed at a speed of the spindle: a tooth takes its share in each turn. None where
  /// the file gives neither a feed nor one per tooth.
  [[nodiscard]] std::optional<double> feed_at(double spindle_rpm) const;
};

/// Reads tools, one to a line, as `NAME: diameter=MM, key=value …`; blank lines and those that
/// begin with `#` do not count. Throws std::invalid_argument with file and line for what is none,
/// for values out of range or that exclude each other, and for two tools of one name.
[[nodiscard]] std::vector<MillTool> read_mill_tools(const std::string& text,
                                                    const std::string& file);

/// Returns the tool of a name. Throws std::invalid_argument that lists the names there are.
[[nodiscard]] const MillTool& tool_named(const std::vector<MillTool>& tools,
                                         const std::string& name,
                                         const std::string& file);

}  // namespace sim::pocket
