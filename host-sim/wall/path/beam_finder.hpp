#pragma once

#include <Eigen/Core>
#include <optional>

#include "host-sim/wall/obstacles.hpp"

namespace sim::wall {

/// A beam at one tip of a path.
struct TipBeam {
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  double left_rad = 0.0;  ///< Angle by which its side is in the part at most: 0, it clears all.
};

/// How beams avoid a part.
struct BeamRules {
  TiltRules tilt;
  double waist_mm = 0.0;        ///< Radius at the tip, at least 0.
  bool avoids = true;           ///< Else all beams are upright.
  bool allows_overlap = false;  ///< Where no axis clears all, the one that is in the part least.
};

/// Finds the beams of tips.
class BeamFinder {
 public:
  /// @param obstacles must outlive this
  BeamFinder(const Obstacles& obstacles, const BeamRules& rules)
      : BeamFinder{obstacles, obstacles, rules} {}
  /// @param touched the same facets, of which those that the waist may touch are touched by the tip
  BeamFinder(const Obstacles& obstacles, const Obstacles& touched, const BeamRules& rules)
      : obstacles_{&obstacles}, touched_{&touched}, rules_{rules} {}

  [[nodiscard]] const BeamRules& rules() const { return rules_; }

  /// Returns the distance of the upright beam from all, below 0 where it meets something, and at
  /// most `most_mm`.
  [[nodiscard]] double upright_clearance(const Eigen::Vector3d& tip, double most_mm) const;

  /// Returns the beam of least tilt; nothing where the tip is out of reach.
  [[nodiscard]] std::optional<TipBeam> leaning(const Eigen::Vector3d& tip) const;

  /// Returns the beam from a tip on the clear axis that is nearest to another.
  [[nodiscard]] std::optional<TipBeam> nearest_to(const Eigen::Vector3d& axis,
                                                  const Eigen::Vector3d& tip) const;

  /// Returns whether no point of the part is deeper in a beam than that, mm.
  [[nodiscard]] bool is_clear(const TipBeam& beam, double depth_mm) const;

 private:
  [[nodiscard]] Beam beam_along(const TipBeam& beam) const;
  [[nodiscard]] std::optional<TipBeam> leaning_by(const Eigen::Vector3d& tip, double half) const;
  [[nodiscard]] std::optional<TipBeam> clear_of_waist(const TipBeam& beam) const;
  [[nodiscard]] TipBeam least_overlap(const Eigen::Vector3d& tip) const;

  const Obstacles* obstacles_;
  const Obstacles* touched_;
  BeamRules rules_;
};

}  // namespace sim::wall
