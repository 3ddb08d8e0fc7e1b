#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host-sim/cut/plan.hpp"
#include "planner/gcode/print_grid.hpp"

namespace sim::cut {

/// The laser for which a program is written.
struct Beam {
  double full_power_w = 0.0;     ///< Power of the laser at `full_power_s`.
  double full_power_s = 1000.0;  ///< S value of full power, setting $30.
  /// Whether the power follows the actual speed (M4). Otherwise it is constant (M3).
  bool follows_speed = true;
  /// Number of the material's kerf table in the list of the controller ($K). It is set if the
  /// controller computes compensated paths itself.
  std::optional<unsigned> kerf_table{};
  /// Whether the power of the laser is known in watts. If it is not, `full_power_w` is 100, and
  /// powers in watts are percentages.
  bool knows_watts = true;
};

/// Returns a text as a line of comment in printable ASCII. Characters that end a comment, or on
/// which a controller acts as soon as it receives them, become `_`.
[[nodiscard]] std::string comment_line(const std::string& text);

/// Returns a plan as G-code: one M4 or M3, a rapid to each cut, and only words that change
/// something. Throws std::invalid_argument if the laser cannot give a power, or if a point is out
/// of the range of a program.
/// @param heading lines of comment at the top; characters that a comment cannot contain become `_`
[[nodiscard]] std::string program_of(const CutPlan& plan,
                                     const drawing::Drawing& drawn,
                                     const Beam& beam,
                                     cnc::gcode::PrintGrid grid,
                                     const std::vector<std::string>& heading);

}  // namespace sim::cut
