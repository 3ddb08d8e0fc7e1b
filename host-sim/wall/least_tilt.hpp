#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "planner/wall/beam.hpp"

namespace sim::wall {

using cnc::wall::Beam;
using cnc::wall::Triangle;

/// Maximum distance in mm between a tip and the plane of a facet at which the tip counts as on the
/// facet: a wall that is milled touches the beam that mills it.
inline constexpr double kTouchMm = 1.0e-3;

/// Returns the facet as an obstacle for a beam. If the tip is on the facet's plane, the facet is
/// moved so that its plane contains the tip exactly.
/// @param touch_mm maximum distance at which the tip counts as on the plane
[[nodiscard]] Triangle as_obstacle(const Triangle& facet,
                                   const Eigen::Vector3d& tip,
                                   double touch_mm = kTouchMm);

/// Limits of a beam's tilt.
struct TiltRules {
  /// Half angle of the beam plus the angle by which it stays clear of all obstacles; above 0, below
  /// a right angle.
  double half_angle_rad = 0.0;
  double max_rad = 0.0;  ///< Greatest tilt, at least 0, below a right angle.
  /// Unit vector to which the axis shall be as near as possible; its tilt is at most the greatest
  /// tilt.
  Eigen::Vector3d wanted = Eigen::Vector3d::UnitZ();
};

/// Finds the axis nearest to the wanted one on which a beam from a tip clears some obstacles. If
/// the wanted axis is upright, the result is the axis of least tilt.
///
/// The axes on which a beam meets a facet are a region of the sphere of directions. The region is
/// bounded by circles around the facet's corners and along its edges. The nearest clear axis is one
/// of three: the wanted axis, the point of a circle nearest to it, or a point where two circles
/// meet. All of these are tried, the nearest first, so that the result is exact.
class LeastTilt {
 public:
  LeastTilt(const Eigen::Vector3d& tip, const TiltRules& rules) : tip_{tip}, rules_{rules} {}

  /// Adds a facet as an obstacle, see as_obstacle().
  void add(const Triangle& obstacle);

  [[nodiscard]] std::size_t obstacle_count() const { return obstacles_.size(); }

  /// Returns the beam on the nearest axis that clears all obstacles; nothing if a beam on any axis
  /// within the rules meets an obstacle.
  [[nodiscard]] std::optional<Beam> beam() const;

 private:
  /// Directions at one angle from `middle`.
  struct Circle {
    Eigen::Vector3d middle;
    double cosine;  ///< Cosine of that angle.
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
