#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "planner/wall/beam.hpp"

namespace sim::wall {

using cnc::wall::Beam;
using cnc::wall::Triangle;

/// Distance in mm between a tip and the plane of a facet up to which the tip counts as on the
/// plane. A beam that cuts a wall touches this wall. The wall must not count as an obstacle.
inline constexpr double kTouchMm = 1.0e-3;

/// Returns a facet as an obstacle for a beam. If the tip counts as on the facet's plane, the facet
/// is moved so that the plane contains the tip exactly.
/// @param touch_mm distance up to which the tip counts as on the plane
[[nodiscard]] Triangle as_obstacle(const Triangle& facet,
                                   const Eigen::Vector3d& tip,
                                   double touch_mm = kTouchMm);

/// Limits of a beam's tilt.
struct TiltRules {
  /// Half angle of the beam plus the angle of clearance from all obstacles; > 0 and < 90 degrees.
  double half_angle_rad = 0.0;
  double max_rad = 0.0;  ///< Greatest tilt from the vertical, at least 0 and < 90 degrees.
  /// Unit vector of the wanted axis, to which the result is as near as possible. The tilt of this
  /// axis is at most `max_rad`.
  Eigen::Vector3d wanted = Eigen::Vector3d::UnitZ();
};

/// Finds the axis nearest to a wanted axis on which a beam from a tip clears all obstacles. If the
/// wanted axis is upright, the result is the axis of least tilt.
///
/// The axes on which a beam hits a facet are a region of the sphere of directions. This region is
/// bounded by circles around the directions of the facet's corners and along its edges. The nearest
/// clear axis is the wanted axis, the point of a circle nearest to the wanted axis, or an
/// intersection of two circles. All these candidates are tried, the nearest first, so that the
/// result is exact.
class LeastTilt {
 public:
  LeastTilt(const Eigen::Vector3d& tip, const TiltRules& rules) : tip_{tip}, rules_{rules} {}

  /// Adds a facet as an obstacle, see as_obstacle().
  void add(const Triangle& obstacle);

  [[nodiscard]] std::size_t obstacle_count() const { return obstacles_.size(); }

  /// Returns the beam on the nearest axis that clears all obstacles; nothing if no axis within the
  /// rules clears all obstacles.
  [[nodiscard]] std::optional<Beam> beam() const;

 private:
  /// A circle of the sphere of directions: all directions at one angle from `middle`.
  struct Circle {
    Eigen::Vector3d middle;
    double cosine;  ///< Cosine of the angle from `middle`.
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
