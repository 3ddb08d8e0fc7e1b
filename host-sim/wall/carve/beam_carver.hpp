#pragma once

#include <cstddef>

#include "host-sim/wall/carve/beam_strokes.hpp"
#include "host-sim/wall/carve/columns.hpp"

namespace sim::wall {

/// The cone of a beam that burns, and the angle by which heat widens it.
struct BurningBeam {
  double half_angle_rad = 0.0;  ///< Half angle of the cone, above 0, below a right angle.
  /// Angle by which heat widens the cone on each side; its sum with the half angle is below a right
  /// angle.
  double heat_rad = 0.0;
  double waist_mm = 0.0;  ///< Radius at the tip, at least 0.
};

/// Maximum excess in mm, at the height of the stock's top, that is burned by a beam whose axis
/// turns along its stroke.
inline constexpr double kSwingErrorMm = 1.0e-3;

/// Burns the strokes of a beam into columns.
///
/// The beam burns everything within the cone from the tip up to the lens, which is above the stock,
/// and within the waist down to the depth below the tip. Between two poses the tip moves on a line
/// and the axis turns in one plane. If the axis keeps its direction, heights are exact. If it
/// turns, the stroke is divided, and the cone is widened by the turn of the axis within a part.
/// Thus the result is never less than the beam burns, and at the stock's top at most kSwingErrorMm
/// too wide.
class BeamCarver {
 public:
  BeamCarver(Columns& columns, const BurningBeam& beam) : columns_{columns}, beam_{beam} {}

  void carve(const BeamStroke& stroke);

  /// moves() returns the number of carved lines of the tip, parts() the number of parts into which
  /// they were divided.
  [[nodiscard]] std::size_t moves() const { return moves_; }
  [[nodiscard]] std::size_t parts() const { return parts_; }

 private:
  void move(const BeamPose& from, const BeamPose& to);
  void burn(const CutCone& cone, const Eigen::Vector3d& from, const Eigen::Vector3d& way);
  void burn_row(const SweptCone& cone, int row, double from, double until);

  Columns& columns_;
  BurningBeam beam_;
  std::size_t moves_ = 0;
  std::size_t parts_ = 0;
};

}  // namespace sim::wall
