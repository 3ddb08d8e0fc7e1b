#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "planner/wall/beam.hpp"

namespace sim::wall {

using cnc::wall::Beam;
using cnc::wall::Triangle;

/// A tip whose distance from the plane of a facet is at most that, mm, is on the facet: a wall that
/// is milled touches the beam that mills it.
inline constexpr double kTouchMm = 1.0e-3;

/// Returns the facet as it stands in the way of a beam: moved into the tip where the tip is on its
/// plane.
/// @param touch_mm distance up to which it is
[[nodiscard]] Triangle as_obstacle(const Triangle& facet,
                                   const Eigen::Vector3d& tip,
                                   double touch_mm = kTouchMm);

/// How a beam may lean.
struct TiltRules {
  /// Half angle of the beam and the angle by which it stays clear of all; above 0, below a right
  /// angle.
  double half_angle_rad = 0.0;
  double most_rad = 0.0;  ///< Greatest tilt, at least 0, below a right angle.
  /// Unit vector that the axis is to be near to, of no more than the greatest tilt.
  Eigen::Vector3d wanted = Eigen::Vector3d::UnitZ();
};

/// Finds the axis nearest to the wanted one on which a beam from a tip clears some obstacles. Where
/// the upright axis is wanted that is the one of least tilt.
///
/// The axes on which a beam meets a facet are a region of the sphere of directions, within circles
/// around its corners and beside its edges. The nearest clear axis is the wanted one, or the
/// point of a circle that is nearest to it, or one where two circles meet: all are tried, the
/// nearest first, so that the answer is exact.
class LeastTilt {
 public:
  LeastTilt(const Eigen::Vector3d& tip, const TiltRules& rules) : tip_{tip}, rules_{rules} {}

  /// Adds a facet as it stands in the way.
  void add(const Triangle& obstacle);

  [[nodiscard]] std::size_t obstacle_count() const { return obstacles_.size(); }

  /// Returns the beam on the nearest axis that clears all; nothing where each axis within the
  /// rules meets one of them.
  [[nodiscard]] std::optional<Beam> beam() const;

 private:
  /// Directions at one angle from a middle.
  struct Circle {
    Eigen::Vector3d middle;
    double cosine;  ///< Cosine of the angle.
  };

  [[nodiscard]] Beam beam_along(const Eigen::Vector3d& axis) const;
  [[nodiscard]] bool is_clear(const Eigen::Vector3d& axis) const;
  [[nodiscard]] std::vector<Eigen::Vector3d> candidates() const;

  Eigen::Vector3d tip_;
  TiltRules rules_;
  std::vector<Triangle> obstacles_;
  std::vector<Circle> circles_;
};

}  // namespace sim::wall
