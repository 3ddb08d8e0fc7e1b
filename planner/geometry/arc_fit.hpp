#pragma once

#include <cstdint>

#include "planner/geometry/biarc_trial.hpp"
#include "planner/geometry/curve_ahead.hpp"
#include "planner/geometry/path_element.hpp"
#include "planner/geometry/spline.hpp"

namespace cnc {

/// Turns a spline into a chain of arcs, one at a time, as few as it can: from
/// where the last biarc ended, on the curve and with its tangent, the one that
/// reaches farthest of all joints, and so on.
///
/// Guarantees, for splines up to kLargestSplineMm across:
/// * The chain begins and ends exactly where the spline does, and its elements
///   join exactly.
/// * No point of the chain is farther than the tolerance from the spline, and
///   no point of the spline farther than that from the chain.
/// * Two arcs meet with one tangent, within kLargestKink radians plus what the
///   rounding of their ends to a nanometre makes: kKinkRoundingMm by the
///   length of the shorter.
///
/// Where the curve turns within less than the tolerance, as at a cusp, a
/// straight line takes its place, and there is a corner at one end or both.
///
/// Each call does a bounded amount of work: kMostTrials stretches of curve are
/// sampled and some ten biarcs held against each.
class ArcFit {
 public:
  static constexpr float kLeastToleranceMm = 1.0e-4F;
  static constexpr float kLargestSplineMm = 2.0e3F;
  static constexpr double kLargestKink = 2.0e-5;
  static constexpr double kKinkRoundingMm = 6.0e-6;

  /// @param spline must outlive this. @pre complete()
  /// @param start of the first control point; the other axes stay where they are.
  /// @param tolerance_mm at least kLeastToleranceMm.
  ArcFit(const Spline& spline, const Position& start, float tolerance_mm);

  [[nodiscard]] bool done() const { return !second_waits_ && ahead_.at_end(); }
  /// @pre !done()
  [[nodiscard]] PathElement next();

 private:
  struct Reach {
    float distance = 0.0F;  ///< In knots; 0 for none.
    float joint_share = 0.5F;
  };

  [[nodiscard]] Reach farthest();
  [[nodiscard]] Reach confirmed(Reach reach);
  [[nodiscard]] Reach leave_no_crumb(const Reach& reach);
  [[nodiscard]] float straight_reach();
  [[nodiscard]] float allowed() const;
  [[nodiscard]] PathElement go_straight();
  [[nodiscard]] PathElement begin_biarc(const Reach& reach);
  [[nodiscard]] bool is_lone_arc(const BiarcEnds& ends) const;
  [[nodiscard]] PathElement divide(const PathElement& whole,
                                   const BiarcEnds& ends,
                                   const Vec2& joint);
  [[nodiscard]] Position place_of(const PlanePlace& place) const;

  static constexpr int kMostTrials = 28;

  CurveAhead ahead_;
  BiarcTrial trial_{};
  Position origin_;
  Position here_;
  float tolerance_mm_;
  float last_distance_ = 0.0F;
  bool second_waits_ = false;
  PathElement second_{};
};

}  // namespace cnc
