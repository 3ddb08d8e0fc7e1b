#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host-sim/cut/plan.hpp"
#include "planner/gcode/print_grid.hpp"

namespace sim::cut {

/// The laser that a program is for.
struct Beam {
  double full_power_w = 0.0;     ///< What it gives at `full_power_s`.
  double full_power_s = 1000.0;  ///< $30.
  bool follows_speed = true;     ///< M4: power by the speed really driven; else M3.
  /// Of the material in the controller's list ($K), where it finds the way beside parts itself.
  std::optional<unsigned> kerf_table{};
  bool knows_watts = true;  ///< Else `full_power_w` is 100, and watts are percents.
};

/// A text as a line of comment: printable ASCII without what ends a comment or acts at once on the
/// wire, which becomes `_`.
[[nodiscard]] std::string comment_line(const std::string& text);

/// A plan as G-code: one M4 or M3, a rapid to each cut, and no word that changes nothing.
/// Throws std::invalid_argument naming what the laser or the numbers of a line cannot.
/// @param heading lines of comment at the top; what G-code could not carry is left out of them
[[nodiscard]] std::string program_of(const CutPlan& plan,
                                     const drawing::Drawing& drawn,
                                     const Beam& beam,
                                     cnc::gcode::PrintGrid grid,
                                     const std::vector<std::string>& heading);

}  // namespace sim::cut
