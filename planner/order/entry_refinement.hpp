#pragma once

#include <span>

#include "planner/order/place_tree.hpp"

namespace cnc::order {

/// A line or an arc of at most half a turn on which a contour may be pierced, as far as it may.
struct EntryPiece {
  Place start;
  Place end;
  double bulge = 0.0;  ///< tan(sweep / 4), positive to the left; 0 for a line.
  double first =
      0.0;  ///< Parameters between which the pierce point lies: 0 at `start`, 1 at `end`.
  double last = 1.0;

  /// Returns the point with a parameter: a rational quadratic curve, which is exactly the arc.
  [[nodiscard]] Place at(double parameter) const;
};

/// Where a contour is pierced, and where it could be.
struct PiercePoint {
  std::span<const EntryPiece> pieces;
  Index piece = 0;
  double parameter = 0.0;

  [[nodiscard]] Place place() const { return pieces[piece].at(parameter); }
};

/// Returns the parameter at which |from − p| + |p − to| is least on a piece. On a line it is exact:
/// the sum is convex, and straight after a reflection. On an arc it is the best of samples, refined
/// between its neighbours; it may miss a minimum that is narrower than a 32nd of the arc.
[[nodiscard]] double best_parameter(const EntryPiece& piece, const Place& from, const Place& to);

/// Moves pierce points along their contours, one after another, each to the best place between the
/// two before and behind it, until a round gains less than `least_gain` or `rounds` have passed.
/// The order stays. For closed contours: entry and exit are one place.
/// @param start where the path begins; @param end where it ends
/// @return how much shorter the path is
double refine_pierce_points(std::span<PiercePoint> points,
                            const Place& start,
                            const Place& end,
                            double least_gain,
                            int rounds);

}  // namespace cnc::order
