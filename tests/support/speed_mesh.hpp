#pragma once

#include <vector>

#include "tests/support/optimal_time.hpp"
#include "tests/support/speed_rules.hpp"

namespace sim {

/// A stretch of the path on which y″ is constant (y = v³), with the rules that apply there.
struct SpeedCell {
  double length = 0.0;  ///< Length, mm.
  /// Rules at the start. At a joint, they differ from those at the end of the previous cell.
  PlaceRules start{};
  PlaceRules middle{};
  PlaceRules end{};
  bool begins_piece = false;
  bool turns = false;       ///< Whether the rules change within the cell.
  double cap_inside = 0.0;  ///< Greatest y on this cell's piece, mm³/s³.
  /// Greatest y at the cell's end, by the pieces on both sides and the corner rule, mm³/s³.
  double cap_end = 0.0;
  /// Upper bounds of a²/v for every motion that satisfies the rules, see bound_relief().
  JerkRelief relief{};
};

/// The cells from one standstill to the next.
using SpeedSection = std::vector<SpeedCell>;

struct MeshSize {
  double cells_per_rise =
      10.0;             ///< Number of cells while the quickest axis reaches its acceleration.
  double widest = 0.1;  ///< Greatest sweep of an arc in one cell, radians.
  std::size_t min_cells = 400;  ///< Least number of cells in a section.
  /// Greatest number of cells in a section; each piece has at least one nevertheless.
  std::size_t max_cells = 1500;
  double start = 1.0;  ///< Share of the usual height y with which the search starts; ≤ 1.
};

/// Divides a path at its stops, and each section into cells of about equal duration. The durations
/// are those of an estimated motion, slightly faster than possible: the lesser of the
/// acceleration-limited optimum and of a limit by jerk. At a distance d from a joint with y ≤ c,
/// jerk permits √y = √c + √(4.5 J) d. So cells become shorter towards stops and slow corners.
[[nodiscard]] std::vector<SpeedSection> speed_mesh(const ProgrammedPath& path,
                                                   const MotionLimits& limits,
                                                   const MeshSize& size);

}  // namespace sim
