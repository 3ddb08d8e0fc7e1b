#pragma once

#include "planner/base/result.hpp"
#include "planner/contour/offset.hpp"
#include "planner/pocket/clearing_space.hpp"

namespace cnc::pocket {

/// Finds the greatest distance y by which the next pass may be inside an uncut area. The goal is
/// the area moved inwards by y. A tool that follows the boundary of the goal clears the points
/// within `reach` of the goal. The search finds the greatest y at which no point of the area is
/// farther than `reach` from the goal.
///
/// At a corner of angle θ between straight walls, y = reach · sin(θ / 2): paper 5, equation 10. The
/// first trial has the y of the smallest angle. It is the only trial unless arcs, short elements or
/// necks affect y.
///
/// Guarantee: no point of the area is more than `kReachSlack` beyond the reach. FarthestPoint
/// checks this for the boundary. For inner points, the goal is offset outwards by `reach`: the
/// holes of this offset must not be in the area. y is less than the greatest possible value by at
/// most 2 % of the reach, or the pass finishes the area. y is at least 0, which always satisfies
/// the reach.
inline constexpr double kReachSlack = 1.0e-8;  // Greatest distance beyond the reach, mm.
template <typename Scalar>
class StepSearch {
 public:
  /// @param reach  greatest distance from the goal that is cleared, mm, positive
  StepSearch(const ClearingSpace<Scalar>& space, Scalar reach) : space_{space}, reach_{reach} {}

  /// Returns y. Afterwards goal() returns the loops of the goal.
  /// @param most  upper bound of y, mm, positive
  /// @param cleared_inwards  width of the strip inside the goal that the pass clears, mm. If y +
  ///     `cleared_inwards` leaves nothing of the area, the pass is the last one.
  [[nodiscard]] Result<Scalar, contour::OffsetError> find(const contour::ContourView<Scalar>& area,
                                                          Scalar most,
                                                          Scalar cleared_inwards);

  [[nodiscard]] contour::ContourView<Scalar> goal() const { return goal_; }

 private:
  /// Greatest distance of the area from the goal at one y. The distance is `kNever` if the goal is
  /// empty, or if the area has an inner point that is out of reach.
  struct Trial {
    Scalar y{};
    Scalar farthest{};
    bool empty = false;
  };
  // NOLINTNEXTLINE(bugprone-dynamic-static-initializers): constant in each instantiation.
  static constexpr Scalar kNever{1.0e30};

  using Vector = BasicVec2<Scalar>;
  using Area = contour::ContourView<Scalar>;

  [[nodiscard]] Result<Trial, contour::OffsetError> look(const Area& area, Scalar y);
  [[nodiscard]] Result<bool, contour::OffsetError> leaves_a_hole(const Area& area);
  [[nodiscard]] bool reaches(const Trial& trial) const {
    return trial.farthest <= reach_ + Scalar{kReachSlack};
  }
  [[nodiscard]] Scalar next(const Trial& low, const Trial& high, bool bounded) const;

  ClearingSpace<Scalar> space_;
  Scalar reach_;
  Area goal_{};
};

}  // namespace cnc::pocket
