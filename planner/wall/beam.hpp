#pragma once

#include <Eigen/Core>
#include <numbers>

namespace cnc::wall {

/// A focused beam as a solid: a cone from the focus up to the lens, cut off at the waist. All
/// lengths are in mm.
struct Beam {
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();    ///< Middle of the waist, on the work.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< Unit vector from the tip to the lens.
  double sine = 0.0;                                ///< Sine of the half angle, above 0.
  double cosine = 1.0;                              ///< Cosine of the half angle, above 0.
  double length_mm = 0.0;                           ///< Distance from the tip to the lens, above 0.
  double waist_mm = 0.0;                            ///< Radius of the waist at the tip, at least 0.

  /// Returns a beam along `axis`, a vector of any length above 0.
  /// @param half_angle_rad above 0, below a right angle
  [[nodiscard]] static Beam along(const Eigen::Vector3d& tip,
                                  const Eigen::Vector3d& axis,
                                  double half_angle_rad,
                                  double length_mm);
};

/// Three corners of a facet, mm.
struct Triangle {
  Eigen::Vector3d a = Eigen::Vector3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  Eigen::Vector3d c = Eigen::Vector3d::Zero();
};

/// Distance below which the beam counts as intersecting a triangle, mm. It exceeds the rounding
/// error of coordinates up to 1 m from the tip, at half angles from 0.5 to 89 degrees.
inline constexpr double kBeamMarginMm = 1.0e-9;

/// Returns the least signed distance of a triangle's points from the side of the beam. Only points
/// between the planes of the tip and of the lens count; the result is infinite if there are none. A
/// negative result is the depth of the triangle in the beam. The distance of a point is measured to
/// the complete cone of which the side is a part.
[[nodiscard]] double clearance(const Beam& beam, const Triangle& triangle);

/// Returns whether the beam intersects or touches the triangle. The result is never false if they
/// intersect, and never true if the triangle is farther than kBeamMarginMm from the beam.
[[nodiscard]] bool meets(const Beam& beam, const Triangle& triangle);

}  // namespace cnc::wall
