#pragma once

#include <cstdint>

#include "planner/geometry/biarc_trial.hpp"
#include "planner/geometry/curve_ahead.hpp"
#include "planner/geometry/path_element.hpp"
#include "planner/geometry/spline.hpp"

namespace cnc {

/// Converts a spline to a chain of arcs, one arc at a time, with as few arcs as possible. Each
/// biarc begins where the last biarc ended, on the curve and with the curve's tangent. Of the
/// biarcs with all possible joints, the fit takes the biarc that reaches farthest along the curve.
///
/// Guarantees, for splines up to kLargestSplineMm across:
/// * The chain begins and ends exactly where the spline does, and its elements join exactly.
/// * No point of the chain is farther than the tolerance from the spline, and no point of the
///   spline is farther than the tolerance from the chain.
/// * Two arcs meet with one tangent, within kLargestKink radians plus the effect of rounding their
///   ends to a nanometre: kKinkRoundingMm divided by the length of the shorter arc.
///
/// If the curve turns within less than the tolerance, as at a cusp, a straight line replaces the
/// curve. Then there is a corner at one end of the line or at both.
///
/// The work for an element is counted in points of the curve that are evaluated or compared with a
/// biarc: some dozens to some thousands. The work can be divided into portions; the result is the
/// same.
class ArcFit {
 public:
  static constexpr float kMinToleranceMm = 1.0e-4F;
  static constexpr float kLargestSplineMm = 2.0e3F;
  static constexpr double kLargestKink = 2.0e-5;
  static constexpr double kKinkRoundingMm = 6.0e-6;

  /// Begins the fit. @param spline must outlive this object. @pre spline.complete()
  /// @param start position of the first control point; the axes other than X and Y keep their
  ///     positions.
  /// @param tolerance_mm at least kMinToleranceMm.
  ArcFit(const Spline& spline, const Position& start, float tolerance_mm);

  [[nodiscard]] bool done() const { return !second_waits_ && ahead_.at_end(); }
  /// Works on the next element and uses up to `points` points. The last step may use up to
  /// kPointsAtOnce points more. Subtracts the points used from `points`. Returns whether the
  /// element is ready.
  /// @pre !done()
  [[nodiscard]] bool work(std::uint32_t& points);
  /// Returns the next element. First finishes the work on it if necessary. @pre !done()
  [[nodiscard]] PathElement next();

  static constexpr std::uint32_t kPointsAtOnce = 12 * BiarcTrial::kSamples;
  static_assert(BiarcTrial::kSamples + BiarcTrial::kClosely <= kPointsAtOnce);

 private:
  /// Next kind of work on the element.
  enum class Step : std::uint8_t { kReach, kConfirm, kOther, kConfirmOther, kStraight, kReady };

  struct Reach {
    float distance = 0.0F;  ///< Distance along the curve, in knots; 0 if no biarc was found.
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
  /// Number of steps of the present kind (`step_`) so far for the element.
  std::uint8_t times_ = 0;
  Reach reach_{};          ///< Farthest biarc found so far that fits.
  float distance_ = 0.0F;  ///< Next distance to be tried, in knots.
  float out_of_reach_ = 0.0F;
  float found_mm_ = 0.0F;  ///< Deviation that the last close comparison found, mm.
  bool bounded_ = false;   ///< Whether some tried distance was out of reach.
  bool crumb_seen_ = false;
  bool second_waits_ = false;
  PathElement second_{};
};

}  // namespace cnc
