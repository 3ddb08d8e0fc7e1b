#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "host-sim/wall/carve/beam_carver.hpp"

namespace sim::wall::burn_oracle {

/// Returns the depth of a point within the volume that one pose burns, mm, measured across the
/// axis; negative outside.
inline double depth_of(const BeamPose& pose,
                       const BurningBeam& beam,
                       const Eigen::Vector3d& point) {
  const Eigen::Vector3d way = point - pose.tip;
  const double along = way.dot(pose.axis);
  const double out = (way - along * pose.axis).norm();
  const double side = std::tan(beam.half_angle_rad + beam.heat_rad);
  const double above = std::min(along, beam.waist_mm + side * along - out);
  if (pose.depth_mm == 0.0 || beam.waist_mm == 0.0) return above;
  const double below = std::min({-along, along + pose.depth_mm, beam.waist_mm - out});
  return std::max(above, below);
}

/// Returns the pose at a fraction of a move. Each move tilts in the plane of both axes.
inline BeamPose at(const BeamPose& from, const BeamPose& to, double share) {
  BeamPose pose{
      (1.0 - share) * from.tip + share * to.tip, from.axis, std::max(from.depth_mm, to.depth_mm)};
  const double cosine = from.axis.dot(to.axis);
  const Eigen::Vector3d across = to.axis - cosine * from.axis;
  if (across.norm() > 1.0e-12) {
    const double angle = share * std::atan2(across.norm(), cosine);
    pose.axis = std::cos(angle) * from.axis + std::sin(angle) * across.normalized();
  }
  return pose;
}

/// Returns the greatest depth along a stroke: at many fractions of each move, and near the best one
/// by ever smaller steps.
inline double depth_of(const BeamStroke& stroke,
                       const BurningBeam& beam,
                       const Eigen::Vector3d& point) {
  double best = depth_of(stroke.front(), beam, point);
  for (std::size_t i = 1; i < stroke.size(); ++i) {
    constexpr int kShares = 200;
    const auto depth_at = [&](double share) {
      return depth_of(at(stroke[i - 1], stroke[i], share), beam, point);
    };
    double share = 0.0;
    double deepest = depth_at(0.0);
    const auto attempt = [&](double other) {
      if (other < 0.0 || other > 1.0) return;
      const double depth = depth_at(other);
      if (depth <= deepest) return;
      deepest = depth;
      share = other;
    };
    for (int k = 1; k <= kShares; ++k) attempt(static_cast<double>(k) / kShares);
    for (double step = 1.0 / kShares; step > 1.0e-10; step *= 0.5) {
      attempt(share + step);
      attempt(share - step);
    }
    best = std::max(best, deepest);
  }
  return best;
}

}  // namespace sim::wall::burn_oracle
