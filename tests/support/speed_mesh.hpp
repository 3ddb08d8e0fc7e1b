#pragma once

#include <vector>

#include "tests/support/optimal_time.hpp"
#include "tests/support/speed_rules.hpp"

namespace sim {

/// A stretch of the path on which y″ is constant (y = v³), with what holds on it.
struct SpeedCell {
  double length = 0.0;  ///< mm.
  PlaceRules start{};   ///< Differs from the end of the cell before at joints.
  PlaceRules middle{};
  PlaceRules end{};
  bool begins_piece = false;
  bool turns = false;       ///< The rules change within it.
  double cap_inside = 0.0;  ///< Of y, on this cell's piece, mm³/s³.
  double cap_end = 0.0;     ///< At its end, of both sides and the corner rule.
  /// Upper bounds of a²/v for every motion that keeps the rules, see relax().
  JerkRelief relief{};
};

/// From one standstill to the next.
using SpeedSection = std::vector<SpeedCell>;

struct MeshSize {
  double cells_per_rise =
      10.0;             ///< In the time in which the quickest axis reaches its acceleration.
  double widest = 0.1;  ///< Radians of an arc in one cell.
  std::size_t min_cells = 400;   ///< In a section,
  std::size_t max_cells = 1500;  ///< in which each piece has one at least.
  double start = 1.0;            ///< How slow the motion is that the search begins with; ≤ 1.
};

/// Divides a path at its stops, and what is between into cells that last about equally
/// long in a motion that is somewhat faster than possible: the lesser of the
/// acceleration-limited optimum and of what jerk lets it have at a distance d from the joints,
/// where y is at most c: √y = √c + √(4.5 J) d. So cells shrink towards stops and slow corners.
[[nodiscard]] std::vector<SpeedSection> speed_mesh(const ProgrammedPath& path,
                                                   const MotionLimits& limits,
                                                   const MeshSize& size);

}  // namespace sim
