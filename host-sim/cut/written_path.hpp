#pragma once

#include <vector>

#include "host-sim/cut/stroke.hpp"
#include "planner/gcode/centre_on_grid.hpp"
#include "planner/geometry/path_element.hpp"

namespace sim::cut {

/// Follows a path as a controller reads it from a program of cnc::gcode::ProgramWriter. Ends are on
/// the grid of printed numbers, and arcs have printed centres. This rounding decides whether the
/// controller detects a corner between a small arc and a line.
class WrittenPath {
 public:
  /// Makes an object that is at the start of a path.
  /// @param from start of the path, mm
  WrittenPath(cnc::gcode::PrintGrid grid, const Place& from);

  /// Returns the elements of the next stroke, which are valid until the next call; none if the
  /// stroke does not move.
  /// @param stroke begins where the previous one ended. Points beyond the printed range move to its
  /// limit. Arcs that are too flat for a centre become lines
  [[nodiscard]] const std::vector<cnc::PathElement>& next(const Stroke& stroke);

 private:
  [[nodiscard]] cnc::gcode::GridPlace on_grid(const Place& place) const;
  [[nodiscard]] cnc::Position position_of(cnc::gcode::GridPlace place) const;
  void add_line(cnc::gcode::GridPlace to);
  void add_arc(const Place& from, const Place& to, double bulge);

  cnc::gcode::PrintGrid grid_;
  cnc::gcode::GridPlace here_;
  std::vector<cnc::PathElement> elements_;
};

}  // namespace sim::cut
