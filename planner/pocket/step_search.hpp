#pragma once

#include "planner/base/result.hpp"
#include "planner/contour/offset.hpp"
#include "planner/pocket/clearing_space.hpp"

namespace cnc::pocket {

/// Finds how far inside of an uncut area the next pass may be. The area moved inwards by y is the
/// goal; a tool that follows the boundary of the goal clears what is within `reach` of the goal.
/// The greatest y is sought at which nothing of the area is farther from it.
///
/// At a corner of angle θ between straight walls y = reach · sin(θ / 2): paper 5, equation 10. The
/// first trial has the y of the smallest angle; it is the last one unless arcs, short elements or
/// necks matter.
///
/// Guarantee: no point of the area is more than `kReachSlack` beyond the reach. Checked for the
/// boundary by FarthestPoint, for the inside by an offset outwards: its holes must not lie in the
/// area. y is within 2 % of the reach of the greatest, or finishes the area; at least 0, which is
/// always enough.
inline constexpr double kReachSlack = 1.0e-8;  // mm
template <typename Scalar>
class StepSearch {
 public:
  /// @param reach  mm, positive
  StepSearch(const ClearingSpace<Scalar>& space, Scalar reach) : space_{space}, reach_{reach} {}

  /// Returns y. The loops of the goal are in `goal()` then.
  /// @param most  bound of y, mm, positive
  /// @param cleared_inwards  width of the strip that the pass clears inside of the goal, mm: where
  ///        nothing is left of the area within y + `cleared_inwards`, the pass is the last one
  [[nodiscard]] Result<Scalar, contour::OffsetError> find(const contour::ContourView<Scalar>& area,
                                                          Scalar most,
                                                          Scalar cleared_inwards);

  [[nodiscard]] contour::ContourView<Scalar> goal() const { return goal_; }

 private:
  /// How far the area is from the goal at one y; `kNever` where the goal is empty or encloses
  /// something that it does not reach.
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
