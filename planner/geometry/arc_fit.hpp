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
/// The work for an element is counted in points of the curve that are looked at or
/// held against a biarc, some dozens to some thousands. It can be done bit by bit
/// between other work; what comes out is the same.
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
  /// Works at the next element for so many points, and at most kPointsAtOnce more; takes what was
  /// spent off them. True when the element is ready. @pre !done()
  [[nodiscard]] bool work(std::uint32_t& points);
  /// Works as long as it takes, when that has not been done. @pre !done()
  [[nodiscard]] PathElement next();

  static constexpr std::uint32_t kPointsAtOnce = 12 * BiarcTrial::kSamples;
  static_assert(BiarcTrial::kSamples + BiarcTrial::kClosely <= kPointsAtOnce);

 private:
  /// What is done next for the element.
  enum class Step : std::uint8_t { kReach, kConfirm, kOther, kConfirmOther, kStraight, kReady };

  struct Reach {
    float distance = 0.0F;  ///< In knots; 0 for none.
    float joint_share = 0.5F;
  };

  void begin();
  [[nodiscard]] std::uint32_t do_step();
  [[nodiscard]] std::uint32_t reach_farther();
  [[nodiscard]] bool narrow(const BiarcTrial::Fit& fit, float most);
  void end_reach();
  [[nodiscard]] std::uint32_t confirm();
  [[nodiscard]] std::uint32_t look_for_other();
  [[nodiscard]] std::uint32_t confirm_other();
  void go_less_far();
  void end_confirm();
  void begin_straight();
  [[nodiscard]] std::uint32_t reach_straight();
  [[nodiscard]] float allowed() const;
  [[nodiscard]] PathElement go_straight();
  [[nodiscard]] PathElement begin_biarc(const Reach& reach);
  [[nodiscard]] bool is_lone_arc(const BiarcEnds& ends) const;
  [[nodiscard]] Vec2 joint_of_trial(const Vec2& forward, const Reach& reach) const;
  [[nodiscard]] PathElement divide(const PathElement& whole,
                                   const BiarcEnds& ends,
                                   const Vec2& joint);
  [[nodiscard]] Position place_of(const PlanePlace& place) const;

  CurveAhead ahead_;
  BiarcTrial trial_{};
  Position origin_;
  Position here_;
  float tolerance_mm_;
  float last_distance_ = 0.0F;
  Step step_ = Step::kReach;
  std::uint8_t times_ = 0;  ///< This kind of step was done for the element.
  Reach reach_{};           ///< Of the biarc: so far it fits.
  float distance_ = 0.0F;   ///< Tried next.
  float out_of_reach_ = 0.0F;
  float found_mm_ = 0.0F;  ///< Deviation when last looked at closely.
  bool bounded_ = false;   ///< Something was out of reach.
  bool crumb_seen_ = false;
  bool second_waits_ = false;
  PathElement second_{};
};

}  // namespace cnc
