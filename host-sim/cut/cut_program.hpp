#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host-sim/cut/plan.hpp"
#include "planner/gcode/print_grid.hpp"

namespace sim::cut {

/// The laser that a program is for.
struct Beam {
  double full_power_w = 0.0;     ///< Power of the laser at `full_power_s`.
  double full_power_s = 1000.0;  ///< S value of full power, $30.
  bool follows_speed = true;     ///< M4, where the power follows the actual speed; otherwise M3.
  /// Number of the material's kerf table in the controller's list ($K), if the controller computes
  /// compensated paths itself.
  std::optional<unsigned> kerf_table{};
  /// If false, `full_power_w` is 100, and powers in watts are percentages.
  bool knows_watts = true;
};

/// Returns a text as a line of comment in printable ASCII. Characters that end a comment, or that
/// act at once on the wire, become `_`.
[[nodiscard]] std::string comment_line(const std::string& text);

/// Returns a plan as G-code: one M4 or M3, a rapid to each cut, and no word that changes nothing.
/// Throws std::invalid_argument, which names what the laser or the numbers of a line cannot
/// express.
/// @param heading lines of comment at the top; characters that G-code cannot carry are left out
[[nodiscard]] std::string program_of(const CutPlan& plan,
                                     const drawing::Drawing& drawn,
                                     const Beam& beam,
                                     cnc::gcode::PrintGrid grid,
                                     const std::vector<std::string>& heading);

}  // namespace sim::cut
