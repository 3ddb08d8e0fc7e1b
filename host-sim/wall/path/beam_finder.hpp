#pragma once

#include <Eigen/Core>
#include <optional>

#include "host-sim/wall/obstacles.hpp"

namespace sim::wall {

/// A beam at one tip of a path.
struct TipBeam {
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  /// Maximum angle by which the beam's side is inside the part; 0 if the beam clears the part.
  double left_rad = 0.0;
};

/// Rules for beams that avoid a part.
struct BeamRules {
  TiltRules tilt;
  double waist_mm = 0.0;  ///< Radius of the beam at its tip, at least 0.
  /// Whether beams lean to avoid the part; otherwise all beams are upright.
  bool avoids = true;
  /// Whether to use the axis with the least overlap if no axis clears the part.
  bool allows_overlap = false;
};

/// Finds a beam that avoids the part, for one tip at a time.
class BeamFinder {
 public:
  /// @param obstacles facets of the part; must outlive this object
  BeamFinder(const Obstacles& obstacles, const BeamRules& rules)
      : BeamFinder{obstacles, obstacles, rules} {}
  /// @param touched the same facets with a greater touch distance. At this distance, facets that
  /// the waist may touch count as touched by the tip
  BeamFinder(const Obstacles& obstacles, const Obstacles& touched, const BeamRules& rules)
      : obstacles_{&obstacles}, touched_{&touched}, rules_{rules} {}

  [[nodiscard]] const BeamRules& rules() const { return rules_; }

  /// Returns the least clearance between the upright beam and the obstacles, at most `max_mm`. The
  /// clearance is < 0 if the beam hits an obstacle.
  [[nodiscard]] double upright_clearance(const Eigen::Vector3d& tip, double max_mm) const;

  /// Returns the beam of least tilt from a tip; nothing if the tip is out of reach.
  [[nodiscard]] std::optional<TipBeam> leaning(const Eigen::Vector3d& tip) const;

  /// Returns the beam from a tip on the clear axis that is nearest to `axis`; nothing if no axis is
  /// clear.
  [[nodiscard]] std::optional<TipBeam> nearest_to(const Eigen::Vector3d& axis,
                                                  const Eigen::Vector3d& tip) const;

  /// Returns whether all points of the part are at most `depth_mm` deep in a beam.
  [[nodiscard]] bool is_clear(const TipBeam& beam, double depth_mm) const;

 private:
  [[nodiscard]] Beam beam_along(const TipBeam& beam) const;
  [[nodiscard]] std::optional<TipBeam> leaning_by(const Eigen::Vector3d& tip, double half) const;
  [[nodiscard]] std::optional<TipBeam> clear_of_waist(const TipBeam& beam) const;
  [[nodiscard]] TipBeam min_overlap(const Eigen::Vector3d& tip) const;

  const Obstacles* obstacles_;
  const Obstacles* touched_;
  BeamRules rules_;
};

}  // namespace sim::wall
